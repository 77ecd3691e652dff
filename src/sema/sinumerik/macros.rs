//! Macros: `DEFINE NAME AS words`.
//!
//! Source: S 5.6 (docs/sources.md).

use rustc_hash::FxHashMap;

use crate::diag::{Fault, codes};
use crate::parser::symbols::{Symbol, Symbols};

use super::g_groups::GCodes;
use super::vocabulary::Meaning;

/// Longest text of a macro.
const MOST_MACRO: usize = 256;

/// How the text of a program is read: with its macros.
#[derive(Debug, Default)]
pub(super) struct Sinumerik {
    macros: FxHashMap<Symbol, Box<[u8]>>,
}

/// Name and words of `NAME AS words`.
pub(super) fn name_and_words(rest: &[u8]) -> Result<(&[u8], &[u8]), Fault> {
    let rest = rest.trim_ascii();
    let len = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
    let (name, body) = rest.split_at(len);
    let body = body.trim_ascii_start();
    let keyword = body.get(..2).is_some_and(|word| word.eq_ignore_ascii_case(b"AS"));
    if len == 0 || !keyword {
        return Err(codes::P1001::macro_is_written_define_name_as_words());
    }
    let body = body[2..].trim_ascii();
    if body.len() > MOST_MACRO { Err(codes::S2030::text_of_macro_has_at_most_256()) } else { Ok((name, body)) }
}

/// Would a macro of this name give a word of the language another meaning? `word` is in capitals.
pub(super) fn is_in_use(word: &str, meaning: Meaning, gcodes: &GCodes) -> bool {
    let digits = word.get(1..).filter(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()));
    match (word.as_bytes().first(), digits) {
        (Some(b'G'), Some(digits)) => {
            digits.len() > 3 || digits.parse().ok().is_some_and(|n: f64| gcodes.get(n).is_some())
        }
        (Some(b'M'), Some(digits)) => {
            let number: Option<u32> = digits.parse().ok();
            digits.len() > 2 || number.is_some_and(|n| n <= 9 || n == 17 || n == 19 || n == 30)
        }
        (Some(b'H'), Some(_)) => false,
        (Some(_), Some(_)) => true,
        _ => word.len() == 1 || meaning != Meaning::Unknown || is_keyword(word),
    }
}

/// The alarm of a word that is in use: numbers of G and M that are too long have their own.
pub(super) fn alarm_of_use(word: &str) -> u32 {
    let digits = word.get(1..).unwrap_or_default();
    let most = if word.starts_with('G') { 3 } else { 2 };
    let long = word.starts_with(['G', 'M']) && digits.len() > most;
    if long && digits.bytes().all(|b| b.is_ascii_digit()) { 12530 } else { 12270 }
}

impl Sinumerik {
    /// What the macro stands for.
    pub fn body(&self, name: Symbol) -> Option<&[u8]> {
        self.macros.get(&name).map(|body| &**body)
    }

    pub fn define(&mut self, name: Symbol, body: &[u8]) {
        self.macros.insert(name, body.into());
    }

    pub fn has_macros(&self) -> bool {
        !self.macros.is_empty()
    }

    pub fn is_macro(&self, name: Symbol) -> bool {
        self.macros.contains_key(&name)
    }

    /// The block with its macros replaced; `None` if it has none.
    #[inline]
    pub fn expanded(&self, symbols: &Symbols, text: &[u8]) -> Option<Vec<u8>> {
        if self.macros.is_empty() {
            return None;
        }
        let mut current = self.replaced(symbols, text)?;
        // Macros in macros, with an end to it.
        for _ in 0..8 {
            match self.replaced(symbols, &current) {
                Some(next) => current = next,
                None => break,
            }
        }
        Some(current)
    }

    fn replaced(&self, symbols: &Symbols, text: &[u8]) -> Option<Vec<u8>> {
        let end = crate::lexer::sinumerik::comment_start(text).unwrap_or(text.len());
        if text.get(..end)?.windows(6).any(|w| w.eq_ignore_ascii_case(b"DEFINE")) {
            return None;
        }
        let mut out = Vec::new();
        let mut any = false;
        let mut at = 0;
        while at < end {
            let byte = text[at];
            if byte == b'"' {
                let close = text[at + 1..end].iter().position(|b| *b == b'"').map_or(end, |n| at + n + 2);
                out.extend_from_slice(&text[at..close]);
                at = close;
                continue;
            }
            let len = text[at..end].iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
            if len == 0 {
                out.push(byte);
                at += 1;
                continue;
            }
            let word = &text[at..at + len];
            let upper = word.to_ascii_uppercase();
            let known = std::str::from_utf8(&upper).ok().and_then(|name| symbols.find(name));
            match known.and_then(|symbol| self.macros.get(&symbol)) {
                Some(body) if out.len() + body.len() <= 4 * MOST_MACRO => {
                    out.extend_from_slice(body);
                    any = true;
                }
                _ => out.extend_from_slice(word),
            }
            at += len;
        }
        out.extend_from_slice(&text[end..]);
        any.then_some(out)
    }
}

/// Words of control structures and declarations.
fn is_keyword(word: &str) -> bool {
    const KEYWORDS: &str = "IF ELSE ENDIF WHILE ENDWHILE FOR TO ENDFOR LOOP ENDLOOP REPEAT REPEATB UNTIL GOTO GOTOF GOTOB GOTOC GOTOS \
        CASE OF DEFAULT DEF REDEF PROC EXTERN DEFINE VAR CALL PCALL MCALL EXTCALL ISOCALL BLOCK NOT AND OR XOR B_NOT B_AND B_OR B_XOR \
        DIV MOD TRUE FALSE INT REAL BOOL CHAR STRING AXIS FRAME SAVE";
    KEYWORDS.split_ascii_whitespace().any(|keyword| keyword == word)
}
