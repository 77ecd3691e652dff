//! Recesses and undercuts in a contour, and the side from which they are cut.
//!
//! A recess is cut from the side opposite to its floor, an undercut from inside of its corner. Where the tool works on
//! the other side they would be beads and rings of material, which no cycle cuts.

use crate::geo::cross;
use crate::text::Loc;

use super::chain::Solved;
use super::forms;

/// What the side of a form is told by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FormKind {
    Recess,
    Undercut,
}

/// A recess or undercut in a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Form {
    pub kind: FormKind,
    /// It is cut with the tool left of the contour, seen in its direction.
    pub left: bool,
    /// Its block.
    pub loc: Loc,
}

impl Form {
    /// The undercut between two elements: the contour turns towards the tool.
    pub fn undercut(before: &Solved, after: Option<&Solved>, loc: Loc) -> Option<Form> {
        let way = |line: &Solved| line.to - line.from;
        let turn = cross(way(before), way(after?));
        Some(Form { kind: FormKind::Undercut, left: turn > 0.0, loc })
    }

    /// The recess in an element: its floor lies away from the tool.
    pub fn recess(line: &Solved, made: &forms::Made, loc: Loc) -> Option<Form> {
        let (wall, _) = made.elements.first()?;
        let aside = cross(line.to - line.from, wall.to() - wall.from());
        Some(Form { kind: FormKind::Recess, left: aside < 0.0, loc })
    }

    /// The same in a contour that is run through backwards.
    pub fn turned(self) -> Form {
        Form { left: !self.left, ..self }
    }

    pub fn name(self) -> &'static str {
        match self.kind {
            FormKind::Recess => "recess",
            FormKind::Undercut => "undercut",
        }
    }
}
