//! The loop over literals is taken: on the golden programs, and on real programs that lie beside the repository.

use std::fs;
use std::path::PathBuf;

use partc::internals::parser::symbols::Symbols;
use partc::internals::parser::{klartext, mtc200, sinumerik, turning};

use super::book::cases;
use super::tools::beside_repository;

/// Dialect, folder of real programs, and the least share of blocks in percent, of golden and of real programs.
const FLOORS: &[(&str, &str, usize, usize)] = &[
    ("klartext", "corpus/heidenhain", 25, 95),
    ("sinumerik", "corpus/sinumerik", 60, 30),
    ("heidenhain-turning", "corpus/turning", 50, 50),
    ("mtc200", "corpus/rexroth", 55, 90),
];

/// Blocks that the loop took, and all blocks that are no mere comments.
fn count(dialect: &str, program: &[u8]) -> (usize, usize) {
    let (mut symbols, mut problems) = (Symbols::default(), Vec::new());
    let (mut klartext_block, mut sinumerik_block) = (klartext::ast::Block::default(), sinumerik::ast::Block::default());
    let (mut turning_block, mut mtc200_block) = (turning::ast::Block::default(), mtc200::ast::Block::default());
    let (mut taken, mut all) = (0, 0);
    for line in program.split(|b| *b == b'\n') {
        let line = line.trim_ascii();
        let comment = |b: &u8| matches!(b, b';' | b'[' | b'(' | b'*' | b'%');
        if line.is_empty() || line.iter().find(|b| !b.is_ascii_digit() && **b != b' ').is_none_or(comment) {
            continue;
        }
        all += 1;
        taken += usize::from(match dialect {
            "klartext" => klartext::parse_block(line, &mut klartext_block, &mut problems),
            "sinumerik" => sinumerik::parse_block(line, &mut sinumerik_block, &mut symbols, &mut problems),
            "mtc200" => mtc200::parse_block(line, &mut mtc200_block, &mut symbols, &mut problems),
            _ => turning::parse_block(line, &mut turning_block, &mut problems),
        });
    }
    (taken, all)
}

fn check(what: &str, dialect: &str, programs: impl Iterator<Item = Vec<u8>>, floor: usize) {
    let (mut taken, mut all) = (0, 0);
    for program in programs {
        let (own, of) = count(dialect, &program);
        (taken, all) = (taken + own, all + of);
    }
    println!("{what}: the loop over literals takes {taken} of {all} blocks, {} %", taken * 100 / all.max(1));
    assert!(taken * 100 >= all * floor, "{what}: {taken} of {all} blocks, at least {floor} % are wanted");
}

#[test]
fn golden_programs_take_the_fast_path() {
    for (dialect, _, floor, _) in FLOORS {
        check(dialect, dialect, cases(dialect).into_iter().map(|case| case.program.clone()), *floor);
    }
}

#[test]
fn real_programs_take_the_fast_path() {
    for (dialect, corpus, _, floor) in FLOORS {
        let Some(folder) = beside_repository(corpus) else { continue };
        let (mut folders, mut files) = (vec![folder], Vec::<PathBuf>::new());
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).expect("a readable folder") {
                let path = entry.expect("a readable entry").path();
                if path.is_dir() { folders.push(path) } else { files.push(path) }
            }
        }
        check(corpus, dialect, files.into_iter().map(|path| fs::read(path).expect("a readable program")), *floor);
    }
}
