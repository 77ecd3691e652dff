//! The path as it is drawn: strokes one behind the other, made fewer where there are very many.
//!
//! In: points and arcs of the picture, in mm. Out: runs of strokes of one pen. What is left out stays within a tolerance that is
//! known, and the rectangle of the path is never touched.

use crate::geo::{Point2, distance};
use crate::text::Loc;

use super::rect::{Bend, Rect};

/// Up to so many strokes every one is drawn.
pub const ALL_DRAWN: usize = 50_000;
/// Strokes that are kept before they are made fewer on the way.
const KEPT: usize = 4 * ALL_DRAWN;
/// Strokes that one may stand for: what it costs to look at them again.
const WINDOW: usize = 48;

/// How often they are made fewer in the end.
const PASSES: u32 = 4;

/// How a stretch of the path is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pen {
    Rapid,
    Cut,
    Thread,
    /// Points.
    Dot,
    /// The programmed contour beside which the tool travels.
    Contour,
}

/// A stroke to `to`, from where the one before ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke {
    pub to: Point2,
    /// Place of its arc, from 1; 0 for a line.
    arc: u32,
    /// How far the path is at most away from it.
    error: f32,
    pub loc: Loc,
}

/// Strokes of one pen and colour without a gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run {
    pub pen: Pen,
    pub colour: usize,
    pub from: Point2,
    /// Its first stroke.
    first: usize,
}

/// All strokes of a picture.
#[derive(Debug, Default)]
pub(super) struct Strokes {
    runs: Vec<Run>,
    all: Vec<Stroke>,
    bends: Vec<Bend>,
    /// Holds every point that was ever taken.
    pub rect: Rect,
    /// Strokes that were taken.
    pub taken: u64,
    /// When to make them fewer on the way.
    next: usize,
    is_broken: bool,
}

impl Strokes {
    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    /// The next stroke begins anew.
    pub(super) fn lift(&mut self) {
        self.is_broken = true;
    }

    fn pen(&mut self, pen: Pen, colour: usize, from: Point2) {
        let at = self.all.last().map(|last| last.to);
        let goes_on = self.runs.last().is_some_and(|run| run.pen == pen && run.colour == colour) && at == Some(from);
        if self.is_broken || !goes_on {
            self.runs.push(Run { pen, colour, from, first: self.all.len() });
            self.is_broken = false;
        }
        self.rect.take(from);
        self.taken += 1;
    }

    pub(super) fn line(&mut self, pen: Pen, colour: usize, from: Point2, to: Point2, loc: Loc) {
        self.pen(pen, colour, from);
        self.rect.take(to);
        self.all.push(Stroke { to, arc: 0, error: 0.0, loc });
        self.make_fewer_on_the_way();
    }

    /// An arc from `from` to `to`, which it may miss by the rounding of the program.
    pub(super) fn arc(&mut self, (pen, colour): (Pen, usize), from: Point2, to: Point2, bend: Bend, loc: Loc) {
        self.pen(pen, colour, from);
        self.rect.take_arc(from, &bend);
        self.rect.take(to);
        self.bends.push(bend);
        let arc = u32::try_from(self.bends.len()).unwrap_or(0);
        self.all.push(Stroke { to, arc, error: 0.0, loc });
        self.make_fewer_on_the_way();
    }

    /// The runs, each with its strokes.
    pub(super) fn runs(&self) -> impl Iterator<Item = (&Run, &[Stroke])> {
        let ends = self.runs.iter().skip(1).map(|run| run.first).chain([self.all.len()]);
        self.runs.iter().zip(ends).map(|(run, end)| (run, self.all.get(run.first..end).unwrap_or_default()))
    }

    pub(super) fn bend(&self, stroke: &Stroke) -> Option<Bend> {
        (stroke.arc as usize).checked_sub(1).and_then(|i| self.bends.get(i)).copied()
    }

    /// Many more than can be told apart are made fewer while they come, so that memory does not grow with the program.
    fn make_fewer_on_the_way(&mut self) {
        if self.all.len() >= self.next.max(KEPT) {
            self.thin(tolerance(self.rect.size()));
            self.next = 2 * self.all.len();
        }
    }

    /// Makes strokes fewer where there are very many. Gives how far the path is at most away from what is drawn.
    pub(super) fn finish(&mut self) -> Option<f64> {
        if self.taken > ALL_DRAWN as u64 {
            // A stroke stands for a few others each time.
            for _ in 0..PASSES {
                let before = self.all.len();
                self.thin(tolerance(self.rect.size()));
                if self.all.len() > before / 10 * 9 {
                    break;
                }
            }
            let error = self.all.iter().map(|stroke| f64::from(stroke.error)).fold(0.0, f64::max);
            return ((self.all.len() as u64) < self.taken).then_some(error);
        }
        None
    }

    /// Lets a stroke stand for those behind it as long as none of their ends, nor what these stood for, is farther away than
    /// `tolerance`. Points on the rectangle of the path stay.
    fn thin(&mut self, tolerance: f64) {
        let old = std::mem::take(&mut self.all);
        let bends = std::mem::take(&mut self.bends);
        let mut runs = std::mem::take(&mut self.runs);
        let mut end = old.len();
        let mut ends: Vec<usize> = Vec::with_capacity(runs.len());
        for run in runs.iter().rev() {
            ends.push(end);
            end = run.first;
        }
        for (run, end) in runs.iter_mut().zip(ends.into_iter().rev()) {
            let strokes = old.get(run.first..end).unwrap_or_default();
            run.first = self.all.len();
            let mut at = run.from;
            let mut i = 0;
            while let Some(first) = strokes.get(i) {
                let (stroke, count) = match self.flattened(first, at, &bends, tolerance) {
                    Some(error) if run.pen != Pen::Dot => {
                        self.longest(strokes.get(i..).unwrap_or_default(), at, error, &bends, tolerance)
                    }
                    _ => (*first, 1),
                };
                let bend = (stroke.arc as usize).checked_sub(1).and_then(|i| bends.get(i));
                let arc = bend.map_or(0, |bend| {
                    self.bends.push(*bend);
                    u32::try_from(self.bends.len()).unwrap_or(0)
                });
                self.all.push(Stroke { arc, ..stroke });
                at = stroke.to;
                i += count;
            }
        }
        self.runs = runs;
    }

    /// How far a stroke is away from the straight line between its ends, if that is little.
    fn flattened(&self, stroke: &Stroke, from: Point2, bends: &[Bend], tolerance: f64) -> Option<f64> {
        let mut error = f64::from(stroke.error);
        if let Some(bend) = (stroke.arc as usize).checked_sub(1).and_then(|i| bends.get(i)) {
            if bend.sweep.abs() > core::f64::consts::PI {
                return None;
            }
            // What the program rounded adds to the height of the arc over its chord.
            let radius = distance(from, bend.center);
            error += radius * (1.0 - libm::cos(bend.sweep / 2.0)) + distance(bend.end(from), stroke.to);
            let mut bulge = Rect::default();
            bulge.take_arc(from, bend);
            let (low, high) = bulge.0?;
            if self.rect.touches(low) || self.rect.touches(high) {
                return None;
            }
        }
        (error <= tolerance).then_some(error)
    }

    /// The line that stands for as many strokes as it can, and how many these are.
    fn longest(&self, strokes: &[Stroke], from: Point2, error: f64, bends: &[Bend], tolerance: f64) -> (Stroke, usize) {
        let Some(first) = strokes.first() else {
            return (Stroke { to: from, arc: 0, error: 0.0, loc: Loc::default() }, 1);
        };
        let line = |to: Point2, error: f64| Stroke { to, arc: 0, error: upward(error), loc: first.loc };
        // A stroke alone stays what it is.
        let mut best = (*first, 1);
        let mut worst = error;
        for count in 2..=strokes.len().min(WINDOW) {
            let (passed, Some(last)) = (strokes.get(..count - 1).unwrap_or_default(), strokes.get(count - 1)) else {
                break;
            };
            let before = passed.last().map_or(from, |stroke| stroke.to);
            if self.rect.touches(before) {
                break;
            }
            let Some(error) = self.flattened(last, before, bends, tolerance) else { break };
            worst = worst.max(error);
            let aside = passed.iter().map(|stroke| to_segment(stroke.to, from, last.to)).fold(0.0, f64::max);
            if worst + aside > tolerance {
                break;
            }
            best = (line(last.to, worst + aside), count);
        }
        best
    }
}

/// Rounded up, so that what is said holds.
fn upward(error: f64) -> f32 {
    let near = error as f32;
    if f64::from(near) < error { near.next_up() } else { near }
}

/// What nobody sees in a picture of this size: a third of a pixel.
pub(super) fn tolerance(size: f64) -> f64 {
    size / super::layout::PIXELS / 3.0
}

fn to_segment(p: Point2, a: Point2, b: Point2) -> f64 {
    let (way, square) = (b - a, (b - a).norm_squared());
    let t = if square > 0.0 { ((p - a).dot(&way) / square).clamp(0.0, 1.0) } else { 0.0 };
    distance(p, a + way * t)
}
