//! What can be wrong with the form of a block, in words of the shop floor.

use lalrpop_util::ParseError;

use crate::diag::codes;
use crate::lexer::sinumerik::Tok;
use crate::parser::problem::{Problem, whole_character};
use crate::text::Span;
use crate::text::decode::{named, readable};

use super::build::Refusal;

/// How statements look, by their first word.
const FORMS: &[(&str, &str)] = &[
    ("IF", "IF R1==1  or  IF R1==1 GOTOF LABEL"),
    ("WHILE", "WHILE R1<10"),
    ("FOR", "FOR R1=1 TO 10"),
    ("UNTIL", "UNTIL R1>10"),
    ("REPEAT", "REPEAT LABEL P=3"),
    ("REPEATB", "REPEATB LABEL P=3"),
    ("CASE", "CASE(R1) OF 1 GOTOF L1 2 GOTOF L2 DEFAULT GOTOF L3"),
    ("GOTO", "GOTO LABEL"),
    ("GOTOF", "GOTOF LABEL"),
    ("GOTOB", "GOTOB LABEL"),
    ("GOTOC", "GOTOC LABEL"),
    ("DEF", "DEF REAL DEPTH=5, WIDTH[3]"),
    ("PROC", "PROC NAME(REAL A, VAR INT B) SAVE"),
    ("EXTERN", "EXTERN NAME(REAL, VAR INT)"),
    ("CALL", "CALL \"NAME\""),
    ("PCALL", "PCALL /_N_SPF_DIR/NAME(1,2)"),
    ("MCALL", "MCALL NAME(1,2)"),
    ("EXTCALL", "EXTCALL(\"NAME\")"),
    ("G", "G1 X10 Y=R1 F200"),
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
            form(codes::P1001::block_ends_too_early_2().among(span).alarm(12080), text, from)
        }
    }
}

fn unexpected(tok: Tok, span: Span, text: &[u8], from: u32) -> Problem {
    let span = whole_character(span, text);
    let word = readable(span.of(text)).into_owned();
    let before = text.get(from as usize..span.start as usize).unwrap_or_default().trim_ascii_end();
    if tok == Tok::Bad {
        let problem = codes::P0010::has_no_place_in_block_2(&named(span.of(text))).among(span).alarm(12080);
        return problem.help("a comment starts with `;`");
    }
    if tok == Tok::Open && before.last().is_none_or(|b| !b.is_ascii_alphanumeric() && *b != b'_') {
        let problem = codes::S0003::brackets_hold_no_comment_on_this_control().among(span).alarm(12080);
        return problem.help("a comment starts with `;`");
    }
    if is_operator(tok) && before.last().is_some_and(|b| b"+-*/".contains(b)) {
        let problem = codes::S1002::follows_another_operator(&word).among(span).alarm(12180);
        return problem.help("put the second value in brackets: R1=R2-(-R3)");
    }
    if matches!(tok, Tok::Number(_) | Tok::Name | Tok::Letter(_)) && ends_in_name(before) {
        let problem = codes::P1001::is_missing_in_front(&word).among(span).alarm(12080);
        return problem.help("an address of more than one letter takes `=`: CR=10");
    }
    let problem = codes::P1001::cannot_stand_here(&word).among(span).alarm(12080);
    match form_of(text, from) {
        None if is_speech(before) => {
            problem.help("this reads as plain speech and is no block; a comment starts with `;`")
        }
        _ => form(problem, text, from),
    }
}

/// Three words of letters beside each other, one of them with a small letter: no block has such.
fn is_speech(before: &[u8]) -> bool {
    let is_plain = |word: &&[u8]| word.len() > 1 && word.iter().all(u8::is_ascii_alphabetic);
    let words: Vec<&[u8]> = before.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).collect();
    let plain = words.iter().rev().take_while(|word| is_plain(word)).count();
    plain >= 3 && before.iter().any(u8::is_ascii_lowercase)
}

fn is_operator(tok: Tok) -> bool {
    matches!(tok, Tok::Plus | Tok::Minus | Tok::Star | Tok::Slash | Tok::Div | Tok::Mod)
}

/// Does the text end in a name of two letters or more?
fn ends_in_name(text: &[u8]) -> bool {
    let len = text.iter().rev().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
    let name = &text[text.len() - len..];
    matches!(name, [a, b, ..] if (a.is_ascii_alphabetic() || *a == b'_') && (b.is_ascii_alphabetic() || *b == b'_'))
}

/// Adds how a block with this first word looks.
fn form(problem: Problem, text: &[u8], from: u32) -> Problem {
    match form_of(text, from) {
        Some(form) => problem.help(format!("the block looks like `{form}`")),
        None => problem,
    }
}

fn form_of(text: &[u8], from: u32) -> Option<&'static str> {
    let rest = text.get(from as usize..).unwrap_or_default();
    let len = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let first = readable(&rest[..len]).to_uppercase();
    FORMS.iter().find(|(head, _)| *head == first).map(|(_, form)| *form)
}
