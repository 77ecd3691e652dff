//! Turns the tree of a `partc.toml` into [`Settings`]. Every key is in [`SECTIONS`]; others are errors.

use std::collections::BTreeMap;

use super::axis::Axis;
use super::mtc200::{Centres, G52, InchSpeed};
use super::settings::*;
use super::tools::{Corner, Tool, ToolKey};
use super::tree::{ConfigError, Node, Table, Value, did_you_mean};

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
}

impl Key {
    /// The same key with the value that holds without it.
    const fn or(self, default: &'static str) -> Key {
        Key { default, ..self }
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
    Key { name, kind, doc, default: "" }
}

const GENERATIONS: &[&str] = &["tnc426", "itnc530", "tnc640", "tnc7"];
const SINUMERIKS: &[&str] = &["802d", "810d", "828d", "840dsl", "one"];
const TURNINGS: &[&str] = &["manualplus4110", "cncpilot4290", "manualplus620"];

const TOOL_KEYS: &[Key] = &[
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
    key("orientation", Kind::Whole, "cutting-edge position 1 to 9 (lathe)"),
    key("width", Kind::Number, "cutting width of recessing tools in mm"),
    key(
        "reference",
        Kind::Choice(&["minus", "plus", "middle"]),
        "programmed corner of a recessing tool: the one towards -Z (axial tools: -X), the other one, or the middle",
    ),
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
            key("diameter_axis", Kind::Text, "axis programmed in diameters (MD 20100); empty for none").or(r#""""#),
            key("md20100", Kind::Text, "same as diameter_axis"),
            key("power_on_diameter", Kind::Flag, "diameter programming is on at the start (lathe)").or("true"),
            key("limits", Kind::Free, "smallest and largest printed coordinate of an axis: X = [-10.0, 800.0]"),
            key("kinematics", Kind::Choice(&["3axis"]), "kinematics of the machine").or(r#""3axis""#),
            key("reference_point", Kind::Free, "machine coordinates of the reference point (G74): X = 0.0"),
            key("fixed_point", Kind::Free, "machine coordinates of the fixed point (G75): Z = 0.0"),
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
                Kind::Choice(&["position", "programmed"]),
                "missing PR or PA after a block that is not polar",
            )
            .or(r#""position""#),
            key(
                "shift_axes",
                Kind::Choice(&["original", "transformed"]),
                "axes of a datum shift under rotation, mirror or scaling",
            )
            .or(r#""original""#),
            key("cp_sign", Kind::Choice(&["refuse", "dr"]), "CP block whose IPA and DR disagree").or(r#""refuse""#),
            key("scaling", Kind::Choice(&["all", "plane"]), "axes that cycle 11 scales (MP 7410)").or(r#""all""#),
            key(
                "turning_arc_q",
                Kind::Choice(&["near", "far"]),
                "solution that Q0 of an arc names in turning programs",
            )
            .or(r#""near""#),
            key(
                "recess_depth",
                Kind::Choice(&["diameter", "radius"]),
                "what an incremental I of a recess (G22) counts",
            )
            .or(r#""diameter""#),
            key(
                "clearance",
                Kind::Number,
                "clearance of turning cycles in mm where the program sets none; 1 mm if not given",
            ),
            key("tool_change_point", Kind::Free, "machine coordinates of G14: X (diameter) and Z"),
            key("retract_max", Kind::Number, "machine coordinate of the tool axis for M140 MB MAX, in mm"),
            key("sd42440", Kind::Flag, "an increment behind a change of the frame travels the change, too"),
            key("md21000", Kind::Number, "largest difference of the radii of a circle, in mm").or("0.01"),
            key("md21010", Kind::Number, "largest difference of the radii of a circle, as a part of the radius")
                .or("0.001"),
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
            key("start", Kind::Free, "MTC200: where the axes stand at the start, in mm: X = 0.0 (radius)"),
            key("home", Kind::Free, "MTC200: machine coordinates of the home position that G74 goes to, in mm"),
            key("repeated_words", Kind::Choice(&["refuse", "last"]), "MTC200: which of two equal words counts")
                .or(r#""refuse""#),
            key("zero_feed", Kind::Choice(&["refuse", "previous"]), "MTC200: what F0 means").or(r#""refuse""#),
            key("g52", Kind::Choice(&["refuse", "position", "shift"]), "MTC200: what G52 does").or(r#""refuse""#),
            key("g53", Kind::Choice(&["refuse", "machine"]), "MTC200: what positions under G53 are").or(r#""refuse""#),
            key("dwell", Kind::Choice(&["s", "ms"]), "MTC200: unit of the F of G04").or(r#""s""#),
            key(
                "tool_change",
                Kind::Choice(&["m6", "t"]),
                "word that changes the tool; default: t on a SINUMERIK lathe, else m6",
            ),
            key("angles", Kind::Choice(&["degrees", "radians"]), "MTC200: unit of angles in formulas")
                .or(r#""degrees""#),
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
    Section { name: "datums", doc: "work offsets (G54 = { X = 0.0 }) and preset.N = \"G55\"", entry: &[], keys: &[] },
    Section {
        name: "include",
        doc: "where called programs may come from",
        entry: &[],
        keys: &[key("roots", Kind::Free, "path prefix of the control and folder of this computer")],
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
    Section { name: "variables", doc: "start values of parameters: Q50 = 3.0, R1 = 5.0", entry: &[], keys: &[] },
    Section {
        name: "output",
        doc: "what is printed",
        entry: &[],
        keys: &[
            key("target", Kind::Choice(&["linuxcnc"]), "control that runs the output").or(r#""linuxcnc""#),
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

/// Reads the settings from a tree; all errors at once.
///
/// # Errors
/// Unknown keys and values that do not fit.
pub fn read(root: &Table) -> Result<Settings, Vec<ConfigError>> {
    let mut reader = Reader { errors: Vec::new(), settings: Settings::default() };
    for (name, node) in root {
        let Some(section) = SECTIONS.iter().find(|section| section.name == name) else {
            reader.unknown(name, node, SECTIONS.iter().map(|s| s.name).chain(["extend"]));
            continue;
        };
        match &node.value {
            Value::Table(table) => reader.section(section, table),
            _ => reader.errors.push(node.fail(format!("`{name}` is a table: [{name}]"))),
        }
    }
    if reader.errors.is_empty() { Ok(reader.settings) } else { Err(reader.errors) }
}

struct Reader {
    errors: Vec<ConfigError>,
    settings: Settings,
}

impl Reader {
    fn unknown<'a>(&mut self, name: &str, node: &Node, known: impl Iterator<Item = &'a str>) {
        let mut error = node.fail(format!("unknown key `{name}`"));
        error.help = did_you_mean(name, known).map(|like| format!("did you mean `{like}`?"));
        self.errors.push(error);
    }

    fn section(&mut self, section: &Section, table: &Table) {
        for (name, node) in table {
            let free = section.keys.is_empty() || (!section.entry.is_empty() && matches!(node.value, Value::Table(_)));
            let result = match section.keys.iter().find(|key| key.name == name) {
                Some(key) => fits(key, node).and_then(|()| self.set(section.name, name, node)),
                None if free => self.set(section.name, name, node),
                None => {
                    self.unknown(name, node, section.keys.iter().map(|key| key.name));
                    Ok(())
                }
            };
            if let Err(error) = result {
                self.errors.push(error);
            }
        }
    }

    fn set(&mut self, section: &str, name: &str, node: &Node) -> Result<(), ConfigError> {
        let s = &mut self.settings;
        match (section, name) {
            ("machine", "kind") => {
                s.machine.kind = if text(node) == "lathe" { MachineKind::Lathe } else { MachineKind::Mill };
            }
            ("machine", "geometry_axes") => s.machine.geometry_axes = geometry_axes(node)?,
            ("machine", "diameter_axis" | "md20100") => {
                s.machine.diameter_axis = if text(node).is_empty() { None } else { Some(axis(text(node), node)?) };
            }
            ("machine", "power_on_diameter") => s.machine.power_on_diameter = flag(node),
            ("machine", "limits") => {
                for (name, node) in table_of(node) {
                    s.machine.limits.insert(axis(name, node)?, range(node)?);
                }
            }
            ("machine", "reference_point" | "fixed_point") => {
                let points =
                    if name == "fixed_point" { &mut s.machine.fixed_point } else { &mut s.machine.reference_point };
                for (name, node) in table_of(node) {
                    points.insert(axis(name, node)?, number(node).ok_or_else(|| node.fail("needs a number"))?);
                }
            }
            ("machine", "kinematics") => s.machine.kinematics = text(node).to_owned(),
            ("control", _) => return self.set_control(name, node),
            ("tools", "table") => {} // read by whoever may open files
            ("tools", _) => {
                let key = tool_key(name, node)?;
                let tool = self.tool(table_of(node), node)?;
                self.settings.tools.table.insert(key, tool);
            }
            ("datums", "preset") => {
                for (number, node) in table_of(node) {
                    let n = number.parse().map_err(|_| node.fail("a preset is a number"))?;
                    let offset = work_offset(text(node)).ok_or_else(|| {
                        node.fail("a preset becomes one of G54, G55, G56, G57, G58, G59, G59.1, G59.2, G59.3")
                    })?;
                    s.datums.presets.insert(n, offset);
                }
            }
            ("datums", _) if matches!(node.value, Value::Text(_)) => {
                let offset = work_offset(text(node)).ok_or_else(|| {
                    node.fail("an offset becomes one of G54, G55, G56, G57, G58, G59, G59.1, G59.2, G59.3")
                })?;
                s.datums.words.insert(name.to_ascii_uppercase(), offset);
            }
            ("datums", _) => {
                let mut values = std::collections::BTreeMap::new();
                for (name, node) in table_of(node) {
                    values.insert(axis(name, node)?, number(node).ok_or_else(|| node.fail("needs a number"))?);
                }
                s.datums.offsets.insert(name.to_ascii_uppercase(), values);
            }
            ("include", _) => {
                for (prefix, node) in table_of(node) {
                    let Value::Text(folder) = &node.value else { return Err(node.fail("a root is a folder")) };
                    s.include.roots.insert(prefix.clone(), folder.into());
                }
            }
            ("undercut", _) => s.undercut.set(name, node)?,
            ("variables", _) => {
                let value = number(node).ok_or_else(|| node.fail("a start value is a number"))?;
                s.variables.insert(name.to_ascii_uppercase(), value);
            }
            ("output", _) => return self.set_output(name, node),
            ("limits", _) => {
                let value = whole(node);
                if value < 1 {
                    return Err(node.fail("must be at least 1"));
                }
                match name {
                    "steps" => s.limits.steps = value as u64,
                    "output_blocks" => s.limits.output_blocks = value as u64,
                    _ => s.limits.call_depth = (value as usize).min(1000),
                }
            }
            _ => return Err(node.fail(format!("`{name}` has no place in [{section}]"))),
        }
        Ok(())
    }

    fn set_control(&mut self, name: &str, node: &Node) -> Result<(), ConfigError> {
        let control = &mut self.settings.control;
        match name {
            "klartext" => {
                control.klartext = match text(node) {
                    "tnc426" => Generation::Tnc426,
                    "tnc640" => Generation::Tnc640,
                    "tnc7" => Generation::Tnc7,
                    _ => Generation::Itnc530,
                }
            }
            "sinumerik" => control.sinumerik = text(node).to_owned(),
            "heidenhain_turning" => control.heidenhain_turning = text(node).to_owned(),
            "skip_blocks" => {
                control.skip_blocks = wholes(node)
                    .map(|n| {
                        u8::try_from(n).ok().filter(|n| *n <= 9).ok_or_else(|| node.fail("skip levels are 0 to 9"))
                    })
                    .collect::<Result<_, _>>()?;
            }
            "unit" => control.unit = Some(if text(node) == "inch" { Unit::Inch } else { Unit::Mm }),
            "feed" | "rapid_feed" => {
                let feed = Some(number(node).filter(|f| *f > 0.0).ok_or_else(|| node.fail("a feed is above 0"))?);
                if name == "feed" {
                    control.feed = feed;
                } else {
                    control.rapid_feed = feed;
                }
            }
            "cc_missing" => {
                control.cc_missing = if text(node) == "previous" { CcMissing::Previous } else { CcMissing::Position };
            }
            "polar_missing" => {
                control.polar_missing =
                    if text(node) == "programmed" { PolarMissing::Programmed } else { PolarMissing::Position };
            }
            "shift_axes" => {
                control.shift_axes =
                    if text(node) == "transformed" { ShiftAxes::Transformed } else { ShiftAxes::Original };
            }
            "cp_sign" => control.cp_sign = if text(node) == "dr" { CpSign::Dr } else { CpSign::Refuse },
            "scaling" => control.scaling_in_plane = text(node) == "plane",
            "turning_arc_q" => {
                let far = text(node) == "far";
                control.turning.arc_choice = if far { ArcChoice::ZeroIsFar } else { ArcChoice::ZeroIsNear };
            }
            "recess_depth" => {
                let radius = text(node) == "radius";
                control.turning.recess_depth = if radius { RecessDepth::Radius } else { RecessDepth::Diameter };
            }
            "clearance" => {
                let clearance =
                    number(node).filter(|mm| *mm > 0.0).ok_or_else(|| node.fail("a clearance is above 0"))?;
                control.turning.clearance = Some(clearance);
            }
            "tool_change_point" => control.turning.change_point = Some(change_point(node)?),
            "retract_max" => control.retract_max = number(node),
            "sd42440" => control.siemens.frame_offset_incremental = Some(flag(node)),
            "md21000" | "md21010" => {
                let value = number(node).filter(|v| *v >= 0.0).ok_or_else(|| node.fail("is not below 0"))?;
                if name == "md21000" {
                    control.siemens.circle_error = value;
                } else {
                    control.siemens.circle_error_factor = value;
                }
            }
            "md11120" => control.siemens.main_variables_visible = flag(node),
            _ => return self.set_mtc200(name, node),
        }
        Ok(())
    }

    fn set_mtc200(&mut self, name: &str, node: &Node) -> Result<(), ConfigError> {
        let control = &mut self.settings.control.mtc200;
        match name {
            "machine_words" => control.machine_words = machine_words(node)?,
            "centres" => {
                control.centres = match text(node) {
                    "absolute" => Centres::Absolute,
                    "relative" => Centres::Relative,
                    "dimension" => Centres::Dimension,
                    _ => Centres::Settle,
                }
            }
            "circle_tolerance" => {
                let tolerance = number(node).filter(|t| (0.0..=1.0).contains(t));
                control.circle_tolerance = tolerance.ok_or_else(|| node.fail("a tolerance is 0 to 1 mm"))?;
            }
            "start" | "home" => {
                let list = if name == "start" { &mut control.start } else { &mut control.home };
                for (name, node) in table_of(node) {
                    let value = number(node).filter(|v| v.is_finite()).ok_or_else(|| node.fail("needs a number"))?;
                    list.insert(axis(name, node)?, value);
                }
            }
            "repeated_words" => control.last_word_counts = text(node) == "last",
            "zero_feed" => control.zero_feed_keeps = text(node) == "previous",
            "g52" => {
                control.g52 = match text(node) {
                    "position" => G52::Position,
                    "shift" => G52::Shift,
                    _ => G52::Refuse,
                }
            }
            "g53" => control.g53_is_machine = text(node) == "machine",
            "dwell" => control.dwell_ms = text(node) == "ms",
            "tool_change" => {
                control.t_changes = text(node) == "t";
                self.settings.control.siemens.tool_change_by_t = Some(text(node) == "t");
            }
            "angles" => control.radians = text(node) == "radians",
            "rotary" => control.rotary_absolute = text(node) == "absolute",
            "inch_speed" => {
                control.inch_speed = match text(node) {
                    "metres" => InchSpeed::Metres,
                    "feet" => InchSpeed::Feet,
                    _ => InchSpeed::Refuse,
                }
            }
            _ => return Err(node.fail(format!("`{name}` has no place in [control]"))),
        }
        Ok(())
    }

    fn set_output(&mut self, name: &str, node: &Node) -> Result<(), ConfigError> {
        let output = &mut self.settings.output;
        match name {
            "target" => output.target = text(node).to_owned(),
            "decimals" => {
                output.decimals = u8::try_from(whole(node))
                    .ok()
                    .filter(|n| (3..=6).contains(n))
                    .ok_or_else(|| node.fail("3 to 6 decimal places"))?;
            }
            "compensation" => {
                output.compensation =
                    if text(node) == "control" { Compensation::Control } else { Compensation::Resolve };
            }
            "diameter" => output.diameter = flag(node),
            "comments" => output.comments = flag(node),
            "pass_m" => {
                output.pass_m = wholes(node)
                    .map(|n| u32::try_from(n).ok().filter(|n| *n < 10_000).ok_or_else(|| node.fail("no M function")))
                    .collect::<Result<_, _>>()?;
            }
            "tool_length" => output.tool_length = text(node) == "G43",
            _ => return Err(node.fail(format!("`{name}` has no place in [output]"))),
        }
        Ok(())
    }

    fn tool(&mut self, table: &Table, at: &Node) -> Result<Tool, ConfigError> {
        let mut tool = Tool::default();
        for (name, node) in table {
            let Some(key) = TOOL_KEYS.iter().find(|key| key.name == name) else {
                self.unknown(name, node, TOOL_KEYS.iter().map(|key| key.name));
                continue;
            };
            fits(key, node)?;
            let small = |most: i64| u8::try_from(whole(node)).ok().filter(|n| (1..=most).contains(&i64::from(*n)));
            match name.as_str() {
                "number" => {
                    tool.number =
                        Some(u32::try_from(whole(node)).map_err(|_| node.fail("a tool number is 0 or more"))?);
                }
                "name" => tool.name = Some(text(node).to_owned()),
                "kind" => tool.kind = Some(text(node).to_owned()),
                "radius" => {
                    tool.radius = number(node);
                    if tool.radius.is_some_and(|r| r < 0.0) {
                        return Err(node.fail("a radius is 0 or more"));
                    }
                }
                "length" => tool.length = number(node),
                "corner_radius" => tool.corner_radius = number(node),
                "orientation" => tool.orientation = Some(small(9).ok_or_else(|| node.fail("1 to 9"))?),
                "reference" => {
                    tool.reference = match text(node) {
                        "plus" => Corner::Plus,
                        "middle" => Corner::Middle,
                        _ => Corner::Minus,
                    }
                }
                _ => tool.width = number(node),
            }
        }
        if table.is_empty() {
            return Err(at.fail("a tool needs at least one value"));
        }
        Ok(tool)
    }
}

fn fits(key: &Key, node: &Node) -> Result<(), ConfigError> {
    let all = |good: fn(&Value) -> bool| match &node.value {
        Value::List(items) => items.iter().all(|item| good(&item.value)),
        _ => false,
    };
    let ok = match key.kind {
        Kind::Text => matches!(node.value, Value::Text(_)),
        Kind::Flag => matches!(node.value, Value::Flag(_)),
        Kind::Number => matches!(node.value, Value::Number(_) | Value::Whole(_)),
        Kind::Whole => matches!(node.value, Value::Whole(_)),
        Kind::Choice(choices) => {
            if let Value::Text(text) = &node.value
                && !choices.contains(&text.as_str())
            {
                let mut error = node.fail(format!("`{}` is none of {}", text, choices.join(", ")));
                error.help = did_you_mean(text, choices.iter().copied()).map(|like| format!("did you mean `{like}`?"));
                return Err(error);
            }
            matches!(node.value, Value::Text(_))
        }
        Kind::Wholes => all(|value| matches!(value, Value::Whole(_))),
        Kind::Texts => all(|value| matches!(value, Value::Text(_))),
        Kind::Free => matches!(node.value, Value::Table(_)),
        Kind::Words => matches!(node.value, Value::Table(_)) || all(|value| matches!(value, Value::Text(_))),
    };
    let wanted = match key.kind {
        Kind::Text | Kind::Choice(_) => "a text in quotes",
        Kind::Flag => "true or false",
        Kind::Number => "a number",
        Kind::Whole => "a whole number",
        Kind::Wholes => "a list of whole numbers",
        Kind::Texts => "a list of texts",
        Kind::Free => "a table",
        Kind::Words => "a list of texts or a table",
    };
    if ok { Ok(()) } else { Err(node.fail(format!("`{}` needs {wanted}: {}", key.name, key.doc))) }
}

fn text(node: &Node) -> &str {
    match &node.value {
        Value::Text(text) => text,
        _ => "",
    }
}

fn flag(node: &Node) -> bool {
    matches!(node.value, Value::Flag(true))
}

fn whole(node: &Node) -> i64 {
    match node.value {
        Value::Whole(n) => n,
        _ => 0,
    }
}

fn number(node: &Node) -> Option<f64> {
    match node.value {
        Value::Whole(n) => Some(n as f64),
        Value::Number(x) => Some(x),
        _ => None,
    }
}

fn wholes(node: &Node) -> impl Iterator<Item = i64> + '_ {
    let items: &[Node] = match &node.value {
        Value::List(items) => items,
        _ => &[],
    };
    items.iter().map(whole)
}

fn table_of(node: &Node) -> &Table {
    static NONE: Table = Table::new();
    match &node.value {
        Value::Table(table) => table,
        _ => &NONE,
    }
}

/// `["LA_ON"]`, or `{ LA_ON = "M64", LA_OFF = "" }`.
fn machine_words(node: &Node) -> Result<BTreeMap<String, Option<u32>>, ConfigError> {
    if let Value::List(items) = &node.value {
        return Ok(items.iter().map(|item| (text(item).to_ascii_uppercase(), None)).collect());
    }
    let mut words = BTreeMap::new();
    for (name, node) in table_of(node) {
        let printed = text(node);
        let number = printed.strip_prefix(['M', 'm']).and_then(|digits| digits.parse().ok()).filter(|n| *n < 10_000);
        if number.is_none() && !(printed.is_empty() && matches!(node.value, Value::Text(_))) {
            return Err(node.fail("a word of the machine becomes an M function such as \"M101\", or nothing: \"\""));
        }
        words.insert(name.to_ascii_uppercase(), number);
    }
    Ok(words)
}

fn axis(name: &str, node: &Node) -> Result<Axis, ConfigError> {
    match name.as_bytes() {
        [letter] => Axis::of(*letter),
        _ => None,
    }
    .ok_or_else(|| node.fail(format!("`{name}` is no axis: X, Y, Z, A, B, C, U, V, W")))
}

fn geometry_axes(node: &Node) -> Result<[Axis; 3], ConfigError> {
    let Value::List(items) = &node.value else { return Err(node.fail("needs three axis names")) };
    let axes = items.iter().map(|item| axis(text(item), item)).collect::<Result<Vec<_>, _>>()?;
    let distinct = |axes: &[Axis; 3]| axes[0] != axes[1] && axes[1] != axes[2] && axes[0] != axes[2];
    <[Axis; 3]>::try_from(axes).ok().filter(distinct).ok_or_else(|| node.fail("needs three different axis names"))
}

fn range(node: &Node) -> Result<(f64, f64), ConfigError> {
    let fail = || node.fail("travel limits are two numbers, the smaller one first: [-10.0, 800.0]");
    let Value::List(items) = &node.value else { return Err(fail()) };
    match items.as_slice() {
        [low, high] => match (number(low), number(high)) {
            (Some(low), Some(high)) if low <= high => Ok((low, high)),
            _ => Err(fail()),
        },
        _ => Err(fail()),
    }
}

fn change_point(node: &Node) -> Result<(f64, f64), ConfigError> {
    let fail = || node.fail("a tool change point has both coordinates: { X = 300.0, Z = 400.0 }");
    let (mut x, mut z) = (None, None);
    for (name, node) in table_of(node) {
        match name.as_str() {
            "X" => x = number(node),
            "Z" => z = number(node),
            _ => return Err(fail()),
        }
    }
    x.zip(z).ok_or_else(fail)
}

fn tool_key(name: &str, node: &Node) -> Result<ToolKey, ConfigError> {
    let (number, index) = name.split_once('.').unwrap_or((name, "0"));
    if name.bytes().all(|b| b.is_ascii_digit() || b == b'.') {
        let fail = || node.fail(format!("`{name}` is no tool number"));
        return Ok(ToolKey::Number(number.parse().map_err(|_| fail())?, index.parse().map_err(|_| fail())?));
    }
    Ok(ToolKey::Name(name.to_owned()))
}

/// 1 for `G54` … 9 for `G59.3`.
pub fn work_offset(word: &str) -> Option<u8> {
    const WORDS: [&str; 9] = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];
    WORDS.iter().position(|known| known.eq_ignore_ascii_case(word)).map(|i| i as u8 + 1)
}

#[cfg(test)]
mod tests {
    use super::super::tree::parse;
    use super::*;

    fn settings(text: &str) -> Result<Settings, Vec<ConfigError>> {
        read(&parse(text, "partc.toml").map_err(|e| vec![e])?)
    }

    #[test]
    fn the_example_of_the_contract() {
        let s = settings(
            r#"
            [machine]
            kind = "lathe"
            geometry_axes = ["X", "Y", "Z"]
            diameter_axis = "X"
            limits = { X = [-10.0, 800.0] }
            [control]
            skip_blocks = [1]
            [tools.1]
            name = "MILL_D10"
            radius = 5.0
            [tools."5.2"]
            number = 52
            [datums]
            G54 = { X = 0.0, Y = 0.0 }
            preset.12 = "G55"
            [include]
            roots = { "TNC:" = ".", "/_N_SPF_DIR" = "subprograms" }
            [variables]
            R1 = 5.0
            "@50" = 12
            [output]
            pass_m = [25, 26]
            compensation = "control"
            [limits]
            steps = 10_000
            "#,
        )
        .unwrap();
        assert_eq!(s.machine.limits[&Axis::X], (-10.0, 800.0));
        assert_eq!(s.tools.by_name("mill_d10").unwrap().0, Some(1));
        assert_eq!(s.tools.by_number(5, 2).unwrap().number, Some(52));
        assert_eq!(s.datums.presets[&12], 2);
        assert_eq!(s.variables["@50"], 12.0);
        assert_eq!(s.output.pass_m, [25, 26]);
        assert_eq!(s.limits.steps, 10_000);
    }

    #[test]
    fn unknown_keys_are_refused_with_a_suggestion_and_a_place() {
        let errors = settings("[output]\ndecimal = 3\n[machin]\nx = 1\n[tools.1]\nradus = 3\n").unwrap_err();
        let shown: Vec<String> = errors.iter().map(ToString::to_string).collect();
        assert_eq!(
            shown,
            [
                "partc.toml:3:2: unknown key `machin`; did you mean `machine`?",
                "partc.toml:2:1: unknown key `decimal`; did you mean `decimals`?",
                "partc.toml:6:1: unknown key `radus`; did you mean `radius`?",
            ]
        );
    }

    #[test]
    fn words_of_the_machine_are_a_list_or_a_table() {
        let list = settings("[control]\nmachine_words = [\"LA_ON\", \"g48\"]").unwrap();
        assert_eq!(list.control.mtc200.machine_words["G48"], None);
        let table = settings("[control.machine_words]\nLA_ON = \"M101\"\nG48 = \"\"").unwrap();
        assert_eq!(table.control.mtc200.machine_words["LA_ON"], Some(101));
        assert_eq!(table.control.mtc200.machine_words["G48"], None);
        assert!(settings("[control]\nmachine_words = { LA_ON = 5 }").is_err());
        assert!(settings("[control]\nmachine_words = { LA_ON = \"X5\" }").is_err());
    }

    #[test]
    fn wrong_values_are_refused() {
        for text in [
            "[output]\ndecimals = 9",
            "[output]\ncomments = 1",
            "[machine]\nlimits = { X = [5, 1] }",
            "[control]\nklartext = \"tnc640x\"",
            "[limits]\nsteps = 0",
            "[machine]\ngeometry_axes = [\"X\", \"X\", \"Z\"]",
            "[tools.1]\nradius = -1.0",
            "[datums]\npreset.1 = \"G60\"",
            "[control]\nfeed = 0",
        ] {
            assert!(settings(text).is_err(), "{text}");
        }
    }
}
