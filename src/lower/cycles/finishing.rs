//! Finishing: down to the start of the contour, once along it, and off it.
//!
//! ```text
//!       ╲ lift                      ╱ approach
//!        ╲                         ╱
//!   ══════╲◄════╗           ╔═════◄
//!               ╚═══════════╝
//! ```

use crate::diag::{Fault, codes};
use crate::geo::offset::{NoParallel, OffsetElement};
use crate::geo::profile::{Grown, Profile, elements};
use crate::geo::{Element, Point2, SAME_POINT, Vec2, distance};
use crate::ir::Feed;
use crate::ir::cycle::Family;
use crate::ir::cycle::finishing::{ArcFeed, Descending, Finishing, FinishingEnd, Way};

use super::track::{Strokes, Track, View};
use super::{CycleItem, Expand, Start};

/// What arithmetic loses in a distance, mm.
const SLACK: f64 = 1e-6;

impl Expand for Finishing {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        expand(self, start.in_turning_plane()?, &mut |stroke| out(stroke.part()))
    }
}

/// Sends the strokes of `finishing`; the tool stands at `from`.
///
/// # Errors
/// G3041 bad arguments, G3047 descending parts that cannot be left out, G3048 no free way to the contour or from
/// it, G3049 no room for the nose.
pub fn expand<'a>(finishing: &Finishing, from: Point2, out: &'a mut Strokes<'a>) -> Result<(), Fault> {
    finishing.check().map_err(|fault| codes::G3041::finishing_makes_no_path(&fault))?;
    let left_out = match finishing.descending {
        Descending::Left => Some(level(finishing)?),
        Descending::Cut { .. } => None,
    };
    let contour = left_out.as_deref().unwrap_or(&finishing.contour);
    let path = finishing.path(contour).map_err(no_parallel)?;
    let mut cutter = Cutter { track: Track::new(View::plain(), from, out), finishing, path: &path };
    cutter.approach(from)?;
    for part in &path {
        let feed = feed_on(finishing, &part.element, contour.get(part.of));
        match part.element {
            Element::Line { to, .. } => cutter.track.line(to, feed),
            Element::Arc { to, center, sweep, .. } => cutter.track.arc(to, center, sweep > 0.0, feed),
        }
    }
    cutter.retract(from)
}

/// The contour with its descending parts left out.
fn level(finishing: &Finishing) -> Result<Vec<Element>, Fault> {
    let (Some(first), Some(last)) = (finishing.contour.first(), finishing.contour.last()) else {
        return Ok(Vec::new());
    };
    let way = last.to() - first.from();
    let along = if finishing.into.is_radial() { way.x } else { way.y };
    let view = View::new(finishing.into, along);
    let contour: Vec<Element> = finishing.contour.iter().map(|element| view.element(element)).collect();
    let start = view.point(first.from());
    let legs = Profile::new(&contour, Grown::default()).rise(start, view.point(last.to()));
    let level = elements(start, &legs).iter().map(|element| view.element_on_part(element)).collect();
    Ok(level)
}

fn no_parallel(why: NoParallel) -> Fault {
    match why {
        NoParallel::TooNarrow => codes::G3049::nose_of_tool_has_no_room_in_recess(),
        NoParallel::Reversal => codes::G3049::contour_turns_back_on_itself(),
        NoParallel::Empty => codes::G3049::contour_has_no_length(),
    }
}

/// Feed on a piece of the path that comes from the element `of`.
fn feed_on(finishing: &Finishing, element: &Element, of: Option<&Element>) -> Feed {
    let feed = match finishing.descending {
        Descending::Cut { feed } if of.is_some_and(|of| descends(of, finishing.into.unit())) => feed,
        _ => finishing.feed,
    };
    // The roundings that the nose makes of outer corners are no arcs of the contour.
    let (Element::Arc { .. }, Some(of @ Element::Arc { .. }), ArcFeed::Turns { turns, speed }) =
        (element, of, finishing.arcs)
    else {
        return feed;
    };
    let most = match feed {
        Feed::PerRevolution(_) => of.length() / turns,
        Feed::PerMinute(_) => speed.map_or(f64::INFINITY, |speed| of.length() / turns * speed),
        // No cycle has its feed by time.
        Feed::InverseTime(_) => f64::INFINITY,
    };
    if feed.value() > most && most > 0.0 { feed.with_value(most) } else { feed }
}

/// Does the element go into the material from its start to its end?
fn descends(element: &Element, into: Vec2) -> bool {
    (element.to() - element.from()).dot(&into) > SAME_POINT
}

struct Cutter<'c> {
    track: Track<'c>,
    finishing: &'c Finishing,
    path: &'c [OffsetElement],
}

impl Cutter<'_> {
    /// To beside the start at rapid traverse, then down to it.
    fn approach(&mut self, from: Point2) -> Result<(), Fault> {
        let Some(start) = self.path.first().map(|part| part.element.from()) else { return Ok(()) };
        if distance(from, start) <= SAME_POINT {
            return Ok(());
        }
        let beside = self.finishing.beside(start).ok_or_else(codes::G3048::there_is_no_room_beside_start)?;
        let ways =
            [vec![beside], vec![Point2::new(from.x, beside.y), beside], vec![Point2::new(beside.x, from.y), beside]];
        let Some(way) = ways.iter().find(|way| self.is_free(from, way)) else {
            return Err(codes::G3048::tool_cannot_travel_from_where_it_stands());
        };
        let Some(way) = ways.iter().find(|way| self.is_free(from, way) && !self.passes_blank(from, way)) else {
            return Err(codes::G3048::rapid_approach_to_x_z_leads_through(
                &(2.0 * way.last().map_or(0.0, |to| to.y)),
                &way.last().map_or(0.0, |to| to.x),
            ));
        };
        for to in way {
            self.track.rapid(*to);
        }
        self.track.line(start, self.finishing.feed);
        Ok(())
    }

    fn passes_blank(&self, from: Point2, way: &[Point2]) -> bool {
        let mut at = from;
        way.iter().any(|to| self.finishing.through_blank(std::mem::replace(&mut at, *to), *to))
    }

    fn retract(&mut self, from: Point2) -> Result<(), Fault> {
        if self.finishing.end == FinishingEnd::Stay {
            return Ok(());
        }
        let beside = self.finishing.beside(self.track.at()).ok_or_else(codes::G3048::there_is_no_room_beside_end)?;
        self.track.line(beside, self.finishing.feed);
        let (to, way) = match self.finishing.end {
            FinishingEnd::Stay | FinishingEnd::Lift => return Ok(()),
            FinishingEnd::Point { to, way } => (to, way),
            FinishingEnd::Start { way } => (from, way),
        };
        let stops = match way {
            Way::Diagonal | Way::AtFeed => vec![to],
            Way::XThenZ => vec![Point2::new(beside.x, to.y), to],
            Way::ZThenX => vec![Point2::new(to.x, beside.y), to],
        };
        if !self.is_free(beside, &stops) {
            return Err(codes::G3048::way_from_end_of_contour_to_end());
        }
        for stop in stops {
            match way {
                Way::AtFeed => self.track.line(stop, self.finishing.feed),
                _ => self.track.rapid(stop),
            }
        }
        Ok(())
    }

    /// Does the way keep the clearance from the contour, or as much of it as its ends have?
    fn is_free(&self, from: Point2, way: &[Point2]) -> bool {
        let to = way.last().copied().unwrap_or(from);
        let clear = |a, b| self.finishing.clear(a, b);
        let least = self.finishing.clearance.min(clear(from, from)).min(clear(to, to));
        let mut at = from;
        least > SLACK && way.iter().all(|to| clear(std::mem::replace(&mut at, *to), *to) >= least - SLACK)
    }
}

#[cfg(test)]
mod tests;
