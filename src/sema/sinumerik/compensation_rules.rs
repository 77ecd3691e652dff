//! The rules of the radius compensation that the compiler computes, as the codes in force say them.
//!
//! Source: S 2.12, S 2.13 (docs/sources.md); docs/compensation.md.

use crate::diag::{Answer, Fault, codes};
use crate::geo::{Deg, SAME_DIRECTION, Vec2};
use crate::ir::compensation::{Alarms, Border, Ends, FeedAt, Inside, Outside, Search};
use crate::ir::{self, Ask};
use crate::machine::Settings;

use super::State;
use super::compensation::Cutter;
use super::g_groups::{GCode, Group};

/// The control's own alarms.
const ALARMS: Alarms = Alarms {
    no_room: Some(10751),
    left_out: Some(10763),
    start_inside: Some(10755),
    end_inside: Some(10756),
    plane: Some(10757),
    no_line: Some(10753),
};
/// Flat corners at which controls may not make an arc under G450 (MD 20230): what its default is said to be.
const FLAT: Deg = Deg(10.0);
/// Turn up to which G451 prolongs (MD 20210).
const LIMIT: Deg = Deg(100.0);
/// The corners that the machine data decide.
const CORNERS: Ask = Ask::key("control", "g451_limit", CORNERS_HELP);
const CORNERS_HELP: &str =
    "give the limits of the machine: `[control] g451_limit` (MD 20210) and `g450_flat` (MD 20230), in degrees";
/// Where F counts on an arc.
const CURVE_FEED: Ask = Ask::key("control", "curve_feed", CURVE_FEED_HELP);
const CURVE_FEED_HELP: &str = "for the feed of the control set `[control] curve_feed = \"control\"`, or program CFTCP if F is meant for the centre";

/// How the path goes around outer corners: by an arc, or by crossings; `flat` and `limit` in degrees, as the machine data say.
fn outer_corners(round: bool, flat: Option<f64>, limit: Option<f64>) -> Outside {
    if round {
        let open = flat.is_none().then_some((Deg(0.0), FLAT, &CORNERS));
        return Outside { prolonged: Deg(flat.unwrap_or(0.0)), open, by: None };
    }
    let prolonged = Deg(limit.unwrap_or(LIMIT.0));
    Outside { prolonged, open: limit.is_none().then_some((prolonged, Deg(180.0), &CORNERS)), by: None }
}

impl State {
    /// The rules for a path that a cycle makes: it comes to the contour by itself, and damages nothing of it.
    pub(super) fn rules_of_cycle(
        &self,
        radius: f64,
        settings: &Settings,
    ) -> Result<(ir::Compensation, Option<Fault>), Fault> {
        let (rules, disc) = self.rules(Cutter { radius, nose: Vec2::zeros() }, settings)?;
        let search = Search { bottlenecks: true, ..rules.search };
        let (approach, retract) = (Border::Perpendicular, Border::Perpendicular);
        Ok((ir::Compensation { radius, approach, retract, search, constant: false, ..rules }, disc))
    }

    /// The rules in force for a cutter, and what is worth saying of a disc.
    pub(super) fn rules(
        &self,
        cutter: Cutter,
        settings: &Settings,
    ) -> Result<(ir::Compensation, Option<Fault>), Fault> {
        self.plane_is_straight()?;
        let codes_on = &self.codes;
        let round = codes_on.of(Group::Corner).index == 1;
        let border = match codes_on.of(Group::Approach) {
            GCode::NORM => Border::Perpendicular,
            GCode::KONT if round => Border::Around,
            GCode::KONT => Border::AroundOtherwise,
            code => {
                return Err(codes::P9013::leads_to_contour(&code.word()));
            }
        };
        let keys = &settings.control.sinumerik.compensation;
        let mut disc = None;
        if self.path.overshoot() > 0.0 {
            if !keys.disc_as_circle {
                return Err(codes::P9013::under_disc_tool_goes_around_corners(&self.path.overshoot())
                    .answer(Answer::key("control", "disc").one_of(&["\"circle\""])));
            }
            disc = Some(codes::S8193::disc_is_read_as_disc_0(&self.path.overshoot()));
        }
        let ends = match codes_on.of(Group::CompensationEnds).index {
            2 => Ends::Circle,
            3 => Ends::Tangent,
            _ => Ends::AsTheyAre,
        };
        let rules = ir::Compensation {
            radius: self.path.radius(),
            nose: cutter.nose,
            approach: border,
            retract: border,
            outside: outer_corners(round, keys.flat, keys.limit),
            inside: Inside::Crossing,
            search: Search { elements: keys.look_ahead, bottlenecks: codes_on.of(Group::Collision) == GCode::CDON },
            ends,
            constant: codes_on.is(GCode::CUTCONON),
            rounded_border: false,
            feed: match codes_on.of(Group::CurveFeed) {
                code if code.index == 2 => FeedAt::Centre,
                _ if !keys.curve_feed => FeedAt::CentreInstead(&CURVE_FEED),
                GCode::CFC => FeedAt::Contour,
                _ => FeedAt::HollowContour,
            },
            is_way: false,
            own_corner: false,
            joints_are_documented: true,
            alarms: ALARMS,
        };
        Ok((rules, disc))
    }

    /// The radius counts in the plane of the tool: a frame may turn and move in it only.
    fn plane_is_straight(&self) -> Result<(), Fault> {
        let (first, second, third) = self.plane().axes();
        let linear = self.ctx.frame.linear();
        let tilts = |a: usize| linear[(third, a)].abs() > SAME_DIRECTION || linear[(a, third)].abs() > SAME_DIRECTION;
        if !self.ctx.frame.is_shift() && (tilts(first) || tilts(second)) {
            return Err(codes::P9013::frame_tilts_working_plane());
        }
        Ok(())
    }
}
