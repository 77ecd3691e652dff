//! Random motion streams that keep the promises of the language.

use core::f64::consts::{PI, TAU};

use crate::geo::{Plane, Point2, turned};
use crate::ir::function::{Coolant, CutterData, PathControl, Spindle, Turn};
use crate::ir::motion::{Arc, Move, Path, Place};
use crate::ir::tap::Stroke;
use crate::ir::{Feed, Function, Pos, Side, Tap};
use crate::machine::settings::{Quantity, ToolChange};
use crate::machine::{Axis, AxisSet, MachineKind, Settings};

/// A small generator of numbers that look random and are the same everywhere.
#[derive(Debug, Clone)]
pub struct Dice(pub u64);

impl Dice {
    pub fn roll(&mut self, sides: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 11) % sides.max(1) as u64) as usize
    }

    pub fn one_in(&mut self, sides: usize) -> bool {
        self.roll(sides) == 0
    }

    /// From 0 up to 1.
    pub fn part(&mut self) -> f64 {
        self.roll(1 << 50) as f64 / (1u64 << 50) as f64
    }

    pub fn of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.roll(list.len())]
    }
}

/// What a stream holds.
#[derive(Debug, Clone)]
pub enum Item {
    Move(Move),
    Function(Function),
    Tap(Tap, Place),
    BeginsAt(Pos),
}

/// A stream, and the settings it is printed with.
pub struct Stream {
    pub settings: Settings,
    pub items: Vec<Item>,
}

struct Maker<'a> {
    dice: &'a mut Dice,
    at: Pos,
    plane: Plane,
    feed: Feed,
    side: Side,
    /// One unit of the last place.
    unit: f64,
    linuxcnc: bool,
    grbl: bool,
    by_time: bool,
    items: Vec<Item>,
}

/// A stream of about `length` items.
pub fn stream(dice: &mut Dice, length: usize) -> Stream {
    let target = dice.of(&["linuxcnc", "linuxcnc", "grbl", "grblhal"]);
    stream_for(dice, length, target)
}

/// The same for a target.
pub fn stream_for(dice: &mut Dice, length: usize, target: &str) -> Stream {
    let mut settings = Settings::default();
    settings.output.target = crate::target::find(target).expect("a target");
    settings.output.decimals.length = Some(dice.of(&[3, 4, 4, 5, 6]));
    let linuxcnc = target == "linuxcnc";
    let frame = &settings.output.target.frame;
    if frame.mill.is_none() || frame.lathe.is_some() && dice.one_in(3) {
        settings.machine.kind = MachineKind::Lathe;
        let both = frame.lathe.is_some() && frame.lathe_diameter.is_some();
        settings.output.diameter = both.then(|| dice.one_in(2)).or(frame.lathe.map(|_| false));
    }
    settings.output.tool_length = Some(linuxcnc && dice.one_in(4));
    let listed = settings.output.target.m.listed;
    if listed {
        settings.output.pass_m = vec![0, 1, 3, 4, 5, 7, 8, 9];
        settings.output.rapid_feed = Some(3000);
    }
    if listed || dice.one_in(4) {
        settings.output.tool_change = ToolChange::Stop;
    }
    let plane = if settings.machine.kind == MachineKind::Lathe { Plane::Zx } else { Plane::Xy };
    let unit = 1.0 / f64::from(10u32.pow(u32::from(settings.output.places(Quantity::Length))));
    let feed = Feed::PerMinute(100.0);
    let grbl = target == "grbl";
    let by_time = settings.output.target.feed.inverse_time.is_some();
    let items = Vec::new();
    let mut maker =
        Maker { dice, at: Pos::UNKNOWN, plane, feed, side: Side::None, unit, linuxcnc, grbl, by_time, items };
    maker.begin();
    while maker.items.len() < length {
        maker.item();
    }
    maker.end();
    Stream { items: maker.items, settings }
}

/// Holes at random places, on a target that may be a lathe.
pub fn stream_of_taps(dice: &mut Dice, target: &str) -> Stream {
    let mut settings = Settings::default();
    settings.output.target = crate::target::find(target).expect("a target");
    let lathe = settings.output.target.frame.mill.is_none();
    if lathe {
        settings.machine.kind = MachineKind::Lathe;
    }
    settings.output.tool_length = Some(false);
    let plane = if lathe { Plane::Zx } else { Plane::Xy };
    let unit = 1.0 / f64::from(10u32.pow(u32::from(settings.output.places(Quantity::Length))));
    let feed = Feed::PerMinute(100.0);
    let (at, side, items) = (Pos::UNKNOWN, Side::None, Vec::new());
    let (linuxcnc, grbl, by_time) = (false, false, false);
    let mut maker = Maker { dice, at, plane, feed, side, unit, linuxcnc, grbl, by_time, items };
    for _ in 0..3 {
        let mut end = Pos::UNKNOWN;
        let axes: &[Axis] = if lathe { &[Axis::X, Axis::Z] } else { &[Axis::X, Axis::Y, Axis::Z] };
        for axis in axes {
            let value = maker.number();
            end.set(*axis, value);
        }
        maker.push(end, end.known(), Path::Rapid);
        maker.tap();
    }
    maker.end();
    Stream { items: maker.items, settings }
}

impl Maker<'_> {
    fn begin(&mut self) {
        if self.dice.one_in(5) {
            let mut at = Pos::UNKNOWN;
            for axis in [Axis::X, Axis::Y, Axis::Z] {
                at.set(axis, self.number());
            }
            self.at.update(&at);
            self.items.push(Item::BeginsAt(at));
        }
        self.everywhere(Path::Rapid);
    }

    fn end(&mut self) {
        self.leave();
        if !self.dice.one_in(4) {
            let rewind = self.dice.one_in(2);
            self.items.push(Item::Function(Function::End { rewind }));
        }
    }

    fn does(&mut self, function: Function) {
        self.items.push(Item::Function(function));
    }

    /// A coordinate as programs have them: round, on the grid of the output, on its ties, or any.
    fn number(&mut self) -> f64 {
        let size = self.dice.of(&[0.01, 1.0, 50.0, 50.0, 400.0, 3000.0]);
        let any = (self.dice.part() * 2.0 - 1.0) * size;
        match self.dice.roll(8) {
            0 => 0.0,
            1 => (any * 10.0).round() / 10.0,
            2 => (any / self.unit).round() * self.unit,
            3 => ((any / self.unit).round() + 0.5) * self.unit,
            _ => any,
        }
    }

    fn some_feed(&mut self) -> Feed {
        if self.dice.roll(4) > 0 {
            return self.feed;
        }
        let value = match self.dice.roll(3) {
            0 => self.dice.of(&[100.0, 250.0, 0.5, 1200.0]),
            1 => self.unit * (1 + self.dice.roll(50)) as f64,
            _ => 0.01 + self.dice.part() * 500.0,
        };
        let kinds = if self.linuxcnc {
            5
        } else if self.by_time {
            4
        } else {
            3
        };
        self.feed = match self.dice.roll(kinds) {
            3 => Feed::InverseTime(value),
            4 => Feed::PerRevolution(value),
            _ => Feed::PerMinute(value),
        };
        self.feed
    }

    fn push(&mut self, mut end: Pos, axes: AxisSet, path: Path) {
        let mut full = self.at;
        full.update(&end);
        end = full;
        self.at = end;
        let (side, plane) = (self.side, self.plane);
        self.items.push(Item::Move(Move { end, axes, path, side, plane, machine: false }));
    }

    /// A move in all main axes.
    fn everywhere(&mut self, path: Path) {
        let mut end = Pos::UNKNOWN;
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            end.set(axis, self.number());
        }
        self.push(end, end.known(), path);
    }

    fn straight(&mut self) {
        let mut end = Pos::UNKNOWN;
        let choice: &[Axis] = if self.linuxcnc {
            &[Axis::X, Axis::Y, Axis::Z, Axis::C, Axis::A, Axis::U]
        } else {
            &[Axis::X, Axis::Y, Axis::Z]
        };
        for _ in 0..=self.dice.roll(3) {
            let axis = self.dice.of(choice);
            let axis = if self.side != Side::None && !axis.is_main() { Axis::X } else { axis };
            let value = if self.dice.one_in(6) { self.at.get(axis) } else { None };
            let near = self.at.get(axis).map(|at| at + self.unit * (self.dice.part() - 0.5) * 3.0);
            let value = value.or(near.filter(|_| self.dice.one_in(6)));
            let value = value.unwrap_or_else(|| self.number());
            end.set(axis, value);
        }
        let path = if self.dice.one_in(3) { Path::Rapid } else { Path::Line(self.some_feed()) };
        self.push(end, end.known(), path);
    }

    fn arc(&mut self) {
        let plane = if self.dice.roll(3) > 0 || self.side != Side::None {
            self.plane
        } else {
            self.dice.of(&[Plane::Xy, Plane::Zx, Plane::Yz])
        };
        let Some(from) = self.at.in_plane(plane) else { return self.everywhere(Path::Rapid) };
        // Mostly of a size that stays an arc, sometimes one that has to become lines, or nothing.
        let radius = match self.dice.roll(12) {
            0 => self.unit * (0.2 + self.dice.part() * 30.0),
            1 => 1000.0 + self.dice.part() * 9000.0,
            2 => f64::from(1 + self.dice.roll(40) as u32),
            _ => 0.05 + self.dice.part() * 60.0,
        };
        let angle = self.dice.part() * TAU;
        let center = Point2::new(from.x + radius * libm::cos(angle), from.y + radius * libm::sin(angle));
        let size = match self.dice.roll(10) {
            0 => TAU,
            1 => TAU * (1 + self.dice.roll(4)) as f64,
            2 => PI,
            3 => TAU * (1.0 + self.dice.part() * 3.0),
            4 => self.dice.part() * 0.01,
            5 => TAU - self.dice.part() * 0.001,
            _ => 0.01 + self.dice.part() * (TAU - 0.02),
        };
        let size = if radius < self.unit * 40.0 { size.min(TAU) } else { size }.max(1e-9);
        // A flat arc that becomes lines becomes many of them.
        let size = if radius > 1000.0 { size.min(0.02) } else { size };
        let sweep = if self.dice.one_in(2) { size } else { -size };
        let turns = size / TAU;
        let to = if turns.fract() == 0.0 { from } else { center + turned(from - center, sweep) };
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(plane, to);
        if self.dice.one_in(3) {
            let (_, _, third) = plane.axes();
            let third = Axis::ALL[third];
            if let Some(at) = self.at.get(third) {
                end.set(third, at + self.dice.of(&[-5.0, 0.3, 12.5, -0.001]) * self.dice.part());
            }
        }
        let feed = self.some_feed();
        let arc = Arc { plane, from, center, sweep };
        self.push(end, end.known(), Path::Arc(arc, feed));
    }

    fn machine(&mut self) {
        let mut end = Pos::UNKNOWN;
        for _ in 0..=self.dice.roll(2) {
            let axis = self.dice.of(&[Axis::X, Axis::Y, Axis::Z]);
            let value = self.number();
            end.set(axis, value);
        }
        let (axes, plane) = (end.known(), self.plane);
        let mv = Move { end, axes, path: Path::Rapid, side: Side::None, plane, machine: true };
        self.items.push(Item::Move(mv));
        self.at = Pos::UNKNOWN;
        self.everywhere(Path::Rapid);
    }

    fn carried(&mut self) {
        let mut end = Pos::UNKNOWN;
        end.set(Axis::C, self.at.get(Axis::C).unwrap_or(0.0) + (self.dice.part() - 0.5) * 90.0);
        if self.at.get(Axis::C).is_none() {
            return self.push(end, end.known(), Path::Rapid);
        }
        if self.dice.roll(4) > 0 {
            let x = self.at.get(Axis::X).unwrap_or(0.0);
            let by = self.dice.of(&[0.0003, 0.002, 5.0, 30.0]);
            end.set(Axis::X, x + by * (self.dice.part() - 0.5));
        }
        let (feed, length) = (1.0 + self.dice.part() * 800.0, 0.5 + self.dice.part() * 20.0);
        self.push(end, end.known(), Path::Carried { feed, length });
    }

    /// A hole of up to four strokes from where the tool stands, and what the spindle does behind it.
    fn tap(&mut self) {
        let Some(start) = self.at.get(Axis::Z) else { return self.everywhere(Path::Rapid) };
        let lead = self.dice.of(&[1.5, 0.75, 1.27, 2.0, 1.0 / 3.0]);
        let speed = self.dice.of(&[100.0, 300.0, 1500.0]);
        let back = self.dice.of(&[speed, speed, 2.0 * speed, 1.5 * speed]);
        let surface = start - self.dice.of(&[0.0, 2.0]);
        let odd = 0.7 + self.dice.part();
        let step = self.dice.of(&[2.0, 3.5, odd]);
        let chip = self.dice.of(&[None, Some(0.3), Some(0.2 * lead)]);
        let count = 1 + self.dice.roll(4);
        let dwell = self.dice.of(&[0.0, 0.0, 0.5]);
        let stroke = |at: usize| {
            let to = surface - step * (at + 1) as f64;
            let back = chip.filter(|_| at + 1 < count).map_or(start, |back| (to + back).min(start));
            Stroke { to, back, dwell }
        };
        let tap = Tap {
            axis: Axis::Z,
            start,
            surface,
            strokes: (0..count).map(stroke).collect(),
            lead,
            turn: self.dice.of(&[Turn::Clockwise, Turn::Clockwise, Turn::CounterClockwise]),
            speed_in: Some(speed),
            speed_out: Some(back),
            orient: self.dice.of(&[None, None, Some(30.0)]),
            pause: self.dice.of(&[0.0, 0.0, 0.25]),
            again: self.dice.of(&[None, Some(1.0)]),
        };
        self.items.push(Item::Tap(tap, Place { at: self.at, plane: self.plane }));
        self.does(Function::Spindle(Spindle::Stop));
    }

    fn speed(&mut self) -> f64 {
        self.dice.of(&[100.0, 1500.0, 2000.5, 18_000.0])
    }

    fn spindle(&mut self) -> Spindle {
        let speed = self.speed();
        match self.dice.roll(if self.linuxcnc { 7 } else { 4 }) {
            0 => Spindle::Start(Turn::Clockwise),
            1 => Spindle::Start(Turn::CounterClockwise),
            2 => Spindle::Stop,
            3 => Spindle::Speed(speed),
            4 => Spindle::CuttingSpeed { speed: 180.0, limit: self.dice.one_in(2).then_some(speed) },
            5 => Spindle::Orient(self.dice.of(&[0.0, 90.0, 37.25])),
            _ => Spindle::Speed(speed / 3.0),
        }
    }

    /// A contour with compensation by the control: straight in, a few elements, straight out.
    fn compensated(&mut self) {
        let radius = self.dice.one_in(2).then_some(0.5);
        let number = 1 + self.dice.roll(9) as u32;
        self.does(Function::Cutter(CutterData { number, radius, ..CutterData::default() }));
        self.does(Function::Plane(self.plane));
        self.side = self.dice.of(&[Side::Left, Side::Right]);
        for _ in 0..3 {
            let feed = self.some_feed();
            self.everywhere(Path::Line(feed));
        }
        if self.dice.one_in(2) {
            self.arc();
        }
        self.leave();
    }

    fn leave(&mut self) {
        if self.side != Side::None {
            self.side = Side::None;
            let feed = self.some_feed();
            self.everywhere(Path::Line(feed));
        }
    }

    fn item(&mut self) {
        match self.dice.roll(42) {
            0..16 => self.straight(),
            16..26 => self.arc(),
            26 => self.machine(),
            27 if self.linuxcnc => self.carried(),
            28 if self.linuxcnc => {
                let lead = self.dice.of(&[1.5, 0.75, 2.0, 1.0 / 3.0]);
                self.everywhere(Path::Thread { lead });
            }
            29 => {
                let number = self.dice.roll(200) as u32;
                if !self.grbl {
                    self.does(Function::ToolChange { number });
                    self.does(Function::Spindle(Spindle::Start(Turn::Clockwise)));
                }
            }
            30 => {
                let number = self.dice.roll(200) as u32;
                self.does(Function::ToolPrepare { number });
            }
            31 | 32 => {
                let spindle = self.spindle();
                self.does(Function::Spindle(spindle));
            }
            33 if self.linuxcnc => {
                let number = 1 + self.dice.roll(3) as u8;
                let spindle = self.spindle();
                self.does(Function::SpindleOf { number, spindle });
            }
            34 => {
                let coolant = self.dice.of(&[Coolant::Flood, Coolant::Off, Coolant::Mist]);
                let coolant = if self.grbl && coolant == Coolant::Mist { Coolant::Flood } else { coolant };
                self.does(Function::Coolant(coolant));
            }
            35 => {
                let seconds = self.dice.of(&[0.5, 1.0, 0.125, 7200.0, 1.0 / 3.0]);
                self.does(Function::Dwell(seconds));
            }
            36 => {
                let function = self.dice.of(&[0, 1]);
                self.does(if function == 0 { Function::Stop } else { Function::OptionalStop });
            }
            37 => {
                let number = 1 + self.dice.roll(6) as u8;
                self.does(Function::WorkOffset(number));
                self.at = Pos::UNKNOWN;
                self.everywhere(Path::Rapid);
            }
            38 => {
                self.plane = self.dice.of(&[Plane::Xy, Plane::Zx, Plane::Yz]);
                self.does(Function::Plane(self.plane));
            }
            39 if self.linuxcnc && self.plane != Plane::Yz => self.compensated(),
            39 if !self.grbl => self.does(Function::Aux(77)),
            40 | 41 => {
                let mm = self.dice.of(&[0.02, 0.05, 1.0 / 3.0]);
                let mode = self.dice.of(&[
                    PathControl::Exact,
                    PathControl::Unbounded,
                    PathControl::Within(mm),
                    PathControl::Before(mm),
                ]);
                let said = !self.dice.one_in(5);
                self.does(Function::PathControl(said.then_some(mode)));
            }
            _ => self.does(Function::Comment(b"a comment (with brackets) G1 X99 and ; more".to_vec())),
        }
    }
}
