//! Rules that hold in every dialect: a column for each dialect, a row for each rule.
//!
//! A new dialect is one more [`Column`]. Line ends, skip marks, start points and loops without end have files of their
//! own: `line_ends`, `skip_marks`, `start`, `endless`.

mod ends;
mod runs;
mod texts;

use std::io;

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;
use partc::internals::text::{FileError, Files, Opened, ReadAt, Request};

use super::cli_run::Folder;
use super::common::{Compiled, compile_bytes, settings};

/// How a dialect says what the rows need.
struct Column {
    dialect: &'static str,
    file: &'static str,
    settings: &'static str,
    /// Blocks after which every axis and the feed are known.
    head: &'static [&'static str],
    tail: &'static [&'static str],
    /// A line to a place on one axis, and by a distance along it.
    to: fn(i32) -> String,
    by: fn(i32) -> String,
    /// How the output names the place.
    shown: fn(i32) -> String,
    /// A block that would move that axis and is refused.
    refused: &'static str,
    /// A formula that has no value is assigned, and two blocks use the variable; where there are variables.
    lost: Option<[&'static str; 3]>,
    comments: &'static [(&'static str, &'static str)],
    /// Runs a body for ever, where there are jumps.
    forever: Option<fn(&str) -> String>,
    /// Calls program number `n`, where there are calls; its file; what it is made of.
    call: Option<fn(usize) -> String>,
    called: fn(usize) -> String,
    /// The code where there is none.
    missing: &'static str,
    program: fn(usize, &str) -> String,
    /// Calls a program by any name; no row is made where programs have numbers only.
    call_by_name: Option<fn(&str) -> String>,
}

const COLUMNS: &[Column] = &[
    Column {
        dialect: "klartext",
        file: "PART.H",
        settings: "",
        head: &["BEGIN PGM PART MM", "L X+0 Y+0 Z+5 R0 FMAX", "L X+1 F100"],
        tail: &["END PGM PART MM"],
        to: |n| format!("L X{n:+}"),
        by: |n| format!("L IX{n:+}"),
        shown: |n| format!("X{n}"),
        refused: "L X+50 R5",
        lost: Some(["Q1 = 1 / 0", "L X+Q1", "Q2 = 1 / Q1"]),
        comments: &[(";", "")],
        forever: Some(|body| format!("LBL 1\n{body}\nFN 9: IF +0 EQU +0 GOTO LBL 1")),
        call: Some(|n| format!("CALL PGM P{n}.H")),
        called: |n| format!("P{n}.H"),
        missing: "P0101",
        program: |n, body| format!("BEGIN PGM P{n} MM\n{body}\nEND PGM P{n} MM\n"),
        call_by_name: Some(|name| format!("CALL PGM {name}")),
    },
    Column {
        dialect: "sinumerik",
        file: "PART.MPF",
        settings: "",
        head: &["G90 G0 X0 Y0 Z5", "G1 X1 F100"],
        tail: &["M30"],
        to: |n| format!("X{n}"),
        by: |n| format!("X=IC({n})"),
        shown: |n| format!("X{n}"),
        refused: "G1 X50 G777",
        lost: Some(["R1=1/0", "X=R1", "R2=1/R1"]),
        comments: &[(";", "")],
        forever: Some(|body| format!("LOOP\n{body}\nENDLOOP")),
        call: Some(|n| format!("SUB{n}")),
        called: |n| format!("SUB{n}.SPF"),
        missing: "S2002",
        program: |_, body| format!("{body}\nM17\n"),
        call_by_name: Some(|name| format!("CALL \"{name}\"")),
    },
    Column {
        dialect: "heidenhain-turning",
        file: "PART.nc",
        settings: "[machine]\nkind = \"lathe\"\n",
        head: &["N1 G94 F100", "N2 G0 X36 Z5"],
        tail: &["M30"],
        to: |n| format!("G1 Z{n}"),
        by: |n| format!("G1 Zi{n}"),
        shown: |n| format!("Z{n}"),
        refused: "G1 Z50 G777",
        lost: Some(["#1=1/0", "G1 Z#1", "#2=1/#1"]),
        comments: &[("[", "]")],
        forever: Some(|body| format!("#1=1\nWHILE #1==1\n{body}\nENDWHILE")),
        call: Some(|n| format!("L\"P{n}\"")),
        called: |n| format!("P{n}.ncs"),
        missing: "P0101",
        program: |n, body| format!("%P{n}.ncs\n{body}\nRETURN\n"),
        call_by_name: Some(|name| format!("L\"{name}\"")),
    },
    Column {
        dialect: "mtc200",
        file: "PART.npg",
        settings: "",
        head: &["G90 G71 G94 G00 X0 Y0 Z5", "G01 X1 F100"],
        tail: &["RET"],
        to: |n| format!("G90 X{n}"),
        by: |n| format!("G91 X{n}"),
        shown: |n| format!("X{n}"),
        refused: "G01 X50 G777",
        lost: Some(["@1=1/0", "G90 X=@1", "@2=1/@1"]),
        comments: &[(";", ""), ("(", ")")],
        forever: Some(|body| format!(".A {body}\nBRA .A")),
        call: Some(|n| format!("JSR P{n}")),
        called: |n| format!("{n}"),
        missing: "P0101",
        program: |_, body| format!("{body}\nRTS\n"),
        call_by_name: None,
    },
    Column {
        dialect: "gcode",
        file: "PART.ngc",
        settings: "",
        head: &["G90 G21 G94 G0 X0 Y0 Z5", "G1 X1 F100"],
        tail: &["M30"],
        to: |n| format!("G90 X{n}"),
        by: |n| format!("G91 X{n}"),
        shown: |n| format!("X{n}"),
        refused: "G1 X50 G777",
        lost: None,
        comments: &[(";", ""), ("(", ")")],
        forever: None,
        call: None,
        called: |n| format!("{n}"),
        missing: "",
        program: |_, body| format!("{body}\n"),
        call_by_name: None,
    },
];

/// A file that begins with a text and is as large as it says; the rest is blanks.
struct Sized(Vec<u8>, u64);

impl ReadAt for Sized {
    fn len(&self) -> u64 {
        self.1
    }

    fn read_at(&mut self, at: u64, buf: &mut [u8]) -> io::Result<usize> {
        let n = buf.len().min(self.1.saturating_sub(at) as usize);
        for (place, at) in buf[..n].iter_mut().zip(at..) {
            *place = self.0.get(at as usize).copied().unwrap_or(b' ');
        }
        Ok(n)
    }
}

/// Programs by number; each is as large as it says.
struct Programs<'c> {
    column: &'c Column,
    size: u64,
    body: &'c dyn Fn(usize) -> String,
}

impl Files for Programs<'_> {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        let name = request.name.to_ascii_uppercase();
        let wanted = |n: &usize| (self.column.called)(*n).split('.').next() == name.split('.').next();
        let digits: String = name.chars().filter(char::is_ascii_digit).collect();
        let Some(n) = digits.parse().ok().filter(wanted) else {
            return Err(FileError::NotFound { tried: vec![name], similar: Vec::new() });
        };
        let text = (self.column.program)(n, &(self.body)(n)).into_bytes();
        let size = self.size.max(text.len() as u64);
        let name = (self.column.called)(n);
        Ok(Opened { identity: name.clone(), name, text: Box::new(Sized(text, size)) })
    }
}

impl Column {
    fn settings(&self, more: &str) -> Settings {
        settings(&format!("{more}\n{}", self.settings))
    }

    fn text(&self, body: &[&str]) -> String {
        let lines = self.head.iter().chain(body).chain(self.tail);
        lines.flat_map(|line| [line, "\n"]).collect()
    }

    fn bytes(&self, bytes: Vec<u8>) -> Compiled {
        compile_bytes(self.file, bytes, self.dialect, &self.settings(""), &NoFiles)
    }

    fn run(&self, body: &[&str]) -> Compiled {
        self.bytes(self.text(body).into_bytes())
    }

    /// A program whose called programs have these bodies.
    fn run_with(&self, body: &[&str], called: &dyn Fn(usize) -> String, size: u64) -> Compiled {
        let files = Programs { column: self, size, body: called };
        compile_bytes(self.file, self.text(body).into_bytes(), self.dialect, &self.settings(""), &files)
    }

    /// Two moves that no other row makes.
    fn moves(&self) -> [String; 2] {
        [(self.to)(7), (self.to)(9)]
    }
}

/// The output without its comments.
fn path(compiled: &Compiled) -> Vec<&str> {
    compiled.output.lines().filter(|line| !line.starts_with('(')).collect()
}

fn errors(compiled: &Compiled) -> Vec<&'static str> {
    let is_error =
        |found: &&partc::internals::diag::Diagnostic| found.code.severity == partc::internals::diag::Severity::Error;
    compiled.findings.iter().filter(is_error).map(|found| found.code.id).collect()
}

/// Runs a row in every column, and shows all columns that break it.
fn row(rule: impl Fn(&Column) -> Result<(), String>) {
    let broken: Vec<String> = COLUMNS
        .iter()
        .filter_map(|column| rule(column).err().map(|why| format!("{}: {why}", column.dialect)))
        .collect();
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

fn hold(truth: bool, why: impl FnOnce() -> String) -> Result<(), String> {
    if truth { Ok(()) } else { Err(why()) }
}

/// The same path as `whole`, without an error.
fn same(compiled: &Compiled, whole: &Compiled, what: &str) -> Result<(), String> {
    hold(!compiled.has_errors() && path(compiled) == path(whole), || {
        format!("{what}: {:?}\n{}\ninstead of\n{}", compiled.rendered, compiled.output, whole.output)
    })
}

/// This error, and no other.
fn refuses(compiled: &Compiled, code: &str, what: &str) -> Result<(), String> {
    hold(errors(compiled) == [code], || format!("{what} makes no {code} alone: {:?}", compiled.rendered))
}

#[test]
fn every_dialect_has_a_column() {
    let names: Vec<&str> = COLUMNS.iter().map(|column| column.dialect).collect();
    let all: Vec<&str> = partc::internals::dialect::ALL.iter().map(|dialect| dialect.id).collect();
    assert!(all.iter().all(|name| names.contains(name)), "{names:?} of {all:?}");
    row(|column| {
        let [seven, nine] = column.moves();
        let compiled = column.run(&[&seven, &nine]);
        let shown = |n| path(&compiled).iter().any(|line| line.contains(&(column.shown)(n)));
        hold(!compiled.has_errors() && shown(7) && shown(9), || {
            format!("{:?}\n{}", compiled.rendered, compiled.output)
        })?;
        // The refused block is one.
        hold(column.run(&[column.refused]).has_errors(), || format!("{} is taken", column.refused))
    });
}
