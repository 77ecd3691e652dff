//! Any bytes as a block: no panic, spans inside the block, and the fast path equals the grammar.
#![no_main]

use libfuzzer_sys::fuzz_target;
use partc::parser::turning::ast::Block;
use partc::parser::turning::{literal, parse_block, parse_statement};

fuzz_target!(|bytes: &[u8]| {
    let (mut block, mut problems) = (Block::default(), Vec::new());
    parse_block(bytes, &mut block, &mut problems);
    for word in &block.words {
        assert!(word.span.end as usize <= bytes.len());
    }
    for problem in &problems {
        assert!(problem.span.end as usize <= bytes.len() + 1);
    }
    let mut fast = Block::default();
    if literal::parse(bytes, 0, &mut fast) {
        let end = fast.comment.take().map_or(bytes.len(), |span| span.start as usize);
        let (mut slow, mut problems) = (Block::default(), Vec::new());
        parse_statement(&bytes[..end], 0, &mut slow, &mut problems);
        assert_eq!(fast, slow);
    }
});
