//! Haas mills: Fanuc with program numbers of five digits and comments in any case.

use super::{Comments, Frame, MFunctions, ProgramName, SpindleWords, Target, fanuc::OWN, fanuc::TARGET as FANUC};

pub(super) const TARGET: Target = Target {
    name: "haas",
    about: "Haas mills (NGC and classic)",
    frame: Frame { name: ProgramName::Number { letter: b'O', digits: 5, most: 99_999 }, ..FANUC.frame },
    comments: Comments { upper: false, ..FANUC.comments },
    // How the largest speed is said on a mill is not confirmed.
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    m: MFunctions { own: OWN, ..FANUC.m },
    ..FANUC
};
