//! What cycles 14, 20 and 270 say for the cycles behind them.
//!
//! Source: K 6.6; F B7 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Label as Also, codes};
use crate::sema::run::Where;

use super::cycle_definition::Open;
use super::cycles::call::Calling;
use super::cycles::data::{Contours, NamedContours, Values};
use super::cycles::{DefinedCycle, Setting};
use super::known::Known;
use super::labels::Label;
use super::{Core, Outcome, Reported};

/// Most contours that cycle 14 names.
const MOST_CONTOURS: usize = 14;

/// Does a number behind it name a parameter, not a label?
fn is_parameter(name: &str) -> bool {
    let name = name.to_ascii_uppercase();
    ["Q", "QL", "QR", "QS"].iter().any(|letters| name.ends_with(letters)) || name.chars().count() == 1
}

impl Contours {
    /// The definition of cycle 14, 20 or 270 is complete.
    pub(super) fn keep(&mut self, core: &Core<'_>, setting: Setting, open: &Open) -> Outcome {
        match setting {
            Setting::Contours => self.named = Known::Given(named(core, open)?),
            Setting::Pocket => self.pocket = Known::Given(values(core, open)?),
            Setting::Train => self.train = Known::Given(values(core, open)?),
        }
        Ok(())
    }

    /// The contours that a cycle takes.
    pub(super) fn taken(&self, core: &Core<'_>, cycle: &DefinedCycle, calling: Calling) -> Outcome<Rc<NamedContours>> {
        let fault = match &self.named {
            _ if calling.placed() => codes::P9010::contour_at_places_of_pattern(),
            Known::Lost => return Err(Reported),
            Known::Nothing => codes::K2952::no_contour_is_named(),
            Known::Given(named) if named.program == core.running_program() => return Ok(Rc::clone(named)),
            Known::Given(_) => codes::P9010::contour_whose_label_stands_in_another_program(),
        };
        cycle.refuse(core, fault)
    }

    /// What is wrong with a contour, for all cycles that take it.
    pub(super) fn fault<T>(&self, core: &Core<'_>, label: &Label, what: &str, help: &str) -> Outcome<T> {
        let mut found = codes::K2951::contour(&label, &what).at(core.here.origin.loc);
        if let Known::Given(named) = &self.named {
            found = found.also(named.loc, Also::ContoursNamed);
        }
        core.report_cause(found.help(help));
        Err(Reported)
    }

    /// Why contours make no area: reported for the first of the cycles that take them.
    pub(super) fn no_area<T>(
        &mut self,
        core: &Core<'_>,
        cycle: &DefinedCycle,
        contours: &NamedContours,
        (what, help): (String, &str),
    ) -> Outcome<T> {
        let found = codes::K2955::cycle(&cycle.number, &what).at(core.here.origin.loc);
        let why = Some((contours.loc, what));
        if self.no_area != why {
            self.no_area = why;
            core.report(found.also(contours.loc, Also::ContoursNamed).help(help));
        }
        Err(Reported)
    }
}

fn named(core: &Core<'_>, open: &Open) -> Outcome<Rc<NamedContours>> {
    let count = open.contours.len();
    if !(1..=MOST_CONTOURS).contains(&count) {
        return core.refuse(Where::Block, codes::K2402::cycle_14_names_contours(&count, &MOST_CONTOURS));
    }
    let (labels, program, loc) = (open.contours.clone(), core.running_program(), core.here.origin.loc);
    Ok(Rc::new(NamedContours { labels, program, loc }))
}

fn values(core: &Core<'_>, open: &Open) -> Outcome<Rc<Values>> {
    let cycle = DefinedCycle::new(open, core.here.origin.loc, core.mm());
    cycle.all_are_set(core)?;
    Ok(Rc::new(Values { cycle, set: open.parameters.clone() }))
}

/// `CYCL DEF 14.1 CONTOUR LABEL1 /2 /"NAME"`: the name of the part is written in the language of the control.
pub(super) fn contour_labels(code: &str) -> Option<Vec<Label>> {
    let list = code.split_once('.').map_or("", |(_, rest)| rest.trim_start_matches(|c: char| c.is_ascii_digit()));
    // The name of the part: words of letters, the last one written together with its first label at most.
    let from = list.find(|c: char| !c.is_alphabetic() && !c.is_whitespace()).unwrap_or(list.len());
    let name = list[..from].split_whitespace().next_back().unwrap_or_default();
    if list[from..].starts_with(|c: char| c.is_ascii_digit()) && is_parameter(name) {
        return None;
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
            _ => return None,
        }
        rest = behind.trim_start_matches(['/', ' ', '\t']);
    }
    Some(labels)
}

/// Is the list of labels over, or does another one follow?
fn starts_another(rest: &str) -> bool {
    rest.is_empty() || rest.starts_with(['/', ' ', '\t'])
}
