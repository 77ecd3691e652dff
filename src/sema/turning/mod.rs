//! Runs a HEIDENHAIN turning program: 4110 DIN programs, DIN PLUS and smart.Turn files.
//!
//! X words are diameters here and radii in the contour stream; the working plane is ZX, so points are (Z, X).
//! Source: T 2 to 7 and 13 (docs/sources.md).

mod blank;
mod block;
mod called_contour;
mod calls;
mod capture;
mod chain;
mod contour_words;
mod cycle_call;
mod cycles;
mod element_data;
mod eval;
mod flow;
mod forms;
mod frames;
mod g_functions;
mod geometry;
mod geometry_forms;
mod m_functions;
mod other_axes;
mod outline;
mod path;
mod program_parts;
mod readings;
mod sections;
mod sides;
mod spindle;
mod state;
mod stock;
mod survey;
mod technology;
mod tool_facts;
mod tool_side;
mod undercuts;
mod vars;
mod words;

use crate::diag::codes;
use crate::ir::Side;
use crate::ir::contour::Sink;
use crate::machine::Compensation;
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::parser::turning::ast::{Block, Stmt};
use crate::parser::turning::{SPLIT, parse_block, problem};
use crate::text::{Span, SplitRules};
pub use cycles::signatures as cycle_signatures;
pub use survey::survey;

use super::run::{self, Interpreter, Language, Level, Parsed, Where};
use super::{Job, Outcome, Reported};
use calls::{Frame, Names};
use capture::Capture;
use chain::Chain;
use eval::Computing;
use geometry::Geometry;
use path::Tag;
use program_parts::ProgramPart;
use sections::Sections;
use state::State;
use vars::Vars;
use words::Words;

/// Runs the main program of `job`; items go to `out`. Returns the hash of the main program's text.
pub fn run(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    let mut run = Run {
        core: Core::new(job, out),
        st: State::new(job.settings),
        vars: Vars::new(&job.settings.variables),
        sections: Sections::new(job.settings),
        geometry: Geometry::default(),
        named: None,
        capture: None,
        chain: Chain::default(),
        words: Some(Box::default()),
    };
    run::run(&mut run)
}

/// Reads every block of the main program, whether it runs or not, and reports what is wrong with its form.
pub fn check_form(job: &Job<'_>) {
    run::unexecuted::check_form::<Turning>(job);
}

/// How the text of a program is read.
#[derive(Debug, Default)]
struct Turning;

impl Language for Turning {
    type Block = Block;
    /// Local subprograms, once they were looked for.
    type Known = Option<Names>;
    type Frame = Frame;

    const SPLIT: SplitRules = SPLIT;

    #[inline]
    fn parse(&mut self, text: &[u8], into: &mut Parsed<Block>, _: &mut Symbols, problems: &mut Vec<Problem>) {
        parse_block(text, &mut into.block, problems);
        if needs_text(&into.block) {
            into.text.extend_from_slice(text);
        }
    }

    #[inline]
    fn span(block: &Block) -> Span {
        block.span
    }

    #[inline]
    fn operations(block: &Block) -> usize {
        block.ops.len()
    }
}

/// Files, call stack and findings of a run.
type Core<'a> = run::Core<'a, Turning>;

/// A run of a program.
struct Run<'a> {
    core: Core<'a>,
    st: State,
    vars: Vars,
    sections: Sections,
    geometry: Geometry,
    /// The contour that ID of the cycle in hand names.
    named: Option<String>,
    /// The cycle whose contour is being read.
    capture: Option<Box<Capture>>,
    /// Moves that wait for the next one.
    chain: Chain<Tag>,
    words: Option<Box<Words>>,
}

impl<'a> Interpreter<'a> for Run<'a> {
    type Language = Turning;

    #[inline]
    fn core(&mut self) -> &mut Core<'a> {
        &mut self.core
    }

    fn begin(&mut self, program: usize) -> Level<Frame> {
        self.core.begins_at(&self.st.position.start());
        Level::main(program, Frame::main())
    }

    fn execute(&mut self, block: &Block, text: &[u8]) {
        if self.core.skips(block.skip) {
            return;
        }
        if let Some(comment) = block.comment.filter(|_| !self.sections.is_unread()) {
            self.core.send_comment(comment.of(text), &self.st.ctx);
        }
        if block.stmt == Stmt::Empty {
            return;
        }
        // What went wrong was reported; the next block may show more.
        let _ = self.statement(block, text);
    }

    fn end_of_file(&mut self) {
        self.file_over();
    }

    fn unread_block(&mut self) {
        self.lose_all();
    }

    /// What stands in a section that is not read is of no interest.
    fn forgive(&mut self, _: &Block) {
        if self.sections.is_unread() || self.sections.part == ProgramPart::Names {
            self.core.problems.clear();
        }
    }

    /// What is still open is worth a word.
    fn finish(&mut self) {
        if let Some(capture) = self.capture.take() {
            self.core.report(codes::T3003::contour_of_this_cycle_has_no_end().at(capture.loc()));
        }
        let _ = self.settle_chain();
        // Of a contour that is computed the path itself tells.
        let computed = self.core.job.settings.output.compensation == Compensation::Resolve;
        if self.st.compensation.is_on() && !(computed && self.st.compensation.sent() != Side::None) {
            self.core.say_here(codes::T2021::program_ends_with_nose_radius_compensation());
        }
    }
}

impl Run<'_> {
    fn statement(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let is_section = matches!(block.stmt, Stmt::Section(..));
        if self.sections.is_unread() && !is_section {
            return Ok(());
        }
        if self.sections.part == ProgramPart::Names && !is_section {
            return self.core.names_line();
        }
        let here = if let Stmt::Slide(number) = block.stmt { Some(number) } else { None };
        if let Some(slide) = block.slide.filter(|slide| *slide != 1).or(here.filter(|slide| *slide != 1)) {
            self.lose_all();
            return self.core.other_slide(slide);
        }
        match block.stmt {
            Stmt::Empty | Stmt::Slide(_) => {}
            Stmt::Section(section, rest) => return self.section(section, rest, text),
            Stmt::Words => return self.words_block(block, text),
            Stmt::Bad => {
                self.lose_all();
                return Err(Reported);
            }
            Stmt::Program(_) => {
                let begun = std::mem::replace(&mut self.core.level().frame.begun, true);
                return self.core.accept(Where::Block, self.sections.program_line(begun));
            }
            Stmt::Head { key, value } => {
                let unit = self.core.made(self.sections.head_line(key.of(text), value.of(text), value))?;
                self.st.unit = unit.unwrap_or(self.st.unit);
            }
            Stmt::Unit | Stmt::EndUnit => {
                self.settle_chain()?;
                if let Some(fault) = self.sections.unit(block.stmt == Stmt::Unit) {
                    self.core.say_here(fault);
                }
            }
            Stmt::Refused(word) => {
                self.lose_all();
                self.core.report_problem(problem::keyword(word, text));
                return Err(Reported);
            }
            _ => {
                self.settle_chain()?;
                if !self.sections.part.is_executed() || self.capture.is_some() {
                    let fault = codes::T1008::variables_program_flow_belong_into_section_machining();
                    return self.core.refuse(block.span, fault);
                }
                self.sections.settle_family();
                self.core.level().frame.begun = true;
                let Run { core, vars, .. } = self;
                return (Computing { core, vars }).flow_block(block);
            }
        }
        Ok(())
    }
}

/// Does executing the block need more of its text than the spans of its words?
fn needs_text(block: &Block) -> bool {
    use crate::parser::turning::ast::Value;
    let worded = |word: &crate::parser::turning::ast::Word| {
        matches!(word.value, Value::Text(_)) || word.address.addr.letter() == Some(b'T')
    };
    block.comment.is_some()
        || match block.stmt {
            Stmt::Words => block.words.iter().any(worded),
            Stmt::Empty => false,
            _ => true,
        }
}
