//! From words to an element with the data it was programmed with.

use crate::diag::codes;
use crate::geo::Deg;
use crate::machine::{ArcChoice, Axis};
use crate::sema::cycle::given::Range;
use crate::text::Span;

use super::chain::{AGREES, Angles, Center, Coord, Data};
use super::program_parts::Family;
use super::readings::Question;
use super::words::{Num, Words};
use super::{Outcome, Run};

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

impl Run<'_> {
    /// A coordinate in mm, X as a radius.
    #[inline]
    pub(super) fn coord(&self, num: Option<Num>, axis: Axis) -> Coord {
        let Some(num) = num else { return Coord::Stay };
        let mm = self.st.mm() * if axis == Axis::X { 0.5 } else { 1.0 };
        match (num.unknown, num.incremental) {
            (true, _) => Coord::Open,
            (_, true) => Coord::By(num.value * mm),
            _ => Coord::At(num.value * mm),
        }
    }

    /// The element that the words of a block describe; `arc`: counter-clockwise, and whether its centre is absolute.
    pub(super) fn element_of(&mut self, w: &Words, arc: Option<(bool, bool)>) -> Outcome<(Data, Follows)> {
        let angle = self.one_of(w.get(b'A'), w.long("AN"))?;
        let transition = self.transition(w)?;
        let entry = angle.map(|num| Angles::FromMinus.entry(Deg(self.line_angle(num))));
        let far = self.far(w, arc.is_some())?;
        let mut data = Data {
            arc: arc.map(|(ccw, _)| ccw),
            x: self.coord(w.get(b'Z'), Axis::Z),
            y: self.coord(w.get(b'X'), Axis::X),
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
            self.depends_on(Question::ArcChoice, w.span(b'Q', self.core.block_span()));
        }
        if let Some((_, absolute)) = arc {
            data.radius = self.arc_radius(w)?;
            // The centre of the 4110 is written in diameters like every other X value.
            let share = if self.sections.family() == Family::Basic { 0.5 } else { 1.0 };
            let mm = self.st.mm();
            data.center =
                Center { x: w.value(b'K').map(|k| k * mm), y: w.value(b'I').map(|i| i * mm * share), absolute };
        }
        Ok((data, Follows { transition, far }))
    }

    /// How far the radii at both ends of an arc may differ, in mm.
    pub(super) fn arc_tolerance(&self) -> f64 {
        self.core.job.settings.control.turning.arc_tolerance.unwrap_or(AGREES)
    }

    /// The angle of a line, counted from the negative Z axis.
    fn line_angle(&self, num: Num) -> f64 {
        // Along an axis there is one line only.
        if num.value % 90.0 != 0.0 {
            self.depends_on(Question::LineAngle, num.span);
        }
        if self.core.job.settings.control.turning.angle_from_plus == Some(true) { 180.0 - num.value } else { num.value }
    }

    fn one_of(&self, a: Option<Num>, b: Option<Num>) -> Outcome<Option<Num>> {
        match (a, b) {
            (Some(_), Some(b)) => self.core.refuse(b.span, codes::P1002::two_addresses_of_block_mean_same()),
            (a, b) => Ok(a.or(b)),
        }
    }

    /// B or BR.
    pub(super) fn transition(&self, w: &Words) -> Outcome<Transition> {
        let Some(num) = self.one_of(w.get(b'B'), w.long("BR"))? else { return Ok(Transition::Open) };
        Ok(transition_of(num.value * self.st.mm()))
    }

    fn arc_radius(&self, w: &Words) -> Outcome<Option<f64>> {
        let Some(num) = w.get(b'R') else { return Ok(None) };
        let radius = num.value * self.st.mm();
        if radius == 0.0 || radius.abs() > LARGEST_RADIUS {
            return self.core.refuse(num.span, codes::T1007::r_is_no_radius(&num.value));
        }
        Ok(Some(radius))
    }

    /// Q: which of two solutions. The manuals disagree on arcs.
    fn far(&self, w: &Words, arc: bool) -> Outcome<bool> {
        let q = match w.get(b'Q') {
            None => 0.0,
            Some(num) if num.value == 0.0 || num.value == 1.0 => num.value,
            Some(num) => return self.core.refuse(num.span, codes::T1007::q_is_neither_0_nor_1(&num.value)),
        };
        let swapped = arc && self.core.job.settings.control.turning.arc_choice == Some(ArcChoice::ZeroIsFar);
        Ok((q == 1.0) != swapped)
    }

    /// A whole number in a range, or the default where the word is missing.
    pub(super) fn choice(&self, w: &Words, letter: u8, default: u32, most: u32) -> Outcome<u32> {
        let Some(num) = w.get(letter) else { return Ok(default) };
        if num.value.fract() == 0.0 && num.value >= 0.0 && num.value <= f64::from(most) {
            return Ok(num.value as u32);
        }
        self.core.refuse(num.span, codes::T1007::is_none_of(&(letter as char), &num.value, &Range(0, most as i32)))
    }

    /// A length in mm that is above zero.
    pub(super) fn above_zero(&self, num: Num, what: &str) -> Outcome<f64> {
        let length = num.value * self.st.mm();
        if length > 0.0 {
            return Ok(length);
        }
        self.core.refuse(num.span, codes::T1007::has_to_be_above_zero(&what))
    }

    /// The word that a function cannot do without.
    pub(super) fn needed(&self, w: &Words, letter: u8, what: &str, span: Span) -> Outcome<Num> {
        match w.get(letter) {
            Some(num) => Ok(num),
            None => self.core.refuse(span, codes::P1004::is_missing(&(letter as char), &what)),
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
