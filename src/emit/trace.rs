//! The resolved moves as JSON Lines, one move a line.

use std::io::Write;

use serde_json::{Map, Value, json};

use crate::diag::Trail;
use crate::geo::{Plane, Point2};
use crate::ir::motion::{Move, Path, Sink};
use crate::ir::{Feed, Function, Origin, Pos, Side};
use crate::machine::axis::Axis;
use crate::text::Sources;
use crate::text::decode::escaped_json;

/// Writes moves to `out`.
pub struct Trace<'a> {
    sources: &'a Sources,
    trail: &'a Trail,
    out: &'a mut dyn Write,
    at: Pos,
    tool: Option<u32>,
    error: Option<std::io::Error>,
}

impl std::fmt::Debug for Trace<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Trace").finish_non_exhaustive()
    }
}

impl<'a> Trace<'a> {
    pub fn new(sources: &'a Sources, trail: &'a Trail, out: &'a mut dyn Write) -> Trace<'a> {
        Trace { sources, trail, out, at: Pos::UNKNOWN, tool: None, error: None }
    }

    /// # Errors
    /// The first error of the output.
    pub fn finish(self) -> std::io::Result<()> {
        match self.error {
            Some(error) => Err(error),
            None => self.out.flush(),
        }
    }

    fn move_line(&mut self, mv: &Move, origin: &Origin) {
        let mut line = Map::new();
        let kind = match &mv.path {
            Path::Rapid => "rapid",
            Path::Line(_) | Path::Carried { .. } => "line",
            Path::Arc(..) => "arc",
            Path::Thread { .. } => "thread",
        };
        line.insert("kind".to_owned(), json!(kind));
        line.insert("start".to_owned(), position(&self.at));
        self.at.update(&mv.end);
        line.insert("end".to_owned(), position(if mv.machine { &mv.end } else { &self.at }));
        if let Path::Arc(arc, _) = &mv.path {
            line.insert("center".to_owned(), center(arc.plane, arc.center));
            line.insert("plane".to_owned(), json!(plane_name(arc.plane)));
            line.insert("sweep_deg".to_owned(), json!(rounded(arc.sweep.to_degrees())));
        }
        if let Path::Thread { lead } = &mv.path {
            line.insert("lead".to_owned(), json!(rounded(*lead)));
        }
        if let Path::Carried { feed, length } = &mv.path {
            line.insert("feed".to_owned(), json!(rounded(*feed)));
            line.insert("length".to_owned(), json!(rounded(*length)));
        }
        match mv.path.feed() {
            Some(Feed::PerMinute(f)) => line.insert("feed".to_owned(), json!(rounded(f))),
            Some(Feed::PerRevolution(f)) => line.insert("feed_per_rev".to_owned(), json!(rounded(f))),
            Some(Feed::InverseTime(f)) => line.insert("feed_inverse_time".to_owned(), json!(rounded(f))),
            None => None,
        };
        if mv.side != Side::None {
            line.insert("compensation".to_owned(), json!(if mv.side == Side::Left { "left" } else { "right" }));
        }
        if mv.machine {
            line.insert("machine".to_owned(), json!(true));
            for axis in mv.axes.iter() {
                self.at.forget(axis);
            }
        }
        line.insert("tool".to_owned(), json!(self.tool));
        line.insert("file".to_owned(), json!(self.sources.name(origin.loc.file)));
        line.insert("line".to_owned(), json!(origin.loc.line));
        let stack: Vec<Value> = self
            .trail
            .sites(origin.call)
            .iter()
            .map(|site| json!({ "file": self.sources.name(site.file), "line": site.line }))
            .collect();
        line.insert("stack".to_owned(), Value::Array(stack));
        self.write(&Value::Object(line));
    }

    fn write(&mut self, line: &Value) {
        if self.error.is_none()
            && let Err(error) = writeln!(self.out, "{}", escaped_json(&line.to_string()))
        {
            self.error = Some(error);
        }
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
        self.move_line(mv, origin);
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        if let Function::ToolChange { number } = function {
            self.tool = Some(*number);
        } else if let Function::WorkOffset(_) = function {
            self.at.clear();
        }
    }

    fn lost(&mut self, _: &Origin) {
        self.at.clear();
    }
}
