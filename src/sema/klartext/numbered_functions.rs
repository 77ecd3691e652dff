//! FN 14 and up.

use crate::diag::codes;
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
                self.core.say_here(codes::P2026::program_stops_with_error(&error));
                self.core.stop_run();
                Err(Reported)
            }
            15 | 16 | 38 => {
                self.left_out(&format!("FN {number} writes to a screen, a file or a log, and"));
                Ok(())
            }
            23 => self.circle_data(&rest),
            24 => {
                self.core.say_here(codes::P9011::fn_24_fits_circle_to_four_points());
                Err(Reported)
            }
            20 if rest.trim_start_matches("WAIT FOR").trim() == "SYNC" => {
                self.left_out("FN 20: WAIT FOR SYNC stops the look-ahead of the control only, and");
                Ok(())
            }
            26..=28 => {
                self.core.say_here(codes::K9006::fn_works_on_table_of_control(&number));
                Err(Reported)
            }
            37 => {
                let name = rest.trim_start_matches("EXPORT").trim();
                match name.strip_prefix("QL").and_then(|digits| digits.parse().ok()) {
                    Some(number) => self.export(number),
                    None => {
                        self.core.say_here(codes::P1001::fn_37_exports_ql_parameter());
                        Err(Reported)
                    }
                }
            }
            // Values for the machine's own control; the path does not depend on them (K 5.2).
            19 | 29 => {
                self.core
                    .report(codes::K2212::fn_gives_values_to_plc_of_machine(&number).at(self.core.here.origin.loc));
                Ok(())
            }
            17 | 20 | 25 => {
                self.core.say_here(codes::K9014::fn_talks_to_machine(&number));
                Err(Reported)
            }
            _ => {
                self.core.say_here(codes::P9011::fn_is_not_supported(&number));
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
        let span = self.core.block_span();
        let Some((target, from)) = parts.filter(|(target, from)| target.max(from) < &1990) else {
            return self.core.refuse(span, codes::P1001::fn_23_names_its_result());
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
            return self.core.refuse(span, codes::P2022::no_circle_leads_through_three_points());
        };
        for (number, value) in (target..).zip([center.x, center.y, distance(a, center)]) {
            self.set(at(number), Slot::Number(value), span)?;
        }
        Ok(())
    }

    /// A statement without influence on the path.
    pub(super) fn left_out(&self, what: &str) {
        self.core.report(codes::K2805::has_no_word_in_output(&what).at(self.core.here.origin.loc));
    }

    /// A parameter that the control sets itself.
    pub(super) fn set_control_parameter(&mut self, q: QRef, value: Slot) {
        if let Some(locals) = innermost_locals(&mut self.core.levels) {
            self.vars.set(locals, q, value);
        }
    }
}
