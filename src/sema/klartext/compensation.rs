//! Radius compensation: RL, RR and R0, what M functions change about the computed path, and what a departure has to know
//! of the contour.
//!
//! Source: K 2.12, 2.14 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2};
use crate::ir::compensation::{Inside, Outside, Search};
use crate::ir::contour::Path;
use crate::ir::{Pos, Side};
use crate::machine::Axis;
use crate::text::Span;

use super::contour::{Contour, LastMove, OwnCorner};
use super::state::State;
use super::words::{Comp, MWord, Words};
use super::{Core, Outcome, Reported, Run};
use crate::sema::common::plane::plane_axes;
use crate::sema::run::Where;

/// Most blocks that M120 LA looks ahead.
const MOST_AHEAD: f64 = 99.0;
/// The largest turn of a contour: M97 prolongs the elements at every outside corner.
const EVERY_TURN: Deg = Deg(180.0);

impl State {
    /// Does a move to `after` change the place in the working plane?
    pub fn moves_in_plane(&self, after: &Pos, path: &Path) -> bool {
        match self.way_in_plane(after) {
            Some([from, to]) => self.goes(from, to, path),
            None => !after.known().common(plane_axes(self.plane())).is_empty(),
        }
    }

    /// Where a move to `after` begins and ends in the working plane.
    #[inline]
    fn way_in_plane(&self, after: &Pos) -> Option<[Point2; 2]> {
        let (first, second, _) = self.plane().axes();
        let at = self.position.at();
        let (first, second) = (Axis::ALL[first], Axis::ALL[second]);
        let from = Point2::new(at.get(first)?, at.get(second)?);
        Some([from, Point2::new(after.get(first).unwrap_or(from.x), after.get(second).unwrap_or(from.y))])
    }

    #[inline]
    fn goes(&self, from: Point2, to: Point2, path: &Path) -> bool {
        from != to || matches!(path, Path::Arc(arc, _) if arc.plane == self.plane())
    }

    /// Notes a move of a contour, or the move that leads away from it, that is about to be sent.
    #[inline]
    pub fn note_contour(&mut self, after: &Pos, path: &Path) {
        if self.compensation.is_on() || self.contour.is_some() {
            self.follow_contour(after, path);
        }
    }

    fn follow_contour(&mut self, after: &Pos, path: &Path) {
        let side = self.compensation.side();
        if side == Side::None && self.contour.is_some_and(|contour| contour.side != Side::None) {
            // A block that names the plane leads to its end, even from beside it.
            if !after.known().common(plane_axes(self.plane())).is_empty() {
                self.contour = None;
            }
            return;
        }
        let way = self.way_in_plane(after);
        let moves = match way {
            Some([from, to]) => self.goes(from, to, path),
            None => !after.known().common(plane_axes(self.plane())).is_empty(),
        };
        if !moves {
            return;
        }
        if self.own_corner == OwnCorner::Waits {
            self.own_corner = OwnCorner::Sent;
        }
        let plane = self.plane();
        let begun = self.contour.is_some();
        let contour = self.contour.get_or_insert(Contour::new(side));
        contour.begun = begun;
        match (way, path) {
            (Some([from, to]), Path::Rapid | Path::Line(_)) => {
                contour.last = Some(LastMove::straight(from, to, plane));
            }
            (Some([from, to]), Path::Arc(..) | Path::Thread(_)) => {
                let before = contour.last.take();
                contour.last = Some(LastMove::new(from, to, plane, *path, before));
            }
            (None, _) => contour.last = None,
        }
    }

    /// The compensation ends, and what M120 says with it.
    pub fn end_compensation(&mut self) {
        self.compensation.end();
        self.look_ahead = 0;
    }

    /// The contour was refused, or lacks an element: what only suffers from it is not worth another error.
    pub fn lose_contour(&mut self) {
        self.end_compensation();
        self.compensation.lose();
        self.contour = None;
    }

    /// The corner at the end of the block in hand is made in another way.
    fn shape_corner(&mut self, (outside, inside): (Option<Outside>, Option<Inside>)) {
        let Some(rules) = self.ctx.compensation.as_deref().copied() else { return };
        let (outside, inside) = (outside.unwrap_or(rules.outside), inside.unwrap_or(rules.inside));
        let own_corner = outside != Outside::default();
        self.compensate(crate::ir::Compensation { outside, inside, own_corner, ..rules });
        self.own_corner = OwnCorner::Waits;
    }

    /// M120: the blocks that are looked ahead from here on.
    fn look_ahead(&mut self, blocks: u32) {
        self.look_ahead = blocks;
        if let Some(rules) = self.ctx.compensation.as_deref().copied() {
            let search = Search { elements: blocks, bottlenecks: blocks > 0 };
            self.compensate(crate::ir::Compensation { search, ..rules });
        }
    }

    /// The block of M97, M98 or M197 is over.
    #[cold]
    pub fn end_own_corner(&mut self, core: &Core<'_>, w: &Words) -> Outcome {
        let own = std::mem::take(&mut self.own_corner);
        self.modal_rules();
        match w.any_m(&[97, 98, 197]) {
            Some(m) if own == OwnCorner::Waits => core.refuse(m.span, codes::K2607::m_acts_on_corner_at_end(&m.number)),
            _ => Ok(()),
        }
    }

    /// What holds from block to block.
    pub fn modal_rules(&mut self) {
        if let Some(rules) = self.ctx.compensation.as_deref().copied() {
            let search = Search { elements: self.look_ahead, bottlenecks: self.look_ahead > 0 };
            let (outside, inside) = (Outside::default(), Inside::default());
            let (feed, own_corner) = (self.feed.at, false);
            self.compensate(crate::ir::Compensation { search, outside, inside, feed, own_corner, ..rules });
        }
    }
}

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
            self.st.look_ahead = 0;
            return Ok(());
        }
        let other = |contour: Contour| contour.side != side && contour.side != Side::None;
        let stays = self.core.computes_path() && self.st.contour.is_some_and(other);
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
        self.st.contour = None;
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
        self.st.compensate(crate::ir::Compensation { radius, rounded_border: true, ..Default::default() });
        self.st.modal_rules();
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
                    self.st.look_ahead(blocks as u32);
                }
                97 | 98 | 197 => self.st.shape_corner(own_corner(&self.core, m)?),
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
        return core.refuse(
            Where::Block,
            codes::P9013::how_control_leads_tool_there_is_not(&what, &help)
                .answer(Answer::key("control", "rounded_approach").one_of(&["\"round\""])),
        );
    }
    core.say_here(codes::K2894::programmed_corner_is_cut_as_between_two(&what, &help));
    Ok(())
}
