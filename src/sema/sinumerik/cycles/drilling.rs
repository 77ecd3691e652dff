//! CYCLE81 to CYCLE89 and CYCLE840.
//!
//! Source: C 6.1 to 6.3 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Plane;
use crate::ir::Feed;
use crate::ir::cycle::drilling::{
    Ahead, Bore, Breaks, Chip, Degression, DrillingFault, Levels, Method, Pecking, Tap, TapStep,
};
use crate::ir::cycle::{Drilling, Family};
use crate::ir::function::{Spindle, Turn};
use crate::machine::Axis;
use crate::standard::din13::coarse_pitch;

use super::super::Outcome;
use super::super::value::whole;
use super::arguments::{
    AMODE, DAM, DIS1, DMODE, DTB, DTD, DTS, ENC, FDEP, FDPR, FRF, GMODE, Key, MDEP, MPIT, PIT, PITA, POSS, RPA, RPAP,
    RPO, S_FA, S_FD, S_ZA, S_ZD, SDAC, SDIR, SDR, SST, SST1, TECHNO, VARI, VRT,
};
use super::call::CycleCall;
use super::table::Hole;

/// Way back to break the chip, where none is given, in mm.
const BREAK: f64 = 1.0;

/// Largest metric size of a tap.
const LARGEST: f64 = 48.0;

/// The plane across a hole along this axis.
pub(super) fn plane_across(axis: Axis) -> Plane {
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

impl CycleCall<'_, '_> {
    /// The hole that the arguments describe.
    pub(super) fn hole(&mut self, cycle: &Hole) -> Outcome<Drilling> {
        let args = self.args;
        let axis = self.hole_axis()?;
        self.no_diameters(args.name(), axis, args.span)?;
        let levels = self.levels(cycle.centring)?;
        let feed = (cycle.feed)(self)?;
        let mut method = (cycle.method)(self, &levels, feed)?;
        let mut hole_feed = feed;
        let mut entry = None;
        if args.has_zones() {
            let zones = self.zones(&levels, feed)?;
            (entry, hole_feed) = (zones.entry, zones.feed);
            if let Some((height, feed)) = zones.last {
                method = Method::Through { dwell: self.dwell_at_depth(DTB)?, height, feed };
            }
        }
        let feed = hole_feed;
        if matches!(method, Method::Tap(Tap { rigid: false, .. })) {
            self.note_once(
                codes::S8025,
                args.span,
                format!("{}: the tap needs a compensating chuck on the target", args.name()),
            );
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
                self.cycle_fault(args.span, alarm, &fault.to_string(), "check the arguments of the cycle")
            }
        }
    }

    /// CYCLE82.
    pub(super) fn counterbore(&self) -> Outcome<Method> {
        let args = self.args;
        for key in [S_ZA, S_FA, S_ZD, S_FD] {
            if !args.has_zones() && args.or_zero(key) != 0.0 {
                self.unused(key, key.0, "without predrilling or through-drilling in `_VARI`");
            }
        }
        Ok(Method::Drill { dwell: self.dwell_at_depth(DTB)? })
    }

    /// A feed among the arguments, of the kind in force.
    pub(super) fn own_feed(&self, key: Key) -> Outcome<Feed> {
        let args = self.args;
        let value = self.needed(key, "the feed")?;
        if value <= 0.0 {
            return self.cycle_fault(args.span_of(key), 61003, "the feed is not above 0", "give a feed above 0");
        }
        Ok(self.st.feed_of(value))
    }

    /// The relative first depth counts where both are given; an absolute one of 0 is taken as none then.
    fn two_first_depths(&self, levels: &Levels) {
        let args = self.args;
        let (Some(absolute), Some(relative)) = (self.length_of(args, FDEP), self.length_of(args, FDPR)) else {
            return;
        };
        let way = (levels.reference - absolute) * levels.outward();
        if relative != 0.0 && absolute != 0.0 && (way - relative.abs()).abs() > 1e-9 {
            let message = format!("{}: FDEP and FDPR give different first depths; FDPR counts", args.name());
            let found = crate::diag::Diagnostic::new(codes::S8018, self.loc(args.span_of(FDEP)), message);
            self.report(found.help("leave one of them out"));
        }
    }

    pub(super) fn peck(&self, levels: &Levels) -> Outcome<Method> {
        let args = self.args;
        self.two_first_depths(levels);
        if args.digit(GMODE, 1) == 1 {
            self.reading(GMODE, "the first depth counts for the tip of the drill, the last one for its full diameter");
        }
        let Some(first) = Pecking::first_step(levels, self.length_of(args, FDEP), self.length_of(args, FDPR)) else {
            return self.cycle_fault(
                args.span_of(FDEP),
                61107,
                "the first drilling depth does not lie between the surface and the bottom",
                "give FDEP (argument 6) below the surface, or FDPR (argument 7)",
            );
        };
        let unit = self.st.length_unit();
        let percent = args.digit(AMODE, 5) == 2;
        let degression = match args.or_zero(DAM) {
            percentage if percent && percentage > 0.0 && percentage <= 100.0 => {
                self.reading(AMODE, "`_AMODE` says that DAM is a percentage (digit 2 of the hundred thousands)");
                let least = self.length_of(args, MDEP).unwrap_or(0.0).abs();
                Degression::Factor { factor: percentage / 100.0, least }
            }
            _ if percent => {
                let help = "give 100 for steps of one size, less for shrinking ones";
                return self.cycle_fault(args.span_of(DAM), None, "the degression is above 0 to 100 percent", help);
            }
            0.0 => Degression::constant(first),
            amount if amount > 0.0 => Degression::Amount(amount * unit),
            factor if factor >= -1.0 => {
                Degression::Factor { factor: -factor, least: self.length_of(args, MDEP).unwrap_or(0.0).abs() }
            }
            _ => {
                let help = "DAM above 0 is an amount, below 0 a factor down to -1";
                return self.cycle_fault(args.span_of(DAM), None, "the degression factor is above 1", help);
            }
        };
        if !matches!(degression, Degression::Factor { .. }) && args.or_zero(MDEP) != 0.0 {
            self.unused(MDEP, "_MDEP", "unless DAM is a factor");
        }
        if let Some(key) = args.below_zero(&[VRT, DIS1]) {
            let help = "give `_VRT` and `_DIS1` without a sign; 0 for the values of the cycle";
            return self.cycle_fault(args.span_of(key), None, "a way back is below 0", help);
        }
        let dwell = self.dwell_at_depth(DTB)?;
        let dwell_at_bottom = if args.or_zero(DTD) == 0.0 { dwell } else { self.dwell_of(DTD)? };
        // With all eight digits the first feed is a percentage.
        let percent = args.digit(AMODE, 7) == 1;
        let factor = match args.number(FRF) {
            Some(factor) if percent => factor / 100.0,
            Some(factor) => factor,
            None => 1.0,
        };
        let first_feed = if factor <= 0.0 { 0.001 } else { factor.min(1.0) };
        let mut peck = Pecking { dwell, dwell_at_bottom, first_feed, ..Pecking::new(first, degression) };
        match args.or_zero(VARI) {
            0.0 => {
                peck.breaks = Breaks::Always;
                peck.way = self.length_of(args, VRT).filter(|way| *way > 0.0).unwrap_or(BREAK);
                for key in [DTS, DIS1].into_iter().filter(|key| args.or_zero(*key) != 0.0) {
                    self.unused(key, &args.written(key), "when VARI breaks the chip");
                }
            }
            1.0 => {
                peck.removal.dwell = self.dwell_of(DTS)?;
                if args.or_zero(VRT) != 0.0 {
                    self.unused(VRT, "_VRT", "when VARI removes the chip");
                }
                if let Some(ahead) = self.length_of(args, DIS1).filter(|way| *way > 0.0) {
                    peck.removal.ahead = Ahead::Evenly([ahead; 2]);
                }
            }
            _ => {
                let help = "0 breaks the chip, 1 removes it";
                return self.cycle_fault(args.span_of(VARI), 61002, "VARI is 0 or 1", help);
            }
        }
        Ok(Method::Peck(peck))
    }

    /// The pitch from PIT or MPIT, sizes up to M`largest`; positive for a right-hand thread.
    pub(super) fn pitch(&self, largest: f64, unit: i32) -> Outcome<f64> {
        let args = self.args;
        let mm = |value: f64| match unit {
            2 => 25.4 / value,
            3 => 25.4 * value,
            1 => value,
            _ => value * self.st.length_unit(),
        };
        let by_size = match args.number(MPIT).filter(|size| *size != 0.0) {
            Some(diameter) => match coarse_pitch(diameter.abs()) {
                Some(coarse) if (3.0..=largest).contains(&diameter.abs()) => Some(coarse.copysign(diameter)),
                _ => {
                    let message = format!("M{} is no size of this cycle", diameter.abs());
                    return self.cycle_fault(args.span_of(MPIT), 61001, &message, "give the pitch instead");
                }
            },
            None => None,
        };
        let given = args.number(PIT).filter(|pitch| *pitch != 0.0).map(mm);
        match (by_size, given) {
            (Some(a), Some(b)) if (a - b).abs() > 1e-6 => {
                let message = format!("the pitch {b} contradicts the thread size, whose pitch is {a}");
                self.cycle_fault(args.span_of(PIT), 61001, &message, "give the pitch or the size")
            }
            (_, Some(pitch)) | (Some(pitch), None) => Ok(pitch),
            (None, None) => {
                self.cycle_fault(args.span, 61001, "the pitch is missing", "give PIT, or MPIT as a metric size")
            }
        }
    }

    /// The depth of a step of a tap: `_DAM` without its sign.
    fn tap_step(&self, levels: &Levels) -> Outcome<f64> {
        let args = self.args;
        let step = self.needed_length(DAM, "the depth of a step `_DAM`")?.abs();
        if step == 0.0 {
            let help = "give `_DAM`, or `_VARI` 0 for one step";
            return self.cycle_fault(args.span_of(DAM), 61808, "the depth of a step `_DAM` is 0", help);
        }
        if step > levels.way() {
            let message = "the first step `_DAM` is deeper than the hole";
            return self.cycle_fault(args.span_of(DAM), 61809, message, "give `_VARI` 0 for one step");
        }
        Ok(step)
    }

    /// Under G96 the speed is none in turns, and it changes on the way.
    fn tapping_speed_is_fixed(&self) -> Outcome {
        let args = self.args;
        if !self.st.spindles.is_cutting() {
            return Ok(());
        }
        let help = "program G97 with S in turns per minute in front of the cycle";
        self.cycle_fault(args.span, None, "tapping under a constant cutting speed (G96)", help)
    }

    pub(super) fn rigid_tap(&mut self, levels: &Levels) -> Outcome<Method> {
        let args = self.args;
        self.tapping_speed_is_fixed()?;
        self.master_is_main(args.span, "tapping")?;
        let lead = self.hand(self.pitch(LARGEST, self.pitch_unit()?)?)?;
        let step = match args.or_zero(VARI) {
            0.0 => None,
            variant @ (1.0 | 2.0) => {
                let back = self.length_of(args, VRT).filter(|way| *way > 0.0).unwrap_or(BREAK);
                let chip = if variant == 1.0 { Chip::Break { back } } else { Chip::Remove { ahead: back } };
                let way = self.tap_step(levels)?;
                Some(TapStep { way, degression: Degression::Even { least: way }, chip })
            }
            _ => {
                let help = "0 taps in one go, 1 breaks the chip, 2 removes it";
                return self.cycle_fault(args.span_of(VARI), 61002, "`_VARI` is 0, 1 or 2", help);
            }
        };
        if args.or_zero(VARI) == 0.0 && args.or_zero(VRT) != 0.0 {
            self.unused(VRT, "_VRT", "when `_VARI` taps in one go");
        }
        self.note_technology();
        if args.digit(DMODE, 2) != 0 {
            self.reading(
                DMODE,
                "the hundreds of `_DMODE` name the spindle of a lathe, and the tap takes the master spindle",
            );
        }
        let speed = |key: Key| args.number(key).filter(|speed| *speed > 0.0);
        let speed_in = speed(SST).or(self.st.spindles.speed());
        if speed_in.is_none() {
            return self.cycle_fault(
                args.span,
                61102,
                "the spindle has no speed",
                "give SST (argument 11) or program S",
            );
        }
        if args.or_zero(POSS) < 0.0 {
            return self.not_built(POSS, "the start angle of the machine data (a negative POSS)");
        }
        if let Some(key) = args.below_zero(&[SST, SST1]) {
            let help = "the sign of the pitch makes the hand of the thread";
            return self.cycle_fault(args.span_of(key), 16763, "a speed is below 0", help);
        }
        let after = self.after()?;
        // Without POSS the tap begins where the spindle was stopped.
        let orient = args.number(POSS).map(whole_turn).or(self.st.spindles.angle());
        self.st.spindles.forget_angle();
        Ok(Method::Tap(Tap {
            rigid: true,
            lead: Some(lead.abs()),
            turn: if lead > 0.0 { Turn::Clockwise } else { Turn::CounterClockwise },
            dwell: self.dwell_at_depth(DTB)?,
            dwell_reversed: false,
            speed_in,
            speed_out: speed(SST1).or(speed_in),
            orient,
            step,
            after,
            speed_after: self.st.spindles.speed(),
        }))
    }

    pub(super) fn spindle_turn(&self, key: Key) -> Outcome<Turn> {
        let args = self.args;
        self.master_is_main(args.span, "the spindle of a cycle")?;
        match args.or_zero(key) {
            3.0 => Ok(Turn::Clockwise),
            4.0 => Ok(Turn::CounterClockwise),
            _ => self.cycle_fault(args.span_of(key), 61102, "no spindle direction is given", "give 3 or 4"),
        }
    }

    /// ENC: with an encoder the pitch is kept (0, and 20 with a dwell), without one F makes it (1), or F made of S and the
    /// pitch (11).
    fn chuck_lead(&mut self) -> Outcome<Option<f64>> {
        let args = self.args;
        let pitched = args.or_zero(MPIT) != 0.0 || args.or_zero(PIT) != 0.0;
        match args.or_zero(ENC) {
            0.0 => {}
            20.0 => self.reading(ENC, "ENC 20 is tapping with an encoder and a dwell"),
            1.0 => {
                if pitched {
                    let given = if args.or_zero(PIT) != 0.0 { args.or_zero(PIT) } else { args.or_zero(MPIT) };
                    let word = if args.or_zero(PIT) != 0.0 { "PIT" } else { "MPIT" };
                    let message = format!(
                        "{}: without an encoder F and S make the thread, and the pitch of the call, {word} {given}, is not used",
                        args.name()
                    );
                    self.note_once(codes::S8025, args.span_of(ENC), message);
                }
                return Ok(None);
            }
            11.0 => {
                self.reading(ENC, "ENC 11 is tapping without an encoder, with a feed made of S and the pitch");
                return Ok(None);
            }
            _ => return self.not_built(ENC, "this use of the encoder (ENC)"),
        }
        Ok(Some(self.pitch(LARGEST, self.pitch_unit()?)?.abs()))
    }

    /// The feed of CYCLE840: that in force, or under ENC 11 one made of S and the pitch.
    pub(super) fn feed_of_chuck(&mut self) -> Outcome<Feed> {
        let args = self.args;
        if args.or_zero(ENC) == 11.0 { self.feed_of_pitch() } else { self.cycle_feed() }
    }

    fn feed_of_pitch(&mut self) -> Outcome<Feed> {
        let args = self.args;
        let pitch = self.pitch(LARGEST, self.pitch_unit()?)?.abs();
        match self.st.spindles.speed().filter(|speed| *speed > 0.0) {
            Some(_) if self.st.codes.per_revolution() => Ok(Feed::PerRevolution(pitch)),
            Some(speed) => Ok(Feed::PerMinute(speed * pitch)),
            None => {
                let help = "program S in front of the cycle";
                self.cycle_fault(args.span, 61102, "the spindle has no speed", help)
            }
        }
    }

    /// `_TECHNO` of the tapping cycles.
    fn note_technology(&mut self) {
        let args = self.args;
        if args.or_zero(TECHNO) != 0.0 {
            self.note_once(codes::S8002, args.span_of(TECHNO), "words that only shape speed and accuracy are left out");
        }
    }

    pub(super) fn tap_with_chuck(&mut self) -> Outcome<Method> {
        let args = self.args;
        self.note_technology();
        self.tapping_speed_is_fixed()?;
        self.master_is_main(args.span, "tapping")?;
        let turn = match args.or_zero(SDR) {
            3.0 => Turn::CounterClockwise,
            4.0 => Turn::Clockwise,
            given if given != 0.0 => {
                let help = "3 or 4 is the sense on the way out, 0 the other one than before the cycle";
                return self.cycle_fault(args.span_of(SDR), 61102, "SDR is 0, 3 or 4", help);
            }
            _ => match self.st.spindles.turn() {
                Some(turn) => turn,
                None => {
                    return self.cycle_fault(args.span, 61102, "the spindle does not turn", "program M3 or M4 before");
                }
            },
        };
        if let Some(key) = args.below_zero(&[MPIT, PIT]) {
            let help =
                "give it without a sign: the spindle in front of the cycle, or SDR, makes the hand of the thread";
            return self.cycle_fault(args.span_of(key), 61001, "the pitch is below 0", help);
        }
        let lead = self.chuck_lead()?;
        let dwell = if args.or_zero(ENC) == 0.0 { self.no_dwell() } else { self.dwell_at_depth(DTB)? };
        // With an automatic reversal the spindle turns on as before, and SDAC may be left out.
        let as_before = args.or_zero(SDR) == 0.0 && args.or_zero(SDAC) == 0.0;
        Ok(Method::Tap(Tap {
            rigid: false,
            lead,
            turn,
            dwell,
            dwell_reversed: false,
            speed_in: None,
            speed_out: None,
            orient: None,
            step: None,
            after: if as_before { Spindle::Start(turn) } else { self.after()? },
            speed_after: None,
        }))
    }

    /// The way off the wall lies along the axes of the plane of the hole, which `_DMODE` may name.
    pub(super) fn bore(&self) -> Outcome<Method> {
        let args = self.args;
        let mut lift = [0.0; 3];
        if self.lifts_off()? {
            let (first, second, third) = plane_across(self.hole_axis()?).axes();
            let roles = [first, second, third].map(|at| Axis::ALL[at]);
            for ((key, axis), way) in [RPA, RPO, RPAP].into_iter().zip(roles).zip(lift.iter_mut()) {
                *way = self.length_of(args, key).unwrap_or(0.0);
                if *way != 0.0 {
                    self.no_diameters(args.name(), axis, args.span_of(key))?;
                }
            }
        }
        Ok(Method::Bore(Bore {
            dwell: self.dwell_at_depth(DTB)?,
            turn: self.spindle_turn(SDIR)?,
            orient: whole_turn(args.or_zero(POSS)),
            back: None,
            lift,
        }))
    }

    /// Unit of PIT: 0 that of the program, 1 mm, 2 turns per inch, 3 inch.
    fn pitch_unit(&self) -> Outcome<i32> {
        let args = self.args;
        match whole(args.or_zero(PITA)).filter(|unit| (0..=3).contains(unit)) {
            Some(unit) => Ok(unit),
            None => self.not_built(PITA, "this unit of the pitch (`_PITA`)"),
        }
    }

    /// The state of the spindle behind a cycle: 3, 4 or 5.
    fn after(&self) -> Outcome<Spindle> {
        let args = self.args;
        match args.or_zero(SDAC) {
            3.0 => Ok(Spindle::Start(Turn::Clockwise)),
            4.0 => Ok(Spindle::Start(Turn::CounterClockwise)),
            0.0 | 5.0 => Ok(Spindle::Stop),
            _ => self.cycle_fault(args.span_of(SDAC), 61102, "the spindle direction is 3, 4 or 5", "3 is M3"),
        }
    }

    /// With an encoder and ENC 0 the cycle does not dwell.
    fn no_dwell(&self) -> f64 {
        let args = self.args;
        if args.or_zero(DTB) != 0.0 {
            self.unused(DTB, "DTB", "with an encoder and ENC 0; ENC 20 dwells");
        }
        0.0
    }

    /// The units of `_GMODE` say whether the tool lifts off: 0 does; what 1 and 2 do says the configuration.
    fn lifts_off(&self) -> Outcome<bool> {
        let args = self.args;
        match (args.digit(GMODE, 0), self.job.settings.control.sinumerik.cycle86_lift) {
            (0, _) => Ok(true),
            (_, Some(lift)) => Ok(lift),
            (digit, None) => {
                let message =
                    format!("{}: whether the tool lifts off under `_GMODE` {digit} is not known", args.name());
                let help = Answer::key("control", "cycle86_lift")
                    .help("say what the machine does: `[control] cycle86_lift = \"lift\"` or `\"none\"`");
                self.fail_help(codes::S9015, args.span_of(GMODE), message, help)
            }
        }
    }
}
