//! Chamfers and roundings at the end of a block: CHF, CHR, RND, RNDM, FRC, FRCM.

use crate::diag::codes;
use crate::ir::contour::{ArcChamfer, Blocks, Corner, CornerShape, LargeCorner};
use crate::ir::{Ask, Feed};
use crate::sema::common::corner::OpenCorner;
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::GCode;
use super::vocabulary::Address;
use super::words::Words;
use super::{Channel, Core, Outcome, Reported, State};

/// A corner that is larger than its neighbours.
const LARGE: Ask = Ask::key("control", "large_corners", LARGE_HELP);
const LARGE_HELP: &str = "make the corner smaller, or the short element longer; the control makes it smaller by itself: for a corner as large as it fits \
           set `[control] large_corners = \"shorten\"`";
/// A chamfer beside an arc.
const AT_ARC: Ask = Ask::key("control", "arc_chamfers", AT_ARC_HELP);
const AT_ARC_HELP: &str = "program a rounding beside an arc; how the control lays a chamfer there is not confirmed: for one across the bisector of the \
           corner set `[control] arc_chamfers = \"bisector\"`";

/// Blocks without a move over which the control looks for the end of a corner (MD 20200).
const MOST_BETWEEN: u32 = 3;

/// Chamfers and roundings.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Corners {
    /// RNDM in mm, 0 for none.
    rounding: f64,
    /// FRCM
    feed: Option<Feed>,
    /// A corner that waits for its second line.
    pub open: OpenCorner,
}

impl Corners {
    /// Radius of the rounding that holds on, in mm; 0 for none.
    pub fn rounding(&self) -> f64 {
        self.rounding
    }

    /// Feed of corners that holds on.
    pub fn feed(&self) -> Option<Feed> {
        self.feed
    }

    /// A block without a move behind a corner: the control looks ahead over a few of them only (MD 20200).
    pub fn pass_block(&mut self, core: &Core<'_>, moved: bool) -> Outcome {
        if moved {
            return Ok(());
        }
        let Some(loc) = self.open.wait(MOST_BETWEEN) else { return Ok(()) };
        let found = codes::S2071::more_than_blocks_without_move_stand(&MOST_BETWEEN).at(loc);
        core.report(found.help("the control would leave the corner as it is: move the blocks away from it"));
        Err(Reported)
    }
}

impl Words {
    pub(super) fn shapes_corner(&self) -> bool {
        [Address::Rnd, Address::Chf, Address::Chr, Address::Frc].iter().any(|address| self.get(*address).is_some())
    }
}

impl State {
    /// RNDM and FRCM.
    pub(super) fn modal_contour_words(&mut self, core: &Core<'_>, w: &mut Words) -> Outcome {
        if let Some(rndm) = w.take(Address::Rndm) {
            if rndm.value < 0.0 {
                return core.negative(rndm.span);
            }
            self.corners.rounding = rndm.value * self.length_unit();
        }
        if let Some(frcm) = w.take(Address::Frcm) {
            if frcm.value < 0.0 {
                return core.refuse(frcm.span, codes::P2003::feed_frcm_is_negative());
            }
            self.corners.feed = (frcm.value > 0.0).then(|| self.feed_of(frcm.value));
        }
        Ok(())
    }
}

impl Channel<'_> {
    pub(super) fn send_corner(&mut self, corner: Option<Corner>) {
        let Some(corner) = corner else { return };
        // A modal rounding is for moves that cut.
        if corner.modal && self.st.is(GCode::G0) {
            return;
        }
        if let Some(stored) = &mut self.st.stored {
            stored.note_corner(&corner);
        }
        self.core.send_corner(&corner, &self.st.ctx);
        if !corner.modal {
            self.st.corners.open.open(self.core.here.origin.loc);
        }
    }
}

/// The corner that the block asks for at its end.
pub(super) fn corner_of(core: &Core<'_>, st: &State, w: &mut Words) -> Outcome<Option<Corner>> {
    if !w.shapes_corner() && st.corners.rounding == 0.0 {
        return Ok(None);
    }
    if st.is(GCode::G93) {
        let corner = [Address::Rnd, Address::Chr, Address::Chf, Address::Frc].iter().find_map(|a| w.get(*a));
        let span = corner.map(|given| given.span).unwrap_or_default();
        return core.refuse(span, codes::S9009::corner_has_no_share_of_time());
    }
    let (rnd, chr, chf, frc) = (w.take(Address::Rnd), w.take(Address::Chr), w.take(Address::Chf), w.take(Address::Frc));
    for given in [rnd, chr, chf].into_iter().flatten() {
        if given.value < 0.0 {
            return core.negative(given.span);
        }
    }
    let unit = st.length_unit();
    // A rounding goes before a chamfer in the same block.
    if let (Some(_), Some(other)) = (rnd, chr.or(chf)) {
        let found = codes::S8008::rnd_chamfer_stand_in_one_block().at(core.loc(other.span));
        core.report(found.help("delete one of them"));
    }
    if let (Some(_), Some(chf)) = (chr, chf) {
        return core.refuse(chf.span, codes::S2071::chr_chf_stand_in_one_block());
    }
    let explicit = rnd.is_some() || chr.is_some() || chf.is_some();
    let shape = match (rnd, chr, chf) {
        (Some(rnd), _, _) => CornerShape::Rounding { radius: rnd.value * unit },
        (None, Some(chr), _) => CornerShape::Chamfer { side: chr.value * unit },
        (None, None, Some(chf)) => CornerShape::ChamferLength { length: chf.value * unit },
        (None, None, None) => CornerShape::Rounding { radius: st.corners.rounding },
    };
    let feed = match frc {
        Some(frc) if frc.value > 0.0 => Some(st.feed_of(frc.value)),
        Some(frc) => return core.refuse(frc.span, codes::P2003::feed_frc_is_not_above_0()),
        None => modal_corner_feed(core, st)?,
    };
    if !explicit && st.corners.rounding == 0.0 {
        return core.refuse(
            frc.map(|given| given.span).unwrap_or_default(),
            codes::S2071::frc_stands_without_chamfer_or_rounding(),
        );
    }
    let size = match shape {
        CornerShape::Rounding { radius } => radius,
        CornerShape::Chamfer { side } => side,
        CornerShape::ChamferLength { length } => length,
        CornerShape::Undercut(_) => 0.0,
    };
    let (large, at_arc, blocks) = (core.large_corner(), core.arc_chamfer(), Blocks::PassedOver);
    Ok((size > 0.0).then_some(Corner { shape, feed, early: true, modal: !explicit, large, at_arc, blocks }))
}

/// FRCM, which counts as the feeds did where it was programmed.
pub(super) fn modal_corner_feed(core: &Core<'_>, st: &State) -> Outcome<Option<Feed>> {
    let fits = st.corners.feed.is_none_or(|feed| st.counts_as(feed));
    if fits {
        return Ok(st.corners.feed);
    }
    core.refuse(Where::Block, codes::P2002::kind_of_feed_has_changed_since_frcm())
}

impl Core<'_> {
    pub(super) fn no_corner(&self, span: Span) -> Outcome<bool> {
        self.refuse(span, codes::S2071::chamfer_or_rounding_stands_in_block())
    }

    fn negative<T>(&self, span: Span) -> Outcome<T> {
        self.refuse(span, codes::S2071::chamfer_or_rounding_is_negative())
    }

    /// What the control does with a corner that does not fit.
    pub(super) fn large_corner(&self) -> LargeCorner {
        if self.job.settings.control.sinumerik.shorten_corners {
            LargeCorner::Shorten
        } else {
            LargeCorner::Ask(&LARGE)
        }
    }

    pub(super) fn arc_chamfer(&self) -> ArcChamfer {
        if self.job.settings.control.sinumerik.arc_chamfers {
            ArcChamfer::AcrossBisector
        } else {
            ArcChamfer::Ask(&AT_ARC)
        }
    }
}
