//! A finding without its place: what is wrong, with the quantities of the case, and what to do.
//!
//! The catalogue of `codes` makes them, one function each, so that the place where something is decided holds no prose: `codes::K2010::…`.

use crate::text::Loc;

use super::{Answer, Code, Diagnostic, Help, Raised};

/// What is wrong, and what to do. It goes through many hands before it is reported, and what may fail is on the way of every block: it is one
/// pointer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault(Box<Parts>);

/// What a fault is made of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parts {
    pub raised: Raised,
    pub message: String,
    pub help: Option<Help>,
}

/// A fault whose help names a key of `partc.toml`: it is none before the key is given as an answer, too.
#[derive(Debug)]
#[must_use]
pub struct Asking(Fault);

/// How the catalogue words a fault, for `partc explain`: quantities stand in `{}`.
#[derive(Debug, PartialEq, Eq)]
pub struct Wording {
    /// Name of the function that makes it.
    pub name: &'static str,
    pub message: &'static str,
    /// Empty where a finding brings a help of its own, or none.
    pub help: &'static str,
    pub alarm: Option<u32>,
}

impl Wording {
    /// A text as a user reads it: `…` for each quantity.
    pub fn shown(&self, text: &str) -> String {
        let mut shown = String::with_capacity(text.len());
        let mut rest = text;
        while let Some(at) = rest.find(['{', '}']) {
            shown += &rest[..at];
            let found = &rest[at..];
            if found.starts_with("{{") || found.starts_with("}}") {
                shown += &found[..1];
                rest = &found[2..];
            } else {
                shown.push('…');
                rest = found.split_once('}').map_or("", |(_, behind)| behind);
            }
        }
        shown + rest
    }
}

impl Fault {
    pub fn new(raised: impl Into<Raised>, message: String) -> Fault {
        Fault(Box::new(Parts { raised: raised.into(), message, help: None }))
    }

    pub fn code(&self) -> &'static Code {
        self.0.raised.code
    }

    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// Does it say what to do?
    pub fn has_help(&self) -> bool {
        self.0.help.is_some()
    }

    pub fn into_parts(self) -> Parts {
        *self.0
    }

    /// What to do, where only the place knows it.
    pub fn help(mut self, help: impl Into<Help>) -> Fault {
        self.0.help = Some(help.into());
        self
    }

    /// What else may be done, as its help goes on.
    pub fn or(mut self, more: Help) -> Fault {
        self.0.help = Some(match self.0.help.take() {
            Some(help) => help.or(more),
            None => more,
        });
        self
    }

    /// The number that the control shows, where the same fault has several.
    pub fn alarm(mut self, number: impl Into<Option<u32>>) -> Fault {
        self.0.raised = self.0.raised.code.alarm(number);
        self
    }

    /// The same, of a part of the program that is named first: a cycle, a statement.
    pub fn of(mut self, what: impl std::fmt::Display) -> Fault {
        self.0.message = format!("{what}: {}", self.0.message);
        self
    }

    /// The finding at its place.
    pub fn at(self, loc: Loc) -> Diagnostic {
        let Parts { raised, message, help } = *self.0;
        let found = Diagnostic::new(raised, loc, message);
        match help {
            Some(help) => found.help(help),
            None => found,
        }
    }
}

impl Asking {
    pub fn new(fault: Fault) -> Asking {
        Asking(fault)
    }

    /// The fault, and the key that answers it.
    pub fn answer(self, answer: Answer) -> Fault {
        self.answers([answer])
    }

    /// The same, where it takes more than one key, or where a configuration may have none left to give.
    pub fn answers(mut self, answers: impl IntoIterator<Item = Answer>) -> Fault {
        if let Some(help) = &mut self.0.0.help {
            help.answers.extend(answers);
        }
        self.0
    }
}

/// Does a help quote a key of `partc.toml`, as in `[control] unit`? Looked at while the catalogue is compiled.
pub(crate) const fn quotes_key(help: &str) -> bool {
    let bytes = help.as_bytes();
    let mut at = 1;
    while at < bytes.len() {
        if bytes[at - 1] == b'`' && bytes[at] == b'[' && names_key(bytes, at + 1) {
            return true;
        }
        at += 1;
    }
    false
}

const SECTIONS: [&str; 10] =
    ["machine", "control", "cycles", "tools", "datums", "include", "variables", "output", "start", "programs"];

/// Do the name of a section, its bracket and a key stand at `from`?
const fn names_key(bytes: &[u8], from: usize) -> bool {
    let mut section = 0;
    while section < SECTIONS.len() {
        let name = SECTIONS[section].as_bytes();
        let mut at = 0;
        while at < name.len() && from + at < bytes.len() && bytes[from + at] == name[at] {
            at += 1;
        }
        if at == name.len() && from + at < bytes.len() && matches!(bytes[from + at], b']' | b'.') {
            let mut end = from + at;
            while end < bytes.len() && bytes[end] != b']' {
                end += 1;
            }
            return end + 1 < bytes.len() && bytes[end + 1] == b' ';
        }
        section += 1;
    }
    false
}

#[cfg(test)]
mod tests {
    use super::{Wording, quotes_key};

    #[test]
    fn quantities_are_shown_as_dots() {
        let wording = Wording { name: "", message: "", help: "", alarm: None };
        assert_eq!(wording.shown("the lead {lead:.2} of {axis} is 0"), "the lead … of … is 0");
        assert_eq!(wording.shown("write `TC = {{ tool = 1 }}`"), "write `TC = { tool = 1 }`");
    }

    #[test]
    fn a_help_quotes_a_key_or_it_does_not() {
        assert!(quotes_key("set `[control] unit`") && quotes_key("give `[tools.{tool}] radius`"));
        assert!(
            !quotes_key("set [control]")
                && !quotes_key("what `[programs]` says of it")
                && !quotes_key("write `[X+10]`")
                && !quotes_key("`[")
        );
    }
}
