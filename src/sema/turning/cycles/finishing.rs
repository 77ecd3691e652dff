//! G890, finishing along a contour: its parameters and their defaults.
//!
//! Source: T 8.10; the letters H, I, K, D, E and O: MANUALplus 620 smart.Turn and DIN, page 119 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Element, Point2, Vec2, cross, left};
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::finishing::{ArcFeed, Descending, Finishing, FinishingEnd, Way};
use crate::ir::cycle::roughing::Nose;
use crate::ir::cycle::turning::Towards;
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Rule, length, number};

use super::super::blank::Blank;
use super::super::technology::Oversize;
use super::{
    Contour, CycleCall, DESCENDING, ENDS, ID, LEFT_OUT, LIMIT_X, LIMIT_Z, NE, NS, Need, Planned, Row, Unbuilt, one,
    word,
};

/// Turns of the spindle that an arc takes at least, unless O1 is programmed.
const TURNS_ON_AN_ARC: f64 = 4.0;
/// Share of the feed on descending elements where E is missing: the least that the control takes.
const DESCENDING_SHARE: f64 = 0.5;
/// How little a point may lie off the line through the ends of the contour to be on it, mm.
const ON_LINE: f64 = 1e-6;

pub(super) const ROWS: &[Row] = &[Row::new(
    890,
    "G890",
    "finishing",
    "MANUALplus 620, G890; CNC PILOT 640, p. 336",
    &[
        NS,
        NE,
        ID,
        DESCENDING.unsigned(),
        ENDS,
        number("Q", "way of the approach; refused where it is not 0").rule(Rule::OneOf(0, 4)).default("0"),
        number("H", "way of the retraction").rule(Rule::OneOf(0, 8)).default("3"),
        LIMIT_X,
        LIMIT_Z,
        LEFT_OUT,
        length("I", "end point, diameter"),
        length("K", "end point along Z"),
        number("O", "feed on small arcs 0 reduced, 1 as it is").rule(Rule::OneOf(0, 1)).default("0"),
        number("U", "element in the words of G80; refused where it is not 0").default("0"),
        number("B", "refused where it is not 0").default("0"),
    ],
    |call| call.finishing(),
)
.contour(Contour::Referenced)
.unbuilt(&[
    Unbuilt::all(word::X, |_| codes::T9007::cutting_limit_is_not_supported()),
    Unbuilt::all(word::Z, |_| codes::T9007::cutting_limit_is_not_supported()),
    Unbuilt::not_zero(word::Q, |_| codes::T9007::how_q_chooses_approach_no_manual()),
    Unbuilt::not_zero(word::U, |_| codes::T9007::u_names_element_in_words_of_g80()),
    Unbuilt::not_zero(word::B, |_| codes::T9007::what_b_of_g890_means_no_manual()),
    Unbuilt::one(word::V, 4.0, |_| codes::T9007::v4_only_chamfer_or_rounding_of_element()),
])
.requires(&[Need::Feed])];

/// Does the contour turn away from the tool anywhere? At a distance the path goes around such a corner on an arc.
fn has_outer_corner(contour: &[Element], tool_is_left: bool) -> bool {
    contour.windows(2).any(|pair| {
        let turn = cross(pair[0].to() - pair[0].from(), pair[1].to() - pair[1].from());
        if tool_is_left { turn < -ON_LINE } else { turn > ON_LINE }
    })
}

/// Where the tool is, seen from the contour.
pub(super) struct Stance {
    pub left: bool,
    pub into: Towards,
    pub away: Vec2,
}

impl CycleCall<'_> {
    fn finishing(&self) -> Planned {
        let section = self.contour()?;
        let contour = section.elements();
        let nose = self.nose_of_tool()?;
        let stance = self.stance(&contour, nose)?;
        self.check_forms(section, stance.left)?;
        let plunging = self.given.length_if(word::E);
        let left_out = plunging.filter(|feed| *feed == 0.0).map(|_| stance.into.unit());
        self.nose_matters_not(&contour, stance.left, left_out)?;
        let feed = self.feed()?;
        let descending = match plunging {
            None => {
                if descends(&contour, stance.into) {
                    self.say(codes::T2028::descending_elements_are_cut_at_half_feed());
                }
                Descending::Cut { feed: reduced(feed) }
            }
            Some(0.0) => Descending::Left,
            Some(own) => Descending::Cut { feed: feed.with_value(own) },
        };
        let speed = self.st.modal.spindle.speed_in_turns();
        let arcs = match self.given.whole(word::O) {
            0 => ArcFeed::Turns { turns: TURNS_ON_AN_ARC, speed },
            _ => ArcFeed::Same,
        };
        let (oversize, shift) = self.finishing_oversize(&contour, &stance)?;
        if oversize != 0.0 && has_outer_corner(&contour, stance.left) {
            self.arc_needs_nose()?;
        }
        one(Cycle::Finishing(Finishing {
            contour,
            around_left: stance.left != section.backwards,
            around: section.whole.clone(),
            into: stance.into,
            left: stance.left,
            nose: nose.unwrap_or_default(),
            oversize,
            shift,
            away: stance.away,
            clearance: self.clearance(),
            blank: self.st.modal.stock.uncut_bar(self.st.blank),
            feed,
            descending,
            arcs,
            end: self.finishing_end()?,
        }))
    }

    fn finishing_end(&self) -> Made<FinishingEnd> {
        let kind = self.given.number(word::H).map_or(3, |kind| kind as i32);
        if (3..=7).contains(&kind)
            && let Some(name) = [word::I, word::K].into_iter().find(|name| self.given.has(*name))
        {
            return self.refuse_argument(name, codes::P1003::i_k_are_end_position(&kind));
        }
        let needed = |name, what: &str| match self.given.length_if(name) {
            Some(length) => Ok(length),
            None => self.refuse_argument(word::H, codes::P1004::is_missing(&name, &what)),
        };
        let point = || -> Made<Point2> {
            let x = needed(word::I, "the X of the end position, as a diameter")?;
            Ok(Point2::new(needed(word::K, "the Z of the end position")?, x / 2.0))
        };
        let to = |way: Way| point().map(|to| FinishingEnd::Point { to, way });
        match kind {
            0 => to(Way::Diagonal),
            1 => to(Way::XThenZ),
            2 => to(Way::ZThenX),
            8 => to(Way::AtFeed),
            4 => Ok(FinishingEnd::Stay),
            5 => Ok(FinishingEnd::Start { way: Way::Diagonal }),
            6 => Ok(FinishingEnd::Start { way: Way::XThenZ }),
            7 => Ok(FinishingEnd::Start { way: Way::ZThenX }),
            _ => Ok(FinishingEnd::Lift),
        }
    }

    /// G57 moves the contour away from the part, G58 is measured at right angles to it.
    fn finishing_oversize(&self, contour: &[Element], stance: &Stance) -> Made<(f64, Vec2)> {
        match self.st.modal.oversize {
            None => Ok((0.0, Vec2::zeros())),
            Some((Oversize::Equidistant(p), _)) => Ok((p, Vec2::zeros())),
            Some((Oversize::Paraxial { x, z }, _))
                if x >= 0.0 && z >= 0.0 && (z == 0.0 || !descends(contour, stance.into)) =>
            {
                Ok((0.0, Vec2::new(z * stance.away.x, x / 2.0 * stance.away.y)))
            }
            Some((_, place)) => self.no_oversize(place, codes::T9007::oversize_does_not_fit_contour()),
        }
    }

    /// On which side of the contour the tool works: told by its edge, else by where it stands.
    pub(super) fn stance(&self, contour: &[Element], nose: Option<Nose>) -> Made<Stance> {
        let (Some(first), Some(last)) = (contour.first(), contour.last()) else {
            return self.refuse(codes::T3003::contour_has_no_element());
        };
        let chord = last.to() - first.from();
        let aside = left(chord);
        let side = match nose {
            Some(nose) => -nose.tip.dot(&aside),
            None => cross(chord, self.st.at - first.from()),
        };
        if side.abs() <= ON_LINE * aside.norm().max(1.0) {
            return self.refuse(codes::T2025::side_of_contour_is_not_clear());
        }
        let is_left = side > 0.0;
        let free = if is_left { aside } else { -aside };
        let outside = if chord.x.abs() <= ON_LINE { nose.is_none_or(|nose| nose.tip.y < 0.0) } else { free.y > 0.0 };
        let bored = matches!(self.st.blank, Some(Blank::Bar { bore, .. }) if bore > 0.0)
            || matches!(self.st.blank, Some(Blank::Casting { bore: true, .. }));
        if !outside && !bored && nose.is_none() {
            return self.refuse(codes::T2025::tool_stands_below_contour());
        }
        let out = if outside { 1.0 } else { -1.0 };
        // A contour that only goes inwards, more than it goes along, is faced.
        let rises = contour.iter().any(|e| (e.to().y - e.from().y) * out > ON_LINE);
        let faces = chord.x.abs() <= ON_LINE || (!rises && chord.y.abs() > chord.x.abs());
        let into = match (faces, outside) {
            (true, _) if free.x > 0.0 => Towards::MinusZ,
            (true, _) => Towards::PlusZ,
            (false, true) => Towards::MinusX,
            (false, false) => Towards::PlusX,
        };
        let away = match nose {
            Some(nose) => -nose.tip,
            None if faces => Vec2::new(free.x.signum(), -chord.y.signum()),
            None => Vec2::new(-chord.x.signum(), out),
        };
        Ok(Stance { left: is_left, into, away })
    }
}

/// Of descending elements where E is missing.
pub(super) fn reduced(feed: Feed) -> Feed {
    feed.with_value(feed.value() * DESCENDING_SHARE)
}

/// Does any element go into the material?
fn descends(contour: &[Element], into: Towards) -> bool {
    contour.iter().any(|e| (e.to() - e.from()).dot(&into.unit()) > ON_LINE)
}
