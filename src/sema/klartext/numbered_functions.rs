//! FN 14 and up.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Point2, SAME_POINT, arc, distance};
use crate::lexer::klartext::{QKind, QRef};

use super::flow::innermost_locals;
use super::vars::Slot;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    /// FN 14 and up. What writes to screens and files only has no influence on the path.
    pub(super) fn fn_other(&mut self, number: u32, rest: &[u8]) -> Outcome {
        if matches!(number, 17..=29) {
            self.lose_target(rest);
        }
        let rest = crate::text::decode::readable(rest).to_ascii_uppercase();
        match number {
            14 => {
                let error = rest.rsplit('=').next().unwrap_or_default().trim().to_owned();
                self.error(codes::K2309, format!("the program stops with error {error}"));
                self.stop_run();
                Err(Reported)
            }
            15 | 16 | 38 => {
                self.left_out(&format!("FN {number} writes to a screen, a file or a log, and"));
                Ok(())
            }
            23 => self.circle_data(&rest),
            24 => {
                self.error(codes::K9011, "FN 24 fits a circle to four points, and how it does is not documented");
                Err(Reported)
            }
            20 if rest.trim_start_matches("WAIT FOR").trim() == "SYNC" => {
                self.left_out("FN 20: WAIT FOR SYNC stops the look-ahead of the control only, and");
                Ok(())
            }
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
            // Values for the machine's own control; the path does not depend on them (K 5.2).
            19 | 29 => {
                self.report(
                    Diagnostic::new(
                        codes::K2212,
                        self.here.origin.loc,
                        format!(
                            "FN {number} gives values to the PLC of the machine, and the output has no word for it"
                        ),
                    )
                    .help("if the target machine needs them, switch by an M function that the target knows"),
                );
                Ok(())
            }
            17 | 20 | 25 => {
                self.error(codes::K9014, format!("FN {number} talks to the machine"));
                Err(Reported)
            }
            _ => {
                self.error(codes::K9011, format!("FN {number} is not supported"));
                Err(Reported)
            }
        }
    }

    /// FN 23: `Q20 = CDATA Q30` puts centre and radius of the circle through the points Q30 to Q35 into Q20 to Q22.
    fn circle_data(&mut self, rest: &str) -> Outcome {
        let q = |text: &str| text.trim().strip_prefix('Q').and_then(|digits| digits.parse::<u32>().ok());
        let parts = rest.split_once('=').and_then(|(target, data)| {
            let from = data.trim().strip_prefix("CDATA")?;
            Some((q(target)?, q(from)?))
        });
        let span = self.block_span();
        let Some((target, from)) = parts.filter(|(target, from)| target.max(from) < &1990) else {
            return self.fail_help(
                codes::K1001,
                span,
                "FN 23 names its result and its points",
                "write `FN 23: Q20 = CDATA Q30`",
            );
        };
        let at = |number| QRef { kind: QKind::Q, number };
        for number in target..target + 3 {
            self.set(at(number), Slot::Lost, span)?;
        }
        let mut points = [Point2::origin(); 3];
        for (i, point) in (0..).zip(&mut points) {
            *point = Point2::new(self.parameter(at(from + 2 * i), span)?, self.parameter(at(from + 2 * i + 1), span)?);
        }
        let [a, b, c] = points;
        let Some((center, _)) = arc::through(a, b, c, SAME_POINT) else {
            return self.fail(codes::K2303, span, "no circle leads through the three points");
        };
        for (number, value) in (target..).zip([center.x, center.y, distance(a, center)]) {
            self.set(at(number), Slot::Number(value), span)?;
        }
        Ok(())
    }

    /// A statement without influence on the path.
    pub(super) fn left_out(&self, what: &str) {
        let text = format!("{what} has no word in the output");
        self.report(Diagnostic::new(codes::K2805, self.here.origin.loc, text));
    }

    /// A parameter that the control sets itself.
    pub(super) fn set_control_parameter(&mut self, q: QRef, value: Slot) {
        if let Some(locals) = innermost_locals(&mut self.core.levels) {
            self.vars.set(locals, q, value);
        }
    }
}
