//! Cycle 209: rigid tapping that breaks the chip.

use crate::diag::codes;
use crate::ir::cycle::drilling::{Chip, Degression, Method, TapStep};
use crate::machine::Generation;
use crate::sema::cycle::row::{Kind, Signature, Status};

use super::super::{Outcome, Run};
use super::DefinedCycle;
use super::drilling::{ANGLE, BREAK_DEPTH, BREAK_WAY, Q201, Q239};
use super::{AT_SURFACE, Cut, Drilling, Nature, Q, REMOVE, Row, SECOND, SET_UP, q};

/// Factor on the speed of the spindle on the way back.
const BACK_FACTOR: Q = Q(403);

pub(super) const ROWS: &[Row] = &[Row {
    numbers: (209, 209),
    nature: Nature::Drilling(&Drilling {
        method: |run, cycle, cut| run.tapping_in_steps(cycle, cut),
        feed: None,
        dwell: None,
        taps: true,
        own_spindle: false,
    }),
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
            q(BREAK_DEPTH, Kind::Length, "depth after which the chip is broken; 0 never").needed(),
            q(
                BREAK_WAY,
                Kind::Number,
                "way back in pitches, with `[control] klartext = \"tnc426\"` a length; 0 out of the hole",
            )
            .needed(),
            q(ANGLE, Kind::Angle, "angle of the spindle before the cut").needed(),
            q(BACK_FACTOR, Kind::Number, "factor on the speed of the way back, 0.0001 to 10").default("1"),
        ],
    },
    form: REMOVE,
}];

impl Run<'_> {
    /// As cycle 207; after every Q257 the tap goes back by Q256 pitches, or out to the set-up clearance.
    fn tapping_in_steps(&mut self, cycle: &DefinedCycle, cut: Cut) -> Outcome<Method> {
        let (way, pitches) = (self.cycle_length(cycle, BREAK_DEPTH)?, self.cycle_number(cycle, BREAK_WAY)?);
        if way < 0.0 || pitches < 0.0 {
            return self.refuse_value(cycle, codes::P2090::neither_q257_nor_q256_may_be_below(&way, &pitches));
        }
        let angle = self.cycle_number(cycle, ANGLE)?;
        let factor = if cycle.sets(BACK_FACTOR) { self.cycle_number(cycle, BACK_FACTOR)? } else { 1.0 };
        if !(0.0001..=10.0).contains(&factor) {
            return self.refuse_value(cycle, codes::P2090::factor_q403_is_not_0_0001(&factor));
        }
        // Older software counts Q256 in lengths.
        let old = self.job.settings.control.klartext == Generation::Tnc426;
        let back_way = if old { Some(self.cycle_length(cycle, BREAK_WAY)?) } else { None };
        if way > 0.0 && pitches == 0.0 && factor != 1.0 {
            return self.refuse_cycle(cycle, codes::P9010::q256_0_with_q403());
        }
        let Method::Tap(mut tap) = self.rigid_tapping(cycle, cut)? else { return Err(super::super::Reported) };
        tap.orient = Some(angle.rem_euclid(360.0));
        if way > 0.0 {
            let back = back_way.unwrap_or(pitches * tap.lead.unwrap_or(0.0));
            let chip = if pitches == 0.0 { Chip::Remove { ahead: 0.0 } } else { Chip::Break { back } };
            tap.step = Some(TapStep { way, degression: Degression::Plain { less: 0.0, least: 0.0 }, chip });
        }
        if let (true, Some(speed)) = (factor != 1.0, self.st.spindle.speed()) {
            tap.speed_in = Some(speed);
            tap.speed_out = Some(speed * factor);
            tap.speed_after = Some(speed);
        }
        Ok(Method::Tap(tap))
    }
}
