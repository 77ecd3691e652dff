//! Values that the control keeps from one run to the next: those of global variables (GUD).
//!
//! What such a variable holds when the program begins is known only where `[variables]` says it. Until the program writes an
//! element, reading it is a guess, which is said. Source: S 5.1 (docs/sources.md).

use crate::diag::{Answer, Help, Label, codes};
use crate::parser::sinumerik::ast::TypeName;
use crate::text::Span;

use super::value::Val;
use super::vars::{Slot, Var};
use super::{Outcome, Run};

impl Run<'_> {
    /// The values that the configuration says a global variable holds when the program begins.
    pub(super) fn with_kept_values(&self, word: &str, mut var: Var, span: Span) -> Outcome<Var> {
        let word = word.to_ascii_uppercase();
        let of_variable =
            |key: &str| key.strip_prefix(&word).is_some_and(|rest| rest.is_empty() || rest.starts_with('['));
        let said = self
            .channel
            .core
            .job
            .settings
            .variables
            .range(word.clone()..)
            .take_while(|(key, _)| key.starts_with(&word));
        for (key, value) in said.filter(|(key, _)| of_variable(key)) {
            let Some(element) = element_of(&var, &key[word.len()..]) else { continue };
            let value = self.channel.core.converted_or(&Val::Real(*value), var.kind, span, [12390, 12160])?;
            self.channel.core.check_limits(&value, var.limits, [12160, 12160], span)?;
            if let Some(place) = var.values.get_mut(element) {
                *place = value;
                var.kept.knows(element);
            }
        }
        Ok(var)
    }

    /// Says that a value is read which the control keeps, and nothing here says.
    pub(super) fn warn_of_kept(&mut self, slot: Slot, indices: &[i32], span: Span) {
        let Some(var) = self.vars.get(slot) else { return };
        let Some(element) = var.offset(indices).or((!var.values.is_empty() && var.sizes.is_empty()).then_some(0))
        else {
            return;
        };
        let Some(name) = var.kept.open(element) else { return };
        let (kind, defined) = (var.kind, var.defined);
        let mut word = self.channel.core.symbols.name(name).to_owned();
        if !indices.is_empty() && !var_is_text(kind) {
            let indices: Vec<String> = indices.iter().map(ToString::to_string).collect();
            word = format!("{word}[{}]", indices.join(","));
        }
        let is_number = matches!(kind, TypeName::Bool | TypeName::Int | TypeName::Real);
        self.warned.unset.extend(is_number.then(|| word.clone()));
        if !self.warned.kept.insert((name, element)) {
            return;
        }
        let help: Help = if is_number {
            Answer::variable(&word, "the value that the control keeps in it")
                .help("set it in the program, or give the value that the control keeps in it under [variables]")
        } else {
            "set it in the program: what the control keeps in it is not known here".into()
        };
        let found = codes::P2021::is_read_before_program_sets(&word).at(self.channel.core.loc(span));
        self.channel.core.report(found.also(defined, Label::IsDefinedHere).help(help));
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

/// An index of it is a character.
fn var_is_text(kind: TypeName) -> bool {
    kind == TypeName::String
}
