//! CYCLE81 to CYCLE89 and CYCLE840.
//!
//! Source: reference sections 6.1 to 6.3.

use crate::diag::codes;
use crate::ir::Feed;
use crate::ir::cycle::Drilling;
use crate::ir::cycle::drilling::{Bore, Chip, Degression, DrillingFault, Levels, Method, Peck, Removal, Tap, TapStep};
use crate::ir::function::{Spindle, Turn};
use crate::standard::din13::coarse_pitch;

use super::super::value::whole;
use super::super::{Outcome, Run};
use super::Arguments;

/// Way back to break the chip, where none is given, in mm.
const BREAK: f64 = 1.0;

/// Is it a hole?
pub(super) fn is_hole(name: &str) -> bool {
    matches!(
        name,
        "CYCLE81"
            | "CYCLE82"
            | "CYCLE83"
            | "CYCLE84"
            | "CYCLE840"
            | "CYCLE85"
            | "CYCLE86"
            | "CYCLE87"
            | "CYCLE88"
            | "CYCLE89"
    )
}

/// An angle of the spindle within one turn.
fn whole_turn(angle: f64) -> f64 {
    angle - 360.0 * libm::floor(angle / 360.0)
}

impl Run<'_> {
    /// The hole that the arguments describe.
    pub(super) fn hole(&mut self, args: &Arguments) -> Outcome<Drilling> {
        let axis = self.hole_axis(args)?;
        self.no_diameters(&args.name, axis, args.span)?;
        let levels = self.levels(args)?;
        let feed = match args.name.as_str() {
            "CYCLE85" => self.own_feed(args, 7)?,
            "CYCLE84" => self.st.feed.unwrap_or(Feed::PerMinute(1.0)),
            "CYCLE840" if args.or_zero(9) == 11.0 => self.feed_of_pitch(args)?,
            _ => self.cycle_feed(args)?,
        };
        let method = match args.name.as_str() {
            "CYCLE81" | "CYCLE82" | "CYCLE89" => self.plain_hole(args, feed)?,
            "CYCLE83" => self.peck(args, &levels)?,
            "CYCLE84" => self.rigid_tap(args, &levels)?,
            "CYCLE840" => self.tap_with_chuck(args)?,
            "CYCLE85" => Method::Ream { dwell: self.dwell_at_depth(args, 6)?, back: self.own_feed(args, 8)? },
            "CYCLE86" => self.bore(args)?,
            "CYCLE87" => Method::BoreWithStop { dwell: 0.0, turn: self.spindle_turn(args, 6)? },
            _ => Method::BoreWithStop { dwell: self.dwell_of(args, 6)?, turn: self.spindle_turn(args, 7)? },
        };
        if matches!(method, Method::Tap(_)) {
            self.note_once(
                codes::S8025,
                args.span,
                format!("{}: the tap needs a compensating chuck on the target", args.name),
            );
        }
        let hole = Drilling { axis, levels, feed, method };
        match hole.check() {
            Ok(()) => Ok(hole),
            Err(fault) => {
                let alarm = match fault {
                    DrillingFault::ReferencePlane => 61101,
                    DrillingFault::Lead => 61001,
                    DrillingFault::Peck => 61107,
                    _ => 0,
                };
                self.cycle_fault(args, args.span, alarm, &fault.to_string(), "check the arguments of the cycle")
            }
        }
    }

    fn plain_hole(&self, args: &Arguments, feed: Feed) -> Outcome<Method> {
        if args.name == "CYCLE82" && args.or_zero(10) != 0.0 {
            return self.not_built(args, 10, "predrilling and through-drilling (`_VARI`)");
        }
        for (place, name) in [(11, "S_ZA"), (12, "S_FA"), (13, "S_ZD"), (14, "S_FD")] {
            if args.name == "CYCLE82" && args.or_zero(place) != 0.0 {
                self.unused(args, place, name, "without predrilling or through-drilling in `_VARI`");
            }
        }
        let dwell = self.dwell_at_depth(args, 6)?;
        Ok(if args.name == "CYCLE89" { Method::Ream { dwell, back: feed } } else { Method::Drill { dwell } })
    }

    /// A feed among the arguments, of the kind in force.
    fn own_feed(&self, args: &Arguments, place: usize) -> Outcome<Feed> {
        let value = self.needed(args, place, "the feed")?;
        if value <= 0.0 {
            return self.cycle_fault(
                args,
                args.span_of(place),
                61003,
                "the feed is not above 0",
                "give a feed above 0",
            );
        }
        Ok(self.feed_of(value))
    }

    /// The relative first depth counts where both are given; an absolute one of 0 is taken as none then.
    fn two_first_depths(&self, args: &Arguments, levels: &Levels) {
        let (Some(absolute), Some(relative)) = (self.length_of(args, 6), self.length_of(args, 7)) else { return };
        let way = (levels.reference - absolute) * levels.outward();
        if relative != 0.0 && absolute != 0.0 && (way - relative.abs()).abs() > 1e-9 {
            let message = "CYCLE83: FDEP and FDPR give different first depths; FDPR counts";
            let found = crate::diag::Diagnostic::new(codes::S8018, self.loc(args.span_of(6)), message);
            self.report(found.help("leave one of them out"));
        }
    }

    fn peck(&self, args: &Arguments, levels: &Levels) -> Outcome<Method> {
        self.two_first_depths(args, levels);
        if args.digit(18, 1) == 1 {
            self.reading(
                args,
                18,
                "the first depth counts for the tip of the drill, the last one for its full diameter",
            );
        }
        let Some(first) = Peck::first_step(levels, self.length_of(args, 6), self.length_of(args, 7)) else {
            return self.cycle_fault(
                args,
                args.span_of(6),
                61107,
                "the first drilling depth does not lie between the surface and the bottom",
                "give FDEP (argument 6) below the surface, or FDPR (argument 7)",
            );
        };
        let unit = self.st.length_unit();
        let percent = args.digit(20, 5) == 2;
        let degression = match args.or_zero(8) {
            percentage if percent && percentage > 0.0 && percentage <= 100.0 => {
                self.reading(args, 20, "`_AMODE` says that DAM is a percentage (digit 2 of the hundred thousands)");
                let least = self.length_of(args, 14).unwrap_or(0.0).abs();
                Degression::Factor { factor: percentage / 100.0, least }
            }
            _ if percent => {
                let help = "give 100 for steps of one size, less for shrinking ones";
                return self.cycle_fault(args, args.span_of(8), 0, "the degression is above 0 to 100 percent", help);
            }
            0.0 => Degression::constant(first),
            amount if amount > 0.0 => Degression::Amount(amount * unit),
            factor if factor >= -1.0 => {
                Degression::Factor { factor: -factor, least: self.length_of(args, 14).unwrap_or(0.0).abs() }
            }
            _ => {
                let help = "DAM above 0 is an amount, below 0 a factor down to -1";
                return self.cycle_fault(args, args.span_of(8), 0, "the degression factor is above 1", help);
            }
        };
        if let Some(place) = [15, 17].into_iter().find(|place| args.or_zero(*place) < 0.0) {
            let help = "give `_VRT` and `_DIS1` without a sign; 0 for the values of the cycle";
            return self.cycle_fault(args, args.span_of(place), 0, "a way back is below 0", help);
        }
        let dwell = self.dwell_at_depth(args, 9)?;
        let dwell_at_bottom = if args.or_zero(16) == 0.0 { dwell } else { self.dwell_of(args, 16)? };
        // With all eight digits the first feed is a percentage.
        let percent = args.digit(20, 7) == 1;
        let factor = match args.number(11) {
            Some(factor) if percent => factor / 100.0,
            Some(factor) => factor,
            None => 1.0,
        };
        let first_feed = if factor <= 0.0 { 0.001 } else { factor.min(1.0) };
        let removal = match args.or_zero(12) {
            0.0 => Removal::Break { way: self.length_of(args, 15).filter(|way| *way > 0.0).unwrap_or(BREAK) },
            1.0 => Removal::Clear {
                dwell: self.dwell_of(args, 10)?,
                ahead: self.length_of(args, 17).filter(|way| *way > 0.0),
            },
            _ => {
                return self.cycle_fault(
                    args,
                    args.span_of(12),
                    61002,
                    "VARI is 0 or 1",
                    "0 breaks the chip, 1 removes it",
                );
            }
        };
        Ok(Method::Peck(Peck { first, degression, dwell, dwell_at_bottom, first_feed, removal }))
    }

    /// Unit of PIT: 0 that of the program, 1 mm, 2 turns per inch, 3 inch.
    fn pitch_unit(&self, args: &Arguments, place: usize) -> Outcome<i32> {
        match whole(args.or_zero(place)).filter(|unit| (0..=3).contains(unit)) {
            Some(unit) => Ok(unit),
            None => self.not_built(args, place, "this unit of the pitch (`_PITA`)"),
        }
    }

    /// The pitch from PIT or MPIT, positive for a right-hand thread.
    pub(super) fn pitch(&self, args: &Arguments, size: usize, pitch: usize, unit: i32) -> Outcome<f64> {
        let mm = |value: f64| match unit {
            2 => 25.4 / value,
            3 => 25.4 * value,
            1 => value,
            _ => value * self.st.length_unit(),
        };
        let by_size = match args.number(size).filter(|size| *size != 0.0) {
            Some(diameter) => match coarse_pitch(diameter.abs()) {
                Some(coarse) if (3.0..=if args.name == "CYCLE97" { 60.0 } else { 48.0 }).contains(&diameter.abs()) => {
                    Some(coarse.copysign(diameter))
                }
                _ => {
                    let message = format!("M{} is no size of this cycle", diameter.abs());
                    return self.cycle_fault(args, args.span_of(size), 61001, &message, "give the pitch instead");
                }
            },
            None => None,
        };
        let given = args.number(pitch).filter(|pitch| *pitch != 0.0).map(mm);
        match (by_size, given) {
            (Some(a), Some(b)) if (a - b).abs() > 1e-6 => {
                let message = format!("the pitch {b} contradicts the thread size, whose pitch is {a}");
                self.cycle_fault(args, args.span_of(pitch), 61001, &message, "give the pitch or the size")
            }
            (_, Some(pitch)) | (Some(pitch), None) => Ok(pitch),
            (None, None) => {
                self.cycle_fault(args, args.span, 61001, "the pitch is missing", "give PIT, or MPIT as a metric size")
            }
        }
    }

    /// The depth of a step of a tap: `_DAM` without its sign.
    fn tap_step(&self, args: &Arguments, levels: &Levels) -> Outcome<f64> {
        let step = self.needed_length(args, 17, "the depth of a step `_DAM`")?.abs();
        if step == 0.0 {
            let help = "give `_DAM`, or `_VARI` 0 for one step";
            return self.cycle_fault(args, args.span_of(17), 61808, "the depth of a step `_DAM` is 0", help);
        }
        if step > levels.way() {
            let message = "the first step `_DAM` is deeper than the hole";
            return self.cycle_fault(args, args.span_of(17), 61809, message, "give `_VARI` 0 for one step");
        }
        Ok(step)
    }

    /// Under G96 the speed is none in turns, and it changes on the way.
    fn tapping_speed_is_fixed(&self, args: &Arguments) -> Outcome {
        if !self.st.constant_cut {
            return Ok(());
        }
        let help = "program G97 with S in turns per minute in front of the cycle";
        self.cycle_fault(args, args.span, 0, "tapping under a constant cutting speed (G96)", help)
    }

    fn rigid_tap(&mut self, args: &Arguments, levels: &Levels) -> Outcome<Method> {
        self.tapping_speed_is_fixed(args)?;
        self.master_is_main(args.span, "tapping")?;
        let lead = self.hand(args, self.pitch(args, 8, 9, self.pitch_unit(args, 14)?)?)?;
        let step = match args.or_zero(16) {
            0.0 => None,
            variant @ (1.0 | 2.0) => {
                let back = self.length_of(args, 18).filter(|way| *way > 0.0).unwrap_or(BREAK);
                let chip = if variant == 1.0 { Chip::Break { back } } else { Chip::Remove { ahead: back } };
                Some(TapStep { way: self.tap_step(args, levels)?, chip })
            }
            _ => {
                let help = "0 taps in one go, 1 breaks the chip, 2 removes it";
                return self.cycle_fault(args, args.span_of(16), 61002, "`_VARI` is 0, 1 or 2", help);
            }
        };
        if args.or_zero(16) == 0.0 && args.or_zero(18) != 0.0 {
            self.unused(args, 18, "_VRT", "when `_VARI` taps in one go");
        }
        if args.or_zero(15) != 0.0 {
            self.note_once(codes::S8002, args.span_of(15), "words that only shape speed and accuracy are left out");
        }
        if args.digit(23, 2) != 0 {
            self.reading(
                args,
                23,
                "the hundreds of `_DMODE` name the spindle of a lathe, and the tap takes the master spindle",
            );
        }
        let speed = |place: usize| args.number(place).filter(|speed| *speed > 0.0);
        let speed_in = speed(11).or(self.st.speed);
        if speed_in.is_none() {
            return self.cycle_fault(
                args,
                args.span,
                61102,
                "the spindle has no speed",
                "give SST (argument 11) or program S",
            );
        }
        if args.or_zero(10) < 0.0 {
            return self.not_built(args, 10, "the start angle of the machine data (a negative POSS)");
        }
        if let Some(place) = [11, 12].into_iter().find(|place| args.or_zero(*place) < 0.0) {
            let help = "the sign of the pitch makes the hand of the thread";
            return self.cycle_fault(args, args.span_of(place), 16763, "a speed is below 0", help);
        }
        let after = self.after(args, 7)?;
        Ok(Method::Tap(Tap {
            lead: Some(lead.abs()),
            turn: if lead > 0.0 { Turn::Clockwise } else { Turn::CounterClockwise },
            dwell: self.dwell_at_depth(args, 6)?,
            dwell_reversed: false,
            speed_in,
            speed_out: speed(12).or(speed_in),
            orient: args.number(10).map(whole_turn),
            step,
            after,
            speed_after: self.st.speed,
        }))
    }

    /// The state of the spindle behind a cycle: 3, 4 or 5.
    fn after(&self, args: &Arguments, place: usize) -> Outcome<Spindle> {
        match args.or_zero(place) {
            3.0 => Ok(Spindle::Start(Turn::Clockwise)),
            4.0 => Ok(Spindle::Start(Turn::CounterClockwise)),
            0.0 | 5.0 => Ok(Spindle::Stop),
            _ => self.cycle_fault(args, args.span_of(place), 61102, "the spindle direction is 3, 4 or 5", "3 is M3"),
        }
    }

    fn spindle_turn(&self, args: &Arguments, place: usize) -> Outcome<Turn> {
        self.master_is_main(args.span, "the spindle of a cycle")?;
        match args.or_zero(place) {
            3.0 => Ok(Turn::Clockwise),
            4.0 => Ok(Turn::CounterClockwise),
            _ => self.cycle_fault(args, args.span_of(place), 61102, "no spindle direction is given", "give 3 or 4"),
        }
    }

    /// ENC: with an encoder the pitch is kept (0, and 20 with a dwell), without one F makes it (1), or F made of S and the
    /// pitch (11).
    fn chuck_lead(&mut self, args: &Arguments) -> Outcome<Option<f64>> {
        let pitched = args.or_zero(10) != 0.0 || args.or_zero(11) != 0.0;
        match args.or_zero(9) {
            0.0 => {}
            20.0 => self.reading(args, 9, "ENC 20 is tapping with an encoder and a dwell"),
            1.0 => {
                if pitched {
                    let message = "CYCLE840: the tap needs a compensating chuck on the target; without an encoder F and S \
                                   make the thread, and the pitch of the call is not used";
                    self.note_once(codes::S8025, args.span_of(9), message.to_owned());
                }
                return Ok(None);
            }
            11.0 => {
                self.reading(args, 9, "ENC 11 is tapping without an encoder, with a feed made of S and the pitch");
                return Ok(None);
            }
            _ => return self.not_built(args, 9, "this use of the encoder (ENC)"),
        }
        Ok(Some(self.pitch(args, 10, 11, self.pitch_unit(args, 13)?)?.abs()))
    }

    /// The feed of CYCLE840 under ENC 11.
    fn feed_of_pitch(&mut self, args: &Arguments) -> Outcome<Feed> {
        let pitch = self.pitch(args, 10, 11, self.pitch_unit(args, 13)?)?.abs();
        match self.st.speed.filter(|speed| *speed > 0.0) {
            Some(_) if self.st.per_revolution() => Ok(Feed::PerRevolution(pitch)),
            Some(speed) => Ok(Feed::PerMinute(speed * pitch)),
            None => {
                let help = "program S in front of the cycle";
                self.cycle_fault(args, args.span, 61102, "the spindle has no speed", help)
            }
        }
    }

    /// With an encoder and ENC 0 the cycle does not dwell.
    fn no_dwell(&self, args: &Arguments) -> f64 {
        if args.or_zero(6) != 0.0 {
            self.unused(args, 6, "DTB", "with an encoder and ENC 0; ENC 20 dwells");
        }
        0.0
    }

    fn tap_with_chuck(&mut self, args: &Arguments) -> Outcome<Method> {
        self.tapping_speed_is_fixed(args)?;
        self.master_is_main(args.span, "tapping")?;
        let turn = match args.or_zero(7) {
            3.0 => Turn::CounterClockwise,
            4.0 => Turn::Clockwise,
            given if given != 0.0 => {
                let help = "3 or 4 is the sense on the way out, 0 the other one than before the cycle";
                return self.cycle_fault(args, args.span_of(7), 61102, "SDR is 0, 3 or 4", help);
            }
            _ => match self.st.turn {
                Some(turn) => turn,
                None => {
                    return self.cycle_fault(
                        args,
                        args.span,
                        61102,
                        "the spindle does not turn",
                        "program M3 or M4 before",
                    );
                }
            },
        };
        if let Some(place) = [10, 11].into_iter().find(|place| args.or_zero(*place) < 0.0) {
            let help =
                "give it without a sign: the spindle in front of the cycle, or SDR, makes the hand of the thread";
            return self.cycle_fault(args, args.span_of(place), 61001, "the pitch is below 0", help);
        }
        let lead = self.chuck_lead(args)?;
        let dwell = if args.or_zero(9) == 0.0 { self.no_dwell(args) } else { self.dwell_at_depth(args, 6)? };
        // With an automatic reversal the spindle turns on as before, and SDAC may be left out.
        let as_before = args.or_zero(7) == 0.0 && args.or_zero(8) == 0.0;
        Ok(Method::Tap(Tap {
            lead,
            turn,
            dwell,
            dwell_reversed: false,
            speed_in: None,
            speed_out: None,
            orient: None,
            step: None,
            after: if as_before { Spindle::Start(turn) } else { self.after(args, 8)? },
            speed_after: None,
        }))
    }

    /// The units of `_GMODE` say whether the tool lifts off: 0 does; what 1 and 2 do says the configuration.
    fn lifts_off(&self, args: &Arguments) -> Outcome<bool> {
        match (args.digit(12, 0), self.job.settings.control.siemens.cycle86_lift) {
            (0, _) => Ok(true),
            (_, Some(lift)) => Ok(lift),
            (digit, None) => {
                let message = format!("CYCLE86: whether the tool lifts off under `_GMODE` {digit} is not known");
                let help = "say what the machine does: `[control] cycle86_lift = \"lift\"` or `\"none\"`";
                self.fail_help(codes::S9015, 0, args.span_of(12), message, help)
            }
        }
    }

    fn bore(&self, args: &Arguments) -> Outcome<Method> {
        let mut lift = [0.0; 3];
        if self.lifts_off(args)? {
            for (place, way) in [8, 9, 10].into_iter().zip(lift.iter_mut()) {
                *way = self.length_of(args, place).unwrap_or(0.0);
                if *way != 0.0 {
                    self.no_diameters(&args.name, self.st.roles()[place - 8], args.span_of(place))?;
                }
            }
        }
        Ok(Method::Bore(Bore {
            dwell: self.dwell_at_depth(args, 6)?,
            turn: self.spindle_turn(args, 7)?,
            orient: whole_turn(args.or_zero(11)),
            back: None,
            lift,
        }))
    }
}
