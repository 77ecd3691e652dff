//! From words to an element with the data it was programmed with.

use crate::diag::codes;
use crate::geo::Deg;
use crate::machine::{ArcChoice, Axis};
use crate::sema::run::refusal::{Made, refused};

use super::chain::{AGREES, Angles, Center, Coord, Data};
use super::program_parts::Family;
use super::readings::Question;
use super::words::{Measure, Num, Words};
use super::{Core, Outcome};

/// Largest radius a control takes, in mm.
const LARGEST_RADIUS: f64 = 200_000.0;

/// How an element goes over into the next.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Transition {
    /// B is missing: tangential where the data leaves it open, else whatever the data says.
    #[default]
    Open,
    /// B0
    Sharp,
    /// mm
    Rounding(f64),
    /// mm cut off each element.
    Chamfer(f64),
}

/// What B and Q of an element say.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Follows {
    pub transition: Transition,
    /// Of two solutions the one that lies further from the start.
    pub far: bool,
}

impl Core<'_> {
    /// The element that the words of a block describe; `arc`: counter-clockwise, and whether its centre is absolute.
    pub(super) fn element_of(
        &self,
        w: &Words,
        arc: Option<(bool, bool)>,
        measure: Measure,
    ) -> Outcome<(Data, Follows)> {
        let settings = &self.job.settings.control.turning;
        let angle = self.made(one_of(w.get(b'A'), w.long("AN")))?;
        let transition = self.made(w.transition(measure.mm))?;
        let entry = angle.map(|num| Angles::FromMinus.entry(Deg(self.line_angle(num))));
        let swapped = arc.is_some() && settings.arc_choice == Some(ArcChoice::ZeroIsFar);
        let far = self.made(w.is_far())? != swapped;
        let mut data = Data {
            arc: arc.map(|(ccw, _)| ccw),
            x: w.coord(Axis::Z, measure.mm),
            y: w.coord(Axis::X, measure.mm),
            entry,
            smooth: transition == Transition::Open,
            tolerance: self.arc_tolerance(),
            ..Data::default()
        };
        let open = data.x == Coord::Open || data.y == Coord::Open;
        let cut_off = data.entry.is_some() && data.x == Coord::Stay && data.y == Coord::Stay;
        if !open && !cut_off {
            self.without_effect(w, b"Q", codes::T8017::end_is_given_without_choice);
        }
        if arc.is_some() && open {
            self.depends_on(Question::ArcChoice, w.place(b'Q'));
        }
        if let Some((_, absolute)) = arc {
            data.radius = self.made(w.arc_radius(measure.mm))?;
            data.center = w.center(absolute, measure);
        }
        Ok((data, Follows { transition, far }))
    }

    /// The angle of a line, counted from the negative Z axis.
    #[cold]
    fn line_angle(&self, num: Num) -> f64 {
        // Along an axis there is one line only.
        if num.value % 90.0 != 0.0 {
            self.depends_on(Question::LineAngle, num.span);
        }
        if self.job.settings.control.turning.angle_from_plus == Some(true) { 180.0 - num.value } else { num.value }
    }

    /// How far the radii at both ends of an arc may differ, in mm.
    pub(super) fn arc_tolerance(&self) -> f64 {
        self.job.settings.control.turning.arc_tolerance.unwrap_or(AGREES)
    }
}

#[inline]
fn one_of(a: Option<Num>, b: Option<Num>) -> Made<Option<Num>> {
    match (a, b) {
        (Some(_), Some(b)) => refused(b.span, codes::P1002::two_addresses_of_block_mean_same()),
        (a, b) => Ok(a.or(b)),
    }
}

impl Words {
    /// B or BR.
    #[inline]
    pub(super) fn transition(&self, mm: f64) -> Made<Transition> {
        let num = one_of(self.get(b'B'), self.long("BR"))?;
        Ok(num.map_or(Transition::Open, |num| transition_of(num.value * mm)))
    }

    fn arc_radius(&self, mm: f64) -> Made<Option<f64>> {
        let Some(num) = self.get(b'R') else { return Ok(None) };
        let radius = num.value * mm;
        if radius == 0.0 || radius.abs() > LARGEST_RADIUS {
            return refused(num.span, codes::T1007::r_is_no_radius(&num.value));
        }
        Ok(Some(radius))
    }

    /// The centre of the 4110 is written in diameters like every other X value.
    fn center(&self, absolute: bool, measure: Measure) -> Center {
        let share = if measure.family == Family::Basic { 0.5 } else { 1.0 };
        let mm = measure.mm;
        Center { x: self.value(b'K').map(|k| k * mm), y: self.value(b'I').map(|i| i * mm * share), absolute }
    }

    /// Q: which of two solutions. The manuals disagree on arcs.
    #[inline]
    fn is_far(&self) -> Made<bool> {
        match self.get(b'Q') {
            None => Ok(false),
            Some(num) if num.value == 0.0 || num.value == 1.0 => Ok(num.value == 1.0),
            Some(num) => refused(num.span, codes::T1007::q_is_neither_0_nor_1(&num.value)),
        }
    }
}

/// What a B value in mm means.
pub(super) fn transition_of(b: f64) -> Transition {
    if b > 0.0 {
        Transition::Rounding(b)
    } else if b < 0.0 {
        Transition::Chamfer(-b)
    } else {
        Transition::Sharp
    }
}
