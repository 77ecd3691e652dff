//! `[machine]`: the machine the program was written for.

use std::collections::BTreeMap;

use super::key::{Key, Kind, key};
use crate::machine::axis::{Axis, AxisSet};
use crate::machine::settings::{MachineKind, Settings};
use crate::machine::tree::{ConfigError, Node, Value};
use crate::machine::values::{
    axis, axis_names, flag, geometry_axes, is, named_axis, number, put, range, rotary_axes, table_of, text,
};

/// The keys of a file come in the order of the alphabet, so `axes` is known where others use its names.
pub const KEYS: &[Key] = &[
    key("kind", Kind::Choice(&["mill", "lathe"]), "lathe: turning technology on, power-on plane G18", |s, v| {
        put(&mut s.machine.kind, if is(v, "lathe") { MachineKind::Lathe } else { MachineKind::Mill })
    })
    .or(r#""mill""#),
    key(
        "geometry_axes",
        Kind::Texts,
        "names of the first, second and third geometry axis (MD 20050, MD 20080)",
        |s, v| put(&mut s.machine.geometry_axes, geometry_axes(v, &s.machine.axes)?),
    )
    .or(r#"["X", "Y", "Z"]"#),
    key(
        "axes",
        Kind::Free,
        "SINUMERIK: names of channel axes (MD 20080) and the axis that is printed, or \"leave-out\": B1 = \"B\"",
        |s, v| put(&mut s.machine.axes, axis_names(v)?),
    ),
    key("diameter_axis", Kind::Text, "axis programmed in diameters (MD 20100); empty for none", diameter_axis)
        .or(r#""""#),
    key("md20100", Kind::Text, "same as diameter_axis", diameter_axis),
    key("power_on_diameter", Kind::Flag, "diameter programming is on at the start (lathe)", |s, v| {
        put(&mut s.machine.power_on_diameter, flag(v))
    })
    .or("true"),
    key("limits", Kind::Free, "smallest and largest printed coordinate of an axis: X = [-10.0, 800.0]", |s, v| {
        for (name, node) in table_of(v) {
            s.machine.limits.insert(axis(name, node)?, range(node)?);
        }
        Ok(())
    }),
    key("kinematics", Kind::Choice(&["3axis"]), "kinematics of the machine", |s, v| {
        put(&mut s.machine.kinematics, text(v).to_owned())
    })
    .or(r#""3axis""#),
    key("reference_point", Kind::Free, "machine coordinates of the reference point (G74): X = 0.0", |s, v| {
        coordinates(&mut s.machine.reference_point, v)
    }),
    key(
        "after_tool_change",
        Kind::Free,
        "where a tool change leaves axes: the coordinate of the new tool in the work offset: Z = 250.0; machine = true: in machine coordinates",
        after_tool_change,
    ),
    key("swivel_retract", Kind::Free, "machine coordinates that CYCLE800 retracts to: Z = 0.0", |s, v| {
        coordinates(&mut s.machine.swivel_retract, v)
    }),
    key("swivel_retract_most", Kind::Free, "the same as far as possible along the tool (`_FR` 4): Z = 0.0", |s, v| {
        coordinates(&mut s.machine.swivel_retract_most, v)
    }),
    key(
        "tilt_axes",
        Kind::Texts,
        "rotary axes that tilt the working plane; fanuc and mazak turn them back by G0: [\"A\", \"C\"]",
        |s, v| put(&mut s.machine.tilt_axes, tilt_axes(v)?),
    )
    .or("[]"),
    key(
        "swivel_record",
        Kind::Text,
        "sinumerik: name of the swivel record in the CYCLE800 that is printed; empty for the only one",
        |s, v| put(&mut s.machine.swivel_record, Some(swivel_record(v)?)),
    )
    .or_warn(r#""""#),
    key("fixed_point", Kind::Free, "machine coordinates of the fixed point (G75): Z = 0.0", |s, v| {
        coordinates(&mut s.machine.fixed_point[0], v)
    }),
    key("fixed_point_2", Kind::Free, "the same of the second fixed point (G75 FP=2)", |s, v| {
        coordinates(&mut s.machine.fixed_point[1], v)
    }),
    key("fixed_point_3", Kind::Free, "the same of the third fixed point (G75 FP=3)", |s, v| {
        coordinates(&mut s.machine.fixed_point[2], v)
    }),
    key("fixed_point_4", Kind::Free, "the same of the fourth fixed point (G75 FP=4)", |s, v| {
        coordinates(&mut s.machine.fixed_point[3], v)
    }),
    key(
        "rotary_axis",
        Kind::Text,
        "SINUMERIK: axis that turns the workpiece about Z under TRANSMIT and TRACYL",
        |s, v| put(&mut s.machine.rotary_axis, rotary_axis(v)?),
    )
    .or(r#""C""#),
    key("modulo", Kind::Texts, "SINUMERIK: rotary axes that count modulo 360 degrees", |s, v| {
        put(&mut s.machine.modulo, rotary_axes(v)?)
    })
    .or("[]"),
];

fn rotary_axis(node: &Node) -> Result<Axis, ConfigError> {
    let axis = axis(text(node), node)?;
    if axis.is_rotary() { Ok(axis) } else { Err(node.fail("the axis that turns the workpiece is A, B or C")) }
}

fn tilt_axes(node: &Node) -> Result<AxisSet, ConfigError> {
    let Value::List(items) = &node.value else { return Err(node.fail("needs a list of axes")) };
    let mut axes = AxisSet::EMPTY;
    for item in items {
        let axis = axis(text(item), item)?;
        if !axis.is_rotary() {
            return Err(item.fail("the axes that tilt the working plane are A, B and C"));
        }
        axes.insert(axis);
    }
    Ok(axes)
}

/// It stands between quotes in the output.
fn swivel_record(node: &Node) -> Result<String, ConfigError> {
    const LONGEST: usize = 32;
    let name = text(node);
    let fine = name.len() <= LONGEST && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
    if fine {
        Ok(name.to_owned())
    } else {
        Err(node.fail("the name of a swivel record is letters, digits, `_` and `-`"))
    }
}

fn diameter_axis(settings: &mut Settings, node: &Node) -> Result<(), ConfigError> {
    let name = text(node);
    let known = &settings.machine.axes;
    settings.machine.diameter_axis = if name.is_empty() { None } else { Some(named_axis(name, node, known)?) };
    Ok(())
}

/// `{ Z = 250.0, machine = true }`
fn after_tool_change(settings: &mut Settings, node: &Node) -> Result<(), ConfigError> {
    let after = &mut settings.machine.after_tool_change;
    for (name, node) in table_of(node) {
        if name == "machine" {
            if !matches!(node.value, Value::Flag(_)) {
                return Err(node.fail("`machine` is true or false"));
            }
            after.machine = flag(node);
            continue;
        }
        let value = number(node).filter(|v| v.is_finite()).ok_or_else(|| node.fail("a position is a number"))?;
        after.at.insert(axis(name, node)?, value);
    }
    Ok(())
}

fn coordinates(into: &mut BTreeMap<Axis, f64>, node: &Node) -> Result<(), ConfigError> {
    for (name, node) in table_of(node) {
        into.insert(axis(name, node)?, number(node).ok_or_else(|| node.fail("needs a number"))?);
    }
    Ok(())
}
