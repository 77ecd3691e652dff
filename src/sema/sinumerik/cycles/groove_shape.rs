//! The shape of a groove of CYCLE93 and CYCLE930: two flanks, a floor, four corners.
//!
//! In: sizes as the calls give them, in mm, and the side of the part. Out: the contour from the rim at the reference point to
//! the other one, points (Z, X) with X as a radius.

use crate::geo::corner::{Cut, NoCut, Size, chamfer, chamfer_of_length, rounding};
use crate::geo::tolerance;
use crate::geo::{Deg, Element, Point2, Vec2, arc, distance};
use crate::ir::cycle::grooving::GrooveAllowance;
use crate::ir::cycle::turning::Towards;

/// What a tool may be wider than a groove, mm.
const TOO_WIDE: f64 = 1e-6;

/// Where a groove is cut, and from which of its rims it counts: the units of VARI.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct GrooveSide {
    pub into: Towards,
    /// The other rim lies towards plus on the cutting axis.
    pub towards_plus: bool,
}

impl GrooveSide {
    /// The side by its number, 1 to 8.
    pub fn numbered(number: i32) -> Option<GrooveSide> {
        let (into, towards_plus) = match number {
            1 => (Towards::MinusX, true),
            5 => (Towards::MinusX, false),
            3 => (Towards::PlusX, true),
            7 => (Towards::PlusX, false),
            2 => (Towards::PlusZ, false),
            6 => (Towards::MinusZ, false),
            4 => (Towards::PlusZ, true),
            8 => (Towards::MinusZ, true),
            _ => return None,
        };
        Some(GrooveSide { into, towards_plus })
    }
}

/// Sizes of a groove. Pairs begin on the side of the reference point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GrooveShape {
    pub side: GrooveSide,
    /// The reference point; at the floor if `at_floor`.
    pub reference: Point2,
    pub at_floor: bool,
    pub floor_width: f64,
    pub depth: f64,
    pub flanks: [Deg; 2],
    /// Edges at the surface.
    pub outer: [Option<Size>; 2],
    /// Corners at the floor.
    pub inner: [Option<Size>; 2],
}

/// The corner that does not fit, counted from 0 in the order of the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct CornerFault(pub usize);

/// What an allowance counts along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Left {
    /// Square to floor and flanks.
    Square { floor: f64, flanks: f64 },
    /// Along the surface and into the depth.
    Along { surface: f64, depth: f64 },
}

impl Left {
    pub fn floor(self) -> f64 {
        match self {
            Left::Square { floor, .. } => floor,
            Left::Along { depth, .. } => depth,
        }
    }
}

fn tan(angle: Deg) -> f64 {
    let (sin, cos) = angle.sin_cos();
    sin / cos
}

impl GrooveShape {
    /// A point `along` the surface from the rim at the reference point towards the other one, and `down` from the surface.
    fn point(&self, along: f64, down: f64) -> Point2 {
        let along = if self.side.towards_plus { along } else { -along };
        let (from, down) = match self.at_floor {
            // The rim lies outwards of the reference point, and above it.
            true => {
                let out = self.depth * tan(self.flanks[0]);
                (along - if self.side.towards_plus { out } else { -out }, down - self.depth)
            }
            false => (along, down),
        };
        let surface = if self.side.into.is_radial() { Vec2::x() } else { Vec2::y() };
        self.reference + self.side.into.unit() * down + surface * from
    }

    /// Width at the surface.
    pub fn top_width(&self) -> f64 {
        self.floor_width + self.depth * (tan(self.flanks[0]) + tan(self.flanks[1]))
    }

    /// Height of the surface on the infeed axis.
    pub fn surface(&self) -> f64 {
        self.side.into.depth_coordinate(self.point(0.0, 0.0))
    }

    /// Height of the floor on the infeed axis.
    pub fn floor(&self) -> f64 {
        self.side.into.depth_coordinate(self.point(0.0, self.depth))
    }

    /// The contour from rim to rim.
    ///
    /// # Errors
    /// The corner that does not fit.
    pub fn contour(&self) -> Result<Vec<Element>, CornerFault> {
        let first = self.depth * tan(self.flanks[0]);
        let (foot, top) = (first + self.floor_width, self.top_width());
        // The surface on both sides, longer than any corner takes of it.
        let far = top + self.depth + 1e4;
        let corners = [(0.0, 0.0), (first, self.depth), (foot, self.depth), (top, 0.0)];
        let corners = corners.map(|(along, down)| self.point(along, down));
        let sizes = [self.outer[0], self.inner[0], self.inner[1], self.outer[1]];
        let mut before = Element::Line { from: self.point(-far, 0.0), to: corners[0] };
        let mut list = Vec::with_capacity(7);
        for (at, size) in sizes.into_iter().enumerate() {
            let to = corners.get(at + 1).copied().unwrap_or_else(|| self.point(top + far, 0.0));
            let after = Element::Line { from: corners[at], to };
            let (leave, join, round) = match size {
                None => (corners[at], corners[at], None),
                Some(size) => {
                    let cut = cut(&before, &after, size).map_err(|_| CornerFault(at))?;
                    (cut.leave, cut.join, Some(cut.arc))
                }
            };
            if at > 0 && distance(leave, before.from()) > tolerance::LOST {
                list.push(Element::Line { from: before.from(), to: leave });
            }
            match round {
                None => {}
                Some(None) => list.push(Element::Line { from: leave, to: join }),
                Some(Some((center, ccw))) => {
                    let sweep = arc::sweep(leave, join, center, ccw);
                    list.push(Element::Arc { from: leave, to: join, center, sweep });
                }
            }
            before = Element::Line { from: join, to };
        }
        Ok(list)
    }

    /// How far the corners at the surface reach below it, of a contour of this shape.
    pub fn rims(&self, contour: &[Element]) -> [f64; 2] {
        let below = |corner: Option<Size>, foot: Option<Point2>| match (corner, foot) {
            (Some(_), Some(foot)) => (self.side.into.depth_coordinate(foot) - self.surface()).abs(),
            _ => 0.0,
        };
        [
            below(self.outer[0], contour.first().map(Element::to)),
            below(self.outer[1], contour.last().map(Element::from)),
        ]
    }

    /// How far the walls move together, and the floor up, for what is left on the groove.
    pub fn allowance(&self, left: Left) -> GrooveAllowance {
        match left {
            // The smaller one everywhere. Moved by (along, up) a flank comes out by `along cos + up sin`.
            Left::Square { floor, flanks } => {
                let around = floor.min(flanks);
                let (floor, flanks) = (floor - around, flanks - around);
                let walls = self.flanks.map(|angle| {
                    let (sin, cos) = angle.sin_cos();
                    (flanks - floor * sin) / cos
                });
                GrooveAllowance { around, walls, depth: floor }
            }
            Left::Along { surface, depth } => GrooveAllowance { around: 0.0, walls: [surface; 2], depth },
        }
    }

    /// Less on the flanks, so that a tool of `width` reaches the floor; `None` where nothing has to change.
    pub fn left_for(&self, left: Left, width: f64) -> Option<Left> {
        let taken: f64 = match left {
            Left::Square { floor, flanks } => {
                self.flanks.iter().map(|angle| angle.sin_cos()).map(|(sin, cos)| (flanks - floor * sin) / cos).sum()
            }
            Left::Along { surface, .. } => 2.0 * surface,
        };
        let missing = width - (self.floor_width - taken);
        if missing <= TOO_WIDE {
            return None;
        }
        Some(match left {
            Left::Square { floor, flanks } => {
                let [a, b] = self.flanks.map(|angle| angle.sin_cos().1);
                Left::Square { floor, flanks: (flanks - missing / (1.0 / a + 1.0 / b)).max(0.0) }
            }
            Left::Along { surface, depth } => Left::Along { surface: (surface - missing / 2.0).max(0.0), depth },
        })
    }
}

fn cut(before: &Element, after: &Element, size: Size) -> Result<Cut, NoCut> {
    match size {
        Size::Radius(radius) => rounding(before, after, radius, tolerance::LOST),
        Size::Side(side) => chamfer(before, after, side, tolerance::LOST),
        Size::Length(length) => chamfer_of_length(before, after, length, tolerance::LOST),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// B1 10, T1 6, flanks of 15 and 20 degrees, reference top right X60 Z-30.
    fn shape() -> GrooveShape {
        GrooveShape {
            side: GrooveSide::numbered(5).expect("a side"),
            reference: Point2::new(-30.0, 30.0),
            at_floor: false,
            floor_width: 10.0,
            depth: 6.0,
            flanks: [Deg(15.0), Deg(20.0)],
            outer: [None; 2],
            inner: [None; 2],
        }
    }

    fn points(shape: &GrooveShape) -> Vec<(f64, f64)> {
        let contour = shape.contour().expect("a groove");
        let round = |v: f64| (v * 1e4).round() / 1e4;
        let point = |p: Point2| (round(p.x), round(p.y));
        contour.first().map(|e| point(e.from())).into_iter().chain(contour.iter().map(|e| point(e.to()))).collect()
    }

    #[test]
    fn straight_flanks() {
        let shape = shape();
        assert_eq!((shape.top_width() * 1e4).round() / 1e4, 13.7915);
        assert_eq!(points(&shape), [(-30.0, 30.0), (-31.6077, 24.0), (-41.6077, 24.0), (-43.7915, 30.0)]);
    }

    #[test]
    fn reference_at_the_floor() {
        let shape = GrooveShape { at_floor: true, reference: Point2::new(-31.0, 24.0), ..shape() };
        let top = -31.0 + 6.0 * libm::tan(15f64.to_radians());
        assert_eq!(points(&shape)[0], ((top * 1e4).round() / 1e4, 30.0));
        assert_eq!(points(&shape)[1], (-31.0, 24.0));
        assert_eq!((shape.surface(), shape.floor()), (30.0, 24.0));
        let left = GrooveShape { side: GrooveSide::numbered(1).expect("a side"), ..shape };
        assert_eq!(points(&left)[1..3], [(-31.0, 24.0), (-21.0, 24.0)]);
    }

    #[test]
    fn all_sides() {
        let plain = GrooveShape { flanks: [Deg(0.0); 2], ..shape() };
        let floor = |side: i32| {
            let shape = GrooveShape { side: GrooveSide::numbered(side).expect("a side"), ..plain };
            let points = points(&shape);
            (points[1], points[2])
        };
        assert_eq!(floor(1), ((-30.0, 24.0), (-20.0, 24.0)));
        assert_eq!(floor(3), ((-30.0, 36.0), (-20.0, 36.0)));
        assert_eq!(floor(5), ((-30.0, 24.0), (-40.0, 24.0)));
        assert_eq!(floor(7), ((-30.0, 36.0), (-40.0, 36.0)));
        assert_eq!(floor(2), ((-24.0, 30.0), (-24.0, 20.0)));
        assert_eq!(floor(6), ((-36.0, 30.0), (-36.0, 20.0)));
        assert_eq!(floor(4), ((-24.0, 30.0), (-24.0, 40.0)));
        assert_eq!(floor(8), ((-36.0, 30.0), (-36.0, 40.0)));
        assert_eq!(GrooveSide::numbered(9), None);
    }

    #[test]
    fn corners() {
        let plain = GrooveShape { flanks: [Deg(0.0); 2], ..shape() };
        let cut = GrooveShape {
            outer: [Some(Size::Side(0.5)), Some(Size::Length(1.0))],
            inner: [Some(Size::Radius(1.0)), None],
            ..plain
        };
        let round = |v: f64| (v * 1e4).round() / 1e4;
        assert_eq!(
            cut.rims(&cut.contour().expect("a groove")).map(round),
            [0.5, round(std::f64::consts::FRAC_1_SQRT_2)]
        );
        assert_eq!(plain.rims(&plain.contour().expect("a groove")), [0.0; 2]);
        let half = (std::f64::consts::FRAC_1_SQRT_2 * 1e4).round() / 1e4;
        assert_eq!(
            points(&cut),
            [
                (-29.5, 30.0),
                (-30.0, 29.5),
                (-30.0, 25.0),
                (-31.0, 24.0),
                (-40.0, 24.0),
                (-40.0, round(30.0 - half)),
                (round(-40.0 - half), 30.0)
            ]
        );
        let wide = GrooveShape { inner: [Some(Size::Radius(5.0)), Some(Size::Radius(5.1))], ..plain };
        assert_eq!(wide.contour(), Err(CornerFault(2)));
        let deep =
            GrooveShape { outer: [Some(Size::Radius(4.0)), None], inner: [Some(Size::Radius(2.1)), None], ..plain };
        assert_eq!(deep.contour(), Err(CornerFault(1)));
        // Exactly as large as the flank.
        let full =
            GrooveShape { outer: [Some(Size::Radius(4.0)), None], inner: [Some(Size::Radius(2.0)), None], ..plain };
        assert_eq!(full.contour().expect("a groove").len(), 4);
    }

    #[test]
    fn allowances() {
        let shape = shape();
        let made = shape.allowance(Left::Square { floor: 0.1, flanks: 0.1 });
        assert_eq!(made, GrooveAllowance { around: 0.1, walls: [0.0; 2], depth: 0.0 });
        // Raised by 0.1 more, the right flank of 15 degrees slides outwards.
        let made = shape.allowance(Left::Square { floor: 0.2, flanks: 0.1 });
        assert!((made.walls[0] + 0.1 * libm::tan(15f64.to_radians())).abs() < 1e-12, "{made:?}");
        assert_eq!(shape.left_for(Left::Square { floor: 0.1, flanks: 0.1 }, 3.0), None);
        let plain = GrooveShape { flanks: [Deg(0.0); 2], ..shape };
        let less = plain.left_for(Left::Square { floor: 0.1, flanks: 0.2 }, 9.8);
        assert!(matches!(less, Some(Left::Square { floor: 0.1, flanks }) if (flanks - 0.1).abs() < 1e-12), "{less:?}");
        let none = plain.left_for(Left::Along { surface: 0.2, depth: 0.1 }, 10.0);
        assert!(matches!(none, Some(Left::Along { surface, .. }) if surface.abs() < 1e-12), "{none:?}");
    }
}
