//! Circles: G2, G3, CIP and CT with all their words, helices, polar arcs.
//!
//! Source: S 2.3 to 2.5 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::angle::rotated;
use crate::geo::arc::{center_by_radius, through};
use crate::geo::{Deg, Plane, Point2};
use crate::ir::contour::{Arc, ArcShape, Path};
use crate::ir::{Feed, Pos};
use crate::machine::{Axis, AxisSet};
use crate::sema::run::Where;
use crate::text::Span;

use super::diameter::Diameter;
use super::g_groups::GCode;
use super::vocabulary::Address;
use super::words::{Given, Mode, Words};
use super::{Channel, Core, Outcome, State};

/// Points closer than this are the same, in mm: half the last digit of a program.
pub(super) const SAME: f64 = 5e-5;
/// Square of the largest angle, in radians, by which the centre of a circle moves as seen from its start (MD 21000).
const MOST_TURN_SQUARED: f64 = 1e-3;
/// Most extra turns of a helix.
const MOST_TURNS: f64 = 999.0;

/// Interpolation parameters of a centre and of an intermediate point, by geometry axis.
pub(super) const CENTER: [Address; 3] = [Address::I, Address::J, Address::K];
const VIA: [Address; 3] = [Address::I1, Address::J1, Address::K1];

impl Channel<'_> {
    pub(super) fn circle_block(&mut self, w: &mut Words, ccw: bool, polar: bool) -> Outcome {
        if polar {
            return self.polar_circle(w, ccw);
        }
        let plane = circle_plane(self.st.plane(), w, &self.st.machine.parameters(CENTER));
        let feed = self.cutting_feed(w)?;
        let turns = w.turns(&self.core)?;
        let mut end = self.st.targets(&self.core, w)?;
        self.st.order_of_axes_fits(&self.core, w, plane, &end)?;
        let start = self.st.start_in(&self.core, plane, w)?;
        let named = names_plane(w, plane);
        let to = end_in(&end, plane, start);
        let span = w.arc_span();
        let center = self.st.point_of(&self.core, w, &self.st.machine.parameters(CENTER), plane, start, false)?;
        let shape = match (w.take(Address::Cr), w.take(Address::Ar), center) {
            (Some(cr), None, None) if !named => {
                return self.core.refuse(cr.span, codes::P3002::arc_by_cr_needs_end_point());
            }
            (Some(cr), None, None) => {
                arc_by_radius(&self.core, self.st.length_unit(), cr, crate::geo::distance(start, to), ccw)?
            }
            (None, Some(ar), center) => {
                let sweep = opening(&self.core, ar, ccw)?;
                match center {
                    Some(_) if named => {
                        return self.core.refuse(ar.span, codes::S3002::ar_stands_beside_both_centre());
                    }
                    Some(center) => {
                        end.set_in_plane(plane, rotated(start, center, sweep));
                        ArcShape::Sweep { center, sweep }
                    }
                    None if named => ArcShape::Opening { sweep },
                    None => return self.core.refuse(ar.span, codes::P3002::ar_needs_end_point_or_centre()),
                }
            }
            (None, None, Some(center)) => {
                end.set_in_plane(plane, to);
                if let Some(stored) = &mut self.st.stored {
                    stored.note_centre(center);
                }
                let center = self.core.checked_center(start, to, center, ccw, span)?;
                let radius = crate::geo::distance(start, center);
                ArcShape::Center { center, ccw, tol: self.core.circle_tolerance(radius) }
            }
            (None, None, None) => {
                return self.core.refuse(span, codes::P3002::arc_has_neither_centre_nor_so_give_i());
            }
            _ => {
                return self.core.refuse(span, codes::S3002::centre_cr());
            }
        };
        if !matches!(shape, ArcShape::Sweep { .. }) {
            end.set_in_plane(plane, to);
        }
        self.send_arc(&end, Arc { plane, shape, turns }, feed, span)
    }

    pub(super) fn send_arc(&mut self, end: &Pos, arc: Arc, feed: Feed, place: impl Into<Where>) -> Outcome {
        let place = place.into();
        if let Some(third) =
            AxisSet::MAIN.iter().find(|axis| end.get(*axis).is_some() && self.st.position.get(*axis).is_none())
        {
            return self.st.unknown_axis(&self.core, third, place);
        }
        self.pair_must_be_done(place)?;
        self.send(end, Path::Arc(arc, feed));
        Ok(())
    }

    /// G2 or G3 with AP and RP: the pole is the centre.
    fn polar_circle(&mut self, w: &mut Words, ccw: bool) -> Outcome {
        for address in [Address::I, Address::J, Address::K, Address::Cr, Address::Ar] {
            if let Some(given) = w.get(address) {
                return self.core.refuse(given.span, codes::S3002::polar_arc_has_pole_as_its_centre());
            }
        }
        let plane = self.st.plane();
        let feed = self.cutting_feed(w)?;
        let turns = w.turns(&self.core)?;
        self.st.start_in(&self.core, plane, w)?;
        let span = w.get(Address::Ap).or(w.get(Address::Rp)).map(|given| given.span).unwrap_or_default();
        let end = self.st.polar_end(&mut self.core, w)?;
        let center = self.st.polar.pole();
        let radius = self.st.polar.radius().unwrap_or(0.0);
        let shape = ArcShape::Center { center, ccw, tol: self.core.circle_tolerance(radius) };
        self.send_arc(&end, Arc { plane, shape, turns }, feed, span)
    }

    /// CIP
    pub(super) fn via_block(&mut self, w: &mut Words) -> Outcome {
        let plane = self.st.via_plane(&self.core, w)?;
        let feed = self.cutting_feed(w)?;
        let turns = w.turns(&self.core)?;
        let start = self.st.start_in(&self.core, plane, w)?;
        let span = VIA.into_iter().filter_map(|a| w.get(a)).map(|g| g.span).reduce(Span::to).unwrap_or_default();
        let (_, _, third) = plane.axes();
        let third = Axis::ALL[third];
        // An intermediate point outside the plane: the circle stands obliquely in space.
        if let Some((address, axis)) =
            self.st.machine.parameters(VIA).iter().find(|(address, axis)| *axis == third && w.get(*address).is_some())
        {
            let given = w.get(*address).unwrap_or_default();
            let at = self.st.target(&self.core, *axis, Given { mode: given.mode, ..given })?;
            let level = |pos: Option<f64>| pos.is_none_or(|v| (v - at).abs() < 1e-9);
            let end_level = w.axis(*axis);
            let end = match end_level {
                Some(given) => Some(self.st.target(&self.core, *axis, given)?),
                None => None,
            };
            if !level(self.st.position.get(*axis)) || !level(end) {
                return self.core.refuse(given.span, codes::S9013::circle_stands_obliquely_in_space());
            }
            w.take(*address);
        }
        says_via_in_diameters(&self.core, &self.st, w);
        let mut end = self.st.targets(&self.core, w)?;
        let to = end_in(&end, plane, start);
        let Some(point) = self.st.point_of(&self.core, w, &self.st.machine.parameters(VIA), plane, start, true)? else {
            return self.core.refuse(
                w.axes.iter().next().and_then(|axis| w.axis(axis)).map(|g| g.span).unwrap_or_default(),
                codes::S3006::cip_needs_intermediate_point(),
            );
        };
        end.set_in_plane(plane, to);
        if through(start, point, to, SAME).is_none() {
            let (a, b) = (point - start, to - start);
            let between = a.dot(&b) > 0.0 && crate::geo::length(a) < crate::geo::length(b);
            if between && turns == 0 {
                self.send(&end, Path::Line(feed));
                return Ok(());
            }
            return self.core.refuse(span, codes::S3006::start_intermediate_point());
        }
        self.send_arc(&end, Arc { plane, shape: ArcShape::Via { point }, turns }, feed, span)
    }
}

impl Words {
    pub(super) fn arc_span(&self) -> Span {
        let words = CENTER.into_iter().chain([Address::Cr, Address::Ar]);
        words.filter_map(|address| self.get(address)).map(|given| given.span).reduce(Span::to).unwrap_or_default()
    }

    pub(super) fn turns(&mut self, core: &Core<'_>) -> Outcome<u32> {
        let Some(turn) = self.take(Address::Turn) else { return Ok(0) };
        if turn.value.fract() != 0.0 || !(0.0..=MOST_TURNS).contains(&turn.value) {
            return core.refuse(turn.span, codes::S3005::turn_is_no_number_of_turns(&turn.value));
        }
        Ok(turn.value as u32)
    }
}

impl State {
    fn point_of(
        &self,
        core: &Core<'_>,
        w: &mut Words,
        names: &[(Address, Axis); 3],
        plane: Plane,
        start: Point2,
        follows_g90: bool,
    ) -> Outcome<Option<Point2>> {
        let (first, second, _) = plane.axes();
        let mut point = start;
        let mut any = false;
        for (address, axis) in names {
            let Some(given) = w.get(*address) else { continue };
            let place = match axis.index() {
                i if i == first => &mut point.x,
                i if i == second => &mut point.y,
                _ => {
                    return core.refuse(given.span, codes::P1003::this_word_counts_along(&axis.letter()));
                }
            };
            w.take(*address);
            any = true;
            let absolute = match given.mode {
                Mode::Plain => follows_g90 && !self.is(GCode::G91),
                Mode::Ac => true,
                Mode::Ic => false,
                _ => {
                    return core.refuse(given.span, codes::P1003::only_ac_ic());
                }
            };
            if absolute {
                *place = self.length(core, *axis, Given { mode: Mode::Ac, ..given }, false)?;
            } else if follows_g90 {
                *place += self.length(core, *axis, Given { mode: Mode::Ic, ..given }, true)?;
            } else {
                // The way to a centre is a radius whatever DIAMON says.
                *place += given.value * self.length_unit();
            }
        }
        Ok(any.then_some(point))
    }

    /// The plane of a circle through a point: the one in which all that is given lies.
    fn via_plane(&mut self, core: &Core<'_>, w: &Words) -> Outcome<Plane> {
        let usual = circle_plane(self.plane(), w, &self.machine.parameters(VIA));
        let [_, _, third] = [usual.axes().0, usual.axes().1, usual.axes().2].map(|i| Axis::ALL[i]);
        let level = |st: &mut Self, axis: Axis| -> Outcome<bool> {
            let Some(at) = st.position.get(axis) else { return Ok(false) };
            let via = st
                .machine
                .parameters(VIA)
                .into_iter()
                .find(|(_, of)| *of == axis)
                .and_then(|(address, _)| w.get(address));
            for given in [w.axis(axis), via].into_iter().flatten() {
                if (st.target(core, axis, given)? - at).abs() > 1e-9 {
                    return Ok(false);
                }
            }
            Ok(true)
        };
        if level(self, third)? {
            return Ok(usual);
        }
        for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
            let (_, _, other) = plane.axes();
            let via = self
                .machine
                .parameters(VIA)
                .iter()
                .find(|(_, of)| *of == Axis::ALL[other])
                .and_then(|(address, _)| w.get(*address));
            if via.is_some() && level(self, Axis::ALL[other])? {
                return Ok(plane);
            }
        }
        Ok(usual)
    }

    /// Where the arc starts.
    pub(super) fn start_in(&self, core: &Core<'_>, plane: Plane, w: &Words) -> Outcome<Point2> {
        let span = w.axes.iter().next().and_then(|axis| w.axis(axis)).map(|given| given.span).unwrap_or_default();
        self.stands_in(core, plane, span)
    }
}

impl Core<'_> {
    /// A centre from which start and end are equally far within the tolerance; moved so that the radius at the
    /// start holds for both.
    fn checked_center(&self, start: Point2, to: Point2, center: Point2, ccw: bool, span: Span) -> Outcome<Point2> {
        let (r1, r2) = (crate::geo::distance(start, center), crate::geo::distance(to, center));
        let off = (r2 - r1).abs();
        if r1 <= SAME || r2 <= SAME {
            let starts = r1 <= SAME;
            let fault =
                if starts { codes::P3002::arc_starts_in_its_centre() } else { codes::P3002::arc_ends_in_its_centre() };
            return self.refuse(span, fault);
        }
        if off > self.circle_tolerance(r1) + 1e-9 {
            return self.refuse(
                span,
                codes::P3001::start_lies_mm_from_centre_end(&r1, &r2).answer(Answer::key("control", "md21000")),
            );
        }
        match fitting_center(start, to, center, ccw, (r1, off)) {
            Some(point) => {
                self.warn_of_moved_centre(crate::geo::distance(point, center), self.circle_tolerance(r1), span);
                Ok(point)
            }
            None => self.refuse(span, codes::P3001::start_lies_mm_from_centre(&r1, &r2)),
        }
    }

    /// The same where there is nothing to say of it.
    #[inline]
    pub(super) fn quiet_center(&self, start: Point2, to: Point2, center: Point2, ccw: bool) -> Option<Point2> {
        let (r1, r2) = (crate::geo::distance(start, center), crate::geo::distance(to, center));
        let (off, tolerance) = ((r2 - r1).abs(), self.circle_tolerance(r1));
        if r1 <= SAME || r2 <= SAME || off > tolerance + 1e-9 {
            return None;
        }
        let point = fitting_center(start, to, center, ccw, (r1, off))?;
        (!is_moved_far(crate::geo::distance(point, center), tolerance)).then_some(point)
    }

    /// A centre that has to move much for a small difference of the radii makes another arc.
    fn warn_of_moved_centre(&self, moved: f64, tolerance: f64, span: Span) {
        if is_moved_far(moved, tolerance) {
            let found = codes::G8101::centre_is_moved_by_mm(&moved).at(self.loc(span));
            self.report_once(found.help("program the end point and the centre with more decimals, or the arc by CR="));
        }
    }

    /// Largest difference of the radii at start and end (MD 21000, MD 21010).
    pub(super) fn circle_tolerance(&self, radius: f64) -> f64 {
        let control = &self.job.settings.control;
        control.sinumerik.circle_error.max(control.sinumerik.circle_error_factor * radius.abs())
    }
}

fn names_plane(w: &Words, plane: Plane) -> bool {
    let (first, second, _) = plane.axes();
    w.axes.contains(Axis::ALL[first]) || w.axes.contains(Axis::ALL[second])
}

/// The end in the plane; coordinates that are not named stay.
pub(super) fn end_in(end: &Pos, plane: Plane, start: Point2) -> Point2 {
    let (first, second, _) = plane.axes();
    Point2::new(end.get(Axis::ALL[first]).unwrap_or(start.x), end.get(Axis::ALL[second]).unwrap_or(start.y))
}

fn opening(core: &Core<'_>, ar: Given, ccw: bool) -> Outcome<Deg> {
    if !(0.0001..=359.9999).contains(&ar.value) {
        return core.refuse(ar.span, codes::S3004::ar_lies_outside_0_0001_to_359(&ar.value));
    }
    Ok(Deg(if ccw { ar.value } else { -ar.value }))
}

/// The plane of a circle: the working plane, or the one of two axes that are not both in it.
fn circle_plane(plane: Plane, w: &Words, names: &[(Address, Axis); 3]) -> Plane {
    let mut geometry = w.axes.common(AxisSet::MAIN).iter();
    let (Some(a), Some(b), None) = (geometry.next(), geometry.next(), geometry.next()) else { return plane };
    let has = |plane: Plane, axis: Axis| {
        let (first, second, _) = plane.axes();
        axis.index() == first || axis.index() == second
    };
    if has(plane, a) && has(plane, b) {
        return plane;
    }
    let other = [Plane::Xy, Plane::Zx, Plane::Yz].into_iter().find(|p| has(*p, a) && has(*p, b));
    let Some(other) = other else { return plane };
    // Parameters of the working plane mean a helix whose one end coordinate stays.
    let fits = names.iter().all(|(address, axis)| w.get(*address).is_none() || has(other, *axis));
    let helix = w.get(Address::Turn).is_some();
    if fits && !helix && w.get(Address::Ar).is_none() { other } else { plane }
}

/// CR: a radius, below 0 for the longer way around.
fn arc_by_radius(core: &Core<'_>, unit: f64, cr: Given, chord: f64, ccw: bool) -> Outcome<ArcShape> {
    let radius = cr.value * unit;
    if chord <= SAME {
        return core.refuse(cr.span, codes::P3002::arc_by_cr_ends_where_it_starts());
    }
    let tol = core.circle_tolerance(radius);
    if radius == 0.0 || chord > 2.0 * radius.abs() + tol {
        let needed = chord / 2.0 / unit;
        let fault = codes::S3001::points_are_mm_apart(&chord, &cr.value, &(2.0 * radius.abs()), &needed);
        return core.refuse(cr.span, fault);
    }
    Ok(ArcShape::Radius { radius, ccw, tol })
}

/// The manuals list the quantities that are diameters, and this one is not among them.
fn says_via_in_diameters(core: &Core<'_>, st: &State, w: &Words) {
    if st.diameter_mode() == Diameter::Off {
        return;
    }
    let across = st.machine.parameters(VIA).into_iter().find(|(_, axis)| core.is_diameter_axis(*axis));
    let given = across.and_then(|(address, _)| w.get(address));
    if let Some(given) = given.filter(|given| !matches!(given.mode, Mode::Dac | Mode::Dic | Mode::Rac | Mode::Ric))
        && core.job.diags.first_time(codes::S8048, ())
    {
        let found = codes::S8048::intermediate_point_of_cip_is_read().at(core.loc(given.span));
        core.report(found.help("program DIAMOF for the circle if a radius is meant"));
    }
}

/// The centre near `center` from which both ends are as far as the start, or `center` itself where they are; `radius` is that
/// at the start, and how much that at the end is off. `None` where there is none near it.
fn fitting_center(start: Point2, to: Point2, center: Point2, ccw: bool, radius: (f64, f64)) -> Option<Point2> {
    let (radius, off) = radius;
    if off <= 1e-9 || crate::geo::distance(start, to) <= SAME {
        return Some(center);
    }
    let solutions = [radius, -radius].map(|radius| center_by_radius(start, to, radius, ccw, SAME, 0.0));
    let near = |point: &Point2| crate::geo::distance(*point, center);
    // A chord longer than twice the radius at the start is a diameter.
    let middle = Point2::from((start.coords + to.coords) / 2.0);
    let best = solutions.into_iter().flatten().min_by(|a, b| near(a).total_cmp(&near(b))).or(Some(middle));
    let seen = |point: Point2| libm::atan2(point.y - start.y, point.x - start.x);
    let turn = |point: &Point2| {
        let turn = (seen(*point) - seen(center)).abs();
        turn.min(core::f64::consts::TAU - turn)
    };
    best.filter(|point| turn(point) < libm::sqrt(MOST_TURN_SQUARED))
}

fn is_moved_far(moved: f64, tolerance: f64) -> bool {
    moved > 10.0 * tolerance
}
