//! From the plane that a program sees to the axes that the machine has: a face or mantle whose workpiece a rotary axis turns.
//!
//! It stands behind the compensation, so that a contour is compensated where it is plane. A way on a face is divided
//! evenly, into so few parts that the way of X and the rotary axis stays within [`TOLERANCE`] of it; the ends of the parts
//! lie on it. Each part knows the length of the contour that it makes, from which the printer has its feed.

mod way;

use crate::geo::tolerance;
use core::f64::consts::TAU;

use crate::diag::{Answer, Diagnostic, Fault, codes};
use crate::geo::{Plane, Point2, distance, turned};
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::transformation::Surface;
use crate::ir::{Ask, Feed, Origin, Pos, Side, Transformation};
use crate::machine::{Axis, AxisSet};

use super::at;
use way::Way;

/// How far the way of the machine may leave the programmed one, in mm.
pub const TOLERANCE: f64 = 0.005;
/// Closest that a way may pass the axis of rotation, in mm.
pub const POLE: f64 = 0.01;
/// Most parts of one way.
const MOST_PARTS: u32 = 100_000;

/// Where a part of a way goes.
type Send<'a> = dyn FnMut(&Move) + 'a;

/// A transformation that is on.
#[derive(Debug)]
pub struct Transformer {
    by: Transformation,
    /// Where the tool stands as the program sees it.
    at: Pos,
    /// Where the rotary axis stands, in degrees.
    angle: Option<f64>,
    /// Whole turns between the mantle and the rotary axis, in degrees, once a move has said them.
    turns: Option<f64>,
    /// The position was lost by an error, which was reported.
    quiet: bool,
    /// Parts that were made.
    pub parts: u64,
}

impl Transformer {
    /// Begins where the machine stands at `real`.
    pub fn new(by: Transformation, real: &Pos) -> Transformer {
        let (at, angle) = (by.seen(real), real.get(by.rotary));
        // Where the program sees Y the mantle lies as the control counts the axis; otherwise the first move says how.
        let turns = at.get(Axis::Y).and_then(|_| Some(angle? - by.starts?));
        Transformer { by, at, angle, turns, quiet: false, parts: 0 }
    }

    pub fn rotary(&self) -> Axis {
        self.by.rotary
    }

    /// Where the program sees the tool.
    pub fn seen(&self) -> Pos {
        self.at
    }

    /// Where the machine stands at the end.
    pub fn left(&self) -> Pos {
        let mut real = self.by.left(&self.at);
        if let Some(angle) = self.angle {
            real.set(self.by.rotary, angle);
        }
        real
    }

    pub fn lost(&mut self) {
        self.at.clear();
        (self.angle, self.turns, self.quiet) = (None, None, true);
    }

    /// The tip of the tool is another one, or the system of the axes.
    pub fn displaced(&mut self, system: bool) {
        self.at.clear();
        if system {
            (self.angle, self.turns) = (None, None);
        }
    }

    /// Sends what the machine does for `mv`.
    ///
    /// # Errors
    /// G3337, G3338, G3339.
    pub fn carry(&mut self, mv: &Move, origin: &Origin, out: &mut Send<'_>) -> Result<(), Box<Diagnostic>> {
        self.admit(mv, origin)?;
        if mv.machine {
            out(mv);
            mv.axes.iter().for_each(|axis| self.at.forget(axis));
            return Ok(());
        }
        match self.by.surface {
            Surface::Face => self.face(mv, origin, out)?,
            Surface::Mantle { diameter } => self.mantle(diameter, mv, origin, out)?,
        }
        self.at.update(&mv.end);
        self.quiet = false;
        Ok(())
    }

    /// What no axis of the machine can do while it makes another one.
    fn admit(&self, mv: &Move, origin: &Origin) -> Result<(), Box<Diagnostic>> {
        let rotary = self.by.rotary;
        let made = [Axis::X, Axis::Y, rotary];
        let fault = if mv.axes.contains(rotary) {
            codes::G3339::is_moved_by_transformation_and_block(&rotary.letter())
        } else if mv.machine && mv.axes.iter().any(|axis| made.contains(&axis)) {
            codes::G3339::place_of_machine_is_approached()
        } else if mv.side != Side::None {
            let resolve = Answer::key("output", "compensation").one_of(&["\"resolve\""]);
            codes::G3339::target_cannot_compensate_tool().answer(resolve)
        } else if matches!(mv.path, Path::Thread { .. }) {
            codes::G3339::thread_in_step_with_spindle()
        } else if let Some(Feed::PerRevolution(_)) = mv.path.feed() {
            codes::G3339::feed_counts_turns_of_first_spindle()
        } else {
            return Ok(());
        };
        refuse(origin, fault)
    }

    // The face.

    fn face(&mut self, mv: &Move, origin: &Origin, out: &mut Send<'_>) -> Result<(), Box<Diagnostic>> {
        let plane: AxisSet = [Axis::X, Axis::Y].into_iter().collect();
        let from = self.at.in_plane(Plane::Xy);
        let to = mv.end.in_plane(Plane::Xy);
        let straight = !matches!(mv.path, Path::Arc(..));
        let rests = straight && from.zip(to).is_some_and(|(from, to)| distance(from, to) <= tolerance::LOST);
        if mv.axes.common(plane).is_empty() || rests {
            let axes = mv.axes.without(plane);
            if !axes.is_empty() {
                out(&Move { end: self.by.left(&mv.end), axes, ..*mv });
            }
            return Ok(());
        }
        let Some(to) = to else { return refuse(origin, codes::G3338::where_this_block_leads_depends()) };
        if !mv.axes.without(AxisSet::MAIN).is_empty() {
            return refuse(origin, codes::G3339::another_axis_moves_together(&"X and Y"));
        }
        let started = from.filter(|_| mv.axes.iter().all(|axis| self.at.get(axis).is_some())).zip(self.angle);
        let Some((_, angle)) = started else {
            return match mv.path {
                Path::Rapid => self.arrive(mv, to, origin, out),
                Path::Line(_) | Path::Arc(..) | Path::Carried { .. } | Path::Thread { .. } => {
                    refuse(origin, codes::G3338::this_block_cuts_from_place_not_known())
                }
            };
        };
        let way = Way::new(&self.at, mv);
        if let Path::Arc(arc, _) = &mv.path
            && arc.plane == Plane::Xy
            && distance(arc.center, Point2::origin()) <= tolerance::LOST
        {
            pole_is_far(distance(arc.from, arc.center), self.by.at_pole, origin)?;
            return self.send_part(mv, &way, 1, 1, angle + arc.sweep.to_degrees(), out);
        }
        pole_is_far(way.closest(), self.by.at_pole, origin)?;
        let Some(parts) = way.parts(TOLERANCE, MOST_PARTS) else {
            return refuse(origin, codes::G3339::this_way_takes_more_parts(&MOST_PARTS));
        };
        let mut angle = angle;
        for part in 1..=parts {
            let p = way.in_face(f64::from(part) / f64::from(parts));
            angle = nearest(libm::atan2(p.y, p.x).to_degrees(), angle);
            self.send_part(mv, &way, part, parts, angle, out)?;
        }
        Ok(())
    }

    /// The first rapid move, from a place that is not known.
    fn arrive(&mut self, mv: &Move, to: Point2, origin: &Origin, out: &mut Send<'_>) -> Result<(), Box<Diagnostic>> {
        let radius = distance(to, Point2::origin());
        pole_is_far(radius, self.by.at_pole, origin)?;
        let angle = libm::atan2(to.y, to.x).to_degrees();
        let angle = self.angle.map_or(angle, |before| nearest(angle, before));
        let mut end = self.by.left(&mv.end);
        end.set(self.by.rotary, angle);
        out(&Move { end, axes: self.real_axes(mv), ..*mv });
        self.angle = Some(angle);
        Ok(())
    }

    fn real_axes(&self, mv: &Move) -> AxisSet {
        let mut axes = mv.axes.without(AxisSet::of(Axis::Y));
        axes.insert(Axis::X);
        axes.insert(self.by.rotary);
        axes
    }

    /// Part `part` of `parts` of a way on the face.
    fn send_part(
        &mut self,
        mv: &Move,
        way: &Way<'_>,
        part: u32,
        parts: u32,
        angle: f64,
        out: &mut Send<'_>,
    ) -> Result<(), Box<Diagnostic>> {
        let (share, count) = (f64::from(part) / f64::from(parts), f64::from(parts));
        let mut seen = mv.end;
        for (axis, value) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(way.place(share)) {
            if seen.get(axis).is_some() {
                seen.set(axis, value);
            }
        }
        let mut end = self.by.left(&seen);
        end.set(self.by.rotary, angle);
        let path = part_of(&mv.path, way.length() / count, count);
        out(&Move { end, axes: self.real_axes(mv), path, ..*mv });
        self.angle = Some(angle);
        self.parts += 1;
        Ok(())
    }

    // The mantle.

    fn mantle(&mut self, diameter: f64, mv: &Move, origin: &Origin, out: &mut Send<'_>) -> Result<(), Box<Diagnostic>> {
        let arc = match &mv.path {
            Path::Arc(arc, _) => Some(arc),
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => None,
        };
        if !mv.axes.contains(Axis::Y) {
            out(&Move { end: self.by.left(&mv.end), ..*mv });
            return Ok(());
        }
        if !mv.axes.without(AxisSet::MAIN).is_empty() {
            return refuse(origin, codes::G3339::another_axis_moves_together(&"Y"));
        }
        let cuts = !matches!(mv.path, Path::Rapid);
        if cuts && mv.axes.iter().any(|axis| self.at.get(axis).is_none()) {
            return refuse(origin, codes::G3338::this_block_cuts_from_place_not_known());
        }
        let way = Way::new(&self.at, mv);
        // In the plane of the unrolled mantle the axes go straight: a line is one part, an arc has its chords.
        let parts = arc.map_or(1, chords);
        for part in 1..=parts {
            let (share, count) = (f64::from(part) / f64::from(parts), f64::from(parts));
            let mut seen = mv.end;
            if cuts {
                for (axis, value) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(way.place(share)) {
                    if seen.get(axis).is_some() {
                        seen.set(axis, value);
                    }
                }
            }
            let angle = self.mantle_angle(diameter, seen.get(Axis::Y).unwrap_or(0.0));
            let mut end = self.by.left(&seen);
            end.set(self.by.rotary, angle);
            let mut axes = mv.axes.without(AxisSet::of(Axis::Y));
            axes.insert(self.by.rotary);
            let path = part_of(&mv.path, way.length() / count, count);
            out(&Move { end, axes, path, ..*mv });
            self.angle = Some(angle);
            self.parts += 1;
        }
        Ok(())
    }

    /// Where the rotary axis stands for a place of the circumference.
    fn mantle_angle(&mut self, diameter: f64, y: f64) -> f64 {
        let angle = y * Transformation::degrees_per_mm(diameter);
        let before = self.angle;
        angle + *self.turns.get_or_insert_with(|| before.map_or(0.0, |before| nearest(angle, before) - angle))
    }
}

/// The path of one of `count` even parts of a way, of which each is `length` mm long.
fn part_of(path: &Path, length: f64, count: f64) -> Path {
    match path.feed() {
        Some(Feed::PerMinute(feed)) if length > 0.0 => Path::Carried { feed, length },
        Some(Feed::InverseTime(time)) => Path::Line(Feed::InverseTime(time * count)),
        Some(feed) => Path::Line(feed),
        None => Path::Rapid,
    }
}

/// Chords of an arc that stay within the tolerance: each leaves it by `r · (1 - cos(a/2))`.
fn chords(arc: &Arc) -> u32 {
    let radius = distance(arc.from, arc.center);
    let step = 2.0 * libm::acos((1.0 - TOLERANCE / radius).max(0.0));
    libm::ceil(arc.sweep.abs() / step - 1e-9).clamp(1.0, f64::from(MOST_PARTS)) as u32
}

/// `angle` in the turn that is nearest to `before`, all in degrees.
fn nearest(angle: f64, before: f64) -> f64 {
    angle + 360.0 * libm::round((before - angle) / 360.0)
}

fn pole_is_far(closest: f64, ask: &Ask, origin: &Origin) -> Result<(), Box<Diagnostic>> {
    if closest >= POLE {
        return Ok(());
    }
    refuse(origin, codes::G3337::way_passes_axis_of_rotation(&closest).help(ask.help()))
}

fn refuse(origin: &Origin, fault: Fault) -> Result<(), Box<Diagnostic>> {
    Err(Box::new(at(*origin, fault)))
}

/// A point that `arc` reaches at a share of its sweep.
fn on_arc(arc: &Arc, share: f64) -> Point2 {
    arc.center + turned(arc.from - arc.center, arc.sweep * share)
}

/// Does an arc pass the direction of `v` from its centre?
fn passes(arc: &Arc, v: crate::geo::Vec2) -> bool {
    let from = arc.from - arc.center;
    let way = libm::atan2(from.x * v.y - from.y * v.x, from.x * v.x + from.y * v.y);
    let way = if arc.sweep > 0.0 { way } else { -way };
    let way = if way < 0.0 { way + TAU } else { way };
    way <= arc.sweep.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest way between an arc and one of `count` chords.
    fn sagitta(arc: &Arc, count: u32) -> f64 {
        let radius = distance(arc.from, arc.center);
        radius * (1.0 - libm::cos(arc.sweep / f64::from(count) / 2.0))
    }

    #[test]
    fn as_few_chords_as_stay_within_the_tolerance() {
        for (radius, degrees, count) in
            [(40.0, 90.0, 50), (40.0, -90.0, 50), (10.0, 360.0, 100), (2.0, 5.0, 1), (0.004, 300.0, 2)]
        {
            let arc = Arc {
                plane: Plane::Xy,
                from: Point2::new(radius + 7.0, -3.0),
                center: Point2::new(7.0, -3.0),
                sweep: f64::to_radians(degrees),
            };
            assert_eq!(chords(&arc), count, "radius {radius}, {degrees} degrees");
            if radius > TOLERANCE {
                assert!(sagitta(&arc, count) <= TOLERANCE + 1e-9, "radius {radius}");
                assert!(count == 1 || sagitta(&arc, count - 1) > TOLERANCE, "radius {radius}");
            }
        }
    }

    #[test]
    fn an_arc_passes_the_directions_between_its_ends() {
        let direction = |degrees: f64| turned(crate::geo::Vec2::new(3.0, 0.0), f64::to_radians(degrees));
        for (start, sweep) in [(20.0, 200.0), (20.0, -100.0), (-170.0, 60.0), (95.0, -300.0)] {
            let center = Point2::new(7.0, -3.0);
            let arc = Arc { plane: Plane::Xy, from: center + direction(start), center, sweep: f64::to_radians(sweep) };
            for at in 0..36 {
                let degrees = 10.0 * f64::from(at) + 4.0;
                let way = (if sweep > 0.0 { degrees - start } else { start - degrees }).rem_euclid(360.0);
                assert_eq!(passes(&arc, direction(degrees)), way <= sweep.abs(), "{start} {sweep} {degrees}");
            }
        }
    }
}
