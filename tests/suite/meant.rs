//! What a program does, in order: as the compiler meant it, as a reader of the output finds it, and both compared.

use core::f64::consts::TAU;
use partc::internals::machine::settings::Quantity;

use partc::internals::ir::function::{Coolant, CutterData, Spindle, Turn};
use partc::internals::ir::motion::{self, Path, Sink};
use partc::internals::ir::{Feed, Function, Origin, Side, Tap};
use partc::internals::machine::axis::AXES;
use partc::internals::machine::{MachineKind, OutputSettings, PathControl, Settings};

/// Where the machine stands before a program: nowhere that a program names, so that an axis word that is missing shows.
pub const BEFORE: [f64; AXES] = [-7771.0, -7772.0, -7773.0, -774.0, -775.0, -776.0, -7777.0, -7778.0, -7779.0];

/// Something the machine does besides moving.
#[derive(Debug, Clone, PartialEq)]
pub enum Does {
    /// The changer brings this tool forth.
    Select(u32),
    /// The tool brought forth goes into the spindle; the spindle stands.
    Change,
    /// Tool whose length counts; 0 for none.
    Length(u32),
    /// Spindle from 0 on; clockwise 1, counter-clockwise -1, standing 0.
    Turns(u8, i8),
    Speed(u8, f64),
    /// Constant cutting speed up to a speed, or the speed itself again.
    CuttingSpeed(bool, f64),
    Orient(u8, f64),
    /// In step with the spindle along an axis to a depth and back to the start: lead, sense, speed.
    Tap {
        axis: usize,
        to: f64,
        lead: f64,
        turn: i8,
        speed: f64,
    },
    Mist,
    Flood,
    CoolantOff,
    Dwell(f64),
    Stop,
    OptionalStop,
    Aux(u32),
    WorkOffset(u8),
    End {
        rewind: bool,
    },
}

impl Does {
    /// Its number, where it is one that is rounded.
    fn number(&self) -> f64 {
        match self {
            Does::Speed(_, n) | Does::CuttingSpeed(_, n) | Does::Orient(_, n) | Does::Dwell(n) => *n,
            _ => 0.0,
        }
    }

    fn same(&self, other: &Does, tolerance: f64) -> bool {
        let (a, b) = (self.number(), other.number());
        let near = a == b || (a - b).abs() <= tolerance;
        let exact = match (self, other) {
            (Does::Speed(a, _), Does::Speed(b, _)) | (Does::Orient(a, _), Does::Orient(b, _)) => a == b,
            (Does::CuttingSpeed(a, _), Does::CuttingSpeed(b, _)) => a == b,
            (Does::Dwell(_), Does::Dwell(_)) => true,
            (
                Does::Tap { axis, to, lead, turn, speed },
                Does::Tap { axis: b_axis, to: b_to, lead: b_lead, turn: b_turn, speed: b_speed },
            ) => {
                let near = |a: f64, b: f64| (a - b).abs() <= tolerance;
                axis == b_axis && turn == b_turn && near(*to, *b_to) && near(*lead, *b_lead) && near(*speed, *b_speed)
            }
            _ => self == other,
        };
        near && exact
    }
}

/// Radius compensation by the target: side (left 1, right -1), and the tool number or the diameter.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cutter {
    pub side: i8,
    pub number: u32,
    pub diameter: Option<f64>,
}

/// What a feed counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    PerMinute,
    PerRevolution,
    /// The way itself, so many times in a minute.
    Inverse,
}

/// What holds during a move.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct How {
    /// Its kind and the value; `None` for rapid traverse and threads.
    pub feed: Option<(Kind, f64)>,
    /// Way per turn of the spindle in a thread.
    pub lead: Option<f64>,
    pub cutter: Cutter,
    /// To a place in machine coordinates.
    pub machine: bool,
    /// Working plane, where compensation refers to it.
    pub plane: Option<[usize; 3]>,
    /// How far corners may be rounded off in mm: 0 for an exact path, infinite without a bound.
    pub corners: Option<f64>,
}

/// How far corners may be rounded off.
fn corners(mode: PathControl) -> f64 {
    match mode {
        PathControl::Exact => 0.0,
        PathControl::Within(mm) => mm,
        PathControl::Before(_) | PathControl::Unbounded => f64::INFINITY,
    }
}

/// The path of a move that was found.
#[derive(Debug, Clone, PartialEq)]
pub enum Way {
    Rapid([f64; AXES]),
    Feed([f64; AXES]),
    /// First, second and third axis; end in these two, centre, signed turns, and the end in all axes.
    Arc {
        plane: [usize; 3],
        center: [f64; 2],
        turns: i32,
        end: [f64; AXES],
    },
}

impl Way {
    pub fn end(&self) -> [f64; AXES] {
        match self {
            Way::Rapid(end) | Way::Feed(end) | Way::Arc { end, .. } => *end,
        }
    }
}

/// What a reader of the output found.
#[derive(Debug, Clone, PartialEq)]
pub enum Found {
    Move(Way, How),
    Does(Does),
}

/// A move as the compiler meant it.
#[derive(Debug, Clone)]
pub struct Move {
    pub rapid: bool,
    /// `None` for axes whose position nobody knows.
    pub end: [Option<f64>; AXES],
    /// Plane, centre and sweep.
    pub arc: Option<([usize; 3], [f64; 2], f64)>,
    pub how: How,
}

/// What the compiler meant.
#[derive(Debug, Clone)]
pub enum Meant {
    Move(Box<Move>),
    Does(Does),
}

/// Keeps what the compiler meant.
pub struct Recorder {
    pub items: Vec<Meant>,
    at: [Option<f64>; AXES],
    cutter: CutterData,
    constant_cut: bool,
    offset: u8,
    length: u32,
    tool_length: bool,
    /// Units in a millimetre.
    scale: f64,
    /// The same of X, which may be a diameter.
    scale_of_x: f64,
    ended: bool,
    speed: f64,
    /// A tap said that speed, and nothing was said of the spindle since.
    tapped: bool,
    corners: Option<f64>,
    output: OutputSettings,
    lathe: bool,
}

impl Recorder {
    pub fn new(settings: &Settings) -> Recorder {
        let scale = 10f64.powi(i32::from(settings.output.places(Quantity::Length)));
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let diameters = lathe && settings.output.prints_diameters();
        Recorder {
            items: Vec::new(),
            at: [None; AXES],
            cutter: CutterData::default(),
            constant_cut: false,
            offset: 1,
            length: 0,
            tool_length: settings.output.prints_tool_length(),
            scale,
            scale_of_x: if diameters { 2.0 * scale } else { scale },
            ended: false,
            speed: 0.0,
            tapped: false,
            corners: settings.output.path_control(None, lathe).map(corners),
            output: settings.output.clone(),
            lathe,
        }
    }

    /// Everything; a program without an end gets one.
    pub fn finish(mut self) -> Vec<Meant> {
        if !self.ended {
            self.does(Does::End { rewind: false });
        }
        self.items
    }

    fn does(&mut self, does: Does) {
        self.items.push(Meant::Does(does));
    }

    fn how(&self, mv: &motion::Move) -> How {
        let side = match mv.side {
            Side::None => 0,
            Side::Left => 1,
            Side::Right => -1,
        };
        let cutter = match (side, self.cutter.radius) {
            (0, _) => Cutter::default(),
            (_, None) => Cutter { side, number: self.cutter.number, diameter: None },
            (_, Some(radius)) => Cutter { side, number: 0, diameter: Some(2.0 * radius) },
        };
        let (a, b, c) = mv.plane.axes();
        let plane = (side != 0).then_some([a, b, c]);
        let (machine, corners) = (mv.machine, self.corners);
        if let Path::Thread { lead } = mv.path {
            return How { feed: None, lead: Some(lead), cutter, machine, plane, corners };
        }
        let feed = mv.path.feed();
        let feed = feed.map(|feed| (kind_of(feed), feed.value()));
        How { feed, lead: None, cutter, machine, plane, corners }
    }

    fn spindle(&mut self, spindle: Spindle, number: Option<u8>) {
        let own = number.unwrap_or(1).saturating_sub(1);
        if number.is_none() && std::mem::take(&mut self.tapped) && spindle == Spindle::Speed(self.speed) {
            return;
        }
        match spindle {
            Spindle::Start(Turn::Clockwise) => self.does(Does::Turns(own, 1)),
            Spindle::Start(Turn::CounterClockwise) => self.does(Does::Turns(own, -1)),
            Spindle::Stop => self.does(Does::Turns(own, 0)),
            Spindle::Speed(speed) => {
                if number.is_none() && std::mem::take(&mut self.constant_cut) {
                    self.does(Does::CuttingSpeed(false, 0.0));
                }
                if number.is_none() {
                    self.speed = speed;
                }
                self.does(Does::Speed(own, speed));
            }
            Spindle::CuttingSpeed { speed, limit } => {
                self.constant_cut = true;
                self.does(Does::CuttingSpeed(true, limit.unwrap_or(f64::INFINITY)));
                self.does(Does::Speed(own, speed));
            }
            Spindle::Orient(angle) => self.does(Does::Orient(own, angle)),
        }
    }

    /// How far axes go, as printed.
    fn way(&self, before: &[Option<f64>; AXES], axes: std::ops::Range<usize>) -> f64 {
        let printed = |axis: usize, v: Option<f64>| {
            let scale = if axis == 0 { self.scale_of_x } else { self.scale };
            (v.expect("a known start") * scale).round() / scale
        };
        let moved = axes.filter(|i| self.at[*i] != before[*i]);
        moved.map(|i| printed(i, self.at[i]) - printed(i, before[i])).map(|d| d * d).sum::<f64>().sqrt()
    }

    fn length(&mut self, number: u32) {
        if self.tool_length && std::mem::replace(&mut self.length, number) != number {
            self.does(Does::Length(number));
        }
    }
}

/// Is this said of the first spindle, which a tap starts by itself?
pub fn is_of_spindle(does: &Does) -> bool {
    matches!(does, Does::Speed(0, _) | Does::Turns(0, 1 | -1) | Does::Orient(0, _))
}

impl Sink for Recorder {
    /// As LinuxCNC taps: each stroke comes back to the start, and nothing waits at the depth.
    fn tap(&mut self, tap: &Tap, _: &motion::Place, _: &Origin) {
        while self.items.last().is_some_and(|item| matches!(item, Meant::Does(does) if is_of_spindle(does))) {
            self.items.pop();
        }
        if let Some(speed) = tap.speed_in {
            self.speed = speed;
        }
        self.tapped = true;
        let (axis, turn) = (tap.axis.index(), if tap.turn == Turn::Clockwise { 1 } else { -1 });
        for (at, stroke) in tap.strokes.iter().enumerate() {
            if at > 0 && tap.pause > 0.0 {
                self.does(Does::Dwell(tap.pause));
            }
            self.does(Does::Tap { axis, to: stroke.to, lead: tap.lead, turn, speed: self.speed });
        }
    }

    fn movement(&mut self, mv: &motion::Move, _: &Origin) {
        let before = self.at;
        for axis in mv.axes.iter() {
            self.at[axis.index()] = mv.end.get(axis);
        }
        let arc = match &mv.path {
            Path::Arc(arc, _) => {
                let (a, b, c) = arc.plane.axes();
                Some(([a, b, c], [arc.center.x, arc.center.y], arc.sweep))
            }
            _ => None,
        };
        let finer = |axis: usize| if axis == 0 { self.scale_of_x / self.scale } else { 1.0 };
        let printed = |axis: usize, v: Option<f64>| v.map(|v| (v * 1e4 * finer(axis)).round());
        let same = (0..AXES).all(|i| printed(i, before[i]) == printed(i, self.at[i]));
        if arc.is_some() || !same || mv.machine && mv.axes.iter().next().is_some() {
            let (rapid, mut how) = (mv.path == Path::Rapid, self.how(mv));
            if let Path::Carried { feed, length } = mv.path {
                let (linear, rotary) = (self.way(&before, 0..3), self.way(&before, 3..6));
                how.feed = Some((
                    Kind::PerMinute,
                    match (linear, rotary) {
                        (_, 0.0) => feed,
                        (0.0, _) => feed * rotary / length,
                        _ => feed * linear / length,
                    },
                ));
                // Where F is too coarse, the rotary axes go first.
                let small = (1.0 / self.scale).max(0.0005);
                if linear > 0.0 && rotary > 0.0 && linear <= small && feed * linear / length * self.scale < 99.5 {
                    let turned = How { feed: Some((Kind::PerMinute, feed * rotary / length)), ..how };
                    let mut end = before;
                    end[3..6].copy_from_slice(&self.at[3..6]);
                    self.items.push(Meant::Move(Box::new(Move { rapid, end, arc, how: turned })));
                    how.feed = Some((Kind::PerMinute, feed));
                }
            }
            self.items.push(Meant::Move(Box::new(Move { rapid, end: self.at, arc, how })));
        }
        if mv.machine {
            for axis in mv.axes.iter() {
                self.at[axis.index()] = None;
            }
        }
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        if matches!(function, Function::ToolChange { .. } | Function::WorkOffset(_) | Function::Tilt(_)) {
            self.at = [None; AXES];
        }
        match function {
            Function::ToolChange { number } => {
                self.does(Does::Select(*number));
                self.does(Does::Change);
                self.length(*number);
            }
            Function::ToolPrepare { number } => self.does(Does::Select(*number)),
            Function::Cutter(cutter) => self.cutter = *cutter,
            Function::Spindle(spindle) => self.spindle(*spindle, None),
            Function::SpindleOf { number, spindle } => self.spindle(*spindle, Some(*number)),
            Function::Coolant(Coolant::Mist) => self.does(Does::Mist),
            Function::Coolant(Coolant::Flood) => self.does(Does::Flood),
            Function::Coolant(Coolant::Off) => self.does(Does::CoolantOff),
            Function::Dwell(seconds) => self.does(Does::Dwell(*seconds)),
            Function::Stop => self.does(Does::Stop),
            Function::OptionalStop => self.does(Does::OptionalStop),
            Function::Aux(number) => self.does(as_known(*number)),
            Function::WorkOffset(number) => {
                if std::mem::replace(&mut self.offset, *number) != *number {
                    self.does(Does::WorkOffset(*number));
                }
            }
            Function::End { rewind } => {
                self.does(Does::End { rewind: *rewind });
                self.ended = true;
            }
            Function::FeedSpindle(_) | Function::Transformation(_) => panic!("{function:?} reached the target"),
            Function::PathControl(said) => {
                self.corners = self.output.path_control(*said, self.lathe).map(corners).or(self.corners);
            }
            Function::Tilt(_) | Function::Plane(_) | Function::Comment(_) | Function::Remark(_) => {}
        }
    }

    fn lost(&mut self, _: &Origin) {}
}

fn kind_of(feed: Feed) -> Kind {
    match feed {
        Feed::PerMinute(_) => Kind::PerMinute,
        Feed::PerRevolution(_) => Kind::PerRevolution,
        Feed::InverseTime(_) => Kind::Inverse,
    }
}

/// An M function that is printed as it stands is one of the target's own, if it has one of this number.
fn as_known(number: u32) -> Does {
    match number {
        0 => Does::Stop,
        1 => Does::OptionalStop,
        3 => Does::Turns(0, 1),
        4 => Does::Turns(0, -1),
        5 => Does::Turns(0, 0),
        7 => Does::Mist,
        8 => Does::Flood,
        9 => Does::CoolantOff,
        _ => Does::Aux(number),
    }
}

/// Half a unit of the last place, and a little for what a reader loses by itself.
pub fn tolerance(decimals: u8) -> f64 {
    0.5 * 0.1f64.powi(i32::from(decimals)) + 0.6e-4
}

/// Compares what a reader found with what was meant, item by item.
pub fn compare(found: &[Found], meant: &[Meant], tolerance: f64) -> Result<(), String> {
    let mut at = BEFORE;
    for (i, (found, meant)) in found.iter().zip(meant).enumerate() {
        let fail = |why: &str| Err(format!("item {i}: {why}: {found:?}, meant {meant:?}"));
        match (found, meant) {
            (Found::Does(found), Meant::Does(meant)) if found.same(meant, tolerance) => {}
            (Found::Move(way, how), Meant::Move(meant)) => {
                let start = std::mem::replace(&mut at, way.end());
                let result = same_way(start, way, meant, tolerance).and_then(|()| same_how(how, &meant.how, tolerance));
                if let Err(why) = result {
                    return fail(why);
                }
            }
            _ => return fail("another thing"),
        }
    }
    if found.len() != meant.len() {
        let next = |i: usize| format!("{:?} {:?}", found.get(i), meant.get(i));
        let (found, meant) = (found.len(), meant.len());
        return Err(format!("{found} items instead of {meant}: {}", next(found.min(meant))));
    }
    Ok(())
}

fn same_way(start: [f64; AXES], way: &Way, meant: &Move, tolerance: f64) -> Result<(), &'static str> {
    let end = way.end();
    if meant.end.iter().zip(end).any(|(meant, end)| meant.is_some_and(|meant| (meant - end).abs() > tolerance)) {
        return Err("ends elsewhere");
    }
    match (way, &meant.arc) {
        (Way::Rapid(_), None) if meant.rapid => Ok(()),
        (Way::Feed(_), None) if !meant.rapid => Ok(()),
        (Way::Arc { plane, center, turns, end }, Some((meant_plane, meant_center, sweep))) => {
            let off = (center[0] - meant_center[0]).hypot(center[1] - meant_center[1]);
            let angle = |p: &[f64; AXES]| (p[plane[1]] - center[1]).atan2(p[plane[0]] - center[0]);
            let radius = (end[plane[0]] - center[0]).hypot(end[plane[1]] - center[1]);
            let sign = f64::from(turns.signum());
            let mut part = ((angle(end) - angle(&start)) * sign).rem_euclid(TAU);
            if part < 1e-9 {
                part = TAU;
            }
            let total = sign * (part + TAU * f64::from(turns.abs() - 1));
            let same = plane == meant_plane && off <= 3.0 * tolerance && (total - sweep).abs() <= 1e-3 + 3e-4 / radius;
            if same { Ok(()) } else { Err("another arc") }
        }
        _ => Err("another kind of move"),
    }
}

fn same_how(found: &How, meant: &How, tolerance: f64) -> Result<(), &'static str> {
    let near = |a: Option<f64>, b: Option<f64>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= tolerance,
        (a, b) => a.is_none() && b.is_none(),
    };
    // A bound is printed with six places.
    let same_bound = match (found.corners, meant.corners) {
        (Some(a), Some(b)) => a == b || (a - b).abs() < 2e-6,
        (a, b) => a == b,
    };
    if !same_bound {
        return Err("other corners");
    }
    let value = |how: &How| how.feed.map(|(_, value)| value);
    let mode = |how: &How| how.feed.map(|(kind, _)| kind);
    if mode(found) != mode(meant) || !near(value(found), value(meant)) {
        return Err("another feed");
    }
    if !near(found.lead, meant.lead) {
        return Err("another lead");
    }
    if found.machine != meant.machine {
        return Err("machine or workpiece coordinates");
    }
    let (a, b) = (found.cutter, meant.cutter);
    if (a.side, a.number) != (b.side, b.number) || !near(a.diameter, b.diameter) {
        return Err("another radius compensation");
    }
    if b.side != 0 && found.plane != meant.plane { Err("compensated in another plane") } else { Ok(()) }
}

/// Without the moves: where an arc had to be replaced, the rest is still what was meant.
pub fn without_moves(found: &[Found], meant: &[Meant]) -> (Vec<Found>, Vec<Meant>) {
    let found = found.iter().filter(|item| matches!(item, Found::Does(_))).cloned().collect();
    (found, meant.iter().filter(|item| matches!(item, Meant::Does(_))).cloned().collect())
}
