//! Places and sizes of a picture, in mm of the part, y upwards.

use crate::geo::{Point2, SAME_POINT, Vec2};

use super::rect::Rect;

/// Length of the longer side of the picture.
pub const PIXELS: f64 = 1200.0;
/// Height of the picture in font sizes, so that letters keep their size.
const FONTS: f64 = 42.0;
/// Most grid lines in one direction.
const GRID: f64 = 24.0;
/// The least window, mm: numbers of four places tell its grid lines apart. A point has no size of its own.
const LEAST: f64 = 0.04;
const AROUND_A_POINT: f64 = 10.0;
/// Room at the left, in font sizes.
const LEFT: f64 = 5.0;
/// From the line of the title to the notice, in font sizes.
pub(super) const NOTICE: f64 = 1.6;
/// Left free beside the words below the picture.
const EDGE: f64 = 0.4;

#[derive(Debug, Clone, Copy)]
pub(super) struct Layout {
    pub low: Point2,
    pub high: Point2,
    pub font: f64,
    /// Room at the left, right, top and bottom.
    room: [f64; 4],
    /// Of a pixel.
    pub pixel: f64,
}

/// What the rectangle of the path does not say.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Needs {
    /// The turning centre lies in the picture.
    pub turning: bool,
    pub dimensions: bool,
    /// Lines below the picture.
    pub lines: usize,
    /// A line below the title.
    pub notice: bool,
    /// What words need at the left of the picture, and from there to the right, in font sizes.
    pub left: f64,
    pub broad: f64,
}

impl Layout {
    pub(super) fn new(rect: &Rect, needs: Needs) -> Layout {
        let (mut low, mut high) = rect.0.unwrap_or((Point2::new(0.0, 0.0), Point2::new(1.0, 1.0)));
        let size = (high - low).amax();
        widen(&mut low, &mut high, if size <= SAME_POINT { AROUND_A_POINT } else { LEAST });
        if needs.turning {
            // Unless the part is far away from it.
            let size = (high - low).amax();
            if low.y > 0.0 && low.y <= size {
                low.y = 0.0;
            }
        }
        let size = (high - low).amax();
        let margin = Vec2::new(0.04, 0.04) * size;
        low -= margin;
        high += margin;
        // A flat path still gets a picture one can look at.
        widen(&mut low, &mut high, 0.3 * size);
        let font = (high - low).amax() / FONTS;
        let more: f64 = if needs.dimensions { 3.0 } else { 0.0 };
        let below = 4.9 + 1.7 * needs.lines as f64;
        let right = (2.0 + more).max(needs.broad + EDGE - (high.x - low.x) / font);
        let above = if needs.notice { 3.6 + NOTICE } else { 3.6 };
        let room = [LEFT.max(needs.left) * font, right * font, (above + more) * font, below * font];
        let mut layout = Layout { low, high, font, room, pixel: 0.0 };
        let (_, _, w, h) = layout.frame();
        layout.pixel = w.max(h) / PIXELS;
        layout
    }

    /// From the left of the picture to where words below it end.
    pub(super) fn broad(&self) -> f64 {
        self.high.x - self.low.x + self.room[1] - EDGE * self.font
    }

    /// The view box: x, y downwards, width, height.
    pub(super) fn frame(&self) -> (f64, f64, f64, f64) {
        let [left, right, top, bottom] = self.room;
        (
            self.low.x - left,
            -self.high.y - top,
            self.high.x - self.low.x + left + right,
            self.high.y - self.low.y + top + bottom,
        )
    }

    /// Distance of grid lines: 1, 2 or 5 times a power of ten.
    pub(super) fn step(&self) -> f64 {
        let rough = ((self.high - self.low).amax() / GRID).max(1e-9);
        let power = libm::pow(10.0, libm::floor(libm::log10(rough)));
        [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|step| *step >= rough).unwrap_or(rough)
    }

    /// The multiples of the step from `low` to `high`.
    pub(super) fn marks(&self, low: f64, high: f64) -> impl Iterator<Item = f64> + use<> {
        let step = self.step();
        let first = libm::ceil(low / step - 1e-9);
        let last = libm::floor(high / step + 1e-9);
        let count = (last - first).clamp(0.0, 4.0 * GRID) as u32;
        (0..=count).map(move |i| (first + f64::from(i)) * step)
    }
}

/// Makes both sides at least so long, about the same middle.
fn widen(low: &mut Point2, high: &mut Point2, least: f64) {
    for i in 0..2 {
        let more = (least - (high[i] - low[i])).max(0.0) / 2.0;
        low[i] -= more;
        high[i] += more;
    }
}
