//! G codes that hold on, and which of them may stand in one block.
//!
//! Source: S 3 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::ir::Side;
use crate::machine::AxisSet;
use crate::sema::run::Where;
use crate::text::Span;

use super::diameter::diameter_of;
use super::g_groups::{GCode, Group};
use super::state::Saved;
use super::words::Words;
use super::{Channel, Core, Outcome, Reported};

/// Is one of its codes the whole block?
pub(super) enum Whole {
    No,
    Done,
    /// A code of group 2, which may have moved the tool as a block of moves does.
    Nonmodal {
        moved: bool,
    },
}

impl Channel<'_> {
    /// Carries out the codes of a block.
    pub(super) fn codes_of_block(&mut self, w: &mut Words) -> Outcome<Whole> {
        if w.codes.is_empty() && w.diameter.is_none() && w.dynamics.is_none() && !w.smoothing.is_given() {
            return Ok(Whole::No);
        }
        self.core.check_codes(w)?;
        self.modal_codes(w)?;
        if let Some((code, span)) = w.code_of(Group::Nonmodal) {
            return self.nonmodal_block(code, span, w).map(|moved| Whole::Nonmodal { moved });
        }
        if let Some((code, span)) = w.code_of(Group::Frame) {
            return self.frame_block(code, span, w).map(|()| Whole::Done);
        }
        if let Some((code, span)) = w.code_of(Group::Buffer).filter(|(code, _)| *code != GCode::FIFOCTRL) {
            return self.buffer_code(code, span, w).map(|()| Whole::Done);
        }
        Ok(Whole::No)
    }

    /// The codes that hold on.
    pub(super) fn modal_codes(&mut self, w: &Words) -> Outcome {
        for at in 0..w.codes.len() {
            let (code, span) = w.codes[at];
            self.modal_code(code, span)?;
        }
        if let Some((indexed, axis, span)) = w.diameter {
            self.st.diameter = diameter_of(&self.core, indexed, axis, span)?;
        }
        if let Some(span) = w.dynamics {
            self.core.say_once(span, codes::S8002::words_that_only_shape_speed());
        }
        self.st.smoothing.program(&self.core, &self.st.codes, w);
        self.send_smoothing();
        Ok(())
    }

    pub(super) fn modal_code(&mut self, code: GCode, span: Span) -> Outcome {
        let old = self.st.codes.of(code.group);
        match code.group {
            Group::Motion => {
                self.core.accept(span, code.can_be_printed())?;
                self.st.codes.activate(code);
                self.left.motion = None;
            }
            Group::Nonmodal | Group::Frame | Group::Suppression => {}
            Group::ExactStopBlock => {}
            Group::ExactStop => self.st.codes.activate(code),
            Group::RepositioningPointBlock => {
                self.core.say_once(span, codes::S8103::words_that_only_steer_control());
            }
            Group::Plane => {
                self.st.codes.activate(code);
                if old != code {
                    self.plane_change(code, span)?;
                }
            }
            Group::Compensation => {
                let st = &mut self.st;
                st.compensation.select(&self.core, &mut st.codes, st.path.is_computed(), code, span)?;
            }
            Group::WorkOffset => self.work_offset(code.index, span)?,
            Group::FeedType => self.st.feed_code(&self.core, code, span)?,
            Group::Diameter => {
                if code != GCode::DIAMOF && self.core.job.settings.machine.diameter_axis.is_none() {
                    return self.core.no_diameter_axis(span);
                }
                // DIAMCYCOF counts inside of cycles only.
                if code == GCode::DIAMCYCOF {
                    self.core.say_once(span, codes::S8103::words_that_only_steer_control());
                } else {
                    self.st.codes.activate(code);
                    if let Some(stored) = self.st.stored.as_mut() {
                        stored.diameter_said = true;
                    }
                    self.st.diameter = None;
                }
            }
            _ => {
                self.refused_code(code, span)?;
                let curve_feed = self.core.job.settings.control.sinumerik.compensation.curve_feed;
                // Other blocks ask for the rest where it counts.
                if let Some(said) = code.left_out(self.core.resolves(), curve_feed) {
                    said.say(&self.core, span);
                }
                self.st.codes.activate(code);
            }
        }
        Ok(())
    }

    pub(super) fn plane_change(&mut self, code: GCode, span: Span) -> Outcome {
        if self.st.side() != Side::None {
            return self.core.refuse(span, codes::S2080::plane_changes_while_radius_compensation());
        }
        if let Some(origin) = self.st.pair.refuse_first() {
            let found = codes::S2070::plane_changes_between_two_lines_of_pair().at(origin.loc);
            self.core
                .report(found.also(self.core.loc(span), Label::Here).help("change the plane before the first line"));
            self.st.position.lose(AxisSet::MAIN);
            return Err(Reported);
        }
        self.st.set_plane(code);
        let plane = self.st.plane();
        self.function(crate::ir::Function::Plane(plane));
        Ok(())
    }

    pub(super) fn refused_code(&mut self, code: GCode, span: Span) -> Outcome {
        let what = match code {
            GCode::G291 => {
                self.iso = true;
                self.st.position.lose(AxisSet::ALL);
                self.lost();
                return self.core.refuse(span, codes::P9012::g291_switches_to_iso_dialect());
            }
            GCode { group: Group::PointToPoint, index: 2.. } => "point-to-point travel",
            GCode::PAROT => "a frame turned to the workpiece",
            GCode { group: Group::ToolFrame, index: 2.. } => "a frame turned to the tool",
            GCode { group: Group::ToolCarrier, index: 2.. } => "an orientable tool carrier",
            GCode { group: Group::Punching, index: 2.. } => "punching",
            GCode { group: Group::Builder1 | Group::Builder2, .. } => "a code of the machine builder",
            GCode::CUTCONON if !self.core.resolves() => "compensation with a constant offset",
            _ => return Ok(()),
        };
        self.core.refuse(span, codes::P9011::is_which_cannot_be_printed(&code.word(), &what))
    }

    /// What SAVE kept of the call comes back.
    pub(super) fn restore(&mut self, saved: Saved) {
        let changed = self.st.codes.of(Group::FeedType) != saved.codes.of(Group::FeedType);
        let (offset, plane) = (self.st.codes.of(Group::WorkOffset), saved.codes.of(Group::Plane));
        self.st.codes = saved.codes;
        self.st.smoothing.restore(saved.smoothing);
        self.st.frames.set_programmable(saved.frames.programmable);
        self.st.set_plane(plane);
        if !self.st.is(offset) {
            // The work offset of the call comes back, whatever MD 10617 says.
            let _: Outcome = self.work_offset(self.st.codes.of(Group::WorkOffset).index, Where::Block);
        } else if self.st.frames.settable() != saved.frames.settable.as_ref() && self.st.frames.is_tilted() {
            self.core.say(Where::Block, codes::S2283::save_brings_work_offset_back());
        } else if self.st.frames.settable() != saved.frames.settable.as_ref() {
            self.st.frames.restore_settable(&self.core, saved.frames.settable);
        }
        self.st.refresh_frame(&self.core);
        if changed {
            self.st.feed_mode_changed();
        }
        self.send_smoothing();
    }
}

impl Core<'_> {
    /// Groups 1 to 4 shape the block: it takes one of them.
    pub(super) fn check_codes(&mut self, w: &Words) -> Outcome {
        let mut shaping = w.codes.iter().filter(|(code, _)| code.group.shapes_block());
        if let (Some((a, first)), Some((b, second))) = (shaping.next(), shaping.next()) {
            return self.two_shapes(*a, *first, *b, *second);
        }
        Ok(())
    }

    pub(super) fn two_shapes(&self, a: GCode, first: Span, b: GCode, second: Span) -> Outcome {
        let (a, b) = (a.word(), b.word());
        let found = codes::S2009::cannot_stand_in_one_block(&a, &b).at(self.loc(second));
        self.report(found.also(self.loc(first), Label::OtherOne).help("give each a block of its own"));
        Err(Reported)
    }
}
