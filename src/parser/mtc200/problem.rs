//! What can be wrong with the form of a block, in words of the shop floor.

use lalrpop_util::ParseError;

use crate::diag::codes;
use crate::lexer::mtc200::Tok;
use crate::parser::problem::{Problem, whole_character};
use crate::text::Span;
use crate::text::decode::{named, readable};

use super::build::Refusal;

/// Functions that read or write data of the control, by name.
const SYSTEM_FUNCTIONS: &[&str] = &["AXD", "DCD", "KDI", "MTD", "OTD", "TLD"];

/// What they are.
pub const SYSTEM_FUNCTION: &str = "a system function, whose data only the control has";
/// What to do about one.
pub const WITHOUT_SYSTEM_DATA: &str = "give what is read as a number, or as a variable in `[variables]` of partc.toml; leave out a block that only writes";

/// Is it a function of the control that reads or writes tools, offsets or parameters? `name` is in capitals.
pub fn is_system_function(name: &str) -> bool {
    SYSTEM_FUNCTIONS.contains(&name)
}

/// The finding for a block that the grammar does not take. `from` is where its words start.
pub fn of_parse_error(error: ParseError<u32, Tok, Refusal>, text: &[u8], from: u32) -> Problem {
    match error {
        ParseError::User { error } => error,
        ParseError::UnrecognizedToken { token: (start, tok, end), .. }
        | ParseError::ExtraToken { token: (start, tok, end) } => unexpected(tok, Span { start, end }, text, from),
        ParseError::InvalidToken { location } => unexpected(Tok::Bad, Span::at(location, 1), text, from),
        ParseError::UnrecognizedEof { location, .. } => {
            let span = Span { start: from, end: location.max(from) };
            if let Some(letter) = bare_letter(text, location) {
                return letter;
            }
            codes::P1001::block_ends_too_early_so_formula().among(span)
        }
    }
}

/// The address without a value that ends at `end`.
fn bare_letter(text: &[u8], end: u32) -> Option<Problem> {
    let end = end as usize;
    let code = text.get(..end)?.trim_ascii_end();
    let (&letter, before) = code.split_last()?;
    let alone = letter.is_ascii_alphabetic() && before.last().is_none_or(|b| !b.is_ascii_alphabetic() && *b != b'_');
    alone.then(|| without_value(Span::at(before.len() as u32, 1), letter))
}

fn without_value(span: Span, letter: u8) -> Problem {
    let letter = letter.to_ascii_uppercase() as char;
    codes::M1003::address_has_no_value(&letter).among(span)
}

fn unexpected(tok: Tok, span: Span, text: &[u8], from: u32) -> Problem {
    let span = whole_character(span, text);
    let word = readable(span.of(text)).into_owned();
    match tok {
        Tok::Unclosed => {
            return codes::M0003::comment_that_begins_here_is_not_closed().among(span);
        }
        Tok::Bad => {
            return codes::P0010::has_no_place_in_block_so_comment_stands(&named(span.of(text))).among(span);
        }
        Tok::OtherVariable => {
            return codes::M9002::is_variable_of_another_process(&word).among(span);
        }
        Tok::Name if is_system_function(&word.to_ascii_uppercase()) => {
            return codes::M9002::is_not_supported_so_give_what(&word, &SYSTEM_FUNCTION).among(span);
        }
        _ => {}
    }
    let before = text.get(from as usize..span.start as usize).unwrap_or_default();
    if let Some(found) = bare_letter(before, before.len() as u32).filter(|_| tok != Tok::Assign) {
        return Problem { span: found.span.shifted(from), ..found };
    }
    let problem = codes::P1001::cannot_stand_here(&word).among(span);
    match tok {
        Tok::Label => problem.help("a label stands at the start of a block or after a jump such as `BRA .LOOP`"),
        Tok::Variable(_) => problem.help("a variable is the value of a word: X=@050"),
        Tok::Slash => problem.help("the skip mark stands at the start of the block"),
        _ => problem.help("a block is a list of words such as `G01 X10 Y=@050 F200`"),
    }
}
