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
            return self.refuse_cycle(args.span, codes::P2090::dmode_names_another_plane_than_one());
        }
        let coded = args.number(VARI).and_then(whole).unwrap_or(0);
        let digit = |place: u32| args.digit(VARI, place);
        if digit(0) == 5 {
            return self.refuse_argument(VARI, codes::S9015::chamfering_units_of_vari_is_not_supported());
        }
        let fits = (1..=2).contains(&digit(0)) && digit(1) <= 1 && digit(2) <= 3 && digit(3) == 0 && digit(4) <= 1;
        if !fits || coded >= 100_000 {
            return self.no_such_machining(
                "units 1 roughs, 2 finishes; tens 0 G0, 1 G1 back; hundreds 0 to 3 lift; ten thousands 1 backwards",
            );
        }
        let side = self.side_of_contour()?;
        if side != Side::None && self.st.path.normal() != 0.0 {
            self.leaves_open(codes::S8230::offn_is_in_force(&self.st.path.normal()));
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
                self.own_way(codes::P8101::of_0_in_hundreds_of_vari_lifts_tool());
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
            other => self.refuse_cycle(args.span_of(RL), codes::P2090::side_rl_is_40_41_or_42(&args.place(RL), &other)),
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
            None => self.refuse(
                self.args.span_of(RL),
                codes::S9015::cycle72_runs_contour_backwards()
                    .answer(Answer::key("cycles", "backward_side").one_of(&["\"travel\"", "\"contour\""])),
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
            return self.refuse_cycle(
                self.args.span_of(VARI),
                codes::P2090::contour_that_runs_backwards_has_at_most(&MOST_BACKWARDS, &elements.len()),
            );
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
            4 => return self.refuse_argument(kind, codes::S9015::line_at_right_angle_to_contour(&name)),
            _ => return self.no_such_way(kind),
        };
        if side == Side::None && shape != Shape::Line {
            return self.refuse_cycle(args.span_of(kind), codes::P2090::asks_for_arc(&name, &place));
        }
        let length = self.magnitude(size);
        if length == 0.0 {
            let (name, place) = (args.written(size), args.place(size));
            return self
                .refuse_cycle(args.span_of(size), codes::P2090::length_or_radius_is_0_or_missing(&name, &place));
        }
        if spatial {
            self.own_way(codes::P8101::in_space_tool_falls_over_whole_way());
        }
        Ok(Way { form: Form::Soft(shape), size: length, spatial })
    }

    fn no_such_way<T>(&self, kind: Key) -> Outcome<T> {
        let (name, place) = (self.args.written(kind), self.args.place(kind));
        self.refuse_cycle(self.args.span_of(kind), codes::P2090::there_is_no_such_approach_or_retraction(&name, &place))
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
