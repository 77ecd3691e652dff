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

use super::geometry::Blank;
use super::outline::Outline;
use super::technology::Oversize;
use super::words::Words;
use super::{Outcome, Run};

/// Turns of the spindle that an arc takes at least, unless O1 is programmed.
const TURNS_ON_AN_ARC: f64 = 4.0;
/// Share of the feed on descending elements where E is missing: the least that the control takes.
const DESCENDING_SHARE: f64 = 0.5;
/// How little a point may lie off the line through the ends of the contour to be on it, mm.
const ON_LINE: f64 = 1e-6;

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

impl Run<'_> {
    pub(super) fn finishing(&mut self, w: &Words, outline: Option<&Outline>) -> Outcome {
        let at = self.stand()?;
        self.refuse_finishing_words(w)?;
        let section = self.contour_with_ends(w, outline)?;
        let contour = section.elements();
        let nose = self.nose_of_tool()?;
        let stance = self.stance(&contour, at, nose)?;
        self.check_forms(&section, stance.left)?;
        let left_out = w.get(b'E').filter(|num| num.value == 0.0).map(|_| stance.into.unit());
        self.nose_matters_not(&contour, stance.left, left_out)?;
        let feed = self.cutting_feed()?;
        let descending = match w.get(b'E') {
            None => {
                if descends(&contour, stance.into) {
                    self.note_descending();
                }
                Descending::Cut { feed: reduced(feed) }
            }
            Some(num) if num.value == 0.0 => Descending::Left,
            Some(num) => Descending::Cut { feed: feed.with_value(self.above_zero(num, "the plunging feed")?) },
        };
        let speed = self.st.spindle.turns();
        let arcs = match self.choice(w, b'O', 0, 1)? {
            0 => ArcFeed::Turns { turns: TURNS_ON_AN_ARC, speed },
            _ => ArcFeed::Same,
        };
        let (oversize, shift) = self.finishing_oversize(&contour, &stance)?;
        if oversize != 0.0 && has_outer_corner(&contour, stance.left) {
            self.arc_needs_nose()?;
        }
        let finishing = Finishing {
            contour,
            around_left: stance.left != section.backwards,
            around: section.whole,
            into: stance.into,
            left: stance.left,
            nose: nose.unwrap_or_default(),
            oversize,
            shift,
            away: stance.away,
            clearance: self.cycle_clearance(),
            blank: self.uncut_bar(),
            feed,
            descending,
            arcs,
            end: self.finishing_end(w)?,
        };
        self.send_cycle(&Cycle::Finishing(finishing));
        self.st.oversize = None;
        Ok(())
    }

    /// Words whose effect on the path no text at hand describes.
    fn refuse_finishing_words(&self, w: &Words) -> Outcome {
        let why = |letter: u8| match letter {
            b'Q' => "how Q chooses the approach no manual at hand says",
            b'U' => "U names an element in the words of G80, which is not supported",
            b'B' => "what B of G890 means no manual at hand says",
            _ => "a cutting limit is not supported: to which side it holds is shown in a picture only",
        };
        for letter in [b'X', b'Z', b'Q', b'U', b'B'] {
            let limit = matches!(letter, b'X' | b'Z');
            if let Some(num) = w.get(letter).filter(|num| limit || num.value != 0.0) {
                return self.fail_help(
                    codes::T9007,
                    num.span,
                    why(letter),
                    "leave the word out, and name the elements to be finished with NS and NE",
                );
            }
        }
        Ok(())
    }

    fn finishing_end(&self, w: &Words) -> Outcome<FinishingEnd> {
        let kind = self.choice(w, b'H', 3, 8)?;
        if let (3..=7, Some(num)) = (kind, w.get(b'I').or(w.get(b'K'))) {
            return self.refuse(num.span, codes::P1003::i_k_are_end_position(&kind));
        }
        let point = || -> Outcome<Point2> {
            let i =
                self.needed(w, b'I', "the X of the end position, as a diameter", w.span(b'H', self.block_span()))?;
            let k = self.needed(w, b'K', "the Z of the end position", w.span(b'H', self.block_span()))?;
            let mm = self.st.mm();
            Ok(Point2::new(k.value * mm, i.value * mm / 2.0))
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
    fn finishing_oversize(&self, contour: &[Element], stance: &Stance) -> Outcome<(f64, Vec2)> {
        match self.st.oversize {
            None => Ok((0.0, Vec2::zeros())),
            Some((Oversize::Equidistant(p), _)) => Ok((p, Vec2::zeros())),
            Some((Oversize::Paraxial { x, z }, _))
                if x >= 0.0 && z >= 0.0 && (z == 0.0 || !descends(contour, stance.into)) =>
            {
                Ok((0.0, Vec2::new(z * stance.away.x, x / 2.0 * stance.away.y)))
            }
            Some((_, loc)) => self.oversize_refused(loc, "this oversize does not fit the contour behind it"),
        }
    }

    /// On which side of the contour the tool works: told by its edge, else by where it stands.
    pub(super) fn stance(&self, contour: &[Element], at: Point2, nose: Option<Nose>) -> Outcome<Stance> {
        let (Some(first), Some(last)) = (contour.first(), contour.last()) else {
            return self.refuse(self.block_span(), codes::T3003::contour_has_no_element());
        };
        let chord = last.to() - first.from();
        let aside = left(chord);
        let side = match nose {
            Some(nose) => -nose.tip.dot(&aside),
            None => cross(chord, at - first.from()),
        };
        if side.abs() <= ON_LINE * aside.norm().max(1.0) {
            return self.side_unclear("it is not clear on which side of the contour the tool works");
        }
        let is_left = side > 0.0;
        let free = if is_left { aside } else { -aside };
        let outside = if chord.x.abs() <= ON_LINE { nose.is_none_or(|nose| nose.tip.y < 0.0) } else { free.y > 0.0 };
        let bored = matches!(self.geometry.blank, Some(Blank::Bar { bore, .. }) if bore > 0.0)
            || matches!(self.geometry.blank, Some(Blank::Casting { bore: true, .. }));
        if !outside && !bored && nose.is_none() {
            return self.side_unclear("the tool stands below the contour, and no bore is known");
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

    fn side_unclear<T>(&self, message: &str) -> Outcome<T> {
        self.fail_help(
            codes::T2025,
            self.block_span(),
            message,
            "position the tool clear of the contour, on the side from which it is turned; for a bore give I of G20, or \
             `radius` and `orientation` of the tool in partc.toml",
        )
    }

    pub(super) fn note_descending(&self) {
        let found = codes::T2028::descending_elements_are_cut_at_half_feed().at(self.here.origin.loc);
        self.report(found.help("program E with the feed for descending elements"));
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
