//! Runs an MTC200 program: an explicit program counter and call stack, NC variables, modal state.
//!
//! Every block is resolved completely in its turn, so the programmed position is always known here. The order
//! inside a block is: modal G functions, S, T, M functions that start something, motion or offset, corner, M
//! functions that end something, program flow. Source: M 1, 2, 6.5 (docs/sources.md).

mod centre;
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
mod state;
mod strange;
mod survey;
mod words;

use crate::sema::common::feed::FeedKind;
use std::rc::Rc;

use rustc_hash::FxHashSet;

use crate::diag::{Answer, Diags, codes};
use crate::geo::Plane;
use crate::ir::Function;
use crate::ir::contour::{Corner, Ctx, Move, Sink};
use crate::ir::function::PathControl;
use crate::machine::options::mtc200::Reading;
use crate::machine::{Axis, Compensation};
use crate::parser::mtc200::ast::{Block, Stmt, Target, Value};
use crate::parser::mtc200::{SPLIT, parse_block};
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::text::{Span, SplitRules};

use super::run::{self, Interpreter, Language, Level, Nowhere, Parsed};
use super::value::Machine;
use super::{Job, Outcome, Reported};
use centre::Settled;
use flow::{Frame, Labels};
use g_functions::Motion;
use g_functions::{G, Group};
use header::Header;
use state::State;
use words::Words;

pub use survey::survey;

/// Runs the main program of `job`; items go to `out`. Returns the hash of the main program's text.
pub fn run(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    let mut run = Run::new(job, out, Settled::default());
    if run::run(&mut run) { run.core.hash() } else { 0 }
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
    /// Axis of each letter.
    axis_names: [Option<Axis>; 26],
    variables: Vec<Option<Outcome<f64>>>,
    /// Result of the last assignment: what branches look at.
    result: Option<f64>,
    settled: Settled,
    /// Words that were noted once.
    noted: FxHashSet<String>,
    /// Readings that the configuration confirms, and those that were said.
    confirmed: Vec<Reading>,
    machine: Machine,
    words: Option<Box<Words>>,
}

impl<'a> Run<'a> {
    fn new(job: &Job<'a>, out: &'a mut dyn Sink, settled: Settled) -> Run<'a> {
        Run {
            core: Core::new(job, out),
            st: State::new(job.settings),
            axis_names: axis_names(job.settings.machine.geometry_axes),
            variables: start_values(&job.settings.variables),
            result: None,
            settled,
            noted: FxHashSet::default(),
            confirmed: job.settings.control.mtc200.confirmed.clone(),
            machine: Machine::new(eval::rules(job.settings.control.mtc200.radians)),
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
        self.refuse_known_words();
        self.core.begins_at(&self.st.position.start());
        Level::main(program, Frame::default())
    }

    #[inline]
    fn execute(&mut self, block: &Block, text: &[u8]) {
        if let Stmt::Header(first) = block.stmt {
            return self.header_line(first, block, text);
        }
        if !matches!(self.core.program().known.header, Header::Closed | Header::None) {
            self.leave_header(block);
        }
        if self.core.skips(block.skip.then_some(0)) {
            return;
        }
        for comment in &block.comments {
            self.comment(comment.of(text));
        }
        match block.stmt {
            Stmt::Empty | Stmt::Header(_) => {}
            Stmt::Bad => self.unread_block(),
            Stmt::Words => {
                let at = self.core.here.at;
                self.core.program().known.first.get_or_insert(at);
                if self.words_block(block, text).is_err() {
                    self.keep_modal(block);
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

impl Run<'_> {
    /// No entry of `machine_words` takes away what moves the tool.
    fn refuse_known_words(&self) {
        let of_flow = |name: &str| words::is_of_flow(name).then_some("a word of the program flow");
        let names = self.core.job.settings.control.mtc200.machine_words.keys();
        let entries: Vec<(&str, &str)> = names
            .filter_map(|name| Some((name.as_str(), reserved::reserved(name).or_else(|| of_flow(name))?)))
            .collect();
        let help = "take them out of the list: without them the tool would go another way, or the machine would not do what the program asks";
        self.core.refuse_entries("[control] machine_words", &entries, help);
        let words = self.core.job.settings.control.mtc200.machine_words.iter();
        let printed: Vec<(String, &str)> = words
            .filter_map(|(name, number)| Some((name, (*number)?)))
            .filter_map(|(name, number)| Some((format!("{name} = M{number}"), reserved::reserved_m(number)?)))
            .collect();
        let printed: Vec<(&str, &str)> = printed.iter().map(|(entry, what)| (entry.as_str(), *what)).collect();
        let help = "take them out: partc has to know of these functions, and would take the word for one that does nothing to the \
                    path; write the M function itself into the program";
        self.core.refuse_entries("[control] machine_words", &printed, help);
    }

    fn words_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        if self.assignments(block)? {
            return self.count_between();
        }
        let w = self.gather(block, text)?;
        let result = self.act_on(&w);
        self.put_back(w);
        result
    }

    /// Everything a block of words does, in order.
    #[inline]
    fn act_on(&mut self, w: &Words) -> Outcome {
        self.check_m(w)?;
        self.m_reading(w);
        let once = w.g[Group::Once as usize].map(|(g, _)| g);
        let ends = w.m().iter().any(|(number, _)| matches!(number, 2 | 30));
        if let (true, Some(flow)) = (ends, w.flow) {
            return self.core.refuse(flow.span, codes::P1003::block_ends_program_and_goes_on());
        }
        if once == Some(G::Dwell) {
            return self.dwell_block(w);
        }
        self.modal_functions(w)?;
        if let Some(at) = w.feed {
            self.relies_on_the_start(self.st.feed_said, at.span);
            self.set_feed(at)?;
        }
        if let Some(at) = w.tool {
            self.tool_word(at, w.m().iter().any(|(number, _)| *number == 6))?;
        }
        if let Some(at) = w.speed {
            self.speed_word(at, once == Some(G::SpeedLimit))?;
        } else if once == Some(G::SpeedLimit) {
            return self.core.refuse(w.g_spans[Group::Once as usize], codes::P1004::g92_needs_its_s());
        }
        let arcs = self.st.motion.code().is_some_and(Motion::is_arc);
        let moves = once.is_none() && (!w.axes.known().is_empty() || w.has_centre() || (arcs && w.radius.is_some()));
        self.m_at_start(w, moves)?;
        let span = w.g_spans[Group::Once as usize];
        match once {
            Some(G::ShiftTo | G::ShiftBy | G::Name) => {
                self.only_axes(w)?;
                self.programmed_offset(once.unwrap_or(G::Name), w, span)?;
            }
            Some(G::Home) => {
                self.only_axes(w)?;
                self.home(w, span)?;
            }
            Some(_) if !w.axes.known().is_empty() => {
                return self.core.refuse(w.axes_span, codes::P1003::axis_words_beside_g92());
            }
            Some(_) => self.only_axes(w)?,
            None if moves => self.motion(w)?,
            None => self.stray_words(w)?,
        }
        if w.program.is_some() {
            self.check_p(w)?;
        }
        if w.chamfer.is_some() || w.rounding.is_some() {
            self.corner(w)?;
        } else if !moves {
            self.count_between()?;
        }
        self.m_at_end(w)?;
        match w.flow {
            Some(flow) if !self.core.has_ended() => self.go_on(flow, w),
            _ => Ok(()),
        }
    }

    /// Beside a function that takes axis words nothing else can use I, J, K or R.
    fn only_axes(&mut self, w: &Words) -> Outcome {
        if w.has_centre() {
            return self.core.refuse(w.centre_span, codes::P1003::i_j_k_have_no_meaning());
        }
        self.stray_words(w)
    }

    fn stray_words(&mut self, w: &Words) -> Outcome {
        match w.radius {
            Some(at) => self.core.refuse(at.span, codes::P1003::r_has_no_meaning()),
            None => Ok(()),
        }
    }

    #[cold]
    fn check_p(&mut self, w: &Words) -> Outcome {
        let (Some(at), None) = (w.program, w.flow.filter(|flow| flow.flow.takes_program())) else { return Ok(()) };
        if w.g[Group::Once as usize].is_some() {
            return self.core.refuse(at.span, codes::M9002::angle_p_of_offset_is_not_documented());
        }
        if self.st.motion.code() == Some(Motion::Thread) && !w.axes.known().is_empty() {
            if at.value == 0.0 {
                return Ok(());
            }
            return self.core.refuse(at.span, codes::M9002::start_angle_of_thread_has_no_word());
        }
        self.core.refuse(at.span, codes::P1003::p_has_no_meaning())
    }

    /// G04 stands alone with its F.
    #[cold]
    fn dwell_block(&mut self, w: &Words) -> Outcome {
        let span = w.g_spans[Group::Once as usize];
        let other_g = w.g.iter().filter(|g| g.is_some()).count() > 1;
        let other = [w.speed, w.tool, w.program, w.radius, w.chamfer, w.rounding].iter().any(Option::is_some);
        if other_g || other || w.has_centre() || !w.axes.known().is_empty() || !w.m().is_empty() || w.flow.is_some() {
            return self.core.refuse(span, codes::P1003::g04_stands_beside_other_words());
        }
        self.dwell(w, span)?;
        self.count_between()
    }

    /// Modal G functions; they hold for their own block already.
    #[inline]
    fn modal_functions(&mut self, w: &Words) -> Outcome {
        // G62 beside G08 ends the exact stop first.
        for group in [Group::ExactStop, Group::Unit, Group::Diameter] {
            if let Some((g, _)) = w.g[group as usize] {
                self.modal(g, w.g_spans[group as usize], w)?;
            }
        }
        for (i, slot) in w.g.iter().enumerate() {
            let Some((g, _)) = slot else { continue };
            if !matches!(g, G::ExactStop(_) | G::Inch(_) | G::Diameter(_)) {
                self.modal(*g, w.g_spans[i], w)?;
            }
        }
        Ok(())
    }

    #[inline]
    fn modal(&mut self, g: G, span: Span, w: &Words) -> Outcome {
        match g {
            G::Motion(motion) => self.st.motion.program(motion),
            G::Plane(plane) => return self.set_plane(plane, span),
            G::Incremental(on) => {
                self.st.incremental = on;
                self.st.dimension_said = true;
            }
            G::Diameter(on) => {
                self.st.diameter = on;
                self.reading(Reading::DiameterCodes, span, codes::P8106::g16_switches_diameters_on);
            }
            G::Inch(on) => self.st.inch = on,
            G::Smooth if self.st.exact_stop => {
                return self.core.refuse(span, codes::M2013::g08_cannot_be_programmed_while_g61());
            }
            G::ExactStop(on) => {
                self.st.exact_stop = on;
                self.function(Function::PathControl(on.then_some(PathControl::Exact)));
            }
            G::Side(side) => return self.set_side(side, span, w),
            G::Chamfers(on) => {
                (self.st.transition.chamfers, self.st.transition.said) = (on, true);
                if self.core.job.settings.output.compensation == Compensation::Control {
                    self.without_geometry(if on { "G44" } else { "G43" }, span);
                }
            }
            G::Length(on) => return self.set_length(on, span),
            G::Offset(offset) => return self.set_offset(offset, span),
            G::PerRevolution(on) => {
                self.st.feed.switch(FeedKind::per_revolution(on));
                self.st.feed_said = true;
            }
            G::ConstantSpeed(on) => return self.spindle_mode(on, span, w),
            G::Smooth => self.without_geometry("G8", span),
            G::Nothing => {
                let group = [Group::FollowingError, Group::Transition].into_iter().find(|group| {
                    w.g[*group as usize].is_some_and(|(g, _)| g == G::Nothing) && w.g_spans[*group as usize] == span
                });
                if let Some((_, number)) = group.and_then(|group| w.g[group as usize]) {
                    self.without_geometry(&format!("G{number}"), span);
                }
            }
            G::Dwell | G::ShiftTo | G::ShiftBy | G::Name | G::Home | G::SpeedLimit => {}
        }
        Ok(())
    }

    /// A block failed. What it says of the modal states holds for the next ones all the same, so that they are not
    /// refused as well.
    #[cold]
    fn keep_modal(&mut self, block: &Block) {
        self.st.motion.lose();
        for word in &block.words {
            let (Target::Letter(b'G'), Value::Literal(number)) = (word.target, word.value) else { continue };
            if !(0.0..=999.0).contains(&number) || number.fract() != 0.0 {
                continue;
            }
            match g_functions::entry(number as u32) {
                Some((_, G::Motion(motion))) => self.st.motion.program(motion),
                Some((_, G::Incremental(on))) => self.st.incremental = on,
                Some((_, G::Diameter(on))) => self.st.diameter = on,
                Some((_, G::Inch(on))) => self.st.inch = on,
                Some((_, G::ExactStop(on))) => self.st.exact_stop = on,
                Some((_, G::PerRevolution(on))) => self.st.feed.assume(FeedKind::per_revolution(on)),
                _ => {}
            }
        }
    }

    /// G43 of the target adds the length of the tool to Z, whatever the plane.
    fn length_acts_along_z(&self, plane: Plane, span: Span) -> Outcome {
        let settings = &self.core.job.settings;
        let none = self.st.tool.active().is_none_or(|number| number == 0);
        if plane == Plane::Xy
            || none
            || !settings.output.prints_tool_length()
            || settings.machine.kind == crate::machine::MachineKind::Lathe
        {
            return Ok(());
        }
        let [who, way] = settings.output.length_along_z();
        self.core.refuse(
            span,
            codes::O9190::outside_g17_length_of_tool_does_not(&who, &way)
                .answer(Answer::key("output", "tool_length").one_of(&["\"off\""])),
        )
    }

    fn set_plane(&mut self, plane: Plane, span: Span) -> Outcome {
        if plane == self.st.plane {
            return Ok(());
        }
        if self.st.compensation.is_on() || self.st.corners.is_open() {
            return self.core.refuse(span, codes::P1003::working_plane_changes_inside_compensated_contour());
        }
        self.length_acts_along_z(plane, span)?;
        self.st.plane = plane;
        self.st.corners.cannot_follow();
        self.st.ctx = Rc::new(Ctx { plane, ..(*self.st.ctx).clone() });
        Ok(())
    }

    fn comment(&mut self, text: &[u8]) {
        if let Some(comment) = self.core.comment_of(text) {
            self.function(comment);
        }
    }

    #[inline]
    fn movement(&mut self, mv: &Move) {
        self.core.send_move(mv, &self.st.ctx);
    }

    fn send_corner(&mut self, corner: &Corner) {
        self.core.send_corner(corner, &self.st.ctx);
    }

    fn function(&mut self, function: Function) {
        self.core.send_function(&function, &self.st.ctx);
    }

    /// Nobody knows where the tool is.
    fn lost(&mut self) {
        self.core.send_lost(&self.st.ctx);
    }
}

/// The axis of each letter: the first three have names of the machine builder's choice, the others their own.
fn axis_names(main: [Axis; 3]) -> [Option<Axis>; 26] {
    let mut names = [None; 26];
    let slot = |axis: Axis| axis.letter() as usize - 'A' as usize;
    for axis in Axis::ALL.into_iter().filter(|axis| !axis.is_main()) {
        names[slot(axis)] = Some(axis);
    }
    for (meaning, name) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(main) {
        names[slot(name)] = Some(meaning);
    }
    names
}

/// Variables with their start values: `@50` and `@050` are the same.
fn start_values(start: &std::collections::BTreeMap<String, f64>) -> Vec<Option<Outcome<f64>>> {
    let mut variables = vec![None; eval::VARIABLES];
    for (name, value) in start {
        let number = name.strip_prefix('@').and_then(|digits| digits.parse::<usize>().ok());
        if let Some(slot) = number.and_then(|number| variables.get_mut(number)) {
            *slot = Some(Ok(*value));
        }
    }
    variables
}
