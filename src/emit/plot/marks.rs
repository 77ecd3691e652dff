//! What helps to read a path: arrows in its direction, where it begins and ends, dimensions.

use crate::geo::{Point2, Vec2, direction, distance, left, turned};

use super::canvas::{Canvas, Class, Part};
use super::strokes::{Pen, Strokes};

/// Pixels of an arrow, of the way between two, and of the shortest stroke that carries one.
const ARROW: f64 = 11.0;
const BETWEEN: f64 = 110.0;
const SHORTEST: f64 = 12.0;
/// Arrows of a picture.
const MOST_ARROWS: usize = 80;

/// A filled triangle with its point at `tip`.
pub(super) fn arrow(canvas: &mut dyn Canvas, class: Class, tip: Point2, along: Vec2, length: f64) {
    let back = tip - along * length;
    let aside = left(along) * (length * 0.32);
    canvas.path(class, None, &[Part::Move(tip), Part::Line(back + aside), Part::Line(back - aside), Part::Close]);
}

/// Arrows on strokes that are long enough, some way from each other.
pub(super) fn arrows(canvas: &mut dyn Canvas, strokes: &Strokes, pixel: f64) {
    let (mut since, mut drawn) = (BETWEEN * pixel, 0);
    // Where there is much of it, an arrow now and then is enough.
    let total: f64 = strokes.runs().map(|(run, of)| length(strokes, run.from, of)).sum();
    let between = (BETWEEN * pixel).max(total / MOST_ARROWS as f64);
    for (run, of) in strokes.runs() {
        if matches!(run.pen, Pen::Dot | Pen::Contour | Pen::Thread) {
            continue;
        }
        let mut from = run.from;
        for stroke in of {
            let way = distance(from, stroke.to);
            since += way;
            if since >= between && way >= SHORTEST * pixel && drawn < MOST_ARROWS {
                let (middle, along) = match strokes.bend(stroke) {
                    Some(bend) => {
                        let out = turned(from - bend.center, bend.sweep / 2.0);
                        let along = direction(left(out), 0.0).unwrap_or(out) * bend.sweep.signum();
                        (bend.center + out, along)
                    }
                    None => (from + (stroke.to - from) / 2.0, direction(stroke.to - from, 0.0).unwrap_or(Vec2::x())),
                };
                let size = ARROW * pixel;
                arrow(canvas, Class::Arrow(run.colour), middle + along * (size / 2.0), along, size);
                (since, drawn) = (0.0, drawn + 1);
            }
            from = stroke.to;
        }
    }
}

fn length(strokes: &Strokes, from: Point2, of: &[super::strokes::Stroke]) -> f64 {
    let mut at = from;
    let mut sum = 0.0;
    for stroke in of {
        sum += match strokes.bend(stroke) {
            Some(bend) => distance(at, bend.center) * bend.sweep.abs(),
            None => distance(at, stroke.to),
        };
        at = stroke.to;
    }
    sum
}

/// Cells of the longer side of a picture in which strokes are looked for.
const CELLS: f64 = 60.0;
/// Places of a stroke that are looked at.
const PLACES: f64 = 200.0;

/// About the area that cuts take up, or rapids where nothing is cut.
pub(super) fn covered(strokes: &Strokes) -> f64 {
    let Some((low, high)) = strokes.rect.0 else { return 0.0 };
    let cell = ((high - low).amax() / CELLS).max(1e-9);
    let row = CELLS as usize + 2;
    let count = |rapid: bool| {
        let mut cells = vec![false; row * row];
        for (run, of) in strokes.runs().filter(|(run, _)| (run.pen == Pen::Rapid) == rapid) {
            let mut from = run.from;
            for stroke in of {
                let bend = strokes.bend(stroke);
                let way = bend.map_or(distance(from, stroke.to), |bend| distance(from, bend.center) * bend.sweep.abs());
                let places = (libm::ceil(2.0 * way / cell) + 1.0).min(PLACES) as u32;
                for i in 0..=places {
                    let t = f64::from(i) / f64::from(places);
                    let at = match bend {
                        Some(bend) => bend.center + turned(from - bend.center, bend.sweep * t),
                        None => from + (stroke.to - from) * t,
                    };
                    let p = (at - low) / cell;
                    if let Some(cell) = cells.get_mut(p.y as usize * row + p.x as usize) {
                        *cell = true;
                    }
                }
                from = stroke.to;
            }
        }
        cells.iter().filter(|cell| **cell).count() as f64 * cell * cell
    };
    let cut = count(false);
    if cut > 0.0 { cut } else { count(true) }
}

/// Lengths of the path by pen: cuts, rapids.
pub(super) fn lengths(strokes: &Strokes) -> (f64, f64) {
    let mut sums = (0.0, 0.0);
    for (run, of) in strokes.runs() {
        let way = length(strokes, run.from, of);
        if run.pen == Pen::Rapid {
            sums.1 += way;
        } else {
            sums.0 += way;
        }
    }
    sums
}

/// A ring where the path begins and a square where it ends.
pub(super) fn ends(canvas: &mut dyn Canvas, start: Point2, end: Point2, pixel: f64) {
    ring(canvas, start, 8.0 * pixel);
    square(canvas, end, 4.0 * pixel);
}

pub(super) fn ring(canvas: &mut dyn Canvas, center: Point2, radius: f64) {
    let from = center + Vec2::new(radius, 0.0);
    let around = Part::Arc { center, sweep: core::f64::consts::TAU, to: from };
    canvas.path(Class::Start, None, &[Part::Move(from), around]);
}

pub(super) fn square(canvas: &mut dyn Canvas, center: Point2, half: f64) {
    let corner = |x: f64, y: f64| center + Vec2::new(x * half, y * half);
    let parts = [
        Part::Move(corner(-1.0, -1.0)),
        Part::Line(corner(1.0, -1.0)),
        Part::Line(corner(1.0, 1.0)),
        Part::Line(corner(-1.0, 1.0)),
        Part::Close,
    ];
    canvas.path(Class::End, None, &parts);
}
