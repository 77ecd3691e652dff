//! CYCLE81 to CYCLE89 and CYCLE840.
//!
//! Source: C 6.1 to 6.3 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Plane;
use crate::ir::Feed;
use crate::ir::cycle::drilling::{
    AdvancedStop, Bore, Breaks, Chip, Degression, DrillingFault, Levels, Method, Pecking, Tap, TapStep,
};
use crate::ir::cycle::{Drilling, Family};
use crate::ir::function::{Spindle, Turn};
use crate::machine::Axis;
use crate::standard::din13::coarse_pitch;

use super::super::value::whole;
use super::call::CycleCall;
use super::drilling_zones::has_zones;
use super::names::{
    AMODE, DAM, DIS1, DMODE, DTB, DTD, DTS, ENC, FDEP, FDPR, FRF, GMODE, MDEP, MPIT, PIT, PITA, POSS, RPA, RPAP, RPO,
    S_FA, S_FD, S_ZA, S_ZD, SDAC, SDIR, SDR, SST, SST1, TECHNO, VARI, VRT,
};
use super::table::Hole;
use crate::sema::cycle::call::{Kind, Made};
use crate::sema::cycle::row::Name;

/// Way back to break the chip, where none is given, in mm.
const BREAK: f64 = 1.0;

/// Largest metric size of a tap.
const LARGEST: f64 = 48.0;

/// The plane across a hole along this axis.
pub(in super::super) fn plane_across(axis: Axis) -> Plane {
    match axis {
        Axis::X => Plane::Yz,
        Axis::Y => Plane::Zx,
        _ => Plane::Xy,
    }
}

/// An angle of the spindle within one turn.
fn whole_turn(angle: f64) -> f64 {
    angle - 360.0 * libm::floor(angle / 360.0)
}

impl CycleCall<'_> {
    /// The hole that the arguments describe.
    pub(in super::super) fn hole(&self, cycle: &Hole) -> Made<Drilling> {
        let given = self.given;
        let axis = self.hole_axis()?;
        self.no_diameters(axis, given.place)?;
        let levels = self.levels(cycle.centring)?;
        let feed = (cycle.feed)(self)?;
        let mut method = (cycle.method)(self, &levels, feed)?;
        let mut hole_feed = feed;
        let mut entry = None;
        if has_zones(given) {
            let zones = self.zones(&levels, feed)?;
            (entry, hole_feed) = (zones.entry, zones.feed);
            if let Some((height, feed)) = zones.last {
                method = Method::Through { dwell: self.dwell_at_depth(DTB)?, height, feed };
            }
        }
        let feed = hole_feed;
        if matches!(method, Method::Tap(Tap { rigid: false, .. })) {
            self.note(given.place, codes::S8025::tap_needs_compensating_chuck_on_target(&given.called), Kind::Once);
        }
        let hole = Drilling { axis, levels, feed, entry, method };
        match hole.check() {
            Ok(()) => Ok(hole),
            Err(fault) => {
                let alarm = match fault {
                    DrillingFault::ReferencePlane => Some(61101),
                    DrillingFault::Lead => Some(61001),
                    DrillingFault::Peck => Some(61107),
                    _ => None,
                };
                self.unsound_call(alarm, &fault, "check the arguments of the cycle")
            }
        }
    }

    /// CYCLE82.
    pub(super) fn counterbore(&self) -> Made<Method> {
        let given = self.given;
        for key in [S_ZA, S_FA, S_ZD, S_FD] {
            if !has_zones(given) && given.or_zero(key) != 0.0 {
                self.unused(key, "without predrilling or through-drilling in `_VARI`");
            }
        }
        Ok(Method::Drill { dwell: self.dwell_at_depth(DTB)? })
    }

    /// A feed among the arguments, of the kind in force.
    pub(super) fn own_feed(&self, name: Name) -> Feed {
        self.st.feed_of(self.given.or_zero(name))
    }

    /// The relative first depth counts where both are given; an absolute one of 0 is taken as none then.
    fn two_first_depths(&self, levels: &Levels) {
        let given = self.given;
        let (Some(absolute), Some(relative)) = (self.given.length_if(FDEP), self.given.length_if(FDPR)) else {
            return;
        };
        let way = (levels.reference - absolute) * levels.outward();
        if relative != 0.0 && absolute != 0.0 && (way - relative.abs()).abs() > 1e-9 {
            let fault = codes::S8018::fdep_fdpr_give_different_first_depths(&given.called);
            self.note(given.place_of(FDEP), fault, Kind::Each);
        }
    }

    pub(super) fn peck(&self, levels: &Levels) -> Made<Method> {
        let given = self.given;
        self.two_first_depths(levels);
        if given.digit(GMODE, 1) == 1 {
            self.say_of(GMODE, codes::P8106::first_depth_counts_for_tip_of_drill());
        }
        let Some(first) = Pecking::first_step(levels, self.given.length_if(FDEP), self.given.length_if(FDPR)) else {
            return self.refuse_argument(FDEP, codes::P2090::first_drilling_depth_does_not_lie_between());
        };
        let degression = self.degression(first)?;
        if !matches!(degression, Degression::Factor { .. }) && given.or_zero(MDEP) != 0.0 {
            self.unused(MDEP, "unless DAM is a factor");
        }
        let dwell = self.dwell_at_depth(DTB)?;
        let dwell_at_bottom = if given.or_zero(DTD) == 0.0 { dwell } else { self.dwell_of(DTD)? };
        // With all eight digits the first feed is a percentage.
        let percent = given.digit(AMODE, 7) == 1;
        let factor = match given.number(FRF) {
            Some(factor) if percent => factor / 100.0,
            Some(factor) => factor,
            None => 1.0,
        };
        let first_feed = if factor <= 0.0 { 0.001 } else { factor.min(1.0) };
        let mut peck = Pecking { dwell, dwell_at_bottom, first_feed, ..Pecking::new(first, degression) };
        match given.or_zero(VARI) {
            0.0 => {
                peck.breaks = Breaks::Always;
                peck.way = self.given.length_if(VRT).filter(|way| *way > 0.0).unwrap_or(BREAK);
                for key in [DTS, DIS1].into_iter().filter(|key| given.or_zero(*key) != 0.0) {
                    self.unused(key, "when VARI breaks the chip");
                }
            }
            _ => {
                peck.removal.dwell = self.dwell_of(DTS)?;
                if given.or_zero(VRT) != 0.0 {
                    self.unused(VRT, "when VARI removes the chip");
                }
                if let Some(ahead) = self.given.length_if(DIS1).filter(|way| *way > 0.0) {
                    peck.removal.ahead = AdvancedStop::Evenly([ahead; 2]);
                }
            }
        }
        Ok(Method::Peck(peck))
    }

    /// DAM and AMODE: how the depth of a step changes from the `first` on.
    fn degression(&self, first: f64) -> Made<Degression> {
        let given = self.given;
        let unit = self.given.unit;
        let percent = given.digit(AMODE, 5) == 2;
        Ok(match given.or_zero(DAM) {
            percentage if percent && percentage > 0.0 && percentage <= 100.0 => {
                self.say_of(AMODE, codes::P8106::amode_says_that_dam_is_percentage());
                let least = self.given.length(MDEP).abs();
                Degression::Factor { factor: percentage / 100.0, least }
            }
            _ if percent => {
                return self.refuse_argument(DAM, codes::P2090::degression_is_above_0_to_100_percent());
            }
            0.0 => Degression::constant(first),
            amount if amount > 0.0 => Degression::Amount(amount * unit),
            factor if factor >= -1.0 => Degression::Factor { factor: -factor, least: self.given.length(MDEP).abs() },
            _ => {
                return self.refuse_argument(DAM, codes::P2090::degression_factor_is_above_1());
            }
        })
    }

    /// The pitch from PIT or MPIT, sizes up to M`largest`; positive for a right-hand thread.
    pub(super) fn pitch(&self, largest: f64, unit: i32) -> Made<f64> {
        let given = self.given;
        let mm = |value: f64| match unit {
            2 => 25.4 / value,
            3 => 25.4 * value,
            1 => value,
            _ => value * self.given.unit,
        };
        let by_size = match given.number(MPIT).filter(|size| *size != 0.0) {
            Some(diameter) => match coarse_pitch(diameter.abs()) {
                Some(coarse) if (3.0..=largest).contains(&diameter.abs()) => Some(coarse.copysign(diameter)),
                _ => {
                    return self.refuse_argument(MPIT, codes::P2090::m_is_no_size_of_this_cycle(&diameter.abs()));
                }
            },
            None => None,
        };
        let given = given.number(PIT).filter(|pitch| *pitch != 0.0).map(mm);
        match (by_size, given) {
            (Some(a), Some(b)) if (a - b).abs() > 1e-6 => {
                self.refuse_argument(PIT, codes::P2090::pitch_contradicts_thread_size(&b, &a))
            }
            (_, Some(pitch)) | (Some(pitch), None) => Ok(pitch),
            (None, None) => self.refuse(codes::P2090::pitch_is_missing()),
        }
    }

    /// The depth of a step of a tap: `_DAM` without its sign.
    fn tap_step(&self, levels: &Levels) -> Made<f64> {
        let step = self.given.length(DAM).abs();
        if step == 0.0 {
            return self.refuse_argument(DAM, codes::P2090::depth_of_step_dam_is_0());
        }
        if step > levels.way() {
            return self.refuse_argument(DAM, codes::P2090::first_step_dam_is_deeper_than_hole());
        }
        Ok(step)
    }

    pub(super) fn rigid_tap(&self, levels: &Levels) -> Made<Method> {
        let given = self.given;
        let lead = self.hand(self.pitch(LARGEST, self.pitch_unit()?)?)?;
        let step = match given.or_zero(VARI) {
            0.0 => None,
            variant @ (1.0 | 2.0) => {
                let back = self.given.length_if(VRT).filter(|way| *way > 0.0).unwrap_or(BREAK);
                let chip = if variant == 1.0 { Chip::Break { back } } else { Chip::Remove { ahead: back } };
                let way = self.tap_step(levels)?;
                Some(TapStep { way, degression: Degression::Even { least: way }, chip })
            }
            _ => {
                return self.refuse_argument(VARI, codes::P2090::vari_is_0_1_or_2());
            }
        };
        if given.or_zero(VARI) == 0.0 && given.or_zero(VRT) != 0.0 {
            self.unused(VRT, "when `_VARI` taps in one go");
        }
        self.note_technology();
        if given.digit(DMODE, 2) != 0 {
            self.say_of(DMODE, codes::P8106::hundreds_of_dmode_name_spindle_of_lathe());
        }
        let speed = |key: Name| given.number(key).filter(|speed| *speed > 0.0);
        let speed_in = speed(SST).or(self.st.spindles.speed());
        if speed_in.is_none() {
            return self.refuse(codes::P2090::spindle_has_no_speed_so_give_sst());
        }
        if given.or_zero(POSS) < 0.0 {
            return self.refuse_argument(POSS, codes::S9015::start_angle_of_machine_data());
        }
        let after = self.after()?;
        // Without POSS the tap begins where the spindle was stopped.
        let orient = given.number(POSS).map(whole_turn).or(self.st.spindles.angle());
        let turn = if lead > 0.0 { Turn::Clockwise } else { Turn::CounterClockwise };
        Ok(Method::Tap(Tap {
            dwell: self.dwell_at_depth(DTB)?,
            speed_in,
            speed_out: speed(SST1).or(speed_in),
            orient,
            step,
            speed_after: self.st.spindles.speed(),
            ..Tap::new(true, Some(lead), turn, after)
        }))
    }

    pub(super) fn spindle_turn(&self, key: Name) -> Made<Turn> {
        let given = self.given;
        self.master_is_main(given.place, "the spindle of a cycle")?;
        match given.or_zero(key) {
            3.0 => Ok(Turn::Clockwise),
            _ => Ok(Turn::CounterClockwise),
        }
    }

    /// ENC: with an encoder the pitch is kept (0, and 20 with a dwell), without one F makes it (1), or F made of S and the
    /// pitch (11).
    fn chuck_lead(&self) -> Made<Option<f64>> {
        let given = self.given;
        let pitched = given.or_zero(MPIT) != 0.0 || given.or_zero(PIT) != 0.0;
        match given.or_zero(ENC) {
            0.0 => {}
            20.0 => self.say_of(ENC, codes::P8106::enc_20_is_tapping_with_encoder()),
            1.0 => {
                if pitched {
                    let pitch = if given.or_zero(PIT) != 0.0 { given.or_zero(PIT) } else { given.or_zero(MPIT) };
                    let word = if given.or_zero(PIT) != 0.0 { "PIT" } else { "MPIT" };
                    self.note(
                        given.place_of(ENC),
                        codes::S8025::without_encoder_f(&given.called, &word, &pitch),
                        Kind::Once,
                    );
                }
                return Ok(None);
            }
            11.0 => {
                self.say_of(ENC, codes::P8106::enc_11_is_tapping_without_encoder());
                return Ok(None);
            }
            _ => return self.refuse_argument(ENC, codes::S9015::this_use_of_encoder()),
        }
        Ok(Some(self.pitch(LARGEST, self.pitch_unit()?)?.abs()))
    }

    /// The feed of CYCLE840: that in force, or under ENC 11 one made of S and the pitch.
    pub(super) fn feed_of_chuck(&self) -> Made<Feed> {
        let given = self.given;
        if given.or_zero(ENC) == 11.0 { self.feed_of_pitch() } else { self.cycle_feed() }
    }

    fn feed_of_pitch(&self) -> Made<Feed> {
        let pitch = self.pitch(LARGEST, self.pitch_unit()?)?.abs();
        match self.st.spindles.speed().filter(|speed| *speed > 0.0) {
            Some(_) if self.st.codes.per_revolution() => Ok(Feed::PerRevolution(pitch)),
            Some(speed) => Ok(Feed::PerMinute(speed * pitch)),
            None => self.refuse(codes::P2090::spindle_has_no_speed()),
        }
    }

    /// `_TECHNO` of the tapping cycles.
    fn note_technology(&self) {
        let given = self.given;
        if given.or_zero(TECHNO) != 0.0 {
            self.note(given.place_of(TECHNO), codes::S8002::words_that_only_shape_speed(), Kind::Once);
        }
    }

    pub(super) fn tap_with_chuck(&self) -> Made<Method> {
        let given = self.given;
        self.note_technology();
        let turn = match given.or_zero(SDR) {
            3.0 => Turn::CounterClockwise,
            4.0 => Turn::Clockwise,
            given if given != 0.0 => {
                return self.refuse_argument(SDR, codes::P2090::sdr_is_0_3_or_4());
            }
            _ => match self.st.spindles.turn() {
                Some(turn) => turn,
                None => {
                    return self.refuse(codes::P2090::spindle_does_not_turn());
                }
            },
        };
        if let Some(key) = given.below_zero(&[MPIT, PIT]) {
            return self.refuse_argument(key, codes::P2090::pitch_is_below_0());
        }
        let lead = self.chuck_lead()?;
        let dwell = if given.or_zero(ENC) == 0.0 { self.no_dwell() } else { self.dwell_at_depth(DTB)? };
        // With an automatic reversal the spindle turns on as before, and SDAC may be left out.
        let as_before = given.or_zero(SDR) == 0.0 && given.or_zero(SDAC) == 0.0;
        let after = if as_before { Spindle::Start(turn) } else { self.after()? };
        Ok(Method::Tap(Tap { dwell, ..Tap::new(false, lead, turn, after) }))
    }

    /// The way off the wall lies along the axes of the plane of the hole, which `_DMODE` may name.
    pub(super) fn bore(&self) -> Made<Method> {
        let given = self.given;
        let mut lift = [0.0; 3];
        if self.lifts_off()? {
            let (first, second, third) = plane_across(self.hole_axis()?).axes();
            let roles = [first, second, third].map(|at| Axis::ALL[at]);
            for ((key, axis), way) in [RPA, RPO, RPAP].into_iter().zip(roles).zip(lift.iter_mut()) {
                *way = self.given.length(key);
                if *way != 0.0 {
                    self.no_diameters(axis, given.place_of(key))?;
                }
            }
        }
        Ok(Method::Bore(Bore {
            dwell: self.dwell_at_depth(DTB)?,
            turn: self.spindle_turn(SDIR)?,
            orient: whole_turn(given.or_zero(POSS)),
            back: None,
            lift,
        }))
    }

    /// Unit of PIT: 0 that of the program, 1 mm, 2 turns per inch, 3 inch.
    fn pitch_unit(&self) -> Made<i32> {
        let given = self.given;
        match whole(given.or_zero(PITA)).filter(|unit| (0..=3).contains(unit)) {
            Some(unit) => Ok(unit),
            None => self.refuse_argument(PITA, codes::S9015::this_unit_of_pitch()),
        }
    }

    /// The state of the spindle behind a cycle: 3, 4 or 5.
    fn after(&self) -> Made<Spindle> {
        let given = self.given;
        match given.or_zero(SDAC) {
            3.0 => Ok(Spindle::Start(Turn::Clockwise)),
            4.0 => Ok(Spindle::Start(Turn::CounterClockwise)),
            0.0 | 5.0 => Ok(Spindle::Stop),
            _ => self.refuse_argument(SDAC, codes::P2090::spindle_direction_is_3_4_or_5()),
        }
    }

    /// With an encoder and ENC 0 the cycle does not dwell.
    fn no_dwell(&self) -> f64 {
        let given = self.given;
        if given.or_zero(DTB) != 0.0 {
            self.unused(DTB, "with an encoder and ENC 0; ENC 20 dwells");
        }
        0.0
    }

    /// The units of `_GMODE` say whether the tool lifts off: 0 does; what 1 and 2 do says the configuration.
    fn lifts_off(&self) -> Made<bool> {
        let given = self.given;
        match (given.digit(GMODE, 0), self.settings.control.sinumerik.cycle86_lift) {
            (0, _) => Ok(true),
            (_, Some(lift)) => Ok(lift),
            (digit, None) => self.refuse_as_said(
                given.place_of(GMODE),
                codes::S9015::whether_tool_lifts_off_under_gmode(&given.called, &digit)
                    .answer(Answer::key("control", "cycle86_lift")),
            ),
        }
    }
}
