//! G89 of the 4110: one cut along the contour behind the cycle, with the nose radius compensated where G41 or G42 stands in
//! the block after it.
//!
//! Source: T 7 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Vec2;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::finishing::{ArcFeed, Descending, Finishing, FinishingEnd, Way};
use crate::ir::cycle::roughing::Nose;

use super::outline::Outline;
use super::readings::Question;
use super::technology::Oversize;
use super::words::{Fun, Words};
use super::{Outcome, Run};

impl Run<'_> {
    /// `side`: G41 or G42 of the block behind the cycle.
    pub(super) fn contour_finishing(&mut self, w: &Words, outline: Option<&Outline>, side: Option<Fun>) -> Outcome {
        let at = self.stand()?;
        for (letter, what) in [(b'B', "the first corner of the section"), (b'J', "the element in front of it")] {
            if let Some(num) = w.get(letter).filter(|num| num.value != 0.0) {
                return self.refuse(num.span, codes::T9007::of_g89_how_it_makes_is_shown(&(letter as char), &what));
            }
        }
        let section = self.contour_of(w, outline, 0)?;
        let contour = section.elements();
        let nose = match side {
            // The programmed point follows the contour.
            None => None,
            Some(fun) => {
                self.depends_on(Question::FinishingSide, self.block_span());
                match self.nose_of_tool()? {
                    Some(nose) => Some(nose),
                    None if self.known_tool().and_then(|tool| tool.radius) == Some(0.0) => None,
                    None => {
                        return self.refuse(
                            self.block_span(),
                            codes::P2004::g_compensates_nose_radius_of_tool(&fun.number).help(self.asks_for_nose()),
                        );
                    }
                }
            }
        };
        // The edge tells the side, whether its radius is compensated or not.
        let edge = nose.or_else(|| self.tip_of_tool().map(|tip| Nose { radius: 0.0, tip }));
        let stance = self.stance(&contour, at, edge)?;
        self.check_forms(&section, stance.left)?;
        let oversize = match (w.get(b'I'), self.st.oversize) {
            (Some(num), _) => num.value * self.st.mm(),
            (None, None) => 0.0,
            (None, Some((Oversize::Equidistant(p), _))) => p,
            (None, Some((_, loc))) => return self.oversize_refused(loc, "G57 does not belong to G89"),
        };
        let (end, clearance) = match w.get(b'K') {
            None => (FinishingEnd::Start { way: Way::Diagonal }, self.cycle_clearance()),
            Some(num) if num.value == 0.0 => (FinishingEnd::Stay, self.cycle_clearance()),
            Some(num) => (FinishingEnd::Lift, self.above_zero(num, "the way by which the tool lifts off")?),
        };
        let feed = self.cutting_feed()?;
        let finishing = Finishing {
            contour,
            around_left: stance.left,
            around: section.whole,
            into: stance.into,
            left: stance.left,
            nose: nose.unwrap_or_default(),
            oversize,
            shift: Vec2::zeros(),
            away: stance.away,
            clearance,
            blank: self.uncut_bar(),
            feed,
            descending: Descending::Cut { feed },
            arcs: ArcFeed::Same,
            end,
        };
        self.send_cycle(&Cycle::Finishing(finishing));
        self.st.oversize = None;
        Ok(())
    }
}
