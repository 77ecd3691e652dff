//! Last pass: what the axes and spindles of the machine do for a path that is complete. Rotary axes turn the workpiece where
//! the program sees a plane ([`transformation`](super::transformation)), and a feed per turn of another spindle than the
//! first becomes one per minute, because targets count the turns of their first one.

use std::collections::BTreeMap;

use crate::diag::{Diagnostic, Diags, codes};
use crate::ir::function::Spindle;
use crate::ir::motion::{self, Move, Path};
use crate::ir::{Feed, Function, Origin};
use crate::machine::{Axis, Machine};

use super::transformation::Transformer;
use super::{at, limits};

/// Where the path goes.
pub struct Out<'a> {
    pub diags: &'a Diags,
    pub machine: &'a Machine,
    pub sink: &'a mut dyn motion::Sink,
    pub machine_axes: &'a mut MachineAxes,
}

impl<'a> Out<'a> {
    /// In a tilted plane no coordinate is that of an axis of the machine.
    #[inline]
    fn limits(&self) -> Limits<'a> {
        (!self.machine.limits.is_empty() && !self.machine_axes.tilted).then_some(&self.machine.limits)
    }

    #[inline]
    pub fn movement(&mut self, mv: &Move, origin: &Origin) {
        if self.machine_axes.is_idle() {
            return print(self.diags, self.limits(), self.sink, mv, origin);
        }
        if let Err(found) = self.carried(mv, origin) {
            self.diags.push(*found);
            self.lost(origin);
        }
    }

    #[cold]
    fn carried(&mut self, mv: &Move, origin: &Origin) -> Result<(), Box<Diagnostic>> {
        let path = self.machine_axes.spindle.per_minute(&mv.path, origin)?;
        let mv = Move { path, ..*mv };
        let (diags, limits) = (self.diags, self.limits());
        let sink = &mut *self.sink;
        match &mut self.machine_axes.transformer {
            Some(transformer) => transformer.carry(&mv, origin, &mut |mv| print(diags, limits, sink, mv, origin)),
            None => {
                print(diags, limits, sink, &mv, origin);
                Ok(())
            }
        }
    }

    pub fn function(&mut self, function: &Function, origin: &Origin) {
        if self.machine_axes.follow(function) {
            self.sink.function(function, origin);
        }
    }

    /// What the target believes of its position no longer holds.
    pub fn lost(&mut self, origin: &Origin) {
        if let Some(transformer) = &mut self.machine_axes.transformer {
            transformer.lost();
        }
        self.sink.lost(origin);
    }

    /// The contour that the next moves run beside, where machine and program see it alike.
    pub fn programmed(&mut self, mv: &Move, start: &crate::ir::Pos) {
        if self.machine_axes.transformer.is_none() {
            self.sink.programmed(mv, start);
        }
    }
}

/// Travel limits that hold, where there are some.
type Limits<'m> = Option<&'m BTreeMap<Axis, (f64, f64)>>;

#[inline]
fn print(diags: &Diags, limits: Limits<'_>, sink: &mut dyn motion::Sink, mv: &Move, origin: &Origin) {
    if let Some(limits) = limits
        && !mv.machine
    {
        limits::check(mv, limits, *origin, diags);
    }
    sink.movement(mv, origin);
}

/// What stands between the path and the machine.
#[derive(Debug, Default)]
pub struct MachineAxes {
    pub transformer: Option<Box<Transformer>>,
    /// The working plane is tilted: what a coordinate of it is for an axis of the machine is not known.
    pub tilted: bool,
    spindle: FeedSpindle,
}

impl MachineAxes {
    /// Does the machine move as the path says?
    #[inline]
    pub fn is_idle(&self) -> bool {
        self.transformer.is_none() && self.spindle.number.is_none()
    }

    /// Takes note of a function; false for one that the target does not hear of.
    fn follow(&mut self, function: &Function) -> bool {
        match function {
            Function::FeedSpindle(number) => {
                self.spindle.number = (*number != FIRST_SPINDLE).then_some(*number);
                return false;
            }
            Function::SpindleOf { number, spindle: Spindle::Speed(speed) } => {
                self.spindle.speeds.insert(*number, *speed);
            }
            Function::ToolChange { .. } | Function::WorkOffset(_) => {
                if let Some(transformer) = &mut self.transformer {
                    transformer.displaced(matches!(function, Function::WorkOffset(_)));
                }
            }
            Function::Transformation(_) => return false,
            Function::Tilt(_)
            | Function::ToolPrepare { .. }
            | Function::Cutter(_)
            | Function::Spindle(_)
            | Function::SpindleOf { .. }
            | Function::Coolant(_)
            | Function::Dwell(_)
            | Function::Stop
            | Function::OptionalStop
            | Function::Aux(_)
            | Function::Plane(_)
            | Function::PathControl(_)
            | Function::Comment(_)
            | Function::Remark(_)
            | Function::End { .. } => {}
        }
        true
    }
}

/// The spindle whose turns targets count.
const FIRST_SPINDLE: u8 = 1;

/// The spindle whose turns a feed per revolution counts, where it is not the first one.
#[derive(Debug, Default)]
struct FeedSpindle {
    number: Option<u8>,
    /// Turns per minute, by spindle.
    speeds: BTreeMap<u8, f64>,
}

impl FeedSpindle {
    /// The path with a feed that every target counts alike.
    fn per_minute(&self, path: &Path, origin: &Origin) -> Result<Path, Box<Diagnostic>> {
        let (Some(number), Some(Feed::PerRevolution(feed))) = (self.number, path.feed()) else { return Ok(*path) };
        let Some(speed) = self.speeds.get(&number).filter(|speed| **speed > 0.0) else {
            return Err(Box::new(at(*origin, codes::G3336::feed_counts_turns_of_spindle(&number))));
        };
        let feed = Feed::PerMinute(feed * speed);
        Ok(match path {
            Path::Arc(arc, _) => Path::Arc(*arc, feed),
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => Path::Line(feed),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_feed_in_turns_of_another_spindle_needs_its_speed() {
        let path = Path::Line(Feed::PerRevolution(0.2));
        let of = |number: Option<u8>, speeds: &[(u8, f64)]| {
            let spindle = FeedSpindle { number, speeds: speeds.iter().copied().collect() };
            spindle.per_minute(&path, &Origin::default()).map_err(|found| found.code.id)
        };
        assert_eq!(of(None, &[]), Ok(path));
        assert_eq!(of(Some(2), &[(2, 1500.0)]), Ok(Path::Line(Feed::PerMinute(300.0))));
        for speeds in [&[][..], &[(3, 1500.0)], &[(2, 0.0)]] {
            assert_eq!(of(Some(2), speeds), Err("G3336"), "{speeds:?}");
        }
    }
}
