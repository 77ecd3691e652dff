//! What cycles 14, 20 and 270 say for the cycles behind them.
//!
//! Source: K 6.6; F B7 (docs/sources.md).

use std::rc::Rc;

use crate::diag::codes;
use crate::parser::klartext::ast::Block;

use super::cycle_definition::Open;
use super::cycles::call::Calling;
use super::cycles::data::{Kept, NamedContours, Values};
use super::cycles::{DefinedCycle, Setting};
use super::known::Known;
use super::labels::Label;
use super::{Outcome, Reported, Run};

/// Most contours that cycle 14 names.
const MOST_CONTOURS: usize = 14;

/// Does a number behind it name a parameter, not a label?
fn is_parameter(name: &str) -> bool {
    let name = name.to_ascii_uppercase();
    ["Q", "QL", "QR", "QS"].iter().any(|letters| name.ends_with(letters)) || name.chars().count() == 1
}

impl Run<'_> {
    // Definitions.

    /// `CYCL DEF 14.1 CONTOUR LABEL1 /2 /"NAME"`: the name of the part is written in the language of the control.
    pub(super) fn contour_labels(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let code = crate::text::decode::readable(block.span.of(text)).into_owned();
        let list = code.split_once('.').map_or("", |(_, rest)| rest.trim_start_matches(|c: char| c.is_ascii_digit()));
        // The name of the part: words of letters, the last one written together with its first label at most.
        let from = list.find(|c: char| !c.is_alphabetic() && !c.is_whitespace()).unwrap_or(list.len());
        let name = list[..from].split_whitespace().next_back().unwrap_or_default();
        if list[from..].starts_with(|c: char| c.is_ascii_digit()) && is_parameter(name) {
            return self.cycle_word(block.span, 14);
        }
        let mut labels = Vec::new();
        let mut rest = list[from..].trim_start_matches(['/', ' ', '\t']);
        while !rest.is_empty() {
            let (label, behind) = match rest.strip_prefix('"') {
                Some(name) => name.split_once('"').map(|(name, behind)| (Some(Label::Name(name.into())), behind)),
                None => {
                    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
                    Some((rest[..end].parse().ok().filter(|n| *n > 0).map(Label::Number), &rest[end..]))
                }
            }
            .unwrap_or((None, ""));
            match label {
                Some(label) if !labels.contains(&label) && starts_another(behind) => labels.push(label),
                _ => return self.cycle_word(block.span, 14),
            }
            rest = behind.trim_start_matches(['/', ' ', '\t']);
        }
        let open = self.open_cycle();
        open.contours.append(&mut labels);
        Ok(())
    }

    fn contour_geometry(&mut self, open: &Open) -> Outcome {
        if open.contours.is_empty() || open.contours.len() > MOST_CONTOURS {
            return self.core.refuse(
                self.core.block_span(),
                codes::K2402::cycle_14_names_contours(&open.contours.len(), &MOST_CONTOURS),
            );
        }
        let (labels, program, loc) = (open.contours.clone(), self.core.level().program, self.core.here.origin.loc);
        self.contours.named = Known::Given(Rc::new(NamedContours { labels, program, loc }));
        Ok(())
    }

    pub(super) fn keep_setting(&mut self, setting: Setting, open: &Open) -> Outcome {
        match setting {
            Setting::Contours => self.contour_geometry(open)?,
            Setting::Pocket => self.contours.pocket = Known::Given(self.values_of(open)?),
            Setting::Train => self.contours.train = Known::Given(self.values_of(open)?),
        }
        Ok(())
    }

    fn values_of(&mut self, open: &Open) -> Outcome<Rc<Values>> {
        let mm = self.core.level().frame.unit.mm();
        let cycle = DefinedCycle::new(open, self.core.here.origin.loc, mm);
        self.all_are_set(&cycle)?;
        Ok(Rc::new(Values { cycle, set: open.parameters.clone() }))
    }

    // What they say where a cycle runs.

    /// The contours that the cycle takes.
    pub(super) fn named_contours(&mut self, cycle: &DefinedCycle, calling: Calling) -> Outcome<Rc<NamedContours>> {
        if calling.placed() {
            return self.refuse_cycle(cycle, codes::P9010::contour_at_places_of_pattern());
        }
        let program = self.core.level().program;
        match &self.contours.named {
            Known::Lost => Err(Reported),
            Known::Nothing => self.refuse_cycle(cycle, codes::K2952::no_contour_is_named()),
            Known::Given(named) if named.program == program => Ok(Rc::clone(named)),
            Known::Given(_) => self.refuse_cycle(cycle, codes::P9010::contour_whose_label_stands_in_another_program()),
        }
    }

    /// The data of cycle 20.
    pub(super) fn pocket_data(&mut self, cycle: &DefinedCycle) -> Outcome<Kept> {
        let values = self.contours.pocket.clone();
        match self.kept(&values)? {
            Some(data) => Ok(data),
            None => self.refuse_cycle(cycle, codes::K2952::there_is_no_contour_data()),
        }
    }
}

/// Is the list of labels over, or does another one follow?
fn starts_another(rest: &str) -> bool {
    rest.is_empty() || rest.starts_with(['/', ' ', '\t'])
}
