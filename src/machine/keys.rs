//! Every key of a `partc.toml`: its kind, its default, its meaning.

use crate::target;

use super::tree::Node;

/// What may stand behind a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Text,
    Flag,
    Number,
    Whole,
    Choice(&'static [&'static str]),
    /// List of whole numbers.
    Wholes,
    /// List of texts.
    Texts,
    /// Table whose keys are names.
    Free,
    /// List of names, or table of names and what is printed for them.
    Words,
}

/// One key of the configuration.
#[derive(Debug)]
pub struct Key {
    pub name: &'static str,
    pub kind: Kind,
    pub doc: &'static str,
    /// TOML text of the value that holds without the key; empty where none does.
    pub default: &'static str,
    /// Without the key its default is a reading that warns; setting the key confirms it.
    pub warns: bool,
}

impl Key {
    /// The same key with the value that holds without it.
    const fn or(self, default: &'static str) -> Key {
        Key { default, ..self }
    }

    /// The same key with the reading that is taken, with a warning, without it.
    const fn or_warn(self, reading: &'static str) -> Key {
        Key { default: reading, warns: true, ..self }
    }

    /// The default as a node of the tree.
    pub fn default_node(&self) -> Option<Node> {
        let tree = super::tree::parse(&format!("x = {}", self.default), "default").ok()?;
        tree.into_values().next()
    }
}

/// One table of the configuration. A section without keys takes any name.
#[derive(Debug)]
pub struct Section {
    pub name: &'static str,
    pub keys: &'static [Key],
    /// Keys of the tables in this section, where its own keys are names.
    pub entry: &'static [Key],
    pub doc: &'static str,
}

const fn key(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    Key { name, kind, doc, default: "", warns: false }
}

const GENERATIONS: &[&str] = &["tnc426", "itnc530", "tnc640", "tnc7"];
const SINUMERIKS: &[&str] = &["802d", "810d", "828d", "840dsl", "one"];
const TURNINGS: &[&str] = &["manualplus4110", "cncpilot4290", "manualplus620"];

pub(super) const TOOL_KEYS: &[Key] = &[
    key("number", Kind::Whole, "tool number to print; needed for a tool known by name or index only"),
    key("name", Kind::Text, "name by which programs call the tool"),
    key(
        "kind",
        Kind::Choice(&["mill", "drill", "tap", "turn", "thread", "recess-radial", "recess-axial"]),
        "kind of tool",
    ),
    key("radius", Kind::Number, "cutter radius in mm; nose radius of turning and recessing tools"),
    key("length", Kind::Number, "length in mm"),
    key("corner_radius", Kind::Number, "corner radius in mm"),
    key("tip_angle", Kind::Number, "angle at the tip of a drill or centre drill in degrees"),
    key("orientation", Kind::Whole, "cutting-edge position 1 to 9 (lathe)"),
    key("width", Kind::Number, "cutting width of recessing tools in mm"),
    key(
        "reference",
        Kind::Choice(&["minus", "plus", "middle"]),
        "programmed corner of a recessing tool: the one towards -Z (axial tools: -X), the other one, or the middle",
    ),
];

pub(super) const PROGRAM_KEYS: &[Key] = &[
    key("tool", Kind::Whole, "argument that names the tool, from 1: the call changes to it"),
    key("ignore", Kind::Flag, "the call is left out, with a note"),
    key("file", Kind::Text, "program that runs instead, beside the program or in an include root"),
];

/// All of `partc.toml`.
pub const SECTIONS: &[Section] = &[
    Section {
        name: "machine",
        doc: "the machine the program was written for",
        entry: &[],
        keys: &[
            key("kind", Kind::Choice(&["mill", "lathe"]), "lathe: turning technology on, power-on plane G18")
                .or(r#""mill""#),
            key(
                "geometry_axes",
                Kind::Texts,
                "names of the first, second and third geometry axis (MD 20050, MD 20080)",
            )
            .or(r#"["X", "Y", "Z"]"#),
            key(
                "axes",
                Kind::Free,
                "SINUMERIK: names of channel axes (MD 20080) and the axis that is printed, or \"leave-out\": B1 = \"B\"",
            ),
            key("diameter_axis", Kind::Text, "axis programmed in diameters (MD 20100); empty for none").or(r#""""#),
            key("md20100", Kind::Text, "same as diameter_axis"),
            key("power_on_diameter", Kind::Flag, "diameter programming is on at the start (lathe)").or("true"),
            key("limits", Kind::Free, "smallest and largest printed coordinate of an axis: X = [-10.0, 800.0]"),
            key("kinematics", Kind::Choice(&["3axis"]), "kinematics of the machine").or(r#""3axis""#),
            key("reference_point", Kind::Free, "machine coordinates of the reference point (G74): X = 0.0"),
            key("swivel_retract", Kind::Free, "machine coordinates that CYCLE800 retracts to: Z = 0.0"),
            key("fixed_point", Kind::Free, "machine coordinates of the fixed point (G75): Z = 0.0"),
            key("fixed_point_2", Kind::Free, "the same of the second fixed point (G75 FP=2)"),
            key("fixed_point_3", Kind::Free, "the same of the third fixed point (G75 FP=3)"),
            key("fixed_point_4", Kind::Free, "the same of the fourth fixed point (G75 FP=4)"),
            key("modulo", Kind::Texts, "SINUMERIK: rotary axes that count modulo 360 degrees").or("[]"),
        ],
    },
    Section {
        name: "control",
        doc: "the control the program was written for",
        entry: &[],
        keys: &[
            key("klartext", Kind::Choice(GENERATIONS), "HEIDENHAIN milling control").or(r#""itnc530""#),
            key("sinumerik", Kind::Choice(SINUMERIKS), "SINUMERIK control"),
            key("heidenhain_turning", Kind::Choice(TURNINGS), "HEIDENHAIN turning control"),
            key("skip_blocks", Kind::Wholes, "skip levels that are switched on; a block with such a / is left out")
                .or("[]"),
            key(
                "unit",
                Kind::Choice(&["mm", "inch"]),
                "unit of a Klartext file without BEGIN PGM; base unit of an MTC200",
            ),
            key("feed", Kind::Number, "feed in mm/min at the start, and for F AUTO without a TOOL CALL"),
            key("rapid_feed", Kind::Number, "feed in mm/min of arcs programmed at rapid traverse"),
            key("cc_missing", Kind::Choice(&["position", "previous"]), "missing coordinate of a CC block")
                .or(r#""position""#),
            key(
                "polar_missing",
                Kind::Choice(&["same-pole", "position", "programmed"]),
                "missing PR or PA after a block that is not polar; same-pole: from the position, but no PA about a new pole",
            )
            .or(r#""same-pole""#),
            key("pattern_feed", Kind::Choice(&["last", "rapid"]), "CYCL CALL PAT and CYCL CALL POS without F")
                .or(r#""last""#),
            key("mirror", Kind::Choice(&["first", "last"]), "Klartext: mirror before or after the rotation of cycle 10")
                .or(r#""first""#),
            key(
                "scaling_center",
                Kind::Choice(&["datum", "kept"]),
                "centre of a cycle 26 that names none where one before did",
            )
            .or(r#""datum""#),
            key(
                "shift_axes",
                Kind::Choice(&["original", "transformed"]),
                "axes of a datum shift under rotation, mirror or scaling",
            )
            .or(r#""original""#),
            key("cp_sign", Kind::Choice(&["refuse", "dr"]), "CP block whose IPA and DR disagree").or(r#""refuse""#),
            key(
                "modulo",
                Kind::Choice(&["refuse", "truncate", "floor"]),
                "% with a negative operand: refused, sign of the left or of the right operand",
            )
            .or(r#""refuse""#),
            key(
                "repeat_count",
                Kind::Choice(&["refuse", "truncate", "round"]),
                "number of repeats (CALL LBL REP) with decimals",
            )
            .or(r#""refuse""#),
            key(
                "open_subprogram",
                Kind::Choice(&["refuse", "end"]),
                "END PGM inside a called label without LBL 0: refused, or the end of the program file",
            )
            .or(r#""refuse""#),
            key("probing", Kind::Choice(&["refuse", "leave-out"]), "touch probe cycles").or(r#""refuse""#),
            key("cycle_19", Kind::Choice(&["space", "axes"]), "angles of cycle 19: space angles, or rotary axes")
                .or(r#""space""#),
            key("scaling", Kind::Choice(&["all", "plane"]), "axes that cycle 11 scales (MP 7410)").or(r#""all""#),
            key(
                "turning_arc_q",
                Kind::Choice(&["near", "far"]),
                "solution that Q0 of an arc names in turning programs",
            )
            .or_warn(r#""near""#),
            key(
                "recess_depth",
                Kind::Choice(&["diameter", "radius"]),
                "what an incremental I of a recess (G22) counts",
            )
            .or_warn(r#""diameter""#),
            key(
                "clearance",
                Kind::Number,
                "clearance of turning cycles in mm where the program sets none; 1 mm if not given",
            ),
            key(
                "recess_side",
                Kind::Choice(&["plus", "minus"]),
                "side of its corner, along Z, on which a wide recess of G86 lies; refused if not given",
            ),
            key("infeed", Kind::Choice(&["radius", "diameter"]), "what the infeed I of G81 in turning programs counts")
                .or_warn(r#""radius""#),
            key(
                "thread_left",
                Kind::Choice(&["minus", "plus"]),
                "turning programs: end of the Z axis that is left for the flank offset H of a thread",
            )
            .or_warn(r#""minus""#),
            key(
                "recess_width",
                Kind::Choice(&["opening", "floor"]),
                "where K of a recess with leaning flanks (G23) is measured",
            )
            .or_warn(r#""opening""#),
            key("recess_blank", Kind::Choice(&["diameter", "radius"]), "what RI of G869 (blank oversize in X) counts")
                .or_warn(r#""diameter""#),
            key(
                "simple_thread",
                Kind::Choice(&["documented", "refuse"]),
                "G32 of turning programs: its words as in docs/turning.md, or refused",
            )
            .or_warn(r#""documented""#),
            key(
                "contour_words",
                Kind::Choice(&["documented", "refuse"]),
                "contour in the words of G80: as in docs/turning.md, or refused",
            )
            .or_warn(r#""documented""#),
            key(
                "line_angle",
                Kind::Choice(&["minus-z", "plus-z"]),
                "turning programs: direction from which the angle A or AN of a line counts",
            )
            .or_warn(r#""minus-z""#),
            key(
                "undercut_limit",
                Kind::Choice(&["lower", "upper"]),
                "row of the table of G85 for a diameter of exactly 18 or 80 mm",
            )
            .or_warn(r#""lower""#),
            key(
                "thread_face",
                Kind::Choice(&["front", "rear"]),
                "face that a transverse thread of G31 is cut in; if not given, the edge position of the tool tells",
            ),
            key(
                "turning_depth",
                Kind::Choice(&["away", "towards"]),
                "turning depth compensation R or RB of G869: away from the floor, or towards it",
            )
            .or_warn(r#""away""#),
            key(
                "offset_one_way",
                Kind::Choice(&["none", "end"]),
                "offset width B of G869 with U1: no effect, or each pass from the second on ends earlier",
            )
            .or_warn(r#""none""#),
            key(
                "recess_oversize",
                Kind::Choice(&["all", "floor"]),
                "oversize of G86: left on the floor and the walls, or on the floor alone",
            )
            .or_warn(r#""all""#),
            key(
                "arc_tolerance",
                Kind::Number,
                "turning programs: how far the radii at both ends of an arc may differ, in mm; 0.02 if not given",
            )
            ,
            key("tool_change_point", Kind::Free, "machine coordinates of G14: X (diameter) and Z"),
            key("retract_max", Kind::Number, "machine coordinate of the tool axis for M140 MB MAX, in mm"),
            key("sd42440", Kind::Flag, "an increment behind a change of the frame travels the change, too"),
            key("md21000", Kind::Number, "largest difference of the radii of a circle, in mm").or("0.01"),
            key("md21010", Kind::Number, "largest difference of the radii of a circle, as a part of the radius")
                .or("0.001"),
            key(
                "large_corners",
                Kind::Choice(&["refuse", "shorten"]),
                "SINUMERIK: a chamfer or rounding that does not fit; shorten: as large as it fits, in the order of the path",
            )
            .or(r#""refuse""#),
            key("md20150", Kind::Choice(&["g94", "g95"]), "SINUMERIK: kind of feed at the start of a program; default: g94"),
            key(
                "md10760",
                Kind::Flag,
                "SINUMERIK: G53, G153 and SUPA suppress the tool length, too, so that they place the spindle, not the tip",
            )
            .or("false"),
            key(
                "md30455",
                Kind::Choice(&["absolute", "shortest"]),
                "SINUMERIK: way of a modulo axis to an absolute position: inside its turn, or the shortest",
            )
            .or(r#""absolute""#),
            key(
                "arc_chamfers",
                Kind::Choice(&["refuse", "bisector"]),
                "SINUMERIK: a chamfer beside an arc; bisector: across the bisector of the corner, its ends on both elements",
            )
            .or(r#""refuse""#),
            key(
                "g40_without_motion",
                Kind::Choice(&["warn", "error"]),
                "SINUMERIK: G40 in front of a move that leaves the plane alone: its offset waits for the next one in the plane, or alarm 10754",
            )
            .or(r#""warn""#),
            key("md10617", Kind::Whole, "SINUMERIK: what SAVE brings back; bit 0: the frame of the work offset"),
            key(
                "cycle86_lift",
                Kind::Choice(&["lift", "none"]),
                "SINUMERIK: what CYCLE86 does under `_GMODE` 1 and 2: lift off at the bottom, or straight out; refused if not given",
            ),
            key(
                "thread_flank",
                Kind::Choice(&["crest", "root"]),
                "SINUMERIK: what stands at the programmed start of a thread with a flank infeed; default: crest",
            ),
            key("md11120", Kind::Flag, "variables of the main program are seen in subprograms").or("false"),
            key(
                "machine_words",
                Kind::Words,
                "MTC200: words of the machine builder that do not move the tool: a list, or a table LA_ON = \"M101\"",
            )
            .or(r#"[]"#),
            key(
                "centres",
                Kind::Choice(&["settle", "absolute", "relative", "dimension"]),
                "MTC200: what I, J, K count from; settle: what fits the arcs of the program",
            )
            .or(r#""settle""#),
            key("circle_tolerance", Kind::Number, "MTC200: how far the end of an arc may miss the circle, in mm")
                .or(r#"0.01"#),
            key("start", Kind::Free, "MTC200: older name of [start], X as a radius"),
            key("home", Kind::Free, "MTC200: machine coordinates of the home position that G74 goes to, in mm"),
            key("repeated_words", Kind::Choice(&["refuse", "last"]), "MTC200: which of two equal words counts")
                .or(r#""refuse""#),
            key("zero_feed", Kind::Choice(&["refuse", "previous"]), "MTC200: what F0 means").or(r#""refuse""#),
            key("g52", Kind::Choice(&["refuse", "position", "shift"]), "MTC200: what G52 does").or(r#""refuse""#),
            key("g53", Kind::Choice(&["refuse", "machine"]), "MTC200: what positions under G53 are").or(r#""refuse""#),
            key(
                "g91_after_offset",
                Kind::Choice(&["refuse", "with-offset", "increment"]),
                "MTC200: what an increment behind a changed zero offset travels: the change as well, or itself alone",
            )
            .or(r#""refuse""#),
            key(
                "spindle_nose",
                Kind::Choice(&["warn", "refuse"]),
                "MTC200: moves along the tool axis under G47, or before the first G48",
            )
            .or(r#""warn""#),
            key(
                "cf_at_arcs",
                Kind::Choice(&["refuse", "along"]),
                "MTC200: CF beside an arc; along: its width is measured along the arc",
            )
            .or(r#""refuse""#),
            key(
                "confirmed",
                Kind::Texts,
                "MTC200: readings that no manual at hand confirms and that this control has: [\"flow\", \"degrees\"]",
            )
            .or("[]"),
            key("dwell", Kind::Choice(&["s", "ms"]), "MTC200: unit of the F of G04").or_warn(r#""s""#),
            key(
                "tool_change",
                Kind::Choice(&["m6", "t"]),
                "word that changes the tool; default: t on a SINUMERIK lathe, TOOL CALL (t) of a Klartext program without M6, else m6",
            ),
            key("angles", Kind::Choice(&["degrees", "radians"]), "MTC200: unit of angles in formulas")
                .or_warn(r#""degrees""#),
            key(
                "rotary",
                Kind::Choice(&["shortest", "absolute"]),
                "MTC200: way of a rotary axis to an absolute position",
            )
            .or(r#""shortest""#),
            key(
                "inch_speed",
                Kind::Choice(&["refuse", "metres", "feet"]),
                "MTC200: unit of the cutting speed under G70, per minute",
            )
            .or(r#""refuse""#),
        ],
    },
    Section {
        name: "tools",
        doc: "tool data: a table file, or one table per tool number or quoted name",
        entry: TOOL_KEYS,
        keys: &[key("table", Kind::Text, "TOOL.T (HEIDENHAIN) or tool.tbl (LinuxCNC)")],
    },
    Section {
        name: "datums",
        doc: "work offsets (G54 = { X = 0.0 }), preset.N = \"G55\"; SINUMERIK: basic = { X = 0.0 }, the basic frame",
        entry: &[],
        keys: &[],
    },
    Section {
        name: "include",
        doc: "where called programs may come from",
        entry: &[],
        keys: &[key("roots", Kind::Free, "path prefix of the control and folder of this computer")],
    },
    Section {
        name: "programs",
        doc: "SINUMERIK: programs of the machine builder that are called and found nowhere: TC = { tool = 1 }",
        entry: PROGRAM_KEYS,
        keys: &[],
    },
    Section {
        name: "undercut",
        doc: "sizes of undercuts that differ from DIN 509 and DIN 76",
        entry: &[],
        keys: &[
            key("din509", Kind::Free, "size of forms E and F: \"0.6x0.3\" = { f = 2.5, t2 = 0.2 }"),
            key(
                "din76",
                Kind::Free,
                "thread undercut of a pitch: \"1.5\" = { external = 2.3, a = [3.2, 5.2], r = 0.8 }",
            ),
            key("din509_by_diameter", Kind::Free, "size up to a diameter: \"80\" = \"0.6x0.3\", above = \"1.0x0.4\""),
            key("din509_in_editor", Kind::Texts, "SINUMERIK: sizes by their index in the contour editor: [\"0.1x0.1\", …]"),
            key("din509_in_cycle", Kind::Texts, "SINUMERIK: sizes by `_PITI` of CYCLE940: [\"0.6x0.3\", …]"),
            key(
                "thread_length",
                Kind::Choice(&["middle", "shortest", "longest"]),
                "length of a thread undercut between g1 and g2",
            )
            .or(r#""middle""#),
            key(
                "internal_depth",
                Kind::Choice(&["core", "bore"]),
                "what the contour is at an internal thread undercut",
            )
            .or(r#""core""#),
        ],
    },
    Section {
        name: "start",
        doc: "where the axes stand before the first block, in mm and degrees: X = 0.0 (lathe: diameter); only axes a program relies on",
        entry: &[],
        keys: &[],
    },
    Section { name: "variables", doc: "start values of parameters: Q50 = 3.0, R1 = 5.0", entry: &[], keys: &[] },
    Section {
        name: "output",
        doc: "what is printed",
        entry: &[],
        keys: &[
            key("target", Kind::Choice(&target::NAMES), "control that runs the output").or(r#""linuxcnc""#),
            key("decimals", Kind::Whole, "decimal places of lengths, 3 to 6").or("4"),
            key("compensation", Kind::Choice(&["resolve", "control"]), "tool-centre path, or contour with G41/G42")
                .or(r#""resolve""#),
            key("diameter", Kind::Flag, "print diameters (lathe)").or("false"),
            key("comments", Kind::Flag, "keep comments of the source").or("true"),
            key("pass_m", Kind::Wholes, "M functions that are printed as they stand").or("[]"),
            key("tool_length", Kind::Choice(&["off", "G43"]), "G43 H behind a tool change").or(r#""off""#),
        ],
    },
    Section {
        name: "limits",
        doc: "limits of a run",
        entry: &[],
        keys: &[
            key("steps", Kind::Whole, "blocks that may be executed").or("10_000_000"),
            key("output_blocks", Kind::Whole, "lines that may be printed").or("50_000_000"),
            key("call_depth", Kind::Whole, "nesting of calls").or("64"),
        ],
    },
];
