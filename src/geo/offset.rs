//! The line parallel to a contour: every element moved sideways, outer corners rounded, inner corners cut.

use super::arc::{NEARLY_ONE_POINT, sweep};
use super::{Element, Point2, SAME_POINT, Vec2, clearance, cross, direction, distance, left};

/// Directions whose sine is below this go on without a corner: what four decimals lose.
const TANGENTIAL: f64 = 1e-3;

/// Arcs with a shorter chord are lines, mm; the limit for full circles holds for each axis.
const SHORTEST_ARC: f64 = 1.5 * NEARLY_ONE_POINT;

/// How much nearer than asked the parallel may come, mm: what tangential joints and arithmetic lose.
pub const NEARER: f64 = 1e-3;

/// Why a contour has no parallel at a distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoParallel {
    /// A hollow arc, an inner corner or a short element has no room for it.
    TooNarrow,
    /// The contour turns back on itself.
    Reversal,
    Empty,
}

/// An element of the parallel, and the place in the contour of the one it comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OffsetElement {
    pub element: Element,
    pub of: usize,
}

/// The parallel of `chain` at `offset` mm, positive to the left. Elements have to join. The rounding of an outer
/// corner comes from the element before it.
///
/// # Errors
/// See [`NoParallel`]. What is returned comes no nearer to any element of the chain than `offset`.
pub fn parallel(chain: &[Element], offset: f64) -> Result<Vec<OffsetElement>, NoParallel> {
    let parts = chain.iter().enumerate().filter(|(_, element)| element.length() > SAME_POINT);
    let mut made: Vec<OffsetElement> = Vec::with_capacity(2 * chain.len());
    for (of, element) in parts {
        if offset == 0.0 {
            made.push(OffsetElement { element: *element, of });
            continue;
        }
        let next = OffsetElement { element: moved(element, offset)?, of };
        match made.pop() {
            None => made.push(next),
            Some(last) => join(last, next, element.from(), offset, &mut made)?,
        }
    }
    if made.is_empty() {
        return Err(NoParallel::Empty);
    }
    for part in &mut made {
        part.element = long_enough(part.element);
    }
    let near = |a: &OffsetElement| chain.iter().any(|b| clearance::between(&a.element, b) < offset.abs() - NEARER);
    if offset != 0.0 && made.iter().any(near) { Err(NoParallel::TooNarrow) } else { Ok(made) }
}

fn moved(element: &Element, offset: f64) -> Result<Element, NoParallel> {
    match *element {
        Element::Line { from, to } => {
            let u = direction(to - from, 0.0).ok_or(NoParallel::Empty)?;
            let by = left(u) * offset;
            Ok(Element::Line { from: from + by, to: to + by })
        }
        Element::Arc { from, to, center, sweep } => {
            let radius = distance(from, center);
            // Left of a counter-clockwise arc lies its centre.
            let other = radius - offset * sweep.signum();
            if other <= NEARLY_ONE_POINT || radius <= 0.0 {
                return Err(NoParallel::TooNarrow);
            }
            let place = |p: Point2| center + (p - center) * (other / radius);
            Ok(Element::Arc { from: place(from), to: place(to), center, sweep })
        }
    }
}

/// Adds `next` behind `last`, which met at `corner` before both were moved.
fn join(
    last: OffsetElement,
    next: OffsetElement,
    corner: Point2,
    offset: f64,
    out: &mut Vec<OffsetElement>,
) -> Result<(), NoParallel> {
    let (a, b) = (last.element, next.element);
    let (Some(u), Some(w)) = (a.end_direction(), b.start_direction()) else { return Err(NoParallel::Empty) };
    let turn = cross(u, w);
    if turn.abs() <= TANGENTIAL && u.dot(&w) < 0.0 {
        return Err(NoParallel::Reversal);
    }
    if turn.abs() <= TANGENTIAL {
        tangential(last, next, out);
    } else if turn * offset < 0.0 {
        let (from, to) = (a.to(), b.from());
        let arc = Element::Arc { from, to, center: corner, sweep: sweep(from, to, corner, offset < 0.0) };
        out.extend([last, OffsetElement { element: arc, of: last.of }, next]);
    } else {
        let at = inner_corner(&a, &b).ok_or(NoParallel::TooNarrow)?;
        out.extend([
            OffsetElement { element: a.ending_at(at), ..last },
            OffsetElement { element: b.starting_at(at), ..next },
        ]);
    }
    Ok(())
}

/// Ends that are one point up to what a drawing rounds: a line takes the end of its neighbour.
fn tangential(last: OffsetElement, next: OffsetElement, out: &mut Vec<OffsetElement>) {
    let (from, to) = (last.element.to(), next.element.from());
    match (last.element, next.element) {
        (Element::Line { from: start, .. }, _) => {
            out.extend([OffsetElement { element: Element::Line { from: start, to }, ..last }, next]);
        }
        (_, Element::Line { to: end, .. }) => {
            out.extend([last, OffsetElement { element: Element::Line { from, to: end }, ..next }]);
        }
        _ if distance(from, to) <= SAME_POINT => out.extend([last, next]),
        _ => out.extend([last, OffsetElement { element: Element::Line { from, to }, of: last.of }, next]),
    }
}

/// Where both moved elements cross: the crossing on both of them that comes last on the way of the first.
fn inner_corner(last: &Element, next: &Element) -> Option<Point2> {
    let inside = |e: &Element, p: &Point2| {
        let way = e.way_to(*p);
        clearance::point_to(*p, e) <= NEARER && way > 0.0 && way <= e.length() + NEARER
    };
    let touching =
        |p: &Point2| inside(last, p) && clearance::point_to(*p, next) <= NEARER && next.way_to(*p) < next.length();
    clearance::crossings(last, next, 0.0)
        .into_iter()
        .flatten()
        .filter(touching)
        .max_by(|a, b| last.way_to(*a).total_cmp(&last.way_to(*b)))
}

/// An arc so short that it might be taken for a full circle becomes a line.
fn long_enough(element: Element) -> Element {
    match element {
        Element::Arc { from, to, sweep, .. }
            if distance(from, to) <= SHORTEST_ARC && sweep.abs() < core::f64::consts::PI =>
        {
            Element::Line { from, to }
        }
        other => other,
    }
}

/// All elements moved by `by`.
pub fn shifted(chain: &[Element], by: Vec2) -> Vec<Element> {
    let shift = |element: &Element| match *element {
        Element::Line { from, to } => Element::Line { from: from + by, to: to + by },
        Element::Arc { from, to, center, sweep } => {
            Element::Arc { from: from + by, to: to + by, center: center + by, sweep }
        }
    };
    chain.iter().map(shift).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn lines(points: &[(f64, f64)]) -> Vec<Element> {
        let p = |p: (f64, f64)| Point2::new(p.0, p.1);
        points.windows(2).map(|pair| Element::Line { from: p(pair[0]), to: p(pair[1]) }).collect()
    }

    fn ends(chain: &[OffsetElement]) -> Vec<(f64, f64)> {
        let round = |v: f64| (v * 1e6).round() / 1e6 + 0.0;
        let mut points: Vec<Point2> = chain.iter().map(|part| part.element.to()).collect();
        points.insert(0, chain[0].element.from());
        points.iter().map(|p| (round(p.x), round(p.y))).collect()
    }

    #[test]
    fn outer_and_inner_corners() {
        let steps = lines(&[(10.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0)]);
        // Travelling to -x, the right side is above: an inner corner, then an outer one.
        let above = parallel(&steps, -1.0).unwrap();
        assert_eq!(ends(&above), [(10.0, 1.0), (6.0, 1.0), (6.0, 5.0), (5.0, 6.0), (0.0, 6.0)]);
        assert!(matches!(above[2].element, Element::Arc { sweep, .. } if sweep > 0.0));
        assert_eq!(above.iter().map(|part| part.of).collect::<Vec<_>>(), [0, 1, 1, 2]);
        let below = parallel(&steps, 1.0).unwrap();
        assert_eq!(ends(&below), [(10.0, -1.0), (5.0, -1.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        assert_eq!(ends(&parallel(&steps, 0.0).unwrap()), [(10.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0)]);
    }

    #[test]
    fn what_has_no_room() {
        assert_eq!(
            parallel(&lines(&[(0.0, 5.0), (0.0, 0.0), (3.0, 0.0), (3.0, 5.0)]), 1.6),
            Err(NoParallel::TooNarrow)
        );
        assert_eq!(parallel(&lines(&[(0.0, 0.0), (5.0, 0.0), (1.0, 0.0)]), 1.0), Err(NoParallel::Reversal));
        let hollow = Element::Arc {
            from: Point2::new(0.0, 0.0),
            to: Point2::new(2.0, 0.0),
            center: Point2::new(1.0, 0.0),
            sweep: core::f64::consts::PI,
        };
        assert_eq!(parallel(&[hollow], 1.0), Err(NoParallel::TooNarrow));
        assert!(parallel(&[hollow], 0.5).is_ok());
    }

    proptest! {
        /// Whatever the contour: the parallel joins, and comes no nearer than it should.
        #[test]
        fn it_keeps_its_distance(
            points in prop::collection::vec((-20.0f64..20.0, -20.0f64..20.0), 2..8),
            offset in -2.0f64..2.0,
        ) {
            let chain = lines(&points);
            if let Ok(made) = parallel(&chain, offset) {
                for pair in made.windows(2) {
                    prop_assert!(distance(pair[0].element.to(), pair[1].element.from()) < 2e-6);
                }
                for a in &made {
                    for step in 0..=20 {
                        let p = match a.element {
                            Element::Line { from, to } => from + (to - from) * (f64::from(step) / 20.0),
                            Element::Arc { from, center, sweep, .. } => {
                                center + super::super::turned(from - center, sweep * f64::from(step) / 20.0)
                            }
                        };
                        for b in &chain {
                            prop_assert!(clearance::point_to(p, b) > offset.abs() - 2e-3, "{p:?} {b:?}");
                        }
                    }
                }
            }
        }
    }
}
