//! What a program says of its tools in names and comments: beside the values that are asked for, as a hint, never as a value.
//!
//! In: where a tool is called first. Out: the comment that tells most of it, with the numbers in it that look like its measures.
//! Looked at are the name of the tool, the comment of the call, the comment lines before it, and the list of tools at the head
//! of the file.

use crate::driver::Session;
use crate::text::{Loc, Span};

use super::need::{Place, cut};

/// Bytes in front of a call in which its comment stands.
const BEFORE: u32 = 600;
/// Blocks between a call and its comment.
const MOST_BLOCKS: usize = 2;
/// Highest number of a tool that a comment means by `T5`.
const MOST_NUMBER: u32 = 9999;
/// Bytes of a file in which a list of its tools stands.
const HEAD: u32 = 8 * 1024;

/// Measures that a text seems to carry, in mm and degrees.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Measures {
    pub radius: Option<f64>,
    pub corner_radius: Option<f64>,
    pub length: Option<f64>,
    pub angles: Vec<f64>,
}

impl Measures {
    fn is_empty(&self) -> bool {
        *self == Measures::default()
    }

    /// `radius 5, length 120`
    fn words(&self) -> String {
        let one = |what: &str, value: Option<f64>| value.map(|value| format!("{what} {value}"));
        let mut words: Vec<String> =
            [one("radius", self.radius), one("corner radius", self.corner_radius), one("length", self.length)]
                .into_iter()
                .flatten()
                .collect();
        let angles: Vec<String> = self.angles.iter().map(ToString::to_string).collect();
        match angles.len() {
            0 => {}
            1 => words.push(format!("angle {}", angles[0])),
            _ => words.push(format!("angles {}", angles.join(" and "))),
        }
        words.join(", ")
    }
}

/// What a program says of a tool.
#[derive(Debug, Clone)]
pub(super) struct Hint {
    /// Where it is called first.
    pub call: Place,
    /// Texts with measures, the nearest to the call first.
    said: Vec<(String, Measures)>,
}

impl Hint {
    /// Of the tool `number`, or of the one that is called by `name`, as TOML writes it.
    pub fn new(number: u32, name: Option<&str>, call: Loc, session: &Session) -> Hint {
        let mut texts: Vec<String> = name.map(|name| name.trim_matches('"').to_owned()).into_iter().collect();
        let is_meant = |text: &String| name.is_some() || !names_another(text, number);
        texts.extend(around(call, session).into_iter().filter(is_meant));
        texts.extend(of_list(number, name, call, session));
        let mut said: Vec<(String, Measures)> = Vec::new();
        texts.retain(|text| !is_in_inches(text));
        if is_inch_program(call, session) {
            texts.clear();
        }
        for text in texts {
            let measures = measures_in(&text);
            let tells_more = said.iter().all(|(_, known)| known.radius != measures.radius);
            if !measures.is_empty() && (said.is_empty() || measures.radius.is_some() && tells_more) {
                said.push((cut(text.trim()), measures));
            }
        }
        Hint { call: Place::new(call, session), said }
    }

    /// `radius 5 by "MILL_D10"?`; two texts that differ are both named.
    pub fn words(&self) -> String {
        let said = self.said.iter().take(2).map(|(text, measures)| format!("{} by \"{text}\"?", measures.words()));
        said.collect::<Vec<_>>().join(" or ")
    }
}

/// Measures in inches, or fractions of them.
fn is_in_inches(text: &str) -> bool {
    let upper = text.to_uppercase();
    let word = |word: &str| matches!(word, "INCH" | "INCHES" | "IN" | "ZOLL");
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let between =
        |(at, _): (usize, char)| digit(upper[..at].chars().next_back()) && digit(upper[at + 1..].chars().next());
    upper.split(|c: char| !c.is_alphabetic()).any(word)
        || upper.char_indices().filter(|(_, c)| *c == '"').any(|(at, _)| digit(upper[..at].chars().next_back()))
        || upper.char_indices().filter(|(_, c)| *c == '/').any(between)
}

/// Does the head of the program say inches? The keys are in mm.
fn is_inch_program(call: Loc, session: &Session) -> bool {
    let bytes = session.sources.bytes(call.file, Span { start: 0, end: HEAD.min(call.span.start) });
    let text = String::from_utf8_lossy(&bytes).to_uppercase();
    let is_word = |word: &str| matches!(word, "INCH" | "G70" | "G700" | "G20");
    text.lines().any(|line| {
        let code = line.split([';', '(']).next().unwrap_or_default();
        code.split(|c: char| !c.is_ascii_alphanumeric()).any(is_word)
    })
}

/// The comment of a block, or of a line that is nothing but one.
fn comment_of(line: &str) -> Option<&str> {
    let line = line.trim();
    let text = line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    if let Some(heading) = text.strip_prefix("* -").or_else(|| text.strip_prefix('*')) {
        return Some(heading.trim());
    }
    let at = line.find(';').or_else(|| line.find('('))?;
    // Brackets of an argument list are no comment.
    let is_call = line[at..].starts_with('(') && line[..at].ends_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
    (!is_call).then(|| line[at + 1..].trim_matches([')', ' ', ';', '(']))
}

/// Is the line nothing but a comment, or empty?
fn is_remark(line: &str) -> bool {
    let text = line.trim().trim_start_matches('N').trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    text.is_empty() || text.starts_with([';', '(', '*'])
}

/// The comment of the call, and those before it.
fn around(call: Loc, session: &Session) -> Vec<String> {
    let own = session.sources.line(call).text;
    let mut texts: Vec<String> = comment_of(&own).map(str::to_owned).into_iter().collect();
    let own_texts = texts.len();
    let start = call.span.start.saturating_sub(BEFORE);
    let bytes = session.sources.bytes(call.file, Span { start, end: call.span.start });
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let mut blocks = 0;
    // The last piece is the head of the call's own line.
    for line in text.lines().rev().skip(usize::from(!text.ends_with(['\n', '\r']))) {
        // Behind a comment that was found the next block ends what belongs to the call.
        if !is_remark(line) {
            blocks += if texts.len() > own_texts { MOST_BLOCKS + 1 } else { 1 };
        }
        if blocks > MOST_BLOCKS || line.to_uppercase().contains("TOOL CALL") {
            break;
        }
        texts.extend(comment_of(line).map(str::to_owned));
    }
    texts
}

/// The comments at the head of the file that name the tool.
fn of_list(number: u32, name: Option<&str>, call: Loc, session: &Session) -> Vec<String> {
    let bytes = session.sources.bytes(call.file, Span { start: 0, end: HEAD.min(call.span.start) });
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let names_it = |line: &str| match name {
        Some(name) => line.contains(name.trim_matches('"')),
        None => names_tool(line, number),
    };
    text.lines()
        .filter(|line| is_remark(line))
        .filter_map(comment_of)
        .filter(|line| names_it(line))
        .map(str::to_owned)
        .collect()
}

/// Does it name this tool: `T5`, `T05` or `TOOL 5` as a word of its own?
fn names_tool(line: &str, number: u32) -> bool {
    numbers_in(line).contains(&number)
}

/// Does it name another tool, and not this one? Longer numbers are those of a tool management.
fn names_another(line: &str, number: u32) -> bool {
    let numbers = numbers_in(line);
    !numbers.contains(&number) && numbers.iter().any(|other| *other <= MOST_NUMBER)
}

/// The numbers of tools in a text.
fn numbers_in(line: &str) -> Vec<u32> {
    let line = line.to_uppercase();
    let number = |(at, _): (usize, &str)| {
        let rest = line[at + 1..].strip_prefix("OOL ").unwrap_or(&line[at + 1..]);
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let is_word = !line[..at].ends_with(|c: char| c.is_alphanumeric());
        rest[..digits].parse::<u32>().ok().filter(|_| is_word)
    };
    line.match_indices('T').filter_map(number).collect()
}

/// A word with the number behind it.
struct Pair {
    word: String,
    value: f64,
    /// It begins a word: `L120`, not the one of `W6L65`.
    is_apart: bool,
    /// It counts: `4 FLUTE`, `4-SCHNEIDER`.
    counts: bool,
}

/// Words with numbers: `D=6.00`, `TL 145`, `R0.8K95`.
fn pairs(text: &str) -> Vec<Pair> {
    let chars: Vec<char> = text.chars().collect();
    let (mut found, mut at) = (Vec::new(), 0);
    while at < chars.len() {
        let begins = chars[at].is_alphabetic() || matches!(chars[at], 'Ø' | '#');
        if !begins {
            at += 1;
            continue;
        }
        let start = at;
        while at < chars.len() && (chars[at].is_alphabetic() || chars[at] == 'Ø') {
            at += 1;
        }
        at = at.max(start + 1);
        let word: String = chars[start..at].iter().collect();
        let mut digits = at;
        while digits < chars.len() && matches!(chars[digits], ' ' | '=' | ':' | '_') {
            digits += 1;
        }
        if let Some((value, end)) = number_at(&chars, digits) {
            let is_apart = start == 0 || matches!(chars[start - 1], ' ' | ',' | ';' | '(' | '/' | '=' | '\t');
            let behind: String = chars[end..].iter().skip_while(|c| matches!(c, ' ' | '-')).take(7).collect();
            let counts =
                ["FL", "SCHNEID", "ZAEHN", "ZÄHN", "TEETH", "TOOTH"].iter().any(|word| behind.starts_with(word));
            found.push(Pair { word, value, is_apart, counts });
            at = end;
        }
    }
    found
}

/// The number that begins here, and where it ends. A comma counts where a digit follows.
fn number_at(chars: &[char], start: usize) -> Option<(f64, usize)> {
    let mut end = start;
    let digit = |at: usize| chars.get(at).is_some_and(char::is_ascii_digit);
    while digit(end) || chars.get(end).is_some_and(|c| matches!(c, '.' | ',')) && digit(end + 1) && end > start {
        end += 1;
    }
    let text: String = chars[start.min(chars.len())..end].iter().collect();
    Some((text.replace(',', ".").parse().ok()?, end))
}

/// A word for a tool that cuts, behind which its diameter stands.
fn is_cutter(word: &str) -> bool {
    ["MILL", "DRILL", "CUTTER", "FRAESER", "FRÄSER", "BOHRER", "REAMER", "REIBAHLE"]
        .iter()
        .any(|end| word.ends_with(end))
}

/// The measures that the name of a tool, or a comment, seems to carry.
pub(super) fn measures_in(text: &str) -> Measures {
    let text = text.to_uppercase();
    let pairs = pairs(&text);
    let of = |words: &[&str]| pairs.iter().find(|pair| words.contains(&pair.word.as_str())).map(|pair| pair.value);
    let apart = |word: &str| pairs.iter().find(|pair| pair.is_apart && pair.word == word).map(|pair| pair.value);
    let small = |value: &f64| *value > 0.0 && *value < 500.0;
    let by_unit = || {
        let cutter =
            text.split(|c: char| !c.is_alphabetic()).any(|word| is_cutter(word) || word == "FR" || word == "BOHR");
        let chars: Vec<char> = text.chars().collect();
        let number = |at: usize| {
            number_at(&chars, at)
                .filter(|(_, end)| chars[*end..].iter().collect::<String>().trim_start().starts_with("MM"))
        };
        let begins = |at: &usize| *at == 0 || !chars[at - 1].is_ascii_digit() && !matches!(chars[at - 1], '.' | ',');
        (0..chars.len()).filter(begins).find_map(number).map(|(value, _)| value).filter(|_| cutter)
    };
    let named = || of(&["DM", "D", "DIA", "DIAM", "Ø", "DURCHMESSER", "DIAMETER"]);
    let by_word = || pairs.iter().find(|pair| is_cutter(&pair.word) && !pair.counts).map(|pair| pair.value);
    // Behind `Anbohrer 90°` stands no diameter.
    let is_length = |value: &f64| degrees(&text) != Some(*value);
    let diameter = named().or_else(by_word).or_else(by_unit).filter(small).filter(is_length);
    let round = of(&["R", "RAD", "RADIUS"]).filter(small);
    let mut angles: Vec<f64> = Vec::new();
    if round.is_some() {
        // Inserts of lathe tools: R0.8K95E80.
        angles.extend(
            pairs.iter().filter(|pair| !pair.is_apart && ["K", "E"].contains(&pair.word.as_str())).map(|p| p.value),
        );
    }
    angles.extend(of(&["ANGLE", "WINKEL", "SPITZENWINKEL"]));
    angles.extend(degrees(&text).filter(|angle| !angles.contains(angle)));
    angles.retain(|angle| *angle > 0.0 && *angle <= 180.0);
    Measures {
        radius: diameter.map(|diameter| diameter / 2.0).or(round),
        corner_radius: of(&["CR"]).or(round.filter(|_| diameter.is_some())).filter(small),
        length: of(&["TL", "LENGTH", "LAENGE", "LÄNGE"]).or_else(|| apart("L")).filter(|value| *value > 0.0),
        angles,
    }
}

/// `118°`, `90 DEG`
fn degrees(text: &str) -> Option<f64> {
    let at = ["°", "DEG", "GRAD"].iter().find_map(|sign| text.find(sign))?;
    let before = text[..at].trim_end();
    let from = before.rfind(|c: char| !c.is_ascii_digit() && c != '.').map_or(0, |at| at + 1);
    before.get(from..)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn radius(text: &str) -> Option<f64> {
        measures_in(text).radius
    }

    #[test]
    fn names_and_comments_carry_radii() {
        for (text, expected) in [
            ("FS_D10", Some(5.0)),
            ("DR_R0.8K95E80", Some(0.8)),
            ("end mill 10 mm", Some(5.0)),
            ("Schaftfraeser D12", Some(6.0)),
            ("CUTTER 16", Some(8.0)),
            ("MILL_8", Some(4.0)),
            ("FACEMILL 63", Some(31.5)),
            ("DRILL 8.5", Some(4.25)),
            ("DRILL", None),
            ("END MILL 4 FLUTE 12 MM", Some(6.0)),
            ("END MILL 6 FLUTE", None),
            ("FRAESER 4-SCHNEIDER", None),
            ("Ø8.5 BOHRER", Some(4.25)),
            ("POCKETING , TOOL : FR-D10AL", Some(5.0)),
            ("DRILLING , TOOL : SV-D4,2", Some(2.1)),
            ("TOOL: T188451270 | GUH-5510-BHF12_H63Z12L90 / DM=12 CR=0 TL=148", Some(6.0)),
            ("BH12000000580158", None),
            ("DR+0.2", None),
            ("T1 - L0 R5 - Schaftfr", Some(5.0)),
        ] {
            assert_eq!(radius(text), expected, "{text}");
        }
    }

    #[test]
    fn inches_are_no_hint() {
        for text in
            ["END MILL 0.5 IN", "END MILL D0.5\"", "R 5 INCH", "END MILL 1/2\"", "3/8 END MILL", "BOHRER 1 Zoll"]
        {
            assert!(is_in_inches(text), "{text}");
        }
        for text in
            ["FRAESER D12", "T1 - L0 R5", "D=6.00 / CR=0", "end mill in holder".replace(" in ", " with ").as_str()]
        {
            assert!(!is_in_inches(text), "{text}");
        }
    }

    #[test]
    fn other_measures_are_told_apart() {
        let all = measures_in("TOOL: T625 | GUH-6761-S5R0_H63ZM6L160 / DM=5 CR=0.5 TL=189.8");
        assert_eq!(all.words(), "radius 2.5, corner radius 0.5, length 189.8");
        assert_eq!(measures_in("(D=6.00 R=1.00 F=15.00 L=35.00)").words(), "radius 3, corner radius 1, length 35");
        assert_eq!(measures_in("DR_R0.8K95E80").words(), "radius 0.8, angles 95 and 80");
        assert_eq!(measures_in("SPIRALBOHRER D8.5 118°").words(), "radius 4.25, angle 118");
        assert_eq!(measures_in("NC-Anbohrer 90 Grad").words(), "angle 90");
        assert!(measures_in("26.05.2015 09:27").is_empty());
    }

    #[test]
    fn tools_are_found_in_lists() {
        assert!(names_tool("T1 - L0 R5", 1) && names_tool("T01: SK40", 1) && names_tool("use tool 12 here", 12));
        assert!(
            names_another("T2 - L0 R3", 1) && !names_another("T2 and T1", 1) && !names_another("T188451270 | D12", 1)
        );
        assert!(!names_tool("T12 D10", 1) && !names_tool("START1", 1) && !names_tool("T", 1));
    }

    #[test]
    fn comments_are_cut_out_of_blocks() {
        for (line, comment) in [
            ("5 TOOL CALL 5 Z S2000 ; end mill 10 mm", Some("end mill 10 mm")),
            ("36 * - TOOL: T1 / DM=12", Some("TOOL: T1 / DM=12")),
            ("N10 T1 M6 (MILL 6)", Some("MILL 6")),
            ("N10 TC(\"ROUGH\",1)", None),
            ("N10 TC(1,0) ; D12", Some("D12")),
            ("5 TOOL CALL 5 Z S2000", None),
        ] {
            assert_eq!(comment_of(line), comment, "{line}");
        }
    }
}
