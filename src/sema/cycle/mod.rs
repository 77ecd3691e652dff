//! Machining cycles of every dialect: a row says what a call takes and needs, [`Given`](given::Given) holds the arguments once they fit
//! their rows, and a pure function of both makes the arguments of `ir::cycle`.
//!
//! ```text
//! call ──► Given ──► its row: rules, requirements ──► plan(&Call) ──► acts, remarks ──► carried out by the dialect
//! ```
//!
//! A plan reports nothing, writes no prose and changes no state: what is wrong comes back as a [`Refusal`](call::Refusal), what is worth
//! saying stands in the call. The dialect reports both in one place, and carries out what was planned.

pub mod call;
pub mod given;
pub mod row;
pub mod text;
