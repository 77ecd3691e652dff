//! Values that the control keeps from one run to the next: those of global variables (GUD).
//!
//! What such a variable holds when the program begins is known only where `[variables]` says it. Until the program writes an
//! element, reading it is a guess, which is said. Source: S 5.1 (docs/sources.md).

use crate::text::Span;

use super::conversions::DEFINED;
use super::value::Val;
use super::vars::Var;
use super::{Core, Outcome};

impl Var {
    /// The values that the configuration says a global variable holds when the program begins.
    pub(super) fn with_kept_values(mut self, word: &str, core: &Core<'_>, span: Span) -> Outcome<Var> {
        let word = word.to_ascii_uppercase();
        let of_variable =
            |key: &str| key.strip_prefix(&word).is_some_and(|rest| rest.is_empty() || rest.starts_with('['));
        let said = core.job.settings.variables.range(word.clone()..).take_while(|(key, _)| key.starts_with(&word));
        for (key, value) in said.filter(|(key, _)| of_variable(key)) {
            let Some(element) = element_of(&self, &key[word.len()..]) else { continue };
            let value = Val::Real(*value).taken_as(self.kind, DEFINED, core, span)?;
            core.accept(span, value.keeps_limits(self.limits, [12160, 12160]))?;
            if let Some(place) = self.values.get_mut(element) {
                *place = value;
                self.kept.knows(element);
            }
        }
        Ok(self)
    }
}

/// The element that `[1,2]` names; the only one where nothing stands.
fn element_of(var: &Var, rest: &str) -> Option<usize> {
    if rest.is_empty() {
        return var.offset(&[]);
    }
    let inside = rest.strip_prefix('[')?.strip_suffix(']')?;
    let indices: Option<Vec<i32>> = inside.split(',').map(|index| index.trim().parse().ok()).collect();
    var.offset(&indices?)
}
