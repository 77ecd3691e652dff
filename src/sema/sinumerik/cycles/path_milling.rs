//! CYCLE72: path milling.
//!
//! Source: M 7.3 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Element;
use crate::geo::soft::Shape;
use crate::ir::captured::Captured;
use crate::ir::cycle::path_milling::{Between, Form, Lift, PathFault, Way};
use crate::ir::cycle::{Cycle, Family, PathMilling};
use crate::ir::{Compensation, Side};
use crate::machine::options::cycles::BackwardSide;

use super::super::value::whole;
use super::super::{Outcome, Run};
use super::arguments::{AS1, AS2, Arguments, FAL, FF3, Key, LP1, LP2, RL, VARI};
use super::call::CycleCall;
use super::milling::CLASSIC;

/// Most elements of a contour that runs backwards.
const MOST_BACKWARDS: usize = 170;

impl Run<'_> {
    pub(super) fn path_milling(&mut self, args: &Arguments) -> Outcome {
        self.cycle(args).check_parameters()?;
        let contour = self.contour_to_mill(args)?;
        let mut call = self.cycle(args);
        call.mill_along(&contour)?;
        call.say_remarks();
        Ok(())
    }
}

impl CycleCall<'_, '_> {
    fn mill_along(&mut self, contour: &Captured) -> Outcome {
        let args = self.args;
        let mill = self.mill(&CLASSIC)?;
        if mill.plane != self.st.plane() {
            let help = "select the plane in front of the cycle: G17, G18 or G19";
            let what = "`_DMODE` names another plane than the one of the contour";
            return self.cycle_fault(args.span, 61101, what, help);
        }
        let coded = args.number(VARI).and_then(whole).unwrap_or(0);
        let digit = |place: u32| args.digit(VARI, place);
        if digit(0) == 5 {
            return self.not_built(VARI, "chamfering (units of `_VARI`)");
        }
        let fits = (1..=2).contains(&digit(0)) && digit(1) <= 1 && digit(2) <= 3 && digit(3) == 0 && digit(4) <= 1;
        if !fits || coded >= 100_000 {
            return self.no_such_machining(
                "units 1 roughs, 2 finishes; tens 0 G0, 1 G1 back; hundreds 0 to 3 lift; ten thousands 1 backwards",
            );
        }
        let side = self.side_of_contour()?;
        if side != Side::None && self.st.path.normal() != 0.0 {
            let message =
                format!("OFFN={} is in force and not counted: the allowance of the cycle is", self.st.path.normal());
            self.says_once(&message, "program OFFN=0 in front of the cycle, and `_FAL` in it");
        }
        if side == Side::None && self.magnitude(FAL) != 0.0 {
            self.unused(FAL, "_FAL", "where the cutter is on the contour (`_RL` 40)");
        }
        let finishes_floor = digit(0) == 2;
        let allowance = if finishes_floor { 0.0 } else { self.magnitude(FAL) };
        let rules = match side {
            Side::None => Compensation::default(),
            Side::Left | Side::Right => self.rules_of_cycle(mill.radius + allowance, args.span.into())?,
        };
        let backwards = digit(4) == 1;
        let side = if backwards { self.side_backwards(side)? } else { side };
        let elements = self.elements_in_order(contour, backwards)?;
        let lift = match digit(2) {
            1 => Lift::Surface,
            2 => Lift::Clearance,
            3 => Lift::None,
            _ => {
                self.own_way("0 in the hundreds of `_VARI` lifts the tool to the retraction plane");
                Lift::Retract
            }
        };
        let feed = if digit(1) == 1 { Some(self.mill_feed(FF3)?) } else { None };
        let path = PathMilling {
            mill,
            contour: elements,
            side,
            rules,
            approach: self.soft_way(AS1, LP1, side)?,
            leave: self.soft_way(AS2, LP2, side)?,
            finishes_floor,
            between: Between { lift, feed },
            alternates: false,
        };
        if let Err(fault) = path.check() {
            return self.path_fault(fault);
        }
        self.send_cycle(Cycle::PathMilling(path));
        Ok(())
    }

    fn side_of_contour(&self) -> Outcome<Side> {
        let args = self.args;
        match args.or_zero(RL) {
            40.0 => Ok(Side::None),
            41.0 => Ok(Side::Left),
            42.0 => Ok(Side::Right),
            other => {
                let message = format!("the side `_RL` (argument {}) is 40, 41 or 42, not {other}", args.place(RL));
                self.cycle_fault(args.span_of(RL), 61114, &message, "41 left, 42 right of the contour, 40 on it")
            }
        }
    }

    /// The side in the direction of travel.
    fn side_backwards(&self, side: Side) -> Outcome<Side> {
        if side == Side::None {
            return Ok(side);
        }
        match self.job.settings.cycles.backward_side {
            Some(BackwardSide::Travel) => Ok(side),
            Some(BackwardSide::Contour) => Ok(if side == Side::Left { Side::Right } else { Side::Left }),
            None => self.fail_help(
                codes::S9015,
                self.args.span_of(RL),
                "CYCLE72 runs the contour backwards: whether `_RL` is seen in the direction of travel or of the contour is not confirmed",
                Answer::key("cycles", "backward_side")
                    .one_of(&["\"travel\"", "\"contour\""])
                    .help("say it by `[cycles] backward_side = \"travel\"` or \"contour\", or turn the contour around"),
            ),
        }
    }

    fn elements_in_order(&self, contour: &Captured, backwards: bool) -> Outcome<Vec<Element>> {
        let mut elements: Vec<Element> =
            contour.pieces.iter().map(|piece| piece.element).filter(|element| element.length() > 0.0).collect();
        if !backwards {
            return Ok(elements);
        }
        if elements.len() > MOST_BACKWARDS {
            let message = format!(
                "a contour that runs backwards has at most {MOST_BACKWARDS} elements, this one has {}",
                elements.len()
            );
            return self.cycle_fault(self.args.span_of(VARI), None, &message, "split the contour, or turn it around");
        }
        elements.reverse();
        Ok(elements.iter().map(Element::reversed).collect())
    }

    /// The way to the contour, or from it.
    fn soft_way(&self, kind: Key, size: Key, side: Side) -> Outcome<Way> {
        let args = self.args;
        let code = args.number(kind).and_then(whole).unwrap_or(0);
        let (name, place) = (args.written(kind), args.place(kind));
        let spatial = match code / 10 {
            0 => false,
            1 => true,
            _ => return self.no_such_way(kind),
        };
        let shape = match code % 10 {
            1 => Shape::Line,
            2 => Shape::Quadrant,
            3 => Shape::Semicircle,
            4 => return self.not_built(kind, &format!("a line at a right angle to the contour (`{name}`)")),
            _ => return self.no_such_way(kind),
        };
        if side == Side::None && shape != Shape::Line {
            let message = format!("`{name}` (argument {place}) asks for an arc, and `_RL` 40 knows lines only");
            return self.cycle_fault(args.span_of(kind), 61115, &message, "give 1 or 11, or a side of the contour");
        }
        let length = self.magnitude(size);
        if length == 0.0 {
            let (name, place) = (args.written(size), args.place(size));
            let message = format!("the length or radius `{name}` (argument {place}) is 0 or missing");
            return self.cycle_fault(args.span_of(size), 61116, &message, "give a size above 0");
        }
        if spatial {
            self.own_way(
                "in space the tool falls over the whole way at the feed for the depth, and rises at that of the plane",
            );
        }
        Ok(Way { form: Form::Soft(shape), size: length, spatial })
    }

    fn no_such_way<T>(&self, kind: Key) -> Outcome<T> {
        let (name, place) = (self.args.written(kind), self.args.place(kind));
        let message = format!("there is no such approach or retraction: `{name}` (argument {place})");
        self.cycle_fault(self.args.span_of(kind), 61115, &message, "1 line, 2 quadrant, 3 semicircle; tens 1 in space")
    }

    fn path_fault(&self, fault: PathFault) -> Outcome {
        let (key, alarm) = match fault {
            PathFault::Mill(fault) => return self.mill_fault(&CLASSIC, fault),
            PathFault::Way => (LP1, 61116),
            PathFault::Round => (AS1, 61115),
            PathFault::Empty | PathFault::Element => (VARI, 61930),
        };
        let help = "check the contour and the arguments of the cycle";
        self.cycle_fault(self.args.span_of(key), alarm, &fault.to_string(), help)
    }
}
