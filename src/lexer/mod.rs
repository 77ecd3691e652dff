//! Tokens: one lexer per dialect. An address and its literal value are one token.
//!
//! In: the text of one logical block. Out: tokens with spans counted from the start of the block. A byte
//! that fits nothing becomes a `Bad` token, never an end of the stream.

pub mod formula;
pub mod klartext;
pub mod mtc200;
pub mod sinumerik;
pub mod turning;
