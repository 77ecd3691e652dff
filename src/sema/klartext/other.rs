//! FN 14 and up, and statements that are refused by name.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Point2, SAME_POINT, arc, distance};
use crate::lexer::klartext::{QKind, QRef};
use crate::parser::klartext::ast::{Block, Refused};

use super::calls::innermost_locals;
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
                    .help("if the target machine needs them, switch by an M function: `[output] pass_m`"),
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

    /// A statement that is known by name only.
    pub(super) fn refused(&mut self, what: Refused, block: &Block, text: &[u8]) -> Outcome {
        let (name, span) = self.block_name(block, text, if matches!(what, Refused::Function) { 1 } else { 2 });
        match what {
            Refused::Plane => self.plane_block(block, text),
            Refused::TouchProbe => self.probe(block, text),
            Refused::Pattern => {
                self.fail(codes::K9010, span, format!("{name}: point tables of the control are not supported"))
            }
            Refused::SelectTable if span.end < block.span.end => {
                self.left_out(
                    "SEL TABLE only selects, a shift from the table is refused where it is programmed, and it",
                );
                Ok(())
            }
            Refused::SelectTable => self.fail_help(
                codes::K1006,
                span,
                format!("{name} names no table"),
                "write the name of the table: `SEL TABLE \"NAME.D\"`",
            ),
            Refused::Contour => {
                self.fail(codes::K9018, span, format!("{name}: contours of SL cycles are not supported yet"))
            }
            Refused::GlobalDef => self.fail_help(
                codes::K9011,
                span,
                "GLOBAL DEF sets parameters for cycles that take them by PREDEF, which is not supported",
                "write the values into the cycles that say PREDEF, and remove this block",
            ),
            Refused::Function if is_harmless(block.span.of(text)) => {
                self.job.diags.push_once(Diagnostic::new(
                    codes::K2703,
                    self.here.origin.loc,
                    format!("{} has no word in the output", self.block_name(block, text, 3).0),
                ));
                Ok(())
            }
            Refused::Function => {
                let (name, span) =
                    self.block_name(block, text, if name.eq_ignore_ascii_case("FUNCTION") { 2 } else { 1 });
                self.refuse_motion(codes::K9011, span, &format!("{name} is not supported"))
            }
        }
    }

    /// A statement without influence on the path.
    fn left_out(&self, what: &str) {
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

/// FUNCTION blocks that no path depends on: milling mode, which is the only one here; the end of functions that are
/// refused where they begin; dwells and speed changes that break chips; counters; supervision.
pub(super) fn is_harmless(code: &[u8]) -> bool {
    let text = crate::text::decode::readable(code).to_ascii_uppercase();
    let words: Vec<&str> = text.split_whitespace().take(4).collect();
    match words.as_slice() {
        ["FUNCTION", "MODE", "MILL"] | ["FUNCTION", "RESET", "TCPM"] | ["FUNCTION", "TCPM", "RESET"] => true,
        ["FUNCTION", "FEED", "DWELL", ..] | ["FUNCTION", "S-PULSE", ..] | ["FUNCTION", "LIFTOFF", ..] => true,
        ["FUNCTION", "COUNT", what, ..] => *what != "REPEAT",
        ["SECTION", "MONITORING", ..] | ["MONITORING", ..] => true,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::is_harmless;

    #[test]
    fn functions_without_a_path() {
        for text in
            ["FUNCTION MODE MILL", "function reset tcpm", "FUNCTION FEED DWELL D-TIME0.5 F-TIME5", "FUNCTION COUNT INC"]
        {
            assert!(is_harmless(text.as_bytes()), "{text}");
        }
        for text in [
            "FUNCTION MODE TURN",
            "FUNCTION TCPM F TCP AXIS POS",
            "FUNCTION COUNT REPEAT LBL \"A\"",
            "FUNCTION MODE MILL \"K\"",
        ] {
            assert!(!is_harmless(text.as_bytes()), "{text}");
        }
    }
}
