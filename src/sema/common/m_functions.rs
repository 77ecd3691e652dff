//! M functions that mean the same on every machine.

use crate::ir::Function;
use crate::ir::function::{Coolant, Spindle, Turn};

/// What the function of this number has the machine do.
pub fn standard(number: u32) -> Option<Function> {
    Some(match number {
        0 => Function::Stop,
        1 => Function::OptionalStop,
        2 | 30 => Function::End { rewind: number == 30 },
        3 => Function::Spindle(Spindle::Start(Turn::Clockwise)),
        4 => Function::Spindle(Spindle::Start(Turn::CounterClockwise)),
        5 => Function::Spindle(Spindle::Stop),
        7 => Function::Coolant(Coolant::Mist),
        8 => Function::Coolant(Coolant::Flood),
        9 => Function::Coolant(Coolant::Off),
        _ => return None,
    })
}

/// Functions in the order in which they act: what `ends` the program comes last, wherever it stands in the block.
pub fn end_last<M: Copy>(functions: &[M], ends: impl Fn(&M) -> bool + Copy) -> impl Iterator<Item = M> {
    let first = functions.iter().copied().filter(move |m| !ends(m));
    first.chain(functions.iter().copied().filter(move |m| ends(m)))
}
