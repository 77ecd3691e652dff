//! What the target knows of how corners are taken, and what is wrong with it.

use crate::ir::Origin;
use crate::machine::{PathChoice, PathControl};

/// What the target knows of corners.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Corners {
    pub lathe: bool,
    pub printed: Option<PathControl>,
    /// The next move is made in a mode that does not bound its corners, or not as the program wants them; the block that asks
    /// for it, if one does.
    pub doubt: Option<(Option<Origin>, Doubt)>,
    pub told: bool,
}

/// What is wrong with a mode.
#[derive(Debug, Clone, Copy)]
pub(super) enum Doubt {
    /// Corners are passed without a bound.
    Unbounded,
    /// No word of the target says anything of corners, or none that holds at its start.
    Unsaid,
    /// Rounded off by so many mm at most where the program stops in them.
    NoStop(f64),
}

impl Corners {
    /// Has something to be told before a move?
    #[inline(always)]
    pub fn in_doubt(&self) -> bool {
        self.doubt.is_some()
    }

    /// Keeps what has to be told before the next move: the configuration chose `choice`, the program said `said`, and `mode` is
    /// printed.
    pub fn look_at(
        &mut self,
        choice: Option<PathChoice>,
        (said, mode): (Option<PathControl>, Option<PathControl>),
        origin: Option<&Origin>,
    ) {
        let doubt = match (mode, said) {
            _ if choice == Some(PathChoice::None) || self.told => None,
            (Some(PathControl::Within(mm)), Some(PathControl::Exact)) => {
                (!matches!(choice, Some(PathChoice::Within(_)))).then_some(Doubt::NoStop(mm))
            }
            (Some(PathControl::Exact | PathControl::Within(_) | PathControl::Before(_)), _) => None,
            (Some(PathControl::Unbounded), _) => Some(Doubt::Unbounded),
            // An answer that was refused.
            (None, None) if choice.is_some() => None,
            (None, _) => Some(Doubt::Unsaid),
        };
        self.doubt = doubt.map(|doubt| (origin.copied(), doubt));
    }
}
