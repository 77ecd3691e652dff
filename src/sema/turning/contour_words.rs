//! A contour in the words of the G80 that closes a cycle, as smart.Turn units with direct contour input write it.
//!
//! A recess has a floor and two walls, a roughed contour two elements. Source: T 8.11 and 12 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2, SAME_DIRECTION, Vec2, direction, intersect};
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};
use crate::text::Loc;

use super::chain::{AGREES, Coord, Data};
use super::element_data::{Transition, transition_of};
use super::outline::{Builder, Flaw, Mark, Outline};
use super::readings::Question;
use super::state::State;
use super::words::Words;
use super::{Core, Outcome};

/// Angles lie below this, degrees.
const UPRIGHT: f64 = 90.0;

/// The words, in mm and with X as a radius. Axes are those of a longitudinal contour or a radial recess: `a` along
/// the cuts, `h` the height; other contours have them swapped.
struct Form {
    start: Vec2,
    end: Vec2,
    /// Tangents of the angles at start and end.
    lean: (f64, f64),
    corner: Transition,
    rims: (Transition, Transition),
}

impl Core<'_> {
    /// The contour that G80 describes for the cycle `number`; `None` where it has no words.
    pub(super) fn contour_words(&self, w: &Words, number: u16, st: &State) -> Outcome<Option<Outline>> {
        let Some((addr, num)) = w.longs().first() else { return Ok(None) };
        let settings = self.job.settings;
        let swapped = match number {
            810 => false,
            820 => true,
            869 => !self.accept(Where::Block, st.recess_tool(settings))?.1,
            _ => return self.refuse(num.span, codes::T9007::contour_in_words_of_g80_is_not(&addr, &number)),
        };
        if settings.control.turning.refuse_contour_words == Some(true) {
            return self.refuse(
                num.span,
                codes::T9007::no_manual_at_hand_lists_words(&addr).answer(Answer::key("control", "contour_words")),
            );
        }
        self.depends_on(Question::ContourWords, num.span);
        let form = self.made(Form::of(w, swapped, st.mm()))?;
        let points = if number == 869 { form.recess() } else { form.step() };
        let no_room = codes::T3002::angles_leave_no_room_between_start;
        let points = self.accept(Where::Block, points.ok_or_else(no_room))?;
        self.flawless(outline_of(&points, swapped, self.here.origin.loc)).map(Some)
    }
}

/// The outline through the points, without its first and last element.
fn outline_of(points: &[(Vec2, Transition)], swapped: bool, loc: Loc) -> Result<Outline, Flaw> {
    let place = |v: Vec2| if swapped { Point2::new(v.y, v.x) } else { Point2::new(v.x, v.y) };
    let mut builder = Builder::default();
    for (i, (to, transition)) in points.iter().enumerate() {
        let to = place(*to);
        if i == 0 {
            builder.start(to);
            continue;
        }
        let data = Data { x: Coord::At(to.x), y: Coord::At(to.y), tolerance: AGREES, ..Data::default() };
        builder.push(data, Mark { number: None, loc, transition: *transition, far: false, arc_tolerance: AGREES })?;
    }
    builder.settle()?;
    let mut outline = builder.outline(0)?;
    outline.edges.pop();
    if !outline.edges.is_empty() {
        outline.edges.remove(0);
    }
    Ok(outline)
}

impl Form {
    fn of(w: &Words, swapped: bool, mm: f64) -> Made<Form> {
        for name in ["EC", "IC", "KC", "HC"] {
            if let Some(num) = w.long(name).filter(|num| num.value != 0.0) {
                return refused(num.span, codes::T9007::in_contour_of_g80_is_not_supported(&name));
            }
        }
        let needed = |name: &str| match w.long(name) {
            Some(num) => Ok(num.value * mm),
            None => refused(Where::Block, codes::P1004::is_missing_contour_has_no_start(&name)),
        };
        let point = |x: f64, z: f64| if swapped { Vec2::new(x / 2.0, z) } else { Vec2::new(z, x / 2.0) };
        let lean = |name: &str| match w.long(name) {
            None => Ok(0.0),
            Some(num) if (0.0..UPRIGHT).contains(&num.value) => {
                let (sin, cos) = Deg(num.value).sin_cos();
                Ok(sin / cos)
            }
            Some(num) => refused(num.span, codes::T1007::lies_between_0(&name)),
        };
        let rim = |name: &str| w.long(name).map_or(Transition::Sharp, |num| transition_of(num.value * mm));
        if let Some(num) = w.long("RC").filter(|num| num.value < 0.0) {
            return refused(num.span, codes::T1007::rc_is_radius());
        }
        Ok(Form {
            start: point(needed("XS")?, needed("ZS")?),
            end: point(needed("XE")?, needed("ZE")?),
            lean: (lean("AC")?, lean("WC")?),
            corner: rim("RC"),
            rims: (rim("BS"), rim("BE")),
        })
    }

    /// Points of a recess from the surface in front of it to the one behind it, each with the transition there.
    fn recess(&self) -> Option<Vec<(Vec2, Transition)>> {
        let way = self.end - self.start;
        let (along, depth) = (way.x.signum(), way.y.abs());
        let (top, floor) = (self.start.y, self.end.y);
        let foot = self.start.x + along * depth * self.lean.0;
        let last_foot = self.end.x - along * depth * self.lean.1;
        let far = Vec2::new(self.end.x, top);
        ((last_foot - foot) * along > 0.0 && depth > 0.0).then(|| {
            vec![
                (self.start - Vec2::new(along * room(self.rims.0), 0.0), Transition::Sharp),
                (self.start, self.rims.0),
                (Vec2::new(foot, floor), self.corner),
                (Vec2::new(last_foot, floor), self.corner),
                (far, self.rims.1),
                (far + Vec2::new(along * room(self.rims.1), 0.0), Transition::Sharp),
            ]
        })
    }

    /// Points of two elements and of those beside them: up to the start across, on behind the end along.
    fn step(&self) -> Option<Vec<(Vec2, Transition)>> {
        let way = self.end - self.start;
        let (along, up) = (way.x.signum(), way.y.signum());
        let first = direction(Vec2::new(along, up * self.lean.0), 0.0)?;
        let second = direction(Vec2::new(along * self.lean.1, up), 0.0)?;
        let (start, end) = (Point2::from(self.start), Point2::from(self.end));
        let (s, t) = intersect::lines(start, first, end, -second, SAME_DIRECTION)?;
        (s > 0.0 && t > 0.0).then(|| {
            vec![
                (self.start - Vec2::new(0.0, up * room(self.rims.0)), Transition::Sharp),
                (self.start, self.rims.0),
                (self.start + first * s, self.corner),
                (self.end, self.rims.1),
                (self.end + Vec2::new(along * room(self.rims.1), 0.0), Transition::Sharp),
            ]
        })
    }
}

/// Length of an element beside a rim: enough for its chamfer or rounding.
fn room(rim: Transition) -> f64 {
    match rim {
        Transition::Open | Transition::Sharp => 1.0,
        Transition::Rounding(size) | Transition::Chamfer(size) => 1.0 + 2.0 * size,
    }
}
