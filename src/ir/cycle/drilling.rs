//! Arguments of drilling, boring and tapping. The tool stands over the hole; only the drilling axis moves.

use core::fmt;

use crate::geo::Deg;
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::ir::{Feed, Pos};
use crate::machine::Axis;

use super::Family;

/// Most steps of a hole; more is a lost decimal point.
pub const MOST_PECKS: usize = 10_000;

/// A hole where the tool stands. Lengths in mm, heights are coordinates along the drilling axis in the programmed
/// frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Drilling {
    /// The drilling axis.
    pub axis: Axis,
    /// Surface, bottom, and the heights above. A hole whose bottom is the surface moves nothing.
    pub levels: Levels,
    /// Feed down into the hole, above 0. A tap with a lead does not look at it.
    pub feed: Feed,
    /// Where the tool goes from the start plane at another feed before it drills; `None` drills from the start plane.
    pub entry: Option<Entry>,
    /// What is done between the start plane and the bottom.
    pub method: Method,
}

/// The upper part of a hole that is open already.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// Height at which drilling begins: at the start plane or lower, above the bottom.
    pub height: f64,
    /// Feed from the start plane to `height`; `None` for rapid.
    pub feed: Option<Feed>,
}

/// Heights of a hole: coordinates along the drilling axis, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Levels {
    /// Retract height: here the tool stands in the end. Not on the side of the surface where the depth lies.
    pub retract: f64,
    /// Surface of the workpiece, from which depths count.
    pub reference: f64,
    /// Safety distance above the surface, mm, 0 or more: rapid traverse ends there, at the start plane.
    pub clearance: f64,
    /// Bottom of the hole.
    pub depth: f64,
}

/// How a hole is made. The tool begins at the start plane, or at the height of the entry, and goes to the retract
/// height in the end. Each dwell is in seconds, 0 or more.
#[derive(Debug, Clone, PartialEq)]
pub enum Method {
    /// To the depth, wait for `dwell`, out at rapid.
    Drill { dwell: f64 },
    /// At the feed of the hole to `height`, which lies between the start plane and the bottom, then to the depth at
    /// `feed`, wait for `dwell`, out at rapid.
    Through { dwell: f64, height: f64, feed: Feed },
    /// In steps.
    Peck(Pecking),
    /// A thread is cut by the tap in the spindle.
    Tap(Tap),
    /// In with the spindle in a state of its own, which holds on the way out of the hole, too.
    Deep(DeepHole),
    /// To the depth, wait for `dwell`, back to the start plane at the feed `back`, out at rapid.
    Ream { dwell: f64, back: Feed },
    /// To the depth, wait, stop the spindle at an angle, lift off, out, back to the centre, spindle on.
    Bore(Bore),
    /// To the depth, wait for `dwell`, spindle and program stop, out at rapid, spindle on in the sense of `turn`.
    BoreWithStop { dwell: f64, turn: Turn },
}

/// Drilling with a drill that is guided by the hole. Speeds in rev/min, above 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeepHole {
    /// Seconds at the bottom, before the spindle changes.
    pub dwell: f64,
    /// Speed and sense of the spindle from the start plane to the entry, and out of the hole; no sense where the
    /// spindle stands: then the speed plays no part.
    pub entry: (f64, Option<Turn>),
    /// Speed and sense from the entry to the bottom.
    pub drilling: (f64, Turn),
    /// What the coolant is told before it drills, and after the dwell at the bottom; `None` leaves it as it is.
    pub coolant: [Option<Coolant>; 2],
    /// Feed from the bottom to the start plane; `None` for rapid.
    pub back: Option<Feed>,
}

/// Drilling in steps: chips are broken in the hole, or removed out of it. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pecking {
    /// Depth below the surface at which the first step begins, 0 or more, above the bottom.
    pub from: f64,
    /// First step, over 0.
    pub first: f64,
    /// How the steps after the first become shorter.
    pub degression: Degression,
    /// Factor on the feed of the first step, over 0 to 1.
    pub first_feed: f64,
    /// Seconds at the depth of each step but the last, 0 or more.
    pub dwell: f64,
    /// Seconds at the bottom, 0 or more.
    pub dwell_at_bottom: f64,
    /// After which steps the chip is broken in the hole; after the others it is removed.
    pub breaks: Breaks,
    /// Retract within the hole that breaks the chip, 0 or more, at rapid.
    pub way: f64,
    /// How a chip is removed out of the hole.
    pub removal: Removal,
}

/// How steps become shorter. Amounts in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Degression {
    /// By this amount each, down to the amount itself; over 0.
    Amount(f64),
    /// By `factor` each, over 0 to 1, but none below `least`. A last step that ends just at the bottom is halved.
    Factor { factor: f64, least: f64 },
    /// By `less` each, 0 or more, down to `least`; the last step is what remains.
    Plain { less: f64, least: f64 },
    /// All steps alike; the last two are halves of the rest where the last would be shorter than `least`.
    Even { least: f64 },
}

/// After which steps chips are broken; after the others they are removed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Breaks {
    /// After no step.
    Never,
    /// After every step.
    Always,
    /// After so many steps one after the other; then chips are removed once.
    Times(u32),
    /// Within a step, each time after so many mm; over 0.
    Every(f64),
}

/// Chips are removed: out to the start plane, a dwell, and at rapid to in front of the last depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Removal {
    /// Feed out of the hole; `None` for rapid.
    pub back: Option<Feed>,
    /// Seconds at the start plane, 0 or more.
    pub dwell: f64,
    /// Where rapid traverse back into the hole ends.
    pub ahead: AdvancedStop,
    /// After the last step, too, the tool stops at the start plane, which it reaches at this feed, at rapid with
    /// `None`; without the outer value it goes to the retract height at once.
    pub last: Option<Option<Feed>>,
}

/// Distance above the depth reached where rapid traverse back into the hole ends, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AdvancedStop {
    /// [`usual_ahead`] of the depth reached.
    ByDepth,
    /// The distance after the first step and the one before the last step, each 0 or more; evenly between.
    Evenly([f64; 2]),
}

/// The distance above a depth, both in mm, that old controls keep: 0.6 mm down to 30 mm, then a fiftieth of the depth,
/// at most 7 mm (standard cycle CYCLE83, V06.02.09; HEIDENHAIN TNC 407, cycle 1).
pub fn usual_ahead(depth: f64) -> f64 {
    if depth <= 30.0 { 0.6 } else { (depth / 50.0).min(7.0) }
}

/// Tapping. The spindle turns one way on the way in and the other way on the way out. Speeds in rev/min, above 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tap {
    /// Without a compensating chuck: axis and spindle go in step all the time. Wants a lead, and no dwell after the reversal.
    pub rigid: bool,
    /// mm per turn, over 0; the hand of the thread is in `turn`. `None`: with the feed of the hole both ways, for a
    /// compensating chuck.
    pub lead: Option<f64>,
    /// On the way in; out is the other way.
    pub turn: Turn,
    /// Seconds at the bottom, and at the depth of each step, 0 or more.
    pub dwell: f64,
    /// The dwell comes after the reversal of the spindle, not before it.
    pub dwell_reversed: bool,
    /// Speed on the way in; `None` for the one in force.
    pub speed_in: Option<f64>,
    /// Speed on the way out; `None` for that of the way in.
    pub speed_out: Option<f64>,
    /// Angle in degrees at which the spindle stops before the tap; `None` where it stops nowhere.
    pub orient: Option<f64>,
    /// Steps of the tap; `None` for one stroke to the bottom.
    pub step: Option<TapStep>,
    /// What the spindle does after the tap.
    pub after: Spindle,
    /// Speed after the tap; `None` leaves the last one.
    pub speed_after: Option<f64>,
}

impl Tap {
    /// In one go, at the speed in force; `lead` in mm per turn, without its sign.
    pub fn new(rigid: bool, lead: Option<f64>, turn: Turn, after: Spindle) -> Tap {
        Tap {
            rigid,
            lead: lead.map(f64::abs),
            turn,
            dwell: 0.0,
            dwell_reversed: false,
            speed_in: None,
            speed_out: None,
            orient: None,
            step: None,
            after,
            speed_after: None,
        }
    }
}

/// What removes the chip between two steps of a tap; lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Chip {
    /// Retract by `back`, 0 or more, at the speed of the way out, not beyond the start plane.
    Break { back: f64 },
    /// Out to the start plane, a dwell as at the bottom, and down at the speed of the way out to `ahead` above the
    /// depth reached, 0 or more.
    Remove { ahead: f64 },
}

impl Chip {
    fn way(self) -> f64 {
        match self {
            Chip::Break { back: way } | Chip::Remove { ahead: way } => way,
        }
    }
}

/// Steps of a tap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TapStep {
    /// Depth of the first step below the surface, mm, over 0.
    pub way: f64,
    /// How the steps after the first become shorter.
    pub degression: Degression,
    /// What removes the chip between two steps.
    pub chip: Chip,
}

/// Boring with a tool whose edge is lifted off the wall before it leaves the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bore {
    /// Seconds at the bottom, 0 or more.
    pub dwell: f64,
    /// Sense in which the spindle is started again after the tool has left the hole.
    pub turn: Turn,
    /// Angle of the spindle in degrees at which it stops at the bottom, so that the edge can be lifted off.
    pub orient: f64,
    /// Feed from the bottom to the start plane; `None` for rapid.
    pub back: Option<Feed>,
    /// Lift-off along the first, second and third axis of the plane, mm, signed, from the centre and the bottom; 0
    /// lifts off along no axis.
    pub lift: [f64; 3],
}

/// Length in mm of the tip of a drill up to where it has this `radius` in mm; `tip` is the whole angle at the tip.
pub fn tip_height(radius: f64, tip: Deg) -> f64 {
    let (sin, cos) = Deg(tip.0 / 2.0).sin_cos();
    radius * cos / sin
}

/// Arguments that make no hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DrillingFault {
    /// A height is not a number.
    Number,
    /// The retract height does not lie on the other side of the surface than the depth (alarm 61101).
    ReferencePlane,
    /// The clearance is negative.
    Clearance,
    /// The tool would enter the hole above the start plane, or below the bottom.
    Entry,
    /// A dwell is negative.
    Dwell,
    /// A peck, its amount or its factor is out of range.
    Peck,
    /// The pitch is not over 0.
    Lead,
    /// A speed is not over 0.
    Speed,
    /// A feed is not over 0.
    Feed,
    /// The pecks never reach the bottom, or only after too many.
    TooManyPecks,
}

impl fmt::Display for DrillingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            DrillingFault::Number => "a height of the hole is not a number",
            DrillingFault::ReferencePlane => "the surface must lie between the retract height and the depth",
            DrillingFault::Clearance => "the safety distance must not be negative",
            DrillingFault::Entry => "drilling has to begin between the start plane and the depth",
            DrillingFault::Dwell => "the dwell time must not be negative",
            DrillingFault::Peck => "the steps of the hole must be over 0, and a factor at most 1",
            DrillingFault::Lead => "the pitch must be over 0",
            DrillingFault::Speed => "the spindle speed must be over 0",
            DrillingFault::Feed => "the feed must be over 0",
            DrillingFault::TooManyPecks => "the steps become so small that the hole is not finished",
        })
    }
}

/// What an absolute and a relative depth come to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolved {
    /// With the depth that counts. Whether the retract height lies above the start plane was not looked at.
    pub levels: Levels,
    /// An absolute depth was given too, says something else and is not used.
    pub overridden: bool,
}

impl Levels {
    /// The levels from an absolute depth, or a relative one that counts from the surface and wins if it is given and
    /// not 0; its sign does not matter (standard cycles CYCLE81 to CYCLE84, V06.02.09).
    ///
    /// # Errors
    /// `ReferencePlane` where a relative depth has no direction, or the absolute one lies on the wrong side.
    pub fn resolve(
        retract: f64,
        reference: f64,
        clearance: f64,
        absolute: Option<f64>,
        relative: Option<f64>,
    ) -> Result<Resolved, DrillingFault> {
        let towards = retract - reference;
        let relative = relative.filter(|way| *way != 0.0);
        let depth = match relative {
            Some(_) if towards == 0.0 => return Err(DrillingFault::ReferencePlane),
            Some(way) => reference - way.abs() * towards.signum(),
            None => absolute.unwrap_or(0.0),
        };
        // SINUMERIK uses the magnitude of the safety distance.
        let levels = Levels { retract, reference, clearance: clearance.abs(), depth };
        let overridden = relative.is_some() && absolute.is_some_and(|given| given != 0.0 && given != depth);
        levels.check()?;
        Ok(Resolved { levels, overridden })
    }

    /// Direction out of the hole along the drilling axis: 1 where the hole goes down, -1 where it goes up; 0 for a hole
    /// without depth.
    pub fn outward(&self) -> f64 {
        let way = self.reference - self.depth;
        if way == 0.0 { 0.0 } else { way.signum() }
    }

    /// Height at which rapid traverse ends: the safety distance above the surface.
    pub fn start_plane(&self) -> f64 {
        self.reference + self.clearance * self.outward()
    }

    /// Depth of the bottom below the surface, mm, 0 or more.
    pub fn way(&self) -> f64 {
        (self.reference - self.depth).abs()
    }

    fn check(&self) -> Result<(), DrillingFault> {
        let finite = [self.retract, self.reference, self.clearance, self.depth].iter().all(|v| v.is_finite());
        let (out, above) = (self.outward(), self.retract - self.reference);
        if !finite {
            Err(DrillingFault::Number)
        } else if self.clearance < 0.0 {
            Err(DrillingFault::Clearance)
        } else if above != 0.0 && out != 0.0 && above.signum() != out {
            Err(DrillingFault::ReferencePlane)
        } else {
            Ok(())
        }
    }
}

impl Pecking {
    /// Steps without dwell, chips removed at rapid.
    pub fn new(first: f64, degression: Degression) -> Pecking {
        let removal = Removal { back: None, dwell: 0.0, ahead: AdvancedStop::ByDepth, last: None };
        Pecking {
            from: 0.0,
            first,
            degression,
            first_feed: 1.0,
            dwell: 0.0,
            dwell_at_bottom: 0.0,
            breaks: Breaks::Never,
            way: 0.0,
            removal,
        }
    }

    /// The first step in mm from an absolute depth, or from a relative one that wins, at most the depth of the hole;
    /// `None` where neither is given, or the absolute one does not lie between the surface and the bottom (alarm
    /// 61107).
    pub fn first_step(levels: &Levels, absolute: Option<f64>, relative: Option<f64>) -> Option<f64> {
        let total = levels.way();
        match (relative.filter(|way| *way != 0.0), absolute) {
            (Some(way), _) => Some(way.abs().min(total)),
            (None, Some(depth)) => {
                let way = (levels.reference - depth) * levels.outward();
                (way > 0.0).then(|| way.min(total))
            }
            (None, None) => None,
        }
    }
}

impl Breaks {
    fn is_possible(self) -> bool {
        !matches!(self, Breaks::Every(way) if !(way > 0.0 && way.is_finite()))
    }
}

impl AdvancedStop {
    fn is_possible(self) -> bool {
        match self {
            AdvancedStop::ByDepth => true,
            AdvancedStop::Evenly(ways) => ways.iter().all(|way| *way >= 0.0 && way.is_finite()),
        }
    }
}

impl Degression {
    /// All steps alike, as the cycle makes them from a factor of 1.
    pub fn constant(step: f64) -> Degression {
        Degression::Factor { factor: 1.0, least: step }
    }
}

impl Family for Drilling {
    type Fault = DrillingFault;

    fn check(&self) -> Result<(), DrillingFault> {
        self.levels.check()?;
        let seconds = |s: f64| s >= 0.0 && s.is_finite();
        let positive = |v: f64| v > 0.0 && v.is_finite();
        let speed = |s: Option<f64>| s.is_none_or(positive);
        let rules: &[(bool, DrillingFault)] = match &self.method {
            Method::Drill { dwell } | Method::BoreWithStop { dwell, .. } => &[(seconds(*dwell), DrillingFault::Dwell)],
            Method::Ream { dwell, back } => {
                &[(seconds(*dwell), DrillingFault::Dwell), (positive(back.value()), DrillingFault::Feed)]
            }
            Method::Through { dwell, height, feed } => &[
                (seconds(*dwell), DrillingFault::Dwell),
                (positive(feed.value()), DrillingFault::Feed),
                (self.enters(&Entry { height: *height, feed: None }), DrillingFault::Entry),
            ],
            Method::Deep(hole) => &[
                (seconds(hole.dwell), DrillingFault::Dwell),
                (hole.back.is_none_or(|back| positive(back.value())), DrillingFault::Feed),
                (positive(hole.drilling.0) && (positive(hole.entry.0) || hole.entry.1.is_none()), DrillingFault::Speed),
            ],
            Method::Bore(bore) => &[
                (seconds(bore.dwell), DrillingFault::Dwell),
                (bore.back.is_none_or(|back| positive(back.value())), DrillingFault::Feed),
                (bore.orient.is_finite() && bore.lift.iter().all(|v| v.is_finite()), DrillingFault::Number),
            ],
            Method::Tap(tap) => &[
                (seconds(tap.dwell), DrillingFault::Dwell),
                (tap.lead.is_none_or(positive), DrillingFault::Lead),
                (speed(tap.speed_in) && speed(tap.speed_out) && speed(tap.speed_after), DrillingFault::Speed),
                (
                    tap.step.is_none_or(|step| positive(step.way) && good(step.degression) && seconds(step.chip.way())),
                    DrillingFault::Peck,
                ),
            ],
            Method::Peck(peck) => &[
                (seconds(peck.dwell) && seconds(peck.dwell_at_bottom), DrillingFault::Dwell),
                (seconds(peck.removal.dwell), DrillingFault::Dwell),
                (positive(peck.first) && good(peck.degression), DrillingFault::Peck),
                (seconds(peck.from) && (peck.from == 0.0 || peck.from < self.levels.way()), DrillingFault::Entry),
                (positive(peck.first_feed) && peck.first_feed <= 1.0, DrillingFault::Feed),
                (seconds(peck.way) && peck.breaks.is_possible(), DrillingFault::Peck),
                (peck.removal.ahead.is_possible(), DrillingFault::Peck),
                (peck.removal.back.is_none_or(|back| positive(back.value())), DrillingFault::Feed),
                (peck.removal.last.flatten().is_none_or(|last| positive(last.value())), DrillingFault::Feed),
            ],
        };
        if !positive(self.feed.value()) && !matches!(self.method, Method::Tap(Tap { lead: Some(_), .. })) {
            return Err(DrillingFault::Feed);
        }
        if self.entry.is_some_and(|entry| !self.enters(&entry)) {
            return Err(DrillingFault::Entry);
        }
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn leaves(&self, at: &mut Pos) {
        // A hole without depth moves nothing.
        if self.levels.outward() != 0.0 {
            at.set(self.axis, self.levels.retract);
        }
    }

    fn spindle_after(&self) -> Option<Spindle> {
        if self.levels.outward() == 0.0 {
            return None;
        }
        match &self.method {
            Method::Tap(tap) => Some(tap.after),
            Method::Bore(bore) => Some(Spindle::Start(bore.turn)),
            Method::BoreWithStop { turn, .. } => Some(Spindle::Start(*turn)),
            Method::Deep(hole) => Some(hole.entry.1.map_or(Spindle::Stop, Spindle::Start)),
            Method::Drill { .. } | Method::Through { .. } | Method::Peck(_) | Method::Ream { .. } => None,
        }
    }

    fn repeats(&self) -> bool {
        true
    }
}

impl Drilling {
    fn enters(&self, entry: &Entry) -> bool {
        let out = self.levels.outward();
        let (above, below) = (self.levels.start_plane() - entry.height, entry.height - self.levels.depth);
        above * out >= 0.0 && below * out > 0.0 && entry.feed.is_none_or(|feed| feed.value() > 0.0)
    }
}

fn good(degression: Degression) -> bool {
    match degression {
        Degression::Amount(amount) => amount > 0.0 && amount.is_finite(),
        Degression::Factor { factor, least } => factor > 0.0 && factor <= 1.0 && least >= 0.0 && least.is_finite(),
        Degression::Plain { less, least } => less >= 0.0 && less.is_finite() && least >= 0.0 && least.is_finite(),
        Degression::Even { least } => least >= 0.0 && least.is_finite(),
    }
}
