//! Work offsets: those of the machine are printed, those that the program writes go into the coordinates.
//!
//! Source: S 4.7 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::{Function, Side};
use crate::machine::Axis;
use crate::machine::settings::Datums;
use crate::sema::common::position::Position;
use crate::sema::run::{OffsetName, Where};

use super::frames::{FrameValue, Frames};
use super::g_groups::{GCode, Group};
use super::{Channel, Core, Outcome, State};

/// What printed positions count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Outer {
    /// The offset that is active on the target at the start: the basic system of the control.
    #[default]
    Basic,
    /// A work offset of the machine that is printed, by its number in the program.
    Printed(u8),
    /// Machine coordinates, printed with G53.
    Machine,
    /// The basic system, whose place is not known here.
    Unrelated,
}

/// Moves that were printed before any work offset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum FromBasic {
    #[default]
    None,
    /// In front of the first code of group 8.
    AtStart,
    UnderG500,
}

/// How work offsets were used so far, and what printed positions count from.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct OffsetUse {
    outer: Outer,
    /// The program selected offsets of the machine.
    printed: bool,
    /// The program selected offsets that it wrote.
    resolved: bool,
    /// G500 was programmed while nothing else was.
    under_g500: bool,
    moved_from_basic: FromBasic,
    /// A move in machine coordinates was printed.
    machine_moved: bool,
}

impl OffsetUse {
    #[inline]
    pub fn outer(&self) -> Outer {
        self.outer
    }

    /// Under G500 beside offsets of the machine.
    #[inline]
    pub fn in_machine(&self) -> bool {
        matches!(self.outer, Outer::Machine | Outer::Unrelated)
    }

    /// What a move has to note of them was noted, and it is printed in a work offset.
    pub fn are_noted(&self) -> bool {
        match (self.outer, self.moved_from_basic) {
            (Outer::Printed(_), _) | (Outer::Basic, FromBasic::UnderG500) => true,
            (Outer::Basic, FromBasic::AtStart) => !self.under_g500,
            (Outer::Basic, FromBasic::None) | (Outer::Machine | Outer::Unrelated, _) => false,
        }
    }

    /// Do positions count from the basic system because the program says so?
    pub fn is_basic_said(&self) -> bool {
        self.under_g500 || self.resolved
    }

    /// A move in machine coordinates is printed.
    pub fn moves_in_machine(&mut self) {
        self.machine_moved = true;
    }

    /// Positions count from an offset of the machine.
    pub fn prints_offset(&mut self) {
        self.printed = true;
    }

    /// Something is printed that counts from the basic system; a later offset of the machine would count from elsewhere.
    #[inline]
    pub fn note_move(&mut self, core: &Core<'_>) {
        if self.outer == Outer::Basic && self.moved_from_basic != FromBasic::UnderG500 {
            self.move_from_basic(core);
        }
    }

    fn move_from_basic(&mut self, core: &Core<'_>) {
        if !self.under_g500 {
            self.moved_from_basic = FromBasic::AtStart;
            return;
        }
        self.moved_from_basic = FromBasic::UnderG500;
        core.say_once(Where::Block, codes::S8011::positions_under_g500_are_printed());
        self.machine_moves_beside_g500(core, Where::Block);
    }

    /// Positions under G500 lie from the offset of the target, those of G53 from its machine zero: together they fit only
    /// where the basic frame is known.
    pub(super) fn machine_moves_beside_g500(&self, core: &Core<'_>, place: impl Into<Where>) {
        let both = self.machine_moved && self.moved_from_basic == FromBasic::UnderG500;
        if !both || core.job.settings.datums.basic.is_some() || !core.job.diags.first_time(codes::S8190, ()) {
            return;
        }
        let help = "give the basic frame: `[datums] basic = { X = 0.0, Y = 0.0, Z = 0.0 }`";
        let help = Answer::datum("basic").help(help);
        core.report(codes::S8190::moves_in_machine_coordinates().at(core.loc(place)).help(help));
    }

    /// A written offset counts from the basic system, a printed one from where the machine has it: nobody knows the
    /// way between the two.
    pub fn resolve(&mut self, core: &Core<'_>, position: &mut Position, place: impl Into<Where>) -> Outcome {
        self.resolved = true;
        if self.printed { mixed(core, position, place) } else { Ok(()) }
    }
}

impl State {
    /// G500: positions count from the basic system, the machine zero shifted by the basic frame.
    fn basic_system(&mut self, core: &Core<'_>, place: impl Into<Where>) {
        let place = place.into();
        let datums = &core.job.settings.datums;
        if self.offsets.resolved || !self.offsets.printed && datums.basic.is_none() {
            // Everything that is printed counts from there.
            self.offsets.under_g500 = true;
            return self.counts_from(core, Outer::Basic, Some(FrameValue::default()));
        }
        if let Some(basic) = &datums.basic {
            let frame = FrameValue::shifted(&basic.iter().map(|(axis, value)| (*axis, *value)).collect::<Vec<_>>());
            core.say_once(place, codes::S8011::under_g500_positions_are_printed_in_machine());
            return self.counts_from(core, Outer::Machine, Some(frame));
        }
        // Seen from a printed offset whose place is known, the basic system lies the other way.
        if let Outer::Printed(number) = self.offsets.outer()
            && let Some(values) = datums.offsets.get(&offset_word(number))
        {
            let back: Vec<_> = values.iter().map(|(axis, value)| (*axis, -*value)).collect();
            let word = offset_word(number);
            core.say_once(place, codes::S8011::positions_under_g500_are_printed_in_through(&word));
            return self.counts_from(core, Outer::Printed(number), Some(FrameValue::shifted(&back)));
        }
        self.counts_from(core, Outer::Unrelated, None);
    }

    /// Positions count from another place, or through another frame.
    pub(super) fn counts_from(&mut self, core: &Core<'_>, outer: Outer, frame: Option<FrameValue>) {
        if outer != self.offsets.outer() {
            self.position.clear();
        }
        self.offsets.outer = outer;
        self.frames.set_settable(frame);
        self.refresh_frame(core);
    }
}

impl Channel<'_> {
    /// A code of group 8: number 0 is G500, 1 is G54.
    pub(super) fn work_offset(&mut self, index: u8, place: impl Into<Where>) -> Outcome {
        let place = place.into();
        self.pending_must_be_done(place)?;
        let number = index - 1;
        if self.st.frames.is_tilted() {
            // The offset in force changes nothing.
            let same = number == self.st.frames.offset() && self.st.frames.written(number).is_none();
            let changes = codes::S2283::work_offset_changes(&offset_word(number));
            return if same && number != 0 { Ok(()) } else { self.core.refuse(place, changes) };
        }
        self.st.codes.activate(GCode::new(Group::WorkOffset, index));
        self.st.frames.select_offset(number);
        if self.st.side() != Side::None {
            return self.core.refuse(place, codes::S2080::work_offset_changes_while_radius_compensation());
        }
        if let Some(frame) = self.st.frames.written(number).cloned() {
            self.core.resolved_offset_note(place);
            self.st.offsets.resolve(&self.core, &mut self.st.position, place)?;
            self.st.counts_from(&self.core, Outer::Basic, Some(frame));
            return Ok(());
        }
        let mapped = self.core.job.settings.datums.words.get(&offset_word(number)).copied();
        let printed = match (mapped, number) {
            (Some(printed), _) => printed,
            (None, 0) => {
                self.st.basic_system(&self.core, place);
                return Ok(());
            }
            (None, 1..=9) => number,
            (None, _) if self.core.job.settings.output.target.offset(number).is_some() => number,
            _ => return self.core.no_counterpart(number, place),
        };
        let word = offset_word(number);
        self.core.prints_offset(OffsetName::Word { word: &word, mapped: mapped.is_some() }, printed, place)?;
        let selected = self.st.offsets.printed || self.st.offsets.under_g500;
        if selected && self.st.offsets.outer() != Outer::Printed(number) {
            self.st.position.end_start();
        }
        self.st.counts_from(&self.core, Outer::Printed(number), None);
        self.st.offsets.printed = true;
        if self.st.offsets.resolved {
            return mixed(&self.core, &mut self.st.position, place);
        }
        let moved = std::mem::take(&mut self.st.offsets.moved_from_basic);
        if moved == FromBasic::UnderG500 {
            self.st.position.clear();
            return self.core.offset_behind_g500(place, &offset_word(number));
        }
        self.function(Function::WorkOffset(printed));
        self.st.position.clear();
        // Axes that never moved stand where the configuration says, in the first work offset.
        self.st.position.take_start(&self.st.ctx.frame);
        if moved == FromBasic::AtStart {
            let word = offset_word(number);
            let found = codes::P2032::moves_stand_in_front_of_they_run(&word).at(self.core.loc(place));
            self.core.report(found.help("select the work offset before the first move"));
        }
        Ok(())
    }
}

impl Core<'_> {
    /// A work offset that the target has no word for.
    fn no_counterpart(&mut self, number: u8, place: Where) -> Outcome {
        let word = offset_word(number);
        if self.job.settings.output.target.offset_range().is_none() {
            return self.prints_offset(OffsetName::Word { word: &word, mapped: false }, number, place);
        }
        let free = self.free_offset(&word);
        self.refuse(
            place,
            codes::P9014::has_no_counterpart_on_target(&word, &free).answer(Answer::key("datums", &word)),
        )
    }

    /// What was printed under G500 cannot be taken back.
    fn offset_behind_g500(&self, place: impl Into<Where>, word: &str) -> Outcome {
        let place = place.into();
        if !self.job.settings.datums.offsets.contains_key(word) {
            return self.unrelated(place, "moves under G500 stand before");
        }
        let help = format!(
            "select {word} before the first move, then G500 is printed through its values in `[datums]`; or give the \
             basic frame (`[datums] basic = {{ X = 0.0, Y = 0.0, Z = 0.0 }}`)"
        );
        self.refuse(place, codes::S9131::moves_under_g500_stand_in_front(&word).help(Answer::datum("basic").help(help)))
    }

    /// G500 beside an offset of the machine: nobody knows the way between the two.
    pub(super) fn unrelated<T>(&self, place: impl Into<Where>, what: &str) -> Outcome<T> {
        self.refuse(
            place,
            codes::S9131::work_offset_of_machine(&what).answers([
                Answer::datum("basic"),
                Answer::datum("G54"),
                Answer::key("datums", "G500"),
            ]),
        )
    }

    pub(super) fn resolved_offset_note(&self, place: impl Into<Where>) {
        self.say_once(place, codes::S8012::work_offset_that_program_writes_itself());
    }
}

fn mixed(core: &Core<'_>, position: &mut Position, place: impl Into<Where>) -> Outcome {
    position.clear();
    core.refuse(place, codes::S9017::program_uses_work_offset_that_it_writes())
}

impl Frames {
    /// A work offset as far as it is known: written by the program, or given under `[datums]`.
    pub(super) fn offset_of(&self, datums: &Datums, number: u8) -> Option<FrameValue> {
        if let Some(frame) = self.written(number) {
            return Some(frame.clone());
        }
        let values = datums.offsets.get(&offset_word(number))?;
        let values: Vec<(Axis, f64)> = values.iter().map(|(axis, value)| (*axis, *value)).collect();
        Some(FrameValue::shifted(&values))
    }

    /// The same work offset is in force, with another frame than at the call: bit 0 of MD 10617 decides.
    pub(super) fn restore_settable(&mut self, core: &Core<'_>, frame: Option<FrameValue>) {
        let chosen = core.job.settings.control.sinumerik.save_restores_offset;
        if chosen == Some(true) {
            self.set_settable(frame);
        } else if chosen.is_none() {
            let found = codes::S9018::program_with_save_changed_frame_of_work().at(core.here.origin.loc);
            core.report(
                found.help(
                    Answer::key("control", "md10617")
                        .help("set `[control] md10617`, or select the offset again in the calling program"),
                ),
            );
        }
    }
}

/// G54 is 1, G57 is 4, G505 is 5.
pub(super) fn offset_word(number: u8) -> String {
    match number {
        0 => "G500".to_owned(),
        1..=4 => format!("G{}", 53 + u32::from(number)),
        _ => format!("G{}", 500 + u32::from(number)),
    }
}
