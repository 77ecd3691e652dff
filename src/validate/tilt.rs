//! Tilted working planes: the printed angles, turned into a matrix, against the axes that are meant.

use nalgebra::Matrix3;

use crate::geo::rotation;
use crate::ir::Tilting;
use crate::ir::tilt::{Solution, Tilt};
use crate::machine::AxisSet;
use crate::machine::settings::Machine;
use crate::read::{self, Act, Angles, Choice, Path, SCALE};

use super::{Validator, Why, is_rounding};

/// What a direction may differ by: 0.01 mm at a metre.
const ANOTHER: f64 = 1e-5;

/// What is expected of tilted planes.
#[derive(Debug)]
pub(super) struct Expected {
    /// Rotary axes that turn back by their letters.
    axes: AxisSet,
    /// Name of the swivel record.
    record: String,
    /// The plane ended before a move in machine coordinates, and is meant to be on.
    pub left: bool,
    /// A plane is meant to be on.
    on: bool,
    /// The tool whose length counts, 0 for none.
    pub tool: u32,
}

impl Expected {
    pub fn of(machine: &Machine) -> Expected {
        let record = machine.swivel_record.clone().unwrap_or_default();
        Expected { axes: machine.tilt_axes, record, left: false, on: false, tool: 0 }
    }
}

impl Validator {
    /// Is the plane that was read the one that is meant?
    pub(super) fn is_tilt(&mut self, tilting: &Tilting, acts: &[Act]) -> bool {
        let was_on = self.tilts.on && !self.tilts.left;
        (self.tilts.on, self.tilts.left) = (tilting.plane().is_some(), false);
        self.stated = 0;
        self.feed = None;
        let length = self.reader.modes().length;
        if self.length_with_move && self.tilts.tool != 0 && length == Some(0) {
            self.length = Some(self.tilts.tool);
        }
        let is_first = |act: &Act| matches!(act, Act::Tilt(read::Tilting::Off | read::Tilting::Shifted));
        let first = acts.iter().take_while(|act| is_first(act)).count();
        let (before, rest) = acts.split_at(first);
        // An order in which each happens once at most.
        let ordered = before.len() < 2 || before == [Act::Tilt(read::Tilting::Off), Act::Tilt(read::Tilting::Shifted)];
        let modes = self.reader.modes();
        let off = !modes.tilted && modes.shift == [0; 3];
        let fine = match tilting {
            Tilting::Into(tilt) => rest == [Act::Tilt(read::Tilting::Into)] && modes.tilted && self.is_plane(tilt),
            Tilting::Back(solution) => off && self.turns_back(*solution, rest, was_on, before),
            Tilting::Off => off && rest.is_empty(),
        };
        let turned = !tilting.turns() || !self.length_with_move || length == Some(0);
        ordered && fine && turned && modes.plane == self.plane.map(|_| read::Plane::Xy)
    }

    fn is_plane(&self, tilt: &Tilt) -> bool {
        let read = self.reader.tilt();
        let degrees = read.angles.map(|units| units as f64 / SCALE as f64);
        let axes: Matrix3<f64> = match read.about {
            Angles::Euler => rotation::euler(degrees),
            Angles::Spatial => rotation::spatial(degrees),
        };
        let same = (axes - tilt.axes).iter().all(|off| off.abs() <= ANOTHER);
        let there = (0..3).all(|i| is_rounding(read.origin[i], tilt.origin[i], self.half));
        same && there && self.is_choice(tilt.solution)
    }

    /// Is it the position of the rotary axes that is meant, as far as the target can be told?
    fn is_choice(&self, meant: Solution) -> bool {
        match self.reader.tilt().choice {
            Choice::Unsaid => true,
            Choice::Primary(said) => match meant {
                Solution::Primary { positive } => said == Some(positive),
                Solution::Control | Solution::Reference { .. } => said.is_none(),
            },
            Choice::Reference(said) => {
                let greater = match meant {
                    Solution::Reference { greater } => greater,
                    Solution::Primary { positive } => positive,
                    Solution::Control => true,
                };
                said == greater && self.reader.record() == self.tilts.record.as_bytes()
            }
        }
    }

    /// The rotary axes turn to where they stood, by a word for it or by their letters.
    fn turns_back(&self, solution: Solution, rest: &[Act], was_on: bool, before: &[Act]) -> bool {
        match rest {
            [Act::Tilt(read::Tilting::Back)] => {
                let none = Solution::Control;
                let by_axis = matches!(self.reader.tilt().choice, Choice::Reference(_));
                before.is_empty() && self.is_choice(if by_axis { solution } else { none })
            }
            [Act::Tilt(read::Tilting::Back), Act::Tilt(read::Tilting::Shifted)] => before.is_empty(),
            [Act::Move(read::Move { path: Path::Rapid, axes, machine: false })] => {
                let all = self.tilts.axes;
                let at_zero = all.iter().all(|axis| self.reader.place(axis.index()) == Some(0));
                let ended = (before == [Act::Tilt(read::Tilting::Off)]) == was_on;
                *axes == all.bits() && !all.is_empty() && at_zero && ended
            }
            _ => false,
        }
    }

    /// The plane may end before a move in machine coordinates, and nothing moves in it any more.
    #[cold]
    pub(super) fn leaves_plane(&mut self, machine: bool) -> Result<(), Why> {
        self.tilts.left = true;
        if self.tilts.on && machine { Ok(()) } else { Err(Why::new("the tilted plane ends before its time")) }
    }

    /// A move or a tap in a plane that has ended.
    #[inline(always)]
    pub(super) fn is_in_plane(&self) -> Result<(), Why> {
        if self.tilts.left { Err(Why::new("the tilted plane has ended")) } else { Ok(()) }
    }
}
