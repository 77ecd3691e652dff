//! A recessing tool that works from a clear height.

use crate::geo::Point2;
use crate::geo::profile::Leg;
use crate::ir::Feed;

use super::track::Track;

/// Moves the tool by its edge towards -x of the view.
pub(super) struct GrooveCutter<'t> {
    pub track: Track<'t>,
    /// From that edge to the programmed point.
    pub shift: f64,
    pub clear: f64,
}

impl GrooveCutter<'_> {
    fn place(&self, p: Point2) -> Point2 {
        Point2::new(p.x + self.shift, p.y)
    }

    pub fn height(&self) -> f64 {
        self.track.at().y
    }

    /// To the clear height above `x`.
    pub fn above(&mut self, x: f64) {
        let height = self.height().max(self.clear);
        self.track.rapid(self.place(Point2::new(x, height)));
        self.track.rapid(self.place(Point2::new(x, self.clear)));
    }

    pub fn rapid_down(&mut self, y: f64) {
        let at = self.track.at();
        self.track.rapid(Point2::new(at.x, y.min(at.y)));
    }

    /// Straight out at rapid, up to `y`.
    pub fn rapid_up(&mut self, y: f64) {
        let at = self.track.at();
        self.track.rapid(Point2::new(at.x, y.max(at.y)));
    }

    pub fn lift(&mut self) {
        self.track.rapid(Point2::new(self.track.at().x, self.clear));
    }

    pub fn line(&mut self, to: Point2, feed: Feed) {
        let to = self.place(to);
        self.track.line(to, feed);
    }

    /// Along a wall; returns the position at its foot.
    pub fn down(&mut self, (start, legs): (Point2, Vec<Leg>), feed: Feed) -> f64 {
        self.above(start.x);
        let mut foot = start.x;
        for leg in legs {
            match leg {
                Leg::Line { to } => self.track.line(self.place(to), feed),
                Leg::Arc { to, center, ccw } => self.track.arc(self.place(to), self.place(center), ccw, feed),
            }
            foot = leg.to().x;
        }
        foot
    }
}
