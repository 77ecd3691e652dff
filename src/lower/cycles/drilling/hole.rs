//! The moves of one hole: down, back, taps, and boring.

use crate::diag::{Fault, codes};
use crate::ir::contour::{Coords, Move, Path, Thread};
use crate::ir::cycle::drilling::{Bore, Chip, DeepHole, Drilling, Levels, Tap};
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::tap::{Stroke, Tap as RigidTap};
use crate::ir::{Feed, Function, Pos, Side};
use crate::lower::cycles::CycleItem;
use crate::machine::Axis;

/// A hole while its moves are sent.
pub(super) struct Hole<'a> {
    pub drilling: &'a Drilling,
    pub levels: &'a Levels,
    pub out: &'a mut dyn FnMut(CycleItem),
}

impl Hole<'_> {
    fn send(&mut self, end: Pos, path: Path) {
        (self.out)(CycleItem::Move(Move { end, path, side: Side::None, coords: Coords::Frame }));
    }

    fn height(&self, to: f64) -> Pos {
        let mut end = Pos::UNKNOWN;
        end.set(self.drilling.axis, to);
        end
    }

    pub(super) fn rapid(&mut self, to: f64) {
        self.send(self.height(to), Path::Rapid);
    }

    pub(super) fn cut(&mut self, to: f64, feed: Feed) {
        self.send(self.height(to), Path::Line(feed));
    }

    pub(super) fn dwell(&mut self, seconds: f64) {
        if seconds > 0.0 {
            (self.out)(CycleItem::Function(Function::Dwell(seconds)));
        }
    }

    pub(super) fn spindle(&mut self, spindle: Spindle) {
        (self.out)(CycleItem::Function(Function::Spindle(spindle)));
    }

    /// Down to where the hole is open.
    pub(super) fn enter(&mut self) {
        if let Some(entry) = self.drilling.entry.filter(|entry| entry.height != self.levels.start_plane()) {
            match entry.feed {
                Some(feed) => self.cut(entry.height, feed),
                None => self.rapid(entry.height),
            }
        }
    }

    /// In with the spindle slow or standing, down, coolant off, out as it came in.
    pub(super) fn deep(&mut self, hole: &DeepHole) {
        self.slowly(hole);
        self.enter();
        self.turn(hole.drilling.1, Some(hole.drilling.0));
        self.coolant(hole.coolant[0]);
        self.cut(self.levels.depth, self.drilling.feed);
        self.dwell(hole.dwell);
        self.coolant(hole.coolant[1]);
        self.slowly(hole);
        self.leave(hole.back);
    }

    fn slowly(&mut self, hole: &DeepHole) {
        match hole.entry {
            (speed, Some(turn)) => self.turn(turn, Some(speed)),
            (_, None) => self.spindle(Spindle::Stop),
        }
    }

    fn coolant(&mut self, coolant: Option<Coolant>) {
        if let Some(coolant) = coolant {
            (self.out)(CycleItem::Function(Function::Coolant(coolant)));
        }
    }

    /// Out to the start plane.
    pub(super) fn leave(&mut self, feed: Option<Feed>) {
        match feed {
            Some(feed) => self.cut(self.levels.start_plane(), feed),
            None => self.rapid(self.levels.start_plane()),
        }
    }

    /// Axis and spindle in step all the time.
    fn rigid_tap(&mut self, tap: &Tap, lead: f64, depths: &[f64]) {
        let axis = self.drilling.axis;
        let (levels, out) = (self.levels, self.levels.outward());
        let start = self.drilling.entry.map_or(levels.start_plane(), |entry| entry.height);
        let chip = tap.step.map(|step| step.chip);
        let stroke = |(at, to): (usize, &f64)| {
            let back = match chip {
                // Never further out than the start plane.
                Some(Chip::Break { back }) if at + 1 < depths.len() => *to + back.min((start - *to) * out) * out,
                _ => start,
            };
            Stroke { to: *to, back, dwell: tap.dwell }
        };
        let (pause, again) = match chip {
            Some(Chip::Remove { ahead }) => (tap.dwell, Some(ahead)),
            Some(Chip::Break { .. }) | None => (0.0, None),
        };
        let item = RigidTap {
            axis,
            start,
            surface: levels.reference,
            strokes: depths.iter().enumerate().map(stroke).collect(),
            lead,
            turn: tap.turn,
            speed_in: tap.speed_in,
            speed_out: tap.speed_out,
            orient: tap.orient,
            pause,
            again,
        };
        (self.out)(CycleItem::Tap(item));
        self.after_tap(tap);
    }

    fn after_tap(&mut self, tap: &Tap) {
        if let Some(speed) = tap.speed_after {
            self.spindle(Spindle::Speed(speed));
        }
        self.spindle(tap.after);
    }

    pub(super) fn tap(&mut self, tap: &Tap, depths: &[f64]) {
        if let (true, Some(lead)) = (tap.rigid, tap.lead) {
            return self.rigid_tap(tap, lead, depths);
        }
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
            self.turn(tap.turn.reversed(), tap.speed_out.or(tap.speed_in));
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
        self.after_tap(tap);
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
    pub(super) fn bore(&mut self, bore: &Bore, start: &Pos, axes: [Axis; 3]) -> Result<(), Fault> {
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
                return Err(codes::G3043::tool_is_lifted_off_along(&axis.letter()));
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
