//! The block in hand as it is written, and what is said of words that have no place in it.

use crate::diag::{Fault, Label, codes};
use crate::machine::Compensation;
use crate::parser::klartext::ast::{Addr, Block, Word};
use crate::parser::klartext::misprinted;
use crate::parser::problem::Problem;
use crate::sema::run::Where;
use crate::text::{Span, decode::readable};

use super::{Core, Outcome, Reported};

/// The first words of the block as written, which name its function.
pub(super) fn block_name(block: &Block, text: &[u8], words: usize) -> (String, Span) {
    let code = block.span.of(text);
    let mut len = 0;
    for _ in 0..words {
        let rest = &code[len..];
        len += rest.iter().take_while(|b| b.is_ascii_whitespace()).count();
        len += code[len..].iter().take_while(|b| !b.is_ascii_whitespace()).count();
    }
    let span = Span::at(block.span.start, len as u32);
    (readable(&code[..len]).split_whitespace().collect::<Vec<_>>().join(" "), span)
}

/// Do the two addresses exclude each other in one block?
pub(super) fn same_matter(a: Addr, b: Addr) -> bool {
    use Addr::*;
    match (a, b) {
        (Axis { axis: a, .. }, Axis { axis: b, .. }) => a == b,
        (PolarRadius { .. }, PolarRadius { .. }) | (PolarAngle { .. }, PolarAngle { .. }) => true,
        (Feed | FeedMax | FeedAuto | FeedPerRev | FeedOther, Feed | FeedMax | FeedAuto | FeedPerRev | FeedOther) => {
            true
        }
        (TurnPlus | TurnMinus, TurnPlus | TurnMinus) => true,
        (
            Radius { .. } | Value | CompLeft | CompRight | ParaxialPlus | ParaxialMinus,
            Radius { .. } | Value | CompLeft | CompRight | ParaxialPlus | ParaxialMinus,
        ) => true,
        (a, b) => a == b,
    }
}

impl Core<'_> {
    /// Does the compiler compensate?
    #[inline]
    pub(super) fn computes_path(&self) -> bool {
        self.job.settings.output.compensation == Compensation::Resolve
    }

    /// A word as the programmer wrote it.
    pub(super) fn word_text(&self, span: Span) -> String {
        let loc = self.loc(span);
        readable(&self.job.sources.bytes(loc.file, loc.span)).into_owned()
    }

    /// `word` says again what an earlier word of the block says.
    #[cold]
    pub(super) fn twice<T>(&self, word: Word, block: &Block) -> Outcome<T> {
        let text = self.word_text(word.span);
        let found = codes::P1002::repeats_word_of_this_block(&text).at(self.loc(word.span));
        let first = block.words.iter().find(|first| same_matter(first.addr, word.addr));
        let found = match first.filter(|first| first.span.start < word.span.start) {
            Some(first) => found.also(self.loc(first.span), Label::FirstOne),
            None => found,
        };
        self.report(found);
        Err(Reported)
    }

    #[cold]
    pub(super) fn not_admitted<T>(&self, word: Word, head: &str) -> Outcome<T> {
        let text = self.word_text(word.span);
        if let Some(problem) = self.misprinted_word(word.span) {
            self.report_problem(problem);
            return Err(Reported);
        }
        let help = match (word.addr, head) {
            (Addr::Axis { .. }, "CP") => "CP takes the angle PA or IPA, and the axes outside the plane",
            (Addr::PolarRadius { .. }, "CP") => "the radius of CP is the distance from the pole",
            (Addr::Radius { .. }, "L" | "C" | "CT" | "LP" | "CP" | "CTP") => {
                "only CR takes a radius; compensation is R0, RL or RR"
            }
            (Addr::M(_), "RND" | "CHF") => "write the M function into a block before the corner or after it",
            _ => "remove the word, or put it into a block where it belongs",
        };
        let block = if head.is_empty() { "this block".to_owned() } else { format!("this {head} block") };
        self.refuse(word.span, codes::P1003::has_no_place(&text, &block).help(help))
    }

    /// What is wrong with the number that a word belongs to: `X-1.#IND`, `X1e5`.
    fn misprinted_word(&self, span: Span) -> Option<Problem> {
        let block = self.block_span();
        let text = self.word_text(block);
        // Decoded text is as long as its bytes where a number stands in it.
        let at = span.start.checked_sub(block.start)?;
        let mut problem = misprinted(text.as_bytes(), Span::at(at, span.end - span.start))?;
        problem.span = Span { start: problem.span.start + block.start, end: problem.span.end + block.start };
        Some(problem)
    }

    /// FZ, but neither FT nor FMAXT, which give the time of the block.
    pub(super) fn counts_teeth(&self, word: Word) -> Outcome {
        let text = self.word_text(word.span);
        if text.to_ascii_uppercase().starts_with("FZ") {
            return Ok(());
        }
        self.refuse(word.span, codes::K9013::gives_time_of_block_in_place(&text))
    }

    #[cold]
    pub(super) fn feed_not_positive<T>(&self, span: Span, value: f64) -> Outcome<T> {
        let text = self.word_text(span);
        let what = if text.contains(['Q', 'q']) { format!("`{text}` is {value}") } else { format!("`{text}`") };
        self.refuse(span, codes::O1001::feed_has_to_be_above_zero(&what))
    }

    /// How FU and FZ are written outside of path blocks is not confirmed by a manual page.
    pub(super) fn reads_feed_by_word(&self, span: Span) {
        let text = self.word_text(span);
        let what = if text.to_ascii_uppercase().contains("FZ") { "for each tooth" } else { "for each revolution" };
        self.say_once(span, codes::K8026::is_read_as_feed(&text, &what));
    }

    /// A statement without influence on the path.
    pub(super) fn left_out(&self, what: &str) {
        self.say_here(codes::K2805::has_no_word_in_output(&what));
    }

    /// Says something once for the whole program, whatever a missing program would have done.
    pub(super) fn note(&self, place: impl Into<Where>, fault: Fault) {
        self.job.diags.push_once(fault.at(self.loc(place)));
    }
}
