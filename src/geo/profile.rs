//! The upper outline of a chain of lines and arcs, grown by allowances and by the disc that rolls along it.
//!
//! In: a chain that is travelled with the material on its right, so that the free side lies above (+y). Out: one height for
//! each place `x`, exact in lines and arcs. A disc is never nearer to the chain than its radius: every line, arc and
//! corner of the chain says how high it holds the centre, and the highest of them counts. So loops of a narrow place are gone by
//! construction. What leans over is in its own shadow.
//!
//! ```text
//!        ╭───────────────  outline
//!   ─────╯  ┌────────────
//!           │   material    cutting direction →
//! ══════════┘
//! ```

mod piece;
mod way;

use piece::{Curve, Piece, SAME_CURVE};
use way::Way;
pub use way::{Leg, backwards, elements, mirrored};

use super::element::quarters;
use super::{Element, Point2, Vec2, direction, distance, left};

/// Heights closer than this are one, mm.
pub const LEVEL: f64 = 1e-7;

/// Pieces that are narrower are none, mm.
const NARROW: f64 = 1e-10;

/// How the outline lies above its chain.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Grown {
    /// Allowance to both sides along x.
    pub along: f64,
    /// Allowance upwards.
    pub up: f64,
    /// Radius of the disc.
    pub disc: f64,
}

/// A place where the outline lies lower than on both sides of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dip {
    pub left: f64,
    pub right: f64,
    /// Height of the lower side.
    pub rim: f64,
}

/// The height over each place.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Profile {
    pieces: Vec<Piece>,
}

/// The candidates of an outline.
struct Candidates {
    list: Vec<Piece>,
    grown: Grown,
}

impl Candidates {
    fn add(&mut self, from: Point2, to: Point2, curve: Curve) {
        if to.x - from.x <= NARROW {
            return;
        }
        let piece = Piece { from, to, curve, source: 0 };
        let Grown { along, up, .. } = self.grown;
        self.list.push(piece.moved(Vec2::new(-along, up), self.list.len()));
        if along > 0.0 {
            self.list.push(piece.moved(Vec2::new(along, up), self.list.len()));
        }
    }

    /// The disc on a point of the chain.
    fn corner(&mut self, p: Point2) {
        let Grown { along, up, disc } = self.grown;
        let top = p + Vec2::new(0.0, disc);
        if along > 0.0 {
            let by = Vec2::new(along, 0.0);
            let flat = Piece { from: top - by, to: top + by, curve: Curve::Line, source: 0 };
            self.list.push(flat.moved(Vec2::new(0.0, up), self.list.len()));
        }
        if disc > 0.0 {
            let curve = Curve::Circle { center: p, radius: disc, upper: true };
            let side = Vec2::new(disc, 0.0);
            self.add(p - side, top, curve);
            self.add(top, p + side, curve);
        }
    }

    fn element(&mut self, element: &Element) {
        let disc = self.grown.disc;
        match *element {
            Element::Line { from, to } => {
                if let Some(u) = direction(to - from, 0.0).filter(|u| u.x > 0.0) {
                    let by = left(u) * disc;
                    self.add(from + by, to + by, Curve::Line);
                }
            }
            Element::Arc { from, to, center, sweep } => {
                let arc = distance(from, center);
                let radius = if sweep < 0.0 { arc + disc } else { arc - disc };
                if arc <= 0.0 || radius <= NARROW || to.x <= from.x {
                    return;
                }
                let place = |p: Point2| center + (p - center) * (radius / arc);
                self.add(place(from), place(to), Curve::Circle { center, radius, upper: sweep < 0.0 });
            }
        }
    }
}

impl Profile {
    /// The outline of a chain that runs towards +x on the whole, with the free side above it.
    pub fn new(chain: &[Element], grown: Grown) -> Profile {
        let mut made = Candidates { list: Vec::with_capacity(8 * chain.len() + 8), grown };
        if let Some(first) = chain.first() {
            made.corner(first.from());
        }
        for element in chain.iter().flat_map(quarters) {
            made.element(&element);
            made.corner(element.to());
        }
        Profile { pieces: envelope(&made.list) }
    }

    /// The highest point of all elements over each place, whichever way they run.
    pub fn hull(elements: &[Element]) -> Profile {
        let mut made = Candidates { list: Vec::new(), grown: Grown::default() };
        for element in elements.iter().flat_map(quarters) {
            let (mut from, mut to) = (element.from(), element.to());
            if from.x > to.x {
                (from, to) = (to, from);
            }
            let curve = match element {
                Element::Line { .. } => Curve::Line,
                Element::Arc { center, .. } => {
                    let upper = element.middle().y > center.y;
                    Curve::Circle { center, radius: distance(from, center), upper }
                }
            };
            made.add(from, to, curve);
        }
        Profile { pieces: envelope(&made.list) }
    }

    /// Seen from behind: `x` changes its sign.
    pub fn mirrored(&self) -> Profile {
        Profile { pieces: self.pieces.iter().rev().map(Piece::mirrored).collect() }
    }

    /// The part between two places.
    pub fn between(&self, from: f64, to: f64) -> Profile {
        let inside = self.pieces.iter().filter(|piece| piece.to.x > from + NARROW && piece.from.x < to - NARROW);
        Profile { pieces: inside.map(|piece| piece.part(from.max(piece.from.x), to.min(piece.to.x))).collect() }
    }

    /// With a wall up to the height `top` from the place `x` on.
    pub fn walled(&self, x: f64, top: f64) -> Profile {
        let mut made = self.between(f64::NEG_INFINITY, x);
        let (from, to) = (Point2::new(x, top), Point2::new(x + top.abs(), top));
        made.pieces.push(Piece { from, to, curve: Curve::Line, source: usize::MAX });
        made
    }

    /// Nowhere lower than `y`.
    pub fn raised(&self, y: f64) -> Profile {
        let Some((from, to)) = self.ends() else { return Profile::default() };
        let level =
            Piece { from: Point2::new(from, y), to: Point2::new(to, y), curve: Curve::Line, source: usize::MAX - 1 };
        Profile { pieces: merge(&self.pieces, &[level]) }
    }

    /// First and last place.
    pub fn ends(&self) -> Option<(f64, f64)> {
        Some((self.pieces.first()?.from.x, self.pieces.last()?.to.x))
    }

    fn beginning_at(&self, x: f64) -> &[Piece] {
        let first = self.pieces.partition_point(|piece| piece.to.x <= x + NARROW);
        self.pieces.get(first..).unwrap_or_default()
    }

    /// Height over `x`; at a wall the higher one. Below everything outside.
    pub fn height(&self, x: f64) -> f64 {
        let first = self.pieces.partition_point(|piece| piece.to.x < x);
        let near = self.pieces.get(first..).unwrap_or_default().iter().take(2);
        near.filter(|piece| piece.from.x <= x && x <= piece.to.x)
            .map(|piece| piece.y(x))
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// Where the outline first runs on a circle about `center`, from `from` on.
    pub fn first_about(&self, center: Point2, from: f64) -> Option<Point2> {
        let on = |piece: &&Piece| matches!(piece.curve, Curve::Circle { center: own, .. } if distance(own, center) < SAME_CURVE);
        let piece = self.beginning_at(from).iter().find(on)?;
        let x = piece.from.x.max(from);
        Some(Point2::new(x, piece.y(x)))
    }

    /// Greatest height between two places.
    pub fn highest(&self, from: f64, to: f64) -> f64 {
        let inside = self.beginning_at(from).iter().take_while(|piece| piece.from.x <= to);
        inside.map(|piece| piece.y(from).max(piece.y(to))).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The lowest point between two places.
    pub fn lowest(&self, from: f64, to: f64) -> Option<Point2> {
        let inside = self.beginning_at(from).iter().take_while(|piece| piece.from.x < to - NARROW);
        let points = inside.flat_map(|piece| {
            let part = piece.part(from, to);
            [part.from, part.to]
        });
        points.min_by(|a, b| a.y.total_cmp(&b.y))
    }

    /// The first place from `from` on where the outline is higher than `y`.
    pub fn first_above(&self, y: f64, from: f64) -> Option<f64> {
        let above = y + LEVEL;
        self.beginning_at(from).iter().find_map(|piece| {
            let start = piece.from.x.max(from);
            if piece.y(start) > above {
                Some(start)
            } else if piece.to.y > above {
                Some(piece.x(y.clamp(piece.from.y.min(piece.to.y), piece.to.y)).max(start))
            } else {
                None
            }
        })
    }

    /// The way that never falls, from `start` on the outline up to the height `top`: what falls away is bridged level.
    pub fn climb(&self, start: Point2, top: f64) -> Vec<Leg> {
        let mut way = Way::new(start);
        for piece in self.beginning_at(start.x) {
            if way.at.y >= top - LEVEL {
                break;
            }
            let from = piece.from.x.max(start.x);
            let entry = piece.y(from);
            if entry > way.at.y + LEVEL {
                way.line(Point2::new(from, way.at.y));
                way.line(Point2::new(from, entry.min(top)));
            }
            if piece.to.y <= way.at.y + LEVEL || way.at.y >= top - LEVEL {
                continue;
            }
            let begin = if entry >= way.at.y - LEVEL {
                Point2::new(from, entry)
            } else {
                Point2::new(piece.x(way.at.y), way.at.y)
            };
            way.line(Point2::new(begin.x, way.at.y));
            let to = if piece.to.y > top { Point2::new(piece.x(top), top) } else { piece.to };
            way.along(piece, to);
        }
        way.done()
    }

    /// The way that never falls from one point to another: what falls away is bridged level, to its end.
    pub fn rise(&self, start: Point2, end: Point2) -> Vec<Leg> {
        let highest = self.highest(start.x, end.x).max(end.y).max(start.y);
        let mut legs = self.between(start.x, end.x).climb(start, highest);
        let at = legs.last().map_or(start, Leg::to);
        let end = Point2::new(end.x.max(at.x), at.y.max(end.y));
        for to in [Point2::new(end.x, at.y), end] {
            if distance(legs.last().map_or(start, Leg::to), to) > super::SAME_POINT {
                legs.push(Leg::Line { to });
            }
        }
        legs
    }

    /// The way along the outline from one point of it to another, farther on.
    pub fn follow(&self, start: Point2, end: Point2) -> Vec<Leg> {
        let mut way = Way::new(start);
        for piece in self.beginning_at(start.x).iter().take_while(|piece| piece.from.x < end.x - NARROW) {
            let part = piece.part(piece.from.x.max(start.x), piece.to.x.min(end.x));
            if distance(way.at, part.from) > super::SAME_POINT {
                way.line(part.from);
            }
            way.along(piece, part.to);
        }
        if distance(way.at, end) > super::SAME_POINT {
            way.line(end);
        }
        way.done()
    }

    /// The places behind `from` that are lower than what lies in front of them and than `top`, deeper than `least`.
    pub fn dips(&self, from: Point2, top: f64, least: f64) -> Vec<Dip> {
        let mut found = Vec::new();
        let mut rim = from.y.min(top);
        // Where the dip under way begins, and its lowest height.
        let mut open: Option<(f64, f64)> = None;
        let mut last = from.x;
        for piece in self.beginning_at(from.x) {
            let start = piece.from.x.max(from.x);
            for (x, y) in [(start, piece.y(start)), (piece.to.x, piece.to.y)] {
                let falls = y < rim - LEVEL;
                match open.as_mut() {
                    None if falls => {
                        // From the height of the rim on, which a falling piece reaches inside of it.
                        let inside = x > start && piece.from.y > rim;
                        open = Some((if inside { piece.x(rim) } else { last.max(start.min(x)) }, y));
                    }
                    Some((_, low)) if falls => *low = low.min(y),
                    Some((left, low)) => {
                        let right = if x > start && piece.y(start) < rim { piece.x(rim) } else { x };
                        if rim - *low > least {
                            found.push(Dip { left: *left, right, rim });
                        }
                        open = None;
                    }
                    None => {}
                }
                rim = rim.max(y).min(top);
                last = x;
            }
        }
        if let Some((left, low)) = open.filter(|(_, low)| rim - low > least) {
            let _: f64 = low;
            found.push(Dip { left, right: last, rim });
        }
        found
    }
}

fn envelope(list: &[Piece]) -> Vec<Piece> {
    match list {
        [] | [_] => list.to_vec(),
        _ => {
            let (a, b) = list.split_at(list.len() / 2);
            merge(&envelope(a), &envelope(b))
        }
    }
}

/// The higher one of both over each place.
fn merge(a: &[Piece], b: &[Piece]) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    let mut x = f64::NEG_INFINITY;
    loop {
        let (pa, pb) = (a.get(i), b.get(j));
        let edge = |piece: Option<&Piece>| piece.map(|p| if p.from.x <= x { p.to.x } else { p.from.x });
        let Some(next) = [edge(pa), edge(pb)].into_iter().flatten().min_by(f64::total_cmp) else { break };
        let over = |piece: Option<&Piece>| piece.filter(|p| p.from.x <= x).copied();
        match (over(pa), over(pb)) {
            (Some(p), Some(q)) => higher(&p, &q, x, next, &mut out),
            (Some(p), None) | (None, Some(p)) => push(&p, x, next, &mut out),
            (None, None) => {}
        }
        x = next;
        i += usize::from(pa.is_some_and(|p| p.to.x <= x));
        j += usize::from(pb.is_some_and(|p| p.to.x <= x));
    }
    out
}

fn push(piece: &Piece, from: f64, to: f64, out: &mut Vec<Piece>) {
    if to - from <= NARROW {
        return;
    }
    let part = piece.part(from, to);
    match out.last_mut() {
        Some(last) if last.source == part.source && part.from.x - last.to.x <= 4.0 * NARROW => last.to = part.to,
        _ => out.push(part),
    }
}

fn higher(a: &Piece, b: &Piece, from: f64, to: f64, out: &mut Vec<Piece>) {
    let mut cuts = [f64::INFINITY; 2];
    for (cut, x) in cuts.iter_mut().zip(a.meets(b)) {
        if x > from && x < to {
            *cut = x;
        }
    }
    cuts.sort_by(f64::total_cmp);
    let mut begin = from;
    for end in [cuts[0], cuts[1], to] {
        if end > to || end <= begin {
            continue;
        }
        let middle = (begin + end) / 2.0;
        let ahead = a.y(middle) - b.y(middle);
        let stays_on_b = out.last().is_some_and(|last| last.source == b.source);
        let best = if ahead > SAME_CURVE || (ahead >= -SAME_CURVE && !stays_on_b) { a } else { b };
        push(best, begin, end, out);
        begin = end;
    }
}

#[cfg(test)]
mod tests;
