//! Rates of the stages and of the whole, on a program made from a seed.
//!
//! `cargo bench` prints them. No test depends on time.

use divan::Bencher;
use divan::counter::{BytesCount, ItemsCount};

use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::machine::Settings;
use partc::internals::parser::klartext::ast::Block;
use partc::internals::parser::klartext::{parse_block, parse_statement};
use partc::internals::text::files::NoFiles;
use partc::internals::text::{Memory, Opened};

const BLOCKS: usize = 100_000;

fn main() {
    divan::main();
}

/// A raster over a wavy surface, as CAM systems write it.
fn lines() -> String {
    let mut text = "0 BEGIN PGM BENCH MM\n1 TOOL CALL 1 Z S12000 F2000\n2 L X-100 Y-87.5 Z+50 R0 FMAX M3\n".to_owned();
    for k in 0..BLOCKS {
        let (row, column) = (k / 500, k % 500);
        let x = column as f64 * 0.4 - 100.0;
        let y = row as f64 * 0.35 - 87.5;
        let z = -2.0 + ((k * 7919) % 3600) as f64 / 1000.0;
        text += &format!("{} L X{x:+.3} Y{y:+.3} Z{z:+.3}\n", k + 3);
    }
    text + "9 L Z+50 R0 FMAX M30\n10 END PGM BENCH MM\n"
}

/// A loop that computes every point.
fn formulas() -> String {
    format!(
        "0 BEGIN PGM BENCH MM\n1 Q1 = 0\n2 LBL 1\n3 Q1 = Q1 + 0.36\n4 Q2 = COS Q1 * 40 + 5 * SIN ( Q1 * 3 )\n\
         5 L X+Q2 Y+Q1 R0 F500\n6 FN 12: IF +Q1 LT +{} GOTO LBL 1\n7 END PGM BENCH MM\n",
        BLOCKS as f64 * 0.36
    )
}

fn compile(text: &str) -> Vec<u8> {
    compile_as("klartext", text)
}

fn compile_as(dialect: &str, text: &str) -> Vec<u8> {
    let main =
        Opened { name: "b.H".into(), identity: "b".into(), text: Box::new(Memory::new(text.as_bytes().to_vec())) };
    let session = Session::new(main);
    let mut out = Vec::new();
    let dialect = dialect::find(dialect).expect("a dialect");
    session.compile(dialect, &Settings::default(), &NoFiles, &mut out, None).expect("memory takes everything");
    assert!(!session.diags.has_errors());
    out
}

#[divan::bench]
fn compile_lines(bencher: Bencher<'_, '_>) {
    let text = lines();
    bencher.counter(BytesCount::of_str(&text)).counter(ItemsCount::new(BLOCKS)).bench(|| compile(&text));
}

#[divan::bench]
fn compile_formulas(bencher: Bencher<'_, '_>) {
    let text = formulas();
    bencher.counter(ItemsCount::new(BLOCKS)).bench(|| compile(&text));
}

/// A turned profile of short lines, as CAM systems write it.
fn turned() -> String {
    let mut text = "%1.nc\n[BENCH]\nN1 T1 G95 F0.2 G97 S1000 M3\nN2 G0 X100 Z2\n".to_owned();
    for k in 0..BLOCKS {
        let z = 2.0 - k as f64 * 0.001;
        let x = 80.0 + ((k * 7919) % 3600) as f64 / 1000.0;
        text += &format!("N{} G1 X{x:.3} Z{z:.3}\n", k + 3);
    }
    text + "END\n"
}

#[divan::bench]
fn compile_turned(bencher: Bencher<'_, '_>) {
    let text = turned();
    bencher
        .counter(BytesCount::of_str(&text))
        .counter(ItemsCount::new(BLOCKS))
        .bench(|| compile_as("heidenhain-turning", &text));
}

fn parse_all(
    text: &str,
    parse: impl Fn(&[u8], &mut Block, &mut Vec<partc::internals::parser::problem::Problem>) -> bool,
) -> usize {
    let (mut block, mut problems, mut words) = (Block::default(), Vec::new(), 0);
    for line in text.as_bytes().split(|b| *b == b'\n') {
        parse(line, &mut block, &mut problems);
        words += block.words.len();
    }
    words
}

#[divan::bench]
fn parse_fast_path(bencher: Bencher<'_, '_>) {
    let text = lines();
    bencher.counter(BytesCount::of_str(&text)).counter(ItemsCount::new(BLOCKS)).bench(|| parse_all(&text, parse_block));
}

#[divan::bench]
fn parse_by_grammar(bencher: Bencher<'_, '_>) {
    let text = lines();
    bencher.counter(BytesCount::of_str(&text)).counter(ItemsCount::new(BLOCKS)).bench(|| {
        parse_all(&text, |line, block, problems| {
            block.clear();
            let from = line.iter().position(|b| !b.is_ascii_digit() && *b != b' ').unwrap_or(line.len());
            if from < line.len() {
                parse_statement(line, from, block, problems);
            }
            false
        })
    });
}

/// The same raster as an MTC200 program.
fn mtc200_lines() -> String {
    let mut text = "%NPG:0:00:0:0\n*BENCH\n%NPG\nG54 G90 S12000 M003\nG00 X-100 Y-87.5 Z50\nG01 F2000\n".to_owned();
    for k in 0..BLOCKS {
        let (row, column) = (k / 500, k % 500);
        let x = column as f64 * 0.4 - 100.0;
        let y = row as f64 * 0.35 - 87.5;
        let z = -2.0 + ((k * 7919) % 3600) as f64 / 1000.0;
        text += &format!("N{k:04} X{x:.3} Y{y:.3} Z{z:.3}\n");
    }
    text + "G00 Z50\nRET\n"
}

#[divan::bench]
fn mtc200_compile_lines(bencher: Bencher<'_, '_>) {
    let text = mtc200_lines();
    bencher.counter(BytesCount::of_str(&text)).counter(ItemsCount::new(BLOCKS)).bench(|| compile_as("mtc200", &text));
}

#[divan::bench]
fn mtc200_parse_fast_path(bencher: Bencher<'_, '_>) {
    use partc::internals::parser::{mtc200, symbols::Symbols};
    let text = mtc200_lines();
    bencher.counter(BytesCount::of_str(&text)).counter(ItemsCount::new(BLOCKS)).bench(|| {
        let (mut block, mut symbols, mut problems, mut words) =
            (mtc200::ast::Block::default(), Symbols::default(), Vec::new(), 0);
        for line in text.as_bytes().split(|b| *b == b'\n') {
            mtc200::parse_block(line, &mut block, &mut symbols, &mut problems);
            words += block.words.len();
        }
        words
    });
}
