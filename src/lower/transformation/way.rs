//! A way in X, Y and Z as the program sees it, from 0 to 1.

use crate::geo::{Plane, Point2, Vec2, distance};
use crate::ir::Pos;
use crate::ir::motion::{Arc, Move, Path};
use crate::machine::Axis;

use super::{on_arc, passes};

/// Places inside a part at which its error is looked at.
const LOOKS: u32 = 15;

pub struct Way<'a> {
    from: [f64; 3],
    to: [f64; 3],
    arc: Option<&'a Arc>,
}

impl<'a> Way<'a> {
    /// The way from `at` to the end of `mv`. Axes that are not known stay at 0.
    pub fn new(at: &Pos, mv: &'a Move) -> Way<'a> {
        let main = [Axis::X, Axis::Y, Axis::Z];
        let to = main.map(|axis| mv.end.get(axis).unwrap_or(0.0));
        let from = [0, 1, 2].map(|i| at.get(main[i]).unwrap_or(to[i]));
        let arc = match &mv.path {
            Path::Arc(arc, _) => Some(arc),
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => None,
        };
        Way { from, to, arc }
    }

    /// X, Y and Z at a share of the way; its end is exact.
    pub fn place(&self, share: f64) -> [f64; 3] {
        if share >= 1.0 {
            return self.to;
        }
        let mut place = [0, 1, 2].map(|i| self.from[i] + (self.to[i] - self.from[i]) * share);
        if let Some(arc) = self.arc {
            let (first, second, _) = arc.plane.axes();
            let p = on_arc(arc, share);
            (place[first], place[second]) = (p.x, p.y);
        }
        place
    }

    /// The same in the plane of a face.
    pub fn in_face(&self, share: f64) -> Point2 {
        let [x, y, _] = self.place(share);
        Point2::new(x, y)
    }

    /// Length of the way in mm.
    pub fn length(&self) -> f64 {
        let delta = [0, 1, 2].map(|i| self.to[i] - self.from[i]);
        let Some(arc) = self.arc else {
            return libm::sqrt(delta.iter().map(|d| d * d).sum());
        };
        let (_, _, third) = arc.plane.axes();
        libm::hypot(distance(arc.from, arc.center) * arc.sweep, delta[third])
    }

    /// How close the way comes to the axis of rotation.
    pub fn closest(&self) -> f64 {
        let pole = Point2::origin();
        let ends = distance(self.in_face(0.0), pole).min(distance(self.in_face(1.0), pole));
        match self.arc {
            None => to_line(self.in_face(0.0), self.in_face(1.0)),
            Some(arc) if arc.plane == Plane::Xy => {
                let towards = pole - arc.center;
                let inside = (towards.norm() - distance(arc.from, arc.center)).abs();
                if passes(arc, towards) { inside.min(ends) } else { ends }
            }
            // Seen along the axis an upright arc is a line, or a wave where another axis goes along.
            Some(_) => (0..STEPS).fold(ends, |closest, i| {
                let share = |i: u32| f64::from(i) / f64::from(STEPS);
                closest.min(to_line(self.in_face(share(i)), self.in_face(share(i + 1))))
            }),
        }
    }

    /// The smallest number of even parts in which radius and angle go evenly and stay within `tolerance` of the way.
    pub fn parts(&self, tolerance: f64, most: u32) -> Option<u32> {
        let quarters = self.arc.map_or(0.0, |arc| arc.sweep.abs() / core::f64::consts::FRAC_PI_2);
        let least = libm::ceil(quarters - 1e-9).clamp(1.0, f64::from(most)) as u32;
        let (mut short, mut enough) = (least - 1, least);
        while !self.fits(enough, tolerance) {
            if enough >= most {
                return None;
            }
            (short, enough) = (enough, (enough * 2).min(most));
        }
        while enough - short > 1 {
            let middle = short + (enough - short) / 2;
            if self.fits(middle, tolerance) {
                enough = middle;
            } else {
                short = middle;
            }
        }
        Some(enough)
    }

    fn fits(&self, parts: u32, tolerance: f64) -> bool {
        let count = f64::from(parts);
        let mut from = Polar::of(self.in_face(0.0), 0.0);
        (0..parts).all(|part| {
            let to = Polar::of(self.in_face(f64::from(part + 1) / count), from.angle);
            let near = (1..=LOOKS).all(|look| {
                let share = f64::from(look) / f64::from(LOOKS + 1);
                let made = from.towards(&to, share).point();
                distance(made, self.in_face((f64::from(part) + share) / count)) <= tolerance
            });
            from = to;
            near
        })
    }
}

/// Lines as which an upright arc is seen along the axis.
const STEPS: u32 = 720;

/// A place on the face by distance and angle, which counts on.
struct Polar {
    radius: f64,
    /// rad
    angle: f64,
}

impl Polar {
    fn of(p: Point2, near: f64) -> Polar {
        let angle = libm::atan2(p.y, p.x);
        let turn = core::f64::consts::TAU;
        Polar { radius: libm::hypot(p.x, p.y), angle: angle + turn * libm::round((near - angle) / turn) }
    }

    /// Where axes that go evenly are at a share of their way.
    fn towards(&self, to: &Polar, share: f64) -> Polar {
        let between = |from: f64, to: f64| from + (to - from) * share;
        Polar { radius: between(self.radius, to.radius), angle: between(self.angle, to.angle) }
    }

    fn point(&self) -> Point2 {
        Point2::new(self.radius * libm::cos(self.angle), self.radius * libm::sin(self.angle))
    }
}

/// Distance of the origin from the line between two points.
fn to_line(from: Point2, to: Point2) -> f64 {
    let way: Vec2 = to - from;
    let share = if way.norm_squared() > 0.0 { -from.coords.dot(&way) / way.norm_squared() } else { 0.0 };
    (from.coords + way * share.clamp(0.0, 1.0)).norm()
}
