//! G86 of the 4110: a recess with upright flanks, roughed in strokes and finished with a chamfer at each rim.
//!
//! The oversize is one length: it counts twice in a diameter. Source: T 8.4 (docs/sources.md). A start at X = contour + 2·(1.3 − chamfer) makes the chamfer: so each flank is entered
//! over a slope of 45 degrees that begins 1.3 mm beside it at the height of the start.

use crate::diag::{Answer, codes};
use crate::geo::{Element, Point2, Vec2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::recess::{Operation, Passes, RecessEnd, RecessFeeds, RecessTurning};
use crate::ir::cycle::turning::Towards;
use crate::machine::RecessSide;
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{dwell, length};

use super::super::readings::Question;
use super::{CORNER_X, CORNER_Z, CycleCall, Need, Planned, Row, Step, word};

pub(super) const ROWS: &[Row] = &[Row::new(
    86,
    "G86",
    "simple recess",
    "4110P, p. 68",
    &[
        CORNER_X.needed(),
        CORNER_Z.needed(),
        length("I", "radial: oversize; axial: width").unsigned(),
        length("K", "radial: width; axial: oversize").unsigned(),
        dwell("E", "dwell at the floor").unsigned().default("one turn"),
    ],
    |call| call.simple_recess(),
)
.requires(&[Need::NotDinPlus(codes::P9010::g86_of_din_plus_is_not_supported), Need::Feed])];

/// Where the slope into a flank begins, beside the flank, in mm.
const SLOPE: f64 = 1.3;
/// Between the blank that the strokes are computed with and the height of the start, where they travel, in mm.
const BELOW_START: f64 = 0.125;

/// The recess along its width and its depth.
struct Slot {
    /// Flanks, the smaller coordinate first.
    flanks: (f64, f64),
    floor: f64,
    start: f64,
    into: Towards,
}

impl Slot {
    fn point(&self, along: f64, depth: f64) -> Point2 {
        if self.into.is_radial() { Point2::new(along, depth) } else { Point2::new(depth, along) }
    }

    /// +1 where the tool comes from greater coordinates.
    fn out(&self) -> f64 {
        if self.floor < self.start { 1.0 } else { -1.0 }
    }

    /// The contour over these places and heights, from the greater place to the smaller.
    fn contour(&self, rims: &[(f64, f64)]) -> Vec<Element> {
        let (low, high) = self.flanks;
        let down = rims.iter().map(|(aside, height)| self.point(high + aside, *height));
        let up = rims.iter().rev().map(|(aside, height)| self.point(low - aside, *height));
        let points: Vec<Point2> =
            down.chain([self.point(high, self.floor), self.point(low, self.floor)]).chain(up).collect();
        points.windows(2).map(|pair| Element::Line { from: pair[0], to: pair[1] }).collect()
    }

    fn upright(&self) -> Vec<Element> {
        self.contour(&[(0.0, self.start)])
    }

    fn sloped(&self) -> Vec<Element> {
        self.contour(&[(SLOPE, self.start), (0.0, self.start - SLOPE * self.out())])
    }
}

impl CycleCall<'_> {
    fn simple_recess(&self) -> Planned {
        let at = self.st.at;
        let (tool, radial) = self.no_fault(self.st.modal.recess_tool(self.settings))?;
        let corner = self.corner()?;
        let (width, oversize) = if radial { (word::K, word::I) } else { (word::I, word::K) };
        let (place, floor, start) = if radial { (corner.x, corner.y, at.y) } else { (corner.y, corner.x, at.x) };
        if (floor - start).abs() <= 1e-6 {
            return self.refuse(codes::T1007::recess_has_no_depth_below_tool());
        }
        let into = match (radial, floor < start) {
            (true, true) => Towards::MinusX,
            (true, false) => Towards::PlusX,
            (false, true) => Towards::MinusZ,
            (false, false) => Towards::PlusZ,
        };
        let oversize = self.given.length(oversize);
        // In a recess as wide as the tool the walls keep nothing.
        let wide = self.given.has(width);
        if oversize > 0.0 && wide {
            self.depends_on(Question::RecessOversize, self.given.place);
        }
        let on_walls = wide && self.settings.control.turning.oversize_on_floor != Some(true);
        let aside = if on_walls { oversize } else { 0.0 };
        let flanks = match self.given.length_if(width) {
            // One stroke: the tool stands with its programmed corner at the corner of the recess.
            None => (place + tool.edge, place + tool.edge + tool.width),
            Some(wide) => self.recess_flanks(wide, place, radial, tool.width)?,
        };
        let slot = Slot { flanks, floor, start, into };
        if (floor - start).abs() <= SLOPE {
            return self.refuse(codes::T1007::recess_is_not_deeper_than_slope());
        }
        let dwell = self.recess_dwell(slot.floor)?;
        let feed = self.feed()?;
        let pass = |operation, contour, dwell| RecessTurning {
            contour,
            into,
            tool,
            blank: start - BELOW_START * slot.out(),
            most: (floor - start).abs(),
            oversize: if radial { Vec2::new(aside, oversize) } else { Vec2::new(oversize, aside) },
            offset_width: 0.0,
            compensation: 0.0,
            passes: Passes::Strokes { width: tool.width - 2.0 * tool.nose, dwell },
            operation,
            clearance: BELOW_START,
            feeds: RecessFeeds { plunge: feed, turn: feed, finish: feed },
            end: RecessEnd::Lift,
        };
        let rough = pass(Operation::Rough, slot.upright(), 0.0);
        let finish = pass(Operation::Finish, slot.sloped(), dwell);
        Ok([rough, finish].map(|pass| Step::Cycle(Box::new(Cycle::RecessTurning(pass)))).into())
    }

    /// Places of the flanks of a recess that is wider than the tool.
    fn recess_flanks(&self, wide: f64, place: f64, radial: bool, tool: f64) -> Made<(f64, f64)> {
        if !radial {
            return self.refuse_argument(word::I, codes::T9007::whether_width_of_axial_recess_counts());
        }
        if wide <= 0.0 {
            return self.refuse_argument(word::K, codes::T1007::has_to_be_above_zero(&"the width of the recess"));
        }
        if wide < tool - 1e-9 {
            return self.refuse_argument(word::K, codes::T1007::recess_is_narrower_than_tool());
        }
        match self.settings.control.turning.recess_side {
            Some(RecessSide::Plus) => Ok((place, place + wide)),
            Some(RecessSide::Minus) => Ok((place - wide, place)),
            None => {
                let fault = codes::T9007::on_which_side_of_its_corner_wide();
                self.refuse_argument(word::K, fault.answer(Answer::key("control", "recess_side")))
            }
        }
    }

    /// E in seconds; one turn of the spindle where it is missing.
    fn recess_dwell(&self, floor: f64) -> Made<f64> {
        if let Some(seconds) = self.given.number(word::E) {
            return Ok(seconds);
        }
        let speed = self.st.modal.spindle.speed().filter(|speed| *speed > 0.0).map(|speed| {
            match self.st.modal.spindle.is_cutting() {
                // Metres per minute at the floor of a radial recess; further out the spindle is slower.
                true => speed * 1000.0 / (core::f64::consts::TAU * floor.abs().max(1e-3)),
                _ => speed,
            }
        });
        match speed.map(|turns| self.st.modal.spindle.limited(turns)) {
            Some(speed) => Ok(60.0 / speed),
            None => self.refuse(codes::P1004::e_is_missing()),
        }
    }
}
