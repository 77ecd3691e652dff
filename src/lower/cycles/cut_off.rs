//! Cut-off: a plunge in front of the edge, the edge, then straight in.
//!
//! ```text
//!   2 ╲          │1
//!  ────╲         │   ─────  surface
//!       ╲        ▼
//!  work- │3
//!  piece │
//!        ▼
//! ```
//!
//! The plunge opens the place beside the edge, which the cut takes anyway, so that the tool cuts the edge on one side only.

use crate::diag::{Fault, codes};
use crate::geo::Point2;
use crate::ir::cycle::Family;
use crate::ir::cycle::cut_off::{CutEdge, CutOff};
use crate::ir::function::Spindle;
use crate::ir::{Feed, Function};

use super::track::{Move, Path};
use super::{CycleItem, Expand, Start};

impl Expand for CutOff {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3041::cut_off_makes_no_path(&fault))?;
        let from = start.in_turning_plane()?;
        let mut way = Way { cut: self, at: from, out };
        way.come(from);
        way.spindle(self.speed);
        way.spindle(self.turn.map(Spindle::Start));
        way.edge();
        way.line(0.0, self.reduced, self.feed);
        way.spindle(self.reduced_speed);
        way.line(0.0, self.end, self.reduced_feed);
        way.rapid(0.0, self.clear());
        Ok(())
    }
}

/// Leads the corner on the side of the workpiece: `beside` counts from the face towards +Z, `x` is a radius.
struct Way<'w> {
    cut: &'w CutOff,
    at: Point2,
    out: &'w mut dyn FnMut(CycleItem),
}

impl Way<'_> {
    /// In front of the cut, at the clear height or above on the way.
    fn come(&mut self, from: Point2) {
        let clear = self.cut.clear();
        let height = from.y.max(clear);
        self.send(Point2::new(from.x, height), Path::Rapid);
        self.rapid(0.0, height);
        self.rapid(0.0, clear);
    }

    fn edge(&mut self) {
        let cut = self.cut;
        let (nose, size, half) = (cut.tool.nose, cut.edge.size(), cut.clearance / 2.0);
        // Where the corner disc touches 45 degrees, its square corner lies this much inside on both axes.
        let inside = nose * (1.0 - std::f64::consts::FRAC_1_SQRT_2);
        let begin = match cut.edge {
            CutEdge::Sharp => return,
            CutEdge::Round(_) => size + nose,
            CutEdge::Chamfer(_) => size + half + 2.0 * inside,
        };
        let plunge = (cut.outer - size - half.max(nose)).max(cut.reduced);
        self.line(0.0, plunge, cut.feed);
        self.rapid(0.0, cut.clear());
        self.rapid(begin, cut.clear());
        self.rapid(begin, cut.outer + half);
        let center = match cut.edge {
            CutEdge::Sharp => return,
            CutEdge::Round(_) => {
                self.line(begin, cut.outer, cut.feed);
                (size + nose, cut.outer - size - nose)
            }
            CutEdge::Chamfer(_) => {
                self.line(inside, cut.outer - size - inside, cut.feed);
                (nose, cut.outer - size - nose)
            }
        };
        let center = self.point(center.0, center.1);
        self.send(self.point(0.0, cut.foot()), Path::Arc { center, ccw: true, feed: cut.feed });
    }

    fn point(&self, beside: f64, x: f64) -> Point2 {
        Point2::new(self.cut.place(beside), x)
    }

    fn rapid(&mut self, beside: f64, x: f64) {
        self.send(self.point(beside, x), Path::Rapid);
    }

    fn line(&mut self, beside: f64, x: f64, feed: Feed) {
        self.send(self.point(beside, x), Path::Line { feed });
    }

    fn spindle(&mut self, spindle: Option<Spindle>) {
        if let Some(spindle) = spindle {
            (self.out)(CycleItem::Function(Function::Spindle(spindle)));
        }
    }

    /// Moves of no length are left out.
    fn send(&mut self, to: Point2, path: Path) {
        if to != self.at {
            self.at = to;
            (self.out)(CycleItem::Move(Move { to, path }.movement()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::Plane;
    use crate::ir::contour;
    use crate::ir::cycle::cut_off::CutOffFault;
    use crate::ir::cycle::recess::RecessTool;
    use crate::ir::{Pos, cycle::Cycle};
    use crate::machine::Axis;

    fn bar() -> CutOff {
        CutOff {
            face: -50.0,
            outer: 20.0,
            reduced: 2.0,
            end: -0.3,
            edge: CutEdge::Chamfer(2.0),
            tool: RecessTool { width: 3.0, nose: 0.0, edge: 0.0 },
            clearance: 1.0,
            feed: Feed::PerRevolution(0.1),
            reduced_feed: Feed::PerRevolution(0.05),
            speed: None,
            turn: None,
            reduced_speed: Some(Spindle::Speed(500.0)),
        }
    }

    fn words(cut: &CutOff) -> Vec<String> {
        let mut at = Pos::UNKNOWN;
        at.set_in_plane(Plane::Zx, Point2::new(5.0, 25.0));
        let start = Start { at, axes: [Axis::Z, Axis::X, Axis::Y] };
        let round = |v: f64| (v * 1e4).round() / 1e4 + 0.0;
        let mut text = Vec::new();
        let mut last = Point2::new(5.0, 25.0);
        cut.expand(&start, &mut |item| match item {
            CycleItem::Tap(_) => unreachable!("nothing is tapped"),
            CycleItem::Function(function) => text.push(format!("{function:?}")),
            CycleItem::Move(mv) | CycleItem::Beside(mv, _) => {
                let to = mv.end.in_plane(Plane::Zx).expect("a point");
                let head = match mv.path {
                    contour::Path::Rapid => "G0",
                    contour::Path::Line(_) => "G1",
                    _ => "G3",
                };
                let mut word = head.to_owned();
                if round(to.y) != round(last.y) {
                    word += &format!(" X{}", round(2.0 * to.y));
                }
                if round(to.x) != round(last.x) {
                    word += &format!(" Z{}", round(to.x));
                }
                text.push(word);
                last = to;
            }
        })
        .expect("a cut-off");
        text
    }

    #[test]
    fn a_bar_with_a_chamfer() {
        let expected = [
            "G0 Z-53",
            "G0 X42",
            "G1 X35",
            "G0 X42",
            "G0 Z-50.5",
            "G0 X41",
            "G1 X36 Z-53",
            "G1 X4",
            "Spindle(Speed(500.0))",
            "G1 X-0.6",
            "G0 X42",
        ];
        assert_eq!(words(&bar()), expected);
        let mut end = Pos::UNKNOWN;
        at_end(&mut end);
        assert_eq!((end.get(Axis::X), end.get(Axis::Z)), (Some(21.0), Some(-53.0)));
    }

    fn at_end(end: &mut Pos) {
        *end = Cycle::CutOff(bar()).leaves(end);
    }

    #[test]
    fn a_pipe_with_the_right_corner() {
        let pipe = CutOff {
            face: -30.0,
            outer: 30.0,
            reduced: 25.0,
            end: 22.0,
            edge: CutEdge::Sharp,
            tool: RecessTool { width: 3.0, nose: 0.2, edge: -3.0 },
            clearance: 2.0,
            reduced_speed: None,
            ..bar()
        };
        assert_eq!(words(&pipe), ["G0 X64", "G0 Z-30", "G1 X50", "G1 X44", "G0 X64"]);
    }

    #[test]
    fn corner_discs_roll_along_chamfer_and_radius() {
        let mut cut = bar();
        cut.tool.nose = 0.2;
        // 0.2 * (1 - 0.7071) = 0.0586 inside.
        assert_eq!(
            words(&cut)[2..8],
            ["G1 X35", "G0 X42", "G0 Z-50.3828", "G0 X41", "G1 X35.8828 Z-52.9414", "G3 X35.6 Z-53"]
        );
        cut.edge = CutEdge::Round(2.0);
        assert_eq!(words(&cut)[2..8], ["G1 X35", "G0 X42", "G0 Z-50.8", "G0 X41", "G1 X40", "G3 X35.6 Z-53"]);
    }

    #[test]
    fn every_bad_argument_has_its_name() {
        type Spoil = fn(&mut CutOff);
        let cases: &[(CutOffFault, Spoil)] = &[
            (CutOffFault::Point, |c| c.face = f64::NAN),
            (CutOffFault::Width, |c| c.tool.width = 0.0),
            (CutOffFault::Nose, |c| c.tool.nose = 1.6),
            (CutOffFault::Edge, |c| c.tool.edge = f64::NAN),
            (CutOffFault::Clearance, |c| c.clearance = 0.0),
            (CutOffFault::Feed, |c| c.reduced_feed = Feed::PerRevolution(0.0)),
            (CutOffFault::Order, |c| c.reduced = 20.0),
            (CutOffFault::Order, |c| c.end = 2.1),
            (CutOffFault::EdgeSize, |c| c.edge = CutEdge::Chamfer(0.0)),
            (CutOffFault::EdgeSize, |c| c.edge = CutEdge::Round(18.1)),
        ];
        assert_eq!(bar().check(), Ok(()));
        for (fault, spoil) in cases {
            let mut cut = bar();
            spoil(&mut cut);
            assert_eq!(cut.check(), Err(*fault));
        }
    }
}
