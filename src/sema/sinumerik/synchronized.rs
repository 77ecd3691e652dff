//! Synchronized actions: what they would do, and whether the output may go without it.
//!
//! Comes in: the text of an action. Goes out: a warning where it is left out; an error where what it does reaches the path, the
//! spindle, or a value that the program reads. Nothing of it is ever carried out.
//!
//! Source: S 6 (docs/sources.md).

use crate::diag::{Answer, Fault, Label, codes};
use crate::text::{Loc, Span};

use super::line::Line;
use super::vars::Slot;
use super::{Channel, Core, Outcome, Reported, Run};

/// Longest text of an action that a message shows.
const MOST_SHOWN: usize = 60;

/// One statement behind DO.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Effect {
    /// An output or function that the machine gets: its text.
    Function(String),
    /// Feed and time, not the path.
    Pace,
    /// Stops, holds or ends actions.
    Manages,
    /// A value that a program may read: its name, with the index where that is a number.
    Writes(String),
    /// A name that may be a variable of all programs.
    WritesName(String),
    /// It reaches the path or the spindle, or nobody knows.
    Reaches(String),
}

/// Values that actions which are left out set, and where the action stands.
#[derive(Debug, Default)]
pub(super) struct SetBeside {
    /// `R10`, `R` for any, `$AC_MARKER[1]`, `$A_OUT` for any.
    names: Vec<(String, Loc)>,
    globals: Vec<(Slot, Loc)>,
}

impl SetBeside {
    /// The action that sets this R parameter.
    #[inline]
    fn sets_r(&self, n: u32) -> Option<Loc> {
        let is_it = |name: &str| name == "R" || name.strip_prefix('R').is_some_and(|digits| digits.parse() == Ok(n));
        self.names.iter().find(|(name, _)| is_it(name)).map(|(_, at)| *at)
    }

    /// No value of an R parameter that an action beside the program sets.
    #[inline]
    pub fn leaves_r(&self, n: u32, core: &Core<'_>, span: Span) -> Outcome {
        match self.sets_r(n) {
            Some(at) => is_set_beside(&format!("R{n}"), at, core, span),
            None => Ok(()),
        }
    }

    /// The same of a variable of all programs.
    #[inline]
    pub fn leaves_variable(&self, slot: Slot, core: &Core<'_>, span: Span) -> Outcome {
        match (self.globals.iter().find(|(known, _)| *known == slot), slot) {
            (Some((_, at)), Slot::Global(name)) => is_set_beside(core.symbols.name(name), *at, core, span),
            _ => Ok(()),
        }
    }

    /// The same of a system variable.
    pub fn leaves_system(&self, word: &str, key: &str, core: &Core<'_>, span: Span) -> Outcome {
        match self.names.iter().find(|(name, _)| name == word || name == key) {
            Some((_, at)) => is_set_beside(key, *at, core, span),
            None => Ok(()),
        }
    }
}

fn is_set_beside<T>(name: &str, at: Loc, core: &Core<'_>, span: Span) -> Outcome<T> {
    let found = codes::S9022::is_set_by_synchronized_action_in_line(&name, &at.line);
    let found = found.at(core.loc(span)).also(at, Label::ActionSets);
    core.report(found.help("let the program compute the value itself, and take it out of the action"));
    Err(Reported)
}

impl Run<'_> {
    /// A synchronized action: refused, or left out where nothing of it reaches what is compiled.
    pub(super) fn synchronized_action(&mut self, line: Line<'_>, span: Span) -> Outcome {
        let code = String::from_utf8_lossy(line.block.span.of(line.text)).to_ascii_uppercase();
        let shown = shown(&code);
        let Some(effects) = effects(&code) else {
            return self.channel.core.refuse(span, codes::S9004::synchronized_action_has_no_do_that_can());
        };
        // Variables of all programs, which an action may set.
        let mut globals = Vec::new();
        for effect in &effects {
            let reached = match effect {
                Effect::Reaches(what) => what.clone(),
                Effect::WritesName(name) => {
                    let symbol = self.channel.core.symbols.intern(name.as_bytes());
                    match self.known_variable(symbol) {
                        Some(slot @ Slot::Global(_)) => {
                            globals.push(slot);
                            continue;
                        }
                        _ => format!("`{name}` is no output, and no variable of all programs"),
                    }
                }
                _ => continue,
            };
            let fault = codes::S9004::synchronized_action_cannot_be_left_out(&shown, &reached);
            return self.channel.core.refuse(span, fault);
        }
        let Channel { core, set_beside, .. } = &mut self.channel;
        if !core.job.settings.control.sinumerik.beside.synchronized {
            let help = "if the target needs nothing of it, leave such actions out: `[control] synchronized_actions = \
                        \"leave-out\"`; or replace it by blocks of the program";
            let help = Answer::key("control", "synchronized_actions").one_of(&["\"leave-out\""]).help(help);
            return core.refuse(span, codes::S9004::synchronized_actions_run_beside_program().help(help));
        }
        let loc = core.loc(span);
        set_beside.globals.extend(globals.into_iter().map(|slot| (slot, loc)));
        for effect in &effects {
            if let Effect::Writes(name) = effect {
                set_beside.names.push((name.clone(), loc));
            }
        }
        core.report_new(left_out(&shown, &effects).at(loc));
        Ok(())
    }
}

/// What is said of an action that is left out.
fn left_out(shown: &str, effects: &[Effect]) -> Fault {
    let functions: Vec<&str> = effects
        .iter()
        .filter_map(|effect| if let Effect::Function(text) = effect { Some(text.as_str()) } else { None })
        .collect();
    let list = functions.join(", ");
    match (functions.is_empty(), effects.contains(&Effect::Pace)) {
        (true, false) => codes::S8165::synchronized_action_is_left_out(&shown),
        (false, false) => codes::S8165::synchronized_action_is_left_out_with(&shown, &list),
        (true, true) => codes::S8165::synchronized_action_of_pace_is_left_out(&shown),
        (false, true) => codes::S8165::synchronized_action_of_pace_is_left_out_with(&shown, &list),
    }
}

/// The action in one line, shortened.
fn shown(code: &str) -> String {
    let words: Vec<&str> = code.split_whitespace().collect();
    let line = words.join(" ");
    if line.chars().count() <= MOST_SHOWN {
        return line;
    }
    let short: String = line.chars().take(MOST_SHOWN).collect();
    format!("{short}…")
}

/// What stands behind DO, statement by statement; `None` where there is no DO, or nothing behind it. `code` is in capitals.
fn effects(code: &str) -> Option<Vec<Effect>> {
    let mut scan = Scan { rest: code };
    while scan.word()? != "DO" {}
    let mut effects = Vec::new();
    loop {
        scan.blanks();
        if scan.rest.is_empty() {
            break;
        }
        let before = scan.rest;
        let Some(statement) = scan.statement() else {
            effects.push(Effect::Reaches(format!("`{}` cannot be read", before.trim_end())));
            break;
        };
        effects.extend(effect_of(&statement));
    }
    (!effects.is_empty()).then_some(effects)
}

/// A statement as it is written.
struct Statement<'s> {
    name: &'s str,
    /// What stands in brackets behind the name.
    index: Option<&'s str>,
    kind: Kind,
    text: &'s str,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Bare,
    Assigned,
    Called,
}

/// What a statement does; `None` for words that only join or measure others.
fn effect_of(statement: &Statement<'_>) -> Option<Effect> {
    use Kind::{Assigned, Bare, Called};
    let Statement { name, index, kind, text } = *statement;
    let reaches = |why: &str| Some(Effect::Reaches(format!("`{text}` {why}")));
    let written = |name: &str| {
        let number =
            index.map(str::trim).filter(|index| !index.is_empty() && index.bytes().all(|b| b.is_ascii_digit()));
        Some(Effect::Writes(number.map_or_else(|| name.to_owned(), |number| format!("{name}[{number}]"))))
    };
    let number_of = |letter: char| name.strip_prefix(letter).and_then(|digits| digits.parse::<u32>().ok());
    match (name, kind) {
        ("ELSE" | "G70" | "G71" | "G700" | "G710", Bare) => None,
        ("RDISABLE" | "STOPREOF", Bare) => Some(Effect::Pace),
        ("SETAL" | "LOCK" | "UNLOCK" | "RESET" | "CANCEL", Called) => Some(Effect::Manages),
        ("$AC_OVR" | "$AC_VC", Assigned) => Some(Effect::Pace),
        ("$AA_OVR" | "$AA_VC", Assigned) => {
            let index = index.unwrap_or_default().trim();
            let spindle =
                index.strip_prefix('S').is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit() || c == 'P'));
            if spindle || index.is_empty() { reaches("acts on a spindle") } else { Some(Effect::Pace) }
        }
        ("$AC_MARKER" | "$AC_PARAM" | "$AC_TIMER", Assigned) => written(name),
        (_, Assigned) if name.starts_with("$AC_FIFO") => Some(Effect::Writes(name.to_owned())),
        (_, Assigned) if is_output(name) => written(name),
        ("R" | "$R", Assigned) => {
            let number =
                index.map(str::trim).filter(|index| !index.is_empty() && index.bytes().all(|b| b.is_ascii_digit()));
            Some(Effect::Writes(format!("R{}", number.unwrap_or_default())))
        }
        (_, Assigned) if name.strip_prefix('$').unwrap_or(name).strip_prefix('R').is_some_and(is_number) => {
            Some(Effect::Writes(name.trim_start_matches('$').to_owned()))
        }
        (_, Bare) if number_of('M').is_some() => match number_of('M').unwrap_or_default() {
            0 | 1 | 2 | 17 | 30 => reaches("stops or ends the program"),
            3 | 4 | 5 | 19 | 70 | 40..=45 => reaches("acts on the spindle"),
            6 => reaches("changes the tool"),
            _ => Some(Effect::Function(text.to_owned())),
        },
        (_, Bare | Assigned) if number_of('H').is_some() || name == "H" => Some(Effect::Function(text.to_owned())),
        (_, Assigned) if number_of('M').is_some() || name == "M" => reaches("may act on the spindle"),
        (_, Assigned) if name.starts_with('S') && (name.len() == 1 || number_of('S').is_some()) => {
            reaches("acts on a spindle")
        }
        (_, Assigned) if is_variable_name(name) => Some(Effect::WritesName(name.to_owned())),
        (_, Bare | Called) if is_variable_name(name) => reaches("moves axes, or is a program of its own"),
        _ => reaches("may move an axis or change what blocks do"),
    }
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// Outputs, and data that the machine's own control gets.
fn is_output(name: &str) -> bool {
    const OUTPUTS: [&str; 14] = [
        "$A_OUT",
        "$A_OUTA",
        "$A_DBB",
        "$A_DBW",
        "$A_DBD",
        "$A_DBR",
        "$A_DBSB",
        "$A_DBSW",
        "$A_DLB",
        "$A_DLW",
        "$A_DLD",
        "$A_DLR",
        "$A_PBB_OUT",
        "$A_PBW_OUT",
    ];
    OUTPUTS.contains(&name)
}

/// A name with two letters in front and no `$`, that is no word of axes.
fn is_variable_name(name: &str) -> bool {
    const WORDS: [&str; 12] =
        ["POS", "POSRANGE", "MOV", "FA", "SPOS", "OVR", "OVRA", "ACC", "VELOLIM", "FXS", "FXST", "SPOSA"];
    let mut bytes = name.bytes();
    let starts =
        matches!((bytes.next(), bytes.next()), (Some(a), Some(b)) if !a.is_ascii_digit() && !b.is_ascii_digit());
    starts && !name.starts_with('$') && !WORDS.contains(&name)
}

/// The rest of an action.
struct Scan<'s> {
    rest: &'s str,
}

impl<'s> Scan<'s> {
    fn blanks(&mut self) {
        self.rest = self.rest.trim_start();
    }

    /// The next name in the text, over whatever stands in front of it.
    fn word(&mut self) -> Option<&'s str> {
        loop {
            self.blanks();
            let first = self.rest.chars().next()?;
            if first == '"' {
                let end = self.rest[1..].find('"')?;
                self.rest = &self.rest[end + 2..];
            } else if begins_name(first) {
                return Some(self.name());
            } else {
                self.rest = &self.rest[first.len_utf8()..];
            }
        }
    }

    fn name(&mut self) -> &'s str {
        let end =
            self.rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '$')).unwrap_or(self.rest.len());
        let (name, rest) = self.rest.split_at(end);
        self.rest = rest;
        name
    }

    /// What stands between `open`, which comes next, and its `close`.
    fn group(&mut self, open: char, close: char) -> Option<&'s str> {
        let mut depth = 0u32;
        for (at, c) in self.rest.char_indices() {
            if c == open {
                depth += 1;
            } else if c == close {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    let inner = &self.rest[open.len_utf8()..at];
                    self.rest = &self.rest[at + close.len_utf8()..];
                    return Some(inner);
                }
            }
        }
        None
    }

    fn statement(&mut self) -> Option<Statement<'s>> {
        let whole = self.rest;
        if !self.rest.starts_with(begins_name) {
            return None;
        }
        let name = self.name();
        // `X10.5`
        if self.rest.starts_with('.') {
            self.rest = self.rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
        }
        self.blanks();
        let index = if self.rest.starts_with('[') { Some(self.group('[', ']')?) } else { None };
        self.blanks();
        let kind = if self.rest.starts_with('=') && !self.rest.starts_with("==") {
            self.rest = &self.rest[1..];
            self.formula()?;
            Kind::Assigned
        } else if self.rest.starts_with('(') {
            self.group('(', ')')?;
            Kind::Called
        } else {
            Kind::Bare
        };
        let text = whole[..whole.len() - self.rest.len()].trim_end();
        Some(Statement { name, index, kind, text })
    }

    /// A formula: operands with operators between them.
    fn formula(&mut self) -> Option<()> {
        loop {
            self.operand()?;
            self.blanks();
            let operator = ["<=", ">=", "<>", "==", "<<", "+", "-", "*", "/", "<", ">"];
            if let Some(sign) = operator.into_iter().find(|sign| self.rest.starts_with(sign)) {
                self.rest = &self.rest[sign.len()..];
                continue;
            }
            let mut ahead = Scan { rest: self.rest };
            let joins = ["AND", "OR", "XOR", "DIV", "MOD", "B_AND", "B_OR", "B_XOR"];
            if !self.rest.starts_with(begins_name) || !joins.contains(&ahead.name()) {
                return Some(());
            }
            self.rest = ahead.rest;
        }
    }

    fn operand(&mut self) -> Option<()> {
        loop {
            self.blanks();
            let first = self.rest.chars().next()?;
            match first {
                '+' | '-' => self.rest = &self.rest[1..],
                '(' => return self.group('(', ')').map(|_| ()),
                '"' => {
                    let end = self.rest[1..].find('"')?;
                    self.rest = &self.rest[end + 2..];
                    return Some(());
                }
                '\'' => {
                    let end = self.rest[1..].find('\'')?;
                    self.rest = &self.rest[end + 2..];
                    return Some(());
                }
                _ if first.is_ascii_digit() || first == '.' => {
                    self.rest = self.rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
                    if let Some(exponent) = self.rest.strip_prefix("EX") {
                        let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
                        self.rest = digits.trim_start_matches(|c: char| c.is_ascii_digit());
                    }
                    return Some(());
                }
                _ if begins_name(first) => {
                    if matches!(self.name(), "NOT" | "B_NOT") {
                        continue;
                    }
                    self.blanks();
                    if self.rest.starts_with('[') {
                        self.group('[', ']')?;
                    } else if self.rest.starts_with('(') {
                        self.group('(', ')')?;
                    }
                    return Some(());
                }
                _ => return None,
            }
        }
    }
}

fn begins_name(c: char) -> bool {
    c.is_ascii_alphabetic() || c == '_' || c == '$'
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(code: &str) -> Vec<Effect> {
        effects(&code.to_ascii_uppercase()).unwrap_or_default()
    }

    /// None of its statements reaches the path, where no variable of all programs has the name of one.
    fn may_go(code: &str) -> bool {
        let effects = of(code);
        let reaches = |effect: &Effect| matches!(effect, Effect::Reaches(_) | Effect::WritesName(_));
        !effects.is_empty() && !effects.iter().any(reaches)
    }

    #[test]
    fn outputs_markers_and_the_pace_may_go() {
        for code in [
            "WHEN $AC_DTEW < 5 DO $A_OUT[1]=1",
            "IDS=1 EVERY ($R10 == 400 * R1) DO M9",
            "IDS=3 FROM TRUE DO $R10 = $R10 + 1",
            "ID=2 WHENEVER $A_IN[1]==1 DO $AC_OVR=50",
            "ID=3 WHENEVER $AA_IM[X]>10.5 DO $AA_OVR[X]=0 RDISABLE",
            "EVERY $A_DBB[10] DO SETAL(66003) $A_DBB[10] = 0",
            "ID=4 DO $AC_MARKER[1]=1 CANCEL(3)",
            "WHEN \"DO\" == \"DO\" DO H5 M100",
            "WHEN G710 ($AC_PARAM[31]+$A_DBB[55]) DO $A_OUT[1]=NOT $A_IN[2] AND (1==1)",
        ] {
            assert!(may_go(code), "{code}: {:?}", of(code));
        }
    }

    #[test]
    fn one_word_that_moves_holds_the_whole_line() {
        for moving in [
            "POS[U]=10",
            "FA[U]=500",
            "MOV[U]=1",
            "SPOS=0",
            "SPOS[2]=90",
            "M3",
            "M=3",
            "M2=3",
            "M30",
            "M6",
            "S500",
            "S2=500",
            "$AA_OFF[Z]=$R1",
            "$AA_OVR[S1]=50",
            "$AA_OVR[SPI(1)]=50",
            "FTOC(1,$AA_IW[X],1,1)",
            "SYNFCT(1,$AC_VC,$AA_LOAD[X])",
            "DELDTG",
            "DELDTG(X)",
            "MEASA[X]=(1,1)",
            "TRAILON(U,X,1)",
            "COUPON(S2,S1)",
            "PRESETON(X,0)",
            "GET(X)",
            "FXS[X]=1",
            "OPEN_DOOR",
            "OPEN_DOOR(1)",
            "X10.5",
            "G0",
            "F2000",
            "T1",
            "D1",
            "$P_UIFR[1,X,TR]=5",
            "$TC_DP3[1,1]=5",
            "$SA_OSCILL_REVERSE_POS1[Z]=5",
            "$AC_XYZ=1",
            "?",
        ] {
            for line in [
                format!("WHEN TRUE DO {moving}"),
                format!("WHEN TRUE DO $A_OUT[1]=1 {moving}"),
                format!("WHEN TRUE DO M9 {moving} $A_OUT[2]=R1*2"),
                format!("ID=1 WHENEVER $A_IN[1] DO $AC_OVR=0 ELSE {moving}"),
                format!("IDS=2 EVERY ($AA_IW[X]>R1) AND NOT $A_IN[2] DO $AC_MARKER[1]=$AC_MARKER[1]+1 {moving} H5"),
                format!("FROM $AC_TIMER[1]>2.5EX1 DO $A_DBB[4]=('H1F' B_AND R2) {moving}"),
                format!("DO G710 SETAL(65000) {moving} RDISABLE"),
            ] {
                assert!(!may_go(&line), "{line}: {:?}", of(&line));
            }
        }
    }

    #[test]
    fn what_is_written() {
        let written = |code: &str| match &of(code)[..] {
            [Effect::Writes(name) | Effect::WritesName(name)] => name.clone(),
            other => format!("{other:?}"),
        };
        assert_eq!(written("DO R10=1"), "R10");
        assert_eq!(written("DO $R10=1"), "R10");
        assert_eq!(written("DO R[10]=1"), "R10");
        assert_eq!(written("DO $R[$AC_MARKER[1]]=1"), "R");
        assert_eq!(written("DO $AC_MARKER[2]=1"), "$AC_MARKER[2]");
        assert_eq!(written("DO $A_DBB[R1]=1"), "$A_DBB");
        assert_eq!(written("DO SYG_COUNT=1"), "SYG_COUNT");
        let set = SetBeside { names: vec![("R1".to_owned(), Loc::default())], globals: Vec::new() };
        assert!(set.sets_r(1).is_some() && set.sets_r(10).is_none());
    }

    #[test]
    fn an_action_without_do_is_none() {
        assert_eq!(effects("WHEN $A_IN[1]"), None);
        assert_eq!(effects("ID=1 DO "), None);
        assert_eq!(effects("ID=1"), None);
    }
}
