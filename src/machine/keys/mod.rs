//! Every key of a `partc.toml`, one file an owner. A new key is a row here and a field of the settings.

mod control;
mod cycles;
mod key;
mod klartext;
mod klartext_cycles;
mod lint;
mod machine;
mod mtc200;
pub(super) mod output;
mod sinumerik;
mod turning;
mod undercut;

use crate::diag::Answer;

use super::unit::Unit;
use super::values::{is, put};
use key::part;
pub use key::{Key, Kind};

/// One table of the configuration. A section without keys takes any name.
#[derive(Debug)]
pub struct Section {
    pub name: &'static str,
    /// Its keys, by owner.
    pub keys: &'static [&'static [Key]],
    /// Keys of the tables in this section, where its own keys are names.
    pub entry: &'static [Key],
    pub doc: &'static str,
}

impl Section {
    /// All of its keys.
    pub fn keys(&self) -> impl Iterator<Item = &'static Key> {
        self.keys.iter().copied().flatten()
    }
}

/// The values that a key of `partc.toml` may take, as TOML, where it has a list of them: none of these refuses.
pub fn choices(answer: &Answer) -> Vec<String> {
    let [name] = &answer.path[..] else { return Vec::new() };
    let section = SECTIONS.iter().find(|section| section.name == answer.section);
    match section.and_then(|section| section.keys().find(|key| key.name == name)).map(|key| key.kind) {
        Some(Kind::Choice(list)) => {
            list.iter().filter(|value| **value != "refuse").map(|value| format!("\"{value}\"")).collect()
        }
        Some(Kind::Flag) => vec!["true".to_owned(), "false".to_owned()],
        _ => Vec::new(),
    }
}

pub(super) const TOOL_KEYS: &[Key] = &[
    part("number", Kind::Whole, "tool number to print; needed for a tool known by name or index only"),
    part("name", Kind::Text, "name by which programs call the tool"),
    part(
        "kind",
        Kind::Choice(&["mill", "drill", "tap", "turn", "thread", "recess-radial", "recess-axial"]),
        "kind of tool",
    ),
    part("radius", Kind::Number, "cutter radius in mm; nose radius of turning and recessing tools"),
    part("length", Kind::Number, "length in mm"),
    part("corner_radius", Kind::Number, "corner radius in mm"),
    part("tip_angle", Kind::Number, "angle at the tip of a drill or centre drill in degrees"),
    part(
        "plunge_angle",
        Kind::Number,
        "greatest angle in degrees at which a cutter goes down into material (ANGLE of the tool table); 0 straight down only",
    ),
    part(
        "teeth",
        Kind::Whole,
        "cutting edges that follow each other in a turn (CUT of the tool table): what FZ counts",
    ),
    part("orientation", Kind::Whole, "cutting-edge position 1 to 9 (lathe)"),
    part(
        "clearance",
        Kind::Number,
        "angle of the flank of a turning tool in degrees: it cuts no relief that falls steeper",
    ),
    part("width", Kind::Number, "cutting width of recessing tools in mm"),
    part(
        "reference",
        Kind::Choice(&["minus", "plus", "middle"]),
        "programmed corner of a recessing tool: the one towards -Z (axial tools: -X), the other one, or the middle",
    ),
];

const TOOL_FILE_KEYS: &[Key] = &[
    part("table", Kind::Text, "TOOL.T (HEIDENHAIN), tool.tbl (LinuxCNC), tool data of a SINUMERIK (.INI, .TOA) or CSV"),
    Key {
        set: |s, v| put(&mut s.tools.stated, Some(if is(v, "inch") { Unit::Inch } else { Unit::Mm })),
        ..part(
            "unit",
            Kind::Choice(&["mm", "inch"]),
            "unit of the table, where it states none, or where its unit is not that of the program",
        )
    },
];

pub(super) const PROGRAM_KEYS: &[Key] = &[
    part("tool", Kind::Whole, "argument that names the tool, from 1: the call changes to it"),
    part("change", Kind::Flag, "the call changes to the tool that T has chosen, as M6 does"),
    part("d", Kind::Whole, "argument that is the D number, from 1; D1 if not given"),
    part("ignore", Kind::Flag, "the call is left out, with a note"),
    part("motion", Kind::Choice(&["G0", "G1"]), "what the call leaves active: G0 or G1"),
    part("lost", Kind::Texts, "axes that the call leaves at a place that nothing says"),
    part(
        "feed",
        Kind::NumberOr("lost"),
        "F that the call leaves, as the program would write it; \"lost\": none that is known",
    ),
    part(
        "speed",
        Kind::NumberOr("lost"),
        "S that the call leaves, as the program would write it; \"lost\": none that is known",
    ),
    part(
        "spindle",
        Kind::Choice(&["M3", "M4", "M5"]),
        "what the call leaves the spindle doing: it is printed at the call",
    ),
    part("file", Kind::Text, "program that runs instead, beside the program or in an include root"),
];

/// All of `partc.toml`.
pub const SECTIONS: &[Section] = &[
    Section { name: "machine", doc: "the machine the program was written for", entry: &[], keys: &[machine::KEYS] },
    Section {
        name: "control",
        doc: "the control the program was written for",
        entry: &[],
        keys: &[control::KEYS, klartext::KEYS, turning::KEYS, sinumerik::KEYS, mtc200::KEYS],
    },
    Section {
        name: "tools",
        doc: "tool data: a table file, or one table per tool number or quoted name",
        entry: TOOL_KEYS,
        keys: &[TOOL_FILE_KEYS],
    },
    Section {
        name: "datums",
        doc: "work offsets (G54 = { X = 0.0 }), preset.N = \"G55\"; SINUMERIK: basic = { X = 0.0 }, the basic frame",
        entry: &[],
        keys: &[],
    },
    Section {
        name: "dialects",
        doc: "language of files by their path: \"lathe/**\" = \"heidenhain-turning\"; without a pattern content and extension tell",
        entry: &[],
        keys: &[],
    },
    Section { name: "include", doc: "where called programs may come from", entry: &[], keys: &[output::INCLUDE] },
    Section {
        name: "programs",
        doc: "programs and cycles of the machine builder that are found nowhere: TC = { tool = 1, motion = \"G0\" }; Klartext: \"CYCL DEF 392\" = { ignore = true }",
        entry: PROGRAM_KEYS,
        keys: &[],
    },
    Section {
        name: "undercut",
        doc: "sizes of undercuts that differ from DIN 509 and DIN 76",
        entry: &[],
        keys: &[undercut::KEYS],
    },
    Section {
        name: "cycles",
        doc: "what a control decides inside its machining cycles",
        entry: &[],
        keys: &[cycles::KEYS, klartext_cycles::KEYS],
    },
    Section {
        name: "start",
        doc: "where the axes stand before the first block, in mm and degrees: X = 0.0 (lathe: diameter); only axes a program relies on",
        entry: &[],
        keys: &[],
    },
    Section {
        name: "variables",
        doc: "start values of parameters: Q50 = 3.0, R1 = 5.0; Klartext: system data, \"ID240 NR1 IDX3\" = 100.0",
        entry: &[],
        keys: &[],
    },
    Section { name: "output", doc: "what is printed", entry: &[], keys: &[output::KEYS] },
    Section { name: "lint", doc: "which findings are reported, and how bad they are", entry: &[], keys: &[lint::KEYS] },
    Section { name: "limits", doc: "limits of a run", entry: &[], keys: &[output::LIMITS] },
];
