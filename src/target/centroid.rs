//! Centroid mills: much as Fanuc, waits in seconds. A preview: what published post processors write.

use super::{
    Dwell, DwellUnit, FeedWords, Frame, Motion, Numbers, PathWords, ProgramName, SpindleWords, Target,
    fanuc::TARGET as FANUC,
};

/// As [`FANUC`] but for what its post processors write otherwise.
pub(super) const TARGET: Target = Target {
    name: "centroid",
    about: "Centroid mills (preview: after published post processors)",
    frame: Frame { name: ProgramName::Number { letter: b'O', digits: 5, most: 99_999 }, ..FANUC.frame },
    numbers: Numbers { zero: true, ..FANUC.numbers },
    // Neither G53 nor a feed per revolution is confirmed.
    motion: Motion { machine: None, rigid_tap: None, ..FANUC.motion },
    feed: FeedWords { per_revolution: None, ..FANUC.feed },
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    more_offsets: None,
    dwell: Dwell { unit: DwellUnit::Seconds, per_minute: false, ..FANUC.dwell },
    // Not confirmed.
    path: PathWords::NONE,
    tilt: None,
    ..FANUC
};
