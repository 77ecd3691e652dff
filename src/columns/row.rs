//! The open batch: a column for each field but the time.

use arrow_array::ArrayRef;
use rustc_hash::FxHashMap;

use crate::diag::{CallPath, Trail};
use crate::emit::told::{Sense, Speed, Told};
use crate::geo::{Plane, distance};
use crate::ir::motion::{Move, Path};
use crate::ir::{Feed, Function, Origin, Pos, Side};
use crate::machine::axis::{AXES, Axis};
use crate::text::{BlockNumbers, FileId, Sources};

use super::arrays::{Texts, Truths, Values, Words};

/// Place of the time among the columns.
pub(super) const TIME: usize = 36;

const KINDS: &[&str] = &["rapid", "line", "arc", "thread"];
const PLANES: &[&str] = &["XY", "ZX", "YZ"];
const FEEDS: &[&str] = &["per_minute", "per_revolution", "inverse_time"];
const SPEEDS: &[&str] = &["speed", "cutting_speed"];
const SIDES: &[&str] = &["left", "right"];

pub(super) struct Rows<'a> {
    sources: &'a Sources,
    trail: &'a Trail,
    told: Told,
    kind: Words,
    start: [Values<f64>; AXES],
    end: [Values<f64>; AXES],
    center: [Values<f64>; 3],
    radius: Values<f64>,
    sweep: Values<f64>,
    plane: Words,
    lead: Values<f64>,
    feed: Values<f64>,
    feed_mode: Words,
    spindle: Values<f64>,
    spindle_mode: Words,
    spindle_limit: Values<f64>,
    spindle_direction: Words,
    tool: Values<i64>,
    compensation: Words,
    machine: Truths,
    length: Values<f64>,
    file: Words,
    line: Values<i64>,
    block: Texts,
    call_path: Words,
    /// Keys of the files.
    files: Vec<Option<i32>>,
    /// Keys of the call paths, and the one that was asked for last.
    paths: FxHashMap<CallPath, i32>,
    last_path: (CallPath, Option<i32>),
    numbers: BlockNumbers,
}

impl<'a> Rows<'a> {
    pub fn new(sources: &'a Sources, trail: &'a Trail) -> Rows<'a> {
        Rows {
            sources,
            trail,
            told: Told::default(),
            kind: Words::new(KINDS),
            start: std::array::from_fn(|_| Values::new()),
            end: std::array::from_fn(|_| Values::new()),
            center: std::array::from_fn(|_| Values::new()),
            radius: Values::new(),
            sweep: Values::new(),
            plane: Words::new(PLANES),
            lead: Values::new(),
            feed: Values::new(),
            feed_mode: Words::new(FEEDS),
            spindle: Values::new(),
            spindle_mode: Words::new(SPEEDS),
            spindle_limit: Values::new(),
            spindle_direction: Words::new(&Sense::ALL.map(Sense::name)),
            tool: Values::new(),
            compensation: Words::new(SIDES),
            machine: Truths::new(),
            length: Values::new(),
            file: Words::new(&[]),
            line: Values::new(),
            block: Texts::default(),
            call_path: Words::new(&[]),
            files: Vec::new(),
            paths: FxHashMap::default(),
            last_path: (CallPath::MAIN, None),
            numbers: BlockNumbers::default(),
        }
    }

    pub fn function(&mut self, function: &Function) {
        self.told.function(function);
    }

    /// A move from `from` on, of this length.
    pub fn push(&mut self, mv: &Move, origin: &Origin, from: &Pos, length: Option<f64>) {
        self.places(mv, from);
        self.path(&mv.path, length);
        self.told();
        self.compensation.push(match mv.side {
            Side::None => None,
            Side::Left => Some(0),
            Side::Right => Some(1),
        });
        self.machine.push(mv.machine);
        self.origin(origin);
    }

    fn places(&mut self, mv: &Move, from: &Pos) {
        for (axis, column) in Axis::ALL.into_iter().zip(&mut self.start) {
            column.push(from.get(axis));
        }
        for (axis, column) in Axis::ALL.into_iter().zip(&mut self.end) {
            // In machine coordinates the others are somewhere else.
            let stays = if mv.machine { None } else { from.get(axis) };
            column.push(mv.end.get(axis).or(stays));
        }
    }

    fn path(&mut self, path: &Path, length: Option<f64>) {
        let kind = match path {
            Path::Rapid => 0,
            Path::Line(_) | Path::Carried { .. } => 1,
            Path::Arc(..) => 2,
            Path::Thread { .. } => 3,
        };
        self.kind.push(Some(kind));
        let mut center = [None; 3];
        let (mut radius, mut sweep, mut plane, mut lead) = (None, None, None, None);
        let mut along = length;
        let mut feed = path.feed();
        match path {
            Path::Arc(arc, _) => {
                let (first, second, _) = arc.plane.axes();
                (center[first], center[second]) = (Some(arc.center.x), Some(arc.center.y));
                radius = Some(distance(arc.from, arc.center));
                sweep = Some(arc.sweep.to_degrees());
                plane = Some(match arc.plane {
                    Plane::Xy => 0,
                    Plane::Zx => 1,
                    Plane::Yz => 2,
                });
            }
            Path::Carried { feed: per_minute, length } => {
                feed = Some(Feed::PerMinute(*per_minute));
                along = Some(*length);
            }
            Path::Thread { lead: turn } => lead = Some(*turn),
            Path::Rapid | Path::Line(_) => {}
        }
        for (column, value) in self.center.iter_mut().zip(center) {
            column.push(value);
        }
        self.radius.push(radius);
        self.sweep.push(sweep);
        self.plane.push(plane);
        self.lead.push(lead);
        self.length.push(along);
        self.feed.push(feed.map(Feed::value));
        self.feed_mode.push(feed.map(|feed| match feed {
            Feed::PerMinute(_) => 0,
            Feed::PerRevolution(_) => 1,
            Feed::InverseTime(_) => 2,
        }));
    }

    fn told(&mut self) {
        let (speed, mode, limit) = match self.told.speed {
            None => (None, None, None),
            Some(Speed::Turns(speed)) => (Some(speed), Some(0), None),
            Some(Speed::Cutting(speed, limit)) => (Some(speed), Some(1), limit),
        };
        self.spindle.push(speed);
        self.spindle_mode.push(mode);
        self.spindle_limit.push(limit);
        self.spindle_direction.push(self.told.sense.map(|sense| sense as i32));
        self.tool.push(self.told.tool.map(i64::from));
    }

    fn origin(&mut self, origin: &Origin) {
        let file = self.file_key(origin.loc.file);
        self.file.push(Some(file));
        self.line.push(Some(i64::from(origin.loc.line)));
        self.block.push(self.numbers.of(self.sources, origin.loc));
        let path = self.path_key(origin.call);
        self.call_path.push(path);
    }

    fn file_key(&mut self, id: FileId) -> i32 {
        let place = usize::from(id.0);
        if self.files.len() <= place {
            self.files.resize(place + 1, None);
        }
        *self.files[place].get_or_insert_with(|| self.file.add(self.sources.name(id)))
    }

    fn path_key(&mut self, call: CallPath) -> Option<i32> {
        if call == self.last_path.0 {
            return self.last_path.1;
        }
        let (trail, sources, words) = (self.trail, self.sources, &mut self.call_path);
        let key = (call != CallPath::MAIN).then(|| {
            *self.paths.entry(call).or_insert_with(|| {
                let sites = trail.sites(call);
                let calls: Vec<String> =
                    sites.iter().rev().map(|site| format!("{}:{}", sources.name(site.file), site.line)).collect();
                words.add(calls.join(" > "))
            })
        });
        self.last_path = (call, key);
        key
    }

    /// The columns in order, without the time; the next batch begins.
    pub fn finish(&mut self) -> Vec<ArrayRef> {
        let mut all = vec![self.kind.finish()];
        all.extend(self.start.iter_mut().map(Values::<f64>::finish));
        all.extend(self.end.iter_mut().map(Values::<f64>::finish));
        all.extend(self.center.iter_mut().map(Values::<f64>::finish));
        all.extend([
            self.radius.finish(),
            self.sweep.finish(),
            self.plane.finish(),
            self.lead.finish(),
            self.feed.finish(),
            self.feed_mode.finish(),
            self.spindle.finish(),
            self.spindle_mode.finish(),
            self.spindle_limit.finish(),
            self.spindle_direction.finish(),
            self.tool.finish(),
            self.compensation.finish(),
            self.machine.finish(),
            self.length.finish(),
            self.file.finish(),
            self.line.finish(),
            self.block.finish(),
            self.call_path.finish(),
        ]);
        all
    }
}
