//! What a probe leaves behind, where what it does is left out: words, places, and which block measured last.

use crate::diag::{Diagnostic, Label, codes};
use crate::ir::Frame;
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

impl Touched {
    /// A move to these axes, before it: those that stand where a probe left them have to be named.
    pub fn moves(
        left: &mut Option<Touched>,
        axes: AxisSet,
        rapid: bool,
        frame: &Frame,
        here: Loc,
    ) -> Option<Diagnostic> {
        let touched = left.take()?;
        let of = |axes: AxisSet| if axes.is_empty() { axes } else { hidden_with(frame, axes) };
        let (all, cuts) = (of(touched.all).without(axes), of(touched.cuts).without(axes));
        let missing = if rapid { all } else { all.union(cuts) };
        if missing.is_empty() {
            *left = (!all.union(cuts).is_empty()).then_some(Touched { all, cuts, ..touched });
            return None;
        }
        let letters: Vec<String> = missing.iter().map(|axis| axis.letter().to_string()).collect();
        let letters = letters.join(" and ");
        let found = codes::S9023::this_block_moves(&letters).at(here).also(touched.loc, Label::MeasuringLeftOut);
        Some(found.help(format!("program {letters} in this block, in absolute coordinates")))
    }
}

/// In a turned frame each axis of the program moves several of the machine.
pub(super) fn hidden_with(frame: &Frame, axes: AxisSet) -> AxisSet {
    if frame.is_shift() || axes.common(AxisSet::MAIN).is_empty() { axes } else { axes.union(AxisSet::MAIN) }
}
