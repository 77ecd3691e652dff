//! What there is to know of a document: one check of the program, with what its blocks do and which names they use.

use std::collections::BTreeMap;

use crate::block_ends::BlockEnds;
use crate::diag::trail::Assigned;
use crate::diag::{Code, Finding, Severity, codes};
use crate::dialect::Dialect;
use crate::driver::Session;
use crate::lint::fix::Fix;
use crate::lint::lead;
use crate::machine::Settings;
use crate::machine::keys::choices;
use crate::sema::Job;
use crate::sema::run::survey::{OfStraight, StraightLine, Surveyed, Visitor, Wanted, What};
use crate::text::{FileId, Files, Memory, Opened, Span};

/// A document at one version.
#[derive(Debug, Default)]
pub struct Study {
    pub findings: Vec<Found>,
    pub fixes: Vec<Fix>,
    pub seen: BlockEnds,
    /// Empty until somebody asks: findings do not wait for it.
    pub survey: Survey,
    is_surveyed: bool,
    /// The program was given up before its end.
    pub cut_off: bool,
    /// What variables got, in order.
    pub values: Vec<Assigned>,
    /// Files of the run by their numbers: name, and what tells them apart.
    pub files: Vec<(String, String)>,
}

/// A finding with its place in the document.
#[derive(Debug, Clone)]
pub struct Found {
    pub code: &'static Code,
    pub severity: Severity,
    /// In the document; for one in a called program the block that calls it.
    pub span: Span,
    pub message: String,
    /// Where it is, if in a called program: file, line and column from 1.
    pub elsewhere: Option<(FileId, u32, u32)>,
    pub more: Vec<(Span, String)>,
    /// A comment may suppress it.
    pub ignorable: bool,
}

/// The blocks and names of the document.
#[derive(Debug, Default)]
pub struct Survey {
    /// In order: from the first byte of each block to its last word.
    pub blocks: Vec<BlockPlace>,
    pub labels: BTreeMap<String, Uses>,
    pub variables: BTreeMap<String, Uses>,
    /// Sections that begin and end: programs of a file.
    pub begins: Vec<Span>,
}

/// A block in the document.
#[derive(Debug, Clone, Copy)]
pub struct BlockPlace {
    pub span: Span,
    /// From its first word to its last.
    pub words: Span,
    pub number: Option<u32>,
}

/// Where a name is set and used; each the words of its block, or closer.
#[derive(Debug, Default, Clone)]
pub struct Uses {
    pub set: Vec<Span>,
    pub used: Vec<Span>,
}

/// Checks a document; `None` where it does not go on to the end.
pub fn study(
    name: &str,
    identity: &str,
    text: &str,
    dialect: &Dialect,
    settings: &Settings,
    files: &dyn Files,
    goes_on: &dyn Fn() -> bool,
) -> Option<Study> {
    let main =
        Opened { name: name.to_owned(), identity: identity.to_owned(), text: Box::new(Memory::new(text.as_bytes())) };
    let session = Session::new(main);
    session.trail.watch_values();
    let mut study = Study::default();
    study.fixes = session.check_seen(dialect, settings, files, Some(&mut study.seen), goes_on);
    if !goes_on() {
        return None;
    }
    let Session { sources, diags, trail } = session;
    study.values = trail.take_values();
    study.files =
        (0..sources.len()).map(|at| FileId(at as u16)).map(|id| (sources.name(id), sources.identity(id))).collect();
    for found in diags.into_sorted() {
        study.cut_off |= found.code.id == codes::P4001.id;
        let own = found.label.loc.file == FileId(0);
        let outermost = trail.sites(found.call).pop().filter(|site| site.file == FileId(0));
        let span = if own { Some(found.label.loc.span) } else { outermost.map(|site| site.span) };
        let shown = Finding::new(&found, &sources, &trail, choices);
        let mut message = shown.message;
        if !own {
            message = format!("{}, line {}: {message}", shown.file, shown.line);
        }
        if let Some(help) = &shown.help {
            message = format!("{message}\n{help}");
        }
        if found.times > 1 {
            message = format!("{message} ({} times)", found.times);
        }
        let more = found.more.iter().filter(|label| label.loc.file == FileId(0));
        study.findings.push(Found {
            code: found.code,
            severity: found.severity,
            span: span.unwrap_or_default(),
            message,
            elsewhere: (!own).then_some((found.label.loc.file, shown.line, shown.column)),
            more: more.map(|label| (label.loc.span, label.text.clone())).collect(),
            ignorable: own && !found.code.is_firm() && !found.code.id.starts_with("P800"),
        });
    }
    Some(study)
}

impl Study {
    /// Looks up the blocks and names of the text that was studied.
    pub fn look_up(&mut self, text: &str, dialect: &Dialect) {
        if !std::mem::replace(&mut self.is_surveyed, true) {
            let text = Box::new(Memory::new(text.as_bytes()));
            let session = Session::new(Opened { name: String::new(), identity: String::new(), text });
            lead(&session.sources, FileId(0), dialect.survey, &mut self.survey);
        }
    }
}

impl Visitor for Survey {
    fn wanted(&self) -> Wanted<'_> {
        Wanted::ALL
    }

    fn items(&self) -> bool {
        true
    }

    fn straight(&self) -> OfStraight {
        OfStraight::Places
    }

    fn straight_line(&mut self, line: &StraightLine) {
        self.blocks.push(BlockPlace { span: line.span, words: line.words, number: line.number });
    }

    fn block(&mut self, block: &Surveyed<'_>, _: &Job<'_>) {
        let at = block.site.at;
        let span = Span::at(at, block.text.len() as u32);
        self.blocks.push(BlockPlace { span, words: block.words.shifted(at), number: block.number });
        for item in block.items {
            let span = item.span.shifted(at);
            match &item.what {
                What::Label(name) => self.labels.entry(name.clone()).or_default().set.push(span),
                What::Uses(name) => self.labels.entry(name.clone()).or_default().used.push(span),
                What::Writes(name) => self.variables.entry(name.clone()).or_default().set.push(span),
                What::Reads(name) => self.variables.entry(name.clone()).or_default().used.push(span),
                What::Begins => self.begins.push(span),
                _ => {}
            }
        }
    }
}

impl Survey {
    /// The block in which a byte lies.
    pub fn block_at(&self, offset: u32) -> Option<&BlockPlace> {
        let behind = self.blocks.partition_point(|block| block.span.start <= offset);
        self.blocks[..behind].last().filter(|block| offset <= block.span.end)
    }
}
