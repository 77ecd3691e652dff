//! Meaning: runs a program as its control would and says what was programmed, as contour items.
//!
//! In: files and settings. Out: items for [`Sink`](crate::ir::contour::Sink), diagnostics. The only writer
//! of modal state. One folder per dialect; what they share stands here.

pub mod chain;
pub mod common;
pub mod cycle;
pub mod gcode;
pub mod klartext;
pub mod mtc200;
pub mod run;
pub mod sinumerik;
pub mod turning;
pub mod value;

use crate::diag::{Answer, Diagnostic, Diags, Trail, codes};
use crate::machine::{Settings, Unit};
use crate::text::{FileId, Files, Loc, Sources};

/// A block that could not be executed, or a value that could not be computed; the reason was reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reported;

pub type Outcome<T = ()> = Result<T, Reported>;

/// What a run of a program works with.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    pub sources: &'a Sources,
    pub diags: &'a Diags,
    pub trail: &'a Trail,
    pub files: &'a dyn Files,
    pub settings: &'a Settings,
    /// The program to run.
    pub main: FileId,
}

impl Job<'_> {
    /// The program calls a tool while its lengths are in this unit: those of a table should be, too.
    pub fn calls_tool_in(&self, unit: Unit, from: Loc) {
        let tools = &self.settings.tools;
        if tools.unit.is_some_and(|of_table| of_table != unit) {
            self.diags.push_once(other_unit(unit, from));
        }
    }

    /// Does the control skip a block for its `/`? `mark` is the number behind it, 0 for none. Level 1 takes the plain
    /// mark along, for users count from the first one.
    #[inline]
    pub fn skips(&self, mark: Option<u8>) -> bool {
        match mark {
            None => false,
            Some(mark) => self.settings.control.skip_blocks.iter().any(|on| *on == mark || mark == 0 && *on == 1),
        }
    }
}

#[cold]
fn other_unit(unit: Unit, from: Loc) -> Diagnostic {
    let (program, table) = if unit == Unit::Inch { ("inch", "mm") } else { ("mm", "inch") };
    let unit = Answer::key("tools", "unit").one_of(&["\"mm\"", "\"inch\""]);
    codes::P0130::program_calls_tool(&program, &table).answer(unit).at(from)
}

impl std::fmt::Debug for Job<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Job").field("main", &self.main).finish_non_exhaustive()
    }
}
