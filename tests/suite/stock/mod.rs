//! Material that a tool takes off: what cycles promise about gouges, rapid traverse, depth and what is left, for calls at random.

mod grooves;
mod klartext_pockets;
mod klartext_studs;
mod layers;
pub mod milling;
mod pockets;
mod regions;
mod turning;
