//! Turns the tree of a `partc.toml` into [`Settings`]. Every key is in [`SECTIONS`]; others are errors.

use std::collections::BTreeMap;

use super::keys::{PROGRAM_KEYS, SECTIONS, Section, TOOL_KEYS};
use super::settings::{ChangeCall, Datums, Leaves, Left, LeftSpindle, Settings, StandIn};
use super::tools::{Corner, Tool};
use super::tree::{ConfigError, Node, Table, Value, did_you_mean, parse};
use super::values::*;

/// Reads the settings from a tree; all errors at once.
///
/// # Errors
/// Unknown keys and values that do not fit.
/// `decimals` of each quantity.
const DECIMALS: [&str; 5] = ["decimals.length", "decimals.angle", "decimals.feed", "decimals.speed", "decimals.time"];

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

/// Reads the settings from the text of a `partc.toml`, without `extend` and tool tables, which are files; `file` names it
/// in errors.
///
/// # Errors
/// What is no TOML, unknown keys and values that do not fit.
pub fn from_toml(text: &str, file: &str) -> Result<Settings, Vec<ConfigError>> {
    read(&parse(text, file).map_err(|error| vec![error])?)
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
            let result = match section.keys().find(|key| key.name == name) {
                Some(key) => {
                    if section.name == "output" {
                        self.settings.output.stated.0.push((key.name, node.spot.clone()));
                        self.state_places(node);
                    }
                    fits(key, node).and_then(|()| (key.set)(&mut self.settings, node))
                }
                None if free => self.set_named(section.name, name, node),
                None => {
                    self.unknown(name, node, section.keys().map(|key| key.name));
                    Ok(())
                }
            };
            if let Err(error) = result {
                self.errors.push(error);
            }
        }
    }

    /// The quantities of `decimals = { … }`; no other key of `[output]` is a table.
    fn state_places(&mut self, node: &Node) {
        let Value::Table(quantities) = &node.value else { return };
        for (name, node) in quantities {
            let known = DECIMALS.iter().find(|known| known.rsplit('.').next() == Some(name));
            self.settings.output.stated.0.extend(known.map(|known| (*known, node.spot.clone())));
        }
    }

    /// A name that the user chose.
    fn set_named(&mut self, section: &str, name: &str, node: &Node) -> Result<(), ConfigError> {
        let s = &mut self.settings;
        match section {
            "tools" => {
                let key = tool_key(name, node)?;
                let tool = self.tool(table_of(node), node)?;
                if let Some(rival) = self.settings.tools.rival(&key, &tool) {
                    let message = format!("the tools {key} and {rival} would be printed by one number");
                    return Err(node.fail(message));
                }
                self.settings.tools.table.insert(key, tool);
            }
            "datums" => set_datum(&mut s.datums, name, node)?,
            "dialects" => match &node.value {
                Value::Text(dialect) => s.dialects.push((name.to_owned(), dialect.clone())),
                _ => return Err(node.fail("a pattern of files has the name of a language in quotes")),
            },
            "programs" => {
                let stand_in = self.stand_in(table_of(node), node)?;
                let leaves = leaves(table_of(node))?;
                if leaves != Leaves::default() {
                    if matches!(stand_in, StandIn::File(_)) {
                        return Err(node.fail("a program that runs leaves what it leaves: `motion`, `lost`, `feed`, `speed` and `spindle` have no place beside `file`"));
                    }
                    self.settings.leaves.insert(name.to_ascii_uppercase(), leaves);
                }
                if self.settings.programs.insert(name.to_ascii_uppercase(), stand_in).is_some() {
                    return Err(node.fail("a second entry of this name: capital and small letters are the same"));
                }
            }
            "start" => {
                let value =
                    number(node).filter(|v| v.is_finite()).ok_or_else(|| node.fail("a position is a number"))?;
                s.start.insert(axis(name, node)?, value);
                if !s.control.mtc200.start.is_empty() {
                    return Err(node.fail(BOTH_STARTS));
                }
            }
            "variables" => {
                let value = number(node).ok_or_else(|| node.fail("a start value is a number"))?;
                s.variables.insert(name.to_ascii_uppercase(), value);
            }
            _ => return Err(node.fail(format!("`{name}` has no place in [{section}]"))),
        }
        Ok(())
    }

    /// `{ tool = 1, d = 2 }`, `{ change = true }`, `{ ignore = true }` or `{ file = "stubs/TC.SPF" }`
    fn stand_in(&mut self, table: &Table, at: &Node) -> Result<StandIn, ConfigError> {
        for (name, node) in table {
            match PROGRAM_KEYS.iter().find(|key| key.name == name) {
                Some(key) => fits(key, node)?,
                None => self.unknown(name, node, PROGRAM_KEYS.iter().map(|key| key.name)),
            }
        }
        let argument = |node: &Node| match usize::try_from(whole(node)) {
            Ok(n @ 1..=127) => Ok(n),
            _ => Err(node.fail("arguments are counted from 1")),
        };
        let edge = table.get("d").map(argument).transpose()?;
        let mut others = table
            .iter()
            .filter(|(name, _)| !matches!(name.as_str(), "d" | "motion" | "lost" | "feed" | "speed" | "spindle"));
        match (others.next(), others.next(), edge) {
            (Some((name, node)), None, edge) if name == "tool" => {
                Ok(StandIn::Change(ChangeCall { tool: Some(argument(node)?), edge }))
            }
            (Some((name, node)), None, edge) if name == "change" && flag(node) => {
                Ok(StandIn::Change(ChangeCall { tool: None, edge }))
            }
            (Some((name, node)), None, None) if name == "ignore" && flag(node) => Ok(StandIn::Ignored),
            (Some((name, node)), None, None) if name == "file" && !text(node).is_empty() => {
                Ok(StandIn::File(text(node).to_owned()))
            }
            _ => Err(at.fail(
                "a program needs one of `tool = 1`, `change = true`, `ignore = true`, `file = \"…\"`; `d = 2` beside the first two",
            )),
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
                    let number = u32::try_from(whole(node)).ok().filter(|number| *number > 0);
                    // T0 is no tool.
                    tool.number = Some(number.ok_or_else(|| node.fail("the number of a tool is 1 or more"))?);
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
                "plunge_angle" => {
                    let angle = number(node).filter(|angle| (0.0..=90.0).contains(angle));
                    tool.plunge_angle = Some(angle.ok_or_else(|| node.fail("an angle of plunging is 0 to 90"))?);
                }
                "teeth" => tool.teeth = Some(small(99).ok_or_else(|| node.fail("1 to 99"))?),
                "orientation" => tool.orientation = Some(small(9).ok_or_else(|| node.fail("1 to 9"))?),
                "clearance" => {
                    let angle = number(node).filter(|angle| *angle > 0.0 && *angle <= 90.0);
                    tool.clearance =
                        Some(angle.ok_or_else(|| node.fail("an angle of a flank is above 0 and at most 90"))?);
                }
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

/// `motion = "G0"`, `lost = ["X"]`, `feed = 0.2`, `speed = "lost"`, `spindle = "M3"`
fn leaves(table: &Table) -> Result<Leaves, ConfigError> {
    let value = |name: &str, least: &str, fits: fn(f64) -> bool| match table.get(name) {
        None => Ok(None),
        Some(node) => match number(node) {
            None => Ok(Some(Left::Lost)),
            Some(value) if value.is_finite() && fits(value) => Ok(Some(Left::Value(value))),
            Some(_) => Err(node.fail(format!("`{name}` is {least}, or \"lost\""))),
        },
    };
    let spindle = |node: &Node| match text(node) {
        "M3" => LeftSpindle::Clockwise,
        "M4" => LeftSpindle::CounterClockwise,
        _ => LeftSpindle::Stopped,
    };
    let mut leaves = Leaves {
        rapid: table.get("motion").map(|node| is(node, "G0")),
        feed: value("feed", "above 0", |feed| feed > 0.0)?,
        speed: value("speed", "0 or more", |speed| speed >= 0.0)?,
        spindle: table.get("spindle").map(spindle),
        ..Leaves::default()
    };
    if let Some(node) = table.get("lost") {
        for name in texts(node) {
            leaves.lost.insert(axis(name, node)?);
        }
    }
    Ok(leaves)
}

fn set_datum(datums: &mut Datums, name: &str, node: &Node) -> Result<(), ConfigError> {
    if name == "preset" {
        for (number, node) in table_of(node) {
            let n = number.parse().map_err(|_| node.fail("a preset is a number"))?;
            let offset =
                work_offset(text(node)).ok_or_else(|| node.fail(format!("a preset becomes one of {OFFSETS}")))?;
            datums.presets.insert(n, offset);
        }
        return Ok(());
    }
    if matches!(node.value, Value::Text(_)) {
        let offset = work_offset(text(node)).ok_or_else(|| node.fail(format!("an offset becomes one of {OFFSETS}")))?;
        datums.words.insert(name.to_ascii_uppercase(), offset);
        return Ok(());
    }
    let mut values = BTreeMap::new();
    for (name, node) in table_of(node) {
        values.insert(axis(name, node)?, number(node).ok_or_else(|| node.fail("needs a number"))?);
    }
    if name.eq_ignore_ascii_case("basic") {
        datums.basic = Some(values);
    } else {
        datums.offsets.insert(name.to_ascii_uppercase(), values);
    }
    Ok(())
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
    fn two_tools_of_one_number_are_refused() {
        for (text, refused) in [
            ("[tools.1]\nradius = 4\n[tools.2]\nnumber = 1", true),
            ("[tools.1]\nnumber = 2\n[tools.2]\nnumber = 1", false),
            ("[tools.A]\nnumber = 7\n[tools.B]\nnumber = 7", true),
            // The data of the named tool.
            ("[tools.A]\nnumber = 7\n[tools.7]\nradius = 4", false),
            // Where a program counts tool A as its tool 7, it is refused there.
            ("[tools.A]\nnumber = 7\n[tools.7]\nnumber = 8", false),
            ("[tools.A]\nnumber = 7\n[tools.5]\nnumber = 7", true),
            // Two edges of one tool.
            ("[tools.\"3.1\"]\nnumber = 3\n[tools.\"3.2\"]\nnumber = 3", false),
        ] {
            assert_eq!(settings(text).is_err(), refused, "{text}");
        }
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
