//! The path as arrays: points, what leads to each, and the moves that they belong to.

use std::cell::Cell;

use crate::geo::{Point2, distance, turned};
use crate::ir::motion::{Arc, Move, Path as Way};
use crate::ir::{Blank, Feed, Function, Origin, Pos, Remark, Side};
use crate::machine::Axis;

use super::Blocks;
use super::packed::Packed;

/// Most points; what follows is left out and counted.
const MOST: usize = 8 << 20;
/// How far a chord may leave its arc, mm.
const CHORD: f64 = 0.002;
/// Chords of a whole turn.
const LEAST_CHORDS: f64 = 24.0;
const MOST_CHORDS: f64 = 180.0;
/// In the byte of a point: nothing leads to it.
const BEGINS: u8 = 0xff;
/// It lies behind an error.
const BROKEN: u8 = 0x80;

/// What is drawn of a program. Lengths in mm, in the coordinates of the workpiece, X of a lathe as radius.
#[derive(Debug, Default)]
pub struct Path {
    /// Zero of the points.
    pub origin: [f64; 3],
    /// Axes that are known somewhere.
    pub known: [bool; 3],
    /// X, Y, Z of each point, seen from `origin`.
    points: Vec<f32>,
    /// What leads to each point: 0 rapid, 1 line, 2 arc, 3 thread; 16, 32, 64 where X, Y, Z of it are not known, 128 behind an
    /// error.
    kinds: Vec<u8>,
    /// The move that leads to each point.
    owners: Vec<u32>,
    /// Of each move: line of its block, last line that was printed for it.
    blocks: Vec<u32>,
    printed: Vec<u32>,
    /// Feed, 0 for none; radius of an arc, below zero for a clockwise one.
    feeds: Vec<f32>,
    radii: Vec<f32>,
    /// 0 to 3 as above; 4 feed per turn, 8 moves a minute, 16 compensated on the left, 32 on the right, 64 machine coordinates.
    ways: Vec<u8>,
    /// Places in `tools`.
    tool_of: Vec<u16>,
    /// In the order of their changes.
    pub tools: Vec<Option<u32>>,
    pub left_out: u64,
    /// The first move behind an error, from which on the path is not whole.
    pub broken_from: Option<usize>,
    pub blank: Option<Blank>,
}

impl Path {
    /// There is no code that the moves could stand in.
    pub fn without_code(&mut self) {
        self.printed.fill(0);
    }

    /// The arrays, by name.
    pub fn pack(&self, packed: &mut Packed) {
        packed.numbers("points", &self.points);
        packed.part("kinds", self.kinds.clone());
        packed.words("owners", &self.owners);
        packed.words("blocks", &self.blocks);
        packed.words("printed", &self.printed);
        packed.numbers("feeds", &self.feeds);
        packed.numbers("radii", &self.radii);
        packed.part("ways", self.ways.clone());
        packed.halves("tool_of", &self.tool_of);
    }
}

/// Notes moves.
#[derive(Debug)]
pub struct Recorder<'a> {
    blocks: Blocks<'a>,
    printed: &'a Cell<u32>,
    path: Path,
    at: Pos,
    tool: u16,
}

impl<'a> Recorder<'a> {
    pub fn new(blocks: Blocks<'a>, printed: &'a Cell<u32>) -> Recorder<'a> {
        let path = Path { tools: vec![None], ..Path::default() };
        Recorder { blocks, printed, path, at: Pos::UNKNOWN, tool: 0 }
    }

    /// An axis that never gets a coordinate stands at zero: a lathe has no Y.
    pub fn finish(mut self) -> Path {
        let never: u8 =
            self.path.known.iter().zip([16, 32, 64]).filter(|(known, _)| !**known).map(|(_, bit)| bit).sum();
        for kind in self.path.kinds.iter_mut().filter(|kind| **kind != BEGINS) {
            *kind &= !never;
        }
        self.path
    }

    pub fn movement(&mut self, mv: &Move, origin: &Origin) {
        let path = &mut self.path;
        if path.kinds.len() >= MOST {
            path.left_out += 1;
            return;
        }
        let way = match &mv.path {
            Way::Rapid => 0,
            Way::Line(_) | Way::Carried { .. } => 1,
            Way::Arc(..) => 2,
            Way::Thread { .. } => 3,
        };
        let (feed, kind_of_feed) = match (mv.path, mv.path.feed()) {
            (Way::Carried { feed, .. }, _) | (_, Some(Feed::PerMinute(feed))) => (feed, 0),
            (_, Some(Feed::PerRevolution(feed))) => (feed, 4),
            (_, Some(Feed::InverseTime(feed))) => (feed, 8),
            (Way::Thread { lead }, None) => (lead, 4),
            (Way::Rapid | Way::Line(_) | Way::Arc(..), None) => (0.0, 0),
        };
        let side = match mv.side {
            Side::None => 0,
            Side::Left => 16,
            Side::Right => 32,
        };
        path.blocks.push(self.blocks.line(origin));
        path.printed.push(self.printed.get());
        path.feeds.push(feed as f32);
        path.radii.push(if let Way::Arc(arc, _) = &mv.path {
            (distance(arc.from, arc.center) * arc.sweep.signum()) as f32
        } else {
            0.0
        });
        path.ways.push(way | kind_of_feed | side | if mv.machine { 64 } else { 0 });
        path.tool_of.push(self.tool);
        if mv.machine {
            mv.axes.iter().for_each(|axis| self.at.forget(axis));
            return;
        }
        let from = self.at;
        if let Way::Arc(arc, _) = &mv.path {
            self.arc(arc, &from, mv);
        }
        let mut end = from;
        end.update(&mv.end);
        self.point(&from, &end, way);
        self.at = end;
    }

    /// The points between the ends of an arc.
    fn arc(&mut self, arc: &Arc, from: &Pos, mv: &Move) {
        let radius = distance(arc.from, arc.center);
        let turns = arc.sweep.abs() / core::f64::consts::TAU;
        let half = libm::acos((1.0 - CHORD / radius.max(CHORD)).clamp(-1.0, 1.0));
        let chords = (core::f64::consts::PI / half.max(1e-6)).clamp(LEAST_CHORDS, MOST_CHORDS);
        let chords = (turns * chords).ceil().clamp(1.0, 1e6) as u32;
        let along = |t: f64, p: Point2| {
            let mut pos = *from;
            for (axis, end) in mv.end.iter() {
                let start = from.get(axis).unwrap_or(end);
                pos.set(axis, start + (end - start) * t);
            }
            pos.set_in_plane(arc.plane, p);
            pos
        };
        for chord in 1..chords {
            if self.path.kinds.len() >= MOST {
                return;
            }
            let t = f64::from(chord) / f64::from(chords);
            let pos = along(t, arc.center + turned(arc.from - arc.center, arc.sweep * t));
            self.point(from, &pos, 2);
        }
    }

    /// A way of the move that was noted last leads to `to`; what is not known of the start of the move, `from`, is not
    /// known of the way.
    fn point(&mut self, from: &Pos, to: &Pos, kind: u8) {
        let path = &mut self.path;
        let owner = path.blocks.len() as u32 - 1;
        if path.kinds.is_empty() {
            path.origin = [Axis::X, Axis::Y, Axis::Z].map(|axis| from.get(axis).or(to.get(axis)).unwrap_or(0.0));
            path.kinds.push(BEGINS);
            path.owners.push(owner);
            path.points.extend_from_slice(&[0.0; 3]);
        }
        let mut unknown = 0;
        for (axis, bit) in [(Axis::X, 16), (Axis::Y, 32), (Axis::Z, 64)] {
            let index = axis.index();
            let value = to.get(axis);
            path.known[index] |= value.is_some();
            if value.is_none() || from.get(axis).is_none() {
                unknown |= bit;
            }
            let before = path.points[path.points.len() - 3];
            path.points.push(value.map_or(before, |value| (value - path.origin[index]) as f32));
        }
        let broken = if path.broken_from.is_some() { BROKEN } else { 0 };
        path.kinds.push(kind | unknown | broken);
        path.owners.push(owner);
    }

    pub fn function(&mut self, function: &Function) {
        if let Function::ToolChange { number } = function {
            let known = self.path.tools.iter().position(|tool| *tool == Some(*number));
            let place = known.unwrap_or(self.path.tools.len());
            if known.is_none() && place < usize::from(u16::MAX) {
                self.path.tools.push(Some(*number));
            }
            self.tool = u16::try_from(place).unwrap_or(u16::MAX);
        } else if let Function::WorkOffset(_) | Function::Tilt(_) = function {
            self.at.clear();
        } else if let Function::Remark(remark) = function {
            match remark {
                Remark::Refused => self.path.broken_from = Some(self.path.blocks.len()),
                Remark::Blank(blank) => self.path.blank = Some(*blank),
            }
        }
    }

    pub fn lost(&mut self) {
        self.at.clear();
    }

    pub fn begins_at(&mut self, at: &Pos) {
        self.at.update(at);
    }
}
