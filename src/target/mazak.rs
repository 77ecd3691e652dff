//! Mazak mills in EIA/ISO: Fanuc without percent signs around the program. A preview: what published post processors write.

use super::{Frame, MFunctions, SpindleWords, Target, fanuc::OWN, fanuc::TARGET as FANUC};

pub(super) const TARGET: Target = Target {
    name: "mazak",
    about: "Mazak mills in EIA/ISO (preview: after published post processors)",
    frame: Frame { first: None, last: None, ..FANUC.frame },
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    m: MFunctions { own: OWN, ..FANUC.m },
    ..FANUC
};
