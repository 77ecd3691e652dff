//! A rapid move ends inside the blank.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Blank, Machine, MotionRule, Say, Setup, Step, TINY};
use crate::lint::turned::Turned;
use crate::machine::axis::Axis;

super::rule! { L1006 Motion RapidIntoBlank Warning "rapid-into-blank"
    what "rapid move ends inside the blank"
    why "A move at rapid traverse ends inside the blank that BLK FORM describes, deeper than anything was cut before; on a lathe, \
        inside the bar of G20, where nothing was cut before. At rapid traverse the tool does not cut: it breaks, or moves the \
        part. Stop above the part and go down at feed. The coordinates of the blank are taken as those of the active datum; after \
        a change of the datum nothing is said. `[lint] blank` gives the blank of programs that describe none."
    example r#"
-- Example (L1006_fires.H)
0 BEGIN PGM P MM
; The blank reaches up to Z0: at Z-5 the rapid move is 5 mm inside.
1 BLK FORM 0.1 Z X+0 Y+0 Z-40
2 BLK FORM 0.2 X+100 Y+100 Z+0
3 TOOL CALL 1 Z S2000
4 L X+50 Y+50 Z-5 R0 FMAX M3
5 L X+60 F200
6 L Z+50 FMAX M30
7 END PGM P MM
"#
    says {
        in_block(letter, depth, top) "this rapid move ends at {letter}{depth:.3}, inside the blank, whose top is at {top:.3}"
            help "stop above the blank, and go on at feed";
        in_bar(diameter, z) "this rapid move ends at diameter {diameter:.3}, Z{z:.3}, inside the blank, where nothing was cut"
            help "stop in front of the blank, and go on at feed";
    }
}

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
        // Depths are those of the blank also in a tilted plane: what was cut from there is cut for all.
        let to = step.place(&step.to);
        let Some(depth) = to.get(axis) else { return };
        if step.cuts() {
            self.deepest = Some(self.deepest.map_or(depth, |deepest| deepest.min(depth)));
            return;
        }
        let inside = Axis::ALL[..3].iter().all(|axis| {
            let margin = 0.01;
            to.get(*axis).is_some_and(|value| {
                value > blank.min[axis.index()] + margin && value < blank.max[axis.index()] - margin
            })
        });
        let deeper = self.deepest.is_none_or(|deepest| depth < deepest - TINY);
        if step.is_rapid() && !step.of_cycle && inside && deeper {
            let top = blank.max[axis.index()];
            say.about(L1006::in_block(&axis.letter(), &depth, &top), step.origin);
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
        say.about(L1006::in_bar(&(2.0 * radius), &z), step.origin);
    }
}
