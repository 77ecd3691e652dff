//! What can be wrong with the form of a block, in words of the shop floor.

use lalrpop_util::ParseError;

use crate::diag::{Code, codes};
use crate::lexer::klartext::Tok;
use crate::machine::tree::did_you_mean;
use crate::text::{Span, decode::readable};

use super::build::Refusal;

/// A finding about one block; spans count from its start.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    pub code: &'static Code,
    pub span: Span,
    pub message: String,
    pub help: Option<String>,
}

impl Problem {
    pub fn new(code: &'static Code, span: Span, message: impl Into<String>) -> Problem {
        Problem { code, span, message: message.into(), help: None }
    }

    pub fn help(mut self, text: impl Into<String>) -> Problem {
        self.help = Some(text.into());
        self
    }
}

/// How blocks look, by their first word.
const FORMS: &[(&str, &str)] = &[
    ("L", "L X+10 Y-5 Z+2 R0 F500 M3"),
    ("C", "C X+20 Y+10 DR+ F200"),
    ("CC", "CC X+20 Y+10"),
    ("CR", "CR X+20 Y+10 R+15 DR- F200"),
    ("CT", "CT X+20 Y+10 F200"),
    ("LP", "LP PR+20 PA+30 F200"),
    ("CP", "CP IPA+90 DR+ F200"),
    ("CTP", "CTP PR+20 PA+30 F200"),
    ("RND", "RND R5 F200"),
    ("CHF", "CHF 5 F200"),
    ("APPR", "APPR LCT X+10 Y+5 R8 RL F200"),
    ("DEP", "DEP LCT X+10 Y+5 R8"),
    ("BEGIN", "BEGIN PGM NAME MM"),
    ("END", "END PGM NAME MM"),
    ("BLK", "BLK FORM 0.1 Z X+0 Y+0 Z-20"),
    ("TOOL", "TOOL CALL 5 Z S2500 F500"),
    ("LBL", "LBL 1"),
    ("CALL", "CALL LBL 1 REP 2"),
    ("CYCL", "CYCL DEF 7.1 X+60"),
    ("FN", "FN 1: Q1 = +Q2 + +5"),
    ("Q", "Q1 = ( Q2 + 5 ) * SIN 30"),
    ("STOP", "STOP M6"),
    ("PLANE", "PLANE RESET STAY"),
    ("TCH", "TCH PROBE 0.0 REF. PLANE Q5 Z-"),
    ("TRANS", "TRANS DATUM AXIS X+10 Y+25"),
    ("SEL", "SEL PGM \"NAME.H\""),
    ("PATTERN", "PATTERN DEF POS1 (X+12 Y+20 Z+0)"),
    ("DECLARE", "DECLARE STRING QS1 = \"TEXT\""),
    ("FUNCTION", "FUNCTION MODE MILL"),
    ("FPOL", "FPOL X+0 Y+0"),
    ("FL", "FL X+10 AN+30"),
    ("FC", "FC DR+ R10"),
    ("M", "M3"),
    ("X", "X+50 R0 F200"),
];

/// The finding for a block that the grammar does not take. `from` is where the statement starts.
pub fn of_parse_error(error: ParseError<u32, Tok, Refusal>, text: &[u8], from: u32) -> Problem {
    match error {
        ParseError::User { error } => Problem::new(codes::K1001, error.span, error.message).form(text, from),
        ParseError::UnrecognizedToken { token: (start, tok, end), .. }
        | ParseError::ExtraToken { token: (start, tok, end) } => unexpected(tok, Span { start, end }, text, from),
        ParseError::InvalidToken { location } => unexpected(Tok::Bad, Span::at(location, 1), text, from),
        ParseError::UnrecognizedEof { location, .. } => {
            let span = Span { start: from, end: location.max(from) };
            Problem::new(codes::K1001, span, "block ends too early").form(text, from)
        }
    }
}

fn unexpected(tok: Tok, span: Span, text: &[u8], from: u32) -> Problem {
    let word = readable(span.of(text)).into_owned();
    if tok == Tok::Bad {
        return Problem::new(codes::K0001, span, format!("`{word}` has no place in a block"))
            .help("a comment starts with `;`");
    }
    if span.start == from {
        let first: String = word.chars().take_while(|c| c.is_alphabetic()).collect();
        let problem = Problem::new(codes::K1002, span, format!("`{word}` begins no Klartext block"));
        let heads = FORMS.iter().map(|(head, _)| *head).filter(|head| head.len() > 1);
        return match did_you_mean(&first, heads) {
            Some(like) if first.len() > 1 => problem.help(format!("did you mean `{like}`?")),
            _ => problem.help("a comment starts with `;`"),
        };
    }
    Problem::new(codes::K1001, span, format!("`{word}` cannot stand here")).form(text, from)
}

impl Problem {
    /// Adds how a block with this first word looks.
    fn form(self, text: &[u8], from: u32) -> Problem {
        let rest = text.get(from as usize..).unwrap_or_default();
        let len = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let first = readable(&rest[..len]).to_uppercase();
        let first = if first.starts_with('Q') { "Q" } else { &first };
        match FORMS.iter().find(|(head, _)| *head == first) {
            Some((_, form)) => self.help(format!("the block looks like `{form}`")),
            None => self,
        }
    }
}
