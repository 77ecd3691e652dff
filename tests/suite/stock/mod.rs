//! Material that a tool takes off: what cycles promise about gouges, rapid traverse, depth and what is left, for calls at random.

mod corner;
mod cut_off;
mod faces;
mod grooves;
mod klartext_bores;
mod klartext_contours;
mod klartext_frames;
mod klartext_old_cycles;
mod klartext_pockets;
mod klartext_studs;
mod layers;
mod milled_threads;
pub mod milling;
mod paths;
mod pockets;
mod region_entries;
mod region_middle;
mod regions;
mod removal;
mod roughing;
mod spigots;
mod turning;
mod undercuts;
