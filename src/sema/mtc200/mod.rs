//! Runs an MTC200 program: an explicit program counter and call stack, NC variables, modal state.
//!
//! Every block is resolved completely in its turn, so the programmed position is always known here. The order
//! inside a block is: modal G functions, S, T, M functions that start something, motion or offset, corner, M
//! functions that end something, program flow. Source: M 1, 2, 6.5 (docs/sources.md).

mod centre;
mod dimensions;
mod eval;
mod flow;
mod g_functions;
mod header;
mod length;
mod m_functions;
mod offsets;
mod path;
mod readings;
mod reserved;
mod spindle;
mod state;
mod strange;
mod survey;
mod tool;
mod words;

use std::rc::Rc;

use crate::diag::{Diags, codes};
use crate::geo::Plane;
use crate::ir::contour::{Ctx, Sink};
use crate::ir::function::PathControl;
use crate::ir::{Function, Side};
use crate::machine::options::mtc200::Reading;
use crate::machine::{Compensation, Unit};
use crate::parser::mtc200::ast::{Block, Stmt, Target, Value};
use crate::parser::mtc200::{SPLIT, parse_block};
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::text::{Span, SplitRules};

use super::common::compensation::compensate;
use super::common::feed::FeedKind;
use super::run::{self, Interpreter, Language, Level, Nowhere, Parsed};
use super::{Job, Outcome, Reported};
use centre::Settled;
use eval::{Computing, Variables};
use flow::{Frame, Labels};
use g_functions::{G, Group, Motion};
use header::Header;
use path::{feed_word, roles};
use state::State;
use words::{AxisNames, ToolData, Words, Written};

pub use survey::survey;

/// Runs the main program of `job`; items go to `out`. Returns the hash of the main program's text.
pub fn run(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    run::run(&mut Run::new(job, out, Settled::default()))
}

/// Looks through the program for arcs that decide what their centres count from.
fn scout(job: &Job<'_>) -> Settled {
    let diags = Diags::default();
    let quiet = Job { diags: &diags, ..*job };
    let mut nowhere = Nowhere;
    let mut run = Run::new(&quiet, &mut nowhere, Settled::scout());
    run::run(&mut run);
    run.settled
}

/// Reads every block of the main program, whether it runs or not, and reports what is wrong with its form.
pub fn check_form(job: &Job<'_>) {
    run::unexecuted::check_form::<Mtc200>(job);
}

/// How the text of a program is read.
#[derive(Debug, Default)]
struct Mtc200;

impl Language for Mtc200 {
    type Block = Block;
    type Known = Known;
    type Frame = Frame;

    const SPLIT: SplitRules = SPLIT;

    #[inline]
    fn parse(&mut self, text: &[u8], into: &mut Parsed<Block>, symbols: &mut Symbols, problems: &mut Vec<Problem>) {
        parse_block(text, &mut into.block, symbols, problems);
        into.text.extend_from_slice(text);
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

/// What is known of a program file.
#[derive(Debug, Default)]
struct Known {
    labels: Option<Labels>,
    header: Header,
    /// Offset of the first block that did something.
    first: Option<u32>,
    /// It was looked whether another program stands behind it.
    alone: bool,
}

/// Files, call stack and findings of a run.
type Core<'a> = run::Core<'a, Mtc200>;

/// A run of a program.
struct Run<'a> {
    core: Core<'a>,
    st: State,
    axis_names: AxisNames,
    variables: Variables,
    settled: Settled,
    words: Option<Box<Words>>,
}

impl<'a> Run<'a> {
    fn new(job: &Job<'a>, out: &'a mut dyn Sink, settled: Settled) -> Run<'a> {
        Run {
            core: Core::new(job, out),
            st: State::new(job.settings),
            axis_names: AxisNames::new(job.settings.machine.geometry_axes),
            variables: Variables::new(job.settings),
            settled,
            words: None,
        }
    }
}

impl<'a> Interpreter<'a> for Run<'a> {
    type Language = Mtc200;

    #[inline]
    fn core(&mut self) -> &mut Core<'a> {
        &mut self.core
    }

    fn begin(&mut self, program: usize) -> Level<Frame> {
        self.core.refuse_known_words();
        self.core.begins_at(&self.st.position.start());
        Level::main(program, Frame::default())
    }

    #[inline]
    fn execute(&mut self, block: &Block, text: &[u8]) {
        if let Stmt::Header(first) = block.stmt {
            if let Some(comment) = self.core.header_line(first, block, text) {
                self.core.send_comment(comment, &self.st.ctx);
            }
            return;
        }
        if !matches!(self.core.program().known.header, Header::Closed | Header::None) {
            self.core.leave_header(block);
        }
        if self.core.skips(block.skip.then_some(0)) {
            return;
        }
        for comment in &block.comments {
            self.core.send_comment(comment.of(text), &self.st.ctx);
        }
        match block.stmt {
            Stmt::Empty | Stmt::Header(_) => {}
            Stmt::Bad => self.unread_block(),
            Stmt::Words => {
                let at = self.core.here.at;
                self.core.program().known.first.get_or_insert(at);
                if self.words_block(block, text).is_err() {
                    self.st.motion.lose();
                    g_functions_of(block).for_each(|g| self.st.assume(g));
                    self.lose_all();
                }
            }
        }
    }

    fn end_of_file(&mut self) {
        self.file_over();
    }

    fn unread_block(&mut self) {
        self.st.motion.lose();
        self.lose_all();
    }

    fn finish(&mut self) {
        self.core.report_no_change();
    }
}

/// The G functions of a block that was refused, as far as they are written in numbers.
fn g_functions_of(block: &Block) -> impl Iterator<Item = G> {
    block.words.iter().filter_map(|word| {
        let (Target::Letter(b'G'), Value::Literal(number)) = (word.target, word.value) else { return None };
        let whole = (0.0..=999.0).contains(&number) && number.fract() == 0.0;
        g_functions::entry(number as u32).filter(|_| whole).map(|(_, g)| g)
    })
}

impl Run<'_> {
    fn words_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let Run { core, variables, .. } = self;
        if (Computing { core, variables }).assignments(block)? {
            return self.count_between();
        }
        let w = self.gather(block, text)?;
        let result = self.act_on(&w);
        self.words = Some(w);
        result
    }

    /// Evaluates the words of a block.
    fn gather(&mut self, block: &Block, text: &[u8]) -> Outcome<Box<Words>> {
        let mut w = self.words.take().unwrap_or_default();
        w.clear();
        let sorted = block.words.iter().try_for_each(|word| {
            let Run { core, variables, axis_names: axes, .. } = self;
            match w.sort_in(word, Written { block, text, axes }, &mut Computing { core, variables })? {
                None => Ok(()),
                Some(data) => {
                    self.choose_tool_data(&data)?;
                    w.take_in(&data, &self.core)
                }
            }
        });
        if !w.strange.is_empty() {
            self.core.settle_strange(&mut w);
        }
        sorted.map(|()| w)
    }

    /// D or E: both choose lengths and a radius that only the machine knows. The radius counts under G41 and G42, the lengths
    /// unless G47 has switched them off.
    fn choose_tool_data(&mut self, data: &ToolData) -> Outcome {
        let span = data.at.span;
        if self.st.tool.choose(data) && self.st.length.counts() {
            self.core.length_is_another(data.letter, span);
        } else {
            self.core.without_geometry(if data.letter == 'D' { "D" } else { "E" }, span);
        }
        let computed = self.core.job.settings.output.compensation == Compensation::Resolve;
        if computed && self.st.compensation.is_on() {
            return self.core.accept(span, self.st.tool.radius_is_that_of_the_table());
        }
        Ok(())
    }

    /// Everything a block of words does, in order.
    #[inline]
    fn act_on(&mut self, w: &Words) -> Outcome {
        self.core.check_m(w)?;
        self.core.m_reading(w);
        let once = w.g[Group::Once as usize].map(|(g, _)| g);
        let ends = w.m().iter().any(|(number, _)| matches!(number, 2 | 30));
        if let (true, Some(flow)) = (ends, w.flow) {
            return self.core.refuse(flow.span, codes::P1003::block_ends_program_and_goes_on());
        }
        if once == Some(G::Dwell) {
            return self.dwell(w);
        }
        self.modal_functions(w)?;
        self.values(w, once == Some(G::SpeedLimit))?;
        let arcs = self.st.motion.code().is_some_and(Motion::is_arc);
        let moves = once.is_none() && (!w.axes.known().is_empty() || w.has_centre() || (arcs && w.radius.is_some()));
        self.m_at_start(w, moves)?;
        let span = w.g_spans[Group::Once as usize];
        match once {
            Some(g @ (G::ShiftTo | G::ShiftBy | G::Name)) => {
                self.core.made(w.no_path_words(true))?;
                self.programmed_offset(g, w, span)?;
            }
            Some(G::Home) => {
                self.core.made(w.no_path_words(true))?;
                self.home(w, span)?;
            }
            Some(_) if !w.axes.known().is_empty() => {
                return self.core.refuse(w.axes_span, codes::P1003::axis_words_beside_g92());
            }
            None if moves => self.motion(w)?,
            once => self.core.made(w.no_path_words(once.is_some()))?,
        }
        if w.program.is_some() {
            self.core.made(w.check_p(self.st.motion.code()))?;
        }
        if w.chamfer.is_some() || w.rounding.is_some() {
            self.corner(w)?;
        } else if !moves {
            self.count_between()?;
        }
        if !w.m().is_empty() {
            self.m_at_end(w)?;
        }
        match w.flow {
            Some(flow) if !self.core.has_ended() => self.go_on(flow, w),
            _ => Ok(()),
        }
    }

    /// F, T and S of a block; `limit`: S is that of G92.
    #[inline]
    fn values(&mut self, w: &Words, limit: bool) -> Outcome {
        let settings = self.core.job.settings;
        if let Some(at) = w.feed {
            self.core.relies_on_the_start(&mut self.st.feed_said, at.span);
            let zero_keeps = settings.control.mtc200.zero_feed_keeps;
            let feed = feed_word(&self.st.feed, at, self.st.dimensions.unit(), zero_keeps);
            if let Some(feed) = self.core.made(feed)? {
                self.st.feed.program(feed);
            }
        }
        if let Some(at) = w.tool {
            self.tool_word(at, w.m().iter().any(|(number, _)| *number == 6))?;
        }
        match w.speed {
            Some(at) => {
                let spindle = spindle::speed(&mut self.st.spindle, at, limit, self.st.dimensions, settings);
                if let Some(spindle) = self.core.made(spindle)? {
                    self.core.send_function(&Function::Spindle(spindle), &self.st.ctx);
                }
                Ok(())
            }
            None if limit => self.core.refuse(w.g_spans[Group::Once as usize], codes::P1004::g92_needs_its_s()),
            None => Ok(()),
        }
    }

    /// G04.
    #[cold]
    fn dwell(&mut self, w: &Words) -> Outcome {
        let at = self.core.made(w.dwell_time())?;
        self.core.reading(Reading::Dwell, at.span, codes::P8106::f_of_g04_counts_in_seconds);
        let unit = if self.core.job.settings.control.mtc200.dwell_ms { 1e-3 } else { 1.0 };
        self.core.send_function(&Function::Dwell(at.value * unit), &self.st.ctx);
        self.count_between()
    }

    /// Modal G functions; they hold for their own block already.
    #[inline]
    fn modal_functions(&mut self, w: &Words) -> Outcome {
        // G62 beside G08 ends the exact stop first.
        for group in [Group::ExactStop, Group::Unit, Group::Diameter] {
            if let Some((g, number)) = w.g[group as usize] {
                self.modal(g, number, w.g_spans[group as usize], w)?;
            }
        }
        for (i, slot) in w.g.iter().enumerate() {
            let Some((g, number)) = slot else { continue };
            if !matches!(g, G::ExactStop(_) | G::Inch(_) | G::Diameter(_)) {
                self.modal(*g, *number, w.g_spans[i], w)?;
            }
        }
        Ok(())
    }

    #[inline]
    fn modal(&mut self, g: G, number: u32, span: Span, w: &Words) -> Outcome {
        match g {
            G::Motion(motion) => self.st.motion.program(motion),
            G::Plane(plane) => return self.set_plane(plane, span),
            G::Incremental(on) => (self.st.dimensions.incremental, self.st.dimensions.said) = (on, true),
            G::Diameter(on) => {
                self.st.dimensions.diameter = on;
                let what = codes::P8106::g16_switches_diameters_on;
                self.core.reading(Reading::DiameterCodes, span, what);
            }
            G::Inch(on) => self.st.dimensions.inch = on,
            G::Smooth if self.st.exact_stop => {
                return self.core.refuse(span, codes::M2013::g08_cannot_be_programmed_while_g61());
            }
            G::ExactStop(on) => {
                self.st.exact_stop = on;
                let control = Function::PathControl(on.then_some(PathControl::Exact));
                self.core.send_function(&control, &self.st.ctx);
            }
            G::Side(side) => return self.set_side(side, span, w),
            G::Chamfers(on) => {
                (self.st.transition.chamfers, self.st.transition.said) = (on, true);
                if self.core.job.settings.output.compensation == Compensation::Control {
                    self.core.without_geometry(&format!("G{number}"), span);
                }
            }
            G::Length(on) => {
                if self.core.job.diags.first_time(codes::M8002, ()) {
                    self.core.say(span, codes::M8002::has_no_word_in_output(&format_args!("G{number}")));
                }
                for letter in self.st.tool.chosen().filter(|_| on) {
                    self.core.length_is_another(letter, span);
                }
                let [_, _, axis] = roles(self.st.ctx.plane);
                return self.st.length.switch(on, axis, &self.core);
            }
            G::Offset(offset) => return self.set_offset(offset, span),
            G::PerRevolution(on) => {
                self.st.feed.switch(FeedKind::per_revolution(on));
                self.st.feed_said = true;
            }
            G::ConstantSpeed(on) => {
                return self.core.accept(span, spindle::count(&mut self.st.spindle, on, w));
            }
            G::Smooth | G::Nothing => self.core.without_geometry(&format!("G{number}"), span),
            G::Dwell | G::ShiftTo | G::ShiftBy | G::Name | G::Home | G::SpeedLimit => {}
        }
        Ok(())
    }

    fn set_plane(&mut self, plane: Plane, span: Span) -> Outcome {
        if plane == self.st.ctx.plane {
            return Ok(());
        }
        if self.st.compensation.is_on() || self.st.corners.is_open() {
            return self.core.refuse(span, codes::P1003::working_plane_changes_inside_compensated_contour());
        }
        self.core.accept(span, self.st.tool.length_acts_along_z(plane, self.core.job.settings))?;
        self.st.corners.cannot_follow();
        self.st.ctx = Rc::new(Ctx { plane, ..(*self.st.ctx).clone() });
        Ok(())
    }

    /// G40, G41, G42.
    fn set_side(&mut self, side: Side, span: Span, w: &Words) -> Outcome {
        let settings = self.core.job.settings;
        if side != Side::None {
            let Some(tool) = self.st.tool.active else {
                return self.core.refuse(span, codes::M2012::path_compensation_without_tool());
            };
            if ![Side::None, side].contains(&self.st.compensation.sent()) {
                return self.core.refuse(span, codes::P1003::g41_g42_follow_each_other_without_g40());
            }
            if settings.output.compensation == Compensation::Resolve {
                let unit = if self.st.dimensions.inch { Unit::Inch } else { Unit::Mm };
                self.core.job.calls_tool_in(unit, self.core.loc(span));
                let rules = self.core.accept(span, self.st.tool.rules(tool, self.st.ctx.plane, settings))?;
                self.st.transition.begin();
                compensate(&mut self.st.ctx, rules);
                let says = w.g.iter().flatten().any(|(g, _)| matches!(g, G::Chamfers(_)));
                if !(says || self.st.transition.said) {
                    let what = codes::P8106::g43_is_in_force_at_start;
                    self.core.reading(Reading::Transition, span, what);
                }
            }
        }
        self.st.compensation.select(side);
        Ok(())
    }
}
