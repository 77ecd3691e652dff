//! Thread milling: a semicircle to the helix, whole turns, and a semicircle from it; holes and countersinks around.

use crate::diag::{Fault, codes};
use crate::geo::{Element, Point2, arc};
use crate::ir::Feed;
use crate::ir::cycle::thread_milling::{Helix, Positioning, Side, Sink, Stage};
use crate::ir::cycle::{Family, ThreadMilling};

use super::cutter::Cutter;
use super::{CycleItem, Expand, Start};

impl Expand for ThreadMilling {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3331::thread_makes_no_path(&fault))?;
        let mut cutter = Cutter::new(&self.mill, self.place, start, out);
        let entry = self.entry();
        let home = if self.side == Side::Internal { Point2::origin() } else { entry };
        if self.ways.positioning.is_some() {
            cutter.lift(self.mill.heights.safe());
            cutter.rapid(home);
        } else {
            cutter.approach(entry);
        }
        self.make(&self.before, start, &mut cutter)?;
        for rest in &self.rests {
            for helix in self.helices() {
                // Free of the thread: in its middle, or beside it.
                cutter.go_down(helix.start, self.positioning());
                if self.ways.positioning.is_some() {
                    cutter.go(entry, self.positioning());
                }
                self.turn(&helix, *rest, &mut cutter);
            }
        }
        if self.ways.positioning.is_some() {
            cutter.go(home, self.positioning());
        } else {
            cutter.line(home, self.mill.feeds.depth);
        }
        self.make(&self.after, start, &mut cutter)?;
        cutter.retract();
        Ok(())
    }
}

impl ThreadMilling {
    /// `None` at rapid traverse.
    fn positioning(&self) -> Option<Feed> {
        match self.ways.positioning {
            Some(Positioning::At(feed)) => Some(feed),
            Some(Positioning::Rapid) | None => None,
        }
    }

    fn make(&self, stages: &[Stage], start: &Start, cutter: &mut Cutter<'_>) -> Result<(), Fault> {
        for stage in stages {
            match stage {
                Stage::Drill(hole) => cutter.drill(hole, start)?,
                Stage::Sink(sink) => self.sink(sink, cutter),
            }
        }
        Ok(())
    }

    fn sink(&self, sink: &Sink, cutter: &mut Cutter<'_>) {
        match self.ways.positioning {
            Some(_) => cutter.go_down(sink.approach, self.positioning()),
            None => cutter.plunge(sink.approach),
        }
        cutter.sink(sink.height, sink.feed);
        if sink.radius == 0.0 {
            return;
        }
        let home = if self.side == Side::Internal { Point2::origin() } else { self.entry() };
        let on = Point2::new(sink.radius, 0.0);
        let middle = Point2::new((home.x + on.x) / 2.0, 0.0);
        let ccw = sink.counter_clockwise;
        // From outside the small circle turns against the one that it meets.
        let towards = ccw == (self.side == Side::Internal);
        cutter.arc(on, middle, towards, sink.feed);
        cutter.helix(Point2::origin(), ccw, 1, sink.height, sink.feed);
        cutter.arc(home, middle, towards, sink.feed);
    }

    fn turn(&self, helix: &Helix, rest: f64, cutter: &mut Cutter<'_>) {
        let (feed, onto) = (self.mill.feeds.plane, self.ways.onto);
        let entry = self.entry();
        let on = Point2::new(self.radius(rest), 0.0);
        let middle = Point2::new((entry.x + on.x) / 2.0, 0.0);
        // From outside the small circle turns against the helix that it meets.
        let ccw = self.counter_clockwise == (self.side == Side::Internal);
        let half = |from: Point2, to: Point2| Element::Arc {
            from,
            to,
            center: middle,
            sweep: arc::sweep(from, to, middle, ccw),
        };
        cutter.fall(&half(entry, on), helix.first, onto);
        cutter.helix(Point2::origin(), self.counter_clockwise, helix.turns, helix.last, feed);
        cutter.fall(&half(on, entry), helix.end, feed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::{Deg, Plane};
    use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, Place};
    use crate::ir::cycle::thread_milling::{Turns, Ways};

    fn thread(depth: f64) -> ThreadMilling {
        let feed = Feed::PerMinute(100.0);
        ThreadMilling {
            mill: Mill {
                plane: Plane::Xy,
                heights: Heights {
                    retract: 10.0,
                    reference: 0.0,
                    clearance: 2.0,
                    depth,
                    step: 0.0,
                    division: Division::Even,
                    allowance: 0.0,
                },
                radius: 6.0,
                feeds: Feeds { plane: feed, depth: feed },
            },
            place: Place { at: Point2::origin(), turn: Deg(0.0) },
            side: Side::Internal,
            nominal: 10.0,
            core: 9.08,
            pitch: 1.5,
            left_hand: false,
            counter_clockwise: true,
            turns: Turns::Continuous,
            rests: vec![0.0],
            ways: Ways::of_half_a_pitch(1.5, feed),
            before: Vec::new(),
            after: Vec::new(),
        }
    }

    #[test]
    fn helix_of_the_worked_example() {
        let thread = thread(-20.0);
        assert_eq!((thread.radius(0.0), thread.helices().len()), (4.0, 1));
        let helix = thread.helices()[0];
        assert_eq!((helix.start, helix.first, helix.turns, helix.last, helix.end), (-20.0, -19.25, 14, 1.75, 2.5));
        let external = ThreadMilling { side: Side::External, nominal: 15.0, core: 13.773, ..thread };
        let mill = Mill { radius: 8.0, ..external.mill };
        assert_eq!(ThreadMilling { mill, ..external }.radius(0.0), 21.773);
    }

    #[test]
    fn the_other_sense_runs_down_and_ends_at_the_depth() {
        let thread = ThreadMilling { counter_clockwise: false, ..thread(-20.0) };
        let helix = thread.helices()[0];
        assert_eq!((helix.start, helix.end), (2.5, -20.0));
        let left = ThreadMilling { left_hand: true, ..thread };
        assert_eq!(left.helices()[0].start, -20.0);
    }

    #[test]
    fn several_teeth_cut_strips_of_one_turn() {
        let thread = ThreadMilling { turns: Turns::Strips(5), ..thread(-20.0) };
        let starts: Vec<(f64, u32)> = thread.helices().iter().map(|helix| (helix.start, helix.turns)).collect();
        assert_eq!(starts, [(-20.0, 1), (-12.5, 1), (-5.0, 1)]);
    }
}
