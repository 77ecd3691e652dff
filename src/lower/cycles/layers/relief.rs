//! Relief cuts: what falls behind a higher part is cut from its falling side.

use crate::diag::{Fault, codes};
use crate::geo::Point2;
use crate::geo::profile::{Dip, LEVEL, backwards, mirrored};
use crate::ir::cycle::layers::{LEAST_DIP, Relief, Trace};
use crate::lower::cycles::infeed;

use super::{Cutter, MOST_CUTS};

impl Cutter<'_> {
    /// # Errors
    /// G3040 too many cuts, G3047 steps of the cuts in the way.
    pub(super) fn relieve(&mut self) -> Result<(), Fault> {
        let region = self.region;
        if region.layers.relief == Relief::Left {
            return Ok(());
        }
        let floor = region.floor();
        // The contour begins where it first rises to the deepest cut.
        let Some(begin) = region.rough.first_above(floor - 3.0 * LEVEL, f64::NEG_INFINITY) else { return Ok(()) };
        let mut dips = region.rough.dips(Point2::new(begin, floor), region.top(), LEAST_DIP);
        if region.layers.trace == Trace::None && !dips.is_empty() {
            return Err(codes::G3047::contour_falls_behind_higher_part());
        }
        dips.reverse();
        // Those inside of others come behind them.
        let mut list: Vec<(Dip, f64)> = dips.into_iter().map(|dip| (dip, dip.rim)).collect();
        while let Some((dip, rim)) = list.pop() {
            let inner = self.dip(&dip, rim + region.layers.clearance.lift)?;
            list.extend(inner.into_iter().rev().map(|inner| (inner, rim)));
        }
        Ok(())
    }

    /// Cuts one dip and gives those inside of it; the tool travels at the height `air`.
    fn dip(&mut self, dip: &Dip, air: f64) -> Result<Vec<Dip>, Fault> {
        let region = self.region;
        let layers = region.layers;
        let nose = region.nose();
        let Some(low) = region.rough.lowest(dip.left, dip.right) else { return Ok(Vec::new()) };
        let top = region.blank.highest(dip.left - nose, dip.right + nose).min(dip.rim);
        if top - low.y <= LEAST_DIP {
            return Ok(Vec::new());
        }
        let heights = infeed::heights(top, low.y, layers.most, MOST_CUTS)?;
        let left = |y: f64| region.behind.first_above(y, -low.x).map_or(dip.left, |x| -x);
        let right = |y: f64| region.rough.first_above(y, low.x).unwrap_or(dip.right);
        let mut before = top;
        for y in heights {
            let start = Point2::new(left(y), y);
            let seen = Point2::new(-start.x, y);
            let up = region.behind.climb(seen, (before + layers.clearance.lift).min(dip.rim));
            let rim = up.last().map_or(start, |leg| Point2::new(-leg.to().x, leg.to().y));
            self.rapid_y(self.at.y.max(air));
            let over = region.highest_between(self.at.x, rim.x);
            if over > self.at.y - LEVEL && rim.x > self.at.x {
                // What is higher than the blank or than the area.
                self.rapid_y(over + layers.clearance.lift);
            }
            self.rapid_x(rim.x);
            self.rapid_y(before + layers.clearance.lift);
            self.line(rim, layers.feeds.plunge);
            self.legs(&mirrored(&backwards(seen, &up)), layers.feeds.plunge);
            self.straight(right(y));
            let at = self.at;
            self.legs(&region.rough.climb(at, before), layers.feeds.rough);
            let wide = self.at.x - left(before);
            let way = layers.clearance.lift.min((wide / 2.0).max(0.0));
            self.lift(way, way, layers.feeds.rough);
            before = y;
        }
        self.rapid_y(self.at.y.max(air));
        let mut inner: Vec<Dip> =
            region.behind.between(-low.x, -dip.left).dips(Point2::new(-low.x, low.y), top, LEAST_DIP);
        inner.reverse();
        for dip in &mut inner {
            (dip.left, dip.right) = (-dip.right, -dip.left);
        }
        inner.extend(region.rough.between(low.x, dip.right).dips(low, top, LEAST_DIP));
        Ok(inner)
    }
}
