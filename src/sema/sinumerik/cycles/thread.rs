//! Thread cycles: CYCLE97, CYCLE98, CYCLE99.
//!
//! Source: C 5.8 to 5.10 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2, parts};
use crate::ir::cycle::thread::{Flank, Infeed, Thread, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Family};
use crate::machine::options::sinumerik::FlankReference;

use super::super::threads::START_ANGLE;
use super::super::value::whole;
use super::call::{Acts, CycleCall};
use super::names::{
    AMODE, APP, DM1, DM2, DM3, DM4, FAL, FDEP, FPD, FPL, GDEP, GST, GUD, IANG, IFLANK, MID, MPIT, NID, NRC, NSP, NUMT,
    NUMTH, PIT, PIT1, PITA, PO1, PO2, PO3, PO4, PP1, PP2, PP3, ROP, S_XRS, SDIS, SPD, SPL, TDEP, VARI, VRT,
};
use crate::sema::cycle::call::{Kind, Made};
use crate::sema::cycle::row::Name;

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
    starts: Name,
    lift: Name,
    /// Arguments of the editor: VARI is coded, signs are left out.
    coded: bool,
}

impl CycleCall<'_> {
    /// CYCLE97
    pub(super) fn single_thread(&self) -> Made<Acts> {
        let lead = self.pitch(LARGEST, 0)?;
        let points = self.line([SPL, DM1], [FPL, DM2]);
        self.thread(&Course { points, leads: vec![lead], starts: NUMT, lift: VRT, coded: false })
    }

    /// CYCLE98
    pub(super) fn chain_of_threads(&self) -> Made<Acts> {
        let given = self.given;
        let mut points = Vec::new();
        for (z, diameter) in [(PO1, DM1), (PO2, DM2), (PO3, DM3), (PO4, DM4)] {
            points.push(self.point(z, diameter));
        }
        let mut leads = Vec::new();
        for key in [PP1, PP2, PP3] {
            leads.push(self.given.length(key));
        }
        for (key, what) in [
            (MID, "the first infeed `_MID`"),
            (GDEP, "`_GDEP`"),
            (PITA, "another unit of the pitch (`_PITA`)"),
            (AMODE, "a coded reading of positions (`_AMODE`)"),
        ] {
            let plain = key == PITA && given.or_zero(PITA) == 1.0;
            if given.or_zero(key) != 0.0 && !plain {
                return self.not_built(key, what);
            }
        }
        self.flank_agrees()?;
        self.thread(&Course { points, leads, starts: NUMT, lift: VRT, coded: false })
    }

    /// CYCLE99
    pub(super) fn thread_of_editor(&self) -> Made<Acts> {
        self.check_new_thread()?;
        let lead = self.new_pitch()?;
        let points = self.line([SPL, SPD], [FPL, FPD]);
        self.thread(&Course { points, leads: vec![lead], starts: NUMTH, lift: SDIS, coded: true })
    }

    fn point(&self, z: Name, diameter: Name) -> Point2 {
        Point2::new(self.given.length(z), self.given.length(diameter) / 2.0)
    }

    /// Start and end; a missing end diameter is that of the start.
    fn line(&self, start: [Name; 2], end: [Name; 2]) -> Vec<Point2> {
        let from = self.point(start[0], start[1]);
        let radius = self.given.length_if(end[1]).map_or(from.y, |diameter| diameter / 2.0);
        vec![from, Point2::new(self.given.length(end[0]), radius)]
    }

    fn thread(&self, course: &Course) -> Made<Acts> {
        let points = &course.points;
        self.no_face_thread(points)?;
        let (internal, area) = self.variant(course)?;
        let depth = self.given.length(TDEP).abs();
        let finish = self.given.length(FAL).abs();
        let passes = self.roughing_passes(depth - finish, area)?;
        let idle = self.whole_of(NID, 0)?;
        let starts = self.number_of_starts(course)?;
        let start_angle = self.start_angle()?;
        let flank = self.flank_of_infeed()?;
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
            run_in: self.given.length(APP).abs(),
            run_out: self.given.length(ROP).abs(),
            fixed_end: true,
            starts,
            start_angle,
            retract: 0.0,
            park: points[0],
        };
        thread.retract = self.lift_off(course.lift, &thread, internal);
        self.lies_in_part(&thread, points, internal)?;
        if let Err(fault) = thread.check() {
            return self.unsound_call(None, &fault, "check the arguments of the cycle");
        }
        let front =
            thread.parts.first().map_or(thread.start, |part| thread.extended(part.end, thread.start, thread.run_in));
        self.says_shifted_starts(course.starts, &thread);
        self.begins_at(Point2::new(front.x, thread.retract), |park| Cycle::Thread(Thread { park, ..thread }))
    }

    fn number_of_starts(&self, course: &Course) -> Made<u32> {
        let given = self.given;
        let starts = self.whole_of(course.starts, 0)?.max(1);
        if !course.coded && given.number(course.starts) == Some(0.0) {
            self.say_of(course.starts, codes::P8106::numt_0_is_taken_as_one_start());
        }
        if course.coded && starts > 1 {
            self.note(given.place_of(course.starts), codes::S8019::cuts_starts(&given.called, &starts), Kind::Each);
        }
        Ok(starts)
    }

    fn start_angle(&self) -> Made<Deg> {
        let given = self.given;
        // Whether the cycle overrides the setting datum is not confirmed.
        if let Some(value) = self.st.system.number(START_ANGLE).filter(|value| *value != 0.0) {
            let fault = codes::S9012::whether_holds_for_threads_of_cycle(&START_ANGLE, &value);
            return self.refuse_as_said(given.place_of(NSP), fault);
        }
        let start_angle = given.or_zero(NSP);
        if !(0.0..360.0).contains(&start_angle) {
            return self.refuse_argument(NSP, codes::P2090::start_angle_nsp(&start_angle));
        }
        Ok(Deg(start_angle))
    }

    /// IANG: along one flank, along both in turn, or straight in.
    fn flank_of_infeed(&self) -> Made<Flank> {
        let given = self.given;
        let angle = given.or_zero(IANG);
        if given.or_zero(MPIT) != 0.0 && angle.abs() > METRIC_FLANK {
            return self.refuse_argument(IANG, codes::P2090::infeed_angle_iang(&angle));
        }
        Ok(if angle == 0.0 {
            Flank::Radial
        } else if angle > 0.0 {
            self.flank_reference(IANG, angle)
        } else {
            Flank::Alternating { angle: Deg(-angle) }
        })
    }

    fn lies_in_part(&self, thread: &Thread, points: &[Point2], internal: bool) -> Made {
        let smallest = points.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
        let beyond = if internal { thread.retract <= 0.0 } else { thread.depth >= smallest };
        if beyond {
            return self.refuse_argument(
                TDEP,
                if internal {
                    codes::P2090::tool_would_lift_beyond_centre()
                } else {
                    codes::P2090::thread_is_deeper_than_part()
                },
            );
        }
        Ok(())
    }

    /// NRC; in CYCLE99 also by the infeed `_MID`, which the editor writes beside it: the two must agree.
    fn roughing_passes(&self, way: f64, area: bool) -> Made<u32> {
        let given = self.given;
        let infeed = match self.given.length_if(MID) {
            Some(infeed) if infeed != 0.0 => infeed,
            _ if !given.has(NRC) => {
                return self.refuse(codes::P2090::number_of_passes_is_missing(&given.argument(NRC)));
            }
            _ => return self.whole_of(NRC, 1),
        };
        if infeed < 0.0 {
            return self.refuse_argument(MID, codes::P2090::infeed_mid_is_below_0());
        }
        // The first cut of equal cross-sections is the depth by the root of their number.
        let cuts = if area { parts::count_of_areas(way, infeed) } else { parts::count(way, infeed) }.max(1.0);
        let given_passes = given.or_zero(NRC);
        if given_passes == 0.0 {
            if cuts > MOST_PASSES {
                return self.refuse_argument(MID, codes::P2090::infeed_mid_of_mm_makes_passes(&infeed, &cuts));
            }
            return Ok(cuts as u32);
        }
        if given_passes != cuts {
            let fault = codes::S9015::passes_contradict_infeed(&given.called, &given_passes, &cuts);
            return self.refuse_as_said(given.place_of(MID), fault);
        }
        self.whole_of(NRC, 1)
    }

    /// The lift-off plane: clear of the thread and of its extensions.
    fn lift_off(&self, key: Name, thread: &Thread, internal: bool) -> f64 {
        let lift = self.given.length_if(key).filter(|way| *way != 0.0).map_or(LIFT, f64::abs);
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
    fn check_new_thread(&self) -> Made {
        let given = self.given;
        for (key, what) in [
            (PIT1, "a changing pitch (`_PIT1`)"),
            (FDEP, "a depth that is cut already (`_FDEP`)"),
            (GUD, "`_GUD`"),
            (S_XRS, "a crowned thread (`_S_XRS`)"),
        ] {
            if given.or_zero(key) != 0.0 {
                return self.not_built(key, what);
            }
        }
        // A thread of one start has no other one that could be the first.
        let single = given.or_zero(NUMTH) <= 1.0;
        match given.or_zero(GST) {
            0.0 => {}
            1.0 if single => self.say_of(GST, codes::P8106::gst_1_is_first_start()),
            first => {
                return self.refuse_argument(GST, codes::S9015::choice_of_first_start_that_is_cut(&first));
            }
        }
        if let Some(place) = (0..10).find(|place| given.digit(AMODE, *place) != 0) {
            let digit = given.digit(AMODE, place);
            return self.refuse_argument(AMODE, codes::S9015::digit_at_place_from_right_of_amode(&digit, &(place + 1)));
        }
        if given.or_zero(GDEP) != 0.0 {
            self.say_of(GDEP, codes::P8106::gdep_is_taken_for_return_distance());
        }
        self.flank_agrees()?;
        self.note(given.place_of(VARI), codes::S8020::units_of_vari_are_read(), Kind::Once);
        Ok(())
    }

    /// The pitch in the unit of `_PITA`.
    pub(super) fn new_pitch(&self) -> Made<f64> {
        match self.given.or_zero(PITA) {
            0.0 => Ok(self.given.length(PIT)),
            1.0 => Ok(self.given.or_zero(PIT)),
            _ => self.refuse_argument(PITA, codes::S9015::pitch_in_inches()),
        }
    }

    /// Over 45 degrees the control cuts a face thread: its pitch counts along X.
    fn no_face_thread(&self, points: &[Point2]) -> Made {
        let given = self.given;
        let steep = |pair: &[Point2]| match pair {
            [from, to] => Some(*to - *from).filter(|way| way.y.abs() > way.x.abs() + 1e-3),
            _ => None,
        };
        let Some((at, way)) = points.windows(2).enumerate().find_map(|(at, pair)| Some((at, steep(pair)?))) else {
            return Ok(());
        };
        let angle = libm::atan2(way.y.abs(), way.x.abs()).to_degrees();
        let fault = match points.len() {
            0..=2 => codes::S9015::thread_leans_out_of_z(&given.called, &angle),
            _ => codes::S9015::part_of_thread_leans_out_of_z(&given.called, &(at + 1), &angle),
        };
        self.refuse_as_said(given.place, fault)
    }

    fn variant(&self, course: &Course) -> Made<Variant> {
        let given = self.given;
        let variant = if course.coded {
            self.variant_digits()?;
            f64::from(given.digit(VARI, 0))
        } else {
            given.or_zero(VARI)
        };
        Ok(match variant {
            1.0 => (false, false),
            2.0 => (true, false),
            3.0 => (false, true),
            4.0 => (true, true),
            _ => {
                return self.refuse_argument(VARI, codes::P2090::vari_is_1_to_4());
            }
        })
    }

    /// The target starts each thread at one angle: other angles are starts that lie farther back.
    fn says_shifted_starts(&self, counted: Name, thread: &Thread) {
        let given = self.given;
        let angle = thread.start_angle.0;
        let starts = f64::from(thread.starts.max(1));
        let turn = angle / 360.0 + (starts - 1.0) / starts;
        let back = thread.parts.first().map_or(0.0, |part| part.lead) * turn;
        let called = &given.called;
        let (fault, name) = match (angle != 0.0, thread.starts) {
            (false, 0 | 1) => return,
            (true, 0 | 1) => (codes::S8133::start_angle_by_cuts_farther_back(called, &angle, &back), NSP),
            (false, starts) => (codes::S8133::starts_by_cuts_farther_back(called, &starts, &back), counted),
            (true, starts) => {
                (codes::S8133::angle_and_starts_by_cuts_farther_back(called, &angle, &starts, &back), NSP)
            }
        };
        self.note(given.place_of(name), fault, Kind::Each);
    }

    /// One flank: which pass stands at the programmed start is not documented. Alternating ones close in on the last pass.
    fn flank_reference(&self, key: Name, angle: f64) -> Flank {
        let given = self.given;
        let chosen = self.settings.control.sinumerik.thread_flank;
        if chosen.is_none() {
            let fault =
                codes::S8021::flank_infeed_is_counted_from_crest().answer(Answer::key("control", "thread_flank"));
            self.note(given.place_of(key), fault, Kind::Once);
        }
        match chosen {
            Some(FlankReference::Root) => Flank::Behind { angle: Deg(angle) },
            _ => Flank::FromCrest { angle: Deg(angle) },
        }
    }

    /// Digits of `_VARI` in CYCLE99: 1310101 was seen in stored calls, and plain units are those of CYCLE97. Other
    /// digits choose alternating flanks, finishing alone or an order of the starts, and which is which is not confirmed.
    fn variant_digits(&self) -> Made {
        let given = self.given;
        const SEEN: [i32; 9] = [0, 1, 0, 1, 3, 1, 0, 0, 0];
        let strange = (1..10).find(|place| {
            let digit = given.digit(VARI, *place);
            digit != 0 && SEEN.get(*place as usize - 1).copied().unwrap_or(0) != digit
        });
        if let Some(place) = strange {
            return self.refuse_argument(
                VARI,
                codes::S9015::digit_at_place_from_right_of_vari(&given.digit(VARI, place), &(place + 1)),
            );
        }
        if given.digit(VARI, 2) == 1 && given.or_zero(IANG) < 0.0 {
            return self.refuse_argument(IANG, codes::S9015::infeed_along_one_flank());
        }
        Ok(())
    }

    fn whole_of(&self, key: Name, least: i32) -> Made<u32> {
        let given = self.given;
        let value = given.number(key).unwrap_or(f64::from(least));
        match whole(value).filter(|n| *n >= least && f64::from(*n) <= MOST_PASSES && f64::from(*n) == value) {
            Some(n) => Ok(n as u32),
            None => self.refuse_argument(key, codes::P2090::is_no_number_of_passes_or_starts(&value)),
        }
    }

    /// The editor writes the flank infeed twice: as an angle, which counts, and as a length.
    fn flank_agrees(&self) -> Made {
        let given = self.given;
        let tangent = libm::tan(given.or_zero(IANG).abs().to_radians());
        let length = given.or_zero(IFLANK);
        if length == 0.0 || (length.abs() - given.or_zero(TDEP).abs() * tangent).abs() <= 0.01 {
            return Ok(());
        }
        self.refuse_argument(IFLANK, codes::P2090::flank_infeed_iflank_contradicts_angle_iang())
    }
}
