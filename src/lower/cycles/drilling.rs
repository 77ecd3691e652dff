//! Drilling, boring and tapping become moves of the drilling axis.

use crate::diag::codes;
use crate::ir::contour::{Coords, Move, Path, Thread};
use crate::ir::cycle::drilling::{
    Bore, Breaks, Chip, DeepHole, Degression, Drilling, DrillingFault, Levels, MOST_PECKS, Method, Peck, Removal, Tap,
};
use crate::ir::function::{Spindle, Turn};
use crate::ir::{Feed, Function, Pos, Side};
use crate::machine::Axis;

use super::track::Failure;

/// What a cycle outside the turning plane is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    Move(Move),
    Function(Function),
}

/// Depth up to which the rapid way back into a hole ends `NEAR` above its bottom, and what it is below.
const SHALLOW: f64 = 30.0;
const NEAR: f64 = 0.6;
const SHARE: f64 = 50.0;
const FURTHEST: f64 = 7.0;

/// Sends the parts of a hole at `start`.
///
/// # Errors
/// G3041 for arguments that make no hole, G3040 for steps without end.
pub fn expand(drilling: &Drilling, start: &Pos, axes: [Axis; 3], out: &mut dyn FnMut(Part)) -> Result<(), Failure> {
    drilling.check().map_err(fault)?;
    let levels = &drilling.levels;
    if levels.outward() == 0.0 {
        // The standard cycles drill nothing where depth and surface are the same.
        return Ok(());
    }
    // All depths are known before the tool moves.
    let depths = match &drilling.method {
        Method::Deep(deep) => deep_steps(levels, deep).map_err(fault)?,
        Method::Peck(peck) => depths(levels, peck.first, peck.degression).map_err(fault)?,
        Method::Tap(Tap { step: Some(step), .. }) => {
            depths(levels, step.way.min(levels.way()), Degression::Even { least: step.way }).map_err(fault)?
        }
        _ => vec![levels.depth],
    };
    let mut hole = Hole { drilling, levels, out };
    hole.rapid(levels.start_plane());
    match &drilling.method {
        Method::Drill { dwell } => {
            hole.cut(levels.depth, drilling.feed);
            hole.dwell(*dwell);
        }
        Method::Peck(peck) => hole.peck(peck, &depths),
        Method::Deep(deep) => hole.deep(deep, &depths),
        Method::Tap(tap) => hole.tap(tap, &depths),
        Method::Ream { dwell, back } => {
            hole.cut(levels.depth, drilling.feed);
            hole.dwell(*dwell);
            hole.cut(levels.start_plane(), *back);
        }
        Method::Bore(bore) => return hole.bore(bore, start, axes),
        Method::BoreWithStop { dwell, turn } => {
            hole.cut(levels.depth, drilling.feed);
            hole.dwell(*dwell);
            hole.spindle(Spindle::Stop);
            (hole.out)(Part::Function(Function::Stop));
            hole.rapid(levels.retract);
            hole.spindle(Spindle::Start(*turn));
            return Ok(());
        }
    }
    hole.rapid(levels.retract);
    Ok(())
}

fn fault(fault: DrillingFault) -> Failure {
    match fault {
        DrillingFault::TooManyPecks => {
            Failure::new(codes::G3040, fault.to_string(), "give a least step, or larger steps")
        }
        _ => Failure::new(codes::G3041, fault.to_string(), "check the data of the drilling cycle"),
    }
}

/// Depths of the steps, the last one at the bottom. The last two are made alike where the rest would be shorter
/// than the least step (standard cycle CYCLE83, V06.02.09).
///
/// # Errors
/// `TooManyPecks`.
pub fn depths(levels: &Levels, first: f64, degression: Degression) -> Result<Vec<f64>, DrillingFault> {
    let total = levels.way();
    let mut step = first.min(total);
    let mut done = step;
    let mut list = Vec::new();
    while done < total {
        list.push(done);
        if list.len() >= MOST_PECKS {
            return Err(DrillingFault::TooManyPecks);
        }
        let rest = total - done;
        let next = match degression {
            Degression::Factor { factor, least } => {
                step = (step * factor).max(least);
                let next = done + step;
                if next > total + NOTHING {
                    total
                } else if (total - next).max(0.0) < least {
                    done + rest / 2.0
                } else {
                    next
                }
            }
            Degression::Plain { less, least } => {
                step = (step - less).max(least);
                if done + step + NOTHING >= total { total } else { done + step }
            }
            Degression::Even { .. } if done + step >= total => total,
            Degression::Even { least } if total - (done + step) < least => done + rest / 2.0,
            Degression::Even { .. } => done + step,
            Degression::Amount(amount) => {
                step = (step - amount).max(amount);
                let whole = rest - step >= amount;
                match (whole, rest > 2.0 * amount) {
                    (true, true) => done + step,
                    (true, false) if rest > amount => done + rest / 2.0,
                    (false, true) if rest > step => total - amount,
                    (false, false) if rest > step => done + rest / 2.0,
                    _ => total,
                }
            }
        };
        if next <= done {
            return Err(DrillingFault::TooManyPecks);
        }
        done = next;
    }
    list.push(total);
    let out = levels.outward();
    // The bottom is the programmed number, not a sum.
    Ok(list.into_iter().map(|way| if way >= total { levels.depth } else { levels.reference - way * out }).collect())
}

/// Rest of a hole that is no step of its own: the error of the sum of the steps before.
const NOTHING: f64 = 1e-9;

/// Depths of the steps of a deep hole, the last one at the bottom.
///
/// # Errors
/// `TooManyPecks`.
fn deep_steps(levels: &Levels, deep: &DeepHole) -> Result<Vec<f64>, DrillingFault> {
    let (total, out) = (levels.way(), levels.outward());
    if matches!(deep.breaks, Breaks::Every(way) if total / way > MOST_PECKS as f64) {
        return Err(DrillingFault::TooManyPecks);
    }
    let mut step = deep.first;
    let mut done = step;
    let mut list = Vec::new();
    while total - done > NOTHING {
        list.push(levels.reference - done * out);
        if deep.less > 0.0 {
            step = (step - deep.less).max(deep.least);
        }
        if step <= NOTHING || list.len() >= MOST_PECKS {
            return Err(DrillingFault::TooManyPecks);
        }
        done += step;
    }
    list.push(levels.depth);
    Ok(list)
}

struct Hole<'a> {
    drilling: &'a Drilling,
    levels: &'a Levels,
    out: &'a mut dyn FnMut(Part),
}

impl Hole<'_> {
    fn send(&mut self, end: Pos, path: Path) {
        (self.out)(Part::Move(Move { end, path, side: Side::None, coords: Coords::Frame }));
    }

    fn height(&self, to: f64) -> Pos {
        let mut end = Pos::UNKNOWN;
        end.set(self.drilling.axis, to);
        end
    }

    fn rapid(&mut self, to: f64) {
        self.send(self.height(to), Path::Rapid);
    }

    fn cut(&mut self, to: f64, feed: Feed) {
        self.send(self.height(to), Path::Line(feed));
    }

    fn dwell(&mut self, seconds: f64) {
        if seconds > 0.0 {
            (self.out)(Part::Function(Function::Dwell(seconds)));
        }
    }

    fn spindle(&mut self, spindle: Spindle) {
        (self.out)(Part::Function(Function::Spindle(spindle)));
    }

    fn peck(&mut self, peck: &Peck, depths: &[f64]) {
        let out = self.levels.outward();
        let feed = self.drilling.feed;
        for (i, depth) in depths.iter().enumerate() {
            let last = i + 1 == depths.len();
            self.cut(*depth, if i == 0 { feed.with_value(feed.value() * peck.first_feed) } else { feed });
            self.dwell(if last { peck.dwell_at_bottom } else { peck.dwell });
            match peck.removal {
                _ if last => {}
                Removal::Break { way } => self.rapid(depth + out * way),
                Removal::Clear { dwell, ahead } => {
                    self.rapid(self.levels.start_plane());
                    self.dwell(dwell);
                    let deep = (self.levels.reference - depth).abs();
                    let by_depth = if deep <= SHALLOW { NEAR } else { (deep / SHARE).min(FURTHEST) };
                    // Never above the start plane: the tool stands there already.
                    let ahead = ahead.unwrap_or(by_depth).min((self.levels.start_plane() - depth).abs());
                    self.rapid(depth + out * ahead);
                }
            }
        }
    }

    fn deep(&mut self, deep: &DeepHole, depths: &[f64]) {
        let (out, feed, start) = (self.levels.outward(), self.drilling.feed, self.levels.start_plane());
        let mut from = self.levels.reference;
        let mut broken = 0;
        for (i, &depth) in depths.iter().enumerate() {
            if let Breaks::Every(way) = deep.breaks {
                while (from - depth) * out > way + NOTHING {
                    from -= way * out;
                    self.cut(from, feed);
                    self.rapid(from + out * deep.way);
                }
            }
            self.cut(depth, feed);
            from = depth;
            if i + 1 == depths.len() {
                break;
            }
            if matches!(deep.breaks, Breaks::Times(times) if broken < times) {
                broken += 1;
                self.rapid(depth + out * deep.way);
                continue;
            }
            broken = 0;
            self.leave(deep.back);
            self.dwell(deep.dwell_out);
            // The first time `ahead[0]`, before the last step `ahead[1]`.
            let share = if depths.len() > 2 { i as f64 / (depths.len() - 2) as f64 } else { 0.0 };
            let ahead = deep.ahead[0] + share * (deep.ahead[1] - deep.ahead[0]);
            // Never above the start plane: the tool stands there already.
            self.rapid(depth + out * ahead.min((start - depth) * out));
        }
        self.dwell(deep.dwell);
        self.leave(deep.back);
    }

    /// Out to the start plane.
    fn leave(&mut self, feed: Option<Feed>) {
        match feed {
            Some(feed) => self.cut(self.levels.start_plane(), feed),
            None => self.rapid(self.levels.start_plane()),
        }
    }

    fn tap(&mut self, tap: &Tap, depths: &[f64]) {
        if let Some(angle) = tap.orient {
            self.spindle(Spindle::Orient(angle));
        }
        let start = self.levels.start_plane();
        let out = self.levels.outward();
        let chip = tap.step.map(|step| step.chip);
        let mut reached = None;
        for (at, depth) in (1..).zip(depths) {
            if let (Some(last), Some(Chip::Remove { ahead })) = (reached.replace(*depth), chip) {
                self.dwell(tap.dwell);
                self.down_again(last + ahead * out, tap);
            }
            self.turn(tap.turn, tap.speed_in);
            self.tap_to(*depth, tap);
            if !tap.dwell_reversed {
                self.dwell(tap.dwell);
            }
            self.turn(other(tap.turn), tap.speed_out.or(tap.speed_in));
            if tap.dwell_reversed {
                self.dwell(tap.dwell);
            }
            let to = match chip {
                // Never further out than the start plane.
                Some(Chip::Break { back }) if at < depths.len() => *depth + back.min((start - *depth) * out) * out,
                _ => start,
            };
            self.tap_to(to, tap);
        }
        if let Some(speed) = tap.speed_after {
            self.spindle(Spindle::Speed(speed));
        }
        self.spindle(tap.after);
    }

    /// From the start plane through the thread that is cut, where that has a speed of its own.
    fn down_again(&mut self, to: f64, tap: &Tap) {
        let below = (self.levels.start_plane() - to) * self.levels.outward() > 0.0;
        let out = tap.speed_out.or(tap.speed_in);
        if below && out != tap.speed_in {
            self.turn(tap.turn, out);
            self.tap_to(to, tap);
        }
    }

    fn turn(&mut self, turn: Turn, speed: Option<f64>) {
        if let Some(speed) = speed {
            self.spindle(Spindle::Speed(speed));
        }
        self.spindle(Spindle::Start(turn));
    }

    fn tap_to(&mut self, to: f64, tap: &Tap) {
        match tap.lead {
            Some(lead) => {
                let path = Path::Thread(Thread { lead, along: Some(self.drilling.axis) });
                self.send(self.height(to), path);
            }
            None => self.cut(to, self.drilling.feed),
        }
    }

    /// Lifts the edge off the wall before it leaves the hole.
    fn bore(&mut self, bore: &Bore, start: &Pos, axes: [Axis; 3]) -> Result<(), Failure> {
        let (levels, feed) = (self.levels, self.drilling.feed);
        let lifts = |i: usize| axes.get(i).copied().zip(bore.lift.get(i).copied()).filter(|(_, way)| *way != 0.0);
        let mut lifted = Pos::UNKNOWN;
        let mut centre = Pos::UNKNOWN;
        for (axis, way) in (0..3).filter_map(lifts) {
            if axis == self.drilling.axis {
                lifted.set(axis, levels.depth + way);
                continue;
            }
            let Some(at) = start.get(axis) else {
                let message = format!("the tool is lifted off along {}, whose position is not known", axis.letter());
                return Err(Failure::new(codes::G3043, message, "position the tool over the hole in both axes"));
            };
            lifted.set(axis, at + way);
            centre.set(axis, at);
        }
        self.cut(levels.depth, feed);
        self.dwell(bore.dwell);
        self.spindle(Spindle::Orient(bore.orient));
        if !lifted.known().is_empty() {
            self.send(lifted, Path::Rapid);
        }
        self.leave(bore.back);
        self.rapid(levels.retract);
        if !centre.known().is_empty() {
            self.send(centre, Path::Rapid);
        }
        self.spindle(Spindle::Start(bore.turn));
        Ok(())
    }
}

fn other(turn: Turn) -> Turn {
    match turn {
        Turn::Clockwise => Turn::CounterClockwise,
        Turn::CounterClockwise => Turn::Clockwise,
    }
}

#[cfg(test)]
mod tests;
