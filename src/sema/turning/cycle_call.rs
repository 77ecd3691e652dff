//! Calls of cycles: the words are held against the row, the plan is made, what it says is reported, what it makes is carried out.

use crate::diag::{Fault, codes};
use crate::geo::{Plane, Point2};
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::cycle::Cycle;
use crate::ir::{Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::sema::cycle::call::Kind;
use crate::sema::cycle::given::{Breach, Given, Value};
use crate::sema::cycle::row::{Name, Parameter};
use crate::sema::run::Where;

use super::cycles::{Contour, CycleCall, Lathe, Need, Refused, Row, Step, Unbuilt};
use super::outline::{Outline, Section};
use super::program_parts::Family;
use super::words::{Fun, Words};
use super::{Outcome, Run};

/// The contour in the blocks behind a cycle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Behind<'a> {
    pub outline: Option<&'a Outline>,
    /// G41 or G42 at its start.
    pub side: Option<Fun>,
}

impl Run<'_> {
    pub(super) fn run_cycle(&mut self, row: &'static Row, w: &Words, behind: Behind<'_>) -> Outcome {
        let at = self.stand()?;
        let given = self.given(row, w);
        self.fits_its_row(row, &given)?;
        for need in row.requires {
            self.meets(*need, row.number)?;
        }
        let contour = self.contour_for(row, w, behind.outline)?;
        let lathe = Lathe {
            number: row.number,
            modal: &self.st,
            family: self.sections.family(),
            blank: self.geometry.blank,
            at,
            x: self.coord(w.get(b'X'), Axis::X),
            z: self.coord(w.get(b'Z'), Axis::Z),
            contour,
            side: behind.side,
        };
        let call = CycleCall::new(&given, &lathe, self.core.job.settings);
        let planned = (row.plan)(&call);
        self.tell(call);
        let steps = self.core.made(planned)?;
        self.carry_out(&steps);
        if row.uses_oversize() {
            self.st.oversize = None;
        }
        Ok(())
    }

    /// The words of the block by the parameters of the row.
    fn given(&self, row: &'static Row, w: &Words) -> Given {
        let mut given = Given::new(&row.signature, "", Where::Block, self.st.mm());
        for parameter in row.signature.parameters {
            let Name::Word(name) = parameter.name else { continue };
            let num = match name.as_bytes() {
                [letter] => w.get(*letter),
                _ => w.long(name),
            };
            let (value, place) = match (num, w.text(name).and(self.named.clone())) {
                (Some(num), _) if num.unknown => (Value::Word("?"), num.span.into()),
                (Some(num), _) => (Value::Number(num.value), num.span.into()),
                (None, Some(text)) => (Value::Text(text), Where::Block),
                (None, None) => (Value::Missing, Where::Block),
            };
            given.push(value, place);
        }
        given
    }

    /// The values that are not compiled, then the rules of the row.
    fn fits_its_row(&self, row: &Row, given: &Given) -> Outcome {
        let refused = |unbuilt: &&Unbuilt| given.has(unbuilt.word) && unbuilt.is(given.or_zero(unbuilt.word));
        if let Some(unbuilt) = row.unbuilt.iter().find(refused) {
            let value = given.or_zero(unbuilt.word);
            let fault = (unbuilt.why)(&Refused { cycle: row.number, word: unbuilt.word, value });
            return self.core.refuse(given.place_of(unbuilt.word), fault);
        }
        match given.breach() {
            None => Ok(()),
            Some((at, breach)) => {
                let parameter = &row.signature.parameters[at];
                self.core.refuse(given.place_at(at), says(parameter, breach))
            }
        }
    }

    fn meets(&mut self, need: Need, number: u16) -> Outcome {
        match need {
            Need::Feed => self.cutting_feed().map(|_| ()),
            Need::Spindle => self.spindle_turns(number),
            Need::Turns if self.st.spindle.is_cutting() => {
                self.core.refuse(Where::Block, codes::P1005::tapping_under_constant_cutting_speed())
            }
            Need::Reading(question) => {
                self.depends_on(question, self.core.block_span());
                Ok(())
            }
            Need::Wanted(refused) => match refused(self.core.job.settings) {
                Some(fault) => self.core.refuse(Where::Block, fault),
                None => Ok(()),
            },
            Need::NotDinPlus(fault) if self.sections.family() == Family::DinPlus => {
                self.core.refuse(Where::Block, fault())
            }
            Need::LaterControl(fault) if self.sections.family() == Family::Basic => {
                self.core.refuse(Where::Block, fault())
            }
            Need::Turns | Need::NotDinPlus(_) | Need::LaterControl(_) => Ok(()),
        }
    }

    fn contour_for(&self, row: &Row, w: &Words, outline: Option<&Outline>) -> Outcome<Option<Section>> {
        match row.contour {
            Contour::None => Ok(None),
            Contour::LineOrReferenced if w.has(b'X') || w.has(b'Z') => Ok(None),
            Contour::Follows | Contour::LineOrReferenced => self.contour_of(w, outline, 0).map(Some),
            Contour::Referenced => self.contour_with_ends(w, outline).map(Some),
        }
    }

    fn tell(&self, call: CycleCall<'_>) {
        for found in call.elsewhere() {
            self.core.report(found.fault.at(found.place).also(self.core.here.origin.loc, found.call));
        }
        for remark in call.remarks() {
            if remark.kind == Kind::Once {
                self.core.say_once(remark.place, remark.fault);
            } else {
                self.core.say(remark.place, remark.fault);
            }
        }
    }

    fn carry_out(&mut self, steps: &[Step]) {
        for step in steps {
            match step {
                Step::Cycle(cycle) => self.send_cycle(cycle),
                Step::Move(to, path) => self.cycle_move(*to, *path),
            }
        }
    }

    /// Sends a cycle; the tool stands where the cycle leaves it.
    fn send_cycle(&mut self, cycle: &Cycle) {
        self.core.send_cycle(cycle, &self.st.ctx);
        let end = cycle.leaves(self.st.position.at());
        self.st.position.cycle_leaves(&end, AxisSet::MAIN);
        self.st.last = None;
        self.st.moved = true;
        self.cycle_cuts(cycle);
    }

    /// A move of a cycle that is no more than a few moves.
    fn cycle_move(&mut self, to: Point2, path: Path) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(Plane::Zx, to);
        self.movement(&Move { end, path, side: Side::None, coords: Coords::Frame });
        self.st.stands(to);
        self.st.moved = true;
        self.st.cut = true;
        self.st.last = None;
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
