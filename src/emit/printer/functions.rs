//! Lines of functions: tool, spindle, coolant, dwell, comments.

use crate::diag::codes;
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::{Function, Origin, Side};
use crate::machine::AxisSet;

use super::super::comment;
use super::Printer;

impl Printer<'_> {
    pub(super) fn print_function(&mut self, function: &Function, origin: &Origin) {
        if self.compensation.ends_before(function, self.plane, origin) {
            self.end_compensation(origin);
        }
        match function {
            Function::ToolChange { number } => {
                self.text.whole(b'T', u64::from(*number)).word(b"M6");
                self.end_line(origin);
                // The change may have moved any axis.
                self.stale = AxisSet::MAIN;
                if self.settings.tool_length && *number == 0 {
                    self.words(b"G49", origin);
                }
                if self.settings.tool_length && *number != 0 {
                    self.text.word(b"G43").whole(b'H', u64::from(*number));
                    self.end_line(origin);
                }
            }
            Function::ToolPrepare { number } => {
                self.text.whole(b'T', u64::from(*number));
                self.end_line(origin);
            }
            Function::Cutter(cutter) => self.compensation.cutter = *cutter,
            Function::Spindle(spindle) => self.spindle(*spindle, None, origin),
            Function::SpindleOf { number, spindle } => self.spindle(*spindle, Some(*number), origin),
            Function::Coolant(coolant) => {
                let word = match coolant {
                    Coolant::Mist => b"M7",
                    Coolant::Flood => b"M8",
                    Coolant::Off => b"M9",
                };
                self.words(word, origin);
            }
            Function::Dwell(seconds) => {
                let Some(units) = self.places.units(*seconds) else { return self.unprintable(origin) };
                self.text.word(b"G4").number(b'P', units, self.places);
                self.end_line(origin);
            }
            Function::Stop => {
                self.words(b"M0", origin);
                self.stale = AxisSet::MAIN;
            }
            Function::OptionalStop => {
                self.words(b"M1", origin);
                self.stale = AxisSet::MAIN;
            }
            Function::Aux(number) => {
                self.says_own_m(*number, origin);
                self.text.whole(b'M', u64::from(*number));
                self.end_line(origin);
            }
            Function::WorkOffset(number) => {
                const WORDS: [&[u8]; 9] =
                    [b"G54", b"G55", b"G56", b"G57", b"G58", b"G59", b"G59.1", b"G59.2", b"G59.3"];
                self.words(WORDS[usize::from(*number).clamp(1, 9) - 1], origin);
                self.known = AxisSet::EMPTY;
            }
            Function::Plane(plane) => self.select_plane(*plane, origin),
            Function::Comment(text) => self.comment(text, origin),
            Function::End { rewind } => {
                if self.compensation.side != Side::None {
                    self.end_compensation(origin);
                }
                self.words(if *rewind { b"M30" } else { b"M2" }, origin);
                self.ended = true;
            }
        }
    }

    /// Warns of an M function that is printed as listed and that the target takes for one of its own.
    fn says_own_m(&self, number: u32, origin: &Origin) {
        let Some((_, does)) = self.traits.own_m.iter().find(|(own, _)| *own == number) else { return };
        self.report(
            codes::O2001,
            origin,
            &format!("M{number} is printed as listed in `pass_m`; on the target it {does}"),
        );
    }

    /// `number` counts spindles from 1; targets count from 0.
    fn spindle(&mut self, spindle: Spindle, number: Option<u8>, origin: &Origin) {
        match spindle {
            Spindle::Start(Turn::Clockwise) => self.text.word(b"M3"),
            Spindle::Start(Turn::CounterClockwise) => self.text.word(b"M4"),
            Spindle::Stop => self.text.word(b"M5"),
            Spindle::Speed(speed) => {
                let Some(units) = self.places.units(speed) else { return self.unprintable(origin) };
                if number.is_none() && std::mem::take(&mut self.constant_cut) {
                    self.text.word(b"G97");
                }
                self.text.number(b'S', units, self.places)
            }
            Spindle::CuttingSpeed { speed, limit } => {
                self.constant_cut = true;
                self.text.word(b"G96");
                if let Some(units) = limit.and_then(|limit| self.places.units(limit)) {
                    self.text.number(b'D', units, self.places);
                }
                let Some(units) = self.places.units(speed) else { return self.unprintable(origin) };
                self.text.number(b'S', units, self.places)
            }
            Spindle::Orient(angle) => {
                let Some(units) = self.places.units(angle) else { return self.unprintable(origin) };
                self.text.word(b"M19").number(b'R', units, self.places)
            }
        };
        if let Some(number) = number {
            self.text.whole(b'$', u64::from(number.saturating_sub(1)));
        }
        self.end_line(origin);
    }

    fn comment(&mut self, text: &[u8], origin: &Origin) {
        let (open, close) = self.traits.comment;
        let text = comment::harmless(text);
        let room = self.traits.line_length - open.len() - close.len();
        for piece in comment::pieces(&text, room) {
            self.text.raw(open.as_bytes()).raw(piece).raw(close.as_bytes());
            self.end_line(origin);
        }
    }
}
