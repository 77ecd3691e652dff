//! CYCLE70 and CYCLE90: thread milling.
//!
//! Source: M 7.8 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::ir::cycle::milling::{MOST_LEVELS, Place, parts};
use crate::ir::cycle::thread_milling::{Side, ThreadMillingFault, Turns, Ways};
use crate::ir::cycle::{Cycle, Family, ThreadMilling};

use super::super::value::whole;
use super::call::{Act, Acts, CycleCall};
use super::milling::{Around, Names};
use super::names::{
    CPA, CPO, DIATH, FAL, FALD, FFD, FFR, H1, KDIAM, MID, NSP, NT, PA, PO, RFP, RTP, SDIS, TYPTH, VARI,
};
use crate::sema::cycle::call::Made;

/// Thread milling has one feed, and its infeed is one of the thread's depth.
const NAMES: Names = Names {
    retract: RTP,
    reference: RFP,
    clearance: SDIS,
    depth: super::names::DP,
    // Neither has an infeed or an allowance along the tool axis.
    step: FFD,
    floor: FALD,
    feed: FFR,
    depth_feed: FFD,
};

impl CycleCall<'_> {
    /// CYCLE70
    pub(super) fn thread_by_depth(&self) -> Made<Acts> {
        let mill = self.mill(&NAMES)?;
        let nominal = self.given.magnitude(DIATH) / 2.0;
        let depth = self.given.magnitude(H1);
        let side = self.thread_side()?;
        let pitch = self.new_pitch()?;
        let teeth = self.teeth()?;
        let (left_hand, counter_clockwise) = self.turning_of_thread(side)?;
        let rests = self.rests(depth)?;
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(self.given.or_zero(NSP)) };
        let core = nominal - depth;
        self.mill_thread(ThreadMilling {
            mill,
            place,
            side,
            nominal,
            core,
            pitch,
            left_hand,
            counter_clockwise,
            turns: if teeth == 1 { Turns::Continuous } else { Turns::Strips(teeth) },
            rests,
            ways: Ways::of_half_a_pitch(pitch, mill.feeds.plane),
            before: Vec::new(),
            after: Vec::new(),
        })
    }

    /// CYCLE90: from the surface down, so that its sense makes the hand of the thread.
    pub(super) fn thread_by_core(&self) -> Made<Acts> {
        let mill = self.mill(&NAMES)?;
        let side = self.thread_side()?;
        let around = if side == Side::Internal { Around::Inside } else { Around::Outside };
        let counter_clockwise = self.goes_counter_clockwise(around)?;
        // Downwards a right-hand thread turns clockwise, seen along the axis that counts outwards.
        let left_hand = counter_clockwise == (mill.heights.outward() > 0.0);
        let place = Place { at: self.reference_point(CPA, CPO), turn: Deg(0.0) };
        let (nominal, core) = (self.given.magnitude(DIATH) / 2.0, self.given.magnitude(KDIAM) / 2.0);
        let pitch = self.new_pitch()?;
        let hand = if left_hand { "left-hand" } else { "right-hand" };
        self.own_way(codes::P8101::from_surface_down_this_sense_makes_thread(&hand));
        self.mill_thread(ThreadMilling {
            mill,
            place,
            side,
            nominal,
            core,
            pitch,
            left_hand,
            counter_clockwise,
            turns: Turns::Continuous,
            rests: vec![0.0],
            ways: Ways::of_half_a_pitch(pitch, mill.feeds.plane),
            before: Vec::new(),
            after: Vec::new(),
        })
    }

    fn thread_side(&self) -> Made<Side> {
        match self.given.or_zero(TYPTH) {
            0.0 => Ok(Side::Internal),
            1.0 => Ok(Side::External),
            _ => {
                let (name, place) = (self.given.written(TYPTH), self.given.argument(TYPTH));
                self.refuse_argument(TYPTH, codes::P2090::kind_of_thread_is_0_or_1(&name, &place))
            }
        }
    }

    /// Teeth of an edge; 0 and 1 are a cutter with one.
    fn teeth(&self) -> Made<u32> {
        let given = self.given.or_zero(NT);
        match whole(given).and_then(|n| u32::try_from(n).ok()).filter(|n| given.fract() == 0.0 && *n <= 1000) {
            Some(teeth) => Ok(teeth.max(1)),
            None => self.refuse_argument(NT, codes::P2090::teeth_of_edge_nt_are_1(&self.given.argument(NT))),
        }
    }

    /// Left hand, and the sense in which the tool goes round, by the digits of `_VARI`.
    fn turning_of_thread(&self, side: Side) -> Made<(bool, bool)> {
        let given = self.given;
        let coded = given.whole(VARI);
        let (unit, tens, hundreds) = (given.digit(VARI, 0), given.digit(VARI, 1), given.digit(VARI, 2));
        if !(1..=2).contains(&unit) || tens > 2 || hundreds > 1 || coded >= 1000 {
            return self.no_such_machining("units 1 roughs, 2 finishes; tens 1 down, 2 up; hundreds 1 left-hand");
        }
        if (tens, hundreds) != (0, 0) && !self.settings.cycles.thread_digits {
            return self.refuse_as_said(
                given.place_of(VARI),
                codes::S9015::cycle70_what_tens()
                    .answer(Answer::key("cycles", "thread_milling_digits").one_of(&["true"])),
            );
        }
        let left_hand = hundreds == 1;
        let around = if side == Side::Internal { Around::Inside } else { Around::Outside };
        let climbs = self.goes_counter_clockwise(around)?;
        let counter_clockwise = match tens {
            // Up a right-hand thread goes counter-clockwise.
            1 => left_hand,
            2 => !left_hand,
            _ => {
                let hand = if left_hand { "left-hand" } else { "right-hand" };
                self.own_way(codes::P8101::no_sense_is_given(&hand));
                climbs
            }
        };
        Ok((left_hand, counter_clockwise))
    }

    /// What the passes leave.
    fn rests(&self, depth: f64) -> Made<Vec<f64>> {
        if self.given.digit(VARI, 0) == 2 {
            return Ok(vec![0.0]);
        }
        let allowance = self.given.magnitude(FAL);
        let way = depth - allowance;
        if way <= 0.0 {
            return self.refuse_argument(
                FAL,
                codes::P2090::allowance_fal_is_not_smaller_than_depth(&self.given.argument(FAL)),
            );
        }
        let count = parts(way, self.given.magnitude(MID));
        if count > MOST_LEVELS {
            return self.refuse_argument(MID, codes::P2090::infeed_mid_is_so_small(&self.given.argument(MID)));
        }
        let rest = |k: usize| if k == count { allowance } else { depth - way * k as f64 / count as f64 };
        Ok((1..=count).map(rest).collect())
    }

    fn mill_thread(&self, thread: ThreadMilling) -> Made<Acts> {
        if let Err(fault) = thread.check() {
            return self.thread_milling_fault(fault);
        }
        self.own_way(codes::P8101::tool_comes_to_thread());
        Ok(vec![Act::Cycle(Cycle::ThreadMilling(thread))])
    }

    fn thread_milling_fault<T>(&self, fault: ThreadMillingFault) -> Made<T> {
        let at = match fault {
            ThreadMillingFault::Mill(fault) => return self.mill_fault(&NAMES, fault),
            ThreadMillingFault::Cutter | ThreadMillingFault::Way | ThreadMillingFault::Hole(_) => {
                (DIATH, 61105, "take a smaller cutter")
            }
            ThreadMillingFault::Pitch | ThreadMillingFault::TooMany => {
                (super::names::PIT, 61001, "check the pitch and the infeed")
            }
            ThreadMillingFault::Depth | ThreadMillingFault::Number => {
                (DIATH, 61601, "check the diameters of the thread")
            }
        };
        self.unsound(at, &fault)
    }
}
