//! Blocks that did not run: what `partc check` can say of them.
//!
//! The control refuses a program for words that have no place, for labels set twice and for calls of labels that do
//! not exist, whether the block runs or not: errors. What only partc would refuse if the block ran is a warning, since
//! no output depends on it, and so is a jump to a missing label that was never taken. Blocks of which the run reported an error are left alone; in one that ran without an
//! error nothing can be found here.

use crate::diag::{Code, Diagnostic, codes};
use crate::parser::klartext::ast::{Addr, Block, LabelRef, Refused, Stmt, Word};
use crate::parser::klartext::misprinted;
use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::sema::run::Site;
use crate::sema::run::unexecuted::Blocks;
use crate::text::{Loc, Span, decode::readable};

use super::Klartext;
use super::block_text::same_matter;
use super::cycles::{CycleKind, find};
use super::labels::{Label, Labels};
use super::path::{corner_words, path_words};
use super::words::Admits;
use super::{m_table, plane, probing, refused};

/// Looks at every block of the main program after its run.
pub fn check_unexecuted(job: &Job<'_>) {
    let start = Loc { file: job.main, line: 1, span: Span::default() };
    let reported = job.diags.errors_in(job.main);
    let labels = Labels::scan(job, job.main, start, &mut |found| {
        if !job.diags.knows(&found) {
            job.diags.push(found);
        }
    });
    let Some(mut blocks) = Blocks::<Klartext>::of_main(job) else { return };
    let mut symbols = Symbols::default();
    while let Some(passed) = blocks.next_behind_straight(job, &mut symbols) {
        if matches!(passed.block.stmt, Stmt::End { .. }) {
            return;
        }
        if passed.is_free_of(&reported) {
            look(job, &labels, passed.block, passed.text, &passed.site);
        }
    }
}

fn look(job: &Job<'_>, labels: &Labels, block: &Block, text: &[u8], here: &Site) {
    let found = called_label(block)
        .and_then(|label| Label::written(label, text))
        .filter(|label| *label != Label::Number(0) && labels.place(label).is_none())
        .map(|label| match block.stmt {
            // Whether a control looks for the label of a jump that it does not take is not known.
            Stmt::If { .. } => not_taken(&labels.missing(&label, here.loc(job, block.span))),
            _ => labels.missing(&label, here.loc(job, block.span)),
        })
        .or_else(|| wrong_word(job, block, text, here))
        .or_else(|| {
            let code = refused(job, block, text)?;
            Some(codes::P8140::this_block_does_not_run(&code.title, &code.id).at(here.loc(job, block.span)))
        });
    if let Some(found) = found {
        job.diags.push(found);
    }
}

/// The finding for a jump that was never taken, where taking it would be `missing`.
fn not_taken(missing: &Diagnostic) -> Diagnostic {
    let code = codes::P2011;
    let found = codes::P8140::this_jump_is_not_taken(&missing.message, &code.id).at(missing.label.loc);
    match &missing.help {
        Some(help) => found.help(help.clone()),
        None => found.help(format!("see `partc explain {}`", code.id)),
    }
}

fn called_label(block: &Block) -> Option<LabelRef> {
    match block.stmt {
        Stmt::CallLabel { label, .. } => Some(label),
        Stmt::If { target, .. } => Some(target),
        _ => None,
    }
}

/// The words that the head of the block takes, where that is known without running it.
fn admits(stmt: Stmt) -> Option<Admits> {
    Some(match stmt {
        Stmt::Path(function) => path_words(function),
        Stmt::Paraxial => Admits::PATH.and(Admits::PARAXIAL),
        Stmt::Functions => Admits::PATH,
        Stmt::Pole => Admits::AXES,
        Stmt::Rounding => corner_words(true),
        Stmt::Chamfer => corner_words(false),
        Stmt::Stop => Admits::M,
        _ => return None,
    })
}

/// A word that the block does not take, or that says again what an earlier one says.
fn wrong_word(job: &Job<'_>, block: &Block, text: &[u8], here: &Site) -> Option<Diagnostic> {
    let admits = admits(block.stmt)?;
    for (at, word) in block.words.iter().enumerate() {
        let shown = || readable(word.span.of(text)).into_owned();
        let loc = || here.loc(job, word.span);
        if !admits.takes(word) {
            // One finding of the program says that some words have no numbers.
            if let Some(problem) = misprinted(text, word.span) {
                let found = here.diagnostic(job, problem);
                return (!job.diags.any(|known| known.code == codes::K0801)).then_some(found);
            }
            return Some(codes::P1003::has_no_place_in_this_block(&shown()).at(loc()));
        }
        if block.words[..at].iter().any(|first| excludes(first, word)) {
            return Some(codes::P1002::repeats_word_of_this_block(&shown()).at(loc()));
        }
        // What follows may belong to the function.
        if matches!(word.addr, Addr::M(number) if m_table::takes_words(number)) {
            return None;
        }
    }
    None
}

fn excludes(first: &Word, second: &Word) -> bool {
    let counts = |word: &Word| !matches!(word.addr, Addr::FeedEmpty | Addr::MEmpty | Addr::RadiusEmpty);
    // CR has a radius and may end the compensation.
    let radius = |word: &Word| matches!(word.addr, Addr::Radius { .. });
    counts(first) && counts(second) && !(radius(first) || radius(second)) && same_matter(first.addr, second.addr)
}

/// FZ counts teeth, which the tool table may give; FT and FMAXT are times.
fn begins_with_fz(word: &[u8]) -> bool {
    word.get(..2).is_some_and(|head| head.eq_ignore_ascii_case(b"FZ"))
}

/// Why partc would refuse the block.
fn refused(job: &Job<'_>, block: &Block, text: &[u8]) -> Option<&'static Code> {
    let code = match block.stmt {
        Stmt::Surface => Some(codes::K9015),
        Stmt::Iso => Some(codes::P9012),
        Stmt::Refused(what, _) => match what {
            Refused::Plane => plane::tilts(block.span.of(text)).then_some(codes::K9004),
            Refused::TouchProbe => (!job.settings.control.klartext_choices.probing_left_out
                && !probing::is_computed(block.span.of(text)))
            .then_some(codes::K9005),
            Refused::Pattern => Some(codes::K9010),
            Refused::Contour => Some(codes::K9018),
            Refused::GlobalDef => Some(codes::P9011),
            Refused::Function if !refused::is_harmless(block.span.of(text)) => Some(codes::P9011),
            Refused::Function | Refused::SelectTable => None,
        },
        Stmt::FnOther { number: 26..=28, .. } => Some(codes::K9006),
        Stmt::FnOther { number: 17 | 25, .. } => Some(codes::K9014),
        Stmt::FnOther { number: 24, .. } => Some(codes::P9011),
        Stmt::Cycle { number, part: None | Some(0) }
            if matches!(find(number).nature, CycleKind::Acting | CycleKind::Unknown) =>
        {
            Some(codes::P9010)
        }
        _ => None,
    };
    let refused_m = |number: u32, job: &Job<'_>| {
        let control = &job.settings.control;
        if control.tool_change_m.contains(&number) {
            return None;
        }
        m_table::refused_code(number, &job.settings.output.pass_m)
    };
    code.or_else(|| {
        block.words.iter().find_map(|word| match word.addr {
            Addr::M(number) => refused_m(number, job),
            Addr::FeedOther if !begins_with_fz(word.span.of(text)) => Some(codes::K9013),
            Addr::CuttingSpeed => Some(codes::P9011),
            _ => None,
        })
    })
}
