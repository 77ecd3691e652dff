//! What the coded arguments of drilling cycles say: axis, plane, how the depth is given, how the dwell counts.
//!
//! Source: reference sections 6.1 and 6.2.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Deg, Plane};
use crate::ir::cycle::drilling::Levels;
use crate::machine::Axis;

use super::super::g_groups::Group;
use super::super::{Outcome, Run};
use super::Arguments;

/// Places of coded arguments; 0 for none.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Modes {
    /// `_AXN`
    pub axis: usize,
    /// `_GMODE`
    pub geometry: usize,
    /// `_DMODE`
    pub display: usize,
    /// `_AMODE`
    pub reading: usize,
}

pub(super) fn modes(name: &str) -> Modes {
    let [axis, geometry, display, reading] = match name {
        "CYCLE81" | "CYCLE82" | "CYCLE89" => [0, 7, 8, 9],
        "CYCLE83" => [13, 18, 19, 20],
        "CYCLE84" => [13, 22, 23, 24],
        "CYCLE840" => [12, 18, 19, 20],
        "CYCLE85" => [0, 9, 10, 11],
        "CYCLE86" => [0, 12, 13, 14],
        _ => [0; 4],
    };
    Modes { axis, geometry, display, reading }
}

/// Digits of `_AMODE` from the hundreds on that were seen in stored calls, by the place from the right: the largest value.
fn seen(name: &str, place: u32) -> i32 {
    match (name, place) {
        // The thousands are the hand of the thread, the millions 1 in all calls.
        ("CYCLE84", 3) => 2,
        ("CYCLE84", 6) => 1,
        // As in CYCLE84; no stored call is at hand.
        ("CYCLE840", 3 | 6) => 1,
        // All eight digits were seen as 1, and the hundred thousands as 2.
        ("CYCLE83", 5) => 2,
        ("CYCLE83", 2..=7) => 1,
        _ => 0,
    }
}

/// Which numbers give the depth.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Depth {
    /// DPR where it is not 0, else DP.
    Classic,
    Incremental,
    Absolute,
}

impl Run<'_> {
    pub(super) fn hole_axis(&self, args: &Arguments) -> Outcome<Axis> {
        let modes = modes(&args.name);
        let [_, _, third] = self.st.roles();
        let mut axis = third;
        if modes.axis != 0 {
            let place = match args.or_zero(modes.axis) {
                0.0 => None,
                1.0 => Some(0),
                2.0 => Some(1),
                3.0 => Some(2),
                _ => {
                    let help = "0 is the tool axis";
                    return self.cycle_fault(args, args.span_of(modes.axis), 61803, "`_AXN` is 0 to 3", help);
                }
            };
            if let Some(place) = place {
                // Axes of the plane, or of the machine: which is counted is not documented.
                let counted: [Axis; 2] = [self.st.roles()[place], self.st.geometry_axes[place]];
                if counted[0] != counted[1] {
                    return self.not_built(
                        args,
                        modes.axis,
                        "an axis by `_AXN` outside G17, which may count the axes of the plane or of the machine,",
                    );
                }
                axis = counted[0];
            }
        }
        if modes.display != 0
            && let plane = args.digit(modes.display, 0)
            && plane != 0
            && plane != i32::from(self.st.codes.of(Group::Plane).index)
        {
            axis = self.axis_at(args, modes.display, plane, modes.axis)?;
        }
        self.digits_are_known(args)?;
        if axis == Axis::Y && self.st.lathe && self.st.position.get(axis).is_none() {
            let message = "the hole lies along Y, the tool axis of G18, and no block has moved Y";
            let help =
                "program G17 in front of the cycle to drill along Z; where the lathe has a Y, program it once before";
            return self.cycle_fault(args, args.span, 61005, message, help);
        }
        Ok(axis)
    }

    /// The tool axis of the plane that `_DMODE` names, where it is not the active one: the hole has no other axis.
    fn axis_at(&self, args: &Arguments, dmode: usize, plane: i32, axn: usize) -> Outcome<Axis> {
        let plane = match plane {
            1 => Plane::Xy,
            2 => Plane::Zx,
            3 => Plane::Yz,
            _ => return self.not_built(args, dmode, "this plane (`_DMODE`)"),
        };
        let axis = Axis::ALL[plane.axes().2];
        let lifts = args.name == "CYCLE86" && (8..=10).any(|place| args.or_zero(place) != 0.0);
        if lifts || axn != 0 && args.or_zero(axn) != 0.0 || self.is_diameter_axis(axis) {
            return self.not_built(args, dmode, "a plane other than the active one (`_DMODE`)");
        }
        Ok(axis)
    }

    /// Digits whose meaning is not known.
    fn digits_are_known(&self, args: &Arguments) -> Outcome {
        let modes = modes(&args.name);
        let name = args.name.as_str();
        let tens = match name {
            // By the diameter of the centring, by the shank.
            "CYCLE81" | "CYCLE82" | "CYCLE83" => 1,
            _ => 0,
        };
        // The units of CYCLE86 say whether the tool lifts off.
        let units = if name == "CYCLE86" { 2 } else { 0 };
        let most = |place: u32| match place {
            0 => units,
            1 => tens,
            _ => 0,
        };
        if modes.geometry != 0
            && let Some(place) = (0..10).find(|place| args.digit(modes.geometry, *place) > most(*place))
        {
            let what = match (name, place) {
                ("CYCLE81", 1) => "this reading of DP (tens of `_GMODE`)",
                (_, 1) => "a depth by the shank of the tool (tens of `_GMODE`)",
                _ => "this reading of the geometry (`_GMODE`)",
            };
            return self.not_built(args, modes.geometry, what);
        }
        if modes.reading == 0 {
            return Ok(());
        }
        let most = |place: u32| if place < 2 { 2 } else { seen(name, place) };
        if name == "CYCLE840" && [3, 6].into_iter().any(|place| args.digit(modes.reading, place) == 1) {
            self.reading(
                args,
                modes.reading,
                "1 in the thousands and in the millions of `_AMODE` is read as in CYCLE84",
            );
        }
        let Some(place) = (0..10).find(|place| args.digit(modes.reading, *place) > most(*place)) else { return Ok(()) };
        let digit = args.digit(modes.reading, place);
        let what = match (name, place) {
            (_, 0) => "this reading of the depth (units of `_AMODE`)".to_owned(),
            (_, 1) => "this unit of the dwell (tens of `_AMODE`)".to_owned(),
            ("CYCLE83", 4) => "this reading of the first depth (`_AMODE`)".to_owned(),
            ("CYCLE83", 5) => "this reading of the degression (`_AMODE`)".to_owned(),
            ("CYCLE83", 7) => "this reading of the first feed (`_AMODE`)".to_owned(),
            ("CYCLE83", _) => "this reading of a dwell or a distance (`_AMODE`)".to_owned(),
            ("CYCLE84", 3) => "this hand of the thread (thousands of `_AMODE`)".to_owned(),
            _ => format!("the digit {digit} at place {} from the right of `_AMODE`", place + 1),
        };
        self.not_built(args, modes.reading, &what)
    }

    pub(super) fn levels(&mut self, args: &Arguments) -> Outcome<Levels> {
        let modes = modes(&args.name);
        let retract = self.needed_length(args, 1, "the retraction plane RTP")?;
        let reference = self.needed_length(args, 2, "the reference plane RFP")?;
        let clearance = self.length_of(args, 3).unwrap_or(0.0);
        if clearance < 0.0 {
            self.reading(args, 3, "SDIS has no sign, and its minus is left out");
        }
        let digit = |place: usize, position: u32| if place == 0 { 0 } else { args.digit(place, position) };
        let by = match digit(modes.reading, 0) {
            1 => Depth::Incremental,
            2 => Depth::Absolute,
            _ => Depth::Classic,
        };
        let shank = digit(modes.geometry, 1) == 1;
        let (mut absolute, mut relative) = (self.length_of(args, 4), self.length_of(args, 5));
        if shank && args.name == "CYCLE81" {
            let depth = self.centring_depth(args, retract, reference)?;
            (absolute, relative) = (Some(depth), None);
        } else {
            self.one_depth(args, by, &mut absolute, &mut relative)?;
        }
        match Levels::resolve(retract, reference, clearance, absolute, relative) {
            Ok(made) => {
                if made.overridden {
                    let message = format!("{}: DP and DPR give different depths; DPR counts", args.name);
                    let found = Diagnostic::new(codes::S8018, self.loc(args.span_of(5)), message);
                    self.report(found.help("leave one of them out"));
                }
                let mut levels = made.levels;
                if shank && args.name != "CYCLE81" {
                    levels.depth -= levels.outward() * self.tip_of_drill(args, modes.geometry)?;
                }
                Ok(levels)
            }
            Err(fault) => self.cycle_fault(
                args,
                args.span_of(4),
                61101,
                &fault.to_string(),
                "RTP lies on the far side of RFP, seen from the depth",
            ),
        }
    }

    /// Leaves the depth that the units of `_AMODE` choose.
    fn one_depth(
        &self,
        args: &Arguments,
        by: Depth,
        absolute: &mut Option<f64>,
        relative: &mut Option<f64>,
    ) -> Outcome {
        // DPR 0 is none; DP 0 is a depth.
        let given = relative.filter(|way| *way != 0.0);
        let (chosen, other, missing) = match by {
            Depth::Classic if absolute.is_none() && relative.is_none() => {
                let help = "give DP (argument 4) or DPR (argument 5)";
                return self.cycle_fault(args, args.span, 61808, "the depth is missing", help);
            }
            Depth::Classic => return Ok(()),
            Depth::Incremental => (
                given.is_some(),
                absolute.is_some_and(|depth| depth != 0.0),
                "`_AMODE` 1 takes it from DPR (argument 5)",
            ),
            Depth::Absolute => (absolute.is_some(), given.is_some(), "`_AMODE` 2 takes it from DP (argument 4)"),
        };
        if !chosen {
            let message = format!("the depth is missing: {missing}");
            let help = "0 in the units of `_AMODE` takes what is given";
            return self.cycle_fault(args, args.span_of(modes(&args.name).reading), 61808, &message, help);
        }
        if other {
            let (used, left) = if by == Depth::Incremental { ("DPR", 4) } else { ("DP", 5) };
            let message = format!(
                "{}: DP and DPR are both given; the units of `_AMODE` choose {used} (message 61805)",
                args.name
            );
            let found = Diagnostic::new(codes::S8018, self.loc(args.span_of(left)), message);
            self.report(found.help("leave the other one out"));
        }
        match by {
            Depth::Incremental => *absolute = None,
            _ => *relative = None,
        }
        Ok(())
    }

    /// The depth at which the cone of a centre drill has the diameter DP.
    fn centring_depth(&self, args: &Arguments, retract: f64, reference: f64) -> Outcome<f64> {
        let diameter = self.needed_length(args, 4, "the diameter of the centring DP")?;
        if diameter <= 0.0 {
            let help = "give the diameter of the cone at the surface, above 0";
            return self.cycle_fault(args, args.span_of(4), 61019, "the diameter of the centring is not above 0", help);
        }
        if args.or_zero(5) != 0.0 {
            let help = "leave DPR out, or take 0 in the tens of `_GMODE` for a depth";
            let message = "DPR stands beside a centring by diameter";
            return self.cycle_fault(args, args.span_of(5), 61805, message, help);
        }
        let way = retract - reference;
        if way == 0.0 {
            let help = "RTP lies above RFP, so that the cycle knows where the depth is";
            return self.cycle_fault(args, args.span_of(1), 61101, "RTP and RFP are the same", help);
        }
        if let Some(radius) = self.active_tool().and_then(|tool| tool.radius).filter(|radius| diameter > 2.0 * radius) {
            let message = format!("the tool has a diameter of {} mm, and the centring {diameter} mm", 2.0 * radius);
            return self.cycle_fault(args, args.span_of(4), 0, &message, "take a larger tool, or a smaller centring");
        }
        let tip = self.tip_angle(args, 7, "a centring by its diameter")?;
        Ok(reference - way.signum() * diameter / 2.0 / tangent(tip))
    }

    /// How far the tip of the drill lies in front of its full diameter.
    fn tip_of_drill(&self, args: &Arguments, place: usize) -> Outcome<f64> {
        const WHAT: &str = "a depth by the shank";
        let tip = self.tip_angle(args, place, WHAT)?;
        match self.active_tool().and_then(|tool| tool.radius).filter(|radius| *radius > 0.0) {
            Some(radius) => Ok(radius / tangent(tip)),
            None => {
                let message = format!("{WHAT} needs the radius of the tool");
                self.cycle_fault(args, args.span_of(place), 0, &message, "give `[tools.N] radius`")
            }
        }
    }

    fn tip_angle(&self, args: &Arguments, place: usize, what: &str) -> Outcome<f64> {
        match self.active_tool().and_then(|tool| tool.tip_angle) {
            Some(angle) => Ok(angle),
            None => {
                let message = format!("{what} needs the angle at the tip of the tool");
                let help = "give `[tools.N] tip_angle`: 118 for a common drill, 90 for a common centre drill";
                self.cycle_fault(args, args.span_of(place), 0, &message, help)
            }
        }
    }

    /// Seconds at the bottom, counted as the tens of `_AMODE` say.
    pub(super) fn dwell_at_depth(&self, args: &Arguments, place: usize) -> Outcome<f64> {
        let reading = modes(&args.name).reading;
        let value = args.or_zero(place);
        match if reading == 0 { 0 } else { args.digit(reading, 1) } {
            1 if value < 0.0 => {
                let help = "give it without a sign; 2 in the tens of `_AMODE` counts turns";
                self.cycle_fault(args, args.span_of(place), 0, "a dwell in seconds is below 0", help)
            }
            2 => self.spindle_turns_of(args, place, value.abs()),
            _ => self.dwell_of(args, place),
        }
    }

    /// The hand of a thread by the thousands of `_AMODE`, beside the sign of its pitch.
    pub(super) fn hand(&self, args: &Arguments, lead: f64) -> Outcome<f64> {
        let reading = modes(&args.name).reading;
        match args.digit(reading, 3) {
            0 => Ok(lead),
            hand if lead > 0.0 => Ok(if hand == 2 { -lead } else { lead }),
            hand => {
                let which = if hand == 2 { "left" } else { "right" };
                let message = format!("the pitch is below 0, and the thousands of `_AMODE` say a {which}-hand thread");
                let help = "give the pitch without a sign, or 0 there";
                self.cycle_fault(args, args.span_of(reading), 61001, &message, help)
            }
        }
    }
}

/// Of half the angle at a tip.
fn tangent(tip: f64) -> f64 {
    let (sin, cos) = Deg(tip / 2.0).sin_cos();
    sin / cos
}
