//! What a probe leaves behind, where what it does is left out: words, places, and which block measured last.

use crate::machine::AxisSet;
use crate::text::{Loc, Span};

/// A word that measures while the block moves.
#[derive(Debug, Clone, Copy)]
pub(super) struct ProbeWord {
    pub name: &'static str,
    pub span: Span,
    /// The block goes to its end whatever the probe does.
    pub whole_way: bool,
}

/// The words that measure in a block of moves; MEASA and MEAWA name an axis.
pub(super) fn word(name: &str, span: Span) -> Option<ProbeWord> {
    let (name, whole_way) = match name {
        "MEAS" => ("MEAS", false),
        "MEAW" => ("MEAW", true),
        "MEASA" => ("MEASA", false),
        "MEAWA" => ("MEAWA", true),
        _ => return None,
    };
    Some(ProbeWord { name, span, whole_way })
}

/// What has measured so far and is left out.
#[derive(Debug, Default)]
pub(super) struct Measured {
    /// The last block or cycle: its name and place.
    pub last: Option<(String, Loc)>,
    /// The last cycle.
    pub cycle: Option<(String, Loc)>,
}

/// Axes that stand where a probe left them, and the block.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touched {
    /// Each move has to name them.
    pub all: AxisSet,
    /// Each move but a rapid one has to name them.
    pub cuts: AxisSet,
    pub loc: Loc,
}
