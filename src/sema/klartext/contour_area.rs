//! The contours that cycles take: pockets less islands for cycles 21 to 24, one contour for cycle 25.
//!
//! Source: K 6.6; F B7 (docs/sources.md). How contours that cross are taken together is the HEIDENHAIN manuals' rule of superimposed
//! contours: it goes by where their start points lie.

use crate::diag::{self, codes};
use crate::geo::area::{Relation, is_counter_clockwise, meet, passes, relation, surrounds};
use crate::geo::overlay::{Area, Touching, overlay};
use crate::geo::tolerance;
use crate::geo::{Element, Point2, corner, grid};
use crate::ir::Side;
use crate::ir::captured::Captured;

use super::cycles::DefinedCycle;
use super::cycles::data::{Contours, NamedContours, Train};
use super::labels::Label;
use super::place::View;
use super::{Core, Outcome, Reported, Run};

/// Elements that turn by less go on into each other, rad: their points lie on a grid.
const GOES_ON: f64 = 1e-6;

/// A closed contour.
struct Closed<'a> {
    label: &'a Label,
    is_pocket: bool,
    elements: Vec<Element>,
}

impl Closed<'_> {
    fn start(&self) -> Point2 {
        self.elements.first().map_or_else(Point2::origin, Element::from)
    }

    /// Does it go around a point?
    fn holds(&self, p: Point2) -> bool {
        surrounds(&self.elements, p)
    }

    fn kind(&self) -> &'static str {
        if self.is_pocket { "pocket" } else { "island" }
    }
}

impl Run<'_> {
    /// Pockets and islands; inside corners are rounded so that the path `away` from them keeps the radius Q8 = `corners`.
    pub(super) fn contour_area(
        &mut self,
        cycle: &DefinedCycle,
        contours: &NamedContours,
        (corners, away): (f64, f64),
    ) -> Outcome<Area> {
        let mut closed = Vec::with_capacity(contours.labels.len());
        for label in &contours.labels {
            let contour = self.capture(label, cycle.loc)?;
            self.contours.check(self.view(), label, &contour)?;
            closed.push(self.contours.closed(&self.core, label, &contour)?);
        }
        let area = taken_together(&closed);
        let area = area.or_else(|(what, help)| self.contours.no_area(&self.core, cycle, contours, (what, help)))?;
        let as_named = |chain: &Vec<Element>| closed.iter().any(|one| one.elements == *chain);
        if !area.outlines.iter().chain(&area.islands).all(as_named) {
            self.core.job.diags.push_once(codes::K8110::contours_of_cycle_14_cross().at(contours.loc));
        }
        if corners == 0.0 {
            return Ok(area);
        }
        with_rounded_corners(&area, grid::on_grid(corners + away)).or_else(|()| {
            let help = "set Q8 to 0, or take a smaller cutter";
            let what = format!("an inside corner has no room for the radius Q8 = {corners} of the path");
            match &contours.labels[..] {
                [label] => self.contours.fault(&self.core, label, &what, help),
                _ => self.contours.no_area(&self.core, cycle, contours, (what, help)),
            }
        })
    }

    /// The contour that cycle 25 follows: the first one of cycle 14, and what cycle 270 says of it.
    pub(super) fn train_of(&mut self, cycle: &DefinedCycle, named: &NamedContours) -> Outcome<Train> {
        if named.labels.len() > 1 {
            let found = codes::K2954::cycle_25_mills_first_contour_of_cycle().at(self.core.here.origin.loc);
            self.core.report(found.also(named.loc, diag::Label::NamedHere));
        }
        let Some(label) = named.labels.first() else { return Err(Reported) };
        let contour = self.capture(label, cycle.loc)?;
        self.contours.check(self.view(), label, &contour)?;
        let Some(side) = contour.side else {
            let help = "write RL, RR or nothing into its first block, and nothing after it";
            return self.contours.fault(&self.core, label, "its side changes", help);
        };
        let data = self.contours.train.read(self.reading())?;
        Ok(Train { elements: contour.pieces.iter().map(|piece| piece.element).collect(), side, data })
    }
}

impl Contours {
    /// Elements that make a contour.
    pub(super) fn check(&self, view: View<'_, '_>, label: &Label, contour: &Captured) -> Outcome {
        if contour.plane != view.st.plane() || contour.pieces.is_empty() {
            return self.fault(
                view.core,
                label,
                "it has no element in the working plane",
                "program its elements after its start point",
            );
        }
        if let Some((first, second)) = contour.crossing()
            && let (Some(a), Some(b)) = (contour.pieces.get(first), contour.pieces.get(second))
        {
            let found = codes::K2951::contour_crosses_itself(&label).at(b.origin.loc).called(b.origin.call);
            view.core.report(found.also(a.origin.loc, diag::Label::Crosses).help("check the end points of both"));
            return Err(Reported);
        }
        Ok(())
    }

    fn closed<'a>(&self, core: &Core<'_>, label: &'a Label, contour: &Captured) -> Outcome<Closed<'a>> {
        if !contour.is_closed() {
            return self.fault(core, label, "it is not closed", "end it where it starts");
        }
        let mut elements: Vec<Element> = contour.pieces.iter().map(|piece| piece.element).collect();
        if let Some(Element::Line { to, .. } | Element::Arc { to, .. }) = elements.last_mut() {
            *to = contour.start;
        }
        // From here on a coordinate is the same number, however it was computed.
        let elements = grid::chain(&elements);
        // With the tool inside it is a pocket.
        let is_pocket = match contour.side {
            Some(Side::Left) => is_counter_clockwise(&elements),
            Some(Side::Right) => !is_counter_clockwise(&elements),
            Some(Side::None) | None => {
                let help = "write RL or RR into its first block";
                return self.fault(core, label, "neither RL nor RR says whether it is a pocket or an island", help);
            }
        };
        Ok(Closed { label, is_pocket, elements })
    }
}

/// All pockets, less all islands; else why they make no area, and what to do.
fn taken_together(closed: &[Closed<'_>]) -> Result<Area, (String, &'static str)> {
    for (at, second) in closed.iter().enumerate() {
        for first in &closed[..at] {
            belongs_to(first, second)?;
        }
    }
    let (pockets, islands): (Vec<&Closed<'_>>, Vec<&Closed<'_>>) = closed.iter().partition(|one| one.is_pocket);
    if pockets.is_empty() {
        let what = "all of its contours are islands: RL or RR leads the tool outside of them";
        return Err((what.to_owned(), "name the pocket around them, or swap RL and RR"));
    }
    if let Some(alone) = islands.iter().find(|island| !pockets.iter().any(|pocket| pocket.holds(island.start()))) {
        let what = format!("the island {} does not begin in a pocket", alone.label);
        let help = "begin it inside a pocket, or leave it out of cycle 14; if it is a pocket, swap RL and RR";
        return Err((what, help));
    }
    let elements = |list: &[&Closed<'_>]| list.iter().map(|one| one.elements.clone()).collect::<Vec<_>>();
    let area = overlay(&elements(&pockets), &elements(&islands)).map_err(|Touching(first, second)| {
        let named: Vec<&Closed<'_>> = pockets.iter().chain(&islands).copied().collect();
        let what = match (named.get(first), named.get(second)) {
            (Some(first), Some(second)) => touch(first, second),
            _ => "contours touch".to_owned(),
        };
        (what, APART)
    })?;
    if area.outlines.is_empty() {
        return Err(("the islands take up all of the pockets".to_owned(), "check RL and RR"));
    }
    Ok(area)
}

const APART: &str = "let them cross clearly, or draw one contour around both";

fn touch(first: &Closed<'_>, second: &Closed<'_>) -> String {
    format!("the contours {} and {} touch or run along each other", first.label, second.label)
}

/// Is it certain what two contours make together? The second one is named after the first.
fn belongs_to(first: &Closed<'_>, second: &Closed<'_>) -> Result<(), (String, &'static str)> {
    let inside = |inner: &Closed<'_>, outer: &Closed<'_>, help| {
        let what = format!("the {} {} lies in the {} {}", inner.kind(), inner.label, outer.kind(), outer.label);
        Err((what, help))
    };
    let (a, b) = (first, second);
    match relation(&a.elements, &b.elements) {
        Relation::Apart => Ok(()),
        Relation::FirstInside if !a.is_pocket && b.is_pocket => Ok(()),
        Relation::SecondInside if a.is_pocket && !b.is_pocket => Ok(()),
        Relation::FirstInside => inside(a, b, "leave one of the two out of cycle 14, or mill them one after the other"),
        Relation::SecondInside => {
            inside(b, a, "leave one of the two out of cycle 14, or mill them one after the other")
        }
        Relation::Crossing if passes(&a.elements, b.start()) || passes(&b.elements, a.start()) => {
            Err((touch(a, b), "begin each of them at a point that is not on the other"))
        }
        Relation::Crossing => match (a.is_pocket, b.is_pocket) {
            (true, true) if b.holds(a.start()) => Err((
                format!("the pockets {} and {} cross, and the first one begins in the second one", a.label, b.label),
                "what they have in common is no pocket that partc makes: draw it as one contour; for both together let the first one begin \
                 outside the second one",
            )),
            (true, false) if b.holds(a.start()) => Err(apart_from(b, a)),
            (false, true) if a.holds(b.start()) => Err(apart_from(a, b)),
            _ => Ok(()),
        },
    }
}

fn apart_from(island: &Closed<'_>, pocket: &Closed<'_>) -> (String, &'static str) {
    let what = format!("the pocket {} begins in the island {}, which crosses it", pocket.label, island.label);
    (what, "begin the pocket outside the island: then it is certain what stays")
}

/// The area with its inside corners rounded.
fn with_rounded_corners(area: &Area, radius: f64) -> Result<Area, ()> {
    let all = |chains: &[Vec<Element>], left: bool| -> Result<Vec<Vec<Element>>, ()> {
        let turns = |chain: &[Element]| if is_counter_clockwise(chain) == left { 1.0 } else { -1.0 };
        chains.iter().map(|chain| rounded(chain.clone(), radius, turns(chain))).collect()
    };
    let made = Area { outlines: all(&area.outlines, true)?, islands: all(&area.islands, false)? };
    // What fills a corner may reach an island in it.
    let walls: Vec<&Vec<Element>> = made.outlines.iter().chain(&made.islands).collect();
    let apart = walls.iter().enumerate().all(|(at, wall)| !walls[..at].iter().any(|other| meet(other, wall)));
    if apart { Ok(made) } else { Err(()) }
}

/// A chain with its inside corners rounded: `turns` is 1 where they turn to the left, else -1.
fn rounded(mut elements: Vec<Element>, radius: f64, turns: f64) -> Result<Vec<Element>, ()> {
    let count = elements.len();
    if count < 2 {
        return Ok(elements);
    }
    let mut made: Vec<Option<Element>> = vec![None; count];
    for at in 0..count {
        let next = (at + 1) % count;
        let (before, after) = (elements[at], elements[next]);
        let (Some(u), Some(w)) = (before.end_direction(), after.start_direction()) else { return Err(()) };
        let turn = crate::geo::cross(u, w) * turns;
        if turn < -GOES_ON || turn <= GOES_ON && u.dot(&w) > 0.0 {
            continue;
        }
        let cut = corner::rounding(&before, &after, radius, tolerance::SAME).map_err(|_| ())?;
        let Some((center, ccw)) = cut.arc else { return Err(()) };
        elements[at] = before.ending_at(cut.leave);
        elements[next] = after.starting_at(cut.join);
        let sweep = crate::geo::arc::sweep(cut.leave, cut.join, center, ccw);
        made[at] = Some(Element::Arc { from: cut.leave, to: cut.join, center, sweep });
    }
    let parts = elements.into_iter().zip(made).flat_map(|(element, corner)| [Some(element), corner]).flatten();
    Ok(parts.filter(|part| part.length() > tolerance::SAME).collect())
}
