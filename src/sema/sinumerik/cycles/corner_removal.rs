//! CYCLE951: stock removal at a corner.
//!
//! The finished contour is always one line of three points: from the front edge of the blank at X1 over the corner to the
//! second side of the blank at Z1. Source: M 4 (docs/sources.md).

use crate::diag::codes;
use crate::geo::arc::sweep;
use crate::geo::tolerance;
use crate::geo::{Element, Point2, Vec2, cross, direction, distance};
use crate::ir::cycle::layers::{Allowance, Blank, Clearance, LayerFeeds, Layers, Limits, Relief, Segmentation, Trace};
use crate::ir::cycle::turning::Towards;

use super::call::{Acts, CycleCall};
use super::layers::{Side, rectangle};
use super::names::{AMODE, EPD, EPL, FALX, FALZ, FF1, LAGE, MID, NR, RF1, RF2, RF3, SDIS, SPD, SPL, VARI, ZPD, ZPL};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::Name;

/// The corner: blank, end point and the point between, as (Z, X radius).
#[derive(Debug, Clone, Copy)]
struct Corner {
    blank: Point2,
    end: Point2,
    between: Point2,
    inside: bool,
}

/// A transition between two lines.
#[derive(Debug, Clone, Copy)]
struct Transition {
    size: f64,
    chamfer: bool,
}

impl CycleCall<'_> {
    pub(super) fn corner_removal(&self) -> Made<Acts> {
        let given = self.given;
        self.removal_digits()?;
        let corner = self.corner()?;
        let Some(operation) = self.operation(given.digit(VARI, 1)).filter(|_| given.or_zero(VARI) < 100.0) else {
            return self.kind_fault(VARI, "tens 1 roughing, 2 finishing, 3 both");
        };
        let along_z = match given.digit(VARI, 0) {
            1 => true,
            2 => false,
            _ => return self.kind_fault(VARI, "units 1 along Z, 2 along X"),
        };
        let way = corner.end - corner.blank;
        let side = match (along_z, corner.inside) {
            (true, true) => Side { into: Towards::PlusX, along: way.x.signum() },
            (true, false) => Side { into: Towards::MinusX, along: way.x.signum() },
            (false, _) if way.x < 0.0 => Side { into: Towards::MinusZ, along: way.y.signum() },
            (false, _) => Side { into: Towards::PlusZ, along: way.y.signum() },
        };
        let (contour, _) = side.in_order(&self.corner_contour(&corner)?);
        let nose = self.nose_of_edge()?;
        let most = self.infeed(MID, operation)?;
        let clearance = self.given.magnitude(SDIS);
        if clearance == 0.0 {
            return self.refuse_argument(
                SDIS,
                codes::P2090::safety_distance_is_missing(&given.written(SDIS), &given.argument(SDIS)),
            );
        }
        let keys = &self.settings.cycles.layers;
        let lift = if corner.inside { keys.release_inside } else { keys.release_outside }.unwrap_or(clearance);
        let percent = keys.finish_feed_percent;
        let feed = self.mill_feed(FF1)?;
        let axes = Vec2::new(self.given.magnitude(FALZ), self.given.magnitude(FALX));
        let depth = if along_z { way.y.abs() - axes.y } else { way.x.abs() - axes.x };
        // Facing in one cut leaves no step that a way up the end wall would remove.
        let plain = !along_z && given.or_zero(NR) == 0.0 && depth <= most + tolerance::SAME;
        let out = if corner.inside { -clearance } else { clearance };
        let layers = Layers {
            contour,
            into: side.into,
            along: side.along,
            nose,
            blank: Blank::Outline(rectangle(corner.blank, corner.end)),
            allowance: Allowance { axes, around: 0.0 },
            most,
            segmentation: Segmentation::Uniform,
            trace: if plain { Trace::None } else { Trace::Level },
            chips: None,
            relief: Relief::Left,
            limits: Limits::default(),
            operation,
            finish_backwards: false,
            clearance: Clearance { lift, entry: clearance },
            feeds: LayerFeeds { rough: feed, plunge: feed, finish: feed.with_value(feed.value() * percent / 100.0) },
            home: Point2::new(corner.blank.x - way.x.signum() * clearance, corner.blank.y + out),
        };
        self.send_layers(layers)
    }

    fn corner(&self) -> Made<Corner> {
        let given = self.given;
        let blank = Point2::new(self.given.length(SPL), self.given.length(SPD) / 2.0);
        let position = given.or_zero(LAGE) as i32;
        let (inside, front) = (position >= 2, position % 2 == 1);
        // Increments lead into the material.
        let into = Vec2::new(if front { -1.0 } else { 1.0 }, if inside { 1.0 } else { -1.0 });
        let x = |key: Name, place: u32| {
            let value = given.length(key);
            if given.digit(AMODE, place) == 1 { blank.y + into.y * value.abs() } else { value / 2.0 }
        };
        let z = |key: Name, place: u32| {
            let value = given.length(key);
            if given.digit(AMODE, place) == 1 { blank.x + into.x * value.abs() } else { value }
        };
        let end = Point2::new(z(EPL, 1), x(EPD, 0));
        if (end.y - blank.y) * into.y <= tolerance::SAME {
            return self.no_material(EPD, "X1 does not lie in the material, seen from X0");
        }
        if (end.x - blank.x) * into.x <= tolerance::SAME {
            return self.no_material(EPL, "Z1 does not lie in the material, seen from Z0");
        }
        let between = if given.or_zero(NR) == 2.0 { Point2::new(z(ZPL, 3), x(ZPD, 2)) } else { end };
        let outside = |a: f64, b: f64, v: f64| v < a.min(b) - tolerance::SAME || v > a.max(b) + tolerance::SAME;
        if outside(blank.y, end.y, between.y) {
            return self.no_material(ZPD, "XM does not lie between X0 and X1");
        }
        if outside(blank.x, end.x, between.x) {
            return self.no_material(ZPL, "ZM does not lie between Z0 and Z1");
        }
        Ok(Corner { blank, end, between, inside })
    }

    /// The line from the front of the blank over the corner to its second side, with its transitions.
    fn corner_contour(&self, corner: &Corner) -> Made<Vec<Element>> {
        let given = self.given;
        let way = corner.end - corner.blank;
        let first = Point2::new(corner.blank.x, corner.end.y);
        let last = Point2::new(corner.end.x, corner.blank.y);
        // The front face of the blank, and its second side.
        let before = first + Vec2::new(0.0, way.y);
        let behind = last + Vec2::new(way.x, 0.0);
        let points = [before, first, corner.between, last, behind];
        let with_transitions = given.or_zero(NR) != 0.0;
        let mut sizes = [Transition { size: 0.0, chamfer: false }; 3];
        for ((key, place), transition) in [(RF1, 4), (RF2, 5), (RF3, 6)].into_iter().zip(&mut sizes) {
            let size = self.given.magnitude(key);
            if with_transitions {
                *transition = Transition { size, chamfer: given.digit(AMODE, place) == 1 };
            } else if size != 0.0 {
                self.unused(key, "by a corner without transitions (`_NR` 0)");
            }
        }
        let mut contour: Vec<Element> = Vec::with_capacity(5);
        let mut at: Option<Point2> = None;
        for ((points, key), transition) in points.windows(3).zip([RF1, RF2, RF3]).zip(sizes) {
            let Some((from, piece, to)) = transition_at([points[0], points[1], points[2]], transition) else {
                continue;
            };
            // The edges on both sides are long enough.
            let ahead = at.map_or(0.0, |at| (from - at).dot(&(points[1] - points[0])));
            let room = distance(points[1], to) <= distance(points[1], points[2]) + tolerance::SAME;
            if ahead < -tolerance::SAME || !room {
                return self.refuse_argument(
                    key,
                    codes::P2090::transition_is_larger_than_its_edge(&given.written(key), &given.argument(key)),
                );
            }
            if let Some(at) = at.filter(|at| distance(*at, from) > tolerance::SAME) {
                contour.push(Element::Line { from: at, to: from });
            }
            contour.extend(piece);
            at = Some(to);
        }
        Ok(contour)
    }
}

/// The transition at the middle one of three points: where it begins, the transition and where it ends. A point without
/// room for one stands for itself; `None` where two points are one.
fn transition_at(points: [Point2; 3], transition: Transition) -> Option<(Point2, Option<Element>, Point2)> {
    let [a, p, b] = points;
    let (Some(back), Some(ahead)) = (direction(a - p, tolerance::SAME), direction(b - p, tolerance::SAME)) else {
        return Some((p, None, p));
    };
    let size = transition.size;
    let turn = cross(-back, ahead);
    if size <= 0.0 || turn.abs() <= tolerance::SAME {
        return Some((p, None, p));
    }
    if transition.chamfer {
        let (from, to) = (p + back * size, p + ahead * size);
        return Some((from, Some(Element::Line { from, to }), to));
    }
    // From the corner to where the arc begins: R / tan of half the angle between the edges.
    let half = libm::acos(back.dot(&ahead).clamp(-1.0, 1.0)) / 2.0;
    let way = size / libm::tan(half);
    let (from, to) = (p + back * way, p + ahead * way);
    let center = p + direction(back + ahead, tolerance::SAME)? * (size / libm::sin(half));
    Some((from, Some(Element::Arc { from, to, center, sweep: sweep(from, to, center, turn > 0.0) }), to))
}
