//! A literal has more decimals than controls resolve.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::{LONG, What};
use crate::text::decode::readable;

/// Most decimals that controls resolve.
const MOST_DECIMALS: usize = LONG - 1;

#[derive(Debug, Default)]
pub(super) struct NumberPrecision {
    said: bool,
}

impl NumberPrecision {
    pub(super) fn new(_: &Setup<'_>) -> NumberPrecision {
        NumberPrecision::default()
    }
}

impl SourceRule for NumberPrecision {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        if self.said || read.block.is_empty {
            return;
        }
        for item in read.block.items {
            let text = item.span.of(read.block.text);
            let decimals = memchr::memchr2(b'.', b',', text)
                .map_or(0, |at| text[at + 1..].iter().filter(|b| b.is_ascii_digit()).count());
            if matches!(item.what, What::Word { .. }) && decimals > MOST_DECIMALS {
                self.said = true;
                let message = format!("`{}` has {decimals} decimals", readable(text));
                told.say.found(Diagnostic::new(codes::L2012, read.loc(item.span), message).help("round it"));
                return;
            }
        }
    }
}
