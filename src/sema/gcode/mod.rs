//! Runs plain G-code, as LinuxCNC reads it: what other programs make, and what partc prints itself.
//!
//! [`Reader`] reads the lines, the same that reads every output of partc. It knows no variables, calls or cycles: such a
//! line is refused. Source: LinuxCNC User Manual, G-Code Overview and G-Codes (docs/sources.md).

mod attempt;
pub mod function;
mod line;
mod place;
mod survey;

use std::ops::ControlFlow;
use std::rc::Rc;

use crate::diag::{Answer, Help, Label, codes};
use crate::geo::{Plane, Point2};
use crate::ir::contour::{Arc, ArcShape, Coords, Ctx, CtxRef, Move, Path, Sink, Thread};
use crate::ir::function::{PathControl, Spindle, Turn};
use crate::ir::tap::Stroke;
use crate::ir::{Function, Pos, Tap};
use crate::machine::{Axis, AxisSet, MachineKind, Settings, Unit};
use crate::parser::problem::Problem;
use crate::parser::symbols::Symbols;
use crate::read::{self, AXES, Act, Lack, Modes, Reader, Rules, Speed};
use crate::text::{Loc, Span, SplitRules};

use line::{Line, is_blank, without};

use self::place::stand;
use super::common::hidden::{By, because};
use super::common::start::Start;
use super::run::refusal::{Refusal, refused};
use super::run::{self, Interpreter, Language, Level, OffsetName, Parsed, Where};
use super::{Job, Outcome};

pub use attempt::first_refused;
pub use survey::survey;

/// By how much the end of an arc may miss its circle, in mm: what LinuxCNC takes.
const ARC_TOLERANCE: f64 = 0.0127;
/// Work offsets of LinuxCNC.
const OFFSETS: [&str; 9] = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];
/// Most turns of one arc.
const MOST_TURNS: u32 = 100_000;
/// Most acts of one line.
const ACTS: usize = 16;
/// Begins the head of an output; so far it is looked for behind the number of the program, in bytes.
const HEAD: &[u8] = b"(partc ";
const NEXT: u32 = 100;
/// Lines in which the number of a program stands.
const HEAD_LINES: u32 = 3;

/// Runs the main program of `job`; items go to `out`. Returns the hash of the main program's text.
pub fn run(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    run::run(&mut Run::new(job, out))
}

/// The form of a line is read with what it does, when it runs.
pub fn check_form(job: &Job<'_>) {
    run::unexecuted::check_form::<Gcode>(job);
}

/// How the text of a program is read.
#[derive(Debug, Default)]
struct Gcode;

impl Language for Gcode {
    type Block = Line;
    type Known = ();
    type Frame = ();

    /// Nothing joins two lines.
    const SPLIT: SplitRules = SplitRules { mark: 0, continues: |_, _| false };

    #[inline]
    fn parse(&mut self, text: &[u8], into: &mut Parsed<Line>, _: &mut Symbols, _: &mut Vec<Problem>) {
        into.block.read(text);
        into.text.extend_from_slice(text);
    }

    #[inline]
    fn span(line: &Line) -> Span {
        line.span
    }

    #[inline]
    fn operations(_: &Line) -> usize {
        0
    }
}

/// Files, call stack and findings of a run.
type Core<'a> = run::Core<'a, Gcode>;

/// A run of a program.
struct Run<'a> {
    core: Core<'a>,
    reader: Reader,
    ctx: CtxRef,
    /// The tool that T chose last, and the one in the spindle.
    selected: Option<u32>,
    tool: Option<u32>,
    cutter: Option<read::Cutter>,
    /// What the configuration says of the place at the start.
    start: Start,
    /// The line that changed the tool, until Z moves.
    changed: Option<Loc>,
    /// A work offset was selected.
    offset_said: bool,
    /// The sense in which the spindle turns behind a tap, where no line said it yet.
    turns_on: Option<Turn>,
    /// A line was refused: what later ones lack may have stood there.
    lost: bool,
}

/// A control as it is switched on, and what the configuration says of it.
fn reader(settings: &Settings, start: &Start) -> Reader {
    let mut reader = Reader::at_power_on();
    let modes = reader.modes_mut();
    modes.inches = settings.control.unit.map(|unit| unit == Unit::Inch);
    if settings.machine.kind == MachineKind::Lathe {
        // Most lathes are set up for G18, which no file shows.
        modes.plane = None;
    }
    stand(&mut reader, start);
    reader
}

impl<'a> Run<'a> {
    fn new(job: &Job<'a>, out: &'a mut dyn Sink) -> Run<'a> {
        let start = Start::new(job.settings, false);
        let reader = reader(job.settings, &start);
        let plane = reader.modes().plane.map_or(Plane::Zx, function::plane);
        Run {
            core: Core::new(job, out),
            reader,
            ctx: Rc::new(Ctx { plane, ..Ctx::default() }),
            selected: None,
            tool: None,
            cutter: None,
            start,
            changed: None,
            offset_said: false,
            turns_on: None,
            lost: false,
        }
    }
}

impl<'a> Interpreter<'a> for Run<'a> {
    type Language = Gcode;

    #[inline]
    fn core(&mut self) -> &mut Core<'a> {
        &mut self.core
    }

    fn begin(&mut self, program: usize) -> Level<()> {
        let start = self.start.position();
        self.core.begins_at(&start);
        Level::main(program, ())
    }

    #[inline]
    fn execute(&mut self, line: &Line, text: &[u8]) {
        if self.core.skips(line.skip) {
            return;
        }
        for comment in &line.comments {
            self.core.check_receiver(comment.of(text));
            self.core.send_comment(comment.of(text), &self.ctx);
        }
        if self.core.names_an_output(line.span.of(text)) {
            return;
        }
        if self.words(line, text).is_err() {
            self.lose_all();
        }
    }

    fn end_of_file(&mut self) {
        let loc = self.core.end_of_text();
        self.core.here.origin.loc = loc;
        self.core.stop_run();
        if self.core.may_end_open("M2 or M30", "M30", None) {
            self.core.report(codes::P1007::program_ends_without_m2_or_m30().at(loc));
        }
        self.does(&Function::End { rewind: false });
    }

    fn unread_block(&mut self) {
        self.lose_all();
    }

    fn finish(&mut self) {
        self.core.report_no_change();
    }
}

/// Why a line is refused.
enum Refused {
    Line(read::Fault),
    /// Of a line that can be read.
    Words(Refusal),
}

impl From<&'static str> for Refused {
    fn from(why: &'static str) -> Refused {
        Refused::Line(read::Fault { why: why.to_owned(), lacks: Some(Lack::Mode) })
    }
}

impl From<Refusal> for Refused {
    fn from(refusal: Refusal) -> Refused {
        Refused::Words(refusal)
    }
}

impl Core<'_> {
    /// The number of a program that partc printed: the next line says for which receiver.
    fn names_an_output(&self, line: &[u8]) -> bool {
        let Loc { file, span, .. } = self.here.origin.loc;
        let next = || self.job.sources.bytes(file, Span { start: span.end, end: span.end.saturating_add(NEXT) });
        is_program_number(line)
            && next().trim_ascii_start().get(..HEAD.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(HEAD))
    }

    /// `O1001` at the head of a program for a mill: the number of the program on a Fanuc and its like. LinuxCNC has none.
    fn passes_program_number(&self, words: &[u8]) -> bool {
        let is_mill = self.job.settings.machine.kind == MachineKind::Mill;
        let is_head = is_mill && self.here.origin.loc.line <= HEAD_LINES && is_program_number(words.trim_ascii());
        if is_head {
            self.say_here(codes::R1005::program_number_of_fanuc_control(&String::from_utf8_lossy(words.trim_ascii())));
        }
        is_head
    }

    /// The head of an output names the receiver that it is for.
    fn check_receiver(&self, comment: &[u8]) {
        if !comment.get(..6).is_some_and(|begin| begin.eq_ignore_ascii_case(b"partc ")) {
            return;
        }
        let text = String::from_utf8_lossy(comment).to_lowercase();
        let Some((_, name)) = text.split_once(", target ") else { return };
        let name = name.trim();
        if Rules::of(name) != Rules::of("linuxcnc") {
            let help = "compile the program that it was made of for the target you need";
            self.say_here(codes::R1003::this_program_was_printed_for_target(&name).help(help));
            self.stop_run();
        }
    }

    /// G64 promises no bound, and the output has one where the target can say it.
    fn bounds_corners(&self) {
        let settings = self.job.settings;
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let printed = settings.output.path_control(Some(PathControl::Unbounded), lathe);
        let what = match printed {
            Some(PathControl::Within(mm)) => format!("the output rounds corners off by {mm} mm at most"),
            Some(PathControl::Exact) => "the output does not round corners off".to_owned(),
            Some(PathControl::Before(_) | PathControl::Unbounded) | None => return,
        };
        self.say_once(self.block_span(), codes::R8001::g64_without_p_says_no_bound(&what));
    }
}

/// `O1001`
fn is_program_number(words: &[u8]) -> bool {
    matches!(words, [b'O' | b'o', number @ ..] if !number.is_empty() && number.iter().all(u8::is_ascii_digit))
}

impl Run<'_> {
    fn does(&mut self, function: &Function) {
        self.core.send_function(function, &self.ctx);
    }

    /// Nobody knows what a line would have done.
    fn lose_all(&mut self) {
        self.lost = true;
        self.reader.forget();
        self.core.send_lost(&self.ctx);
    }

    fn words(&mut self, line: &Line, text: &[u8]) -> Outcome {
        if line.is_broken {
            let fault = codes::R1001::line_break_stands_inside_of_this_line();
            return self.core.refuse(Where::Block, fault.help("save the file with one kind of line break"));
        }
        let before = *self.reader.modes();
        let words = &text[line.from..line.end];
        let first = words.trim_ascii_start().first();
        if first == Some(&b'%') && (line.skip.is_some() || !line.comments.is_empty()) {
            let fault = codes::R1001::has_to_stand_in_line();
            return self.core.refuse(Where::Block, fault.help("write what stands beside it into another line"));
        }
        if matches!(first, Some(b'O' | b'o')) && self.core.passes_program_number(&without(line, text)) {
            return Ok(());
        }
        let nested = |comment: &Span| memchr::memchr(b'(', comment.of(text)).is_some();
        let done = if line.comments.iter().any(nested) {
            self.line(&without(line, text), &before)
        } else {
            self.line(words, &before)
        };
        match done {
            Ok(()) => {
                if self.reader.closed() {
                    self.close();
                }
                Ok(())
            }
            Err(Refused::Line(fault)) => self.unreadable(&fault),
            Err(Refused::Words(refusal)) => self.core.made(Err(refusal)),
        }
    }

    /// The line cannot be read; what it lacks may have been said in a line that was refused.
    #[cold]
    fn unreadable(&self, fault: &read::Fault) -> Outcome {
        if fault.lacks.is_some() && self.lost {
            return Err(super::Reported);
        }
        let at_change = match fault.lacks {
            Some(Lack::Place(axis)) if axis == Axis::Z.index() => self.changed.map(|loc| (By::ToolChange, loc)),
            _ => None,
        };
        let why = because(at_change, self.core.here.origin.loc);
        let help = match fault.lacks {
            Some(Lack::Place(axis)) => {
                let usual = Help::from("program an absolute position first");
                usual.or(self.start.or_say(Axis::ALL[axis], at_change.is_some()))
            }
            Some(Lack::Unit) => Answer::key("control", "unit").help("write G21 or G20 first, or set `[control] unit`"),
            Some(Lack::Mode) | None => "partc reads plain G-code, without variables, calls and cycles: resolve them \
                                        first, or name the language of the program with --dialect"
                .into(),
        };
        self.core.refuse(Where::Block, codes::R1001::this_line_cannot_be_read(&fault.why, &why).help(help))
    }

    /// The second `%` ends the program, as it ended a tape: nothing behind it is read (RS274/NGC 3.1; rs274 does so, too).
    #[cold]
    fn close(&mut self) {
        let loc = self.core.here.origin.loc;
        self.core.stop_run();
        self.core.say_here(codes::P1007::program_ends_at_its_second());
        self.does(&Function::End { rewind: false });
        let program = self.core.level().program;
        let behind = self.core.first_behind(program, |text| {
            let Some(start) = text.iter().position(|b| !is_blank(*b)) else { return ControlFlow::Continue(()) };
            let end = text.iter().rposition(|b| !is_blank(*b)).map_or(start, |last| last + 1);
            ControlFlow::Break(Some(Span { start: start as u32, end: end as u32 }))
        });
        if let Some(behind) = behind {
            let help = "delete it; or delete the `%` before it, if it belongs to the program";
            let found = codes::R1004::this_stands_after_that_ends_program().at(behind).help(help);
            self.core.report(found.also(loc, Label::ProgramEnds));
        }
    }

    fn line(&mut self, words: &[u8], before: &Modes) -> Result<(), Refused> {
        let (mut rest, mut end) = (words, words.len());
        let mut acts = [Act::Change; ACTS];
        let mut count = 0;
        while let Some(act) = self.reader.next(&mut rest, &mut end).map_err(Refused::Line)? {
            acts[count.min(ACTS - 1)] = act;
            count += 1;
        }
        let acts = &acts[..count.min(ACTS)];
        if before.constant_cut == Some(true)
            && self.reader.modes().constant_cut == Some(false)
            && !acts.iter().any(|act| matches!(act, Act::Speed(Speed { spindle: 0, .. })))
        {
            return Ok(refused(Where::Block, codes::R2001::g97_stands_without_s())?);
        }
        self.modes(before)?;
        let changes = acts.contains(&Act::Change);
        for act in acts {
            self.act(act, changes)?;
            if self.core.has_ended() {
                break;
            }
        }
        Ok(())
    }

    /// What a line changes for the ones behind it.
    fn modes(&mut self, before: &Modes) -> Result<(), Refused> {
        let modes = *self.reader.modes();
        if let (Some(plane), true) = (modes.plane, modes.plane != before.plane) {
            let plane = function::plane(plane);
            self.ctx = Rc::new(Ctx { plane, ..Ctx::default() });
            self.does(&Function::Plane(plane));
        }
        match modes.length {
            Some(number) if modes.length != before.length && number != 0 => self.length(number),
            _ => Ok(()),
        }
    }

    /// The length of a tool counts from here on.
    fn length(&mut self, number: u32) -> Result<(), Refused> {
        self.reader.lose(Axis::Z.index());
        if self.changed.is_some() {
            // What the configuration says is said of the tool with its length.
            self.stand_after_change();
        }
        if !self.core.job.settings.output.prints_tool_length() {
            let with_length = Answer::key("output", "tool_length").one_of(&["\"G43\""]);
            return Ok(refused(Where::Block, codes::R2001::output_has_no_tool_length(&number).answer(with_length))?);
        }
        if self.tool != Some(number) {
            return Ok(refused(Where::Block, codes::R2001::g43_adds_length_of_another_tool(&number))?);
        }
        Ok(())
    }

    /// Behind a tap the spindle turns on as before; said, unless the next act says what it does.
    fn turns_on(&mut self, act: &Act) {
        let Some(turn) = self.turns_on else { return };
        match act {
            Act::M { number: 3..=5 | 19, spindle: 0, .. } | Act::Tap => self.turns_on = None,
            // A wait says nothing of the spindle: what follows it does.
            Act::Speed(_) | Act::Corners(_) | Act::Dwell(_) => {}
            Act::Move(_) | Act::Select(_) | Act::Change | Act::M { .. } | Act::Offset(_) | Act::Tilt(_) => {
                self.turns_on = None;
                self.does(&Function::Spindle(Spindle::Start(turn)));
            }
        }
    }

    fn act(&mut self, act: &Act, changes: bool) -> Result<(), Refused> {
        self.turns_on(act);
        match *act {
            Act::Move(mv) => return self.movement(&mv),
            Act::Tap => self.tap(),
            Act::Select(number) => {
                self.selected = Some(number);
                if !changes {
                    self.does(&Function::ToolPrepare { number });
                }
            }
            Act::Change => {
                let number = self.selected.ok_or("a change to a tool that no T has chosen")?;
                self.tool = Some(number);
                self.does(&Function::ToolChange { number });
                // The tip of another tool stands elsewhere.
                self.reader.lose(Axis::Z.index());
                self.start.change_tip(Axis::Z);
                self.changed = Some(self.core.here.origin.loc);
                let places = self.stand_after_change();
                self.core.stands_at(&places, &self.ctx);
            }
            Act::M { number, .. } if !is_known(number) && !self.core.job.settings.output.pass_m.contains(&number) => {
                let help = Answer::pass_m(number)
                    .help(format!("if it may be printed as it stands, list it: `[output] pass_m = [{number}]`"));
                let fault = codes::P2007::m_means_what_builder_of_machine_wants(&number).help(help);
                return Ok(refused(Where::Block, fault)?);
            }
            _ => {
                if let Some(function) = function::function(act)? {
                    if let Function::WorkOffset(number) = function {
                        let name = OFFSETS.get(usize::from(number).wrapping_sub(1)).copied().unwrap_or("this offset");
                        let taken = self.core.prints_offset(OffsetName::Fixed(name), number, Where::Block);
                        taken.map_err(Refusal::from)?;
                    }
                    self.does(&function);
                    if function == Function::PathControl(Some(PathControl::Unbounded)) {
                        self.core.bounds_corners();
                    }
                    if let Function::WorkOffset(_) = function {
                        self.offset();
                    }
                    if let Function::End { .. } = function {
                        self.core.end_is_whole();
                        self.core.stop_run();
                    }
                }
            }
        }
        Ok(())
    }

    /// The places of the start count in the offset that is selected first.
    fn offset(&mut self) {
        if std::mem::replace(&mut self.offset_said, true) {
            return self.start.end();
        }
        stand(&mut self.reader, &self.start);
    }

    /// G33.1: down and back in step; the spindle turns on as before behind it.
    fn tap(&mut self) {
        let read = *self.reader.tap();
        let speed = read.speed.map(function::real);
        let turn = if read.left { Turn::CounterClockwise } else { Turn::Clockwise };
        let start = function::real(read.from);
        let faster = (read.factor != read::SCALE).then_some(function::real(read.factor));
        let tap = Tap {
            axis: Axis::ALL[read.axis],
            start,
            surface: start,
            strokes: vec![Stroke { to: function::real(read.to), back: function::real(read.back), dwell: 0.0 }],
            lead: function::real(read.lead),
            turn,
            speed_in: speed.filter(|_| faster.is_some()),
            speed_out: speed.zip(faster).map(|(speed, factor)| speed * factor),
            orient: None,
            pause: 0.0,
            again: None,
        };
        self.core.send_tap(&tap, &self.ctx);
        self.turns_on = Some(turn);
        self.start.touch(AxisSet::of(tap.axis));
    }

    fn movement(&mut self, mv: &read::Move) -> Result<(), Refused> {
        let cutter = self.reader.modes().cutter.unwrap_or_default();
        if cutter.side != 0 && self.cutter != Some(cutter) {
            self.cutter = Some(cutter);
            self.does(&function::cutter(cutter));
        }
        let with_length = self.reader.modes().length.is_some_and(|number| number != 0);
        if self.core.job.settings.output.prints_tool_length()
            && !mv.machine
            && !with_length
            && self.tool.is_some_and(|t| t != 0)
        {
            let fault = codes::R2001::tool_moves_without_its_length().answer(Answer::key("output", "tool_length"));
            return Ok(refused(Where::Block, fault)?);
        }
        let mut end = Pos::UNKNOWN;
        for axis in (0..AXES).filter(|axis| mv.axes & (1 << axis) != 0) {
            end.set(Axis::ALL[axis], function::real(self.reader.at()[axis]));
        }
        let path = match mv.path {
            read::Path::Rapid => Path::Rapid,
            read::Path::Line => Path::Line(function::feed(&self.reader)?),
            // K is the way along the path for a turn.
            read::Path::Thread(lead) => Path::Thread(Thread { lead: function::real(lead), along: None }),
            read::Path::Arc(arc) if arc.turns.unsigned_abs() > MOST_TURNS => {
                let fault = codes::R4001::arc_turns_times(&arc.turns.unsigned_abs(), &MOST_TURNS);
                return Ok(refused(Where::Block, fault.help("check P, the number of turns"))?);
            }
            read::Path::Arc(arc) => Path::Arc(shape(&arc)?, function::feed(&self.reader)?),
        };
        let coords = if mv.machine { Coords::Machine } else { Coords::Frame };
        let mv = Move { end, path, side: function::side(cutter), coords };
        self.core.send_move(&mv, &self.ctx);
        self.start.touch(mv.end.known());
        if mv.end.get(Axis::Z).is_some() {
            self.changed = None;
        }
        Ok(())
    }
}

/// M functions that mean the same on every machine.
fn is_known(number: u32) -> bool {
    matches!(number, 0..=5 | 7..=9 | 19 | 30)
}

fn shape(arc: &read::Arc) -> Result<Arc, &'static str> {
    if arc.from == arc.center || arc.to == arc.center {
        return Err("an arc without a radius");
    }
    let center = Point2::new(function::real(arc.center[0]), function::real(arc.center[1]));
    let shape = ArcShape::Center { center, ccw: arc.turns > 0, tol: ARC_TOLERANCE };
    Ok(Arc { plane: function::plane(arc.plane), shape, turns: arc.turns.unsigned_abs().saturating_sub(1) })
}
