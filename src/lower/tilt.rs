//! Tilted working planes: the path counts in them as in any other plane; what this pass sees to is that rotary axes turn
//! where the tool is clear of the part.

use crate::diag::{Answer, codes};
use crate::ir::contour::{self, Coords};
use crate::ir::{Function, Origin, Pos, Side, Tilting};
use crate::machine::{Axis, AxisSet};

use super::{Lower, at};

/// Is the tool where the program took it away from the part?
#[derive(Debug, Default)]
pub(super) struct Clear(bool);

impl Clear {
    /// Z in machine coordinates takes the tool away, and what goes on in machine coordinates keeps it there; a move by the
    /// coordinates of the program may lead back. Rotary axes alone are no way of the tool.
    #[inline]
    pub fn follow(&mut self, mv: &contour::Move) {
        let machine = mv.coords == Coords::Machine;
        if machine || self.0 {
            self.moves(machine, mv.end.known());
        }
    }

    #[cold]
    fn moves(&mut self, machine: bool, axes: AxisSet) {
        self.0 = if machine { self.0 || axes.contains(Axis::Z) } else { axes.common(AxisSet::MAIN).is_empty() };
    }

    /// Nobody knows where the tool is.
    pub fn lost(&mut self) {
        self.0 = false;
    }
}

impl Lower<'_> {
    /// The working plane is tilted, or is so no more.
    #[cold]
    pub(super) fn tilt(&mut self, tilting: &Tilting, origin: &Origin) {
        self.flush();
        if !self.compensator.is_idle(Side::None) {
            self.diags.push(at(*origin, codes::G3204::working_plane_is_tilted()));
            self.position_lost(origin);
        }
        if self.machine_axes.transformer.is_some() {
            self.diags.push(at(*origin, codes::G3339::plane_is_tilted()));
        }
        if tilting.turns() && !self.clear.0 {
            self.retract(origin);
        }
        if !self.machine.limits.is_empty() && tilting.plane().is_some() {
            self.diags.push_once(at(*origin, codes::G3341::limits_are_not_checked()));
        }
        self.machine_axes.tilted = tilting.plane().is_some();
        self.at.clear();
        for axis in AxisSet::MAIN.iter() {
            self.start.forget(axis);
        }
        self.last.forget();
        self.chain.lost();
        let function = Function::Tilt(Box::new(*tilting));
        let (corners, mut finish) = self.split();
        corners.function(&function, origin, finish.diags, &mut |event| finish.event(event));
    }

    /// The tool leaves the part by the place that the configuration gives.
    fn retract(&mut self, origin: &Origin) {
        let retract = &self.machine.swivel_retract;
        let Some(height) = retract.get(&Axis::Z) else {
            let asking = codes::G3340::rotary_axes_turn_beside_part();
            let answer = Answer::entry("machine", "swivel_retract", Axis::Z.letter());
            return self.diags.push(at(*origin, asking.answer(answer)));
        };
        let mut steps = vec![Pos::UNKNOWN; 2];
        steps[0].set(Axis::Z, *height);
        for axis in [Axis::X, Axis::Y] {
            if let Some(place) = retract.get(&axis) {
                steps[1].set(axis, *place);
            }
        }
        let comment = Function::Comment(b"retract before the rotary axes turn".to_vec());
        let (corners, mut finish) = self.split();
        corners.function(&comment, origin, finish.diags, &mut |event| finish.event(event));
        for end in steps.into_iter().filter(|step| !step.known().is_empty()) {
            let path = contour::Path::Rapid;
            self.path_element(&contour::Move { end, path, side: Side::None, coords: Coords::Machine }, origin);
        }
        self.flush();
    }
}
