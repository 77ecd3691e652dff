//! Rounding and chamfering the corner between two contour elements.

use super::{Element, Point2, SAME_DIRECTION, Vec2, cross, distance, intersect, left, turned};

/// What replaces a corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Where the element before ends now.
    pub leave: Point2,
    /// Where the element after starts now.
    pub join: Point2,
    /// Centre and sense of the arc between; `None` for a chamfer.
    pub arc: Option<(Point2, bool)>,
}

/// Size of a corner, in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Size {
    /// Of a rounding.
    Radius(f64),
    /// Cut off along each side by a chamfer.
    Side(f64),
    /// Of the chamfer itself.
    Length(f64),
}

/// Why there is no cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoCut {
    /// The elements continue in the same direction.
    Straight,
    /// The second element goes back the way of the first.
    Reversal,
    /// The cut would be longer than an element.
    TooLarge,
    /// A chamfer beside an arc.
    Arc,
    /// An element has no length.
    Degenerate,
}

/// Rounds the corner with `radius`. `tol` is how much an element may fall short, in mm.
///
/// # Errors
/// See [`NoCut`].
pub fn rounding(before: &Element, after: &Element, radius: f64, tol: f64) -> Result<Cut, NoCut> {
    let (u, w) = directions(before, after)?;
    let side = if cross(u, w) > 0.0 { 1.0 } else { -1.0 };
    let corner = before.to();
    if let (Element::Line { .. }, Element::Line { .. }) = (before, after) {
        let back = radius * tan_of_half(u, w);
        fits(back, before, after, tol)?;
        let leave = corner - u * back;
        return Ok(Cut { leave, join: corner + w * back, arc: Some((leave + left(u) * (side * radius), side > 0.0)) });
    }
    let mut best: Option<(f64, Cut)> = None;
    for center in centers(before, after, u, w, side * radius, tol) {
        let (Some(leave), Some(join)) = (foot(before, center), foot(after, center)) else { continue };
        let lost = before.length() - before.way_to(leave);
        let used = after.way_to(join);
        let inside = lost >= -tol && used >= -tol && before.way_to(leave) >= -tol && used <= after.length() + tol;
        let lost_all = lost + used;
        if inside && best.is_none_or(|(least, _)| lost_all < least) {
            best = Some((lost_all, Cut { leave, join, arc: Some((center, side > 0.0)) }));
        }
    }
    best.map(|(_, cut)| cut).ok_or(NoCut::TooLarge)
}

/// Chamfers the corner between two lines by `side` along each of them.
///
/// # Errors
/// See [`NoCut`].
pub fn chamfer(before: &Element, after: &Element, side: f64, tol: f64) -> Result<Cut, NoCut> {
    let (Element::Line { .. }, Element::Line { .. }) = (before, after) else { return Err(NoCut::Arc) };
    let (u, w) = directions(before, after)?;
    fits(side, before, after, tol)?;
    Ok(Cut { leave: before.to() - u * side, join: after.from() + w * side, arc: None })
}

/// Chamfers the corner by `side`, measured along each of the two elements.
///
/// # Errors
/// See [`NoCut`].
pub fn chamfer_along(before: &Element, after: &Element, side: f64, tol: f64) -> Result<Cut, NoCut> {
    directions(before, after)?;
    fits(side, before, after, tol)?;
    Ok(Cut { leave: at_way(before, before.length() - side), join: at_way(after, side), arc: None })
}

/// The point of an element at `way` from its start, along it.
fn at_way(element: &Element, way: f64) -> Point2 {
    let share = way / element.length();
    match *element {
        Element::Line { from, to } => from + (to - from) * share,
        Element::Arc { from, center, sweep, .. } => center + turned(from - center, sweep * share),
    }
}

/// How much a corner cuts off each of two lines; `None` beside an arc.
pub fn cut_off(before: &Element, after: &Element, size: Size) -> Option<f64> {
    let (Element::Line { .. }, Element::Line { .. }) = (before, after) else { return None };
    let (u, w) = directions(before, after).ok()?;
    Some(match size {
        Size::Radius(radius) => radius * tan_of_half(u, w),
        Size::Side(side) => side,
        Size::Length(length) => length / (u + w).norm(),
    })
}

/// The largest part of `size` for which a corner fits, from 0 to 1.
pub fn largest(before: &Element, after: &Element, size: Size, tol: f64) -> f64 {
    if let Some(back) = cut_off(before, after, size) {
        return (before.length().min(after.length()) / back).min(1.0);
    }
    let made = |part: f64| match size {
        Size::Radius(radius) => rounding(before, after, radius * part, tol),
        Size::Side(side) => chamfer_at_arc(before, after, Size::Side(side * part), tol),
        Size::Length(length) => chamfer_at_arc(before, after, Size::Length(length * part), tol),
    };
    let (mut fits, mut large) = (0.0, 1.0);
    // Each step halves what is not known.
    for _ in 0..50 {
        let middle = 0.5 * (fits + large);
        if made(middle).is_ok() { fits = middle } else { large = middle }
    }
    fits
}

/// Chamfers the corner between two lines by a chamfer of `length`, the same angle to both.
///
/// # Errors
/// See [`NoCut`].
pub fn chamfer_of_length(before: &Element, after: &Element, length: f64, tol: f64) -> Result<Cut, NoCut> {
    let (u, w) = directions(before, after)?;
    // The chamfer is the base of a triangle with two equal sides along -u and w.
    chamfer(before, after, length / (u + w).norm(), tol)
}

/// Chamfers a corner beside an arc: at a right angle to the bisector of the corner, its ends on both elements.
/// `Size::Side` means the chamfer that would cut so much off the two tangents of the corner.
///
/// # Errors
/// See [`NoCut`].
pub fn chamfer_at_arc(before: &Element, after: &Element, size: Size, tol: f64) -> Result<Cut, NoCut> {
    let (u, w) = directions(before, after)?;
    let along = u + w;
    let length = match size {
        Size::Side(side) => side * along.norm(),
        Size::Length(length) => length,
        Size::Radius(_) => return Err(NoCut::Degenerate),
    };
    let frame = AtCorner { corner: before.to(), along: along / along.norm(), inward: (w - u) / (w - u).norm() };
    let (Some(a), Some(b)) = (frame.track(before, u), frame.track(after, w)) else { return Err(NoCut::Degenerate) };
    let width = |depth: f64| b.at(depth) - a.at(depth);
    // Beyond the least depth of the two an arc turns back; between lines the chamfer grows for ever.
    let deepest = a.deepest.min(b.deepest).min(before.length() + after.length());
    if width(deepest) < length {
        return Err(NoCut::TooLarge);
    }
    let (mut less, mut more) = (0.0, deepest);
    // Each step halves what is not known.
    for _ in 0..100 {
        let middle = 0.5 * (less + more);
        if width(middle) < length { less = middle } else { more = middle }
    }
    let depth = 0.5 * (less + more);
    let (leave, join) = (frame.point(depth, a.at(depth)), frame.point(depth, b.at(depth)));
    let lost = before.length() - before.way_to(leave);
    let used = after.way_to(join);
    let fits = |part: f64, whole: f64| (-tol..=whole + tol).contains(&part);
    if !fits(lost, before.length()) || !fits(used, after.length()) {
        return Err(NoCut::TooLarge);
    }
    Ok(Cut { leave, join, arc: None })
}

/// Coordinates at a corner: into it along the bisector, and across from the element before to the one after.
struct AtCorner {
    corner: Point2,
    along: Vec2,
    inward: Vec2,
}

/// Where an element lies across the corner, by the depth in it.
struct Track {
    /// Across per depth of a line, or centre and radius of an arc, with the side of the centre it runs on.
    curve: Run,
    /// Largest depth up to which it leads away from the corner.
    deepest: f64,
}

enum Run {
    Line(f64),
    Arc { depth: f64, across: f64, radius: f64 },
}

impl AtCorner {
    fn point(&self, depth: f64, across: f64) -> Point2 {
        self.corner + self.inward * depth + self.along * across
    }

    /// `dir` is the direction of travel at the corner.
    fn track(&self, element: &Element, dir: Vec2) -> Option<Track> {
        let (deep, across) = (dir.dot(&self.inward), dir.dot(&self.along));
        match *element {
            Element::Line { .. } => {
                (deep != 0.0).then_some(Track { curve: Run::Line(across / deep), deepest: f64::INFINITY })
            }
            Element::Arc { center, .. } => {
                let to = center - self.corner;
                let (depth, across) = (to.dot(&self.inward), to.dot(&self.along));
                let radius = to.norm();
                let deepest = if depth > 0.0 { depth } else { radius + depth };
                (across != 0.0).then_some(Track { curve: Run::Arc { depth, across, radius }, deepest })
            }
        }
    }
}

impl Track {
    fn at(&self, depth: f64) -> f64 {
        match self.curve {
            Run::Line(slope) => slope * depth,
            Run::Arc { depth: center, across, radius } => {
                let off = (radius * radius - (depth - center) * (depth - center)).max(0.0).sqrt();
                across - off.copysign(across)
            }
        }
    }
}

/// Tangent of half the angle by which `w` turns from `u`, both of length 1: no trigonometry, so right angles stay exact. Of the two forms
/// the one that takes no difference of numbers nearly alike.
pub fn tan_of_half(u: Vec2, w: Vec2) -> f64 {
    let (sin, cos) = (cross(u, w).abs(), u.dot(&w));
    if cos >= 0.0 { sin / (1.0 + cos) } else { (1.0 - cos) / sin }
}

fn directions(before: &Element, after: &Element) -> Result<(Vec2, Vec2), NoCut> {
    let (Some(u), Some(w)) = (before.end_direction(), after.start_direction()) else {
        return Err(NoCut::Degenerate);
    };
    if cross(u, w).abs() <= SAME_DIRECTION {
        return Err(if u.dot(&w) > 0.0 { NoCut::Straight } else { NoCut::Reversal });
    }
    Ok((u, w))
}

fn fits(back: f64, before: &Element, after: &Element, tol: f64) -> Result<(), NoCut> {
    if back > before.length() + tol || back > after.length() + tol { Err(NoCut::TooLarge) } else { Ok(()) }
}

/// Points at the distance `|shift|` from both elements, on the left for a positive shift.
fn centers(before: &Element, after: &Element, u: Vec2, w: Vec2, shift: f64, tol: f64) -> Vec<Point2> {
    let found = match (shifted(before, u, shift), shifted(after, w, shift)) {
        (Some(Curve::Line(p, u)), Some(Curve::Line(q, w))) => {
            intersect::lines(p, u, q, w, SAME_DIRECTION).map(|(s, _)| [p + u * s; 2])
        }
        (Some(Curve::Line(p, u)), Some(Curve::Circle(c, r))) | (Some(Curve::Circle(c, r)), Some(Curve::Line(p, u))) => {
            intersect::line_circle(p, u, c, r, tol)
        }
        (Some(Curve::Circle(a, ra)), Some(Curve::Circle(b, rb))) => intersect::circles(a, ra, b, rb, tol),
        _ => None,
    };
    found.map(|pair| pair.to_vec()).unwrap_or_default()
}

enum Curve {
    Line(Point2, Vec2),
    Circle(Point2, f64),
}

/// The curve beside an element. `None` where an arc has no room for it.
fn shifted(element: &Element, dir: Vec2, shift: f64) -> Option<Curve> {
    match *element {
        Element::Line { to, .. } => Some(Curve::Line(to + left(dir) * shift, dir)),
        Element::Arc { from, center, sweep, .. } => {
            let radius = distance(from, center) - if sweep > 0.0 { shift } else { -shift };
            (radius > 0.0).then_some(Curve::Circle(center, radius))
        }
    }
}

/// The point of an element's curve nearest to `p`.
fn foot(element: &Element, p: Point2) -> Option<Point2> {
    match *element {
        Element::Line { from, to } => super::direction(to - from, 0.0).map(|u| from + u * (p - from).dot(&u)),
        Element::Arc { from, center, .. } => {
            super::direction(p - center, 0.0).map(|d| center + d * distance(from, center))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::arc;
    use proptest::prelude::*;

    fn line(a: (f64, f64), b: (f64, f64)) -> Element {
        Element::Line { from: Point2::new(a.0, a.1), to: Point2::new(b.0, b.1) }
    }

    fn tangent(cut: &Cut, before: &Element, after: &Element, radius: f64) -> bool {
        let (center, ccw) = cut.arc.unwrap();
        let a = before.ending_at(cut.leave).end_direction();
        let b = after.starting_at(cut.join).start_direction();
        let near = |d: Option<Vec2>, at| {
            d.is_none_or(|d| arc::tangent_at(at, center, ccw).is_some_and(|t| (t - d).norm() < 1e-6))
        };
        (distance(cut.leave, center) - radius).abs() < 1e-7
            && (distance(cut.join, center) - radius).abs() < 1e-7
            && near(a, cut.leave)
            && near(b, cut.join)
    }

    /// The lines nearly turn back: what is cut off is long, and has all its digits.
    #[test]
    fn rounding_of_a_sharp_corner() {
        let (far, up) = (100_019.0, 17.3205);
        let cut = rounding(&line((-far, 0.0), (0.0, 0.0)), &line((0.0, 0.0), (-far, up)), 3.0, 1e-9).unwrap();
        let half = libm::atan2(up, far) / 2.0;
        assert!((cut.leave.x + 3.0 / libm::tan(half)).abs() < 1e-6, "{cut:?}");
    }

    #[test]
    fn rounding_of_the_manual() {
        // (10,40) -> (40,25) -> (10,5), R5.
        let cut = rounding(&line((10.0, 40.0), (40.0, 25.0)), &line((40.0, 25.0), (10.0, 5.0)), 5.0, 1e-9).unwrap();
        let near = |p: Point2, x: f64, y: f64| (p - Point2::new(x, y)).norm() < 1e-4;
        assert!(near(cut.leave, 32.2937, 28.8531) && near(cut.join, 32.8311, 20.2208), "{cut:?}");
        assert!(!cut.arc.unwrap().1);
    }

    #[test]
    fn refusals() {
        let a = line((0.0, 0.0), (10.0, 0.0));
        assert_eq!(rounding(&a, &line((10.0, 0.0), (20.0, 0.0)), 1.0, 1e-9), Err(NoCut::Straight));
        assert_eq!(rounding(&a, &line((10.0, 0.0), (5.0, 0.0)), 1.0, 1e-9), Err(NoCut::Reversal));
        assert_eq!(rounding(&a, &line((10.0, 0.0), (10.0, 3.0)), 4.0, 1e-9), Err(NoCut::TooLarge));
        assert_eq!(chamfer(&a, &line((10.0, 0.0), (10.0, 3.0)), 4.0, 1e-9), Err(NoCut::TooLarge));
        assert_eq!(rounding(&a, &line((10.0, 0.0), (10.0, 0.0)), 4.0, 1e-9), Err(NoCut::Degenerate));
    }

    /// Distance of `p` from the curve of `element`.
    fn off(element: &Element, p: Point2) -> f64 {
        foot(element, p).map_or(f64::INFINITY, |at| distance(at, p))
    }

    #[test]
    fn chamfers_at_arcs() {
        // A quarter circle about (0,10) from (0,0) to (10,10), then a line to -X: the corner is square.
        let center = Point2::new(0.0, 10.0);
        let quarter = core::f64::consts::FRAC_PI_2;
        let (from, to) = (Point2::origin(), Point2::new(10.0, 10.0));
        let arc = Element::Arc { from, to, center, sweep: quarter };
        let after = line((10.0, 10.0), (-10.0, 10.0));
        // The chamfer runs along (-1,1): its ends are (x, 10 - d) on the circle and (x - d, 10), d = length / sqrt(2).
        let cut = chamfer_at_arc(&arc, &after, Size::Length(2.0), 1e-9).unwrap();
        let d = core::f64::consts::SQRT_2;
        let x = (100.0 - d * d).sqrt();
        assert!(distance(cut.leave, Point2::new(x, 10.0 - d)) < 1e-9, "{cut:?}");
        assert!(distance(cut.join, Point2::new(x - d, 10.0)) < 1e-9, "{cut:?}");
        // 1 mm off each tangent of a square corner makes sqrt(2).
        let side = chamfer_at_arc(&arc, &after, Size::Side(1.0), 1e-9).unwrap();
        assert!((distance(side.leave, side.join) - d).abs() < 1e-9);
        assert_eq!(chamfer_at_arc(&arc, &after, Size::Length(20.0), 1e-9), Err(NoCut::TooLarge));
        assert_eq!(
            chamfer_at_arc(&arc, &line((10.0, 10.0), (10.0, 20.0)), Size::Length(1.0), 1e-9),
            Err(NoCut::Straight)
        );
        // Between two lines it is the chamfer of before.
        let (a, b) = (line((0.0, 0.0), (60.0, 0.0)), line((60.0, 0.0), (90.0, 40.0)));
        let (lines, arcs) =
            (chamfer(&a, &b, 6.0, 1e-9).unwrap(), chamfer_at_arc(&a, &b, Size::Side(6.0), 1e-9).unwrap());
        assert!(distance(lines.leave, arcs.leave) < 1e-9 && distance(lines.join, arcs.join) < 1e-9);
    }

    proptest! {
        #[test]
        fn a_chamfer_at_an_arc_lies_across_the_bisector(
            radius in 3.0f64..40.0, ccw in any::<bool>(), turn in 15.0f64..165.0, left_turn in any::<bool>(),
            length in 0.05f64..3.0, second in 0u8..3, backwards in any::<bool>()
        ) {
            let sweep = if ccw { 1.2 } else { -1.2 };
            let center = Point2::new(0.0, if ccw { radius } else { -radius });
            let to = center + crate::geo::turned(Point2::origin() - center, sweep);
            let mut before = Element::Arc { from: Point2::origin(), to, center, sweep };
            let u = before.end_direction().unwrap();
            let w = crate::geo::turned(u, if left_turn { 1.0 } else { -1.0 } * turn.to_radians());
            let mut after = if second == 0 {
                Element::Line { from: to, to: to + w * 30.0 }
            } else {
                let sweep = if second == 1 { 1.1 } else { -1.1 };
                let center = to + left(w) * (radius * 0.7).copysign(sweep);
                Element::Arc { from: to, to: center + crate::geo::turned(to - center, sweep), center, sweep }
            };
            if backwards {
                let turned = |element: &Element| match *element {
                    Element::Line { from, to } => Element::Line { from: to, to: from },
                    Element::Arc { from, to, center, sweep } => Element::Arc { from: to, to: from, center, sweep: -sweep },
                };
                (before, after) = (turned(&after), turned(&before));
            }
            let (u, w) = (before.end_direction().unwrap(), after.start_direction().unwrap());
            if let Ok(cut) = chamfer_at_arc(&before, &after, Size::Length(length), 1e-9) {
                let chord = cut.join - cut.leave;
                prop_assert!((chord.norm() - length).abs() < 1e-8, "{cut:?}");
                prop_assert!(chord.dot(&(w - u)).abs() < 1e-8 && chord.dot(&(u + w)) > 0.0, "{cut:?}");
                prop_assert!(off(&before, cut.leave) < 1e-8 && off(&after, cut.join) < 1e-8, "{cut:?}");
                prop_assert!(before.way_to(cut.leave) <= before.length() && after.way_to(cut.join) <= after.length());
            } else {
                // Arcs that bend towards each other leave a narrow gap, those of an S a narrow step.
                let turn = turn.to_radians();
                let room = f64::min(1.0 + libm::cos(turn), 1.0 - libm::cos(turn / 2.0));
                prop_assert!(length > 0.35 * radius * room, "a small chamfer fits everywhere");
            }
        }

        #[test]
        fn a_rounding_is_tangent_to_lines(angle in 5.0f64..175.0, flip in any::<bool>(), radius in 0.1f64..3.0) {
            let w = crate::geo::Deg(if flip { -angle } else { angle }).unit() * 100.0;
            let (a, b) = (line((-100.0, 0.0), (0.0, 0.0)), line((0.0, 0.0), (w.x, w.y)));
            let cut = rounding(&a, &b, radius, 1e-9).unwrap();
            prop_assert!(tangent(&cut, &a, &b, radius));
        }

        #[test]
        fn a_rounding_is_tangent_to_arcs(sweep_deg in 20.0f64..170.0, ccw in any::<bool>(), turn in 20.0f64..160.0,
                                         left_turn in any::<bool>(), radius in 0.05f64..1.0, both in any::<bool>()) {
            let center = Point2::new(0.0, if ccw { 20.0 } else { -20.0 });
            let sweep = if ccw { 1.0 } else { -1.0 } * sweep_deg.to_radians();
            let to = center + crate::geo::turned(Point2::origin() - center, sweep);
            let before = Element::Arc { from: Point2::origin(), to, center, sweep };
            let u = before.end_direction().unwrap();
            let w = crate::geo::turned(u, if left_turn { 1.0 } else { -1.0 } * turn.to_radians());
            let after = if both {
                let center = to + left(w) * 15.0;
                Element::Arc { from: to, to: center + crate::geo::turned(to - center, 1.2), center, sweep: 1.2 }
            } else {
                Element::Line { from: to, to: to + w * 30.0 }
            };
            if let Ok(cut) = rounding(&before, &after, radius, 1e-9) {
                prop_assert!(tangent(&cut, &before, &after, radius), "{cut:?}");
            }
        }
    }

    #[test]
    fn the_largest_part_of_a_corner_at_an_arc_just_fits() {
        // The quarter circle of above and the line across it: at most a circle of radius r fits between them.
        let arc = Element::Arc {
            from: Point2::origin(),
            to: Point2::new(10.0, 10.0),
            center: Point2::new(0.0, 10.0),
            sweep: core::f64::consts::FRAC_PI_2,
        };
        let after = line((10.0, 10.0), (-10.0, 10.0));
        let made = |size: Size, part: f64| match size {
            Size::Radius(radius) => rounding(&arc, &after, radius * part, 1e-9),
            Size::Side(side) => chamfer_at_arc(&arc, &after, Size::Side(side * part), 1e-9),
            Size::Length(length) => chamfer_at_arc(&arc, &after, Size::Length(length * part), 1e-9),
        };
        for size in [Size::Radius(60.0), Size::Side(40.0), Size::Length(50.0)] {
            let part = largest(&arc, &after, size, 1e-9);
            assert!(part > 0.05 && part < 1.0, "{part}");
            assert!(made(size, part).is_ok() && made(size, part * (1.0 + 1e-6)).is_err(), "{part}");
        }
        // A circle in the quarter that touches the line touches the arc at its start: (10 - r)² = r² + x², x = 0.
        assert!((60.0 * largest(&arc, &after, Size::Radius(60.0), 1e-9) - 5.0).abs() < 1e-3);
    }
}
