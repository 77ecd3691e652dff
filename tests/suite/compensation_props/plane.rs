//! Geometry of contours and paths by sampling: nothing of it is shared with the compiler.

use core::f64::consts::{PI, TAU};

pub type P = [f64; 2];

pub fn sub(a: P, b: P) -> P {
    [a[0] - b[0], a[1] - b[1]]
}

pub fn add(a: P, b: P, by: f64) -> P {
    [a[0] + b[0] * by, a[1] + b[1] * by]
}

pub fn dot(a: P, b: P) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub fn norm(a: P) -> f64 {
    a[0].hypot(a[1])
}

pub fn apart(a: P, b: P) -> f64 {
    norm(sub(a, b))
}

pub fn left(a: P) -> P {
    [-a[1], a[0]]
}

pub fn unit(a: P) -> P {
    let far = norm(a);
    [a[0] / far, a[1] / far]
}

pub fn towards(angle: f64) -> P {
    [angle.cos(), angle.sin()]
}

/// A line, or an arc with its centre and sweep; a printed arc may have a radius at its end that is another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    pub from: P,
    pub to: P,
    pub arc: Option<(P, f64)>,
}

impl Curve {
    pub fn line(from: P, to: P) -> Curve {
        Curve { from, to, arc: None }
    }

    pub fn length(&self) -> f64 {
        match self.arc {
            Some((center, sweep)) => apart(self.from, center) * sweep.abs(),
            None => apart(self.from, self.to),
        }
    }

    /// The point after this share of the way.
    pub fn at(&self, t: f64) -> P {
        match self.arc {
            Some((center, sweep)) => {
                let out = sub(self.from, center);
                let angle = out[1].atan2(out[0]) + sweep * t;
                let radius = norm(out) + (apart(self.to, center) - norm(out)) * t;
                add(center, towards(angle), radius)
            }
            None => add(self.from, sub(self.to, self.from), t),
        }
    }

    /// Direction of travel after this share of the way.
    pub fn heading(&self, t: f64) -> P {
        match self.arc {
            Some((center, sweep)) => {
                let out = unit(sub(self.at(t), center));
                if sweep > 0.0 { left(out) } else { left([-out[0], -out[1]]) }
            }
            None => unit(sub(self.to, self.from)),
        }
    }

    /// The point beside it, at a signed distance to the left.
    pub fn beside(&self, t: f64, d: f64) -> P {
        add(self.at(t), left(self.heading(t)), d)
    }

    /// Room of the tool centre in a hollow arc; endless elsewhere.
    pub fn room(&self, d: f64) -> f64 {
        match self.arc {
            Some((center, sweep)) if sweep * d > 0.0 => apart(self.from, center) - d.abs(),
            _ => f64::INFINITY,
        }
    }

    pub fn distance(&self, p: P) -> f64 {
        let ends = apart(p, self.from).min(apart(p, self.to));
        match self.arc {
            Some((center, sweep)) => {
                let (start, here) = (sub(self.from, center), sub(p, center));
                let turned = (here[1].atan2(here[0]) - start[1].atan2(start[0])) * sweep.signum();
                if turned.rem_euclid(TAU) > sweep.abs() {
                    return ends;
                }
                let share = turned.rem_euclid(TAU) / sweep.abs();
                let radius = norm(start) + (apart(self.to, center) - norm(start)) * share;
                ends.min((norm(here) - radius).abs())
            }
            None => {
                let way = sub(self.to, self.from);
                let share = dot(sub(p, self.from), way) / dot(way, way).max(1e-300);
                if (0.0..=1.0).contains(&share) { ends.min(apart(p, self.at(share))) } else { ends }
            }
        }
    }

    pub fn reversed(&self) -> Curve {
        Curve { from: self.to, to: self.from, arc: self.arc.map(|(center, sweep)| (center, -sweep)) }
    }

    pub fn mapped(&self, map: &Map) -> Curve {
        let arc = self.arc.map(|(center, sweep)| (map.apply(center), sweep * map.sign()));
        Curve { from: map.apply(self.from), to: map.apply(self.to), arc }
    }
}

/// Shift, mirror and rotation: first the mirror acts on what is programmed, last the shift.
#[derive(Debug, Clone, Copy)]
pub struct Map {
    pub shift: P,
    pub mirror: [bool; 2],
    pub angle: f64,
}

impl Map {
    pub fn apply(&self, p: P) -> P {
        let flip = |i: usize| if self.mirror[i] { -p[i] } else { p[i] };
        let axis = towards(self.angle);
        add(add(self.shift, axis, flip(0)), left(axis), flip(1))
    }

    /// -1 where it swaps left and right.
    pub fn sign(&self) -> f64 {
        if self.mirror[0] == self.mirror[1] { 1.0 } else { -1.0 }
    }
}

pub fn nearest(curves: &[Curve], p: P) -> f64 {
    curves.iter().map(|curve| curve.distance(p)).fold(f64::INFINITY, f64::min)
}

/// By how much the contour turns between two elements, positive to the left.
pub fn turn(before: &Curve, after: &Curve) -> f64 {
    let (a, b) = (before.heading(1.0), after.heading(0.0));
    dot(left(a), b).atan2(dot(a, b))
}

/// Does the tool go round the whole contour, also with a little more radius? Each element has to keep one piece of its path
/// that only its neighbours cut, and these have to meet.
pub fn is_wide(contour: &[Curve], d: f64) -> bool {
    let margin = 0.02 * d.abs() + 2e-3;
    let mut last: Option<(P, f64)> = None;
    for (i, element) in contour.iter().enumerate() {
        let Some((first, end, step)) = kept(contour, i, d, margin) else { return false };
        let inside = last.is_some_and(|_| turn(&contour[i - 1], element) * d > 0.0);
        if inside && last.is_some_and(|(before, other)| apart(before, first) > 3.0 * (step + other)) {
            return false;
        }
        if contour.get(i + 1).is_some_and(|next| !corner_is_wide(contour, i, next, d, margin)) {
            return false;
        }
        last = Some((end, step));
    }
    true
}

/// The part of its path that an element keeps: its first and last point, and how exactly they are known.
fn kept(contour: &[Curve], i: usize, d: f64, margin: f64) -> Option<(P, P, f64)> {
    let (element, r) = (&contour[i], d.abs());
    if element.room(d) < margin {
        return None;
    }
    let far: Vec<Curve> = (0..contour.len()).filter(|j| i.abs_diff(*j) > 1).map(|j| contour[j]).collect();
    let steps = (element.length() / (0.05 * r)).ceil().clamp(24.0, 4000.0);
    let cut = |j: Option<usize>, p: P| j.and_then(|j| contour.get(j)).is_some_and(|c| c.distance(p) < r - 1e-9);
    // Cut at the start, free, cut at the end: each once.
    let (mut part, mut free) = (0, Vec::new());
    for k in 0..=steps as u32 {
        let p = element.beside(f64::from(k) / steps, d);
        let now = match (cut(i.checked_sub(1), p), cut(Some(i + 1), p)) {
            (false, false) => 1,
            (true, false) => 0,
            (false, true) => 2,
            (true, true) => return None,
        };
        if now < part || nearest(&far, p) < r + margin {
            return None;
        }
        part = now;
        if now == 1 {
            free.push(p);
        }
    }
    let step = apart(element.beside(0.5, d), element.beside(0.5 + 1.0 / steps, d)).max(1e-6);
    (free.len() >= 4).then(|| (free[0], free[free.len() - 1], step))
}

/// The way about an outside corner is free, and an inside corner is no needle.
fn corner_is_wide(contour: &[Curve], i: usize, next: &Curve, d: f64, margin: f64) -> bool {
    let r = d.abs();
    let turn = turn(&contour[i], next);
    if turn.abs() > PI - 0.02 {
        return false;
    }
    if turn * d > 0.0 {
        return true;
    }
    let from = contour[i].heading(1.0);
    (0..=24).all(|k| {
        let (sin, cos) = (turn * f64::from(k) / 24.0).sin_cos();
        let heading = [from[0] * cos - from[1] * sin, from[0] * sin + from[1] * cos];
        let p = add(next.from, left(heading), d);
        contour.iter().enumerate().all(|(j, element)| {
            let least = if j == i || j == i + 1 { r - 1e-7 } else { r + margin };
            element.distance(p) >= least
        })
    })
}
