//! Dimensions: the size of what is cut, circles, holes, and what a turned part measures.

use crate::geo::{Element, Point2, SAME_POINT, Vec2, distance};

use super::canvas::{Anchor, Canvas, Class, Part, Words};
use super::layout::Layout;
use super::marks::arrow;
use super::rect::Rect;
use super::section::Section;
use super::strokes::{Pen, Strokes};
use super::svg::show;

/// Width of a letter, in heights of the font.
pub(super) const LETTER: f64 = 0.56;
/// The same in the broadest of the usual fonts: what must not be cut off counts with it.
pub(super) const BROAD: f64 = 0.64;
/// Left free behind a word, in heights of the font.
const GAP: f64 = 0.6;
/// Labels of a picture; more would hide it.
const MOST: usize = 60;

/// Words with the lines that lead to them, placed where nothing is written yet.
#[derive(Debug, Default)]
pub(super) struct Labels {
    placed: Vec<Label>,
    taken: Vec<(Point2, Point2)>,
    /// Least and greatest X at which there is something of a word.
    room: (f64, f64),
    /// For want of room.
    pub left_out: u32,
}

#[derive(Debug)]
struct Label {
    at: Point2,
    anchor: Anchor,
    font: f64,
    upright: bool,
    text: String,
}

impl Labels {
    pub(super) fn within(layout: &Layout) -> Labels {
        let (left, _, broad, _) = layout.frame();
        Labels { room: (left, left + broad), ..Labels::default() }
    }

    /// Does a word of so many letters lie in the picture, in whatever font?
    fn fits(&self, at: Point2, anchor: Anchor, font: f64, text: &str) -> bool {
        let (left, right) = extent(at.x, anchor, BROAD * font * text.chars().count() as f64);
        self.room.0 <= left && right <= self.room.1
    }

    pub(super) fn place(&mut self, at: Point2, anchor: Anchor, font: f64, text: String) -> bool {
        let long = LETTER * font * text.chars().count() as f64;
        let (left, right) = extent(at.x, anchor, long);
        let (low, high) = (Point2::new(left, at.y - 0.2 * font), Point2::new(right + GAP * font, at.y + 0.8 * font));
        let meets = |(a, b): &(Point2, Point2)| a.x < high.x && low.x < b.x && a.y < high.y && low.y < b.y;
        if self.placed.len() >= MOST || !self.fits(at, anchor, font, &text) || self.taken.iter().any(meets) {
            self.left_out += 1;
            return false;
        }
        self.taken.push((low, high));
        self.placed.push(Label { at, anchor, font, upright: false, text });
        true
    }

    pub(super) fn write(&self, canvas: &mut dyn Canvas) {
        for Label { at, anchor, font, upright, text } in &self.placed {
            canvas.words(&Words { at: *at, anchor: *anchor, font: *font, upright: *upright, loud: false, text });
        }
    }
}

/// From where to where a word reaches.
fn extent(at: f64, anchor: Anchor, long: f64) -> (f64, f64) {
    let left = match anchor {
        Anchor::Start => at,
        Anchor::Middle => at - long / 2.0,
        Anchor::End => at - long,
    };
    (left, left + long)
}

/// What there is to measure.
#[derive(Debug)]
pub(super) struct Measured<'a> {
    pub layout: &'a Layout,
    /// What is cut.
    pub cut: &'a Rect,
    pub strokes: &'a Strokes,
    pub section: &'a Section,
    /// The second axis is a radius, of which diameters are written.
    pub turning: bool,
    /// What is written for a millimetre to the right and up.
    pub factors: (f64, f64),
}

impl Measured<'_> {
    pub(super) fn draw(&self, canvas: &mut dyn Canvas, labels: &mut Labels) {
        self.overall(canvas, labels);
        if self.turning {
            self.turned(canvas, labels);
        } else {
            self.circles(canvas, labels);
            self.holes(labels);
        }
    }

    /// Above and at the right of the picture; of a turned part its length.
    fn overall(&self, canvas: &mut dyn Canvas, labels: &mut Labels) {
        let mut rect = *self.cut;
        if self.turning && !self.section.edges.is_empty() {
            rect = Rect::default();
            self.section.edges.iter().for_each(|edge| [edge.from(), edge.to()].into_iter().for_each(|p| rect.take(p)));
        }
        let Some((low, high)) = rect.0 else { return };
        let (layout, font) = (self.layout, self.layout.font);
        let up = |x: f64| {
            // A line through half the picture would hide more than it says.
            let from = if self.turning { layout.high.y } else { high.y };
            (Point2::new(x, from), Point2::new(x, layout.high.y + 2.0 * font))
        };
        if high.x - low.x > SAME_POINT {
            self.line(canvas, up(low.x), up(high.x));
            let at = Point2::new((low.x + high.x) / 2.0, layout.high.y + 2.35 * font);
            labels.place(at, Anchor::Middle, 0.9 * font, show((high.x - low.x) * self.factors.0));
        }
        if high.y - low.y > SAME_POINT && !self.turning {
            let line = layout.high.x + 2.0 * font;
            let right = |y: f64| (Point2::new(high.x, y), Point2::new(line, y));
            self.line(canvas, right(low.y), right(high.y));
            let at = Point2::new(line - 0.35 * font, (low.y + high.y) / 2.0);
            let text = show((high.y - low.y) * self.factors.1);
            let half = LETTER * 0.9 * font * text.chars().count() as f64 / 2.0;
            labels.taken.push((at - Vec2::new(0.9 * font, half), at + Vec2::new(0.2 * font, half)));
            labels.placed.push(Label { at, anchor: Anchor::Middle, font: 0.9 * font, upright: true, text });
        }
    }

    /// A line with arrows between the ends of two others, which lead to what is measured.
    fn line(&self, canvas: &mut dyn Canvas, a: (Point2, Point2), b: (Point2, Point2)) {
        let beyond = |(from, to): (Point2, Point2)| {
            let way = to - from;
            to + way * (0.4 * self.layout.font / way.norm().max(SAME_POINT))
        };
        let parts = [
            Part::Move(a.0),
            Part::Line(beyond(a)),
            Part::Move(b.0),
            Part::Line(beyond(b)),
            Part::Move(a.1),
            Part::Line(b.1),
        ];
        canvas.path(Class::Dimension, None, &parts);
        let way = b.1 - a.1;
        let along = way / way.norm().max(SAME_POINT);
        let size = 10.0 * self.layout.pixel;
        arrow(canvas, Class::DimensionArrow, b.1, along, size);
        arrow(canvas, Class::DimensionArrow, a.1, -along, size);
    }

    /// Circles that are cut, each once: a cross in the centre and the diameter of the path.
    fn circles(&self, canvas: &mut dyn Canvas, labels: &mut Labels) {
        let font = 0.8 * self.layout.font;
        let mut seen: Vec<(Point2, f64)> = Vec::new();
        for (run, of) in self.strokes.runs().filter(|(run, _)| run.pen == Pen::Cut) {
            let mut from = run.from;
            // A circle may come in two halves.
            let mut around: Option<(Point2, f64)> = None;
            for stroke in of {
                let bend = self.strokes.bend(stroke);
                around = bend.map(|bend| match around {
                    Some((center, sweep)) if distance(center, bend.center) < 1e-3 => (center, sweep + bend.sweep),
                    _ => (bend.center, bend.sweep),
                });
                if let Some((center, sweep)) = around
                    && sweep.abs() > core::f64::consts::TAU - 1e-4
                {
                    let radius = distance(from, center);
                    let known = seen.iter().any(|(at, r)| distance(*at, center) < 1e-3 && (r - radius).abs() < 1e-3);
                    if !known && seen.len() < MOST {
                        seen.push((center, radius));
                    }
                }
                from = stroke.to;
            }
        }
        for (center, radius) in seen {
            let arm = (0.25 * radius).min(8.0 * self.layout.pixel);
            let cross = [
                Part::Move(center - Vec2::new(arm, 0.0)),
                Part::Line(center + Vec2::new(arm, 0.0)),
                Part::Move(center - Vec2::new(0.0, arm)),
                Part::Line(center + Vec2::new(0.0, arm)),
            ];
            canvas.path(Class::Dimension, None, &cross);
            let text = format!("⌀{}", show(2.0 * radius));
            // To the left where the edge of the picture would cut it off.
            let ways = [(1.0, Anchor::Start), (-1.0, Anchor::End)].map(|(side, anchor)| {
                let way = Vec2::new(side, 1.0);
                let on = center + way * (radius * core::f64::consts::FRAC_1_SQRT_2);
                (on, on + way * (0.8 * font), anchor)
            });
            let fits = ways.iter().find(|(_, to, anchor)| labels.fits(*to, *anchor, font, &text));
            let (on, to, anchor) = *fits.unwrap_or(&ways[0]);
            if labels.place(to, anchor, font, text) {
                canvas.path(Class::Dimension, None, &[Part::Move(on), Part::Line(to)]);
            }
        }
    }

    /// Where a tool goes straight in.
    fn holes(&self, labels: &mut Labels) {
        let font = 0.75 * self.layout.font;
        let mut seen: Vec<Point2> = Vec::new();
        for (run, _) in self.strokes.runs().filter(|(run, _)| run.pen == Pen::Dot) {
            if seen.iter().any(|p| distance(*p, run.from) < 1e-4) {
                continue;
            }
            seen.push(run.from);
            let text = format!("{}, {}", show(run.from.x * self.factors.0), show(run.from.y * self.factors.1));
            // At the left of the hole where the edge of the picture would cut it off.
            let ways = [(0.5, Anchor::Start), (-0.5, Anchor::End)]
                .map(|(side, anchor)| (run.from + Vec2::new(side, 0.5) * font, anchor));
            let fits = ways.iter().find(|(at, anchor)| labels.fits(*at, *anchor, font, &text));
            let (at, anchor) = *fits.unwrap_or(&ways[0]);
            labels.place(at, anchor, font, text);
        }
    }

    /// Diameters and shoulders of the half section.
    fn turned(&self, canvas: &mut dyn Canvas, labels: &mut Labels) {
        let font = 0.8 * self.layout.font;
        let shortest = 12.0 * self.layout.pixel;
        let mut shoulders: Vec<f64> = Vec::new();
        for edge in &self.section.edges {
            let Element::Line { from, to } = *edge else { continue };
            if (from.y - to.y).abs() <= SAME_POINT && (from.x - to.x).abs() >= shortest {
                let at = edge.middle() - Vec2::new(0.0, 1.0 * font);
                labels.place(at, Anchor::Middle, font, format!("⌀{}", show(2.0 * from.y.abs())));
            }
            for p in [from, to] {
                let is_new = !shoulders.iter().any(|z| (z - p.x).abs() < 1e-3);
                if is_new && (from.x - to.x).abs() <= SAME_POINT && shoulders.len() < MOST {
                    shoulders.push(p.x);
                }
            }
        }
        let low = self.section.edges.iter().map(|edge| edge.from().y.min(edge.to().y)).fold(0.0, f64::min);
        for z in shoulders {
            let text = show(z);
            let below = Point2::new(z, self.layout.low.y + 0.4 * font);
            // The vertical axis would strike the word out.
            let half = LETTER * font * text.chars().count() as f64 / 2.0;
            let beside = Point2::new(0.4 * font, below.y);
            let (at, anchor) = if z.abs() <= half { (beside, Anchor::Start) } else { (below, Anchor::Middle) };
            if labels.place(at, anchor, font, text) {
                let (from, to) = (Point2::new(z, low - 0.3 * font), below + Vec2::new(0.0, 0.9 * font));
                canvas.path(Class::Dimension, None, &[Part::Move(from), Part::Line(to)]);
            }
        }
    }
}
