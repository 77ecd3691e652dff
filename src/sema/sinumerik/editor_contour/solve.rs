//! From records to elements with their geometry: what an element leaves open follows from its neighbours.

use crate::geo::{Deg, Point2, SAME_POINT, Vec2, arc, cross, direction, distance, intersect, left};
use crate::parser::sinumerik::records::{Heading, Keys, Record};

use super::made::Unsolved;

/// Stored values are rounded to three places.
const ROUNDED: f64 = 0.005;
/// How far an end point and the way to it may differ.
const SAME_END: f64 = 0.001 + 1e-9;
/// What rounded angles and points make of an arc.
const AIMED: f64 = 0.05;
/// Stored choices that were seen in programs, with their meaning.
const SEEN: [u32; 5] = [7, 207, 210, 14, 15];

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
    pub fn start_direction(&self) -> Option<Vec2> {
        match self.arc {
            Some((center, ccw)) => arc::tangent_at(self.from, center, ccw),
            None => direction(self.to - self.from, SAME_POINT),
        }
    }

    pub fn end_direction(&self) -> Option<Vec2> {
        match self.arc {
            Some((center, ccw)) => arc::tangent_at(self.to, center, ccw),
            None => direction(self.to - self.from, SAME_POINT),
        }
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
        for i in 0..self.elements.len() {
            let (Some(typed), next) = (self.elements.get(i).copied(), self.elements.get(i + 1).copied()) else { break };
            let solved = match typed.kind {
                Kind::Line(heading) => self.line(typed, heading, at, dir, next)?,
                Kind::Arc { ccw } => self.arc(typed, ccw, at, dir, next)?,
            };
            at = solved.to;
            dir = solved.end_direction().or(dir);
            list.push(solved);
        }
        Ok((corner, list))
    }

    fn line(
        &mut self,
        typed: Typed,
        heading: Heading,
        at: Point2,
        dir: Option<Vec2>,
        next: Option<Typed>,
    ) -> Result<Solved, Unsolved> {
        let keys = typed.keys;
        let angle = line_angle(&typed, dir);
        let mut x = keys.ex.or(keys.dex.map(|d| at.x + d));
        let mut y = keys.ey;
        let twice = keys.ex.zip(keys.dex).is_some_and(|(to, by)| (to - at.x - by).abs() > SAME_END);
        let of_arcs = [keys.cx, keys.cy, keys.rad, keys.aa].iter().any(Option::is_some);
        if twice || of_arcs || !angles_agree(&typed, dir) {
            return Err(Unsolved::Contradiction(typed.record));
        }
        match heading {
            Heading::Left | Heading::Right => y = y.or(Some(at.y)),
            Heading::Up | Heading::Down => x = x.or(Some(at.x)),
            Heading::Any => {}
        }
        let to = match (x, y, angle) {
            (Some(x), Some(y), _) => Point2::new(x, y),
            (Some(x), None, Some(u)) if u.x.abs() > 1e-9 => Point2::new(x, at.y + (x - at.x) * u.y / u.x),
            (None, Some(y), Some(u)) if u.y.abs() > 1e-9 => Point2::new(at.x + (y - at.y) * u.x / u.y, y),
            (_, _, Some(u)) => self.open_line(typed, at, u, next)?,
            (None, Some(y), None) => self.start_of_arc(typed, y, next)?,
            _ => return Err(Unsolved::Open(typed.record)),
        };
        // A line that goes the other way than it says.
        if let (Some(u), Some(v)) = (angle, direction(to - at, SAME_POINT))
            && cross(u, v).abs().max(1.0 - u.dot(&v)) > 0.01
        {
            return Err(Unsolved::Contradiction(typed.record));
        }
        Ok(Solved { typed, from: at, to, arc: None })
    }

    /// The end of a line of known direction follows from the next element.
    fn open_line(&mut self, typed: Typed, at: Point2, u: Vec2, next: Option<Typed>) -> Result<Point2, Unsolved> {
        let open = Unsolved::Open(typed.record);
        let next = next.ok_or(open.clone())?;
        let keys = next.keys;
        match next.kind {
            Kind::Line(heading) => {
                if let (Heading::Any, None, Some(by), Some(y)) = (heading, keys.ex, keys.dex, keys.ey) {
                    // Its own way along the abscissa and its angle say how far it rises to its end.
                    let w = line_angle(&next, Some(u)).filter(|w| w.x * by > 1e-9).ok_or(open.clone())?;
                    if u.y.abs() <= 1e-9 {
                        return Err(open);
                    }
                    let s = (y - by * w.y / w.x - at.y) / u.y;
                    return if s <= 0.0 { Err(Unsolved::Contradiction(typed.record)) } else { Ok(at + u * s) };
                }
                let through = match (heading, keys.ex, keys.ey) {
                    (Heading::Up | Heading::Down, Some(x), _) => Point2::new(x, at.y),
                    (Heading::Left | Heading::Right, _, Some(y)) => Point2::new(at.x, y),
                    (_, Some(x), Some(y)) => Point2::new(x, y),
                    _ => return Err(open),
                };
                let w = line_angle(&next, Some(u)).ok_or(open)?;
                let (s, _) = intersect::lines(at, u, through, w, 1e-9).ok_or(Unsolved::Contradiction(typed.record))?;
                if s <= 0.0 { Err(Unsolved::Contradiction(typed.record)) } else { Ok(at + u * s) }
            }
            Kind::Arc { ccw } => {
                let Some(radius) = keys.rad else { return Err(open) };
                if keys.at == Some(0.0) {
                    // The centre lies beside the line; a known coordinate of it says where.
                    let beside = at + left(u) * if ccw { radius } else { -radius };
                    let along = match (keys.cx, keys.cy) {
                        (Some(x), _) if u.x.abs() > 1e-9 => (x - beside.x) / u.x,
                        (_, Some(y)) if u.y.abs() > 1e-9 => (y - beside.y) / u.y,
                        _ => return Err(open),
                    };
                    return if along > 0.0 { Ok(at + u * along) } else { Err(Unsolved::Contradiction(typed.record)) };
                }
                let center = self.center_from_end(&next, None)?;
                let hits = intersect::line_circle(at, u, center, radius, 1e-3);
                let [first, second] = hits.ok_or(Unsolved::Contradiction(typed.record))?;
                let ahead = |p: &Point2| (p - at).dot(&u) > SAME_POINT;
                match (ahead(&first), ahead(&second), typed.keys.dia.0) {
                    (true, true, 225) => Ok(first),
                    (true, true, 25) => {
                        // Not seen in any program.
                        self.chosen.push(typed.record);
                        Ok(second)
                    }
                    (true, true, _) if distance(first, second) > 2e-3 => Err(Unsolved::Open(typed.record)),
                    (true, ..) => Ok(first),
                    (false, true, _) => Ok(second),
                    (false, false, _) => Err(Unsolved::Contradiction(typed.record)),
                }
            }
        }
    }

    /// The end of a line of which only the ordinate is known, on the circle of the arc behind it.
    fn start_of_arc(&mut self, typed: Typed, y: f64, next: Option<Typed>) -> Result<Point2, Unsolved> {
        let open = Unsolved::Open(typed.record);
        let Some(Typed { kind: Kind::Arc { .. }, keys, .. }) = next else { return Err(open) };
        let (Some(center), Some(end)) = (
            keys.cx.zip(keys.cy).map(|(x, y)| Point2::new(x, y)),
            keys.ex.zip(keys.ey).map(|(x, y)| Point2::new(x, y)),
        ) else {
            return Err(open);
        };
        let off = leg(distance(end, center), y - center.y).ok_or(Unsolved::Contradiction(typed.record))?;
        match keys.dia.1 {
            17 => Ok(Point2::new(center.x - off, y)),
            217 => {
                // Not seen in any program.
                self.chosen.push(typed.record);
                Ok(Point2::new(center.x + off, y))
            }
            _ => Err(open),
        }
    }

    /// Centre of an arc from its end, its radius and one coordinate of the centre; `at` is its start, if known.
    fn center_from_end(&mut self, typed: &Typed, at: Option<Point2>) -> Result<Point2, Unsolved> {
        let open = Unsolved::Open(typed.record);
        let Keys { ex, ey, cx, cy, rad, .. } = typed.keys;
        if let (Some(x), Some(y)) = (cx, cy) {
            return Ok(Point2::new(x, y));
        }
        let (Some(x), Some(y), Some(radius)) = (ex, ey, rad) else { return Err(open) };
        let made = |off: f64| match (cx, cy) {
            (Some(cx), _) => Point2::new(cx, y + off),
            (_, cy) => Point2::new(x + off, cy.unwrap_or(y)),
        };
        let across = match (cx, cy) {
            (Some(cx), _) => x - cx,
            (_, Some(cy)) => y - cy,
            _ => return Err(open),
        };
        let off = leg(radius, across).ok_or(Unsolved::Contradiction(typed.record))?;
        // The start leaves one of the two, as a rule.
        let fits = |off: f64| at.is_some_and(|at| (distance(at, made(off)) - radius).abs() < ROUNDED);
        match (fits(off), fits(-off)) {
            (true, false) => Ok(made(off)),
            (false, true) => Ok(made(-off)),
            _ => self.choice(typed, typed.keys.dia.1, 14, off).map(made),
        }
    }

    /// Which of two solutions, `off` or `-off`, is stored under `class`; alternatives never seen are noted.
    fn choice(&mut self, typed: &Typed, stored: u32, class: u32, off: f64) -> Result<f64, Unsolved> {
        if off.abs() <= 1e-3 {
            return Ok(off);
        }
        let second = match stored {
            _ if stored == class => false,
            _ if stored == class + 200 => true,
            _ => return Err(Unsolved::Open(typed.record)),
        };
        if !SEEN.contains(&stored) {
            self.chosen.push(typed.record);
        }
        Ok(if second { -off } else { off })
    }

    fn arc(
        &mut self,
        typed: Typed,
        ccw: bool,
        at: Point2,
        dir: Option<Vec2>,
        next: Option<Typed>,
    ) -> Result<Solved, Unsolved> {
        let keys = typed.keys;
        let x = keys.ex.or(keys.dex.map(|d| at.x + d));
        let y = keys.ey;
        if keys.ex.zip(keys.dex).is_some_and(|(to, by)| (to - at.x - by).abs() > SAME_END) {
            return Err(Unsolved::Contradiction(typed.record));
        }
        let end = x.zip(y).map(|(x, y)| Point2::new(x, y));
        let tangent = keys.at.zip(dir).map(|(angle, dir)| crate::geo::turned(dir, Deg(angle).radians()));
        let center = self.center(&typed, ccw, at, end, tangent)?;
        let radius = distance(at, center);
        if radius <= SAME_POINT {
            return Err(Unsolved::Contradiction(typed.record));
        }
        let to = match end {
            Some(end) => end,
            None => self.arc_end(&typed, ccw, at, center, (x, y), next)?,
        };
        if (distance(to, center) - radius).abs() > ROUNDED || self.says_too_much(&typed, ccw, at, to, center, tangent) {
            return Err(Unsolved::Contradiction(typed.record));
        }
        Ok(Solved { typed, from: at, to, arc: Some((center, ccw)) })
    }

    /// Does a key that was not needed for the arc say something else than the arc?
    fn says_too_much(
        &self,
        typed: &Typed,
        ccw: bool,
        at: Point2,
        to: Point2,
        center: Point2,
        tangent: Option<Vec2>,
    ) -> bool {
        let Keys { rad, ase, aa, .. } = typed.keys;
        let radius = distance(at, center);
        // How far an angle that is off moves a point of the arc.
        let aside = |u: Vec2, p: Point2| {
            let along = arc::tangent_at(p, center, ccw).unwrap_or(u);
            radius * cross(u, along).abs().max(1.0 - u.dot(&along))
        };
        let turn = arc::sweep(at, to, center, ccw).abs();
        let whole = distance(at, to) <= SAME_POINT;
        rad.is_some_and(|rad| (rad - radius).abs() > ROUNDED)
            || ase.is_some_and(|angle| aside(Deg(angle).unit(), to) > AIMED)
            || tangent.is_some_and(|u| aside(u, at) > AIMED)
            || aa.is_some_and(|angle| !whole && radius * (Deg(angle).radians() - turn).abs() > AIMED)
    }

    fn center(
        &mut self,
        typed: &Typed,
        ccw: bool,
        at: Point2,
        end: Option<Point2>,
        tangent: Option<Vec2>,
    ) -> Result<Point2, Unsolved> {
        let Keys { cx, cy, rad, dia, .. } = typed.keys;
        let contradiction = Unsolved::Contradiction(typed.record);
        let side = |r: f64| if ccw { r } else { -r };
        if let (Some(x), Some(y)) = (cx, cy) {
            return Ok(Point2::new(x, y));
        }
        if let (Some(u), Some(r)) = (tangent, rad) {
            return Ok(at + left(u) * side(r));
        }
        if let (Some(u), Some(end)) = (tangent, end) {
            return match arc::tangent_arc(at, u, end, SAME_POINT, 1e-6) {
                arc::TangentArc::Arc { center, ccw: sense } if sense == ccw => Ok(center),
                _ => Err(contradiction),
            };
        }
        match (end, rad, cx, cy) {
            (Some(end), Some(_), ..) if cx.is_some() || cy.is_some() => {
                let keys = Keys { ex: Some(end.x), ey: Some(end.y), ..typed.keys };
                self.center_from_end(&Typed { keys, ..*typed }, Some(at))
            }
            // Start, end and one coordinate of the centre: on the perpendicular bisector.
            (Some(end), None, Some(_), None) | (Some(end), None, None, Some(_)) => {
                let (middle, w) = (at + (end - at) / 2.0, left(end - at));
                let along = match (cx, cy) {
                    (Some(x), _) if w.x.abs() > 1e-9 => (x - middle.x) / w.x,
                    (_, Some(y)) if w.y.abs() > 1e-9 => (y - middle.y) / w.y,
                    _ => return Err(Unsolved::Open(typed.record)),
                };
                Ok(middle + w * along)
            }
            (Some(end), Some(r), None, None) => {
                // All programs seen have the shorter arc; which of the two the stored choice means is not known.
                self.chosen.push(typed.record);
                arc::center_by_radius(at, end, r.abs(), ccw, SAME_POINT, 1e-3).ok_or(contradiction)
            }
            (None, Some(r), Some(x), None) => {
                let off = leg(r, at.x - x).ok_or(contradiction)?;
                self.choice(typed, dia.1, 15, off).map(|off| Point2::new(x, at.y + off))
            }
            (None, Some(r), None, Some(y)) => {
                let off = leg(r, at.y - y).ok_or(contradiction)?;
                self.choice(typed, dia.1, 15, off).map(|off| Point2::new(at.x + off, y))
            }
            _ => Err(Unsolved::Open(typed.record)),
        }
    }

    fn arc_end(
        &mut self,
        typed: &Typed,
        ccw: bool,
        at: Point2,
        center: Point2,
        known: (Option<f64>, Option<f64>),
        next: Option<Typed>,
    ) -> Result<Point2, Unsolved> {
        let keys = typed.keys;
        let radius = distance(at, center);
        let sense = if ccw { 1.0 } else { -1.0 };
        let leaving = |u: Vec2| center - left(u) * (sense * radius);
        if let Some(sweep) = keys.aa {
            return Ok(center + crate::geo::turned(at - center, Deg(sense * sweep).radians()));
        }
        if let Some(angle) = keys.ase {
            return Ok(leaving(Deg(angle).unit()));
        }
        let contradiction = Unsolved::Contradiction(typed.record);
        match known {
            (Some(x), None) => {
                let off = leg(radius, x - center.x).ok_or(contradiction)?;
                self.choice(typed, keys.dia.0, 7, off).map(|off| Point2::new(x, center.y + off))
            }
            (None, Some(y)) => {
                let off = leg(radius, y - center.y).ok_or(contradiction)?;
                self.choice(typed, keys.dia.0, 10, off).map(|off| Point2::new(center.x + off, y))
            }
            _ => {
                // The next element goes on in its direction.
                let next = next.filter(|next| matches!(next.kind, Kind::Line(_)));
                let u = next.and_then(|next| line_angle(&next, None)).ok_or(Unsolved::Open(typed.record))?;
                Ok(leaving(u))
            }
        }
    }
}

/// The other leg of a right-angled triangle; 0 where rounding makes it just impossible.
fn leg(hypotenuse: f64, leg: f64) -> Option<f64> {
    let square = hypotenuse * hypotenuse - leg * leg;
    (square > -1e-2 * hypotenuse.abs().min(1.0)).then(|| square.max(0.0).sqrt())
}

/// The start point has a place, and perhaps the direction in front of the contour.
fn is_start(keys: &Keys) -> bool {
    let others = [keys.dex, keys.cx, keys.cy, keys.rad, keys.at, keys.aa, keys.dst];
    others.iter().all(Option::is_none)
}

/// Do code, angle and angle to the element before say the same of a line?
fn angles_agree(typed: &Typed, dir: Option<Vec2>) -> bool {
    let Some(u) = line_angle(typed, dir) else { return true };
    let by_angle = typed.keys.ase.map(|angle| Deg(angle).unit());
    let by_turn = typed.keys.at.zip(dir).map(|(angle, dir)| crate::geo::turned(dir, Deg(angle).radians()));
    [by_angle, by_turn].into_iter().flatten().all(|v| cross(u, v).abs().max(1.0 - u.dot(&v)) <= 0.01)
}

/// Direction of a line by its code, its angle, or the angle to the element before.
fn line_angle(typed: &Typed, dir: Option<Vec2>) -> Option<Vec2> {
    let Kind::Line(heading) = typed.kind else { return None };
    match heading {
        Heading::Left => Some(Deg(180.0).unit()),
        Heading::Right => Some(Deg(0.0).unit()),
        Heading::Up => Some(Deg(90.0).unit()),
        Heading::Down => Some(Deg(270.0).unit()),
        Heading::Any => match (typed.keys.ase, typed.keys.at, dir) {
            (Some(angle), ..) => Some(Deg(angle).unit()),
            (None, Some(0.0), Some(dir)) => Some(dir),
            (None, Some(angle), Some(dir)) => Some(crate::geo::turned(dir, Deg(angle).radians())),
            _ => None,
        },
    }
}
