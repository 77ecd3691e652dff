//! G85 of the 4110: one cut along an undercut, from above the cylinder to above the shoulder; or, where the tool stands on
//! the cylinder, along that and the undercut.
//!
//! Source: T 8.7 and the table of G85 in section 6.3 (docs/sources.md).

use crate::diag::codes;
use crate::geo::tolerance;
use crate::geo::{Element, Plane, Point2, Vec2};
use crate::ir::contour::{Arc, ArcShape, Path};
use crate::ir::undercut::{form_e, form_f};
use crate::sema::common::compensation::edge_direction;
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Rule, feed, length};
use crate::standard::{din76, din509};

use super::super::chain::{AGREES, Coord, Solved};
use super::super::readings::Question;
use super::super::undercuts::{self, Undercut};
use super::{CORNER_X, CORNER_Z, CycleCall, Need, Planned, Row, Step, word};

/// How little a tool is off the cylinder that stands on it, mm.
const ON: f64 = 1e-6;
/// How far the lines beside the corner are taken to reach, in mm: what lies there is the programmer's.
const REACH: f64 = 1e4;

pub(super) const ROWS: &[Row] = &[Row::new(
    85,
    "G85",
    "undercut",
    "4110P, p. 80",
    &[
        CORNER_X.needed(),
        CORNER_Z.needed(),
        length("I", "E and F: oversize, refused where it is not 0; DIN 76: depth").default("0"),
        length("K", "0 form F, above 0 width of DIN 76").default("form E"),
        feed("E", "feed").rule(Rule::Above(0)).default("that in force"),
    ],
    |call| call.undercut(),
)
.requires(&[Need::NotDinPlus(codes::P9010::g85_of_din_plus_is_not_supported), Need::Feed])];

impl CycleCall<'_> {
    fn undercut(&self) -> Planned {
        let at = self.st.at;
        let (Coord::At(x), Coord::At(z)) = (self.st.x, self.st.z) else {
            return self.refuse(codes::P1004::undercut_needs_absolute_x());
        };
        let corner = Point2::new(z, x);
        let height = at.y - corner.y;
        let on_cylinder = height.abs() <= ON;
        let up = if on_cylinder { self.undercut_outwards()? } else { height.signum() };
        // The cylinder lies on the side from which the tool comes along Z, the shoulder beyond the corner.
        let sense = if at.x >= z { 1.0 } else { -1.0 };
        self.edge_fits(sense, up)?;
        let undercut = self.undercut_sizes(2.0 * corner.y, up < 0.0)?;
        let before = Solved { from: Point2::new(z + REACH * sense, x), to: corner, arc: None };
        let after = Solved { from: corner, to: Point2::new(z, x + REACH * up), arc: None };
        let made = undercuts::build(&undercut, &before, Some(&after));
        let made = self.no_fault(made)?;
        let clear = on_cylinder || (made.joins.y - corner.y).abs() < height.abs();
        if (at.x - made.leaves.x) * sense < 0.0 || !clear {
            return self.refuse(codes::T2025::tool_does_not_stand_in_front());
        }
        let active = self.feed()?;
        let feed = self.own_feed(word::E, active)?;
        // On the cylinder that is machined, too.
        let mut steps = match on_cylinder {
            true => vec![Step::Move(made.leaves, Path::Line(active))],
            false => vec![
                Step::Move(Point2::new(made.leaves.x, at.y), Path::Rapid),
                Step::Move(made.leaves, Path::Line(feed)),
            ],
        };
        steps.extend(made.elements.iter().map(|(element, _)| {
            let path = match *element {
                Element::Line { .. } => Path::Line(feed),
                Element::Arc { center, sweep, .. } => {
                    let shape = ArcShape::Center { center, ccw: sweep > 0.0, tol: AGREES };
                    Path::Arc(Arc { plane: Plane::Zx, shape, turns: 0 }, feed)
                }
            };
            Step::Move(element.to(), path)
        }));
        // A tool that stood on the cylinder has reached its start X on the way.
        if !on_cylinder {
            steps.push(Step::Move(Point2::new(z, at.y), Path::Line(feed)));
        }
        Ok(steps)
    }

    /// +1 for an undercut outside, -1 for one inside, where the tool stands on the cylinder: its edge tells.
    fn undercut_outwards(&self) -> Made<f64> {
        let up = match self.known_tool().and_then(|tool| tool.orientation) {
            Some(3 | 4 | 8) => 1.0,
            Some(1 | 2 | 6) => -1.0,
            _ => return self.refuse(codes::P2004::tool_stands_on_cylinder()),
        };
        self.depends_on(Question::UndercutSide, self.given.place);
        Ok(up)
    }

    /// The edge of the tool points to the shoulder and to the cylinder, or not away from them at least.
    fn edge_fits(&self, sense: f64, up: f64) -> Made {
        let Some(edge) = self.known_tool().and_then(|tool| tool.orientation) else { return Ok(()) };
        let points = edge_direction(edge).unwrap_or_else(Vec2::zeros);
        if points.x * sense <= 0.0 && points.y * up <= 0.0 {
            return Ok(());
        }
        self.refuse(codes::T2025::tool_comes_to_undercut_from_side(&edge))
    }

    /// K tells the form: missing E, 0 F, else the width of DIN 76.
    fn undercut_sizes(&self, diameter: f64, inside: bool) -> Made<Undercut> {
        let form = self.given.length_if(word::K);
        let of_table = form.is_none_or(|k| k == 0.0);
        let tables = &self.settings.undercut;
        let limit = |range: &din509::Range| (range.upto - diameter).abs() <= tolerance::LOST;
        if of_table && !tables.says_sizes_by_diameter() && din509::PLUS_4110_G85.iter().any(limit) {
            self.depends_on(Question::UndercutLimit, self.given.place_of(word::X));
        }
        // A diameter at a limit belongs to the row below it or above it.
        let upper = self.settings.control.turning.undercut_upper == Some(true);
        let sought = diameter + if upper { tolerance::LOST } else { -tolerance::LOST };
        if of_table && self.given.or_zero(word::I) != 0.0 {
            return self.refuse_argument(word::I, codes::T9007::wear_oversize_of_undercut_e_or_f());
        }
        match form {
            None | Some(0.0) => match tables.size_for(sought, din509::PLUS_4110_G85) {
                Some((_, size)) => Ok(if form.is_none() { form_e(size) } else { form_f(size) }.into()),
                None => self.refuse_argument(word::X, codes::P1004::size_of_undercut_is_missing(&diameter)),
            },
            Some(width) => {
                let depth = match self.given.length_if(word::I) {
                    Some(depth) if depth > 0.0 => depth,
                    Some(_) => {
                        let fault = codes::T1007::has_to_be_above_zero(&"the depth of the undercut");
                        return self.refuse_argument(word::I, fault);
                    }
                    None => return self.refuse(codes::P1004::is_missing(&word::I, &"the depth of the undercut")),
                };
                match undercuts::radius_of_width(tables, width, inside) {
                    Some(radius) => Ok(undercuts::square(depth, width, radius, din76::ENTRY).into()),
                    None => self.refuse_argument(word::K, codes::T1007::no_undercut_of_din_76_is_mm(&width)),
                }
            }
        }
    }
}
