//! Statements that are known by name only: refused, or left out because no path depends on them.

use crate::diag::codes;
use crate::parser::klartext::ast::{Block, Refused};
use crate::sema::run::Where;
use crate::text::Span;

use super::block_text::block_name;
use super::point_table;
use super::reading::Reading;
use super::{Outcome, Run};

impl Run<'_> {
    /// A statement that is known by name only.
    pub(super) fn refused(&mut self, what: Refused, block: &Block, text: &[u8]) -> Outcome {
        let (name, span) = block_name(block, text, if matches!(what, Refused::Function) { 1 } else { 2 });
        match what {
            Refused::Plane => self.plane_block(block, text),
            Refused::TouchProbe => self.probe(block, text),
            Refused::Pattern => {
                let written = Span { start: span.end, end: block.span.end }.of(text);
                let places = point_table::select(self.reading(), written);
                self.pattern.define(places)
            }
            Refused::SelectTable if span.end < block.span.end => {
                let written = Span { start: span.end, end: block.span.end }.of(text);
                let name = self.reading().program_name(written)?;
                self.datum_table.select(name, self.core.here.origin.loc);
                self.core.left_out("SEL TABLE only selects the table that datum shifts take rows of, and");
                Ok(())
            }
            Refused::SelectTable => self.core.refuse(span, codes::P1004::names_no_table(&name)),
            Refused::Contour => {
                let by_parameter = name.get(..2).is_some_and(|head| head.eq_ignore_ascii_case("QC"));
                let (name, span) = if by_parameter { block_name(block, text, 1) } else { (name, span) };
                self.core.refuse(span, codes::K9018::contours_that_are_put_together_are_not(&name))
            }
            Refused::GlobalDef => {
                let reading = Reading { core: &self.core, vars: &self.vars, st: &self.st };
                self.globals.define(reading, block, text)
            }
            Refused::Function if is_harmless(block.span.of(text)) => {
                self.core.note(Where::Block, codes::K2703::has_no_word_in_output(&block_name(block, text, 3).0));
                Ok(())
            }
            Refused::Function => {
                let (name, span) = block_name(block, text, words_of_name(&name));
                if let Some(name) = named_branch(&name) {
                    self.st.lose_all(&mut self.core);
                    return self.core.refuse(span, codes::P9011::is_not_supported(&name));
                }
                self.st.refuse_motion(&mut self.core, span, codes::P9011::is_not_supported_3(&name))
            }
        }
    }
}

/// The name of a block of `IF … THEN`.
fn named_branch(name: &str) -> Option<&'static str> {
    let name = name.to_ascii_uppercase();
    [("IF", "IF … THEN"), ("ELSE", "ELSE"), ("ELSEIF", "ELSE IF"), ("END IF", "END IF"), ("ENDIF", "END IF")]
        .into_iter()
        .find_map(|(head, shown)| (name == head).then_some(shown))
}

/// How many words name the function that begins with `first`.
fn words_of_name(first: &str) -> usize {
    let of_two = ["FUNCTION", "SEL", "OPEN", "FIXTURE", "END"];
    if of_two.iter().any(|head| first.eq_ignore_ascii_case(head)) { 2 } else { 1 }
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
