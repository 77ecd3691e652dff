//! The kinds of files that are told, one row each.

use super::super::Dialect;
use super::line::Line;
use super::marks::{self, Mark, alone, beside, half};
use super::{Kind, stands_for};

/// What the extension says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Own {
    Klartext,
    Sinumerik,
    Turning,
    Mtc200,
    Plain,
    Nothing,
}

impl Own {
    pub fn of(file_name: &str) -> Own {
        let extension = file_name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
        match extension.as_deref() {
            Some("h" | "klartext") => Own::Klartext,
            Some("mpf" | "spf" | "arc") => Own::Sinumerik,
            Some("nc" | "ncs") => Own::Turning,
            Some("npg") => Own::Mtc200,
            Some("ngc" | "gcode") => Own::Plain,
            _ => Own::Nothing,
        }
    }

    /// Is this line one of the language that the extension says, and of no other?
    pub fn shows(self, line: &Line<'_>) -> bool {
        match self {
            Own::Klartext => is_klartext(line),
            Own::Sinumerik | Own::Nothing => is_sinumerik(line) || is_klartext(line),
            Own::Turning | Own::Mtc200 | Own::Plain => false,
        }
    }
}

/// Begins with a word of the dialog, behind the number of the block.
fn is_klartext(line: &Line<'_>) -> bool {
    const VERBS: [&[u8]; 15] = [
        b"BEGIN",
        b"CYCL",
        b"TOOL",
        b"BLK",
        b"LBL",
        b"FN",
        b"PLANE",
        b"APPR",
        b"DEP",
        b"RND",
        b"CHF",
        b"PATTERN",
        b"FUNCTION",
        b"SEL",
        b"TCH",
    ];
    let code = line.code.trim_ascii_start();
    let code = code[code.iter().take_while(|b| b.is_ascii_digit()).count()..].trim_ascii_start();
    let word = code.split(|b| !b.is_ascii_alphabetic()).next().unwrap_or_default();
    let path = matches!(word, b"L" | b"LP" | b"C" | b"CC" | b"CP" | b"CR" | b"CT");
    let is_axis = |rest: &[u8]| matches!(rest, [b'X' | b'Y' | b'Z' | b'P' | b'I', ..]);
    VERBS.contains(&word) || path && is_axis(code[word.len()..].trim_ascii_start())
}

/// A name, an assignment, or G290, which ends a section of the ISO dialect: what no other control writes so.
fn is_sinumerik(line: &Line<'_>) -> bool {
    const NAMES: [&[u8]; 20] = [
        b"CYCLE",
        b"DEF",
        b"PROC",
        b"MSG",
        b"MCALL",
        b"RET",
        b"STOPRE",
        b"DIAMON",
        b"DIAMOF",
        b"TRANS",
        b"ATRANS",
        b"ROT",
        b"AROT",
        b"SUPA",
        b"GOTOF",
        b"GOTOB",
        b"REPEAT",
        b"EXTERN",
        b"WORKPIECE",
        b"ENDIF",
    ];
    let named = line.words.iter().any(|word| word.is("G", "290") || NAMES.contains(&&word.letters[..]));
    let code = line.code.trim_ascii_start();
    let assigned = line.words.iter().any(|word| {
        let behind = line.code.get(word.span.end as usize..).unwrap_or_default().trim_ascii_start();
        word.letters != b"#" && behind.first() == Some(&b'=') && !word.letters.starts_with(b"V")
    });
    named || assigned && !code.starts_with(b"#") || line.text.starts_with(b"%_N_")
}

fn any(_: Own) -> bool {
    true
}

fn text_of_ours(own: Own) -> bool {
    !matches!(own, Own::Nothing | Own::Plain)
}

fn but_plain(own: Own) -> bool {
    !matches!(own, Own::Plain | Own::Mtc200)
}

const FANUC_MARKS: &[Mark] = &[
    half(marks::tape_start),
    half(marks::program_number),
    half(marks::tool_length),
    half(marks::reference_point),
    half(marks::drilling),
    half(marks::macro_call),
    half(marks::condition),
    beside(marks::variable),
];

/// Each with the extensions under which it is looked for; the first that fits is it.
pub(super) static ALL: &[&Kind] =
    &[&C, &SINUMERIK, &PRINTER, &OKUMA, &OLD_SINUMERIK, &PHILIPS, &DIN_ISO, &ISO, &FANUC, &PLAIN];

static FANUC_DIALECT: Dialect = stands_for("Fanuc or Haas");
const READ_PLAIN: &str = "partc does not read the language of these controls yet. Have the program made for a control that it reads, or, if \
     it holds plain moves without variables, calls and cycles, try `--dialect gcode`, which reads them as LinuxCNC does";
static FANUC: Kind = Kind {
    dialect: &FANUC_DIALECT,
    is: "a program for Fanuc, Haas and similar controls",
    way_on: READ_PLAIN,
    marks: FANUC_MARKS,
    sure: false,
    under: but_plain,
};

static ISO_DIALECT: Dialect = stands_for("ISO dialect of SINUMERIK");
static ISO: Kind = Kind {
    dialect: &ISO_DIALECT,
    is: "a program in the ISO dialect of a SINUMERIK",
    way_on: "partc reads the SINUMERIK language (G290), not the ISO dialect (G291). Have the program made in the SINUMERIK language, or, \
             if it holds plain moves without variables, calls and cycles, try `--dialect gcode`",
    // The switch alone is a block of the SINUMERIK language, which is refused where it stands.
    marks: &[half(marks::iso_switch), half(marks::iso_word)],
    sure: false,
    under: |own| own == Own::Sinumerik,
};

static SINUMERIK_DIALECT: Dialect = stands_for("SINUMERIK");
static SINUMERIK: Kind = Kind {
    dialect: &SINUMERIK_DIALECT,
    is: "a program in the language of the SINUMERIK",
    way_on: "partc reads it: `--dialect sinumerik`, or for all such files `[dialects]` with `\"**/*.nc\" = \"sinumerik\"` in partc.toml",
    marks: &[
        alone(marks::cycle_call),
        alone(marks::declaration),
        half(marks::radius_by_name),
        half(marks::jump_by_direction),
        half(marks::tool_by_name),
        half(marks::stop_of_reading),
    ],
    sure: false,
    under: |own| own == Own::Turning || own == Own::Plain,
};

static PLAIN_DIALECT: Dialect = stands_for("plain G-code");
static PLAIN: Kind = Kind {
    dialect: &PLAIN_DIALECT,
    is: "G-code for a mill, not a program of a HEIDENHAIN turning control",
    way_on: "partc reads plain G-code as LinuxCNC does: `--dialect gcode`, or for all such files `[dialects]` with `\"**/*.nc\" = \"gcode\"` in \
             partc.toml",
    marks: &[
        alone(marks::safety_block),
        alone(marks::tool_change),
        alone(marks::tool_length),
        half(marks::round_comment),
        half(marks::unit),
    ],
    sure: false,
    under: |own| own == Own::Turning,
};

static PRINTER_DIALECT: Dialect = stands_for("3-D printer");
static PRINTER: Kind = Kind {
    dialect: &PRINTER_DIALECT,
    is: "a file for a 3-D printer (Marlin and similar firmware)",
    way_on: "partc reads programs of machine tools: there is nothing to compile here. Leave such files out with a line in `.partcignore`",
    marks: &[alone(marks::slicer), half(marks::heater), half(marks::filament), half(marks::bed_probing)],
    sure: false,
    under: |own| own != Own::Mtc200,
};

static OKUMA_DIALECT: Dialect = stands_for("Okuma OSP");
static OKUMA: Kind = Kind {
    dialect: &OKUMA_DIALECT,
    is: "a program for an Okuma OSP control",
    way_on: "partc does not read the language of this control. Have the program made for a control that it reads",
    marks: &[alone(marks::okuma_name), half(marks::okuma_word), half(marks::okuma_call), half(marks::okuma_offset)],
    sure: false,
    under: but_plain,
};

static DIN_ISO_DIALECT: Dialect = stands_for("HEIDENHAIN DIN/ISO");
static DIN_ISO: Kind = Kind {
    dialect: &DIN_ISO_DIALECT,
    is: "a HEIDENHAIN program in DIN/ISO (G-code)",
    way_on: "partc reads Klartext. Have the program made as Klartext (`.H`): the control or the CAM system can do it",
    marks: &[alone(marks::din_iso_head)],
    sure: true,
    under: but_plain,
};

static OLD_SINUMERIK_DIALECT: Dialect = stands_for("SINUMERIK 810, 850 or 880");
static OLD_SINUMERIK: Kind = Kind {
    dialect: &OLD_SINUMERIK_DIALECT,
    is: "a program for an older SINUMERIK (810, 850, 880)",
    way_on: "partc reads the language of the SINUMERIK 840D and later controls: `@` commands and cycles by L and R numbers have to be \
             rewritten",
    marks: &[half(marks::old_head), half(marks::old_command)],
    sure: true,
    under: but_plain,
};

static PHILIPS_DIALECT: Dialect = stands_for("Philips or MillPlus");
static PHILIPS: Kind = Kind {
    dialect: &PHILIPS_DIALECT,
    is: "a program for a Philips or MillPlus control",
    way_on: "partc does not read the language of this control. Have the program made for a control that it reads",
    marks: &[alone(marks::philips_head)],
    sure: true,
    under: but_plain,
};

static C_DIALECT: Dialect = stands_for("C or C++");
static C: Kind = Kind {
    dialect: &C_DIALECT,
    is: "C or C++ source text",
    way_on: "no part program: leave such files out with a line in `.partcignore`, such as `*.h` in their folder",
    marks: &[alone(marks::preprocessor)],
    sure: true,
    under: |own| own == Own::Klartext || own == Own::Nothing,
};

/// What is no text of blocks at all, by its first bytes.
pub(super) fn container(head: &[u8]) -> Option<&'static Kind> {
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head).trim_ascii_start();
    let begins = |with: &[u8]| text.get(..with.len()).is_some_and(|start| start.eq_ignore_ascii_case(with));
    if begins(b"@@MMC") {
        return Some(&PANEL_ARCHIVE);
    }
    if begins(b"<?xml") || begins(b"<!DOCTYPE") || begins(b"<html") || begins(b"<svg") {
        return Some(&MARKUP);
    }
    if begins(b"{\"") || begins(b"{\n") && is_json(text) || begins(b"[{\"") {
        return Some(&JSON);
    }
    let packed: [&[u8]; 8] =
        [b"PK\x03\x04", b"%PDF-", b"\x7fELF", b"\x89PNG", b"\x1f\x8b", b"Rar!\x1a", b"7z\xbc\xaf", b"\xd0\xcf\x11\xe0"];
    (packed.iter().any(|magic| head.starts_with(magic)) || has_control_bytes(head)).then_some(&BINARY)
}

/// One of twenty bytes is none of text. Line ends, tabs, what punched tapes begin with, and NUL and Ctrl-Z, of which findings of
/// their own tell, are no proof.
fn has_control_bytes(head: &[u8]) -> bool {
    let odd = |byte: &&u8| matches!(**byte, 1..=8 | 0x0e..=0x10 | 0x15..=0x19 | 0x1c..=0x1f);
    let count = head.iter().filter(odd).count();
    count >= 16 && count * 20 > head.len()
}

/// Is the first thing behind the bracket a name in quotes?
fn is_json(text: &[u8]) -> bool {
    text.get(1..).is_some_and(|rest| rest.trim_ascii_start().starts_with(b"\""))
}

static PANEL_ARCHIVE_DIALECT: Dialect = stands_for("archives of an operator panel");
static PANEL_ARCHIVE: Kind = Kind {
    dialect: &PANEL_ARCHIVE_DIALECT,
    is: "a binary archive of the operator panel of a SINUMERIK",
    way_on: "its programs cannot be read out of it here: read the archive in on the control or on a PC and export the programs one by one \
             (`.MPF`, `.SPF`), or as an archive in text (punched tape format)",
    marks: &[],
    sure: false,
    under: any,
};

static MARKUP_DIALECT: Dialect = stands_for("XML or HTML");
static MARKUP: Kind =
    Kind { dialect: &MARKUP_DIALECT, is: "XML or HTML", way_on: NO_PROGRAM, marks: &[], sure: true, under: any };

static JSON_DIALECT: Dialect = stands_for("JSON");
static JSON: Kind = Kind { dialect: &JSON_DIALECT, is: "JSON", way_on: NO_PROGRAM, marks: &[], sure: true, under: any };

static BINARY_DIALECT: Dialect = stands_for("binary files");
static BINARY: Kind = Kind {
    dialect: &BINARY_DIALECT,
    is: "a binary file, not text",
    way_on: NO_PROGRAM,
    marks: &[],
    sure: true,
    under: any,
};

static TEXT_DIALECT: Dialect = stands_for("text");
/// Prose; [`super::look`] asks for it last.
pub(super) static TEXT: Kind = Kind {
    dialect: &TEXT_DIALECT,
    is: "text, not a part program",
    way_on: NO_PROGRAM,
    marks: &[],
    sure: false,
    under: text_of_ours,
};

const NO_PROGRAM: &str = "no part program: if one was meant, get it anew from where it was made; else leave the file out with a line in \
                          `.partcignore`";
