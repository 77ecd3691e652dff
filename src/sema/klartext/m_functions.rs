//! M functions: one table says what each does, when it acts, and what it takes.
//!
//! Source: K 2.14 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::compensation::FeedAt;
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::{Function, Side};
use crate::machine::Unit;
use crate::sema::common::m_functions::end_last;
use crate::text::Span;

use super::active_tool::Change;
use super::m_table::{Act, When, entry};
use super::words::{Comp, MWord, Words};
use super::{Outcome, Run};

/// What the program told the spindle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SpindleState {
    turn: Option<Turn>,
    /// The sense in which it turned last.
    used: Option<Turn>,
    speed: Option<f64>,
    /// Angle of cycle 13.
    orientation: Option<f64>,
}

impl SpindleState {
    /// Sense of rotation, while it turns.
    pub fn turn(&self) -> Option<Turn> {
        self.turn
    }

    pub fn turns(&self) -> bool {
        self.turn.is_some()
    }

    /// The sense in which it turned last.
    pub fn used(&self) -> Option<Turn> {
        self.used
    }

    pub fn speed(&self) -> Option<f64> {
        self.speed
    }

    pub fn start(&mut self, turn: Turn) {
        (self.turn, self.used) = (Some(turn), Some(turn));
    }

    pub fn stop(&mut self) {
        self.turn = None;
    }

    pub fn set_speed(&mut self, speed: f64) {
        self.speed = Some(speed);
    }

    /// Cycle 13: where M19 stops the spindle.
    pub fn orient(&mut self, angle: f64) {
        self.orientation = Some(angle);
    }
}

impl Run<'_> {
    /// Refuses M functions that no path can be computed with, before anything of the block acts.
    pub(super) fn check_m(&mut self, w: &Words) -> Outcome {
        self.no_m_in_contour(w)?;
        let compensated = self.st.compensation.is_on() || matches!(w.comp, Some(Comp::Side(Side::Left | Side::Right)));
        for m in w.m() {
            match entry(m.number) {
                Some((Act::Refused, _)) => {
                    let (what, help) = refusal(m.number);
                    return self.core.refuse(m.span, codes::K9008::m(&m.number, &what).help(help));
                }
                Some(_) if m.number == 130 && self.st.frames.transform().turn.0 != 0.0 => {
                    return self.core.refuse(m.span, codes::K9008::m130_takes_this_block_out_of_working());
                }
                Some((Act::CompensationOnly | Act::LookAhead, _))
                    if compensated && acts(m) && !self.computes_path() =>
                {
                    return self.core.refuse(m.span, codes::K9008::m_changes_compensated_path(&m.number));
                }
                Some(_) => {}
                None if self.core.job.settings.output.pass_m.contains(&m.number) => {}
                None => {
                    let number = m.number;
                    let usual = format!("if the target machine understands it, add `[output] pass_m = [{number}]`");
                    let help = match self.st.tool.change {
                        Change::Called { .. } | Change::Printed { moved: false } => Answer::pass_m(number)
                            .help(format!(
                                "if it changes to the tool of the TOOL CALL, say so: `[control] tool_change_m = [{number}]`; {usual}"
                            ))
                            .and(Answer::changing_m(number)),
                        _ => Answer::pass_m(number).help(usual),
                    };
                    return self
                        .core
                        .refuse(m.span, codes::P2007::m_is_function_of_machine_builder(&number).help(help));
                }
            }
        }
        Ok(())
    }

    /// Refuses M functions that say how or where a block moves, in a block that does not.
    pub(super) fn forbid_m(&mut self, w: &Words, head: &str, numbers: &[u32]) -> Outcome {
        let Some(m) = w.any_m(numbers) else { return Ok(()) };
        self.core.refuse(m.span, codes::P1003::m_has_no_place_in_block(&m.number, &head))
    }

    /// M functions that act at the start of the block. `moves` tells whether the block moves.
    pub(super) fn m_at_start(&mut self, w: &Words, moves: bool) -> Outcome {
        for m in w.m() {
            match entry(m.number) {
                Some((act, When::Start)) => self.act(act, m)?,
                Some((Act::ToolChange, When::End)) => self.st.m6_at_end(),
                Some((_, When::End)) => {}
                None => {
                    if moves {
                        self.core
                            .job
                            .diags
                            .push_once(codes::P2008::m_is_printed_before_move(&m.number).at(self.core.loc(m.span)));
                    }
                    self.function(Function::Aux(m.number));
                }
            }
        }
        Ok(())
    }

    pub(super) fn m_at_end(&mut self, w: &Words) -> Outcome {
        self.these_at_end(w.m())
    }

    /// Those that act at the end of the block, in their order.
    pub(super) fn these_at_end(&mut self, functions: &[MWord]) -> Outcome {
        for m in end_last(functions, |m| matches!(entry(m.number), Some((Act::ProgramEnd { .. }, _)))) {
            if let Some((act, When::End)) = entry(m.number) {
                self.act(act, &m)?;
            }
        }
        Ok(())
    }

    fn act(&mut self, act: Act, m: &MWord) -> Outcome {
        match act {
            Act::Spindle(turn) => self.start_spindle(turn),
            Act::SpindleAndCoolant(turn) => {
                self.start_spindle(turn);
                self.coolant(true);
            }
            Act::SpindleStop => self.stop_spindle(),
            Act::CoolantOn => self.coolant(true),
            Act::CoolantOff => self.coolant(false),
            Act::Stop => self.stop_all(m.span),
            Act::OptionalStop => self.function(Function::OptionalStop),
            Act::ProgramEnd { rewind } => return self.program_end(rewind),
            Act::ToolChange => return self.m6(m.span),
            Act::Orient => {
                let angle = self.st.spindle.orientation.unwrap_or(0.0);
                self.st.spindle.stop();
                self.function(Function::Spindle(Spindle::Orient(angle)));
            }
            Act::PlungeShare => return self.share_plunges(m),
            Act::EdgeFeed(FeedAt::Centre) if self.st.feed.at == FeedAt::Centre => self.note_m(m),
            Act::RotaryFeed(false) if !self.st.feed.at_surface => self.note_m(m),
            Act::ShortWay(false) if !self.st.rotary.short_way => self.note_m(m),
            Act::PerRevolution(false) if !self.st.feed.is_per_revolution() => self.note_m(m),
            Act::FollowTip(false) if !self.st.rotary.follows_tip => self.note_m(m),
            Act::EdgeFeed(at) => {
                self.st.feed.at = at;
                self.st.modal_rules();
            }
            Act::RotaryFeed(on) => self.st.feed.at_surface = on,
            Act::ShortWay(on) => self.st.rotary.short_way = on,
            Act::PerRevolution(on) => {
                if on && self.core.level().frame.unit == Unit::Inch {
                    return self.core.refuse(m.span, codes::K9008::unit_of_f_under_m136_in_inch());
                }
                self.st.feed.switch(on);
            }
            Act::FollowTip(on) => return self.follow_tip(on, m.span),
            Act::ModuloRotary => {
                if !self.st.rotary.reduce(&self.st.position, m.args.axes) {
                    self.note_m(m);
                }
            }
            Act::Retract => return self.retract(m),
            Act::EndRotation => return self.end_basic_rotation(m),
            Act::Note => self.note_m(m),
            Act::ShortPoints => {
                self.core.report(codes::K2804::m124_leaves_out_points_on_control().at(self.core.loc(m.span)))
            }
            Act::CompensationOnly | Act::LookAhead if self.computes_path() && self.st.compensation.is_on() => {}
            Act::CompensationOnly | Act::LookAhead => {
                self.core.report(codes::K2703::m_has_no_word_in_output(&m.number).at(self.core.loc(m.span)));
            }
            Act::Block | Act::Refused => {}
        }
        Ok(())
    }

    /// M103: plunges run at a share of the feed.
    fn share_plunges(&mut self, m: &MWord) -> Outcome {
        if let Some(share) = m.args.feed
            && !(share > 0.0 && share <= 100.0)
        {
            return self.core.refuse(m.span, codes::K2707::m103_f_is_no_share_of_feed(&share));
        }
        if m.args.feed.is_none() && self.st.feed.plunge_share().is_none() {
            self.note_m(m);
        }
        self.st.feed.share_plunges(m.args.feed.map(|percent| percent / 100.0));
        Ok(())
    }

    /// Says once of each function that it is left out.
    pub(super) fn note_m(&mut self, m: &MWord) {
        if self.noted.contains(&m.number) {
            return;
        }
        self.noted.push(m.number);
        let what = match m.number {
            91 | 92 => "stands in a block without coordinates, and has",
            94 => "finds no rotary axis beyond a turn, and has",
            103 | 111 | 117 | 127 | 129 | 137 => "switches off what is not on, and has",
            _ => "has",
        };
        self.core.report(codes::K2703::m_no_word_in_output(&m.number, &what).at(self.core.loc(m.span)));
    }

    pub(super) fn start_spindle(&mut self, turn: Turn) {
        self.st.spindle.start(turn);
        self.function(Function::Spindle(Spindle::Start(turn)));
    }

    pub(super) fn stop_spindle(&mut self) {
        self.st.spindle.stop();
        self.function(Function::Spindle(Spindle::Stop));
    }

    fn coolant(&mut self, on: bool) {
        self.st.coolant = on;
        self.function(Function::Coolant(if on { Coolant::Flood } else { Coolant::Off }));
    }

    /// M0: program stop, spindle stop, coolant off.
    fn stop_all(&mut self, span: Span) {
        if self.st.spindle.turns() || self.st.coolant {
            let what = match (self.st.spindle.turns(), self.st.coolant) {
                (true, true) => "the spindle and the coolant",
                (true, false) => "the spindle",
                _ => "the coolant",
            };
            self.core.report(codes::K2708::m0_also_stops(&what).at(self.core.loc(span)));
        }
        if self.st.spindle.turns() {
            self.stop_spindle();
        }
        if self.st.coolant {
            self.coolant(false);
        }
        self.function(Function::Stop);
        self.st.position.stops();
    }

    /// STOP with its M functions. STOP itself does not stop the spindle.
    pub(super) fn stop_block(&mut self, block: &crate::parser::klartext::ast::Block) -> Outcome {
        let w = self.gather(block, "STOP", super::words::Admits::M)?;
        self.check_m(&w)?;
        self.forbid_m(&w, "STOP", &[89, 91, 92, 99])?;
        self.m_at_start(&w, false)?;
        if w.has_m(0) {
            return self.m_at_end(&w);
        }
        self.m_at_end(&w)?;
        if !self.core.has_ended() {
            self.function(Function::Stop);
            self.st.position.stops();
        }
        Ok(())
    }
}

/// Does the function switch something on? `M120` without LA, or with LA0, switches off.
fn acts(m: &MWord) -> bool {
    m.number != 120 || m.args.value.is_some_and(|blocks| blocks != 0.0)
}

/// Why an M function is refused, and what to do.
fn refusal(number: u32) -> (&'static str, &'static str) {
    match number {
        93 | 95 | 96 => ("is an approach function of old controls", "program the approach as blocks"),
        104 => ("sets the workpiece datum back", "select the datum with cycle 247"),
        114 | 144 => {
            ("makes the control follow the tool tip with the rotary axes", "use 3-axis output of the CAM system")
        }
        _ => ("resets functions that partc cannot know of", "reset them one by one"),
    }
}
