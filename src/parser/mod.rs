//! Blocks: one entry per dialect, one LALRPOP grammar each.
//!
//! In: the text of one logical block. Out: the block as data, spans counted from its start. Parsing never
//! fails as a whole: a block that cannot be read is reported and has no statement.

pub mod klartext;
mod literal;
pub mod mtc200;
pub mod not_a_number;
pub mod problem;
pub mod sinumerik;
pub mod straight;
pub mod symbols;
pub mod turning;
