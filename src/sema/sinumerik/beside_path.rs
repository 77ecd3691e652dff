//! Couplings, curve tables and oscillation: left out where the axis that they move is none of the output's.
//!
//! Comes in: the words and their arguments. Goes out: a warning, or an error. The axis that follows, or swings, is looked at first:
//! where it is printed, or where a spindle follows, nothing takes the word away.
//!
//! Source: S 6 (docs/sources.md). The blocks between CTABDEF and CTABEND describe a table and move nothing; after it the
//! state of the program is that of before.

use crate::diag::{Answer, Diagnostic, Label, codes};
use crate::machine::{Axis, AxisSet};
use crate::parser::sinumerik::ast::{Base, Block, Op, Stmt, Target, Value, Word};
use crate::parser::symbols::Symbols;
use crate::sema::common::hidden::By;
use crate::text::{Loc, Span};

use super::axis_names::AxisNames;
use super::line::Line;
use super::value::Val;
use super::vocabulary::{Indexed, Meaning};
use super::words::{CallWord, call_not_alone};
use super::{Channel, Core, Outcome, Reported, Run};

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

    /// Only the key leaves it out, and each is named.
    fn leave_out(self, name: &str, span: Span, what: &str, core: &Core<'_>) -> Outcome {
        let kind = if self == Beside::Oscillates { "oscillation" } else { "coupling of axes" };
        if !self.is_left_out(core.job.settings) {
            let key = self.key();
            let help = format!("it {what}: leave such words out, `[control] {key} = \"leave-out\"`");
            let help = Answer::key("control", key).one_of(&["\"leave-out\""]).help(help);
            return core.refuse(span, codes::P9010::is_not_supported(&name, &kind).help(help));
        }
        let found = codes::S8166::is_left_out(&name, &what).at(core.loc(span));
        core.report_new(found.help("check that the part does not depend on it"));
        Ok(())
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

impl Run<'_> {
    /// TRAILON and its kin. After an error nobody knows where the axes are.
    pub(super) fn coupling(&mut self, beside: Beside, call: CallWord, line: Line<'_>) -> Outcome {
        let name = self.channel.core.symbols.name(call.name).to_owned();
        if beside == Beside::Table {
            let loc = self.channel.core.loc(call.span);
            self.channel.curve_table = Some(Box::new(CurveTable { loc, axes: AxisSet::EMPTY, refused: false }));
        }
        let formulas = line.arguments_of(call.args);
        self.channel.pending_must_be_done(call.span)?;
        let following = match beside {
            Beside::TableEnds => {
                return self.channel.core.refuse(call.span, codes::P9010::ctabend_ends_no_curve_table());
            }
            Beside::Oscillates => {
                return self.channel.core.refuse(call.span, codes::P1001::lacks_axis_in_brackets(&name));
            }
            Beside::Couples | Beside::Table => formulas.get(..1).unwrap_or_default(),
            Beside::CouplesAll => formulas,
            Beside::CouplesAllButLast => formulas.split_last().map_or(&[][..], |(_, slaves)| slaves),
            Beside::Ends => &[],
        };
        let couples = beside != Beside::Ends;
        if couples && following.is_empty() {
            return self.channel.core.refuse(call.span, codes::S2021::lacks_axis_that_follows(&name));
        }
        for formula in following {
            if let Some(spindle) = spindle_of(line.ops(*formula), &self.channel.core.symbols) {
                return self.channel.core.refuse(formula.span, codes::P9010::lets_follow(&name, &spindle));
            }
            let axis = match self.eval(*formula, line)? {
                Val::Axis(named) => named,
                other => return self.channel.core.refuse(formula.span, codes::S2031::axis_is_needed(&other.what())),
            };
            if self.channel.axis_names.printed(&self.channel.core, axis, formula.span)?.is_some() {
                let fault = codes::P9010::lets_follow_and_is_in_output(&name, &axis.text()).help(STANDS_IN_THE_OUTPUT);
                return self.channel.core.refuse(formula.span, fault);
            }
        }
        let what = if couples { "moves no axis of the output" } else { "ends no coupling of the output" };
        beside.leave_out(&name, call.span, what, &self.channel.core)
    }

    /// `OSP1[U]=10`, `OS[U]=1`, `OSCILL[U]=(X,Y)`. After an error nobody knows where the axes are.
    pub(super) fn oscillation_word(&mut self, name: &str, word: &Word, line: Line<'_>) -> Outcome {
        let Target::Indexed(_, args) = word.target else {
            return self.channel.core.refuse(word.span, codes::P1001::lacks_axis_in_brackets(&name));
        };
        let named = self.axis_index(args, line)?;
        let mut printed = self.channel.axis_names.printed(&self.channel.core, named, word.span)?.map(|_| named);
        if let Value::Formula(formula) = word.value {
            let values = match self.eval(formula, line)? {
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
        let core = &self.channel.core;
        if let Some(axis) = printed {
            let fault = codes::P9010::oscillation_moves_beside_path(&name, &axis.text()).help(STANDS_IN_THE_OUTPUT);
            return core.refuse(word.span, fault);
        }
        Beside::Oscillates.leave_out(name, word.span, "moves no axis of the output", core)
    }

    // Curve tables.

    /// A block between CTABDEF and CTABEND: no axis moves, and what it switches ends with the table.
    pub(super) fn table_block(&mut self, block: &Block) -> Outcome {
        if block.stmt == Stmt::Empty {
            return Ok(());
        }
        let end = self.channel.core.symbols.find("CTABEND");
        let ends = |word: &Word| matches!(word.target, Target::Name(name) if Some(name) == end);
        if block.stmt == Stmt::Words && block.words.iter().any(ends) {
            self.channel.curve_table_ends();
            return match block.words.iter().find(|word| !ends(word)) {
                Some(other) => self.channel.core.refuse(other.span, call_not_alone()),
                None => Ok(()),
            };
        }
        let mut axes = AxisSet::EMPTY;
        let mut other = (block.stmt != Stmt::Words).then_some(block.span);
        for word in &block.words {
            let symbols = &self.channel.core.symbols;
            let is_variable =
                !matches!(word.target, Target::Indexed(..)) && self.vars.target(word.target, symbols).is_some();
            let name = match word.target {
                Target::Numbered(_, _, name) | Target::Name(name) | Target::Indexed(Base::Name(name), _) => Some(name),
                Target::Letter(_) | Target::System(_) | Target::Indexed(..) => None,
            };
            let meaning = name.map_or(Meaning::Unknown, |name| self.names.meaning(name, &self.channel));
            let own = name.map_or("", |name| self.channel.core.symbols.name(name));
            match described(word, own, meaning, &self.channel.axis_names).filter(|_| !is_variable) {
                Some(axis) => axes = axes.union(axis),
                None => other = other.or(Some(word.span)),
            }
        }
        let Some(table) = &mut self.channel.curve_table else { return Ok(()) };
        let Some(span) = other else {
            table.axes = table.axes.union(axes);
            return Ok(());
        };
        let begun = table.loc;
        if std::mem::replace(&mut table.refused, true) {
            return Ok(());
        }
        self.channel.lose_all();
        let found = codes::P9010::in_curve_table_only_positions_of_axes().at(self.channel.core.loc(span));
        let found = found.also(begun, Label::TableBegins);
        self.channel.core.report(found.help("take the table out of the copy that is compiled"));
        Err(Reported)
    }
}

/// The printed axis that a word of a table names, if any; `None` for a word that is no point of it, nor says the way between them.
fn described(word: &Word, own: &str, meaning: Meaning, axes: &AxisNames) -> Option<AxisSet> {
    let of = |axis: Option<Axis>| Some(axis.into_iter().collect());
    let polynomial = || matches!(own, "PL" | "PW" | "SD").then_some(AxisSet::EMPTY);
    match (word.target, meaning) {
        (Target::Letter(b'M' | b'S' | b'T' | b'D' | b'H' | b'L' | b'P' | b'R') | Target::Numbered(b'R', ..), _) => None,
        (Target::Letter(letter), _) => of(axes.letter(letter).and_then(|named| named.axis)),
        (Target::Numbered(..) | Target::Name(_), Meaning::Axis(named)) => of(named.axis),
        (Target::Name(_), Meaning::Code(_)) if matches!(word.value, Value::None) => Some(AxisSet::EMPTY),
        (Target::Name(_), _) => polynomial(),
        (Target::Indexed(..), Meaning::Indexed(Indexed::Polynomial | Indexed::Ax)) => Some(AxisSet::EMPTY),
        (Target::Numbered(..) | Target::Indexed(..) | Target::System(_), _) => None,
    }
}

/// The spindle that a formula names.
fn spindle_of(ops: &[Op], symbols: &Symbols) -> Option<String> {
    let digits = |name: &str| {
        name.strip_prefix('S').is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()))
    };
    match ops {
        [Op::Name(name, _)] => Some(symbols.name(*name)).filter(|name| digits(name)).map(str::to_owned),
        [.., Op::Call(name, _, _)] if symbols.name(*name) == "SPI" => Some("the spindle".to_owned()),
        _ => None,
    }
}

impl Channel<'_> {
    /// CTABEND: what the table names stands where nobody knows.
    fn curve_table_ends(&mut self) {
        let Some(table) = self.curve_table.take() else { return };
        let loc = self.core.here.origin.loc;
        self.st.position.forget(table.axes);
        self.st.position.hide(table.axes, By::Table, loc);
        self.only_known_axes_stand();
    }
}

impl CurveTable {
    /// The program ends in a table.
    pub fn has_no_end(&self) -> Diagnostic {
        let found = codes::P9010::curve_table_has_no_ctabend().at(self.loc);
        found.help("write CTABEND after the last point of the table")
    }
}
