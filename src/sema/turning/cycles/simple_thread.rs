//! G32, a thread from where the tool stands to an end point, cut in several passes.
//!
//! No available manual shows its list of words; they are read as docs/turning.md says, from the reference, section
//! 10.4; `[control] simple_thread = "refuse"` refuses them.

use crate::diag::{Answer, Fault, codes};
use crate::geo::{Deg, Point2};
use crate::ir::cycle::thread::{Flank, Infeed, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Thread};
use crate::machine::Settings;
use crate::sema::cycle::row::{Rule, angle, count, length, number};

use super::super::readings::Question;
use super::{CORNER_X, CORNER_Z, CycleCall, MOST_AIR_CUTS, Need, Planned, Row, Unbuilt, one, word};

pub(super) const ROWS: &[Row] = &[Row::new(
    32,
    "G32",
    "simple thread",
    "MANUALplus 620",
    &[
        CORNER_X.needed(),
        CORNER_Z.needed(),
        length("F", "pitch").needed().rule(Rule::Above(0)),
        length("P", "depth").needed(),
        length("I", "greatest infeed").needed().rule(Rule::Above(0)),
        number("B", "last cut 0 split, 1 whole").rule(Rule::OneOf(0, 1)).default("0"),
        count("Q", "cuts at full depth").rule(Rule::OneOf(0, MOST_AIR_CUTS)).default("0"),
        length("K", "run-out").unsigned().default("0"),
        angle("W", "taper; refused where it is not 0").default("0"),
        angle("C", "start angle").default("0"),
        number("H", "infeed 0 radial, 1 left, 2 right, 3 by turns; refused where it is not 0")
            .rule(Rule::OneOf(0, 3))
            .default("0"),
    ],
    |call| call.simple_thread(),
)
.unbuilt(&[
    Unbuilt::not_zero(word::W, |it| {
        codes::T9007::of_g32_no_manual_at_hand_gives(&it.word, &"the sense of its taper angle")
    }),
    Unbuilt::not_zero(word::H, |it| {
        codes::T9007::of_g32_no_manual_at_hand_gives(&it.word, &"the angle of its flank offset")
    }),
])
.requires(&[Need::Wanted(refused), Need::Reading(Question::SimpleThread), Need::Spindle])];

fn refused(settings: &Settings) -> Option<Fault> {
    let fault = codes::T9007::words_of_g32_are_not_confirmed;
    let refuses = settings.control.turning.refuse_simple_thread == Some(true);
    refuses.then(|| fault().answer(Answer::key("control", "simple_thread")))
}

impl CycleCall<'_> {
    fn simple_thread(&self) -> Planned {
        let at = self.st.at;
        let end = self.corner()?;
        let lead = self.given.length(word::F);
        let depth = self.given.magnitude(word::P);
        if depth == 0.0 {
            return self.refuse_argument(word::P, codes::T1007::thread_has_no_depth());
        }
        let into = if at.y > end.y { Towards::MinusX } else { Towards::PlusX };
        if self.given.or_zero(word::P) < 0.0 && into == Towards::PlusX {
            return self.refuse_argument(word::P, codes::T1007::negative_depth_is_that_of_external_thread());
        }
        let start = Point2::new(at.x, end.y);
        let parts = vec![ThreadPart { end, lead }];
        self.above_centre(start, &parts, into, depth)?;
        let most = self.given.length(word::I);
        one(Cycle::Thread(Thread {
            start,
            parts,
            into,
            depth,
            infeed: match self.given.whole(word::B) {
                0 => Infeed::RemainderSplit { most },
                _ => Infeed::Remainder { most },
            },
            flank: Flank::Radial,
            finish: 0.0,
            air_cuts: self.given.whole(word::Q).unsigned_abs(),
            run_in: 0.0,
            run_out: self.given.length(word::K),
            fixed_end: false,
            starts: 1,
            start_angle: Deg(self.given.or_zero(word::C)),
            retract: at.y,
            park: at,
        }))
    }
}
