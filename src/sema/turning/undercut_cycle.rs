//! G85 of the 4110: one cut along an undercut, from above the cylinder to above the shoulder.
//!
//! Source: reference section 8.7 and the table of G85 in section 6.3.

use crate::diag::codes;
use crate::geo::{Element, Plane, Point2};
use crate::ir::contour::{Arc, ArcShape, Coords, EndPoint, Move, Path};
use crate::ir::{Feed, Pos, Side};
use crate::machine::Axis;

use super::chain::{AGREES, Coord, Solved};
use super::sections::Family;
use super::undercuts::{self, LEAN_509, SLOPE_76, SLOPE_509, Undercut};
use super::words::Words;
use super::{Outcome, Run};

/// How far the lines beside the corner are taken to reach, in mm: what lies there is the programmer's.
const REACH: f64 = 1e4;

impl Run<'_> {
    pub(super) fn undercut_cycle(&mut self, w: &Words) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        if self.sections.family() == Family::DinPlus {
            return self.fail_help(
                codes::T9006,
                span,
                "G85 of DIN PLUS is not supported",
                "describe the undercut with G25 in the contour",
            );
        }
        let (Coord::At(x), Coord::At(z)) = (self.coord(w.get(b'X'), Axis::X), self.coord(w.get(b'Z'), Axis::Z)) else {
            return self.fail(codes::T1005, span, "an undercut needs absolute X and Z of its corner");
        };
        let corner = Point2::new(z, x);
        let height = at.y - corner.y;
        if height.abs() <= 1e-6 {
            return self.fail_help(
                codes::T9007,
                span,
                "a tool on the cylinder itself leaves open whether the undercut lies outside or inside",
                "turn the cylinder with G1, and position the tool clear of it before G85",
            );
        }
        let undercut = self.undercut_sizes(w, 2.0 * corner.y)?;
        // The cylinder comes from +Z, the shoulder goes to where the tool stands.
        let before = Solved { from: Point2::new(z + REACH, x), to: corner, arc: None };
        let after = Solved { from: corner, to: Point2::new(z, x + REACH * height.signum()), arc: None };
        let made = match undercuts::build(&undercut, &before, Some(&after)) {
            Ok(made) => made,
            Err(why) => return self.fail(codes::T3004, span, why),
        };
        let clear = (made.joins.y - corner.y).abs() < height.abs();
        if at.x < made.leaves.x || !clear {
            return self.fail_help(
                codes::T2025,
                span,
                "the tool does not stand in front of the undercut and clear of it",
                "position it at a greater Z than the undercut begins, and beyond its end at the shoulder",
            );
        }
        let active = self.cutting_feed()?;
        let feed = match w.get(b'E') {
            Some(num) => active.with_value(self.above_zero(num, "the reduced feed")?),
            None => active,
        };
        self.undercut_move(Point2::new(made.leaves.x, at.y), Path::Rapid, None);
        self.undercut_move(made.leaves, Path::Line, Some(feed));
        for (element, _) in &made.elements {
            let path = match *element {
                Element::Line { .. } => Path::Line,
                Element::Arc { center, sweep, .. } => {
                    let shape = ArcShape::Center { center, ccw: sweep > 0.0, tol: AGREES };
                    Path::Arc(Arc { plane: Plane::Zx, shape, turns: 0 })
                }
            };
            self.undercut_move(element.to(), path, Some(feed));
        }
        self.undercut_move(Point2::new(z, at.y), Path::Line, Some(feed));
        self.st.last = None;
        Ok(())
    }

    fn undercut_move(&mut self, to: Point2, path: Path, feed: Option<Feed>) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(Plane::Zx, to);
        self.movement(&Move { end: EndPoint::Cartesian(end), path, feed, side: Side::None, coords: Coords::Frame });
        self.st.stands(to);
        self.st.moved = true;
    }

    /// K tells the form: missing E, 0 F, else the width of DIN 76.
    fn undercut_sizes(&self, w: &Words, diameter: f64) -> Outcome<Undercut> {
        let mm = self.st.mm();
        let span = self.block_span();
        let [depth, width, radius, face] = undercuts::din_509(diameter, true);
        let form = w.get(b'K').map(|num| num.value * mm);
        if let Some(num) = w.get(b'I').filter(|num| num.value != 0.0 && form.is_none_or(|k| k == 0.0)) {
            return self.fail_help(
                codes::T9007,
                num.span,
                "the wear oversize of an undercut E or F is not supported",
                "leave I out, and correct the wear at the tool",
            );
        }
        match form {
            None => Ok(Undercut::E { depth, width, radius, slope: SLOPE_509 }),
            Some(0.0) => Ok(Undercut::F { depth, width, radius, slope: SLOPE_509, face, lean: LEAN_509 }),
            Some(width) => {
                let depth = self.needed(w, b'I', "the depth of the undercut", span)?;
                let depth = self.above_zero(depth, "the depth of the undercut")?;
                match undercuts::din_76_radius(width) {
                    Some(radius) => Ok(Undercut::E { depth, width, radius, slope: SLOPE_76 }),
                    None => self.fail_help(
                        codes::T1007,
                        w.span(b'K', span),
                        format!("no undercut of DIN 76 is {width} mm wide"),
                        "take the width of the table, or write the undercut with G1 and G2 blocks",
                    ),
                }
            }
        }
    }
}
