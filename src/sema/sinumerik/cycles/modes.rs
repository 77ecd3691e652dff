//! What the coded arguments of drilling cycles say: axis, plane, how the depth is given, how the dwell counts.
//!
//! Source: C 6.1 and 6.2 (docs/sources.md).

use crate::diag::{Answer, Help, codes};
use crate::geo::{Deg, Plane};
use crate::ir::cycle::drilling::Levels;
use crate::machine::Axis;
use crate::sema::cycle::row::Kind;

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
                return self.refuse_cycle(args.span_of(AXN), codes::P2090::axn_is_0_to_3());
            }
        };
        if let Some(place) = place {
            // Axes of the plane, or of the machine: which is counted is not documented.
            let counted: [Axis; 2] = [self.st.roles()[place], self.st.machine.geometry_axes[place]];
            if counted[0] != counted[1] {
                return self.refuse_argument(AXN, codes::S9015::axis_by_axn_outside_g17());
            }
            axis = counted[0];
        }
        if self.names_other_plane(args) {
            axis = self.axis_of_named_plane()?;
        }
        self.digits_are_known()?;
        if axis == Axis::Y && self.st.machine.lathe && self.st.position.get(axis).is_none() {
            return self.refuse_cycle(args.span, codes::P2090::hole_lies_along_y());
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
            self.reads(SDIS, codes::P8106::sdis_has_no_sign());
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
                    let found =
                        codes::S8018::dp_dpr_give_different_depths(&args.name()).at(self.loc(args.span_of(DPR)));
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
            return self.refuse_cycle(args.span_of(DP), codes::P2090::diameter_of_centring_is_not_above_0());
        }
        if args.or_zero(DPR) != 0.0 {
            return self.refuse_cycle(args.span_of(DPR), codes::P2090::dpr_stands_beside_centring_by_diameter());
        }
        let way = retract - reference;
        if way == 0.0 {
            return self.refuse_cycle(args.span_of(RTP), codes::P2090::rtp_rfp_are_same());
        }
        if let Some(radius) = self.active_tool().and_then(|tool| tool.radius).filter(|radius| diameter > 2.0 * radius) {
            return self
                .refuse_cycle(args.span_of(DP), codes::P2090::tool_has_diameter_of_mm(&(2.0 * radius), &diameter));
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
            None => self.refuse_cycle(
                args.span_of(GMODE),
                codes::P2090::needs_radius_of_tool(&WHAT).help(self.ask_tool("radius", "give `[tools.N] radius`")),
            ),
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
                let help = "give `[tools.N] tip_angle`: 118 for a common drill, 90 for a common centre drill";
                let help = self.ask_tool("tip_angle", help);
                self.refuse_cycle(args.span_of(GMODE), codes::P2090::needs_angle_at_tip_of_tool(&what).help(help))
            }
        }
    }

    /// Seconds at the bottom, counted as the tens of `_AMODE` say.
    pub(super) fn dwell_at_depth(&self, key: Key) -> Outcome<f64> {
        let args = self.args;
        let value = args.or_zero(key);
        match args.digit(AMODE, 1) {
            1 if value < 0.0 => self.refuse_cycle(args.span_of(key), codes::P2090::dwell_in_seconds_is_below_0()),
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
            _ => return self.refuse_argument(DMODE, codes::S9015::this_plane_dmode_is_not_supported()),
        };
        let axis = Axis::ALL[plane.axes().2];
        if args.or_zero(AXN) != 0.0 || self.is_diameter_axis(axis) {
            return self.refuse_argument(DMODE, codes::S9015::plane_other_than_active_one());
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
                return self.refuse_cycle(args.span, codes::P2090::depth_is_missing_so_give_dp());
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
            return self.refuse_cycle(args.span_of(AMODE), codes::P2090::depth_is_missing(&missing));
        }
        if other {
            let (used, left) = if by == Depth::Incremental { ("DPR", DP) } else { ("DP", DPR) };
            let found = codes::S8018::dp_dpr_are_both_given(&args.name(), &used).at(self.loc(args.span_of(left)));
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
                self.refuse_cycle(args.span_of(AMODE), codes::P2090::pitch_is_below_0_and_thousands(&which))
            }
        }
    }
}

/// Of half the angle at a tip.
fn tangent(tip: f64) -> f64 {
    let (sin, cos) = Deg(tip / 2.0).sin_cos();
    sin / cos
}
