//! Blank form, FN 14 and up, and statements that are refused by name.

use crate::diag::{Diagnostic, codes};
use crate::parser::klartext::ast::{Addr, Block, Refused};

use super::{Outcome, Reported, Run};

impl Run<'_> {
    /// BLK FORM: emits nothing; kept for the working plane of fragments and for checks.
    pub(super) fn blank_form(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let mm = self.level().unit.mm();
        let mut corner = None;
        let mut values = [None; 3];
        for &word in &block.words {
            match word.addr {
                Addr::Value if corner.is_none() => corner = Some(word.span.of(text).to_vec()),
                Addr::Axis { axis, .. } if word.value == crate::lexer::klartext::Value::None => {
                    self.st.blank.axis = Some(axis);
                }
                Addr::Axis { axis, incremental } if axis.is_main() => {
                    let value = self.number(word.value, word.span)? * mm;
                    let base = if incremental { self.st.blank.min.map_or(0.0, |min| min[axis.index()]) } else { 0.0 };
                    values[axis.index()] = Some(base + value);
                }
                // Cylinders, bodies of revolution, files.
                _ => return Ok(()),
            }
        }
        let [Some(x), Some(y), Some(z)] = values else { return Ok(()) };
        match corner.as_deref() {
            Some(b"0.1" | b"0,1") => self.st.blank.min = Some([x, y, z]),
            Some(b"0.2" | b"0,2") => {
                if let Some(min) = self.st.blank.min
                    && [x, y, z].iter().zip(&min).any(|(max, min)| max <= min)
                {
                    self.report(
                        Diagnostic::new(
                            codes::K2508,
                            self.here.origin.loc,
                            "the MAX point does not lie above the MIN point",
                        )
                        .help("the control refuses this blank; the path does not depend on it"),
                    );
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// FN 14 and up. What writes to screens and files only has no influence on the path.
    pub(super) fn fn_other(&mut self, number: u32, rest: &[u8]) -> Outcome {
        let rest = crate::text::decode::readable(rest).to_ascii_uppercase();
        match number {
            14 => {
                let error = rest.rsplit('=').next().unwrap_or_default().trim().to_owned();
                self.error(codes::K2309, format!("the program stops with error {error}"));
                self.ended = true;
                Err(Reported)
            }
            // Printing and logging.
            15 | 16 | 38 => Ok(()),
            // WAIT FOR SYNC only stops the look-ahead of the control.
            20 if rest.trim_start_matches("WAIT FOR").trim() == "SYNC" => Ok(()),
            26..=28 => {
                self.error(codes::K9006, format!("FN {number} works on a table of the control"));
                Err(Reported)
            }
            37 => {
                let name = rest.trim_start_matches("EXPORT").trim();
                match name.strip_prefix("QL").and_then(|digits| digits.parse().ok()) {
                    Some(number) => self.export(number),
                    None => {
                        self.error(codes::K1001, "FN 37 exports a QL parameter: `FN 37: EXPORT QL5`");
                        Err(Reported)
                    }
                }
            }
            17 | 19 | 20 | 25 | 29 => {
                self.error(codes::K9014, format!("FN {number} talks to the machine"));
                Err(Reported)
            }
            _ => {
                self.error(codes::K9011, format!("FN {number} is not supported"));
                Err(Reported)
            }
        }
    }

    /// A statement that is known by name only.
    pub(super) fn refused(&mut self, what: Refused) -> Outcome {
        match what {
            Refused::Plane => {
                self.refuse_motion(codes::K9004, "the tilted working plane cannot be compiled for three axes")
            }
            Refused::TouchProbe => self.refuse_motion(codes::K9005, "touch probe cycles run only at the machine"),
            Refused::Pattern => {
                self.error(codes::K9010, "point patterns are not supported yet");
                Err(Reported)
            }
            Refused::SelectTable => {
                self.error(codes::K9012, "datum tables are not supported");
                Err(Reported)
            }
            Refused::Contour => {
                self.error(codes::K9018, "contour definitions for SL cycles are not supported yet");
                Err(Reported)
            }
            Refused::Function => self.refuse_motion(codes::K9011, "this function is not supported"),
        }
    }

    /// PLANE RESET: no tilt was active, so nothing changes; the positioning words are checked.
    pub(super) fn plane_reset(&mut self, rest: &[u8]) -> Outcome {
        let rest = crate::text::decode::readable(rest).to_ascii_uppercase();
        let mut words = rest.split_whitespace();
        match words.next() {
            Some("STAY") | None if words.next().is_none() => {
                for number in 120..=122 {
                    self.set_control_parameter(number, 0.0);
                }
                Ok(())
            }
            _ => self.refuse_motion(codes::K9004, "PLANE RESET with MOVE or TURN moves the rotary axes"),
        }
    }

    /// A parameter that the control sets itself.
    pub(super) fn set_control_parameter(&mut self, number: u32, value: f64) {
        use crate::lexer::klartext::{QKind, QRef};
        if let Some(locals) = self.levels.iter_mut().rev().find_map(|level| level.locals.as_mut()) {
            self.vars.set(locals, QRef { kind: QKind::Q, number }, super::vars::Slot::Number(value));
        }
    }
}
