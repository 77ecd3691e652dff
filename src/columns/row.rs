//! The open batch: a column for each field but the time.

use crate::emit::spindle_and_tool::{Sense, Speed, SpindleAndTool};
use crate::geo::{Plane, distance};
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Feed, Function, Pos, Side};
use crate::machine::axis::AXES;
use arrow_array::ArrayRef;

use super::arrays::{Held, Texts, Truths, Values, Words};
use super::chunk::Row;

/// Place of the time among the columns.
pub(super) const TIME: usize = 36;

const KINDS: &[&str] = &["rapid", "line", "arc", "thread"];
const PLANES: &[&str] = &["XY", "ZX", "YZ"];
const FEEDS: &[&str] = &["per_minute", "per_revolution", "inverse_time"];
const SPEEDS: &[&str] = &["speed", "cutting_speed"];
const SIDES: &[&str] = &["left", "right"];

pub(super) struct Rows {
    /// Of the open batch.
    row: usize,
    program: SpindleAndTool,
    kind: Words,
    start: [Values<f64>; AXES],
    end: [Values<f64>; AXES],
    center: [Values<f64>; 3],
    radius: Values<f64>,
    sweep: Values<f64>,
    plane: Words,
    lead: Held<f64>,
    feed: Held<f64>,
    feed_mode: Words,
    spindle: Held<f64>,
    spindle_mode: Words,
    spindle_limit: Held<f64>,
    spindle_direction: Words,
    tool: Held<i64>,
    compensation: Words,
    machine: Truths,
    length: Values<f64>,
    file: Words,
    line: Values<i64>,
    block: Texts,
    call_path: Words,
    tool_axis: [Held<f64>; 3],
}

impl Rows {
    pub fn new() -> Rows {
        Rows {
            row: 0,
            program: SpindleAndTool::default(),
            kind: Words::new(KINDS),
            start: std::array::from_fn(|_| Values::new()),
            end: std::array::from_fn(|_| Values::new()),
            center: std::array::from_fn(|_| Values::new()),
            radius: Values::new(),
            sweep: Values::new(),
            plane: Words::new(PLANES),
            lead: Held::new(),
            feed: Held::new(),
            feed_mode: Words::new(FEEDS),
            spindle: Held::new(),
            spindle_mode: Words::new(SPEEDS),
            spindle_limit: Held::new(),
            spindle_direction: Words::new(&Sense::ALL.map(Sense::name)),
            tool: Held::new(),
            compensation: Words::new(SIDES),
            machine: Truths::new(),
            length: Values::new(),
            file: Words::new(&[]),
            line: Values::new(),
            block: Texts::default(),
            call_path: Words::new(&[]),
            tool_axis: std::array::from_fn(|_| Held::new()),
        }
    }

    pub fn function(&mut self, function: &Function) {
        self.program.function(function);
    }

    /// Names that rows will speak of.
    pub fn names(&mut self, files: &[String], call_paths: &[String]) {
        files.iter().for_each(|file| self.file.add(file));
        call_paths.iter().for_each(|path| self.call_path.add(path));
    }

    /// A move from `from` on, of this length, in the block of this number.
    pub fn push(&mut self, row: &Row, number: Option<&[u8]>, from: &Pos, length: Option<f64>) {
        let mv = &row.mv;
        self.places(mv, from);
        self.path(&mv.path, length);
        self.spindle_and_tool();
        self.tool_axis(mv.machine);
        let side = match mv.side {
            Side::None => None,
            Side::Left => Some(0),
            Side::Right => Some(1),
        };
        self.compensation.put(self.row, side);
        self.machine.push(mv.machine);
        self.file.put(self.row, Some(row.file));
        self.line.put(self.row, i64::from(row.line));
        self.block.push(number);
        self.call_path.put(self.row, row.call_path);
        self.row += 1;
    }

    fn places(&mut self, mv: &Move, from: &Pos) {
        let row = self.row;
        for (axis, value) in from.iter() {
            self.start[axis.index()].put(row, value);
        }
        // In machine coordinates the others are somewhere else.
        let mut end = if mv.machine { Pos::UNKNOWN } else { *from };
        end.update(&mv.end);
        for (axis, value) in end.iter() {
            self.end[axis.index()].put(row, value);
        }
    }

    fn path(&mut self, path: &Path, length: Option<f64>) {
        let row = self.row;
        let kind = match path {
            Path::Rapid => 0,
            Path::Line(_) | Path::Carried { .. } => 1,
            Path::Arc(..) => 2,
            Path::Thread { .. } => 3,
        };
        self.kind.put(row, Some(kind));
        let (mut plane, mut lead) = (None, None);
        let mut along = length;
        let mut feed = path.feed();
        match path {
            Path::Arc(arc, _) => {
                plane = Some(match arc.plane {
                    Plane::Xy => 0,
                    Plane::Zx => 1,
                    Plane::Yz => 2,
                });
                self.arc(arc);
            }
            Path::Carried { feed: per_minute, length } => {
                feed = Some(Feed::PerMinute(*per_minute));
                along = Some(*length);
            }
            Path::Thread { lead: turn } => lead = Some(*turn),
            Path::Rapid | Path::Line(_) => {}
        }
        self.plane.put(row, plane);
        self.lead.put(row, lead);
        if let Some(along) = along {
            self.length.put(row, along);
        }
        self.feed.put(row, feed.map(Feed::value));
        let mode = feed.map(|feed| match feed {
            Feed::PerMinute(_) => 0,
            Feed::PerRevolution(_) => 1,
            Feed::InverseTime(_) => 2,
        });
        self.feed_mode.put(row, mode);
    }

    fn arc(&mut self, arc: &Arc) {
        let row = self.row;
        let (first, second, _) = arc.plane.axes();
        self.center[first].put(row, arc.center.x);
        self.center[second].put(row, arc.center.y);
        self.radius.put(row, distance(arc.from, arc.center));
        self.sweep.put(row, arc.sweep.to_degrees());
    }

    fn spindle_and_tool(&mut self) {
        let row = self.row;
        let (speed, mode, limit) = match self.program.speed {
            None => (None, None, None),
            Some(Speed::Turns(speed)) => (Some(speed), Some(0), None),
            Some(Speed::Cutting(speed, limit)) => (Some(speed), Some(1), limit),
        };
        self.spindle.put(row, speed);
        self.spindle_mode.put(row, mode);
        self.spindle_limit.put(row, limit);
        self.spindle_direction.put(row, self.program.sense.map(|sense| sense as i32));
        self.tool.put(row, self.program.tool.map(i64::from));
    }

    fn tool_axis(&mut self, machine: bool) {
        let direction = self.program.axis.direction(machine);
        for (i, column) in self.tool_axis.iter_mut().enumerate() {
            column.put(self.row, direction.map(|direction| direction[i]));
        }
    }

    /// The columns in order, without the time; the next batch begins.
    pub fn finish(&mut self) -> Vec<ArrayRef> {
        let rows = std::mem::take(&mut self.row);
        let mut all = vec![self.kind.finish(rows)];
        all.extend(self.start.iter_mut().map(|values| values.finish(rows)));
        all.extend(self.end.iter_mut().map(|values| values.finish(rows)));
        all.extend(self.center.iter_mut().map(|values| values.finish(rows)));
        all.extend([
            self.radius.finish(rows),
            self.sweep.finish(rows),
            self.plane.finish(rows),
            self.lead.finish(rows),
            self.feed.finish(rows),
            self.feed_mode.finish(rows),
            self.spindle.finish(rows),
            self.spindle_mode.finish(rows),
            self.spindle_limit.finish(rows),
            self.spindle_direction.finish(rows),
            self.tool.finish(rows),
            self.compensation.finish(rows),
            self.machine.finish(),
            self.length.finish(rows),
            self.file.finish(rows),
            self.line.finish(rows),
            self.block.finish(),
            self.call_path.finish(rows),
        ]);
        all.extend(self.tool_axis.iter_mut().map(|values| values.finish(rows)));
        all
    }
}
