//! A rapid move ends inside the blank.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step, TINY};
use crate::lint::turned::Turned;
use crate::machine::axis::Axis;

#[derive(Debug, Default)]
pub(super) struct RapidIntoBlank {
    blank: Option<Blank>,
    deepest: Option<f64>,
    turned: Option<Turned>,
}

impl RapidIntoBlank {
    pub(super) fn new(setup: &Setup<'_>) -> RapidIntoBlank {
        RapidIntoBlank { blank: setup.blank, turned: setup.bar.map(Turned::new), ..RapidIntoBlank::default() }
    }
}

impl MotionRule for RapidIntoBlank {
    fn wants_moves(&self) -> bool {
        self.blank.is_some() || self.turned.is_some()
    }

    fn movement(&mut self, step: &Step<'_>, _: &Machine, say: Say<'_>) {
        if let Some(turned) = &mut self.turned {
            bar(turned, step, say);
        }
        let Some(blank) = self.blank else { return };
        let axis = step.tool_axis();
        let Some(depth) = step.to.get(axis) else { return };
        if step.cuts() {
            self.deepest = Some(self.deepest.map_or(depth, |deepest| deepest.min(depth)));
            return;
        }
        let inside = Axis::ALL[..3].iter().all(|axis| {
            let margin = 0.01;
            step.to.get(*axis).is_some_and(|value| {
                value > blank.min[axis.index()] + margin && value < blank.max[axis.index()] - margin
            })
        });
        let deeper = self.deepest.is_none_or(|deepest| depth < deepest - TINY);
        if step.is_rapid() && !step.of_cycle && inside && deeper {
            let top = blank.max[axis.index()];
            let message = format!(
                "this rapid move ends at {}{depth:.3}, inside the blank, whose top is at {top:.3}",
                axis.letter()
            );
            say.about(codes::L1006, step.origin, message, "stop above the blank, and go on at feed");
        }
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        if matches!(function, Function::WorkOffset(_)) {
            self.blank = None;
            self.turned = None;
        }
    }
}

fn bar(turned: &mut Turned, step: &Step<'_>, say: Say<'_>) {
    if step.cuts() {
        turned.cut(step);
    } else if let Some((radius, z)) = turned.inside(step).filter(|_| step.is_rapid() && !step.of_cycle) {
        let message = format!(
            "this rapid move ends at diameter {:.3}, Z{z:.3}, inside the blank, where nothing was cut",
            2.0 * radius
        );
        say.about(codes::L1006, step.origin, message, "stop in front of the blank, and go on at feed");
    }
}
