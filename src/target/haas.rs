//! Haas mills: Fanuc with program numbers of five digits and comments in any case.

use super::{Comments, Frame, ProgramName, SpindleWords, Target, fanuc::TARGET as FANUC};

pub(super) const TARGET: Target = Target {
    name: "haas",
    about: "Haas mills (NGC and classic)",
    frame: Frame { name: ProgramName::Number { letter: b'O', digits: 5, most: 99_999 }, ..FANUC.frame },
    comments: Comments { upper: false, ..FANUC.comments },
    // How the largest speed is said on a mill is not confirmed.
    offsets: &["G54", "G55", "G56", "G57", "G58", "G59", "G154 P1", "G154 P2", "G154 P3"],
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    ..FANUC
};
