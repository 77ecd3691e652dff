//! S, G26, G96 and G97.

use crate::diag::{Fault, codes};
use crate::ir::function::Spindle;
use crate::machine::Unit;
use crate::sema::common::spindle::{ModalSpindle, SpeedKind};
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};

use super::words::{Num, Words};

/// G26: highest speed.
pub(super) fn limit(spindle: &mut ModalSpindle, w: &Words) -> Made<Num> {
    let num = w.needed(b'S', "the highest speed in revolutions per minute")?;
    if num.value <= 0.0 {
        return refused(num.span, codes::T1007::speed_limit_is_above_zero());
    }
    spindle.set_limit(num.value);
    Ok(num)
}

/// G96 and G97: where S means something else now, the block says it. The S of the block.
pub(super) fn count(spindle: &mut ModalSpindle, kind: SpeedKind, w: &Words, unit: Unit) -> Made<Option<Num>> {
    let changes = spindle.count(kind);
    match w.get(b'S') {
        Some(num) => speed(spindle, num, unit).map(Some),
        None if changes => {
            let (name, form) = match kind {
                SpeedKind::Cutting => ("G96", "`G96 S180`"),
                SpeedKind::Turns => ("G97", "`G97 S800`"),
            };
            refused(Where::Block, codes::P1004::changes_what_s_means(&name, &form))
        }
        None => Ok(None),
    }
}

/// S.
pub(super) fn speed(spindle: &mut ModalSpindle, num: Num, unit: Unit) -> Made<Num> {
    if num.value < 0.0 {
        return refused(num.span, codes::O9002::speed(&num.value));
    }
    match spindle.kind() {
        None => return refused(num.span, codes::T2004::neither_g96_nor_g97_says_what_s()),
        Some(SpeedKind::Cutting) if unit == Unit::Inch => spindle.set_speed(num.value * Unit::FOOT),
        Some(_) => spindle.set_speed(num.value),
    }
    Ok(num)
}

/// What the spindle is told, and that its speed is kept under the limit.
pub(super) fn order(spindle: &ModalSpindle) -> Option<(Spindle, Option<Fault>)> {
    let speed = spindle.speed()?;
    if let Some(order) = spindle.cutting_speed() {
        return Some((order, None));
    }
    let kept = spindle.limited(speed);
    let lowered = (kept < speed).then(|| codes::T2005::speed_is_lowered_to_limit_of_g26(&speed, &kept));
    Some((Spindle::Speed(kept), lowered))
}

/// A thread is cut with a turning spindle, by the function of this number.
pub(super) fn turns(spindle: &ModalSpindle, number: u16) -> Result<(), Fault> {
    match spindle.turn() {
        Some(_) => Ok(()),
        None => Err(codes::P1004::spindle_does_not_turn_when_g_begins(&number)),
    }
}
