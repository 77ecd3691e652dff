//! The words of a path block, evaluated once and sorted by what they mean.

use crate::diag::{Diagnostic, codes};
use crate::ir::{Pos, Side};
use crate::lexer::klartext::Value;
use crate::machine::{Axis, AxisSet};
use crate::parser::klartext::ast::{Addr, Block, Word};
use crate::text::{Span, decode::readable};

use super::mfunc::{self, Args};
use super::{Outcome, Run};

/// Which words a head admits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Admits(u16);

impl Admits {
    pub const AXES: Admits = Admits(1);
    pub const POLAR: Admits = Admits(2);
    /// A radius word with a value.
    pub const RADIUS: Admits = Admits(4);
    pub const TURN: Admits = Admits(8);
    /// R0, RL, RR.
    pub const COMP: Admits = Admits(16);
    /// R+, R-.
    pub const PARAXIAL: Admits = Admits(32);
    pub const FEED: Admits = Admits(64);
    pub const M: Admits = Admits(128);
    /// A number without address.
    pub const NUMBER: Admits = Admits(256);
    pub const SPEED: Admits = Admits(512);

    pub const fn and(self, other: Admits) -> Admits {
        Admits(self.0 | other.0)
    }

    fn has(self, other: Admits) -> bool {
        self.0 & other.0 != 0
    }
}

/// What a block says about radius compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Comp {
    Side(Side),
    /// R+ (true) or R-.
    Paraxial(bool),
}

/// What a block says about the feed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum FeedWord {
    #[default]
    None,
    /// As written, in the unit of the control.
    Value(f64),
    Max,
    Auto,
    PerRevolution(f64),
}

/// An M function with what it takes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct MWord {
    pub number: u32,
    pub span: Span,
    pub args: Args,
}

/// Most M functions of a block.
const MOST_M: usize = 8;

/// The evaluated words; lengths in mm, angles in degrees. Kept in a box that goes from block to block.
#[derive(Debug, Clone, Default)]
pub(super) struct Words {
    /// Value of each axis word, absolute or incremental.
    pub axes: Pos,
    pub incremental: AxisSet,
    /// From the first axis word to the last.
    pub axes_span: Span,
    /// Value, incremental.
    pub polar_radius: Option<(f64, bool)>,
    pub polar_angle: Option<(f64, bool)>,
    pub radius: Option<f64>,
    pub radius_span: Span,
    /// Counter-clockwise.
    pub turn: Option<bool>,
    pub comp: Option<Comp>,
    pub comp_span: Span,
    pub feed: FeedWord,
    pub feed_span: Span,
    pub speed: Option<f64>,
    pub number: Option<f64>,
    m: Vec<MWord>,
}

impl Words {
    fn clear(&mut self) {
        self.axes.clear();
        self.incremental = AxisSet::EMPTY;
        self.axes_span = Span::default();
        self.polar_radius = None;
        self.polar_angle = None;
        self.radius = None;
        self.turn = None;
        self.comp = None;
        self.feed = FeedWord::None;
        self.speed = None;
        self.number = None;
        self.m.clear();
    }

    pub fn m(&self) -> &[MWord] {
        &self.m
    }

    pub fn has_m(&self, number: u32) -> bool {
        self.m().iter().any(|m| m.number == number)
    }
}

impl Run<'_> {
    /// Evaluates the words of the current block, which begins with `head`.
    #[inline]
    pub(super) fn gather(&mut self, block: &Block, head: &str, admits: Admits) -> Outcome<Box<Words>> {
        let mut w = self.words.take().unwrap_or_default();
        w.clear();
        self.gather_into(&mut w, block, head, admits)?;
        Ok(w)
    }

    /// Gives the box back.
    #[inline]
    pub(super) fn put_back(&mut self, w: Box<Words>) {
        self.words = Some(w);
    }

    fn gather_into(&mut self, w: &mut Words, block: &Block, head: &str, admits: Admits) -> Outcome {
        let mm = self.level().unit.mm();
        let mut at = 0;
        while let Some(&word) = block.words.get(at) {
            at += 1;
            match word.addr {
                Addr::Axis { axis, incremental } if admits.has(Admits::AXES) => {
                    let value = self.number(word.value, word.span)?;
                    if w.axes.known().contains(axis) {
                        return self.twice(word.span);
                    }
                    w.axes.set(axis, if axis.is_rotary() { value } else { value * mm });
                    if incremental {
                        w.incremental.insert(axis);
                    }
                    w.axes_span = if w.axes_span.is_empty() { word.span } else { w.axes_span.to(word.span) };
                }
                Addr::Feed | Addr::FeedMax | Addr::FeedAuto | Addr::FeedPerRev | Addr::FeedOther
                    if admits.has(Admits::FEED) =>
                {
                    if w.feed != FeedWord::None {
                        return self.twice(word.span);
                    }
                    w.feed = self.feed_word(word, mm)?;
                    w.feed_span = word.span;
                }
                Addr::M(number) if admits.has(Admits::M) => {
                    let (args, used) = self.m_arguments(number, word.span, &block.words[at..])?;
                    at += used;
                    if w.m.len() == MOST_M {
                        return self.fail(codes::K1005, word.span, "too many M functions in one block");
                    }
                    w.m.push(MWord { number, span: word.span, args });
                }
                // Empty words of old listings mean "unchanged".
                Addr::FeedEmpty | Addr::MEmpty | Addr::RadiusEmpty => {}
                _ => self.rare_word(word, head, admits, mm, w)?,
            }
        }
        if w.m.len() > 1 {
            self.check_m_conflicts(w)?;
        }
        Ok(())
    }

    /// The words that CAM programs hardly use.
    fn rare_word(&mut self, word: Word, head: &str, admits: Admits, mm: f64, w: &mut Words) -> Outcome {
        match word.addr {
            Addr::PolarRadius { incremental } if admits.has(Admits::POLAR) => {
                let value = self.number(word.value, word.span)?;
                if w.polar_radius.replace((value * mm, incremental)).is_some() {
                    return self.twice(word.span);
                }
            }
            Addr::PolarAngle { incremental } if admits.has(Admits::POLAR) => {
                let value = self.number(word.value, word.span)?;
                if w.polar_angle.replace((value, incremental)).is_some() {
                    return self.twice(word.span);
                }
            }
            // R0 without a sign is compensation, everything else a radius.
            Addr::Radius { signed: false } if word.value == Value::Number(0.0) && admits.has(Admits::COMP) => {
                self.comp_word(w, Comp::Side(Side::None), word.span)?;
            }
            Addr::Radius { .. } if admits.has(Admits::RADIUS) => {
                let value = self.number(word.value, word.span)?;
                if w.radius.replace(value * mm).is_some() {
                    return self.twice(word.span);
                }
                w.radius_span = word.span;
            }
            Addr::CompLeft if admits.has(Admits::COMP) => self.comp_word(w, Comp::Side(Side::Left), word.span)?,
            Addr::CompRight if admits.has(Admits::COMP) => self.comp_word(w, Comp::Side(Side::Right), word.span)?,
            Addr::ParaxialPlus if admits.has(Admits::PARAXIAL) => self.comp_word(w, Comp::Paraxial(true), word.span)?,
            Addr::ParaxialMinus if admits.has(Admits::PARAXIAL) => {
                self.comp_word(w, Comp::Paraxial(false), word.span)?
            }
            Addr::TurnPlus | Addr::TurnMinus if admits.has(Admits::TURN) => {
                if w.turn.replace(word.addr == Addr::TurnPlus).is_some() {
                    return self.twice(word.span);
                }
            }
            Addr::Speed if admits.has(Admits::SPEED) => {
                let value = self.number(word.value, word.span)?;
                if w.speed.replace(value).is_some() {
                    return self.twice(word.span);
                }
            }
            Addr::Value if admits.has(Admits::NUMBER) => {
                let value = self.number(word.value, word.span)?;
                if w.number.replace(value).is_some() {
                    return self.twice(word.span);
                }
            }
            _ => return self.not_admitted(word, head),
        }
        Ok(())
    }

    fn comp_word(&mut self, w: &mut Words, comp: Comp, span: Span) -> Outcome {
        if w.comp.replace(comp).is_some() {
            return self.twice(span);
        }
        w.comp_span = span;
        Ok(())
    }

    fn feed_word(&mut self, word: Word, mm: f64) -> Outcome<FeedWord> {
        Ok(match word.addr {
            Addr::Feed => {
                let value = self.number(word.value, word.span)?;
                FeedWord::Value(value)
            }
            Addr::FeedMax => FeedWord::Max,
            Addr::FeedAuto => FeedWord::Auto,
            Addr::FeedPerRev => {
                let value = self.number(word.value, word.span)?;
                FeedWord::PerRevolution(value * mm)
            }
            _ => {
                return self.fail_help(
                    codes::K9013,
                    word.span,
                    "feed per tooth or by time is not supported",
                    "program the feed in mm/min or, with FU, in mm/rev",
                );
            }
        })
    }

    #[cold]
    fn twice<T>(&self, span: Span) -> Outcome<T> {
        let word = self.word_text(span);
        self.fail_help(codes::K1004, span, format!("`{word}` repeats a word of this block"), "remove one of the two")
    }

    #[cold]
    pub(super) fn not_admitted<T>(&self, word: Word, head: &str) -> Outcome<T> {
        let text = self.word_text(word.span);
        let help = match (word.addr, head) {
            (Addr::Axis { .. }, "CP") => "CP takes the angle PA or IPA, and the axes outside the plane",
            (Addr::PolarRadius { .. }, "CP") => "the radius of CP is the distance from the pole",
            (Addr::Radius { .. }, "L" | "C" | "CT" | "LP" | "CP" | "CTP") => {
                "only CR takes a radius; compensation is R0, RL or RR"
            }
            _ => "remove the word, or put it into a block where it belongs",
        };
        let block = if head.is_empty() { "this block".to_owned() } else { format!("this {head} block") };
        self.fail_help(codes::K1005, word.span, format!("`{text}` has no place in {block}"), help)
    }

    /// A word as the programmer wrote it.
    pub(super) fn word_text(&self, span: Span) -> String {
        let loc = self.loc(span);
        readable(&self.job.sources.bytes(loc.file, loc.span)).into_owned()
    }

    /// The arguments of an M function, and how many words they took.
    fn m_arguments(&mut self, number: u32, span: Span, words: &[Word]) -> Outcome<(Args, usize)> {
        let takes = mfunc::takes(number);
        let mut args = Args::default();
        let mm = self.level().unit.mm();
        let mut at = 0;
        while let Some(&word) = words.get(at) {
            match word.addr {
                Addr::Feed if takes.feed && args.feed.is_none() => {
                    args.feed = Some(self.number(word.value, word.span)?)
                }
                Addr::FeedMax if takes.retract && args.given => args.feed_max = true,
                Addr::Axis { axis, .. } if takes.axes => {
                    args.axes.insert(axis);
                    args.given |= self.number_if(word.value, word.span)?.is_some();
                }
                Addr::DeltaLength if takes.named => args.value = Some(self.number(word.value, word.span)?),
                Addr::Name if takes.named || takes.retract => {
                    let name = self.word_text(word.span);
                    match words.get(at + 1) {
                        _ if name.eq_ignore_ascii_case("MAX") && takes.retract => {
                            args.max = true;
                            args.given = true;
                        }
                        Some(value) if value.addr == Addr::Value => {
                            let scale = if name.eq_ignore_ascii_case("MB") { mm } else { 1.0 };
                            args.value = Some(self.number(value.value, value.span)? * scale);
                            args.given = true;
                            at += 1;
                        }
                        Some(next) if next.addr == Addr::Name && takes.retract => {}
                        _ => {
                            return self.fail(
                                codes::K2707,
                                word.span,
                                format!("`{name}` of M{number} lacks its value"),
                            );
                        }
                    }
                }
                _ => break,
            }
            at += 1;
        }
        if takes.retract && !args.given {
            return self.fail_help(
                codes::K2707,
                span,
                format!("M{number} lacks its path"),
                "write `M140 MB 50` or `M140 MB MAX`",
            );
        }
        Ok((args, at))
    }

    /// M3 with M4, M8 with M9 and the like.
    fn check_m_conflicts(&self, w: &Words) -> Outcome {
        for (i, a) in w.m().iter().enumerate() {
            for b in &w.m()[i + 1..] {
                if a.number == b.number {
                    return self.twice(b.span);
                }
                if mfunc::conflict(a.number, b.number) {
                    self.report(
                        Diagnostic::new(
                            codes::K1014,
                            self.loc(b.span),
                            format!("M{} contradicts M{}", b.number, a.number),
                        )
                        .also(self.loc(a.span), "the other one")
                        .help("keep one of them, or put them into two blocks"),
                    );
                    return Err(super::Reported);
                }
            }
        }
        Ok(())
    }

    /// Turns an axis value into an absolute one. `None` for axes that the block does not name.
    pub(super) fn absolute(&mut self, w: &Words) -> Outcome<Pos> {
        if w.incremental.is_empty() {
            return Ok(w.axes);
        }
        let mut end = w.axes;
        for axis in w.incremental.iter() {
            let from = self.position_of(axis, w.axes_span, "an incremental word")?;
            end.set(axis, from + w.axes.get(axis).unwrap_or(0.0));
        }
        Ok(end)
    }

    /// Programmed position of an axis; an error where it is not known.
    pub(super) fn position_of(&mut self, axis: Axis, span: Span, what: &str) -> Outcome<f64> {
        if let Some(value) = self.st.pos.get(axis) {
            return Ok(value);
        }
        if self.st.lost.contains(axis) {
            return Err(super::Reported);
        }
        self.fail_help(
            codes::K2001,
            span,
            format!("{what} needs the position of {}, which is not known here", axis.letter()),
            &format!("program an absolute position of {} first", axis.letter()),
        )
    }
}
