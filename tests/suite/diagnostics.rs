//! Every diagnostic code fires where it should, and is silent where it should be.
//!
//! The books under `tests/golden/errors/<dialect>` have a chapter for each code, with programs that show the mistake
//! (`fires`) and the same programs with the mistake mended (`silent`). Inputs that no book can show are built in [`BUILT`].

use std::collections::{BTreeMap, BTreeSet};
use std::io;

use partc::internals::diag::{Diagnostic, Severity, codes};
use partc::internals::driver::Session;
use partc::internals::machine::{Settings, Unit};
use partc::internals::text::files::NoFiles;
use partc::internals::text::sources::{MAX_ALL_CALLED, MAX_CALLED};
use partc::internals::text::{FileError, Files, Memory, Opened, ReadAt, Request};

use super::book::{Case, cases, find};
use super::common::{Compiled, check_klartext, check_program, compile_bytes, settings};

/// A code whose input is made by the test: a wide file, a huge one, a file system that refuses.
struct Built {
    code: &'static str,
    fires: fn() -> Compiled,
    silent: fn() -> Compiled,
}

const BUILT: &[Built] = &[
    Built { code: "P0001", fires: || main_of(&utf16(PART)), silent: || main_of(PART.as_bytes()) },
    Built { code: "P0002", fires: || main_by(sized("PART.H", 5 << 30)), silent: || main_by(hole("HOLE.H")) },
    Built {
        code: "P0003",
        fires: || main_of(&with_comment_of((1 << 20) + 1)),
        silent: || main_of(&with_comment_of(1 << 19)),
    },
    Built {
        code: "P0005",
        fires: || main_of(PART.replace(" R0 F300", "\0 R0 F300").as_bytes()),
        silent: || main_of(format!("{PART}\x1a\0\0").as_bytes()),
    },
    Built {
        code: "P0006",
        fires: || main_of(PART.replace(" R0 F300", " R0 F300\0").as_bytes()),
        silent: || main_of(format!("\0\0{PART}\x1a").as_bytes()),
    },
    Built {
        code: "P0102",
        fires: || {
            calling(|_| {
                Err(FileError::Forbidden { why: "it is a link that leads out of the include roots".to_owned() })
            })
        },
        silent: || calling(|_| Ok(hole("HOLE.H"))),
    },
    Built {
        code: "P0103",
        fires: || calling(|_| Err(FileError::Ambiguous { names: vec!["HOLE.H".to_owned(), "hole.h".to_owned()] })),
        silent: || calling(|_| Ok(hole("HOLE.H"))),
    },
    Built {
        code: "P0104",
        fires: || calling(|_| Err(FileError::NoRoot { prefix: "TNC:".to_owned() })),
        silent: || calling(|_| Ok(hole("HOLE.H"))),
    },
    Built {
        code: "P0105",
        fires: || calling(|_| Err(FileError::Io { why: "permission denied".to_owned() })),
        silent: || calling(|_| Ok(hole("HOLE.H"))),
    },
    Built { code: "P0106", fires: || calls_of(1000, 0), silent: || calls_of(999, 0) },
    Built { code: "P0130", fires: || with_table_in(Unit::Inch), silent: || with_table_in(Unit::Mm) },
    Built {
        code: "P0120",
        fires: || calling(|_| Ok(sized("HOLE.H", MAX_CALLED + 1))),
        silent: || calling(|_| Ok(sized("HOLE.H", 1 << 20))),
    },
    // The hundredth one is too much.
    Built { code: "P0121", fires: || calls_of(100, MAX_ALL_CALLED / 99), silent: || calls_of(100, 1 << 10) },
    Built { code: "K2007", fires: || with_table(TOOL_CALL, &[]), silent: || with_table(TOOL_CALL, &[5]) },
    Built { code: "K8001", fires: || checked(&behind_m30("SPL X+20")), silent: || checked(&behind_m30("L X+20")) },
    Built { code: "S8040", fires: || sinumerik_idle("TRAORI"), silent: || sinumerik_idle("G1 X5") },
    Built { code: "S8009", fires: || sinumerik_tool(&[]), silent: || sinumerik_tool(&[5]) },
    Built { code: "O9300", fires: || on_grbl("G33 Z-10 K1.5", ""), silent: || on_grbl("G1 Z-10 F100", "") },
    Built { code: "O9301", fires: || on_grbl("G95 G1 X5 F0.2", ""), silent: || on_grbl("G94 G1 X5 F100", "") },
    Built {
        code: "O9302",
        fires: || on_grbl("G96 S200 M4 LIMS=3000", LATHE),
        silent: || on_grbl("G97 S200 M4", LATHE),
    },
    Built { code: "O9303", fires: || on_grbl("SPOS=90", ""), silent: || on_grbl("M5", "") },
    Built { code: "O9304", fires: || on_grbl("S2=500 M2=3", ""), silent: || on_grbl("S500 M3", "") },
    Built {
        code: "O9305",
        fires: || on_grbl("T1 M6", ""),
        silent: || on_grbl("T1 M6", "[output]\ntool_change = \"stop\""),
    },
    Built { code: "O9306", fires: || on_grbl("T300", ""), silent: || on_grbl("T30", "") },
    Built {
        code: "O9307",
        fires: || on_grbl("T1 M6", "[output]\ntool_change = \"stop\"\ntool_length = \"G43\""),
        silent: || on_grbl("T1 M6", "[output]\ntool_change = \"stop\""),
    },
    Built {
        code: "O9308",
        fires: || on_grbl("T1 M6\nM3\nD1\nG41 G1 X5 F100", CONTROL),
        silent: || on_grbl("T1 M6\nM3\nD1\nG40 G1 X5 F100", CONTROL),
    },
    Built { code: "O9309", fires: || on_grbl("G1 A90 F100", ""), silent: || on_grbl("G1 Y90 F100", "") },
    Built { code: "O9310", fires: || on_grbl("G505", EIGHTH), silent: || on_grbl("G55", EIGHTH) },
    Built { code: "O9311", fires: || on_grbl("M7", ""), silent: || on_grbl("M8", "") },
    Built { code: "O9312", fires: || on_grbl("M1", ""), silent: || on_grbl("M0", "") },
    Built {
        code: "O9313",
        fires: || on_grbl("M77", "[output]\npass_m = [77]"),
        silent: || on_grbl("M8", "[output]\npass_m = [77]"),
    },
    Built { code: "O9314", fires: || on_grbl("G0 X12345.6789", ""), silent: || on_grbl("G0 X1234.5678", "") },
    Built {
        code: "O9315",
        fires: || on_grbl("M8", "[machine]\nkind = \"lathe\"\n[output]\ndiameter = true"),
        silent: || on_grbl("M8", LATHE),
    },
    Built {
        code: "O9316",
        fires: || on_grbl("T1 M6\nG1 X5 F100", BY_HAND),
        silent: || on_grbl("T1 M6\nM3\nG1 X5 F100", BY_HAND),
    },
    // M5 says that the tool shall stand.
    Built {
        code: "O9316",
        fires: || on_grbl("M5\nM4\nT1 M6\nG1 X5 F100", BY_HAND),
        silent: || on_grbl("T1 M6\nM5\nG1 X5 F100", BY_HAND),
    },
    Built { code: "O4003", fires: || on("heidenhain", "G55", ""), silent: || on("sinumerik", "G55", "") },
    Built {
        code: "O4003",
        fires: || on("fanuc", "G507", "[output]\ntool_length = \"off\""),
        silent: || on("linuxcnc", "G507", ""),
    },
    Built { code: "O9326", fires: || on("heidenhain", "M8", SIX), silent: || on("linuxcnc", "M8", SIX) },
    Built { code: "O9327", fires: || on("heidenhain", "T2", BY_HAND_T), silent: || on("grbl", "T2", BY_HAND_T) },
    Built {
        code: "O9328",
        fires: || on("heidenhain", "G18 G2 X10 Y5 Z5 I5 K0 F100", ""),
        silent: || on("heidenhain", "G18 G2 X10 Z5 I5 K0 F100", ""),
    },
    Built {
        code: "O4004",
        fires: || on("uccnc", "G18 G2 X10 Z5 I5 K0 F100", LINES),
        silent: || on("uccnc", "G17 G2 X10 Y0 I5 J0 F100", LINES),
    },
    Built {
        code: "O4005",
        fires: || on("linuxcnc", "T1 M6\nG0 G41 X20 Y0 Z0\nG1 Y30 F100\nG40 X50", FAR_TOOL),
        silent: || on("linuxcnc", "T1 M6\nG1 G41 X20 Y0 Z0 F100\nY30\nG40 X50", FAR_TOOL),
    },
    Built { code: "O2002", fires: || on("mach3", "G55", ""), silent: || on("fanuc", "G55", "") },
    Built { code: "O9331", fires: || on("mach3", "G4 F1", ""), silent: || on("mach3", "G4 F1", SECONDS) },
    Built {
        code: "O9332",
        fires: || on("klipper", "G1 X5 F100", &format!("{MACROS}\nunits = \"inch\"")),
        silent: || on("klipper", "G1 X5 F100", MACROS),
    },
    Built {
        code: "O9333",
        fires: || on("marlin", "G0 X5", "[output]\npass_m = [3, 5]"),
        silent: || on("marlin", "G0 X5", MACROS),
    },
    Built { code: "O9334", fires: || on("klipper", "M8", MACROS), silent: || on("klipper", "M3", MACROS) },
    Built { code: "O9329", fires: || on("heidenhain", "M8", NUMBERS), silent: || on("sinumerik", "M8", NUMBERS) },
    Built { code: "O1005", fires: || on("fanuc", "G4 F0.0004", ""), silent: || on("linuxcnc", "G4 F0.0004", "") },
    Built { code: "O9336", fires: || on("fanuc", "M8", RAPID), silent: || on("marlin", "G0 X5", MACROS) },
    Built { code: "O9337", fires: || on("fanuc", "T1000 M6", M6), silent: || on("fanuc", "T1000 M6", MANY_OFFSETS) },
    // Without the length, it is the radius that has a number.
    Built {
        code: "O9337",
        fires: || on("fanuc", "T100 D1\nM6\nG1 G41 X50 Y9 F100\nY50\nG40 X99", FAR_TOOL),
        silent: || on("fanuc", "T99 D1\nM6\nG1 G41 X50 Y9 F100\nY50\nG40 X99", FAR_TOOL),
    },
    Built { code: "O1006", fires: || on("fanuc", "S10.4 M3", ""), silent: || on("linuxcnc", "S10.4 M3", "") },
    Built {
        code: "O1006",
        fires: || on("linuxcnc", "G95 G1 X5 F0.0012", INCHES),
        silent: || on("linuxcnc", "G95 G1 X5 F0.127", INCHES),
    },
    Built {
        code: "O1006",
        fires: || on("linuxcnc", "G33 Z-10 K0.35", THREE),
        silent: || on("linuxcnc", "G33 Z-10 K1.27", THREE),
    },
    Built {
        code: "O1007",
        fires: || on("linuxcnc", "G33 Z-10 K0.02", THREE),
        silent: || on("linuxcnc", "G33 Z-10 K1.27", THREE),
    },
    Built { code: "O1007", fires: || on("fanuc", "S0.5 M3", ""), silent: || on("linuxcnc", "S0.5 M3", "") },
    Built {
        code: "O1007",
        fires: || on("linuxcnc", "G95 G1 X5 F0.0004", INCHES),
        silent: || on("linuxcnc", "G95 G1 X5 F0.0508", INCHES),
    },
    Built { code: "O9335", fires: || on("haas", ARC, THREE), silent: || on("haas", ARC, INCHES) },
    Built { code: "O9317", fires: || on("fanuc", "M8", LATHE), silent: || on("fanuc-lathe", "M8", LATHE) },
    Built {
        code: "O9319",
        fires: || on("linuxcnc", "G1 A90 F100", INCHES),
        silent: || on("linuxcnc", "G0 A90", INCHES),
    },
    Built { code: "O9320", fires: || on("fanuc-lathe", "T2", TURRET), silent: || on("fanuc", "T2", "") },
    Built {
        code: "O9321",
        fires: || on("fanuc", "G1 SUPA D0 Z5 F100", "[output]\ntool_length = \"off\""),
        silent: || on("fanuc", "G0 SUPA D0 Z5", "[output]\ntool_length = \"off\""),
    },
    Built {
        code: "O9322",
        fires: || on("fanuc-lathe", "G33 X10 Z-10 K1.5", LATHE),
        silent: || on("fanuc-lathe", "G33 Z-10 K1.5", LATHE),
    },
    Built {
        code: "O9324",
        fires: || on("fanuc", "M8", "[output]\nprogram_number = 10000"),
        silent: || on("haas", "M8", "[output]\nprogram_number = 10000"),
    },
    Built {
        code: "O9325",
        fires: || on("sinumerik", "G331 Z-10 K1.5\nG332 Z5 K1.5", ""),
        silent: || on("linuxcnc", "G331 Z-10 K1.5\nG332 Z5 K1.5", ""),
    },
];

/// Codes that no program can bring about today. A case for one of them is to be added together with its removal here.
const NEVER: &[(&str, &str)] = &[
    // Fires in tests/suite/undercut.rs: the undercuts of a contour corner take the form that their corner has.
    ("G3066", "dialects take the side of an undercut from the contour"),
    ("G3020", "dialects look for three points on a line themselves"),
    ("G3021", "dialects look for a lead without a way themselves"),
    ("O9318", "dialects ask for the position along Z in front of such a block themselves"),
    ("O9323", "SINUMERIK states the largest speed with each cutting speed once it was programmed"),
    ("O9001", "what a target has no word for has a code of its own"),
    ("T2029", "retired: G86 is finished without an oversize, too"),
    ("G3043", "dialects ask for the position in front of a cycle themselves"),
];

const LATHE: &str = "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"";
const BY_HAND_T: &str = "[control]\ntool_change = \"t\"\n[output]\ntool_change = \"stop\"";
const BY_HAND: &str = "[output]\ntool_change = \"stop\"";
const CONTROL: &str = "[output]\ncompensation = \"control\"\ntool_change = \"stop\"\n[tools.1]\nradius = 2.0";
const M6: &str = "[control]\ntool_change = \"m6\"";
const MANY_OFFSETS: &str = "[control]\ntool_change = \"m6\"\n[output]\ntool_offsets = 2000";
const FAR_TOOL: &str = "[control]\ntool_change = \"m6\"\n[output]\ncompensation = \"control\"\ntool_length = \"off\"\n\
                        [tools.99]\nradius = 2.0\n[tools.100]\nradius = 2.0";
const LINES: &str = "[output]\narc_fallback_tolerance = 0.01";
const SECONDS: &str = "[output]\ndwell_unit = \"seconds\"";
const MACROS: &str = "[output]\nrapid_feed = 6000\npass_m = [3, 5]";
const SIX: &str = "[output]\ndecimals = 6";
const NUMBERS: &str = "[output]\nline_numbers = 10";
const EIGHTH: &str = "[datums]\nG505 = \"G59.2\"";

const INCHES: &str = "[output]\nunits = \"inch\"";
const THREE: &str = "[output]\nunits = \"inch\"\ndecimals = 3";
const RAPID: &str = "[output]\nrapid_feed = 3000";
const ARC: &str = "G2 X10 Y5 I2.5 J7.5 F100";
const TURRET: &str = "[machine]\nkind = \"lathe\"\n[control]\ntool_change = \"m6\"";

/// A SINUMERIK block on a target that says little.
fn on_grbl(block: &str, configuration: &str) -> Compiled {
    on("grbl", block, configuration)
}

/// A SINUMERIK block on a target.
fn on(target: &str, block: &str, configuration: &str) -> Compiled {
    let mut settings = settings(configuration);
    settings.output.target = partc::internals::target::find(target).expect("a target");
    let text = format!("G90 G0 X0 Y0 Z5\nS1000 M3\n{block}\nM30\n");
    compile_bytes("PART.MPF", text.into_bytes(), "sinumerik", &settings, &NoFiles)
}

const PART: &str = "0 BEGIN PGM PART MM\n1 L X+10 Y+5 R0 F300\n2 END PGM PART MM\n";
const TOOL_CALL: &str = "0 BEGIN PGM PART MM\n1 TOOL CALL 5 Z S2000\n2 L X+10 Y+5 R0 F300\n3 END PGM PART MM\n";
const CALLER: &str = "0 BEGIN PGM PART MM\n1 L X+10 Y+5 Z+2 R0 FMAX\n2 CALL PGM HOLE\n3 END PGM PART MM\n";

fn main_of(bytes: &[u8]) -> Compiled {
    compile_bytes("PART.H", bytes.to_vec(), "klartext", &Settings::default(), &NoFiles)
}

/// What `partc check` says.
fn checked(text: &str) -> Compiled {
    of_findings(check_klartext(text))
}

fn sinumerik_idle(block: &str) -> Compiled {
    of_findings(check_program("sinumerik", "T.MPF", &format!("G0 X0 Y0 Z5\nM30\n{block}\n")))
}

fn of_findings(findings: Vec<Diagnostic>) -> Compiled {
    let failed = findings.iter().any(|found| found.code.severity == Severity::Error);
    let output = if failed { String::new() } else { "%\n".to_owned() };
    Compiled { output, attempt: String::new(), findings, rendered: Vec::new(), lines: Vec::new(), found_in: Vec::new() }
}

fn behind_m30(block: &str) -> String {
    format!("0 BEGIN PGM PART MM\n1 L X+10 Y+5 R0 F300 M30\n2 {block}\n3 END PGM PART MM\n")
}

/// The text in two bytes a character, as an editor set to "Unicode" saves it.
fn utf16(text: &str) -> Vec<u8> {
    [0xfeff].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect()
}

/// The part with a comment of this many characters in its one move.
fn with_comment_of(len: usize) -> Vec<u8> {
    PART.replace(" F300", &format!(" F300 ;{}", "-".repeat(len))).into_bytes()
}

/// Files by a function.
struct By<F>(F);

impl<F: Fn(&str) -> Result<Opened, FileError>> Files for By<F> {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        (self.0)(request.name)
    }
}

fn calling(files: fn(&str) -> Result<Opened, FileError>) -> Compiled {
    compile_bytes("PART.H", CALLER.as_bytes().to_vec(), "klartext", &Settings::default(), &By(files))
}

fn opened(name: &str, text: Box<dyn ReadAt>) -> Opened {
    Opened { name: name.to_owned(), identity: name.to_owned(), text }
}

fn hole(name: &str) -> Opened {
    let stem = name.trim_end_matches(".H");
    let text = format!("0 BEGIN PGM {stem} MM\n1 L Z-5 F150\n2 L Z+2 FMAX\n3 END PGM {stem} MM\n");
    opened(name, Box::new(Memory::new(text.into_bytes())))
}

/// A program that says it is larger than it is: nothing comes behind its text.
struct Sized(Vec<u8>, u64);

impl ReadAt for Sized {
    fn len(&self) -> u64 {
        self.1
    }

    fn read_at(&mut self, at: u64, buf: &mut [u8]) -> io::Result<usize> {
        let from = usize::try_from(at).unwrap_or(usize::MAX).min(self.0.len());
        let text = &self.0[from..self.0.len().min(from + buf.len())];
        buf[..text.len()].copy_from_slice(text);
        Ok(text.len())
    }
}

fn sized(name: &str, size: u64) -> Opened {
    let stem = name.trim_end_matches(".H");
    let text = format!("0 BEGIN PGM {stem} MM\n1 L Z-5 F150\n2 L Z+2 FMAX\n3 END PGM {stem} MM\n");
    opened(name, Box::new(Sized(text.into_bytes(), size)))
}

fn main_by(main: Opened) -> Compiled {
    let session = Session::new(main);
    let dialect = partc::internals::dialect::find("klartext").expect("a dialect");
    session.check(dialect, &Settings::default(), &NoFiles);
    of_findings(session.diags.into_sorted())
}

/// A program that calls `count` different programs of a size: with the main program there are `count + 1` files.
fn calls_of(count: usize, size: u64) -> Compiled {
    let mut text = "0 BEGIN PGM PART MM\n1 L X+0 Y+0 Z+2 R0 FMAX\n".to_owned();
    for i in 0..count {
        text += &format!("{} CALL PGM HOLE{i}.H\n", i + 2);
    }
    text += "END PGM PART MM\n";
    let files = By(|name: &str| Ok(if size == 0 { hole(name) } else { sized(name, size) }));
    compile_bytes("PART.H", text.into_bytes(), "klartext", &Settings::default(), &files)
}

/// Compiles with a complete tool table of these numbers.
fn with_table(text: &str, numbers: &[u32]) -> Compiled {
    let table: String = numbers.iter().map(|n| format!("[tools.{n}]\nradius = 5.0\n")).collect();
    let mut settings = settings(&table);
    settings.tools.complete = true;
    compile_bytes("PART.H", text.as_bytes().to_vec(), "klartext", &settings, &NoFiles)
}

/// A program in mm that calls tool 5 of a table in this unit.
fn with_table_in(unit: Unit) -> Compiled {
    let mut settings = settings("[tools.5]\nradius = 5.0\n");
    settings.tools.unit = Some(unit);
    compile_bytes("PART.H", TOOL_CALL.as_bytes().to_vec(), "klartext", &settings, &NoFiles)
}

/// A SINUMERIK program with tool 5, and a complete table of these numbers.
fn sinumerik_tool(numbers: &[u32]) -> Compiled {
    let table: String = numbers.iter().map(|n| format!("[tools.{n}]\nradius = 5.0\n")).collect();
    let mut settings = settings(&table);
    settings.tools.complete = true;
    compile_bytes("PART.MPF", b"T5 M6\nG0 X0\nM30\n".to_vec(), "sinumerik", &settings, &NoFiles)
}

/// The cases of each code: `(fires, silent)`.
fn by_code() -> BTreeMap<String, (Vec<&'static Case>, Vec<&'static Case>)> {
    let mut map: BTreeMap<String, (Vec<&Case>, Vec<&Case>)> = BTreeMap::new();
    for case in cases("errors") {
        let stem = case.stem();
        let (code, rest) = stem.split_once('_').unwrap_or_else(|| panic!("{stem}: CODE_fires or CODE_silent"));
        let entry = map.entry(code.to_owned()).or_default();
        match rest.split('_').next() {
            Some("fires") => entry.0.push(case),
            Some("silent") => entry.1.push(case),
            _ => panic!("{stem}: CODE_fires or CODE_silent"),
        }
    }
    map
}

fn check_fires(what: &str, code: &codes::Code, compiled: &Compiled) {
    assert!(compiled.codes().contains(&code.id), "{what} does not fire: {:#?}", compiled.rendered);
    assert_eq!(compiled.has_errors(), compiled.output.is_empty(), "{what}: output beside errors");
    if code.severity == Severity::Error {
        assert!(compiled.output.is_empty(), "{what}: an error, and still an output");
    }
}

fn check_silent(what: &str, code: &codes::Code, compiled: &Compiled) {
    assert!(!compiled.codes().contains(&code.id), "{what} is not silent: {:#?}", compiled.rendered);
    assert!(!compiled.has_errors(), "{what}: mended, and still an error: {:#?}", compiled.rendered);
}

#[test]
fn every_code_fires_and_is_silent() {
    let cases = by_code();
    let mut missing = Vec::new();
    for code in codes::all() {
        let built: Vec<&Built> = BUILT.iter().filter(|built| built.code == code.id).collect();
        for built in &built {
            check_fires(&format!("{} built", code.id), code, &(built.fires)());
            check_silent(&format!("{} built", code.id), code, &(built.silent)());
        }
        let none = (Vec::new(), Vec::new());
        let (fires, silent) = cases.get(code.id).unwrap_or(&none);
        for case in fires {
            check_fires(&case.name, code, &case.compile());
        }
        for case in silent {
            check_silent(&case.name, code, &case.compile());
        }
        let never = NEVER.iter().any(|(id, _)| *id == code.id);
        let shown = !built.is_empty() || (!fires.is_empty() && !silent.is_empty());
        assert!(!(never && (shown || !fires.is_empty())), "{} fires: take it out of NEVER", code.id);
        if !shown && !never {
            missing.push(code.id);
        }
    }
    assert!(missing.is_empty(), "no case that fires, or none that is silent, for {missing:?}");
}

#[test]
fn every_case_belongs_to_a_code_and_has_its_counterpart() {
    for (id, (fires, silent)) in by_code() {
        assert!(codes::find(&id).is_some(), "{id} is no code");
        let suffixes = |cases: &[&Case], kind: &str| -> BTreeSet<String> {
            cases.iter().map(|case| case.stem().replace(&format!("{id}_{kind}"), "")).collect()
        };
        assert_eq!(suffixes(&fires, "fires"), suffixes(&silent, "silent"), "cases of {id} come in pairs");
    }
    for id in BUILT.iter().map(|built| built.code).chain(NEVER.iter().map(|(id, _)| *id)) {
        assert!(codes::find(id).is_some(), "{id} is no code");
    }
}

/// Findings of a mended program are about other things, so a pair differs in as little as possible.
#[test]
fn mended_programs_differ_in_few_lines() {
    for (id, (fires, silent)) in by_code() {
        for (fires, silent) in fires.iter().zip(&silent) {
            let lines = |case: &Case| -> Vec<String> {
                let text = case.text().expect("a program in UTF-8");
                // Block numbers move when a block is added.
                text.lines()
                    .map(|line| line.trim_start_matches(|c: char| c.is_ascii_digit()).trim().to_owned())
                    .collect()
            };
            let (a, b) = (lines(fires), lines(silent));
            let lost = a.iter().filter(|line| !b.contains(line)).count();
            // The title comment, the mistake, and for long definitions what replaces them.
            let most = if matches!(id.as_str(), "K9001" | "K9003") { 12 } else { 3 };
            assert!(lost <= most, "{id}: {lost} lines of {} changed", fires.name);
        }
    }
}

#[test]
fn every_finding_has_a_place_and_a_plain_message() {
    for case in cases("errors") {
        let compiled = case.compile();
        for (found, rendered) in compiled.findings.iter().zip(&compiled.rendered) {
            let what = format!("{}: {rendered}", case.name);
            check_place(&what, case, found, rendered);
            check_text(&what, &found.text());
            if let Some(help) = &found.help {
                check_text(&what, help);
            }
            for label in std::iter::once(&found.label).chain(&found.more).filter(|label| !label.text.is_empty()) {
                check_text(&what, &label.text);
            }
        }
    }
    for built in BUILT {
        for found in (built.fires)().findings {
            check_text(built.code, &found.text());
            assert!(found.label.loc.line >= 1, "{}", built.code);
        }
    }
}

/// The span lies in its file, on the line that is shown.
fn check_place(what: &str, case: &Case, found: &Diagnostic, rendered: &str) {
    let loc = found.label.loc;
    let mut parts = rendered.splitn(4, ':');
    let (name, line, column) = (parts.next().expect("a name"), parts.next(), parts.next());
    let number =
        |part: Option<&str>| part.and_then(|part| part.parse::<usize>().ok()).unwrap_or_else(|| panic!("{what}"));
    let (line, column) = (number(line), number(column));
    let text = if loc.file.0 == 0 {
        assert_eq!(name, case.file, "{what}");
        &case.program
    } else {
        case.called.get(name).expect("a called program")
    };
    let (start, end) = (loc.span.start as usize, loc.span.end as usize);
    assert!(start <= end && end <= text.len(), "{what}: span {start} to {end} of {} bytes", text.len());
    let lines = text.split(|b| *b == b'\n').count();
    assert!(loc.line >= 1 && line <= lines && column >= 1, "{what}");
    let above = text[..start].iter().filter(|b| **b == b'\n').count() + 1;
    assert_eq!(line, above, "{what}: the marked bytes stand on another line");
    // Only the end of a file that breaks off has no word to mark.
    let marked = !String::from_utf8_lossy(&text[start..end]).trim().is_empty() || end == text.len();
    assert!(marked, "{what}: nothing is marked");
}

/// Words for a machinist: no full stop, no name of the program's inside.
fn check_text(what: &str, text: &str) {
    assert!(!text.trim().is_empty(), "{what}: no text");
    assert!(!text.ends_with('.') || text.ends_with('…'), "{what}: ends in a full stop: {text}");
    assert!(text.chars().all(|c| !c.is_control()), "{what}: control characters: {text}");
    // What stands in quotes is the user's, or to be typed by him.
    let plain: String =
        text.split('`').step_by(2).flat_map(|part| part.split('"').step_by(2)).collect::<Vec<_>>().join(" ");
    for sign in ["::", "Some(", "None", "Err(", "Ok(", "{", "}", "unwrap", "usize", "f64", "NaN", "_"] {
        assert!(!plain.contains(sign), "{what}: `{sign}` in: {text}");
    }
    for word in plain.split(|c: char| !c.is_alphanumeric()).filter(|word| !matches!(*word, "GiB" | "MiB")) {
        let inner = word.chars().zip(word.chars().skip(1)).any(|(a, b)| a.is_lowercase() && b.is_uppercase());
        assert!(!inner, "{what}: `{word}` looks like a name of the source: {text}");
    }
    let mut first = plain.chars();
    let capital = first.next().is_some_and(char::is_uppercase) && first.next().is_some_and(char::is_lowercase);
    assert!(!capital, "{what}: messages begin in lower case: {text}");
}

/// The title of a code is what all its messages have in common, so it reads like one.
#[test]
fn titles_and_explanations_read_alike() {
    for code in codes::all() {
        check_text(code.id, code.title);
        assert!(code.title.chars().count() <= 72, "{}: a title is one short line", code.id);
        let explain = code.explain;
        assert!(explain.ends_with('.') || explain.ends_with('`'), "{}: explanations are sentences", code.id);
        assert!(!explain.contains("  ") && !explain.contains(" \n"), "{}: stray blanks", code.id);
        assert!(code.name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-'), "{}", code.id);
    }
}

#[test]
fn a_finding_in_a_called_subprogram_says_how_the_program_got_there() {
    let compiled = find("errors/klartext/G3001_fires_in_subprogram").expect("the case").compile();
    assert!(compiled.rendered[0].ends_with("(called from G3001_fires_in_subprogram.H:5)"), "{:?}", compiled.rendered);
}

/// The same mistake at the same place is one finding, however often the loop passes it.
#[test]
fn a_mistake_in_a_loop_is_one_finding() {
    let text = "0 BEGIN PGM LOOP MM\n1 LBL 1\n2 L IX+10 R0 F300 M25\n3 CALL LBL 1 REP 9\n4 END PGM LOOP MM\n";
    let compiled = main_of(text.as_bytes());
    assert_eq!(compiled.codes(), ["K2701"], "{:?}", compiled.rendered);
    assert_eq!(compiled.findings[0].times, 10);
}

/// A file that breaks off while it is read is no shorter program.
#[test]
fn a_read_error_in_the_middle_of_a_file_is_an_error() {
    struct Breaks(Vec<u8>);
    impl ReadAt for Breaks {
        fn len(&self) -> u64 {
            self.0.len() as u64
        }

        fn read_at(&mut self, at: u64, buf: &mut [u8]) -> io::Result<usize> {
            if at > 0 {
                return Err(io::Error::other("the medium was removed"));
            }
            let n = buf.len().min(self.0.len() - 1);
            buf[..n].copy_from_slice(&self.0[..n]);
            Ok(n)
        }
    }
    let files = By(|name: &str| {
        let text = format!("0 BEGIN PGM {name} MM\n1 L Z-5 F150\n2 L Z+2 FMAX\n3 END PGM {name} MM\n");
        Ok(opened(name, Box::new(Breaks(text.into_bytes()))))
    });
    let compiled = compile_bytes("PART.H", CALLER.as_bytes().to_vec(), "klartext", &Settings::default(), &files);
    assert!(compiled.codes().contains(&"P0105") && compiled.output.is_empty(), "{:?}", compiled.rendered);
}

/// 500 findings are kept; the rest is counted, so that the exit code never depends on the room.
#[test]
fn more_findings_than_are_kept_still_fail() {
    let mut text = "0 BEGIN PGM MANY MM\n1 L X+0 Y+0 R0 F300\n".to_owned();
    for _ in 0..600 {
        text += "L X+10 R5\n";
    }
    text += "END PGM MANY MM\n";
    let compiled = main_of(text.as_bytes());
    assert_eq!(compiled.findings.len(), 500);
    assert!(compiled.output.is_empty());
}
