//! G85 of the 4110: one cut along an undercut, from above the cylinder to above the shoulder; or, where the tool stands on
//! the cylinder, along that and the undercut.
//!
//! Source: T 8.7 and the table of G85 in section 6.3 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Element, Plane, Point2, Vec2};
use crate::ir::contour::{Arc, ArcShape, Coords, Move, Path};
use crate::ir::undercut::{form_e, form_f};
use crate::ir::{Pos, Side};
use crate::machine::Axis;
use crate::sema::common::compensation::edge_direction;
use crate::standard::{din76, din509};
use crate::text::Span;

use super::chain::{AGREES, Coord, Solved};
use super::readings::Question;
use super::undercuts::{self, Undercut};
use super::words::Words;
use super::{Outcome, Run};

/// How little a tool is off the cylinder that stands on it, mm.
const ON: f64 = 1e-6;
/// What arithmetic loses in a diameter, mm.
const LOST: f64 = 1e-9;
/// How far the lines beside the corner are taken to reach, in mm: what lies there is the programmer's.
const REACH: f64 = 1e4;

impl Run<'_> {
    pub(super) fn undercut_cycle(&mut self, w: &Words) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        self.not_of_din_plus("G85", "describe the undercut with G25 in the contour")?;
        let (Coord::At(x), Coord::At(z)) = (self.coord(w.get(b'X'), Axis::X), self.coord(w.get(b'Z'), Axis::Z)) else {
            return self.refuse(span, codes::P1004::undercut_needs_absolute_x());
        };
        let corner = Point2::new(z, x);
        let height = at.y - corner.y;
        let on_cylinder = height.abs() <= ON;
        let up = if on_cylinder { self.undercut_outwards(span)? } else { height.signum() };
        // The cylinder lies on the side from which the tool comes along Z, the shoulder beyond the corner.
        let sense = if at.x >= z { 1.0 } else { -1.0 };
        self.edge_fits(sense, up)?;
        let undercut = self.undercut_sizes(w, 2.0 * corner.y, up < 0.0)?;
        let before = Solved { from: Point2::new(z + REACH * sense, x), to: corner, arc: None };
        let after = Solved { from: corner, to: Point2::new(z, x + REACH * up), arc: None };
        let made = match undercuts::build(&undercut, &before, Some(&after)) {
            Ok(made) => made,
            Err(why) => return self.fail(codes::T3004, span, why),
        };
        let clear = on_cylinder || (made.joins.y - corner.y).abs() < height.abs();
        if (at.x - made.leaves.x) * sense < 0.0 || !clear {
            return self.refuse(span, codes::T2025::tool_does_not_stand_in_front());
        }
        let active = self.cutting_feed()?;
        let feed = match w.get(b'E') {
            Some(num) => active.with_value(self.above_zero(num, "the reduced feed")?),
            None => active,
        };
        if on_cylinder {
            // The cylinder is machined, too.
            self.undercut_move(made.leaves, Path::Line(active));
        } else {
            self.undercut_move(Point2::new(made.leaves.x, at.y), Path::Rapid);
            self.undercut_move(made.leaves, Path::Line(feed));
        }
        for (element, _) in &made.elements {
            let path = match *element {
                Element::Line { .. } => Path::Line(feed),
                Element::Arc { center, sweep, .. } => {
                    let shape = ArcShape::Center { center, ccw: sweep > 0.0, tol: AGREES };
                    Path::Arc(Arc { plane: Plane::Zx, shape, turns: 0 }, feed)
                }
            };
            self.undercut_move(element.to(), path);
        }
        // A tool that stood on the cylinder has reached its start X on the way.
        if !on_cylinder {
            self.undercut_move(Point2::new(z, at.y), Path::Line(feed));
        }
        self.st.cut = true;
        self.st.last = None;
        Ok(())
    }

    /// +1 for an undercut outside, -1 for one inside, where the tool stands on the cylinder: its edge tells.
    fn undercut_outwards(&self, span: Span) -> Outcome<f64> {
        match self.known_tool().and_then(|tool| tool.orientation) {
            Some(3 | 4 | 8) => {
                self.depends_on(Question::UndercutSide, span);
                Ok(1.0)
            }
            Some(1 | 2 | 6) => {
                self.depends_on(Question::UndercutSide, span);
                Ok(-1.0)
            }
            _ => self.refuse(span, codes::P2004::tool_stands_on_cylinder()),
        }
    }

    /// The edge of the tool points to the shoulder and to the cylinder, or not away from them at least.
    fn edge_fits(&self, sense: f64, up: f64) -> Outcome {
        let Some(edge) = self.known_tool().and_then(|tool| tool.orientation) else { return Ok(()) };
        let points = edge_direction(edge).unwrap_or_else(Vec2::zeros);
        if points.x * sense <= 0.0 && points.y * up <= 0.0 {
            return Ok(());
        }
        self.refuse(self.block_span(), codes::T2025::tool_comes_to_undercut_from_side(&edge))
    }

    fn undercut_move(&mut self, to: Point2, path: Path) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(Plane::Zx, to);
        self.movement(&Move { end, path, side: Side::None, coords: Coords::Frame });
        self.st.stands(to);
        self.st.moved = true;
    }

    /// K tells the form: missing E, 0 F, else the width of DIN 76.
    fn undercut_sizes(&self, w: &Words, diameter: f64, inside: bool) -> Outcome<Undercut> {
        let mm = self.st.mm();
        let span = self.block_span();
        let form = w.get(b'K').map(|num| num.value * mm);
        let of_table = form.is_none_or(|k| k == 0.0);
        let tables = &self.job.settings.undercut;
        let limit = |range: &din509::Range| (range.upto - diameter).abs() <= LOST;
        if of_table && !tables.says_sizes_by_diameter() && din509::PLUS_4110_G85.iter().any(limit) {
            self.depends_on(Question::UndercutLimit, w.span(b'X', span));
        }
        // A diameter at a limit belongs to the row below it or above it.
        let upper = self.job.settings.control.turning.undercut_upper == Some(true);
        let sought = diameter + if upper { LOST } else { -LOST };
        if let Some(num) = w.get(b'I').filter(|num| num.value != 0.0 && form.is_none_or(|k| k == 0.0)) {
            return self.refuse(num.span, codes::T9007::wear_oversize_of_undercut_e_or_f());
        }
        match form {
            None | Some(0.0) => match tables.size_for(sought, din509::PLUS_4110_G85) {
                Some((_, size)) => Ok(if form.is_none() { form_e(size) } else { form_f(size) }.into()),
                None => self.fail(codes::P1004, w.span(b'X', span), undercuts::no_size(diameter)),
            },
            Some(width) => {
                let depth = self.needed(w, b'I', "the depth of the undercut", span)?;
                let depth = self.above_zero(depth, "the depth of the undercut")?;
                match undercuts::radius_of_width(tables, width, inside) {
                    Some(radius) => Ok(undercuts::square(depth, width, radius, din76::ENTRY).into()),
                    None => self.refuse(w.span(b'K', span), codes::T1007::no_undercut_of_din_76_is_mm(&width)),
                }
            }
        }
    }
}
