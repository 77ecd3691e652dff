//! The dialects: one table each, registered by one line in [`ALL`].

mod gcode;
mod klartext;
mod mtc200;
mod sinumerik;
mod turning;

use std::borrow::Cow;

use crate::ir::contour::Sink;
use crate::machine::{MachineKind, Settings};
use crate::sema::Job;
use crate::sema::cycle_table::Signature;
use crate::sema::run::survey::Survey;

/// What the rest of the compiler knows of a control's language.
pub struct Dialect {
    /// Name in `--dialect`.
    pub id: &'static str,
    pub name: &'static str,
    /// Extensions of its files, lower case, without the dot.
    pub extensions: &'static [&'static str],
    /// Do these first bytes of a file show the language beyond doubt?
    pub recognizes: fn(&[u8]) -> bool,
    /// A language of lathes: whatever `[machine] kind` says, the output is one for a lathe.
    pub turns: bool,
    /// Runs the main program; returns the hash of its text.
    pub run: fn(&Job<'_>, &mut dyn Sink) -> u64,
    /// Reads every block, whether it runs or not.
    pub check_form: fn(&Job<'_>),
    /// Looks at the blocks of which the run, which comes before, reported no error, and says what can be known without
    /// running them: an error where the control itself refuses the program, a warning where only partc would refuse
    /// the block if it ran. `None` where a dialect knows no more than the form.
    pub check_unexecuted: Option<fn(&Job<'_>)>,
    /// A comment at the end of a block with a list in brackets: what stands in front of it, around the list, and behind it.
    pub comment: [&'static str; 4],
    /// Are its blocks numbered 0, 1, 2, not by tens?
    pub numbers_by_one: bool,
    /// Leads rules on source text through a file.
    pub survey: Survey,
    /// What each of its cycles takes, built or not.
    pub cycles: fn() -> Vec<&'static Signature>,
}

impl Dialect {
    /// The settings of a run in this language.
    pub fn settings<'s>(&self, settings: &'s Settings) -> Cow<'s, Settings> {
        if !self.turns || settings.machine.kind == MachineKind::Lathe {
            return Cow::Borrowed(settings);
        }
        let mut settings = settings.clone();
        settings.machine.kind = MachineKind::Lathe;
        Cow::Owned(settings)
    }
}

impl Dialect {
    /// The cycle that a program calls by this name: `CYCLE81`, `CYCL DEF 200`, `G869`.
    pub fn cycle(&self, name: &str) -> Option<&'static Signature> {
        (self.cycles)().into_iter().find(|cycle| cycle.name.eq_ignore_ascii_case(name.trim()))
    }
}

impl std::fmt::Debug for Dialect {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id)
    }
}

/// All dialects.
pub const ALL: &[&Dialect] =
    &[&klartext::DIALECT, &sinumerik::DIALECT, &mtc200::DIALECT, &turning::DIALECT, &gcode::DIALECT];

/// The dialect of this name.
pub fn find(id: &str) -> Option<&'static Dialect> {
    ALL.iter().copied().find(|dialect| dialect.id == id)
}

/// Guesses by content, then by extension. `None` if that leaves more or less than one.
pub fn guess(file_name: &str, head: &[u8]) -> Option<&'static Dialect> {
    let mut by_content = ALL.iter().copied().filter(|dialect| (dialect.recognizes)(head));
    if let (Some(dialect), None) = (by_content.next(), by_content.next()) {
        return Some(dialect);
    }
    let extension = file_name.rsplit_once('.')?.1.to_ascii_lowercase();
    let mut by_extension = ALL.iter().copied().filter(|dialect| dialect.extensions.contains(&extension.as_str()));
    match (by_extension.next(), by_extension.next()) {
        (Some(dialect), None) => Some(dialect),
        _ => None,
    }
}
