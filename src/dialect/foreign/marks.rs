//! What shows a language that is none of ours.

use crate::text::Span;

use super::line::{Line, Word};
use super::own::is_klartext;

/// Weight of marks that together decide.
pub const DECIDES: u8 = 2;
/// Weight of a mark that no language of ours has: it counts beside lines that look like one of them.
const PROVES: u8 = 4;

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

/// A mark that is enough, whatever stands beside it.
pub const fn proof(shows: fn(&Line<'_>, usize) -> Option<Span>) -> Mark {
    Mark { weight: PROVES, shows }
}

/// One of two that are needed.
pub const fn half(shows: fn(&Line<'_>, usize) -> Option<Span>) -> Mark {
    Mark { weight: 1, shows }
}

/// One that is named beside those that decide.
pub const fn beside(shows: fn(&Line<'_>, usize) -> Option<Span>) -> Mark {
    Mark { weight: 0, shows }
}

impl Mark {
    pub fn is_proof(&self) -> bool {
        self.weight == PROVES
    }
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

/// `#100=5`, `N10 #100=[#1+2]` at the beginning of a block: a variable of a macro is set.
pub fn set_variable(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.behind_number().first().filter(|word| word.letters == b"#" && !word.number.is_empty())?;
    let behind = line.code.get(word.span.end as usize..)?.trim_ascii_start();
    let whole = word.number.iter().all(u8::is_ascii_digit);
    let value = behind.strip_prefix(b"=")?.trim_ascii_start();
    let is_value = value.first().is_some_and(|b| b.is_ascii_digit() || b"+-.#[".contains(b) || b.is_ascii_alphabetic());
    (whole && word.number.len() >= 3 && is_value).then(|| line.span_to_blank(word))
}

/// `#1=5` at the beginning of a block. A HEIDENHAIN turning control has such variables, too.
pub fn set_any_variable(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.behind_number().first().filter(|word| word.letters == b"#" && !word.number.is_empty())?;
    let behind = line.code.get(word.span.end as usize..)?.trim_ascii_start();
    behind.starts_with(b"=").then(|| line.span_to_blank(word))
}

/// `G65 P9000`, `M98 P1000`
pub fn macro_call(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["65", "66"]), numbered("P")).or_else(|| both(line, is("M", &["98"]), numbered("P")))
}

/// `IF [#1 EQ 2] GOTO 10`, `WHILE [#1 LT 5] DO1`
pub fn condition(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.behind_number().first().filter(|word| word.letters == b"IF" || word.letters == b"WHILE")?;
    let behind = line.code.get(word.span.end as usize..)?.trim_ascii_start();
    (behind.starts_with(b"[") && behind.contains(&b'#')).then(|| line.span_from(word))
}

/// `GOTO 100`, `GOTO100`: a jump to the number of a block.
pub fn jump_to_number(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| word.letters == b"GOTO")?;
    let behind = line.code.get(word.span.start as usize + 4..)?.trim_ascii_start();
    behind.first().is_some_and(u8::is_ascii_digit).then(|| line.span_from(word))
}

/// `G54.1 P1`, `G10 L2`: work offsets of a Fanuc.
pub fn offset_by_number(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["54.1"]), numbered("P")).or_else(|| both(line, is("G", &["10"]), numbered("L")))
}

/// `G50 S2000`, `G71 P10 Q20 U0.4`: a lathe of Fanuc.
pub fn turning_cycle(line: &Line<'_>, _: usize) -> Option<Span> {
    let profile = |word: &Word| matches!(&word.letters[..], b"Q") && !word.number.is_empty();
    both(line, is("G", &["70", "71", "72", "73", "76"]), profile)
        .filter(|_| line.words.iter().any(|word| word.letters == b"P"))
        .or_else(|| both(line, is("G", &["50"]), numbered("S")))
}

/// `O100 SUB`, `O<BORE> CALL`, `#<DEPTH> = 5`: subprograms and named variables of LinuxCNC.
pub fn o_word(line: &Line<'_>, _: usize) -> Option<Span> {
    const FLOW: [&[u8]; 15] = [
        b"SUB",
        b"ENDSUB",
        b"CALL",
        b"IF",
        b"ELSE",
        b"ELSEIF",
        b"ENDIF",
        b"WHILE",
        b"ENDWHILE",
        b"DO",
        b"REPEAT",
        b"ENDREPEAT",
        b"BREAK",
        b"CONTINUE",
        b"RETURN",
    ];
    let code = line.code.trim_ascii();
    let named = code.starts_with(b"#<") || code.starts_with(b"O<");
    // `O100: IF R1==1`: a label of a SINUMERIK.
    let is_label = |word: &Word| {
        line.code.get(word.span.end as usize..).is_some_and(|rest| rest.trim_ascii_start().starts_with(b":"))
    };
    let flow = match line.behind_number() {
        [first, second, ..] => {
            first.letters == b"O" && !first.number.is_empty() && !is_label(first) && FLOW.contains(&&second.letters[..])
        }
        _ => false,
    };
    (named || flow).then(|| line.span())
}

/// Two words with which programs for mills begin, and which mean something else on a lathe of HEIDENHAIN.
pub fn safety_block(line: &Line<'_>, _: usize) -> Option<Span> {
    let safe = is("G", &["17", "20", "21", "40", "49", "54", "80", "90", "94", "64"]);
    // That control has these, too.
    let shared = is("G", &["40", "80", "94"]);
    // Comments of that control stand in square brackets.
    if line.text.contains(&b'[') || line.words.iter().filter(|word| safe(word)).all(shared) {
        return None;
    }
    let mut found = line.words.iter().filter(|word| safe(word));
    let (first, mut last) = (found.next()?, found.next()?);
    found.for_each(|word| last = word);
    Some(first.span.to(last.span))
}

fn g_word(line: &Line<'_>, numbers: &'static [&'static str]) -> Option<Span> {
    line.words.iter().find(|word| is("G", numbers)(word)).map(|word| word.span)
}

/// `G17`, `G54`, `G90`, `G43`: what no lathe of HEIDENHAIN takes.
pub fn mode_of_mill(line: &Line<'_>, _: usize) -> Option<Span> {
    g_word(line, &["17", "18", "19", "43", "49", "54", "54.1", "90", "91", "91.1"])
}

/// `Y10`: a third axis.
pub fn third_axis(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| word.letters == b"Y" && !word.number.is_empty())?;
    Some(word.span)
}

/// `M6`
pub fn change(line: &Line<'_>, _: usize) -> Option<Span> {
    line.words.iter().find(|word| word.is("M", "6")).map(|word| word.span)
}

/// `G20` or `G21` with no more than other G words.
pub fn unit_alone(line: &Line<'_>, at: usize) -> Option<Span> {
    let only = line.behind_number().iter().all(|word| word.letters == b"G");
    unit(line, at).filter(|_| only)
}

/// `G43`, `G49`: the length of a tool, which the SINUMERIK language takes with D.
pub fn any_length(line: &Line<'_>, _: usize) -> Option<Span> {
    g_word(line, &["43", "44", "49"])
}

/// `G80`, `G81`: drilling cycles by G code.
pub fn any_cycle(line: &Line<'_>, _: usize) -> Option<Span> {
    g_word(line, &["73", "76", "80", "81", "82", "83", "84", "85", "86", "87", "88", "89"])
}

/// `G98`, `G99`
pub fn return_plane(line: &Line<'_>, _: usize) -> Option<Span> {
    g_word(line, &["98", "99"])
}

/// `G0 X10 Y5`, `N10 G90 G54`: a block that begins with a G word and holds an axis, or no more than G words.
pub fn g_block(line: &Line<'_>, _: usize) -> Option<Span> {
    let (first, rest) = line.behind_number().split_first()?;
    let of_g = first.letters == b"G" && !first.number.is_empty();
    let axis = |word: &Word| matches!(&word.letters[..], b"X" | b"Y" | b"Z") && !word.number.is_empty();
    (of_g && (rest.iter().any(axis) || rest.iter().all(|word| word.letters == b"G"))).then(|| line.span())
}

/// A word of a letter and a number.
pub fn any_word(line: &Line<'_>, _: usize) -> Option<Span> {
    let is_word = |word: &Word| matches!(&word.letters[..], [letter] if *letter != b'#') && !word.number.is_empty();
    let is_block = line.words.first().is_some_and(is_word) && !line.code.trim_ascii_start().starts_with(b"%");
    is_block.then(|| line.span())
}

/// Does the line come from a program for a lathe of Fanuc or its like, where X is a diameter?
pub fn of_lathe(line: &Line<'_>) -> bool {
    let change = line.words.iter().any(|word| word.is("M", "6"));
    let turret = |word: &Word| word.letters == b"T" && word.number.len() >= 4 && !change;
    let limit = both(line, is("G", &["50", "92"]), numbered("S")).is_some();
    let increment = |word: &Word| matches!(&word.letters[..], b"U" | b"W") && !word.number.is_empty();
    limit || line.words.iter().any(|word| turret(word) || increment(word) || word.is("G", "96"))
}

/// `R1=5`
pub fn r_parameter(line: &Line<'_>, _: usize) -> Option<Span> {
    let of_r = |word: &&Word| word.letters == b"R" && word.number.first().is_some_and(u8::is_ascii_digit);
    let word = line.words.iter().filter(of_r).find(|word| {
        line.code.get(word.span.end as usize..).is_some_and(|behind| behind.trim_ascii_start().starts_with(b"="))
    })?;
    Some(line.span_to_blank(word))
}

/// `X=IC(5)`, `B=DC(90)`
pub fn axis_by_name(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| {
        let behind = line.code.get(word.span.end as usize..).unwrap_or_default().trim_ascii_start();
        let Some(value) = behind.strip_prefix(b"=").map(<[u8]>::trim_ascii_start) else { return false };
        let name = value.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let at = line.code.len() - value.len() + name;
        [&b"IC"[..], b"AC", b"DC", b"ACP", b"ACN"].contains(&&value[..name])
            && line.text.get(at..).is_some_and(|rest| rest.trim_ascii_start().starts_with(b"("))
    })?;
    Some(line.span_to_blank(word))
}

/// `X=10`, `F=VCUT`: a value behind a sign of equality, where other controls write it at once.
pub fn value_assigned(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| {
        word.letters != b"#"
            && !matches!(&word.letters[..], b"CR" | b"T" | b"R" | b"Q" | b"QL" | b"QR" | b"QS")
            && line.code.get(word.span.end as usize) == Some(&b'=')
    })?;
    (!line.code.trim_ascii_start().starts_with(b"#")).then(|| line.span_to_blank(word))
}

/// A comment behind `;` is the whole line.
pub fn semicolon_comment(line: &Line<'_>, _: usize) -> Option<Span> {
    line.text.trim_ascii().starts_with(b";").then(|| line.span())
}

/// `G500`, `G710`, `G642`
pub fn sinumerik_mode(line: &Line<'_>, _: usize) -> Option<Span> {
    g_word(line, &["500", "505", "506", "507", "601", "602", "641", "642", "645", "450", "451", "700", "710"])
}

/// `TOOL CALL 5 Z S1000`, `CYCL DEF 200`: a block of the dialog.
pub fn dialog(line: &Line<'_>, _: usize) -> Option<Span> {
    let code = line.code.trim_ascii_start();
    let code = code[code.iter().take_while(|b| b.is_ascii_digit()).count()..].trim_ascii_start();
    let begins = [&b"TOOL CALL "[..], b"TOOL DEF ", b"CYCL DEF ", b"CYCL CALL ", b"BLK FORM "];
    begins.iter().any(|begin| code.starts_with(begin)).then(|| line.span())
}

/// `L X+10 Y-5 R0 FMAX`: a line of the dialog with signs.
pub fn dialog_line(line: &Line<'_>, _: usize) -> Option<Span> {
    let signed = line.words.iter().any(|word| matches!(word.number.first(), Some(b'+' | b'-')));
    let speed = line.words.iter().any(|word| matches!(&word.letters[..], b"FMAX" | b"FAUTO") || word.is("R", "0"));
    (is_klartext(line) && signed && speed).then(|| line.span())
}

/// `CYCLE81(`: a cycle of the SINUMERIK.
pub fn cycle_call(line: &Line<'_>, _: usize) -> Option<Span> {
    let word = line.words.iter().find(|word| word.letters == b"CYCLE" && word.number.len() >= 2)?;
    // Brackets are blanked out in `code`.
    let behind = line.text.get(word.span.end as usize..)?.trim_ascii_start();
    behind.starts_with(b"(").then(|| line.span_to_blank(word))
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

/// `STOPRE`, `MCALL`, `SUPA`
pub fn stop_of_reading(line: &Line<'_>, _: usize) -> Option<Span> {
    named(line, &[b"STOPRE", b"MCALL", b"SUPA", b"DIAMON", b"DIAMOF"])
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
    [program_number, tool_length, any_length, reference_point, drilling, any_cycle, macro_call, set_variable]
        .iter()
        .find_map(|shows| shows(line, at))
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

/// `NAT01`, `VZOFZ=`, `NOEX`, `NLAP1`
pub fn okuma_word(line: &Line<'_>, _: usize) -> Option<Span> {
    const WORDS: [&[u8]; 10] =
        [b"VZOFZ", b"VZOFX", b"VZOFY", b"VTOFH", b"VTOFD", b"VSIOZ", b"VGRIN", b"OSTRT", b"NOEX", b"VNTOL"];
    let word = line.words.iter().find(|word| {
        matches!(&word.letters[..], b"NAT" | b"NLAP") && !word.number.is_empty() || WORDS.contains(&&word.letters[..])
    });
    word.map(|word| word.span)
}

/// `VC1=5`, `IF [VC1 EQ 2] N10`: a variable of an Okuma.
pub fn okuma_variable(line: &Line<'_>, _: usize) -> Option<Span> {
    let (at, word) =
        line.words.iter().enumerate().find(|(_, word)| word.letters == b"VC" && !word.number.is_empty())?;
    let is_set = line.code.get(word.span.end as usize..)?.trim_ascii_start().starts_with(b"=");
    let asks = at > 0 && line.words.iter().any(|word| word.letters == b"IF");
    (is_set || asks).then(|| line.span_to_blank(word))
}

/// `G85 NLAP1 D4 F0.3`: a cycle of an Okuma lathe with the name of its contour.
pub fn okuma_cycle(line: &Line<'_>, _: usize) -> Option<Span> {
    both(line, is("G", &["85", "86", "87", "88"]), |word| word.letters == b"NLAP")
}

/// `G15 H1`: a work offset. No other control of ours has the code.
pub fn okuma_offset_alone(line: &Line<'_>, at: usize) -> Option<Span> {
    let few = line.behind_number().len() == 2;
    okuma_offset(line, at).filter(|_| few)
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
