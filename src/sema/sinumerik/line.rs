//! A block and the text that it was read from.

use crate::parser::sinumerik::ast::{Args, Block, Formula, Op, Target};
use crate::text::Span;

/// A block with its text, in which the spans of its words count.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'b> {
    pub block: &'b Block,
    /// Empty for a block of words that stands in its file as it was read.
    pub text: &'b [u8],
}

impl<'b> Line<'b> {
    /// The operations of a formula.
    pub fn ops(self, formula: Formula) -> &'b [Op] {
        self.block.formula(formula)
    }

    /// The arguments of a call.
    pub fn arguments(self, args: Args) -> &'b [Formula] {
        self.block.arguments(args)
    }

    /// What stands in the brackets of a target.
    pub fn indices_of(self, target: Target) -> &'b [Formula] {
        self.arguments_of(if let Target::Indexed(_, args) = target { Some(args) } else { None })
    }

    /// The arguments of a call that may have none.
    pub fn arguments_of(self, args: Option<Args>) -> &'b [Formula] {
        args.map_or(&[], |args| self.block.arguments(args))
    }
}

/// A text that is executed as a block once the block that gives it is done with.
#[derive(Debug)]
pub(super) struct NextText {
    pub text: Vec<u8>,
    /// The words that give it.
    pub span: Span,
}
