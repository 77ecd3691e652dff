//! Rules that hold in every dialect: a column for each dialect, a row for each rule.
//!
//! A new dialect is one more [`Column`]. Line ends, skip marks, start points and loops without end have files of their
//! own: `line_ends`, `skip_marks`, `start`, `endless`.

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
    /// A formula that has no value is assigned, and two blocks use the variable.
    lost: [&'static str; 3],
    comments: &'static [(&'static str, &'static str)],
    /// Runs a body for ever.
    forever: fn(&str) -> String,
    /// Calls program number `n`; its file; what it is made of.
    call: fn(usize) -> String,
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
        lost: ["Q1 = 1 / 0", "L X+Q1", "Q2 = 1 / Q1"],
        comments: &[(";", "")],
        forever: |body| format!("LBL 1\n{body}\nFN 9: IF +0 EQU +0 GOTO LBL 1"),
        call: |n| format!("CALL PGM P{n}.H"),
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
        lost: ["R1=1/0", "X=R1", "R2=1/R1"],
        comments: &[(";", "")],
        forever: |body| format!("LOOP\n{body}\nENDLOOP"),
        call: |n| format!("SUB{n}"),
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
        lost: ["#1=1/0", "G1 Z#1", "#2=1/#1"],
        comments: &[("[", "]")],
        forever: |body| format!("#1=1\nWHILE #1==1\n{body}\nENDWHILE"),
        call: |n| format!("L\"P{n}\""),
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
        lost: ["@1=1/0", "G90 X=@1", "@2=1/@1"],
        comments: &[(";", ""), ("(", ")")],
        forever: |body| format!(".A {body}\nBRA .A"),
        call: |n| format!("JSR P{n}"),
        called: |n| format!("{n}"),
        missing: "P0101",
        program: |_, body| format!("{body}\nRTS\n"),
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

// Files.

#[test]
fn umlauts_in_comments_are_read_in_any_encoding() {
    row(|column| {
        let [seven, nine] = column.moves();
        let whole = column.run(&[&seven, &nine]);
        for (open, close) in column.comments {
            let text = column.text(&[&format!("{seven} {open}Spr\u{fc}h\u{e4}{close}"), &nine]);
            let narrow: Vec<u8> = text.chars().map(|c| c as u8).collect();
            let utf8 = column.bytes(text.clone().into_bytes());
            let latin = column.bytes(narrow);
            same(&utf8, &whole, "UTF-8")?;
            same(&latin, &whole, "Windows-1252")?;
            for compiled in [&utf8, &latin] {
                let said = compiled.output.contains("Spruehae") || compiled.output.contains("SPRUEHAE");
                hold(said && compiled.output.is_ascii(), || compiled.output.clone())?;
            }
            for byte in [0x80, 0x81, 0x9f, 0xff, 0x7f, 0x1b, 1] {
                let text = column.text(&[&format!("{seven} {open}a?b{close}"), &nine]);
                let bytes = text.bytes().map(|b| if b == b'?' { byte } else { b }).collect();
                same(&column.bytes(bytes), &whole, &format!("byte {byte:#x} in a comment"))?;
            }
        }
        Ok(())
    });
}

#[test]
fn two_bytes_a_character_are_refused() {
    row(|column| {
        let [seven, nine] = column.moves();
        let text = column.text(&[&seven, &nine]);
        for mark in ["\u{feff}", ""] {
            let units: Vec<u16> = format!("{mark}{text}").encode_utf16().collect();
            for bytes in [
                units.iter().flat_map(|unit| unit.to_le_bytes()).collect::<Vec<u8>>(),
                units.iter().flat_map(|unit| unit.to_be_bytes()).collect(),
            ] {
                refuses(&column.bytes(bytes), "P0001", "UTF-16")?;
            }
        }
        Ok(())
    });
}

#[test]
fn a_byte_order_mark_stands_at_the_start_only() {
    row(|column| {
        let [seven, nine] = column.moves();
        let text = column.text(&[&seven, &nine]);
        let whole = column.bytes(text.clone().into_bytes());
        same(&column.bytes(format!("\u{feff}{text}").into_bytes()), &whole, "a mark at the start")?;
        for wrong in [format!("\u{feff}\u{feff}{text}"), column.text(&[&seven, &format!("\u{feff}{nine}")])] {
            let compiled = column.bytes(wrong.into_bytes());
            hold(compiled.has_errors(), || format!("a mark elsewhere is taken: {}", compiled.output))?;
        }
        Ok(())
    });
}

#[test]
fn nul_and_ctrl_z_are_padding_outside_the_program_only() {
    row(|column| {
        let [seven, nine] = column.moves();
        let whole = column.run(&[&seven, &nine]);
        for hole in ["\0", "\x1a", "\0\0\0\0\0\0"] {
            let mut inside = vec![seven.replace(' ', &format!(" {hole}"))];
            for (open, close) in column.comments {
                inside.push(format!("{seven} {open}text{hole}more{close}"));
                inside.push(format!("{seven} {hole} {open}text{close}"));
            }
            for block in inside.iter().filter(|block| block.contains(hole)) {
                let found = column.run(&[block, &nine]);
                hold(errors(&found).contains(&"P0005"), || format!("{block:?}: {:?}", found.rendered))?;
            }
            for body in [
                [format!("{seven}{hole}"), nine.clone()],
                [format!("{hole}{seven}"), nine.clone()],
                [format!("{seven}\n{hole}\r"), nine.clone()],
            ] {
                let compiled = column.run(&[&body[0], &body[1]]);
                let warned = compiled.codes().contains(&"P0006");
                hold(warned, || format!("no warning of {body:?}: {:?}", compiled.rendered))?;
                same(&compiled, &whole, &format!("{body:?}"))?;
            }
            let text = column.text(&[&seven, &nine]);
            for padded in [
                format!("{text}{hole}"),
                format!("{text}{hole}\n"),
                format!("{}{hole}", text.trim_end()),
                format!("{text}\r\n{hole}\r\n {hole}"),
                format!("{hole}{text}"),
                format!("{hole}\n{text}"),
            ] {
                let compiled = column.bytes(padded.clone().into_bytes());
                same(&compiled, &whole, &format!("padding of {hole:?} in {padded:?}"))?;
            }
        }
        Ok(())
    });
}

#[test]
fn an_empty_file_is_refused() {
    row(|column| {
        for text in ["", "\n", " \t\r\n\r\n", "\0\0\0", "\x1a", "\u{feff}", "\u{feff}\r\n"] {
            refuses(&column.bytes(text.as_bytes().to_vec()), "P0004", &format!("{text:?}"))?;
        }
        Ok(())
    });
}

#[test]
fn what_follows_a_line_that_is_too_long_is_silent_until_the_place_is_known() {
    row(|column| {
        let (open, close) = column.comments[0];
        let long = format!("{} {open}{}{close}", (column.to)(7), "-".repeat((1 << 20) + 1));
        refuses(&column.run(&[&long, &(column.by)(3), &(column.to)(9), &(column.by)(1)]), "P0003", "a long line")?;
        // A line that is nearly too long is a block like others.
        let whole = column.run(&[&(column.to)(7), &(column.to)(9)]);
        let nearly = format!("{} {open}{}{close}", (column.to)(7), "-".repeat((1 << 20) - 100));
        same(&column.run(&[&nearly, &(column.to)(9)]), &whole, "a line of nearly 1 MiB")
    });
}

// Comments.

#[test]
fn comments_never_act() {
    row(|column| {
        let [seven, nine] = column.moves();
        let whole = column.run(&[&seven, &nine]);
        for (open, close) in column.comments {
            for text in [
                "G0 X99 Z99",
                "L X+99 R0 FMAX",
                "M30",
                "END PGM PART MM",
                "RET",
                "/ N5 X99",
                "N5 G1 X99",
                "(",
                ")",
                "((",
                "))",
                ")(",
                "[",
                "]",
                "][",
                "; ;",
                "%",
                "%_N_A_MPF",
                "\"",
                "'",
                "\"a",
                "~",
                "&",
                "*",
                "!",
                "#1=5",
                "R1=5",
                "Q1=+5",
                "@1=5",
                "LBL 1",
                ".A",
                "$PATH",
                "\\",
            ] {
                for comment in [format!("{open}{text}{close}"), format!("{open} a {text} b {close}")] {
                    for body in [
                        vec![format!("{seven} {comment}"), nine.clone()],
                        vec![seven.clone(), comment.clone(), nine.clone()],
                    ] {
                        let body: Vec<&str> = body.iter().map(String::as_str).collect();
                        let compiled = column.run(&body);
                        // A comment in brackets ends at the first one that closes, and a block of Klartext goes on
                        // behind `~`: then an error is right.
                        let ended = !close.is_empty() && text.contains(close) || text == "~";
                        if !(ended && compiled.has_errors()) {
                            same(&compiled, &whole, &comment)?;
                        }
                        let bare = |line: &&str| {
                            line.starts_with('(')
                                && (line.matches('(').count() != 1
                                    || !line.ends_with(')')
                                    || line.matches(')').count() != 1)
                        };
                        let wrong = compiled.output.lines().find(bare);
                        hold(wrong.is_none(), || format!("{comment} is printed as {wrong:?}"))?;
                    }
                }
            }
        }
        Ok(())
    });
}

// What is not known.

#[test]
fn a_refused_block_is_one_finding() {
    row(|column| {
        let (to, by) = (column.to, column.by);
        for body in [
            vec![column.refused.to_owned(), by(3)],
            vec![column.refused.to_owned(), by(3), by(2), to(7), by(2), to(9)],
            vec![to(7), column.refused.to_owned(), to(9), by(-1)],
        ] {
            let body: Vec<&str> = body.iter().map(String::as_str).collect();
            let compiled = column.run(&body);
            hold(errors(&compiled).len() == 1, || format!("{body:?}: {:?}", compiled.rendered))?;
        }
        // A second mistake is a second finding.
        let twice = column.run(&[column.refused, &to(7), column.refused]);
        hold(errors(&twice).len() == 2, || format!("two mistakes: {:?}", twice.rendered))
    });
}

#[test]
fn a_value_that_is_lost_is_one_finding() {
    row(|column| {
        let compiled = column.run(&[&column.lost[..], &[&*(column.by)(3), &(column.to)(7)]].concat());
        hold(errors(&compiled).len() == 1, || format!("{:?}: {:?}", column.lost, compiled.rendered))
    });
}

// Budgets.

#[test]
fn budgets_of_steps_and_of_output_stop_a_run() {
    row(|column| {
        let body = format!("{}\n{}", (column.to)(7), (column.to)(9));
        let text = column.text(&[&(column.forever)(&body)]).into_bytes();
        for (limit, code) in [("steps = 5000", "P4001"), ("output_blocks = 500", "P4002")] {
            let settings = column.settings(&format!("[limits]\n{limit}\n"));
            let compiled = compile_bytes(column.file, text.clone(), column.dialect, &settings, &NoFiles);
            refuses(&compiled, code, limit)?;
        }
        Ok(())
    });
}

// Calls.

#[test]
fn a_program_that_is_called_twice_moves_twice() {
    row(|column| {
        let call = (column.call)(5);
        let body = [call.as_str(), &(column.to)(3), &call];
        let good = column.run_with(&body, &|_| format!("{}\n{}", (column.to)(7), (column.to)(9)), 0);
        let places = path(&good).iter().filter(|line| line.contains(&(column.shown)(7))).count();
        hold(!good.has_errors() && places == 2, || format!("{:?}\n{}", good.rendered, good.output))?;
        let bad = column.run_with(&body, &|_| format!("{}\n{}", column.refused, (column.to)(9)), 0);
        hold(errors(&bad).len() == 1, || format!("a mistake in it: {:?}", bad.rendered))
    });
}

#[test]
fn calls_end() {
    row(|column| {
        let call = column.call;
        let one = call(1);
        let itself = column.run_with(&[&one], &|n| call(n), 0);
        hold(errors(&itself).len() == 1, || format!("a program that calls itself: {:?}", itself.rendered))?;
        let ring = column.run_with(&[&one], &|n| call(3 - n), 0);
        hold(errors(&ring).len() == 1, || format!("two that call each other: {:?}", ring.rendered))?;
        let chain = column.run_with(&[&one], &|n| call(n + 1), 0);
        hold(errors(&chain).len() == 1, || format!("a chain without end: {:?}", chain.rendered))?;
        // The next block is not what the depth is to blame for.
        let two = column.run_with(&[&one], &|n| if n < 3 { call(n + 1) } else { (column.to)(7) }, 0);
        hold(!two.has_errors(), || format!("three levels: {:?}", two.rendered))
    });
}

#[test]
fn called_files_have_limits() {
    row(|column| {
        let calls: Vec<String> = (1..=1000).map(column.call).collect();
        let calls: Vec<&str> = calls.iter().map(String::as_str).collect();
        let move_ = |_| (column.to)(7);
        // The main program is one file, too.
        let fits = column.run_with(&calls[..999], &move_, 0);
        hold(!fits.has_errors(), || format!("1000 files: {:?}", &fits.rendered[..fits.rendered.len().min(3)]))?;
        refuses(&column.run_with(&calls, &move_, 0), "P0106", "1001 files")?;
        refuses(&column.run_with(&calls[..1], &move_, (256 << 20) + 1), "P0120", "a file over 256 MiB")
    });
}

#[test]
fn a_program_that_is_not_there_is_one_finding() {
    row(|column| {
        let body = [&*(column.call)(5), &(column.by)(3), &(column.to)(7)];
        refuses(&column.run(&body), column.missing, "a program that is not there")
    });
}

#[test]
fn hostile_names_open_nothing() {
    row(|column| {
        let Some(call) = column.call_by_name else { return Ok(()) };
        let folder = Folder::new(&format!("matrix_{}/inside", column.dialect));
        let secret = (column.program)(5, &(column.to)(7));
        for name in ["SECRET.H", "SECRET.SPF", "SECRET.MPF", "SECRET.ncs", "SECRET.nc", "SECRET"] {
            folder.write(&format!("../{name}"), &secret);
        }
        folder.write("partc.toml", column.settings);
        let absolute = folder.0.parent().expect("a folder").join("SECRET");
        let long = "A".repeat(5000);
        for name in [
            "../SECRET",
            "..\\SECRET",
            "../SECRET.H",
            "./../SECRET",
            "inside/../../SECRET",
            "/../SECRET",
            absolute.to_str().expect("UTF-8"),
            "/etc/passwd",
            "//server/share/SECRET",
            "\\\\server\\share\\SECRET",
            "C:\\SECRET",
            "C:SECRET",
            "file:SECRET",
            "SECRET:stream",
            "NUL",
            "CON.H",
            "COM1",
            "lpt9.spf",
            "..",
            ".",
            "/",
            "a*",
            "?",
            "~/SECRET",
            "$HOME/SECRET",
            "a\x01b",
            &long,
        ] {
            folder.write(column.file, &column.text(&[&call(name)]));
            let ran =
                folder.run(&["compile", column.file, "--format", "concise", "--dialect", column.dialect]).exits(1);
            let shown: String = name.chars().take(40).collect();
            hold(ran.err.contains("error[") && !ran.err.contains("panicked"), || format!("{shown}: {}", ran.err))?;
            let made: Vec<String> = folder.names().into_iter().filter(|name| name.ends_with("ngc")).collect();
            hold(made.is_empty(), || format!("{shown} makes {made:?}"))?;
        }
        Ok(())
    });
}

/// A NUL in a name is a hole in the program before it is a name.
#[test]
fn a_name_with_a_nul_is_refused() {
    row(|column| {
        let Some(call) = column.call_by_name else { return Ok(()) };
        let text = column.text(&[&call("A\0B")]).into_bytes();
        let files = Programs { column, size: 0, body: &|_| (column.to)(7) };
        let compiled = compile_bytes(column.file, text, column.dialect, &column.settings(""), &files);
        hold(compiled.has_errors(), || compiled.output.clone())
    });
}
