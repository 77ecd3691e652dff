//! Lines of plain G-code for rules on source text.

use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::sema::run::survey::{Notes, Visitor, What};
use crate::sema::run::unexecuted::Passed;
use crate::sema::run::{Shown, Shows, survey_file};
use crate::text::{FileId, Span};

use super::Gcode;

/// Leads `visitor` through a file.
pub fn survey(job: &Job<'_>, file: FileId, visitor: &mut dyn Visitor) {
    survey_file::<Gcode>(job, file, visitor);
}

impl Shows for Gcode {
    type Before = ();

    fn show(passed: &Passed<'_, Gcode>, _: &Symbols, _: &mut (), items: bool, notes: &mut Notes) -> Shown {
        let (line, text) = (passed.block, passed.text);
        notes.comments.extend_from_slice(&line.comments);
        Shown {
            skip: line.skip.is_some(),
            words: line.span,
            ..words(text, line.from, &line.comments, items.then_some(notes))
        }
    }
}

/// Reads the words between the comments; each letter with its number is noted.
fn words(text: &[u8], from: usize, comments: &[Span], mut notes: Option<&mut Notes>) -> Shown {
    let mut found = Shown { is_empty: true, ..Shown::default() };
    let mut at = from;
    while at < text.len() {
        if let Some(comment) = comments.iter().find(|comment| comment.start as usize == at + 1) {
            at = comment.end as usize + 1;
            continue;
        }
        let byte = text[at];
        if byte.is_ascii_whitespace() || byte == b'%' {
            at += 1;
            continue;
        }
        let start = at;
        at += 1;
        let digits = text[at..].iter().take_while(|b| b.is_ascii_digit() || b"+-.".contains(b)).count();
        let number = std::str::from_utf8(&text[at..at + digits]).ok().and_then(|digits| digits.parse::<f64>().ok());
        at += digits;
        let (true, Some(value)) = (byte.is_ascii_alphabetic(), number) else {
            found.is_bad = true;
            return found;
        };
        let letter = byte.to_ascii_uppercase();
        if letter == b'N' {
            found.number = (value >= 0.0 && value <= f64::from(u32::MAX)).then_some(value as u32);
            continue;
        }
        found.is_empty = false;
        if let Some(notes) = notes.as_deref_mut() {
            let span = Span { start: start as u32, end: at as u32 };
            notes.word(letter, value, span);
            if letter == b'M' && (value == 2.0 || value == 30.0) {
                notes.add(What::Ends, span);
            }
        }
    }
    found
}
