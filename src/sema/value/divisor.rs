//! The variable that a formula divides by while it is zero: its name, and who set it.

use crate::diag::CallPath;
use crate::machine::Settings;
use crate::sema::Job;
use crate::text::Loc;

/// A divisor that is a variable alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Divisor {
    /// As the control writes it.
    pub name: String,
    pub set: SetBy,
}

/// Who gave a variable its zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SetBy {
    Block(Loc),
    /// The block that defines the variable, and gives it no other value.
    Definition(Loc),
    /// `[variables]` of the configuration.
    Configuration,
    Nobody,
    Unknown,
}

impl SetBy {
    /// Who set `name` to zero, as far as the run has seen it; `level` is the program whose own variable it is.
    pub fn of(job: &Job<'_>, name: &str, level: Option<CallPath>) -> Option<SetBy> {
        match job.trail.zero_of(name) {
            Some((loc, call)) if level.is_none_or(|level| level == call) => Some(SetBy::Block(loc)),
            Some(_) => Some(SetBy::Unknown),
            None => is_configured(job.settings, name).then_some(SetBy::Configuration),
        }
    }
}

fn is_configured(settings: &Settings, name: &str) -> bool {
    settings.variables.contains_key(name) || settings.variables.contains_key(&name.to_ascii_uppercase())
}

impl Divisor {
    /// What is said of it in a block at `here`.
    pub fn said(&self, job: &Job<'_>, here: Loc) -> String {
        let name = &self.name;
        let line = |loc: Loc| match loc.file == here.file {
            true => format!("line {}", loc.line),
            false => format!("line {} of `{}`", loc.line, job.sources.shown(loc.file)),
        };
        match self.set {
            SetBy::Block(loc) => format!("`{name}` is 0 (set in {})", line(loc)),
            // What set it since then is not kept.
            SetBy::Definition(loc) => format!("`{name}`, defined in {}, is 0", line(loc)),
            SetBy::Configuration => format!("`{name}` is 0, as `[variables]` says"),
            SetBy::Nobody => format!("`{name}` is 0 and set nowhere"),
            SetBy::Unknown => format!("`{name}` is 0"),
        }
    }
}
