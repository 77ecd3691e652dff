//! Calls of cycles: the words are held against the row, the plan is made, what it says is reported, what it makes is carried out.

use crate::diag::{Fault, codes};
use crate::geo::Plane;
use crate::ir::contour::{Coords, Move};
use crate::ir::{Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::sema::common::spindle::ModalSpindle;
use crate::sema::cycle::call::Kind;
use crate::sema::cycle::given::{Breach, Given, Value};
use crate::sema::cycle::row::{Name, Parameter};
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};

use super::called_contour::Wanted;
use super::cycles::{CycleCall, Lathe, Need, Refused, Row, Step, Unbuilt};
use super::outline::Outline;
use super::program_parts::Family;
use super::spindle::turns;
use super::words::{Fun, Words};
use super::{Core, Outcome, Run};

/// The contour in the blocks behind a cycle.
#[derive(Debug, Clone, Copy)]
pub(super) struct FollowingContour<'a> {
    pub outline: Option<&'a Outline>,
    /// G41 or G42 at its start.
    pub side: Option<Fun>,
}

impl Run<'_> {
    pub(super) fn run_cycle(&mut self, row: &'static Row, w: &Words, behind: FollowingContour<'_>) -> Outcome {
        let at = self.core.tip(&self.st.position)?;
        let measure = self.measure();
        let named = self.named.as_deref();
        let given = given(row, w, named, measure.mm);
        self.core.made(fits_its_row(row, &given))?;
        for need in row.requires {
            match need {
                Need::Feed => drop(self.core.cutting_feed(&mut self.st.feed)?),
                need => self.core.meets(*need, row.number, measure.family, &self.st.spindle)?,
            }
        }
        let wanted = Wanted { w, named, behind: behind.outline };
        let contour = self.geometry.contour_for(row.contour, wanted, &self.core)?;
        let lathe = Lathe {
            number: row.number,
            modal: &self.st,
            family: measure.family,
            blank: self.geometry.blank,
            at,
            x: w.coord(Axis::X, measure.mm),
            z: w.coord(Axis::Z, measure.mm),
            contour,
            side: behind.side,
        };
        let call = CycleCall::new(&given, &lathe, self.core.job.settings);
        let planned = (row.plan)(&call);
        self.core.tell(call);
        for step in &self.core.made(planned)? {
            self.carry_out(step);
        }
        if row.uses_oversize() {
            self.st.oversize = None;
        }
        Ok(())
    }

    /// Sends a cycle, or a move of one that is no more than a few moves; the tool stands where it leads.
    fn carry_out(&mut self, step: &Step) {
        match step {
            Step::Cycle(cycle) => {
                self.core.send_cycle(cycle, &self.st.ctx);
                let end = cycle.leaves(self.st.position.at());
                self.st.position.cycle_leaves(&end, AxisSet::MAIN);
                self.st.stock.cut_by(cycle, self.st.shift.total());
            }
            Step::Move(to, path) => {
                let mut end = Pos::UNKNOWN;
                end.set_in_plane(Plane::Zx, *to);
                let (path, side, coords) = (*path, Side::None, Coords::Frame);
                self.core.send_move(&Move { end, path, side, coords }, &self.st.ctx);
                self.st.position.move_in_plane(Plane::Zx, *to);
                self.st.stock.cut_somewhere();
            }
        }
        self.st.moved = true;
        self.st.last.forget();
    }
}

/// The words of the block by the parameters of the row; `named` is the contour that ID names.
fn given(row: &'static Row, w: &Words, named: Option<&str>, mm: f64) -> Given {
    let mut given = Given::new(&row.signature, "", Where::Block, mm);
    for parameter in row.signature.parameters {
        let Name::Word(name) = parameter.name else { continue };
        let num = match name.as_bytes() {
            [letter] => w.get(*letter),
            _ => w.long(name),
        };
        let (value, place) = match (num, w.text(name).and(named)) {
            (Some(num), _) if num.unknown => (Value::Word("?"), num.span.into()),
            (Some(num), _) => (Value::Number(num.value), num.span.into()),
            (None, Some(text)) => (Value::Text(text.to_owned()), Where::Block),
            (None, None) => (Value::Missing, Where::Block),
        };
        given.push(value, place);
    }
    given
}

/// The values that are not compiled, then the rules of the row.
fn fits_its_row(row: &Row, given: &Given) -> Made {
    let is_unbuilt = |unbuilt: &&Unbuilt| given.has(unbuilt.word) && unbuilt.is(given.or_zero(unbuilt.word));
    if let Some(unbuilt) = row.unbuilt.iter().find(is_unbuilt) {
        let value = given.or_zero(unbuilt.word);
        let fault = (unbuilt.why)(&Refused { cycle: row.number, word: unbuilt.word, value });
        return refused(given.place_of(unbuilt.word), fault);
    }
    match given.breach() {
        None => Ok(()),
        Some((at, breach)) => refused(given.place_at(at), says(&row.signature.parameters[at], breach)),
    }
}

impl Core<'_> {
    fn meets(&self, need: Need, number: u16, family: Family, spindle: &ModalSpindle) -> Outcome {
        let fault = match need {
            Need::Spindle => return self.accept(Where::Block, turns(spindle, number)),
            Need::Turns if spindle.is_cutting() => codes::P1005::tapping_under_constant_cutting_speed(),
            Need::Reading(question) => {
                self.depends_on(question, Where::Block);
                return Ok(());
            }
            Need::Wanted(refused) => match refused(self.job.settings) {
                Some(fault) => fault,
                None => return Ok(()),
            },
            Need::NotDinPlus(fault) if family == Family::DinPlus => fault(),
            Need::LaterControl(fault) if family == Family::Basic => fault(),
            Need::Feed | Need::Turns | Need::NotDinPlus(_) | Need::LaterControl(_) => return Ok(()),
        };
        self.refuse(Where::Block, fault)
    }

    fn tell(&self, call: CycleCall<'_>) {
        for found in call.elsewhere() {
            self.report(found.fault.at(found.place).also(self.here.origin.loc, found.call));
        }
        for remark in call.remarks() {
            if remark.kind == Kind::Once {
                self.say_once(remark.place, remark.fault);
            } else {
                self.say(remark.place, remark.fault);
            }
        }
    }
}

/// What is said of an argument that is not what its row asks for.
fn says(parameter: &Parameter, breach: Breach) -> Fault {
    let (name, what) = (&parameter.name, &parameter.what);
    match breach {
        Breach::Missing => codes::P1004::is_missing(name, what),
        Breach::Negative(value) => codes::T1007::is_below_zero(name, &value, what),
        Breach::NotAboveZero(value, _) => codes::T1007::is_not_above_zero(name, &value, what),
        Breach::NoneOf(value, range) => codes::T1007::is_none_of(name, &value, &range),
        Breach::OutOfAllRange => codes::T1007::number_is_too_large_for_any_control(),
        Breach::NoNumber | Breach::NoText | Breach::NoDigits(_) | Breach::Zero | Breach::NotBelow90(_) => {
            codes::T1007::is_no_value(name, what)
        }
    }
}
