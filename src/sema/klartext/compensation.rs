//! Radius compensation: RL, RR and R0, what M functions change about the computed path, and what a departure has to know
//! of the contour.
//!
//! Source: K 2.12, 2.14 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::ir::compensation::{Inside, Outside};
use crate::ir::{Compensation, Side};
use crate::sema::common::compensation::compensate;
use crate::sema::run::Where;
use crate::text::Span;

use super::contour::Contour;
use super::words::{Comp, MWord, Words};
use super::{Core, Outcome, Reported, Run};

/// Most blocks that M120 LA looks ahead.
const MOST_AHEAD: f64 = 99.0;
/// The largest turn of a contour: M97 prolongs the elements at every outside corner.
const EVERY_TURN: Deg = Deg(180.0);

impl Run<'_> {
    pub(super) fn switch_side(&mut self, w: &Words, arc: bool) -> Outcome {
        let Some(Comp::Side(side)) = w.comp else { return Ok(()) };
        if side == self.st.compensation.side() {
            if side == Side::None {
                self.st.compensation.found();
            }
            return Ok(());
        }
        let switched = match &self.st.described {
            // RL or RR in the first block says on which side of the contour the tool lies.
            Some(label) if self.st.compensation.is_on() => {
                self.core.refuse(w.comp_span, codes::K2951::rl_rr_or_r0_stands_in_contour(&label))
            }
            Some(_) => Ok(()),
            None => self.may_switch(w, side, arc),
        };
        match switched {
            Ok(()) => {
                self.st.compensation.select(side);
                self.st.compensation.found();
            }
            Err(Reported) => self.st.compensation.lose(),
        }
        switched
    }

    fn may_switch(&mut self, w: &Words, side: Side, arc: bool) -> Outcome {
        if arc {
            return self.core.refuse(w.comp_span, codes::P2040::radius_compensation_cannot_start_or_end());
        }
        if side == Side::None {
            self.st.contour.look_ahead = 0;
            return Ok(());
        }
        let other = |contour: Contour| contour.side != side && contour.side != Side::None;
        let stays = self.core.computes_path() && self.st.contour.now.is_some_and(other);
        if self.st.compensation.is_on() || stays {
            let fault = if stays {
                codes::K2602::r0_between_rl_and_rr_moved_nothing()
            } else {
                codes::K2602::rl_and_rr_follow_without_r0()
            };
            return self.core.refuse(w.comp_span, fault);
        }
        self.compute_compensation(w.comp_span)?;
        self.st.tool.check_cutter(&self.core, w.comp_span)?;
        self.st.contour.now = None;
        Ok(())
    }

    /// The compiler itself computes the path of the tool centre, unless the target shall.
    pub(super) fn compute_compensation(&mut self, span: Span) -> Outcome {
        if !self.core.computes_path() {
            return Ok(());
        }
        let radius = self.st.tool.radius(&self.core, span)?;
        if radius < 0.0 {
            return self.core.refuse(span, codes::P9013::radius_of_tool_with_its_oversizes(&radius));
        }
        if self.st.rotary.follows_tip {
            return self.core.refuse(span, codes::P9013::under_m128_radius_compensation_is_one());
        }
        // RND and CHF there are refused, or accepted, where they stand.
        let rules = Compensation { radius, rounded_border: true, ..Compensation::default() };
        compensate(&mut self.st.ctx, rules);
        self.st.contour.modal_rules(&mut self.st.ctx, self.st.feed.at);
        Ok(())
    }

    /// M97, M98, M120 and M197 of a block in a contour that the compiler compensates.
    pub(super) fn shape_corners(&mut self, w: &Words) -> Outcome {
        if w.m().is_empty() || !self.core.computes_path() || !self.st.compensation.is_on() {
            return Ok(());
        }
        for m in w.m() {
            match m.number {
                120 => {
                    let blocks = m.args.value.unwrap_or(0.0);
                    if blocks.fract() != 0.0 || !(0.0..=MOST_AHEAD).contains(&blocks) {
                        return self.core.refuse(m.span, codes::K2707::m120_looks_ahead_blocks(&blocks));
                    }
                    self.st.contour.look_ahead(&mut self.st.ctx, blocks as u32);
                }
                97 | 98 | 197 => {
                    let corner = own_corner(&self.core, m)?;
                    self.st.contour.shape_corner(&mut self.st.ctx, corner);
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// How M97, M98 or M197 make the corner: what is not named stays as it is.
fn own_corner(core: &Core<'_>, m: &MWord) -> Outcome<(Option<Outside>, Option<Inside>)> {
    let fault = match (m.number, m.args.value) {
        (97, _) => return Ok((Some(Outside { prolonged: EVERY_TURN, ..Outside::default() }), None)),
        (98, _) if core.job.settings.control.klartext_choices.open_corners_refused => {
            codes::K9008::m98_opens_corner_at_end().answer(Answer::key("control", "m98").one_of(&["\"line\""]))
        }
        (98, _) => {
            core.say(m.span, codes::K2893::m98_opens_corner_at_end().answer(Answer::key("control", "m98")));
            return Ok((None, Some(Inside::Open)));
        }
        (_, None) => codes::K2707::m197_lacks_its_length(),
        (_, Some(by)) if by < 0.0 => codes::K2707::m197_prolongs_elements(&by),
        (_, Some(by)) => return Ok((Some(Outside { by: Some(by * core.mm()), ..Outside::default() }), None)),
    };
    core.refuse(m.span, fault)
}

/// RND or CHF (`word`) as way to a contour, or from it.
pub(super) fn round_border(core: &Core<'_>, word: &str, leaves: bool) -> Outcome {
    if !core.computes_path() {
        return Ok(());
    }
    let (what, help) = if leaves {
        (
            format!("{word} stands before the block with R0, so the contour ends on it"),
            "program the departure with DEP CT",
        )
    } else {
        (
            format!("{word} stands after the block with RL or RR, so the contour begins on it"),
            "program the approach with APPR CT",
        )
    };
    if !core.job.settings.control.klartext_choices.rounded_approach {
        let fault = codes::P9013::how_control_leads_tool_there_is_not(&what, &help);
        return core
            .refuse(Where::Block, fault.answer(Answer::key("control", "rounded_approach").one_of(&["\"round\""])));
    }
    core.say_here(codes::K2894::programmed_corner_is_cut_as_between_two(&what, &help));
    Ok(())
}
