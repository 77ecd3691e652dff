//! Carries out the words of a block: modal codes, then technology, then the motion, then what acts behind it, and the modal call.
//!
//! Source: S 0, 2.1, 2.6, 2.8 and 2.9 (docs/sources.md).

use crate::diag::codes;
use crate::parser::sinumerik::ast::Block;

use super::g_functions::Whole;
use super::g_groups::Group;
use super::line::{Line, NextText};
use super::procedures::Left;
use super::vocabulary::Address;
use super::words::Words;
use super::{Outcome, Run};

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

    /// The words of a block that holds no call.
    fn run_words_of(&mut self, w: &mut Words, block: &Block) -> Outcome {
        if self.channel.st.taps.are_open() {
            self.channel.beside_taps(w);
        }
        if self.channel.st.threads.are_open() {
            self.channel.beside_threads(w);
        }
        if self.channel.is_capturing() {
            self.channel.words_in_contour(w)?;
        }
        let triggers = self.channel.st.modal_call.cycle().is_some()
            && (w.code_of(Group::Motion).is_some() || w.get(Address::F).is_some() || !w.s.is_empty());
        if let Some(probe) = w.probe
            && let Some((_, span)) =
                [Group::Nonmodal, Group::Frame, Group::Buffer].into_iter().find_map(|group| w.code_of(group))
        {
            return self.channel.measures_beside(probe, span);
        }
        match self.channel.codes_of_block(w)? {
            Whole::No => {}
            Whole::Done => return Ok(()),
            Whole::Nonmodal { moved } => {
                self.late_functions(w)?;
                let goes_on = moved && !self.channel.core.has_ended();
                return if goes_on { self.call_modal() } else { Ok(()) };
            }
        }
        if self.channel.st.codes.of(Group::Motion).is_tapping() && !w.axes.is_empty() {
            self.channel.only_tapping(w)?;
            self.channel.tap_begins();
        }
        self.channel.technology(w)?;
        self.channel.early_functions(w)?;
        let corner_before = self.channel.st.corners.open.site();
        let moved = self.channel.probed_motion(w, block)?;
        if moved && self.channel.st.corners.open.site() == corner_before {
            self.channel.st.corners.open.close();
        }
        self.channel.block_behind_corner(moved)?;
        if let Err((span, fault)) = w.leftover() {
            return self.channel.core.refuse(span, fault);
        }
        self.channel.left_out_under_modal_call(w)?;
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

    /// M functions that stop the program or end it.
    fn late_functions(&mut self, w: &Words) -> Outcome {
        for m in &w.m {
            if self.channel.late_function(*m)? {
                self.leave_program();
            }
        }
        Ok(())
    }
}
