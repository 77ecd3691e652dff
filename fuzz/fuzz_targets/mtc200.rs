//! Any bytes as MTC200 blocks and as an MTC200 program: no panic, spans inside, the fast path equals the
//! grammar, the output is plain.
#![no_main]

use libfuzzer_sys::fuzz_target;
use partc::driver::Session;
use partc::machine::{Compensation, Settings};
use partc::parser::mtc200::ast::Block;
use partc::parser::mtc200::{literal, parse_block, parse_statement};
use partc::parser::symbols::Symbols;
use partc::text::files::NoFiles;
use partc::text::{Memory, Opened};

fn block(bytes: &[u8]) {
    let (mut symbols, mut block, mut problems) = (Symbols::default(), Block::default(), Vec::new());
    parse_block(bytes, &mut block, &mut symbols, &mut problems);
    for word in &block.words {
        assert!(word.span.end as usize <= bytes.len());
    }
    for problem in &problems {
        assert!(problem.span.end as usize <= bytes.len() + 1);
    }
    let mut fast = Block::default();
    if literal::parse(bytes, 0, &mut fast) {
        let (mut slow, mut problems) = (Block::default(), Vec::new());
        parse_statement(bytes, 0, &mut slow, &mut symbols, &mut problems);
        assert_eq!(fast, slow);
    }
}

fuzz_target!(|bytes: &[u8]| {
    bytes.split(|b| *b == b'\n').for_each(block);
    let mut settings = Settings::default();
    settings.limits.steps = 5_000;
    settings.limits.output_blocks = 5_000;
    settings.control.feed = Some(100.0);
    settings.output.compensation = Compensation::Control;
    let text = Box::new(Memory::new(bytes.to_vec()));
    let session = Session::new(Opened { name: "fuzz.npg".into(), identity: "fuzz".into(), text });
    let dialect = partc::dialect::find("mtc200").expect("a dialect");
    let mut out = Vec::new();
    session.compile(dialect, &settings, &NoFiles, &mut out, None).expect("memory takes everything");
    assert!(out.is_ascii());
    for found in session.diags.into_sorted() {
        assert!(found.label.loc.line >= 1 && found.label.loc.span.start as usize <= bytes.len());
    }
});
