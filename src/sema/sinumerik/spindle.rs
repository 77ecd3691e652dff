//! Spindles: speed, sense of rotation, constant cutting speed.
//!
//! Source: reference section 2.15.

use crate::diag::codes;
use crate::ir::Function;
use crate::ir::function::Spindle;
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::{Code, Group};
use super::state::{MAIN_SPINDLE, SpindleState};
use super::vocabulary::Address;
use super::words::{Given, MWord, Mode, SWord, Words};
use super::{Outcome, Run};

/// Highest spindle number that is a spindle.
const MOST_SPINDLES: u8 = 20;

impl Run<'_> {
    /// A word for spindle `n`. The target knows the first one without a number.
    pub(super) fn send_spindle(&mut self, n: u8, spindle: Spindle) {
        if n == MAIN_SPINDLE {
            self.function(Function::Spindle(spindle));
        } else {
            self.function(Function::SpindleOf { number: n, spindle });
        }
    }

    /// Feed per revolution, threads and cutting speed count with the turns of the master; the target counts those
    /// of its first spindle.
    pub(super) fn master_is_main(&self, place: impl Into<Where>, what: &str) -> Outcome {
        let master = self.st.master;
        if master == MAIN_SPINDLE {
            return Ok(());
        }
        self.fail_help(
            codes::S9007,
            place,
            format!("{what} follows spindle {master}, the master; the target follows its first spindle"),
            "program a feed per minute (G94), or make spindle 1 the master: SETMS(1)",
        )
    }

    /// S words of a block.
    pub(super) fn speeds(&mut self, w: &Words) -> Outcome {
        let constant = self.st.codes.of(Group::FeedType).holds_cutting_speed();
        let masters = |s: &SWord| s.spindle.is_none_or(|n| n == self.st.master);
        let given = w.s.iter().any(masters);
        if !given {
            if constant && self.st.speed_kept {
                // G96 again: the speed that the spindle kept is none in m/min.
                (self.st.constant_cut, self.st.speed_kept) = (false, false);
            } else if !constant && self.st.constant_cut && !self.st.speed_kept {
                self.st.speed_kept = true;
                // Where M5 stops the spindle nothing goes on.
                let stops = |m: &MWord| m.number == 5 && m.spindle.is_none_or(|n| n == self.st.master);
                if w.m.iter().any(stops) {
                    self.st.turns = None;
                    return self.speeds_given(w, constant);
                }
                self.freeze_speed(w.code_of(Group::FeedType).map(|(_, span)| span).unwrap_or_default())?;
            }
        }
        if let Some((code, span)) = w.code_of(Group::FeedType)
            && !given
        {
            self.feed_kind_limits_speed(code, span);
        }
        self.speeds_given(w, constant)
    }

    fn speeds_given(&mut self, w: &Words, constant: bool) -> Outcome {
        for at in 0..w.s.len() {
            self.speed(w.s[at], constant)?;
        }
        if !constant || self.st.constant_cut {
            self.cut_speed_open = None;
        } else if self.cut_speed_open.is_none() {
            self.cut_speed_open = Some(w.code_of(Group::FeedType).map(|(_, span)| span).unwrap_or_default());
        }
        Ok(())
    }

    /// Refuses a cut at a speed that a turning spindle kept since G96 and that is not known here.
    pub(super) fn speed_is_known(&mut self) -> Outcome {
        if !self.st.speed_kept || self.st.turn.is_none() || self.st.turns.is_some() {
            return Ok(());
        }
        // Once is enough.
        (self.st.constant_cut, self.st.speed_kept) = (false, false);
        self.unknown_speed(Where::Block, "this block cuts at the speed that the spindle happens to have kept since G96")
    }

    fn unknown_speed(&self, place: impl Into<Where>, message: &str) -> Outcome {
        self.fail_help(codes::S2045, place, message, "program the speed in turns per minute behind G97: S1000")
    }

    /// Refuses to start spindle `n` without a speed that is known.
    pub(super) fn start_is_known(&mut self, n: u8, span: Span) -> Outcome {
        let kept = match self.st.spindles.get(&n) {
            Some(spindle) if n != self.st.master => spindle.kept,
            _ => n == self.st.master && self.st.speed_kept,
        };
        if !kept {
            return Ok(());
        }
        (self.st.constant_cut, self.st.speed_kept) = (false, false);
        self.unknown_speed(span, "the spindle starts without a speed: the one of before was a cutting speed (G96)")
    }

    fn speed(&mut self, s: SWord, constant: bool) -> Outcome {
        if s.value > 1e6 {
            return self.fail(codes::S2045, s.span, format!("the speed S{} is out of all range", s.value));
        }
        if s.value < 0.0 {
            let help = "the sense of rotation comes from M3 or M4";
            return self.fail_help(
                codes::S2045.alarm(14840),
                s.span,
                format!("the speed S{} is negative", s.value),
                help,
            );
        }
        match s.spindle {
            Some(n) if n != self.st.master => {
                self.spindle_number(n, s.span)?;
                let spindle = self.st.spindles.entry(n).or_default();
                (spindle.speed, spindle.kept) = (Some(s.value), false);
                let highest = spindle.highest;
                let limited = self.limited(s.value, highest, s.span);
                self.send_spindle(n, Spindle::Speed(limited));
            }
            _ if constant => {
                self.master_is_main(s.span, "the cutting speed of G96")?;
                let feet = self.st.feed_unit() != 1.0;
                self.st.speed = Some(if feet { s.value * 0.3048 } else { s.value });
                (self.st.constant_cut, self.st.speed_kept) = (true, false);
                self.send_cutting_speed();
            }
            _ => {
                self.st.speed = Some(s.value);
                (self.st.constant_cut, self.st.speed_kept) = (false, false);
                let limited = self.limited(s.value, self.limit_of_turns(), s.span);
                self.st.turns = Some(limited);
                self.send_spindle(self.st.master, Spindle::Speed(limited));
            }
        }
        Ok(())
    }

    /// The limit of a programmed speed: G26, and LIMS under G97.
    fn limit_of_turns(&self) -> Option<f64> {
        let lims = self.st.speed_limit.filter(|_| self.st.codes.of(Group::FeedType).ends_cutting_speed());
        [lims, self.st.highest_speed].into_iter().flatten().reduce(f64::min)
    }

    /// A speed as the spindle turns it.
    fn limited(&self, speed: f64, limit: Option<f64>, span: Span) -> f64 {
        match limit {
            Some(limit) if limit < speed => {
                let message = format!("the speed {speed} is above the limit {limit}, at which the spindle turns");
                let found = crate::diag::Diagnostic::new(codes::S8032, self.loc(span), message);
                let found = found.help("program a speed within the limit of LIMS= and G26");
                if !self.job.diags.knows(&found) {
                    self.report(found);
                }
                limit
            }
            _ => speed,
        }
    }

    /// LIMS= counts under G97, and no more under G94 and G95.
    fn feed_kind_limits_speed(&mut self, code: Code, span: Span) {
        let (Some(before), Some(speed), false) = (self.st.turns, self.st.speed, self.st.constant_cut) else { return };
        if self.limit_of_turns().map_or(speed, |limit| limit.min(speed)) == before {
            return;
        }
        self.limit_changed(span);
        if let Some(now) = self.st.turns.filter(|now| *now > before) {
            let code = code.word();
            let message = format!("LIMS= does not count under {code}: the spindle goes from {before} to {now} turns");
            let found = crate::diag::Diagnostic::new(codes::S8032, self.loc(span), message);
            self.report(found.help("program S with it, or limit the speed by G26 S"));
        }
    }

    /// G97 without S: the spindle keeps turning as fast as G96 has it turn at this place.
    fn freeze_speed(&mut self, span: Span) -> Outcome {
        if self.st.turn.is_none() {
            return Ok(());
        }
        let limits = [self.st.speed_limit, self.st.highest_speed];
        let limit = limits.into_iter().flatten().reduce(f64::min);
        let radius = self.job.settings.machine.diameter_axis.and_then(|axis| self.st.position.get(axis)).map(f64::abs);
        let free = match (self.st.speed, radius) {
            (Some(speed), Some(radius)) if radius > 1e-3 => {
                Some(libm::round(1000.0 * speed / (2.0 * std::f64::consts::PI * radius)))
            }
            _ => None,
        };
        let Some(turns) = [free, limit].into_iter().flatten().reduce(f64::min) else {
            (self.st.constant_cut, self.st.speed_kept) = (false, false);
            return self.unknown_speed(span, "G96 ends at a diameter at which its speed is not known");
        };
        let message = format!("G96 ends without S: the spindle goes on at about {turns} turns per minute");
        let found = crate::diag::Diagnostic::new(codes::S8046, self.loc(span), message);
        self.report(found.help("program S with G97"));
        self.st.turns = Some(turns);
        self.send_spindle(self.st.master, Spindle::Speed(turns));
        Ok(())
    }

    fn limit_changed(&mut self, span: Span) {
        if self.st.speed_kept {
            return;
        }
        if self.st.constant_cut {
            return self.send_cutting_speed();
        }
        let Some(speed) = self.st.speed else { return };
        let limited = self.limited(speed, self.limit_of_turns(), span);
        if self.st.turns.is_some_and(|turns| turns != limited) {
            self.st.turns = Some(limited);
            self.send_spindle(self.st.master, Spindle::Speed(limited));
        }
    }

    /// SPOS and SPOSA: the spindle stops at an angle.
    pub(super) fn spindle_position(&mut self, w: &mut Words) -> Outcome {
        let (spos, sposa) = (w.take(Address::Spos), w.take(Address::Sposa));
        let Some(given) = spos.or(sposa) else { return Ok(()) };
        if let (Some(_), Some(second)) = (spos, sposa) {
            return self.fail(codes::S2007.alarm(12000), second.span, "SPOS= and SPOSA= stand in one block");
        }
        let master = self.st.master;
        if let Some(m) = w.m.iter().find(|m| m.number == 19 && m.spindle.is_none_or(|n| n == master)) {
            let help = "leave M19 out: SPOS= says where the spindle stops";
            return self.fail_help(codes::S2045, m.span, "M19 and SPOS= stop the spindle in one block", help);
        }
        let from = match given.mode {
            Mode::Plain | Mode::Ac | Mode::Dc => 0.0,
            Mode::Acp | Mode::Acn => {
                let message = "the sense in which SPOS=ACP(…) and ACN(…) turn the spindle is not printed";
                self.note_once(codes::S8031, given.span, message);
                0.0
            }
            Mode::Ic => match self.st.spindle_angle {
                Some(angle) => angle,
                None => {
                    return self.fail_help(
                        codes::S2045,
                        given.span,
                        "where the spindle stands, from which SPOS=IC(…) counts, is not known",
                        "stop it by SPOS= at an angle first",
                    );
                }
            },
            _ => return self.does_not_fit(given.span),
        };
        let angle = from + given.value;
        let angle = angle - 360.0 * libm::floor(angle / 360.0);
        self.st.spindle_angle = Some(angle);
        self.st.turn = None;
        self.send_spindle(master, Spindle::Orient(angle));
        Ok(())
    }

    pub(super) fn spindle_number(&self, n: u8, span: Span) -> Outcome {
        if (1..=MOST_SPINDLES).contains(&n) {
            Ok(())
        } else {
            self.fail(codes::S2045, span, format!("there is no spindle {n}"))
        }
    }

    /// `LIMS=` of the master.
    pub(super) fn speed_limit(&mut self, lims: Given, speed_follows: bool) -> Outcome {
        self.check_limit(lims)?;
        self.st.speed_limit = Some(lims.value);
        if !speed_follows {
            self.limit_changed(lims.span);
        }
        Ok(())
    }

    /// `LIMS[n]=` of a spindle that is not the master: it counts when it becomes one.
    pub(super) fn speed_limit_of(&mut self, n: u8, lims: Given) -> Outcome {
        self.check_limit(lims)?;
        self.st.spindles.entry(n).or_default().limit = Some(lims.value);
        Ok(())
    }

    fn check_limit(&self, lims: Given) -> Outcome {
        if lims.value == 0.0 {
            let help = "give the highest speed in turns per minute: LIMS=2500";
            return self.fail_help(
                codes::S2045,
                lims.span,
                "the speed limit LIMS= is 0: the spindle would stand",
                help,
            );
        }
        if lims.value < 0.0 {
            return self.fail(codes::S2045.alarm(14820), lims.span, "the speed limit LIMS= is negative");
        }
        Ok(())
    }

    /// `G26 S3000`: the highest speed of a spindle.
    pub(super) fn highest_speed(&mut self, s: SWord) {
        match s.spindle {
            Some(n) if n != self.st.master => self.st.spindles.entry(n).or_default().highest = Some(s.value),
            _ => {
                self.st.highest_speed = Some(s.value);
                self.limit_changed(s.span);
            }
        }
    }

    fn send_cutting_speed(&mut self) {
        if let Some(speed) = self.st.speed {
            let limits = [self.st.speed_limit, self.st.highest_speed];
            let limit = limits.into_iter().flatten().reduce(f64::min);
            self.function(Function::Spindle(Spindle::CuttingSpeed { speed, limit }));
        }
    }

    /// SETMS: words without a spindle number go to spindle `n` from here on.
    pub(super) fn set_master(&mut self, n: u8, span: Span) -> Outcome {
        if n == self.st.master {
            return Ok(());
        }
        if self.st.constant_cut && self.st.turn.is_some() {
            return self.fail_help(
                codes::S2045,
                span,
                "the master spindle changes while it turns at a constant cutting speed",
                "stop it by M5, or program G97 with a speed, in front of SETMS",
            );
        }
        let st = &mut self.st;
        let old = SpindleState {
            speed: st.speed.filter(|_| !st.constant_cut),
            turn: st.turn,
            limit: st.speed_limit,
            highest: st.highest_speed,
            kept: st.constant_cut,
        };
        st.spindles.insert(st.master, old);
        let new = st.spindles.remove(&n).unwrap_or_default();
        (st.speed, st.turn, st.speed_limit, st.highest_speed) = (new.speed, new.turn, new.limit, new.highest);
        (st.constant_cut, st.speed_kept) = (new.kept, new.kept);
        st.master = n;
        (st.spindle_angle, st.turns) = (None, None);
        self.note_once(codes::S8014, span, format!("S and M words without a number go to spindle {n} from here on"));
        Ok(())
    }
}
