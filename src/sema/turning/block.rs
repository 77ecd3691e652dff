//! Blocks of words: which function takes which word, and in which order they act.
//!
//! A block acts in this order: tool, spindle, feed, M functions at the start, modal functions, the move or cycle, M
//! functions at the end.

use crate::diag::codes;
use crate::ir::function::PathControl;
use crate::ir::{Function as Item, Side};
use crate::parser::turning::ast::Block;
use crate::sema::common::feed::FeedKind;
use crate::text::decode::readable;

use super::cycles::Row;
use super::g_functions::{Function, Kind, find};
use super::other_axes::belongs;
use super::program_parts::ProgramPart;
use super::technology::SpeedMode;
use super::words::{Fun, Letters, Words, letters};
use super::{Outcome, Reported, Run};

/// Words that need no function.
const GENERAL: Letters = letters("TFS");

impl Run<'_> {
    pub(super) fn words_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let result = self.gather(block).and_then(|w| {
            let result = self.words_of_part(&w, block, text);
            self.put_back(w);
            result
        });
        if result.is_err() && matches!(self.sections.part, ProgramPart::Start | ProgramPart::Machining) {
            self.lose_all();
        }
        result
    }

    #[inline]
    fn words_of_part(&mut self, w: &Words, block: &Block, text: &[u8]) -> Outcome {
        match self.sections.part {
            ProgramPart::Start | ProgramPart::Machining if self.capture.is_none() => self.machine(w, text),
            ProgramPart::Start | ProgramPart::Machining => self.capture_block(w, block),
            ProgramPart::Contour => self.geometry_block(w, block, text),
            ProgramPart::Turret => self.turret_line(w, text),
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
            return self.call(w, name, text);
        }
        let plan = self.plan(w)?;
        self.check_m(w)?;
        let only_moves = plan.only_path && w.m().is_empty() && w.present() & GENERAL == 0;
        if !only_moves {
            self.settle_chain()?;
            self.before_motion(w, &plan, text)?;
        }
        if let Some((function, fun)) = plan.motion {
            self.named = w.text("ID").map(|span| readable(span.of(text)).into_owned());
            self.motion(function, fun, w)?;
        }
        self.exact_stop_ends();
        if only_moves || self.core.has_ended() {
            return Ok(());
        }
        if !w.m().is_empty() && self.capture.is_none() {
            self.settle_chain_if_ends(w)?;
            self.m_at_end(w)?;
        }
        Ok(())
    }

    /// Behind its block, G9 counts no longer. A move that waits for the next block takes it along.
    #[inline]
    fn exact_stop_ends(&mut self) {
        if self.st.exact_stop && self.chain.is_empty() {
            self.st.exact_stop = false;
            self.function(Item::PathControl(None));
        }
    }

    /// M functions at the end of a block whose move waits for the next one cannot be kept in order.
    fn settle_chain_if_ends(&mut self, w: &Words) -> Outcome {
        let ends = w.m().iter().any(|m| !matches!(m.number, 3 | 4 | 8));
        if ends { self.settle_chain() } else { Ok(()) }
    }

    /// Looks the functions up and gives every word to one of them.
    fn plan(&mut self, w: &Words) -> Outcome<Plan> {
        let mut plan = Plan { motion: None, claimed: 0, only_path: true };
        let mut functions: [Option<&'static Function>; 4] = [None; 4];
        for (i, fun) in w.g().iter().enumerate() {
            let function = self.function_of(*fun)?;
            self.check_same(w, i)?;
            let both = plan.claimed & function.letters & w.present();
            if both != 0 {
                let letter = (b'A' + both.trailing_zeros() as u8) as char;
                return self.core.refuse(fun.span, codes::P1005::two_functions_of_block_take(&letter));
            }
            plan.claimed |= function.letters;
            if let Some(slot) = functions.get_mut(i) {
                *slot = Some(function);
            }
            plan.only_path &= function.kind.is_path();
            if function.kind.is_motion() && plan.motion.replace((function, *fun)).is_some() {
                return self.core.refuse(fun.span, codes::P1005::g_another_move_or_cycle_stand(&fun.number));
            }
        }
        self.check_words(w, &plan, &functions)?;
        Ok(plan)
    }

    #[inline]
    fn function_of(&self, fun: Fun) -> Outcome<&'static Function> {
        match find(fun.number) {
            Some(function) if function.kind != Kind::Refused => Ok(function),
            known => self.no_such_function(fun, known),
        }
    }

    #[cold]
    fn no_such_function<T>(&self, fun: Fun, known: Option<&Function>) -> Outcome<T> {
        if let Some(owner) = belongs(fun.number) {
            let what = known.map_or_else(String::new, |function| format!(" ({})", function.name));
            return self.core.refuse(fun.span, codes::P9011::g_is_function(&fun.number, &what, &owner));
        }
        match known {
            Some(function) => self.core.refuse(fun.span, codes::P9011::g_is_not_supported(&fun.number, &function.name)),
            None => self.core.refuse(fun.span, codes::P9011::g_is_not_known(&fun.number)),
        }
    }

    fn check_same(&self, w: &Words, i: usize) -> Outcome {
        let fun = w.g()[i];
        if w.g()[..i].iter().any(|other| other.number == fun.number) {
            return self.core.refuse(fun.span, codes::P1002::g_stands_twice_in_block(&fun.number));
        }
        Ok(())
    }

    #[inline]
    fn check_words(&self, w: &Words, plan: &Plan, functions: &[Option<&Function>]) -> Outcome {
        let stray = w.present() & !(plan.claimed | GENERAL);
        if stray != 0 {
            return self.stray_letter(w, stray, plan.motion.is_some());
        }
        let marked = |letter: u8| w.get(letter).filter(|num| num.incremental || num.unknown);
        let free = letters("XZ");
        let mut rest = w.present() & !free;
        while rest != 0 {
            let letter = b'A' + rest.trailing_zeros() as u8;
            if let Some(num) = marked(letter) {
                return self.core.refuse(num.span, codes::P1003::takes_plain_number_here(&(letter as char)));
            }
            rest &= rest - 1;
        }
        for (addr, num) in w.longs() {
            let name = addr.to_string();
            if !functions.iter().flatten().any(|function| function.takes(&name)) {
                return self.core.refuse(num.span, codes::P1003::no_function_of_block_takes(&name));
            }
            if num.unknown {
                return self.core.refuse(num.span, codes::P1003::takes_number(&name));
            }
        }
        let named = plan.motion.is_some_and(|(function, _)| function.cycle.is_some_and(Row::takes_name));
        match w.texts().iter().find(|(addr, _)| !(named && addr.to_string() == "ID")) {
            Some((addr, span)) => self.core.refuse(*span, codes::P1003::no_function_of_block_takes_text(&addr)),
            None => Ok(()),
        }
    }

    #[cold]
    fn stray_letter(&self, w: &Words, stray: Letters, moves: bool) -> Outcome {
        let letter = b'A' + stray.trailing_zeros() as u8;
        let span = w.span(letter, self.core.block_span());
        let letter = letter as char;
        if !moves && matches!(letter, 'X' | 'Z') {
            return self.core.refuse(span, codes::T2001::block_has_coordinates());
        }
        if matches!(letter, 'C' | 'Y' | 'U' | 'W') {
            return self.core.refuse(span, codes::T9004::belongs_to_c_axis(&letter));
        }
        self.core.refuse(span, codes::P1003::no_function_of_block_takes(&letter))
    }

    fn before_motion(&mut self, w: &Words, plan: &Plan, text: &[u8]) -> Outcome {
        if let Some(num) = w.get(b'T') {
            self.tool_word(num, text)?;
        }
        for fun in w.g() {
            let function = self.function_of(*fun)?;
            self.modal_function(function.kind, *fun, w)?;
        }
        if let Some(num) = w.get(b'S').filter(|_| plan.claimed & letters("S") == 0) {
            self.speed_word(num)?;
        }
        if let Some(num) = w.get(b'F').filter(|_| plan.claimed & letters("F") == 0) {
            self.feed_word(num)?;
        }
        self.m_at_start(w)
    }

    fn modal_function(&mut self, kind: Kind, fun: Fun, w: &Words) -> Outcome {
        match kind {
            Kind::SpeedLimit => self.speed_limit(w),
            Kind::CuttingSpeed => self.speed_mode(SpeedMode::Cutting, w),
            Kind::Revolutions => self.speed_mode(SpeedMode::Revolutions, w),
            Kind::PerMinute => self.feed_mode(FeedKind::PerMinute, w, true),
            Kind::PerRevolution => self.feed_mode(FeedKind::PerRevolution, w, true),
            Kind::CompensationOff => self.compensation(Side::None, fun),
            Kind::CompensationLeft => self.compensation(Side::Left, fun),
            Kind::CompensationRight => self.compensation(Side::Right, fun),
            Kind::ShiftRelative | Kind::ShiftAdditive | Kind::ShiftAbsolute => self.shift(kind, w),
            Kind::Clearance => self.clearance(w),
            Kind::OversizeParaxial => self.oversize(w, false),
            Kind::OversizeEquidistant => self.oversize(w, true),
            Kind::OversizeOff => {
                self.without_effect(w, b"P", codes::T8017::g52_ends_oversizes_as_g50);
                self.st.oversize = None;
                Ok(())
            }
            Kind::ExactStop => {
                self.st.exact_stop = true;
                self.function(Item::PathControl(Some(PathControl::Exact)));
                Ok(())
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
            | Kind::Refused => Ok(()),
        }
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
        match function.kind {
            Kind::MachineRapid => self.machine_rapid(w),
            Kind::ChangePoint => self.change_point(w),
            Kind::Dwell => self.dwell(w),
            Kind::SingleThread => self.single_thread(w),
            Kind::EndOfContour => self.core.refuse(fun.span, codes::T3003::g80_ends_contour()),
            Kind::Cycle => match function.cycle {
                Some(cycle) => self.begin_cycle(cycle, w),
                None => Err(Reported),
            },
            _ => Err(Reported),
        }
    }

    /// G4
    fn dwell(&mut self, w: &Words) -> Outcome {
        let num = self.needed(w, b'F', "the time in seconds", self.core.block_span())?;
        if num.value < 0.0 {
            return self.core.refuse(num.span, codes::T1007::dwell_time_is_not_negative());
        }
        self.function(Item::Dwell(num.value));
        Ok(())
    }
}

/// Which function takes which words.
#[derive(Debug)]
struct Plan {
    motion: Option<(&'static Function, Fun)>,
    claimed: Letters,
    /// G0 to G3, G12, G13 and nothing else.
    only_path: bool,
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
