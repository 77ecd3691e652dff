//! An undercut as the standards draw it, in the frame of its corner: along the cylinder, and along the face.

use super::super::layers::{chance, real};
use super::super::turning::{P, Sweep};
use crate::damage::Dice;

/// How far the cylinder and the face reach.
const LONG: f64 = 500.0;

#[derive(Debug, Clone, Copy)]
pub(super) struct Shape {
    /// From the corner to where the slope begins on the finished cylinder.
    pub length: f64,
    pub depth: f64,
    /// Degrees.
    pub entry: f64,
    /// At the foot of the slope and at the face; 0 for a sharp one.
    pub radii: [f64; 2],
    /// Depth behind the face of form F.
    pub behind: Option<f64>,
}

/// The finished part from the cylinder to the face.
pub(super) struct Outline {
    pieces: Vec<Sweep>,
    /// Sharp inner corners, and the turn there in radians.
    sharp: Vec<(P, f64)>,
    join: P,
    top: f64,
}

fn tan(degrees: f64) -> f64 {
    if degrees == 90.0 { f64::INFINITY } else { degrees.to_radians().tan() }
}

impl Shape {
    pub(super) fn free(dice: &mut Dice) -> Shape {
        let depth = real(dice, 0.3, 4.0);
        let entry = if chance(dice, 20) { 90.0 } else { real(dice, 30.0, 90.0) };
        let radius = |dice: &mut Dice| if chance(dice, 20) { 0.0 } else { real(dice, 0.1, 2.0) };
        let radii = [radius(dice), radius(dice)];
        let length = depth / tan(entry) + radii[0] + radii[1] + real(dice, 0.2, 8.0);
        Shape { length: (length * 1e3).ceil() / 1e3, depth, entry, radii, behind: None }
    }

    fn slope(&self) -> f64 {
        self.depth / tan(self.entry)
    }

    /// Length that the rounding at the foot of the slope takes of it.
    fn taken(&self) -> f64 {
        self.radii[0] * (self.entry.to_radians() / 2.0).tan()
    }

    /// A rounding larger than an upright slope is made as large as fits.
    pub(super) fn cut_radii(&self) -> [f64; 2] {
        let length = self.depth / self.entry.to_radians().sin();
        let [a, b] = self.radii;
        [if self.taken() > length { length / (self.entry.to_radians() / 2.0).tan() } else { a }, b]
    }

    /// Is there room for slope, floor and roundings?
    pub(super) fn fits(&self) -> bool {
        let [a, b] = self.cut_radii();
        let taken = a * (self.entry.to_radians() / 2.0).tan();
        self.length - self.slope() >= taken + b
    }

    /// Does the nose find no way between slope and face, or would it pass over a rounding there?
    pub(super) fn is_tight(&self, nose: f64) -> bool {
        let [a, b] = self.cut_radii();
        let taken = a.max(nose) * (self.entry.to_radians() / 2.0).tan() + b.max(nose);
        self.length - self.slope() < taken + 1e-3
    }

    /// The outline with a raised cylinder and face, moved along both; the face ends at `top`.
    pub(super) fn outline(&self, [cylinder, face]: P, [z, x]: P, top: f64) -> Outline {
        let foot = self.length - self.slope();
        let mut corners = vec![
            ([LONG, cylinder], 0.0),
            ([foot + (self.depth + cylinder) / tan(self.entry), cylinder], 0.0),
            ([foot, -self.depth], self.cut_radii()[0]),
        ];
        let r = self.radii[1];
        match self.behind {
            None => corners.push(([0.0, -self.depth], r)),
            Some(behind) => {
                let (sin, cos) = 8f64.to_radians().sin_cos();
                let w = behind - r + r * (1.0 + sin) / cos;
                corners.push(([-w, -self.depth], r));
                corners.push(([face, (w + face) * cos / sin - self.depth], 0.0));
            }
        }
        corners.push(([corners.last().map_or(0.0, |(p, _)| p[0]).max(face), LONG], 0.0));
        for (p, _) in &mut corners {
            *p = [p[0] + z, p[1] + x];
        }
        Outline::of(&corners, top)
    }
}

fn unit(a: P, b: P) -> P {
    let long = (b[0] - a[0]).hypot(b[1] - a[1]);
    [(b[0] - a[0]) / long, (b[1] - a[1]) / long]
}

impl Outline {
    /// Lines through the corners, with their roundings.
    fn of(corners: &[(P, f64)], top: f64) -> Outline {
        let (mut pieces, mut sharp, mut at) = (Vec::new(), Vec::new(), corners[0].0);
        let mut join = at;
        for trio in corners.windows(3) {
            let [(a, _), (p, r), (b, _)] = [trio[0], trio[1], trio[2]];
            let (u, w) = (unit(a, p), unit(p, b));
            let turn = (u[0] * w[1] - u[1] * w[0]).atan2(u[0] * w[0] + u[1] * w[1]);
            let tangent = r * (turn.abs() / 2.0).tan();
            let leave = [p[0] - u[0] * tangent, p[1] - u[1] * tangent];
            join = [p[0] + w[0] * tangent, p[1] + w[1] * tangent];
            pieces.push(Sweep::Line(at, leave));
            if r > 0.0 {
                // The roundings lie on the right: they are hollow.
                let center = [leave[0] + u[1] * r, leave[1] - u[0] * r];
                pieces.push(Sweep::Arc(leave, join, center, false));
            } else if turn < -1e-9 {
                sharp.push((p, -turn));
            }
            at = join;
        }
        let end = corners[corners.len() - 1].0;
        pieces.push(Sweep::Line(at, end));
        Outline { pieces, sharp, join, top }
    }

    /// Where the undercut meets the face.
    pub(super) fn join(&self) -> P {
        self.join
    }

    pub(super) fn distance(&self, p: P) -> f64 {
        self.pieces.iter().map(|piece| to_sweep(piece, p)).fold(f64::INFINITY, f64::min)
    }

    /// Is the point in the material?
    pub(super) fn is_inside(&self, p: P) -> bool {
        // Crossings on the way up to far above: the free side is up and along the cylinder.
        let mut crossings = 0;
        let far = [LONG * 0.9, LONG * 0.5];
        let points: Vec<P> = self
            .pieces
            .iter()
            .flat_map(|piece| piece.points(if matches!(piece, Sweep::Arc(..)) { 12 } else { 1 }))
            .collect();
        let side = |a: P, b: P, q: P| (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
        for pair in points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let one = (side(p, far, a) > 0.0) != (side(p, far, b) > 0.0);
            let other = (side(a, b, p) > 0.0) != (side(a, b, far) > 0.0);
            crossings += usize::from(one && other);
        }
        crossings % 2 == 1 && self.distance(p) > 0.01
    }

    /// Places of the undercut and the face that a nose can touch.
    pub(super) fn samples(&self, nose: f64) -> Vec<P> {
        let mut list = Vec::new();
        for (n, piece) in self.pieces.iter().enumerate().skip(1) {
            let (a, b) = piece.ends();
            let last = n + 1 == self.pieces.len();
            // The end of the face is open: as much of it as is asked for.
            let top = if self.top.is_finite() { self.top.max(a[1]) } else { a[1] };
            let b = if last { [b[0], top] } else { b };
            let piece = match *piece {
                Sweep::Line(..) => Sweep::Line(a, b),
                arc @ Sweep::Arc(..) => arc,
            };
            list.extend(piece.points(12));
        }
        let reached = |p: &P| {
            self.sharp.iter().all(|(at, turn)| (p[0] - at[0]).hypot(p[1] - at[1]) > nose * (turn / 2.0).tan() + 1e-3)
        };
        list.retain(reached);
        list
    }
}

/// Distance of a point to a line or an arc.
pub(super) fn to_sweep(sweep: &Sweep, p: P) -> f64 {
    let off = |a: P| (p[0] - a[0]).hypot(p[1] - a[1]);
    match *sweep {
        Sweep::Line(a, b) => {
            let (d, v) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
            let square = d[0] * d[0] + d[1] * d[1];
            let t = if square > 0.0 { ((v[0] * d[0] + v[1] * d[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
            (v[0] - t * d[0]).hypot(v[1] - t * d[1])
        }
        Sweep::Arc(a, b, c, ccw) => {
            let angle = |q: P| (q[1] - c[1]).atan2(q[0] - c[0]);
            let way = |from: f64, to: f64| {
                let turn = if ccw { to - from } else { from - to };
                turn.rem_euclid(std::f64::consts::TAU)
            };
            let on = way(angle(a), angle(p)) <= way(angle(a), angle(b));
            let ends = off(a).min(off(b));
            if on { ends.min((off(c) - (a[0] - c[0]).hypot(a[1] - c[1])).abs()) } else { ends }
        }
    }
}
