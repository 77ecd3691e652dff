//! The words of a path block, evaluated once and sorted by what they mean.

use crate::diag::{Label, codes};
use crate::ir::{Pos, Side};
use crate::lexer::klartext::Value;
use crate::machine::{Axis, AxisSet};
use crate::parser::klartext::ast::{Addr, Block, Stmt, Word};
use crate::parser::klartext::misprinted;
use crate::parser::problem::Problem;
use crate::text::{Span, decode::readable};

use super::m_table::{self, Args, M6};
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

    /// A path block.
    pub const PATH: Admits = Admits::AXES.and(Admits::COMP).and(Admits::FEED).and(Admits::M).and(Admits::SPEED);

    pub const fn and(self, other: Admits) -> Admits {
        Admits(self.0 | other.0)
    }

    fn has(self, other: Admits) -> bool {
        self.0 & other.0 != 0
    }

    /// Does a block with these words take `word`?
    pub fn takes(self, word: &Word) -> bool {
        match word.addr {
            Addr::Axis { .. } => self.has(Admits::AXES),
            Addr::Feed | Addr::FeedMax | Addr::FeedAuto | Addr::FeedPerRev | Addr::FeedOther => self.has(Admits::FEED),
            Addr::M(_) => self.has(Admits::M),
            Addr::FeedEmpty | Addr::MEmpty | Addr::RadiusEmpty => true,
            Addr::PolarRadius { .. } | Addr::PolarAngle { .. } => self.has(Admits::POLAR),
            Addr::Radius { signed: false } if word.value == Value::Number(0.0) => {
                self.has(Admits::COMP) || self.has(Admits::RADIUS)
            }
            Addr::Radius { .. } => self.has(Admits::RADIUS),
            Addr::CompLeft | Addr::CompRight => self.has(Admits::COMP),
            Addr::ParaxialPlus | Addr::ParaxialMinus => self.has(Admits::PARAXIAL),
            Addr::TurnPlus | Addr::TurnMinus => self.has(Admits::TURN),
            Addr::Speed => self.has(Admits::SPEED),
            Addr::Value => self.has(Admits::NUMBER),
            _ => false,
        }
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
    PerTooth(f64),
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
    pub polar_radius_span: Span,
    pub polar_angle: Option<(f64, bool)>,
    pub polar_angle_span: Span,
    pub radius: Option<f64>,
    pub radius_span: Span,
    /// Counter-clockwise.
    pub turn: Option<bool>,
    pub comp: Option<Comp>,
    pub comp_span: Span,
    pub feed: FeedWord,
    pub feed_span: Span,
    pub speed: Option<f64>,
    pub speed_span: Span,
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

    /// The first of these M functions in the block.
    pub fn any_m(&self, numbers: &[u32]) -> Option<&MWord> {
        self.m().iter().find(|m| numbers.contains(&m.number))
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
        let mm = self.core.level().frame.unit.mm();
        let mut at = 0;
        while let Some(&word) = block.words.get(at) {
            at += 1;
            match word.addr {
                Addr::Axis { axis, incremental } if admits.has(Admits::AXES) => {
                    let value = self.number(word.value, word.span)?;
                    if w.axes.known().contains(axis) {
                        return self.twice(word, block);
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
                        return self.twice(word, block);
                    }
                    w.feed = self.feed_word(word, mm)?;
                    w.feed_span = word.span;
                }
                Addr::M(number) if admits.has(Admits::M) => {
                    let (args, used) = self.m_arguments(number, word.span, &block.words[at..], block, w)?;
                    at += used;
                    if w.m.len() == MOST_M {
                        return self.core.refuse(word.span, codes::P1003::too_many_m_functions_in_one_block());
                    }
                    let changes = m_table::entry(number).is_none()
                        && self.core.job.settings.control.tool_change_m.contains(&number);
                    w.m.push(MWord { number: if changes { M6 } else { number }, span: word.span, args });
                }
                // Empty words of old listings mean "unchanged".
                Addr::FeedEmpty | Addr::MEmpty | Addr::RadiusEmpty => {}
                _ => self.rare_word(word, head, admits, mm, w, block)?,
            }
        }
        if w.m.len() > 1 {
            self.check_m_conflicts(w, block)?;
        }
        Ok(())
    }

    /// The words that CAM programs hardly use.
    fn rare_word(&mut self, word: Word, head: &str, admits: Admits, mm: f64, w: &mut Words, block: &Block) -> Outcome {
        match word.addr {
            Addr::PolarRadius { incremental } if admits.has(Admits::POLAR) => {
                let value = self.number(word.value, word.span)?;
                if w.polar_radius.replace((value * mm, incremental)).is_some() {
                    return self.twice(word, block);
                }
                w.polar_radius_span = word.span;
            }
            Addr::PolarAngle { incremental } if admits.has(Admits::POLAR) => {
                let value = self.number(word.value, word.span)?;
                if w.polar_angle.replace((value, incremental)).is_some() {
                    return self.twice(word, block);
                }
                w.polar_angle_span = word.span;
            }
            // R0 without a sign is compensation, everything else a radius.
            Addr::Radius { signed: false } if word.value == Value::Number(0.0) && admits.has(Admits::COMP) => {
                self.comp_word(w, Comp::Side(Side::None), word, block)?;
            }
            Addr::Radius { .. } if admits.has(Admits::RADIUS) => {
                let value = self.number(word.value, word.span)?;
                if w.radius.replace(value * mm).is_some() || w.number.is_some() {
                    return self.twice(word, block);
                }
                w.radius_span = word.span;
            }
            Addr::CompLeft if admits.has(Admits::COMP) => self.comp_word(w, Comp::Side(Side::Left), word, block)?,
            Addr::CompRight if admits.has(Admits::COMP) => self.comp_word(w, Comp::Side(Side::Right), word, block)?,
            Addr::ParaxialPlus | Addr::ParaxialMinus if admits.has(Admits::PARAXIAL) => {
                self.comp_word(w, Comp::Paraxial(word.addr == Addr::ParaxialPlus), word, block)?;
            }
            Addr::TurnPlus | Addr::TurnMinus if admits.has(Admits::TURN) => {
                if w.turn.replace(word.addr == Addr::TurnPlus).is_some() {
                    return self.twice(word, block);
                }
            }
            Addr::Speed if admits.has(Admits::SPEED) => {
                let value = self.number(word.value, word.span)?;
                if w.speed.replace(value).is_some() {
                    return self.twice(word, block);
                }
                w.speed_span = word.span;
            }
            Addr::Value if admits.has(Admits::NUMBER) => {
                let value = self.number(word.value, word.span)?;
                if w.number.replace(value).is_some() || w.radius.is_some() {
                    return self.twice(word, block);
                }
            }
            _ => return self.not_admitted(word, head),
        }
        Ok(())
    }

    fn comp_word(&mut self, w: &mut Words, comp: Comp, word: Word, block: &Block) -> Outcome {
        if w.comp.replace(comp).is_some() {
            return self.twice(word, block);
        }
        w.comp_span = word.span;
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
            _ if self.counts_teeth(word) => {
                let value = self.number(word.value, word.span)?;
                FeedWord::PerTooth(value * mm)
            }
            _ => return self.feed_by_time(word),
        })
    }

    /// Is this FZ, and not FT or FMAXT?
    pub(super) fn counts_teeth(&self, word: Word) -> bool {
        self.word_text(word.span).to_ascii_uppercase().starts_with("FZ")
    }

    #[cold]
    pub(super) fn feed_by_time<T>(&self, word: Word) -> Outcome<T> {
        self.core.refuse(word.span, codes::K9013::gives_time_of_block_in_place(&self.word_text(word.span)))
    }

    /// `word` says again what an earlier word of the block says.
    #[cold]
    pub(super) fn twice<T>(&self, word: Word, block: &Block) -> Outcome<T> {
        let text = self.word_text(word.span);
        let found = codes::P1002::repeats_word_of_this_block(&text).at(self.core.loc(word.span));
        let first = block.words.iter().find(|first| same_matter(first.addr, word.addr));
        let found = match first.filter(|first| first.span.start < word.span.start) {
            Some(first) => found.also(self.core.loc(first.span), Label::FirstOne),
            None => found,
        };
        self.core.report(found);
        Err(super::Reported)
    }

    #[cold]
    pub(super) fn not_admitted<T>(&self, word: Word, head: &str) -> Outcome<T> {
        let text = self.word_text(word.span);
        if let Some(problem) = self.misprinted_word(word.span) {
            self.core.report_problem(problem);
            return Err(super::Reported);
        }
        let help = match (word.addr, head) {
            (Addr::Axis { .. }, "CP") => "CP takes the angle PA or IPA, and the axes outside the plane",
            (Addr::PolarRadius { .. }, "CP") => "the radius of CP is the distance from the pole",
            (Addr::Radius { .. }, "L" | "C" | "CT" | "LP" | "CP" | "CTP") => {
                "only CR takes a radius; compensation is R0, RL or RR"
            }
            (Addr::M(_), "RND" | "CHF") => "write the M function into a block before the corner or after it",
            _ => "remove the word, or put it into a block where it belongs",
        };
        let block = if head.is_empty() { "this block".to_owned() } else { format!("this {head} block") };
        self.core.refuse(word.span, codes::P1003::has_no_place(&text, &block).help(help))
    }

    /// What is wrong with the number that a word belongs to: `X-1.#IND`, `X1e5`.
    fn misprinted_word(&self, span: Span) -> Option<Problem> {
        let block = self.core.block_span();
        let text = self.word_text(block);
        // Decoded text is as long as its bytes where a number stands in it.
        let at = span.start.checked_sub(block.start)?;
        let mut problem = misprinted(text.as_bytes(), Span::at(at, span.end - span.start))?;
        problem.span = Span { start: problem.span.start + block.start, end: problem.span.end + block.start };
        Some(problem)
    }

    /// A word as the programmer wrote it.
    pub(super) fn word_text(&self, span: Span) -> String {
        let loc = self.core.loc(span);
        readable(&self.core.job.sources.bytes(loc.file, loc.span)).into_owned()
    }

    /// The arguments of an M function, and how many words they took. `w` holds the words in front of it.
    fn m_arguments(
        &mut self,
        number: u32,
        span: Span,
        words: &[Word],
        block: &Block,
        w: &Words,
    ) -> Outcome<(Args, usize)> {
        let takes = m_table::takes(number);
        let mut args = Args::default();
        let mm = self.core.level().frame.unit.mm();
        let mut at = 0;
        while let Some(&word) = words.get(at) {
            match word.addr {
                Addr::Feed if takes.feed && args.feed.is_none() => {
                    args.feed = Some(self.number(word.value, word.span)?)
                }
                Addr::FeedMax if takes.retract && args.given => args.feed_max = true,
                // A letter alone names an axis; with a value it is where the block goes.
                Addr::Axis { axis, incremental: false } if takes.letters && word.value == Value::None => {
                    args.axes.insert(axis);
                }
                Addr::Axis { axis, .. } if takes.values.contains(axis) => {
                    self.check_m_value(number, word, block, w)?;
                    args.given |= self.number_if(word.value, word.span)?.is_some();
                }
                Addr::DeltaLength if number == 197 => args.value = Some(self.number(word.value, word.span)?),
                Addr::Name if takes.named || takes.retract => {
                    let name = self.word_text(word.span);
                    match words.get(at + 1) {
                        _ if name.eq_ignore_ascii_case("MAX") && takes.retract => {
                            args.max = true;
                            args.given = true;
                        }
                        Some(_) if number == 197 || number == 120 && !name.eq_ignore_ascii_case("LA") => {
                            let wanted = if number == 120 { "LA5" } else { "DL0.5" };
                            return self
                                .core
                                .refuse(word.span, codes::K2707::does_not_belong_to_m(&name, &number, &wanted));
                        }
                        Some(value) if value.addr == Addr::Value => {
                            let scale = if name.eq_ignore_ascii_case("MB") { mm } else { 1.0 };
                            args.value = Some(self.number(value.value, value.span)? * scale);
                            args.given = true;
                            at += 1;
                        }
                        Some(next) if next.addr == Addr::Name && takes.retract => {}
                        _ => {
                            return self.core.refuse(word.span, codes::K2707::of_m_lacks_its_value(&name, &number));
                        }
                    }
                }
                _ => break,
            }
            at += 1;
        }
        if takes.retract && !args.given {
            return self.core.refuse(span, codes::K2707::m_lacks_its_path(&number));
        }
        Ok((args, at))
    }

    /// Behind M118 and M112 an axis word is a size, behind everything else the place to go to. Refuses what may
    /// be either: the control itself writes the place in front, with a sign, and the size without one.
    fn check_m_value(&mut self, number: u32, word: Word, block: &Block, w: &Words) -> Outcome {
        let Addr::Axis { axis, incremental } = word.addr else { return Ok(()) };
        let text = self.word_text(word.span);
        let signed = incremental || text.contains(['+', '-']);
        let alone = block.stmt == Stmt::Functions;
        let clear = match number {
            // `M112 T0.01 A10`
            112 => !signed,
            _ => alone || w.axes.known().contains(axis) || (!signed && !w.axes.known().is_empty()),
        };
        if clear {
            return Ok(());
        }
        self.core.refuse(word.span, codes::K2707::behind_m_may_belong(&text, &number))
    }

    /// M3 with M4, M8 with M9 and the like.
    fn check_m_conflicts(&self, w: &Words, block: &Block) -> Outcome {
        for (i, a) in w.m().iter().enumerate() {
            for b in &w.m()[i + 1..] {
                if a.number == b.number {
                    return self.twice(Word { addr: Addr::M(b.number), value: Value::None, span: b.span }, block);
                }
                if m_table::conflict(a.number, b.number) {
                    self.core.report(
                        codes::P1005::m_contradicts_m(&b.number, &a.number)
                            .at(self.core.loc(b.span))
                            .also(self.core.loc(a.span), Label::OtherOne),
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
        if let Some(value) = self.st.position.programmed(axis) {
            return Ok(value);
        }
        if self.st.position.is_lost(axis) {
            return Err(super::Reported);
        }
        self.unknown_position(axis, span, |axis, why| codes::P2001::needs_position_of(&what, axis, why))
    }
}

/// Do the two addresses exclude each other in one block?
pub(super) fn same_matter(a: Addr, b: Addr) -> bool {
    use Addr::*;
    match (a, b) {
        (Axis { axis: a, .. }, Axis { axis: b, .. }) => a == b,
        (PolarRadius { .. }, PolarRadius { .. }) | (PolarAngle { .. }, PolarAngle { .. }) => true,
        (Feed | FeedMax | FeedAuto | FeedPerRev | FeedOther, Feed | FeedMax | FeedAuto | FeedPerRev | FeedOther) => {
            true
        }
        (TurnPlus | TurnMinus, TurnPlus | TurnMinus) => true,
        (
            Radius { .. } | Value | CompLeft | CompRight | ParaxialPlus | ParaxialMinus,
            Radius { .. } | Value | CompLeft | CompRight | ParaxialPlus | ParaxialMinus,
        ) => true,
        (a, b) => a == b,
    }
}
