//! Bore milling: a semicircle to the wall, a helix down, a full circle at the depth, a semicircle to the middle.

use crate::diag::{Fault, codes};
use crate::geo::{Deg, Point2, angle};
use crate::ir::cycle::{BoreMilling, Family};

use super::cutter::Cutter;
use super::{CycleItem, Expand, Start};

impl Expand for BoreMilling {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3331::bore_makes_no_path(&fault))?;
        let heights = &self.mill.heights;
        let mut cutter = Cutter::new(&self.mill, self.place, start, out);
        cutter.lift(heights.safe());
        cutter.rapid(Point2::origin());
        if self.circles.is_empty() {
            cutter.plunge(heights.depth);
        }
        for (at, radius) in self.circles.iter().enumerate() {
            if at > 0 {
                cutter.lift(heights.safe());
            }
            self.circle(*radius, &mut cutter);
        }
        cutter.retract();
        Ok(())
    }
}

impl BoreMilling {
    fn circle(&self, radius: f64, cutter: &mut Cutter<'_>) {
        let (feed, ccw, depth) = (self.mill.feeds.plane, self.counter_clockwise, self.mill.heights.depth);
        let middle = Point2::origin();
        let half = |p: Point2| Point2::new(p.x / 2.0, p.y / 2.0);
        let on = Point2::new(radius, 0.0);
        if self.straight {
            cutter.line(on, feed);
        } else {
            cutter.arc(on, half(on), ccw, feed);
        }
        cutter.plunge(self.from);
        let turns = self.turns(radius);
        let mut end = on;
        if turns.rest > 0.0 {
            let way = turns.rest * if ccw { 360.0 } else { -360.0 };
            end = angle::rotated(on, middle, Deg(way));
            cutter.spiral(end, middle, (ccw, turns.whole), depth, feed);
        } else if turns.whole > 0 {
            cutter.helix(middle, ccw, turns.whole, depth, feed);
        } else {
            cutter.plunge(depth);
        }
        cutter.helix(middle, ccw, 1, depth, feed);
        if self.straight {
            cutter.line(middle, feed);
        } else {
            cutter.arc(middle, half(end), ccw, feed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::Plane;
    use crate::ir::Feed;
    use crate::ir::cycle::bore_milling::Turns;
    use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, Place};

    fn bore(pitch: f64) -> BoreMilling {
        let feed = Feed::PerMinute(100.0);
        let heights = Heights {
            retract: 50.0,
            reference: 0.0,
            clearance: 2.0,
            depth: -10.0,
            step: 0.0,
            division: Division::Even,
            allowance: 0.0,
        };
        BoreMilling {
            mill: Mill { plane: Plane::Xy, heights, radius: 6.0, feeds: Feeds { plane: feed, depth: feed } },
            place: Place::HERE,
            circles: vec![9.0],
            pitch,
            counter_clockwise: true,
            from: 2.0,
            straight: false,
        }
    }

    #[test]
    fn turns_of_the_worked_examples() {
        assert_eq!(bore(3.0).turns(9.0), Turns { whole: 4, rest: 0.0 });
        let turns = bore(5.0).turns(9.0);
        assert!(turns.whole == 2 && (turns.rest - 0.4).abs() < 1e-12);
        assert_eq!(bore(4.000_000_1).turns(9.0), Turns { whole: 3, rest: 0.0 });
        assert_eq!(bore(1e7).turns(9.0), Turns { whole: 0, rest: 0.0 });
    }

    #[test]
    fn arguments_that_make_no_hole_are_named() {
        use crate::ir::cycle::bore_milling::BoreMillingFault::{Number, Pitch, Start, TooMany};
        assert_eq!(bore(0.0).check(), Err(Pitch));
        assert_eq!(bore(1e-6).check(), Err(TooMany));
        assert_eq!(BoreMilling { from: 3.0, ..bore(3.0) }.check(), Err(Start));
        assert_eq!(BoreMilling { circles: vec![0.0], ..bore(3.0) }.check(), Err(Number));
    }
}
