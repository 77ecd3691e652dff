pub mod thread;
pub mod turning;
