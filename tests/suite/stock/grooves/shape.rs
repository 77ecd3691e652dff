//! A groove as it is meant to be: walls, their corners, and the tool that fits between them.

/// A point: along the surface, and height above it.
pub(super) type P = [f64; 2];

/// Columns this near to the side of the tool are not looked at, mm.
pub(super) const SIDE: f64 = 5e-6;
/// Pieces of an arc.
pub(super) const PIECES: usize = 400;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Corner {
    Sharp,
    Round(f64),
    /// Sides.
    Chamfer(f64),
}

impl Corner {
    pub(super) fn size(self) -> f64 {
        match self {
            Corner::Sharp => 0.0,
            Corner::Round(size) | Corner::Chamfer(size) => size,
        }
    }
}

/// One wall, falling towards +x, its rim at x = 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wall {
    pub(super) sin: f64,
    pub(super) cos: f64,
    pub(super) outer: Corner,
    pub(super) inner: Corner,
}

impl Wall {
    /// The line from the surface to far along the floor.
    pub(super) fn line(&self, depth: f64) -> Vec<P> {
        let foot = [depth * self.sin / self.cos, -depth];
        let mut list = vec![[-1e3, 0.0]];
        let round = |list: &mut Vec<P>, center: P, radius: f64, from: f64, to: f64| {
            for i in 0..=PIECES {
                let angle = from + (to - from) * i as f64 / PIECES as f64;
                list.push([center[0] + radius * angle.cos(), center[1] + radius * angle.sin()]);
            }
        };
        let tangent = |radius: f64| radius * (1.0 - self.sin) / self.cos;
        // Direction of the normal of the wall towards the groove.
        let normal = self.sin.atan2(self.cos);
        match self.outer {
            Corner::Sharp => list.push([0.0, 0.0]),
            Corner::Chamfer(c) => list.extend([[-c, 0.0], [c * self.sin, -c * self.cos]]),
            Corner::Round(r) => round(&mut list, [-tangent(r), -r], r, core::f64::consts::FRAC_PI_2, normal),
        }
        match self.inner {
            Corner::Sharp => list.push(foot),
            Corner::Chamfer(c) => {
                list.extend([[foot[0] - c * self.sin, foot[1] + c * self.cos], [foot[0] + c, foot[1]]]);
            }
            Corner::Round(r) => {
                let pi = core::f64::consts::PI;
                round(&mut list, [foot[0] + tangent(r), foot[1] + r], r, pi + normal, 1.5 * pi);
            }
        }
        list.push([1e3, -depth]);
        list
    }
}

/// Height of a falling line over `x`; where it is upright, the lower end.
fn height(line: &[P], x: f64) -> f64 {
    let next = line.partition_point(|p| p[0] <= x).clamp(1, line.len() - 1);
    let ([ax, ay], [bx, by]) = (line[next - 1], line[next]);
    if bx > ax { ay + (by - ay) * (x - ax) / (bx - ax) } else { by }
}

fn to_segment([a, b]: [P; 2], p: P) -> f64 {
    let (d, v) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = d[0] * d[0] + d[1] * d[1];
    let t = if square > 0.0 { ((v[0] * d[0] + v[1] * d[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    (v[0] - t * d[0]).hypot(v[1] - t * d[1])
}

/// Distance to a falling line, looked for from the place of the point to both sides.
fn to_line(line: &[P], p: P) -> f64 {
    let middle = line.partition_point(|q| q[0] < p[0]).clamp(1, line.len() - 1);
    let mut least = f64::INFINITY;
    for i in (1..=middle).rev() {
        if p[0] - line[i][0] > least {
            break;
        }
        least = least.min(to_segment([line[i - 1], line[i]], p));
    }
    for i in middle + 1..line.len() {
        if line[i - 1][0] - p[0] > least {
            break;
        }
        least = least.min(to_segment([line[i - 1], line[i]], p));
    }
    least
}

/// The shape: both walls, seen from the left rim.
pub(super) struct Shape {
    pub(super) walls: [Vec<P>; 2],
    pub(super) left: f64,
    pub(super) top: f64,
}

impl Shape {
    /// From the left wall and from the right one.
    pub(super) fn seen(&self, x: f64) -> [f64; 2] {
        [x - self.left, self.left + self.top - x]
    }

    pub(super) fn height(&self, x: f64) -> f64 {
        let [a, b] = self.seen(x);
        height(&self.walls[0], a).max(height(&self.walls[1], b))
    }

    pub(super) fn distance(&self, p: P) -> f64 {
        let [a, b] = self.seen(p[0]);
        to_line(&self.walls[0], [a, p[1]]).min(to_line(&self.walls[1], [b, p[1]]))
    }

    /// Highest place over `x` of a disc of radius `around` that rolls on it.
    pub(super) fn rolled(&self, x: f64, around: f64) -> f64 {
        if around == 0.0 {
            return self.height(x);
        }
        let over = |line: &[P], x: f64| {
            let from = line.partition_point(|p| p[0] < x - around).max(1) - 1;
            let to = (line.partition_point(|p| p[0] <= x + around) + 1).min(line.len());
            let low = |p: P| [p[0], -p[1]];
            line[from..to]
                .windows(2)
                .map(|pair| -disc(low(pair[0]), low(pair[1]), around, x))
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let [a, b] = self.seen(x);
        over(&self.walls[0], a).max(over(&self.walls[1], b))
    }

    /// The same with its walls moved towards each other and up.
    pub(super) fn moved(&self, walls: [f64; 2], up: f64) -> Shape {
        let line = |at: usize| self.walls[at].iter().map(|p| [p[0] + walls[at], p[1] + up]).collect();
        Shape { walls: [line(0), line(1)], left: self.left, top: self.top }
    }
}

/// The tool at an edge towards minus.
pub struct Tool {
    pub width: f64,
    pub nose: f64,
}

impl Tool {
    /// Lowest height of the tool over `x` while its left edge goes from `a` to `b`.
    pub fn lowest(&self, a: P, b: P, x: f64) -> Option<f64> {
        let (r, flat) = (self.nose, self.width - 2.0 * self.nose);
        let mut low = f64::INFINITY;
        for side in [r, r + flat] {
            if r > 0.0 {
                low = low.min(disc([a[0] + side, a[1] + r], [b[0] + side, b[1] + r], r, x));
            }
        }
        // The flat between the corners covers x while the edge is between these.
        let (from, to) = (x - r - flat - SIDE * 0.01, x - r + SIDE * 0.01);
        let way = b[0] - a[0];
        let part = if way.abs() < 1e-12 {
            (from..=to).contains(&a[0]).then_some((0.0, 1.0))
        } else {
            let (s, t) = ((from - a[0]) / way, (to - a[0]) / way);
            let (s, t) = (s.min(t).max(0.0), s.max(t).min(1.0));
            (s <= t).then_some((s, t))
        };
        if let Some((s, t)) = part {
            let y = |t: f64| a[1] + (b[1] - a[1]) * t;
            low = low.min(y(s)).min(y(t));
        }
        low.is_finite().then_some(low)
    }
}

/// Lowest height of a disc over `x` while its centre goes from `a` to `b`.
fn disc(a: P, b: P, r: f64, x: f64) -> f64 {
    let at = |c: P| {
        let off = x - c[0];
        if off.abs() <= r { c[1] - (r * r - off * off).sqrt() } else { f64::INFINITY }
    };
    let mut low = at(a).min(at(b));
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx.hypot(dy);
    if length > 1e-12 && dx.abs() > 1e-12 {
        // The lower side of the strip.
        let n = if dx > 0.0 { [dy / length * r, -dx / length * r] } else { [-dy / length * r, dx / length * r] };
        let t = (x - a[0] - n[0]) / dx;
        if (0.0..=1.0).contains(&t) {
            low = low.min(a[1] + n[1] + dy * t);
        }
    } else if length > 1e-12 {
        let lower = if a[1] < b[1] { a } else { b };
        low = low.min(at(lower));
    }
    low
}
