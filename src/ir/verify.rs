//! Checks what every motion stream must hold: continuity, arcs on their circles, finite numbers.
//!
//! Installed in debug builds and tests between lowering and printing; a failure is a defect of the compiler.

use crate::geo::distance;

use super::motion::{Move, Path, Sink};
use super::{Function, Origin, Pos};

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
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        assert!(mv.end.iter().all(|(_, v)| v.is_finite()), "{mv:?}");
        if let Path::Arc(arc, _) = &mv.path {
            let to = mv.end.in_plane(arc.plane).expect("an arc has an end in its plane");
            let radius = distance(arc.from, arc.center);
            let tol = TOLERANCE * (1.0 + radius);
            assert!((distance(to, arc.center) - radius).abs() <= tol, "end off the circle: {mv:?}");
            assert!(arc.sweep != 0.0 && arc.sweep.is_finite(), "{mv:?}");
            if let Some(from) = self.at.in_plane(arc.plane) {
                assert!(distance(from, arc.from) <= tol, "gap before an arc: {mv:?} at {:?}", self.at);
            }
        }
        if mv.machine {
            for axis in mv.axes.iter() {
                self.at.forget(axis);
            }
        } else {
            self.at.update(&mv.end);
        }
        self.out.movement(mv, origin);
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        if matches!(function, Function::WorkOffset(_) | Function::ToolChange { .. }) {
            self.at.clear();
        }
        self.out.function(function, origin);
    }

    fn lost(&mut self, origin: &Origin) {
        self.at.clear();
        self.out.lost(origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.at.update(at);
        self.out.begins_at(at);
    }

    fn full(&self) -> bool {
        self.out.full()
    }
}
