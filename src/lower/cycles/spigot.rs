//! Spigots: beside the blank to the level, on a semicircle to the circuit, round, and on a semicircle away.

use crate::diag::{Fault, codes};
use crate::geo::{Element, Point2};
use crate::ir::Feed;
use crate::ir::cycle::{Family, Spigot};

use super::cutter::Cutter;
use super::{CycleItem, Expand, Start};

/// Where the tool goes down nearer to its circuit than this, it goes straight to it, mm.
const LEAST_APPROACH: f64 = 2e-3;

impl Expand for Spigot {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3331::spigot_makes_no_path(&fault))?;
        let entry = self.entry();
        let circuits: Vec<Circuit> = self.distances().into_iter().map(|distance| self.at(distance)).collect();
        let feed = self.mill.feeds.plane;
        let mut cutter = Cutter::new(&self.mill, self.place, start, out);
        cutter.approach(entry);
        if self.rough {
            self.go_round(&mut cutter, &self.levels(), &circuits, feed);
        }
        if let Some(finish) = &self.finish {
            let heights = &self.mill.heights;
            if finish.wall {
                cutter.lift(heights.safe());
                let levels = heights.levels_to(heights.rough_floor(), finish.step);
                self.go_round(&mut cutter, &levels, &[self.at(self.mill.radius)], finish.feed);
            }
            if finish.floor {
                cutter.lift(heights.safe());
                let allowance = if finish.wall { 0.0 } else { self.allowance };
                let circuits: Vec<Circuit> = self.distances_to(allowance).into_iter().map(|far| self.at(far)).collect();
                self.go_round(&mut cutter, &[heights.depth], &circuits, finish.feed);
            }
        }
        cutter.retract();
        Ok(())
    }
}

/// A closed way around the spigot.
struct Circuit {
    start: Point2,
    elements: Vec<Element>,
}

impl Spigot {
    /// All circuits of each level.
    fn go_round(&self, cutter: &mut Cutter<'_>, levels: &[f64], circuits: &[Circuit], feed: Feed) {
        let entry = self.entry();
        for level in levels {
            cutter.plunge(*level);
            for circuit in circuits {
                let beside = Point2::new((entry.x + circuit.start.x) / 2.0, 0.0);
                let has_room = entry.x - circuit.start.x > LEAST_APPROACH;
                // The semicircle meets the circuit in its own direction.
                let between = |cutter: &mut Cutter<'_>, to: Point2| match has_room {
                    true => cutter.arc(to, beside, !self.counter_clockwise, feed),
                    false => cutter.line(to, feed),
                };
                between(cutter, circuit.start);
                cutter.follow(&circuit.elements, feed);
                between(cutter, entry);
            }
        }
    }

    fn at(&self, distance: f64) -> Circuit {
        let mut elements = self.shape.circuit(distance);
        if !self.counter_clockwise {
            elements = elements.iter().rev().map(Element::reversed).collect();
        }
        let start = elements.first().map_or(Point2::origin(), Element::from);
        Circuit { start, elements }
    }
}
