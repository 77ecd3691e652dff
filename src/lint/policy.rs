//! What decides over a finding: `[lint]` of the configuration, and the suppressions in the file of the finding.

use std::cell::RefCell;
use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::diag::selection::Choice;
use crate::diag::{Code, Diagnostic, Diags, Judge, Selection, Severity, codes};
use crate::sema::run::survey::Survey;
use crate::text::{FileId, Loc, Sources};

use super::lead;
use super::suppression::Suppressions;

/// Decides over the findings of a run. A file is looked through for suppressions when something is found in it.
pub struct Policy {
    selection: Selection,
    sources: Rc<Sources>,
    survey: Survey,
    files: RefCell<FxHashMap<FileId, OfFile>>,
}

/// What holds in one file.
#[derive(Debug)]
struct OfFile {
    choice: Choice,
    suppressions: Suppressions,
}

impl std::fmt::Debug for Policy {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Policy").field("selection", &self.selection).finish_non_exhaustive()
    }
}

impl Policy {
    pub fn new(selection: &Selection, sources: &Rc<Sources>, survey: Survey) -> Policy {
        Policy {
            selection: selection.clone(),
            sources: Rc::clone(sources),
            survey,
            files: RefCell::new(FxHashMap::default()),
        }
    }

    fn with<T>(&self, file: FileId, act: impl FnOnce(&mut OfFile) -> T) -> T {
        if let Some(known) = self.files.borrow_mut().get_mut(&file) {
            return act(known);
        }
        let mut read = self.read(file);
        let result = act(&mut read);
        self.files.borrow_mut().insert(file, read);
        result
    }

    fn read(&self, file: FileId) -> OfFile {
        let identity = self.sources.identity(file);
        let path = if identity.is_empty() { self.sources.name(file) } else { identity };
        let mut suppressions = Suppressions::default();
        lead(&self.sources, file, self.survey, &mut suppressions);
        OfFile { choice: self.selection.of(&path), suppressions }
    }

    /// Is a finding of this code reported in any file?
    pub fn wants(&self, code: &Code) -> bool {
        let choices = self.selection.files.iter().map(|(pattern, _)| self.selection.of(pattern));
        self.selection.all.level(code).is_some()
            || choices.into_iter().any(|choice| choice.level(code).is_some())
            || self.with(FileId(0), |of| of.choice.level(code).is_some())
    }

    /// Reports what is wrong with the suppressions of a file whose findings are all there.
    pub fn report(&self, file: FileId, diags: &Diags) {
        let (faults, unused) = self.with(file, |of| (of.suppressions.take_faults(), self.unused(of)));
        faults.into_iter().for_each(|fault| diags.push(fault));
        // Behind an error not all is found.
        if diags.has_errors() {
            return;
        }
        for (code, loc) in unused {
            let message = format!("{} ({}) is not found here, so nothing is suppressed", code.id, code.name);
            diags.push(Diagnostic::new(codes::P8001, loc, message).help("remove it"));
        }
    }

    /// What is not reported anyway does not make a suppression useless.
    fn unused(&self, of: &OfFile) -> Vec<(&'static Code, Loc)> {
        of.suppressions.unused(|code| !code.id.starts_with("P800") && of.choice.level(code).is_some())
    }
}

impl Judge for Policy {
    fn level(&self, found: &Diagnostic) -> Option<Severity> {
        let loc = found.label.loc;
        self.with(loc.file, |of| {
            let level = of.choice.level(found.code)?;
            let suppressed = !found.code.is_firm() && of.suppressions.cover(found.code, loc.line);
            (!suppressed).then_some(level)
        })
    }
}
