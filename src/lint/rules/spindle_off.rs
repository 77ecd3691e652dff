//! The tool cuts while the spindle stands.

use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step, Turning};
use crate::machine::axis::Axis;

super::rule! { L1001 Motion SpindleOff Warning "spindle-off"
    what "tool cuts while the spindle stands"
    why "A move at feed begins while the spindle stands: it was stopped, or nothing has started it since the first tool came. The \
        tool breaks, or the part is pushed out of its clamping. Start the spindle (M3, M4) before the tool touches the part. Said \
        once for each time that the spindle stands; a program without any tool change and without any spindle word is taken for a \
        part of another one. A retract along the tool axis is no cut."
    example r#"
-- Example (L1001_fires.H)
0 BEGIN PGM P MM
; Nothing starts the spindle.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX
3 L Z-1 F100
4 L Z+50 FMAX M30
5 END PGM P MM
"#
    says {
        stands() "this move cuts, and the spindle stands" help "start the spindle before it (M3, M4)";
    }
}

#[derive(Debug, Default)]
pub(super) struct SpindleOff {
    said: bool,
    blank: Option<Blank>,
}

impl SpindleOff {
    pub(super) fn new(setup: &Setup<'_>) -> SpindleOff {
        SpindleOff { blank: setup.blank, ..SpindleOff::default() }
    }
}

impl MotionRule for SpindleOff {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, say: Say<'_>) {
        if machine.turning != Turning::Off {
            self.said = false;
            return;
        }
        let cuts = step.cuts() && !step.of_cycle && !step.retracts(self.blank);
        if cuts && !self.said && step.mv.axes.iter().any(Axis::is_main) {
            self.said = true;
            say.about(L1001::stands(), step.origin);
        }
    }
}
