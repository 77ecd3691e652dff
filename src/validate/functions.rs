//! Functions: tool, spindle, coolant, dwell, stops, offsets.

use crate::ir::Function;
use crate::ir::function::{Coolant, PathControl, Spindle, Turn};
use crate::read::{Act, PathControl as path, SCALE, Speed};

use super::{MAIN, Running, TIE, Text, Validator, Why, is_rounding, plane};

/// Acts of a function, but for a dwell.
const MOST: usize = 3;

impl Validator {
    /// Is the text what this function asks for?
    pub(super) fn check_function(&mut self, function: &Function, text: Text<'_>) -> Result<(), Why> {
        if let Function::Dwell(seconds) = function {
            return self.dwells(*seconds, text);
        }
        if let Function::End { rewind } = function {
            return self.ends(*rewind, text);
        }
        let mut list = [Act::Change; MOST];
        let mut count = 0;
        let Text { bytes: mut rest, mut end } = text;
        while let Some(act) = self.reader.next(&mut rest, &mut end)? {
            *list.get_mut(count).ok_or_else(|| Why::new("something happens that is not meant"))? = act;
            count += 1;
        }
        if self.is_function(function, &list[..count], text) {
            Ok(())
        } else {
            Err(Why::new("another function is meant"))
        }
    }

    fn is_function(&mut self, function: &Function, acts: &[Act], text: Text<'_>) -> bool {
        match function {
            Function::ToolChange { number } => self.is_change(*number, acts, text),
            Function::ToolPrepare { number } => *acts == [Act::Select(*number)],
            Function::Cutter(cutter) => {
                self.cutter = *cutter;
                acts.is_empty()
            }
            Function::Spindle(spindle) => self.is_spindle(*spindle, None, acts),
            Function::SpindleOf { number, spindle } => self.is_spindle(*spindle, Some(*number), acts),
            Function::Coolant(coolant) => {
                self.running.coolant = !matches!(coolant, Coolant::Off);
                let number = match coolant {
                    Coolant::Mist => 7,
                    Coolant::Flood => 8,
                    Coolant::Off => 9,
                };
                *acts == [m(number)]
            }
            Function::Stop => self.stops(0, acts),
            Function::OptionalStop => self.stops(1, acts),
            Function::Aux(number) => match acts {
                [Act::M { number: read, .. }] => read == number,
                // What the control counts among its own.
                [Act::Change] => *number == 6,
                _ => false,
            },
            Function::WorkOffset(number) => {
                self.stated = 0;
                *acts == [Act::Offset(*number)]
            }
            Function::Plane(meant) => {
                acts.is_empty() && (self.plane.is_none() || self.reader.modes().plane == Some(plane(*meant)))
            }
            Function::Tilt(tilting) => self.is_tilt(tilting, acts),
            Function::PathControl(said) => {
                self.corners = self.output.path_control(*said, self.lathe).or(self.corners);
                acts.iter().all(|act| matches!(act, Act::Corners(_))) && acts.len() < 2 && self.takes_corners()
            }
            Function::Comment(_) | Function::Remark(_) | Function::FeedSpindle(_) | Function::Transformation(_) => {
                acts.is_empty()
            }
            Function::Dwell(_) | Function::End { .. } => false,
        }
    }

    /// Are corners taken as they are meant? A bound is printed without what is behind its last place, and never as nothing.
    pub(super) fn takes_corners(&self) -> bool {
        let is_bound = |read: i64, meant: f64| {
            let (meant, read) = (meant * SCALE as f64, read as f64);
            let slack = TIE + meant * 1e-9;
            read <= (meant + slack).max(self.bound_unit + slack) && read > meant - self.bound_unit - slack
        };
        match (self.reader.modes().corners, self.corners) {
            (read, None) => read.is_none(),
            (Some(path::Exact), Some(PathControl::Exact)) => true,
            (Some(path::Unbounded), Some(PathControl::Unbounded)) => true,
            (Some(path::Within(read)), Some(PathControl::Within(meant))) => is_bound(read, meant),
            (Some(path::Before(read)), Some(PathControl::Before(meant))) => is_bound(read, meant),
            (_, Some(_)) => false,
        }
    }

    fn is_change(&mut self, number: u32, acts: &[Act], text: Text<'_>) -> bool {
        self.stated &= !MAIN;
        let changed = if self.by_hand {
            self.running.turn = None;
            let text = &text.bytes[..text.end];
            let what = if number == 0 { "take the tool out".to_owned() } else { format!("change to tool {number}") };
            let (open, close) = self.brackets;
            let told = format!("{open}{what}{close}\n").into_bytes();
            let text = text.to_ascii_lowercase();
            *acts == [m(5), m(0)] && text.windows(told.len()).any(|part| part == told)
        } else {
            *acts == [Act::Select(number), Act::Change]
        };
        self.tilts.tool = number;
        if self.length_with_move {
            self.length = (number != 0).then_some(number);
            return changed && (number != 0 || self.reader.modes().length == Some(0));
        }
        changed && (!self.tool_length || self.reader.modes().length == Some(number))
    }

    /// A speed with the start that it belongs to, or a start with the last speed.
    fn starts(&mut self, spindle: Spindle, acts: &[Act]) -> bool {
        match spindle {
            Spindle::Start(Turn::Clockwise) => self.running.turn = Some(3),
            Spindle::Start(Turn::CounterClockwise) => self.running.turn = Some(4),
            Spindle::Stop => {
                self.running.turn = None;
                return *acts == [m(5)];
            }
            Spindle::Speed(speed) => {
                self.running.speed = Some(speed);
                if self.running.turn.is_none() {
                    return acts.is_empty();
                }
            }
            Spindle::CuttingSpeed { .. } | Spindle::Orient(_) => return false,
        }
        let Running { speed, turn, .. } = self.running;
        match (acts, speed, turn) {
            ([Act::Speed(Speed { spindle: 0, value, constant_cut: None }), start], Some(speed), Some(turn)) => {
                *start == m(turn) && self.is_speed(*value, speed)
            }
            ([start], None, Some(turn)) => *start == m(turn),
            _ => false,
        }
    }

    fn is_spindle(&mut self, spindle: Spindle, number: Option<u8>, acts: &[Act]) -> bool {
        if self.with_start && number.is_none() {
            return self.starts(spindle, acts);
        }
        let own = number.map_or(0, |number| number.saturating_sub(1));
        let turns = |m: u32| *acts == [Act::M { number: m, spindle: own, angle: None }];
        match spindle {
            Spindle::Start(Turn::Clockwise) => turns(3),
            Spindle::Start(Turn::CounterClockwise) => turns(4),
            Spindle::Stop => turns(5),
            Spindle::Speed(meant) => match acts {
                // A tap said it.
                [] => own == 0 && self.reader.tapped_speed().is_some_and(|said| self.is_speed(said, meant)),
                [Act::Speed(Speed { spindle, value, constant_cut: None })] => {
                    let ended = own != 0
                        || match self.reader.modes().constant_cut {
                            Some(on) => !on,
                            None => !self.states_speed,
                        };
                    *spindle == own && ended && self.is_speed(*value, meant)
                }
                _ => false,
            },
            Spindle::CuttingSpeed { speed, limit } => match acts {
                [Act::Speed(Speed { spindle, value, constant_cut: Some(read) })] => {
                    let limited = match (*read, limit) {
                        (Some(read), Some(limit)) => self.is_speed(read, limit),
                        (read, limit) => read.is_none() && limit.is_none(),
                    };
                    *spindle == own && limited && self.is_speed(*value, speed)
                }
                _ => false,
            },
            Spindle::Orient(meant) => match acts {
                [Act::M { number: 19, spindle, angle: Some(angle) }] => {
                    *spindle == own && is_rounding(*angle, meant, self.grain.angle)
                }
                _ => false,
            },
        }
    }

    fn is_speed(&self, read: i64, meant: f64) -> bool {
        is_rounding(read, meant, self.grain.speed)
    }

    /// Somebody may move axes while the program waits.
    fn stops(&mut self, number: u32, acts: &[Act]) -> bool {
        self.stated &= !MAIN;
        *acts == [m(number)]
    }

    /// One wait or several that make the same time.
    fn dwells(&mut self, seconds: f64, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        let (mut sum, mut any) = (0i64, false);
        while let Some(act) = self.reader.next(&mut rest, &mut end)? {
            let Act::Dwell(part) = act else { return Err(Why::new("a dwell is meant")) };
            sum = sum.saturating_add(part);
            any = true;
        }
        if self.reader.feed().is_none() {
            self.feed = None;
        }
        if any && is_rounding(sum, seconds, self.grain.time) { Ok(()) } else { Err(Why::new("another dwell is meant")) }
    }

    /// The end of the program.
    pub(super) fn ends(&mut self, rewind: bool, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        self.ended = true;
        if self.ends_with_text {
            return self.runs_out(text);
        }
        let act = self.reader.next(&mut rest, &mut end)?;
        if act != Some(m(if rewind { 30 } else { 2 })) {
            return Err(Why::new("the end of the program is meant"));
        }
        self.no_act(Text { bytes: rest, end })
    }
}

impl Validator {
    /// An end without a word: what runs is stopped, and nothing else happens.
    fn runs_out(&mut self, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        let Running { turn, coolant, .. } = self.running;
        for number in [turn.map(|_| 5), coolant.then_some(9)].into_iter().flatten() {
            if self.reader.next(&mut rest, &mut end)? != Some(m(number)) {
                return Err(Why::new("spindle or coolant go on after the end"));
            }
        }
        self.no_act(Text { bytes: rest, end })
    }
}

fn m(number: u32) -> Act {
    Act::M { number, spindle: 0, angle: None }
}
