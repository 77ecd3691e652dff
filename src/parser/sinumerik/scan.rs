//! A quick look at a block for jumps: its number, its label, and whether it opens or closes a structure.

use crate::lexer::sinumerik::{Tok, Tokens, comment_start};
use crate::parser::problem::Problem;
use crate::parser::symbols::{Symbol, Symbols};

use super::ast::Block;

/// What a jump needs to know of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Mark {
    pub number: Option<u32>,
    pub label: Option<Symbol>,
    pub structure: Option<Word>,
}

/// Words of control structures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Word {
    If,
    Else,
    EndIf,
    While,
    EndWhile,
    For,
    EndFor,
    Loop,
    EndLoop,
    Repeat,
    Until,
}

/// What is wrong with a line of a control structure that nobody executes when it is jumped over: ELSE and the ends.
pub fn skipped_line(text: &[u8], word: Word, symbols: &mut Symbols) -> Option<Problem> {
    if !matches!(word, Word::Else | Word::EndIf | Word::EndWhile | Word::EndFor | Word::EndLoop) {
        return None;
    }
    let mut problems = Vec::new();
    super::parse_block(text, &mut Block::default(), symbols, &mut problems);
    problems.into_iter().find(|problem| problem.code.severity == crate::diag::Severity::Error)
}

/// Looks at one block.
pub fn scan(text: &[u8], symbols: &mut Symbols) -> Mark {
    if matches!(text.first(), Some(b'%')) {
        return Mark::default();
    }
    let mut block = Block::default();
    let from = super::head(text, &mut block, symbols, &mut Vec::new());
    let structure = text.get(from..).and_then(structure_word);
    Mark { number: block.number, label: block.label, structure }
}

fn structure_word(text: &[u8]) -> Option<Word> {
    let len = text.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
    if !(2..=8).contains(&len) {
        return None;
    }
    let (word, rest) = text.split_at(len);
    let mut upper = [0; 8];
    upper[..len].copy_from_slice(word);
    upper.make_ascii_uppercase();
    Some(match &upper[..len] {
        b"IF" if !jumps(rest) => Word::If,
        b"ELSE" => Word::Else,
        b"ENDIF" => Word::EndIf,
        b"WHILE" => Word::While,
        b"ENDWHILE" => Word::EndWhile,
        b"FOR" => Word::For,
        b"ENDFOR" => Word::EndFor,
        b"LOOP" => Word::Loop,
        b"ENDLOOP" => Word::EndLoop,
        b"REPEAT" if code(rest).trim_ascii().is_empty() => Word::Repeat,
        b"UNTIL" => Word::Until,
        _ => return None,
    })
}

/// The part in front of the comment.
fn code(text: &[u8]) -> &[u8] {
    let end = comment_start(text).unwrap_or(text.len());
    &text[..end]
}

/// `IF c GOTOF L` is a jump, not a structure, also where the number in front is glued to it: `IF R1==0GOTOF L`.
fn jumps(rest: &[u8]) -> bool {
    Tokens::new(rest, 0).any(|(_, tok, _)| matches!(tok, Tok::Goto | Tok::GotoF | Tok::GotoB | Tok::GotoC))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks() {
        let mut symbols = Symbols::default();
        let word = |text: &str, symbols: &mut Symbols| scan(text.as_bytes(), symbols).structure;
        assert_eq!(word("N10 IF R1>0", &mut symbols), Some(Word::If));
        assert_eq!(word("IF R1>0 GOTOF END1", &mut symbols), None);
        assert_eq!(word("IF R1>0GOTOF END1", &mut symbols), None);
        assert_eq!(word("if R1>R5gotob END1", &mut symbols), None);
        assert_eq!(word("IF(R1>0)GOTO\"END1\"", &mut symbols), None);
        assert_eq!(word("IF XGOTOF>0", &mut symbols), Some(Word::If));
        assert_eq!(word("IF R1>0 ; GOTOF", &mut symbols), Some(Word::If));
        assert_eq!(word("if NAME==\"GOTOF\"", &mut symbols), Some(Word::If));
        assert_eq!(word("REPEAT", &mut symbols), Some(Word::Repeat));
        assert_eq!(word("REPEAT L1 P=2", &mut symbols), None);
        assert_eq!(word("ENDLOOP", &mut symbols), Some(Word::EndLoop));
        let mark = scan(b"N20 HERE: G1 X5", &mut symbols);
        assert_eq!((mark.number, mark.label.map(|l| symbols.name(l))), (Some(20), Some("HERE")));
    }
}
