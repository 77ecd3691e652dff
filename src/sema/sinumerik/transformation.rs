//! TRANSMIT and TRACYL: the program works on a face or a mantle as in a plane, up to TRAFOOF.
//!
//! What is printed for them is the user's choice. Source: S 2.16 (docs/sources.md).

use crate::diag::{Answer, Diagnostic, codes};
use crate::ir::transformation::Surface;
use crate::ir::{Function, Side, Transformation};
use crate::machine::{Axis, AxisSet, MachineKind, Transmit};
use crate::parser::sinumerik::ast::{Block, Formula};
use crate::text::Span;

use super::diameter::Diameter;
use super::vocabulary::OnSurface;
use super::{Channel, Outcome, Run};

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

impl Run<'_> {
    /// `TRANSMIT`, `TRANSMIT(n)`, `TRACYL(d)`, `TRACYL(d, n, k)`
    pub(super) fn transformation(
        &mut self,
        on: OnSurface,
        formulas: &[Formula],
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let mut given = [None; 3];
        let most = if on == OnSurface::Face { 1 } else { 3 };
        if let Some(more) = formulas.get(most) {
            let message = format!("{} takes {most} argument{}", on.word(), if most == 1 { "" } else { "s" });
            return self.fail(codes::S2021.alarm(12340), more.span, message);
        }
        for (place, formula) in given.iter_mut().zip(formulas) {
            if !formula.is_missing() {
                *place = Some((self.number(*formula, block, text)?, formula.span));
            }
        }
        let [diameter, number, wall] = match on {
            OnSurface::Face => [None, given[0], None],
            OnSurface::Mantle => given,
        };
        let made = self.surface(on, diameter, number, wall, span).and_then(|surface| self.transform(on, surface, span));
        if made.is_err() {
            self.st.position.lose(AxisSet::ALL);
            self.lost();
        }
        made
    }
}

type Argument = Option<(f64, Span)>;

impl Channel<'_> {
    fn surface(
        &mut self,
        on: OnSurface,
        diameter: Argument,
        number: Argument,
        wall: Argument,
        span: Span,
    ) -> Outcome<Surface> {
        if let Some((number, span)) = number.filter(|(number, _)| *number != 1.0) {
            let message =
                format!("{} selects transformation {number}: which axes it uses, only the machine knows", on.word());
            let help = "select the first one, or compile the face in Cartesian axes";
            return self.fail_help(codes::S2280, span, message, help);
        }
        if let Some((_, span)) = wall.filter(|(wall, _)| *wall != 0.0) {
            let help = "leave the third argument out, and program the path of the tool's centre";
            return self.fail_help(codes::S2280, span, "TRACYL corrects the walls of a groove by a real Y axis", help);
        }
        if on == OnSurface::Face {
            return Ok(Surface::Face);
        }
        let (given, at) = diameter.unwrap_or((0.0, span));
        let diameter = given * self.st.length_unit();
        if !(1e-3..1e6).contains(&diameter) {
            let message = format!("the working diameter of TRACYL is {given}");
            return self.fail_help(codes::S2280, at, message, "give the diameter at which Y counts: TRACYL(80)");
        }
        Ok(Surface::Mantle { diameter })
    }

    fn transform(&mut self, on: OnSurface, surface: Surface, span: Span) -> Outcome {
        let (word, rotary) = (on.word(), self.job.settings.machine.rotary_axis);
        let as_seen = match self.job.settings.cycles.transmit {
            Transmit::Refuse => {
                let what = if on == OnSurface::Face { "face" } else { "mantle" };
                let help = Answer::key("cycles", "transmit").one_of(&["\"polar\"", "\"cartesian\""]).help("set `[cycles] transmit = \"polar\"` for X and the rotary axis, or \"cartesian\" for a control that \
                            transforms by itself");
                return self.fail_help(
                    codes::S9006,
                    span,
                    format!("{word} machines the {what} in axes that the target may not have"),
                    help,
                );
            }
            Transmit::Cartesian => true,
            Transmit::Polar => false,
        };
        self.transformation_ends(span)?;
        self.may_transform(span)?;
        if !as_seen {
            self.has_axes_for(on, span)?;
        }
        let by = Transformation { surface, rotary };
        self.st.transformation = Some(Transformed { by, as_seen });
        let frame = self.st.ctx.frame.clone();
        let seen = frame.unapply(&by.seen(&frame.apply(self.st.position.at())));
        self.axes_change(rotary);
        if as_seen {
            self.lost();
            let message = format!(
                "{word}: face machining in virtual Cartesian axes; needs a machine with X, Y or a control transformation"
            );
            self.note_once(codes::S8250, span, message);
        } else {
            self.st.position.move_to(&seen);
            self.function(Function::Transformation(Some(by)));
            let letter = rotary.letter();
            let zero = match on {
                OnSurface::Face => format!("the tool stands over the positive X of the program at {letter}0"),
                OnSurface::Mantle => format!("Y0 of the program lies at {letter}0"),
            };
            let message = format!("{word} is printed with X and {letter}: X0 lies on the axis of rotation, and {zero}");
            self.note_once(codes::S8251, span, message);
        }
        self.says_diameter(on, span);
        Ok(())
    }

    /// `TRAFOOF`; false where nothing is on.
    pub(super) fn transformation_off(&mut self, span: Span) -> Outcome<bool> {
        let on = self.st.transformation.is_some();
        self.transformation_ends(span)?;
        Ok(on)
    }

    fn transformation_ends(&mut self, span: Span) -> Outcome {
        let Some(on) = self.st.transformation else { return Ok(()) };
        self.may_transform(span)?;
        self.st.transformation = None;
        let frame = self.st.ctx.frame.clone();
        let left = frame.unapply(&on.by.left(&frame.apply(self.st.position.at())));
        self.axes_change(on.by.rotary);
        if on.as_seen {
            self.lost();
        } else {
            self.st.position.move_to(&left);
            self.function(Function::Transformation(None));
        }
        Ok(())
    }

    /// Where X, Y and the rotary axis stand is said in other axes from here on.
    fn axes_change(&mut self, rotary: Axis) {
        self.st.position.forget([Axis::X, Axis::Y, rotary].into_iter().collect());
        self.st.heading = super::tangent::Heading::None;
    }

    /// What may not be on where axes change.
    fn may_transform(&mut self, span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        if self.st.side() != Side::None || self.st.compensation.is_leaving() {
            let help = "program G40 with a straight move in front of it";
            return self.fail_help(codes::S2281, span, "radius compensation is on where the axes change", help);
        }
        let kept = self.job.settings.control.sinumerik.transformation_keeps_frame;
        if !self.st.ctx.frame.is_identity() && !kept {
            let help = Answer::key("control", "md10602").one_of(&["1"]).help(
                "program the frame behind this block (TRANS without values in front of it), or set \
                        `[control] md10602 = 1` if it stays on the machine",
            );
            return self.fail_help(
                codes::S2281,
                span,
                "a frame is in force where the axes change, and the control may delete it (MD 10602)",
                help,
            );
        }
        Ok(())
    }

    /// Is the machine one whose X and rotary axis make the surface?
    fn has_axes_for(&mut self, on: OnSurface, span: Span) -> Outcome {
        let machine = &self.job.settings.machine;
        if on == OnSurface::Mantle && machine.kind != MachineKind::Lathe {
            let help = Answer::key("machine", "kind")
                .help("set `[machine] kind = \"lathe\"` if the tool points along X to a workpiece that turns about Z");
            return self.fail_help(
                codes::S2280,
                span,
                "which axes TRACYL uses on a milling machine, only the machine knows",
                help,
            );
        }
        let y = self.st.ctx.frame.apply(self.st.position.at()).get(Axis::Y).filter(|y| y.abs() > 1e-6);
        if let Some(y) = y.filter(|_| self.st.transformation.is_none()) {
            let message = format!("the Y axis stands at {y} where X and the rotary axis take over");
            return self.fail_help(codes::S2281, span, message, "program Y0 in front of it");
        }
        Ok(())
    }

    /// X of a face under DIAMON.
    fn says_diameter(&self, on: OnSurface, span: Span) {
        let counts =
            self.job.settings.machine.diameter_axis == Some(Axis::X) && self.st.diameter_mode() != Diameter::Off;
        if on == OnSurface::Face && counts && self.job.diags.first_time(codes::S8252, ()) {
            let message = "diameter programming is on at TRANSMIT: X of the face is read as a diameter";
            let found = Diagnostic::new(codes::S8252, self.loc(span), message);
            self.report(found.help("program DIAMOF behind TRANSMIT if X and Y of the face count alike"));
        }
    }

    /// Alarm 61020: a turning cycle where the program sees a face or mantle.
    pub(super) fn no_turning_cycle_here(&self, name: &str, span: Span) -> Outcome {
        if self.st.transformation.is_none() || !TURNING.contains(&name) {
            return Ok(());
        }
        let message = format!("{name} is not possible while TRANSMIT or TRACYL is on");
        self.fail_help(codes::S2282.alarm(61020), span, message, "program TRAFOOF in front of it")
    }
}
