//! Lines of functions: tool, spindle, coolant, dwell, comments.

use crate::diag::{Answer, Label, codes};
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::{Function, Origin, Side};
use crate::machine::settings::ToolChange;
use crate::target::{Change, Form, Length, LengthNumber, LengthWords, Limit};
use crate::text::Loc;

use super::super::comment;
use super::super::modal::FeedKind;
use super::super::number::Places;
use super::refusals::in_millimetres;
use super::{HandChange, Printer, ToolLength};

impl Printer<'_> {
    pub(super) fn print_function(&mut self, function: &Function, origin: &Origin) {
        if self.compensation.ends_before(function, self.modal.plane, origin) {
            self.end_compensation(origin);
        }
        let flow = &self.target.flow;
        match function {
            Function::ToolChange { number } => self.tool_change(*number, origin),
            Function::ToolPrepare { .. } if !self.target.tool.prepares => {
                self.deny(origin, codes::O9320::target_has_no_word_for_tool(&self.target.name));
            }
            Function::ToolPrepare { number } => {
                if let Form::Dialog(dialog) = self.target.form {
                    self.lines.text.word(dialog.prepare);
                }
                self.tool_word(*number, origin);
                self.lines.end_line(origin);
            }
            Function::Cutter(cutter) => self.compensation.cutter = *cutter,
            Function::Spindle(spindle) => self.spindle(*spindle, None, origin),
            Function::SpindleOf { number, spindle } => self.spindle(*spindle, Some(*number), origin),
            // What they change has happened to the moves.
            Function::FeedSpindle(_) | Function::Transformation(_) => {}
            Function::Coolant(coolant) => self.coolant(*coolant, origin),
            Function::Dwell(seconds) => self.dwell(*seconds, origin),
            Function::Stop if !self.has_m(0, origin) => {}
            Function::Stop => {
                self.lines.words(flow.stop, origin);
                self.stated.turn = None;
                self.modal.may_have_moved();
            }
            Function::OptionalStop if !self.has_m(1, origin) => {}
            Function::OptionalStop => {
                if flow.optional_stop_is_idle {
                    self.optional_stop_is_idle(origin);
                }
                self.lines.words(flow.optional_stop, origin);
                self.stated.turn = None;
                self.modal.may_have_moved();
            }
            Function::Aux(number) => self.m_function(*number, origin),
            Function::WorkOffset(number) => self.work_offset(*number, origin),
            Function::Plane(plane) => self.select_plane(*plane, origin),
            Function::Tilt(tilting) => self.tilt(tilting, origin),
            Function::PathControl(said) => self.path_control(*said, origin),
            Function::Comment(text) => self.comment(text, origin),
            Function::Remark(_) => {}
            Function::End { rewind } => {
                if self.compensation.side != Side::None {
                    self.end_compensation(origin);
                }
                self.template(&self.settings.footer);
                self.end(if *rewind { flow.rewind } else { flow.end }, origin);
                self.ended = true;
            }
        }
    }

    /// The end of the program. Where the end of the text is all there is, nothing else stops spindle and coolant.
    pub(super) fn end(&mut self, word: Option<&str>, origin: &Origin) {
        if let Some(word) = word {
            return self.lines.words(word, origin);
        }
        if self.running.turn.is_some() {
            self.spindle(Spindle::Stop, None, origin);
        }
        if self.running.coolant {
            self.coolant(Coolant::Off, origin);
        }
    }

    pub(super) fn tool_word(&mut self, number: u32, origin: &Origin) {
        let words = &self.target.tool;
        if number > words.most {
            self.say(origin, codes::O9306::tool_target_counts_tools(&number, &self.target.name, &words.most));
        }
        match self.target.form {
            Form::Words => drop(self.lines.text.whole(words.address, u64::from(number))),
            Form::Dialog(_) => drop(self.lines.text.bare(i64::from(number), Places::new(0))),
        }
    }

    fn tool_change(&mut self, number: u32, origin: &Origin) {
        // The change may have moved any axis, and stopped the spindle.
        self.modal.may_have_moved();
        self.stated.turn = None;
        if self.settings.tool_change == ToolChange::Stop {
            // D1 is a length of the tool that T has named.
            let of_call = match self.target.tool.length {
                Length::WithTool => true,
                Length::Words(words) => {
                    matches!(words.number, LengthNumber::None) && self.settings.prints_tool_length()
                }
                Length::None => false,
            };
            if of_call {
                let asking = codes::O9327::target_has_no_word_for_change_by_hand(&self.target.name);
                let change = Answer::key("output", "tool_change").one_of(&["\"change\""]);
                return self.deny(origin, asking.answer(change));
            }
            self.change_by_hand(number, origin);
        } else {
            self.change(number, origin);
        }
        self.tool_length(number, origin);
    }

    fn change(&mut self, number: u32, origin: &Origin) {
        match self.target.tool.change {
            Some(Change::Word(change)) => {
                self.tool_word(number, origin);
                self.lines.text.word(change);
            }
            Some(Change::Turret { digits }) if number > 0 => {
                let place = 10u64.pow(digits as u32);
                self.tool_word(number, origin);
                self.lines.text.drop_line();
                let (tool, digits) = (u64::from(number) * (place + 1), 2 * digits);
                let word = format!("{}{tool:0digits$}", self.target.tool.address as char);
                self.lines.text.word(&word);
            }
            Some(Change::Call) => {
                if let Form::Dialog(dialog) = self.target.form {
                    self.dialog_tool(dialog, Some(number), origin);
                }
            }
            Some(Change::Turret { .. }) => {
                return self.deny(origin, codes::O9305::target_has_no_word_for_tool_0(&self.target.name));
            }
            None => {
                let asking = codes::O9305::target_has_no_word_for_tool_change(&self.target.name);
                let stop = Answer::key("output", "tool_change").one_of(&["\"stop\""]);
                return self.deny(origin, asking.answer(stop));
            }
        }
        self.lines.end_line(origin);
    }

    /// The length of the tool behind its change.
    fn tool_length(&mut self, number: u32, origin: &Origin) {
        if !self.settings.prints_tool_length() {
            return;
        }
        if let Length::Words(LengthWords { number: LengthNumber::Tool(letter), .. }) = self.target.tool.length
            && !self.has_offset(number, letter, origin)
        {
            return;
        }
        match self.target.tool.length {
            Length::None => {
                let asking = codes::O9307::target_has_no_word_for_length_of_tool(&self.target.name);
                self.deny(origin, asking.answer(Answer::key("output", "tool_length").one_of(&["\"off\""])));
            }
            Length::WithTool => {}
            Length::Words(words) if number == 0 => {
                self.length = ToolLength { tool: 0, waits: false, counts: false, ..self.length };
                match words.off {
                    Some(off) => self.lines.words(off, origin),
                    None => self.deny(origin, codes::O9307::target_has_no_word_for_tool_0(&self.target.name)),
                }
            }
            Length::Words(words) if words.with_move => {
                self.length = ToolLength { tool: number, waits: true, ..self.length };
            }
            Length::Words(words) => {
                self.length = ToolLength { tool: number, waits: false, ..self.length };
                self.lines.text.word(words.on);
                if let LengthNumber::Tool(address) = words.number {
                    self.lines.text.whole(address, u64::from(number));
                }
                self.lines.end_line(origin);
            }
        }
    }

    /// The spindle stops, as under a change by the machine, and the program waits.
    fn change_by_hand(&mut self, number: u32, origin: &Origin) {
        if !self.has_m(5, origin) || !self.has_m(0, origin) {
            return;
        }
        self.lines.words(self.target.spindle.stop, origin);
        self.running.turn = None;
        if self.spindle == HandChange::Turns {
            self.spindle = HandChange::Stopped(origin.loc);
        }
        let text = if number == 0 { "take the tool out".to_owned() } else { format!("change to tool {number}") };
        self.comment(text.as_bytes(), origin);
        self.lines.words(self.target.flow.stop, origin);
    }

    /// A cut behind a change by hand: whether the control had the spindle turn is not known.
    #[cold]
    pub(super) fn spindle_stands(&mut self, change: Loc, origin: &Origin) {
        // Once is enough.
        self.spindle = HandChange::Stands;
        let found = codes::O9316::this_block_cuts().at(origin.loc).called(origin.call);
        self.diags.push(found.also(change, Label::Change));
    }

    fn coolant(&mut self, coolant: Coolant, origin: &Origin) {
        let words = &self.target.coolant;
        let (word, m) = match coolant {
            Coolant::Mist => (words.mist, 7),
            Coolant::Flood => (Some(words.flood), 8),
            Coolant::Off => (Some(words.off), 9),
        };
        self.running.coolant = !matches!(coolant, Coolant::Off);
        if word.is_some() && !self.has_m(m, origin) {
            return;
        }
        match word {
            Some(word) => self.lines.words(word, origin),
            None => {
                self.deny(origin, codes::O9311::target_has_no_word_for_mist(&self.target.name));
            }
        }
    }

    fn dwell(&mut self, seconds: f64, origin: &Origin) {
        let words = self.target.dwell;
        let places = self.measures.time;
        let Some(mut units) = places.units(seconds) else { return self.unprintable(origin) };
        if self.settings.dwell_unit().is_none() {
            return self.lacks_dwell_unit(origin);
        }
        if units == 0 && seconds > 0.0 {
            return self.wait_is_lost(seconds, origin);
        }
        if words.per_minute && self.modal.feed_kind_changes(FeedKind::PerMinute) {
            self.lines.words(self.target.feed.per_minute, origin);
            self.modal.forget_feed();
        }
        let most = places.units(words.most).unwrap_or(i64::MAX);
        loop {
            let part = units.min(most);
            if let Form::Dialog(dialog) = self.target.form {
                self.lines.words(dialog.dwell, origin);
            }
            self.lines.text.word(words.word);
            if matches!(self.target.form, Form::Dialog(_)) {
                self.lines.text.bare(part, places);
            } else if self.settings.waits_in_milliseconds() {
                self.lines.text.whole(words.address, part.unsigned_abs());
            } else {
                self.lines.text.number(words.address, part, places);
            }
            self.lines.end_line(origin);
            units -= part;
            if units <= 0 {
                return;
            }
        }
    }

    #[cold]
    fn optional_stop_is_idle(&self, origin: &Origin) {
        self.say(origin, codes::O9312::target_reads_optional_stop(&self.target.name));
    }

    fn m_function(&mut self, number: u32, origin: &Origin) {
        let words = &self.target.m;
        if !words.open {
            // No value of the key answers it: what stands in it has to go.
            let asking = codes::O9313::target_has_no_word_for_m_function(&self.target.name, &number);
            return self.deny(origin, asking.answers([]));
        }
        if let Some((_, does)) = words.own.iter().find(|(own, _)| *own == number) {
            self.say(origin, codes::O2001::m_is_printed_as_listed_in_pass(&number, &does));
        }
        self.lines.text.whole(words.address, u64::from(number));
        self.lines.end_line(origin);
    }

    fn work_offset(&mut self, number: u8, origin: &Origin) {
        if self.offset_is_tilted() {
            let fault = codes::O9343::work_offset_is_selected_in_plane(&self.target.name);
            return self.deny(origin, fault);
        }
        if !self.target.offsets_confirmed && !std::mem::replace(&mut self.doubted, true) {
            self.say(origin, codes::O2002::work_offsets_of_target_are_not_confirmed(&self.target.name));
        }
        match self.target.offset(number) {
            Some(word) => match self.target.form {
                Form::Words => {
                    if number > self.target.offsets_named {
                        self.say(origin, codes::O4003::work_offset_is_printed(&word));
                    }
                    self.lines.words(&word, origin);
                }
                Form::Dialog(dialog) => self.dialog_offset(dialog, number, &word, origin),
            },
            None => {
                // Every front end names its own word before.
                let name = &self.target.name;
                let fault = match self.target.offset_range() {
                    Some(range) => codes::O9310::target_has_no_word_for_this_work_offset(name, &range),
                    None => codes::O9310::target_has_no_word_for_any_work_offset(name),
                };
                self.deny(origin, fault);
            }
        }
        self.modal.forget_all();
    }

    /// `number` counts spindles from 1; targets count from 0.
    fn spindle(&mut self, spindle: Spindle, number: Option<u8>, origin: &Origin) {
        let words = &self.target.spindle;
        if number.is_none() {
            if words.speed_with_start && !self.with_start(spindle, origin) {
                return;
            }
            if self.said_by_tap(spindle) {
                return;
            }
            self.spindle_hears(spindle);
        }
        let said = match spindle {
            Spindle::Start(turn) => {
                let text = &mut self.lines.text;
                text.word(if turn == Turn::Clockwise { words.clockwise } else { words.counter_clockwise });
                if let Some(speed) = self.running.speed {
                    text.number(words.speed, speed, self.measures.speed);
                }
                true
            }
            Spindle::Stop => {
                self.lines.text.word(words.stop);
                true
            }
            Spindle::Speed(speed) => self.speed(speed, number, origin),
            Spindle::CuttingSpeed { speed, limit } => self.cutting_speed(speed, limit, number, origin),
            Spindle::Orient(angle) => self.orient(angle, origin),
        };
        if !said {
            return;
        }
        if let Some(number) = number {
            let Some(address) = words.other else {
                return self.deny(origin, codes::O9304::target_has_no_word_for_spindle(&self.target.name, &number));
            };
            self.lines.text.whole(address, u64::from(number.saturating_sub(1)));
        }
        self.lines.end_line(origin);
    }

    /// Is this the speed that the tap before said already?
    fn said_by_tap(&mut self, spindle: Spindle) -> bool {
        let by_tap = std::mem::take(&mut self.stated.by_tap);
        match spindle {
            Spindle::Speed(speed) if by_tap && !self.states_turns() => {
                self.stated.speed.is_some() && self.stated.speed == self.measures.speed.units(speed)
            }
            Spindle::Start(_)
            | Spindle::Stop
            | Spindle::Speed(_)
            | Spindle::CuttingSpeed { .. }
            | Spindle::Orient(_) => false,
        }
    }

    /// The next speed has to say that it counts turns.
    pub(super) fn states_turns(&self) -> bool {
        self.modal.cutting_speed && self.target.spindle.cutting_speed.is_some()
    }

    /// What the first spindle is told.
    fn spindle_hears(&mut self, spindle: Spindle) {
        match spindle {
            Spindle::Start(turn) => {
                self.spindle = HandChange::Turns;
                self.stated.turn = Some(turn);
            }
            Spindle::Stop | Spindle::Orient(_) => {
                self.spindle = HandChange::Stands;
                self.stated.turn = None;
            }
            Spindle::Speed(_) | Spindle::CuttingSpeed { .. } => self.stated.speed = None,
        }
    }

    /// The words of a speed; false where there are none, and that was said.
    fn speed(&mut self, speed: f64, number: Option<u8>, origin: &Origin) -> bool {
        let words = &self.target.spindle;
        let Some(units) = self.speed_units(speed, origin) else { return false };
        if number.is_none() {
            self.stated.speed = Some(units);
        }
        if let Some(cutting) = &words.cutting_speed
            && is_first(number)
            && std::mem::take(&mut self.modal.cutting_speed)
        {
            self.lines.text.word(cutting.off);
            self.modal.cuts_at_speed = false;
        }
        if let Form::Dialog(dialog) = self.target.form {
            self.modal.dialog.speed = Some(units);
            self.dialog_tool(dialog, None, origin);
        } else {
            self.lines.text.number(words.speed, units, self.measures.speed);
        }
        true
    }

    /// The same of a constant cutting speed.
    fn cutting_speed(&mut self, speed: f64, limit: Option<f64>, number: Option<u8>, origin: &Origin) -> bool {
        let words = &self.target.spindle;
        let Some(cutting) = &words.cutting_speed else {
            self.deny(origin, codes::O9302::target_has_no_word_for_constant_cutting(&self.target.name));
            return false;
        };
        if self.measures.inches || limit.is_none() && self.length.limited {
            self.lacks_cutting_speed(origin);
            return false;
        }
        if is_first(number) {
            (self.modal.cutting_speed, self.modal.cuts_at_speed) = (true, true);
        }
        let places = self.measures.speed;
        let Some(units) = self.speed_units(speed, origin) else { return false };
        let limit = match limit {
            Some(limit) => match self.speed_units(limit, origin) {
                Some(limit) => Some(limit),
                None => return false,
            },
            None => None,
        };
        let text = &mut self.lines.text;
        match (cutting.limit, limit) {
            (Limit::Word(word), Some(limit)) => {
                text.word(cutting.on).valued(word, limit, places);
            }
            (Limit::Block(word), Some(limit)) => {
                text.word(word).number(words.speed, limit, places);
                self.lines.end_line(origin);
                self.length.limited = true;
                self.lines.text.word(cutting.on);
            }
            (_, None) => drop(text.word(cutting.on)),
        }
        self.lines.text.number(words.speed, units, places);
        true
    }

    /// The same of a stop at an angle.
    fn orient(&mut self, angle: f64, origin: &Origin) -> bool {
        let Some((word, address)) = self.target.spindle.orient else {
            self.deny(origin, codes::O9303::target_has_no_word_for_spindle_stop(&self.target.name));
            return false;
        };
        let places = self.measures.angle;
        let Some(units) = places.units(angle) else {
            self.unprintable(origin);
            return false;
        };
        match address {
            Some(address) => drop(self.lines.text.word(word).number(address, units, places)),
            None => drop(self.lines.text.valued(word, units, places)),
        }
        true
    }

    /// A speed in printed units; reported where there is none. One that prints as zero would let the spindle stand.
    pub(super) fn speed_units(&mut self, speed: f64, origin: &Origin) -> Option<i64> {
        let Some(units) = self.measures.speed.units(speed) else {
            self.unprintable(origin);
            return None;
        };
        if units == 0 && speed != 0.0 {
            self.say(origin, codes::O1004::speed_prints_as_zero(&speed).answer(Answer::key("output", "decimals")));
            return None;
        }
        let exact = self.is_near("speed", speed, units, self.measures.speed, origin);
        exact.then_some(units)
    }

    /// Looks at a function of a spindle whose speed is a part of its start; false where nothing is left to print.
    fn with_start(&mut self, spindle: Spindle, origin: &Origin) -> bool {
        let turn = match spindle {
            Spindle::Start(turn) => turn,
            Spindle::Stop => {
                self.running.turn = None;
                return self.has_m(5, origin);
            }
            Spindle::Speed(speed) => {
                self.running.speed = self.speed_units(speed, origin);
                // The turning spindle is started again, at its new speed.
                if let (Some(turn), Some(_)) = (self.running.turn, self.running.speed) {
                    self.spindle(Spindle::Start(turn), None, origin);
                }
                return false;
            }
            Spindle::CuttingSpeed { .. } | Spindle::Orient(_) => return true,
        };
        self.running.turn = Some(turn);
        self.has_m(if turn == Turn::Clockwise { 3 } else { 4 }, origin)
    }

    #[cold]
    fn lacks_cutting_speed(&mut self, origin: &Origin) {
        let name = &self.target.name;
        let fault = if self.measures.inches {
            codes::O9319::target_has_no_word_for_cutting_speed_in_feet(name).answer(in_millimetres())
        } else {
            codes::O9323::target_has_no_word_for_constant_cutting(name)
        };
        self.deny(origin, fault);
    }

    fn comment(&mut self, text: &[u8], origin: &Origin) {
        let comments = &self.target.comments;
        for line in comment::lines(text, comments, self.comment_room()) {
            self.lines.text.raw(comments.open.as_bytes()).raw(&line).raw(comments.close.as_bytes());
            self.lines.end_line(origin);
        }
    }
}

/// Is it the first spindle, by its number or without one?
fn is_first(number: Option<u8>) -> bool {
    number.is_none_or(|number| number <= 1)
}
