//! The call stack: what its levels hold, and how repeats and calls add to it.
//!
//! Source: S 5.5 and 5.6 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::parser::symbols::Symbol;
use crate::sema::run::{Level, Where};
use crate::text::{Loc, Place};

use super::state::Saved;
use super::value::whole;
use super::vars::{Argument, Reference};
use super::{Core, Outcome};

/// Most passes of a program or a repeat.
const MOST_PASSES: i32 = 9999;

/// What a level of the call stack holds.
#[derive(Debug)]
pub(super) struct Frame {
    pub kind: FrameKind,
    /// The program that runs on this level.
    pub unit: usize,
    /// The FOR that ENDFOR came from.
    pub counting: Option<u32>,
    /// Arguments that wait for PROC.
    pub arguments: Option<Vec<Argument>>,
    /// Which parameters the call gave.
    pub given: Vec<bool>,
    /// Something was executed, so DEF is too late.
    pub executed: bool,
    /// The definition part has begun, so PROC is too late.
    pub declares: bool,
    /// A further pass of a call: the parameters keep their values.
    pub further_pass: bool,
}

#[derive(Debug)]
pub(super) enum FrameKind {
    Main,
    Program {
        passes: u32,
        /// Runs up to this offset only.
        stop: Option<u32>,
        start: Place,
        /// State that SAVE brings back.
        saved: Option<Box<Saved>>,
        /// Values that go back to the caller: parameter and what it stands for.
        references: Vec<(Symbol, Reference)>,
        modal: bool,
    },
    /// REPEAT: a section of the same program.
    Section {
        from: Place,
        stop: u32,
        left: u32,
    },
}

impl Frame {
    pub fn main(unit: usize) -> Frame {
        Frame::new(FrameKind::Main, unit, false)
    }

    /// A level on which blocks of `unit` run; `inside` where they stand behind its definitions.
    pub fn new(kind: FrameKind, unit: usize, inside: bool) -> Frame {
        let (executed, declares) = (inside, inside);
        let (counting, arguments, given, further_pass) = (None, None, Vec::new(), false);
        Frame { kind, unit, counting, arguments, given, executed, declares, further_pass }
    }
}

/// What ran up to its last block.
pub(super) enum PartEnds {
    /// A section of a repeat; one that is not over goes round again.
    Section { over: bool },
    /// A part of a program, which has to be left.
    Program,
}

/// The program that runs.
pub(super) fn unit(levels: &[Level<Frame>]) -> usize {
    levels.last().map_or(0, |level| level.frame.unit)
}

fn of_program(levels: &[Level<Frame>]) -> usize {
    levels.iter().rposition(|level| !matches!(level.frame.kind, FrameKind::Section { .. })).unwrap_or(0)
}

/// What the level of a program holds, below any repeats.
pub(super) fn program(levels: &mut [Level<Frame>]) -> &mut Frame {
    let at = of_program(levels);
    &mut levels[at].frame
}

/// The block that called the program that runs.
pub(super) fn call_site(levels: &[Level<Frame>]) -> Loc {
    levels[of_program(levels)].site
}

/// Does the main program run?
pub(super) fn in_main(levels: &[Level<Frame>]) -> bool {
    matches!(levels[of_program(levels)].frame.kind, FrameKind::Main)
}

/// Calls on the stack.
pub(super) fn calls(levels: &[Level<Frame>]) -> usize {
    levels.iter().filter(|level| matches!(level.frame.kind, FrameKind::Program { .. })).count()
}

/// A number of passes.
pub(super) fn passes(value: f64) -> Result<u32, Fault> {
    let fits = |n: &i32| (1..=MOST_PASSES).contains(n) && (f64::from(*n) - value).abs() < 1e-6;
    match whole(value).filter(fits) {
        Some(n) => Ok(n as u32),
        None => Err(codes::S2019::p_is_no_number_of_passes(&value)),
    }
}

impl Core<'_> {
    /// An executable block: DEF is too late from here on, arguments without PROC are too many.
    pub(super) fn begins_executing(&mut self) {
        let level = program(&mut self.levels);
        if level.executed {
            return;
        }
        level.executed = true;
        if level.arguments.is_some() {
            self.refuse_arguments();
        }
    }

    /// A call waits for a PROC that does not come.
    pub(super) fn refuse_arguments(&mut self) {
        let argument = program(&mut self.levels).arguments.take().and_then(|list| list.into_iter().next());
        if let Some(argument) = argument {
            let found = codes::S2021::arguments_are_given().at(argument.loc);
            self.report(found.help("write `PROC NAME(…)` as the first block of the called program"));
        }
    }

    pub(super) fn enter_section(&mut self, from: Place, stop: u32, times: u32) -> Outcome {
        self.check_depth()?;
        let (site, back) = (self.here.origin.loc, self.program().source.cursor.place());
        let level = self.level();
        let (program, unit, call) = (level.program, level.frame.unit, level.call);
        let frame = Frame::new(FrameKind::Section { from, stop, left: times - 1 }, unit, true);
        self.levels.push(Level { program, back, call, site, frame });
        self.note_jump();
        self.resume(from)
    }

    pub(super) fn check_depth(&self) -> Outcome {
        if self.levels.len() < self.job.settings.limits.call_depth {
            return Ok(());
        }
        self.stop_run();
        let help = self.cycle_of_calls().unwrap_or_else(|| "call or repeat in fewer levels".to_owned());
        self.refuse(Where::Block, codes::P4003::programs_repeats_are_nested_deeper(&self.levels.len()).help(help))
    }

    /// Ends the section, or its pass, that ran up to its last block; of a part of a program it only says so.
    pub(super) fn part_ends(&mut self, at: u32) -> Option<PartEnds> {
        let level = self.level();
        let back = level.back;
        let (goes_on, over) = match &mut level.frame.kind {
            FrameKind::Section { from, stop, left } if at >= *stop || at < from.at => {
                let again = *left > 0;
                *left -= u32::from(again);
                (if again { *from } else { back }, !again)
            }
            FrameKind::Program { stop: Some(stop), .. } if at >= *stop => return Some(PartEnds::Program),
            _ => return None,
        };
        if over {
            self.levels.pop();
        }
        // A file that was read once can be read again.
        let _ = self.resume(goes_on);
        Some(PartEnds::Section { over })
    }

    /// Goes on at `place` of the current program. Repeats that do not hold the place end.
    pub(super) fn go_to(&mut self, place: Place) -> Outcome {
        while let FrameKind::Section { from, stop, .. } = self.level().frame.kind
            && !(from.at <= place.at && place.at < stop)
        {
            self.levels.pop();
        }
        self.resume(place)
    }

    pub(super) fn resume(&mut self, place: Place) -> Outcome {
        if place.at <= self.here.at {
            self.note_jump();
        }
        self.seek(place)
    }
}
