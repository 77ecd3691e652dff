//! Mazak mills in EIA/ISO: Fanuc without percent signs around the program. A preview: what published post processors write.

use super::fanuc::{EULER, TAP, TARGET as FANUC};
use super::{EulerWords, Frame, Motion, RigidTap, SpindleWords, TapCycle, TapPitch, Target, TiltWords};

/// As [`FANUC`] but for its tapping cycles.
pub(super) const TARGET: Target = Target {
    name: "mazak",
    about: "Mazak mills in EIA/ISO (preview: after published post processors)",
    frame: Frame { first: None, last: None, ..FANUC.frame },
    motion: Motion {
        rigid_tap: Some(RigidTap::Cycle(TapCycle {
            ready: None,
            right: "G84.2",
            left: Some("G84.3"),
            pitch: TapPitch::PerRevolution,
            dwell: None,
            stays: false,
            meets: "the machine has to be set up so that each tap begins at the mark of the spindle",
            ..TAP
        })),
        ..FANUC.motion
    },
    more_offsets: None,
    tilt: Some(TiltWords::Euler(&EulerWords { mode: Some("P0"), ..EULER })),
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    ..FANUC
};
