//! The tool in use, what D and E choose of it, and its radius under G41 and G42.
//!
//! Source: M 7, 8 (docs/sources.md).

use crate::diag::{Answer, Fault, codes};
use crate::geo::{Plane, Vec2};
use crate::ir;
use crate::machine::{Compensation, MachineKind, Settings};
use crate::sema::common::compensation::{nose_of, rules_of_nose};

use super::words::ToolData;

/// Blocks of a compensated contour that need not move in the plane.
const MOST_WITHOUT_MOVE: u32 = 2;

/// The tool that is chosen, and the one in use.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ToolInUse {
    /// Tool of the last T word.
    pub selected: Option<u32>,
    /// Tool of the last change.
    pub active: Option<u32>,
    /// A correction D other than 0 was chosen.
    corrected: bool,
    /// An edge E other than the first was chosen.
    other_edge: bool,
}

fn printed() -> Answer {
    Answer::key("output", "compensation").one_of(&["\"control\""])
}

impl ToolInUse {
    /// Letters of what was chosen beside the first edge and no correction.
    pub fn chosen(&self) -> impl Iterator<Item = char> {
        [('D', self.corrected), ('E', self.other_edge)].into_iter().filter_map(|(letter, on)| on.then_some(letter))
    }

    /// D or E. True where that is another one than the first edge without a correction.
    pub fn choose(&mut self, data: &ToolData) -> bool {
        let first = u32::from(data.letter == 'E');
        let other = data.number > first;
        if data.letter == 'D' {
            self.corrected = other;
        } else {
            self.other_edge = other;
        }
        other
    }

    /// D and E choose a radius that only the machine knows.
    pub fn radius_is_that_of_the_table(&self) -> Result<(), Fault> {
        if self.corrected {
            return Err(codes::P9013::what_correction_d_in_force_adds().answer(printed()));
        }
        if self.other_edge {
            return Err(codes::P9013::radius_of_edge_e_in_force().answer(printed()));
        }
        Ok(())
    }

    /// How the compiler computes the path of the centre of this tool, or of the nose of a turning tool.
    pub fn rules(&self, tool: u32, plane: Plane, settings: &Settings) -> Result<ir::Compensation, Fault> {
        let answers = |field| [Answer::tool(tool, field), printed()];
        let (radius, edge) = nose_of(settings.tools.by_number(tool, 0));
        let radius = match radius {
            Some(radius) if radius >= 0.0 => radius,
            Some(_) => {
                let asking = codes::P9013::radius_of_tool_is_below_zero_for_path(&tool);
                return Err(asking.answers(answers("radius")));
            }
            None => return Err(codes::P9013::radius_of_tool_is_not_known_for_path(&tool).answers(answers("radius"))),
        };
        let turns = settings.machine.kind == MachineKind::Lathe && plane == Plane::Zx;
        let edge = match edge {
            Some(edge) if turns => edge,
            None if turns && radius > 0.0 => {
                let asking = codes::P9013::cutting_edge_position_of_tool_is_not(&tool);
                return Err(asking.answers(answers("orientation")));
            }
            _ => Vec2::zeros(),
        };
        self.radius_is_that_of_the_table()?;
        Ok(rules_of_nose(radius, edge))
    }

    /// G43 of the target adds the length of the tool to Z, whatever the plane.
    pub fn length_acts_along_z(&self, plane: Plane, settings: &Settings) -> Result<(), Fault> {
        let none = self.active.is_none_or(|number| number == 0);
        let lathe = settings.machine.kind == MachineKind::Lathe;
        if plane == Plane::Xy || none || lathe || !settings.output.prints_tool_length() {
            return Ok(());
        }
        let [who, way] = settings.output.length_along_z();
        Err(codes::O9190::outside_g17_length_of_tool_does_not(&who, &way)
            .answer(Answer::key("output", "tool_length").one_of(&["\"off\""])))
    }
}

/// From one element of a compensated contour to the next.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Transition {
    /// G44.
    pub chamfers: bool,
    /// G43 or G44 was programmed.
    pub said: bool,
    /// Blocks since the last one that moves in the plane.
    between: u32,
}

impl Transition {
    /// A contour begins.
    pub fn begin(&mut self) {
        self.between = 0;
    }

    /// A block of the contour; after too many that do not move in the plane the control takes it as finished.
    pub fn pass(&mut self, moves_in_plane: bool, computed: Compensation) -> Result<(), Fault> {
        let before = self.between;
        self.between = if moves_in_plane { 0 } else { before + 1 };
        if !moves_in_plane || before <= MOST_WITHOUT_MOVE || computed == Compensation::Control {
            return Ok(());
        }
        Err(codes::P9013::blocks_in_front_of_this_one(&before, &MOST_WITHOUT_MOVE))
    }
}
