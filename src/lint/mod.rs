//! What is said of a program beside its compilation: rules, and what the program says about findings.

#[cfg(feature = "cli")]
pub mod ends;
pub mod fingerprint;
pub mod fix;
pub mod motion;
pub mod policy;
#[cfg(feature = "cli")]
pub mod renumber;
pub mod rules;
pub mod source;
pub mod suppression;
pub mod tapping;
pub mod turned;

use crate::diag::{Diags, Trail};
use crate::machine::{MachineKind, Settings};
use crate::sema::Job;
use crate::sema::run::survey::{Survey, Visitor};
use crate::text::files::NoFiles;
use crate::text::{FileId, Sources};

use fix::Fix;
use motion::{Bar, Blank, Say, Setup, Watch, Watching};
use policy::Policy;
use rules::{Make, RULES};
use source::{FindsBlank, Reader};

/// The rules of a check that somebody wants to hear of.
pub struct Checks<'a> {
    setup: Setup<'a>,
    policy: &'a Policy,
    diags: &'a Diags,
}

impl std::fmt::Debug for Checks<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Checks").finish_non_exhaustive()
    }
}

impl<'a> Checks<'a> {
    /// Looks for what rules want to know before the program runs.
    pub fn new(
        settings: &'a Settings,
        sources: &'a Sources,
        survey: Survey,
        policy: &'a Policy,
        diags: &'a Diags,
    ) -> Checks<'a> {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let mut found = FindsBlank::on(lathe);
        lead(sources, FileId(0), survey, &mut found);
        let blank = found.blank().or_else(|| Blank::given(&settings.blank).filter(|_| !lathe));
        let bar = found.bar().or_else(|| Bar::given(&settings.blank).filter(|_| lathe));
        let setup = Setup { settings, blank, bar, size: sources.size(FileId(0)), sources };
        Checks { setup, policy, diags }
    }

    /// Rules that look on while the program runs; `None` where nobody wants one.
    pub fn watch(&self) -> Option<Watching<'a>> {
        let wanted = RULES.iter().filter(|rule| self.policy.wants(rule.code));
        let made = wanted.filter_map(|rule| match rule.make {
            Make::Motion(make) => Some(make(&self.setup)),
            Make::Source(_) => None,
        });
        let rules: Vec<_> = made.collect();
        (!rules.is_empty()).then(|| Watch::new(rules, self.diags))
    }

    /// Reads the blocks of the main program, and gives what would mend them.
    pub fn read(&self, sources: &Sources, survey: Survey) -> Vec<Fix> {
        let wanted = RULES.iter().filter(|rule| self.policy.wants(rule.code));
        let made = wanted.filter_map(|rule| match rule.make {
            Make::Source(make) => Some(make(&self.setup)),
            Make::Motion(_) => None,
        });
        let mut reader = Reader { rules: made.collect(), say: Say::to(self.diags), fixes: Vec::new() };
        if !reader.rules.is_empty() {
            lead(sources, FileId(0), survey, &mut reader);
            reader.finish();
        }
        reader.fixes
    }
}

/// Leads a visitor through a file for whom nothing but its text matters: what is wrong with it is found by who runs it.
pub fn lead(sources: &Sources, file: FileId, survey: Survey, visitor: &mut dyn Visitor) {
    let (diags, trail, settings) = (Diags::default(), Trail::default(), Settings::default());
    let job = Job { sources, diags: &diags, trail: &trail, files: &NoFiles, settings: &settings, main: file };
    survey(&job, file, visitor);
}
