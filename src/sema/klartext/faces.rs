//! Faces: 230 and 232.
//!
//! Source: K 6.7; F B7 (docs/sources.md).

use crate::geo::{Deg, Point2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::facing::{Facing, Kind, Links, Overrun};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, Place, parts};

use super::cycles::call::Call;
use super::cycles::drilling::{FEED, PLUNGE, PREPOSITION};
use super::cycles::faces::{BOTTOM, CUTS, SIDE_CLEARANCE, STEP_FEED, STRATEGY, TOP};
use super::cycles::milling::{FINISHING_FEED, FIRST_SIDE, FLOOR_ALLOWANCE, MILLING_FEED, SECOND_SIDE};
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
        let cuts = self.cycle_number(cycle, CUTS)?;
        if cuts.fract() != 0.0 || !(2.0..=MOST_CUTS).contains(&cuts) {
            return self.cycle_value(cycle, &format!("the number of cuts Q240 = {cuts} is not 2 to {MOST_CUTS}"));
        }
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
            links: Links::At(self.cycle_feed(cycle, STEP_FEED, None)?),
            width: between / (cuts - 1.0),
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
        let (top, bottom) = (self.cycle_length(cycle, TOP)?, self.cycle_length(cycle, BOTTOM)?);
        if top <= bottom {
            return self
                .cycle_value(cycle, &format!("the blank Q227 = {top} does not lie above the face Q386 = {bottom}"));
        }
        let radius = self.cutter_radius(cycle)?;
        let clearance = self.not_below_zero(cycle, CLEARANCE)?;
        let heights = Heights {
            retract: top + self.not_below_zero(cycle, SECOND_CLEARANCE)?.max(clearance),
            reference: top,
            clearance,
            depth: bottom,
            step: self.above_zero(cycle, PLUNGE)?,
            division: Division::Even,
            allowance: self.not_below_zero(cycle, FLOOR_ALLOWANCE)?,
        };
        let link = self.cycle_feed(cycle, PREPOSITION, None)?;
        let feeds = Feeds { plane: self.cycle_feed(cycle, MILLING_FEED, None)?, depth: link };
        let finishing =
            if cycle.gives_q(FINISHING_FEED) { self.cycle_feed(cycle, FINISHING_FEED, None)? } else { feeds.plane };
        let strategy = self.choice(cycle, STRATEGY, 3)?;
        if strategy == 3 {
            return self.cycle_unbuilt(cycle, "paths without overrun (Q389=3)");
        }
        let width = self.overlap(cycle, radius)?;
        let cuts = parts(size[1].abs(), width) as f64;
        let face = Facing {
            mill: Mill { plane: self.st.plane(), heights, radius, feeds },
            corner: Place { at: corner, turn: Deg(0.0) },
            size,
            along: 0,
            alternates: strategy < 2,
            links: if strategy == 1 { Links::Inside(link) } else { Links::At(link) },
            width: size[1].abs() / cuts,
            overrun: Overrun { ends: self.not_below_zero(cycle, SIDE_CLEARANCE)?, side: 0.0 },
            walls: [[false; 2]; 2],
            kind: Kind::Rough,
            last: (heights.allowance > 0.0).then_some(finishing),
        };
        Ok(Some(Cycle::Facing(self.sound(cycle, face)?)))
    }

    /// Corner and signed sizes of a face, which has a place of its own.
    fn face_of(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<(Point2, [f64; 2])> {
        if call.placed {
            return self.cycle_unbuilt(cycle, "a pattern or CYCL CALL POS with a face that has a place of its own");
        }
        let corner = Point2::new(self.cycle_length(cycle, START.0)?, self.cycle_length(cycle, START.1)?);
        Ok((corner, [self.cycle_length(cycle, FIRST_SIDE)?, self.cycle_length(cycle, SECOND_SIDE)?]))
    }
}
