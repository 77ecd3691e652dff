//! G71, G74 and G36: drilling and tapping along Z from where the tool stands.
//!
//! Source: T 9 (docs/sources.md).

use crate::diag::codes;
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::drilling::{Breaks, Degression, Drilling, Levels, Method, Pecking, Tap};
use crate::ir::function::Spindle;
use crate::machine::Axis;
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Parameter, Rule, dwell, length, number};

use super::super::chain::Coord;
use super::{CycleCall, Need, Planned, Row, Unbuilt, one, word};

const BOTTOM: Parameter = length("Z", "bottom of the hole").needed();
const OVER_HOLE: Parameter = length("X", "diameter at which the tool stands");
const PER_HOLE: Parameter = dwell("E", "dwell at the bottom").unsigned().default("0");
const SOFT: Parameter = number("V", "reduced feed at the ends; refused where it is not 0").default("0");
const BACK: Parameter = number("D", "out of the hole at 0 rapid, 1 feed").rule(Rule::OneOf(0, 1)).default("0");

const NOT_SOFT: &[Unbuilt] = &[Unbuilt::not_zero(word::V, |_| codes::T9007::by_how_much_v_lowers_feed())];

pub(super) const ROWS: &[Row] = &[
    Row::new(
        36,
        "G36",
        "tapping",
        "CNC PILOT 4290",
        &[
            OVER_HOLE,
            BOTTOM,
            length("F", "pitch").needed().rule(Rule::Above(0)),
            length("B", "run-in; refused where it is not 0").default("0"),
            number("Q", "spindle; refused where it is not 0").default("0"),
            number("H", "reference of the pitch; refused where it is not 0").default("0"),
        ],
        |call| call.tapping(),
    )
    .unbuilt(&[
        Unbuilt::not_zero(word::B, |it| codes::T9007::of_g36_what_its_values_do_no(&it.word, &"run-in")),
        Unbuilt::not_zero(word::Q, |it| codes::T9007::of_g36_what_its_values_do_no(&it.word, &"spindle")),
        Unbuilt::not_zero(word::H, |it| {
            codes::T9007::of_g36_what_its_values_do_no(&it.word, &"reference of the pitch")
        }),
    ])
    .requires(&[Need::Turns]),
    Row::new(71, "G71", "drilling", "CNC PILOT 4290", &[OVER_HOLE, BOTTOM, PER_HOLE, SOFT, BACK], |call| {
        call.drilling(false)
    })
    .unbuilt(NOT_SOFT)
    .requires(&[Need::Feed]),
    Row::new(
        74,
        "G74",
        "deep-hole drilling",
        "4290-71, p. 601",
        &[
            OVER_HOLE,
            BOTTOM,
            length("P", "first step").rule(Rule::Above(0)).default("the whole depth"),
            length("I", "by which each step is shorter").unsigned().default("0"),
            length("B", "way back to break the chip").rule(Rule::Above(0)).default("out of the hole"),
            length("J", "least step").rule(Rule::Above(0)).default("a tenth of P"),
            PER_HOLE,
            SOFT,
            BACK,
        ],
        |call| call.drilling(true),
    )
    .unbuilt(NOT_SOFT)
    .requires(&[Need::Feed]),
];

impl CycleCall<'_> {
    fn drilling(&self, pecks: bool) -> Planned {
        let feed = self.feed()?;
        let bottom = self.bottom_of_hole()?;
        let dwell = self.given.or_zero(word::E);
        let method = match (pecks, self.given.whole(word::D) == 1) {
            (false, false) => Method::Drill { dwell },
            (false, true) => Method::Ream { dwell, back: feed },
            (true, false) => Method::Peck(self.pecks(self.st.at.x - bottom, dwell)?),
            (true, true) => {
                return self.refuse_argument(word::D, codes::T9007::deep_hole_drilling_with_retraction_at_feed());
            }
        };
        self.hole(bottom, feed, method)
    }

    fn hole(&self, depth: f64, feed: Feed, method: Method) -> Planned {
        let start = self.st.at.x;
        let levels = Levels { retract: start, reference: start, clearance: 0.0, depth };
        one(Cycle::Drilling(Drilling { axis: Axis::Z, levels, feed, entry: None, method }))
    }

    /// G36: the thread is cut with the spindle in step; it turns back on the way out.
    fn tapping(&self) -> Planned {
        let bottom = self.bottom_of_hole()?;
        let lead = self.given.length(word::F);
        let Some(turn) = self.st.modal.spindle.turn() else {
            return self.refuse(codes::P1004::spindle_does_not_turn());
        };
        let tap = Tap::new(true, Some(lead), turn, Spindle::Start(turn));
        // The feed of the hole is not used; the pitch is.
        self.hole(bottom, Feed::PerRevolution(lead), Method::Tap(tap))
    }

    /// Z of the bottom; the tool stands over the hole, in front of it.
    fn bottom_of_hole(&self) -> Made<f64> {
        let at = self.st.at;
        match self.st.x {
            Coord::Stay => {}
            Coord::At(x) if (x - at.y).abs() <= 1e-6 => {}
            _ => return self.refuse_argument(word::X, codes::T9007::drilling_along_x_is_not_supported()),
        }
        let bottom = match self.st.z {
            Coord::At(z) => z,
            Coord::By(d) => at.x + d,
            _ => return self.refuse(codes::P1004::z_is_missing()),
        };
        if bottom >= at.x {
            return self.refuse_argument(word::Z, codes::T1007::hole_does_not_lie_in_front());
        }
        Ok(bottom)
    }

    /// P, I, J and B: the steps of a deep hole.
    fn pecks(&self, depth: f64, dwell: f64) -> Made<Pecking> {
        let first = self.given.length_if(word::P).map_or(depth, |first| first.min(depth));
        let less = self.given.length(word::I);
        let least = self.given.length_if(word::J).unwrap_or(first / 10.0);
        let degression = if less == 0.0 {
            Degression::Plain { less: 0.0, least: least.min(first) }
        } else if (less - least).abs() <= 1e-9 {
            Degression::Plain { less, least: least.min(first) }
        } else {
            return self.refuse_argument(word::I, codes::T9007::steps_that_become_shorter_by_i_down());
        };
        let (breaks, way) = match self.given.length_if(word::B) {
            Some(way) => (Breaks::Always, way),
            None => (Breaks::Never, 0.0),
        };
        Ok(Pecking { dwell_at_bottom: dwell, breaks, way, ..Pecking::new(first, degression) })
    }
}
