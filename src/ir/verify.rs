//! Checks what every motion stream must hold: continuity, arcs on their circles, finite numbers.
//!
//! Installed in debug builds and tests between lowering and printing; a failure is a defect of the compiler.

use crate::geo::distance;

use super::motion::{Item, Kind, Path, Sink};
use super::{Function, Pos};

/// How far a point may be off, relative to the radius, in mm.
const TOLERANCE: f64 = 1e-6;

/// Passes items on and checks them.
pub struct Verify<'a> {
    out: &'a mut dyn Sink,
    at: Pos,
}

impl std::fmt::Debug for Verify<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Verify").field("at", &self.at).finish_non_exhaustive()
    }
}

impl<'a> Verify<'a> {
    pub fn new(out: &'a mut dyn Sink) -> Verify<'a> {
        Verify { out, at: Pos::UNKNOWN }
    }
}

impl Sink for Verify<'_> {
    fn item(&mut self, item: Item) {
        match &item.kind {
            Kind::Move(mv) => {
                assert!(mv.end.iter().all(|(_, v)| v.is_finite()), "{item:?}");
                if let Path::Arc(arc) = &mv.path {
                    let to = mv.end.in_plane(arc.plane).expect("an arc has an end in its plane");
                    let radius = distance(arc.from, arc.center);
                    let tol = TOLERANCE * (1.0 + radius);
                    assert!((distance(to, arc.center) - radius).abs() <= tol, "end off the circle: {item:?}");
                    assert!(arc.sweep != 0.0 && arc.sweep.is_finite(), "{item:?}");
                    if let Some(from) = self.at.in_plane(arc.plane) {
                        assert!(distance(from, arc.from) <= tol, "gap before an arc: {item:?} at {:?}", self.at);
                    }
                }
                if mv.machine {
                    for axis in mv.axes.iter() {
                        self.at.forget(axis);
                    }
                } else {
                    self.at.update(&mv.end);
                }
            }
            Kind::Function(Function::WorkOffset(_) | Function::ToolChange { .. }) | Kind::Lost => self.at = Pos::UNKNOWN,
            Kind::Function(_) => {}
        }
        self.out.item(item);
    }
}
