//! Where each block leads, behind its words.

use lsp_types::{InlayHint, InlayHintLabel, InlayHintTooltip, Range};

use crate::block_ends::{Stop, Way};
use crate::machine::Axis;
use crate::text::FileId;

pub use crate::block_ends::{coordinates, number};

use super::document::Document;

/// The hints of the blocks in `range`.
pub fn hints(document: &Document, range: Range) -> Vec<InlayHint> {
    let Some(study) = &document.study else { return Vec::new() };
    let (from, to) = (document.text.offset(range.start) as u32, document.text.offset(range.end) as u32);
    let first = study.survey.blocks.partition_point(|block| block.span.end < from);
    let blocks = study.survey.blocks[first..].iter().take_while(|block| block.span.start <= to);
    let moving = blocks.filter_map(|block| Some((block, study.seen.stop(FileId(0), block.words.start)?)));
    let hint = |(block, stop): (&super::study::BlockPlace, &Stop)| InlayHint {
        position: document.text.position(block.words.end),
        label: InlayHintLabel::String(stop.place(study.cut_off, study.seen.diameter)),
        kind: None,
        text_edits: None,
        tooltip: Some(InlayHintTooltip::String(tooltip(stop, study.seen.diameter))),
        padding_left: Some(true),
        padding_right: None,
        data: None,
    };
    moving.map(hint).collect()
}

fn tooltip(stop: &Stop, diameter: Option<Axis>) -> String {
    let system =
        if stop.machine { "coordinates of the machine" } else { "coordinates of the workpiece, before compensation" };
    let turned = turned(stop, diameter).map(|axis| format!("; {} is a diameter", axis.letter())).unwrap_or_default();
    let what = match stop.path {
        Way::Cycle => "where the cycle leaves the tool",
        Way::Corner => "the corner that is cut",
        Way::Rapid | Way::Line | Way::Arc | Way::Thread => "end of the block",
    };
    match stop.passes {
        1 => format!("{what}, in {system}{turned}"),
        passes => format!("{what} in its first pass of {passes}, in {system}{turned}"),
    }
}

/// The axis whose diameter is shown.
pub fn turned(stop: &Stop, diameter: Option<Axis>) -> Option<Axis> {
    diameter.filter(|axis| stop.end.get(*axis).is_some())
}
