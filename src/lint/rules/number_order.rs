//! A block number is not larger than the one before.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;

super::rule! { L2005 Source NumberOrder Note off "block-number-order"
    what "block number is not larger than the one before"
    why "The number of a block is smaller than, or the same as, that of the block before it. Blocks were moved or joined from two \
        programs. Controls run them in the order in which they stand; a search for a block number finds the wrong one. Said once. \
        Off by default; `partc check --fix --unsafe-fixes` numbers the blocks anew where nothing jumps to a number."
    example r#"
-- Example (L2005_fires.H)
0 BEGIN PGM P MM
; 2 stands after 3.
1 L X+0 Y+0 Z+5 R0 F300
3 L X+10
2 L X+20
4 L Z+50 FMAX M30
5 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        out_of_order(number, last) "block {number} stands after block {last}" help "number the blocks anew";
    }
}

#[derive(Debug, Default)]
pub(super) struct NumberOrder {
    last: Option<u32>,
    said: bool,
}

impl NumberOrder {
    pub(super) fn new(_: &Setup<'_>) -> NumberOrder {
        NumberOrder::default()
    }
}

impl SourceRule for NumberOrder {
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        let block = read.block;
        self.last = block.passed.or(self.last);
        let Some(number) = block.number else { return };
        if block.items.iter().any(|item| item.what == What::Begins) {
            self.last = None;
        }
        if let Some(last) = self.last.filter(|last| number <= *last && !self.said) {
            self.said = true;
            let found = L2005::out_of_order(&number, &last).at(read.words());
            report.say.found(found);
        }
        self.last = Some(number);
    }
}
