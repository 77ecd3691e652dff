//! Diagnostics: plain data with a stable code, a place and a text for a machinist.
//!
//! Stages push into [`Diags`]; none prints, none stops another. Renderers live in [`render`].

pub mod answer;
pub mod codes;
pub mod decimals;
pub mod fault;
pub mod finding;
pub mod label;
mod once;
pub mod render;
pub mod report;
pub mod selection;
pub mod trail;

use std::borrow::Cow;
use std::cell::RefCell;
use std::hash::Hash;
use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::text::Loc;

pub use answer::{Answer, Help, Values};
pub use codes::{Code, Raised};
pub use fault::{Fault, Parts};
pub use finding::Finding;
pub use label::Label;
pub use selection::Selection;
pub use trail::{CallPath, Trail};

use once::Once;

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    Note,
    Warning,
    Error,
}

impl Severity {
    pub fn word(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// A place with a word on what it has to do with the matter.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Marked {
    pub loc: Loc,
    pub text: String,
}

/// One finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    pub code: &'static Code,
    /// That of the code, unless the user wants another one.
    pub severity: Severity,
    /// The number that the control itself shows.
    pub alarm: Option<u32>,
    /// What is wrong, in the user's words, values quoted.
    pub message: String,
    /// Where: the first label is the cause.
    pub label: Marked,
    /// Places that explain it.
    pub more: Vec<Marked>,
    /// One action that mends it.
    pub help: Option<String>,
    /// What of a configuration would mend it.
    pub answers: Vec<Answer>,
    /// How the program got there.
    pub call: CallPath,
    /// How often the same was found at the same place.
    pub times: u32,
}

impl Diagnostic {
    pub fn new(code: impl Into<Raised>, loc: Loc, message: impl Into<String>) -> Diagnostic {
        let Raised { code, alarm } = code.into();
        Diagnostic {
            code,
            severity: code.severity,
            alarm,
            message: message.into(),
            label: Marked { loc, text: String::new() },
            more: Vec::new(),
            help: None,
            answers: Vec::new(),
            call: CallPath::default(),
            times: 1,
        }
    }

    /// What is wrong, with the alarm of the control behind it. Quotes of a block end after some sixty characters.
    pub fn text(&self) -> Cow<'_, str> {
        let message = shortened(&self.message);
        match self.alarm {
            Some(number) => Cow::Owned(format!("{message} (alarm {number})")),
            None => message,
        }
    }

    /// Text beside the marked words.
    pub fn here(mut self, text: impl Into<String>) -> Diagnostic {
        self.label.text = text.into();
        self
    }

    /// A place that explains it.
    pub fn also(mut self, loc: Loc, label: impl Into<Label>) -> Diagnostic {
        self.more.push(Marked { loc, text: label.into().to_string() });
        self
    }

    pub fn help(mut self, help: impl Into<Help>) -> Diagnostic {
        let Help { text, answers } = help.into();
        self.help = Some(text);
        self.answers = answers;
        self
    }

    pub fn called(mut self, call: CallPath) -> Diagnostic {
        self.call = call;
        self
    }
}

/// Most characters of a quote.
const QUOTED: usize = 60;
/// Most characters of a name: what is cut names no file.
const NAMED: usize = 400;

/// The text with long quotes, which stand between backticks, cut.
fn shortened(text: &str) -> Cow<'_, str> {
    if text.len() <= QUOTED || !text.contains('`') {
        return Cow::Borrowed(text);
    }
    let mut short = String::with_capacity(text.len());
    for (at, part) in text.split('`').enumerate() {
        if at > 0 {
            short.push('`');
        }
        let is_name = part.contains(['/', '\\']) || part.contains('.') && !part.contains(' ');
        match part.char_indices().nth(if is_name { NAMED } else { QUOTED }) {
            Some((end, _)) if at % 2 == 1 => {
                short.push_str(&part[..end]);
                short.push('…');
            }
            _ => short.push_str(part),
        }
    }
    Cow::Owned(short)
}

/// What decides over a finding besides its code: the configuration, and the comments of the program.
pub trait Judge: std::fmt::Debug {
    /// How bad the finding is; `None` where it is not reported.
    fn level(&self, found: &Diagnostic) -> Option<Severity>;
}

/// Findings kept of one run; more are only counted.
const KEPT: usize = 500;
/// Places remembered of findings, kept or not, so that none is counted twice.
const PLACES: usize = 1 << 17;

/// Collects the findings of one run. Shared by all stages, so it is used through `&`.
#[derive(Debug, Default)]
pub struct Diags {
    inner: RefCell<Inner>,
    judge: RefCell<Option<Rc<dyn Judge>>>,
}

#[derive(Debug, Default)]
struct Inner {
    list: Vec<Diagnostic>,
    /// Index in `list`; `None` for those that are only counted.
    seen: FxHashMap<(&'static str, Loc), Option<usize>>,
    once: Once,
    counts: [u32; 3],
    dropped: u32,
    /// As many are kept, where it is more than usual.
    room: usize,
    /// The run has met an error.
    failed: bool,
    /// The first so many were found in the form of the program; true for those that its run met, too.
    form: Vec<bool>,
}

impl Diags {
    /// From here on `judge` decides over what is found.
    pub fn judge_by(&self, judge: Rc<dyn Judge>) {
        *self.judge.borrow_mut() = Some(judge);
    }

    /// Keeps `most` findings, or as many as usual if that is more.
    pub fn keep(&self, most: usize) {
        self.inner.borrow_mut().room = most;
    }

    /// Takes a finding. The same code at the same place is counted, not repeated.
    pub fn push(&self, mut found: Diagnostic) {
        let key = (found.code.id, found.label.loc);
        if found.code.severity == Severity::Error {
            self.inner.borrow_mut().failed = true;
        }
        if self.is_repeated(key, found.call) {
            return;
        }
        let judge = self.judge.borrow().clone();
        let level = judge.map_or(Some(found.severity), |judge| judge.level(&found));
        let inner = &mut *self.inner.borrow_mut();
        let Some(severity) = level else {
            if inner.seen.len() < PLACES {
                inner.seen.insert(key, None);
            }
            return;
        };
        found.severity = severity;
        // Notes and warnings leave room for what stops the output.
        let room = if severity == Severity::Error { KEPT } else { KEPT / 2 }.max(inner.room);
        inner.counts[severity as usize] += 1;
        let kept = inner.list.len() < room;
        if inner.seen.len() < PLACES {
            inner.seen.insert(key, kept.then_some(inner.list.len()));
        }
        if kept {
            inner.list.push(found);
        } else {
            inner.dropped += 1;
        }
    }

    /// Counts a finding that is known already.
    fn is_repeated(&self, key: (&'static str, Loc), call: CallPath) -> bool {
        let inner = &mut *self.inner.borrow_mut();
        let Some(&known) = inner.seen.get(&key) else { return false };
        let Some(at) = known else { return true };
        match inner.form.get_mut(at) {
            // The first run of a block whose form was looked at before; now the way to it is known.
            Some(met) if !*met => {
                *met = true;
                inner.list[at].call = call;
            }
            _ => inner.list[at].times = inner.list[at].times.saturating_add(1),
        }
        true
    }

    /// Was the same found at the same place before?
    pub fn knows(&self, found: &Diagnostic) -> bool {
        self.inner.borrow().seen.contains_key(&(found.code.id, found.label.loc))
    }

    /// Offsets in `file` at which errors were found, ascending.
    pub fn errors_in(&self, file: crate::text::FileId) -> Vec<u32> {
        let inner = self.inner.borrow();
        let in_file = inner.list.iter().filter(|d| d.code.severity == Severity::Error && d.label.loc.file == file);
        let mut places: Vec<u32> = in_file.map(|d| d.label.loc.span.start).collect();
        places.sort_unstable();
        places
    }

    /// What was found so far came from the form of the program; now it runs, and passes the same blocks again.
    pub fn begin_run(&self) {
        let inner = &mut *self.inner.borrow_mut();
        inner.form = vec![false; inner.list.len()];
        inner.failed = false;
    }

    /// Has the run met an error, also one that the form of the program had shown before?
    pub fn has_failed(&self) -> bool {
        self.inner.borrow().failed
    }

    /// The first error that the run has met.
    pub fn first_error(&self) -> Option<Diagnostic> {
        let inner = self.inner.borrow();
        inner.list.iter().find(|found| found.code.severity == Severity::Error).cloned()
    }

    /// Shows all findings that are kept.
    pub fn each(&self, show: impl FnMut(&Diagnostic)) {
        self.inner.borrow().list.iter().for_each(show);
    }

    /// Was there such a finding?
    pub fn any(&self, is: impl Fn(&Diagnostic) -> bool) -> bool {
        self.inner.borrow().list.iter().any(is)
    }

    /// Findings that were counted and not kept.
    pub fn dropped(&self) -> u32 {
        self.inner.borrow().dropped
    }

    /// Takes a finding unless one of the same code said the same before: for what holds on in the program.
    pub fn push_once(&self, mut found: Diagnostic) {
        found.message = decimals::rounded(found.message);
        if self.first_time(found.code, &found.message) {
            self.push(found);
        }
    }

    /// The same, for one that other places explain: what they explain may be said of each of them.
    pub fn push_cause(&self, mut found: Diagnostic) {
        found.message = decimals::rounded(found.message);
        if self.first_time(found.code, (&found.message, &found.more)) {
            self.push(found);
        }
    }

    /// True the first time it is asked about this text of `code`.
    pub fn first_text(&self, code: &'static Code, text: &str) -> bool {
        self.first_time(code, decimals::rounded(text.to_owned()))
    }

    /// True the first time it is asked about this fact of `code`: the values that the finding names, `()` where it names none.
    pub fn first_time(&self, code: &'static Code, fact: impl Hash) -> bool {
        self.inner.borrow_mut().once.is_first(code.id, fact)
    }

    /// Notes, warnings and errors, also those that were only counted.
    pub fn counts(&self) -> [u32; 3] {
        self.inner.borrow().counts
    }

    pub fn errors(&self) -> u32 {
        self.inner.borrow().counts[Severity::Error as usize]
    }

    pub fn warnings(&self) -> u32 {
        self.inner.borrow().counts[Severity::Warning as usize]
    }

    pub fn has_errors(&self) -> bool {
        self.errors() > 0
    }

    /// The findings, in the order of file and place; those of one place as they were found.
    pub fn into_sorted(self) -> Vec<Diagnostic> {
        let Inner { mut list, once, .. } = self.inner.into_inner();
        let last: FxHashMap<&'static str, &mut Diagnostic> =
            list.iter_mut().map(|found| (found.code.id, found)).collect();
        for (code, found) in last {
            if let Some((more, at_least)) = once.unlisted(code) {
                let least = if at_least { "at least " } else { "" };
                found.message += &format!("; {least}{more} more of this kind are not listed");
            }
        }
        list.sort_by_key(|d| (d.label.loc.file, d.label.loc.span.start));
        list
    }
}
