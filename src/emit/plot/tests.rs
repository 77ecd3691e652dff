//! What is left out of a path cannot be seen, and nothing that a picture says is no number.

use proptest::prelude::*;

use super::rect::Bend;
use super::strokes::{ALL_DRAWN, Pen, Strokes, tolerance};
use super::*;
use crate::geo::Vec2;
use crate::ir::Feed;
use crate::text::Loc;

/// The points of a path of so many steps: chains of little steps, with leaps, circles and points between them.
fn path(seed: u64, count: usize) -> Vec<(Pen, Point2, Point2, Option<Bend>)> {
    let mut state = seed | 1;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut at, mut heading) = (Point2::origin(), 0.0);
    let mut all = Vec::with_capacity(count);
    for _ in 0..count {
        let kind = random();
        heading += (random() - 0.5) * 0.4;
        let step = |length: f64| Vec2::new(libm::cos(heading), libm::sin(heading)) * length;
        let (pen, to, bend) = if kind < 0.002 {
            (Pen::Rapid, Point2::new(200.0 * random() - 100.0, 200.0 * random() - 100.0), None)
        } else if kind < 0.01 {
            (Pen::Dot, at, None)
        } else if kind < 0.1 {
            let center = at + step(random() * 5.0 + 0.01);
            let bend = Bend { center, sweep: (random() - 0.5) * 12.0 };
            (Pen::Cut, bend.end(at), Some(bend))
        } else {
            (Pen::Cut, at + step(random() * 0.3), None)
        };
        all.push((pen, at, to, bend));
        at = to;
    }
    all
}

fn drawn(path: &[(Pen, Point2, Point2, Option<Bend>)]) -> (Strokes, Option<f64>) {
    let mut strokes = Strokes::default();
    for (i, (pen, from, to, bend)) in path.iter().enumerate() {
        let loc = Loc { line: i as u32 + 1, ..Loc::default() };
        match bend {
            Some(bend) => strokes.arc((*pen, 0), *from, *to, *bend, loc),
            None => strokes.line(*pen, 0, *from, *to, loc),
        }
    }
    let error = strokes.finish();
    (strokes, error)
}

/// The points of what is drawn, with the points of arcs close together.
fn points(from: Point2, to: Point2, bend: Option<Bend>) -> Vec<Point2> {
    let Some(bend) = bend else { return vec![from, to] };
    let way = |i: u32| bend.center + turned(from - bend.center, bend.sweep * f64::from(i) / 64.0);
    (0..=64).map(way).chain([to]).collect()
}

fn away(p: Point2, line: &[Point2]) -> f64 {
    let to_line = |a: Point2, b: Point2| {
        let square = (b - a).norm_squared();
        let t = if square > 0.0 { ((p - a).dot(&(b - a)) / square).clamp(0.0, 1.0) } else { 0.0 };
        distance(p, a + (b - a) * t)
    };
    line.windows(2).map(|pair| to_line(pair[0], pair[1])).fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4, ..ProptestConfig::default() })]

    #[test]
    fn what_is_left_out_is_less_than_a_third_of_a_pixel(seed in any::<u64>(), more in 1usize..30_000) {
        let path = path(seed, ALL_DRAWN + more);
        let (strokes, error) = drawn(&path);
        let error = error.expect("little steps are put together");
        let most = tolerance(strokes.rect.size());
        prop_assert!(error <= most * (1.0 + 1e-6), "{error} {most}");
        // The rectangle of the drawn strokes is that of the path.
        let mut rect = Rect::default();
        for (_, from, to, bend) in &path {
            match bend {
                Some(bend) => rect.take_arc(*from, bend),
                None => { rect.take(*from); rect.take(*to) }
            }
        }
        let mut shown = Rect::default();
        let mut all = Vec::new();
        for (run, of) in strokes.runs() {
            let mut from = run.from;
            for stroke in of {
                let bend = strokes.bend(stroke);
                match bend {
                    Some(bend) => shown.take_arc(from, &bend),
                    None => { shown.take(from); shown.take(stroke.to) }
                }
                all.push((from, stroke.to, bend, stroke.loc.line as usize - 1));
                from = stroke.to;
            }
        }
        // Strokes stand in the order of the path and name the first block that they stand for.
        let ends = all.iter().skip(1).map(|(.., first)| *first).chain([path.len()]);
        for ((from, to, bend, first), end) in all.iter().zip(ends) {
            let chord = points(*from, *to, *bend);
            prop_assert!(*first < end);
            for (_, a, b, bend) in path.get(*first..end).unwrap_or_default().iter().filter(|_| end - first > 1) {
                for p in points(*a, *b, *bend) {
                    prop_assert!(away(p, &chord) <= error + 1e-9, "{p} {error}");
                }
            }
        }
        let near = |a: Option<(Point2, Point2)>, b: Option<(Point2, Point2)>| {
            let (a, b) = (a.expect("a path"), b.expect("strokes"));
            distance(a.0, b.0) < 1e-6 && distance(a.1, b.1) < 1e-6
        };
        prop_assert!(near(rect.0, shown.0) && near(rect.0, strokes.rect.0), "{rect:?} {shown:?}");
    }

    #[test]
    fn a_picture_of_any_moves_holds_numbers_only(
        moves in prop::collection::vec((any::<u8>(), -1e6..1e6f64, -1e3..1e3f64, -1e-5..1e-5f64), 0..60),
        side in 0u8..5,
        lathe in any::<bool>(),
    ) {
        let side = [None, Some(Side::Xy), Some(Side::Xz), Some(Side::Yz), Some(Side::Iso)][usize::from(side)];
        for form in forms() {
            let mut settings = Settings::default();
            if lathe {
                settings.machine.kind = MachineKind::Lathe;
            }
            let mut plot = Plot::new(&settings, "any <&\"> moves", Options { view: side, dimensions: true, form });
            moves.iter().for_each(|mv| any_move(&mut plot, *mv));
            let mut out: Vec<u8> = Vec::new();
            plot.finish(None, &mut out).expect("memory takes everything");
            if form == Form::Svg {
                let text = String::from_utf8(out).expect("text");
                prop_assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
                prop_assert!(text.ends_with("</svg>\n"));
            } else {
                prop_assert!(out.starts_with(b"\x89PNG"));
            }
        }
    }
}

fn forms() -> Vec<Form> {
    vec![
        Form::Svg,
        #[cfg(feature = "png")]
        Form::Png,
    ]
}

fn any_move(plot: &mut Plot, (kind, x, y, z): (u8, f64, f64, f64)) {
    let mut end = Pos::UNKNOWN;
    let plane = [Plane::Xy, Plane::Zx, Plane::Yz][usize::from(kind) % 3];
    for (axis, value) in Axis::ALL.iter().zip([x, y, z]) {
        end.set(*axis, value);
    }
    let feed = Feed::PerMinute(100.0);
    let from = plot.at.in_plane(plane);
    let path = match (kind % 7, from) {
        (0, _) => Path::Rapid,
        (1, Some(from)) => {
            let center = from + Vec2::new(z * 1e6, y);
            let sweep = x * 1e-4;
            if let Some(plane_end) = (sweep != 0.0).then(|| center + turned(from - center, sweep)) {
                end.set_in_plane(plane, plane_end);
            }
            Path::Arc(Arc { plane, from, center, sweep }, feed)
        }
        (2, _) => Path::Thread { lead: 1.5 },
        _ => Path::Line(feed),
    };
    let mv = Move { end, axes: end.known(), path, plane, machine: kind == 200, ..Move::default() };
    if kind == 100 {
        plot.function(&Function::ToolChange { number: 7 }, &Origin::default());
    }
    plot.movement(&mv, &Origin::default());
    plot.programmed(&mv, &plot.at.clone());
    if kind % 11 == 0 {
        let contour = [
            Element::Line { from: Point2::new(z, 0.0), to: Point2::new(x, y) },
            Element::Line { from: Point2::new(x, y), to: Point2::new(y, x) },
        ];
        plot.finished(
            &contour,
            [Towards::MinusX, Towards::PlusX, Towards::MinusZ, Towards::PlusZ][usize::from(kind) % 4],
        );
    }
}

#[test]
fn errors_are_rounded_up() {
    for (value, text) in
        [(0.0412, "0.042"), (0.04, "0.04"), (1.21, "1.3"), (123.0, "130"), (0.0, "0"), (1e-9, "0.000001")]
    {
        assert_eq!(rounded_up(value), text, "{value}");
    }
}

#[test]
fn a_short_path_is_drawn_as_it_is() {
    let path = path(7, 500);
    let (strokes, error) = drawn(&path);
    assert_eq!((strokes.len(), error), (500, None));
}
