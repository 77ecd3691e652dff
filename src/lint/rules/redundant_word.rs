//! A modal word says what holds already.

use crate::diag::{Diagnostic, codes};
use crate::lint::fix::Fix;
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::{Surveyed, What};
use crate::text::decode::readable;

#[derive(Debug, Default)]
pub(super) struct RedundantWord {
    groups: [Option<f64>; 8],
    feed: Option<f64>,
    speed: Option<f64>,
}

impl RedundantWord {
    pub(super) fn new(_: &Setup<'_>) -> RedundantWord {
        RedundantWord::default()
    }
}

impl SourceRule for RedundantWord {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        let block = read.block;
        let breaks = |what: &What| !matches!(what, What::Word { .. });
        if block.skip || block.is_bad || block.items.iter().any(|item| breaks(&item.what)) {
            *self = RedundantWord::default();
            return;
        }
        for item in block.items {
            let What::Word { letter, value } = item.what else { continue };
            let place = match letter {
                b'G' => group(value).map(|group| &mut self.groups[group]),
                b'F' => Some(&mut self.feed),
                b'S' => Some(&mut self.speed),
                // A tool change, a stop: what holds behind them is for the machine to say.
                b'T' | b'M' | b'D' => {
                    *self = RedundantWord::default();
                    None
                }
                _ => None,
            };
            let Some(place) = place else { continue };
            if place.replace(value) == Some(value) && !self.is_alone(block) {
                let loc = read.loc(item.span);
                let shown = readable(item.span.of(block.text)).into_owned();
                let found = Diagnostic::new(codes::L2008, loc, format!("`{shown}` holds already"));
                let found = found.help("remove the word");
                let fix = Fix::removal(&found, block.text, block.site.at);
                told.found_with(found, fix);
            }
        }
    }
}

impl RedundantWord {
    /// A block of this word alone says something to people.
    fn is_alone(&self, block: &Surveyed<'_>) -> bool {
        block.items.len() < 2
    }
}

/// The group of a modal G function, where all controls agree on it.
fn group(value: f64) -> Option<usize> {
    let groups: [&[f64]; 5] = [
        &[0.0, 1.0, 2.0, 3.0, 33.0],
        &[17.0, 18.0, 19.0],
        &[90.0, 91.0],
        &[40.0, 41.0, 42.0],
        &[94.0, 95.0, 96.0, 97.0],
    ];
    groups.iter().position(|group| group.contains(&value))
}
