//! What only the user can say: a choice of the control that no manual confirms, as the dialect asks for it.

use crate::diag::{Answer, Help};

/// A key of `partc.toml` that decides, and what to do. The passes behind the dialect raise it where the choice matters, and know no key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ask {
    /// Table of `partc.toml`, such as `control`.
    pub section: &'static str,
    /// Key in that table.
    pub key: &'static str,
    /// The values that it takes; empty for any.
    pub values: &'static [&'static str],
    /// What to do, in one sentence for the user.
    pub help: &'static str,
}

impl Ask {
    /// A question that any value of the key answers.
    pub const fn key(section: &'static str, key: &'static str, help: &'static str) -> Ask {
        Ask { section, key, values: &[], help }
    }

    /// The same, and the values that may be chosen.
    pub const fn one_of(self, values: &'static [&'static str]) -> Ask {
        Ask { values, ..self }
    }

    /// The help of a finding, with the answer that it names.
    pub fn help(&self) -> Help {
        let answer = Answer::key(self.section, self.key);
        if self.values.is_empty() { answer.help(self.help) } else { answer.one_of(self.values).help(self.help) }
    }
}
