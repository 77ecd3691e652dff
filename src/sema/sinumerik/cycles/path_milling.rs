//! CYCLE72: path milling.
//!
//! Source: M 7.3 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Element;
use crate::geo::soft::Shape;
use crate::ir::captured::Captured;
use crate::ir::cycle::path_milling::{Form, LevelChange, Lift, PathFault, Way};
use crate::ir::cycle::{Cycle, Family, PathMilling};
use crate::ir::{Compensation, Side};
use crate::machine::options::cycles::BackwardSide;

use super::super::named_contour::CalledContour;
use super::call::{Act, Acts, CycleCall};
use super::milling::CLASSIC;
use super::names::{AS1, AS2, FAL, FF3, LP1, LP2, RL, VARI};
use crate::sema::cycle::call::{Kind, Made};
use crate::sema::cycle::row::Name;

/// Most elements of a contour that runs backwards.
const MOST_BACKWARDS: usize = 170;

impl CycleCall<'_> {
    /// CYCLE72
    pub(super) fn path_milling(&self, contours: &[CalledContour]) -> Made<Acts> {
        let [contour] = contours else { return Ok(Acts::new()) };
        let given = self.given;
        let mill = self.mill(&CLASSIC)?;
        if mill.plane != self.st.plane() {
            return self.refuse(codes::P2090::dmode_names_another_plane_than_one());
        }
        let coded = given.whole(VARI);
        let digit = |place: u32| given.digit(VARI, place);
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
        if side == Side::None && self.given.magnitude(FAL) != 0.0 {
            self.unused(FAL, "where the cutter is on the contour (`_RL` 40)");
        }
        let finishes_floor = digit(0) == 2;
        let allowance = if finishes_floor { 0.0 } else { self.given.magnitude(FAL) };
        let rules = match side {
            Side::None => Compensation::default(),
            Side::Left | Side::Right => self.rules_along(mill.radius + allowance)?,
        };
        let backwards = digit(4) == 1;
        let side = if backwards { self.side_backwards(side)? } else { side };
        let elements = self.elements_in_order(&contour.made, backwards)?;
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
            between: LevelChange { lift, feed },
            alternates: false,
        };
        if let Err(fault) = path.check() {
            return self.path_fault(fault);
        }
        Ok(vec![Act::Cycle(Cycle::PathMilling(path))])
    }

    /// The rules of compensation in force.
    fn rules_along(&self, radius: f64) -> Made<Compensation> {
        match self.st.rules_of_cycle(radius, self.settings) {
            Ok((rules, disc)) => {
                if let Some(fault) = disc {
                    self.note(self.given.place, fault, Kind::Once);
                }
                Ok(rules)
            }
            Err(fault) => self.refuse_as_said(self.given.place, fault),
        }
    }

    fn side_of_contour(&self) -> Made<Side> {
        let given = self.given;
        match given.or_zero(RL) {
            40.0 => Ok(Side::None),
            41.0 => Ok(Side::Left),
            42.0 => Ok(Side::Right),
            other => self.refuse_argument(RL, codes::P2090::side_rl_is_40_41_or_42(&given.argument(RL), &other)),
        }
    }

    /// The side in the direction of travel.
    fn side_backwards(&self, side: Side) -> Made<Side> {
        if side == Side::None {
            return Ok(side);
        }
        match self.settings.cycles.backward_side {
            Some(BackwardSide::Travel) => Ok(side),
            Some(BackwardSide::Contour) => Ok(if side == Side::Left { Side::Right } else { Side::Left }),
            None => self.refuse_as_said(
                self.given.place_of(RL),
                codes::S9015::cycle72_runs_contour_backwards()
                    .answer(Answer::key("cycles", "backward_side").one_of(&["\"travel\"", "\"contour\""])),
            ),
        }
    }

    fn elements_in_order(&self, contour: &Captured, backwards: bool) -> Made<Vec<Element>> {
        let mut elements: Vec<Element> =
            contour.pieces.iter().map(|piece| piece.element).filter(|element| element.length() > 0.0).collect();
        if !backwards {
            return Ok(elements);
        }
        if elements.len() > MOST_BACKWARDS {
            return self.refuse_argument(
                VARI,
                codes::P2090::contour_that_runs_backwards_has_at_most(&MOST_BACKWARDS, &elements.len()),
            );
        }
        elements.reverse();
        Ok(elements.iter().map(Element::reversed).collect())
    }

    /// The way to the contour, or from it.
    fn soft_way(&self, kind: Name, size: Name, side: Side) -> Made<Way> {
        let given = self.given;
        let code = given.whole(kind);
        let (name, place) = (given.written(kind), given.argument(kind));
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
            return self.refuse_argument(kind, codes::P2090::asks_for_arc(&name, &place));
        }
        let length = self.given.magnitude(size);
        if length == 0.0 {
            let (name, place) = (given.written(size), given.argument(size));
            return self.refuse_argument(size, codes::P2090::length_or_radius_is_0_or_missing(&name, &place));
        }
        if spatial {
            self.own_way(codes::P8101::in_space_tool_falls_over_whole_way());
        }
        Ok(Way { form: Form::Soft(shape), size: length, spatial })
    }

    fn no_such_way<T>(&self, kind: Name) -> Made<T> {
        let (name, place) = (self.given.written(kind), self.given.argument(kind));
        self.refuse_argument(kind, codes::P2090::there_is_no_such_approach_or_retraction(&name, &place))
    }

    fn path_fault<T>(&self, fault: PathFault) -> Made<T> {
        let (key, alarm) = match fault {
            PathFault::Mill(fault) => return self.mill_fault(&CLASSIC, fault),
            PathFault::Way => (LP1, 61116),
            PathFault::Round => (AS1, 61115),
            PathFault::Empty | PathFault::Element => (VARI, 61930),
        };
        let fault = codes::P2090::call_makes_no_cycle(&fault).alarm(alarm);
        self.refuse_argument(key, fault.help("check the contour and the arguments of the cycle"))
    }
}
