//! A contour element in the plane: a line or an arc with its ends.

use super::{Point2, Vec2, arc, cross, direction, distance, turned};

/// A line or arc of a contour. `sweep` is signed, counter-clockwise positive, and may exceed a turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Element {
    Line { from: Point2, to: Point2 },
    Arc { from: Point2, to: Point2, center: Point2, sweep: f64 },
}

impl Element {
    pub fn from(&self) -> Point2 {
        match *self {
            Element::Line { from, .. } | Element::Arc { from, .. } => from,
        }
    }

    pub fn to(&self) -> Point2 {
        match *self {
            Element::Line { to, .. } | Element::Arc { to, .. } => to,
        }
    }

    /// Direction of travel at the start; `None` for an element of no length.
    pub fn start_direction(&self) -> Option<Vec2> {
        match *self {
            Element::Line { from, to } => direction(to - from, 0.0),
            Element::Arc { from, center, sweep, .. } => arc::tangent_at(from, center, sweep > 0.0),
        }
    }

    /// Direction of travel at the end; `None` for an element of no length.
    ///
    /// For an arc it is the start direction turned by the sweep, so that it does not depend on how well
    /// the programmed end lies on the circle.
    pub fn end_direction(&self) -> Option<Vec2> {
        match *self {
            Element::Line { from, to } => direction(to - from, 0.0),
            Element::Arc { to, center, sweep, .. } => arc::tangent_at(to, center, sweep > 0.0),
        }
    }

    pub fn length(&self) -> f64 {
        match *self {
            Element::Line { from, to } => distance(from, to),
            Element::Arc { from, center, sweep, .. } => distance(from, center) * sweep.abs(),
        }
    }

    /// Way along the element from its start to `p`, a point on it; negative in front of the start.
    pub fn way_to(&self, p: Point2) -> f64 {
        match *self {
            Element::Line { from, to } => direction(to - from, 0.0).map_or(0.0, |u| (p - from).dot(&u)),
            Element::Arc { from, center, sweep, .. } => {
                let turn = arc::sweep(from, p, center, sweep > 0.0).abs();
                let turn = if turn > core::f64::consts::TAU - 1e-9 { 0.0 } else { turn };
                turn * distance(from, center)
            }
        }
    }

    /// The part from the start to `p`.
    pub fn ending_at(&self, p: Point2) -> Element {
        match *self {
            Element::Line { from, .. } => Element::Line { from, to: p },
            Element::Arc { from, to, center, sweep } => {
                let cut = arc::sweep(p, to, center, sweep > 0.0);
                let cut = if cut.abs() > sweep.abs() { 0.0 } else { cut };
                Element::Arc { from, to: p, center, sweep: sweep - cut }
            }
        }
    }

    /// The part from `p` to the end.
    pub fn starting_at(&self, p: Point2) -> Element {
        match *self {
            Element::Line { to, .. } => Element::Line { from: p, to },
            Element::Arc { from, to, center, sweep } => {
                let cut = arc::sweep(from, p, center, sweep > 0.0);
                let cut = if cut.abs() > sweep.abs() { 0.0 } else { cut };
                Element::Arc { from: p, to, center, sweep: sweep - cut }
            }
        }
    }

    /// The element from its end to its start.
    /// The same element elsewhere.
    pub fn shifted(&self, by: Vec2) -> Element {
        match *self {
            Element::Line { from, to } => Element::Line { from: from + by, to: to + by },
            Element::Arc { from, to, center, sweep } => {
                Element::Arc { from: from + by, to: to + by, center: center + by, sweep }
            }
        }
    }

    pub fn reversed(&self) -> Element {
        match *self {
            Element::Line { from, to } => Element::Line { from: to, to: from },
            Element::Arc { from, to, center, sweep } => Element::Arc { from: to, to: from, center, sweep: -sweep },
        }
    }

    /// Point at half the way.
    pub fn middle(&self) -> Point2 {
        match *self {
            Element::Line { from, to } => from + (to - from) / 2.0,
            Element::Arc { from, center, sweep, .. } => center + turned(from - center, sweep / 2.0),
        }
    }
}

/// The element in pieces between its leftmost, topmost, rightmost and lowest points.
pub fn quarters(element: &Element) -> Vec<Element> {
    let Element::Arc { from, to, center, sweep } = *element else { return vec![*element] };
    let radius = distance(from, center);
    let poles = [Vec2::x(), Vec2::y(), -Vec2::x(), -Vec2::y()];
    let mut cuts: Vec<(f64, Point2)> = poles
        .iter()
        .filter_map(|pole| {
            let start = from - center;
            let turn = libm::atan2(cross(start, *pole), start.dot(pole));
            let turn = if sweep > 0.0 { turn } else { -turn };
            let turn = if turn <= 0.0 { turn + core::f64::consts::TAU } else { turn };
            // A pole at an end cuts nothing off.
            let near = 1e-9;
            (turn > near && turn < sweep.abs() - near && turn < core::f64::consts::TAU - near)
                .then_some((turn, center + *pole * radius))
        })
        .collect();
    cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut list = Vec::with_capacity(cuts.len() + 1);
    let (mut at, mut done) = (from, 0.0);
    let sign = sweep.signum();
    for (turn, p) in cuts {
        list.push(Element::Arc { from: at, to: p, center, sweep: sign * (turn - done) });
        (at, done) = (p, turn);
    }
    list.push(Element::Arc { from: at, to, center, sweep: sweep - sign * done });
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_along_an_arc_begins_at_its_start() {
        for sweep in [3.0, -3.0] {
            let center = Point2::new(2.0, 1.0);
            let at = |angle: f64| center + turned(Vec2::new(10.0, 0.0), angle);
            let arc = Element::Arc { from: at(0.0), to: at(sweep), center, sweep };
            for share in [0.25, 0.5, 1.0] {
                assert!((arc.way_to(at(share * sweep)) - 30.0 * share).abs() < 1e-9, "{share} {sweep}");
            }
            // Its start is not a turn away, nor is what rounding puts in front of it.
            assert_eq!(arc.way_to(arc.from()).abs(), 0.0);
            assert_eq!(arc.way_to(at(-1e-11 * sweep)).abs(), 0.0);
        }
    }

    #[test]
    fn quarters_of_a_half_circle() {
        let half = Element::Arc {
            from: Point2::new(0.0, 0.0),
            to: Point2::new(4.0, 0.0),
            center: Point2::new(2.0, 0.0),
            sweep: core::f64::consts::PI,
        };
        let parts = quarters(&half);
        assert_eq!(parts.len(), 2);
        assert!(
            (parts[0].to() - Point2::new(2.0, -2.0)).norm() < 1e-9
                && (parts[1].to() - Point2::new(4.0, 0.0)).norm() < 1e-9
        );
    }

    #[test]
    fn a_circle_is_cut_at_its_poles() {
        let center = Point2::new(2.0, 1.0);
        let at = |degrees: f64| center + turned(Vec2::new(10.0, 0.0), f64::to_radians(degrees));
        for (start, sweep, cuts) in
            [(30.0, 290.0, vec![90.0, 180.0, 270.0]), (30.0, -140.0, vec![0.0, -90.0]), (100.0, 60.0, vec![])]
        {
            let arc = Element::Arc { from: at(start), to: at(start + sweep), center, sweep: f64::to_radians(sweep) };
            let pieces = quarters(&arc);
            let mut wanted = cuts;
            wanted.push(start + sweep);
            assert_eq!(pieces.len(), wanted.len());
            let mut begin = start;
            for (piece, end) in pieces.iter().zip(wanted) {
                let Element::Arc { from, to, sweep, .. } = *piece else { panic!("{piece:?}") };
                assert!((from - at(begin)).norm() < 1e-9 && (to - at(end)).norm() < 1e-9, "{piece:?}");
                assert!((sweep.to_degrees() - (end - begin)).abs() < 1e-9, "{piece:?}");
                begin = end;
            }
        }
    }
}
