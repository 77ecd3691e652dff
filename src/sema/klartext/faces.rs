//! Faces: 230, 232 and 233.
//!
//! Source: K 6.7; F B7 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Deg, Point2};
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::facing::{Facing, Kind, Links, Overrun};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, Place, parts};

use super::cycles::call::{self, Call};
use super::cycles::drilling::{FEED, PLUNGE, PREPOSITION};
use super::cycles::faces::{ALONG, BOTTOM, CUTS, LIMITS, SIDE_CLEARANCE, STEP_FEED, STRATEGY, TOP};
use super::cycles::milling::{
    FINISHING_FEED, FIRST_SIDE, FLOOR_ALLOWANCE, MILLING_FEED, OPERATION, POSITION, SECOND_SIDE,
};
use super::cycles::patterns::START;
use super::cycles::{CLEARANCE, DefinedCycle, SECOND_CLEARANCE};
use super::{Outcome, Run};

/// Most paths of a face.
const MOST_CUTS: f64 = 10_000.0;

impl Run<'_> {
    /// Cycle 230.
    pub(super) fn multipass(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let (corner, size) = self.face_of(cycle, call)?;
        let (top, clearance) = (self.cycle_length(cycle, TOP)?, self.not_below_zero(cycle, CLEARANCE)?);
        let radius = self.cutter_radius(cycle)?;
        let cuts = self.cuts(cycle)?;
        let on_edges = self.job.settings.cycles.klartext.rows_on_edges;
        let (corner, size) = if on_edges { wider(corner, size, radius) } else { (corner, size) };
        let between = size[1].abs() - 2.0 * radius;
        if between <= 0.0 {
            return self.tool_too_large(
                cycle,
                "the paths lie its radius inside of the sides, and Q219 leaves no room between them",
            );
        }
        let heights = Heights {
            retract: top + clearance,
            reference: top,
            clearance,
            depth: top,
            step: 0.0,
            division: Division::Even,
            allowance: 0.0,
        };
        let feeds =
            Feeds { plane: self.cycle_feed(cycle, MILLING_FEED, None)?, depth: self.cycle_feed(cycle, FEED, None)? };
        let face = Facing {
            mill: Mill { plane: self.st.plane(), heights, radius, feeds },
            corner: Place { at: corner, turn: Deg(0.0) },
            size,
            along: 0,
            alternates: true,
            links: Links::At(Some(self.cycle_feed(cycle, STEP_FEED, None)?)),
            width: between / f64::from(cuts - 1),
            overrun: Overrun { ends: 0.0, side: 0.0 },
            // The paths keep inside of the sides.
            walls: [[false; 2], [true; 2]],
            kind: Kind::Rough,
            last: None,
        };
        Ok(Some(Cycle::Facing(self.sound(cycle, face)?)))
    }

    /// Cycle 232.
    pub(super) fn face(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let (corner, size) = self.face_of(cycle, call)?;
        let mill = self.face_cutter(cycle, call)?;
        let finishing = self.finishing_feed(cycle, &mill)?;
        self.floor_in_one_cut(cycle, &mill)?;
        let face = self.paths_of_face(cycle, mill, (corner, size), 0)?;
        let last = (mill.heights.allowance > 0.0).then_some(finishing);
        Ok(Some(Cycle::Facing(self.sound(cycle, Facing { last, ..face })?)))
    }

    /// Cycle 233.
    pub(super) fn face_at_call(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        for limit in LIMITS {
            let value = self.cycle_option(cycle, limit)?;
            if value != 0.0 {
                return self.refuse_cycle(cycle, codes::P9010::face_with_limit_is_not_supported(&limit, &value));
            }
        }
        let mill = self.face_cutter(cycle, call)?;
        let (operation, along) = (self.choice(cycle, OPERATION, 2)?, self.choice(cycle, ALONG, 1)?);
        let finishing = self.finishing_feed(cycle, &mill)?;
        if operation != 1 {
            self.floor_in_one_cut(cycle, &mill)?;
        }
        let place = self.face_at(cycle)?;
        let face = self.paths_of_face(cycle, mill, place, along as usize)?;
        let allowance = mill.heights.allowance;
        let face = match operation {
            0 => Facing { last: (allowance > 0.0).then_some(finishing), ..face },
            1 => face,
            _ if allowance == 0.0 => {
                self.nothing_to_finish(cycle, "Q215 = 2 finishes, and Q369 leaves nothing to finish");
                return Ok(None);
            }
            // What roughing left is the blank.
            _ => {
                let heights =
                    Heights { reference: mill.heights.rough_floor(), allowance: 0.0, step: 0.0, ..mill.heights };
                let feeds = Feeds { plane: finishing, ..mill.feeds };
                Facing { mill: Mill { heights, feeds, ..mill }, ..face }
            }
        };
        Ok(Some(Cycle::Facing(self.sound(cycle, face)?)))
    }

    /// Corner and signed sizes of a face that lies where it is called.
    fn face_at(&mut self, cycle: &DefinedCycle) -> Outcome<(Point2, [f64; 2])> {
        let start = self.call_point(cycle)?;
        let size = [self.cycle_length(cycle, FIRST_SIDE)?, self.cycle_length(cycle, SECOND_SIDE)?];
        if !cycle.gives_q(POSITION) || self.cycle_number(cycle, POSITION)? == -1.0 {
            return Ok((start, size));
        }
        let half = [self.above_zero(cycle, FIRST_SIDE)? / 2.0, self.above_zero(cycle, SECOND_SIDE)? / 2.0];
        let to_middle = self.way_to_middle(cycle, half)?;
        Ok((Point2::new(start.x + to_middle.x - half[0], start.y + to_middle.y - half[1]), size))
    }

    /// Cutter, heights and feeds of a face.
    fn face_cutter(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Mill> {
        let (top, bottom) = (self.cycle_length(cycle, TOP)?, self.cycle_length(cycle, BOTTOM)?);
        if top <= bottom {
            return self.refuse_value(cycle, codes::P2090::blank_q227_does_not_lie_above_face(&top, &bottom));
        }
        let radius = self.cutter_radius(cycle)?;
        let clearance = self.not_below_zero(cycle, CLEARANCE)?;
        let second = self.not_below_zero(cycle, SECOND_CLEARANCE)?.max(clearance);
        let surface = top + call.shift;
        let heights = Heights {
            retract: call.retract.height(&call::Heights { surface, clearance, second: surface + second }),
            reference: surface,
            clearance,
            depth: bottom + call.shift,
            step: self.above_zero(cycle, PLUNGE)?,
            division: Division::Even,
            allowance: self.not_below_zero(cycle, FLOOR_ALLOWANCE)?,
        };
        let plane = self.cycle_feed(cycle, MILLING_FEED, None)?;
        let feeds = Feeds { plane, depth: self.retract_feed(cycle, PREPOSITION, None)?.unwrap_or(plane) };
        Ok(Mill { plane: self.st.plane(), heights, radius, feeds })
    }

    fn finishing_feed(&mut self, cycle: &DefinedCycle, mill: &Mill) -> Outcome<Feed> {
        if cycle.gives_q(FINISHING_FEED) { self.cycle_feed(cycle, FINISHING_FEED, None) } else { Ok(mill.feeds.plane) }
    }

    /// The paths by Q389, along the first axis or the second one.
    fn paths_of_face(
        &mut self,
        cycle: &DefinedCycle,
        mill: Mill,
        (corner, size): (Point2, [f64; 2]),
        along: usize,
    ) -> Outcome<Facing> {
        let strategy = self.choice(cycle, STRATEGY, 4)?;
        let link = self.retract_feed(cycle, PREPOSITION, None)?;
        let links = match strategy {
            0 | 2 => Links::At(link),
            1 => {
                self.own_way_of(cycle, codes::K8141::with_q389_1_inner_ways_end_beyond());
                Links::Inside(link)
            }
            3 => return self.refuse_cycle(cycle, codes::P9010::paths_without_overrun()),
            _ => return self.refuse_cycle(cycle, codes::P9010::paths_from_outside_inwards()),
        };
        let width = self.overlap(cycle, mill.radius)?;
        let across = size[1 - along].abs();
        Ok(Facing {
            mill,
            corner: Place { at: corner, turn: Deg(0.0) },
            size,
            along,
            alternates: strategy < 2,
            links,
            width: across / parts(across, width) as f64,
            overrun: Overrun { ends: self.not_below_zero(cycle, SIDE_CLEARANCE)?, side: 0.0 },
            walls: [[false; 2]; 2],
            kind: Kind::Rough,
            last: None,
        })
    }

    /// Q240.
    pub(super) fn cuts(&mut self, cycle: &DefinedCycle) -> Outcome<u32> {
        let cuts = self.cycle_number(cycle, CUTS)?;
        if cuts.fract() == 0.0 && (2.0..=MOST_CUTS).contains(&cuts) {
            return Ok(cuts as u32);
        }
        self.refuse_value(cycle, codes::P2090::number_of_cuts_q240_is_not_2(&cuts, &MOST_CUTS))
    }

    /// Corner and signed sizes of a face, which has a place of its own.
    fn face_of(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<(Point2, [f64; 2])> {
        if call.placed() {
            return self.refuse_cycle(cycle, codes::P9010::pattern_or_cycl_call_pos_with_face());
        }
        let corner = Point2::new(self.cycle_length(cycle, START.0)?, self.cycle_length(cycle, START.1)?);
        Ok((corner, [self.cycle_length(cycle, FIRST_SIDE)?, self.cycle_length(cycle, SECOND_SIDE)?]))
    }
}

/// The face that a path on its side would lie a radius inside of.
fn wider(corner: Point2, [length, width]: [f64; 2], radius: f64) -> (Point2, [f64; 2]) {
    let by = radius.copysign(width);
    (Point2::new(corner.x, corner.y - by), [length, width + 2.0 * by])
}
