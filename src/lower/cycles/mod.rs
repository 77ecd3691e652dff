pub mod infeed;
pub mod thread;
pub mod track;
