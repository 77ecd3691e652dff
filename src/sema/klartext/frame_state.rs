//! The transformation in force, and what cycles and functions make of it: each gives the next one, or says what is wrong.
//!
//! Source: K 3 (docs/sources.md).

use crate::diag::{Answer, Fault, codes};
use crate::geo::{Deg, Plane};
use crate::machine::{Axis, AxisSet, ShiftAxes};
use crate::parser::klartext::ast::Transform;
use crate::sema::run::Where;
use crate::text::{Loc, Span};

use super::cycle_definition::{AxisValue, Open};
use super::transformation::Transformation;
use super::{Core, Outcome, Reported};

/// The transformation in force, and the input systems that it made.
#[derive(Debug, Clone)]
pub(super) struct FrameState {
    transform: Transformation,
    /// Counts changes of the input system.
    system: u32,
    /// Cycle 247 selected a preset.
    preset_selected: bool,
    /// The row that it selected last.
    row: Option<u32>,
    /// A touch probe cycle that is left out, after which a basic rotation may be in force that nobody here knows.
    probed: Option<Loc>,
}

impl FrameState {
    pub fn new(transform: Transformation) -> FrameState {
        FrameState { transform, system: 0, preset_selected: false, row: None, probed: None }
    }

    pub fn transform(&self) -> &Transformation {
        &self.transform
    }

    /// The row of the preset table that the program selected last.
    pub fn preset_row(&self) -> Option<u32> {
        self.row
    }

    /// The cycle at `loc` is left out, and may turn the coordinates.
    pub fn may_be_turned(&mut self, loc: Loc) {
        self.probed = Some(loc);
    }

    /// The last cycle that is left out and may have turned the coordinates.
    pub fn probed(&self) -> Option<Loc> {
        self.probed
    }

    /// Puts another one in force.
    pub fn set(&mut self, transform: Transformation) {
        self.transform = transform;
    }

    /// Another input system begins.
    pub fn change_system(&mut self) {
        self.system += 1;
    }

    /// Cycle 247 selects a row: another system begins. Was one selected before?
    pub fn select_preset(&mut self, row: Option<u32>) -> bool {
        self.system += 1;
        self.row = row;
        std::mem::replace(&mut self.preset_selected, true)
    }

    pub fn preset_selected(&self) -> bool {
        self.preset_selected
    }

    /// Number of the input system: another one after each change.
    pub fn system(&self) -> u32 {
        self.system
    }

    // What comes next.

    /// Warns where `next` mixes transformations whose order no available manual gives.
    pub fn warn_of_order(&self, core: &Core<'_>, next: &Transformation) {
        let now = &self.transform;
        let here = core.here.origin.loc;
        let turned = now.angle != next.angle || now.plane != next.plane;
        if next.mirror_order_counts() && (turned || now.mirror != next.mirror) {
            let fault =
                if next.mirror_last { codes::K2807::rotation_acts_first() } else { codes::K2807::mirror_acts_first() };
            core.report(fault.answer(Answer::key("control", "mirror")).at(here));
        }
        if next.scaling_order_counts() && (turned || now.axis_scale != next.axis_scale) {
            core.report(codes::K2807::cycle_26_scales_first().at(here));
        }
        if next.scales_twice() && (now.scale != next.scale || now.axis_scale != next.axis_scale) {
            core.report(codes::K2808::cycle_11_scales_first().at(here));
        }
    }

    /// Datum shift: axes that are not named keep theirs.
    pub fn shifted(&self, core: &Core<'_>, axes: &[AxisValue]) -> Outcome<Transformation> {
        let mm = core.mm();
        let mut next = self.transform.clone();
        let turned = core.job.settings.control.shift_axes == ShiftAxes::Transformed;
        for axis in axes {
            let Some(value) = axis.value else {
                core.report(codes::K2402::shift_of_lacks_its_value(&axis.axis.letter()).at(axis.loc));
                return Err(Reported);
            };
            let value = if axis.axis.is_rotary() { value } else { value * mm };
            next.shift_by(axis.axis, value, axis.incremental, turned);
        }
        self.check_shift_under_turn(core, &mut next)?;
        let now = &self.transform;
        let changes = AxisSet::MAIN.iter().any(|axis| now.shift[axis.index()] != next.shift[axis.index()]);
        let clears = AxisSet::MAIN.iter().all(|axis| next.shift[axis.index()] == 0.0);
        if changes && !clears && !now.is_shift_only() && !turned {
            let fault = codes::K2501::datum_shift_is_measured_along_original_axes();
            core.say_here(fault.answer(Answer::key("control", "shift_axes")));
        }
        Ok(next)
    }

    /// A datum shift that came before the turn of the working plane is measured along other axes than one after it.
    fn check_shift_under_turn(&self, core: &Core<'_>, next: &mut Transformation) -> Outcome {
        let now = &self.transform;
        if now.turn.0 == 0.0 || now.shift[..2] == next.shift[..2] {
            return Ok(());
        }
        if now.is_shifted_in_plane() && !now.shifted_in_turn {
            return core.refuse(Where::Block, codes::K2852::datum_was_shifted_before_working_plane());
        }
        next.shifted_in_turn = next.is_shifted_in_plane();
        Ok(())
    }

    /// Cycle 8.
    pub fn mirrored(&self, core: &Core<'_>, axes: AxisSet, tool_axis: Axis) -> Outcome<Transformation> {
        if !axes.without(AxisSet::MAIN).is_empty() {
            return core.refuse(Where::Block, codes::P2090::only_x_y());
        }
        if axes.contains(tool_axis) {
            core.say_here(codes::P2030::tool_axis_is_mirrored(&tool_axis.letter()));
        }
        let mut next = self.transform.clone();
        next.mirror = axes;
        Ok(next)
    }

    /// Cycle 10.
    pub fn rotated(&self, angle: f64, incremental: bool, plane: Plane) -> Transformation {
        let mut next = self.transform.clone();
        next.angle = Deg(if incremental { next.angle.0 + angle } else { angle });
        if next.angle.normal().0 == 0.0 {
            next.angle = Deg(0.0);
        }
        next.plane = plane;
        next
    }

    /// Cycle 11.
    pub fn scaled(&self, core: &Core<'_>, factor: f64, tool_axis: Axis) -> Outcome<Transformation> {
        check_factor(core, factor)?;
        let in_plane = core.job.settings.control.scaling_in_plane;
        if factor != 1.0 && !in_plane {
            let fault = codes::K2507::scaling_acts_on_tool_axis();
            core.note(Where::Block, fault.answer(Answer::key("control", "scaling")));
        }
        let mut next = self.transform.clone();
        next.scale = factor;
        next.unscaled = in_plane.then_some(tool_axis);
        Ok(next)
    }

    /// Cycle 26.
    pub fn axes_scaled(&self, core: &Core<'_>, open: &Open) -> Outcome<Transformation> {
        let mm = core.mm();
        let mut next = self.transform.clone();
        for axis in &open.axes {
            let (true, Some(factor)) = (axis.axis.is_main(), axis.value) else {
                core.report(codes::P2090::cannot_be_scaled(&axis.axis.letter()).at(axis.loc));
                return Err(Reported);
            };
            check_factor(core, factor)?;
            next.axis_scale[axis.axis.index()] = factor;
        }
        let kept = next.scale_center;
        next.scale_center = [0.0; 3];
        let mut named = [false; 3];
        for labelled in &open.values {
            let axis = match labelled.label.as_str() {
                "CCX" => 0,
                "CCY" => 1,
                "CCZ" => 2,
                // Other names are refused where they are read.
                _ => continue,
            };
            next.scale_center[axis] = labelled.value * mm;
            named[axis] = true;
        }
        other_centers(core, &mut next, kept, named);
        Ok(next)
    }

    /// TRANS … RESET.
    pub fn reset(&self, core: &Core<'_>, kind: Transform) -> Outcome<Transformation> {
        let mut next = self.transform.clone();
        let none = Transformation::default();
        match kind {
            Transform::Datum => {
                next.unshift();
                self.check_shift_under_turn(core, &mut next)?;
            }
            Transform::Mirror => next.mirror = none.mirror,
            Transform::Rotation => next.angle = none.angle,
            Transform::Scale => {
                next.scale = none.scale;
                next.unscaled = none.unscaled;
            }
        }
        Ok(next)
    }

    /// A turn under a shift of the turned plane, a mirror or an uneven scale would need another order of them.
    pub fn may_turn(&self) -> Result<(), Fault> {
        let now = &self.transform;
        if now.shifted_in_turn && now.is_shifted_in_plane() {
            return Err(codes::K2852::working_plane_turns_while_datum_shift_along());
        }
        if now.turns_with_the_plane() {
            return Err(codes::K2852::working_plane_turns_while_mirror_or_uneven());
        }
        Ok(())
    }

    /// While the working plane is turned, the turn is in the coordinates: a rotary axis that moves would turn twice.
    pub fn no_rotary_move_under_turn(&self, core: &Core<'_>, axes: AxisSet, span: Span) -> Outcome {
        let turned = &self.transform;
        if turned.turn.0 == 0.0 && !turned.is_turned_as_a_whole() {
            return Ok(());
        }
        let Some(axis) = axes.iter().find(|axis| axis.is_rotary()) else { return Ok(()) };
        core.refuse(span, codes::K9004::moves_while_coordinates_are_turned_about_z(&axis.letter()))
    }
}

fn check_factor(core: &Core<'_>, factor: f64) -> Outcome {
    if (0.000_001..=99.999_999).contains(&factor) {
        return Ok(());
    }
    core.refuse(Where::Block, codes::P2090::scaling_factor_of_is_out_of_range(&factor))
}

/// Axes that cycle 26 scales about a centre given before: it goes, or stays.
fn other_centers(core: &Core<'_>, next: &mut Transformation, kept: [f64; 3], named: [bool; 3]) {
    let keep = core.job.settings.control.klartext_readings.keep_scaling_center;
    for axis in AxisSet::MAIN.iter() {
        let i = axis.index();
        if named[i] || kept[i] == 0.0 || next.axis_scale[i] == 1.0 {
            continue;
        }
        let what = if keep {
            next.scale_center[i] = kept[i];
            "the centre given before"
        } else {
            "the datum"
        };
        let fault = codes::K2809::this_cycle_26_names_no_centre(&axis.letter(), &what);
        core.say_here(fault.answer(Answer::key("control", "scaling_center")));
    }
}
