//! M functions: what a block may hold of them, and what they do at its start and its end.
//!
//! Source: K 2.14 (docs/sources.md).

use crate::diag::{Answer, Help, codes};
use crate::ir::compensation::FeedAt;
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Function, Pos, Side};
use crate::machine::{AxisSet, Unit};
use crate::parser::klartext::ast::Block;
use crate::text::Span;

use super::active_tool::Change;
use super::m_table::{Act, Args, When, entry};
use super::place::View;
use super::state::State;
use super::words::{Admits, Comp, MWord, Words};
use super::{Core, Outcome, Run};

impl Run<'_> {
    /// The words of a block whose M functions may act; these have no place in it.
    pub(super) fn gather_m(
        &mut self,
        block: &Block,
        head: &str,
        admits: Admits,
        barred: &[u32],
    ) -> Outcome<Box<Words>> {
        let w = self.gather(block, head, admits)?;
        self.view().check_m(&w)?;
        w.forbid_m(&self.core, head, barred)?;
        Ok(w)
    }

    /// M functions that act at the start of the block. `moves` tells whether the block moves.
    pub(super) fn m_at_start(&mut self, w: &Words, moves: bool) -> Outcome {
        for m in w.m() {
            match entry(m.number) {
                Some((act, When::Start)) => self.act(act, m)?,
                Some((Act::ToolChange, When::End)) => self.st.tool.m6_at_end(),
                Some((_, When::End)) => {}
                None => {
                    if moves {
                        self.core.note(m.span, codes::P2008::m_is_printed_before_move(&m.number));
                    }
                    self.function(Function::Aux(m.number));
                }
            }
        }
        Ok(())
    }

    /// Those of `functions` that act at the end of the block, in their order.
    pub(super) fn m_at_end(&mut self, functions: &[MWord]) -> Outcome {
        // The end of the program comes last, wherever it stands in the block.
        for last in [false, true] {
            for m in functions {
                if let Some((act, When::End)) = entry(m.number)
                    && matches!(act, Act::ProgramEnd { .. }) == last
                {
                    self.act(act, m)?;
                }
            }
        }
        Ok(())
    }

    fn act(&mut self, act: Act, m: &MWord) -> Outcome {
        match act {
            Act::ProgramEnd { rewind } => return self.program_end(rewind),
            Act::ToolChange => return self.change_at(m.span, "this M6"),
            Act::FollowTip(on) if on || self.st.rotary.follows_tip => return self.follow_tip(on, m.span),
            Act::Retract => return self.retract(m),
            Act::EndRotation => return self.end_basic_rotation(m),
            Act::OptionalStop => self.function(Function::OptionalStop),
            Act::Stop => {
                let stopped = self.st.spindle.stop_all(&self.core, m.span);
                stopped.into_iter().flatten().for_each(|function| self.function(function));
                self.stop_program();
            }
            _ => {
                let switched = self.st.spindle.switch(act);
                switched.into_iter().flatten().for_each(|function| self.function(function));
                if !self.st.set_mode(&self.core, act, m)? {
                    self.noted.note(&self.core, m.number, m.span);
                }
            }
        }
        Ok(())
    }

    /// M128: as long as the rotary axes stand at zero the tool tip is where it would be without.
    fn follow_tip(&mut self, on: bool, span: Span) -> Outcome {
        if on && !self.st.tilt.is_upright() {
            return self.core.refuse(span, codes::K9008::m128_makes_control_follow_tool_tip());
        }
        if on && !self.st.rotary.stands_upright(&self.st.position, &self.st.ctx.frame) {
            return self.core.refuse(span, codes::K9008::m128_makes_control_follow_tool_tip());
        }
        if on {
            self.st.refuse_compensated(&mut self.core, "M128 begins");
        }
        self.st.rotary.follows_tip = on;
        Ok(())
    }

    /// The program stops: the axes may be moved by hand.
    fn stop_program(&mut self) {
        self.function(Function::Stop);
        self.st.position.stops();
    }

    /// M140: away from the workpiece along the tool axis, before the block moves.
    fn retract(&mut self, m: &MWord) -> Outcome {
        let Args { feed, value, max, .. } = m.args;
        if feed.is_some_and(|feed| feed <= 0.0) {
            return self.core.refuse(m.span, codes::O1001::feed_of_m140_is_not_above_zero());
        }
        let feed = feed.map(|f| self.st.feed.counted(f, self.core.unit()));
        let path = Path::straight(feed);
        if max {
            return self.retract_by("M140 MB MAX", None, path, m.span);
        }
        let way = value.unwrap_or(0.0);
        if way <= 0.0 {
            return self.core.refuse(m.span, codes::K2707::path_of_m140_is_not_above_zero());
        }
        self.retract_by("M140", Some(way), path, m.span)
    }

    /// Away from the workpiece along the tool axis, by `way` mm, or as far as the configuration says.
    pub(super) fn retract_by(&mut self, what: &str, way: Option<f64>, path: Path, span: Span) -> Outcome {
        let axis = self.st.axis();
        let mut end = Pos::UNKNOWN;
        let Some(way) = way else {
            let Some(top) = self.core.job.settings.control.retract_max else {
                let fault = codes::K2705::retracts_to_end(&what);
                return self.core.refuse(span, fault.answer(Answer::key("control", "retract_max")));
            };
            self.core.note(span, codes::K2704::goes_to_machine_coordinate(&what, &axis.letter(), &top));
            end.set(axis, top);
            let coords = Coords::Machine;
            self.forbid_open_approach()?;
            self.movement(&Move { end, path, side: self.st.compensation.side(), coords });
            self.moved_by_machine(&end);
            return Ok(());
        };
        // The path is a real one: no scaling acts on it, and it leads away from the workpiece.
        let column = self.st.ctx.frame.linear().column(axis.index()).into_owned();
        let factor = column[axis.index()];
        if !(factor > 0.0 && AxisSet::MAIN.iter().all(|other| other == axis || column[other.index()] == 0.0)) {
            return self.core.refuse(span, codes::K9008::m140_retracts_along(&axis.letter()));
        }
        let from = match self.st.position.get(axis) {
            Some(from) => from,
            None => self.view().position_of(axis, span, what)?,
        };
        end.set(axis, from + way / factor);
        self.send(&end, path);
        Ok(())
    }

    /// STOP with its M functions. STOP itself does not stop the spindle.
    pub(super) fn stop_block(&mut self, block: &Block) -> Outcome {
        let w = self.gather_m(block, "STOP", Admits::M, &[89, 91, 92, 99])?;
        self.m_at_start(&w, false)?;
        self.m_at_end(w.m())?;
        if !w.has_m(0) && !self.core.has_ended() {
            self.stop_program();
        }
        Ok(())
    }
}

impl State {
    /// Carries out what M functions switch of feed, rotary axes and compensation. False for one that changes nothing.
    fn set_mode(&mut self, core: &Core<'_>, act: Act, m: &MWord) -> Outcome<bool> {
        let changes = match act {
            Act::EdgeFeed(at) => at != FeedAt::Centre || self.feed.at != at,
            Act::RotaryFeed(on) => on || self.feed.at_surface,
            Act::ShortWay(on) => on || self.rotary.short_way,
            Act::PerRevolution(on) => on || self.feed.is_per_revolution(),
            Act::ModuloRotary => self.rotary.reduce(&self.position, m.args.axes),
            Act::PlungeShare => self.feed.share_plunges(core, m)?,
            Act::Note | Act::FollowTip(_) => false,
            Act::ShortPoints | Act::CompensationOnly | Act::LookAhead => true,
            // They are carried out elsewhere.
            Act::Spindle(_)
            | Act::SpindleAndCoolant(_)
            | Act::SpindleStop
            | Act::CoolantOn
            | Act::CoolantOff
            | Act::Stop
            | Act::OptionalStop
            | Act::ProgramEnd { .. }
            | Act::ToolChange
            | Act::Orient
            | Act::Block
            | Act::Retract
            | Act::EndRotation
            | Act::Refused => return Ok(true),
        };
        match act {
            _ if !changes => {}
            Act::EdgeFeed(at) => {
                self.feed.at = at;
                self.contour.modal_rules(&mut self.ctx, at);
            }
            Act::RotaryFeed(on) => self.feed.at_surface = on,
            Act::ShortWay(on) => self.rotary.short_way = on,
            Act::PerRevolution(true) if core.unit() == Unit::Inch => {
                return core.refuse(m.span, codes::K9008::unit_of_f_under_m136_in_inch());
            }
            Act::PerRevolution(on) => self.feed.switch(on),
            Act::ShortPoints => core.say(m.span, codes::K2804::m124_leaves_out_points_on_control()),
            Act::CompensationOnly | Act::LookAhead if core.computes_path() && self.compensation.is_on() => {}
            Act::CompensationOnly | Act::LookAhead => {
                core.say(m.span, codes::K2703::m_has_no_word_in_output(&m.number));
            }
            _ => {}
        }
        Ok(changes)
    }
}

impl View<'_, '_> {
    /// Refuses M functions that no path can be computed with, before anything of the block acts.
    pub(super) fn check_m(&self, w: &Words) -> Outcome {
        self.no_m_in_contour(w)?;
        let compensated = self.st.compensation.is_on() || matches!(w.comp, Some(Comp::Side(Side::Left | Side::Right)));
        for m in w.m() {
            match entry(m.number) {
                Some((Act::Refused, _)) => {
                    let (what, help) = refusal(m.number);
                    return self.core.refuse(m.span, codes::K9008::m(&m.number, &what).help(help));
                }
                Some(_)
                    if m.number == 130
                        && (self.st.frames.transform().turn.0 != 0.0 || self.st.tilt.plane().is_some()) =>
                {
                    return self.core.refuse(m.span, codes::K9008::m130_takes_this_block_out_of_working());
                }
                Some((Act::CompensationOnly | Act::LookAhead, _))
                    if compensated && acts(m) && !self.core.computes_path() =>
                {
                    return self.core.refuse(m.span, codes::K9008::m_changes_compensated_path(&m.number));
                }
                Some(_) => {}
                None if self.core.job.settings.output.pass_m.contains(&m.number) => {}
                None => {
                    let fault = codes::P2007::m_is_function_of_machine_builder(&m.number);
                    return self.core.refuse(m.span, fault.help(self.may_be_passed(m.number)));
                }
            }
        }
        Ok(())
    }

    /// What to say of a function of the machine builder.
    fn may_be_passed(&self, number: u32) -> Help {
        let usual = format!("if the target machine understands it, add `[output] pass_m = [{number}]`");
        match self.st.tool.change {
            Change::Called { .. } | Change::Printed { moved: false } => Answer::pass_m(number)
                .help(format!(
                    "if it changes to the tool of the TOOL CALL, say so: `[control] tool_change_m = [{number}]`; {usual}"
                ))
                .and(Answer::changing_m(number)),
            _ => Answer::pass_m(number).help(usual),
        }
    }

    /// Refuses what says how a block moves, in a contour that is only described.
    fn no_m_in_contour(&self, w: &Words) -> Outcome {
        let Some(label) = &self.st.described else { return Ok(()) };
        let paraxial = matches!(w.comp, Some(Comp::Paraxial(_))).then_some(w.comp_span);
        let speed = w.speed.map(|_| w.speed_span);
        let Some(span) = w.m().first().map(|m| m.span).or(speed).or(paraxial) else { return Ok(()) };
        self.core.refuse(span, codes::K2951::stands_in_contour(&self.core.word_text(span), &label))
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
