//! Thread cycles: CYCLE97, CYCLE98, CYCLE99.
//!
//! Source: reference sections 5.8 to 5.10.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Deg, Point2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::thread::{Flank, Infeed, Thread, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::machine::options::sinumerik::FlankReference;

use super::super::g_groups::Group;
use super::super::value::whole;
use super::super::{Outcome, Run};
use super::Arguments;

/// The lift-off plane lies this far outside the thread, in mm.
const LIFT: f64 = 1.0;

/// Places of the arguments that all thread cycles have.
struct Places {
    run_in: usize,
    run_out: usize,
    depth: usize,
    finish: usize,
    angle: usize,
    start_angle: usize,
    passes: usize,
    idle: usize,
    variant: usize,
    starts: usize,
}

const CYCLE97: Places = Places {
    run_in: 7,
    run_out: 8,
    depth: 9,
    finish: 10,
    angle: 11,
    start_angle: 12,
    passes: 13,
    idle: 14,
    variant: 15,
    starts: 16,
};
const CYCLE98: Places = Places {
    run_in: 9,
    run_out: 10,
    depth: 11,
    finish: 12,
    angle: 13,
    start_angle: 14,
    passes: 15,
    idle: 16,
    variant: 20,
    starts: 21,
};
const CYCLE99: Places = Places {
    run_in: 5,
    run_out: 6,
    depth: 7,
    finish: 8,
    angle: 9,
    start_angle: 10,
    passes: 11,
    idle: 12,
    variant: 14,
    starts: 15,
};

/// Half the flank angle of a metric thread, degrees.
const METRIC_FLANK: f64 = 30.0;
/// Most passes, or starts; more is a lost decimal point.
const MOST_PASSES: f64 = 1000.0;

impl Run<'_> {
    pub(super) fn thread_cycle(&mut self, args: &Arguments) -> Outcome {
        self.in_turning_plane(args)?;
        let (places, points, leads) = match args.name.as_str() {
            "CYCLE97" => {
                self.no_sign(args, &[1, 2])?;
                let lead = self.pitch(args, 2, 1, 0)?;
                self.needed(args, 6, "the diameter at the end DM2")?;
                (CYCLE97, self.line(args, [3, 5], [4, 6])?, vec![lead])
            }
            "CYCLE98" => {
                let mut points = Vec::new();
                for place in [1, 3, 5, 7] {
                    points.push(self.point(args, place, place + 1)?);
                }
                self.no_sign(args, &[17, 18, 19])?;
                let mut leads = Vec::new();
                for place in [17, 18, 19] {
                    leads.push(self.needed_length(args, place, "the pitch")?);
                }
                for (place, what) in [
                    (23, "the first infeed `_MID`"),
                    (24, "`_GDEP`"),
                    (26, "another unit of the pitch (`_PITA`)"),
                    (31, "a coded reading of positions (`_AMODE`)"),
                ] {
                    let plain = place == 26 && args.or_zero(26) == 1.0;
                    if args.or_zero(place) != 0.0 && !plain {
                        return self.not_built(args, place, what);
                    }
                }
                self.flank_agrees(args, 11, 13, 25)?;
                let plane = args.digit(30, 0);
                if plane != 0 && plane != i32::from(self.st.codes.of(Group::Plane).index) {
                    return self.not_built(args, 30, "a plane other than the active one (`_DMODE`)");
                }
                (CYCLE98, points, leads)
            }
            _ => {
                self.check_new_thread(args)?;
                let lead = self.new_pitch(args)?;
                (CYCLE99, self.line(args, [1, 2], [3, 4])?, vec![lead])
            }
        };
        self.no_face_thread(args, &points)?;
        self.thread(args, &places, &points, &leads)
    }

    /// Over 45 degrees the control cuts a face thread: its pitch counts along X.
    fn no_face_thread(&self, args: &Arguments, points: &[Point2]) -> Outcome {
        let steep = |pair: &[Point2]| match pair {
            [from, to] => Some(*to - *from).filter(|way| way.y.abs() > way.x.abs() + 1e-3),
            _ => None,
        };
        let Some((at, way)) = points.windows(2).enumerate().find_map(|(at, pair)| Some((at, steep(pair)?))) else {
            return Ok(());
        };
        let angle = libm::atan2(way.y.abs(), way.x.abs()).to_degrees();
        let part = if points.len() > 2 { format!("part {} of the thread", at + 1) } else { "the thread".to_owned() };
        let message = format!(
            "{}: {part} leans {angle:.1} degrees out of Z, and over 45 degrees it is a face thread: from which side \
             the control feeds in, and how run-in and lift-off count, is not published",
            args.name
        );
        let help =
            "cut a face thread by blocks: G0 to the depth of the pass in Z, then G33 X… I… with the pitch along X";
        self.fail_help(codes::S9015, 0, args.span, message, help)
    }

    /// The hand of a thread comes from the spindle: a sign of its pitch would be dropped.
    fn no_sign(&self, args: &Arguments, places: &[usize]) -> Outcome {
        match places.iter().find(|place| args.or_zero(**place) < 0.0) {
            Some(place) => {
                let help = "give the pitch without a sign; M3 or M4 makes the hand of the thread";
                self.cycle_fault(args, args.span_of(*place), 61001, "the pitch is below 0", help)
            }
            None => Ok(()),
        }
    }

    fn point(&self, args: &Arguments, z: usize, diameter: usize) -> Outcome<Point2> {
        let z = self.needed_length(args, z, "a point of the thread along Z")?;
        let diameter = self.needed_length(args, diameter, "a diameter of the thread")?;
        Ok(Point2::new(z, diameter / 2.0))
    }

    /// Start and end; a missing end diameter is that of the start.
    fn line(&self, args: &Arguments, start: [usize; 2], end: [usize; 2]) -> Outcome<Vec<Point2>> {
        let from = self.point(args, start[0], start[1])?;
        let z = self.needed_length(args, end[0], "the end of the thread along Z")?;
        let radius = self.length_of(args, end[1]).map_or(from.y, |diameter| diameter / 2.0);
        Ok(vec![from, Point2::new(z, radius)])
    }

    /// A thread waits for ever for a spindle that stands.
    fn spindle_turns(&self, args: &Arguments) -> Outcome {
        if self.st.turn.is_some() {
            return Ok(());
        }
        let help = "program M3 or M4 with a speed in front of the cycle";
        self.cycle_fault(args, args.span, 61102, "the spindle does not turn", help)
    }

    /// Lengths and depths that the classic cycles take without a sign.
    fn without_signs(&self, args: &Arguments, places: &Places) -> Outcome {
        if args.name == "CYCLE99" {
            return Ok(());
        }
        let unsigned = [places.run_in, places.run_out, places.depth, places.finish];
        match unsigned.into_iter().find(|place| args.or_zero(*place) < 0.0) {
            Some(place) => {
                let help = "give the depth, the allowance, run-in and run-out without a sign";
                self.cycle_fault(args, args.span_of(place), 61001, "a length of the thread is below 0", help)
            }
            None => Ok(()),
        }
    }

    fn thread(&mut self, args: &Arguments, places: &Places, points: &[Point2], leads: &[f64]) -> Outcome {
        self.master_is_main(args.span, "the lead of a thread")?;
        let variant = if args.name == "CYCLE99" {
            self.variant_digits(args, places)?;
            f64::from(args.digit(places.variant, 0))
        } else {
            args.or_zero(places.variant)
        };
        let (internal, area) = match variant {
            1.0 => (false, false),
            2.0 => (true, false),
            3.0 => (false, true),
            4.0 => (true, true),
            _ => {
                let help = "1 external, 2 internal with equal infeed; 3 external, 4 internal with equal cross-section";
                return self.cycle_fault(args, args.span_of(places.variant), 61002, "VARI is 1 to 4", help);
            }
        };
        self.spindle_turns(args)?;
        self.without_signs(args, places)?;
        let depth = self.needed_length(args, places.depth, "the thread depth TDEP")?.abs();
        let finish = self.length_of(args, places.finish).unwrap_or(0.0).abs();
        let passes = self.roughing_passes(args, places, depth - finish, area)?;
        let idle = self.whole_of(args, places.idle, 0)?;
        let starts = self.whole_of(args, places.starts, 0)?.max(1);
        if args.name != "CYCLE99" && args.number(places.starts) == Some(0.0) {
            self.reading(args, places.starts, "NUMT 0 is taken as one start");
        }
        if args.name == "CYCLE99" && starts > 1 {
            let found = Diagnostic::new(
                codes::S8019,
                self.loc(args.span_of(places.starts)),
                format!("CYCLE99 cuts {starts} starts"),
            );
            self.report(found.help("the editor may leave a number here though one start is meant: set it to 1 then"));
        }
        // Whether the cycle overrides the setting datum is not confirmed.
        self.no_start_angle_by_setting(args.span_of(places.start_angle))?;
        let start_angle = args.or_zero(places.start_angle);
        if !(0.0..360.0).contains(&start_angle) {
            let message = format!("the start angle NSP is {start_angle}");
            let help = "give 0 to below 360 degrees";
            return self.cycle_fault(args, args.span_of(places.start_angle), 0, &message, help);
        }
        let angle = args.or_zero(places.angle);
        if args.name == "CYCLE97" && args.or_zero(2) != 0.0 && angle.abs() > METRIC_FLANK {
            let message = format!("the infeed angle IANG is {angle}, over half of the 60 degrees of a metric thread");
            let help = "give at most 30, below 0 for alternating flanks";
            return self.cycle_fault(args, args.span_of(places.angle), 0, &message, help);
        }
        let flank = if angle == 0.0 {
            Flank::Radial
        } else if angle > 0.0 {
            self.flank_reference(args, places.angle, angle)
        } else {
            Flank::Alternating { angle: Deg(-angle) }
        };
        let park = self.turning_position(args.span)?;
        let mut parts = Vec::new();
        for (end, lead) in points.iter().skip(1).zip(leads) {
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
            run_in: self.length_of(args, places.run_in).unwrap_or(0.0).abs(),
            run_out: self.length_of(args, places.run_out).unwrap_or(0.0).abs(),
            fixed_end: true,
            starts,
            start_angle: Deg(start_angle),
            retract: 0.0,
            park,
        };
        thread.retract = self.lift_off(args, &thread, internal);
        let smallest = points.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
        let beyond = if internal { thread.retract <= 0.0 } else { depth >= smallest };
        if beyond {
            let what = if internal {
                "the tool would lift off beyond the turning centre"
            } else {
                "the thread is deeper than the part"
            };
            return self.cycle_fault(
                args,
                args.span_of(places.depth),
                61001,
                what,
                "check the diameters, the depth and the lift-off",
            );
        }
        if let Err(fault) = thread.check() {
            return self.cycle_fault(args, args.span, 0, &fault.to_string(), "check the arguments of the cycle");
        }
        self.says_shifted_starts(args, places, &thread);
        self.send_cycle(Cycle::Thread(thread));
        Ok(())
    }

    /// The target starts each thread at one angle: other angles are starts that lie farther back.
    fn says_shifted_starts(&self, args: &Arguments, places: &Places, thread: &Thread) {
        let angle = thread.start_angle.0;
        let (what, place) = match (angle != 0.0, thread.starts) {
            (false, 0 | 1) => return,
            (true, 0 | 1) => (format!("the start angle {angle}"), places.start_angle),
            (false, starts) => (format!("{starts} starts"), places.starts),
            (true, starts) => (format!("the start angle {angle} and {starts} starts"), places.start_angle),
        };
        let starts = f64::from(thread.starts.max(1));
        let turn = angle / 360.0 + (starts - 1.0) / starts;
        let back = thread.parts.first().map_or(0.0, |part| part.lead) * turn;
        let message = format!(
            "{}: {what} made by cuts that begin up to {back:.4} mm farther back, where the tool goes at rapid",
            args.name
        );
        let message = message.replacen(" made by", if thread.starts > 1 { " are made by" } else { " is made by" }, 1);
        let found = Diagnostic::new(codes::S8133, self.loc(args.span_of(place)), message);
        self.report(found.help("see that nothing stands there"));
    }

    /// One flank: which pass stands at the programmed start is not documented. Alternating ones close in on the last pass.
    fn flank_reference(&self, args: &Arguments, place: usize, angle: f64) -> Flank {
        let chosen = self.job.settings.control.siemens.thread_flank;
        if chosen.is_none() && self.job.diags.first_time(codes::S8021) {
            let message = "a flank infeed is counted from the crest: the manuals leave open which pass stands at the programmed Z";
            let found = Diagnostic::new(codes::S8021, self.loc(args.span_of(place)), message);
            self.report(found.help("say it by `[control] thread_flank`: \"crest\", or \"root\" for the last pass"));
        }
        match chosen {
            Some(FlankReference::Root) => Flank::Behind { angle: Deg(angle) },
            _ => Flank::FromCrest { angle: Deg(angle) },
        }
    }

    /// NRC; in CYCLE99 also by the infeed `_MID`, which the editor writes beside it: the two must agree.
    fn roughing_passes(&self, args: &Arguments, places: &Places, way: f64, area: bool) -> Outcome<u32> {
        const MID: usize = 17;
        let infeed = match self.length_of(args, MID) {
            Some(infeed) if args.name == "CYCLE99" && infeed != 0.0 => infeed,
            _ => {
                self.needed(args, places.passes, "the number of roughing passes NRC")?;
                return self.whole_of(args, places.passes, 1);
            }
        };
        if infeed < 0.0 {
            let help = "give the infeed without a sign, or the number of passes `_NRC` alone";
            return self.cycle_fault(args, args.span_of(MID), 61001, "the infeed `_MID` is below 0", help);
        }
        // The first cut of equal cross-sections is the depth by the root of their number.
        let cuts = if area { (way / infeed) * (way / infeed) } else { way / infeed };
        let cuts = libm::ceil(cuts - 1e-9).max(1.0);
        let given = args.or_zero(places.passes);
        if given == 0.0 {
            if cuts > MOST_PASSES {
                let message = format!("the infeed `_MID` of {infeed} mm makes {cuts:.0} passes");
                return self.cycle_fault(args, args.span_of(MID), 61001, &message, "give a larger infeed");
            }
            return Ok(cuts as u32);
        }
        if given != cuts {
            let message = format!(
                "the number of passes `_NRC` is {given}, and the infeed `_MID` makes {cuts}: which of them counts is not known"
            );
            let help = "leave one of them 0";
            return self.fail_help(codes::S9015, 0, args.span_of(MID), format!("CYCLE99: {message}"), help);
        }
        self.whole_of(args, places.passes, 1)
    }

    /// Digits of `_VARI` in CYCLE99: 1310101 was seen in stored calls, and plain units are those of CYCLE97. Other
    /// digits choose alternating flanks, finishing alone or an order of the starts, and which is which is not confirmed.
    fn variant_digits(&self, args: &Arguments, places: &Places) -> Outcome {
        const SEEN: [i32; 9] = [0, 1, 0, 1, 3, 1, 0, 0, 0];
        let at = places.variant;
        let strange = (1..10).find(|place| {
            let digit = args.digit(at, *place);
            digit != 0 && SEEN.get(*place as usize - 1).copied().unwrap_or(0) != digit
        });
        if let Some(place) = strange {
            let what = format!(
                "the digit {} at place {} from the right of `_VARI`, whose meaning is not confirmed,",
                args.digit(at, place),
                place + 1
            );
            return self.not_built(args, at, &what);
        }
        if args.digit(at, 2) == 1 && args.or_zero(places.angle) < 0.0 {
            let what = "an infeed along one flank (`_VARI`) with the negative angle of an alternating one";
            return self.not_built(args, places.angle, what);
        }
        Ok(())
    }

    /// The lift-off plane: clear of the thread and of its extensions.
    fn lift_off(&self, args: &Arguments, thread: &Thread, internal: bool) -> f64 {
        let given = match args.name.as_str() {
            "CYCLE97" => self.length_of(args, 17),
            "CYCLE99" => self.length_of(args, 16),
            _ => self.length_of(args, 22),
        };
        let lift = given.filter(|way| *way != 0.0).map_or(LIFT, f64::abs);
        let (Some(first), Some(last)) = (thread.parts.first(), thread.parts.last()) else { return thread.start.y };
        let before_last = thread.parts.iter().rev().nth(1).map_or(thread.start, |part| part.end);
        let ends = [
            thread.extended(first.end, thread.start, thread.run_in).y,
            thread.extended(before_last, last.end, thread.run_out).y,
        ];
        let radii = thread.parts.iter().map(|part| part.end.y).chain(ends);
        if internal { radii.fold(thread.start.y, f64::min) - lift } else { radii.fold(thread.start.y, f64::max) + lift }
    }

    fn whole_of(&self, args: &Arguments, place: usize, least: i32) -> Outcome<u32> {
        let value = args.number(place).unwrap_or(f64::from(least));
        match whole(value).filter(|n| *n >= least && f64::from(*n) <= MOST_PASSES && f64::from(*n) == value) {
            Some(n) => Ok(n as u32),
            None => {
                let message = format!("{value} is no number of passes or starts");
                self.cycle_fault(args, args.span_of(place), 0, &message, "give a whole number")
            }
        }
    }

    /// The editor writes the flank infeed twice: as an angle, which counts, and as a length.
    fn flank_agrees(&self, args: &Arguments, depth: usize, angle: usize, flank: usize) -> Outcome {
        let tangent = libm::tan(args.or_zero(angle).abs().to_radians());
        let given = args.or_zero(flank);
        if given == 0.0 || (given.abs() - args.or_zero(depth).abs() * tangent).abs() <= 0.01 {
            return Ok(());
        }
        self.cycle_fault(
            args,
            args.span_of(flank),
            0,
            "the flank infeed `_IFLANK` contradicts the angle `_IANG`",
            "give the angle, and the length as the editor computes it",
        )
    }

    /// CYCLE99 codes much in digits; what is not known is refused.
    fn check_new_thread(&mut self, args: &Arguments) -> Outcome {
        for (place, what) in [
            (19, "a changing pitch (`_PIT1`)"),
            (20, "`_FDEP`"),
            (21, "`_GST`"),
            (22, "`_GUD`"),
            (30, "a crowned thread (`_S_XRS`)"),
        ] {
            if args.or_zero(place) != 0.0 {
                return self.not_built(args, place, what);
            }
        }
        if let Some(place) = (0..10).find(|place| args.digit(29, *place) != 0) {
            let digit = args.digit(29, place);
            let what =
                format!("the digit {digit} at place {} from the right of `_AMODE`, which was never seen,", place + 1);
            return self.not_built(args, 29, &what);
        }
        if args.or_zero(18) != 0.0 {
            self.reading(args, 18, "`_GDEP` is taken for a return distance of the editor, which changes no pass");
        }
        self.flank_agrees(args, 7, 9, 23)?;
        let plane = args.digit(28, 0);
        if plane != 0 && plane != i32::from(self.st.codes.of(Group::Plane).index) {
            return self.not_built(args, 28, "a plane other than the active one (`_DMODE`)");
        }
        self.note_once(
            codes::S8020,
            args.span_of(14),
            "the units of `_VARI` are read as in CYCLE97 (1 and 3 external, 2 and 4 internal), and its other digits as roughing and finishing in one call",
        );
        Ok(())
    }

    /// Pitch at place 13, in the unit of `_PITA`.
    fn new_pitch(&self, args: &Arguments) -> Outcome<f64> {
        let pitch = self.needed(args, 13, "the pitch `_PIT`")?;
        if pitch <= 0.0 {
            return self.cycle_fault(args, args.span_of(13), 61001, "the pitch is not above 0", "give the pitch");
        }
        match args.or_zero(24) {
            0.0 => Ok(pitch * self.st.length_unit()),
            1.0 => Ok(pitch),
            _ => self.not_built(args, 24, "a pitch in inches, turns or modules (`_PITA`)"),
        }
    }
}
