//! Thread cutting: approach, cut in step with the spindle, lift, return; pass by pass.
//!
//! ```text
//!   retract ──────◄──────────────────◄─────── lift
//!     │ rapid                            ▲
//!     ▼    run-in       thread      run-out
//!     ├────────────►════════════════►────┘
//! ```

use crate::diag::{Fault, codes};
use crate::geo::Point2;
use crate::ir::cycle::Family;
use crate::ir::cycle::thread::{Flank, Thread};

use super::infeed::Series;
use super::track::{Strokes, Track, View};
use super::{CycleItem, Expand, Start};

/// Most cuts of one thread.
const MOST_CUTS: u64 = 100_000;

impl Expand for Thread {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        expand(self, start.in_turning_plane()?, &mut |stroke| out(stroke.part()))
    }
}

/// Sends the strokes of `thread`; the tool stands at `from`.
///
/// # Errors
/// G3040 too many cuts, G3041 bad arguments, G3042 a flank offset longer than the way it uses up.
pub fn expand<'a>(thread: &Thread, from: Point2, out: &'a mut Strokes<'a>) -> Result<(), Fault> {
    thread.check().map_err(|fault| codes::G3041::thread_makes_no_path(&fault))?;
    let line = Line::of(thread);
    let series = Series::new(thread.infeed, thread.depth - thread.finish);
    let passes = Passes { thread, series };
    let cuts = passes.count().saturating_mul(u64::from(thread.starts));
    if cuts > MOST_CUTS {
        return Err(codes::G3040::infeed_makes_cuts_of_this_thread(&cuts, &MOST_CUTS));
    }
    check_shifts(&passes, &line)?;

    let view = line.view;
    let retract = view.height(thread.retract);
    let park = view.point(thread.park);
    let first = line.before(thread.run_in - passes.shift(1) + thread.start_angle.0 / 360.0 * line.first_lead());
    let stands = view.point(from);
    if stands.y < retract - 1e-9 && stands.x > line.start.x + 1e-9 {
        return Err(codes::G3046::tool_stands_beside_thread_at_its_height());
    }
    let mut track = Track::new(view, from, out);
    // Whoever stands higher than the way back stays there until the start is reached.
    let approach = track.at().y.max(retract);
    track.rapid(Point2::new(track.at().x, approach));
    for start in 0..thread.starts {
        let turn = thread.start_angle.0 / 360.0 + f64::from(start) / f64::from(thread.starts);
        for k in 1..=passes.count() {
            let depth = passes.depth(k);
            let shift = passes.shift(k);
            let begin = line.before(thread.run_in - shift + turn * line.first_lead());
            track.rapid(Point2::new(begin.x, track.at().y));
            track.rapid(Point2::new(begin.x, begin.y - depth));
            line.cut(&mut track, depth, thread.run_out + if thread.fixed_end { 0.0 } else { shift });
            track.rapid(Point2::new(track.at().x, retract));
        }
    }
    if park.x > line.start.x + 1e-9 {
        // What stands behind the thread may be higher than the way back: the tool leaves as it came.
        let high = park.y.max(retract);
        track.rapid(Point2::new(first.x, retract));
        track.rapid(Point2::new(first.x, high));
        track.rapid(Point2::new(park.x, high));
    } else {
        track.rapid(Point2::new(park.x, retract));
    }
    track.rapid(park);
    Ok(())
}

/// The cuts of one start, in order.
struct Passes<'t> {
    thread: &'t Thread,
    series: Series,
}

impl Passes<'_> {
    fn count(&self) -> u64 {
        let finish = u64::from(self.thread.finish > 0.0);
        self.series.cuts().saturating_add(finish).saturating_add(u64::from(self.thread.air_cuts))
    }

    /// Depth of cut `k`, counted from 1.
    fn depth(&self, k: u64) -> f64 {
        if k <= self.series.cuts() { self.series.depth(k) } else { self.thread.depth }
    }

    /// How far cut `k` lies ahead, along the cutting axis.
    fn shift(&self, k: u64) -> f64 {
        let depth = self.depth(k);
        let above = self.thread.depth - depth;
        let tan = self.thread.flank.angle().map_or(0.0, |angle| libm::tan(angle.radians()));
        match self.thread.flank {
            Flank::Radial => 0.0,
            Flank::Ahead { .. } => above * tan,
            Flank::Behind { .. } => -above * tan,
            Flank::Alternating { .. } if k % 2 == 1 => above * tan,
            Flank::Alternating { .. } => -above * tan,
            Flank::FromCrest { .. } => depth * tan,
        }
    }
}

/// A shift ahead uses up run-in, one behind uses up run-out and the last part.
fn check_shifts(passes: &Passes<'_>, line: &Line) -> Result<(), Fault> {
    let (mut ahead, mut behind) = (0.0_f64, 0.0_f64);
    for k in 1..=passes.count() {
        ahead = ahead.max(passes.shift(k));
        behind = behind.max(-passes.shift(k));
    }
    let thread = passes.thread;
    if ahead > thread.run_in {
        return Err(codes::G3042::flank_infeed_starts_cut_mm_ahead(&ahead, &thread.run_in));
    }
    if behind >= thread.run_out + line.last_length() {
        return Err(codes::G3042::flank_infeed_ends_cut_mm_early(&behind));
    }
    Ok(())
}

/// The thread at depth 0 in its view.
struct Line {
    view: View,
    start: Point2,
    /// End and lead of each part.
    parts: Vec<(Point2, f64)>,
}

impl Line {
    fn of(thread: &Thread) -> Line {
        let way = thread.parts.first().map_or(0.0, |part| {
            let way = part.end - thread.start;
            if thread.into.is_radial() { way.x } else { way.y }
        });
        let view = View::new(thread.into, way);
        let parts = thread.parts.iter().map(|part| (view.point(part.end), part.lead)).collect();
        Line { view, start: view.point(thread.start), parts }
    }

    fn first_lead(&self) -> f64 {
        self.parts.first().map_or(0.0, |part| part.1)
    }

    /// The last part with its start.
    fn last(&self) -> (Point2, Point2) {
        let from = self.parts.iter().rev().nth(1).map_or(self.start, |part| part.0);
        (from, self.parts.last().map_or(self.start, |part| part.0))
    }

    fn last_length(&self) -> f64 {
        let (from, to) = self.last();
        to.x - from.x
    }

    /// The point `way` in front of the start.
    fn before(&self, way: f64) -> Point2 {
        extended(self.parts.first().map_or(self.start, |part| part.0), self.start, way)
    }

    /// Cuts along all parts and `way` further.
    fn cut(&self, track: &mut Track<'_>, depth: f64, way: f64) {
        let last = self.parts.len() - 1;
        for (i, &(end, lead)) in self.parts.iter().enumerate() {
            let to = if i == last { extended(self.last().0, end, way) } else { end };
            track.thread(Point2::new(to.x, to.y - depth), lead);
        }
    }
}

/// The point `way` behind `to` on the line from `from`, measured along x.
fn extended(from: Point2, to: Point2, way: f64) -> Point2 {
    let line = to - from;
    to + line * (way / line.x.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::Deg;
    use crate::ir::cycle::Cycle;
    use crate::ir::cycle::thread::tests::m20;
    use crate::ir::cycle::thread::{Infeed, ThreadPart};
    use crate::ir::cycle::turning::Towards;
    use crate::lower::cycles::simulate::check_lowering;
    use crate::lower::cycles::track::{Move, Path, Stroke};
    use proptest::prelude::*;

    fn strokes(thread: &Thread, from: Point2) -> Vec<Move> {
        let mut list = Vec::new();
        expand(thread, from, &mut |stroke| {
            if let Stroke::Move(mv) = stroke {
                list.push(mv);
            }
        })
        .expect("a thread");
        list
    }

    /// Strokes as words with X as a diameter, rounded to four decimals; axes that stay are left out.
    fn words(list: &[Move], from: Point2) -> Vec<String> {
        let mut at = from;
        let round = |v: f64| (v * 1e4).round() / 1e4;
        let mut text = Vec::new();
        for &Move { to, path } in list {
            let head = match path {
                Path::Rapid => "G0",
                Path::Thread { .. } => "G33",
                Path::Line { .. } | Path::Arc { .. } => "G1",
            };
            let x = if to.y == at.y { String::new() } else { format!(" X{}", round(2.0 * to.y)) };
            let z = if to.x == at.x { String::new() } else { format!(" Z{}", round(to.x)) };
            let k = if let Path::Thread { lead, .. } = path { format!(" K{lead}") } else { String::new() };
            text.push(format!("{head}{x}{z}{k}"));
            at = to;
        }
        text
    }

    fn cut_starts(list: &[Move]) -> Vec<Point2> {
        let mut last = Point2::origin();
        let mut starts = Vec::new();
        for mv in list {
            if matches!(mv.path, Path::Thread { .. }) {
                starts.push(last);
            }
            last = mv.to;
        }
        starts
    }

    #[test]
    fn m20_with_constant_area() {
        let from = Point2::new(5.0, 13.0);
        let thread = m20();
        let list = words(&strokes(&thread, from), from);
        assert_eq!(list[..5], ["G0 Z8", "G0 X19.4", "G33 Z-21 K1.5", "G0 X26", "G0 Z8"]);
        assert_eq!(list[5..7], ["G0 X19.1515", "G33 Z-21 K1.5"]);
        assert_eq!(list.iter().filter(|word| word.starts_with("G33")).count(), 10);
        assert_eq!(list[list.len() - 4..], ["G0 X18.16", "G33 Z-21 K1.5", "G0 X26", "G0 Z5"]);
    }

    #[test]
    fn flank_offsets_as_computed_by_hand() {
        let from = Point2::new(5.0, 13.0);
        let angle = Deg::from_radians(libm::atan(0.5 * 1.5 / 0.92));
        assert!((angle.0 - 39.1875).abs() < 5e-5);
        let shifted = |flank| {
            let thread = Thread { infeed: Infeed::Remainder { most: 0.3 }, flank, ..m20() };
            cut_starts(&strokes(&thread, from)).iter().map(|p| 8.0 - p.x).collect::<Vec<_>>()
        };
        let near = |found: Vec<f64>, expected: [f64; 4]| {
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 6e-5), "{found:?}");
        };
        near(shifted(Flank::Ahead { angle }), [0.7337, 0.4891, 0.2446, 0.0]);
        near(shifted(Flank::Behind { angle }), [-0.7337, -0.4891, -0.2446, 0.0]);
        near(shifted(Flank::Alternating { angle }), [0.7337, -0.4891, 0.2446, 0.0]);
        near(shifted(Flank::Ahead { angle: Deg(30.0) }), [0.5196, 0.3464, 0.1732, 0.0]);
    }

    #[test]
    fn the_end_shifts_with_the_start() {
        let from = Point2::new(5.0, 13.0);
        let flank = Flank::Ahead { angle: Deg(30.0) };
        let thread = Thread { infeed: Infeed::Remainder { most: 0.3 }, flank, ..m20() };
        assert_eq!(words(&strokes(&thread, from), from)[..3], ["G0 Z7.4804", "G0 X19.96", "G33 Z-21.5196 K1.5"]);
    }

    #[test]
    fn the_start_angle_begins_farther_ahead() {
        // A quarter turn of a lead of 1.5 in front of Z8.
        let from = Point2::new(5.0, 13.0);
        let thread = Thread { start_angle: Deg(90.0), ..m20() };
        assert_eq!(words(&strokes(&thread, from), from)[..3], ["G0 Z8.375", "G0 X19.4", "G33 Z-21 K1.5"]);
        // To a place behind the thread the tool leaves as it came.
        let behind = Thread { park: Point2::new(-30.0, 15.0), ..thread };
        let list = words(&strokes(&behind, from), from);
        assert_eq!(list[list.len() - 3..], ["G0 Z8.375", "G0 X30", "G0 Z-30"]);
    }

    #[test]
    fn flank_offset_from_the_crest() {
        // M20×1.5, depth 0.92, finishing 0.05, five passes and one air cut, 30 degrees.
        let from = Point2::new(5.0, 13.0);
        let flank = Flank::FromCrest { angle: Deg(30.0) };
        let infeed = Infeed::AreaPasses { passes: 5 };
        let thread = Thread { infeed, flank, finish: 0.05, air_cuts: 1, ..m20() };
        let starts = cut_starts(&strokes(&thread, from));
        let x = [19.2218, 18.8995, 18.6522, 18.4437, 18.26, 18.16, 18.16];
        let shift = [0.2246, 0.3177, 0.3891, 0.4493, 0.5023, 0.5312, 0.5312];
        assert_eq!(starts.len(), 7);
        for ((p, x), s) in starts.iter().zip(x).zip(shift) {
            assert!((2.0 * p.y - x).abs() < 6e-5 && (8.0 - p.x - s).abs() < 6e-5, "{p:?} {x} {s}");
        }
    }

    #[test]
    fn internal_thread_as_computed_by_hand() {
        let infeed = Infeed::AreaPasses { passes: 5 };
        let bore = 18.3762 / 2.0;
        let thread = Thread {
            start: Point2::new(0.0, bore),
            parts: vec![ThreadPart { end: Point2::new(-20.0, bore), lead: 1.5 }],
            into: Towards::PlusX,
            depth: 0.8119,
            finish: 0.05,
            infeed,
            retract: bore - 1.0,
            park: Point2::new(3.0, bore - 1.0),
            ..m20()
        };
        let starts = cut_starts(&strokes(&thread, thread.park));
        let x = [19.0577, 19.3400, 19.5566, 19.7392, 19.9001, 20.0];
        assert_eq!(starts.len(), 6);
        // The example rounds its inputs, so its last digit is off by one.
        assert!(starts.iter().zip(x).all(|(p, x)| (2.0 * p.y - x).abs() < 1.1e-4), "{starts:?}");
    }

    #[test]
    fn taper_as_computed_by_hand() {
        // X28 at Z2 to X30 at Z-20: the slope is 1 mm of radius on 22 mm.
        let thread = Thread {
            start: Point2::new(2.0, 14.0),
            parts: vec![ThreadPart { end: Point2::new(-20.0, 15.0), lead: 1.5 }],
            depth: 1e-9,
            infeed: Infeed::EqualPasses { passes: 1 },
            retract: 16.0,
            ..m20()
        };
        let from = Point2::new(5.0, 16.0);
        assert_eq!(words(&strokes(&thread, from), from)[..2], ["G0 X27.7273", "G33 X30.0909 Z-21 K1.5"]);
    }

    #[test]
    fn chain_as_computed_by_hand() {
        let thread = Thread {
            start: Point2::new(0.0, 15.0),
            parts: vec![
                ThreadPart { end: Point2::new(-20.0, 15.0), lead: 2.0 },
                ThreadPart { end: Point2::new(-40.0, 17.0), lead: 2.0 },
            ],
            depth: 1.2,
            infeed: Infeed::Equal { most: 0.4 },
            run_in: 4.0,
            run_out: 2.0,
            retract: 20.0,
            park: Point2::new(6.0, 20.0),
            ..m20()
        };
        let from = Point2::new(6.0, 20.0);
        let list = words(&strokes(&thread, from), from);
        let first = ["G0 Z4", "G0 X29.2", "G33 Z-20 K2", "G33 X33.6 Z-42 K2", "G0 X40"];
        // Local diameter less 0.8 at the end of the second part: 34.4 - 0.8.
        assert_eq!(list[..5], first);
        assert_eq!(list[5..7], ["G0 Z4", "G0 X28.4"]);
        assert_eq!(list[list.len() - 1], "G0 Z6");
    }

    #[test]
    fn starts_and_start_angle_lengthen_the_run_in() {
        let infeed = Infeed::EqualPasses { passes: 1 };
        let thread = Thread { infeed, starts: 3, start_angle: Deg(90.0), ..m20() };
        let starts = cut_starts(&strokes(&thread, Point2::new(5.0, 13.0)));
        let z: Vec<_> = starts.iter().map(|p| p.x).collect();
        assert_eq!(z, [8.375, 8.875, 9.375]);
    }

    #[test]
    fn a_tool_that_stands_far_out_stays_there_until_it_is_at_the_start() {
        let from = Point2::new(-50.0, 50.0);
        let list = words(&strokes(&m20(), from), from);
        assert_eq!(list[..3], ["G0 Z8", "G0 X19.4", "G33 Z-21 K1.5"]);
        let from = Point2::new(9.0, 9.0);
        assert_eq!(words(&strokes(&m20(), from), from)[..3], ["G0 X26", "G0 Z8", "G0 X19.4"]);
    }

    #[test]
    fn refused_threads() {
        let code = |thread: Thread| expand(&thread, Point2::origin(), &mut |_| ()).expect_err("refused").code().id;
        assert_eq!(code(Thread { infeed: Infeed::Equal { most: 1e-9 }, ..m20() }), "G3040");
        assert_eq!(code(Thread { infeed: Infeed::ConstantArea { first: 1e-300 }, ..m20() }), "G3040");
        assert_eq!(code(Thread { air_cuts: u32::MAX, starts: u32::MAX, ..m20() }), "G3040");
        assert_eq!(code(Thread { depth: 0.0, ..m20() }), "G3041");
        assert_eq!(code(Thread { run_in: 0.1, flank: Flank::Ahead { angle: Deg(30.0) }, ..m20() }), "G3042");
        assert_eq!(code(Thread { flank: Flank::Behind { angle: Deg(89.99) }, ..m20() }), "G3042");
    }

    #[test]
    fn a_cut_may_end_early_by_the_run_out_and_the_last_part() {
        // The first cut is 0.3 mm deep: 0.62 mm above the bottom, behind by 0.62 * tan(angle). The run-out is 1 mm.
        let cut = |parts: &[ThreadPart], angle: f64| {
            let thread = Thread { parts: parts.to_vec(), flank: Flank::Behind { angle: Deg(angle) }, ..m20() };
            expand(&thread, thread.park, &mut |_| ()).map_err(|fault| fault.code().id)
        };
        let part = |z: f64| ThreadPart { end: Point2::new(z, 10.0), lead: 1.5 };
        // 25 mm and 1 mm: 23.7 mm go, 27.3 mm do not.
        assert_eq!(cut(&[part(-20.0)], 88.5), Ok(()));
        assert_eq!(cut(&[part(-20.0)], 88.7), Err("G3042"));
        // The last part is 5 mm long: 5.9 mm go, 6.1 mm do not.
        assert_eq!(cut(&[part(-15.0), part(-20.0)], 84.0), Ok(()));
        assert_eq!(cut(&[part(-15.0), part(-20.0)], 84.2), Err("G3042"));
    }

    fn thread() -> impl Strategy<Value = Thread> {
        let infeed = prop_oneof![
            (0.05f64..1.0).prop_map(|first| Infeed::ConstantArea { first }),
            (0.05f64..1.0).prop_map(|most| Infeed::Equal { most }),
            (0.05f64..1.0).prop_map(|most| Infeed::RemainderSplit { most }),
            (0.05f64..1.0).prop_map(|most| Infeed::Remainder { most }),
            (1u32..20).prop_map(|passes| Infeed::EqualPasses { passes }),
        ];
        let flank = (0usize..5, 0.0f64..40.0).prop_map(|(kind, angle)| {
            let angle = Deg(angle);
            [
                Flank::Radial,
                Flank::Ahead { angle },
                Flank::Behind { angle },
                Flank::Alternating { angle },
                Flank::FromCrest { angle },
            ][kind]
        });
        let parts = prop::collection::vec((5.0f64..20.0, -0.9f64..0.9, 0.5f64..3.0), 1..=6);
        let side =
            prop_oneof![Just(Towards::MinusX), Just(Towards::PlusX), Just(Towards::MinusZ), Just(Towards::PlusZ)];
        let rest = (0.3f64..2.0, 0u32..3, 2.0f64..6.0, 0.0f64..5.0, 1u32..4, any::<bool>());
        (infeed, flank, parts, side, rest).prop_map(|(infeed, flank, parts, into, rest)| {
            let (depth, air_cuts, run_in, run_out, starts, back) = rest;
            let view = View::new(into, if back { -1.0 } else { 1.0 });
            let mut at = Point2::new(0.0, 100.0);
            let mut list = Vec::new();
            for (length, slope, lead) in parts {
                at = Point2::new(at.x + length, at.y + slope * length);
                list.push(ThreadPart { end: view.part(at), lead });
            }
            let park = view.part(Point2::new(-1.0, 250.0));
            Thread {
                start: view.part(Point2::new(0.0, 100.0)),
                parts: list,
                into,
                depth,
                infeed,
                flank,
                finish: if air_cuts == 2 { depth / 10.0 } else { 0.0 },
                air_cuts,
                run_in,
                run_out,
                fixed_end: false,
                starts,
                start_angle: Deg(0.0),
                retract: into.depth_coordinate(park),
                park,
            }
        })
    }

    proptest! {
        /// Never deeper than the depth, never a rapid below the retract plane except into the run-in, every
        /// pass at least as deep as the one before, the tool ends where it is said to.
        #[test]
        fn threads_keep_their_promises(thread in thread()) {
            prop_assume!(expand(&thread, thread.park, &mut |_| ()).is_ok());
            let list = strokes(&thread, thread.park);
            let line = Line::of(&thread);
            let corners: Vec<Point2> = core::iter::once(line.before(100.0))
                .chain([line.start])
                .chain(line.parts.iter().map(|part| part.0))
                .collect();
            let surface = |x: f64| {
                let k = corners.windows(2).position(|pair| x <= pair[1].x).unwrap_or(corners.len() - 2);
                let (a, b) = (corners[k], corners[k + 1]);
                a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)
            };
            let retract = line.view.height(thread.retract);
            let mut at = line.view.point(thread.park);
            let mut deepest = Vec::new();
            for mv in &list {
                let to = line.view.point(mv.to);
                match mv.path {
                    Path::Rapid => {
                        let plunges = to.x == at.x && to.x <= line.start.x;
                        let lifts = to.x == at.x && to.y >= retract - 1e-9;
                        prop_assert!(plunges || lifts || at.y.min(to.y) >= retract - 1e-9, "{at:?} {to:?}");
                    }
                    _ => {
                        for end in [at, to] {
                            prop_assert!(surface(end.x) - end.y <= thread.depth + 1e-9);
                        }
                        deepest.push(surface(to.x) - to.y);
                    }
                }
                at = to;
            }
            prop_assert!((at - line.view.point(thread.park)).norm() < 1e-9);
            check_lowering(&Cycle::Thread(thread.clone()), thread.park)?;
            let per_start = deepest.len() / thread.starts as usize;
            for start in deepest.chunks(per_start) {
                prop_assert!(start.windows(2).all(|pair| pair[1] >= pair[0] - 1e-9), "{start:?}");
                prop_assert!((start[per_start - 1] - thread.depth).abs() < 1e-9);
            }
        }
    }
}
