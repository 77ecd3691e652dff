//! GLOBAL DEF: values for the parameters that a later cycle takes by PREDEF.
//!
//! A cycle takes the value when it is defined. Source: K 4.4 (docs/sources.md).

use crate::diag::codes;
use crate::lexer::klartext::QRef;
use crate::machine::Unit;
use crate::parser::klartext::ast::Block;
use crate::text::Span;

use super::reading::Reading;
use super::{Core, Outcome};

/// What GLOBAL DEF gives a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Given {
    Number(f64),
    /// FMAX or FAUTO.
    Word(&'static str),
}

/// Parameters of GLOBAL DEF, by number of the Q parameter.
#[derive(Debug, Default)]
pub(super) struct Globals {
    list: Vec<(u32, Given, Unit)>,
}

impl Globals {
    fn get(&self, q: u32) -> Option<(Given, Unit)> {
        self.list.iter().find(|(known, ..)| *known == q).map(|(_, given, unit)| (*given, *unit))
    }

    fn set(&mut self, q: u32, given: Given, unit: Unit) {
        self.list.retain(|(known, ..)| *known != q);
        self.list.push((q, given, unit));
    }

    /// GLOBAL DEF
    pub fn define(&mut self, reading: Reading<'_, '_>, block: &Block, text: &[u8]) -> Outcome {
        // A letter a byte, so that places in it are places in the program; words of other letters are names only.
        let bytes = text.get(block.span.start as usize..).unwrap_or_default();
        let code: String = bytes.iter().map(|b| if b.is_ascii() { char::from(*b) } else { '?' }).collect();
        let words = split(lines(&code, block.span.start));
        let Some((head, parameters)) = words.split_first() else { return Ok(()) };
        let number = head.0.split_ascii_whitespace().nth(2).and_then(|number| number.parse::<u32>().ok());
        if number == Some(125) {
            return reading.core.refuse(head.1, codes::P9011::global_def_125_decides_where_tool_goes());
        }
        let Some((number, takes)) = KNOWN.iter().find(|(known, _)| Some(*known) == number) else {
            return reading.core.refuse(head.1, codes::K2943::number_of_this_global_def_is_not());
        };
        for (word, span) in parameters {
            let (q, given) = parameter(reading, word, *span)?;
            if !takes.contains(&q) {
                return reading.core.refuse(*span, codes::K2943::global_def_has_no_parameter_q(&number, &q));
            }
            self.set(q, given, reading.core.unit());
        }
        Ok(())
    }

    /// What a parameter that says PREDEF takes.
    pub fn predefined(&self, core: &Core<'_>, q: QRef, span: Span) -> Outcome<Given> {
        match self.get(q.number) {
            Some((given, of)) if of == core.unit() => Ok(given),
            Some(_) => core.refuse(span, codes::K2943::global_def_with_stands_in_program(&q)),
            None => core.refuse(span, codes::K2944::no_global_def_gives_value(&q)),
        }
    }
}

/// A definition and the parameters that it has.
const KNOWN: &[(u32, &[u32])] = &[
    (100, &[200, 204, 253, 208]),
    (105, &[256, 210, 211]),
    (110, &[370, 351, 366]),
    (111, &[2, 6, 7]),
    (120, &[320, 260, 301]),
];

/// `Q200=+2`, where it stands, without blanks and comments.
type Line = (String, Span);

/// The words of a definition: its number and name, and its parameters.
fn lines(code: &str, start: u32) -> Vec<Line> {
    let mut list = Vec::new();
    let mut at = 0;
    for line in code.split_inclusive('\n') {
        let bare = line.split(';').next().unwrap_or_default();
        let mut from = 0;
        for part in bare.split_inclusive('~') {
            let text = part.trim_end_matches('~').trim();
            if !text.is_empty() {
                let lead = part.len() - part.trim_start().len();
                let span = Span::at(start + (at + from + lead) as u32, text.len() as u32);
                list.push((text.to_ascii_uppercase(), span));
            }
            from += part.len();
        }
        at += line.len();
    }
    list
}

/// `Q200=+2`
fn parameter(reading: Reading<'_, '_>, word: &str, span: Span) -> Outcome<(u32, Given)> {
    let unreadable = || reading.core.refuse(span, codes::K2943::is_no_parameter_with_its_value(&word));
    let Some((name, value)) = word.split_once('=') else { return unreadable() };
    let Some(q) = name.trim().strip_prefix('Q').and_then(|digits| digits.parse().ok()) else {
        return unreadable();
    };
    let value = value.trim();
    match value {
        "FMAX" | "MAX" => return Ok((q, Given::Word("FMAX"))),
        "FAUTO" | "AUTO" => return Ok((q, Given::Word("FAUTO"))),
        _ => {}
    }
    match reading.written(value, span) {
        Some(number) => Ok((q, Given::Number(number?))),
        None => unreadable(),
    }
}

/// Parameters that stand one after the other in a line.
fn split(list: Vec<Line>) -> Vec<Line> {
    let mut made: Vec<Line> = Vec::new();
    for (text, span) in list {
        let mut starts: Vec<usize> = text.match_indices('=').filter_map(|(at, _)| name_before(&text, at)).collect();
        if starts.first() != Some(&0) {
            starts.insert(0, 0);
        }
        for (i, from) in starts.iter().enumerate() {
            let to = starts.get(i + 1).copied().unwrap_or(text.len());
            let word = text[*from..to].trim_end();
            if !word.is_empty() {
                made.push((word.to_owned(), Span::at(span.start + *from as u32, word.len() as u32)));
            }
        }
    }
    made
}

/// Where the name begins that ends at the `=`.
fn name_before(text: &str, equals: usize) -> Option<usize> {
    let name = text[..equals].trim_end();
    let digits = name.trim_end_matches(|c: char| c.is_ascii_digit());
    (digits.len() < name.len() && digits.ends_with('Q')).then(|| digits.len() - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_definition() {
        let code = "GLOBAL DEF 100 GENERAL ~\n  Q200=+2 ;SET-UP ~\n Q204=+50 Q253=+750 ~\n Q208=FMAX";
        let words: Vec<String> = split(lines(code, 0)).into_iter().map(|(word, _)| word).collect();
        assert_eq!(words, ["GLOBAL DEF 100 GENERAL", "Q200=+2", "Q204=+50", "Q253=+750", "Q208=FMAX"]);
        let one: Vec<String> =
            split(lines("GLOBAL DEF 105 DRILLING Q256=Q1 Q210 = 0", 4)).into_iter().map(|l| l.0).collect();
        assert_eq!(one, ["GLOBAL DEF 105 DRILLING", "Q256=Q1", "Q210 = 0"]);
    }
}
