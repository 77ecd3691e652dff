//! Frames in formulas: the functions that make them, their components, and MODAXVAL.
//!
//! Source: S 4.7 and 5.7 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Fault, codes};
use crate::machine::Axis;

use super::frames::{Component, FrameValue};
use super::value::{Val, whole};

/// The value of the function `name`; lengths count in `unit` mm, and the working plane turns about `third`.
pub(super) fn frame_function(name: &str, args: &[Val], unit: f64, third: Axis) -> Result<Val, Fault> {
    let made = match name {
        "CTRANS" => FrameValue::shifted(&axis_pairs(args, unit)?),
        "CFINE" => FrameValue::fine(&axis_pairs(args, unit)?),
        "CROT" => FrameValue::rotated(triple(args, 0.0)?),
        "CSCALE" => {
            let scale = triple(args, 1.0)?;
            if scale.contains(&0.0) {
                return Err(codes::S2034::scaling_factor_is_0());
            }
            FrameValue::scaled(scale)
        }
        "CMIRROR" => mirrored(args)?,
        "CRPL" => rotated_in_plane(args, third)?,
        "INVFRAME" => match args {
            [Val::Frame(inner)] => inner.inverse().ok_or_else(codes::S2034::frame_cannot_be_inverted)?,
            _ => return Err(codes::S2021::invframe_takes_frame()),
        },
        "MODAXVAL" => {
            let [_, value] = args else { return Err(codes::S2021::modaxval_takes_axis()) };
            let Some(v) = value.number() else { return Err(codes::P2024::modaxval_takes_axis()) };
            return Ok(Val::Real(v - 360.0 * libm::floor(v / 360.0)));
        }
        // SET and REP
        _ => return Err(codes::P2024::fills_array(&name)),
    };
    Ok(Val::Frame(Rc::new(made)))
}

/// `X, 10, Y, 20`
fn axis_pairs(args: &[Val], unit: f64) -> Result<Vec<(Axis, f64)>, Fault> {
    let mut pairs = Vec::new();
    for pair in args.chunks(2) {
        let [Val::Axis(axis), value] = pair else { return Err(codes::S2021::axes_and_values_follow_each_other()) };
        let value = value.as_number()?;
        // The shift of an axis that is left out moves nothing.
        let Some(axis) = axis.axis else { continue };
        pairs.push((axis, value * if axis.is_rotary() { 1.0 } else { unit }));
    }
    Ok(pairs)
}

fn triple(args: &[Val], neutral: f64) -> Result<[f64; 3], Fault> {
    let mut values = [neutral; 3];
    for pair in args.chunks(2) {
        let [Val::Axis(axis), value] = pair else { return Err(codes::S2021::axes_values_follow_each_other()) };
        let value = value.as_number()?;
        match axis.axis.and_then(|axis| values.get_mut(axis.index())) {
            Some(place) => *place = value,
            None => return Err(codes::S2031::is_no_geometry_axis_2(&axis.text())),
        }
    }
    Ok(values)
}

fn mirrored(args: &[Val]) -> Result<FrameValue, Fault> {
    let mut mirror = [false; 3];
    for value in args {
        match value {
            Val::Axis(named) if named.axis.is_none_or(Axis::is_main) => {
                if let Some(axis) = named.axis {
                    mirror[axis.index()] = true;
                }
            }
            // A number behind the axis does not matter.
            other if other.number().is_some() => {}
            _ => return Err(codes::S2021::cmirror_takes_geometry_axes()),
        }
    }
    Ok(FrameValue::mirrored(mirror))
}

/// `CRPL(n, angle)`: 0 the working plane, 1 about Z, 2 about Y, 3 about X.
fn rotated_in_plane(args: &[Val], third: Axis) -> Result<FrameValue, Fault> {
    let [plane, angle] = args else { return Err(codes::S2021::crpl_takes_plane()) };
    let angle = angle.as_number()?;
    let about = match plane.number().and_then(whole) {
        Some(0) => third.index(),
        Some(1) => 2,
        Some(2) => 1,
        Some(3) => 0,
        _ => return Err(codes::S2021::plane_of_crpl_is_0_to_3()),
    };
    let mut angles = [0.0; 3];
    if let Some(place) = angles.get_mut(about) {
        *place = angle;
    }
    Ok(FrameValue::rotated(angles))
}

impl FrameValue {
    /// `F[X,TR]`; shifts count in `unit` mm.
    pub(super) fn read_component(&self, args: &[Val], unit: f64) -> Result<Val, Fault> {
        let (axis, component) = frame_place(args)?;
        let axis = axis.ok_or_else(codes::P2023::frame_of_axis_that_is_left_out)?;
        let value = self.component(axis, component).ok_or_else(codes::S2034::this_chain_of_rotations)?;
        Ok(Val::Real(value / component_unit(axis, component, unit)))
    }

    pub(super) fn write_component(&mut self, args: &[Val], value: &Val, unit: f64) -> Result<(), Fault> {
        let (axis, component) = frame_place(args)?;
        let value = value.as_number()?;
        // The frame of an axis that is left out moves nothing.
        let Some(axis) = axis else { return Ok(()) };
        if self.set_component(axis, component, value * component_unit(axis, component, unit)) {
            return Ok(());
        }
        Err(codes::S2034::this_component_cannot_be_set())
    }
}

/// Millimetres, or degrees, in the unit of a component of a frame.
pub(super) fn component_unit(axis: Axis, component: Component, unit: f64) -> f64 {
    match component {
        Component::Shift | Component::Fine if !axis.is_rotary() => unit,
        _ => 1.0,
    }
}

/// A component of a frame: `[X,TR]`. No axis is one that the output does not have.
pub(super) fn frame_place(args: &[Val]) -> Result<(Option<Axis>, Component), Fault> {
    let found = match args {
        [Val::Axis(named), Val::Text(name)] => {
            std::str::from_utf8(name).ok().and_then(Component::of).map(|component| (named.axis, component))
        }
        _ => None,
    };
    found.ok_or_else(codes::S2031::component_of_frame_is_axis)
}
