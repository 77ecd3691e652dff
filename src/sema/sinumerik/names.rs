//! What the names in a program mean: words of the language, axes of the machine, numbers of G codes, macros.
//!
//! Source: S 1.3 and 5.6 (docs/sources.md).

use rustc_hash::FxHashMap;

use crate::diag::{Fault, codes};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::g_groups::GCodes;
use super::vars::Vars;
use super::vocabulary::{Meaning, Procedure, Refusal};
use super::{Channel, Outcome, dictionary, macros};

/// The words that a program may use.
pub(super) struct Names {
    /// By the number of the name, as far as somebody asked.
    known: Vec<Option<Meaning>>,
    pub vocabulary: &'static FxHashMap<&'static str, Meaning>,
    pub gcodes: GCodes,
}

impl Names {
    pub fn new() -> Names {
        Names { known: Vec::new(), vocabulary: dictionary::words(), gcodes: GCodes::new() }
    }

    pub fn meaning(&mut self, name: Symbol, channel: &Channel<'_>) -> Meaning {
        let at = name.0 as usize;
        if let Some(Some(known)) = self.known.get(at) {
            return *known;
        }
        let word = channel.core.symbols.name(name);
        let meaning = match channel.axis_names.find(word) {
            Some(axis) => Meaning::Axis(axis),
            None => self.vocabulary.get(word).copied().unwrap_or(Meaning::Unknown),
        };
        if self.known.len() <= at {
            self.known.resize(at + 1, None);
        }
        self.known[at] = Some(meaning);
        meaning
    }

    /// What is wrong with a word of which nothing is known here, or which is not compiled.
    pub fn misused(&mut self, name: Symbol, vars: &Vars, channel: &Channel<'_>) -> Fault {
        let word = channel.core.symbols.name(name);
        match self.meaning(name, channel) {
            Meaning::Known(known) => known.not_compiled(word),
            Meaning::Procedure(Procedure::Refused(Refusal { what, .. })) => {
                codes::P9010::is_not_supported_so_replace(&word, &what)
            }
            _ => vars.undefined(name, &channel.core),
        }
    }

    /// DEFINE: `NAME AS words`
    pub fn define_macro(&mut self, rest: &[u8], span: Span, vars: &Vars, channel: &mut Channel<'_>) -> Outcome {
        let (name, body) = channel.core.accept(span, macros::name_and_words(rest))?;
        let symbol = channel.core.symbols.intern(name);
        let meaning = self.meaning(symbol, channel);
        let core = &mut channel.core;
        let word = core.symbols.name(symbol);
        if macros::is_in_use(word, meaning, &self.gcodes) {
            return core.refuse(span, codes::S2016::is_word_of_language(&word).alarm(macros::alarm_of_use(word)));
        }
        let known = core.language.body(symbol);
        if known.is_some_and(|known| known != body) {
            return core.refuse(span, codes::S2016::macro_is_defined_twice(&word));
        }
        if vars.find(symbol).is_some() {
            return core.refuse(span, codes::S2016::is_variable_already(&word));
        }
        if known.is_none() {
            core.language.define(symbol, body);
            // Blocks that were read before may contain the name.
            for program in &mut core.programs {
                program.source.forget_blocks();
            }
        }
        Ok(())
    }
}
