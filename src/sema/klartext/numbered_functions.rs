//! FN 14 and up.

use crate::diag::codes;
use crate::geo::{Point2, SAME_POINT, arc, distance};
use crate::lexer::klartext::{QKind, QRef};
use crate::sema::run::Where;

use super::vars::Slot;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    /// FN 14 and up. What writes to screens and files only has no influence on the path.
    pub(super) fn fn_other(&mut self, number: u32, rest: &[u8]) -> Outcome {
        if matches!(number, 17..=29) {
            self.vars.lose_target(&mut self.core, rest);
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
                self.core.left_out(&format!("FN {number} writes to a screen, a file or a log, and"));
                Ok(())
            }
            23 => self.circle_data(&rest),
            24 => self.core.refuse(Where::Block, codes::P9011::fn_24_fits_circle_to_four_points()),
            20 if rest.trim_start_matches("WAIT FOR").trim() == "SYNC" => {
                self.core.left_out("FN 20: WAIT FOR SYNC stops the look-ahead of the control only, and");
                Ok(())
            }
            26..=28 => self.core.refuse(Where::Block, codes::K9006::fn_works_on_table_of_control(&number)),
            37 => {
                let name = rest.trim_start_matches("EXPORT").trim();
                match name.strip_prefix("QL").and_then(|digits| digits.parse().ok()) {
                    Some(number) => self.vars.export(&mut self.core, number),
                    None => self.core.refuse(Where::Block, codes::P1001::fn_37_exports_ql_parameter()),
                }
            }
            // Values for the machine's own control; the path does not depend on them (K 5.2).
            19 | 29 => {
                self.core.say_here(codes::K2212::fn_gives_values_to_plc_of_machine(&number));
                Ok(())
            }
            17 | 20 | 25 => self.core.refuse(Where::Block, codes::K9014::fn_talks_to_machine(&number)),
            _ => self.core.refuse(Where::Block, codes::P9011::fn_is_not_supported(&number)),
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
            self.vars.assign(&mut self.core, at(number), Slot::Lost, span)?;
        }
        let mut points = [Point2::origin(); 3];
        for (i, point) in (0..).zip(&mut points) {
            let of = |number| self.reading().parameter(at(number), span);
            *point = Point2::new(of(from + 2 * i)?, of(from + 2 * i + 1)?);
        }
        let [a, b, c] = points;
        let Some((center, _)) = arc::through(a, b, c, SAME_POINT) else {
            return self.core.refuse(span, codes::P2022::no_circle_leads_through_three_points());
        };
        for (number, value) in (target..).zip([center.x, center.y, distance(a, center)]) {
            self.vars.assign(&mut self.core, at(number), Slot::Number(value), span)?;
        }
        Ok(())
    }
}
