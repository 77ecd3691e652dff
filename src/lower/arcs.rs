//! Pass 1: every arc gets its centre and sweep.
//!
//! A full circle is decided here, on the exact numbers (see [`arc::ONE_POINT`]); nobody derives it from
//! rounded ones later.

use core::f64::consts::TAU;

use crate::diag::{Diagnostic, Diags, Fault, codes};
use crate::geo::arc::{self, Closing, TangentArc};
use crate::geo::{Element, Plane, Point2, SAME_POINT, Vec2, distance};
use crate::ir::contour::{self, ArcShape};
use crate::ir::motion::{Arc, Path};
use crate::ir::{Feed, Origin};
use crate::machine::AxisSet;

use super::at;
use super::step::{Step, plane_axes};

/// Sideways distance under which a tangential end counts as straight ahead, in mm.
const STRAIGHT: f64 = 1e-6;
/// Largest angle in rad by which moving the centre may turn an arc at its start: 1.8 degrees, as controls allow.
const MOST_TURN: f64 = 0.0316;
/// Shifts of a centre up to this much are rounding of the source and not worth a note, in mm.
const UNNOTED: f64 = 0.0005;
/// Shifts above this many tolerances of the source are worth a warning: the arc is short and flat, or a coordinate wrong.
const FAR: f64 = 10.0;

/// Direction of the contour so far.
#[derive(Debug, Default)]
pub struct LastDirection {
    /// The element that has the direction, and its plane.
    element: Option<(Element, Plane)>,
    why: Why,
}

/// Why there is no direction.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
enum Why {
    #[default]
    Start,
    Corner,
    OtherAxis,
}

impl LastDirection {
    pub fn forget(&mut self) {
        *self = LastDirection::default();
    }

    /// After a corner the direction is the one of the next element.
    pub fn corner(&mut self) {
        *self = LastDirection { element: None, why: Why::Corner };
    }

    /// The direction in which the contour goes on in `plane`.
    fn tangent(&self, plane: Plane) -> Option<Vec2> {
        let (element, _) = self.element.filter(|(_, in_plane)| *in_plane == plane)?;
        element.end_direction()
    }

    /// Takes over the direction at the end of `step`.
    #[inline(always)]
    pub fn follow(&mut self, step: &Step) {
        let plane = step.plane();
        let known = step.start.known().common(step.mv.end.known());
        if !plane_axes(plane).without(known).is_empty() {
            return self.forget();
        }
        if step.leaves(plane) {
            self.element = None;
            self.why = Why::OtherAxis;
        } else {
            self.follow_in(plane, step);
        }
    }

    /// The same for a step that stays in `plane`, where both of its ends are known.
    #[inline(never)]
    fn follow_in(&mut self, plane: Plane, step: &Step) {
        // An element of no length leaves the direction as it was.
        if let Some(element) = step.element(plane).filter(is_long) {
            self.element = Some((element, plane));
        }
    }
}

/// Is the element longer than a point?
#[inline]
fn is_long(element: &Element) -> bool {
    if let Element::Line { from, to } = element {
        let way = to - from;
        // No side of a triangle is longer than the one across the right angle.
        if way.x.abs().max(way.y.abs()) > 2.0 * SAME_POINT {
            return true;
        }
    }
    element.length() > SAME_POINT
}

/// How far centres were moved, for one note and one warning at the end.
#[derive(Debug, Default)]
pub struct Adjusted {
    little: Moved,
    /// By more than [`FAR`] times the tolerance of the source.
    far: Moved,
}

#[derive(Debug, Default)]
struct Moved {
    count: u32,
    largest: f64,
    origin: Option<Origin>,
}

impl Moved {
    fn add(&mut self, shift: f64, origin: Origin) {
        self.count += 1;
        if shift > self.largest {
            self.largest = shift;
            self.origin = Some(origin);
        }
    }
}

impl Adjusted {
    /// `tol` is what the source allows start and end to differ in their distance from the centre, in mm.
    fn note(&mut self, shift: f64, tol: f64, origin: Origin) {
        if shift > UNNOTED {
            let moved = if shift > FAR * tol { &mut self.far } else { &mut self.little };
            moved.add(shift, origin);
        }
    }

    pub fn report(&self, diags: &Diags) {
        if let Some(origin) = self.little.origin {
            let Moved { count, largest, .. } = self.little;
            diags.push(at(origin, codes::G3013::arc_centres_were_adjusted(&count, &largest)));
        }
        if let Some(origin) = self.far.origin {
            let Moved { count, largest, .. } = self.far;
            diags.push(at(origin, codes::G8101::arc_centres_were_moved_far(&count, &largest)));
        }
    }
}

/// A refusal, or nothing to say because a start that is not known was reported before.
type Refused = Option<Box<Diagnostic>>;

/// What comes with a completed element.
#[derive(Debug)]
pub enum Extra {
    None,
    /// A second element that ends on the programmed point.
    Second(Box<Step>),
    /// Something worth a word.
    Word(Box<Diagnostic>),
}

/// A straight line, which is complete as it is; `None` for anything else.
#[inline(always)]
pub fn straight(path: &contour::Path) -> Option<Path> {
    match path {
        contour::Path::Rapid => Some(Path::Rapid),
        contour::Path::Line(feed) => Some(Path::Line(*feed)),
        contour::Path::Arc(..) | contour::Path::Thread(_) => None,
    }
}

/// Completes `step` with the geometry of `path`.
///
/// # Errors
/// Geometry that does not exist.
pub fn resolve(
    path: &contour::Path,
    step: &mut Step,
    last: &LastDirection,
    adjusted: &mut Adjusted,
) -> Result<Extra, Refused> {
    match path {
        contour::Path::Rapid | contour::Path::Line(_) => step.mv.path = straight(path).unwrap_or_default(),
        contour::Path::Arc(arc, feed) => {
            let extra = resolve_arc(arc, *feed, step, last, adjusted)?;
            if arc.turns > 0 {
                add_turns(step, arc.turns);
            }
            return Ok(extra);
        }
        contour::Path::Thread(thread) => step.mv.path = thread_path(thread, step)?,
    }
    Ok(Extra::None)
}

/// The ends of an arc and how fast it is travelled.
#[derive(Debug, Clone, Copy)]
struct Ends {
    plane: Plane,
    from: Point2,
    to: Point2,
    feed: Feed,
}

impl Ends {
    fn arc(&self, center: Point2, sweep: f64) -> Path {
        Path::Arc(Arc { plane: self.plane, from: self.from, center, sweep }, self.feed)
    }

    /// Around `center` from end to end.
    fn about(&self, center: Point2, ccw: bool) -> Path {
        self.arc(center, arc::sweep(self.from, self.to, center, ccw))
    }
}

fn resolve_arc(
    shape: &contour::Arc,
    feed: Feed,
    step: &mut Step,
    last: &LastDirection,
    adjusted: &mut Adjusted,
) -> Result<Extra, Refused> {
    let plane = shape.plane;
    let (Some(from), Some(to)) = (step.start.in_plane(plane), step.mv.end.in_plane(plane)) else { return Err(None) };
    let ends = Ends { plane, from, to, feed };
    step.mv.axes = step.mv.axes.union(plane_axes(plane));
    match shape.shape {
        ArcShape::Center { center, ccw, tol } => return by_center(step, &ends, (center, ccw), tol, adjusted),
        ArcShape::Sweep { center, sweep } => {
            if distance(from, center) <= SAME_POINT {
                return refuse(step, codes::G3014::arc_starts_in_its_centre());
            }
            step.mv.path = ends.arc(center, sweep.radians());
        }
        ArcShape::Radius { radius, ccw, tol } => {
            let d = distance(from, to);
            if arc::closing(to - from) == Closing::Closed {
                return refuse(step, codes::G3003::arc_ends_where_it_starts());
            }
            let Some(center) = arc::center_by_radius(from, to, radius, ccw, SAME_POINT, tol) else {
                return refuse(step, codes::G3002::points_are_mm_apart(&d, &(2.0 * radius.abs()), &(d / 2.0)));
            };
            adjusted.note((d / 2.0 - radius.abs()).max(0.0), tol, step.origin);
            step.mv.path = ends.about(center, ccw);
        }
        ArcShape::Opening { sweep } => {
            let sweep = sweep.radians();
            let Some(center) = arc::center_by_opening(from, to, sweep, SAME_POINT) else {
                return refuse(step, codes::G3003::start_and_end_of_arc_are_same_point());
            };
            step.mv.path = ends.arc(center, sweep);
        }
        ArcShape::Via { point } => match arc::through(from, point, to, SAME_POINT) {
            Some((center, ccw)) => {
                step.mv.path = ends.about(center, ccw);
            }
            None => return refuse(step, codes::G3020::start_intermediate_point_and_end_lie()),
        },
        ArcShape::Tangent => {
            let Some(tangent) = last.tangent(plane) else {
                let fault = match last.why {
                    Why::Start => codes::G3004::no_element_with_direction_precedes(),
                    Why::Corner => codes::G3004::chamfer_or_rounding_directly_before_leaves(),
                    Why::OtherAxis => codes::G3004::element_before_moves_out_of_plane(),
                };
                return refuse(step, fault);
            };
            match arc::tangent_arc(from, tangent, to, SAME_POINT, STRAIGHT) {
                TangentArc::Arc { center, ccw } => {
                    step.mv.path = ends.about(center, ccw);
                }
                TangentArc::Nothing => step.mv.path = Path::Line(feed),
                TangentArc::Line => {
                    step.mv.path = Path::Line(feed);
                    let word = at(step.origin, codes::G3006::end_lies_straight_ahead());
                    return Ok(Extra::Word(Box::new(word)));
                }
                TangentArc::Behind => return refuse(step, codes::G3005::end_point_lies_exactly_behind_start()),
            }
        }
    }
    Ok(Extra::None)
}

fn refuse<T>(step: &Step, fault: Fault) -> Result<T, Refused> {
    Err(Some(Box::new(at(step.origin, fault))))
}

fn add_turns(step: &mut Step, turns: u32) {
    if let Path::Arc(arc, _) = &mut step.mv.path {
        let more = TAU * f64::from(turns);
        arc.sweep += if arc.sweep > 0.0 { more } else { -more };
    }
}

/// The lead along the path of a thread.
fn thread_path(thread: &contour::Thread, step: &Step) -> Result<Path, Refused> {
    let Some(axis) = thread.along else { return Ok(Path::Thread { lead: thread.lead }) };
    let way = |axis| Some(step.mv.end.get(axis)? - step.start.get(axis)?);
    let Some(along) = way(axis) else { return Err(None) };
    let length = AxisSet::MAIN.iter().filter_map(way).fold(0.0, libm::hypot);
    if along.abs() <= SAME_POINT {
        return refuse(step, codes::G3021::lead_counts_along(&axis.letter()));
    }
    Ok(Path::Thread { lead: thread.lead * length / along.abs() })
}

/// An arc about a centre from which its ends may lie `tol` mm differently far.
fn by_center(
    step: &mut Step,
    ends: &Ends,
    (center, ccw): (Point2, bool),
    tol: f64,
    adjusted: &mut Adjusted,
) -> Result<Extra, Refused> {
    let Ends { plane, from, to, feed } = *ends;
    let (r1, r2) = (distance(from, center), distance(to, center));
    if r1 <= SAME_POINT {
        return refuse(step, codes::G3014::arc_starts_in_its_centre());
    }
    if r2 <= SAME_POINT {
        return refuse(step, codes::G3014::arc_ends_in_its_centre());
    }
    match arc::closing(to - from) {
        Closing::Closed => {
            step.mv.end.set_in_plane(plane, from);
            step.mv.path = ends.arc(center, if ccw { TAU } else { -TAU });
            return Ok(Extra::None);
        }
        Closing::Unclear => {
            return refuse(step, codes::G3023::start_end_of_arc_are_mm_apart(&distance(from, to)));
        }
        Closing::Open => {}
    }
    let off = (r2 - r1).abs();
    if off > tol + 1e-9 {
        return refuse(step, codes::G3001::start_lies_mm_from_centre(&r1, &r2, &off, &tol));
    }
    let moved = arc::centered_between(from, to, center);
    let sweep = arc::sweep(from, to, moved, ccw);
    // With ends close together the line between them may lead the centre far away: the arc would shrink, or
    // start in another direction.
    let same_size = (distance(from, moved) - r1).abs() <= tol && distance(moved, center) <= MOST_TURN * r1;
    if same_size && deviation(from, moved, sweep, center, r1, r2) <= tol {
        adjusted.note(distance(moved, center), tol, step.origin);
        step.mv.path = ends.arc(moved, sweep);
        return Ok(Extra::None);
    }
    // Nearly a full circle that does not close: no single arc fits. The arc about the programmed centre is
    // followed by the rest of the way to the programmed end, which is shorter than the tolerance.
    adjusted.note(off, tol, step.origin);
    let sweep = arc::sweep(from, to, center, ccw);
    let foot = center + (to - center) * (r1 / r2);
    let mut rest = step.clone();
    step.mv.end.set_in_plane(plane, foot);
    step.mv.path = ends.arc(center, sweep);
    rest.start = step.mv.end;
    rest.mv.path = Path::Line(feed);
    rest.mv.axes = plane_axes(plane);
    Ok(Extra::Second(Box::new(rest)))
}

/// Largest distance between the arc about `moved` and the programmed one, whose radius goes from `r1` to `r2`.
fn deviation(from: Point2, moved: Point2, sweep: f64, center: Point2, r1: f64, r2: f64) -> f64 {
    if moved == center {
        return 0.0;
    }
    (1..8)
        .map(|i| {
            let t = f64::from(i) / 8.0;
            let p = moved + crate::geo::turned(from - moved, sweep * t);
            (distance(p, center) - (r1 + (r2 - r1) * t)).abs()
        })
        .fold(0.0, f64::max)
}
