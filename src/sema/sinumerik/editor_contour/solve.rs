//! From records to elements with their geometry: what an element leaves open follows from its neighbours.

use crate::geo::open::{
    self, Center, Coord, Data, Entry, Fault, NOT_FIXED, Rules, Situation, Solution, Solutions, Start, Tag,
};
use crate::geo::{Deg, Point2, SAME_POINT, Vec2, arc, cross, direction, distance};
use crate::parser::sinumerik::records::{Heading, Keys, Record};
use crate::sema::chain::{Angles, Chain, Choice};

use super::made::Unsolved;

/// Stored values are rounded to three places.
const ROUNDED: f64 = 0.005;
/// How far an end point and the way to it may differ.
const SAME_END: f64 = 0.001 + 1e-9;
/// What rounded angles and points make of an arc.
const AIMED: f64 = 0.05;
/// Stored choices that were seen in programs, with their meaning.
const SEEN: [u32; 6] = [7, 207, 210, 14, 15, 17];
/// Solutions that lie closer together are one.
const ONE: f64 = 2e-3;

const RULES: Rules = Rules {
    // What is said twice is compared afterwards.
    agrees: f64::INFINITY,
    touch: 1e-3,
    smooth_touch: 1e-3,
    reach: |radius| (radius * radius + 1e-2 * radius.min(1.0)).sqrt() - radius,
    chord: Some(1e-3),
    one_coordinate: true,
    leaves_along: true,
};

/// An element as it is typed, with the transition behind it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Typed {
    pub record: usize,
    pub kind: Kind,
    pub keys: Keys,
    pub transition: Option<usize>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    Line(Heading),
    Arc { ccw: bool },
}

/// An element with its geometry.
#[derive(Debug, Clone, Copy)]
pub(super) struct Solved {
    pub typed: Typed,
    pub from: Point2,
    pub to: Point2,
    pub arc: Option<(Point2, bool)>,
}

impl Solved {
    fn new(typed: Typed, open::Solved { from, to, arc }: open::Solved) -> Solved {
        Solved { typed, from, to, arc }
    }

    fn element(&self) -> open::Solved {
        open::Solved { from: self.from, to: self.to, arc: self.arc }
    }

    pub fn start_direction(&self) -> Option<Vec2> {
        self.element().start_direction()
    }

    pub fn end_direction(&self) -> Option<Vec2> {
        self.element().end_direction()
    }
}

/// The start point record, its keys and the transition behind it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Begin {
    pub record: usize,
    pub keys: Keys,
    pub transition: Option<usize>,
}

pub(super) struct Solver {
    elements: Vec<Typed>,
    /// From ordinates as written to radius values.
    scale: f64,
    pub chosen: Vec<usize>,
}

impl Solver {
    pub fn new(diameter: bool) -> Solver {
        Solver { elements: Vec::new(), scale: if diameter { 0.5 } else { 1.0 }, chosen: Vec::new() }
    }

    /// Sorts the records into elements with their transitions.
    pub fn read(&mut self, records: &[Record]) -> Result<Begin, Unsolved> {
        let mut begin: Option<Begin> = None;
        for (i, record) in records.iter().enumerate() {
            let unknown = |keys: &Keys| keys.unknown;
            match record {
                Record::Begin | Record::End | Record::Header { .. } => {}
                Record::Unknown(_) => return Err(Unsolved::Unknown(i)),
                Record::Start(keys) if begin.is_none() && !unknown(keys) && is_start(keys) => {
                    begin = Some(Begin { record: i, keys: *keys, transition: None });
                }
                Record::Start(_) => return Err(Unsolved::Unknown(i)),
                Record::Line(..) | Record::Arc { .. } if begin.is_none() => return Err(Unsolved::NoStart),
                Record::Line(_, keys) | Record::Arc { keys, .. } if unknown(keys) => return Err(Unsolved::Unknown(i)),
                Record::Line(heading, keys) => self.push(i, Kind::Line(*heading), keys),
                Record::Arc { ccw, keys } => self.push(i, Kind::Arc { ccw: *ccw }, keys),
                Record::Rounding(size) | Record::Chamfer(size) if *size < 0.0 => {
                    return Err(Unsolved::Contradiction(i));
                }
                Record::Rounding(_) | Record::Chamfer(_) | Record::Undercut(_) => {
                    let transition = match (self.elements.last_mut(), &mut begin) {
                        (Some(element), _) => &mut element.transition,
                        (None, Some(begin)) => &mut begin.transition,
                        (None, None) => return Err(Unsolved::NoStart),
                    };
                    // A corner has one.
                    if transition.is_some() {
                        return Err(Unsolved::Contradiction(i));
                    }
                    *transition = Some(i);
                }
            }
        }
        begin.ok_or(Unsolved::NoStart)
    }

    fn push(&mut self, record: usize, kind: Kind, keys: &Keys) {
        let mut keys = *keys;
        keys.ey = keys.ey.map(|v| v * self.scale);
        keys.cy = keys.cy.map(|v| v * self.scale);
        self.elements.push(Typed { record, kind, keys, transition: None });
    }

    pub fn elements_from(&mut self, begin: Begin) -> Result<(Point2, Vec<Solved>), Unsolved> {
        let (Some(x), Some(y)) = (begin.keys.ex, begin.keys.ey) else { return Err(Unsolved::Open(begin.record)) };
        let corner = Point2::new(x, y * self.scale);
        let mut at = corner;
        let mut dir = begin.keys.ase.map(|a| Deg(a).unit());
        let mut list: Vec<Solved> = Vec::with_capacity(self.elements.len());
        let mut chain = Chain::default();
        for typed in &self.elements {
            chain.push(typed.data(), *typed);
        }
        let mut following = self.elements.iter().skip(1);
        for typed in &self.elements {
            typed.says_one_thing(at, dir)?;
            let (solution, typed) = match chain.next(&Start { at, dir, goes_on: false }, true) {
                Ok(Some(found)) => found,
                Ok(None) => break,
                Err((fault @ Fault::Open(_), _)) => {
                    let next = following.next().filter(|next| fault == NOT_FIXED && typed.is_cut_by(next));
                    return Err(Unsolved::Open(next.unwrap_or(typed).record));
                }
                Err(_) => return Err(Unsolved::Contradiction(typed.record)),
            };
            let solved = Solved::new(typed, solution.solved);
            if !solved.agrees(dir) {
                return Err(Unsolved::Contradiction(typed.record));
            }
            let next = following.next();
            let doubted = solution.tags.iter().flatten().filter_map(|tag| typed.doubt(tag, next));
            self.chosen.extend(doubted);
            at = solved.to;
            dir = solved.end_direction().or(dir);
            list.push(solved);
        }
        Ok((corner, list))
    }
}

/// Which of two solutions a choice stands for that is stored: for the first one under this number, for the other under a
/// number that is larger by 200.
fn class(situation: Situation) -> Option<u32> {
    match situation {
        Situation::EndAtX => Some(7),
        Situation::EndAtY => Some(10),
        Situation::CenterByEnd | Situation::NextCenterByEnd => Some(14),
        Situation::CenterByStart => Some(15),
        Situation::LineToY => Some(17),
        // The other way round: 225 is the first.
        Situation::LineAndCircle => Some(25),
        Situation::LineToX | Situation::TwoCircles | Situation::EitherWay | Situation::ShorterArc => None,
    }
}

impl Choice for Typed {
    const RULES: Rules = RULES;

    fn choose(&self, start: &Start, next: Option<&Typed>, among: &Solutions) -> Result<Solution, Fault> {
        let ahead = || among.iter().filter(|solution| self.runs_ahead(start, solution));
        for solution in ahead() {
            // Of two points on a circle the one behind the start is none.
            let alone = ahead().filter(|other| other.tags[0] == solution.tags[0]).count() == 1;
            let mut meant = true;
            for tag in solution.tags.iter().flatten().filter(|tag| tag.situation != Situation::LineAndCircle || !alone)
            {
                meant = meant && self.means(tag, next)?;
            }
            if meant {
                return Ok(*solution);
            }
        }
        Err(Fault::Impossible("the solution that is stored would run backwards"))
    }
}

impl Typed {
    fn data(&self) -> Data {
        let Keys { ex, ey, dex, cx, cy, rad, ase, at, aa, .. } = self.keys;
        let data = Data {
            x: ex.map(Coord::At).or(dex.map(Coord::By)).unwrap_or(Coord::Open),
            y: ey.map_or(Coord::Open, Coord::At),
            tolerance: ROUNDED,
            ..Data::default()
        };
        match self.kind {
            Kind::Line(_) => Data { entry: self.heading(), ..data },
            Kind::Arc { ccw } => Data {
                arc: Some(ccw),
                entry: at.map(|angle| Entry::Turned(Deg(angle).radians())),
                exit: ase.map(|angle| Deg(angle).unit()),
                sweep: aa.map(|angle| Deg(angle).radians()),
                radius: rad,
                center: Center { x: cx, y: cy, absolute: true },
                ..data
            },
        }
    }

    /// Direction of a line by its code, its angle, or the angle to the element before.
    fn heading(&self) -> Option<Entry> {
        let Kind::Line(heading) = self.kind else { return None };
        let angle = match heading {
            Heading::Left => Some(180.0),
            Heading::Right => Some(0.0),
            Heading::Up => Some(90.0),
            Heading::Down => Some(270.0),
            Heading::Any => self.keys.ase,
        };
        let turned = self.keys.at.map(|angle| Entry::Turned(Deg(angle).radians()));
        angle.map(|angle| Angles::FromPlus.entry(Deg(angle))).or(turned)
    }

    /// The choice that is stored for a situation, and the record that holds it.
    fn stored(&self, situation: Situation, next: Option<&Typed>) -> (u32, usize) {
        match situation {
            Situation::CenterByEnd | Situation::CenterByStart => (self.keys.dia.1, self.record),
            Situation::NextCenterByEnd => next.map_or((0, self.record), |next| (next.keys.dia.1, next.record)),
            Situation::LineToY => (next.map_or(0, |next| next.keys.dia.1), self.record),
            _ => (self.keys.dia.0, self.record),
        }
    }

    /// Is this the solution that is stored?
    fn means(&self, tag: &Tag, next: Option<&Typed>) -> Result<bool, Fault> {
        if tag.situation == Situation::ShorterArc {
            // All programs seen have the shorter arc; which of the two the stored choice means is not known.
            return Ok(true);
        }
        if tag.apart <= ONE {
            return Ok(!tag.second);
        }
        let neither = match tag.situation {
            Situation::NextCenterByEnd => NOT_FIXED,
            _ => Fault::Open("the stored choice is neither of two solutions"),
        };
        let Some(class) = class(tag.situation) else { return Err(neither) };
        let (stored, _) = self.stored(tag.situation, next);
        let second = match stored {
            _ if stored == class => false,
            _ if stored == class + 200 => true,
            _ => return Err(neither),
        };
        Ok(second == (tag.second != (tag.situation == Situation::LineAndCircle)))
    }

    /// Is it a line up to the circle of the next arc? That has to be known then.
    fn is_cut_by(&self, next: &Typed) -> bool {
        let arc = matches!(next.kind, Kind::Arc { .. }) && next.keys.rad.is_some() && next.keys.at != Some(0.0);
        arc && self.heading().is_some()
    }

    /// The record of a choice that was never seen in a program.
    fn doubt(&self, tag: &Tag, next: Option<&Typed>) -> Option<usize> {
        let (stored, record) = self.stored(tag.situation, next);
        match tag.situation {
            Situation::ShorterArc => Some(record),
            Situation::LineAndCircle => (tag.second && stored == 25).then_some(record),
            _ => (tag.apart > ONE && !SEEN.contains(&stored)).then_some(record),
        }
    }

    /// A line whose end follows from the next element runs the way it says.
    fn runs_ahead(&self, start: &Start, solution: &Solution) -> bool {
        let Some(u) = self.direction(start.dir).filter(|u| !self.reaches(*u)) else { return true };
        let way = (solution.solved.to - start.at).dot(&u);
        let hit = solution.tags.iter().flatten().any(|tag| tag.situation == Situation::LineAndCircle);
        way > if hit { SAME_POINT } else { 0.0 }
    }

    /// Direction of a line.
    fn direction(&self, dir: Option<Vec2>) -> Option<Vec2> {
        match self.heading()? {
            Entry::Along(u) | Entry::Parallel(u) => Some(u),
            Entry::Turned(0.0) => dir,
            Entry::Turned(angle) => dir.map(|dir| crate::geo::turned(dir, angle)),
        }
    }

    /// Does a coordinate of its end say where a line of this direction ends?
    fn reaches(&self, u: Vec2) -> bool {
        let Keys { ex, dex, ey, .. } = self.keys;
        let x = ex.is_some() || dex.is_some();
        x && (ey.is_some() || u.x.abs() > 1e-9) || ey.is_some() && u.y.abs() > 1e-9
    }

    /// Do its keys say one thing, and nothing that a line or an arc does not have?
    fn says_one_thing(&self, at: Point2, dir: Option<Vec2>) -> Result<(), Unsolved> {
        let Keys { ex, dex, cx, cy, rad, aa, .. } = self.keys;
        let twice = ex.zip(dex).is_some_and(|(to, by)| (to - at.x - by).abs() > SAME_END);
        let line = matches!(self.kind, Kind::Line(_));
        let of_arcs = line && [cx, cy, rad, aa].iter().any(Option::is_some);
        if twice || of_arcs || line && !self.angles_agree(dir) {
            return Err(Unsolved::Contradiction(self.record));
        }
        Ok(())
    }

    /// Do code, angle and angle to the element before say the same of a line?
    fn angles_agree(&self, dir: Option<Vec2>) -> bool {
        let Some(u) = self.direction(dir) else { return true };
        let by_angle = self.keys.ase.map(|angle| Deg(angle).unit());
        let by_turn = self.keys.at.zip(dir).map(|(angle, dir)| crate::geo::turned(dir, Deg(angle).radians()));
        [by_angle, by_turn].into_iter().flatten().all(|v| off(u, v) <= 0.01)
    }
}

/// How far two directions differ, about in rad.
fn off(u: Vec2, v: Vec2) -> f64 {
    cross(u, v).abs().max(1.0 - u.dot(&v))
}

impl Solved {
    /// Does nothing of what was typed say something else than the element?
    fn agrees(&self, dir: Option<Vec2>) -> bool {
        let Some((center, ccw)) = self.arc else {
            // A line that goes the other way than it says.
            let says = self.typed.direction(dir).zip(direction(self.to - self.from, SAME_POINT));
            return says.is_none_or(|(u, v)| off(u, v) <= 0.01);
        };
        let Keys { rad, ase, at, aa, .. } = self.typed.keys;
        let radius = distance(self.from, center);
        let tangent = at.zip(dir).map(|(angle, dir)| crate::geo::turned(dir, Deg(angle).radians()));
        // How far an angle that is off moves a point of the arc.
        let aside = |u: Vec2, p: Point2| radius * off(u, arc::tangent_at(p, center, ccw).unwrap_or(u));
        let turn = arc::sweep(self.from, self.to, center, ccw).abs();
        let whole = distance(self.from, self.to) <= SAME_POINT;
        let differs = radius <= SAME_POINT
            || (distance(self.to, center) - radius).abs() > ROUNDED
            || rad.is_some_and(|rad| (rad - radius).abs() > ROUNDED)
            || ase.is_some_and(|angle| aside(Deg(angle).unit(), self.to) > AIMED)
            || tangent.is_some_and(|u| aside(u, self.from) > AIMED)
            || aa.is_some_and(|angle| !whole && radius * (Deg(angle).radians() - turn).abs() > AIMED);
        !differs
    }
}

/// The start point has a place, and perhaps the direction in front of the contour.
fn is_start(keys: &Keys) -> bool {
    let others = [keys.dex, keys.cx, keys.cy, keys.rad, keys.at, keys.aa, keys.dst];
    others.iter().all(Option::is_none)
}
