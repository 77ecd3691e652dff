//! The resolved moves as JSON Lines, one move a line.

use std::collections::VecDeque;
use std::io::Write;

use serde_json::{Map, Value, json};

use crate::diag::{Finding, Trail};
use crate::geo::{Plane, Point2, distance};
use crate::ir::motion::{Move, Path, Sink};
use crate::ir::{Feed, Function, Origin, Pos, Remark, Side};
use crate::machine::axis::Axis;
use crate::text::decode::escaped_json;
use crate::text::{BlockNumbers, Sources};

use super::spindle_and_tool::{Sense, Speed, SpindleAndTool, ToolAxis};
use super::stats::{Clock, Ended, Model, Time};

/// Writes moves to `out`.
pub struct Trace<'a> {
    sources: &'a Sources,
    trail: &'a Trail,
    out: &'a mut dyn Write,
    clock: Clock,
    program: SpindleAndTool,
    numbers: BlockNumbers,
    /// Moves so far.
    moves: u64,
    /// Lines from the first on whose time is still open.
    waiting: VecDeque<Map<String, Value>>,
    /// A block was refused: what follows is not whole, and in no line.
    refused: bool,
    error: Option<std::io::Error>,
}

impl std::fmt::Debug for Trace<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Trace").finish_non_exhaustive()
    }
}

impl<'a> Trace<'a> {
    pub fn new(sources: &'a Sources, trail: &'a Trail, model: Model, out: &'a mut dyn Write) -> Trace<'a> {
        Trace {
            sources,
            trail,
            out,
            clock: Clock::new(model),
            program: SpindleAndTool::default(),
            numbers: BlockNumbers::default(),
            moves: 0,
            waiting: VecDeque::new(),
            refused: false,
            error: None,
        }
    }

    /// Ends the list; one that ends at an error of the program with a line about it.
    ///
    /// # Errors
    /// The first error of the output.
    pub fn finish(mut self, refused: Option<&Finding>) -> std::io::Result<()> {
        let ended = self.clock.stop();
        self.settle(ended);
        self.release(None);
        if let Some(found) = refused {
            self.write(&incomplete(found));
        }
        match self.error {
            Some(error) => Err(error),
            None => self.out.flush(),
        }
    }

    /// A time that was open is known: all lines up to the next open one go out.
    fn settle(&mut self, ended: Option<Ended>) {
        let Some(Ended { number, time, .. }) = ended else { return };
        let first = self.moves - self.waiting.len() as u64;
        if let Some(line) = self.waiting.get_mut((number - first) as usize) {
            line["time"] = json!(rounded(time));
        }
        self.release(self.clock.open());
    }

    fn release(&mut self, open: Option<u64>) {
        while open != Some(self.moves - self.waiting.len() as u64)
            && let Some(line) = self.waiting.pop_front()
        {
            self.write(&Value::Object(line));
        }
    }

    fn move_line(&mut self, mv: &Move, origin: &Origin) {
        let mut line = Map::new();
        let mut say = |name: &str, value: Value| drop(line.insert(name.to_owned(), value));
        let start = *self.clock.at();
        let step = self.clock.movement(mv);
        say("kind", json!(kind(&mv.path)));
        say("start", position(&start));
        let mut end = start;
        end.update(&mv.end);
        say("end", position(if mv.machine { &mv.end } else { &end }));
        path(&mv.path, &mut say);
        if !matches!(mv.path, Path::Carried { .. })
            && let Some(length) = step.length
        {
            say("length", json!(rounded(length)));
        }
        match step.time {
            Time::Later => say("time", Value::Null),
            Time::None => say("time", json!(0.0)),
            Time::Unknown => {}
        }
        if mv.side != Side::None {
            say("compensation", json!(if mv.side == Side::Left { "left" } else { "right" }));
        }
        if mv.machine {
            say("machine", json!(true));
        }
        say("tool", json!(self.program.tool));
        spindle(&self.program, &mut say);
        if self.program.axis != ToolAxis::Upright {
            let direction = self.program.axis.direction(mv.machine);
            say("tool_axis", json!(direction.map(|axis| axis.map(rounded))));
        }
        say("file", json!(self.sources.name(origin.loc.file)));
        say("line", json!(origin.loc.line));
        if let Some(block) = self.numbers.of(self.sources, origin.loc) {
            say("block", json!(block));
        }
        let stack: Vec<Value> = self
            .trail
            .sites(origin.call)
            .iter()
            .map(|site| json!({ "file": self.sources.name(site.file), "line": site.line }))
            .collect();
        say("stack", Value::Array(stack));
        self.settle(step.ended);
        self.moves += 1;
        self.waiting.push_back(line);
        self.release(self.clock.open());
    }

    fn write(&mut self, line: &Value) {
        if self.error.is_none()
            && let Err(error) = writeln!(self.out, "{}", escaped_json(&line.to_string()))
        {
            self.error = Some(error);
        }
    }
}

/// The last line of a list that is not whole.
fn incomplete(found: &Finding) -> Value {
    let mut line = json!({
        "kind": "incomplete",
        "code": found.code,
        "message": found.message,
        "file": found.file,
        "line": found.line,
    });
    if let Some(block) = &found.block {
        line["block"] = json!(block);
    }
    line
}

fn kind(path: &Path) -> &'static str {
    match path {
        Path::Rapid => "rapid",
        Path::Line(_) | Path::Carried { .. } => "line",
        Path::Arc(..) => "arc",
        Path::Thread { .. } => "thread",
    }
}

fn path(path: &Path, say: &mut dyn FnMut(&str, Value)) {
    match path {
        Path::Arc(arc, _) => {
            say("center", center(arc.plane, arc.center));
            say("radius", json!(rounded(distance(arc.from, arc.center))));
            say("plane", json!(plane_name(arc.plane)));
            say("sweep_deg", json!(rounded(arc.sweep.to_degrees())));
        }
        Path::Thread { lead } => say("lead", json!(rounded(*lead))),
        Path::Carried { feed, length } => {
            say("feed", json!(rounded(*feed)));
            say("length", json!(rounded(*length)));
        }
        Path::Rapid | Path::Line(_) => {}
    }
    match path.feed() {
        Some(Feed::PerMinute(f)) => say("feed", json!(rounded(f))),
        Some(Feed::PerRevolution(f)) => say("feed_per_rev", json!(rounded(f))),
        Some(Feed::InverseTime(f)) => say("feed_inverse_time", json!(rounded(f))),
        None => {}
    }
}

fn spindle(told: &SpindleAndTool, say: &mut dyn FnMut(&str, Value)) {
    match told.speed {
        Some(Speed::Turns(speed)) => say("spindle", json!(rounded(speed))),
        Some(Speed::Cutting(speed, limit)) => {
            say("cutting_speed", json!(rounded(speed)));
            if let Some(limit) = limit {
                say("spindle_limit", json!(rounded(limit)));
            }
        }
        None => {}
    }
    if let Some(sense) = told.sense {
        say("spindle_direction", json!(Sense::name(sense)));
    }
}

/// Without the last digits, in which nothing but the conversion of units shows: 152.4 for six inches.
fn rounded(value: f64) -> f64 {
    let scaled = (value * 1e9).round() / 1e9;
    if scaled.is_finite() { scaled + 0.0 } else { value }
}

fn position(pos: &Pos) -> Value {
    let coordinates = pos.iter().map(|(axis, value)| (axis.letter().to_string(), json!(rounded(value))));
    Value::Object(coordinates.collect())
}

fn center(plane: Plane, p: Point2) -> Value {
    let (first, second, _) = plane.axes();
    let mut pos = Pos::UNKNOWN;
    pos.set(Axis::ALL[first], p.x);
    pos.set(Axis::ALL[second], p.y);
    position(&pos)
}

fn plane_name(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "XY",
        Plane::Zx => "ZX",
        Plane::Yz => "YZ",
    }
}

impl Sink for Trace<'_> {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        if !self.refused {
            self.move_line(mv, origin);
        }
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        if let Function::Remark(Remark::Refused) = function {
            let ended = self.clock.stop();
            self.settle(ended);
            self.refused = true;
        }
        let ended = self.clock.function(function);
        self.settle(ended);
        self.program.function(function);
    }

    fn lost(&mut self, _: &Origin) {
        let ended = self.clock.lost();
        self.settle(ended);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.clock.begins_at(at);
    }
}
