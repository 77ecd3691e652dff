//! G89 of the 4110: one cut along the contour behind the cycle, with the nose radius compensated where G41 or G42 stands in
//! the block after it.
//!
//! Source: T 7 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::geo::Vec2;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::finishing::{ArcFeed, Descending, Finishing, FinishingEnd, Way};
use crate::ir::cycle::roughing::Nose;
use crate::sema::cycle::call::{Elsewhere, Made};
use crate::sema::cycle::row::{length, number};

use super::super::readings::Question;
use super::super::technology::Oversize;
use super::super::words::Fun;
use super::{Contour, CycleCall, Need, Planned, Row, Unbuilt, one, word};

pub(super) const ROWS: &[Row] = &[Row::new(
    89,
    "G89",
    "contour finishing",
    "4110P, p. 67",
    &[
        length("B", "first corner; refused where it is not 0").default("0"),
        length("I", "oversize along the contour").default("that of G58"),
        length("K", "lift: 0 stays").unsigned().default("back to the start"),
        number("J", "reference element; refused where it is not 0").default("0"),
    ],
    |call| call.contour_finishing(),
)
.contour(Contour::Follows)
.unbuilt(&[
    Unbuilt::not_zero(word::B, |it| {
        codes::T9007::of_g89_how_it_makes_is_shown(&it.word, &"the first corner of the section")
    }),
    Unbuilt::not_zero(word::J, |it| codes::T9007::of_g89_how_it_makes_is_shown(&it.word, &"the element before it")),
])
.requires(&[Need::Feed])];

impl CycleCall<'_> {
    fn contour_finishing(&self) -> Planned {
        let section = self.contour()?;
        let contour = section.elements();
        let nose = match self.st.side {
            // The programmed point follows the contour.
            None => None,
            Some(side) => self.nose_on_side(side)?,
        };
        // The edge tells the side, whether its radius is compensated or not.
        let edge = nose.or_else(|| self.tip_of_tool().map(|tip| Nose { radius: 0.0, tip }));
        let stance = self.stance(&contour, edge)?;
        self.check_forms(section, stance.left)?;
        let oversize = match (self.given.length_if(word::I), self.st.modal.oversize) {
            (Some(oversize), _) => oversize,
            (None, None) => 0.0,
            (None, Some((Oversize::Equidistant(p), _))) => p,
            (None, Some((_, place))) => {
                let fault = codes::T9007::g57_does_not_belong_to_g89();
                return self.refuse_elsewhere(Elsewhere { place, fault, call: Label::Cycle });
            }
        };
        let (end, clearance) = match self.given.length_if(word::K) {
            None => (FinishingEnd::Start { way: Way::Diagonal }, self.clearance()),
            Some(0.0) => (FinishingEnd::Stay, self.clearance()),
            Some(lift) => (FinishingEnd::Lift, lift),
        };
        let feed = self.feed()?;
        one(Cycle::Finishing(Finishing {
            contour,
            around_left: stance.left,
            around: section.whole.clone(),
            into: stance.into,
            left: stance.left,
            nose: nose.unwrap_or_default(),
            oversize,
            shift: Vec2::zeros(),
            away: stance.away,
            clearance,
            blank: self.st.modal.stock.uncut_bar(self.st.blank),
            feed,
            descending: Descending::Cut { feed },
            arcs: ArcFeed::Same,
            end,
        }))
    }

    /// The nose that G41 or G42 in the block behind the cycle compensates.
    fn nose_on_side(&self, side: Fun) -> Made<Option<Nose>> {
        self.depends_on(Question::FinishingSide, self.given.place);
        if let Some(nose) = self.nose_of_tool()? {
            return Ok(Some(nose));
        }
        if self.known_tool().and_then(|tool| tool.radius) == Some(0.0) {
            return Ok(None);
        }
        self.refuse(match self.st.modal.tool.as_ref() {
            Some(tool) => codes::P2004::g_compensates_nose_radius_of_tool(&side.number, &tool.number)
                .answers(self.answers_of_nose(tool.number)),
            None => codes::P2004::g_compensates_nose_radius_of_no_tool(&side.number),
        })
    }
}
