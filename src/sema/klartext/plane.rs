//! PLANE functions that tilt nothing, and what M128 does while no rotary axis moves.
//!
//! Source: reference sections 3.4 and 2.14. A tilt by nothing is how CAM posts write 3-axis work for a machine with
//! rotary axes; every other tilt is refused.

use crate::diag::{Diagnostic, codes};
use crate::machine::Axis;
use crate::parser::klartext::ast::Block;
use crate::text::{Span, decode::readable, number::decimal};

use super::words::Words;
use super::{Outcome, Reported, Run};

/// What stands behind PLANE.
#[derive(Debug, Default, PartialEq)]
struct Plane {
    kind: String,
    /// Words with a number: the data of the plane.
    data: Vec<(String, f64)>,
    /// STAY, TURN or MOVE.
    positioning: Option<String>,
    /// MB, a parameter, or a word that is not known.
    open: bool,
}

impl Plane {
    fn read(code: &str) -> Plane {
        let mut plane = Plane::default();
        for (at, word) in code.split_whitespace().enumerate() {
            let (name, rest) = word.split_at(word.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(word.len()));
            match (at, name, rest) {
                (0, "PLANE", "") => {}
                (1, kind, "") => plane.kind = kind.to_owned(),
                (_, "STAY" | "TURN" | "MOVE", "") if plane.positioning.is_none() => {
                    plane.positioning = Some(name.to_owned());
                }
                // How fast, about which point, which solution.
                (_, "FMAX" | "FAUTO" | "COORD" | "TABLE" | "ROT", "") | (_, "SEQ" | "SYM", "+" | "-") => {}
                (_, "F" | "DIST" | "ABST", number) if value(number).is_some() => {}
                _ => match value(rest) {
                    Some(number) => plane.data.push((name.to_owned(), number)),
                    None => plane.open = true,
                },
            }
        }
        plane
    }

    /// Is the plane the one that is not tilted?
    fn is_identity(&self) -> bool {
        let of = |name: &str| self.data.iter().find(|(found, _)| found == name).map(|(_, number)| *number);
        let only = |names: &[&str]| self.data.iter().all(|(name, _)| names.contains(&name.as_str()));
        let zero = |names: &[&str]| only(names) && names.iter().all(|name| of(name) == Some(0.0));
        if self.open {
            return false;
        }
        match self.kind.as_str() {
            "RESET" => self.data.is_empty(),
            "SPATIAL" => zero(&["SPA", "SPB", "SPC"]),
            "EULER" => zero(&["EULPR", "EULNU", "EULROT"]),
            "RELATIVE" => only(&["SPA", "SPB", "SPC"]) && self.data.len() == 1 && self.data[0].1 == 0.0,
            "AXIAL" => {
                only(&["A", "B", "C"]) && !self.data.is_empty() && self.data.iter().all(|(_, angle)| *angle == 0.0)
            }
            "VECTOR" => {
                let is = |name: &str, sign: f64| of(name).is_some_and(|n| if sign == 0.0 { n == 0.0 } else { n > 0.0 });
                only(&["BX", "BY", "BZ", "NX", "NY", "NZ"])
                    && is("BX", 1.0)
                    && is("BY", 0.0)
                    && is("BZ", 0.0)
                    && is("NX", 0.0)
                    && is("NY", 0.0)
                    && is("NZ", 1.0)
            }
            _ => false,
        }
    }
}

/// `+0`, `-12,5`, `40`.
fn value(text: &str) -> Option<f64> {
    let (sign, digits) = match text.as_bytes() {
        [b'-', digits @ ..] => (-1.0, digits),
        [b'+', digits @ ..] => (1.0, digits),
        digits => (1.0, digits),
    };
    let (number, len) = decimal(digits, true)?;
    (len == digits.len()).then_some(sign * number)
}

/// Would the block tilt the plane?
pub(super) fn tilts(code: &[u8]) -> bool {
    !Plane::read(&readable(code).to_ascii_uppercase()).is_identity()
}

impl Run<'_> {
    /// A PLANE block: without a tilt nothing changes, as none was active.
    pub(super) fn plane_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let plane = Plane::read(&readable(block.span.of(text)).to_ascii_uppercase());
        if !plane.is_identity() {
            let (name, span) = self.block_name(block, text, 2);
            let message = format!("{name} tilts the working plane, which cannot be compiled for three axes");
            return self.refuse_motion(codes::K9004, span, &message);
        }
        if plane.positioning.as_deref().is_some_and(|word| word != "STAY") {
            if !self.stands_upright() {
                let message = format!("PLANE {} moves the rotary axes to zero", plane.kind);
                return self.refuse_motion(codes::K9004, block.span, &message);
            }
            self.job.diags.push_once(Diagnostic::new(
                codes::K2512,
                self.here.origin.loc,
                "the rotary axes are taken to stand at zero, so nothing turns",
            ));
        }
        for number in 120..=122 {
            self.set_control_parameter(number, 0.0);
        }
        Ok(())
    }

    /// Does every rotary axis that the program moved stand at zero?
    fn stands_upright(&self) -> bool {
        let at = self.st.ctx.frame.apply(&self.st.pos);
        [Axis::A, Axis::B, Axis::C].into_iter().filter(|axis| self.st.rotary_moved.contains(*axis)).all(|axis| {
            at.get(axis)
                .is_some_and(|angle| (angle - self.st.rotary_offset[axis.index() - Axis::A.index()]) % 360.0 == 0.0)
        })
    }

    /// M128: as long as the rotary axes stand at zero the tool tip is where it would be without.
    pub(super) fn follow_tip(&mut self, on: bool, span: Span) -> Outcome {
        if on && !self.stands_upright() {
            return self.fail_help(
                codes::K9008,
                span,
                "M128 makes the control follow the tool tip with the rotary axes, and they are turned",
                "use 3-axis output of the CAM system",
            );
        }
        self.st.follows_tip = on;
        Ok(())
    }

    /// Under M128 a rotary axis that turns takes the other axes along.
    pub(super) fn check_tip(&mut self, w: &Words, axis: Axis, target: Option<f64>) -> Outcome {
        if !self.st.follows_tip || (target.is_some() && target == self.st.pos.get(axis)) {
            return Ok(());
        }
        if self.st.lost.contains(axis) {
            return Err(Reported);
        }
        self.fail_help(
            codes::K9008,
            w.axes_span,
            format!("under M128 the tool tip stays while {} turns, so the other axes move with it", axis.letter()),
            "use 3-axis output of the CAM system",
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_that_tilt_nothing() {
        for code in [
            "PLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY",
            "plane spatial spa+0 spb-0 spc+0,0 turn fmax seq- table rot",
            "PLANE VECTOR BX1 BY0 BZ0 NX0 NY0 NZ1 STAY SEQ- TABLE ROT",
            "PLANE EULER EULPR+0 EULNU+0 EULROT+0 MOVE DIST50 F800",
            "PLANE AXIAL B+0 STAY",
            "PLANE RELATIVE SPB+0 STAY",
            "PLANE RESET TURN FMAX",
        ] {
            assert!(!tilts(code.as_bytes()), "{code}");
        }
        for code in [
            "PLANE SPATIAL SPA+0 SPB+0 SPC+10 STAY",
            "PLANE SPATIAL SPA+0 SPB+0 STAY",
            "PLANE SPATIAL SPA+0 SPB+0 SPC+Q1 STAY",
            "PLANE VECTOR BX-1 BY0 BZ0 NX0 NY0 NZ1 STAY",
            "PLANE VECTOR BX1 BY0 BZ0 NX0 NY0.0000001 NZ1 STAY",
            "PLANE RESET MOVE DIST50 MB MAX FMAX",
            "PLANE PROJECTED PROPR+0 PROMIN+0 ROT+0 STAY",
        ] {
            assert!(tilts(code.as_bytes()), "{code}");
        }
    }
}
