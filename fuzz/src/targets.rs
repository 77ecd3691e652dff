//! What holds for any bytes: plain functions, called by the libFuzzer targets beside this file and by the test suite.

use partc::internals::compare::{Difference, steps_of_text};
use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::machine::{Compensation, Settings, config, table, tree};
use partc::internals::parser::symbols::Symbols;
use partc::internals::parser::{klartext, mtc200, sinumerik, turning};
use partc::internals::text::files::NoFiles;
use partc::internals::text::{Memory, Opened, Span};

/// What a target does with some bytes: nothing, or it panics.
pub type Target = fn(&[u8]);

/// All targets by the name of their binary.
pub const ALL: &[(&str, Target)] = &[
    ("parse_klartext", parse_klartext),
    ("parse_turning", parse_turning),
    ("compile_klartext", compile_klartext),
    ("compile_turning", compile_turning),
    ("gcode", gcode),
    ("mtc200", mtc200),
    ("sinumerik", sinumerik),
    ("tables", tables),
    ("outputs", outputs),
];

/// Any bytes as a program: no panic, every finding has a place, the output is plain.
fn compile(dialect: &str, name: &str, bytes: &[u8]) {
    let mut settings = Settings::default();
    settings.limits.steps = 5_000;
    settings.limits.output_blocks = 5_000;
    settings.control.feed = Some(100.0);
    settings.output.compensation = Compensation::Control;
    let text = Box::new(Memory::new(bytes.to_vec()));
    let session = Session::new(Opened { name: name.to_owned(), identity: name.to_owned(), text });
    let dialect = dialect::find(dialect).expect("a dialect");
    let mut out = Vec::new();
    session.compile(dialect, &settings, &NoFiles, &mut out, None).expect("memory takes everything");
    assert!(out.is_ascii());
    for found in session.diags.into_sorted() {
        let span = found.label.loc.span;
        let inside = span.start as usize <= bytes.len() && span.end as usize <= bytes.len() + 1;
        assert!(inside && found.label.loc.line >= 1, "no place: {found:?}");
        // What hides in a comment is shown.
        let hidden = found.code.id == "P1010";
        assert!(!(hidden && found.message.starts_with("``")), "an empty quote: {found:?}");
    }
}

/// Words lie inside the block; findings at most at its end.
fn inside(words: impl Iterator<Item = Span>, problems: impl Iterator<Item = Span>, bytes: &[u8]) {
    words.for_each(|span| assert!(span.end as usize <= bytes.len()));
    problems.for_each(|span| assert!(span.start <= span.end && span.end as usize <= bytes.len() + 1));
}

/// A fast path is asked about blocks that hold something.
fn is_blank(bytes: &[u8]) -> bool {
    bytes.iter().all(|b| b.is_ascii_whitespace() || matches!(b, 0 | 0x0b | 0x1a | b'&'))
}

/// Any bytes as a block: no panic, spans inside the block, and the fast path equals the grammar.
pub fn parse_klartext(bytes: &[u8]) {
    use klartext::{ast::Block, literal, parse_block, parse_statement};
    let (mut block, mut problems) = (Block::default(), Vec::new());
    parse_block(bytes, &mut block, &mut problems);
    inside(block.words.iter().map(|word| word.span), problems.iter().map(|problem| problem.span), bytes);
    let mut fast = Block::default();
    if !is_blank(bytes) && literal::parse(bytes, 0, &mut fast) {
        let (mut slow, mut problems) = (Block::default(), Vec::new());
        parse_statement(bytes, 0, &mut slow, &mut problems);
        assert_eq!(fast, slow);
    }
}

/// Any bytes as a block of HEIDENHAIN turning.
pub fn parse_turning(bytes: &[u8]) {
    use turning::{ast::Block, literal, parse_block, parse_statement};
    let (mut block, mut problems) = (Block::default(), Vec::new());
    parse_block(bytes, &mut block, &mut problems);
    inside(block.words.iter().map(|word| word.span), problems.iter().map(|problem| problem.span), bytes);
    let mut fast = Block::default();
    if !is_blank(bytes) && literal::parse(bytes, 0, &mut fast) {
        let end = fast.comment.take().map_or(bytes.len(), |span| span.start as usize);
        let (mut slow, mut problems) = (Block::default(), Vec::new());
        parse_statement(&bytes[..end], 0, &mut slow, &mut problems);
        assert_eq!(fast, slow);
    }
}

fn mtc200_block(bytes: &[u8]) {
    use mtc200::{ast::Block, literal, parse_block, parse_statement};
    let (mut symbols, mut block, mut problems) = (Symbols::default(), Block::default(), Vec::new());
    parse_block(bytes, &mut block, &mut symbols, &mut problems);
    inside(block.words.iter().map(|word| word.span), problems.iter().map(|problem| problem.span), bytes);
    let mut fast = Block::default();
    if !is_blank(bytes) && literal::parse(bytes, 0, &mut fast) {
        let (mut slow, mut problems) = (Block::default(), Vec::new());
        parse_statement(bytes, 0, &mut slow, &mut symbols, &mut problems);
        assert_eq!(fast, slow);
    }
}

fn sinumerik_block(bytes: &[u8]) {
    use sinumerik::{ast::Block, literal, parse_block, parse_statement};
    let (mut symbols, mut block, mut problems) = (Symbols::default(), Block::default(), Vec::new());
    parse_block(bytes, &mut block, &mut symbols, &mut problems);
    inside(block.words.iter().map(|word| word.span), problems.iter().map(|problem| problem.span), bytes);
    let mut fast = Block::default();
    if !is_blank(bytes) && literal::parse(bytes, 0, &mut fast) {
        // The caller has taken a comment off before it asks the grammar.
        let end = fast.comment.take().map_or(bytes.len(), |span| span.start as usize - 1);
        if is_blank(&bytes[..end]) {
            return;
        }
        let (mut slow, mut problems) = (Block::default(), Vec::new());
        parse_statement(&bytes[..end], 0, &mut slow, &mut symbols, &mut problems);
        assert_eq!(fast, slow);
    }
}

pub fn compile_klartext(bytes: &[u8]) {
    compile("klartext", "fuzz.H", bytes);
}

pub fn compile_turning(bytes: &[u8]) {
    compile("heidenhain-turning", "fuzz.nc", bytes);
}

/// Any bytes as a program of plain G-code.
pub fn gcode(bytes: &[u8]) {
    compile("gcode", "fuzz.ngc", bytes);
}

/// Any bytes as blocks and as a program of the MTC200.
pub fn mtc200(bytes: &[u8]) {
    bytes.split(|b| *b == b'\n').for_each(mtc200_block);
    compile("mtc200", "fuzz.npg", bytes);
}

/// Any bytes as blocks and as a program of a SINUMERIK.
pub fn sinumerik(bytes: &[u8]) {
    bytes.split(|b| *b == b'\n').for_each(sinumerik_block);
    compile("sinumerik", "fuzz.mpf", bytes);
}

/// Any text as a tool table and as a configuration.
pub fn tables(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let _ = table::read(text);
    if let Ok(tree) = tree::parse(text, "partc.toml") {
        let _ = config::read(&tree);
    }
}

/// Any bytes as a printed program that is read back and compared with itself.
pub fn outputs(bytes: &[u8]) {
    if let Ok(steps) = steps_of_text(bytes, 0.001) {
        let found = Difference::between(&steps, &steps, 0.001);
        assert!(found.is_same(), "{}", found.text(&steps, &steps, ["a", "b"]));
    }
}
