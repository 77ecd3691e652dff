//! What shows a language that is none of ours.

use crate::text::Span;

use super::line::{Line, Word};

/// Weight of marks that together decide.
pub const DECIDES: u8 = 2;

/// Something that shows a language.
pub struct Mark {
    /// [`DECIDES`] where it does so alone.
    pub weight: u8,
    /// Where it stands in a line, which is the so many-th that is not blank, counted from 0.
    pub shows: fn(&Line<'_>, usize) -> Option<Span>,
}

/// A mark that is enough.
pub const fn alone(shows: fn(&Line<'_>, usize) -> Option<Span>) -> Mark {
    Mark { weight: DECIDES, shows }
}

/// One of two that are needed.
pub const fn half(shows: fn(&Line<'_>, usize) -> Option<Span>) -> Mark {
    Mark { weight: 1, shows }
}

/// One that is named beside those that decide.
pub const fn beside(shows: fn(&Line<'_>, usize) -> Option<Span>) -> Mark {
    Mark { weight: 0, shows }
}

fn starts(line: &Line<'_>, with: &str) -> bool {
    line.text.trim_ascii_start().get(..with.len()).is_some_and(|text| text.eq_ignore_ascii_case(with.as_bytes()))
}

/// The whole line, where it begins so.
pub fn begins(line: &Line<'_>, with: &[&str]) -> Option<Span> {
    with.iter().any(|with| starts(line, with)).then(|| line.span())
}

/// From the first of two words to the second, where both stand in the line.
fn both(line: &Line<'_>, first: impl Fn(&Word) -> bool, second: impl Fn(&Word) -> bool) -> Option<Span> {
    let first = line.words.iter().find(|word| first(word))?;
    let second = line.words.iter().find(|word| second(word))?;
    Some(first.span.to(second.span))
}

fn numbered(letters: &'static str) -> impl Fn(&Word) -> bool {
    move |word| word.letters == letters.as_bytes() && !word.number.is_empty()
}

fn is(letters: &'static str, numbers: &'static [&'static str]) -> impl Fn(&Word) -> bool {
    move |word| numbers.iter().any(|number| word.is(letters, number))
}

/// `O1000` or `:1000` as the first words of the file, `%` in front of them or not.
pub fn program_number(line: &Line<'_>, at: usize) -> Option<Span> {
    let code = line.code.trim_ascii();
    let digits = code.get(1..)?.iter().take_while(|b| b.is_ascii_digit()).count();
    let is_number = at < 3 && matches!(code.first(), Some(b'O' | b':')) && digits > 0;
    (is_number && code[1 + digits..].trim_ascii().is_empty()).then(|| Span::at(line.span().start, 1 + digits as u32))
}

/// `%` alone in the first line.
pub fn tape_start(line: &Line<'_>, at: usize) -> Option<Span> {
    (at == 0 && line.text.trim_ascii() == b"%").then(|| line.span())
}

/// `G43 H1`: the length of a tool.
pub fn tool_length(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["43"]), numbered("H"))
}

/// `T1 M6`: a tool change in a block of a language of lathes, which have a turret.
pub fn tool_change(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, numbered("T"), is("M", &["6"]))
}

/// `G28 U0 W0`, `G91 G28 Z0`: to the reference point.
pub fn reference_point(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["28", "30"]), |word| matches!(word.letters[..], [b'U' | b'W' | b'X' | b'Y' | b'Z']))
}

/// `G81 G98 … R2.`: a drilling cycle with the plane that it starts from.
pub fn drilling(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["73", "76", "81", "82", "83", "84", "85", "86", "89"]), is("G", &["98", "99"]))
}

/// `#100=1`
pub fn variable(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| word.letters == b"#" && word.number.len() >= 3)?;
    Some(word.span)
}

/// `G65 P9000`, `M98 P1000`
pub fn macro_call(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["65", "66"]), numbered("P")).or_else(|| both(line, is("M", &["98"]), numbered("P")))
}

/// `IF [#1 EQ 2] GOTO 10`, `WHILE [#1 LT 5] DO1`
pub fn condition(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| word.letters == b"IF" || word.letters == b"WHILE")?;
    let behind = line.code.get(word.span.end as usize..)?.trim_ascii_start();
    behind.starts_with(b"[").then_some(word.span)
}

/// Two words with which programs for mills begin, and which mean something else on a lathe of HEIDENHAIN.
pub fn safety_block(line: &Line<'_>, _: usize) -> Option<Span> {
    let safe = is("G", &["17", "20", "21", "40", "49", "54", "80", "90", "94", "64"]);
    // Comments of that control stand in square brackets.
    if line.text.contains(&b'[') {
        return None;
    }
    let mut found = line.words.iter().filter(|word| safe(word));
    let (first, mut last) = (found.next()?, found.next()?);
    found.for_each(|word| last = word);
    Some(first.span.to(last.span))
}

/// `CYCLE81(`: a cycle of the SINUMERIK.
pub fn cycle_call(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| word.letters == b"CYCLE" && word.number.len() >= 2)?;
    // Brackets are blanked out in `code`.
    let behind = line.text.get(word.span.end as usize..)?.trim_ascii_start();
    behind.starts_with(b"(").then_some(word.span)
}

/// `DEF REAL A`
pub fn declaration(line: &Line<'_>, _: usize) -> Option<Span> {
    let of = |letters: &'static [u8]| move |word: &Word| word.letters == letters;
    [&b"REAL"[..], b"INT", b"BOOL", b"STRING", b"AXIS"].iter().find_map(|kind| both(line, of(b"DEF"), of(kind)))
}

/// `CR=20`
pub fn radius_by_name(line: &Line<'_>, _: usize) -> Option<Span> {
    assigned(line, b"CR")
}

/// `GOTOF END1`
pub fn jump_by_direction(line: &Line<'_>, _: usize) -> Option<Span> {
    named(line, &[b"GOTOF", b"GOTOB"])
}

/// `T="MILL10"`
pub fn tool_by_name(line: &Line<'_>, _: usize) -> Option<Span> {
    assigned(line, b"T").filter(|span| line.text.get(span.end as usize + 1) == Some(&b'"'))
}

/// `STOPRE`, `MCALL`
pub fn stop_of_reading(line: &Line<'_>, _: usize) -> Option<Span> {
    named(line, &[b"STOPRE", b"MCALL"])
}

fn named(line: &Line<'_>, names: &[&[u8]]) -> Option<Span> {
    line.words.iter().find(|word| names.contains(&&word.letters[..])).map(|word| word.span)
}

fn assigned(line: &Line<'_>, letters: &[u8]) -> Option<Span> {
    let word = line.words.iter().find(|word| word.letters == letters && word.number.is_empty())?;
    (line.code.get(word.span.end as usize) == Some(&b'=')).then_some(word.span)
}

/// `G20`, `G21`: inches or millimetres.
pub fn unit(line: &Line<'_>, _: usize) -> Option<Span> {
    line.words.iter().find(|word| is("G", &["20", "21"])(word)).map(|word| word.span)
}

/// A comment in round brackets is the whole line.
pub fn round_comment(line: &Line<'_>, _: usize) -> Option<Span> {
    let text = line.text.trim_ascii();
    (text.starts_with(b"(") && text.ends_with(b")")).then(|| line.span())
}

/// `G291`: from the language of the SINUMERIK to its ISO dialect.
pub fn iso_switch(line: &Line<'_>, _: usize) -> Option<Span> {
    line.words.iter().find(|word| word.is("G", "291")).map(|word| word.span)
}

/// What a program in the ISO dialect has beside the switch to it.
pub fn iso_word(line: &Line<'_>, at: usize) -> Option<Span> {
    [program_number, tool_length, reference_point, drilling, macro_call].iter().find_map(|shows| shows(line, at))
}

/// `M104 S200`, `M140 S60`: a nozzle or a bed is heated.
pub fn heater(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("M", &["104", "109", "140", "190"]), numbered("S"))
}

/// `G1 X1 Y2 E0.5`, `G92 E0`: filament.
pub fn filament(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["1", "92"]), numbered("E"))
}

/// `G29` alone: the bed is probed.
pub fn bed_probing(line: &Line<'_>, _: usize) -> Option<Span> {
    matches!(line.behind_number(), [word] if word.is("G", "29")).then(|| line.span())
}

/// Comments of the programs that make paths for printers.
pub fn slicer(line: &Line<'_>, _: usize) -> Option<Span> {
    begins(
        line,
        &[";FLAVOR:", ";LAYER_COUNT", "; generated by PrusaSlicer", "; generated by Slic3r", ";Generated with Cura"],
    )
}

/// `$NAME.MIN%`
pub fn okuma_name(line: &Line<'_>, at: usize) -> Option<Span> {
    let text = line.text.trim_ascii();
    (at < 2 && text.starts_with(b"$") && text.ends_with(b"%") && text.contains(&b'.')).then(|| line.span())
}

/// `NAT01`, `VZOFZ=`, `CALL OBORE`, `G15 H1`
pub fn okuma_word(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| {
        word.letters == b"NAT" && !word.number.is_empty()
            || [&b"VZOFZ"[..], b"VZOFX", b"VSIOZ", b"OSTRT", b"NOEX"].contains(&&word.letters[..])
    });
    word.map(|word| word.span)
}

/// `CALL OBORE`
pub fn okuma_call(line: &Line<'_>, _: usize) -> Option<Span> {
    let code = line.code.trim_ascii_start();
    (code.starts_with(b"CALL O") && code.len() > 6).then(|| line.span())
}

/// `G15 H1`: a work offset.
pub fn okuma_offset(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["15", "16"]), numbered("H"))
}

/// `%NAME G71 *`: a HEIDENHAIN program of G-code.
pub fn din_iso_head(line: &Line<'_>, at: usize) -> Option<Span> {
    let text = line.text.trim_ascii();
    let words: Vec<&[u8]> = text.split(|b| b.is_ascii_whitespace() || *b == b'*').filter(|w| !w.is_empty()).collect();
    let unit = words.iter().any(|word| matches!(*word, b"G70" | b"G71"));
    (at == 0 && text.starts_with(b"%") && text.ends_with(b"*") && unit).then(|| line.span())
}

/// `%MPF 90`: an older SINUMERIK.
pub fn old_head(line: &Line<'_>, at: usize) -> Option<Span> {
    let rest = line.code.trim_ascii().strip_prefix(b"%").map(<[u8]>::trim_ascii_start)?;
    let number = rest.strip_prefix(b"MPF").or_else(|| rest.strip_prefix(b"SPF"))?.trim_ascii();
    (at < 2 && !number.is_empty() && number.iter().all(u8::is_ascii_digit)).then(|| line.span())
}

/// `@371 R52 K2`
pub fn old_command(line: &Line<'_>, _: usize) -> Option<Span> {
    let at = line.code.iter().position(|b| *b == b'@')?;
    let digits = line.code[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
    (digits == 3).then(|| Span::at(at as u32, 4))
}

/// `%PM` in the first line.
pub fn philips_head(line: &Line<'_>, at: usize) -> Option<Span> {
    (at == 0 && line.code.trim_ascii() == b"%PM").then(|| line.span())
}

/// A line of the preprocessor of C.
pub fn preprocessor(line: &Line<'_>, _: usize) -> Option<Span> {
    let text = line.text.trim_ascii_start();
    let rest = text.strip_prefix(b"#")?.trim_ascii_start();
    let words: [&[u8]; 6] = [b"include ", b"include<", b"ifndef ", b"ifdef ", b"define ", b"pragma "];
    let is_one = words.iter().any(|word| rest.starts_with(word)) || rest.starts_with(b"include\"");
    is_one.then(|| line.span())
}

/// Prose: four words of small letters, and no digit.
pub fn prose(line: &Line<'_>) -> bool {
    let text = line.text.trim_ascii();
    let is_comment = matches!(text.first(), Some(b';' | b'(' | b'[' | b'*' | b'%'));
    let small =
        |word: &&[u8]| word.len() > 1 && word[1..].iter().all(|b| b.is_ascii_lowercase() || b",.:'".contains(b));
    let words = text.split(|b| b.is_ascii_whitespace()).filter(small).count();
    !is_comment && words >= 4 && !text.contains(&b'=')
}
