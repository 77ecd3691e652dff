//! What the extension of a file says, and what shows a language of ours.

use super::line::{self, Line, Word};

/// What the extension says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Own {
    Klartext,
    Sinumerik,
    /// `.nc`: programs of the turning control, and of many others.
    Nc,
    Turning,
    Mtc200,
    Plain,
    Nothing,
}

impl Own {
    pub fn of(file_name: &str) -> Own {
        let extension = file_name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
        match extension.as_deref() {
            Some("h" | "klartext") => Own::Klartext,
            Some("mpf" | "spf" | "arc") => Own::Sinumerik,
            Some("nc") => Own::Nc,
            Some("ncs") => Own::Turning,
            Some("npg") => Own::Mtc200,
            Some("ngc" | "gcode") => Own::Plain,
            _ => Own::Nothing,
        }
    }

    pub fn turns(self) -> bool {
        matches!(self, Own::Nc | Own::Turning)
    }

    /// Is this line one of the language that the extension says, and of no other?
    pub fn shows(self, line: &Line<'_>) -> bool {
        match self {
            Own::Klartext => is_klartext(line),
            Own::Sinumerik => is_sinumerik(line),
            Own::Nothing => is_sinumerik(line) || is_klartext(line),
            Own::Nc | Own::Turning | Own::Mtc200 | Own::Plain => false,
        }
    }
}

/// Begins with a word of the dialog, behind the number of the block.
pub fn is_klartext(line: &Line<'_>) -> bool {
    const VERBS: [&[u8]; 15] = [
        b"BEGIN",
        b"CYCL",
        b"TOOL",
        b"BLK",
        b"LBL",
        b"FN",
        b"PLANE",
        b"APPR",
        b"DEP",
        b"RND",
        b"CHF",
        b"PATTERN",
        b"FUNCTION",
        b"SEL",
        b"TCH",
    ];
    let code = line.code.trim_ascii_start();
    let code = code[code.iter().take_while(|b| b.is_ascii_digit()).count()..].trim_ascii_start();
    let word = code.split(|b| !b.is_ascii_alphabetic()).next().unwrap_or_default();
    let rest = code[word.len()..].trim_ascii_start();
    let is_call = word == b"CALL" && (rest.starts_with(b"LBL") || rest.starts_with(b"PGM"));
    let path = matches!(word, b"L" | b"LP" | b"C" | b"CC" | b"CP" | b"CR" | b"CT");
    let is_axis = |rest: &[u8]| matches!(rest, [b'X' | b'Y' | b'Z' | b'P' | b'I', ..]);
    let is_parameter = matches!(word, b"Q" | b"QL" | b"QR" | b"QS") && {
        let behind = rest[rest.iter().take_while(|b| b.is_ascii_digit()).count()..].trim_ascii_start();
        rest.first().is_some_and(u8::is_ascii_digit) && behind.starts_with(b"=")
    };
    VERBS.contains(&word) || is_call || is_parameter || path && is_axis(rest)
}

/// A name, an assignment, or G290, which ends a section of the ISO dialect: what no other control writes so.
fn is_sinumerik(line: &Line<'_>) -> bool {
    const NAMES: [&[u8]; 20] = [
        b"CYCLE",
        b"DEF",
        b"PROC",
        b"MSG",
        b"MCALL",
        b"RET",
        b"STOPRE",
        b"DIAMON",
        b"DIAMOF",
        b"TRANS",
        b"ATRANS",
        b"ROT",
        b"AROT",
        b"SUPA",
        b"GOTOF",
        b"GOTOB",
        b"REPEAT",
        b"EXTERN",
        b"WORKPIECE",
        b"ENDIF",
    ];
    let named = line.words.iter().any(|word| word.is("G", "290") || NAMES.contains(&&word.letters[..]));
    let code = line.code.trim_ascii_start();
    let assigned = line.words.iter().any(|word| {
        let behind = line.code.get(word.span.end as usize..).unwrap_or_default().trim_ascii_start();
        word.letters != b"#" && behind.first() == Some(&b'=') && !word.letters.starts_with(b"V")
    });
    named || assigned && !code.starts_with(b"#") || line.text.starts_with(b"%_N_")
}

/// Does something show a program of a HEIDENHAIN turning control: its name line, a comment in square brackets, its end, or a
/// function of its own?
pub fn shows_turning(lines: &[Line<'_>]) -> bool {
    let is_named = lines.first().is_some_and(|line| {
        let name = line.code.trim_ascii();
        name.starts_with(b"%") && (name.ends_with(b".NC") || name.ends_with(b".NCS"))
    });
    is_named || lines.iter().any(is_line_of_turning)
}

fn is_line_of_turning(line: &Line<'_>) -> bool {
    let words = line.behind_number();
    let ends = matches!(words, [word] if word.number.is_empty() && matches!(&word.letters[..], b"END" | b"RETURN"));
    let behind = |word: &Word| line.code.get(word.span.end as usize..).unwrap_or_default().trim_ascii_start();
    // Other controls put a condition in brackets.
    let asks = |word: &Word| matches!(&word.letters[..], b"IF" | b"WHILE") && behind(word).starts_with(b"#");
    let mut codes = words.iter().filter(|word| word.letters == b"G");
    let describes_part = match (codes.next(), codes.next()) {
        (Some(code), None) => {
            (code.is("G", "20") || code.is("G", "21"))
                && words.iter().any(|word| word.letters == b"X" && !word.number.is_empty())
        }
        _ => false,
    };
    ends || has_square_comment(line)
        || words.first().is_some_and(asks)
        || describes_part
        || words.iter().any(is_function_of_turning)
}

/// `[rough the face]`: text in square brackets, at the beginning of a block or behind a blank, not a formula.
fn has_square_comment(line: &Line<'_>) -> bool {
    let text = line.text.trim_ascii();
    let Some(open) = text.iter().position(|b| *b == b'[') else { return false };
    let inside = text[open + 1..].split(|b| *b == b']').next().unwrap_or_default();
    let is_apart = open == 0 || text[open - 1].is_ascii_whitespace();
    let is_text = inside.windows(2).any(|two| two.iter().all(u8::is_ascii_alphabetic));
    let is_formula = inside.iter().any(|b| b"#=[".contains(b)) || matches!(text.first(), Some(b'#'));
    let asks = line.words.iter().any(|word| matches!(&word.letters[..], b"IF" | b"WHILE" | b"VC" | b"O"));
    is_apart && is_text && !is_formula && !asks
}

/// G functions that other controls do not have, or not under this number.
fn is_function_of_turning(word: &Word) -> bool {
    let number = std::str::from_utf8(word.value()).ok().and_then(|number| number.parse::<u16>().ok());
    word.letters == b"G"
        && number.is_some_and(|number| {
            matches!(number, 14 | 26 | 47 | 147 | 148 | 152 | 192..=197 | 350..=353 | 701 | 702 | 799..=899 | 901..=903 | 909 | 920 | 921)
        })
}

/// Has each block a number, one more than the block before it, as that control gives them, and are feeds those of a lathe, a turn?
pub fn is_numbered_as_turning(head: &[u8]) -> bool {
    let mut last: Option<u32> = None;
    let (mut count, mut is_large) = (0_u32, false);
    for line in line::lines(head) {
        let Some(first) = line.words.first().filter(|_| !line.code.trim_ascii_start().starts_with(b"%")) else {
            continue;
        };
        let number = std::str::from_utf8(&first.number).ok().and_then(|number| number.parse::<u32>().ok());
        match (number, last) {
            (Some(number), _) if first.letters != b"N" || last.is_some_and(|last| number != last + 1) => return false,
            (Some(number), _) => last = Some(number),
            (None, _) => return false,
        }
        count += 1;
        is_large |=
            line.words.iter().any(|word| word.letters == b"F" && feed(word).is_some_and(|feed| feed > MOST_A_TURN));
    }
    let begins = count == 1 && last == Some(1) || count > 1;
    begins && !is_large
}

/// Millimetres: nobody turns with more.
const MOST_A_TURN: f64 = 10.0;

fn feed(word: &Word) -> Option<f64> {
    std::str::from_utf8(&word.number).ok()?.parse().ok()
}
