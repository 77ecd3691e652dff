//! Stock on a lathe: the height of the material over places along the axis of the cuts, and the tool that takes it off.
//!
//! Everything is seen with the cuts towards +x and the infeed towards -y. A round nose is swept exactly along lines and
//! arcs; the material is known at columns.

/// A point: place along the cuts, and height.
pub type P = [f64; 2];

/// Heights at columns of equal distance.
#[derive(Debug, Clone)]
pub struct Stock {
    pub left: f64,
    pub step: f64,
    pub heights: Vec<f64>,
}

/// A move of the nose centre.
#[derive(Debug, Clone, Copy)]
pub enum Sweep {
    Line(P, P),
    /// From, to, centre, counter-clockwise.
    Arc(P, P, P, bool),
}

impl Stock {
    pub fn new(left: f64, right: f64, step: f64, height: impl Fn(f64) -> f64) -> Stock {
        let count = ((right - left) / step) as usize;
        let heights = (0..count).map(|i| height(left + i as f64 * step)).collect();
        Stock { left, step, heights }
    }

    pub fn place(&self, i: usize) -> f64 {
        self.left + i as f64 * self.step
    }

    /// Columns under a move.
    fn under(&self, low: f64, high: f64) -> std::ops::Range<usize> {
        let first = ((low - self.left) / self.step).ceil().max(0.0) as usize;
        let last = ((high - self.left) / self.step).floor();
        let last = if last < 0.0 { 0 } else { (last as usize + 1).min(self.heights.len()) };
        first..last.max(first)
    }

    /// Calls `take` with each column that a nose of `radius` passes, and the least height it comes to there.
    pub fn swept(&self, sweep: &Sweep, radius: f64, mut take: impl FnMut(usize, f64)) {
        let (low, high) = sweep.span(radius);
        for i in self.under(low, high) {
            if let Some(y) = sweep.lowest(self.place(i), radius) {
                take(i, y);
            }
        }
    }
}

/// Lower edge of a disc over `x`.
fn disc(center: P, radius: f64, x: f64) -> Option<f64> {
    let off = x - center[0];
    (off.abs() <= radius).then(|| center[1] - (radius * radius - off * off).max(0.0).sqrt())
}

impl Sweep {
    pub fn ends(&self) -> (P, P) {
        match *self {
            Sweep::Line(a, b) | Sweep::Arc(a, b, ..) => (a, b),
        }
    }

    fn span(&self, radius: f64) -> (f64, f64) {
        match *self {
            Sweep::Line(a, b) => (a[0].min(b[0]) - radius, a[0].max(b[0]) + radius),
            Sweep::Arc(a, _, c, _) => {
                let r = (a[0] - c[0]).hypot(a[1] - c[1]) + radius;
                (c[0] - r, c[0] + r)
            }
        }
    }

    /// Points along the move.
    pub fn points(&self, count: usize) -> Vec<P> {
        match *self {
            Sweep::Line(a, b) => (0..=count)
                .map(|k| {
                    let t = k as f64 / count as f64;
                    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
                })
                .collect(),
            Sweep::Arc(a, _, c, _) => {
                let (start, turn) = self.turn();
                let r = (a[0] - c[0]).hypot(a[1] - c[1]);
                let at = |k: usize| start + turn * k as f64 / count as f64;
                (0..=count).map(|k| [c[0] + r * at(k).cos(), c[1] + r * at(k).sin()]).collect()
            }
        }
    }

    /// Angle at the start and the signed turn of an arc.
    fn turn(&self) -> (f64, f64) {
        let Sweep::Arc(a, b, c, ccw) = *self else { return (0.0, 0.0) };
        let angle = |p: P| (p[1] - c[1]).atan2(p[0] - c[0]);
        let turn = (angle(b) - angle(a)).rem_euclid(std::f64::consts::TAU);
        (angle(a), if ccw { turn } else { turn - std::f64::consts::TAU })
    }

    /// Least height of the swept nose over `x`.
    fn lowest(&self, x: f64, radius: f64) -> Option<f64> {
        let (a, b) = self.ends();
        let mut least = [disc(a, radius, x), disc(b, radius, x)].into_iter().flatten().fold(f64::INFINITY, f64::min);
        match *self {
            Sweep::Line(a, b) => {
                let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
                let length = dx.hypot(dy);
                if length > 0.0 && dx != 0.0 {
                    // The lower side of the strip.
                    let n = if dx > 0.0 { [dy / length, -dx / length] } else { [-dy / length, dx / length] };
                    let t = (x - a[0] - n[0] * radius) / dx;
                    if (0.0..=1.0).contains(&t) {
                        least = least.min(a[1] + n[1] * radius + dy * t);
                    }
                }
            }
            Sweep::Arc(a, _, c, _) => {
                let (start, turn) = self.turn();
                let r = (a[0] - c[0]).hypot(a[1] - c[1]);
                let mut side = |edge: f64, sign: f64| {
                    let off = x - c[0];
                    if off.abs() > edge.abs() {
                        return;
                    }
                    let y = sign * (edge * edge - off * off).sqrt();
                    // The way of the centre that touches there.
                    let angle = (y * edge.signum()).atan2(off * edge.signum());
                    let way = if turn > 0.0 { angle - start } else { start - angle }.rem_euclid(std::f64::consts::TAU);
                    if way <= turn.abs() {
                        least = least.min(c[1] + y);
                    }
                };
                for edge in [r + radius, r - radius] {
                    side(edge, 1.0);
                    side(edge, -1.0);
                }
            }
        }
        (least < f64::INFINITY).then_some(least)
    }
}

/// The lowest surface that a nose of `radius` can make above `floor`, without going deeper.
pub fn reachable(floor: &Stock, radius: f64) -> Vec<f64> {
    let width = (radius / floor.step).floor() as isize;
    let rise: Vec<f64> = (-width..=width)
        .map(|k| {
            let off = k as f64 * floor.step;
            (radius * radius - off * off).max(0.0).sqrt()
        })
        .collect();
    let n = floor.heights.len() as isize;
    let at = |list: &[f64], i: isize, k: usize, sign: f64| {
        let j = (i + k as isize - width).clamp(0, n - 1) as usize;
        list[j] + sign * rise[k]
    };
    let centers: Vec<f64> = (0..n)
        .map(|i| (0..rise.len()).map(|k| at(&floor.heights, i, k, 1.0)).fold(f64::NEG_INFINITY, f64::max))
        .collect();
    (0..n).map(|i| (0..rise.len()).map(|k| at(&centers, i, k, -1.0)).fold(f64::INFINITY, f64::min)).collect()
}
