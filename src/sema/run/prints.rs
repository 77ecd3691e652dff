//! Prints work offsets and tools by their numbers: one that stands for another one of the program already is refused.

use crate::diag::{Answer, Diagnostic, Help, Label, codes};
use crate::ir::Function;
use crate::ir::contour::CtxRef;
use crate::ir::function::CutterData;
use crate::machine::tools::ToolKey;
use crate::sema::{Outcome, Reported};

use super::Language;
use super::core::Core;
use super::printed::{OffsetName, Printed, PrintedOffsets};
use super::report::Where;

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
        self.report(found.also(*at, Label::PrintedAs(format!("tool {other}"), format!("T{number}"))));
        Err(Reported)
    }

    /// Another tool comes into the spindle, or into the cutting position: its change and its data are printed.
    pub fn send_tool(&mut self, own: &ToolKey, number: u32, place: impl Into<Where>, ctx: &CtxRef) -> Outcome {
        self.prints_tool(own, number, place)?;
        self.send_function(&Function::ToolChange { number }, ctx);
        self.send_function(&Function::Cutter(CutterData { number, ..CutterData::default() }), ctx);
        Ok(())
    }

    /// The finding where two tools would be printed by one number.
    pub fn another_tool(&self, own: &ToolKey, other: &ToolKey, number: u32, place: impl Into<Where>) -> Diagnostic {
        let printed = |key: &ToolKey| match key {
            ToolKey::Number(n, 0) => self.job.settings.tools.printed_number(*n),
            ToolKey::Number(..) | ToolKey::Name(_) => number,
        };
        let mapped = if *own == ToolKey::Number(number, 0) { other } else { own };
        let asking = match printed(other) {
            n if n == number => codes::P0203::tool_is_printed_as_another(own, &number, other, mapped),
            n => codes::P0203::tool_has_number_of_another(own, &number, other, &n, mapped),
        };
        asking.answer(Answer::tool(mapped, "number")).at(self.loc(place.into()))
    }

    /// A work offset is to be printed by its number. Refused where the target has none of that number, or where
    /// another one of the program is printed by it: both parts would be cut at one place.
    pub fn prints_offset(&mut self, name: OffsetName<'_>, number: u8, place: impl Into<Where>) -> Outcome {
        let place = place.into();
        let said = name.said();
        if self.job.settings.output.target.offset(number).is_none() {
            return self.lacks_offset(name, &said, number, place);
        }
        let (moved, at) = (std::mem::take(&mut self.moved), self.loc(place));
        let offsets = &mut self.printed_offsets;
        let before = offsets.selected.replace(number);
        if let Some(before) = offsets.printed.iter_mut().find(|printed| Some(printed.number) == before) {
            before.used |= moved;
        }
        let key = name.is_mapped().then(|| name.key());
        let Some(other) = offsets.printed.iter_mut().find(|printed| printed.number == number) else {
            offsets.printed.push(Printed { number, said, key, at, used: false });
            return Ok(());
        };
        if other.said == said {
            return Ok(());
        }
        if !other.used {
            *other = Printed { number, said, key, at, used: false };
            return Ok(());
        }
        let (theirs, other_at, other_key) = (other.said.clone(), other.at, other.key.clone());
        let word = self.offset_word(number);
        let key = if name.is_mapped() { name.key() } else { other_key.unwrap_or_else(|| name.key()) };
        let help = format!(
            "name another work offset of the target in `[datums] {key}`, and set it up there; to the same values if both \
             are one place"
        );
        let help = Answer::key("datums", &key).help(help);
        let found = codes::P0202::is_to_be_printed(&said, &word, &theirs).at(self.loc(place)).help(help);
        self.report(found.also(other_at, Label::PrintedAs(theirs, word)));
        Err(Reported)
    }

    /// Moves in front of the first work offset count from whatever is active on the control.
    pub fn moves_before_offset(&self, number: u8, place: impl Into<Where>) {
        if !self.moved {
            return;
        }
        let word = self.offset_word(number);
        self.report(codes::P2032::moves_stand_in_front(&word).at(self.loc(place.into())));
    }

    /// A work offset of the target that nothing else of the program is printed by, in words to put behind a key of `[datums]`:
    /// each key gets one of its own.
    pub fn free_offset(&mut self, key: &str) -> String {
        let PrintedOffsets { printed, proposed, .. } = &self.printed_offsets;
        if let Some((_, number)) = proposed.iter().find(|(known, _)| known == key) {
            return self.offset_word(*number);
        }
        let output = &self.job.settings.output;
        let datums = &self.job.settings.datums;
        let is_free = |number: &u8| {
            output.target.offset(*number).is_some()
                && printed.iter().all(|printed| printed.number != *number)
                && proposed.iter().all(|(_, given)| given != number)
                && datums.words.values().chain(datums.presets.values()).all(|given| given != number)
        };
        // Where all are taken, any word shows the form, and P0202 says the rest.
        let number = (1..=u8::MAX).find(is_free).unwrap_or(1);
        self.printed_offsets.proposed.push((key.to_owned(), number));
        self.offset_word(number)
    }

    #[cold]
    fn lacks_offset(&mut self, name: OffsetName<'_>, said: &str, number: u8, place: Where) -> Outcome {
        let target = self.job.settings.output.target;
        let Some(range) = target.offset_range() else {
            return self.refuse(place, codes::O9310::target_has_no_work_offsets(&target.name, &said));
        };
        let printed =
            if name.is_mapped() { format!(", which `[datums]` maps to number {number},") } else { String::new() };
        let key = name.key();
        let free = self.free_offset(&key);
        let help: Help = match name {
            OffsetName::Word { .. } => {
                Answer::key("datums", &key).help(format!("name one that it has: `[datums] {key} = \"{free}\"`"))
            }
            OffsetName::Preset { row, .. } => Answer::entry("datums", "preset", f64::from(row))
                .help(format!("name one that it has: `[datums]` with `{key} = \"{free}\"`")),
            OffsetName::Fixed(_) => "set the part up in one of these, and select it in the program".into(),
        };
        self.refuse(place, codes::O9310::target_has_no_word(&target.name, &said, &printed, &range).help(help))
    }

    /// The word by which the target selects a work offset.
    pub fn offset_word(&self, number: u8) -> String {
        self.job.settings.output.target.offset(number).map(|word| word.into_owned()).unwrap_or_default()
    }
}
