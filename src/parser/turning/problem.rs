//! What can be wrong with the form of a block, in words of the shop floor.

use lalrpop_util::ParseError;

use crate::diag::codes;
use crate::lexer::turning::Tok;
use crate::parser::problem::{Problem, whole_character};
use crate::text::Span;
use crate::text::decode::{named, readable};

use super::build::Refusal;

/// How statements look, by their first word.
const FORMS: &[(&str, &str)] = &[
    ("IF", "IF #1==1 THEN"),
    ("WHILE", "WHILE #1<10"),
    ("SWITCH", "SWITCH #1"),
    ("CASE", "CASE 1"),
    ("G", "G1 X50 Z-20"),
    ("V", "V1=V2+5"),
];

/// The finding for a block that the grammar does not take. `from` is where the statement starts.
pub fn of_parse_error(error: ParseError<u32, Tok, Refusal>, text: &[u8], from: u32) -> Problem {
    match error {
        ParseError::User { error } => error,
        ParseError::UnrecognizedToken { token: (start, tok, end), .. }
        | ParseError::ExtraToken { token: (start, tok, end) } => unexpected(tok, Span { start, end }, text, from),
        ParseError::InvalidToken { location } => unexpected(Tok::Bad, Span::at(location, 1), text, from),
        ParseError::UnrecognizedEof { location, .. } => {
            let span = Span { start: from, end: location.max(from) };
            form(Problem::new(codes::T1001, span, "the block ends too early"), text, from)
        }
    }
}

fn unexpected(tok: Tok, span: Span, text: &[u8], from: u32) -> Problem {
    let span = whole_character(span, text);
    let word = readable(span.of(text)).into_owned();
    let before = text.get(from as usize..span.start as usize).unwrap_or_default().trim_ascii_end();
    if tok == Tok::Bad {
        let problem = Problem::new(codes::T0001, span, format!("{} has no place in a block", named(span.of(text))));
        return problem.help("a comment stands in square brackets: [text]");
    }
    if before.last().is_some_and(u8::is_ascii_alphabetic) {
        let problem = Problem::new(codes::T1001, span, format!("`{word}` stands where a value is missing"));
        return problem.help("an address and its value stand together: `X50`, `X#5`, `X{#5+2}`");
    }
    form(Problem::new(codes::T1001, span, format!("`{word}` cannot stand here")), text, from)
}

/// Adds how a block with this first word looks.
fn form(problem: Problem, text: &[u8], from: u32) -> Problem {
    let rest = text.get(from as usize..).unwrap_or_default();
    let len = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let first = readable(&rest[..len]).to_uppercase();
    match FORMS.iter().find(|(head, _)| *head == first) {
        Some((_, form)) => problem.help(format!("the block looks like `{form}`")),
        None => problem,
    }
}
