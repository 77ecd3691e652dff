//! What can be measured of partc's reliability: the test suite asks for few tries, `examples/quality.rs` for as many as the
//! quality of a release wants.

pub mod arcs;
pub mod kills;
pub mod malformed;
pub mod names;
pub mod numbers;
pub mod process;
pub mod same;
pub mod stops;
