//! Technology: feed, spindle, tool, M functions, compensation, work offsets.
//!
//! Source: S 0, 2.12, 2.15, 4.7 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::{Function, Side};

use super::spindle::function_of;
use super::vocabulary::Address;
use super::words::{MWord, Words};
use super::{Channel, Core, Outcome, levels};

/// M functions of a block.
const MOST_M: usize = 5;
/// S words of a block (S 1.2).
const MOST_S: usize = 3;

impl Channel<'_> {
    /// An M function that stops the program or ends it. True if it ends a program that another one called.
    pub(super) fn late_function(&mut self, m: MWord) -> Outcome<bool> {
        if !matches!(m.number, 0..=2 | 17 | 30) {
            return Ok(false);
        }
        self.tapping_ends();
        match m.number {
            0 => self.function(Function::Stop),
            1 => self.function(Function::OptionalStop),
            _ => {
                self.core.end_is_whole();
                if !levels::in_main(&self.core.levels) {
                    return Ok(true);
                }
                if self.capture.as_ref().is_some_and(|capture| capture.ends_program(&self.core)) {
                    return Err(super::Reported);
                }
                let done = self.pending_must_be_done(m.span);
                self.function(Function::End { rewind: m.number == 30 });
                self.core.stop_run();
                done?;
            }
        }
        Ok(false)
    }

    // F, S, T, D.

    pub(super) fn technology(&mut self, w: &mut Words) -> Outcome {
        if let Some(f) = w.take(Address::F) {
            if f.value <= 0.0 {
                self.st.feed.lose();
                return self.core.refuse(f.span, codes::P2003::feed_f_is_not_above_0(&f.value));
            }
            w.feed_given = true;
            self.st.feed.program(self.st.feed_of(f.value));
        }
        // Feeds of positioning axes hold on.
        self.st.feed.program_axes(&w.beside.feeds);
        if let Some(t) = w.take(Address::T) {
            self.tool_word_given(t, w)?;
        }
        if let Some(d) = w.take(Address::D) {
            if let Some(h) = w.h {
                return self.core.refuse(h, codes::P1003::d_h_stand_in_one_block());
            }
            // The edge is that of the tool that M6 brings.
            if w.m.iter().any(|m| m.number == 6) {
                w.edge_of_new_tool = Some(d);
            } else {
                self.st.select_edge(&self.core, d.value, d.span)?;
            }
        }
        let shaped = w.get(Address::Offn).is_some() || w.get(Address::Disc).is_some();
        if shaped {
            let is_on = self.st.side() != Side::None && !self.st.compensation.waits();
            self.st.path.shape(&self.core, w, self.st.codes.length_unit(), is_on)?;
        }
        if let Some(span) = self.st.compensation.take_open(w.edge_of_new_tool.is_some()) {
            let selected = self.select_cutter(span);
            if selected.is_err() {
                // It does not come into force.
                self.st.compensation.end(&mut self.st.codes);
            }
            selected?;
        }
        self.speeds(w)?;
        if let Some(angle) = self.st.spindles.position(&self.core, w)? {
            self.stops_at_angle(angle, w, 0);
        }
        no_other_offset(&self.core, w)?;
        if self.st.path.is_computed() && (!w.codes.is_empty() || shaped) {
            self.st.rules_change(&self.core, w)?;
        }
        if let Some(span) = w.h {
            self.core.say_once(span, codes::S8005::h_functions_are_for_machines_own_control());
        }
        Ok(())
    }

    // M functions.

    /// What acts in front of the motion.
    pub(super) fn early_functions(&mut self, w: &Words) -> Outcome {
        // The tool is changed before the spindle starts.
        if w.m.iter().any(|m| m.number == 6) {
            self.change_tool()?;
            if let Some(d) = w.edge_of_new_tool {
                self.st.select_edge(&self.core, d.value, d.span)?;
            }
        }
        let turning = |m: &&MWord| matches!(m.number, 3..=5);
        let spindles: Vec<&MWord> = w.m.iter().filter(turning).collect();
        if let [first, second, ..] = spindles.as_slice()
            && first.spindle == second.spindle
        {
            return self.core.refuse(second.span, codes::S2045::m_and_m_stand_in_one(&first.number, &second.number));
        }
        let mut ends = w.m.iter().filter(|m| matches!(m.number, 2 | 17 | 30));
        if let (Some(first), Some(second)) = (ends.next(), ends.next()) {
            return self.core.refuse(second.span, codes::S2045::m_m_stand_in_one_block(&first.number, &second.number));
        }
        if let Some(sixth) = w.m.get(MOST_M) {
            return self.core.refuse(sixth.span, codes::P1002::block_has_at_most_five_m_functions());
        }
        if let Some(fourth) = w.s.get(MOST_S) {
            return self.core.refuse(fourth.span, codes::P1002::block_has_at_most_three_s_words());
        }
        for m in &w.m {
            self.early_function(*m, w)?;
        }
        Ok(())
    }

    fn early_function(&mut self, m: MWord, w: &Words) -> Outcome {
        if let Some(n) = m.spindle
            && !matches!(m.number, 3..=5 | 19 | 40..=45 | 70)
        {
            // `M80=1` is M function 1 of address extension 80, which is neither M80 nor M1.
            return self.core.refuse(m.span, codes::P2007::what_m(&n, &m.number));
        }
        let spindle = match m.number {
            3 => Spindle::Start(Turn::Clockwise),
            4 => Spindle::Start(Turn::CounterClockwise),
            5 => Spindle::Stop,
            19 => Spindle::Orient(0.0),
            _ => return self.other_function(m),
        };
        let turn = match spindle {
            Spindle::Start(turn) => Some(turn),
            _ => None,
        };
        if self.st.spindles.is_master(m.spindle) {
            self.st.spindles.forget_angle();
        }
        if turn.is_some() {
            self.st.spindles.start_is_known(&self.core, m.spindle.unwrap_or(self.st.spindles.master()), m.span)?;
        }
        match m.spindle {
            Some(n) if n != self.st.spindles.master() => {
                self.core.spindle_number(n, m.span)?;
                self.st.spindles.set_turn_of(n, turn);
                self.function(function_of(n, spindle));
            }
            _ => {
                self.st.spindles.set_turn(turn);
                match spindle {
                    Spindle::Orient(angle) => self.stops_at_angle(angle, w, 1),
                    Spindle::Start(_) | Spindle::Stop | Spindle::Speed(_) | Spindle::CuttingSpeed { .. } => {
                        self.function(self.st.spindles.function(spindle));
                    }
                }
            }
        }
        Ok(())
    }

    fn other_function(&mut self, m: MWord) -> Outcome {
        match m.number {
            0 | 1 | 2 | 6 | 17 | 30 => {}
            7 => self.function(Function::Coolant(Coolant::Mist)),
            8 => self.function(Function::Coolant(Coolant::Flood)),
            // In the block of G332 it follows the tap.
            9 if self.st.taps.is_inside() => {}
            9 => self.function(Function::Coolant(Coolant::Off)),
            number if self.core.job.settings.output.pass_m.contains(&number) => self.function(Function::Aux(number)),
            40..=45 => self.core.say_once(m.span, codes::S8004::gear_steps_m40_to_m45_are_left()),
            70 => {
                return self.core.refuse(m.span, codes::P9011::m70_makes_spindle_axis().answer(Answer::pass_m(70)));
            }
            96..=99 => {
                return self.core.refuse(m.span, codes::P2007::m_calls_programs_in_iso_dialect(&m.number));
            }
            number => {
                let usual = format!("if it may be printed as it stands, list it: `[output] pass_m = [{number}]`");
                let help = match self.st.tool.waiting() {
                    Some(tool) => Answer::pass_m(number)
                        .help(format!(
                            "if it changes to tool {tool}, say so: `[control] tool_change_m = [{number}]`; {usual}"
                        ))
                        .and(Answer::changing_m(number)),
                    None => Answer::pass_m(number).help(usual),
                };
                return self.core.refuse(m.span, codes::P2007::what_m_does_is_up_to_machine(&number).help(help));
            }
        }
        Ok(())
    }
}

/// Offsets and carriers that the output cannot say.
fn no_other_offset(core: &Core<'_>, w: &mut Words) -> Outcome {
    for address in [Address::Dl, Address::Toff, Address::Toffl, Address::Toffr, Address::Tcarr] {
        let Some(given) = w.take(address).filter(|given| given.value != 0.0) else { continue };
        let fault = match address {
            Address::Tcarr => codes::P9011::orientable_tool_carriers_cannot_be_printed(),
            _ => codes::P9013::offset_of_tool_that_program_adds(),
        };
        return core.refuse(given.span, fault);
    }
    Ok(())
}
