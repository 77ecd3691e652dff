//! Inputs that no book can show: built by the test, for the codes that only they bring about.

use std::io;

use partc::internals::diag::{Diagnostic, Severity};
use partc::internals::dialect::read_as;
use partc::internals::driver::Session;
use partc::internals::machine::{Settings, Unit};
use partc::internals::text::files::NoFiles;
use partc::internals::text::sources::{MAX_ALL_CALLED, MAX_CALLED};
use partc::internals::text::{FileError, Files, Memory, Opened, ReadAt, Request};

use super::super::common::{Compiled, check_klartext, check_program, compile_bytes, settings};

/// A code whose input is made by the test: a wide file, a huge one, a file system that refuses.
pub(super) struct Built {
    pub code: &'static str,
    pub fires: fn() -> Compiled,
    pub silent: fn() -> Compiled,
}

pub(super) const BUILT: &[Built] = &[
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
    Built { code: "P0009", fires: || read_as_it_is("P.H", "#ifndef P_H\n"), silent: || read_as_it_is("P.H", PART) },
    Built {
        code: "P0012",
        fires: || read_as_it_is("A.NC", "N1 G95 F0.2\nN2 G0 X50 Z2\nN3 M30\n"),
        silent: || read_as_it_is("A.NC", "N1 G95 F0.2 [rough the face]\nN2 G0 X50 Z2\nN3 M30\n"),
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
    Built { code: "P2006", fires: || with_table(TOOL_CALL, &[]), silent: || with_table(TOOL_CALL, &[5]) },
    Built { code: "P8140", fires: || checked(&behind_m30("SPL X+20")), silent: || checked(&behind_m30("L X+20")) },
    Built { code: "P8140", fires: || sinumerik_idle("TRAORI"), silent: || sinumerik_idle("G1 X5") },
    Built { code: "P2006", fires: || sinumerik_tool(&[]), silent: || sinumerik_tool(&[5]) },
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
    Built { code: "O9338", fires: || on("fanuc", "M8", ""), silent: || on("fanuc", "M8", EXACT) },
    Built { code: "O9338", fires: || on("grbl", "M8", ""), silent: || on("grbl", "M8", SET_UP) },
    Built {
        code: "O9338",
        fires: || on("heidenhain", "G60 G1 X5 F100", ""),
        silent: || on("heidenhain", "G60 G1 X5 F100", BOUND),
    },
    Built { code: "O9339", fires: || on("fanuc", "M8", BOUND), silent: || on("linuxcnc", "M8", BOUND) },
    Built { code: "O9339", fires: || on("heidenhain", "M8", EXACT), silent: || on("fanuc", "M8", EXACT) },
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
        fires: || on("sinumerik", "F100\nCYCLE840(5,0,2,-10,,0,4,3,0,,1.5)", ""),
        silent: || on("linuxcnc", "F100\nCYCLE840(5,0,2,-10,,0,4,3,0,,1.5)", ""),
    },
    Built { code: "O4007", fires: || on("fanuc", STEPPED, TAPPED), silent: || on("sinumerik", STEPPED, TAPPED) },
    Built { code: "O4009", fires: || on("fanuc", STEPPED, TAPPED), silent: || on("heidenhain", STEPPED, TAPPED) },
    Built { code: "O4008", fires: || on("haas", WAITING, TAPPED), silent: || on("sinumerik", WAITING, TAPPED) },
    Built {
        code: "O9340",
        fires: || on_grbl("G331 Z-10 K1.5\nG332 Z5 K1.5", ""),
        silent: || on_grbl("G1 Z-10 F100", ""),
    },
    Built {
        code: "O9341",
        fires: || on("haas", "G331 Z-10 K1.5\nG332 Z2 K1.5", TAPPED),
        silent: || on("haas", "G331 Z-10 K1.5\nG332 Z5 K1.5", TAPPED),
    },
];

/// Codes that no program can bring about today. A case for one of them is to be added together with its removal here.
pub(super) const NEVER: &[(&str, &str)] = &[
    // Fires in tests/suite/undercut.rs: the undercuts of a contour corner take the form that their corner has.
    ("G3066", "dialects take the side of an undercut from the contour"),
    ("G3020", "dialects look for three points on a line themselves"),
    ("G3021", "dialects look for a lead without a way themselves"),
    ("O9318", "dialects ask for the position along Z in front of such a block themselves"),
    ("O9323", "SINUMERIK states the largest speed with each cutting speed once it was programmed"),
    ("O9001", "what a target has no word for has a code of its own"),
    ("S8024", "retired: undercut cycles compensate the nose, or refuse"),
    ("T2029", "retired: G86 is finished without an oversize, too"),
    ("G3043", "dialects ask for the position in front of a cycle themselves"),
];

const LATHE: &str = "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"";
const BY_HAND_T: &str = "[control]\ntool_change = \"t\"\n[output]\ntool_change = \"stop\"";
const BY_HAND: &str = "[output]\ntool_change = \"stop\"";
const CONTROL: &str = "[output]\ncompensation = \"control\"\ntool_change = \"stop\"\n[tools.1]\nradius = 2.0";
const M6: &str = "[control]\ntool_change = \"m6\"";
const BOUND: &str = "[output]\npath_control = { tolerance = 0.05 }";
const SET_UP: &str = "[output]\npath_control = \"none\"";
const EXACT: &str = "[output]\npath_control = \"exact\"";
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

/// The length of a tool begins with a move of its own where it has to.
const TAPPED: &str = "[output]\ntool_length = \"off\"";
const STEPPED: &str = "G331 Z-4 K1.5\nG332 Z-3 K1.5\nG331 Z-10 K1.5\nG332 Z5 K1.5";
const WAITING: &str = "G331 Z-10 K1.5\nG4 F0.5\nG332 Z5 K1.5";

pub(super) const PART: &str = "0 BEGIN PGM PART MM\n1 L X+10 Y+5 R0 F300\n2 END PGM PART MM\n";
const TOOL_CALL: &str = "0 BEGIN PGM PART MM\n1 TOOL CALL 5 Z S2000\n2 L X+10 Y+5 R0 F300\n3 END PGM PART MM\n";
pub(super) const CALLER: &str = "0 BEGIN PGM PART MM\n1 L X+10 Y+5 Z+2 R0 FMAX\n2 CALL PGM HOLE\n3 END PGM PART MM\n";

pub(super) fn main_of(bytes: &[u8]) -> Compiled {
    compile_bytes("PART.H", bytes.to_vec(), "klartext", &Settings::default(), &NoFiles)
}

/// In the language that the file shows, if it is one.
fn read_as_it_is(name: &str, text: &str) -> Compiled {
    let text_of_it = Box::new(Memory::new(text.as_bytes().to_vec()));
    let session = Session::new(Opened { name: name.to_owned(), identity: name.to_owned(), text: text_of_it });
    let dialect = read_as(name, text.as_bytes()).expect("a language, or what it is instead");
    session.check(dialect, &Settings::default(), &NoFiles);
    of_findings(session.diags.into_sorted())
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
pub(super) struct By<F>(pub F);

impl<F: Fn(&str) -> Result<Opened, FileError>> Files for By<F> {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        (self.0)(request.name)
    }
}

fn calling(files: fn(&str) -> Result<Opened, FileError>) -> Compiled {
    compile_bytes("PART.H", CALLER.as_bytes().to_vec(), "klartext", &Settings::default(), &By(files))
}

pub(super) fn opened(name: &str, text: Box<dyn ReadAt>) -> Opened {
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
