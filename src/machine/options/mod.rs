//! The keys of `partc.toml` beside the types that they set, one file an owner. A new key is a row here and a field.

pub mod control;
pub mod cycles;
pub mod klartext;
pub mod klartext_cycles;
pub mod lint;
pub mod machine;
pub mod mtc200;
pub mod output;
pub mod sinumerik;
pub mod turning;
pub mod undercut;
