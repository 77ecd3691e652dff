//! The modal state that every dialect keeps, by owner: each part guards its own rules and answers in few verbs.
//!
//! A part knows no words and reports nothing: it says what it knows, and the dialect says it in its own words.

pub mod compensation;
pub mod corner;
pub mod feed;
pub mod hidden;
pub mod m_functions;
pub mod orientation;
pub mod plane;
pub mod position;
pub mod spindle;
pub mod start;
