//! Haas mills: Fanuc with program numbers of five digits and comments in any case.

use super::{Comments, Frame, MoreOffsets, ProgramName, SpindleWords, Target, fanuc::TARGET as FANUC};

pub(super) const TARGET: Target = Target {
    name: "haas",
    about: "Haas mills (NGC and classic)",
    frame: Frame { name: ProgramName::Number { letter: b'O', digits: 5, most: 99_999 }, ..FANUC.frame },
    comments: Comments { upper: false, ..FANUC.comments },
    // How the largest speed is said on a mill is not confirmed.
    more_offsets: Some(MoreOffsets { word: "G154 P", less: 6, most: 105 }),
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    ..FANUC
};
