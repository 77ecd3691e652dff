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

/// Words that begin a statement which is not compiled, and what they do.
const KEYWORDS: &[(&str, &str)] = &[
    ("INPUT", "asks the operator for a value"),
    ("INPUTA", "asks the operator for a value"),
    ("WINDOW", "opens a window for the operator"),
    ("WINDOWA", "opens a window for the operator"),
    ("PRINT", "shows a value to the operator"),
    ("PRINTA", "shows a value to the operator"),
    ("PARA", "reads a parameter of the machine"),
    ("CONST", "names constants"),
    ("VAR", "names variables"),
];

/// The finding for a statement that begins with this word and is not compiled.
pub fn keyword(word: Span, text: &[u8]) -> Problem {
    let shown = readable(word.of(text)).into_owned();
    let upper = shown.to_uppercase();
    let Some((_, what)) = KEYWORDS.iter().find(|(known, _)| *known == upper) else {
        return codes::T9002::is_not_supported_2(&shown).among(word);
    };
    let problem = codes::T9002::is_not_supported(&shown, &what).among(word);
    problem.help(match *what {
        "shows a value to the operator" | "opens a window for the operator" => {
            "leave it out of the copy that is compiled"
        }
        "names constants" | "names variables" => "write the value or the variable itself where a name stands",
        _ => "assign the value in the program: `#l1=5`",
    })
}

/// The known word that the statement at `from` begins with.
fn first_keyword(text: &[u8], from: u32) -> Option<Span> {
    let rest = text.get(from as usize..)?;
    let len = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let known = KEYWORDS.iter().any(|(known, _)| rest[..len].eq_ignore_ascii_case(known.as_bytes()));
    known.then(|| Span::at(from, len as u32))
}

/// The finding for a block that the grammar does not take. `from` is where the statement starts.
pub fn of_parse_error(error: ParseError<u32, Tok, Refusal>, text: &[u8], from: u32) -> Problem {
    if let Some(word) = first_keyword(text, from) {
        return keyword(word, text);
    }
    match error {
        ParseError::User { error } => error,
        ParseError::UnrecognizedToken { token: (start, tok, end), .. }
        | ParseError::ExtraToken { token: (start, tok, end) } => unexpected(tok, Span { start, end }, text, from),
        ParseError::InvalidToken { location } => unexpected(Tok::Bad, Span::at(location, 1), text, from),
        ParseError::UnrecognizedEof { location, .. } => {
            let span = Span { start: from, end: location.max(from) };
            form(codes::P1001::block_ends_too_early_2().among(span), text, from)
        }
    }
}

fn unexpected(tok: Tok, span: Span, text: &[u8], from: u32) -> Problem {
    let span = whole_character(span, text);
    let word = readable(span.of(text)).into_owned();
    let before = text.get(from as usize..span.start as usize).unwrap_or_default().trim_ascii_end();
    if tok == Tok::Bad {
        let problem = codes::P0010::has_no_place_in_block_2(&named(span.of(text))).among(span);
        return problem.help("a comment stands in square brackets: [text]");
    }
    if before.last().is_some_and(u8::is_ascii_alphabetic) {
        let problem = codes::P1001::stands_where_value_is_missing(&word).among(span);
        return problem.help("an address and its value stand together: `X50`, `X#5`, `X{#5+2}`");
    }
    form(codes::P1001::cannot_stand_here(&word).among(span), text, from)
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
