//! A modal word says what holds already.

use crate::diag::Diagnostic;
use crate::lint::fix::Fix;
use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::{Surveyed, What};
use crate::text::Span;
use crate::text::decode::readable;

super::rule! { L2008 Source RedundantWord Note off "word-redundant"
    what "word says what holds already"
    why "A modal G function, an F or an S is programmed, and the same holds already from a block before. It does no harm. Off by \
        default; `partc check --fix` removes it where the program does the same without it. F and S of a tool call are those of \
        the tool, and no modal words."
    example r#"
-- Example (L2008_fires.MPF)
; G1 and F100 hold already.
G0 X0 Y0 Z5
G1 X5 F100
G1 Y5 F100
M30
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        redundant(word) "`{word}` holds already" help "remove the word";
    }
}

/// M functions up to here are spindle, coolant, stop and change.
const LAST_PLAIN_M: f64 = 69.0;

/// Most findings that wait for the end of the program.
const MOST_WAITING: usize = 1 << 20;

/// What holds, as far as the blocks in a row say.
#[derive(Debug, Default)]
struct Modal {
    groups: [Option<f64>; 5],
    feed: Option<f64>,
    speed: Option<f64>,
}

#[derive(Debug, Default)]
pub(super) struct RedundantWord {
    modal: Modal,
    waiting: Vec<(Diagnostic, Fix)>,
    /// A jump leads to a block number, or nobody knows where: then other words may hold at any block.
    jumps: bool,
}

impl RedundantWord {
    pub(super) fn new(_: &Setup<'_>) -> RedundantWord {
        RedundantWord::default()
    }
}

impl SourceRule for RedundantWord {
    fn block(&mut self, read: &Read<'_>, _: &mut Report<'_>) {
        let block = read.block;
        self.jumps |= block.items.iter().any(|item| match &item.what {
            What::Uses(name) => is_number(name),
            what => *what == What::UsesUnknown,
        });
        let breaks = |what: &What| !matches!(what, What::Word { .. });
        let breaks = block.items.iter().any(|item| breaks(&item.what) || gives_meaning(&item.what));
        if self.jumps || block.skip || block.is_bad || breaks {
            self.modal = Modal::default();
            return;
        }
        let Some(counts) = self.modal.feed_and_speed_count(block) else {
            self.modal = Modal::default();
            return;
        };
        for item in block.items {
            let What::Word { letter, value } = item.what else { continue };
            let place = match letter {
                b'G' => group(value).map(|group| &mut self.modal.groups[group]),
                b'F' => Some(&mut self.modal.feed).filter(|_| counts),
                b'S' => Some(&mut self.modal.speed).filter(|_| counts),
                // A tool change, a stop: what holds behind them is for the machine to say.
                b'T' | b'M' | b'D' => {
                    self.modal = Modal::default();
                    None
                }
                _ => None,
            };
            let Some(place) = place else { continue };
            if place.replace(value) == Some(value) && !is_alone(block, item.span) && self.waiting.len() < MOST_WAITING {
                let loc = read.loc(item.span);
                let shown = readable(item.span.of(block.text)).into_owned();
                let found = L2008::redundant(&shown).at(loc);
                let fix = Fix::removal(&found, block.text, block.site.at);
                self.waiting.push((found, fix));
            }
        }
    }

    fn wants_straight(&self) -> bool {
        true
    }

    fn finish(&mut self, report: &mut Report<'_>) {
        let waiting = std::mem::take(&mut self.waiting);
        for (found, fix) in waiting.into_iter().filter(|_| !self.jumps) {
            report.found_with(found, fix);
        }
    }
}

impl Modal {
    /// Do F and S of this block say what they said before? `None` for a block with a G function that may give them, or
    /// anything else, another meaning.
    fn feed_and_speed_count(&mut self, block: &Surveyed<'_>) -> Option<bool> {
        let mut kind = None;
        for item in block.items {
            let What::Word { letter: b'G', value } = item.what else { continue };
            if group(value)? == FEED {
                kind = Some(value);
            }
        }
        let before = self.groups[FEED];
        if kind.is_some() && kind != before {
            // Another kind of feed or speed wants its value anew.
            (self.feed, self.speed) = (None, None);
        }
        // Under G93 each block has a feed of its own.
        Some(kind.or(before) != Some(BY_TIME))
    }
}

/// A block number: `N100`.
fn is_number(name: &str) -> bool {
    name.strip_prefix('N').is_some_and(|digits| digits.bytes().all(|b| b.is_ascii_digit()))
}

/// A block of this word alone says something to people. The name of a function beside it moves nothing.
fn is_alone(block: &Surveyed<'_>, word: Span) -> bool {
    let (words, text) = (block.words, block.text);
    let before = Span { start: words.start, end: word.start.max(words.start) };
    let after = Span { start: word.end.min(words.end), end: words.end };
    ![before, after].iter().any(|part| part.of(text).iter().any(u8::is_ascii_digit))
}

/// An M function that gives F or S of its block another meaning: `M19 S90`, `M103 F50`, `M128 F1000`.
fn gives_meaning(what: &What) -> bool {
    matches!(*what, What::Word { letter: b'M', value } if value == 19.0 || value > LAST_PLAIN_M)
}

/// G94 and its like among the groups.
const FEED: usize = 4;
const BY_TIME: f64 = 93.0;

/// The group of a modal G function, where all controls agree on it.
fn group(value: f64) -> Option<usize> {
    let groups: [&[f64]; 5] = [
        &[0.0, 1.0, 2.0, 3.0, 33.0],
        &[17.0, 18.0, 19.0],
        &[90.0, 91.0],
        &[40.0, 41.0, 42.0],
        &[93.0, 94.0, 95.0, 96.0, 97.0],
    ];
    groups.iter().position(|group| group.contains(&value))
}
