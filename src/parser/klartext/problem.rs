//! What can be wrong with the form of a block, in words of the shop floor.

use lalrpop_util::ParseError;

use crate::diag::codes;
use crate::lexer::klartext::{Tok, Tokens};
use crate::machine::tree::did_you_mean;
use crate::text::Span;
use crate::text::decode::{named, readable};

use super::build::Refusal;
use super::cycle::{begins_line, dangling};
use crate::parser::not_a_number::{Misprint, misprint};
use crate::parser::problem::{Problem, whole_character};

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
    ("FN 9", "FN 9: IF +Q1 EQU +5 GOTO LBL 1"),
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
    if let Some(span) = named_parameter(text, from) {
        let shown = readable(span.of(text)).into_owned();
        return codes::P9011::is_parameter_by_name(&shown).among(span);
    }
    if matches!(Tokens::new(text, from as usize).next(), Some((_, Tok::PatternDef, _))) {
        return no_pattern(&error, text, from);
    }
    match error {
        ParseError::User { error } => Problem::new(codes::P1001, error.span, error.message).form(text, from),
        ParseError::UnrecognizedToken { token: (start, tok, end), .. }
        | ParseError::ExtraToken { token: (start, tok, end) } => unexpected(tok, Span { start, end }, text, from),
        ParseError::InvalidToken { location } => unexpected(Tok::Bad, Span::at(location, 1), text, from),
        ParseError::UnrecognizedEof { location, .. } => {
            let span = Span { start: from, end: location.max(from) };
            codes::P1001::block_ends_too_early().among(span).form(text, from)
        }
    }
}

/// What does not belong into a PATTERN DEF.
fn no_pattern(error: &ParseError<u32, Tok, Refusal>, text: &[u8], from: u32) -> Problem {
    let span = match error {
        ParseError::User { error } => error.span,
        ParseError::UnrecognizedToken { token: (start, _, end), .. }
        | ParseError::ExtraToken { token: (start, _, end) } => Span { start: *start, end: *end },
        ParseError::InvalidToken { location } => Span::at(*location, 1),
        ParseError::UnrecognizedEof { location, .. } => {
            return codes::K2411::ends_too_early().among(Span { start: from, end: (*location).max(from) });
        }
    };
    let span = whole_character(span, text);
    if let Some(problem) = misprinted(text, span) {
        return problem;
    }
    codes::K2411::cannot_be_read_here(&readable(span.of(text))).among(span)
}

/// The first parameter by name, `{Depth}`, outside of texts and comments.
fn named_parameter(text: &[u8], from: u32) -> Option<Span> {
    Tokens::new(text, from as usize).find(|(_, tok, _)| *tok == Tok::Named).map(|(start, _, end)| Span { start, end })
}

fn unexpected(tok: Tok, span: Span, text: &[u8], from: u32) -> Problem {
    let span = whole_character(span, text);
    let word = readable(span.of(text)).into_owned();
    if let Some(problem) = misprinted(text, span) {
        return problem;
    }
    if tok == Tok::Bad {
        return codes::P0010::has_no_place_in_block(&named(span.of(text))).among(span);
    }
    if span.start > from && begins_line(text, span.start) {
        return dangling(text, span.start, "the block");
    }
    if span.start == from {
        return no_statement(&word, span, text);
    }
    codes::P1001::cannot_stand_here(&word).among(span).form(text, from)
}

/// A word around `span` that is no number, or one with an exponent.
pub fn misprinted(text: &[u8], span: Span) -> Option<Problem> {
    let (kind, range) = misprint(text, span.start as usize)?;
    let span = Span { start: range.start as u32, end: range.end as u32 };
    let word = readable(span.of(text)).into_owned();
    Some(match kind {
        Misprint::Nothing => no_number(&word, span),
        Misprint::Exponent => codes::K0801::has_exponent_which_control_does_not_read(&word).among(span),
    })
}

/// A word that some program wrote instead of a number.
pub fn no_number(word: &str, span: Span) -> Problem {
    codes::K0801::is_no_number(&word).among(span)
}

/// Statements of two words: the first one, the second ones, how such a block looks.
const PAIRS: &[(&str, &[&str], &str)] = &[
    ("BEGIN", &["PGM"], "BEGIN PGM NAME MM"),
    ("END", &["PGM"], "END PGM NAME MM"),
    ("BLK", &["FORM"], "BLK FORM 0.1 Z X+0 Y+0 Z-20"),
    ("TOOL", &["CALL", "DEF"], "TOOL CALL 5 Z S2500 F500"),
    ("CALL", &["LBL", "PGM", "SELECTED"], "CALL LBL 1` or `CALL PGM NAME.H"),
    ("SEL", &["PGM", "PATTERN", "TABLE", "CONTOUR"], "SEL PGM \"NAME.H\""),
    ("CYCL", &["DEF", "CALL"], "CYCL DEF 7.1 X+60` or `CYCL CALL"),
    ("TRANS", &["DATUM", "MIRROR", "ROTATION", "SCALE"], "TRANS DATUM AXIS X+10 Y+25"),
    ("TCH", &["PROBE"], "TCH PROBE 0.0 REF. PLANE Q5 Z-"),
    ("PATTERN", &["DEF"], "PATTERN DEF POS1 (X+12 Y+20 Z+0)"),
    ("DECLARE", &["STRING", "CONTOUR"], "DECLARE STRING QS1 = \"TEXT\""),
    ("PLANE", &["RESET", "SPATIAL", "PROJECTED", "EULER", "VECTOR", "POINTS", "RELATIVE", "AXIAL"], "PLANE RESET STAY"),
];

/// Words of other languages and of plain speech, and what Klartext writes for them.
const MEANT: &[(&str, &str)] = &[
    ("LINE", "L X+10 Y-5 F500"),
    ("CIRCLE", "C X+20 Y+10 DR+"),
    ("ARC", "CR X+20 Y+10 R+15 DR-"),
    ("LABEL", "LBL 1"),
    ("IF", "FN 9: IF +Q1 EQU +5 GOTO LBL 1"),
    ("GOTO", "FN 9: IF +0 EQU +0 GOTO LBL 1"),
    ("CHAMFER", "CHF 5"),
    ("ROUND", "RND R5"),
    ("DWELL", "CYCL DEF 9.1 DWELL 1.5"),
];

/// Path functions, the longest first.
const FUNCTIONS: &[&str] = &["CTP", "CT", "CR", "CC", "CP", "LP", "L", "C"];

/// The first word begins no block, or what follows does not belong to it.
fn no_statement(word: &str, span: Span, text: &[u8]) -> Problem {
    let rest = text.get(span.start as usize..).unwrap_or_default();
    let line = readable(rest).into_owned();
    let code = line.split(';').next().unwrap_or_default();
    let mut words = code.split_whitespace();
    let first: String = words.next().unwrap_or(word).chars().take_while(|c| c.is_alphabetic()).collect();
    let upper = first.to_uppercase();
    if let Some((head, seconds, form)) = PAIRS.iter().find(|(head, ..)| *head == upper) {
        return wrong_pair(head, seconds, form, words.next(), rest, span);
    }
    let problem = codes::K1002::begins_no_klartext_block_2(&word).among(span);
    if let Some((_, form)) = MEANT.iter().find(|(meant, _)| *meant == upper) {
        return problem.help(format!("the block looks like `{form}`"));
    }
    if is_axis(&upper) {
        return problem.help(format!("a path function is missing before it, as in `L {word}… R0 F500`"));
    }
    if let Some(function) = glued(&upper) {
        return problem.help(format!("write a blank after the function: `{function} {}…`", &upper[function.len()..]));
    }
    let heads = FORMS.iter().map(|(head, _)| *head).filter(|head| head.len() > 1 && upper.starts_with(&head[..1]));
    match did_you_mean(&upper, heads) {
        Some(like) if upper.len() > 1 => problem.help(format!("did you mean `{like}`?")),
        _ => problem.help("a comment starts with `;`"),
    }
}

/// The letter of an axis, or with I in front.
fn is_axis(word: &str) -> bool {
    matches!(
        word.strip_prefix('I').filter(|rest| !rest.is_empty()).unwrap_or(word),
        "X" | "Y" | "Z" | "A" | "B" | "U" | "V" | "W"
    )
}

/// The function in `LX` or `CRX`.
fn glued(word: &str) -> Option<&'static str> {
    let function = FUNCTIONS.iter().copied().find(|function| word.starts_with(function))?;
    let rest = &word[function.len()..];
    let axis = rest.strip_prefix('I').unwrap_or(rest);
    matches!(axis, "X" | "Y" | "Z" | "U" | "V" | "W" | "A" | "B" | "C" | "PR" | "PA").then_some(function)
}

fn wrong_pair(head: &str, seconds: &[&str], form: &str, second: Option<&str>, rest: &[u8], span: Span) -> Problem {
    let looks = format!("the block looks like `{form}`");
    let Some(second) = second else {
        return codes::K1002::alone_is_no_klartext_block(&head, &form).among(span);
    };
    let both = Span::at(span.start, two_words(rest));
    let upper = second.to_uppercase();
    if seconds.contains(&upper.as_str()) {
        return codes::K1002::is_not_complete(&head, &second, &form).among(both);
    }
    let problem = codes::K1002::begins_no_klartext_block(&head, &second).among(both);
    match did_you_mean(&upper, seconds.iter().copied()) {
        Some(like) => problem.help(format!("did you mean `{head} {like}`?")),
        None => problem.help(looks),
    }
}

/// Bytes of the first two words.
fn two_words(text: &[u8]) -> u32 {
    let blanks = |from: usize| text[from..].iter().take_while(|b| b.is_ascii_whitespace()).count();
    let word = |from: usize| text[from..].iter().take_while(|b| !b.is_ascii_whitespace() && **b != b';').count();
    let first = word(0);
    let second = first + blanks(first);
    (second + word(second)) as u32
}

/// How the definition of this cycle looks.
fn cycle_form(text: &[u8]) -> &'static str {
    let text = readable(text).to_uppercase();
    let mut words = text.split_whitespace();
    if words.nth(1) == Some("CALL") {
        return "CYCL CALL M3";
    }
    let number = words.next().unwrap_or_default().split(['.', ',']).next().unwrap_or_default();
    match number {
        "1" => "CYCL DEF 1.2 DEPTH -15",
        "2" => "CYCL DEF 2.2 DEPTH -15",
        "8" => "CYCL DEF 8.1 X Y",
        "9" => "CYCL DEF 9.1 DWELL 1.5",
        "10" => "CYCL DEF 10.1 ROT+35",
        "11" => "CYCL DEF 11.1 SCL 0.75",
        "12" => "CYCL DEF 12.1 PGM NAME.H",
        "13" => "CYCL DEF 13.1 ANGLE 180",
        "14" => "CYCL DEF 14.1 CONTOUR LABEL 1 /2",
        "17" => "CYCL DEF 17.3 PITCH +1.5",
        "19" => "CYCL DEF 19.1 A+0 B+0 C+0",
        "26" => "CYCL DEF 26.1 X1.4 Y0.6 CCX+15 CCY+20",
        "32" => "CYCL DEF 32.1 T0.05",
        "247" => "CYCL DEF 247 DATUM SETTING Q339=1",
        number if number.len() > 2 => "CYCL DEF 200 DRILLING Q200=+2 Q201=-15",
        _ => "CYCL DEF 7.1 X+60",
    }
}

impl Problem {
    /// Adds how a block with this first word looks.
    fn form(self, text: &[u8], from: u32) -> Problem {
        let rest = text.get(from as usize..).unwrap_or_default();
        let len = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let first = readable(&rest[..len]).to_uppercase();
        let first = if first.starts_with('Q') { "Q" } else { &first };
        if first == "CYCL" || first == "CYCLE" {
            return self.help(format!("the block looks like `{}`", cycle_form(rest)));
        }
        let jump = first == "FN"
            && matches!(rest[len..].trim_ascii_start(), [b'9', b':' | b' ', ..] | [b'1', b'0'..=b'2', ..]);
        let first = if jump { "FN 9" } else { first };
        match FORMS.iter().find(|(head, _)| *head == first) {
            Some((_, form)) => self.help(format!("the block looks like `{form}`")),
            None => self,
        }
    }
}
