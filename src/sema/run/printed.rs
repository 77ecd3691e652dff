//! What is printed by a number of its own: each printed work offset, and each printed tool, stands for one of the program.

use std::cell::RefCell;

use crate::machine::tools::ToolKey;
use crate::text::Loc;

/// What the program calls a work offset, and how the configuration names another one for it.
#[derive(Debug, Clone, Copy)]
pub enum OffsetName<'a> {
    /// A word, and whether `[datums]` maps it.
    Word { word: &'a str, mapped: bool },
    /// A row of a preset table, and whether `[datums] preset` maps it.
    Preset { row: u32, mapped: bool },
    /// A word that no configuration maps.
    Fixed(&'a str),
}

impl OffsetName<'_> {
    pub(super) fn said(self) -> String {
        match self {
            OffsetName::Word { word, .. } | OffsetName::Fixed(word) => word.to_owned(),
            OffsetName::Preset { row, .. } => format!("preset {row}"),
        }
    }

    pub(super) fn is_mapped(self) -> bool {
        match self {
            OffsetName::Word { mapped, .. } | OffsetName::Preset { mapped, .. } => mapped,
            OffsetName::Fixed(_) => false,
        }
    }

    /// The line of `[datums]` that maps it.
    pub(super) fn key(self) -> String {
        match self {
            OffsetName::Word { word, .. } | OffsetName::Fixed(word) => word.to_owned(),
            OffsetName::Preset { row, .. } => format!("preset.{row}"),
        }
    }
}

/// The work offsets that were printed, each with the name and the place that it was first printed for.
#[derive(Debug, Default)]
pub struct PrintedOffsets {
    pub(super) printed: Vec<Printed>,
    /// Number of the one that is selected.
    pub(super) selected: Option<u8>,
    /// Those that were proposed for a name without one.
    pub(super) proposed: Vec<(String, u8)>,
}

#[derive(Debug)]
pub(super) struct Printed {
    pub number: u8,
    pub said: String,
    /// The key that maps it, if one does.
    pub key: Option<String>,
    pub at: Loc,
    /// A move counted from it.
    pub used: bool,
}

/// The tools that were printed: as what, and which they are to the program.
#[derive(Debug, Default)]
pub struct PrintedTools(pub(super) RefCell<Vec<(u32, ToolKey, Loc)>>);
