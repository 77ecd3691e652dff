//! Turns the tree of a `partc.toml` into [`Settings`]. Every key is in [`SECTIONS`]; others are errors.

use crate::target;

use super::keys::{PROGRAM_KEYS, SECTIONS, Section, TOOL_KEYS};
use super::mtc200::{Centres, G52, InchSpeed, Reading, ShiftedIncrement};
use super::settings::*;
use super::tools::{Corner, Tool};
use super::tree::{ConfigError, Node, Table, Value, did_you_mean};
use super::values::*;

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

/// Two keys for one thing.
const BOTH_STARTS: &str =
    "`[control] start` is the older name of `[start]`: keep one of the two (X counts as a radius in the older one)";

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
            // The keys come in the order of the alphabet, so the names are known where others use them.
            ("machine", "axes") => s.machine.axes = axis_names(node)?,
            ("machine", "geometry_axes") => s.machine.geometry_axes = geometry_axes(node, &s.machine.axes)?,
            ("machine", "diameter_axis" | "md20100") => {
                let name = text(node);
                s.machine.diameter_axis =
                    if name.is_empty() { None } else { Some(named_axis(name, node, &s.machine.axes)?) };
            }
            ("machine", "power_on_diameter") => s.machine.power_on_diameter = flag(node),
            ("machine", "limits") => {
                for (name, node) in table_of(node) {
                    s.machine.limits.insert(axis(name, node)?, range(node)?);
                }
            }
            (
                "machine",
                "reference_point" | "fixed_point" | "fixed_point_2" | "fixed_point_3" | "fixed_point_4"
                | "swivel_retract",
            ) => {
                let points = match name {
                    "fixed_point" => &mut s.machine.fixed_point[0],
                    "fixed_point_2" => &mut s.machine.fixed_point[1],
                    "fixed_point_3" => &mut s.machine.fixed_point[2],
                    "fixed_point_4" => &mut s.machine.fixed_point[3],
                    "swivel_retract" => &mut s.machine.swivel_retract,
                    _ => &mut s.machine.reference_point,
                };
                for (name, node) in table_of(node) {
                    points.insert(axis(name, node)?, number(node).ok_or_else(|| node.fail("needs a number"))?);
                }
            }
            ("machine", "modulo") => {
                s.machine.modulo = rotary_axes(node)?;
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
                if name.eq_ignore_ascii_case("basic") {
                    s.datums.basic = Some(values);
                } else {
                    s.datums.offsets.insert(name.to_ascii_uppercase(), values);
                }
            }
            ("include", _) => {
                for (prefix, node) in table_of(node) {
                    let Value::Text(folder) = &node.value else { return Err(node.fail("a root is a folder")) };
                    s.include.roots.insert(prefix.clone(), folder.into());
                }
            }
            ("programs", _) => {
                let stand_in = self.stand_in(table_of(node), node)?;
                self.settings.programs.insert(name.to_ascii_uppercase(), stand_in);
            }
            ("undercut", _) => s.undercut.set(name, node)?,
            ("start", _) => {
                let value =
                    number(node).filter(|v| v.is_finite()).ok_or_else(|| node.fail("a position is a number"))?;
                s.start.insert(axis(name, node)?, value);
                if !s.control.mtc200.start.is_empty() {
                    return Err(node.fail(BOTH_STARTS));
                }
            }
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
                control.polar_missing = match text(node) {
                    "programmed" => PolarMissing::Programmed,
                    "position" => PolarMissing::Position,
                    _ => PolarMissing::SamePole,
                };
            }
            "pattern_feed" => control.klartext_readings.pattern_at_rapid = text(node) == "rapid",
            "mirror" => control.klartext_readings.mirror_last = text(node) == "last",
            "scaling_center" => control.klartext_readings.keep_scaling_center = text(node) == "kept",
            "shift_axes" => {
                control.shift_axes =
                    if text(node) == "transformed" { ShiftAxes::Transformed } else { ShiftAxes::Original };
            }
            "cp_sign" => control.cp_sign = if text(node) == "dr" { CpSign::Dr } else { CpSign::Refuse },
            "modulo" => {
                control.modulo = match text(node) {
                    "truncate" => Modulo::Truncate,
                    "floor" => Modulo::Floor,
                    _ => Modulo::Refuse,
                };
            }
            "repeat_count" => {
                control.repeat_count = match text(node) {
                    "truncate" => RepeatCount::Truncate,
                    "round" => RepeatCount::Round,
                    _ => RepeatCount::Refuse,
                };
            }
            "open_subprogram" => control.klartext_choices.open_subprogram_ends = text(node) == "end",
            "probing" => control.klartext_choices.probing_left_out = text(node) == "leave-out",
            "cycle_19" => control.klartext_choices.cycle_19_axes = text(node) == "axes",
            "scaling" => control.scaling_in_plane = text(node) == "plane",
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
            "large_corners" => control.siemens.shorten_corners = text(node) == "shorten",
            "md20150" => control.siemens.feed_per_revolution = Some(text(node) == "g95"),
            "md10760" => control.siemens.machine_moves_without_tool = flag(node),
            "md30455" => control.siemens.modulo_shortest = text(node) == "shortest",
            "arc_chamfers" => control.siemens.arc_chamfers = text(node) == "bisector",
            "g40_without_motion" => control.siemens.g40_needs_motion = text(node) == "error",
            "md10617" => control.siemens.save_restores_offset = Some(whole(node) & 1 != 0),
            "cycle86_lift" => control.siemens.cycle86_lift = Some(text(node) == "lift"),
            "thread_flank" => {
                let root = text(node) == "root";
                control.siemens.thread_flank = Some(if root { FlankReference::Root } else { FlankReference::Crest });
            }
            "md11120" => control.siemens.main_variables_visible = flag(node),
            _ if self.set_turning(name, node)? => {}
            _ => return self.set_mtc200(name, node),
        }
        Ok(())
    }

    /// True where `name` is a key of turning programs.
    fn set_turning(&mut self, name: &str, node: &Node) -> Result<bool, ConfigError> {
        let turning = &mut self.settings.control.turning;
        let is = |wanted: &str| Some(text(node) == wanted);
        let counts = || if text(node) == "radius" { RecessDepth::Radius } else { RecessDepth::Diameter };
        match name {
            "turning_arc_q" => {
                let far = text(node) == "far";
                turning.arc_choice = Some(if far { ArcChoice::ZeroIsFar } else { ArcChoice::ZeroIsNear });
            }
            "recess_depth" => turning.recess_depth = Some(counts()),
            "clearance" => {
                let clearance = number(node).filter(|mm| *mm > 0.0);
                turning.clearance = Some(clearance.ok_or_else(|| node.fail("a clearance is above 0"))?);
            }
            "recess_side" => {
                let plus = text(node) == "plus";
                turning.recess_side = Some(if plus { RecessSide::Plus } else { RecessSide::Minus });
            }
            "infeed" => turning.infeed = Some(counts()),
            "thread_left" => turning.left_is_plus = is("plus"),
            "recess_width" => {
                let floor = text(node) == "floor";
                turning.recess_width = Some(if floor { RecessWidth::Floor } else { RecessWidth::Opening });
            }
            "recess_blank" => turning.recess_blank = Some(counts()),
            "simple_thread" => turning.refuse_simple_thread = is("refuse"),
            "contour_words" => turning.refuse_contour_words = is("refuse"),
            "line_angle" => turning.angle_from_plus = is("plus-z"),
            "undercut_limit" => turning.undercut_upper = is("upper"),
            "thread_face" => turning.rear_face = is("rear"),
            "turning_depth" => turning.towards_floor = is("towards"),
            "offset_one_way" => turning.offset_one_way = is("end"),
            "recess_oversize" => turning.oversize_on_floor = is("floor"),
            "arc_tolerance" => {
                let tolerance = number(node).filter(|mm| (0.0..=1.0).contains(mm));
                turning.arc_tolerance = Some(tolerance.ok_or_else(|| node.fail("a tolerance is 0 to 1 mm"))?);
            }
            "tool_change_point" => turning.change_point = Some(change_point(node)?),
            _ => return Ok(false),
        }
        Ok(true)
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
            "start" if !self.settings.start.is_empty() => return Err(node.fail(BOTH_STARTS)),
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
            "dwell" => {
                control.dwell_ms = text(node) == "ms";
                control.confirmed.push(Reading::Dwell);
            }
            "g91_after_offset" => {
                control.g91_after_offset = match text(node) {
                    "with-offset" => ShiftedIncrement::WithOffset,
                    "increment" => ShiftedIncrement::Increment,
                    _ => ShiftedIncrement::Refuse,
                }
            }
            "spindle_nose" => control.refuse_spindle_nose = text(node) == "refuse",
            "cf_at_arcs" => control.chamfers_along_arcs = text(node) == "along",
            "confirmed" => {
                for name in texts(node) {
                    let known = Reading::ALL.into_iter().find(|reading| reading.name() == name);
                    let names = Reading::ALL.map(Reading::name).join(", ");
                    let fault = || node.fail(format!("`{name}` is no reading: {names}"));
                    control.confirmed.push(known.ok_or_else(fault)?);
                }
            }
            "tool_change" => {
                control.t_changes = text(node) == "t";
                self.settings.control.siemens.tool_change_by_t = Some(text(node) == "t");
            }
            "angles" => {
                control.radians = text(node) == "radians";
                control.confirmed.push(Reading::Degrees);
            }
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
            "target" => {
                output.target = target::find(text(node)).ok_or_else(|| node.fail("no such target"))?;
            }
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

    /// `{ tool = 1 }`, `{ ignore = true }` or `{ file = "stubs/TC.SPF" }`
    fn stand_in(&mut self, table: &Table, at: &Node) -> Result<StandIn, ConfigError> {
        for (name, node) in table {
            match PROGRAM_KEYS.iter().find(|key| key.name == name) {
                Some(key) => fits(key, node)?,
                None => self.unknown(name, node, PROGRAM_KEYS.iter().map(|key| key.name)),
            }
        }
        let mut entries = table.iter();
        match (entries.next(), entries.next()) {
            (Some((name, node)), None) if name == "tool" => match usize::try_from(whole(node)) {
                Ok(n @ 1..=127) => Ok(StandIn::Tool(n)),
                _ => Err(node.fail("arguments are counted from 1")),
            },
            (Some((name, node)), None) if name == "ignore" && flag(node) => Ok(StandIn::Ignored),
            (Some((name, node)), None) if name == "file" && !text(node).is_empty() => {
                Ok(StandIn::File(text(node).to_owned()))
            }
            _ => Err(at.fail("a program needs one of `tool = 1`, `ignore = true`, `file = \"…\"`")),
        }
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
                "tip_angle" => {
                    let angle = number(node).filter(|angle| *angle > 0.0 && *angle < 180.0);
                    tool.tip_angle =
                        Some(angle.ok_or_else(|| node.fail("an angle at a tip is above 0 and below 180"))?);
                }
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
#[cfg(test)]
mod tests {
    use super::super::axis::Axis;
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
