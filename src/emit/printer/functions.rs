//! Lines of functions: tool, spindle, coolant, dwell, comments.

use crate::diag::{Code, Diagnostic, codes};
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::{Function, Origin, Side};

use super::super::comment;
use super::Printer;

impl Printer<'_> {
    pub(super) fn print_function(&mut self, function: &Function, origin: &Origin) {
        if self.compensation.ends_before(function, self.modal.plane, origin) {
            self.end_compensation(origin);
        }
        let flow = &self.target.flow;
        match function {
            Function::ToolChange { number } => self.tool_change(*number, origin),
            Function::ToolPrepare { number } => {
                self.page.text.whole(self.target.tool.address, u64::from(*number));
                self.page.end_line(origin);
            }
            Function::Cutter(cutter) => self.compensation.cutter = *cutter,
            Function::Spindle(spindle) => self.spindle(*spindle, None, origin),
            Function::SpindleOf { number, spindle } => self.spindle(*spindle, Some(*number), origin),
            Function::Coolant(coolant) => self.coolant(*coolant, origin),
            Function::Dwell(seconds) => self.dwell(*seconds, origin),
            Function::Stop => {
                self.page.words(flow.stop, origin);
                self.modal.may_have_moved();
            }
            Function::OptionalStop => {
                self.page.words(flow.optional_stop, origin);
                self.modal.may_have_moved();
            }
            Function::Aux(number) => self.m_function(*number, origin),
            Function::WorkOffset(number) => self.work_offset(*number, origin),
            Function::Plane(plane) => self.select_plane(*plane, origin),
            Function::Comment(text) => self.comment(text, origin),
            Function::End { rewind } => {
                if self.compensation.side != Side::None {
                    self.end_compensation(origin);
                }
                self.page.words(if *rewind { flow.rewind } else { flow.end }, origin);
                self.ended = true;
            }
        }
    }

    /// Refuses what the target has no word for.
    #[cold]
    pub(super) fn lacks(&mut self, code: &'static Code, origin: &Origin, what: &str) {
        self.page.text.drop_line();
        let message = format!("the target {} has no word for {what}", self.target.name);
        self.diags.push(Diagnostic::new(code, origin.loc, message).called(origin.call));
    }

    fn tool_change(&mut self, number: u32, origin: &Origin) {
        let words = &self.target.tool;
        let Some(change) = words.change else { return self.lacks(codes::O9001, origin, "a tool change") };
        self.page.text.whole(words.address, u64::from(number)).word(change);
        self.page.end_line(origin);
        // The change may have moved any axis.
        self.modal.may_have_moved();
        if !self.settings.tool_length {
            return;
        }
        let Some(length) = &words.length else { return self.lacks(codes::O9001, origin, "the length of a tool") };
        if number == 0 {
            self.page.words(length.off, origin);
        } else {
            self.page.text.word(length.on).whole(length.number, u64::from(number));
            self.page.end_line(origin);
        }
    }

    fn coolant(&mut self, coolant: Coolant, origin: &Origin) {
        let words = &self.target.coolant;
        let word = match coolant {
            Coolant::Mist => words.mist,
            Coolant::Flood => Some(words.flood),
            Coolant::Off => Some(words.off),
        };
        match word {
            Some(word) => self.page.words(word, origin),
            None => self.lacks(codes::O9001, origin, "mist"),
        }
    }

    fn dwell(&mut self, seconds: f64, origin: &Origin) {
        let words = &self.target.dwell;
        let Some(mut units) = self.places.units(seconds) else { return self.unprintable(origin) };
        let most = self.places.units(words.most).unwrap_or(i64::MAX);
        while units > most {
            self.page.text.word(words.word).number(words.seconds, most, self.places);
            self.page.end_line(origin);
            units -= most;
        }
        self.page.text.word(words.word).number(words.seconds, units, self.places);
        self.page.end_line(origin);
    }

    fn m_function(&mut self, number: u32, origin: &Origin) {
        let words = &self.target.m;
        if let Some((_, does)) = words.own.iter().find(|(own, _)| *own == number) {
            self.report(
                codes::O2001,
                origin,
                &format!("M{number} is printed as listed in `pass_m`; on the target it {does}"),
            );
        }
        self.page.text.whole(words.address, u64::from(number));
        self.page.end_line(origin);
    }

    fn work_offset(&mut self, number: u8, origin: &Origin) {
        match self.target.offsets.get(usize::from(number.clamp(1, 9)) - 1) {
            Some(word) => self.page.words(word, origin),
            None => return self.lacks(codes::O9001, origin, "this work offset"),
        }
        self.modal.forget_all();
    }

    /// `number` counts spindles from 1; targets count from 0.
    fn spindle(&mut self, spindle: Spindle, number: Option<u8>, origin: &Origin) {
        let words = &self.target.spindle;
        let text = &mut self.page.text;
        match spindle {
            Spindle::Start(Turn::Clockwise) => text.word(words.clockwise),
            Spindle::Start(Turn::CounterClockwise) => text.word(words.counter_clockwise),
            Spindle::Stop => text.word(words.stop),
            Spindle::Speed(speed) => {
                let Some(units) = self.places.units(speed) else { return self.unprintable(origin) };
                if let Some(cutting) = &words.cutting_speed
                    && number.is_none()
                    && std::mem::take(&mut self.modal.cutting_speed)
                {
                    text.word(cutting.off);
                }
                text.number(words.speed, units, self.places)
            }
            Spindle::CuttingSpeed { speed, limit } => {
                let Some(cutting) = &words.cutting_speed else {
                    return self.lacks(codes::O9001, origin, "constant cutting speed");
                };
                self.modal.cutting_speed = true;
                text.word(cutting.on);
                if let Some(units) = limit.and_then(|limit| self.places.units(limit)) {
                    text.number(cutting.limit, units, self.places);
                }
                let Some(units) = self.places.units(speed) else { return self.unprintable(origin) };
                text.number(words.speed, units, self.places)
            }
            Spindle::Orient(angle) => {
                let Some((word, address)) = words.orient else {
                    return self.lacks(codes::O9001, origin, "a spindle stop at an angle");
                };
                let Some(units) = self.places.units(angle) else { return self.unprintable(origin) };
                text.word(word).number(address, units, self.places)
            }
        };
        if let Some(number) = number {
            let Some(address) = words.other else { return self.lacks(codes::O9001, origin, "another spindle") };
            self.page.text.whole(address, u64::from(number.saturating_sub(1)));
        }
        self.page.end_line(origin);
    }

    fn comment(&mut self, text: &[u8], origin: &Origin) {
        let comments = &self.target.comments;
        let text = comment::harmless(text, comments.forbidden);
        let room = self.target.line.length - comments.open.len() - comments.close.len();
        for piece in comment::pieces(&text, room) {
            self.page.text.raw(comments.open.as_bytes()).raw(piece).raw(comments.close.as_bytes());
            self.page.end_line(origin);
        }
    }
}
