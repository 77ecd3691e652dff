//! The rectangle that holds something: points, and arcs with their bulges.

use crate::geo::{Point2, distance, turned};

/// The rectangle that holds something.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Rect(pub Option<(Point2, Point2)>);

impl Rect {
    pub(super) fn take(&mut self, p: Point2) {
        let (low, high) = self.0.get_or_insert((p, p));
        (low.x, low.y) = (low.x.min(p.x), low.y.min(p.y));
        (high.x, high.y) = (high.x.max(p.x), high.y.max(p.y));
    }

    /// Ends and bulges of an arc from `from`.
    pub(super) fn take_arc(&mut self, from: Point2, bend: &Bend) {
        let radius = distance(from, bend.center);
        let angle = libm::atan2(from.y - bend.center.y, from.x - bend.center.x);
        let quarter = core::f64::consts::FRAC_PI_2;
        let sides = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        for (i, (x, y)) in sides.into_iter().enumerate() {
            let way = (i as f64 * quarter - angle) * bend.sweep.signum();
            let way = way - libm::floor(way / (4.0 * quarter)) * 4.0 * quarter;
            if way <= bend.sweep.abs() {
                self.take(Point2::new(bend.center.x + x * radius, bend.center.y + y * radius));
            }
        }
        self.take(from);
        self.take(bend.end(from));
    }

    pub(super) fn size(&self) -> f64 {
        self.0.map_or(0.0, |(low, high)| (high - low).amax())
    }

    pub(super) fn touches(&self, p: Point2) -> bool {
        self.0.is_some_and(|(low, high)| p.x <= low.x || p.y <= low.y || p.x >= high.x || p.y >= high.y)
    }
}

/// Centre and signed way round of an arc, at most a turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bend {
    pub center: Point2,
    pub sweep: f64,
}

impl Bend {
    pub(super) fn end(&self, from: Point2) -> Point2 {
        self.center + turned(from - self.center, self.sweep)
    }
}
