//! The words of CYCL DEF: which of them a definition takes, and what they say.
//!
//! Source: K 3.1, 4.4, 4.5, 6.1 and 6.2 (docs/sources.md). A name in a part of an old cycle is decoration in the language
//! of the control; every value has to have its place.

use crate::diag::codes;
use crate::ir::Function;
use crate::ir::function::PathControl;
use crate::lexer::klartext::{QKind, QRef, Value};
use crate::machine::AxisSet;
use crate::parser::klartext::ast::{Addr, Block, Word};
use crate::sema::cycle::row::Name;
use crate::sema::run::Where;
use crate::text::decode::readable;
use crate::text::{Span, number::decimal};

use super::contour_data::contour_labels;
use super::cycle_definition::{AxisValue, DottedValue, Labelled, Open, What, WordFeed};
use super::cycles::{CycleKind, find};
use super::global_def::{Given, Globals};
use super::reading::Reading;
use super::state::State;
use super::vars::{Slot, Vars};
use super::{Core, Outcome};

/// What was read of a part of a definition.
#[derive(Debug, Default)]
struct Read {
    /// The name that waits for its value, in upper case, and where it stands.
    label: Option<(String, Span)>,
    /// Values without an axis, feeds included.
    values: u32,
}

impl Read {
    fn label(&self) -> &str {
        self.label.as_ref().map_or("", |(label, _)| label)
    }
}

/// A definition while a block of it is read.
pub(super) struct Defining<'d, 'a> {
    pub open: &'d mut Open,
    pub core: &'d mut Core<'a>,
    pub vars: &'d mut Vars,
    pub st: &'d State,
    pub globals: &'d Globals,
}

impl<'a> Defining<'_, 'a> {
    fn reading(&self) -> Reading<'_, 'a> {
        Reading { core: self.core, vars: self.vars, st: self.st }
    }

    pub fn words(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let mut read = Read::default();
        let number = self.open.number;
        let nature = find(number).nature;
        if number == 14 && self.open.part.is_some_and(|part| part > 0) {
            let Some(mut labels) = contour_labels(&readable(block.span.of(text))) else {
                return self.refuse_word(block.span);
            };
            self.open.contours.append(&mut labels);
            return Ok(());
        }
        for &word in &block.words {
            if !self.takes(nature, word, &read, text) {
                return self.refuse_word(word.span);
            }
            self.read(word, nature, &mut read, block, text)?;
        }
        match read.label {
            Some((label, span)) if needs_its_value(nature, self.open.part) => {
                self.core.refuse(span, codes::P1004::has_no_number(&label))
            }
            _ => Ok(()),
        }
    }

    fn read(&mut self, word: Word, nature: CycleKind, read: &mut Read, block: &Block, text: &[u8]) -> Outcome {
        match word.addr {
            Addr::TurnPlus | Addr::TurnMinus if nature.is_machining() => {
                self.open.keep_part(What::Turn, if word.addr == Addr::TurnPlus { 1.0 } else { -1.0 });
            }
            Addr::Axis { .. } => return self.axis(word, nature, block),
            Addr::Name if matches!(nature, CycleKind::Mirror) => self.mirror_letters(word, block, text)?,
            Addr::Name => {
                read.label = Some((String::from_utf8_lossy(word.span.of(text)).to_ascii_uppercase(), word.span));
            }
            Addr::Hash => {
                read.label = Some(("#".to_owned(), word.span));
                self.open.table_row = true;
            }
            Addr::Value => {
                self.doubtful_point(read, word, text)?;
                let value = self.reading().number(word.value, word.span)?;
                let label = read.label.take().map(|(label, _)| label).unwrap_or_default();
                read.values += 1;
                self.open.keep_part(What::Value, value);
                self.open.values.push(Labelled { label, value });
            }
            Addr::Feed if nature.is_machining() => {
                let value = self.reading().number(word.value, word.span)?;
                read.values += 1;
                self.open.keep_part(What::Feed, value);
            }
            Addr::Assign(q) => self.parameter(q, word, text)?,
            Addr::Feed | Addr::FeedMax if matches!(nature, CycleKind::Tilt) => {
                let label = if word.addr == Addr::Feed { "F" } else { "FMAX" }.to_owned();
                let value = self.reading().number_if(word.value, word.span)?.unwrap_or_default();
                self.open.values.push(Labelled { label, value });
            }
            Addr::Text => {
                let name = self.reading().program_name(strip_pgm(word.span.of(text)))?;
                self.open.program = Some(name);
            }
            // Words of cycles that are refused.
            _ => {}
        }
        Ok(())
    }

    /// A coordinate: of a machining cycle a part of its place, else what the cycle does to the axis.
    fn axis(&mut self, word: Word, nature: CycleKind, block: &Block) -> Outcome {
        let Addr::Axis { axis, incremental } = word.addr else { return Ok(()) };
        if nature.is_machining() {
            let value = self.reading().number(word.value, word.span)?;
            self.open.keep_part(What::Along(axis), value);
            return Ok(());
        }
        if matches!(nature, CycleKind::DatumShift | CycleKind::Mirror | CycleKind::AxisScaling)
            && self.open.axes.iter().any(|other| other.axis == axis)
        {
            return self.core.twice(word, block);
        }
        let value = self.reading().number_if(word.value, word.span)?;
        let loc = self.core.loc(word.span);
        self.open.axes.push(AxisValue { axis, incremental, value, loc });
        Ok(())
    }

    /// `8.1 XY`: letters written together name both axes.
    fn mirror_letters(&mut self, word: Word, block: &Block, text: &[u8]) -> Outcome {
        for letter in word.span.of(text).to_ascii_uppercase() {
            let axis = AxisSet::MAIN.iter().find(|axis| axis.letter() as u32 == u32::from(letter));
            let Some(axis) = axis else { return self.refuse_word(word.span) };
            if self.open.axes.iter().any(|other| other.axis == axis) {
                return self.core.twice(word, block);
            }
            let loc = self.core.loc(word.span);
            self.open.axes.push(AxisValue { axis, incremental: false, value: None, loc });
        }
        Ok(())
    }

    /// `Q200=+2`
    fn parameter(&mut self, q: QRef, word: Word, text: &[u8]) -> Outcome {
        let number = self.open.number;
        let takes = q.kind != QKind::Q || find(number).takes(number, q);
        if !takes && q.number < 100 && matches!(find(number).nature, CycleKind::Unknown) {
            return self
                .core
                .refuse(word.span, codes::P1003::in_definition_of_cycle(&self.core.word_text(word.span), &number, &q));
        }
        if !takes {
            return self.core.refuse(word.span, codes::P1003::cycle_has_no_parameter(&number, &q));
        }
        // FMAX, FAUTO, PREDEF: of use to machining cycles only.
        let named = match word.value {
            Value::FeedMax => Some("FMAX"),
            Value::FeedAuto => Some("FAUTO"),
            Value::None => Some(named_value(word.span.of(text))),
            _ => None,
        };
        if matches!(named, Some("FU" | "FZ"))
            && let Some(value) = number_behind(word.span.of(text))
        {
            self.core.reads_feed_by_word(word.span);
            self.open.feeds.push(WordFeed { parameter: q.number, per_tooth: named == Some("FZ"), value });
        }
        let value = match named {
            Some("PREDEF") => match self.globals.predefined(self.core, q, word.span)? {
                Given::Number(value) => value,
                Given::Word(named) => {
                    self.open.words.push((q.number, named));
                    return Ok(());
                }
            },
            Some(named) => {
                self.open.words.push((q.number, named));
                return Ok(());
            }
            None => self.reading().number(word.value, word.span)?,
        };
        self.vars.assign(self.core, q, Slot::Number(value), word.span)?;
        if q.kind == QKind::Q {
            self.open.parameters.push((q.number, value));
        }
        Ok(())
    }

    /// `ABST.2`: does the point end the name or begin the number?
    fn doubtful_point(&self, read: &Read, word: Word, text: &[u8]) -> Outcome {
        let Some((label, span)) = &read.label else { return Ok(()) };
        let exact = matches!(label.as_str(), "ROT" | "IROT" | "SCL" | "CCX" | "CCY" | "CCZ" | "T" | "TA");
        if exact || span.end != word.span.start || !word.span.of(text).starts_with(b".") {
            return Ok(());
        }
        let whole = span.to(word.span);
        self.core.refuse(whole, codes::P1003::in_point_may_belong_to_name(&self.core.word_text(whole)))
    }

    /// A word that the cycle does not take.
    fn refuse_word<T>(&self, span: Span) -> Outcome<T> {
        let (text, cycle) = (self.core.word_text(span), self.open.number);
        self.core.refuse(span, codes::P1003::has_no_place_in_cycle(&text, &cycle).help(find(cycle).form))
    }

    /// Does the definition under way take this word?
    fn takes(&self, nature: CycleKind, word: Word, read: &Read, text: &[u8]) -> bool {
        use CycleKind::*;
        let number = self.open.number;
        let valued = word.value != Value::None;
        let none = read.values == 0;
        let part = self.open.part;
        let drilling = if number < 20 { nature.drilling() } else { None };
        let feeds = drilling.and_then(|cycle| cycle.feed).is_some_and(|feed| part.map(Name::Part) == Some(feed));
        match (nature, word.addr) {
            // `HSC-MODE:1`
            (Tolerance, Addr::Colon) => read.label() == "HSC-MODE",
            (_, Addr::Colon) => false,
            (Drilling(_), Addr::Name | Addr::Value) if drilling.is_some() => none,
            (Drilling(_), Addr::Feed) if drilling.is_some() => none && read.label.is_none() && feeds,
            (Drilling(_), _) if drilling.is_some() => false,
            (Milling(_), _) if number < 20 => self.open.takes_in_old_pocket(word),
            (
                Drilling(_) | Milling(_) | Machining | Pattern(_) | Setting(_) | Data | Acting | Unknown | Preset,
                Addr::Assign(_) | Addr::AssignText(_),
            ) => true,
            // Refused, whatever they say.
            (Machining | Acting | Unknown, _) => true,
            // The name of cycle 14.
            (Setting(_), Addr::Name) => part == Some(0),
            (Data, Addr::Name | Addr::Value | Addr::Slash | Addr::Text) => true,
            (Tolerance, Addr::Name) => is_one_of(word, text, &["T", "HSC-MODE", "TA"]),
            (Tolerance, Addr::Value) => read.label.is_some(),
            (ProgramCall, Addr::Text) => true,
            (DatumShift, Addr::Axis { .. } | Addr::Hash) => read.label.is_none(),
            (DatumShift, Addr::Value) => read.label() == "#",
            (Mirror, Addr::Axis { incremental, .. }) => !valued && !incremental,
            (Mirror, Addr::Name) => true,
            (AxisScaling, Addr::Axis { incremental, .. }) => valued && !incremental && read.label.is_none(),
            (AxisScaling, Addr::Name) => read.label.is_none() && is_one_of(word, text, &["CCX", "CCY", "CCZ"]),
            (AxisScaling, Addr::Value) => read.label.is_some(),
            (Rotation, Addr::Name) => none && is_one_of(word, text, &["ROT", "IROT"]),
            (Scaling, Addr::Name) => none && is_one_of(word, text, &["SCL"]),
            (Rotation | Scaling, Addr::Value) => none && read.label.is_some(),
            // Their names are written in the language of the control.
            (Dwell | Orientation, Addr::Name | Addr::Value) => none && self.open.values.is_empty(),
            // A tilt is refused for its angles; its feed and distance belong to it.
            (Tilt, Addr::Axis { axis, .. }) => axis.is_rotary() && valued,
            (Tilt, Addr::Feed | Addr::FeedMax) => true,
            (Tilt, Addr::Name) => is_one_of(word, text, &["DIST", "ABST"]),
            (Tilt, Addr::Value) => read.label.is_some(),
            _ => false,
        }
    }
}

impl Open {
    /// Keeps what a part of an old machining cycle says.
    fn keep_part(&mut self, what: What, value: f64) {
        if let Some(part) = self.part {
            self.parts.push(DottedValue { part, what, value });
        }
    }

    /// Does the part of an old pocket take this word, and has it none yet?
    fn takes_in_old_pocket(&self, word: Word) -> bool {
        let Some(part) = self.part.filter(|part| *part > 0) else { return word.addr == Addr::Name };
        let what = match word.addr {
            Addr::Name => return true,
            Addr::Value => What::Value,
            Addr::Feed => What::Feed,
            Addr::TurnPlus | Addr::TurnMinus => What::Turn,
            Addr::Axis { axis, incremental: false } if word.value != Value::None => What::Along(axis),
            _ => return false,
        };
        let same = |a: What| std::mem::discriminant(&a) == std::mem::discriminant(&what);
        let again = self.parts.iter().any(|known| known.part == part && same(known.what));
        !again && find(self.number).takes_in_part(part, what)
    }

    /// The only value of a definition.
    pub fn single_value(&self, core: &Core<'_>) -> Outcome<f64> {
        match self.values.as_slice() {
            // Two values are refused where they are read.
            [only, ..] => Ok(only.value),
            [] => core.refuse(Where::Block, codes::K2402::cycle_lacks_its_value(&self.number)),
        }
    }

    /// What cycle 9 or 32 does. Without T the setting of the machine holds again for corners.
    pub fn function(&self, core: &Core<'_>, nature: CycleKind) -> Outcome<Function> {
        if matches!(nature, CycleKind::Dwell) {
            let seconds = self.single_value(core)?;
            if !(0.0..=3600.0).contains(&seconds) {
                return core.refuse(Where::Block, codes::P2090::dwell_of_s_is_out_of_range(&seconds));
            }
            return Ok(Function::Dwell(seconds));
        }
        if self.values.iter().any(|value| value.label != "T") {
            core.note(Where::Block, codes::K2703::hsc_mode());
        }
        let said = match self.values.iter().find(|value| value.label == "T").map(|value| value.value) {
            None => None,
            Some(t) if t > 0.0 => Some(PathControl::Within(t * core.mm())),
            // No deviation at all.
            Some(0.0) => Some(PathControl::Exact),
            Some(t) => return core.refuse(Where::Block, codes::P2090::tolerance(&t)),
        };
        Ok(Function::PathControl(said))
    }
}

/// The name behind the number of a cycle is decoration in any language; a value among it would be lost.
pub(super) fn check_title(core: &Core<'_>, number: u32, part: Option<u32>, block: &Block, text: &[u8]) -> Outcome {
    if part.is_none() || !find(number).nature.acts() {
        return Ok(());
    }
    let head = block.span.of(text);
    let name = head.iter().position(|b| *b == b'.').map_or(head.len(), |dot| dot + 2).min(head.len());
    let mut at = name;
    for word in head[name..].split(u8::is_ascii_whitespace) {
        if word.iter().any(u8::is_ascii_digit) {
            let span = Span::at(block.span.start + at as u32, word.len() as u32);
            return core.refuse(span, codes::P1003::stands_in_name_of_cycle(&core.word_text(span), &number));
        }
        at += word.len() + 1;
    }
    Ok(())
}

/// Is a name without a number a mistake here?
fn needs_its_value(nature: CycleKind, part: Option<u32>) -> bool {
    match nature {
        CycleKind::AxisScaling | CycleKind::Rotation | CycleKind::Scaling => true,
        CycleKind::Milling(_) => part.is_some_and(|part| part > 0),
        _ => false,
    }
}

fn is_one_of(word: Word, text: &[u8], names: &[&str]) -> bool {
    names.iter().any(|name| word.span.of(text).eq_ignore_ascii_case(name.as_bytes()))
}

/// What a word as the value of a parameter means: `Q206=AUTO` is FAUTO.
fn named_value(assignment: &[u8]) -> &'static str {
    let value = assignment.iter().position(|b| *b == b'=').map_or(assignment, |at| &assignment[at + 1..]);
    match value.trim_ascii() {
        word if word.eq_ignore_ascii_case(b"AUTO") => "FAUTO",
        word if word.eq_ignore_ascii_case(b"MAX") => "FMAX",
        word if word.eq_ignore_ascii_case(b"PREDEF") => "PREDEF",
        word if begins(word, b"FU") => "FU",
        word if begins(word, b"FZ") => "FZ",
        _ => "a word",
    }
}

/// The number in `Q206=FU0.2`.
fn number_behind(assignment: &[u8]) -> Option<f64> {
    let value = assignment.iter().position(|b| *b == b'=').map_or(assignment, |at| &assignment[at + 1..]);
    let number = value.trim_ascii().get(2..)?.trim_ascii();
    let number = number.strip_prefix(b"+").unwrap_or(number);
    let (value, len) = decimal(number, true)?;
    (len == number.len()).then_some(value)
}

fn begins(word: &[u8], head: &[u8]) -> bool {
    word.get(..head.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(head))
}

/// `PGM LOT31` without its keyword.
fn strip_pgm(text: &[u8]) -> &[u8] {
    match text.get(..3) {
        Some(head) if head.eq_ignore_ascii_case(b"PGM") => text[3..].trim_ascii(),
        _ => text,
    }
}
