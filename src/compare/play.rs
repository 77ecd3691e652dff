//! Plain G-code as motion items: what a reader of it finds, in the language that everything after the compiler speaks.

use core::f64::consts::TAU;

use crate::geo::{Plane, Point2, rotation};
use crate::ir::function::{Spindle, Turn};
use crate::ir::motion::{Arc, Move, Path, Place, Sink};
use crate::ir::tap::Stroke;
use crate::ir::tilt::Solution;
use crate::ir::{Function, Origin, Pos, Side, Tap, Tilt, Tilting};
use crate::machine::{Axis, AxisSet};
use crate::read::{self, AXES, Act, Angles, Choice, Reader, Rules};
use crate::sema::gcode::function::{self, plane, real};
use crate::text::Loc;

/// Where a program cannot be read, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stop {
    pub line: u64,
    pub why: String,
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "line {} cannot be read: {}", self.line, self.why)
    }
}

/// Gives what the program does to `sink`, each item with its line.
///
/// # Errors
/// The first line that is no plain G-code.
pub fn play(text: &[u8], sink: &mut dyn Sink) -> Result<(), Stop> {
    let reader = Reader::switched_on(rules_of(text));
    let mut player = Player { reader, sink, selected: None, waiting: None, cutter: None, open: None };
    let (mut rest, mut end) = (text, text.len());
    loop {
        let before = player.reader.lines();
        let act = player.reader.next(&mut rest, &mut end);
        let stop = |why: String| Stop { line: player.reader.lines().max(before), why };
        if act.is_err() && player.reader.closed() && !player.reader.ended() {
            // Behind the `%` that closes the program nothing is read.
            break;
        }
        match act.map_err(|fault| stop(fault.why))? {
            Some(act) => player.act(act).map_err(|why| Stop { line: player.reader.lines(), why: why.to_owned() })?,
            None => break,
        }
    }
    player.bring_forth(None);
    Ok(())
}

/// The rules of the target that the head of a printed program names; otherwise those of LinuxCNC.
pub(super) fn rules_of(text: &[u8]) -> Rules {
    const HEAD: usize = 400;
    const NAMED: &str = "partc ";
    let head = String::from_utf8_lossy(&text[..text.len().min(HEAD)]).to_lowercase();
    let line = head.lines().find(|line| line.contains(NAMED));
    let name = line.and_then(|line| line.split_once("target ")).map(|(_, name)| name.trim_end_matches(')').trim());
    Rules::of(name.unwrap_or_default())
}

struct Player<'a> {
    reader: Reader,
    sink: &'a mut dyn Sink,
    /// The tool that T chose last.
    selected: Option<u32>,
    /// A T word that a change in the same line may use: the tool and the line.
    waiting: Option<(u32, u64)>,
    cutter: Option<read::Cutter>,
    /// A tap that went in.
    open: Option<Tap>,
}

impl Player<'_> {
    fn origin(&self) -> Origin {
        let line = u32::try_from(self.reader.lines()).unwrap_or(u32::MAX);
        Origin { loc: Loc { line, ..Loc::default() }, ..Origin::default() }
    }

    fn does(&mut self, function: Function) {
        let origin = self.origin();
        self.sink.function(&function, &origin);
    }

    /// A T word that no change in its line uses tells the changer what comes next.
    fn bring_forth(&mut self, act: Option<&Act>) {
        if let Some((number, line)) = self.waiting.take()
            && !(act == Some(&Act::Change) && line == self.reader.lines())
        {
            self.does(Function::ToolPrepare { number });
        }
    }

    fn act(&mut self, act: Act) -> Result<(), &'static str> {
        self.bring_forth(Some(&act));
        match act {
            Act::Move(mv) => return self.movement(&mv),
            Act::Tap => return self.tap(),
            Act::Dwell(seconds) if self.open.is_some() => {
                if let Some(open) = &mut self.open {
                    open.strokes.iter_mut().for_each(|stroke| stroke.dwell += real(seconds));
                }
            }
            Act::Select(tool) => {
                self.selected = Some(tool);
                self.waiting = Some((tool, self.reader.lines()));
            }
            Act::Change => {
                let number = self.selected.ok_or("a change to a tool that no T has chosen")?;
                self.does(Function::ToolChange { number });
            }
            Act::Tilt(tilting) => {
                if let Some(tilting) = self.tilting(tilting) {
                    self.does(Function::Tilt(Box::new(tilting)));
                }
            }
            Act::Speed(_) | Act::M { .. } | Act::Dwell(_) | Act::Corners(_) | Act::Offset(_) => {
                if let Some(function) = function::function(&act)? {
                    self.does(function);
                }
            }
        }
        Ok(())
    }

    /// A tilted plane; a shift alone is a part of the plane that comes.
    fn tilting(&self, tilting: read::Tilting) -> Option<Tilting> {
        let read = self.reader.tilt();
        let solution = match read.choice {
            Choice::Unsaid | Choice::Primary(None) => Solution::Control,
            Choice::Primary(Some(positive)) => Solution::Primary { positive },
            Choice::Reference(greater) => Solution::Reference { greater },
        };
        let angles = read.angles.map(real);
        let axes = match read.about {
            Angles::Euler => rotation::euler(angles),
            Angles::Spatial => rotation::spatial(angles),
        };
        Some(match tilting {
            read::Tilting::Shifted => return None,
            read::Tilting::Into => Tilting::Into(Tilt { axes, origin: read.origin.map(real).into(), solution }),
            read::Tilting::Back => Tilting::Back(solution),
            read::Tilting::Off => Tilting::Off,
        })
    }

    /// A stroke, or one of its two ways.
    fn tap(&mut self) -> Result<(), &'static str> {
        let read = *self.reader.tap();
        let axis = Axis::ALL[read.axis];
        let speed = read.speed.map(real);
        let item = Tap {
            axis,
            start: real(read.from),
            surface: read.steps.map_or(real(read.from), |[surface, ..]| real(surface)),
            strokes: vec![Stroke { to: real(read.to), back: real(read.back), dwell: real(read.dwell) }],
            lead: real(read.lead),
            turn: if read.left { Turn::CounterClockwise } else { Turn::Clockwise },
            speed_in: speed,
            speed_out: speed.map(|speed| if read.factor == 0 { speed } else { speed * real(read.factor) }),
            orient: None,
            pause: 0.0,
            again: None,
        };
        match (read.way, self.open.take()) {
            (read::Way::Both, None) => {
                let strokes = steps(&read).unwrap_or_else(|| item.strokes.clone());
                self.send_tap(&Tap { strokes, ..item });
            }
            (read::Way::In, None) => self.open = Some(item),
            (read::Way::In, Some(open)) => self.open = Some(Tap { start: open.start, ..item }),
            (read::Way::Out, Some(open)) => {
                let strokes = open.strokes.iter().map(|stroke| Stroke { back: real(read.back), ..*stroke }).collect();
                self.send_tap(&Tap { strokes, speed_out: speed, ..open });
            }
            (read::Way::Both, Some(_)) | (read::Way::Out, None) => {
                return Err("the ways in and out of a tap do not belong together");
            }
        }
        Ok(())
    }

    fn send_tap(&mut self, tap: &Tap) {
        let mut at = Pos::UNKNOWN;
        for axis in bits(self.reader.known()) {
            at.set(axis, real(self.reader.at()[axis.index()]));
        }
        at.set(tap.axis, tap.start);
        let plane = self.reader.modes().plane.map_or(Plane::Xy, plane);
        let origin = self.origin();
        self.sink.tap(tap, &Place { at, plane }, &origin);
        if let Some(speed) = self.reader.tapped_speed() {
            self.does(Function::Spindle(Spindle::Speed(real(speed))));
        }
    }

    fn movement(&mut self, mv: &read::Move) -> Result<(), &'static str> {
        let side = self.side();
        let axes: AxisSet = bits(mv.axes).collect();
        let mut end = Pos::UNKNOWN;
        let told = if mv.machine { mv.axes } else { self.reader.known() };
        for axis in bits(told) {
            end.set(axis, real(self.reader.at()[axis.index()]));
        }
        let plane = self.reader.modes().plane.map_or(Plane::Xy, plane);
        let path = match mv.path {
            read::Path::Rapid => Path::Rapid,
            read::Path::Line => Path::Line(function::feed(&self.reader)?),
            read::Path::Thread(lead) => Path::Thread { lead: real(lead) },
            read::Path::Arc(arc) => Path::Arc(exact(&arc)?, function::feed(&self.reader)?),
        };
        let mut axes = axes;
        if let read::Path::Arc(arc) = mv.path {
            arc.plane.axes()[..2].iter().for_each(|axis| axes.insert(Axis::ALL[*axis]));
        }
        let origin = self.origin();
        self.sink.movement(&Move { end, axes, path, side, plane, machine: mv.machine }, &origin);
        Ok(())
    }

    /// The side that holds; a new cutter is told first.
    fn side(&mut self) -> Side {
        let cutter = self.reader.modes().cutter.unwrap_or_default();
        if cutter.side != 0 && self.cutter != Some(cutter) {
            self.cutter = Some(cutter);
            self.does(function::cutter(cutter));
        }
        function::side(cutter)
    }
}

/// The strokes of a cycle that makes them by itself.
fn steps(read: &read::Tap) -> Option<Vec<Stroke>> {
    const MOST: i64 = 10_000;
    let [surface, way, back] = read.steps?;
    let deep = surface.checked_sub(read.to)?;
    let count = (deep - 1).checked_div(way)?.clamp(0, MOST);
    let stroke = |at: i64| {
        let depth = surface - at * way;
        Stroke {
            to: real(depth),
            back: real(if back == 0 { read.from } else { (depth + back).min(read.from) }),
            dwell: 0.0,
        }
    };
    let last = Stroke { to: real(read.to), back: real(read.back), dwell: 0.0 };
    Some((1..=count).map(stroke).chain([last]).collect())
}

/// An arc by its exact sweep.
fn exact(arc: &read::Arc) -> Result<Arc, &'static str> {
    let point = |p: [i64; 2]| Point2::new(real(p[0]), real(p[1]));
    let (from, to, center) = (point(arc.from), point(arc.to), point(arc.center));
    if arc.from == arc.center || arc.to == arc.center {
        return Err("an arc without a radius");
    }
    let sense = f64::from(arc.turns.signum());
    let angle = |p: Point2| libm::atan2(p.y - center.y, p.x - center.x);
    let mut part = sense * (angle(to) - angle(from));
    if part <= 0.0 {
        part += TAU;
    }
    if arc.from == arc.to {
        part = TAU;
    }
    let sweep = sense * (part + TAU * f64::from(arc.turns.abs() - 1));
    Ok(Arc { plane: plane(arc.plane), from, center, sweep })
}

/// The axes of a set of bits.
fn bits(set: u16) -> impl Iterator<Item = Axis> {
    (0..AXES).filter(move |i| set & (1 << i) != 0).map(|i| Axis::ALL[i])
}
