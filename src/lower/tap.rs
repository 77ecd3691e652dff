//! A tap without a compensating chuck: through the frame, along the axis of the tool alone.

use crate::diag::{Fault, codes};
use crate::ir::contour::{Coords, Move, Path, Thread};
use crate::ir::motion::{self, Place};
use crate::ir::tap::Stroke;
use crate::ir::{Frame, Origin, Pos, Side, Tap};
use crate::machine::Axis;

use super::{Lower, at, compensation, limits};

/// Moves that a stroke counts as: in and out.
const STROKE: u64 = 2;
/// What a frame may turn or stretch an axis by and still leave it as it is.
const STILL: f64 = 1e-12;

impl Lower<'_> {
    /// A tap from where the tool stands.
    pub(super) fn tap_hole(&mut self, tap: &Tap, origin: &Origin) {
        if self.recording.is_some() {
            // Who takes the contour says that no thread belongs in one.
            let mut end = Pos::UNKNOWN;
            end.set(tap.axis, tap.end());
            let path = Path::Thread(Thread { lead: tap.lead, along: Some(tap.axis) });
            return self.path_element(&Move { end, path, side: Side::None, coords: Coords::Frame }, origin);
        }
        self.moves += STROKE * tap.strokes.len() as u64;
        self.start.forget(tap.axis);
        self.flush();
        let mut end = self.at;
        end.set(tap.axis, tap.end());
        if !self.compensator.is_idle(Side::None) {
            return self.refuse(compensation::cycle_beside(origin), &end, origin);
        }
        match self.placed(tap) {
            Ok((tap, place)) => {
                self.check_limits(&tap, &place, origin);
                self.chain.lost();
                self.at = end;
                self.last.forget();
                self.out.tap(&tap, &place, origin);
            }
            Err(fault) => self.refuse(Some(Box::new(at(*origin, fault))), &end, origin),
        }
    }

    /// The tap in workpiece coordinates.
    fn placed(&self, tap: &Tap) -> Result<(Tap, Place), Fault> {
        if self.machine_axes.transformer.is_some() {
            return Err(codes::G3339::hole_is_tapped_inside());
        }
        let frame = &self.ctx.frame;
        if !leaves_alone(frame, tap.axis) {
            return Err(codes::G3050::frame_turns_mirrors_or_scales(&tap.axis.letter()));
        }
        let mut stands = self.at;
        stands.set(tap.axis, tap.start);
        let mapped = |height: f64| {
            let mut place = stands;
            place.set(tap.axis, height);
            frame.apply(&place).get(tap.axis).unwrap_or(height)
        };
        let strokes =
            tap.strokes.iter().map(|stroke| Stroke { to: mapped(stroke.to), back: mapped(stroke.back), ..*stroke });
        let placed =
            Tap { start: mapped(tap.start), surface: mapped(tap.surface), strokes: strokes.collect(), ..tap.clone() };
        Ok((placed, Place { at: frame.apply(&stands), plane: self.ctx.plane }))
    }

    fn check_limits(&self, tap: &Tap, place: &Place, origin: &Origin) {
        if self.machine.limits.is_empty() || self.machine_axes.tilted {
            return;
        }
        for to in tap.strokes.iter().flat_map(|stroke| [stroke.to, stroke.back]) {
            let mv = place.along(tap, to, motion::Path::Thread { lead: tap.lead });
            limits::check(&mv, &self.machine.limits, *origin, self.diags);
        }
    }
}

/// Does the frame only shift this axis, whatever it does to the others?
fn leaves_alone(frame: &Frame, axis: Axis) -> bool {
    let (linear, own) = (frame.linear(), axis.index());
    let unit = |i: usize| f64::from(u8::from(i == own));
    axis.is_main()
        && (0..3).all(|i| (linear[(own, i)] - unit(i)).abs() <= STILL && (linear[(i, own)] - unit(i)).abs() <= STILL)
}
