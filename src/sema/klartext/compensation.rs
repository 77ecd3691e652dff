//! Radius compensation: RL, RR and R0, what M functions change about the computed path, and what a departure has to know
//! of the contour.
//!
//! Source: K 2.12, 2.14 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2};
use crate::ir::compensation::{Inside, Outside, Search};
use crate::ir::contour::Path;
use crate::ir::{Pos, Side};
use crate::machine::{Axis, Compensation};
use crate::text::Span;

use super::contour::{Contour, LastMove, OwnCorner};
use super::m_table::Args;
use super::state::State;
use super::words::{Comp, MWord, Words};
use super::{Outcome, Reported, Run};
use crate::sema::common::compensation::compensate;
use crate::sema::common::plane::plane_axes;

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

    /// Notes a move of a contour, or the move that leads away from it. Called before the position is taken over.
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

    /// What holds from block to block.
    pub fn modal_rules(&mut self) {
        if let Some(rules) = self.ctx.compensation.as_deref().copied() {
            let search = Search { elements: self.look_ahead, bottlenecks: self.look_ahead > 0 };
            let (outside, inside) = (Outside::default(), Inside::default());
            let (feed, own_corner) = (self.feed.at, false);
            compensate(&mut self.ctx, crate::ir::Compensation { search, outside, inside, feed, own_corner, ..rules });
        }
    }
}

impl Run<'_> {
    /// Does the compiler compensate?
    pub(super) fn computes_path(&self) -> bool {
        self.core.job.settings.output.compensation == Compensation::Resolve
    }

    /// Does a straight block need nothing but its direction noted?
    pub(super) fn contour_is_plain(&self) -> bool {
        let side = self.st.compensation.side();
        match self.st.contour {
            None => side == Side::None,
            Some(contour) => side != Side::None && contour.begun && self.computes_path(),
        }
    }

    /// Takes note of a move that is about to be sent.
    #[inline]
    pub(super) fn note_contour(&mut self, end: &Pos, path: &Path) {
        if self.st.compensation.is_on() || self.st.contour.is_some() {
            self.st.follow_contour(end, path);
        }
    }

    pub(super) fn switch_side(&mut self, w: &Words, arc: bool) -> Outcome {
        let Some(Comp::Side(side)) = w.comp else { return Ok(()) };
        if side == self.st.compensation.side() {
            if side == Side::None {
                self.st.compensation.found();
            }
            return Ok(());
        }
        let switched = if self.is_capturing() {
            self.side_of_contour(side, w.comp_span)
        } else {
            self.switch_side_to(w, side, arc)
        };
        match switched {
            Ok(()) => self.st.compensation.found(),
            Err(Reported) => self.st.compensation.lose(),
        }
        switched
    }

    fn switch_side_to(&mut self, w: &Words, side: Side, arc: bool) -> Outcome {
        if arc {
            return self.core.refuse(w.comp_span, codes::P2040::radius_compensation_cannot_start_or_end());
        }
        if side == Side::None {
            self.st.look_ahead = 0;
        } else {
            let other = |contour: Contour| contour.side != side && contour.side != Side::None;
            let stays = self.computes_path() && self.st.contour.is_some_and(other);
            if self.st.compensation.is_on() || stays {
                let fault = if stays {
                    codes::K2602::r0_between_rl_and_rr_moved_nothing()
                } else {
                    codes::K2602::rl_and_rr_follow_without_r0()
                };
                return self.core.refuse(w.comp_span, fault);
            }
            self.compute_compensation(w.comp_span)?;
            self.check_cutter(w.comp_span)?;
            self.st.contour = None;
        }
        self.st.compensation.select(side);
        Ok(())
    }

    /// The compiler itself computes the path of the tool centre, unless the target shall.
    pub(super) fn compute_compensation(&mut self, span: Span) -> Outcome {
        if !self.computes_path() {
            return Ok(());
        }
        let radius = self.tool_radius(span)?;
        if radius < 0.0 {
            return self.core.refuse(span, codes::P9013::radius_of_tool_with_its_oversizes(&radius));
        }
        if self.st.rotary.follows_tip {
            return self.core.refuse(span, codes::P9013::under_m128_radius_compensation_is_one());
        }
        // RND and CHF there are refused, or accepted, where they stand.
        compensate(&mut self.st.ctx, crate::ir::Compensation { radius, rounded_border: true, ..Default::default() });
        self.st.modal_rules();
        Ok(())
    }

    /// M97, M98, M120 and M197 of a block in a contour that the compiler compensates.
    pub(super) fn shape_corners(&mut self, w: &Words) -> Outcome {
        if w.m().is_empty() || !self.computes_path() || !self.st.compensation.is_on() {
            return Ok(());
        }
        for &m in w.m() {
            match m.number {
                97 => self.own_corner(Outside { prolonged: EVERY_TURN, ..Outside::default() }, None),
                98 => self.open_corner(&m)?,
                120 => self.look_ahead(&m)?,
                197 => self.shortened_corner(&m)?,
                _ => {}
            }
        }
        Ok(())
    }

    /// The corner at the end of this block is made in another way.
    fn own_corner(&mut self, outside: Outside, inside: Option<Inside>) {
        let Some(rules) = self.st.ctx.compensation.as_deref().copied() else { return };
        let outside = if inside.is_some() { rules.outside } else { outside };
        let inside = inside.unwrap_or(rules.inside);
        let own_corner = outside != Outside::default();
        compensate(&mut self.st.ctx, crate::ir::Compensation { outside, inside, own_corner, ..rules });
        self.st.own_corner = OwnCorner::Waits;
    }

    fn open_corner(&mut self, m: &MWord) -> Outcome {
        if self.core.job.settings.control.klartext_choices.open_corners_refused {
            return self.core.refuse(
                m.span,
                codes::K9008::m98_opens_corner_at_end().answer(Answer::key("control", "m98").one_of(&["\"line\""])),
            );
        }
        self.core.report(
            codes::K2893::m98_opens_corner_at_end().answer(Answer::key("control", "m98")).at(self.core.loc(m.span)),
        );
        self.own_corner(Outside::default(), Some(Inside::Open));
        Ok(())
    }

    fn look_ahead(&mut self, m: &MWord) -> Outcome {
        let blocks = m.args.value.unwrap_or(0.0);
        if blocks.fract() != 0.0 || !(0.0..=MOST_AHEAD).contains(&blocks) {
            return self.core.refuse(m.span, codes::K2707::m120_looks_ahead_blocks(&blocks));
        }
        self.st.look_ahead = blocks as u32;
        if let Some(rules) = self.st.ctx.compensation.as_deref().copied() {
            let search = Search { elements: self.st.look_ahead, bottlenecks: self.st.look_ahead > 0 };
            compensate(&mut self.st.ctx, crate::ir::Compensation { search, ..rules });
        }
        Ok(())
    }

    fn shortened_corner(&mut self, m: &MWord) -> Outcome {
        let Args { value: Some(by), .. } = m.args else {
            return self.core.refuse(m.span, codes::K2707::m197_lacks_its_length());
        };
        if by < 0.0 {
            return self.core.refuse(m.span, codes::K2707::m197_prolongs_elements(&by));
        }
        let by = by * self.core.level().frame.unit.mm();
        self.own_corner(Outside { by: Some(by), ..Outside::default() }, None);
        Ok(())
    }

    /// The block of M97, M98 or M197 is over.
    #[cold]
    pub(super) fn end_own_corner(&mut self, w: &Words) -> Outcome {
        let own = std::mem::take(&mut self.st.own_corner);
        self.st.modal_rules();
        match w.any_m(&[97, 98, 197]) {
            Some(m) if own == OwnCorner::Waits => {
                self.core.refuse(m.span, codes::K2607::m_acts_on_corner_at_end(&m.number))
            }
            _ => Ok(()),
        }
    }

    /// Refuses what may not stand in a compensated contour, where the compiler computes it.
    pub(super) fn refuse_compensated(&mut self, what: &str) {
        if !self.st.compensation.is_on() || !self.computes_path() {
            return;
        }
        self.core.report(codes::K2606::while_radius_compensation(&what).at(self.core.here.origin.loc));
        self.st.end_compensation();
        self.st.contour = None;
        self.lose_all();
    }

    /// RND or CHF (`word`) as way to a contour, or from it.
    pub(super) fn round_border(&mut self, word: &str, leaves: bool) -> Outcome {
        if !self.computes_path() {
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
        if !self.core.job.settings.control.klartext_choices.rounded_approach {
            return self.core.refuse(
                self.core.block_span(),
                codes::P9013::how_control_leads_tool_there_is_not(&what, &help)
                    .answer(Answer::key("control", "rounded_approach").one_of(&["\"round\""])),
            );
        }
        self.core
            .report(codes::K2894::programmed_corner_is_cut_as_between_two(&what, &help).at(self.core.here.origin.loc));
        Ok(())
    }
}
