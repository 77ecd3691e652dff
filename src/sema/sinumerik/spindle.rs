//! Spindles: speed, sense of rotation, constant cutting speed.
//!
//! Source: S 2.15 (docs/sources.md).

use crate::diag::codes;
use crate::ir::Function;
use crate::ir::function::Spindle;
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::rotary::reduced;
use super::spindle_state::{MAIN_SPINDLE, Spindles};
use super::vocabulary::Address;
use super::words::{Given, MWord, Mode, SWord, Words, misfit};
use super::{Channel, Core, Outcome, State};

/// Highest spindle number that is a spindle.
const MOST_SPINDLES: u8 = 20;

impl Spindles {
    /// A word for the master.
    pub fn function(&self, spindle: Spindle) -> Function {
        function_of(self.master(), spindle)
    }

    /// The cutting speed of the master within its limit.
    fn cutting_speed(&self) -> Option<Function> {
        let speed = self.speed()?;
        Some(Function::Spindle(Spindle::CuttingSpeed { speed, limit: self.limit() }))
    }

    /// Threads and cutting speed count with the turns of the master; the target counts those of its first spindle.
    pub fn master_is_main(&self, core: &Core<'_>, place: impl Into<Where>, what: &str) -> Outcome {
        let master = self.master();
        if master == MAIN_SPINDLE {
            return Ok(());
        }
        core.refuse(place, codes::S9007::follows_spindle(&what, &master))
    }

    /// Refuses a cut at a speed that a turning spindle kept since G96 and that is not known here.
    fn kept_speed_is_known(&mut self, core: &Core<'_>) -> Outcome {
        if !self.turns_unknown() {
            return Ok(());
        }
        // Once is enough.
        self.end_cutting_speed();
        core.refuse(Where::Block, codes::S2045::block_cuts_at_speed_kept_since_g96())
    }

    /// Refuses to start spindle `n` without a speed that is known.
    pub fn start_is_known(&mut self, core: &Core<'_>, n: u8, span: Span) -> Outcome {
        if !self.kept_by(n) {
            return Ok(());
        }
        self.end_cutting_speed();
        core.refuse(span, codes::S2045::spindle_starts_without_speed())
    }

    /// G97 without S: the spindle keeps turning as fast as G96 has it turn at this place, `radius` from the middle.
    fn freeze_speed(&mut self, core: &Core<'_>, radius: Option<f64>, span: Span) -> Outcome<Option<Function>> {
        if self.turn().is_none() {
            return Ok(None);
        }
        let free = match (self.speed(), radius) {
            (Some(speed), Some(radius)) if radius > 1e-3 => {
                Some(libm::round(1000.0 * speed / (2.0 * std::f64::consts::PI * radius)))
            }
            _ => None,
        };
        let Some(turns) = [free, self.limit()].into_iter().flatten().reduce(f64::min) else {
            self.end_cutting_speed();
            return core.refuse(span, codes::S2045::g96_ends_at_unknown_diameter());
        };
        core.say(span, codes::S8046::g96_ends_without_s(&turns));
        self.print_turns(turns);
        Ok(Some(self.function(Spindle::Speed(turns))))
    }

    /// A limit of the master is another one, or counts otherwise.
    fn limit_changed(&mut self, core: &Core<'_>, lims_counts: bool, span: Span) -> Option<Function> {
        if self.keeps_speed() {
            return None;
        }
        if self.is_cutting() {
            return self.cutting_speed();
        }
        let limited = core.limited(self.speed()?, self.limit_of_turns(lims_counts), span);
        self.turns().filter(|turns| *turns != limited)?;
        self.print_turns(limited);
        Some(self.function(Spindle::Speed(limited)))
    }

    /// SPOS and SPOSA: the angle at which the spindle stops.
    pub fn position(&mut self, core: &Core<'_>, w: &mut Words) -> Outcome<Option<f64>> {
        let (spos, sposa) = (w.take(Address::Spos), w.take(Address::Sposa));
        let Some(given) = spos.or(sposa) else { return Ok(None) };
        if let (Some(_), Some(second)) = (spos, sposa) {
            return core.refuse(second.span, codes::P1002::spos_sposa_stand_in_one_block());
        }
        let master = self.master();
        if let Some(m) = w.m.iter().find(|m| m.number == 19 && m.spindle.is_none_or(|n| n == master)) {
            return core.refuse(m.span, codes::S2045::m19_spos_stop_spindle_in_one_block());
        }
        let from = match given.mode {
            Mode::Ic => match self.angle() {
                Some(angle) => angle,
                None => {
                    return core.refuse(given.span, codes::S2045::where_spindle_stands_from_which_spos());
                }
            },
            _ => core.absolute_position(given)?,
        };
        let angle = reduced(from + given.value);
        self.stop_at(angle);
        Ok(Some(angle))
    }

    /// `SPOS[2]=90` of a spindle that is not the master.
    pub fn position_of(&mut self, core: &Core<'_>, n: u8, given: Given) -> Outcome<Function> {
        core.spindle_number(n, given.span)?;
        if given.mode == Mode::Ic {
            return core.refuse(given.span, codes::S2045::where_spindle_stands(&n));
        }
        core.absolute_position(given)?;
        self.set_turn_of(n, None);
        Ok(function_of(n, Spindle::Orient(reduced(given.value))))
    }

    /// `LIMS=` of the master, or `LIMS[n]=` of a spindle that is none: it counts when it becomes one.
    pub fn speed_limit(&mut self, core: &Core<'_>, n: Option<u8>, lims: Given) -> Outcome {
        core.check_limit("LIMS=", lims.value, lims.span)?;
        self.set_limit(n, lims.value);
        Ok(())
    }

    /// `G26 S3000`: the highest speed of a spindle. `G25 S30` is the lowest one, which the target does not keep.
    pub fn speed_range(
        &mut self,
        core: &Core<'_>,
        code: GCode,
        s: SWord,
        lims_counts: bool,
    ) -> Outcome<Option<Function>> {
        if let Some(n) = s.spindle {
            core.spindle_number(n, s.span)?;
        }
        if code == GCode::G25 && s.value >= 0.0 {
            return Ok(None);
        }
        core.check_limit(&format!("{} S", code.word()), s.value, s.span)?;
        self.set_highest(s.spindle, s.value);
        Ok(if self.is_master(s.spindle) { self.limit_changed(core, lims_counts, s.span) } else { None })
    }
}

impl State {
    /// Says once that a feed per revolution counts the turns of another spindle than the target's first one.
    pub fn master_feeds(&self, core: &Core<'_>, place: impl Into<Where>) {
        let master = self.spindles.master();
        if master != MAIN_SPINDLE && !self.describes {
            core.say_once(place, codes::S8253::feed_per_revolution_of_spindle(&master));
        }
    }
}

/// A word for spindle `n`. The target knows the first one without a number.
pub(super) fn function_of(n: u8, spindle: Spindle) -> Function {
    if n == MAIN_SPINDLE { Function::Spindle(spindle) } else { Function::SpindleOf { number: n, spindle } }
}

impl Channel<'_> {
    /// LIMS and the S words of a block.
    pub(super) fn speeds(&mut self, w: &mut Words) -> Outcome {
        let kind = self.st.codes.of(Group::FeedType);
        let (constant, lims_counts) = (kind.holds_cutting_speed(), kind.ends_cutting_speed());
        let core = &self.core;
        let spindles = &mut self.st.spindles;
        if let Some(lims) = w.take(Address::Lims) {
            spindles.speed_limit(core, None, lims)?;
            let changed = if w.s.is_empty() { spindles.limit_changed(core, lims_counts, lims.span) } else { None };
            self.function(changed);
        }
        let given = w.s.iter().any(|s: &SWord| self.st.spindles.is_master(s.spindle));
        let kind_of_block = w.code_of(Group::FeedType);
        let site = kind_of_block.map(|(_, span)| span).unwrap_or_default();
        if given {
            self.left.speed = None;
        } else if !self.kind_keeps_speed(w, constant, site)?
            && let Some((code, span)) = kind_of_block
        {
            self.feed_kind_limits_speed(code, lims_counts, span);
        }
        for at in 0..w.s.len() {
            self.speed(w.s[at], constant, lims_counts)?;
        }
        if !constant || self.st.spindles.is_cutting() {
            self.st.spindles.close_cut_speed();
        } else {
            self.st.spindles.open_cut_speed(site);
        }
        Ok(())
    }

    /// A block without S under another kind of feed: the spindle goes on as it turns. True where the block stops it.
    fn kind_keeps_speed(&mut self, w: &Words, constant: bool, site: Span) -> Outcome<bool> {
        let spindles = &mut self.st.spindles;
        if constant && spindles.keeps_speed() {
            // G96 again: the speed that the spindle kept is none in m/min.
            spindles.end_cutting_speed();
        } else if !constant && spindles.is_cutting() && !spindles.keeps_speed() {
            spindles.keep_speed();
            // Where M5 stops the spindle nothing goes on.
            if w.m.iter().any(|m: &MWord| m.number == 5 && spindles.is_master(m.spindle)) {
                spindles.forget_turns();
                return Ok(true);
            }
            let axis = self.core.job.settings.machine.diameter_axis;
            let radius = axis.and_then(|axis| self.st.position.get(axis)).map(f64::abs);
            let frozen = spindles.freeze_speed(&self.core, radius, site)?;
            self.function(frozen);
        }
        Ok(false)
    }

    /// Refuses a cut at a speed that is not known.
    pub(super) fn speed_is_known(&mut self) -> Outcome {
        self.left.speed_is_known(&self.core, self.capture.is_some(), "this block cuts")?;
        self.st.spindles.kept_speed_is_known(&self.core)
    }

    fn speed(&mut self, s: SWord, constant: bool, lims_counts: bool) -> Outcome {
        if s.value > 1e6 {
            return self.core.refuse(s.span, codes::S2045::speed_s_is_out_of_all_range(&s.value));
        }
        if s.value < 0.0 {
            return self.core.refuse(s.span, codes::S2045::speed_s_is_negative(&s.value));
        }
        let (core, spindles) = (&self.core, &mut self.st.spindles);
        let made = match s.spindle {
            Some(n) if n != spindles.master() => {
                core.spindle_number(n, s.span)?;
                let highest = spindles.set_speed_of(n, s.value);
                Some(function_of(n, Spindle::Speed(core.limited(s.value, highest, s.span))))
            }
            _ if constant => {
                spindles.master_is_main(core, s.span, "the cutting speed of G96")?;
                let feet = self.st.codes.feed_unit(self.st.machine.basic_unit) != 1.0;
                spindles.set_cutting_speed(if feet { s.value * 0.3048 } else { s.value });
                spindles.cutting_speed()
            }
            _ => {
                let limited = core.limited(s.value, spindles.limit_of_turns(lims_counts), s.span);
                spindles.set_turns(s.value, limited);
                (!self.st.taps.take_speed()).then(|| spindles.function(Spindle::Speed(limited)))
            }
        };
        self.function(made);
        Ok(())
    }

    /// LIMS= counts under G97, and no more under G94 and G95.
    fn feed_kind_limits_speed(&mut self, code: GCode, lims_counts: bool, span: Span) {
        let spindles = &mut self.st.spindles;
        let (Some(before), Some(speed), false) = (spindles.turns(), spindles.speed(), spindles.is_cutting()) else {
            return;
        };
        if spindles.limit_of_turns(lims_counts).map_or(speed, |limit| limit.min(speed)) == before {
            return;
        }
        let changed = spindles.limit_changed(&self.core, lims_counts, span);
        self.function(changed);
        if let Some(now) = self.st.spindles.turns().filter(|now| *now > before) {
            self.core.say(span, codes::S8032::lims_does_not_count(&code.word(), &before, &now));
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
                self.report_new(found);
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

    /// The angle counts as it is given; in which sense the spindle goes there is left out.
    fn absolute_position(&self, given: Given) -> Outcome<f64> {
        match given.mode {
            Mode::Plain | Mode::Ac | Mode::Dc => {}
            Mode::Acp | Mode::Acn => self.say_once(given.span, codes::S8031::sense_in_which_spos_acp()),
            _ => return self.refuse(given.span, misfit()),
        }
        Ok(0.0)
    }
}
