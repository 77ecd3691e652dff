//! Couplings, curve tables and oscillation: left out where the axis that they move is none of the output's.
//!
//! Comes in: the words and their arguments. Goes out: a warning, or an error. The axis that follows, or swings, is looked at first:
//! where it is printed, or where a spindle follows, nothing takes the word away.
//!
//! Source: S 6 (docs/sources.md). The blocks between CTABDEF and CTABEND describe a table and move nothing; after it the
//! state of the program is that of before.

use crate::diag::{Answer, Label, codes};
use crate::machine::AxisSet;
use crate::parser::sinumerik::ast::{Base, Block, Formula, Op, Stmt, Target, Value, Word};
use crate::sema::common::hidden::By;
use crate::text::{Loc, Span};

use super::value::Val;
use super::vocabulary::{Indexed, Meaning};
use super::words::{CallWord, Words};
use super::{Outcome, Reported, Run};

/// What stands beside the path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beside {
    /// Its first argument follows.
    Couples,
    /// All its arguments follow.
    CouplesAll,
    /// All but its last argument follow.
    CouplesAllButLast,
    /// Ends, deletes or locks a coupling or table.
    Ends,
    /// Begins a curve table, whose first argument follows.
    Table,
    /// Ends it.
    TableEnds,
    /// `OSP1[U]=`: the axis in brackets swings.
    Oscillates,
}

const WORDS: &[(Beside, &str)] = &[
    (Beside::Couples, "TRAILON LEADON COUPDEF COUPON COUPONC COUPRES EGDEF EGON EGONSYN EGONSYNE TANG TANGON TLIFT"),
    (Beside::CouplesAll, "MASLON"),
    (Beside::CouplesAllButLast, "MASLDEF"),
    (
        Beside::Ends,
        "TRAILOF LEADOF COUPOF COUPOFS COUPDEL EGOFS EGOFC EGDEL TANGOF TANGDEL MASLOF MASLOFS MASLDEL CTABDEL CTABLOCK CTABUNLOCK",
    ),
    (Beside::Table, "CTABDEF"),
    (Beside::TableEnds, "CTABEND"),
    (Beside::Oscillates, "OS OSCILL OSP1 OSP2 OST1 OST2 OSCTRL OSNSC OSE OSB"),
];

impl Beside {
    pub fn find(name: &str) -> Option<Beside> {
        let has = |names: &str| names.split(' ').any(|known| known == name);
        WORDS.iter().find(|(_, names)| has(names)).map(|(beside, _)| *beside)
    }

    /// The key that leaves it out.
    fn key(self) -> &'static str {
        if self == Beside::Oscillates { "oscillation" } else { "couplings" }
    }

    pub fn is_left_out(self, settings: &crate::machine::Settings) -> bool {
        let beside = settings.control.sinumerik.beside;
        if self == Beside::Oscillates { beside.oscillation } else { beside.couplings }
    }
}

/// What to do about an axis that the output has.
const STANDS_IN_THE_OUTPUT: &str =
    "program its moves as blocks; an axis that the target does not have is left out by `axes` under [machine]";

/// A curve table that is described.
pub(super) struct CurveTable {
    /// Where CTABDEF stands.
    loc: Loc,
    /// Printed axes that its blocks name.
    axes: AxisSet,
    /// What stands in it was refused.
    refused: bool,
}

/// What follows another axis.
enum Follower {
    LeftOut,
    /// A printed axis: its name.
    Printed(String),
    Spindle(String),
}

impl Run<'_> {
    /// TRAILON and its kin.
    pub(super) fn coupling(
        &mut self,
        beside: Beside,
        (name, call): (&str, CallWord),
        formulas: &[Formula],
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let result = self.couple(beside, (name, call), formulas, block, text);
        if beside == Beside::Table {
            self.channel.curve_table = Some(Box::new(CurveTable {
                loc: self.channel.core.loc(call.span),
                axes: AxisSet::EMPTY,
                refused: false,
            }));
        }
        if result.is_err() {
            self.channel.lose_all();
        }
        result
    }

    fn couple(
        &mut self,
        beside: Beside,
        (name, call): (&str, CallWord),
        formulas: &[Formula],
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        self.channel.pending_must_be_done(call.span)?;
        match beside {
            Beside::TableEnds => {
                return self.channel.core.refuse(call.span, codes::P9010::ctabend_ends_no_curve_table());
            }
            Beside::Oscillates => {
                return self.channel.core.refuse(call.span, codes::P1001::lacks_axis_in_brackets(&name));
            }
            Beside::Couples | Beside::CouplesAll | Beside::CouplesAllButLast | Beside::Ends | Beside::Table => {}
        }
        let following = match beside {
            Beside::Couples | Beside::Table => formulas.get(..1).unwrap_or_default(),
            Beside::CouplesAll => formulas,
            Beside::CouplesAllButLast => formulas.split_last().map_or(&[][..], |(_, slaves)| slaves),
            Beside::Ends | Beside::TableEnds | Beside::Oscillates => &[],
        };
        let couples = beside != Beside::Ends;
        if couples && following.is_empty() {
            return self.channel.core.refuse(call.span, codes::S2021::lacks_axis_that_follows(&name));
        }
        for formula in following {
            match self.follower(*formula, block, text)? {
                Follower::LeftOut => {}
                Follower::Printed(axis) => {
                    return self.channel.core.refuse(
                        formula.span,
                        codes::P9010::lets_follow_and_is_in_output(&name, &axis).help(STANDS_IN_THE_OUTPUT),
                    );
                }
                Follower::Spindle(spindle) => {
                    return self.channel.core.refuse(formula.span, codes::P9010::lets_follow(&name, &spindle));
                }
            }
        }
        let what = if couples { "moves no axis of the output" } else { "ends no coupling of the output" };
        self.is_left_out_beside(beside, name, call.span, what)
    }

    /// What a coupling moves.
    fn follower(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Follower> {
        let name = match block.formula(formula) {
            [Op::Name(name, _)] => Some(self.channel.core.symbols.name(*name).to_owned()),
            [.., Op::Call(name, _, _)] if self.channel.core.symbols.name(*name) == "SPI" => {
                Some("the spindle".to_owned())
            }
            _ => None,
        };
        let digits = |name: &str| {
            name.strip_prefix('S')
                .is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()))
        };
        if let Some(spindle) = name.filter(|name| name == "the spindle" || digits(name)) {
            return Ok(Follower::Spindle(spindle));
        }
        match self.eval(formula, block, text)? {
            Val::Axis(named) => Ok(match self.channel.axis_names.printed(&self.channel.core, named, formula.span)? {
                None => Follower::LeftOut,
                Some(_) => Follower::Printed(named.text().to_owned()),
            }),
            other => self.channel.core.refuse(formula.span, codes::S2031::axis_is_needed(&other.what())),
        }
    }

    /// Only the key leaves it out, and each is named.
    fn is_left_out_beside(&mut self, beside: Beside, name: &str, span: Span, what: &str) -> Outcome {
        let kind = if beside == Beside::Oscillates { "oscillation" } else { "coupling of axes" };
        if !beside.is_left_out(self.channel.core.job.settings) {
            let key = beside.key();
            let help = format!("it {what}: leave such words out, `[control] {key} = \"leave-out\"`");
            let help = Answer::key("control", key).one_of(&["\"leave-out\""]).help(help);
            return self.channel.core.refuse(span, codes::P9010::is_not_supported(&name, &kind).help(help));
        }
        let found = codes::S8166::is_left_out(&name, &what).at(self.channel.core.loc(span));
        if !self.channel.core.job.diags.knows(&found) {
            self.channel.core.report(found.help("check that the part does not depend on it"));
        }
        Ok(())
    }

    /// `OSP1[U]=10`, `OS[U]=1`, `OSCILL[U]=(X,Y)`
    pub(super) fn oscillation_word(&mut self, name: &str, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        let result = self.oscillates(name, word, block, text);
        if result.is_err() {
            self.channel.lose_all();
        }
        result
    }

    fn oscillates(&mut self, name: &str, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        let Target::Indexed(_, args) = word.target else {
            return self.channel.core.refuse(word.span, codes::P1001::lacks_axis_in_brackets(&name));
        };
        let named = self.axis_index(args, block, text)?;
        let mut printed = self.channel.axis_names.printed(&self.channel.core, named, word.span)?.map(|_| named);
        if let Value::Formula(formula) = word.value {
            let values = match self.eval(formula, block, text)? {
                Val::List(list) => list.to_vec(),
                one => vec![one],
            };
            // Axes whose infeed waits for the turning points.
            for value in values {
                if let Val::Axis(infeed) = value
                    && self.channel.axis_names.printed(&self.channel.core, infeed, word.span)?.is_some()
                {
                    printed = printed.or(Some(infeed));
                }
            }
        }
        if let Some(axis) = printed {
            let axis = axis.text();
            return self.channel.core.refuse(
                word.span,
                codes::P9010::oscillation_moves_beside_path(&name, &axis).help(STANDS_IN_THE_OUTPUT),
            );
        }
        self.is_left_out_beside(Beside::Oscillates, name, word.span, "moves no axis of the output")
    }

    // Curve tables.

    /// A block between CTABDEF and CTABEND: no axis moves, and what it switches ends with the table.
    pub(super) fn table_block(&mut self, block: &Block) -> Outcome {
        if block.stmt == Stmt::Empty {
            return Ok(());
        }
        let ends = |run: &Self, word: &Word| matches!(word.target, Target::Name(name) if run.channel.core.symbols.name(name) == "CTABEND");
        if block.stmt == Stmt::Words && block.words.iter().any(|word| ends(self, word)) {
            let Some(table) = self.channel.curve_table.take() else { return Ok(()) };
            let loc = self.channel.core.here.origin.loc;
            self.channel.st.position.forget(table.axes);
            self.channel.st.position.hide(table.axes, By::Table, loc);
            self.channel.only_known_axes_stand();
            return match block.words.iter().find(|word| !ends(self, word)) {
                Some(other) => self.channel.core.call_not_alone(other.span),
                None => Ok(()),
            };
        }
        let other = if block.stmt == Stmt::Words {
            block.words.iter().find(|word| !self.describes(word)).map(|word| word.span)
        } else {
            Some(block.span)
        };
        let Some(span) = other else {
            let axes: Vec<_> = block.words.iter().filter_map(|word| self.axis_of(word)).collect();
            if let Some(table) = &mut self.channel.curve_table {
                axes.into_iter().for_each(|axis| table.axes.insert(axis));
            }
            return Ok(());
        };
        let Some(table) = self.channel.curve_table.as_mut().filter(|table| !table.refused) else { return Ok(()) };
        table.refused = true;
        let begun = table.loc;
        self.channel.lose_all();
        let found = codes::P9010::in_curve_table_only_positions_of_axes()
            .at(self.channel.core.loc(span))
            .also(begun, Label::TableBegins);
        self.channel.core.report(found.help("take the table out of the copy that is compiled"));
        Err(Reported)
    }

    /// Is the word one of the points of a table, or of the way between them?
    fn describes(&mut self, word: &Word) -> bool {
        match word.target {
            Target::Letter(b'M' | b'S' | b'T' | b'D' | b'H' | b'L' | b'P' | b'R') => false,
            Target::Letter(letter) => self.letter_variable(letter).is_none(),
            Target::Numbered(_, _, name) | Target::Name(name) if self.vars.find(name).is_some() => false,
            Target::Numbered(letter, _, name) => letter != b'R' && matches!(self.meaning(name), Meaning::Axis(_)),
            Target::Name(name) => {
                let polynomial = matches!(self.channel.core.symbols.name(name), "PL" | "PW" | "SD");
                polynomial
                    || matches!(
                        (self.meaning(name), word.value),
                        (Meaning::Code(_), Value::None) | (Meaning::Axis(_), _)
                    )
            }
            Target::Indexed(Base::Name(name), _) => {
                matches!(self.meaning(name), Meaning::Indexed(Indexed::Polynomial | Indexed::Ax))
            }
            Target::Indexed(..) | Target::System(_) => false,
        }
    }

    /// The printed axis that a word names.
    fn axis_of(&mut self, word: &Word) -> Option<crate::machine::Axis> {
        match word.target {
            Target::Letter(letter) => self.channel.axis_names.letter(letter).and_then(|named| named.axis),
            Target::Name(name) | Target::Numbered(_, _, name) => match self.meaning(name) {
                Meaning::Axis(named) => named.axis,
                _ => None,
            },
            Target::Indexed(..) | Target::System(_) => None,
        }
    }

    /// The program ends in a table.
    pub(super) fn report_open_table(&mut self) {
        if let Some(table) = self.channel.curve_table.take() {
            let found = codes::P9010::curve_table_has_no_ctabend().at(table.loc);
            self.channel.core.report(found.help("write CTABEND after the last point of the table"));
        }
    }

    /// A word beside the path that stands alone in its block, like a call.
    pub(super) fn stands_beside_path(&self, w: &Words) -> Option<Beside> {
        Beside::find(self.channel.core.symbols.name(w.calls.word?.name))
    }
}
