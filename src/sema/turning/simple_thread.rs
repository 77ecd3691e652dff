//! G32, a thread from where the tool stands to an end point, cut in several passes.
//!
//! No manual at hand shows its list of words; they are read as docs/turning.md says, from the reference, section
//! 10.4; `[control] simple_thread = "refuse"` refuses them.

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2};
use crate::ir::cycle::thread::{Flank, Infeed, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Thread};

use super::readings::Question;
use super::words::Words;
use super::{Outcome, Run};

/// Most air cuts.
const MOST_AIR_CUTS: u32 = 99;

impl Run<'_> {
    pub(super) fn simple_thread(&mut self, w: &Words) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        if self.job.settings.control.turning.refuse_simple_thread == Some(true) {
            return self.refuse(
                span,
                codes::T9007::words_of_g32_are_not_confirmed().answer(Answer::key("control", "simple_thread")),
            );
        }
        self.depends_on(Question::SimpleThread, span);
        for (letter, what) in [(b'W', "the sense of its taper angle"), (b'H', "the angle of its flank offset")] {
            if let Some(num) = w.get(letter).filter(|num| num.value != 0.0) {
                return self.refuse(num.span, codes::T9007::of_g32_no_manual_at_hand_gives(&(letter as char), &what));
            }
        }
        self.spindle_turns(32)?;
        let end = self.corner_of(w, at)?;
        let pitch = self.needed(w, b'F', "the pitch of the thread", span)?;
        let lead = self.above_zero(pitch, "the pitch of the thread")?;
        let p = self.needed(w, b'P', "the depth of the thread", span)?;
        let depth = p.value.abs() * self.st.mm();
        if depth == 0.0 {
            return self.refuse(p.span, codes::T1007::thread_has_no_depth());
        }
        let into = if at.y > end.y { Towards::MinusX } else { Towards::PlusX };
        if p.value < 0.0 && into == Towards::PlusX {
            return self.refuse(p.span, codes::T1007::negative_depth_is_that_of_external_thread());
        }
        let start = Point2::new(at.x, end.y);
        let parts = vec![ThreadPart { end, lead }];
        self.above_centre(start, &parts, into, depth)?;
        let most = self.needed(w, b'I', "the greatest infeed", span)?;
        let most = self.above_zero(most, "the greatest infeed")?;
        let run_out = match w.get(b'K') {
            Some(num) if num.value < 0.0 => return self.refuse(num.span, codes::T1007::run_out_is_not_negative()),
            num => num.map_or(0.0, |num| num.value * self.st.mm()),
        };
        let thread = Thread {
            start,
            parts,
            into,
            depth,
            infeed: match self.choice(w, b'B', 0, 1)? {
                0 => Infeed::RemainderSplit { most },
                _ => Infeed::Remainder { most },
            },
            flank: Flank::Radial,
            finish: 0.0,
            air_cuts: self.choice(w, b'Q', 0, MOST_AIR_CUTS)?,
            run_in: 0.0,
            run_out,
            fixed_end: false,
            starts: 1,
            start_angle: Deg(w.value(b'C').unwrap_or(0.0)),
            retract: at.y,
            park: at,
        };
        self.send_cycle(&Cycle::Thread(thread));
        Ok(())
    }
}
