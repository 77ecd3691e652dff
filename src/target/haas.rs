//! Haas mills: Fanuc with program numbers of five digits and comments in any case.

use super::fanuc::{TAP, TARGET as FANUC};
use super::{Comments, Frame, MoreOffsets, Motion, ProgramName, RigidTap, SpindleWords, TapCycle, TapPitch, Target};

/// As [`FANUC`] but for program numbers, comments, tapping, more offsets and the cutting speed.
pub(super) const TARGET: Target = Target {
    name: "haas",
    about: "Haas mills (NGC and classic)",
    frame: Frame { name: ProgramName::Number { letter: b'O', digits: 5, most: 99_999 }, ..FANUC.frame },
    comments: Comments { upper: false, ..FANUC.comments },
    // M29 is not needed. What F is under a feed per revolution, and whether there is a dwell, is not confirmed.
    motion: Motion {
        rigid_tap: Some(RigidTap::Cycle(TapCycle {
            ready: None,
            pitch: TapPitch::PerMinute,
            dwell: None,
            factor: Some(b'J'),
            stays: false,
            meets: "setting 133 (REPT RIGID TAP) has to be on",
            ..TAP
        })),
        ..FANUC.motion
    },
    // How the largest speed is said on a mill is not confirmed.
    more_offsets: Some(MoreOffsets { word: "G154 P", less: 6, most: 105 }),
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    // Its words are others, and what their angles count from is not confirmed.
    tilt: None,
    ..FANUC
};
