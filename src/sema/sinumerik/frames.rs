//! Frame values: shift, fine shift, rotation, scale and mirror, and their chains.
//!
//! `v = R · S · M · v' + shift + fine`; `A : B` applies B first. Source: S 4 (docs/sources.md).

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};

use crate::geo::Deg;
use crate::ir::Frame;
use crate::machine::axis::{AXES, Axis};

/// A frame as the control keeps it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FrameValue {
    pub shift: [f64; AXES],
    pub fine: [f64; AXES],
    linear: Matrix3<f64>,
    /// Angles about X, Y and Z, factors and mirrored axes, while the linear part is made of these alone.
    parts: Option<Parts>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Parts {
    angles: [f64; 3],
    scale: [f64; 3],
    mirror: [bool; 3],
}

const PLAIN: Parts = Parts { angles: [0.0; 3], scale: [1.0; 3], mirror: [false; 3] };

impl Default for FrameValue {
    fn default() -> FrameValue {
        FrameValue { shift: [0.0; AXES], fine: [0.0; AXES], linear: Matrix3::identity(), parts: Some(PLAIN) }
    }
}

/// Largest shift in mm and largest factor that a frame can have.
const MOST_SHIFT: f64 = 1e9;
const MOST_SCALE: f64 = 1e6;

/// Elements of a rotation that are smaller come from rounding.
const UPRIGHT: f64 = 1e-12;

/// A component of a frame: `[X,TR]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Component {
    Shift,
    Fine,
    Rotation,
    Scale,
    Mirror,
}

impl Component {
    pub fn of(name: &str) -> Option<Component> {
        Some(match name {
            "TR" => Component::Shift,
            "FI" => Component::Fine,
            "RT" => Component::Rotation,
            "SC" => Component::Scale,
            "MI" => Component::Mirror,
            _ => return None,
        })
    }
}

impl FrameValue {
    pub fn shifted(values: &[(Axis, f64)]) -> FrameValue {
        let mut frame = FrameValue::default();
        for (axis, value) in values {
            frame.shift[axis.index()] = *value;
        }
        frame
    }

    pub fn fine(values: &[(Axis, f64)]) -> FrameValue {
        let mut frame = FrameValue::default();
        for (axis, value) in values {
            frame.fine[axis.index()] = *value;
        }
        frame
    }

    /// Turned as the columns of `linear` say, with its zero point `at`.
    pub fn placed(linear: Matrix3<f64>, at: Vector3<f64>) -> FrameValue {
        let upright = (linear - Matrix3::identity()).iter().all(|v| v.abs() < UPRIGHT);
        let (linear, parts) = if upright { (Matrix3::identity(), Some(PLAIN)) } else { (linear, None) };
        let mut frame = FrameValue { linear, parts, ..FrameValue::default() };
        for (place, value) in frame.shift.iter_mut().zip(at.iter()) {
            *place = *value;
        }
        frame
    }

    /// Angles about X, Y, Z in degrees: Z first, then the new Y, then the new X (MD 10600 = 1).
    pub fn rotated(angles: [f64; 3]) -> FrameValue {
        FrameValue::of_parts(Parts { angles, ..PLAIN })
    }

    pub fn scaled(scale: [f64; 3]) -> FrameValue {
        FrameValue::of_parts(Parts { scale, ..PLAIN })
    }

    pub fn mirrored(mirror: [bool; 3]) -> FrameValue {
        FrameValue::of_parts(Parts { mirror, ..PLAIN })
    }

    fn of_parts(parts: Parts) -> FrameValue {
        FrameValue { linear: linear(&parts), parts: Some(parts), ..FrameValue::default() }
    }

    /// `self : inner`
    pub fn chain(&self, inner: &FrameValue) -> FrameValue {
        let moved = self.linear * Vector3::new(inner.total(0), inner.total(1), inner.total(2));
        let mut shift = [0.0; AXES];
        for (i, value) in shift.iter_mut().enumerate() {
            *value = self.shift[i] + if i < 3 { moved[i] } else { inner.total(i) };
        }
        let parts = match (self.parts, inner.parts) {
            (Some(outer), Some(inner)) if outer == PLAIN => Some(inner),
            (Some(outer), Some(inner)) if inner == PLAIN => Some(outer),
            (Some(outer), Some(inner)) => joined(&outer, &inner),
            _ => None,
        };
        FrameValue { shift, fine: self.fine, linear: self.linear * inner.linear, parts }
    }

    /// A shift in the frame, kept as the additive part (MD 24000 = 1).
    pub fn translated(&self, values: &[(Axis, f64)]) -> FrameValue {
        let moved = self.chain(&FrameValue::shifted(values));
        let mut made = self.clone();
        for i in 0..AXES {
            made.fine[i] = self.fine[i] + (moved.shift[i] - self.shift[i]);
        }
        made
    }

    fn total(&self, i: usize) -> f64 {
        self.shift[i] + self.fine[i]
    }

    /// Its axes X, Y and Z as columns; longer or shorter than 1 under a scale.
    pub fn axes(&self) -> &Matrix3<f64> {
        &self.linear
    }

    /// Its zero point in X, Y and Z.
    pub fn origin(&self) -> Vector3<f64> {
        Vector3::new(self.total(0), self.total(1), self.total(2))
    }

    /// Does it turn, scale and mirror nothing?
    pub fn is_shift(&self) -> bool {
        self.linear == Matrix3::identity()
    }

    /// The frame with which `self` undoes itself.
    pub fn inverse(&self) -> Option<FrameValue> {
        let linear = self.linear.try_inverse()?;
        let back = linear * Vector3::new(self.total(0), self.total(1), self.total(2));
        let mut shift = [0.0; AXES];
        for (i, value) in shift.iter_mut().enumerate() {
            *value = if i < 3 { -back[i] } else { -self.total(i) };
        }
        let parts = self.parts.filter(|parts| *parts == PLAIN);
        Some(FrameValue { shift, fine: [0.0; AXES], linear, parts })
    }

    /// The frame for coordinates; `None` if it cannot be inverted or is not finite.
    pub fn map(&self) -> Option<Frame> {
        let mut shift = [0.0; AXES];
        for (i, value) in shift.iter_mut().enumerate() {
            *value = self.total(i);
        }
        let sizes = [0, 1, 2].map(|i| self.linear.column(i).norm());
        let sensible = shift.iter().all(|v| v.abs() <= MOST_SHIFT)
            && sizes.iter().all(|s| (1.0 / MOST_SCALE..=MOST_SCALE).contains(s));
        if !sensible {
            return None;
        }
        Frame::new(self.linear, shift)
    }

    /// A component; `None` if the frame is a chain that has no such components.
    pub fn component(&self, axis: Axis, component: Component) -> Option<f64> {
        let i = axis.index();
        Some(match component {
            Component::Shift => self.shift[i],
            Component::Fine => self.fine[i],
            Component::Rotation if i >= 3 => 0.0,
            Component::Scale if i >= 3 => 1.0,
            Component::Mirror if i >= 3 => 0.0,
            Component::Rotation => self.parts?.angles[i],
            Component::Scale => self.parts?.scale[i],
            Component::Mirror => f64::from(u8::from(self.parts?.mirror[i])),
        })
    }

    /// Sets a component; false if that cannot be done.
    pub fn set_component(&mut self, axis: Axis, component: Component, value: f64) -> bool {
        let i = axis.index();
        match component {
            Component::Shift => self.shift[i] = value,
            Component::Fine => self.fine[i] = value,
            _ if i >= 3 => return false,
            other => {
                let Some(mut parts) = self.parts else { return false };
                match other {
                    Component::Rotation => parts.angles[i] = value,
                    Component::Scale => parts.scale[i] = value,
                    _ => parts.mirror[i] = value != 0.0,
                }
                if parts.scale.contains(&0.0) {
                    return false;
                }
                self.parts = Some(parts);
                self.linear = linear(&parts);
            }
        }
        true
    }
}

/// The parts of `outer : inner` where they are again angles, factors and mirrors about the same axes.
fn joined(outer: &Parts, inner: &Parts) -> Option<Parts> {
    let about = |parts: &Parts, i: usize| (0..3).all(|j| j == i || parts.angles[j] == 0.0);
    // Mirrors and factors of the outer frame act behind the inner rotation.
    if inner.angles == [0.0; 3] {
        let mut parts = *outer;
        for i in 0..3 {
            parts.scale[i] *= inner.scale[i];
            parts.mirror[i] ^= inner.mirror[i];
        }
        return Some(parts);
    }
    let even = outer.scale == [1.0; 3] && outer.mirror == [false; 3];
    let axis = (0..3).find(|i| about(outer, *i) && about(inner, *i))?;
    if !even {
        return None;
    }
    let mut parts = *inner;
    parts.angles[axis] += outer.angles[axis];
    Some(parts)
}

fn linear(parts: &Parts) -> Matrix3<f64> {
    let mut matrix = Matrix3::identity();
    let turn = |i: usize| {
        let (sin, cos) = Deg(parts.angles[i]).sin_cos();
        match i {
            0 => Matrix3::new(1.0, 0.0, 0.0, 0.0, cos, -sin, 0.0, sin, cos),
            1 => Matrix3::new(cos, 0.0, sin, 0.0, 1.0, 0.0, -sin, 0.0, cos),
            _ => Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0),
        }
    };
    for i in [2, 1, 0] {
        if parts.angles[i] != 0.0 {
            matrix *= turn(i);
        }
    }
    for i in 0..3 {
        let factor = parts.scale[i] * if parts.mirror[i] { -1.0 } else { 1.0 };
        if factor != 1.0 {
            for row in 0..3 {
                matrix[(row, i)] *= factor;
            }
        }
    }
    matrix
}

/// The frames of the program: what is chained to the workpiece system of the blocks.
#[derive(Debug, Clone, Default)]
pub(super) struct Frames {
    programmable: FrameValue,
    /// The plane of CYCLE800, or its shift.
    swivelled: FrameValue,
    /// Work offsets that the program wrote, by number (0 is G500).
    written: BTreeMap<u8, FrameValue>,
    /// The work offset in force, where the program wrote it.
    settable: Option<FrameValue>,
    /// Number of the work offset in force.
    offset: u8,
}

/// What SAVE keeps of them.
#[derive(Debug, Clone)]
pub(super) struct SavedFrames {
    pub programmable: FrameValue,
    pub settable: Option<FrameValue>,
}

impl Frames {
    pub fn programmable(&self) -> &FrameValue {
        &self.programmable
    }

    pub fn programmable_mut(&mut self) -> &mut FrameValue {
        &mut self.programmable
    }

    pub fn set_programmable(&mut self, frame: FrameValue) {
        self.programmable = frame;
    }

    pub fn settable(&self) -> Option<&FrameValue> {
        self.settable.as_ref()
    }

    pub fn set_settable(&mut self, frame: Option<FrameValue>) {
        self.settable = frame;
    }

    /// Number of the work offset in force: 0 is G500, 1 is G54.
    pub fn offset(&self) -> u8 {
        self.offset
    }

    pub fn select_offset(&mut self, number: u8) {
        self.offset = number;
    }

    /// The values that the program gave a work offset.
    pub fn written(&self, number: u8) -> Option<&FrameValue> {
        self.written.get(&number)
    }

    pub fn write(&mut self, number: u8, frame: FrameValue) {
        self.written.insert(number, frame);
    }

    /// The plane of CYCLE800, or its shift, between the work offset and the programmable frame.
    pub fn swivelled(&self) -> &FrameValue {
        &self.swivelled
    }

    pub fn set_swivelled(&mut self, frame: FrameValue) {
        self.swivelled = frame;
    }

    /// Does CYCLE800 turn the plane? Positions count in it then, and not in the workpiece.
    pub fn is_tilted(&self) -> bool {
        !self.swivelled.is_shift()
    }

    /// Where the plane of CYCLE800 lies in the workpiece.
    pub fn plane(&self) -> FrameValue {
        match &self.settable {
            Some(outer) => outer.chain(&self.swivelled),
            None => self.swivelled.clone(),
        }
    }

    /// From programmed coordinates to those of the workpiece, or of the plane while that is turned.
    pub fn of_positions(&self) -> FrameValue {
        if self.is_tilted() {
            return self.programmable.clone();
        }
        let inner = self.swivelled.chain(&self.programmable);
        match &self.settable {
            Some(outer) => outer.chain(&inner),
            None => inner,
        }
    }

    pub fn saved(&self) -> SavedFrames {
        SavedFrames { programmable: self.programmable.clone(), settable: self.settable.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Pos;

    fn at(frame: &FrameValue, x: f64, y: f64, z: f64) -> [f64; 3] {
        let mut p = Pos::UNKNOWN;
        p.set(Axis::X, x);
        p.set(Axis::Y, y);
        p.set(Axis::Z, z);
        let p = frame.map().unwrap().apply(&p);
        [Axis::X, Axis::Y, Axis::Z].map(|axis| (p.get(axis).unwrap() * 1e4).round() / 1e4)
    }

    #[test]
    fn worked_examples() {
        let t = FrameValue::shifted(&[(Axis::X, 40.0), (Axis::Y, 30.0)]);
        let r = FrameValue::rotated([0.0, 0.0, 30.0]);
        assert_eq!(at(&t.chain(&r), 20.0, 0.0, 0.0), [57.3205, 40.0, 0.0]);
        assert_eq!(at(&r.chain(&t), 20.0, 0.0, 0.0), [36.9615, 55.9808, 0.0]);
        let rpy = FrameValue::rotated([30.0, 20.0, 10.0]);
        assert_eq!(at(&rpy, 10.0, 0.0, 0.0), [9.2542, 1.6318, -3.4202]);
        assert_eq!(at(&rpy, 0.0, 10.0, 0.0), [0.1803, 8.8256, 4.6985]);
        assert_eq!(at(&rpy, 0.0, 0.0, 10.0), [3.7852, -4.4097, 8.138]);
        let chain = FrameValue::shifted(&[(Axis::X, 10.0)])
            .chain(&FrameValue::rotated([0.0, 0.0, 90.0]))
            .chain(&FrameValue::scaled([2.0, 1.0, 1.0]))
            .chain(&FrameValue::mirrored([false, true, false]));
        assert_eq!(at(&chain, 5.0, 3.0, 0.0), [13.0, 10.0, 0.0]);
        assert_eq!(chain.component(Axis::Z, Component::Rotation), Some(90.0));
    }

    #[test]
    fn inverse() {
        let frame = FrameValue::shifted(&[(Axis::X, 10.0)]).chain(&FrameValue::rotated([0.0, 0.0, 30.0]));
        assert_eq!(at(&frame.chain(&frame.inverse().unwrap()), 1.0, 2.0, 3.0), [1.0, 2.0, 3.0]);
    }
}
