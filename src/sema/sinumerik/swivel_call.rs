//! The arguments of `CYCLE800`, and the plane that they describe.
//!
//! `new = (I, X0) · (R, 0) · (I, X1)`: the reference point before the turns, the turns, the zero point of the turned plane in its
//! axes. Source: S 4.9 (docs/sources.md) and references, multi-axis, section 3.1.

use nalgebra::{Matrix3, Vector3};

use crate::diag::{Fault, codes};
use crate::geo::rotation;
use crate::text::Span;

use super::frames::FrameValue;
use super::value::whole;

/// Places of the arguments, from 0.
const RETRACTION: usize = 0;
const STATE: usize = 2;
const MODE: usize = 3;
const BEFORE: usize = 4;
const ANGLES: usize = 7;
const AFTER: usize = 10;
const DIRECTION: usize = 13;
const RETRACTION_WAY: usize = 14;
const MODE_OF_SCREEN: usize = 15;

/// The name of the swivel record.
pub(super) const RECORD: usize = 1;
/// Most arguments.
pub(super) const MOST: usize = 16;

/// What is wrong, and where.
type Wrong = (Span, Fault);

/// The arguments of a call.
#[derive(Debug, Default)]
pub(super) struct Arguments {
    values: [f64; MOST],
    places: [Span; MOST],
    /// `_TC`
    record: String,
    /// Nothing but a retraction is given.
    resets: bool,
}

/// What a call asks for.
#[derive(Debug)]
pub(super) struct Swivel {
    /// `_FR`
    pub retraction: f64,
    /// `_FR_I` in mm.
    pub way: f64,
    /// Back to the plane that is not swivelled, and no rotary axis turns: nothing but a retraction is given, or the record is
    /// deselected.
    pub resets: bool,
    /// It is chained behind the plane in force.
    pub additive: bool,
    pub plane: FrameValue,
    /// `_DIR`
    pub direction: Direction,
    /// Name of the swivel record, which may be empty.
    pub record: String,
    /// `_ST` wants the tip to follow.
    pub follows: Option<Wrong>,
    /// Is it the plane of G17 that is meant? `None` for the one in force.
    pub first_plane: Option<bool>,
    /// `_ST` keeps another direction than `_DIR`.
    pub contradiction: Option<Wrong>,
}

/// Which solution of the rotary axes is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    Smaller,
    Greater,
    /// No axis turns.
    Stays,
    Unknown,
}

impl Arguments {
    /// A call with so many places for arguments.
    pub fn of(count: usize) -> Arguments {
        Arguments { resets: count <= 1, ..Arguments::default() }
    }

    /// Takes a number; false where there is no such argument.
    pub fn take(&mut self, at: usize, value: f64, place: Span) -> bool {
        let (Some(to), Some(span)) = (self.values.get_mut(at), self.places.get_mut(at)) else { return false };
        (*to, *span) = (value, place);
        true
    }

    /// Takes the name of the record.
    pub fn take_record(&mut self, name: &[u8], place: Span) {
        self.record = String::from_utf8_lossy(name).trim().to_ascii_uppercase();
        self.places[RECORD] = place;
    }

    /// What the call asks for; `mm` is the unit of length.
    pub fn read(&self, mm: f64) -> Result<Swivel, Wrong> {
        self.have_values()?;
        let [state, mode] = [STATE, MODE].map(|at| whole(self.values[at]).unwrap_or_default());
        let direction = self.direction();
        let turn = self.turn(mode)?;
        let deselects = self.record == "0";
        if deselects && self.turns() {
            return Err((self.places[RECORD], codes::S9006::cycle800_swivels_deselected_record()));
        }
        let [before, after] = [BEFORE, AFTER].map(|at| self.vector(at) * mm);
        Ok(Swivel {
            retraction: self.values[RETRACTION],
            way: self.values[RETRACTION_WAY] * mm,
            resets: self.resets || deselects,
            additive: state % 10 == 1,
            plane: FrameValue::placed(turn, before + turn * after),
            direction,
            record: self.record.clone(),
            follows: (state / 10 % 10 != 0).then(|| self.does_more(state / 10 % 10, "tens", "has the tip follow")),
            first_plane: match whole(self.values[MODE_OF_SCREEN]).unwrap_or_default() % 10 {
                0 => None,
                code => Some(code == 1),
            },
            contradiction: self.contradiction(state, direction),
        })
    }

    /// Codes that the cycle has.
    fn have_values(&self) -> Result<(), Wrong> {
        for at in [STATE, MODE, DIRECTION, MODE_OF_SCREEN] {
            let code = whole(self.values[at]);
            let (name, known, wanted) = match at {
                STATE => (
                    "_ST",
                    code.is_some_and(|code| (0..1_000_000).contains(&code) && code % 10 < 2),
                    "units 0 for a new plane or 1 for an additive one",
                ),
                MODE => ("_MODE", code.is_some_and(|code| (0..256).contains(&code)), "a code up to 255"),
                DIRECTION => ("_DIR", code.is_some_and(|code| (-2..3).contains(&code)), "-1 or 1, or 0"),
                _ => ("_DMODE", code.is_some_and(|code| (0..100_000_000).contains(&code)), "a whole number"),
            };
            if !known {
                let fault = codes::S9006::cycle800_has_no(&self.values[at], &name, &(at + 1), &wanted);
                return Err((self.places[at], fault));
            }
        }
        let state = whole(self.values[STATE]).unwrap_or_default();
        match [state / 100 % 10, state / 1000 % 10] {
            [0, 0] => Ok(()),
            [0, digit] => Err(self.does_more(digit, "thousands", "is a choice whose meaning is not known")),
            [digit, _] => Err(self.does_more(digit, "hundreds", "aligns the tool")),
        }
    }

    fn does_more(&self, digit: i32, name: &str, what: &str) -> Wrong {
        (self.places[STATE], codes::S9006::cycle800_does_more(&digit, &name, &what))
    }

    fn vector(&self, at: usize) -> Vector3<f64> {
        Vector3::new(self.values[at], self.values[at + 1], self.values[at + 2])
    }

    /// Is an angle given that is not 0?
    fn turns(&self) -> bool {
        self.values[ANGLES..AFTER].iter().any(|angle| *angle != 0.0)
    }

    /// Three turns, each about an axis that those before have turned.
    fn turn(&self, mode: i32) -> Result<Matrix3<f64>, Wrong> {
        if !self.turns() {
            return Ok(Matrix3::identity());
        }
        let what = match mode >> 6 {
            0 => "",
            1 => "solid angles",
            2 => "projected angles",
            _ => "the positions of the rotary axes",
        };
        if !what.is_empty() {
            return Err((self.places[MODE], codes::S9006::cycle800_swivels_in_mode(&mode, &what)));
        }
        let axes = match mode {
            57 => [0, 1, 2],
            54 => [1, 0, 2],
            45 => [0, 2, 1],
            39 => [2, 0, 1],
            30 => [1, 2, 0],
            27 => [2, 1, 0],
            _ => return Err((self.places[MODE], codes::S9006::cycle800_has_no_order(&mode))),
        };
        let angles = &self.values[ANGLES..AFTER];
        Ok(rotation::in_turn([0, 1, 2].map(|at| (axes[at], angles[at]))))
    }

    fn direction(&self) -> Direction {
        match whole(self.values[DIRECTION]) {
            Some(-1) => Direction::Smaller,
            Some(0) => Direction::Stays,
            Some(1) => Direction::Greater,
            _ => Direction::Unknown,
        }
    }

    /// The screen keeps its choice of the direction as the last but one and the last digit: 1 for minus, 2 for plus.
    fn contradiction(&self, state: i32, direction: Direction) -> Option<Wrong> {
        let opposite = match direction {
            Direction::Smaller => 2,
            Direction::Greater => 1,
            Direction::Stays | Direction::Unknown => return None,
        };
        [state / 10_000 % 10, state / 100_000].contains(&opposite).then(|| {
            let shown = self.values[DIRECTION];
            (self.places[STATE], codes::S8255::st_says_otherwise_than_dir(&state, &shown))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACE: Span = Span { start: 0, end: 0 };

    /// A call by its numbers, without the record.
    fn call(values: [f64; 15]) -> Result<Swivel, &'static str> {
        let mut arguments = Arguments::of(MOST);
        for (at, value) in (0..MOST).filter(|at| *at != RECORD).zip(values) {
            assert!(arguments.take(at, value, PLACE));
        }
        arguments.read(1.0).map_err(|(_, fault)| fault.code().id)
    }

    fn mode(mode: i32, [a, b, c]: [f64; 3]) -> Result<Swivel, &'static str> {
        call([0.0, 0.0, f64::from(mode), 0.0, 0.0, 0.0, a, b, c, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0])
    }

    fn near(a: &FrameValue, b: &FrameValue) -> bool {
        (a.axes() - b.axes()).iter().chain((a.origin() - b.origin()).iter()).all(|off| off.abs() < 1e-9)
    }

    fn is(found: Vector3<f64>, wanted: [f64; 3], tolerance: f64) {
        assert!((found - Vector3::from(wanted)).abs().max() < tolerance, "{found} {wanted:?}");
    }

    /// Section 3.1: the six orders with 10, 20, 30, by the Z of the plane.
    #[test]
    fn six_orders_of_turns() {
        for (code, normal) in [
            (57, [0.342020, -0.163176, 0.925417]),
            (54, [0.163176, -0.342020, 0.925417]),
            (45, [0.469846, 0.018028, 0.882564]),
            (39, [0.543838, -0.204874, 0.813798]),
            (30, [0.318796, -0.469846, 0.823173]),
            (27, [0.378522, -0.440970, 0.813798]),
        ] {
            let plane = mode(code, [10.0, 20.0, 30.0]).unwrap().plane;
            is(plane.axes().column(2).into_owned(), normal, 1e-6);
        }
        assert_eq!([64, 128, 185, 192].map(|code| mode(code, [10.0, 0.0, 0.0]).err()), [Some("S9006"); 4]);
        assert_eq!([0, 21, 58, 63].map(|code| mode(code, [10.0, 0.0, 0.0]).err()), [Some("S9006"); 4]);
        for code in [0, 64, 128, 192] {
            assert!(mode(code, [0.0; 3]).unwrap().plane.is_shift(), "{code}");
        }
    }

    /// Section 3.1: the chain of the published program, a box 50 high.
    #[test]
    fn chain_of_a_published_program() {
        let first =
            call([0.0, 0.0, 57.0, 0.0, 0.0, 50.0, -15.0, 0.0, 0.0, 50.0, 51.76, 0.0, 1.0, 0.0, 1.0]).unwrap().plane;
        let second = call([0.0, 1.0, 54.0, 35.0, -24.0, 0.0, 7.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0]).unwrap();
        assert!(second.additive);
        is(first.origin(), [50.0, 49.9963, 36.6035], 5e-5);
        let chained = first.chain(&second.plane);
        is(chained.origin(), [85.0, 26.8141, 42.8152], 5e-5);
        is(chained.axes().column(2).into_owned(), [0.121869, 0.256890, 0.958726], 1e-6);
        let hole = chained.origin() + chained.axes() * Vector3::new(0.0, 60.0, 0.0);
        is(hole, [85.0, 84.7697, 27.2860], 5e-5);
    }

    /// Row 30 of section 9: B 90 brings Z to X.
    #[test]
    fn a_quarter_turn_is_exact() {
        let plane = mode(57, [0.0, 90.0, 0.0]).unwrap().plane;
        assert_eq!(plane.origin() + plane.axes() * Vector3::new(15.0, 5.0, 19.0), Vector3::new(19.0, 5.0, -15.0));
        let back = plane.chain(&mode(57, [0.0, -90.0, 0.0]).unwrap().plane);
        assert_eq!(FrameValue::placed(*back.axes(), back.origin()), FrameValue::default());
    }

    #[test]
    fn digits_of_the_state() {
        let state = |state: i32, direction: f64| {
            call([0.0, f64::from(state), 57.0, 0.0, 0.0, 0.0, 0.0, 30.0, 0.0, 0.0, 0.0, 0.0, direction, 0.0, 1.0])
        };
        for wrong in [2, 100, 1000, 201_100, 1_000_000, -1] {
            assert_eq!(state(wrong, 1.0).err(), Some("S9006"), "{wrong}");
        }
        assert!(state(10, 1.0).unwrap().follows.is_some() && state(200_001, 1.0).unwrap().follows.is_none());
        for (code, direction, contradicts) in [
            (100_000, -1.0, false),
            (200_000, 1.0, false),
            (100_000, 1.0, true),
            (200_000, -1.0, true),
            (10_000, 1.0, true),
            (220_000, 0.0, false),
        ] {
            assert_eq!(state(code, direction).unwrap().contradiction.is_some(), contradicts, "{code} {direction}");
        }
    }

    /// The angles by which three turns in an order make a rotation: the middle one lies within 90 degrees.
    fn angles_in_turn([i, j, k]: [usize; 3], turn: &Matrix3<f64>) -> [f64; 3] {
        let sign = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        let first = libm::atan2(-sign * turn[(j, k)], turn[(k, k)]);
        let second = libm::asin((sign * turn[(i, k)]).clamp(-1.0, 1.0));
        let third = libm::atan2(-sign * turn[(i, j)], turn[(i, i)]);
        [first, second, third].map(f64::to_degrees)
    }

    proptest::proptest! {
        /// One rotation through all orders makes one plane, and a call behind another is their product.
        #[test]
        fn orders_agree(a in -180.0f64..180.0, b in -89.0f64..89.0, c in -180.0f64..180.0,
                        shift in proptest::array::uniform6(-200.0f64..200.0), second in proptest::array::uniform3(-180.0f64..180.0)) {
            let turn = rotation::spatial([a, b, c]);
            let orders = [(57, [0, 1, 2]), (54, [1, 0, 2]), (45, [0, 2, 1]), (39, [2, 0, 1]), (30, [1, 2, 0]), (27, [2, 1, 0])];
            let [x0, y0, z0, x1, y1, z1] = shift;
            for (code, order) in orders {
                let [a, b, c] = angles_in_turn(order, &turn);
                let plane = call([0.0, 0.0, f64::from(code), x0, y0, z0, a, b, c, x1, y1, z1, 1.0, 0.0, 1.0]).unwrap().plane;
                let wanted = FrameValue::placed(turn, Vector3::new(x0, y0, z0) + turn * Vector3::new(x1, y1, z1));
                proptest::prop_assert!(near(&plane, &wanted), "{code}");
                let inner = mode(39, second).unwrap().plane;
                let product = FrameValue::placed(turn * inner.axes(), wanted.origin());
                proptest::prop_assert!(near(&plane.chain(&inner), &product));
            }
        }
    }
}
