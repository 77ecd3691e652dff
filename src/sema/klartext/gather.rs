//! Reading the words of a path block, each once.

use crate::diag::{Label, codes};
use crate::ir::Side;
use crate::lexer::klartext::Value;
use crate::parser::klartext::ast::{Addr, Block, Stmt, Word};
use crate::text::Span;

use super::m_table::{self, Args, M6};
use super::reading::Reading;
use super::words::{Admits, Comp, FeedWord, MOST_M, MWord, Words};
use super::{Outcome, Reported, Run};

impl<'a> Run<'a> {
    /// The words of the block in hand, which begins with `head`, in the box that goes from block to block.
    #[inline]
    pub(super) fn gather(&mut self, block: &Block, head: &str, admits: Admits) -> Outcome<Box<Words>> {
        let mut w = self.words.take().unwrap_or_default();
        w.clear();
        self.reading().words(&mut w, block, head, admits)?;
        Ok(w)
    }

    /// What the block in hand reads.
    #[inline]
    pub(super) fn reading(&self) -> Reading<'_, 'a> {
        Reading { core: &self.core, vars: &self.vars, st: &self.st }
    }
}

impl Reading<'_, '_> {
    /// Reads the words of the block in hand, which begins with `head`, into `w`.
    pub fn words(self, w: &mut Words, block: &Block, head: &str, admits: Admits) -> Outcome {
        let mm = self.core.mm();
        let mut at = 0;
        while let Some(&word) = block.words.get(at) {
            at += 1;
            match word.addr {
                Addr::Axis { axis, incremental } if admits.has(Admits::AXES) => {
                    let value = self.number(word.value, word.span)?;
                    if w.axes.known().contains(axis) {
                        return self.core.twice(word, block);
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
                        return self.core.twice(word, block);
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
                _ if admits.takes(&word) => self.rare_word(word, head, admits, mm, w, block)?,
                _ => return self.core.not_admitted(word, head),
            }
        }
        if w.m.len() > 1 {
            self.check_m_conflicts(w, block)?;
        }
        Ok(())
    }

    /// The words that CAM programs hardly use.
    fn rare_word(self, word: Word, head: &str, admits: Admits, mm: f64, w: &mut Words, block: &Block) -> Outcome {
        let number = || self.number(word.value, word.span);
        let mut side = |comp: Comp| {
            w.comp_span = word.span;
            w.comp.replace(comp).is_some()
        };
        let again = match word.addr {
            Addr::PolarRadius { incremental } => {
                w.polar_radius_span = word.span;
                w.polar_radius.replace((number()? * mm, incremental)).is_some()
            }
            Addr::PolarAngle { incremental } => {
                w.polar_angle_span = word.span;
                w.polar_angle.replace((number()?, incremental)).is_some()
            }
            // R0 without a sign is compensation, everything else a radius.
            Addr::Radius { signed: false } if word.value == Value::Number(0.0) && admits.has(Admits::COMP) => {
                side(Comp::Side(Side::None))
            }
            Addr::Radius { .. } => {
                w.radius_span = word.span;
                w.radius.replace(number()? * mm).is_some() || w.number.is_some()
            }
            Addr::CompLeft => side(Comp::Side(Side::Left)),
            Addr::CompRight => side(Comp::Side(Side::Right)),
            Addr::ParaxialPlus | Addr::ParaxialMinus => side(Comp::Paraxial(word.addr == Addr::ParaxialPlus)),
            Addr::TurnPlus | Addr::TurnMinus => w.turn.replace(word.addr == Addr::TurnPlus).is_some(),
            Addr::Speed => {
                w.speed_span = word.span;
                w.speed.replace(number()?).is_some()
            }
            Addr::Value => w.number.replace(number()?).is_some() || w.radius.is_some(),
            _ => return self.core.not_admitted(word, head),
        };
        if again { self.core.twice(word, block) } else { Ok(()) }
    }

    fn feed_word(self, word: Word, mm: f64) -> Outcome<FeedWord> {
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
                self.core.counts_teeth(word)?;
                let value = self.number(word.value, word.span)?;
                FeedWord::PerTooth(value * mm)
            }
        })
    }

    /// The arguments of an M function, and how many words they took. `w` holds the words in front of it.
    fn m_arguments(self, number: u32, span: Span, words: &[Word], block: &Block, w: &Words) -> Outcome<(Args, usize)> {
        let takes = m_table::takes(number);
        let mut args = Args::default();
        let mm = self.core.mm();
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
                Addr::DeltaLength if number == 197 && args.value.is_none() => {
                    args.value = Some(self.number(word.value, word.span)?)
                }
                Addr::Name if takes.named || takes.retract => {
                    let name = self.core.word_text(word.span);
                    match words.get(at + 1) {
                        _ if name.eq_ignore_ascii_case("MAX") && takes.retract => {
                            args.max = true;
                            args.given = true;
                        }
                        Some(_) if !m_table::takes_name(number, &name) => {
                            let wanted = m_table::usual_words(number);
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
    fn check_m_value(self, number: u32, word: Word, block: &Block, w: &Words) -> Outcome {
        let Addr::Axis { axis, incremental } = word.addr else { return Ok(()) };
        let text = self.core.word_text(word.span);
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
    fn check_m_conflicts(self, w: &Words, block: &Block) -> Outcome {
        for (i, a) in w.m().iter().enumerate() {
            for b in &w.m()[i + 1..] {
                if a.number == b.number {
                    return self.core.twice(Word { addr: Addr::M(b.number), value: Value::None, span: b.span }, block);
                }
                if m_table::conflict(a.number, b.number) {
                    self.core.report(
                        codes::P1005::m_contradicts_m(&b.number, &a.number)
                            .at(self.core.loc(b.span))
                            .also(self.core.loc(a.span), Label::OtherOne),
                    );
                    return Err(Reported);
                }
            }
        }
        Ok(())
    }
}
