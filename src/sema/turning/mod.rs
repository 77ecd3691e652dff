//! Runs a HEIDENHAIN turning program: 4110 DIN programs, DIN PLUS and smart.Turn files.
//!
//! X words are diameters here and radii in the contour stream; the working plane is ZX, so points are (Z, X).
//! Source: T 2 to 7 and 13 (docs/sources.md).

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
use crate::ir::contour::{Move, Sink};
use crate::ir::{Function, Side};
use crate::machine::Compensation;
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::parser::turning::ast::{Block, Stmt};
use crate::parser::turning::{SPLIT, parse_block, problem};
use crate::text::{Span, SplitRules};
pub use cycles::signatures as cycle_signatures;
pub use survey::survey;

use super::run::{self, Interpreter, Language, Level, Parsed};
use super::value::Machine;
use super::{Job, Outcome, Reported};
use calls::{Frame, Names};
use capture::Capture;
use chain::Chain;
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
        calls: 1,
        sections: Sections::new(job.settings),
        geometry: Geometry::default(),
        named: None,
        capture: None,
        chain: Chain::default(),
        machine: Machine::new(eval::RULES),
        words: Some(Box::default()),
    };
    if run::run(&mut run) { run.core.hash() } else { 0 }
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
    /// Calls made so far, the main program included.
    calls: u32,
    sections: Sections,
    geometry: Geometry,
    /// The contour that ID of the cycle in hand names.
    named: Option<String>,
    /// The cycle whose contour is being read.
    capture: Option<Box<Capture>>,
    /// Moves that wait for the next one.
    chain: Chain<Tag>,
    machine: Machine,
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
        if let Some(comment) = block.comment {
            self.comment(comment.of(text));
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

    fn finish(&mut self) {
        self.report_open();
    }
}

impl Run<'_> {
    fn statement(&mut self, block: &Block, text: &[u8]) -> Outcome {
        if self.sections.is_unread() && !matches!(block.stmt, Stmt::Section(..)) {
            return Ok(());
        }
        if self.sections.part == ProgramPart::Names && !matches!(block.stmt, Stmt::Section(..)) {
            return self.names_line();
        }
        if let Some(slide) = block.slide.filter(|slide| *slide != 1) {
            return self.slide(slide);
        }
        match block.stmt {
            Stmt::Empty => Ok(()),
            Stmt::Words => self.words_block(block, text),
            Stmt::Bad => {
                self.lose_all();
                Err(Reported)
            }
            Stmt::Program(_) => self.program_line(),
            Stmt::Head { key, value } => self.head_line(key.of(text), value.of(text), value),
            Stmt::Section(section, rest) => self.section(section, rest, text),
            Stmt::Unit => self.unit(true),
            Stmt::EndUnit => self.unit(false),
            Stmt::Slide(number) => self.slide(number),
            Stmt::Refused(word) => {
                self.lose_all();
                let problem = problem::keyword(word, text);
                self.core.report_problem(problem);
                Err(Reported)
            }
            _ => self.flow_block(block),
        }
    }

    fn comment(&mut self, text: &[u8]) {
        if !self.sections.is_unread()
            && let Some(comment) = self.core.comment_of(text)
        {
            self.function(comment);
        }
    }

    #[inline]
    fn movement(&mut self, mv: &Move) {
        self.core.send_move(mv, &self.st.ctx);
    }

    fn function(&mut self, function: Function) {
        self.core.send_function(&function, &self.st.ctx);
    }

    /// Nobody knows where the tool is.
    fn lose_all(&mut self) {
        self.chain.clear();
        self.st.lose();
        self.core.send_lost(&self.st.ctx);
    }

    /// End of the whole run: what is still open is worth a word.
    fn report_open(&mut self) {
        if let Some(capture) = self.capture.take() {
            self.core.report(codes::T3003::contour_of_this_cycle_has_no_end().at(capture.loc()));
        }
        let _ = self.settle_chain();
        // Of a contour that is computed the path itself tells.
        let computed = self.core.job.settings.output.compensation == Compensation::Resolve;
        if self.st.compensation.is_on() && !(computed && self.st.compensation.sent() != Side::None) {
            self.core.report(codes::T2021::program_ends_with_nose_radius_compensation().at(self.core.here.origin.loc));
        }
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
