//! The walk of rules over what a program does: they look on while it runs, and change nothing.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use crate::diag::{Diagnostic, Diags, Fault, codes};
use crate::geo::Plane;
use crate::ir::captured::{Captured, Unfit};
use crate::ir::contour::{self, Corner, CtxRef, Load};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::drilling;
use crate::ir::cycle::drilling::Method;
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::motion::{self, Move, Path};
use crate::ir::tap::Part;
use crate::ir::{Feed, Function, Origin, Pos, Side, Tap, Tilt};
use crate::machine::{Axis, MachineKind, Settings};
use crate::text::Sources;

/// A cuboid in workpiece coordinates, mm: least and greatest corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blank {
    pub min: [f64; 3],
    pub max: [f64; 3],
}

impl Blank {
    /// Where the program describes none: that of `[lint] blank`.
    pub fn given(ranges: &BTreeMap<Axis, (f64, f64)>) -> Option<Blank> {
        let [x, y, z] = [Axis::X, Axis::Y, Axis::Z].map(|axis| ranges.get(&axis));
        let [x, y, z] = [x?, y?, z?];
        Some(Blank { min: [x.0, y.0, z.0], max: [x.1, y.1, z.1] })
    }
}

/// A bar or tube about Z, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    pub radius: f64,
    pub bore: f64,
    pub left: f64,
    pub right: f64,
}

impl Bar {
    /// The same on a lathe; X are the diameters of the bore and of the bar.
    pub fn given(ranges: &BTreeMap<Axis, (f64, f64)>) -> Option<Bar> {
        let (x, z) = (ranges.get(&Axis::X)?, ranges.get(&Axis::Z)?);
        Some(Bar { radius: x.1 / 2.0, bore: x.0 / 2.0, left: z.0, right: z.1 }).filter(Bar::is_one)
    }

    /// Is there any material?
    pub fn is_one(&self) -> bool {
        self.bore >= 0.0 && self.bore < self.radius && self.left < self.right
    }
}

/// What a rule is made with.
#[derive(Debug, Clone, Copy)]
pub struct Setup<'a> {
    pub settings: &'a Settings,
    /// The blank that the program describes, where it does, or that of the configuration.
    pub blank: Option<Blank>,
    /// The same of a turned part.
    pub bar: Option<Bar>,
    /// Bytes of the main program.
    pub size: u64,
    pub sources: &'a Sources,
}

impl Setup<'_> {
    pub fn is_lathe(&self) -> bool {
        self.settings.machine.kind == MachineKind::Lathe
    }
}

/// Does a spindle turn?
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Turning {
    #[default]
    Unknown,
    Off,
    On(Turn),
}

/// What the last move did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Last {
    #[default]
    None,
    Rapid,
    Cut,
}

/// The machine before the item that a rule looks at.
#[derive(Debug, Clone, Default)]
pub struct Machine {
    pub at: Pos,
    /// The tool in the spindle; `None` before the first change.
    pub tool: Option<u32>,
    pub turning: Turning,
    /// Is any speed known?
    pub has_speed: bool,
    pub coolant: bool,
    pub last: Last,
    /// Side of the compensation as programmed.
    pub side: Side,
    pub plane: Plane,
    /// The tilted plane in which positions count.
    pub tilt: Option<Box<Tilt>>,
}

/// A move with where it comes from. In a tilted plane it counts in that: up, down and sideways are as the tool sees them, and a
/// number is the one of the program. What asks for the part takes [`Step::place`].
#[derive(Debug)]
pub struct Step<'s> {
    pub mv: &'s Move,
    pub from: &'s Pos,
    /// All axes behind the move.
    pub to: Pos,
    pub origin: &'s Origin,
    /// A cycle makes it, no block of its own.
    pub of_cycle: bool,
    /// The cycle taps with a compensating chuck.
    pub of_tap: bool,
    sideways: bool,
    tilt: Option<&'s Tilt>,
}

impl<'s> Step<'s> {
    fn new(mv: &'s Move, machine: &'s Machine, origin: &'s Origin) -> Step<'s> {
        let from = &machine.at;
        let tilt = machine.tilt.as_deref();
        let mut to = *from;
        to.update(&mv.end);
        let mut step = Step { mv, from, to, origin, of_cycle: false, of_tap: false, sideways: false, tilt };
        let (first, second, _) = mv.plane.axes();
        let moves = |axis: usize| step.way(Axis::ALL[axis]).is_none_or(|way| way.abs() > TINY);
        let moves = [first, second].into_iter().any(|axis| mv.axes.contains(Axis::ALL[axis]) && moves(axis));
        step.sideways = moves || matches!(mv.path, Path::Arc(..));
        step
    }
}

impl Step<'_> {
    /// Does it go at a feed, in coordinates of the workpiece?
    pub fn cuts(&self) -> bool {
        !self.mv.machine && !matches!(self.mv.path, Path::Rapid)
    }

    pub fn is_rapid(&self) -> bool {
        !self.mv.machine && matches!(self.mv.path, Path::Rapid)
    }

    pub fn is_line(&self) -> bool {
        matches!(self.mv.path, Path::Line(_))
    }

    pub fn feed(&self) -> Option<Feed> {
        self.mv.path.feed()
    }

    /// Way along an axis, where both ends are known.
    pub fn way(&self, axis: Axis) -> Option<f64> {
        Some(self.to.get(axis)? - self.from.get(axis)?)
    }

    /// One of the ends in workpiece coordinates.
    pub fn place(&self, at: &Pos) -> Pos {
        self.tilt.map_or(*at, |tilt| tilt.in_workpiece(at))
    }

    /// Is the working plane a tilted one?
    pub fn is_tilted(&self) -> bool {
        self.tilt.is_some()
    }

    /// The tool axis of the working plane.
    pub fn tool_axis(&self) -> Axis {
        tool_axis(self.mv.plane)
    }

    /// Way along the tool axis, upwards positive.
    pub fn rise(&self) -> Option<f64> {
        self.way(self.tool_axis())
    }

    /// Does it go straight away from the part, along the tool axis? Behind a change nobody knows where it begins; a height
    /// above the blank is enough then, in the workpiece.
    pub fn retracts(&self, blank: Option<Blank>) -> bool {
        let axis = self.tool_axis();
        let above = |blank: Blank| self.place(&self.to).get(axis).is_some_and(|to| to > blank.max[axis.index()]);
        let up = self.rise().map_or_else(|| blank.is_some_and(above), |rise| rise > TINY);
        self.is_line() && up && !self.goes_sideways()
    }

    /// Does it move an axis of the working plane?
    pub fn goes_sideways(&self) -> bool {
        self.sideways
    }
}

/// Ways shorter than this are none, mm.
pub const TINY: f64 = 1e-6;

pub fn tool_axis(plane: Plane) -> Axis {
    Axis::ALL[plane.axes().2]
}

/// Takes what rules find.
#[derive(Debug, Clone, Copy)]
pub struct Say<'d> {
    diags: &'d Diags,
}

impl<'d> Say<'d> {
    pub fn to(diags: &'d Diags) -> Say<'d> {
        Say { diags }
    }

    pub fn about(&self, fault: Fault, origin: &Origin) {
        self.diags.push(fault.at(origin.loc).called(origin.call));
    }

    pub fn found(&self, found: Diagnostic) {
        self.diags.push(found);
    }

    /// Does the block read a variable of which it was said already that nothing has set it?
    pub fn reads_unset(&self, block: &str) -> bool {
        self.diags.any(|found| {
            found.code.id == codes::P2021.id
                && found.message.split(' ').next().is_some_and(|name| {
                    let name = name.trim_matches('`').split('[').next().unwrap_or_default();
                    block
                        .split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
                        .any(|word| word.eq_ignore_ascii_case(name))
                })
        })
    }
}

/// A rule over what the program does. Each method sees the machine as it was before.
pub trait MotionRule {
    /// Does it look at moves at all?
    fn wants_moves(&self) -> bool {
        true
    }
    fn movement(&mut self, _: &Step<'_>, _: &Machine, _: Say<'_>) {}
    fn function(&mut self, _: &Function, _: &Machine, _: &Origin, _: Say<'_>) {}
    /// Nobody knows where the tool is.
    fn lost(&mut self) {}
    /// The program is over, and ran to its end.
    fn finish(&mut self, _: &Machine, _: Say<'_>) {}
}

/// The rules and what they share. Behind an error of the run a block is missing: they would go on with a wrong machine, and
/// are asked no more.
pub struct Watch<'a> {
    rules: Vec<Box<dyn MotionRule + 'a>>,
    /// Those of the rules that look at moves.
    moving: Vec<usize>,
    machine: Machine,
    diags: &'a Diags,
    /// The block of the last cycle.
    cycle: Option<Origin>,
    /// It taps with a compensating chuck.
    taps: bool,
    /// The moves are parts of a tap without one.
    rigid: bool,
    /// Side of the last programmed move.
    side: Side,
}

impl std::fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Watch").field("machine", &self.machine).finish_non_exhaustive()
    }
}

pub type Watching<'a> = Rc<RefCell<Watch<'a>>>;

impl<'a> Watch<'a> {
    pub fn new(rules: Vec<Box<dyn MotionRule + 'a>>, diags: &'a Diags) -> Watching<'a> {
        let moving = rules.iter().enumerate().filter(|(_, rule)| rule.wants_moves()).map(|(at, _)| at).collect();
        let machine = Machine::default();
        let watch = Watch { rules, moving, machine, diags, cycle: None, taps: false, rigid: false, side: Side::None };
        Rc::new(RefCell::new(watch))
    }

    /// The run is over.
    pub fn finish(&mut self) {
        if self.diags.has_errors() {
            return;
        }
        let say = Say::to(self.diags);
        self.rules.iter_mut().for_each(|rule| rule.finish(&self.machine, say));
    }

    fn movement(&mut self, mv: &Move, origin: &Origin) {
        let mut step = Step::new(mv, &self.machine, origin);
        step.of_cycle = self.cycle.is_some_and(|cycle| cycle == *origin);
        step.of_tap = self.rigid || step.of_cycle && self.taps;
        let to = step.to;
        // What rules find ends nothing.
        if !self.diags.has_failed() {
            let say = Say::to(self.diags);
            for &rule in &self.moving {
                self.rules[rule].movement(&step, &self.machine, say);
            }
        }
        let last = if step.is_rapid() || mv.machine { Last::Rapid } else { Last::Cut };
        self.machine.last = last;
        self.machine.plane = mv.plane;
        self.machine.at = to;
        if mv.machine {
            mv.axes.iter().for_each(|axis| self.machine.at.forget(axis));
            // An axis of the machine moves several of a tilted plane.
            if self.machine.tilt.is_some() {
                self.machine.at.clear();
            }
        }
    }

    /// The parts of a tap, one by one.
    fn tap(&mut self, tap: &Tap, place: &motion::Place, origin: &Origin) {
        self.rigid = true;
        tap.parts(&mut |part| {
            if let Some(function) = part.function() {
                self.function(&function, origin);
            } else if let Part::To(to) = part {
                self.movement(&place.along(tap, to, Path::Thread { lead: tap.lead }), origin);
            }
        });
        self.rigid = false;
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        let say = Say::to(self.diags);
        for rule in self.rules.iter_mut().filter(|_| !self.diags.has_failed()) {
            rule.function(function, &self.machine, origin, say);
        }
        let machine = &mut self.machine;
        match function {
            Function::ToolChange { number } => {
                // What a machine does with a spindle that turns is not known.
                if machine.turning == Turning::Unknown {
                    machine.turning = Turning::Off;
                }
                machine.tool = Some(*number);
                machine.last = Last::None;
            }
            Function::Spindle(spindle) | Function::SpindleOf { spindle, .. } => match spindle {
                Spindle::Start(turn) => machine.turning = Turning::On(*turn),
                Spindle::Stop | Spindle::Orient(_) => machine.turning = Turning::Off,
                Spindle::Speed(_) | Spindle::CuttingSpeed { .. } => machine.has_speed = true,
            },
            Function::Coolant(coolant) => machine.coolant = *coolant != Coolant::Off,
            Function::WorkOffset(_) => machine.at.clear(),
            Function::Tilt(tilting) => {
                machine.at.clear();
                machine.tilt = tilting.plane().map(|tilt| Box::new(*tilt));
            }
            Function::Plane(plane) => machine.plane = *plane,
            _ => {}
        }
    }

    fn lost(&mut self) {
        self.machine.at.clear();
        self.rules.iter_mut().for_each(|rule| rule.lost());
    }
}

/// Looks on in front of the sink that takes the motion.
pub struct OnMotion<'w, 'a> {
    pub watch: Watching<'a>,
    pub next: &'w mut dyn motion::Sink,
}

impl motion::Sink for OnMotion<'_, '_> {
    fn tap(&mut self, tap: &Tap, place: &motion::Place, origin: &Origin) {
        self.watch.borrow_mut().tap(tap, place, origin);
        self.next.tap(tap, place, origin);
    }

    fn movement(&mut self, mv: &Move, origin: &Origin) {
        self.watch.borrow_mut().movement(mv, origin);
        self.next.movement(mv, origin);
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        self.watch.borrow_mut().function(function, origin);
        self.next.function(function, origin);
    }

    fn lost(&mut self, origin: &Origin) {
        self.watch.borrow_mut().lost();
        self.next.lost(origin);
    }

    fn programmed(&mut self, mv: &Move, start: &Pos) {
        self.next.programmed(mv, start);
    }

    fn finished(&mut self, contour: &[crate::geo::Element], into: crate::ir::cycle::turning::Towards) {
        self.next.finished(contour, into);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.watch.borrow_mut().machine.at.update(at);
        self.next.begins_at(at);
    }

    fn full(&self) -> bool {
        self.next.full()
    }
}

/// Looks on in front of the sink that takes the contour: what the motion does not say any more.
pub struct OnContour<'w, 'a> {
    pub watch: Watching<'a>,
    pub next: &'w mut dyn contour::Sink,
}

impl contour::Sink for OnContour<'_, '_> {
    fn movement(&mut self, mv: &contour::Move, ctx: &CtxRef, origin: &Origin) {
        self.watch.borrow_mut().side = mv.side;
        self.next.movement(mv, ctx, origin);
    }

    fn corner(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin) {
        self.next.corner(corner, ctx, origin);
    }

    fn tap(&mut self, tap: &Tap, ctx: &CtxRef, origin: &Origin) {
        self.next.tap(tap, ctx, origin);
    }

    fn function(&mut self, function: &Function, ctx: &CtxRef, origin: &Origin) {
        {
            let watch = &mut *self.watch.borrow_mut();
            watch.machine.side = watch.side;
        }
        self.next.function(function, ctx, origin);
    }

    fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef, origin: &Origin) {
        {
            let watch = &mut *self.watch.borrow_mut();
            watch.cycle = Some(*origin);
            watch.taps = matches!(cycle, Cycle::Drilling(drilling)
                if matches!(drilling.method, Method::Tap(drilling::Tap { lead: None, .. })));
        }
        self.next.cycle(cycle, ctx, origin);
    }

    fn lost(&mut self, ctx: &CtxRef, origin: &Origin) {
        self.next.lost(ctx, origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.next.begins_at(at);
    }

    fn stands_at(&mut self, at: &Pos, ctx: &CtxRef, origin: &Origin) {
        self.next.stands_at(at, ctx, origin);
    }

    fn load(&self) -> Load {
        self.next.load()
    }

    fn contour_begins(&mut self, limit: usize, ctx: &CtxRef, origin: &Origin) {
        self.next.contour_begins(limit, ctx, origin);
    }

    fn contour_ends(&mut self, origin: &Origin) -> Result<Captured, Unfit> {
        self.next.contour_ends(origin)
    }
}
