//! Blocks of words: which function takes which word, and in which order they act.
//!
//! A block acts in this order: tool, spindle, feed, M functions at the start, modal functions, the move or cycle, M
//! functions at the end.

use std::rc::Rc;

use crate::diag::{Fault, Label, codes};
use crate::ir::contour::Ctx;
use crate::ir::function::PathControl;
use crate::ir::{Function as Item, Remark, Side};
use crate::machine::Compensation;
use crate::parser::turning::ast::Block;
use crate::sema::common::feed::FeedKind;
use crate::sema::common::spindle::SpeedKind;
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};
use crate::text::decode::readable;

use super::blank::Blank;
use super::cycles::Row;
use super::eval::Computing;
use super::frames::ShiftOf;
use super::g_functions::{Function, Kind, find};
use super::geometry::Line;
use super::m_functions::check_m;
use super::other_axes::belongs;
use super::program_parts::ProgramPart;
use super::spindle;
use super::technology::Oversize;
use super::words::{Fun, Letters, Words, letters};
use super::{Outcome, Reported, Run};

/// Words that need no function.
const GENERAL: Letters = letters("TFS");

impl Run<'_> {
    pub(super) fn words_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let mut w = self.words.take().unwrap_or_default();
        let Run { core, vars, .. } = self;
        let read = w.gather(block, &mut Computing { core, vars });
        let result = read.and_then(|()| self.words_of_part(&w, block, text));
        self.words = Some(w);
        if result.is_err() && self.sections.part.is_executed() {
            self.lose_all();
        }
        result
    }

    #[inline]
    fn words_of_part(&mut self, w: &Words, block: &Block, text: &[u8]) -> Outcome {
        match self.sections.part {
            ProgramPart::Start | ProgramPart::Machining if self.capture.is_none() => self.machine(w, text),
            ProgramPart::Start | ProgramPart::Machining => self.capture_block(w, block),
            ProgramPart::Contour => {
                let line = Line { w, block, measure: self.measure() };
                let blank = self.geometry.block(line, text, &self.core)?;
                if let Some(shown) = blank.and_then(Blank::shown) {
                    self.core.send_function(&Item::Remark(Remark::Blank(shown)), &self.st.ctx);
                }
                Ok(())
            }
            ProgramPart::Turret => {
                if let Some(fault) = self.core.made(self.sections.turret_line(w, text))? {
                    self.core.say_here(fault);
                }
                Ok(())
            }
            ProgramPart::Unread => Ok(()),
            ProgramPart::Head | ProgramPart::Names | ProgramPart::Between => {
                self.core.refuse(block.span, codes::T1008::words_have_no_place_in_this_section())
            }
        }
    }

    /// A block that is executed.
    fn machine(&mut self, w: &Words, text: &[u8]) -> Outcome {
        self.sections.settle_family();
        self.core.level().frame.begun = true;
        if let Some(name) = w.text("L") {
            self.settle_chain()?;
            let called = w.called(&readable(name.of(text)), self.sections.family());
            let called = self.core.made(called)?;
            return self.enter(called);
        }
        let plan = self.core.made(Plan::of(w))?;
        self.core.made(check_m(w, self.core.job.settings))?;
        let only_moves = plan.only_path && w.m().is_empty() && w.present() & GENERAL == 0;
        if !only_moves {
            self.settle_chain()?;
            self.before_motion(w, &plan, text)?;
        }
        if let Some((function, fun)) = plan.motion {
            self.named = w.text("ID").map(|span| readable(span.of(text)).into_owned());
            self.motion(function, fun, w)?;
        }
        // Behind its block, G9 counts no longer. A move that waits for the next block takes it along.
        if self.st.exact_stop && self.chain.is_empty() {
            self.st.exact_stop = false;
            self.core.send_function(&Item::PathControl(None), &self.st.ctx);
        }
        if only_moves || self.core.has_ended() || w.m().is_empty() || self.capture.is_some() {
            return Ok(());
        }
        // Those at the end of a block whose move waits for the next one cannot be kept in order.
        if w.m().iter().any(|m| !matches!(m.number, 3 | 4 | 8)) {
            self.settle_chain()?;
        }
        self.m_functions(w, false)
    }

    fn before_motion(&mut self, w: &Words, plan: &Plan, text: &[u8]) -> Outcome {
        if let Some(num) = w.get(b'T') {
            self.tool_word(num, text)?;
        }
        for fun in w.g() {
            let function = self.core.made(function_of(*fun))?;
            self.modal_function(function.kind, *fun, w)?;
        }
        if let Some(num) = w.get(b'S').filter(|_| plan.claimed & letters("S") == 0) {
            self.core.made(spindle::speed(&mut self.st.spindle, num, self.st.unit))?;
            self.send_speed(num.span);
        }
        if let Some(num) = w.get(b'F').filter(|_| plan.claimed & letters("F") == 0) {
            let mm = self.st.mm();
            self.core.made(num.feed(&mut self.st.feed, mm))?;
        }
        self.m_functions(w, true)
    }

    fn modal_function(&mut self, kind: Kind, fun: Fun, w: &Words) -> Outcome {
        let (unit, mm) = (self.st.unit, self.st.mm());
        match kind {
            Kind::SpeedLimit => {
                let num = self.core.made(spindle::limit(&mut self.st.spindle, w))?;
                self.send_speed(num.span);
            }
            Kind::CuttingSpeed | Kind::Revolutions => {
                let counts = if kind == Kind::CuttingSpeed { SpeedKind::Cutting } else { SpeedKind::Turns };
                if let Some(num) = self.core.made(spindle::count(&mut self.st.spindle, counts, w, unit))? {
                    self.send_speed(num.span);
                }
            }
            Kind::PerMinute | Kind::PerRevolution => {
                let counts = FeedKind::per_revolution(kind == Kind::PerRevolution);
                self.core.made(w.feed_mode(&mut self.st.feed, counts, mm))?;
            }
            Kind::CompensationOff => return self.compensation(Side::None, fun),
            Kind::CompensationLeft => return self.compensation(Side::Left, fun),
            Kind::CompensationRight => return self.compensation(Side::Right, fun),
            Kind::Shift(of) => return self.shift(of, w),
            Kind::Clearance => {
                let clearance = w.get(b'P').map(|num| num.above_zero(mm, "the clearance")).transpose();
                self.st.clearance = self.core.made(clearance)?;
            }
            Kind::OversizeParaxial => self.oversize(w.paraxial(mm)),
            Kind::OversizeEquidistant => {
                let oversize = self.core.made(w.equidistant(mm))?;
                self.oversize(oversize);
            }
            Kind::OversizeOff => {
                self.core.without_effect(w, b"P", codes::T8017::g52_ends_oversizes_as_g50);
                self.st.oversize = None;
            }
            Kind::ExactStop => {
                self.st.exact_stop = true;
                self.core.send_function(&Item::PathControl(Some(PathControl::Exact)), &self.st.ctx);
            }
            Kind::Nothing
            | Kind::Rapid
            | Kind::Line
            | Kind::Arc { .. }
            | Kind::MachineRapid
            | Kind::ChangePoint
            | Kind::Dwell
            | Kind::SingleThread
            | Kind::EndOfContour
            | Kind::Cycle
            | Kind::Refused => {}
        }
        Ok(())
    }

    /// G57 and G58.
    fn oversize(&mut self, oversize: Oversize) {
        let here = self.core.here.origin.loc;
        if let Some((before, loc)) = self.st.oversize.replace((oversize, here))
            && std::mem::discriminant(&before) != std::mem::discriminant(&oversize)
        {
            let found = codes::T8017::from_here_on_changes_nothing(&before.name(), &oversize.name()).at(loc);
            self.core.report(found.also(here, Label::TakesItsPlace));
        }
    }

    /// G51, G56, G59: the workpiece zero moves, the tool stays where it is.
    fn shift(&mut self, kind: ShiftOf, w: &Words) -> Outcome {
        let z = self.core.made(w.shift(kind, self.st.mm()))?;
        if self.st.compensation.is_on() && self.core.job.settings.output.compensation == Compensation::Resolve {
            let fault = codes::T2021::workpiece_zero_shifts_under_nose_radius_compensation();
            return self.core.refuse(Where::Block, fault);
        }
        let counted: Option<fn() -> Fault> = if self.st.moved {
            Some(codes::T2016::g59_moves_workpiece_zero_that_program)
        } else if !self.st.position.start().known().is_empty() {
            Some(codes::T2016::g59_moves_workpiece_zero_that_positions)
        } else {
            None
        };
        let shift = self.core.accept(Where::Block, self.st.shift.after(kind, z, counted))?;
        if kind == ShiftOf::Absolute {
            if self.st.shift.base.is_none() {
                let fault = codes::T2015::coordinates_count_from_workpiece_zero_of_g59(&z);
                self.core.job.diags.push_once(fault.at(self.core.here.origin.loc));
            }
            if shift.is_added() {
                return self.core.refuse(Where::Block, codes::T2016::whether_g59_ends_shifts_of_g51());
            }
        }
        self.st.shift = shift;
        let frame = shift.frame().ok_or_else(codes::T1007::shift_is_no_number);
        let frame = self.core.accept(Where::Block, frame)?;
        self.st.position.through_frame(&self.st.ctx.frame, &frame);
        self.st.last.forget();
        self.st.ctx = Rc::new(Ctx { frame, ..(*self.st.ctx).clone() });
        Ok(())
    }

    #[inline]
    fn motion(&mut self, function: &Function, fun: Fun, w: &Words) -> Outcome {
        match function.kind {
            Kind::Rapid => return self.straight(w, true),
            Kind::Line => return self.straight(w, false),
            Kind::Arc { ccw, absolute } => return self.arc(w, ccw, absolute),
            _ => {}
        }
        if self.st.compensation.is_on() && function.kind != Kind::Dwell {
            return self.core.refuse(fun.span, codes::T2021::g_stands_under_nose_radius_compensation(&fun.number));
        }
        match (function.kind, function.cycle) {
            (Kind::MachineRapid, _) => {
                let end = self.core.made(w.machine_place(self.st.mm()))?;
                self.machine_move(end);
            }
            (Kind::ChangePoint, _) => {
                for step in self.core.made(w.to_change_point(self.core.job.settings))? {
                    self.machine_move(step);
                }
            }
            (Kind::Dwell, _) => {
                let time = self.core.made(w.dwell())?;
                self.core.send_function(&Item::Dwell(time), &self.st.ctx);
            }
            (Kind::SingleThread, _) => return self.single_thread(w),
            (Kind::EndOfContour, _) => return self.core.refuse(fun.span, codes::T3003::g80_ends_contour()),
            (Kind::Cycle, Some(cycle)) => return self.begin_cycle(cycle, w),
            _ => return Err(Reported),
        }
        Ok(())
    }
}

impl Words {
    /// G4: the time in seconds.
    fn dwell(&self) -> Made<f64> {
        let num = self.needed(b'F', "the time in seconds")?;
        if num.value < 0.0 {
            return refused(num.span, codes::T1007::dwell_time_is_not_negative());
        }
        Ok(num.value)
    }
}

#[inline]
fn function_of(fun: Fun) -> Made<&'static Function> {
    match find(fun.number) {
        Some(function) if function.kind != Kind::Refused => Ok(function),
        known => no_such_function(fun, known),
    }
}

#[cold]
fn no_such_function<T>(fun: Fun, known: Option<&Function>) -> Made<T> {
    let fault = match (belongs(fun.number), known) {
        (Some(owner), known) => {
            let what = known.map_or_else(String::new, |function| format!(" ({})", function.name));
            codes::P9011::g_is_function(&fun.number, &what, &owner)
        }
        (None, Some(function)) => codes::P9011::g_is_not_supported(&fun.number, &function.name),
        (None, None) => codes::P9011::g_is_not_known(&fun.number),
    };
    refused(fun.span, fault)
}

/// Which function takes which words.
#[derive(Debug)]
struct Plan {
    motion: Option<(&'static Function, Fun)>,
    claimed: Letters,
    /// G0 to G3, G12, G13 and nothing else.
    only_path: bool,
}

impl Plan {
    /// Looks the functions up and gives every word to one of them.
    fn of(w: &Words) -> Made<Plan> {
        let mut plan = Plan { motion: None, claimed: 0, only_path: true };
        let mut functions: [Option<&'static Function>; 4] = [None; 4];
        for (i, fun) in w.g().iter().enumerate() {
            let function = function_of(*fun)?;
            if w.g()[..i].iter().any(|other| other.number == fun.number) {
                return refused(fun.span, codes::P1002::g_stands_twice_in_block(&fun.number));
            }
            let both = plan.claimed & function.letters & w.present();
            if both != 0 {
                let letter = (b'A' + both.trailing_zeros() as u8) as char;
                return refused(fun.span, codes::P1005::two_functions_of_block_take(&letter));
            }
            plan.claimed |= function.letters;
            if let Some(slot) = functions.get_mut(i) {
                *slot = Some(function);
            }
            plan.only_path &= function.kind.is_path();
            if function.kind.is_motion() && plan.motion.replace((function, *fun)).is_some() {
                return refused(fun.span, codes::P1005::g_another_move_or_cycle_stand(&fun.number));
            }
        }
        plan.check_words(w, &functions)?;
        Ok(plan)
    }

    #[inline]
    fn check_words(&self, w: &Words, functions: &[Option<&Function>]) -> Made {
        let stray = w.present() & !(self.claimed | GENERAL);
        if stray != 0 {
            return stray_letter(w, stray, self.motion.is_some());
        }
        let mut rest = w.present() & !letters("XZ");
        while rest != 0 {
            let letter = b'A' + rest.trailing_zeros() as u8;
            if let Some(num) = w.get(letter).filter(|num| num.incremental || num.unknown) {
                return refused(num.span, codes::P1003::takes_plain_number_here(&(letter as char)));
            }
            rest &= rest - 1;
        }
        for (addr, num) in w.longs() {
            let name = addr.to_string();
            if !functions.iter().flatten().any(|function| function.takes(&name)) {
                return refused(num.span, codes::P1003::no_function_of_block_takes(&name));
            }
            if num.unknown {
                return refused(num.span, codes::P1003::takes_number(&name));
            }
        }
        let named = self.motion.is_some_and(|(function, _)| function.cycle.is_some_and(Row::takes_name));
        match w.texts().iter().find(|(addr, _)| !(named && addr.to_string() == "ID")) {
            Some((addr, span)) => refused(*span, codes::P1003::no_function_of_block_takes_text(&addr)),
            None => Ok(()),
        }
    }
}

#[cold]
fn stray_letter(w: &Words, stray: Letters, moves: bool) -> Made {
    let letter = b'A' + stray.trailing_zeros() as u8;
    let (place, letter) = (w.place(letter), letter as char);
    let fault = match letter {
        'X' | 'Z' if !moves => codes::T2001::block_has_coordinates(),
        'C' | 'Y' | 'U' | 'W' => codes::T9004::belongs_to_c_axis(&letter),
        letter => codes::P1003::no_function_of_block_takes(&letter),
    };
    refused(place, fault)
}

impl Kind {
    fn is_path(self) -> bool {
        matches!(self, Kind::Rapid | Kind::Line | Kind::Arc { .. })
    }

    fn is_motion(self) -> bool {
        self.is_path()
            || matches!(
                self,
                Kind::MachineRapid
                    | Kind::ChangePoint
                    | Kind::Dwell
                    | Kind::SingleThread
                    | Kind::EndOfContour
                    | Kind::Cycle
            )
    }
}
