//! What the coded arguments of drilling cycles say: axis, plane, how the depth is given, how the dwell counts.
//!
//! Source: C 6.1 and 6.2 (docs/sources.md).

use crate::diag::{Answer, Help, codes};
use crate::geo::{Deg, Plane};
use crate::ir::cycle::drilling::{Levels, tip_height};
use crate::machine::Axis;
use crate::sema::cycle::given::digit;
use crate::sema::cycle::row::{self, Name};

use super::call::CycleCall;
use super::names::{AMODE, AXN, DMODE, DP, DPR, GMODE, RFP, RTP, SDIS};
use crate::sema::cycle::call::{Kind, Made};

/// Which numbers give the depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Depth {
    /// DPR where it is not 0, else DP.
    Classic,
    Incremental,
    Absolute,
}

impl CycleCall<'_> {
    pub(super) fn hole_axis(&self) -> Made<Axis> {
        let given = self.given;
        let [_, _, third] = self.st.roles();
        let mut axis = third;
        let place = match given.or_zero(AXN) {
            0.0 => None,
            1.0 => Some(0),
            2.0 => Some(1),
            3.0 => Some(2),
            _ => {
                return self.refuse_argument(AXN, codes::P2090::axn_is_0_to_3());
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
        if self.names_other_plane() {
            axis = self.axis_of_named_plane()?;
        }
        if axis == Axis::Y && self.st.machine.lathe && self.st.position.get(axis).is_none() {
            return self.refuse(codes::P2090::hole_lies_along_y());
        }
        Ok(axis)
    }

    /// The heights of the hole. A depth by the tens of `_GMODE` is that of a `centring`, or of the shank.
    pub(super) fn levels(&self, centring: bool) -> Made<Levels> {
        let given = self.given;
        let retract = self.given.length(RTP);
        let reference = self.given.length(RFP);
        let clearance = self.given.length(SDIS);
        if clearance < 0.0 {
            self.say_of(SDIS, codes::P8106::sdis_has_no_sign());
        }
        let by = self.depth_by();
        let by_tens = given.digit(GMODE, 1) == 1;
        let (mut absolute, mut relative) = (self.given.length_if(DP), self.given.length_if(DPR));
        if by_tens && centring {
            let depth = self.centring_depth(retract, reference)?;
            (absolute, relative) = (Some(depth), None);
        } else {
            self.one_depth(by, &mut absolute, &mut relative)?;
        }
        match Levels::resolve(retract, reference, clearance, absolute, relative) {
            Ok(made) => {
                if made.overridden {
                    let fault = codes::S8018::dp_dpr_give_different_depths(&given.called);
                    self.note(given.place_of(DPR), fault, Kind::Each);
                }
                let mut levels = made.levels;
                if by_tens && !centring {
                    levels.depth -= levels.outward() * self.tip_of_drill()?;
                }
                Ok(levels)
            }
            Err(fault) => {
                let fault = codes::P2090::call_makes_no_cycle(&fault).alarm(61101);
                self.refuse_argument(DP, fault.help("RTP lies on the far side of RFP, seen from the depth"))
            }
        }
    }

    /// Which of DP and DPR the units of `_AMODE` choose.
    pub(super) fn depth_by(&self) -> Depth {
        match self.given.digit(AMODE, 0) {
            1 => Depth::Incremental,
            2 => Depth::Absolute,
            _ => Depth::Classic,
        }
    }

    /// The depth at which the cone of a centre drill has the diameter DP.
    fn centring_depth(&self, retract: f64, reference: f64) -> Made<f64> {
        let given = self.given;
        let diameter = self.given.length(DP);
        if diameter <= 0.0 {
            return self.refuse_argument(DP, codes::P2090::diameter_of_centring_is_not_above_0());
        }
        if given.or_zero(DPR) != 0.0 {
            return self.refuse_argument(DPR, codes::P2090::dpr_stands_beside_centring_by_diameter());
        }
        let way = retract - reference;
        if way == 0.0 {
            return self.refuse_argument(RTP, codes::P2090::rtp_rfp_are_same());
        }
        if let Some(radius) =
            self.st.active_tool(self.settings).and_then(|tool| tool.radius).filter(|radius| diameter > 2.0 * radius)
        {
            return self.refuse_argument(DP, codes::P2090::tool_has_diameter_of_mm(&(2.0 * radius), &diameter));
        }
        let tip = self.tip_angle("a centring by its diameter")?;
        Ok(reference - way.signum() * tip_height(diameter / 2.0, Deg(tip)))
    }

    /// How far the tip of the drill lies in front of its full diameter.
    fn tip_of_drill(&self) -> Made<f64> {
        const WHAT: &str = "a depth by the shank";
        let tip = self.tip_angle(WHAT)?;
        match self.st.active_tool(self.settings).and_then(|tool| tool.radius).filter(|radius| *radius > 0.0) {
            Some(radius) => Ok(tip_height(radius, Deg(tip))),
            None => self.refuse_argument(
                GMODE,
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

    fn tip_angle(&self, what: &str) -> Made<f64> {
        match self.st.active_tool(self.settings).and_then(|tool| tool.tip_angle) {
            Some(angle) => Ok(angle),
            None => {
                let help = "give `[tools.N] tip_angle`: 118 for a common drill, 90 for a common centre drill";
                let help = self.ask_tool("tip_angle", help);
                self.refuse_argument(GMODE, codes::P2090::needs_angle_at_tip_of_tool(&what).help(help))
            }
        }
    }

    /// Seconds at the bottom, counted as the tens of `_AMODE` say.
    pub(super) fn dwell_at_depth(&self, key: Name) -> Made<f64> {
        let given = self.given;
        let value = given.or_zero(key);
        match given.digit(AMODE, 1) {
            1 if value < 0.0 => self.refuse_argument(key, codes::P2090::dwell_in_seconds_is_below_0()),
            2 => self.spindle_turns_of(key, value.abs()),
            _ => self.dwell_of(key),
        }
    }

    /// The tool axis of the plane that `_DMODE` names, where it is not the active one: the hole has no other axis.
    fn axis_of_named_plane(&self) -> Made<Axis> {
        let given = self.given;
        let plane = match given.digit(DMODE, 0) {
            1 => Plane::Xy,
            2 => Plane::Zx,
            3 => Plane::Yz,
            _ => return self.refuse_argument(DMODE, codes::S9015::this_plane_dmode_is_not_supported()),
        };
        let axis = Axis::ALL[plane.axes().2];
        if given.or_zero(AXN) != 0.0 || self.is_diameter_axis(axis) {
            return self.refuse_argument(DMODE, codes::S9015::plane_other_than_active_one());
        }
        Ok(axis)
    }

    /// Digits whose meaning is not known.
    pub(super) fn digits_of_are_known(&self, key: Name) -> Made {
        let given = self.given;
        let Some(row::Kind::Digits(digits)) = given.signature.parameter(key).map(|parameter| parameter.kind) else {
            return Ok(());
        };
        let value = given.whole(key);
        if !digits.checked || value == 0 {
            return Ok(());
        }
        if let Some((places, way)) = digits.doubt
            && places.iter().any(|place| digit(value, *place) == 1)
        {
            self.note(given.place_of(key), codes::P8106::digits_are_read_so(&given.called, &way), Kind::Each);
        }
        let known = |place: u32| digits.known.iter().find(|digit| digit.place == place);
        let most = |place: u32| known(place).map_or(0, |digit| digit.most);
        let Some(place) = (0..10).find(|place| digit(value, *place) > most(*place)) else { return Ok(()) };
        match known(place).map_or(digits.other, |digit| digit.unknown) {
            "" => {
                let (digit, name) = (digit(value, place), given.written(key));
                let fault = codes::S9015::digit_at_place_is_not_supported(&given.called, &digit, &(place + 1), &name);
                self.refuse_as_said(given.place_of(key), fault)
            }
            what => self.not_built(key, what),
        }
    }

    /// Leaves the depth that the units of `_AMODE` choose.
    pub(super) fn one_depth(&self, by: Depth, absolute: &mut Option<f64>, relative: &mut Option<f64>) -> Made {
        let given = self.given;
        // DPR 0 is none; DP 0 is a depth.
        let by_way = relative.filter(|way| *way != 0.0).is_some();
        let (chosen, other, missing) = match by {
            Depth::Classic if absolute.is_none() && relative.is_none() => {
                return self.refuse(codes::P2090::depth_is_missing_so_give_dp());
            }
            Depth::Classic => return Ok(()),
            Depth::Incremental => {
                (by_way, absolute.is_some_and(|depth| depth != 0.0), "`_AMODE` 1 takes it from DPR (argument 5)")
            }
            Depth::Absolute => (absolute.is_some(), by_way, "`_AMODE` 2 takes it from DP (argument 4)"),
        };
        if !chosen {
            return self.refuse_argument(AMODE, codes::P2090::depth_is_missing(&missing));
        }
        if other {
            let (used, left) = if by == Depth::Incremental { ("DPR", DP) } else { ("DP", DPR) };
            self.note(given.place_of(left), codes::S8018::dp_dpr_are_both_given(&given.called, &used), Kind::Each);
        }
        match by {
            Depth::Incremental => *absolute = None,
            _ => *relative = None,
        }
        Ok(())
    }

    /// The hand of a thread by the thousands of `_AMODE`, beside the sign of its pitch.
    pub(super) fn hand(&self, lead: f64) -> Made<f64> {
        let given = self.given;
        match given.digit(AMODE, 3) {
            0 => Ok(lead),
            hand if lead > 0.0 => Ok(if hand == 2 { -lead } else { lead }),
            hand => {
                let which = if hand == 2 { "left" } else { "right" };
                self.refuse_argument(AMODE, codes::P2090::pitch_is_below_0_and_thousands(&which))
            }
        }
    }
}
