//! Mazak mills in EIA/ISO: Fanuc without percent signs around the program. A preview: what published post processors write.

use super::{Frame, SpindleWords, Target, fanuc::TARGET as FANUC};

pub(super) const TARGET: Target = Target {
    name: "mazak",
    about: "Mazak mills in EIA/ISO (preview: after published post processors)",
    frame: Frame { first: None, last: None, ..FANUC.frame },
    more_offsets: None,
    spindle: SpindleWords { cutting_speed: None, ..FANUC.spindle },
    ..FANUC
};
