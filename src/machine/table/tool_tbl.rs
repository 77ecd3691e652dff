//! `tool.tbl` of LinuxCNC: `T1 P1 D6.0 Z50.0 ;remark`; D is a diameter, and the unit is that of the machine.

use crate::machine::{Tool, ToolKey};

use super::columns::signed;
use super::{Contents, TableError};

/// # Errors
/// A word that no tool table has.
pub(super) fn read(text: &str) -> Result<Contents, TableError> {
    let mut contents = Contents::default();
    for (line, text) in (1..).zip(text.lines()) {
        let (words, remark) = text.split_once(';').unwrap_or((text, ""));
        let mut number = None;
        let mut tool = Tool::default();
        let mut seen = Vec::new();
        for word in words.split_whitespace() {
            let fail = || TableError { line, message: format!("{word:?} is no word of a tool table") };
            let letter = word.chars().next().filter(char::is_ascii_alphabetic).ok_or_else(fail)?;
            let value = signed(&word[1..]).ok_or_else(fail)?;
            let letter = letter.to_ascii_uppercase();
            if seen.contains(&letter) {
                return Err(TableError { line, message: format!("{letter} stands twice") });
            }
            seen.push(letter);
            match letter {
                'T' if value.fract() == 0.0 && (0.0..=1e9).contains(&value) => number = Some(value as u32),
                'T' => return Err(fail()),
                'D' => tool.radius = Some(value / 2.0),
                'Z' => tool.length = Some(value),
                'P' => {}
                // Cutting-edge positions are numbered otherwise there; `[tools]` gives them.
                'Q' | 'X' | 'Y' | 'A' | 'B' | 'C' | 'U' | 'V' | 'W' | 'I' | 'J' => {
                    if value != 0.0 {
                        contents.left_out.push((line, word.to_owned()));
                    }
                }
                _ => return Err(fail()),
            }
        }
        if let Some(number) = number {
            tool.name = Some(remark.trim().to_owned()).filter(|name| !name.is_empty());
            if contents.tools.insert(ToolKey::Number(number, 0), tool).is_some() {
                return Err(TableError { line, message: format!("tool {number} stands twice in the table") });
            }
        } else if !words.trim().is_empty() {
            return Err(TableError { line, message: "a tool line starts with its T word".to_owned() });
        }
    }
    Ok(contents)
}
