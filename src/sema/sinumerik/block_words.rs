//! Carries out the words of a block: modal codes, then technology, then the motion, then what acts after it, and the modal call.
//!
//! Source: S 0, 2.1, 2.6, 2.8 and 2.9 (docs/sources.md).

use crate::diag::codes;

use super::block::AfterBlock;
use super::line::{Line, NextText};
use super::procedures::Left;
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
        let Some(AfterBlock { moved, triggers }) = self.channel.run_words(words, line.block)? else { return Ok(None) };
        for m in &words.m {
            if self.channel.late_function(*m)? {
                self.leave_program();
            }
        }
        if moved && !self.channel.core.has_ended() {
            if let Some((unit, arguments)) = self.channel.runs_modally()? {
                self.call(unit, arguments, 1, true, None)?;
            }
        } else if triggers && !moved && self.channel.core.job.diags.first_time(codes::S8033, ()) {
            // A control may drill behind a bare G0 or F, too; read here: after blocks that name an axis only.
            let fault = codes::S8033::under_mcall_of_drilling_cycle_this_block();
            let fault = fault.help("put it before MCALL: some controls drill after it once more");
            self.channel.core.say(line.block.span, fault);
        }
        Ok(None)
    }
}
