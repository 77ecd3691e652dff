//! A hole that is tapped without a compensating chuck: axis and spindle go in step all the time, the turn at the bottom
//! included.
//!
//! Both streams carry it as one item, for most targets have a word of their own for the whole of it. Who looks at moves only
//! takes its [`parts`](Tap::parts): the same way as lines in step with the spindle, and what the spindle does between them.

use core::fmt;

use crate::machine::Axis;

use super::function::{Function, Spindle, Turn};

/// A rigid tap. The tool stands at `start` of `axis`, over the hole, and no other axis moves. Coordinates and lengths
/// in mm; [`Tap::check`] holds for what is in a stream.
///
/// The tap starts the spindle by itself, and after it the spindle stands, or turns as the target leaves it: the
/// producer sends the state of the spindle, and its speed where `speed_in` or `speed_out` is given, before the next
/// move.
#[derive(Debug, Clone, PartialEq)]
pub struct Tap {
    /// The tool axis: it alone moves, in step with the spindle.
    pub axis: Axis,
    /// Coordinate along `axis` where it begins.
    pub start: f64,
    /// Coordinate of the surface of the workpiece, from which depths count; it lies between `start` and the first
    /// depth, or at `start`.
    pub surface: f64,
    /// One at least; the last one ends the hole.
    pub strokes: Vec<Stroke>,
    /// mm per turn, over 0; the hand of the thread is in `turn`.
    pub lead: f64,
    /// Sense of the spindle on the way in; out is the other one.
    pub turn: Turn,
    /// Speed on the way in, rev/min, over 0; `None` for the one in force.
    pub speed_in: Option<f64>,
    /// Speed on the way out, rev/min, over 0; `None` for that of the way in.
    pub speed_out: Option<f64>,
    /// Angle in degrees at which the spindle stops before the tap; `None` where it stops nowhere.
    pub orient: Option<f64>,
    /// Seconds between two strokes, 0 or more.
    pub pause: f64,
    /// Down through the thread that is cut, to so many mm above the last depth, 0 or more, it goes at the speed of the
    /// way out; `None`: at that of the way in.
    pub again: Option<f64>,
}

/// In to a depth and back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Coordinate of the depth.
    pub to: f64,
    /// Coordinate to which it comes back: in the hole to break the chip, or out of it.
    pub back: f64,
    /// Seconds at the depth, the spindle standing; 0 or more.
    pub dwell: f64,
}

/// What a tap does, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Part {
    /// The spindle is told its angle, speed or sense.
    Spindle(Spindle),
    /// Wait, seconds, over 0.
    Dwell(f64),
    /// In step with the spindle to this coordinate of the axis.
    To(f64),
}

/// Why something is no tap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TapFault {
    /// A coordinate or the angle is no finite number.
    Number,
    /// The lead is not over 0.
    Lead,
    /// A speed is not over 0.
    Speed,
    /// A dwell, a pause or the distance of [`Tap::again`] is negative.
    Dwell,
    /// There is no stroke, or one leads not in, or not back.
    Stroke,
}

impl fmt::Display for TapFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            TapFault::Number => "a height of the tapped hole is not a number",
            TapFault::Lead => "the pitch must be over 0",
            TapFault::Speed => "the spindle speed must be over 0",
            TapFault::Dwell => "the dwell time must not be negative",
            TapFault::Stroke => "the tap does not go in, or not out again",
        })
    }
}

impl Tap {
    /// Coordinate where it ends.
    pub fn end(&self) -> f64 {
        self.strokes.last().map_or(self.start, |stroke| stroke.back)
    }

    /// Coordinate of the last depth.
    pub fn bottom(&self) -> f64 {
        self.strokes.last().map_or(self.start, |stroke| stroke.to)
    }

    /// Direction out of the hole along the axis: 1 or -1.
    pub fn outward(&self) -> f64 {
        if self.start >= self.bottom() { 1.0 } else { -1.0 }
    }

    /// Speed of the way out as a part of that in.
    pub fn factor(&self) -> f64 {
        match (self.speed_in, self.speed_out) {
            (Some(speed_in), Some(speed_out)) => speed_out / speed_in,
            _ => 1.0,
        }
    }

    /// Turns of the spindle from the start to the farthest depth.
    pub fn turns(&self) -> f64 {
        self.strokes.iter().map(|stroke| (self.start - stroke.to).abs() / self.lead).fold(0.0, f64::max)
    }

    /// # Errors
    /// What is wrong with it.
    pub fn check(&self) -> Result<(), TapFault> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let seconds = |value: f64| value >= 0.0 && value.is_finite();
        let heights = self.strokes.iter().flat_map(|stroke| [stroke.to, stroke.back]);
        if !heights.chain([self.start, self.surface, self.orient.unwrap_or(0.0)]).all(f64::is_finite) {
            return Err(TapFault::Number);
        }
        if !positive(self.lead) {
            return Err(TapFault::Lead);
        }
        if ![self.speed_in, self.speed_out].into_iter().flatten().all(positive) {
            return Err(TapFault::Speed);
        }
        if !(self.strokes.iter().all(|stroke| seconds(stroke.dwell))
            && seconds(self.pause)
            && seconds(self.again.unwrap_or(0.0)))
        {
            return Err(TapFault::Dwell);
        }
        let (out, mut at) = (self.outward(), self.start);
        let mut leads = !self.strokes.is_empty();
        for stroke in &self.strokes {
            leads &= (at - stroke.to) * out > 0.0 && (stroke.back - stroke.to) * out > 0.0;
            at = stroke.back;
        }
        if leads { Ok(()) } else { Err(TapFault::Stroke) }
    }

    /// Coordinate above the depth of the stroke before where the speed of the way in begins; `None` where all of the
    /// stroke, counted from 0, has that speed.
    pub fn resumes(&self, stroke: usize) -> Option<f64> {
        let ahead = self.again.filter(|_| self.speed_out.is_some() && self.speed_out != self.speed_in)?;
        let last = self.strokes.get(stroke.checked_sub(1)?)?;
        let to = last.to + ahead * self.outward();
        ((last.back - to) * self.outward() > 0.0).then_some(to)
    }

    /// What it does, as lines in step with the spindle and what happens between them.
    pub fn parts(&self, take: &mut dyn FnMut(Part)) {
        if let Some(angle) = self.orient {
            take(Part::Spindle(Spindle::Orient(angle)));
        }
        let turn = |turn: Turn, speed: Option<f64>, take: &mut dyn FnMut(Part)| {
            if let Some(speed) = speed {
                take(Part::Spindle(Spindle::Speed(speed)));
            }
            take(Part::Spindle(Spindle::Start(turn)));
        };
        let out = self.speed_out.or(self.speed_in);
        let wait = |seconds: f64, take: &mut dyn FnMut(Part)| {
            if seconds > 0.0 {
                take(Part::Dwell(seconds));
            }
        };
        for (at, stroke) in self.strokes.iter().enumerate() {
            if at > 0 {
                wait(self.pause, take);
            }
            if let Some(to) = self.resumes(at) {
                turn(self.turn, out, take);
                take(Part::To(to));
            }
            turn(self.turn, self.speed_in, take);
            take(Part::To(stroke.to));
            wait(stroke.dwell, take);
            turn(self.turn.reversed(), out, take);
            take(Part::To(stroke.back));
        }
    }
}

impl Part {
    /// The function of a part that is no move.
    pub fn function(self) -> Option<Function> {
        match self {
            Part::Spindle(spindle) => Some(Function::Spindle(spindle)),
            Part::Dwell(seconds) => Some(Function::Dwell(seconds)),
            Part::To(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// M10 from Z2 to Z-20 in two strokes, 0.3 mm back between them, out at twice the speed.
    fn tap() -> Tap {
        Tap {
            axis: Axis::Z,
            start: 2.0,
            surface: 0.0,
            strokes: vec![Stroke { to: -10.0, back: -9.7, dwell: 0.0 }, Stroke { to: -20.0, back: 2.0, dwell: 0.0 }],
            lead: 1.5,
            turn: Turn::Clockwise,
            speed_in: Some(300.0),
            speed_out: Some(600.0),
            orient: None,
            pause: 0.0,
            again: None,
        }
    }

    #[test]
    fn parts_go_in_one_way_and_out_the_other_at_their_speeds() {
        let mut parts = Vec::new();
        tap().parts(&mut |part| parts.push(part));
        let turn = |speed, turn| [Part::Spindle(Spindle::Speed(speed)), Part::Spindle(Spindle::Start(turn))];
        let (right, left) = (turn(300.0, Turn::Clockwise), turn(600.0, Turn::CounterClockwise));
        let stroke = |to, back| [&right[..], &[Part::To(to)], &left[..], &[Part::To(back)]].concat();
        assert_eq!(parts, [stroke(-10.0, -9.7), stroke(-20.0, 2.0)].concat());
    }

    #[test]
    fn a_removed_chip_lets_the_tap_go_down_again_at_the_speed_of_the_way_out() {
        let strokes = vec![Stroke { to: -10.0, back: 2.0, dwell: 0.0 }, Stroke { to: -20.0, back: 2.0, dwell: 0.0 }];
        let tap = Tap { strokes, again: Some(1.0), ..tap() };
        assert_eq!([tap.resumes(0), tap.resumes(1)], [None, Some(-9.0)]);
        assert_eq!(Tap { speed_out: Some(300.0), ..tap }.resumes(1), None);
    }

    #[test]
    fn what_is_no_tap_is_told() {
        let stroke = |to, back| Tap { strokes: vec![Stroke { to, back, dwell: 0.0 }], ..tap() };
        assert_eq!(tap().check(), Ok(()));
        assert_eq!(stroke(-10.0, -10.0).check(), Err(TapFault::Stroke));
        assert_eq!(stroke(2.0, 3.0).check(), Err(TapFault::Stroke));
        assert_eq!(Tap { strokes: Vec::new(), ..tap() }.check(), Err(TapFault::Stroke));
        assert_eq!(stroke(f64::NAN, 2.0).check(), Err(TapFault::Number));
        assert_eq!(Tap { lead: 0.0, ..tap() }.check(), Err(TapFault::Lead));
        assert_eq!(Tap { speed_out: Some(0.0), ..tap() }.check(), Err(TapFault::Speed));
        assert_eq!(Tap { pause: -1.0, ..tap() }.check(), Err(TapFault::Dwell));
    }
}
