//! The nose of the tool, as `[tools]` knows it, and where a contour can be cut without it.
//!
//! Along the axes the programmed point of a tool that points to the material is exact. On slopes and arcs the nose touches
//! elsewhere: there its radius has to be known.

use crate::diag::{Answer, Label, codes};
use crate::geo::{Element, Vec2};
use crate::ir::cycle::layers::{Layers, Relief};
use crate::ir::cycle::roughing::Nose;
use crate::sema::common::compensation::edge_direction;
use crate::sema::cycle::call::{Elsewhere, Kind, Made};
use crate::sema::run::Where;

use super::super::outline::Section;
use super::super::sides::FormKind;
use super::CycleCall;

/// How far the ends of a line along an axis may lie apart across it, mm: what four decimals lose.
const ON_AXIS: f64 = 1e-4;

/// What of a contour the programmed point alone does not make.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Need {
    Slope,
    Arc,
    /// Walls that face each other, or the other way than the edge points.
    Wall,
}

impl Need {
    fn name(self) -> &'static str {
        match self {
            Need::Slope => "a slope",
            Need::Arc => "an arc",
            Need::Wall => "a wall that its point does not touch",
        }
    }
}

/// A part of the contour that is cut: the element, and the direction from it to the tool where it lies along an axis.
type Piece = (Element, Vec2);

impl CycleCall<'_> {
    /// The nose of the tool in the cutting position; `None` where it has no radius, or nothing is known of it.
    ///
    /// # Errors
    /// P2004 for a radius without the position of the edge.
    pub(super) fn nose_of_tool(&self) -> Made<Option<Nose>> {
        let known = self.known_tool();
        let Some(radius) = known.and_then(|tool| tool.radius) else { return Ok(None) };
        let tip = match self.tip_of_tool() {
            Some(tip) => tip,
            None if radius == 0.0 => return Ok(None),
            None => {
                return self.refuse(match known.and_then(|tool| tool.orientation) {
                    Some(position) => codes::P2004::edge_position_of_tool_has_no_corner(&position),
                    None => {
                        let active = self.st.modal.tool.as_ref();
                        let answer = active.map(|tool| Answer::tool(tool.number, "orientation"));
                        codes::P2004::edge_position_of_tool_is_not_known().answers(answer)
                    }
                });
            }
        };
        Ok(Some(Nose { radius, tip }))
    }

    /// The corner that the edge of the tool points to.
    pub(super) fn tip_of_tool(&self) -> Option<Vec2> {
        edge_direction(self.known_tool()?.orientation?).filter(|tip| tip.x != 0.0 && tip.y != 0.0)
    }

    /// A nose of unknown radius does not matter along what finishing cuts. `left_out`: the direction of elements that are left out.
    pub(super) fn nose_matters_not(&self, contour: &[Element], left: bool, left_out: Option<Vec2>) -> Made {
        let aside = |way: Vec2| if left { crate::geo::left(way) } else { -crate::geo::left(way) };
        let cut = contour.iter().filter(|e| left_out.is_none_or(|into| (e.to() - e.from()).dot(&into) <= ON_AXIS));
        let pieces: Vec<Piece> = cut.map(|e| (*e, aside(e.to() - e.from()))).collect();
        self.point_is_enough(&pieces)
    }

    /// The same for what roughing cuts, and for the cut along the contour behind it.
    pub(super) fn nose_matters_not_in(&self, layers: &Layers) -> Made {
        self.point_is_enough(&pieces_of(layers))
    }

    /// # Errors
    /// P2004 where the nose radius is not known and the pieces need it; along the axes note T2027.
    fn point_is_enough(&self, pieces: &[Piece]) -> Made {
        let known = self.known_tool();
        if known.and_then(|tool| tool.radius).is_some() {
            return Ok(());
        }
        let tip = known.and_then(|tool| tool.orientation).and_then(edge_direction);
        let Some(need) = need(pieces, tip) else {
            let fault = if reach_centre(pieces) {
                codes::T2027::nose_leaves_inner_corners_and_pip()
            } else {
                codes::T2027::nose_leaves_inner_corners()
            };
            self.note(Where::Block, fault, Kind::Once);
            return Ok(());
        };
        let what = need.name();
        self.refuse(match self.st.modal.tool.as_ref() {
            Some(tool) => codes::P2004::contour_needs_nose_radius_of_tool(&tool.number, &what)
                .answers(self.answers_of_nose(tool.number)),
            None => codes::P2004::contour_needs_nose_radius_of_no_tool(&what),
        })
    }

    /// What is cut has an arc: around a corner at the distance of G58.
    pub(super) fn arc_needs_nose(&self) -> Made {
        if self.known_tool().and_then(|tool| tool.radius).is_some() {
            return Ok(());
        }
        self.refuse(match self.st.modal.tool.as_ref() {
            Some(tool) => {
                codes::P2004::arc_needs_nose_radius_of_tool(&tool.number).answers(self.answers_of_nose(tool.number))
            }
            None => codes::P2004::arc_needs_nose_radius_of_no_tool(),
        })
    }

    /// What says the nose of the tool in the cutting position.
    pub(super) fn answers_of_nose(&self, number: u32) -> impl Iterator<Item = Answer> {
        let known = self.known_tool().and_then(|tool| tool.orientation);
        let missing = known.is_none().then(|| Answer::tool(number, "orientation"));
        [Answer::tool(number, "radius")].into_iter().chain(missing)
    }

    /// The recesses and undercuts of the contour lie on the side of the tool.
    pub(super) fn check_forms(&self, section: &Section, tool_left: bool) -> Made {
        let wrong = section.edges.iter().filter_map(|edge| edge.form).find(|form| form.left != tool_left);
        let Some(form) = wrong else { return Ok(()) };
        let fault = match form.kind {
            FormKind::Recess => codes::T3050::recess_rises_out_of_material(),
            FormKind::Undercut => codes::T3050::undercut_stands_at_convex_edge(),
        };
        self.refuse_elsewhere(Elsewhere { place: form.loc, fault, call: Label::CycleThatCuts })
    }
}

/// What roughing cuts of a contour: without what falls, leans over or lies in the shadow where that is left standing.
fn pieces_of(layers: &Layers) -> Vec<Piece> {
    let (into, along) = (layers.into.unit(), layers.side_of_cuts());
    let shadows = if layers.relief == Relief::Left { layers.reliefs() } else { Vec::new() };
    let in_shadow = |e: &Element| {
        let ends = [e.from(), e.to()].map(|p| layers.into.cutting_coordinate(p));
        let inside = |p: f64, (a, b): (f64, f64)| p >= a.min(b) - ON_AXIS && p <= a.max(b) + ON_AXIS;
        shadows.iter().any(|shadow| ends.iter().all(|p| inside(*p, *shadow)))
    };
    let kept = |e: &&Element| {
        let way = e.to() - e.from();
        let falls = layers.relief == Relief::Left && way.dot(&into) > ON_AXIS;
        let leans = way.dot(&along) < -ON_AXIS;
        !falls && !leans && !in_shadow(e)
    };
    let aside = |e: &Element| {
        let way = e.to() - e.from();
        let level = way.dot(&into).abs() <= ON_AXIS;
        match (level, way.dot(&into) > 0.0) {
            (true, _) => -into,
            (false, false) => -along,
            (false, true) => along,
        }
    };
    layers.contour.iter().filter(kept).map(|e| (*e, aside(e))).collect()
}

/// Does a face end at the turning centre?
fn reach_centre(pieces: &[Piece]) -> bool {
    let is_face = |e: &Element| (e.to().y - e.from().y).abs() > ON_AXIS;
    pieces.iter().any(|(e, _)| is_face(e) && e.from().y.abs().min(e.to().y.abs()) <= ON_AXIS)
}

/// What needs the radius of the nose. `tip`: where its programmed point lies from the centre, in radii.
fn need(pieces: &[Piece], tip: Option<Vec2>) -> Option<Need> {
    let mut seen = [Vec2::zeros(); 2];
    pieces.iter().find_map(|(element, aside)| {
        let way = element.to() - element.from();
        let line = matches!(element, Element::Line { .. });
        let along = match (way.x.abs() > ON_AXIS, way.y.abs() > ON_AXIS) {
            _ if !line => return Some(Need::Arc),
            (true, true) => return Some(Need::Slope),
            (false, false) => return None,
            (true, false) => 0,
            (false, true) => 1,
        };
        let unit = |v: f64| if v.abs() > ON_AXIS { v.signum() } else { 0.0 };
        let aside = aside.map(unit);
        let turned = core::mem::replace(&mut seen[along], aside).dot(&aside) < 0.0;
        let off = tip.is_some_and(|tip| tip.dot(&aside) != -1.0);
        (turned || off).then_some(Need::Wall)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::Point2;

    fn line(a: (f64, f64), b: (f64, f64)) -> Element {
        Element::Line { from: Point2::new(a.0, a.1), to: Point2::new(b.0, b.1) }
    }

    /// Needs of a chain of lines through points (Z, X), the tool on its right.
    fn of(points: &[(f64, f64)], tip: Option<(f64, f64)>) -> Option<Need> {
        let pieces: Vec<Piece> = points
            .windows(2)
            .map(|pair| {
                let element = line(pair[0], pair[1]);
                (element, -crate::geo::left(element.to() - element.from()))
            })
            .collect();
        need(&pieces, tip.map(|tip| Vec2::new(tip.0, tip.1)))
    }

    #[test]
    fn stairs_need_no_nose() {
        let stairs = [(0.0, 0.0), (0.0, 10.0), (-10.0, 10.0), (-10.0, 20.0), (-30.0, 20.0)];
        assert_eq!(of(&stairs, None), None);
        assert_eq!(of(&stairs, Some((-1.0, -1.0))), None);
        assert_eq!(of(&stairs, Some((1.0, -1.0))), Some(Need::Wall));
        assert_eq!(of(&stairs, Some((0.0, -1.0))), Some(Need::Wall));
    }

    #[test]
    fn slopes_arcs_and_walls_on_both_sides_need_it() {
        assert_eq!(of(&[(0.0, 10.0), (-10.0, 11.0)], None), Some(Need::Slope));
        let collar = [(0.0, 10.0), (-10.0, 10.0), (-10.0, 20.0), (-20.0, 20.0), (-20.0, 10.0), (-30.0, 10.0)];
        assert_eq!(of(&collar, None), Some(Need::Wall));
        let (from, to) = (Point2::new(0.0, 10.0), Point2::new(-5.0, 15.0));
        let arc = Element::Arc { from, to, center: Point2::new(0.0, 15.0), sweep: -1.5 };
        assert_eq!(need(&[(arc, Vec2::zeros())], None), Some(Need::Arc));
    }
}
