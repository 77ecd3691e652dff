//! What a program does, step by step, without how it was said.

use core::f64::consts::TAU;

use crate::geo::{Plane, Point2, distance, rotation, turned};
use crate::ir::function::{Coolant, CutterData, Spindle, Turn};
use crate::ir::motion::{Move, Path, Place, Sink};
use crate::ir::{Feed, Function, Origin, Pos, Side, Tap, Tilting};
use crate::machine::{Axis, MachineKind, OutputSettings, PathControl, Settings};
use crate::text::Loc;

/// One thing that a program does, and the block that asks for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    pub file: u16,
    /// From 1.
    pub line: u32,
    pub does: Does,
}

#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "nearly all steps are moves")]
pub enum Does {
    Travel(Travel),
    /// A word such as `M3` or `S`, and its numbers.
    Function(String, [f64; 2]),
}

/// A move with everything that holds for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Travel {
    pub kind: Kind,
    /// Where it starts and ends, as far as it is known.
    pub start: Pos,
    pub end: Pos,
    /// The feed; `None` where there is none, or where the machine has to work it out.
    pub feed: Option<Feed>,
    pub side: Side,
    pub machine: bool,
    pub tool: Option<u32>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    Rapid,
    Line,
    /// The way of a turn of the spindle.
    Thread(f64),
    /// In step with the spindle along one axis to a depth and back.
    Tap(Stroke),
    Arc {
        plane: Plane,
        center: Point2,
        sweep: f64,
    },
}

/// A stroke of a tap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    pub axis: Axis,
    pub depth: f64,
    pub lead: f64,
    pub turn: Turn,
    /// Turns a minute, as far as they were said.
    pub speed: Option<f64>,
    /// On the way out.
    pub back: Option<f64>,
    pub dwell: f64,
    /// Of the spindle at the start, in degrees, where it was said.
    pub angle: Option<f64>,
    /// A program of a control that says no angle leaves it to its output, which may have to say 0.
    pub any_angle: bool,
}

impl Travel {
    /// Where the machine is after this part of the way.
    pub fn place(&self, part: f64) -> Pos {
        let mut place = Pos::UNKNOWN;
        for (axis, end) in self.end.iter() {
            let start = self.start.get(axis).unwrap_or(end);
            place.set(axis, start + (end - start) * part);
        }
        if let Kind::Arc { plane, center, sweep } = self.kind
            && let Some(from) = self.start.in_plane(plane)
        {
            place.set_in_plane(plane, center + turned(from - center, sweep * part));
        }
        place
    }

    /// Way of the main axes in mm, as far as the start is known.
    pub fn length(&self) -> f64 {
        if self.machine {
            return 0.0;
        }
        let way = |axis: Axis| self.end.get(axis).zip(self.start.get(axis)).map_or(0.0, |(end, start)| end - start);
        let [x, y, z] = [Axis::X, Axis::Y, Axis::Z].map(way);
        match self.kind {
            Kind::Arc { plane, center, sweep } => {
                let (_, _, third) = plane.axes();
                let radius = self.end.in_plane(plane).map_or(0.0, |end| distance(end, center));
                libm::hypot(radius * sweep, way(Axis::ALL[third]))
            }
            Kind::Rapid | Kind::Line | Kind::Thread(_) => libm::hypot(libm::hypot(x, y), z),
            Kind::Tap(stroke) => {
                let deep = |pos: &Pos| pos.get(stroke.axis).map_or(0.0, |at| (at - stroke.depth).abs());
                deep(&self.start) + deep(&self.end)
            }
        }
    }
}

/// Keeps the steps of a motion stream. A way that is no way is none; parts of one arc are one arc.
#[derive(Debug)]
pub struct Steps {
    list: Vec<Step>,
    /// A way that is no longer is none, in mm.
    nothing: f64,
    at: Pos,
    tool: Option<u32>,
    cutter: CutterData,
    offset: Option<u8>,
    /// Of the spindle, in turns a minute.
    speed: Option<f64>,
    /// The speeds among the steps, the last one at the end.
    said: Vec<f64>,
    /// A tap was made at its own speed: the one after it is a step where the spindle starts or cuts with it.
    speed_waits: bool,
    corners: Option<PathControl>,
    /// What a stream says of corners is what is printed for it, on a lathe or a mill.
    output: Option<(OutputSettings, bool)>,
}

impl Steps {
    /// Ways up to half the tolerance are none.
    pub fn new(tolerance: f64) -> Steps {
        let (list, at) = (Vec::new(), Pos::UNKNOWN);
        let nothing = tolerance / 2.0;
        let (cutter, corners, output) = (CutterData::default(), None, None);
        let (tool, offset, speed, said, speed_waits) = (None, None, None, Vec::new(), false);
        Steps { list, nothing, at, tool, cutter, offset, speed, said, speed_waits, corners, output }
    }

    /// The same for a stream that is printed with these settings: the output says how corners are taken where the program
    /// does not.
    pub fn of_program(tolerance: f64, settings: &Settings) -> Steps {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let mut steps = Steps { output: Some((settings.output.clone(), lathe)), ..Steps::new(tolerance) };
        let start = Origin { loc: Loc { line: 1, ..Loc::default() }, ..Origin::default() };
        if settings.output.target.path.is_empty() {
            steps.corners_are_open();
        } else {
            steps.path_control(None, &start);
        }
        steps
    }

    /// All steps. A program that does not say how it ends stops at its end.
    pub fn finish(mut self) -> Vec<Step> {
        let ends = |step: &Step| matches!(&step.does, Does::Function(word, _) if word == "end");
        if !self.list.iter().rev().any(ends) {
            let origin = Origin::default();
            self.function("end", [0.0; 2], &origin);
        }
        self.list
    }

    fn function(&mut self, word: &str, numbers: [f64; 2], origin: &Origin) {
        let does = Does::Function(word.to_owned(), numbers);
        self.list.push(Step { file: origin.loc.file.0, line: origin.loc.line, does });
    }

    /// A plane by the angles and the zero point that say where it lies.
    fn tilt(&mut self, tilting: &Tilting, origin: &Origin) {
        self.at.clear();
        let word = match tilting {
            Tilting::Into(_) => "plane",
            Tilting::Back(_) => "plane back",
            Tilting::Off => "plane off",
        };
        let Some(tilt) = tilting.plane() else { return self.function(word, [0.0; 2], origin) };
        let [a, b, c] = rotation::spatial_of(&tilt.axes);
        let [x, y, z] = [0, 1, 2].map(|i| tilt.origin[i]);
        for (part, numbers) in [("A B", [a, b]), ("C X", [c, x]), ("Y Z", [y, z])] {
            self.function(&format!("{word} {part}"), numbers, origin);
        }
    }

    fn spindle(&mut self, spindle: Spindle, number: u8, origin: &Origin) {
        if number == 0 {
            match spindle {
                Spindle::Speed(speed) => {
                    self.speed = Some(speed);
                    if self.speed_waits {
                        return;
                    }
                    self.said.push(speed);
                }
                Spindle::CuttingSpeed { .. } => {
                    (self.speed, self.speed_waits) = (None, false);
                    self.said.push(f64::NAN);
                }
                Spindle::Start(_) => self.speed_counts(origin),
                Spindle::Stop | Spindle::Orient(_) => {}
            }
        }
        let number = f64::from(number);
        match spindle {
            Spindle::Start(Turn::Clockwise) => self.function("M3", [number, 0.0], origin),
            Spindle::Start(Turn::CounterClockwise) => self.function("M4", [number, 0.0], origin),
            Spindle::Stop => self.function("M5", [number, 0.0], origin),
            Spindle::Speed(speed) => self.function("S", [number, speed], origin),
            Spindle::CuttingSpeed { speed, limit } => {
                if let Some(limit) = limit {
                    self.function("speed limit", [number, limit], origin);
                }
                self.function("cutting speed", [number, speed], origin);
            }
            Spindle::Orient(angle) => self.function("M19", [number, angle], origin),
        }
    }

    /// The speed after a tap is one from here on.
    fn speed_counts(&mut self, origin: &Origin) {
        if std::mem::take(&mut self.speed_waits)
            && let Some(speed) = self.speed
            && self.said.last() != Some(&speed)
        {
            self.said.push(speed);
            self.function("S", [0.0, speed], origin);
        }
    }

    /// Makes one arc of this one and the one in front of it, where they are parts of it.
    fn joins(&mut self, next: &Travel) -> bool {
        let Some(Step { does: Does::Travel(last), .. }) = self.list.last_mut() else { return false };
        let (Kind::Arc { plane, center, sweep }, Kind::Arc { plane: other, center: about, sweep: more }) =
            (last.kind, next.kind)
        else {
            return false;
        };
        let by_time = matches!(next.feed, Some(Feed::InverseTime(_)));
        let radius = self.at.in_plane(plane).map_or(0.0, |at| distance(at, center));
        let same = plane == other
            && sweep.signum() == more.signum()
            && distance(center, about) <= MOST_APART
            && last.feed == next.feed
            && !by_time
            && last.side == next.side;
        // An axis that goes along goes evenly: by the turn.
        let even = same
            && next.end.iter().all(|(axis, end)| {
                let (first, second, _) = plane.axes();
                let in_plane = axis.index() == first || axis.index() == second;
                let Some((start, middle)) = last.start.get(axis).zip(last.end.get(axis)) else { return in_plane };
                let share = sweep / (sweep + more);
                in_plane || (start + (end - start) * share - middle).abs() <= MOST_APART
            });
        if !even || radius < MOST_APART {
            return false;
        }
        last.kind = Kind::Arc { plane, center, sweep: sweep + more };
        last.end = next.end;
        true
    }
}

/// How far the centres of parts of one arc may lie apart by their rounding, in mm.
const MOST_APART: f64 = 0.0025;

impl Sink for Steps {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        let kind = match &mv.path {
            Path::Rapid => Kind::Rapid,
            Path::Line(_) | Path::Carried { .. } => Kind::Line,
            Path::Thread { lead } => Kind::Thread(*lead),
            Path::Arc(arc, _) => Kind::Arc { plane: arc.plane, center: arc.center, sweep: arc.sweep },
        };
        if self.speed_waits && !matches!(kind, Kind::Rapid) {
            self.speed_counts(origin);
        }
        let start = self.at;
        let mut end = if mv.machine { Pos::UNKNOWN } else { start };
        for axis in mv.axes.iter() {
            if let Some(value) = mv.end.get(axis) {
                end.set(axis, value);
            }
        }
        let travel =
            Travel { kind, start, end, feed: mv.path.feed(), side: mv.side, machine: mv.machine, tool: self.tool };
        let stays = |(axis, end): (Axis, f64)| start.get(axis).is_some_and(|start| (start - end).abs() <= self.nothing);
        let is_way = matches!(kind, Kind::Arc { .. }) || mv.machine || !end.iter().all(stays);
        if !is_way {
            return;
        }
        if !self.joins(&travel) {
            let does = Does::Travel(travel);
            self.list.push(Step { file: origin.loc.file.0, line: origin.loc.line, does });
        }
        if mv.machine {
            mv.axes.iter().for_each(|axis| self.at.forget(axis));
        } else {
            self.at = end;
        }
    }

    fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        let before = self.spindle_before_tap();
        // A program says the angle with its tap, a text with the words in front of it.
        let is_program = self.output.is_some();
        let angle = tap.orient.or(before.filter(|_| !is_program));
        self.speed_waits = true;
        let (speed, tool) = (tap.speed_in.or(self.speed), self.tool);
        let back = tap.speed_out.or(speed);
        for (at, stroke) in tap.strokes.iter().enumerate() {
            if at > 0 && tap.pause > 0.0 {
                self.dwell(tap.pause, origin);
            }
            let does = Stroke {
                axis: tap.axis,
                depth: stroke.to,
                lead: tap.lead,
                turn: tap.turn,
                speed,
                back,
                dwell: stroke.dwell,
                angle: angle.filter(|_| at == 0),
                any_angle: is_program && angle.is_none() && at == 0,
            };
            let start = self.at;
            self.at.update(&place.at);
            self.at.set(tap.axis, stroke.back);
            let travel = Travel {
                kind: Kind::Tap(does),
                start,
                end: self.at,
                feed: None,
                side: Side::None,
                machine: false,
                tool,
            };
            let (file, line) = (origin.loc.file.0, origin.loc.line);
            self.list.push(Step { file, line, does: Does::Travel(travel) });
        }
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        let none = [0.0; 2];
        match function {
            Function::ToolChange { number } => {
                self.tool = Some(*number);
                self.function("tool", [f64::from(*number), 0.0], origin);
            }
            Function::ToolPrepare { number } => self.function("T", [f64::from(*number), 0.0], origin),
            Function::Cutter(cutter) => self.cutter = *cutter,
            Function::Spindle(spindle) => self.spindle(*spindle, 0, origin),
            Function::SpindleOf { number, spindle } => self.spindle(*spindle, number.saturating_sub(1), origin),
            Function::Coolant(Coolant::Mist) => self.function("M7", none, origin),
            Function::Coolant(Coolant::Flood) => self.function("M8", none, origin),
            Function::Coolant(Coolant::Off) => self.function("M9", none, origin),
            Function::Dwell(seconds) => self.dwell(*seconds, origin),
            Function::Stop => self.function("M0", none, origin),
            Function::OptionalStop => self.function("M1", none, origin),
            // What the control counts among its own.
            Function::Aux(number @ (0 | 1 | 3..=5 | 7..=9)) => self.function(&format!("M{number}"), none, origin),
            Function::Aux(number) => self.function("M", [f64::from(*number), 0.0], origin),
            Function::WorkOffset(number) => {
                self.at.clear();
                if self.offset.replace(*number) != Some(*number) {
                    self.function("work offset", [f64::from(*number), 0.0], origin);
                }
            }
            Function::Tilt(tilting) => self.tilt(tilting, origin),
            Function::End { rewind } => self.function("end", [f64::from(u8::from(*rewind)), 0.0], origin),
            Function::PathControl(said) => self.path_control(*said, origin),
            Function::FeedSpindle(_)
            | Function::Transformation(_)
            | Function::Plane(_)
            | Function::Comment(_)
            | Function::Remark(_) => {}
        }
    }

    fn lost(&mut self, _: &Origin) {
        self.at.clear();
    }

    fn begins_at(&mut self, at: &Pos) {
        // Later on it is what the configuration says of a change, on which no output relies.
        if self.list.is_empty() {
            self.at.update(at);
        } else {
            at.known().iter().for_each(|axis| self.at.forget(axis));
        }
    }
}

impl Steps {
    /// No word of the receiver says how corners are taken.
    pub fn corners_are_open(&mut self) {
        self.function(OPEN_CORNERS, [0.0; 2], &Origin::default());
    }

    /// How corners are taken, where it changes.
    fn path_control(&mut self, said: Option<PathControl>, origin: &Origin) {
        let mode = match &self.output {
            Some((output, lathe)) => output.path_control(said, *lathe),
            None => said,
        };
        let Some(mode) = mode.filter(|mode| self.corners != Some(*mode)) else { return };
        self.corners = Some(mode);
        match mode {
            PathControl::Exact => self.function("G61", [0.0; 2], origin),
            PathControl::Within(mm) => self.function("G64 P", [mm, 0.0], origin),
            PathControl::Before(mm) => self.function("G641 ADIS=", [mm, 0.0], origin),
            PathControl::Unbounded => self.function("G64", [0.0; 2], origin),
        }
    }

    /// A tap starts the spindle by itself, at its speed: what was said of it just before has no effect but for the angle at which it
    /// was stopped, which is returned.
    fn spindle_before_tap(&mut self) -> Option<f64> {
        let (mut angle, mut turned) = (None, false);
        while let Some(Step { does: Does::Function(word, [_, value]), .. }) =
            self.list.pop_if(|step| is_of_spindle(&step.does))
        {
            match word.as_str() {
                "M3" | "M4" => turned = true,
                "M19" if !turned && angle.is_none() => angle = Some(value),
                "S" => drop(self.said.pop()),
                _ => {}
            }
        }
        angle
    }

    /// Waits that follow each other are one.
    fn dwell(&mut self, seconds: f64, origin: &Origin) {
        match self.list.last_mut() {
            Some(Step { does: Does::Function(word, numbers), .. }) if word == "dwell" => numbers[0] += seconds,
            _ => self.function("dwell", [seconds, 0.0], origin),
        }
    }
}

/// The step that says that nothing is said of corners.
const OPEN_CORNERS: &str = "corners as the machine is set up";
/// Steps that say how they are taken.
const CORNERS: [&str; 4] = ["G61", "G64 P", "G641 ADIS=", "G64"];

impl Step {
    /// Can the program not say how corners are taken?
    pub(super) fn leaves_corners_open(&self) -> bool {
        matches!(&self.does, Does::Function(word, _) if word == OPEN_CORNERS)
    }

    pub(super) fn is_path_control(&self) -> bool {
        matches!(&self.does, Does::Function(word, _) if CORNERS.contains(&word.as_str()))
    }

    /// The step in words of G-code; the line is named, where it is asked for.
    pub fn text(&self) -> String {
        format!("{} (line {})", self.does.text(), self.line)
    }
}

impl Does {
    fn text(&self) -> String {
        match self {
            Does::Travel(travel) => travel.text(),
            Does::Function(word, [first, second]) => match word.as_str() {
                "tool" => format!("T{first} M6"),
                "G64 P" | "G641 ADIS=" => format!("{word}{}", shown(*first)),
                "T" | "M" => format!("{word}{first}"),
                "end" => if *first > 0.0 { "M30" } else { "M2" }.to_owned(),
                "dwell" | "work offset" => format!("{word} {}", shown(*first)),
                "S" if *first == 0.0 => format!("S{}", shown(*second)),
                "cutting speed" | "speed limit" | "M19" | "S" => {
                    let spindle = if *first > 0.0 { format!(" of spindle {}", first + 1.0) } else { String::new() };
                    format!("{word} {}{spindle}", shown(*second))
                }
                _ if *first > 0.0 => format!("{word} of spindle {}", first + 1.0),
                _ => word.clone(),
            },
        }
    }
}

impl Travel {
    fn text(&self) -> String {
        let word = match self.kind {
            Kind::Rapid => "G0",
            Kind::Line => "G1",
            Kind::Thread(_) => "G33",
            Kind::Tap(_) => "tap",
            Kind::Arc { sweep, .. } if sweep > 0.0 => "G3",
            Kind::Arc { .. } => "G2",
        };
        let mut text = if self.machine { format!("G53 {word}") } else { word.to_owned() };
        for (axis, value) in self.end.iter() {
            text += &format!(" {}{}", axis.letter(), shown(value));
        }
        match self.kind {
            Kind::Arc { plane, center, sweep } => {
                let (first, second, _) = plane.axes();
                if let Some(from) = self.start.in_plane(plane) {
                    let mut off = [(first, center.x - from.x), (second, center.y - from.y)];
                    off.sort_by_key(|(axis, _)| *axis);
                    text += &off.map(|(axis, off)| format!(" {}{}", ["I", "J", "K"][axis], shown(off))).concat();
                }
                let turns = libm::ceil(sweep.abs() / TAU - 1e-6);
                if turns > 1.0 {
                    text += &format!(" P{turns}");
                }
            }
            Kind::Thread(lead) => text += &format!(" K{}", pitch(lead)),
            Kind::Tap(Stroke { axis, depth, lead, turn, speed, back, dwell, angle, any_angle: _ }) => {
                let hand = if turn == Turn::Clockwise { "right" } else { "left" };
                text += &format!(" to {}{}, {hand}-hand, pitch {}", axis.letter(), shown(depth), pitch(lead));
                if let Some(speed) = speed {
                    text += &format!(", S{}", shown(speed));
                }
                if let Some(back) = back.filter(|back| speed != Some(*back)) {
                    text += &format!(", back at S{}", shown(back));
                }
                if dwell > 0.0 {
                    text += &format!(", dwell {}", shown(dwell));
                }
                if let Some(angle) = angle {
                    text += &format!(", from {} degrees", shown(angle));
                }
            }
            Kind::Rapid | Kind::Line => {}
        }
        match self.feed {
            Some(Feed::PerMinute(feed)) => text += &format!(" F{}", shown(feed)),
            Some(Feed::PerRevolution(feed)) => text += &format!(" F{} a turn", shown(feed)),
            Some(Feed::InverseTime(feed)) => text += &format!(" F{} by time", shown(feed)),
            None => {}
        }
        text + match self.side {
            Side::None => "",
            Side::Left => " left of the contour",
            Side::Right => " right of the contour",
        }
    }
}

/// The speed of the first spindle, its start, its stop at an angle, and M29, which announces a tap.
fn is_of_spindle(does: &Does) -> bool {
    match does {
        Does::Travel(_) => false,
        Does::Function(word, [number, _]) => match word.as_str() {
            "S" | "M3" | "M4" | "M19" => *number == 0.0,
            "M" => *number == 29.0,
            _ => false,
        },
    }
}

/// A pitch as it is shown: many turns make much of its last places.
fn pitch(value: f64) -> f64 {
    libm::round(value * 1e6) / 1e6
}

/// A number as it is shown: four places, no `-0`.
pub fn shown(value: f64) -> f64 {
    libm::round(value * 1e4) / 1e4 + 0.0
}
