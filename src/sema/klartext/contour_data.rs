//! What cycles 14, 20 and 270 say for the cycles behind them.
//!
//! Source: K 6.6; F B7 (docs/sources.md).

use std::rc::Rc;

use crate::diag::codes;
use crate::geo::overlay::Area;
use crate::ir::Frame;
use crate::parser::klartext::ast::Block;
use crate::text::Loc;

use super::cycle_definition::Open;
use super::cycles::{DefinedCycle, Q};
use super::labels::Label;
use super::{Outcome, Run};

/// Most contours that cycle 14 names.
const MOST_CONTOURS: usize = 14;

/// What cycles 14, 20 and 270 say for the cycles behind them.
#[derive(Debug, Default)]
pub(super) struct Contours {
    pub named: Known<NamedContours>,
    pub pocket: Known<Values>,
    pub train: Known<Values>,
    pub roughed: Known<Roughed>,
    /// Why the contours that a cycle 14 here names make no area, which was reported.
    pub no_area: Option<(Loc, String)>,
}

#[derive(Debug, Default)]
pub(super) enum Known<T> {
    #[default]
    Nothing,
    /// Its definition was refused, which was reported.
    Lost,
    Given(Rc<T>),
}

/// Cycle 14.
#[derive(Debug)]
pub(super) struct NamedContours {
    pub labels: Vec<Label>,
    /// Index of the program whose labels they are.
    pub program: usize,
    pub loc: Loc,
}

/// A definition with the values that it set.
#[derive(Debug)]
pub(super) struct Values {
    pub cycle: DefinedCycle,
    set: Vec<(u32, f64)>,
}

/// The last run of cycle 22.
#[derive(Debug)]
pub(super) struct Roughed {
    pub named: Rc<NamedContours>,
    /// As it was called.
    pub tool: Option<String>,
    pub radius: f64,
    /// What its calls and its table add to its own radius.
    pub oversize: f64,
    pub allowance: f64,
    /// What was cleared, and the system in which it was.
    pub area: Area,
    pub frame: Frame,
    pub pocket: Rc<Values>,
}

impl Contours {
    /// The definition of this cycle was refused.
    pub fn lose(&mut self, number: u32) {
        match number {
            14 => self.named = Known::Lost,
            20 => self.pocket = Known::Lost,
            _ => self.train = Known::Lost,
        }
    }
}

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

    pub(super) fn contour_geometry(&mut self, open: &Open) -> Outcome {
        if open.contours.is_empty() || open.contours.len() > MOST_CONTOURS {
            return self.refuse(
                self.block_span(),
                codes::K2402::cycle_14_names_contours(&open.contours.len(), &MOST_CONTOURS),
            );
        }
        let (labels, program, loc) = (open.contours.clone(), self.level().program, self.here.origin.loc);
        self.contours.named = Known::Given(Rc::new(NamedContours { labels, program, loc }));
        Ok(())
    }

    pub(super) fn contour_data(&mut self, open: &Open) -> Outcome {
        self.contours.pocket = Known::Given(self.values_of(open)?);
        Ok(())
    }

    pub(super) fn contour_train_data(&mut self, open: &Open) -> Outcome {
        self.contours.train = Known::Given(self.values_of(open)?);
        Ok(())
    }

    fn values_of(&mut self, open: &Open) -> Outcome<Rc<Values>> {
        let mm = self.level().frame.unit.mm();
        let cycle = DefinedCycle::new(open, self.here.origin.loc, mm);
        self.all_are_set(&cycle, &format!("cycle {}", open.number))?;
        Ok(Rc::new(Values { cycle, set: open.parameters.clone() }))
    }

    // What they say where a cycle runs.

    /// A parameter of cycle 20 or 270, which has to be what it was.
    pub(super) fn kept(&mut self, data: &Values, q: Q) -> Outcome<f64> {
        self.same_unit(&data.cycle)?;
        let now = self.cycle_number(&data.cycle, q)?;
        let set = data.set.iter().rev().find(|(number, _)| *number == q.0).map(|(_, value)| *value);
        match set {
            Some(set) if set != now => self.refuse_value(&data.cycle, codes::P2090::it_set_to_is_now(&q, &set, &now)),
            _ => Ok(now),
        }
    }

    pub(super) fn kept_length(&mut self, data: &Values, q: Q) -> Outcome<f64> {
        Ok(self.kept(data, q)? * self.level().frame.unit.mm())
    }

    pub(super) fn kept_unsigned(&mut self, data: &Values, q: Q) -> Outcome<f64> {
        let value = self.kept_length(data, q)?;
        if value >= 0.0 { Ok(value) } else { self.refuse_value(&data.cycle, codes::P2090::is_below_zero(&q, &value)) }
    }
}

/// Is the list of labels over, or does another one follow?
fn starts_another(rest: &str) -> bool {
    rest.is_empty() || rest.starts_with(['/', ' ', '\t'])
}
