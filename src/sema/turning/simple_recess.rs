//! G86 of the 4110: a recess with upright flanks, roughed in strokes and finished with a chamfer at each rim.
//!
//! Source: reference section 8.4. A start at X = contour + 2·(1.3 − chamfer) makes the chamfer: so each flank is entered
//! over a slope of 45 degrees that begins 1.3 mm beside it at the height of the start.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Element, Point2, Vec2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::recess::{Operation, Passes, RecessEnd, RecessFeeds, RecessTurning};
use crate::ir::cycle::turning::Towards;
use crate::machine::RecessSide;

use super::sections::Family;
use super::state::SpeedMode;
use super::words::Words;
use super::{Outcome, Run};

/// Where the slope into a flank begins, beside the flank, in mm.
const SLOPE: f64 = 1.3;
/// How far the strokes come down to the start height from above: nothing lies there.
const CLEAR: f64 = 2.0 * SLOPE;

/// The recess in the directions of its width and its depth: places of both flanks, floor, start.
struct Slot {
    near: f64,
    far: f64,
    floor: f64,
    start: f64,
    into: Towards,
}

impl Run<'_> {
    pub(super) fn simple_recess(&mut self, w: &Words) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        if self.sections.family() == Family::DinPlus {
            return self.fail_help(
                codes::T9006,
                span,
                "G86 of DIN PLUS is not supported",
                "describe the recess in the contour and program G869",
            );
        }
        let (tool, radial) = self.recess_tool()?;
        let corner = self.corner_of(w, at)?;
        let (width, oversize) = if radial { (b'K', b'I') } else { (b'I', b'K') };
        let (place, floor, start) =
            if radial { (corner.x, corner.y, at.y) } else { (corner.y, corner.x, at.x) };
        if (floor - start).abs() <= 1e-6 {
            return self.fail(codes::T1007, span, "the recess has no depth below the tool");
        }
        let into = match (radial, floor < start) {
            (true, true) => Towards::MinusX,
            (true, false) => Towards::PlusX,
            (false, true) => Towards::MinusZ,
            (false, false) => Towards::PlusZ,
        };
        let mm = self.st.mm();
        let wide = match w.get(width) {
            // One stroke: the tool stands with its programmed corner at the corner of the recess.
            None => None,
            Some(num) => {
                let share = if radial { 1.0 } else { 0.5 };
                let wide = self.above_zero(num, "the width of the recess")? * share;
                if wide < tool.width - 1e-9 {
                    return self.fail(codes::T1007, num.span, "the recess is narrower than the tool");
                }
                Some((wide, self.recess_side(num.span)?))
            }
        };
        let oversize = match w.get(oversize) {
            Some(num) if num.value < 0.0 => return self.fail(codes::T1007, num.span, "an oversize is not negative"),
            num => num.map_or(0.0, |num| num.value * mm * if radial { 0.5 } else { 1.0 }),
        };
        let (near, far) = match wide {
            None => (place + tool.edge, place + tool.edge + tool.width),
            Some((wide, RecessSide::Plus)) => (place, place + wide),
            Some((wide, RecessSide::Minus)) => (place - wide, place),
        };
        let slot = Slot { near, far, floor, start, into };
        let dwell = self.recess_dwell(w, floor, radial)?;
        let feed = self.cutting_feed()?;
        let (rough_dwell, strokes) = if oversize > 0.0 { (0.0, "") } else { (dwell, " without finishing") };
        let effective = tool.width - 2.0 * tool.nose;
        let recess = |operation, passes, contour: Vec<Element>| RecessTurning {
            contour,
            into,
            tool,
            // The strokes travel at the height of the start.
            blank: slot.blank(),
            most: (floor - start).abs(),
            oversize: slot.share(oversize),
            offset_width: 0.0,
            compensation: 0.0,
            passes,
            operation,
            clearance: CLEAR,
            feeds: RecessFeeds { plunge: feed, turn: feed, finish: feed },
            end: if radial || oversize > 0.0 { RecessEnd::Lift } else { RecessEnd::Lift },
        };
        if strokes.is_empty() {
            let passes = Passes::Strokes { width: effective, dwell: rough_dwell };
            self.send_cycle(&Cycle::RecessTurning(recess(Operation::Rough, passes, slot.upright())));
            let passes = Passes::Strokes { width: effective, dwell };
            self.send_cycle(&Cycle::RecessTurning(recess(Operation::Finish, passes, slot.sloped())));
        } else {
            let message = "without an oversize G86 is made in strokes, without finishing and without chamfers at the rims";
            self.report(Diagnostic::new(codes::T2029, self.here.origin.loc, message));
            let passes = Passes::Strokes { width: effective, dwell: rough_dwell };
            self.send_cycle(&Cycle::RecessTurning(recess(Operation::Rough, passes, slot.upright())));
        }
        Ok(())
    }
}
