//! What closed chains of lines and arcs take up together, less what others take away.
//!
//! ```text
//!    ╭─────╮                 ╭─────╮
//!    │  A ╭┼────╮            │     ╰────╮
//!    │    ││  B │     ──►    │          │
//!    ╰────┼╯    │            ╰────╮     │
//!         ╰─────╯                 ╰─────╯
//! ```
//!
//! All chains are cut where they cross; a part stays where it bounds the area. Where chains touch or lie in one another it is not
//! certain which parts those are: no area is made.

use super::area::{NEAR, is_counter_clockwise, passes, reversed, surrounds};
use super::{Element, Point2, Vec2, cross, crossing, direction, distance, intersect};
use crate::geo::tolerance;

/// Sine of the angle under which two elements do not cross but touch.
const TOUCHING: f64 = 0.01;

/// Two chains that touch, by their places: those that add first, then those that take away.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Touching(pub usize, pub usize);

/// The boundary of an area: a chain that crossed no other one is as it was, others have the area on their left.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Area {
    /// Around its parts.
    pub outlines: Vec<Vec<Element>>,
    /// Around what is left out inside of them.
    pub islands: Vec<Vec<Element>>,
}

/// A part of a chain, and the chain.
type Cut = (usize, Element);

/// # Errors
/// Chains that touch.
pub fn overlay(adds: &[Vec<Element>], takes: &[Vec<Element>]) -> Result<Area, Touching> {
    let chains: Vec<&Vec<Element>> = adds.iter().chain(takes).collect();
    let crossings = crossings(&chains)?;
    let bounds = |chain: usize, p: Point2| {
        let held = |range: core::ops::Range<usize>| range.into_iter().any(|i| i != chain && surrounds(chains[i], p));
        let (added, taken) = (held(0..adds.len()), held(adds.len()..chains.len()));
        if chain < adds.len() { !added && !taken } else { added && !taken }
    };
    let mut made = Area::default();
    let mut parts: Vec<Cut> = Vec::new();
    for (at, chain) in chains.iter().enumerate() {
        if crossings[at].iter().all(Vec::is_empty) {
            if chain.first().is_some_and(|first| bounds(at, first.middle())) {
                let list = if at < adds.len() { &mut made.outlines } else { &mut made.islands };
                list.push((*chain).clone());
            }
            continue;
        }
        let mut cut: Vec<Element> = Vec::new();
        for (element, points) in chain.iter().zip(&crossings[at]) {
            divided(element, points, &mut cut);
        }
        if is_counter_clockwise(&cut) != (at < adds.len()) {
            cut = reversed(&cut);
        }
        for part in cut {
            let p = part.middle();
            if let Some(other) = (0..chains.len()).find(|i| *i != at && passes(chains[*i], p)) {
                return Err(Touching(at.min(other), at.max(other)));
            }
            if bounds(at, p) {
                parts.push((at, part));
            }
        }
    }
    for chain in linked(parts)? {
        let list = if is_counter_clockwise(&chain) { &mut made.outlines } else { &mut made.islands };
        list.push(chain);
    }
    Ok(made)
}

/// Where the elements of each chain are crossed by other chains.
fn crossings(chains: &[&Vec<Element>]) -> Result<Vec<Vec<Vec<Point2>>>, Touching> {
    let mut found: Vec<Vec<Vec<Point2>>> = chains.iter().map(|chain| vec![Vec::new(); chain.len()]).collect();
    for j in 0..chains.len() {
        for i in 0..j {
            for (a_at, a) in chains[i].iter().enumerate() {
                for (b_at, b) in chains[j].iter().enumerate() {
                    if !crossing::meet(a, b, &[]) {
                        continue;
                    }
                    let hits = crossed(a, b).ok_or(Touching(i, j))?;
                    found[i][a_at].extend(&hits);
                    found[j][b_at].extend(&hits);
                }
            }
        }
    }
    Ok(found)
}

/// Points in which two elements that meet cross; `None` where they touch.
fn crossed(a: &Element, b: &Element) -> Option<Vec<Point2>> {
    let candidates: Vec<Point2> = match (carrier(a)?, carrier(b)?) {
        (Carrier::Line(p, u), Carrier::Line(q, w)) => {
            let (along, _) = intersect::lines(p, u, q, w, TOUCHING)?;
            vec![p + u * along]
        }
        (Carrier::Line(p, u), Carrier::Circle(center, radius))
        | (Carrier::Circle(center, radius), Carrier::Line(p, u)) => {
            intersect::line_circle(p, u, center, radius, 0.0)?.to_vec()
        }
        (Carrier::Circle(c, r), Carrier::Circle(d, s)) => intersect::circles(c, r, d, s, 0.0)?.to_vec(),
    };
    let mut points = Vec::new();
    for p in candidates {
        let (Place::On(on_a), Place::On(on_b)) = (place(a, p)?, place(b, p)?) else { continue };
        if cross(tangent(a, p)?, tangent(b, p)?).abs() < TOUCHING {
            return None;
        }
        // An end of one of them is the point, not what was computed.
        points.push(on_a.or(on_b).unwrap_or(p));
    }
    // They came so near that they meet, and yet do not cross: with a corner, or side by side.
    if points.is_empty() { None } else { Some(points) }
}

enum Carrier {
    Line(Point2, Vec2),
    Circle(Point2, f64),
}

fn carrier(element: &Element) -> Option<Carrier> {
    Some(match *element {
        Element::Line { from, to } => Carrier::Line(from, direction(to - from, 0.0)?),
        Element::Arc { from, center, .. } => Carrier::Circle(center, distance(from, center)),
    })
}

/// Where a point of the carrier lies.
enum Place {
    Beyond,
    /// On the element, or that end of it.
    On(Option<Point2>),
}

/// `None` where the point lies beside an end.
fn place(element: &Element, p: Point2) -> Option<Place> {
    let ends = [element.from(), element.to()];
    if let Some(end) = ends.into_iter().find(|end| distance(*end, p) <= NEAR) {
        return (distance(end, p) <= tolerance::SAME).then_some(Place::On(Some(end)));
    }
    let way = element.way_to(p);
    let inside = way > 0.0 && way < element.length();
    Some(if inside { Place::On(None) } else { Place::Beyond })
}

fn tangent(element: &Element, p: Point2) -> Option<Vec2> {
    match *element {
        Element::Line { from, to } => direction(to - from, 0.0),
        Element::Arc { center, sweep, .. } => super::arc::tangent_at(p, center, sweep > 0.0),
    }
}

/// The parts of an element between points on it.
fn divided(element: &Element, points: &[Point2], parts: &mut Vec<Element>) {
    let inner =
        |p: &Point2| distance(*p, element.from()) > tolerance::SAME && distance(*p, element.to()) > tolerance::SAME;
    let mut points: Vec<Point2> = points.iter().copied().filter(inner).collect();
    points.sort_by(|a, b| element.way_to(*a).total_cmp(&element.way_to(*b)));
    points.dedup_by(|a, b| distance(*a, *b) <= tolerance::SAME);
    let mut rest = *element;
    for p in points {
        parts.push(rest.ending_at(p));
        rest = rest.starting_at(p);
    }
    parts.push(rest);
}

/// Closed chains of parts that follow each other.
fn linked(mut parts: Vec<Cut>) -> Result<Vec<Vec<Element>>, Touching> {
    let mut made = Vec::new();
    while let Some((first, begun)) = parts.pop() {
        let start = begun.from();
        let (mut last, mut chain) = (first, vec![begun]);
        let mut end = begun.to();
        while distance(end, start) > tolerance::SAME {
            let next: Vec<usize> =
                (0..parts.len()).filter(|i| distance(parts[*i].1.from(), end) <= tolerance::SAME).collect();
            let [next] = next[..] else { return Err(Touching(first.min(last), first.max(last))) };
            let (of, element) = parts.swap_remove(next);
            last = of;
            chain.push(if element.from() == end { element } else { element.starting_at(end) });
            end = element.to();
        }
        if let Some(Element::Line { to, .. } | Element::Arc { to, .. }) = chain.last_mut() {
            *to = start;
        }
        let count = chain.len();
        let nearby = |i: usize, j: usize| j - i <= 1 || j - i + 1 == count;
        if (0..count).any(|j| (0..j).any(|i| !nearby(i, j) && crossing::meet(&chain[i], &chain[j], &[]))) {
            return Err(Touching(first.min(last), first.max(last)));
        }
        made.push(chain);
    }
    Ok(made)
}

#[cfg(test)]
mod tests {
    use super::super::area::tests::{circle, polygon};
    use super::super::area::{reversed, twice_signed};
    use super::*;
    use core::f64::consts::PI;
    use core::slice;

    fn areas(adds: &[Vec<Element>], takes: &[Vec<Element>]) -> Vec<f64> {
        let made = overlay(adds, takes).unwrap();
        let (outlines, islands) = (made.outlines.iter(), made.islands.iter());
        let size = |chain: &Vec<Element>| twice_signed(chain).abs() / 2.0;
        let mut areas: Vec<f64> = outlines.map(size).chain(islands.map(|chain| -size(chain))).collect();
        areas.sort_by(f64::total_cmp);
        areas
    }

    fn square(x: f64, y: f64, size: f64) -> Vec<Element> {
        polygon(&[(x, y), (x + size, y), (x + size, y + size), (x, y + size)])
    }

    fn are(found: &[f64], wanted: &[f64]) {
        let same = found.len() == wanted.len() && found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(same, "{found:?} {wanted:?}");
    }

    #[test]
    fn areas_add_and_take_away() {
        let (a, b) = (square(0.0, 0.0, 10.0), square(5.0, 5.0, 10.0));
        are(&areas(&[a.clone(), b.clone()], &[]), &[175.0]);
        are(&areas(&[reversed(&a), b.clone()], &[]), &[175.0]);
        are(&areas(slice::from_ref(&a), slice::from_ref(&b)), &[75.0]);
        // A bar across leaves two areas.
        let bar = polygon(&[(4.0, -1.0), (6.0, -1.0), (6.0, 11.0), (4.0, 11.0)]);
        are(&areas(slice::from_ref(&a), &[bar]), &[40.0, 40.0]);
        // What crosses nothing is as it was.
        let stud = square(1.0, 1.0, 1.0);
        are(&areas(&[a, b], slice::from_ref(&stud)), &[-1.0, 175.0]);
        assert_eq!(overlay(&[square(0.0, 0.0, 10.0)], slice::from_ref(&stud)).unwrap().islands, [stud]);
    }

    #[test]
    fn circles_add_and_take_away() {
        // Two circles of radius 5, 6 apart: a lens of 2·25·acos(0.6) - 6·4.
        let lens = 50.0 * libm::acos(0.6) - 24.0;
        let (a, b) = (circle(0.0, 0.0, 5.0, 1.0), circle(6.0, 0.0, 5.0, -1.0));
        are(&areas(&[a.clone(), b.clone()], &[]), &[50.0 * PI - lens]);
        are(&areas(&[a], &[b]), &[25.0 * PI - lens]);
        // Four bars around a square leave it standing.
        let bar = |x: f64, y: f64, w: f64, h: f64| polygon(&[(x, y), (x + w, y), (x + w, y + h), (x, y + h)]);
        let bars =
            [bar(0.0, 0.0, 10.0, 2.0), bar(0.5, 7.0, 9.0, 2.0), bar(1.0, 1.0, 2.0, 7.0), bar(7.0, 1.0, 2.0, 7.0)];
        are(&areas(&bars, &[]), &[-20.0, 20.0 + 18.0 + 10.0 + 10.0 + 20.0]);
    }

    #[test]
    fn chains_that_touch_make_no_area() {
        let a = square(0.0, 0.0, 10.0);
        for b in [
            square(10.0, 2.0, 5.0),
            square(2.0, 0.0, 5.0),
            circle(5.0, 15.0, 5.0, 1.0),
            polygon(&[(10.001, 5.0), (15.0, 3.0), (15.0, 8.0)]),
            polygon(&[(8.0, 0.001), (15.0, -3.0), (15.0, 8.0)]),
        ] {
            assert_eq!(overlay(&[a.clone(), b.clone()], &[]), Err(Touching(0, 1)), "{b:?}");
        }
        // A corner on a line is a crossing where both lines that meet in it go through.
        let corner = polygon(&[(10.0, 5.0), (5.0, 8.0), (15.0, 8.0)]);
        assert_eq!(areas(&[a.clone(), corner.clone()], &[]).len(), 1);
    }
}
