//! What is printed by a number of its own: each printed work offset, and each printed tool, stands for one of the program.

use std::cell::RefCell;

use crate::diag::{Answer, Diagnostic, Help, codes};
use crate::machine::tools::ToolKey;
use crate::sema::{Outcome, Reported};
use crate::text::Loc;

use super::Language;
use super::core::Core;
use super::report::Where;

/// What the program calls a work offset, and how the configuration names another one for it.
#[derive(Debug, Clone, Copy)]
pub enum OffsetName<'a> {
    /// A word, and whether `[datums]` maps it.
    Word { word: &'a str, mapped: bool },
    /// A row of a preset table, and whether `[datums] preset` maps it.
    Preset { row: u32, mapped: bool },
    /// A word that no configuration maps.
    Fixed(&'a str),
}

impl OffsetName<'_> {
    fn said(self) -> String {
        match self {
            OffsetName::Word { word, .. } | OffsetName::Fixed(word) => word.to_owned(),
            OffsetName::Preset { row, .. } => format!("preset {row}"),
        }
    }

    fn is_mapped(self) -> bool {
        match self {
            OffsetName::Word { mapped, .. } | OffsetName::Preset { mapped, .. } => mapped,
            OffsetName::Fixed(_) => false,
        }
    }

    /// The line of `[datums]` that maps it.
    fn key(self) -> String {
        match self {
            OffsetName::Word { word, .. } | OffsetName::Fixed(word) => word.to_owned(),
            OffsetName::Preset { row, .. } => format!("preset.{row}"),
        }
    }
}

/// The work offsets that were printed, each with the name and the place that it was first printed for.
#[derive(Debug, Default)]
pub struct PrintedOffsets(Vec<Printed>);

#[derive(Debug)]
struct Printed {
    number: u8,
    said: String,
    /// The key that maps it, if one does.
    key: Option<String>,
    at: Loc,
}

/// The tools that were printed: as what, and which they are to the program.
#[derive(Debug, Default)]
pub struct PrintedTools(RefCell<Vec<(u32, ToolKey, Loc)>>);

impl<L: Language> Core<'_, L> {
    /// The tool `own` of the program is to be printed as `number`; refused where another one was: the machine would bring
    /// the same tool for both.
    pub fn prints_tool(&self, own: &ToolKey, number: u32, place: impl Into<Where>) -> Outcome {
        let tools = &mut *self.printed_tools.0.borrow_mut();
        let place = place.into();
        let Some((_, other, at)) = tools.iter().find(|(printed, ..)| *printed == number) else {
            tools.push((number, own.clone(), self.loc(place)));
            return Ok(());
        };
        if other == own {
            return Ok(());
        }
        let found = self.another_tool(own, other, number, place);
        self.report(found.also(*at, format!("tool {other} is printed as T{number}")));
        Err(Reported)
    }

    /// The finding where two tools would be printed by one number.
    pub fn another_tool(&self, own: &ToolKey, other: &ToolKey, number: u32, place: impl Into<Where>) -> Diagnostic {
        let message = format!("tool {own} is to be printed as T{number}, and so is tool {other}");
        let mapped = if *own == ToolKey::Number(number, 0) { other } else { own };
        let help = format!(
            "give it a number of its own in partc.toml: `number` in `[tools.{mapped}]`; if both are one tool, describe it in \
             one place: `[tools.{number}]` with its `name`"
        );
        Diagnostic::new(codes::P0203, self.loc(place.into()), message).help(help)
    }

    /// A work offset is to be printed by its number. Refused where the target has none of that number, or where
    /// another one of the program is printed by it: both parts would be cut at one place.
    pub fn prints_offset(&mut self, name: OffsetName<'_>, number: u8, place: impl Into<Where>) -> Outcome {
        let place = place.into();
        let said = name.said();
        if self.job.settings.output.target.offset(number).is_none() {
            return self.lacks_offset(name, &said, number, place);
        }
        let Some(other) = self.printed_offsets.0.iter().find(|printed| printed.number == number) else {
            let key = name.is_mapped().then(|| name.key());
            let at = self.loc(place);
            self.printed_offsets.0.push(Printed { number, said, key, at });
            return Ok(());
        };
        if other.said == said {
            return Ok(());
        }
        let word = self.offset_word(number);
        let message = format!("{said} is to be printed as {word}, and so was {}", other.said);
        let key = if name.is_mapped() { name.key() } else { other.key.clone().unwrap_or_else(|| name.key()) };
        let help = format!(
            "name another work offset of the target in `[datums] {key}`, and set it up there; to the same values if both \
             are one place"
        );
        let found = Diagnostic::new(codes::P0202, self.loc(place), message).help(help);
        self.report(found.also(other.at, format!("{} is printed as {word}", other.said)));
        Err(Reported)
    }

    #[cold]
    fn lacks_offset(&self, name: OffsetName<'_>, said: &str, number: u8, place: Where) -> Outcome {
        let target = self.job.settings.output.target;
        let Some(range) = target.offset_range() else {
            let help = "take the word out: positions count from where the part is set up on the machine";
            let message = format!("the target {} has no work offsets, and the program selects {said}", target.name);
            return self.fail_help(codes::O9310, place, message, help);
        };
        let printed =
            if name.is_mapped() { format!(", which `[datums]` maps to number {number},") } else { String::new() };
        let message = format!("the target {} has no word for {said}{printed}: it has {range}", target.name);
        let key = name.key();
        let help: Help = match name {
            OffsetName::Word { .. } => {
                Answer::key("datums", &key).help(format!("name one that it has: `[datums] {key} = \"G54\"`"))
            }
            OffsetName::Preset { row, .. } => Answer::entry("datums", "preset", f64::from(row))
                .help(format!("name one that it has: `[datums]` with `{key} = \"G54\"`")),
            OffsetName::Fixed(_) => "set the part up in one of these, and select it in the program".into(),
        };
        self.fail_help(codes::O9310, place, message, help)
    }

    /// The word by which the target selects a work offset.
    pub fn offset_word(&self, number: u8) -> String {
        self.job.settings.output.target.offset(number).map(|word| word.into_owned()).unwrap_or_default()
    }
}
