//! Programs that are cut, damaged, or in another encoding: each ends with findings that have a place, or with an output.

use std::panic::{AssertUnwindSafe, catch_unwind};

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;

use crate::book::cases;
use crate::common::{compile_bytes, settings};
use crate::damage::{Dice, KINDS, damage};

/// Folder of the books of each dialect, its name, and a file of it.
const DIALECTS: [(&str, &str, &str); 4] = [
    ("klartext", "klartext", "P.H"),
    ("sinumerik", "sinumerik", "P.MPF"),
    ("heidenhain-turning", "heidenhain-turning", "P.nc"),
    ("mtc200", "mtc200", "P.npg"),
];

/// How many programs of a dialect are cut at every byte, how many are damaged, and how often each.
#[derive(Debug, Clone, Copy)]
pub struct Amount {
    pub cut: usize,
    pub damaged: usize,
    pub rounds: usize,
}

/// What came of all of them.
#[derive(Debug, Default)]
pub struct Tried {
    /// Programs that were cut at every byte, and what came of that.
    pub cut: u64,
    pub cuts: u64,
    pub programs: u64,
    /// Outputs in spite of an error.
    pub outputs: u64,
    pub findings: u64,
    /// Findings without a place in the program.
    pub unlocated: u64,
    /// Programs that made partc panic.
    pub panics: Vec<String>,
}

/// Other bytes for the same program: marks in front, other ends of lines, other encodings.
fn encodings(program: &[u8]) -> Vec<Vec<u8>> {
    let text = String::from_utf8_lossy(program);
    let wide = |mark: bool, bytes: fn(u16) -> [u8; 2]| {
        let units = mark.then_some(0xfeff).into_iter().chain(text.encode_utf16());
        units.flat_map(bytes).collect::<Vec<u8>>()
    };
    let behind = |tail: &[u8]| [program, tail].concat();
    let mixed = program.split(|b| *b == b'\n').enumerate().flat_map(|(n, line)| {
        let end: &[u8] = [&b"\n"[..], b"\r\n", b"\r", b"\n\r"][n % 4];
        [line, end].concat()
    });
    vec![
        [&b"\xef\xbb\xbf"[..], program].concat(),
        [&b"\xef\xbb\xbf\xef\xbb\xbf"[..], program].concat(),
        wide(true, u16::to_le_bytes),
        wide(true, u16::to_be_bytes),
        wide(false, u16::to_le_bytes),
        mixed.collect(),
        behind(b"\0\0\0"),
        behind(b"\x1a"),
        behind(b"\x1a\r\nL X+1 G1 X1"),
        behind(b"; \xfc\xe4\xf6 \xb0\n"),
        program.iter().flat_map(|b| [*b, 0]).collect(),
        program.iter().rev().copied().collect(),
        program.to_ascii_lowercase(),
    ]
}

/// Tries them.
pub fn malformed(amount: Amount) -> Tried {
    let settings = settings(
        "[limits]\nsteps = 20000\noutput_blocks = 20000\n[control]\nfeed = 100\n[output]\ncompensation = \"control\"\n",
    );
    let mut tried = Tried::default();
    for (folder, dialect, name) in DIALECTS {
        let mut all = cases(folder);
        all.sort_by_key(|case| (case.program.len(), &case.name));
        // The middle of the list: neither a line nor a page.
        let from = all.len() / 3;
        for case in all.iter().skip(from).step_by(3).take(amount.cut) {
            tried.cut += 1;
            tried.cuts += case.program.len() as u64;
            (0..case.program.len()).for_each(|end| tried.one(dialect, name, &case.program[..end], &settings));
        }
        let step = (all.len() / amount.damaged.max(1)).max(1);
        let mut dice = Dice(0x0ddb_a110 + all.len() as u64);
        for case in all.iter().step_by(step).take(amount.damaged) {
            encodings(&case.program).iter().for_each(|bytes| tried.one(dialect, name, bytes, &settings));
            for round in 0..amount.rounds {
                let mut bytes = case.program.clone();
                (0..=dice.roll(3)).for_each(|_| damage(&mut bytes, round % KINDS, &mut dice));
                tried.one(dialect, name, &bytes, &settings);
            }
        }
    }
    tried
}

impl Tried {
    fn one(&mut self, dialect: &str, name: &str, bytes: &[u8], settings: &Settings) {
        self.programs += 1;
        let compiled =
            catch_unwind(AssertUnwindSafe(|| compile_bytes(name, bytes.to_vec(), dialect, settings, &NoFiles)));
        let Ok(compiled) = compiled else {
            self.panics.push(String::from_utf8_lossy(bytes).into_owned());
            return;
        };
        self.outputs += u64::from(compiled.has_errors() && !compiled.output.is_empty());
        self.findings += compiled.findings.len() as u64;
        let placed = |loc: partc::internals::text::Loc| {
            loc.line >= 1 && loc.span.start as usize <= bytes.len() && loc.span.end as usize <= bytes.len() + 1
        };
        self.unlocated += compiled.findings.iter().filter(|found| !placed(found.label.loc)).count() as u64;
    }
}
