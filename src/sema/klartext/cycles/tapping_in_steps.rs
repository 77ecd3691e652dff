//! Cycle 209: rigid tapping that breaks the chip.

use crate::diag::codes;
use crate::ir::cycle::drilling::{Chip, Degression, Method, TapStep};
use crate::machine::Generation;
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Signature, Status};

use super::call::CycleCall;
use super::drilling::{ANGLE, BREAK_DEPTH, BREAK_WAY, Q201, Q239, TAPPING};
use super::{AT_SURFACE, Cut, CycleKind, Drilling, REMOVE, Row, SECOND, SET_UP, q};

/// Factor on the speed of the spindle on the way back.
const BACK_FACTOR: Name = Name::Q(403);

pub(super) const ROWS: &[Row] = &[Row {
    numbers: (209, 209),
    nature: CycleKind::Drilling(&Drilling {
        method: |call, cut| call.tapping_in_steps(cut),
        feed: None,
        dwell: None,
        requires: TAPPING,
    }),
    requires: TAPPING,
    signature: Signature {
        name: "CYCL DEF 209",
        what: "TAPPING WITH CHIP BREAKING",
        status: Status::Built,
        source: "HEIDENHAIN TNC 640 cycles, p. 102",
        parameters: &[
            SET_UP,
            Q201,
            Q239,
            AT_SURFACE,
            SECOND,
            q(BREAK_DEPTH, Kind::Length, "depth after which the chip is broken; 0 never").needed().unsigned(),
            q(
                BREAK_WAY,
                Kind::Number,
                "way back in pitches, with `[control] klartext = \"tnc426\"` a length; 0 out of the hole",
            )
            .needed()
            .unsigned(),
            q(ANGLE, Kind::Angle, "angle of the spindle before the cut").needed(),
            q(BACK_FACTOR, Kind::Number, "factor on the speed of the way back, 0.0001 to 10").default("1"),
        ],
    },
    form: REMOVE,
}];

impl CycleCall<'_> {
    /// As cycle 207; after every Q257 the tap goes back by Q256 pitches, or out to the set-up clearance.
    fn tapping_in_steps(&self, cut: Cut) -> Made<Method> {
        let (way, pitches) = (self.given.length(BREAK_DEPTH), self.given.or_zero(BREAK_WAY));
        let factor = self.given.number(BACK_FACTOR).unwrap_or(1.0);
        if !(0.0001..=10.0).contains(&factor) {
            return self.refuse(codes::P2090::factor_q403_is_not_0_0001(&factor));
        }
        if way > 0.0 && pitches == 0.0 && factor != 1.0 {
            return self.refuse(codes::P9010::q256_0_with_q403());
        }
        let mut tap = self.rigid_tapping(cut);
        tap.orient = Some(self.given.or_zero(ANGLE).rem_euclid(360.0));
        if way > 0.0 {
            // Older software counts Q256 in lengths.
            let old = self.settings.control.klartext == Generation::Tnc426;
            let back = if old { self.given.length(BREAK_WAY) } else { pitches * tap.lead.unwrap_or(0.0) };
            let chip = if pitches == 0.0 { Chip::Remove { ahead: 0.0 } } else { Chip::Break { back } };
            tap.step = Some(TapStep { way, degression: Degression::Plain { less: 0.0, least: 0.0 }, chip });
        }
        if let (true, Some(speed)) = (factor != 1.0, self.st.state.spindle.speed()) {
            tap.speed_in = Some(speed);
            tap.speed_out = Some(speed * factor);
            tap.speed_after = Some(speed);
        }
        Ok(Method::Tap(tap))
    }
}
