//! Tool data, from the program's surroundings: `[tools]` or a table.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::diag::{Answer, Help};

use super::Unit;
use super::table::{Contents, Edge};

/// How a tool is asked for.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum ToolKey {
    /// Number and index (`5.2` is 5, 2).
    Number(u32, u8),
    Name(String),
}

impl fmt::Display for ToolKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ToolKey::Number(n, 0) => write!(f, "{n}"),
            ToolKey::Number(n, index) => write!(f, "{n}.{index}"),
            ToolKey::Name(name) => write!(f, "\"{name}\""),
        }
    }
}

/// A corner of a recessing tool, seen along the axis of its width.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Corner {
    /// Towards -Z, for axial tools towards -X.
    #[default]
    Minus,
    Plus,
    Middle,
}

/// Data of one tool; lengths in mm. `None` is "not known", which is not zero.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tool {
    /// Number to print, where it is not the one of the key.
    pub number: Option<u32>,
    pub name: Option<String>,
    pub kind: Option<String>,
    /// Cutter radius; nose radius of turning and recessing tools.
    pub radius: Option<f64>,
    pub length: Option<f64>,
    pub corner_radius: Option<f64>,
    /// Angle at the tip of a drill, degrees.
    pub tip_angle: Option<f64>,
    /// Greatest angle at which a cutter goes down into material, degrees.
    pub plunge_angle: Option<f64>,
    /// Cutting edges that follow each other in a turn.
    pub teeth: Option<u8>,
    /// Wear or oversize of length, radius and corner radius in the table.
    pub deltas: [f64; 3],
    /// Cutting-edge position 1 to 9.
    pub orientation: Option<u8>,
    /// Angle between the flank of a turning tool and the way of its cuts, degrees.
    pub clearance: Option<f64>,
    /// Cutting width of recessing tools.
    pub width: Option<f64>,
    /// Corner of a recessing tool that is programmed.
    pub reference: Corner,
}

impl Tool {
    /// Is nothing known of it but what to print for it?
    fn is_only_numbered(&self) -> bool {
        self.number.is_some() && *self == Tool { number: self.number, ..Tool::default() }
    }

    /// Is all that is known of it known of `other`, too, and the same?
    fn adds_nothing_to(&self, other: &Tool) -> bool {
        let none = Tool::default();
        let with = Tool {
            number: other.number,
            name: other.name.clone(),
            kind: self.kind.clone().or_else(|| other.kind.clone()),
            radius: self.radius.or(other.radius),
            length: self.length.or(other.length),
            corner_radius: self.corner_radius.or(other.corner_radius),
            tip_angle: self.tip_angle.or(other.tip_angle),
            plunge_angle: self.plunge_angle.or(other.plunge_angle),
            teeth: self.teeth.or(other.teeth),
            deltas: if self.deltas == none.deltas { other.deltas } else { self.deltas },
            orientation: self.orientation.or(other.orientation),
            clearance: self.clearance.or(other.clearance),
            width: self.width.or(other.width),
            reference: if self.reference == none.reference { other.reference } else { self.reference },
        };
        with == *other
    }
}

/// The known tools.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tools {
    pub table: BTreeMap<ToolKey, Tool>,
    /// A tool table was given, so a tool that is not in it is worth a word.
    pub complete: bool,
    /// What a SINUMERIK knows of the edges, in the unit of the table.
    pub edges: BTreeMap<Edge, f64>,
    /// The unit that `[tools] unit` states.
    pub stated: Option<Unit>,
    /// The unit of the table, where nobody but the table itself says it.
    pub unit: Option<Unit>,
}

impl Tools {
    /// Takes the tools of a file, but for those that are known already.
    ///
    /// # Errors
    /// A unit that `[tools] unit` contradicts.
    pub fn add(&mut self, mut contents: Contents) -> Result<(), String> {
        match (self.stated, contents.unit) {
            (Some(stated), None) => contents.take_for(stated),
            (Some(stated), Some(unit)) if stated != unit => {
                return Err("the unit of the table is not the one that `[tools] unit` states".to_owned());
            }
            _ => {}
        }
        if self.stated.is_none() {
            self.unit = Some(contents.unit.unwrap_or_default());
        }
        for (key, tool) in contents.tools {
            match (self.table.entry(key), contents.edges.is_empty()) {
                (Entry::Vacant(free), _) => drop(free.insert(tool)),
                // A number to print says nothing of the tool itself.
                (Entry::Occupied(mut known), _) if known.get().is_only_numbered() => {
                    let number = known.get().number;
                    *known.get_mut() = Tool { number, ..tool };
                }
                // What partc.toml says of a tool is its edge 1.
                (Entry::Occupied(known), false) => {
                    if let ToolKey::Number(number, 0) = *known.key() {
                        contents.edges.retain(|edge, _| (edge.tool, edge.edge) != (number, 1));
                    }
                }
                _ => {}
            }
        }
        self.edges.append(&mut contents.edges);
        self.complete = true;
        Ok(())
    }

    pub fn by_number(&self, number: u32, index: u8) -> Option<&Tool> {
        self.table.get(&ToolKey::Number(number, index))
    }

    /// The tool that a program counts as `own`: the one of this number, or else the named one that is printed by it.
    pub fn called(&self, own: u32) -> Option<&Tool> {
        let named = |(key, tool): (&ToolKey, &'_ Tool)| matches!(key, ToolKey::Name(_)) && tool.number == Some(own);
        self.by_number(own, 0).or_else(|| self.table.iter().find(|entry| named(*entry)).map(|(_, tool)| tool))
    }

    /// Radius of the tool that a program counts as `own`.
    pub fn radius_of_called(&self, own: u32) -> Option<f64> {
        let tool = self.called(own)?;
        Some(tool.radius? + tool.deltas[1])
    }

    /// The tool of exactly this name, if `exact`; or one that differs in upper and lower case only if there is no other.
    pub fn key_of_name(&self, name: &str, exact: bool) -> Option<&ToolKey> {
        let other_case = || self.named(|other| other.eq_ignore_ascii_case(name)).filter(|_| !exact);
        self.named(|other| other == name).or_else(other_case).map(|(key, _)| key)
    }

    /// The tool that has the number of the named one as its own, and is another one.
    pub fn other_of_number(&self, key: &ToolKey) -> Option<u32> {
        let tool = self.table.get(key).filter(|_| matches!(key, ToolKey::Name(_)))?;
        let number = tool.number?;
        if let (ToolKey::Name(name), own) = (key, self.own_number(number)) {
            // Its row in the table of the control.
            let rows = |(key, row): (&ToolKey, &Tool)| match key {
                ToolKey::Number(own, 0) if row.name.as_deref() == Some(name) => Some(*own),
                _ => None,
            };
            let other = self.table.iter().filter_map(rows).find(|row| *row != own);
            if other.is_some() {
                return other;
            }
        }
        let own = self.own_number(number);
        let differs =
            |other: &Tool| other.number.is_some_and(|printed| printed != number) || !tool.adds_nothing_to(other);
        let is_other = own != number || self.by_number(own, 0).is_some_and(differs);
        is_other.then_some(own)
    }

    /// The tool that is printed as `number`.
    pub fn by_printed(&self, number: u32) -> Option<&Tool> {
        self.by_number(self.own_number(number), 0)
    }

    /// What the tool `number` of the program is printed as.
    pub fn printed_number(&self, number: u32) -> u32 {
        self.by_number(number, 0).and_then(|tool| tool.number).unwrap_or(number)
    }

    /// What a tool that is printed as `printed` has as its key.
    pub fn own_number(&self, printed: u32) -> u32 {
        let own = |(key, tool): (&ToolKey, &Tool)| match key {
            ToolKey::Number(own, 0) if tool.number == Some(printed) => Some(*own),
            ToolKey::Number(..) | ToolKey::Name(_) => None,
        };
        self.table.iter().find_map(own).unwrap_or(printed)
    }

    /// A tool that would be printed by the number of this one. A name may stand for a tool that has its number as key; where a
    /// program counts the named one as that tool, it is refused there.
    pub fn rival(&self, key: &ToolKey, tool: &Tool) -> Option<&ToolKey> {
        let printed = |key: &ToolKey, tool: &Tool| match key {
            ToolKey::Number(number, 0) => Some(tool.number.unwrap_or(*number)),
            ToolKey::Number(..) | ToolKey::Name(_) => tool.number,
        };
        let number = printed(key, tool)?;
        let rivals = |(other, its): &(&ToolKey, &Tool)| {
            let same = printed(other, its) == Some(number);
            match (key, *other) {
                (ToolKey::Number(one, _), ToolKey::Number(two, _)) => same && one != two,
                (ToolKey::Name(one), ToolKey::Name(two)) => same && one != two,
                (ToolKey::Name(_), ToolKey::Number(..)) => same && its.number.is_some(),
                (ToolKey::Number(..), ToolKey::Name(_)) => same && tool.number.is_some(),
            }
        };
        self.table.iter().find(rivals).map(|(other, _)| other)
    }

    /// The tool of this name and its number; one that differs in upper and lower case only if there is no other.
    pub fn by_name(&self, name: &str) -> Option<(Option<u32>, &Tool)> {
        self.numbered(
            self.named(|other| other == name).or_else(|| self.named(|other| other.eq_ignore_ascii_case(name))),
        )
    }

    /// The tool of exactly this name and its number.
    pub fn by_exact_name(&self, name: &str) -> Option<(Option<u32>, &Tool)> {
        self.numbered(self.named(|other| other == name))
    }

    /// A tool with the number to print.
    fn numbered<'t>(&self, found: Option<(&ToolKey, &'t Tool)>) -> Option<(Option<u32>, &'t Tool)> {
        found.map(|(key, tool)| match key {
            ToolKey::Number(own, _) => (Some(tool.number.unwrap_or(*own)), tool),
            ToolKey::Name(_) => (tool.number, tool),
        })
    }

    /// A name that differs from `name` in nothing but case, blanks, `_` and `-`. Anything else would be another tool.
    pub fn alike(&self, name: &str) -> Option<&str> {
        let bare = |name: &str| -> String {
            name.chars().filter(|c| !matches!(c, ' ' | '_' | '-')).flat_map(char::to_lowercase).collect()
        };
        let wanted = bare(name);
        let names = self.table.iter().filter_map(|(key, tool)| match key {
            ToolKey::Name(name) => Some(name.as_str()),
            ToolKey::Number(..) => tool.name.as_deref(),
        });
        names.into_iter().find(|other| bare(other) == wanted && *other != name)
    }

    /// Is the number given to a tool, as its key or to print?
    fn is_taken(&self, number: u32) -> bool {
        self.table
            .iter()
            .any(|(key, tool)| tool.number == Some(number) || matches!(key, ToolKey::Number(n, _) if *n == number))
    }

    /// Radius of the tool that is printed as `number`; `None` if it is not known, or edges of it differ.
    pub fn radius_of_printed(&self, number: u32) -> Option<f64> {
        let mut radii = self.table.iter().filter_map(|(key, tool)| match (key, tool.number) {
            (_, Some(printed)) => (printed == number).then_some(tool),
            (ToolKey::Number(own, _), None) => (*own == number).then_some(tool),
            (ToolKey::Name(_), None) => None,
        });
        let radius = |tool: &Tool| tool.radius.map(|radius| radius + tool.deltas[1]);
        let first = radii.next().and_then(radius)?;
        radii.all(|tool| radius(tool) == Some(first)).then_some(first)
    }

    /// A tool that partc.toml has under this name, or the only one of the table that has it.
    fn named(&self, is_it: impl Fn(&str) -> bool) -> Option<(&ToolKey, &Tool)> {
        let by_key = self.table.iter().find(|(key, _)| matches!(key, ToolKey::Name(name) if is_it(name)));
        by_key.or_else(|| {
            // Sister tools share one.
            let mut all = self
                .table
                .iter()
                .filter(|(key, tool)| matches!(key, ToolKey::Number(_, 0)) && tool.name.as_deref().is_some_and(&is_it));
            let first = all.next()?;
            all.next().is_none().then_some(first)
        })
    }
}

/// Numbers proposed for tools that the program calls by a name without a number.
#[derive(Debug, Clone, Default)]
pub struct Proposed {
    names: Vec<(String, u32)>,
    /// Numbers that the program called.
    called: BTreeSet<u32>,
}

impl Proposed {
    /// The program called this number: it is no free one.
    pub fn call(&mut self, number: u32) {
        self.called.insert(number);
    }

    /// What to put into the configuration for the tool `name`: each name gets a number of its own.
    pub fn help(&mut self, name: &str, tools: &Tools) -> Help {
        let has_name = |tool: &Tool| tool.name.as_deref().is_some_and(|other| other.eq_ignore_ascii_case(name));
        let sisters: Vec<String> = tools
            .table
            .iter()
            .filter(|(key, tool)| matches!(key, ToolKey::Number(_, 0)) && has_name(tool))
            .map(|(key, _)| key.to_string())
            .collect();
        if sisters.len() > 1 {
            let which = sisters.join(" and ");
            let escaped = name.replace('\\', "\\\\").replace('"', "\\\"");
            return Help::from(format!(
                "tools {which} of the table have this name, and a control chooses by tool life: say in partc.toml which one it is, \
                 `[tools.\"{escaped}\"]` with its `number` and its data"
            ));
        }
        let known = self.names.iter().find(|(known, _)| known == name).map(|(_, number)| *number);
        let number = known.unwrap_or_else(|| {
            let free = |n: &u32| {
                !tools.is_taken(*n) && !self.called.contains(n) && !self.names.iter().any(|(_, given)| given == n)
            };
            let number = (1..).find(free).unwrap_or(1);
            self.names.push((name.to_owned(), number));
            number
        });
        let escaped = name.replace('\\', "\\\\").replace('"', "\\\"");
        let line = format!("give it a number in partc.toml: `[tools.{number}]` with `name = \"{escaped}\"`");
        Answer::tool(number, "name").one_of(&[format!("\"{escaped}\"")]).help(match tools.alike(name) {
            Some(alike) => format!("{line}; the table has a tool `{alike}`, whose name is written differently"),
            None => line,
        })
    }
}
