//! What the coded arguments of drilling cycles say: axis, plane, how the depth is given, how the dwell counts.
//!
//! Source: C 6.1 and 6.2 (docs/sources.md).

use crate::diag::{Answer, Diagnostic, Help, codes};
use crate::geo::{Deg, Plane};
use crate::ir::cycle::drilling::Levels;
use crate::machine::Axis;
use crate::sema::cycle_table::Kind;

use super::super::Outcome;
use super::arguments::{AMODE, AXN, DMODE, DP, DPR, GMODE, Key, RFP, RTP, SDIS};
use super::call::CycleCall;

/// Which numbers give the depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Depth {
    /// DPR where it is not 0, else DP.
    Classic,
    Incremental,
    Absolute,
}

impl CycleCall<'_, '_> {
    pub(super) fn hole_axis(&self) -> Outcome<Axis> {
        let args = self.args;
        let [_, _, third] = self.st.roles();
        let mut axis = third;
        let place = match args.or_zero(AXN) {
            0.0 => None,
            1.0 => Some(0),
            2.0 => Some(1),
            3.0 => Some(2),
            _ => {
                let help = "0 is the tool axis";
                return self.cycle_fault(args.span_of(AXN), 61803, "`_AXN` is 0 to 3", help);
            }
        };
        if let Some(place) = place {
            // Axes of the plane, or of the machine: which is counted is not documented.
            let counted: [Axis; 2] = [self.st.roles()[place], self.st.machine.geometry_axes[place]];
            if counted[0] != counted[1] {
                return self.not_built(
                    AXN,
                    "an axis by `_AXN` outside G17, which may count the axes of the plane or of the machine,",
                );
            }
            axis = counted[0];
        }
        if self.names_other_plane(args) {
            axis = self.axis_of_named_plane()?;
        }
        self.digits_are_known()?;
        if axis == Axis::Y && self.st.machine.lathe && self.st.position.get(axis).is_none() {
            let message = "the hole lies along Y, the tool axis of G18, and no block has moved Y";
            let help =
                "program G17 in front of the cycle to drill along Z; where the lathe has a Y, program it once before";
            return self.cycle_fault(args.span, 61005, message, help);
        }
        Ok(axis)
    }

    /// The heights of the hole. A depth by the tens of `_GMODE` is that of a `centring`, or of the shank.
    pub(super) fn levels(&mut self, centring: bool) -> Outcome<Levels> {
        let args = self.args;
        let retract = self.needed_length(RTP, "the retraction plane RTP")?;
        let reference = self.needed_length(RFP, "the reference plane RFP")?;
        let clearance = self.length_of(args, SDIS).unwrap_or(0.0);
        if clearance < 0.0 {
            self.reading(SDIS, "SDIS has no sign, and its minus is left out");
        }
        let by = self.depth_by();
        let by_tens = args.digit(GMODE, 1) == 1;
        let (mut absolute, mut relative) = (self.length_of(args, DP), self.length_of(args, DPR));
        if by_tens && centring {
            let depth = self.centring_depth(retract, reference)?;
            (absolute, relative) = (Some(depth), None);
        } else {
            self.one_depth(by, &mut absolute, &mut relative)?;
        }
        match Levels::resolve(retract, reference, clearance, absolute, relative) {
            Ok(made) => {
                if made.overridden {
                    let message = format!("{}: DP and DPR give different depths; DPR counts", args.name());
                    let found = Diagnostic::new(codes::S8018, self.loc(args.span_of(DPR)), message);
                    self.report(found.help("leave one of them out"));
                }
                let mut levels = made.levels;
                if by_tens && !centring {
                    levels.depth -= levels.outward() * self.tip_of_drill()?;
                }
                Ok(levels)
            }
            Err(fault) => self.cycle_fault(
                args.span_of(DP),
                61101,
                &fault.to_string(),
                "RTP lies on the far side of RFP, seen from the depth",
            ),
        }
    }

    /// Which of DP and DPR the units of `_AMODE` choose.
    pub(super) fn depth_by(&self) -> Depth {
        match self.args.digit(AMODE, 0) {
            1 => Depth::Incremental,
            2 => Depth::Absolute,
            _ => Depth::Classic,
        }
    }

    /// The depth at which the cone of a centre drill has the diameter DP.
    fn centring_depth(&self, retract: f64, reference: f64) -> Outcome<f64> {
        let args = self.args;
        let diameter = self.needed_length(DP, "the diameter of the centring DP")?;
        if diameter <= 0.0 {
            let help = "give the diameter of the cone at the surface, above 0";
            return self.cycle_fault(args.span_of(DP), 61019, "the diameter of the centring is not above 0", help);
        }
        if args.or_zero(DPR) != 0.0 {
            let help = "leave DPR out, or take 0 in the tens of `_GMODE` for a depth";
            let message = "DPR stands beside a centring by diameter";
            return self.cycle_fault(args.span_of(DPR), 61805, message, help);
        }
        let way = retract - reference;
        if way == 0.0 {
            let help = "RTP lies above RFP, so that the cycle knows where the depth is";
            return self.cycle_fault(args.span_of(RTP), 61101, "RTP and RFP are the same", help);
        }
        if let Some(radius) = self.active_tool().and_then(|tool| tool.radius).filter(|radius| diameter > 2.0 * radius) {
            let message = format!("the tool has a diameter of {} mm, and the centring {diameter} mm", 2.0 * radius);
            return self.cycle_fault(args.span_of(DP), None, &message, "take a larger tool, or a smaller centring");
        }
        let tip = self.tip_angle("a centring by its diameter")?;
        Ok(reference - way.signum() * diameter / 2.0 / tangent(tip))
    }

    /// How far the tip of the drill lies in front of its full diameter.
    fn tip_of_drill(&self) -> Outcome<f64> {
        let args = self.args;
        const WHAT: &str = "a depth by the shank";
        let tip = self.tip_angle(WHAT)?;
        match self.active_tool().and_then(|tool| tool.radius).filter(|radius| *radius > 0.0) {
            Some(radius) => Ok(radius / tangent(tip)),
            None => {
                let message = format!("{WHAT} needs the radius of the tool");
                self.cycle_fault(
                    args.span_of(GMODE),
                    None,
                    &message,
                    self.ask_tool("radius", "give `[tools.N] radius`"),
                )
            }
        }
    }

    /// A help that names a field of the tool in use, with the key of that tool.
    fn ask_tool(&self, field: &'static str, help: &str) -> Help {
        match self.st.tool.active() {
            Some(number) => Answer::tool(number, field).help(help),
            None => "select the tool before the cycle".into(),
        }
    }

    fn tip_angle(&self, what: &str) -> Outcome<f64> {
        let args = self.args;
        match self.active_tool().and_then(|tool| tool.tip_angle) {
            Some(angle) => Ok(angle),
            None => {
                let message = format!("{what} needs the angle at the tip of the tool");
                let help = "give `[tools.N] tip_angle`: 118 for a common drill, 90 for a common centre drill";
                let help = self.ask_tool("tip_angle", help);
                self.cycle_fault(args.span_of(GMODE), None, &message, help)
            }
        }
    }

    /// Seconds at the bottom, counted as the tens of `_AMODE` say.
    pub(super) fn dwell_at_depth(&self, key: Key) -> Outcome<f64> {
        let args = self.args;
        let value = args.or_zero(key);
        match args.digit(AMODE, 1) {
            1 if value < 0.0 => {
                let help = "give it without a sign; 2 in the tens of `_AMODE` counts turns";
                self.cycle_fault(args.span_of(key), None, "a dwell in seconds is below 0", help)
            }
            2 => self.spindle_turns_of(key, value.abs()),
            _ => self.dwell_of(key),
        }
    }

    /// The tool axis of the plane that `_DMODE` names, where it is not the active one: the hole has no other axis.
    fn axis_of_named_plane(&self) -> Outcome<Axis> {
        let args = self.args;
        let plane = match args.digit(DMODE, 0) {
            1 => Plane::Xy,
            2 => Plane::Zx,
            3 => Plane::Yz,
            _ => return self.not_built(DMODE, "this plane (`_DMODE`)"),
        };
        let axis = Axis::ALL[plane.axes().2];
        if args.or_zero(AXN) != 0.0 || self.is_diameter_axis(axis) {
            return self.not_built(DMODE, "a plane other than the active one (`_DMODE`)");
        }
        Ok(axis)
    }

    /// Digits whose meaning is not known.
    pub(super) fn digits_are_known(&self) -> Outcome {
        self.digits_of_are_known(GMODE)?;
        self.digits_of_are_known(AMODE)
    }

    pub(super) fn digits_of_are_known(&self, key: Key) -> Outcome {
        let args = self.args;
        let Some(Kind::Digits(digits)) = args.cycle.parameter(key).map(|parameter| parameter.kind) else {
            return Ok(());
        };
        if let Some((places, way)) = digits.doubt
            && places.iter().any(|place| args.digit(key, *place) == 1)
        {
            self.reading(key, way);
        }
        let known = |place: u32| digits.known.iter().find(|digit| digit.place == place);
        let most = |place: u32| known(place).map_or(0, |digit| digit.most);
        let Some(place) = (0..10).find(|place| args.digit(key, *place) > most(*place)) else { return Ok(()) };
        let what = match known(place).map_or(digits.other, |digit| digit.unknown) {
            "" => {
                let (digit, name) = (args.digit(key, place), args.written(key));
                format!("the digit {digit} at place {} from the right of `{name}`", place + 1)
            }
            what => what.to_owned(),
        };
        self.not_built(key, &what)
    }

    /// Leaves the depth that the units of `_AMODE` choose.
    pub(super) fn one_depth(&self, by: Depth, absolute: &mut Option<f64>, relative: &mut Option<f64>) -> Outcome {
        let args = self.args;
        // DPR 0 is none; DP 0 is a depth.
        let given = relative.filter(|way| *way != 0.0);
        let (chosen, other, missing) = match by {
            Depth::Classic if absolute.is_none() && relative.is_none() => {
                let help = "give DP (argument 4) or DPR (argument 5)";
                return self.cycle_fault(args.span, 61808, "the depth is missing", help);
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
            return self.cycle_fault(args.span_of(AMODE), 61808, &message, help);
        }
        if other {
            let (used, left) = if by == Depth::Incremental { ("DPR", DP) } else { ("DP", DPR) };
            let message = format!(
                "{}: DP and DPR are both given; the units of `_AMODE` choose {used} (message 61805)",
                args.name()
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

    /// The hand of a thread by the thousands of `_AMODE`, beside the sign of its pitch.
    pub(super) fn hand(&self, lead: f64) -> Outcome<f64> {
        let args = self.args;
        match args.digit(AMODE, 3) {
            0 => Ok(lead),
            hand if lead > 0.0 => Ok(if hand == 2 { -lead } else { lead }),
            hand => {
                let which = if hand == 2 { "left" } else { "right" };
                let message = format!("the pitch is below 0, and the thousands of `_AMODE` say a {which}-hand thread");
                let help = "give the pitch without a sign, or 0 there";
                self.cycle_fault(args.span_of(AMODE), 61001, &message, help)
            }
        }
    }
}

/// Of half the angle at a tip.
fn tangent(tip: f64) -> f64 {
    let (sin, cos) = Deg(tip / 2.0).sin_cos();
    sin / cos
}
