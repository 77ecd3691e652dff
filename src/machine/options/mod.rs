//! What the keys of `partc.toml` choose among, one file an owner. Their rows stand in [`keys`](super::keys).

pub mod cycles;
pub mod klartext;
pub mod klartext_cycles;
pub mod mtc200;
pub mod sinumerik;
pub mod turning;
