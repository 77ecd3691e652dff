//! Spindles: speed, sense of rotation, constant cutting speed.
//!
//! Source: S 2.15 (docs/sources.md).

use crate::diag::codes;
use crate::ir::Function;
use crate::ir::function::Spindle;
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::spindle_state::MAIN_SPINDLE;
use super::state::State;
use super::vocabulary::Address;
use super::words::{Given, MWord, Mode, SWord, Words};
use super::{Channel, Core, Outcome};

/// Highest spindle number that is a spindle.
const MOST_SPINDLES: u8 = 20;

impl State {
    /// The limit of a programmed speed: G26, and LIMS under G97.
    fn limit_of_turns(&self) -> Option<f64> {
        self.spindles.limit_of_turns(self.codes.of(Group::FeedType).ends_cutting_speed())
    }
}

impl Channel<'_> {
    /// A word for spindle `n`. The target knows the first one without a number.
    pub(super) fn send_spindle(&mut self, n: u8, spindle: Spindle) {
        if n == MAIN_SPINDLE {
            self.function(Function::Spindle(spindle));
        } else {
            self.function(Function::SpindleOf { number: n, spindle });
        }
    }

    /// Says once that a feed per revolution counts the turns of another spindle than the target's first one.
    pub(super) fn master_feeds(&self, place: impl Into<Where>) {
        let master = self.st.spindles.master();
        if master != MAIN_SPINDLE && !self.capture.is_some() {
            self.core.say_once(place, codes::S8253::feed_per_revolution_of_spindle(&master));
        }
    }

    /// Threads and cutting speed count with the turns of the master; the target counts those of its first spindle.
    pub(super) fn master_is_main(&self, place: impl Into<Where>, what: &str) -> Outcome {
        let master = self.st.spindles.master();
        if master == MAIN_SPINDLE {
            return Ok(());
        }
        self.core.refuse(place, codes::S9007::follows_spindle(&what, &master))
    }

    /// S words of a block.
    pub(super) fn speeds(&mut self, w: &Words) -> Outcome {
        let constant = self.st.codes.of(Group::FeedType).holds_cutting_speed();
        let masters = |s: &SWord| self.st.spindles.is_master(s.spindle);
        let given = w.s.iter().any(masters);
        if given {
            self.speed_lost = None;
        }
        if !given {
            let spindles = &mut self.st.spindles;
            if constant && spindles.keeps_speed() {
                // G96 again: the speed that the spindle kept is none in m/min.
                spindles.end_cutting_speed();
            } else if !constant && spindles.is_cutting() && !spindles.keeps_speed() {
                spindles.keep_speed();
                // Where M5 stops the spindle nothing goes on.
                let stops = |m: &MWord| m.number == 5 && self.st.spindles.is_master(m.spindle);
                if w.m.iter().any(stops) {
                    self.st.spindles.forget_turns();
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
        if !constant || self.st.spindles.is_cutting() {
            self.st.spindles.close_cut_speed();
        } else {
            let site = w.code_of(Group::FeedType).map(|(_, span)| span).unwrap_or_default();
            self.st.spindles.open_cut_speed(site);
        }
        Ok(())
    }

    /// Refuses a cut at a speed that a turning spindle kept since G96 and that is not known here.
    pub(super) fn speed_is_known(&mut self) -> Outcome {
        self.left_speed_is_known("this block cuts")?;
        if !self.st.spindles.turns_unknown() {
            return Ok(());
        }
        // Once is enough.
        self.st.spindles.end_cutting_speed();
        self.core.refuse(Where::Block, codes::S2045::block_cuts_at_speed_kept_since_g96())
    }

    /// Refuses what needs a speed where a left-out call leaves another one.
    pub(super) fn left_speed_is_known(&mut self, needs: &str) -> Outcome {
        let Some(lost) = self.speed_lost.take().filter(|_| !self.capture.is_some()) else { return Ok(()) };
        let (name, call) = *lost;
        self.core.refuse(Where::Block, codes::S2045::in_line_leaves_speed_that_is_not(&needs, &name, &call.line))
    }

    /// Refuses to start spindle `n` without a speed that is known.
    pub(super) fn start_is_known(&mut self, n: u8, span: Span) -> Outcome {
        if !self.st.spindles.kept_by(n) {
            return Ok(());
        }
        self.st.spindles.end_cutting_speed();
        self.core.refuse(span, codes::S2045::spindle_starts_without_speed())
    }

    fn speed(&mut self, s: SWord, constant: bool) -> Outcome {
        if s.value > 1e6 {
            return self.core.refuse(s.span, codes::S2045::speed_s_is_out_of_all_range(&s.value));
        }
        if s.value < 0.0 {
            return self.core.refuse(s.span, codes::S2045::speed_s_is_negative(&s.value));
        }
        match s.spindle {
            Some(n) if n != self.st.spindles.master() => {
                self.core.spindle_number(n, s.span)?;
                let highest = self.st.spindles.set_speed_of(n, s.value);
                let limited = self.core.limited(s.value, highest, s.span);
                self.send_spindle(n, Spindle::Speed(limited));
            }
            _ if constant => {
                self.master_is_main(s.span, "the cutting speed of G96")?;
                let feet = self.st.feed_unit() != 1.0;
                self.st.spindles.set_cutting_speed(if feet { s.value * 0.3048 } else { s.value });
                self.send_cutting_speed();
            }
            _ => {
                let limited = self.core.limited(s.value, self.st.limit_of_turns(), s.span);
                self.st.spindles.set_turns(s.value, limited);
                if !self.st.taps.take_speed() {
                    self.send_spindle(self.st.spindles.master(), Spindle::Speed(limited));
                }
            }
        }
        Ok(())
    }

    /// LIMS= counts under G97, and no more under G94 and G95.
    fn feed_kind_limits_speed(&mut self, code: GCode, span: Span) {
        let spindles = &self.st.spindles;
        let (Some(before), Some(speed), false) = (spindles.turns(), spindles.speed(), spindles.is_cutting()) else {
            return;
        };
        if self.st.limit_of_turns().map_or(speed, |limit| limit.min(speed)) == before {
            return;
        }
        self.limit_changed(span);
        if let Some(now) = self.st.spindles.turns().filter(|now| *now > before) {
            self.core.say(span, codes::S8032::lims_does_not_count(&code.word(), &before, &now));
        }
    }

    /// G97 without S: the spindle keeps turning as fast as G96 has it turn at this place.
    fn freeze_speed(&mut self, span: Span) -> Outcome {
        if self.st.spindles.turn().is_none() {
            return Ok(());
        }
        let limit = self.st.spindles.limit();
        let radius =
            self.core.job.settings.machine.diameter_axis.and_then(|axis| self.st.position.get(axis)).map(f64::abs);
        let free = match (self.st.spindles.speed(), radius) {
            (Some(speed), Some(radius)) if radius > 1e-3 => {
                Some(libm::round(1000.0 * speed / (2.0 * std::f64::consts::PI * radius)))
            }
            _ => None,
        };
        let Some(turns) = [free, limit].into_iter().flatten().reduce(f64::min) else {
            self.st.spindles.end_cutting_speed();
            return self.core.refuse(span, codes::S2045::g96_ends_at_unknown_diameter());
        };
        self.core.say(span, codes::S8046::g96_ends_without_s(&turns));
        self.st.spindles.print_turns(turns);
        self.send_spindle(self.st.spindles.master(), Spindle::Speed(turns));
        Ok(())
    }

    fn limit_changed(&mut self, span: Span) {
        if self.st.spindles.keeps_speed() {
            return;
        }
        if self.st.spindles.is_cutting() {
            return self.send_cutting_speed();
        }
        let Some(speed) = self.st.spindles.speed() else { return };
        let limited = self.core.limited(speed, self.st.limit_of_turns(), span);
        if self.st.spindles.turns().is_some_and(|turns| turns != limited) {
            self.st.spindles.print_turns(limited);
            self.send_spindle(self.st.spindles.master(), Spindle::Speed(limited));
        }
    }

    /// SPOS and SPOSA: the spindle stops at an angle.
    pub(super) fn spindle_position(&mut self, w: &mut Words) -> Outcome {
        let (spos, sposa) = (w.take(Address::Spos), w.take(Address::Sposa));
        let Some(given) = spos.or(sposa) else { return Ok(()) };
        if let (Some(_), Some(second)) = (spos, sposa) {
            return self.core.refuse(second.span, codes::P1002::spos_sposa_stand_in_one_block());
        }
        let master = self.st.spindles.master();
        if let Some(m) = w.m.iter().find(|m| m.number == 19 && m.spindle.is_none_or(|n| n == master)) {
            return self.core.refuse(m.span, codes::S2045::m19_spos_stop_spindle_in_one_block());
        }
        let from = match given.mode {
            Mode::Plain | Mode::Ac | Mode::Dc => 0.0,
            Mode::Acp | Mode::Acn => {
                self.sense_of_position_is_left_out(given.span);
                0.0
            }
            Mode::Ic => match self.st.spindles.angle() {
                Some(angle) => angle,
                None => {
                    return self.core.refuse(given.span, codes::S2045::where_spindle_stands_from_which_spos());
                }
            },
            _ => return self.core.does_not_fit(given.span),
        };
        let angle = from + given.value;
        let angle = angle - 360.0 * libm::floor(angle / 360.0);
        self.st.spindles.stop_at(angle);
        self.stops_at_angle(angle, w, 0);
        Ok(())
    }

    /// `SPOS[2]=90` of a spindle that is not the master.
    pub(super) fn spindle_position_of(&mut self, n: u8, given: Given) -> Outcome {
        self.core.spindle_number(n, given.span)?;
        match given.mode {
            Mode::Plain | Mode::Ac | Mode::Dc => {}
            Mode::Acp | Mode::Acn => self.sense_of_position_is_left_out(given.span),
            Mode::Ic => {
                return self.core.refuse(given.span, codes::S2045::where_spindle_stands(&n));
            }
            _ => return self.core.does_not_fit(given.span),
        }
        self.st.spindles.set_turn_of(n, None);
        self.send_spindle(n, Spindle::Orient(super::rotary::reduced(given.value)));
        Ok(())
    }

    fn sense_of_position_is_left_out(&self, span: Span) {
        self.core.say_once(span, codes::S8031::sense_in_which_spos_acp());
    }

    /// `LIMS=` of the master.
    pub(super) fn speed_limit(&mut self, lims: Given, speed_follows: bool) -> Outcome {
        self.core.check_limit("LIMS=", lims.value, lims.span)?;
        self.st.spindles.set_limit(None, lims.value);
        if !speed_follows {
            self.limit_changed(lims.span);
        }
        Ok(())
    }

    /// `LIMS[n]=` of a spindle that is not the master: it counts when it becomes one.
    pub(super) fn speed_limit_of(&mut self, n: u8, lims: Given) -> Outcome {
        self.core.check_limit("LIMS=", lims.value, lims.span)?;
        self.st.spindles.set_limit(Some(n), lims.value);
        Ok(())
    }

    /// `G26 S3000`: the highest speed of a spindle. `G25 S30` is the lowest one, which the target does not keep.
    pub(super) fn speed_range(&mut self, code: GCode, s: SWord) -> Outcome {
        if let Some(n) = s.spindle {
            self.core.spindle_number(n, s.span)?;
        }
        if code == GCode::G25 && s.value >= 0.0 {
            return Ok(());
        }
        self.core.check_limit(&format!("{} S", code.word()), s.value, s.span)?;
        self.st.spindles.set_highest(s.spindle, s.value);
        if self.st.spindles.is_master(s.spindle) {
            self.limit_changed(s.span);
        }
        Ok(())
    }

    fn send_cutting_speed(&mut self) {
        if let Some(speed) = self.st.spindles.speed() {
            let limit = self.st.spindles.limit();
            self.function(Function::Spindle(Spindle::CuttingSpeed { speed, limit }));
        }
    }

    /// SETMS: words without a spindle number go to spindle `n` from here on.
    pub(super) fn set_master(&mut self, n: u8, span: Span) -> Outcome {
        if n == self.st.spindles.master() {
            return Ok(());
        }
        if self.st.spindles.is_cutting() && self.st.spindles.turn().is_some() {
            return self.core.refuse(span, codes::S2045::master_spindle_changes_while_it_turns());
        }
        self.st.spindles.select_master(n);
        self.function(Function::FeedSpindle(n));
        self.core.say_once(span, codes::S8014::s_m_words_without_number_go(&n));
        Ok(())
    }
}

impl Core<'_> {
    /// A speed as the spindle turns it.
    fn limited(&self, speed: f64, limit: Option<f64>, span: Span) -> f64 {
        match limit {
            Some(limit) if limit < speed => {
                let found = codes::S8032::speed_is_above_limit(&speed, &limit).at(self.loc(span));
                if !self.job.diags.knows(&found) {
                    self.report(found);
                }
                limit
            }
            _ => speed,
        }
    }

    pub(super) fn spindle_number(&self, n: u8, span: Span) -> Outcome {
        if (1..=MOST_SPINDLES).contains(&n) { Ok(()) } else { self.refuse(span, codes::S2045::there_is_no_spindle(&n)) }
    }

    /// `words` name a speed limit of a spindle.
    fn check_limit(&self, words: &str, limit: f64, span: Span) -> Outcome {
        if limit == 0.0 {
            return self.refuse(span, codes::S2045::speed_limit_is_0(&words));
        }
        if limit < 0.0 {
            return self.refuse(span, codes::S2045::speed_limit_is_negative(&words));
        }
        Ok(())
    }
}
