//! TRANSMIT and TRACYL: the program works on a face or a mantle as in a plane, up to TRAFOOF.
//!
//! What is printed for them is the user's choice. Source: S 2.16 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::transformation::Surface;
use crate::ir::{Ask, Function, Side, Transformation};
use crate::machine::{Axis, AxisSet, MachineKind, Transmit};
use crate::sema::run::Where;
use crate::text::Span;

use super::diameter::Diameter;
use super::rotary::reduced;
use super::vocabulary::OnSurface;
use super::{Channel, Core, Outcome, State};

/// The tool passes the axis of rotation.
const AT_POLE: Ask = Ask::key("cycles", "transmit", AT_POLE_HELP).one_of(&["\"cartesian\""]);
const AT_POLE_HELP: &str = "lead the tool around the centre of the face, or set `[cycles] transmit = \"cartesian\"` for a control that transforms by itself";

/// Cycles of a turning contour.
const TURNING: &[&str] = &[
    "CYCLE92", "CYCLE93", "CYCLE930", "CYCLE94", "CYCLE940", "CYCLE95", "CYCLE951", "CYCLE952", "CYCLE96", "CYCLE97",
    "CYCLE98", "CYCLE99",
];

/// A transformation that is on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Transformed {
    by: Transformation,
    /// The moves are printed in the axes that the program sees.
    as_seen: bool,
}

/// A number with its place, where one is given.
type Argument = Option<(f64, Span)>;

impl Channel<'_> {
    /// `TRANSMIT`, `TRANSMIT(n)`, `TRACYL(d)`, `TRACYL(d, n, k)`
    pub(super) fn transformation(&mut self, on: OnSurface, given: [Argument; 3], span: Span) -> Outcome {
        let [diameter, number, wall] = match on {
            OnSurface::Face => [None, given[0], None],
            OnSurface::Mantle => given,
        };
        let made = surface(&self.core, self.st.length_unit(), on, diameter, number, wall, span)
            .and_then(|surface| self.transform(on, surface, span));
        if made.is_err() {
            self.st.position.lose(AxisSet::ALL);
            self.lost();
        }
        made
    }
}

fn surface(
    core: &Core<'_>,
    mm: f64,
    on: OnSurface,
    diameter: Argument,
    number: Argument,
    wall: Argument,
    span: Span,
) -> Outcome<Surface> {
    if let Some((number, span)) = number.filter(|(number, _)| *number != 1.0) {
        return core.refuse(span, codes::S2280::selects_transformation(&on.word(), &number));
    }
    if let Some((_, span)) = wall.filter(|(wall, _)| *wall != 0.0) {
        return core.refuse(span, codes::S2280::tracyl_corrects_walls_of_groove_by_real());
    }
    if on == OnSurface::Face {
        return Ok(Surface::Face);
    }
    let (given, at) = diameter.unwrap_or((0.0, span));
    let diameter = given * mm;
    if !(1e-3..1e6).contains(&diameter) {
        return core.refuse(at, codes::S2280::working_diameter_of_tracyl(&given));
    }
    Ok(Surface::Mantle { diameter })
}

impl State {
    /// Where X, Y and the rotary axis stand is said in other axes from here on.
    fn axes_change(&mut self, rotary: Axis) {
        self.position.forget([Axis::X, Axis::Y, rotary].into_iter().collect());
        self.heading = super::tangent::Heading::None;
    }
}

impl Channel<'_> {
    fn transform(&mut self, on: OnSurface, surface: Surface, span: Span) -> Outcome {
        if self.st.frames.is_tilted() {
            return self.core.refuse(span, codes::S2283::axes_are_transformed(&on.word()));
        }
        let (word, rotary) = (on.word(), self.core.job.settings.machine.rotary_axis);
        let as_seen = match self.core.job.settings.cycles.transmit {
            Transmit::Refuse => {
                let what = if on == OnSurface::Face { "face" } else { "mantle" };
                return self.core.refuse(
                    span,
                    codes::S9006::machines_in_axes_that_target_may_not(&word, &what)
                        .answer(Answer::key("cycles", "transmit").one_of(&["\"polar\"", "\"cartesian\""])),
                );
            }
            Transmit::Cartesian => true,
            Transmit::Polar => false,
        };
        self.transformation_ends(span)?;
        self.may_transform(span)?;
        if !as_seen {
            has_axes_for(&self.core, &self.st, on, span)?;
        }
        let frame = self.st.ctx.frame.clone();
        // What counts modulo 360 stands in its first turn, however far the output has counted on.
        let starts = frame.apply(self.st.position.at()).get(rotary);
        let starts = if self.st.machine.modulo.contains(rotary) { starts.map(reduced) } else { starts };
        let by = Transformation { surface, rotary, starts, at_pole: &AT_POLE };
        self.st.transformation = Some(Transformed { by, as_seen });
        let seen = frame.unapply(&by.seen(&frame.apply(self.st.position.at())));
        self.st.axes_change(rotary);
        if as_seen {
            self.lost();
            self.core.say_once(span, codes::S8250::face_machining_in_virtual_cartesian_axes(&word));
        } else {
            self.st.position.move_to(&seen);
            self.function(Function::Transformation(Some(by)));
            let letter = rotary.letter();
            let zero = match on {
                OnSurface::Face => format!("the tool stands over the positive X of the program at {letter}0"),
                OnSurface::Mantle => format!("Y0 of the program lies at {letter}0"),
            };
            self.core.say_once(span, codes::S8251::is_printed_with_x(&word, &letter, &zero));
        }
        says_diameter(&self.core, &self.st, on, span);
        Ok(())
    }

    /// `TRAFOOF`
    pub(super) fn transformation_ends(&mut self, span: Span) -> Outcome {
        let Some(on) = self.st.transformation else { return Ok(()) };
        self.may_transform(span)?;
        self.st.transformation = None;
        let frame = self.st.ctx.frame.clone();
        let left = frame.unapply(&on.by.left(&frame.apply(self.st.position.at())));
        self.st.axes_change(on.by.rotary);
        if on.as_seen {
            self.lost();
        } else {
            self.st.position.move_to(&left);
            self.function(Function::Transformation(None));
        }
        Ok(())
    }

    /// What may not be on where axes change.
    fn may_transform(&mut self, span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        if self.st.side() != Side::None || self.st.compensation.is_leaving() {
            return self.core.refuse(span, codes::S2281::radius_compensation_is_on_where_axes_change());
        }
        let kept = self.core.job.settings.control.sinumerik.transformation_keeps_frame;
        if !self.st.ctx.frame.is_identity() && !kept {
            return self.core.refuse(
                span,
                codes::S2281::frame_is_in_force_where_axes_change()
                    .answer(Answer::key("control", "md10602").one_of(&["1"])),
            );
        }
        Ok(())
    }
}

/// Is the machine one whose X and rotary axis make the surface?
fn has_axes_for(core: &Core<'_>, st: &State, on: OnSurface, span: Span) -> Outcome {
    let machine = &core.job.settings.machine;
    if on == OnSurface::Mantle && machine.kind != MachineKind::Lathe {
        return core.refuse(
            span,
            codes::S2280::which_axes_tracyl_uses_on_milling_machine().answer(Answer::key("machine", "kind")),
        );
    }
    let y = st.ctx.frame.apply(st.position.at()).get(Axis::Y).filter(|y| y.abs() > 1e-6);
    if let Some(y) = y.filter(|_| st.transformation.is_none()) {
        return core.refuse(span, codes::S2281::y_axis_stands_at_where_x(&y));
    }
    Ok(())
}

/// X of a face under DIAMON.
fn says_diameter(core: &Core<'_>, st: &State, on: OnSurface, span: Span) {
    let counts = core.job.settings.machine.diameter_axis == Some(Axis::X) && st.diameter_mode() != Diameter::Off;
    if on == OnSurface::Face && counts && core.job.diags.first_time(codes::S8252, ()) {
        let found = codes::S8252::diameter_programming_is_on_at_transmit().at(core.loc(span));
        core.report(found.help("program DIAMOF after TRANSMIT if X and Y of the face count alike"));
    }
}

/// Alarm 61020: a turning cycle where the program sees a face or mantle.
pub(super) fn no_turning_cycle_here(core: &Core<'_>, st: &State, name: &str, place: Where) -> Outcome {
    if st.transformation.is_none() || !TURNING.contains(&name) {
        return Ok(());
    }
    core.refuse(place, codes::S2282::is_not_possible_while_transmit_or_tracyl(&name))
}
