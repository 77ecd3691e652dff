//! Thread cycles: CYCLE97, CYCLE98, CYCLE99.
//!
//! Source: C 5.8 to 5.10 (docs/sources.md).

use crate::diag::{Answer, Diagnostic, codes};
use crate::geo::{Deg, Point2, parts};
use crate::ir::cycle::thread::{Flank, Infeed, Thread, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Family};
use crate::machine::options::sinumerik::FlankReference;

use super::super::Outcome;
use super::super::value::whole;
use super::arguments::{
    AMODE, APP, DM1, DM2, DM3, DM4, DMODE, FAL, FDEP, FPD, FPL, GDEP, GST, GUD, IANG, IFLANK, Key, MID, MPIT, NID, NRC,
    NSP, NUMT, NUMTH, PIT, PIT1, PITA, PO1, PO2, PO3, PO4, PP1, PP2, PP3, ROP, S_XRS, SDIS, SPD, SPL, TDEP, VARI, VRT,
};
use super::call::CycleCall;

/// The lift-off plane lies this far outside the thread, in mm.
const LIFT: f64 = 1.0;

/// Half the flank angle of a metric thread, degrees.
const METRIC_FLANK: f64 = 30.0;
/// Most passes, or starts; more is a lost decimal point.
const MOST_PASSES: f64 = 1000.0;

/// Largest metric size of a thread.
const LARGEST: f64 = 60.0;

/// Internal, and with equal cross-section.
type Variant = (bool, bool);

/// What the thread cycles have each in their own way.
struct Course {
    points: Vec<Point2>,
    leads: Vec<f64>,
    /// Number of starts, and way of the lift-off.
    starts: Key,
    lift: Key,
    /// Arguments of the editor: VARI is coded, signs are left out.
    coded: bool,
}

impl CycleCall<'_, '_> {
    /// CYCLE97
    pub(super) fn single_thread(&mut self) -> Outcome {
        self.in_turning_plane()?;
        self.no_sign(&[PIT, MPIT])?;
        let lead = self.pitch(LARGEST, 0)?;
        self.needed(DM2, "the diameter at the end DM2")?;
        let points = self.line([SPL, DM1], [FPL, DM2])?;
        self.thread(&Course { points, leads: vec![lead], starts: NUMT, lift: VRT, coded: false })
    }

    /// CYCLE98
    pub(super) fn chain_of_threads(&mut self) -> Outcome {
        let args = self.args;
        self.in_turning_plane()?;
        let mut points = Vec::new();
        for (z, diameter) in [(PO1, DM1), (PO2, DM2), (PO3, DM3), (PO4, DM4)] {
            points.push(self.point(z, diameter)?);
        }
        self.no_sign(&[PP1, PP2, PP3])?;
        let mut leads = Vec::new();
        for key in [PP1, PP2, PP3] {
            leads.push(self.needed_length(key, "the pitch")?);
        }
        for (key, what) in [
            (MID, "the first infeed `_MID`"),
            (GDEP, "`_GDEP`"),
            (PITA, "another unit of the pitch (`_PITA`)"),
            (AMODE, "a coded reading of positions (`_AMODE`)"),
        ] {
            let plain = key == PITA && args.or_zero(PITA) == 1.0;
            if args.or_zero(key) != 0.0 && !plain {
                return self.not_built(key, what);
            }
        }
        self.flank_agrees()?;
        if self.names_other_plane(args) {
            return self.refuse_argument(DMODE, codes::S9015::plane_other_than_active_one());
        }
        self.thread(&Course { points, leads, starts: NUMT, lift: VRT, coded: false })
    }

    /// CYCLE99
    pub(super) fn thread_of_editor(&mut self) -> Outcome {
        self.in_turning_plane()?;
        self.check_new_thread()?;
        let lead = self.new_pitch()?;
        let points = self.line([SPL, SPD], [FPL, FPD])?;
        self.thread(&Course { points, leads: vec![lead], starts: NUMTH, lift: SDIS, coded: true })
    }

    fn point(&self, z: Key, diameter: Key) -> Outcome<Point2> {
        let z = self.needed_length(z, "a point of the thread along Z")?;
        let diameter = self.needed_length(diameter, "a diameter of the thread")?;
        Ok(Point2::new(z, diameter / 2.0))
    }

    /// Start and end; a missing end diameter is that of the start.
    fn line(&self, start: [Key; 2], end: [Key; 2]) -> Outcome<Vec<Point2>> {
        let args = self.args;
        let from = self.point(start[0], start[1])?;
        let z = self.needed_length(end[0], "the end of the thread along Z")?;
        let radius = self.length_of(args, end[1]).map_or(from.y, |diameter| diameter / 2.0);
        Ok(vec![from, Point2::new(z, radius)])
    }

    /// A thread waits for ever for a spindle that stands.
    fn spindle_turns(&self) -> Outcome {
        let args = self.args;
        if self.st.spindles.turn().is_some() {
            return Ok(());
        }
        self.refuse_cycle(args.span, codes::P2090::spindle_does_not_turn_so_program_m3())
    }

    fn thread(&mut self, course: &Course) -> Outcome {
        let args = self.args;
        let points = &course.points;
        self.no_face_thread(points)?;
        self.master_is_main(args.span, "the lead of a thread")?;
        let (internal, area) = self.variant(course)?;
        self.spindle_turns()?;
        if !course.coded {
            self.without_signs()?;
        }
        let depth = self.needed_length(TDEP, "the thread depth TDEP")?.abs();
        let finish = self.length_of(args, FAL).unwrap_or(0.0).abs();
        let passes = self.roughing_passes(depth - finish, area)?;
        let idle = self.whole_of(NID, 0)?;
        let starts = self.whole_of(course.starts, 0)?.max(1);
        if !course.coded && args.number(course.starts) == Some(0.0) {
            self.reads(course.starts, codes::P8106::numt_0_is_taken_as_one_start());
        }
        if course.coded && starts > 1 {
            let found = codes::S8019::cuts_starts(&args.name(), &starts).at(self.loc(args.span_of(course.starts)));
            self.report(found.help("the editor may leave a number here though one start is meant: set it to 1 then"));
        }
        // Whether the cycle overrides the setting datum is not confirmed.
        self.no_start_angle_by_setting(args.span_of(NSP))?;
        let start_angle = args.or_zero(NSP);
        if !(0.0..360.0).contains(&start_angle) {
            return self.refuse_cycle(args.span_of(NSP), codes::P2090::start_angle_nsp(&start_angle));
        }
        let angle = args.or_zero(IANG);
        if args.or_zero(MPIT) != 0.0 && angle.abs() > METRIC_FLANK {
            return self.refuse_cycle(args.span_of(IANG), codes::P2090::infeed_angle_iang(&angle));
        }
        let flank = if angle == 0.0 {
            Flank::Radial
        } else if angle > 0.0 {
            self.flank_reference(IANG, angle)
        } else {
            Flank::Alternating { angle: Deg(-angle) }
        };
        let mut parts = Vec::new();
        for (end, lead) in points.iter().skip(1).zip(&course.leads) {
            parts.push(ThreadPart { end: *end, lead: *lead });
        }
        let mut thread = Thread {
            start: points[0],
            parts,
            into: if internal { Towards::PlusX } else { Towards::MinusX },
            depth,
            infeed: if area { Infeed::AreaPasses { passes } } else { Infeed::EqualPasses { passes } },
            flank,
            finish,
            air_cuts: idle,
            run_in: self.length_of(args, APP).unwrap_or(0.0).abs(),
            run_out: self.length_of(args, ROP).unwrap_or(0.0).abs(),
            fixed_end: true,
            starts,
            start_angle: Deg(start_angle),
            retract: 0.0,
            park: points[0],
        };
        thread.retract = self.lift_off(course.lift, &thread, internal);
        let smallest = points.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
        let beyond = if internal { thread.retract <= 0.0 } else { depth >= smallest };
        if beyond {
            let what = if internal {
                "the tool would lift off beyond the turning centre"
            } else {
                "the thread is deeper than the part"
            };
            return self.cycle_fault(
                args.span_of(TDEP),
                61001,
                what,
                "check the diameters, the depth and the lift-off",
            );
        }
        if let Err(fault) = thread.check() {
            return self.cycle_fault(args.span, None, &fault.to_string(), "check the arguments of the cycle");
        }
        let front =
            thread.parts.first().map_or(thread.start, |part| thread.extended(part.end, thread.start, thread.run_in));
        self.says_shifted_starts(course.starts, &thread);
        self.send_from(Point2::new(front.x, thread.retract), |park| Cycle::Thread(Thread { park, ..thread }))
    }

    /// NRC; in CYCLE99 also by the infeed `_MID`, which the editor writes beside it: the two must agree.
    fn roughing_passes(&self, way: f64, area: bool) -> Outcome<u32> {
        let args = self.args;
        let infeed = match self.length_of(args, MID) {
            Some(infeed) if infeed != 0.0 => infeed,
            _ => {
                self.needed(NRC, "the number of roughing passes NRC")?;
                return self.whole_of(NRC, 1);
            }
        };
        if infeed < 0.0 {
            return self.refuse_cycle(args.span_of(MID), codes::P2090::infeed_mid_is_below_0());
        }
        // The first cut of equal cross-sections is the depth by the root of their number.
        let cuts = if area { parts::count_of_areas(way, infeed) } else { parts::count(way, infeed) }.max(1.0);
        let given = args.or_zero(NRC);
        if given == 0.0 {
            if cuts > MOST_PASSES {
                return self
                    .refuse_cycle(args.span_of(MID), codes::P2090::infeed_mid_of_mm_makes_passes(&infeed, &cuts));
            }
            return Ok(cuts as u32);
        }
        if given != cuts {
            let message = format!(
                "the number of passes `_NRC` is {given}, and the infeed `_MID` makes {cuts}: which of them counts is not known"
            );
            return self.refuse(args.span_of(MID), codes::S9015::contradicts(&args.name(), &message));
        }
        self.whole_of(NRC, 1)
    }

    /// The lift-off plane: clear of the thread and of its extensions.
    fn lift_off(&self, key: Key, thread: &Thread, internal: bool) -> f64 {
        let args = self.args;
        let lift = self.length_of(args, key).filter(|way| *way != 0.0).map_or(LIFT, f64::abs);
        let (Some(first), Some(last)) = (thread.parts.first(), thread.parts.last()) else { return thread.start.y };
        let before_last = thread.parts.iter().rev().nth(1).map_or(thread.start, |part| part.end);
        let ends = [
            thread.extended(first.end, thread.start, thread.run_in).y,
            thread.extended(before_last, last.end, thread.run_out).y,
        ];
        let radii = thread.parts.iter().map(|part| part.end.y).chain(ends);
        if internal { radii.fold(thread.start.y, f64::min) - lift } else { radii.fold(thread.start.y, f64::max) + lift }
    }

    /// CYCLE99 codes much in digits; what is not known is refused.
    fn check_new_thread(&mut self) -> Outcome {
        let args = self.args;
        for (key, what) in [
            (PIT1, "a changing pitch (`_PIT1`)"),
            (FDEP, "a depth that is cut already (`_FDEP`)"),
            (GUD, "`_GUD`"),
            (S_XRS, "a crowned thread (`_S_XRS`)"),
        ] {
            if args.or_zero(key) != 0.0 {
                return self.not_built(key, what);
            }
        }
        // A thread of one start has no other one that could be the first.
        let single = args.or_zero(NUMTH) <= 1.0;
        match args.or_zero(GST) {
            0.0 => {}
            1.0 if single => self.reads(GST, codes::P8106::gst_1_is_first_start()),
            first => {
                return self.refuse_argument(GST, codes::S9015::choice_of_first_start_that_is_cut(&first));
            }
        }
        if let Some(place) = (0..10).find(|place| args.digit(AMODE, *place) != 0) {
            let digit = args.digit(AMODE, place);
            return self.refuse_argument(AMODE, codes::S9015::digit_at_place_from_right_of_amode(&digit, &(place + 1)));
        }
        if args.or_zero(GDEP) != 0.0 {
            self.reads(GDEP, codes::P8106::gdep_is_taken_for_return_distance());
        }
        self.flank_agrees()?;
        if self.names_other_plane(args) {
            return self.refuse_argument(DMODE, codes::S9015::plane_other_than_active_one());
        }
        self.say_once(args.span_of(VARI), codes::S8020::units_of_vari_are_read());
        Ok(())
    }

    /// The pitch in the unit of `_PITA`.
    pub(super) fn new_pitch(&self) -> Outcome<f64> {
        let args = self.args;
        let pitch = self.needed(PIT, "the pitch `_PIT`")?;
        if pitch <= 0.0 {
            return self.refuse_cycle(args.span_of(PIT), codes::P2090::pitch_is_not_above_0());
        }
        match args.or_zero(PITA) {
            0.0 => Ok(pitch * self.st.length_unit()),
            1.0 => Ok(pitch),
            _ => self.refuse_argument(PITA, codes::S9015::pitch_in_inches()),
        }
    }

    /// Over 45 degrees the control cuts a face thread: its pitch counts along X.
    fn no_face_thread(&self, points: &[Point2]) -> Outcome {
        let args = self.args;
        let steep = |pair: &[Point2]| match pair {
            [from, to] => Some(*to - *from).filter(|way| way.y.abs() > way.x.abs() + 1e-3),
            _ => None,
        };
        let Some((at, way)) = points.windows(2).enumerate().find_map(|(at, pair)| Some((at, steep(pair)?))) else {
            return Ok(());
        };
        let angle = libm::atan2(way.y.abs(), way.x.abs()).to_degrees();
        let part = if points.len() > 2 { format!("part {} of the thread", at + 1) } else { "the thread".to_owned() };
        self.refuse(args.span, codes::S9015::leans_degrees_out_of_z(&args.name(), &part, &angle))
    }

    /// The hand of a thread comes from the spindle: a sign of its pitch would be dropped.
    fn no_sign(&self, keys: &[Key]) -> Outcome {
        let args = self.args;
        match args.below_zero(keys) {
            Some(key) => self.refuse_cycle(args.span_of(key), codes::P2090::pitch_is_below_0_so_give_pitch()),
            None => Ok(()),
        }
    }

    /// Lengths and depths that the classic cycles take without a sign.
    fn without_signs(&self) -> Outcome {
        let args = self.args;
        match args.below_zero(&[APP, ROP, TDEP, FAL]) {
            Some(key) => self.refuse_cycle(args.span_of(key), codes::P2090::length_of_thread_is_below_0()),
            None => Ok(()),
        }
    }

    fn variant(&self, course: &Course) -> Outcome<Variant> {
        let args = self.args;
        let variant = if course.coded {
            self.variant_digits()?;
            f64::from(args.digit(VARI, 0))
        } else {
            args.or_zero(VARI)
        };
        Ok(match variant {
            1.0 => (false, false),
            2.0 => (true, false),
            3.0 => (false, true),
            4.0 => (true, true),
            _ => {
                return self.refuse_cycle(args.span_of(VARI), codes::P2090::vari_is_1_to_4());
            }
        })
    }

    /// The target starts each thread at one angle: other angles are starts that lie farther back.
    fn says_shifted_starts(&self, counted: Key, thread: &Thread) {
        let args = self.args;
        let angle = thread.start_angle.0;
        let (what, key) = match (angle != 0.0, thread.starts) {
            (false, 0 | 1) => return,
            (true, 0 | 1) => (format!("the start angle {angle}"), NSP),
            (false, starts) => (format!("{starts} starts"), counted),
            (true, starts) => (format!("the start angle {angle} and {starts} starts"), NSP),
        };
        let starts = f64::from(thread.starts.max(1));
        let turn = angle / 360.0 + (starts - 1.0) / starts;
        let back = thread.parts.first().map_or(0.0, |part| part.lead) * turn;
        let message = format!(
            "{}: {what} made by cuts that begin up to {back:.4} mm farther back, where the tool goes at rapid",
            args.name()
        );
        let message = message.replacen(" made by", if thread.starts > 1 { " are made by" } else { " is made by" }, 1);
        let found = Diagnostic::new(codes::S8133, self.loc(args.span_of(key)), message);
        self.report(found.help("see that nothing stands there"));
    }

    /// One flank: which pass stands at the programmed start is not documented. Alternating ones close in on the last pass.
    fn flank_reference(&self, key: Key, angle: f64) -> Flank {
        let args = self.args;
        let chosen = self.job.settings.control.sinumerik.thread_flank;
        if chosen.is_none() && self.job.diags.first_time(codes::S8021, ()) {
            let found = codes::S8021::flank_infeed_is_counted_from_crest().at(self.loc(args.span_of(key)));
            self.report(
                found.help(
                    Answer::key("control", "thread_flank")
                        .help("say it by `[control] thread_flank`: \"crest\", or \"root\" for the last pass"),
                ),
            );
        }
        match chosen {
            Some(FlankReference::Root) => Flank::Behind { angle: Deg(angle) },
            _ => Flank::FromCrest { angle: Deg(angle) },
        }
    }

    /// Digits of `_VARI` in CYCLE99: 1310101 was seen in stored calls, and plain units are those of CYCLE97. Other
    /// digits choose alternating flanks, finishing alone or an order of the starts, and which is which is not confirmed.
    fn variant_digits(&self) -> Outcome {
        let args = self.args;
        const SEEN: [i32; 9] = [0, 1, 0, 1, 3, 1, 0, 0, 0];
        let strange = (1..10).find(|place| {
            let digit = args.digit(VARI, *place);
            digit != 0 && SEEN.get(*place as usize - 1).copied().unwrap_or(0) != digit
        });
        if let Some(place) = strange {
            return self.refuse_argument(
                VARI,
                codes::S9015::digit_at_place_from_right_of_vari(&args.digit(VARI, place), &(place + 1)),
            );
        }
        if args.digit(VARI, 2) == 1 && args.or_zero(IANG) < 0.0 {
            return self.refuse_argument(IANG, codes::S9015::infeed_along_one_flank());
        }
        Ok(())
    }

    fn whole_of(&self, key: Key, least: i32) -> Outcome<u32> {
        let args = self.args;
        let value = args.number(key).unwrap_or(f64::from(least));
        match whole(value).filter(|n| *n >= least && f64::from(*n) <= MOST_PASSES && f64::from(*n) == value) {
            Some(n) => Ok(n as u32),
            None => self.refuse_cycle(args.span_of(key), codes::P2090::is_no_number_of_passes_or_starts(&value)),
        }
    }

    /// The editor writes the flank infeed twice: as an angle, which counts, and as a length.
    fn flank_agrees(&self) -> Outcome {
        let args = self.args;
        let tangent = libm::tan(args.or_zero(IANG).abs().to_radians());
        let given = args.or_zero(IFLANK);
        if given == 0.0 || (given.abs() - args.or_zero(TDEP).abs() * tangent).abs() <= 0.01 {
            return Ok(());
        }
        self.refuse_cycle(args.span_of(IFLANK), codes::P2090::flank_infeed_iflank_contradicts_angle_iang())
    }
}
