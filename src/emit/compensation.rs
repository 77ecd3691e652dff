//! Radius compensation by the target itself: what it allows while it compensates.
//!
//! RS274 controls accept few things between G41 and G40. What must not stand there either ends the
//! compensation first, or is refused: a contour that starts anew at its offset is another contour.

use crate::diag::{Answer, Diagnostic, Fault, Label, codes};
use crate::geo::Plane;
use crate::ir::function::CutterData;
use crate::ir::motion::{Move, Path};
use crate::ir::{Function, Origin, Side};

/// What has to happen in front of a move.
#[derive(Debug)]
pub(super) enum Preparation {
    Nothing,
    /// G40, G41 or G42 for the side of the move.
    Switch,
    /// The move is not printed: reported just now, or with an earlier block of the same contour.
    Refuse(Option<Box<Diagnostic>>),
}

/// What is known of the way of a move that may switch the compensation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    /// It changes an axis of its working plane.
    pub in_plane: bool,
    /// Length in the working plane, in mm, where the start is known.
    pub length: Option<f64>,
    /// Radius of the tool in mm, where it is known.
    pub radius: Option<f64>,
    /// The last printed place, in mm.
    pub unit: f64,
    /// A block was refused: it may have been an element of the contour.
    pub in_doubt: bool,
}

/// How a length may miss the radius by the rounding of what was printed, in mm.
const SAME_LENGTH: f64 = 1e-9;
/// Blocks without a move in the plane over which every target looks ahead.
const MOST_IDLE: u64 = 1;
/// What rounding takes from a way that is as long as the radius, such as that of DEP CT, in printed units: half a unit at both
/// ends along both axes, √2 together.
const ROUNDED: f64 = 1.5;

/// State of the target's compensation.
#[derive(Debug, Default)]
pub(super) struct Compensation {
    /// Side that is printed.
    pub side: Side,
    pub cutter: CutterData,
    /// The function that ended it; the contour cannot go on behind it.
    ended_by: Option<Origin>,
    /// G40 was printed, and no straight move since.
    leaving: bool,
    /// Something on this contour was refused.
    refused: bool,
    /// The word of the side stands in the move that comes.
    pub waits: bool,
    /// Blocks since the last one that moved in the plane.
    idle: u64,
    /// A move in the plane followed the one that began it.
    has_element: bool,
}

/// The path of the tool centre answers.
pub(super) fn resolved() -> Answer {
    Answer::key("output", "compensation").one_of(&["\"resolve\""])
}

impl Compensation {
    /// Is there nothing to look at for a move on `side`?
    #[inline]
    pub fn is_idle(&self, side: Side) -> bool {
        side == Side::None && self.side == Side::None && !self.leaving && !self.refused && self.ended_by.is_none()
    }

    /// What `mv` needs. `selected` is the plane in force, `planes` those the target compensates in.
    #[cold]
    pub fn before(&mut self, mv: &Move, origin: &Origin, selected: Plane, planes: &[Plane], way: Way) -> Preparation {
        if mv.side == Side::None {
            self.refused = false;
            self.ended_by = None;
        } else if self.refused {
            return Preparation::Refuse(None);
        }
        if let Some(fault) = self.obstacle(mv, selected, planes, way) {
            self.refused = true;
            if mv.side == Side::None {
                // What follows stands outside of the contour, whatever the target made of its end.
                self.side = Side::None;
            }
            let mut found = fault.at(origin.loc).called(origin.call);
            if let (Some(by), true) = (self.ended_by, mv.side != Side::None) {
                found = found.also(by.loc, Label::EndsCompensation);
            }
            return Preparation::Refuse(Some(Box::new(found)));
        }
        if mv.side == self.side {
            self.has_element |= way.in_plane;
            return Preparation::Nothing;
        }
        match self.too_short(mv.side, way) {
            Some(fault) => {
                self.refused = true;
                Preparation::Refuse(Some(Box::new(fault.at(origin.loc).called(origin.call))))
            }
            None => Preparation::Switch,
        }
    }

    /// The target refuses a way to the contour that is not longer than the radius. On a way from it that is shorter, the
    /// tool would end over the contour that it has just left.
    fn too_short(&self, side: Side, way: Way) -> Option<Fault> {
        let (length, radius) = (way.length?, way.radius?);
        if side == Side::None {
            let short = length < radius - ROUNDED * way.unit;
            short.then(|| codes::O9100::move_that_leaves_contour(&length, &radius))
        } else {
            let short = length <= radius + SAME_LENGTH;
            short.then(|| codes::O9100::move_that_leads_to_contour(&length, &radius))
        }
    }

    /// What is wrong with `mv`, and what to do.
    fn obstacle(&self, mv: &Move, selected: Plane, planes: &[Plane], way: Way) -> Option<Fault> {
        let on = self.side != Side::None;
        if on != (mv.side != Side::None) && !way.in_plane {
            // The first move in the plane would become the way to or from the contour.
            return Some(codes::O9003::begins_or_ends_in_block_that_does_not_move());
        }
        if on && mv.side == Side::None && !self.has_element && !way.in_doubt {
            // Controls differ in where the tool stands then, and some raise an alarm.
            return Some(codes::O9003::ends_before_contour_has_element());
        }
        if mv.side == Side::None {
            let arc = self.leaving || on;
            return (arc && matches!(mv.path, Path::Arc(..))).then(codes::O9003::target_needs_straight_move_to_end);
        }
        if self.ended_by.is_some() {
            return Some(codes::O9003::cannot_go_on_after_tool_change());
        }
        if !planes.contains(&mv.plane) {
            return Some(codes::O9003::target_does_not_compensate_in_this_plane().answer(resolved()));
        }
        if on && mv.side != self.side {
            return Some(codes::O9003::side_changes_while_it_is_on());
        }
        if on && mv.plane != selected {
            return Some(codes::O9003::working_plane_changes().answer(resolved()));
        }
        if !on && matches!(mv.path, Path::Arc(..)) {
            return Some(codes::O9003::cannot_start_in_arc());
        }
        let asking = match &mv.path {
            _ if mv.machine => codes::O9003::block_in_machine_coordinates_cannot_run(),
            Path::Thread { .. } => codes::O9003::thread_cannot_be_cut(),
            Path::Arc(arc, _) if arc.plane != mv.plane => codes::O9003::arc_outside_working_plane_cannot_run(),
            Path::Rapid | Path::Line(_) | Path::Arc(..) | Path::Carried { .. } => return None,
        };
        Some(asking.answer(resolved()))
    }

    /// Blocks that move nothing in the plane, between two moves of the contour: the target looks ahead over one.
    /// What to report, once for a contour.
    pub fn stands(&mut self, blocks: u64, origin: &Origin) -> Option<Diagnostic> {
        self.idle += blocks;
        if self.idle <= MOST_IDLE || std::mem::replace(&mut self.refused, true) {
            return None;
        }
        Some(
            codes::O9003::second_block_that_moves_nothing_in_working()
                .answer(Answer::key("output", "comments").one_of(&["false"]))
                .at(origin.loc)
                .called(origin.call),
        )
    }

    /// A stop, which the target does not read beyond: the tool would stand at a right angle to the element in front of it, in an
    /// inner corner behind the next one. What to report, once for a contour.
    pub fn stops(&mut self, target: &str, origin: &Origin) -> Option<Diagnostic> {
        if std::mem::replace(&mut self.refused, true) {
            return None;
        }
        let fault = codes::O9003::stop_stands_in_compensated_contour(&target).answer(resolved());
        Some(fault.at(origin.loc).called(origin.call))
    }

    /// A move in the plane is printed.
    pub fn moves(&mut self) {
        self.idle = 0;
    }

    /// The contour that begins is refused; true unless that was said.
    pub fn refuse_contour(&mut self) -> bool {
        !std::mem::replace(&mut self.refused, true)
    }

    /// The compensation was switched to `side`.
    pub fn switched(&mut self, side: Side) {
        self.leaving = side == Side::None;
        self.side = side;
        self.has_element = false;
    }

    /// A straight move was printed.
    #[inline]
    pub fn straight(&mut self) {
        self.leaving = false;
    }

    /// Must G40 stand in front of `function`?
    pub fn ends_before(&mut self, function: &Function, selected: Plane, origin: &Origin) -> bool {
        let ends = match function {
            Function::ToolChange { .. } | Function::WorkOffset(_) | Function::Tilt(_) => true,
            Function::Plane(plane) => *plane != selected,
            Function::Cutter(cutter) => *cutter != self.cutter,
            Function::ToolPrepare { .. }
            | Function::Spindle(_)
            | Function::SpindleOf { .. }
            | Function::FeedSpindle(_)
            | Function::Transformation(_)
            | Function::Coolant(_)
            | Function::Dwell(_)
            | Function::Stop
            | Function::OptionalStop
            | Function::Aux(_)
            | Function::PathControl(_)
            | Function::Comment(_)
            | Function::Remark(_)
            | Function::End { .. } => false,
        };
        let ends = ends && self.side != Side::None;
        if ends {
            self.ended_by = Some(*origin);
        }
        ends
    }
}
