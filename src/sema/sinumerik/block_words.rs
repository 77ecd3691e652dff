//! Carries out the words of a block: modal codes, then technology, then the motion, then what acts behind it, and the modal call.
//!
//! Source: S 0, 2.1, 2.6, 2.8 and 2.9 (docs/sources.md).

use crate::diag::codes;
use crate::ir::Function;
use crate::machine::AxisSet;
use crate::parser::sinumerik::ast::{Block, Target};

use super::axis_names::NamedAxis;
use super::block::ARC_ADDRESSES;
use super::g_groups::{GCode, Group};
use super::line::{Line, NextText};
use super::procedures::Left;
use super::vocabulary::{Address, Meaning};
use super::words::Words;
use super::{Outcome, Reported, Run, levels};

impl Run<'_> {
    /// Sorts the words of a block and carries them out; a text that is to be executed next comes back.
    pub(super) fn block_of_words(&mut self, words: &mut Words, line: Line<'_>) -> Outcome<Option<NextText>> {
        self.sort_words(words, line)?;
        if words.is_empty() {
            return Ok(None);
        }
        if words.calls.word.is_some() || words.calls.number.is_some() {
            match self.call_block(words, line)? {
                Left::Nothing => return Ok(None),
                Left::Text(text) => return Ok(Some(text)),
                Left::Words => words.calls.word = None,
            }
        }
        self.channel.core.begins_executing();
        self.run_words_of(words, line.block).map(|()| None)
    }

    /// After an error nobody knows where the axes of the block are.
    pub(super) fn lose_block(&mut self, words: &Words, block: &Block) {
        let of_tap = self.channel.st.codes.of(Group::Motion).is_tapping() && !words.axes.is_empty();
        self.channel.st.taps.block_is_refused(of_tap);
        let mut axes = words.axes;
        for word in &block.words {
            let named = match word.target {
                Target::Letter(letter) => self.channel.axis_names.letter(letter),
                Target::Numbered(_, _, name) | Target::Name(name) => match self.meaning(name) {
                    Meaning::Axis(named) => Some(named),
                    _ => None,
                },
                Target::Indexed(..) => {
                    axes = axes.union(AxisSet::MAIN);
                    None
                }
                Target::System(_) => None,
            };
            if let Some(NamedAxis { axis: Some(axis), .. }) = named {
                axes.insert(axis);
            }
        }
        let more = [Address::Ap, Address::Rp, Address::Ang, Address::Ar, Address::F];
        if ARC_ADDRESSES.iter().chain(&more).any(|address| words.get(*address).is_some()) {
            axes = axes.union(AxisSet::MAIN);
        }
        if words.get(Address::F).is_some() {
            self.channel.st.feed.lose();
        }
        if words.get(Address::Ang).is_some() {
            self.channel.st.pair.lose();
        }
        if !axes.is_empty() {
            self.channel.st.position.lose(axes);
            self.channel.st.pair.drop_first();
            self.channel.lost();
        }
    }

    /// The words of a block that holds no call.
    fn run_words_of(&mut self, w: &mut Words, block: &Block) -> Outcome {
        let motion = self.channel.st.codes.of(Group::Motion);
        if self.channel.st.taps.are_open() && self.channel.st.taps.end_before(w, motion) {
            self.channel.tapping_ends();
        }
        self.channel.st.threads.go_on_beside(&self.channel.core, w);
        if let Some(capture) = &mut self.channel.capture {
            capture.words(&self.channel.core, w)?;
        }
        let triggers = self.channel.st.modal_call.cycle().is_some()
            && (w.code_of(Group::Motion).is_some() || w.get(Address::F).is_some() || !w.s.is_empty());
        if let Some(probe) = w.probe
            && let Some((_, span)) =
                [Group::Nonmodal, Group::Frame, Group::Buffer].into_iter().find_map(|group| w.code_of(group))
        {
            return probe.stands_beside(&self.channel.core, span);
        }
        if self.codes_of_block(w)? {
            return Ok(());
        }
        let motion = self.channel.st.codes.of(Group::Motion);
        if motion.is_tapping() && !w.axes.is_empty() {
            let st = &mut self.channel.st;
            st.taps.take_only(&self.channel.core, &st.spindles, motion, w)?;
            if !st.describes {
                st.taps.begin(st.spindles.fixed_turns(None));
            }
        }
        self.channel.technology(w)?;
        self.channel.early_functions(w)?;
        let corner_before = self.channel.st.corners.open.site();
        let moved = self.channel.probed_motion(w, block)?;
        if moved && self.channel.st.corners.open.site() == corner_before {
            self.channel.st.corners.open.close();
        }
        self.channel.st.corners.pass_block(&self.channel.core, moved)?;
        if let Err((span, fault)) = w.leftover() {
            return self.channel.core.refuse(span, fault);
        }
        if self.channel.st.modal_call.is_on() {
            w.moves_what_is_left_out(&self.channel.core)?;
        }
        self.late_functions(w)?;
        if moved && !self.channel.core.has_ended() {
            self.call_modal()?;
        } else if triggers && !moved && self.channel.core.job.diags.first_time(codes::S8033, ()) {
            // A control may drill behind a bare G0 or F, too; read here: behind blocks that name an axis only.
            let fault = codes::S8033::under_mcall_of_drilling_cycle_this_block();
            let fault = fault.help("put it before MCALL: some controls drill after it once more");
            self.channel.core.say(block.span, fault);
        }
        Ok(())
    }

    /// The codes of a block; true if one of them is the whole block.
    fn codes_of_block(&mut self, w: &mut Words) -> Outcome<bool> {
        if w.codes.is_empty() && w.diameter.is_none() && w.dynamics.is_none() && !w.smoothing.is_given() {
            return Ok(false);
        }
        self.channel.core.check_codes(w)?;
        self.channel.modal_codes(w)?;
        if let Some((code, span)) = w.code_of(Group::Nonmodal) {
            let moved = self.channel.nonmodal_block(code, span, w)?;
            self.late_functions(w)?;
            if moved && !self.channel.core.has_ended() {
                self.call_modal()?;
            }
            return Ok(true);
        }
        if let Some((code, span)) = w.code_of(Group::Frame) {
            return self.channel.frame_block(code, span, w).map(|()| true);
        }
        if let Some((code, span)) = w.code_of(Group::Buffer).filter(|(code, _)| *code != GCode::FIFOCTRL) {
            return self.channel.buffer_code(code, span, w).map(|()| true);
        }
        Ok(false)
    }

    /// M functions that stop the program or end it.
    fn late_functions(&mut self, w: &Words) -> Outcome {
        for m in &w.m {
            if matches!(m.number, 0..=2 | 17 | 30) {
                self.channel.tapping_ends();
            }
            match m.number {
                0 => self.channel.function(Function::Stop),
                1 => self.channel.function(Function::OptionalStop),
                2 | 17 | 30 => {
                    self.channel.core.end_is_whole();
                    if !levels::in_main(&self.channel.core.levels) {
                        self.leave_program();
                        continue;
                    }
                    if self.channel.capture.as_ref().is_some_and(|capture| capture.ends_program(&self.channel.core)) {
                        return Err(Reported);
                    }
                    let done = self.channel.pending_must_be_done(m.span);
                    self.channel.function(Function::End { rewind: m.number == 30 });
                    self.channel.core.stop_run();
                    done?;
                }
                _ => {}
            }
        }
        Ok(())
    }
}
