//! The kinds of programs and sources that are told by their lines, one row each.

use super::super::Dialect;
use super::marks::{self, Mark, alone, beside, half, proof};
use super::own::Own;
use super::source_marks as source;
use super::way_on::WayOn;
use super::{Kind, stands_for};

fn any(_: Own) -> bool {
    true
}

fn but_plain(own: Own) -> bool {
    !matches!(own, Own::Plain | Own::Mtc200)
}

/// Extensions of ours where the words of plain G-code are words of no block.
fn no_iso(own: Own) -> bool {
    matches!(own, Own::Klartext | Own::Sinumerik)
}

/// Each with the extensions under which it is looked for; the first that fits is it.
pub(super) static ALL: &[&Kind] = &[
    &C,
    &DRAWING,
    &STEP,
    &STL,
    &OKUMA,
    &OLD_SINUMERIK,
    &PHILIPS,
    &DIN_ISO,
    &KLARTEXT,
    &SINUMERIK,
    &SINUMERIK_NC,
    &PRINTER,
    &ISO,
    &LINUXCNC,
    &FANUC,
    &MILL,
    &G_CODE,
    &G_BLOCKS,
];

const BASE: Kind = Kind {
    dialect: &FANUC_DIALECT,
    is: "",
    way_on: WayOn::Said(""),
    marks: &[],
    sure: false,
    iso_sections: false,
    under: any,
};

static FANUC_DIALECT: Dialect = stands_for("Fanuc or Haas");
static FANUC: Kind = Kind {
    dialect: &FANUC_DIALECT,
    is: "a program for Fanuc, Haas and similar controls",
    way_on: WayOn::TriedOnMill {
        taken: "partc does not read the language of these controls yet, but this program holds only what plain G-code has, too: \
                `--dialect gcode` reads it as LinuxCNC does. G4 P counts seconds there, and `X100` is 100 mm: check both",
        refused: "partc does not read the language of these controls yet: have the program made for a control that it reads",
    },
    marks: FANUC_MARKS,
    under: but_plain,
    ..BASE
};
const FANUC_MARKS: &[Mark] = &[
    half(marks::tape_start),
    half(marks::program_number),
    half(marks::tool_length),
    half(marks::reference_point),
    half(marks::drilling),
    half(marks::macro_call),
    half(marks::jump_to_number),
    half(marks::offset_by_number),
    half(marks::turning_cycle),
    proof(marks::condition),
    proof(marks::set_variable),
    beside(marks::variable),
];

static ISO_DIALECT: Dialect = stands_for("ISO dialect of SINUMERIK");
static ISO: Kind = Kind {
    dialect: &ISO_DIALECT,
    is: "a program in the ISO dialect of a SINUMERIK",
    way_on: WayOn::Said(
        "partc reads the SINUMERIK language (G290), not the ISO dialect (G291). Have the program made in the SINUMERIK language",
    ),
    // The switch alone is a block of the SINUMERIK language, which is refused where it stands.
    marks: &[half(marks::iso_switch), half(marks::iso_word)],
    iso_sections: true,
    under: |own| own == Own::Sinumerik,
    ..BASE
};

static KLARTEXT_DIALECT: Dialect = stands_for("Klartext under another name");
static KLARTEXT: Kind = Kind {
    dialect: &KLARTEXT_DIALECT,
    is: "a program in HEIDENHAIN Klartext",
    way_on: WayOn::Said(
        "partc reads it: `--dialect klartext`, or for all such files `[dialects]` with `\"{pattern}\" = \"klartext\"` in partc.toml",
    ),
    marks: &[alone(marks::dialog), half(marks::dialog_line)],
    under: |own| own.turns() || matches!(own, Own::Sinumerik | Own::Plain),
    ..BASE
};

static SINUMERIK_DIALECT: Dialect = stands_for("SINUMERIK under another name");
static SINUMERIK: Kind = Kind {
    dialect: &SINUMERIK_DIALECT,
    is: "a program in the language of the SINUMERIK",
    way_on: WayOn::Said(
        "partc reads it: `--dialect sinumerik`, or for all such files `[dialects]` with `\"{pattern}\" = \"sinumerik\"` in partc.toml",
    ),
    marks: &[
        alone(marks::cycle_call),
        alone(marks::declaration),
        alone(marks::r_parameter),
        alone(marks::axis_by_name),
        alone(marks::jump_by_direction),
        alone(marks::tool_by_name),
        alone(marks::stop_of_reading),
        half(marks::radius_by_name),
        half(marks::value_assigned),
        half(marks::sinumerik_mode),
    ],
    under: |own| own.turns() || matches!(own, Own::Klartext | Own::Plain),
    ..BASE
};
/// No other control that calls its programs `.nc` has both; in files for printers they stand beside each other.
static SINUMERIK_NC: Kind = Kind {
    marks: &[
        half(marks::semicolon_comment),
        half(marks::value_assigned),
        half(marks::sinumerik_mode),
        half(marks::radius_by_name),
    ],
    under: Own::turns,
    ..SINUMERIK
};

static LINUXCNC_DIALECT: Dialect = stands_for("LinuxCNC with O words");
static LINUXCNC: Kind = Kind {
    dialect: &LINUXCNC_DIALECT,
    is: "a program for LinuxCNC with subprograms or named variables",
    way_on: WayOn::Said(
        "partc reads the plain G-code of LinuxCNC without O words and variables: resolve them first. For a program without them, say \
         `--dialect gcode`, or call it `.ngc`",
    ),
    marks: &[proof(marks::o_word)],
    under: but_plain,
    ..BASE
};

static PLAIN_DIALECT: Dialect = stands_for("plain G-code");
/// What no control of HEIDENHAIN for lathes takes in a file that is called as its programs are.
static MILL: Kind = Kind {
    dialect: &PLAIN_DIALECT,
    is: "G-code for a mill, not a program of a HEIDENHAIN turning control",
    way_on: PLAIN_WAY_ON,
    marks: &[
        alone(marks::safety_block),
        alone(marks::tool_change),
        alone(marks::tool_length),
        alone(marks::mode_of_mill),
        alone(marks::unit_alone),
        alone(marks::third_axis),
        alone(marks::change),
        half(marks::round_comment),
        half(marks::unit),
    ],
    under: Own::turns,
    ..BASE
};

/// Two codes that neither SINUMERIK nor Klartext has.
static G_CODE: Kind = Kind {
    dialect: &PLAIN_DIALECT,
    is: "G-code of another control (ISO code)",
    way_on: RENAMED_WAY_ON,
    marks: &[
        proof(marks::set_any_variable),
        alone(marks::unit_alone),
        half(marks::unit),
        half(marks::any_length),
        half(marks::any_cycle),
        half(marks::return_plane),
        half(marks::reference_point),
        half(marks::macro_call),
        half(marks::jump_to_number),
        half(marks::tape_start),
    ],
    under: no_iso,
    ..BASE
};

/// Blocks of G-code in a file that is called as Klartext is, and holds none.
static G_BLOCKS: Kind = Kind { marks: &[alone(marks::g_block)], under: |own| own == Own::Klartext, ..G_CODE };

const RENAMED_WAY_ON: WayOn = WayOn::Tried {
    taken: "partc reads plain G-code as LinuxCNC does (G4 P counts seconds, `X100` is 100 mm): say `--dialect gcode`, or call the file \
            `.ngc`",
    refused: NOT_ALL,
};

const NOT_ALL: &str = "partc does not read all of this language yet: have the program made for a control that it reads";

const PLAIN_WAY_ON: WayOn = WayOn::Tried {
    taken: "partc reads plain G-code as LinuxCNC does (G4 P counts seconds, `X100` is 100 mm): `--dialect gcode`, or for all such files \
            `[dialects]` with `\"{pattern}\" = \"gcode\"` in partc.toml",
    refused: NOT_ALL,
};

/// A file `.nc` in which no word shows the control; [`super::look`] asks for it last.
pub(super) static UNDECIDED: Kind = Kind {
    dialect: &UNDECIDED_DIALECT,
    is: "G-code that fits several controls, and no word shows which",
    way_on: WayOn::Tried {
        taken: "say which it is: `--dialect gcode`, as LinuxCNC reads it (X is a radius without G7), or `--dialect heidenhain-turning`; or for \
                all such files `[dialects]` with `\"{pattern}\" = \"gcode\"` in partc.toml",
        refused: "for a HEIDENHAIN turning control say `--dialect heidenhain-turning`, or for all such files `[dialects]` with \
                  `\"{pattern}\" = \"heidenhain-turning\"` in partc.toml",
    },
    marks: &[alone(marks::any_word)],
    under: |own| own == Own::Nc,
    ..BASE
};
static UNDECIDED_DIALECT: Dialect = stands_for("G-code of several controls");

static PRINTER_DIALECT: Dialect = stands_for("3-D printer");
static PRINTER: Kind = Kind {
    dialect: &PRINTER_DIALECT,
    is: "a file for a 3-D printer (Marlin and similar firmware)",
    way_on: WayOn::Said(
        "partc reads programs of machine tools: there is nothing to compile here. Leave such files out with a line in `.partcignore`",
    ),
    marks: &[alone(marks::slicer), half(marks::heater), half(marks::filament), half(marks::bed_probing)],
    under: |own| own != Own::Mtc200,
    ..BASE
};

const NOT_READ: WayOn =
    WayOn::Said("partc does not read the language of this control. Have the program made for a control that it reads");

static OKUMA_DIALECT: Dialect = stands_for("Okuma OSP");
static OKUMA: Kind = Kind {
    dialect: &OKUMA_DIALECT,
    is: "a program for an Okuma OSP control",
    way_on: NOT_READ,
    marks: &[
        proof(marks::okuma_name),
        proof(marks::okuma_offset_alone),
        proof(marks::okuma_cycle),
        half(marks::okuma_word),
        half(marks::okuma_call),
        half(marks::okuma_offset),
        half(marks::okuma_variable),
    ],
    under: but_plain,
    ..BASE
};

static DIN_ISO_DIALECT: Dialect = stands_for("HEIDENHAIN DIN/ISO");
static DIN_ISO: Kind = Kind {
    dialect: &DIN_ISO_DIALECT,
    is: "a HEIDENHAIN program in DIN/ISO (G-code)",
    way_on: WayOn::Said(
        "partc reads Klartext. Have the program made as Klartext (`.H`): the control or the CAM system can do it",
    ),
    marks: &[alone(marks::din_iso_head)],
    sure: true,
    under: but_plain,
    ..BASE
};

static OLD_SINUMERIK_DIALECT: Dialect = stands_for("SINUMERIK 810, 850 or 880");
static OLD_SINUMERIK: Kind = Kind {
    dialect: &OLD_SINUMERIK_DIALECT,
    is: "a program for an older SINUMERIK (810, 850, 880)",
    way_on: WayOn::Said(
        "partc reads the language of the SINUMERIK 840D and later controls: `@` commands and cycles by L and R numbers have to be \
         rewritten",
    ),
    marks: &[half(marks::old_head), half(marks::old_command)],
    sure: true,
    under: but_plain,
    ..BASE
};

static PHILIPS_DIALECT: Dialect = stands_for("Philips or MillPlus");
static PHILIPS: Kind = Kind {
    dialect: &PHILIPS_DIALECT,
    is: "a program for a Philips or MillPlus control",
    way_on: NOT_READ,
    marks: &[alone(marks::philips_head)],
    sure: true,
    under: but_plain,
    ..BASE
};

static C_DIALECT: Dialect = stands_for("C or C++");
static C: Kind = Kind {
    dialect: &C_DIALECT,
    is: "C or C++ source text",
    way_on: WayOn::Said(
        "no part program: leave such files out with a line in `.partcignore`, such as `*.h` in their folder",
    ),
    marks: &[
        alone(source::preprocessor),
        alone(source::type_declaration),
        alone(source::prototype),
        half(source::line_comment),
        half(source::comment_begins),
        half(source::comment_ends),
    ],
    sure: true,
    under: but_plain,
    ..BASE
};

static DRAWING_DIALECT: Dialect = stands_for("DXF");
static DRAWING: Kind = Kind {
    dialect: &DRAWING_DIALECT,
    is: "a drawing (DXF)",
    way_on: OF_CAM,
    marks: &[half(source::dxf_group), half(source::dxf_section)],
    sure: true,
    ..BASE
};

static STEP_DIALECT: Dialect = stands_for("STEP");
static STEP: Kind = Kind {
    dialect: &STEP_DIALECT,
    is: "a model of a part (STEP)",
    way_on: OF_CAM,
    marks: &[alone(source::step_head)],
    sure: true,
    ..BASE
};

static STL_DIALECT: Dialect = stands_for("STL");
static STL: Kind = Kind {
    dialect: &STL_DIALECT,
    is: "a model of a part (STL)",
    way_on: OF_CAM,
    marks: &[half(source::stl_head), half(source::stl_facet)],
    sure: true,
    ..BASE
};

pub(super) const OF_CAM: WayOn = WayOn::Said(
    "a CAM system makes programs of it: there is nothing to compile here. Leave such files out with a line in `.partcignore`",
);
