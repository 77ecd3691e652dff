//! Words that have no counterpart in the output and change no move: what is said of them.
//!
//! Source: S 1.5, 2.14 and 3 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::machine::{Axis, AxisSet};
use crate::text::Span;

use super::Core;
use super::g_groups::{GCode, Group};
use super::value::Val;
use super::vocabulary::Procedure;

/// FGROUP: the axes along which F counts. Without arguments, or with the geometry axes, it is the path.
pub(super) fn said_of_feed_axes(values: &[Val], geometry: [Axis; 3]) -> LeftOut {
    let axis_of = |value: &Val| match value {
        Val::Axis(named) => named.axis,
        _ => None,
    };
    let named: AxisSet = values.iter().filter_map(axis_of).collect();
    if named.is_empty() || named == geometry.into_iter().collect() {
        LeftOut::Once(codes::S8002::words_that_only_shape_speed())
    } else {
        LeftOut::Here(codes::S8101::fgroup_is_left_out())
    }
}

/// Groups that steer the control. SAR, splines, punching, transformations and frames of the tool are refused themselves.
fn steers_only(group: Group) -> bool {
    matches!(
        group,
        Group::Buffer
            | Group::SplineStart
            | Group::SplineEnd
            | Group::RepositioningPoint
            | Group::FineToolOffset
            | Group::Punching
            | Group::PunchingDelay
            | Group::PunchingOutput
            | Group::ConstantCompensation
            | Group::ThreadInterruption
            | Group::ToolCarrier
            | Group::SoftApproach
            | Group::SoftApproachPath
            | Group::RetractionPlane
            | Group::CodeMode
            | Group::PointToPoint
            | Group::WorkpieceFrame
            | Group::ToolFrame
            | Group::ToolWear
            | Group::SoftwareLimit
            | Group::RepositioningPointBlock
    )
}

/// What is said of a word that has no counterpart in the output.
pub(super) enum LeftOut {
    /// Said once for the whole program.
    Once(Fault),
    /// Said at each place.
    Here(Fault),
}

impl LeftOut {
    pub fn say(self, core: &Core<'_>, span: Span) {
        match self {
            LeftOut::Once(fault) => core.say_once(span, fault),
            LeftOut::Here(fault) => core.report_new(fault.at(core.loc(span))),
        }
    }

    /// What is said of a procedure that changes nothing of the path; `None` for one that does something.
    pub fn of_procedure(procedure: Procedure, name: &str) -> Option<LeftOut> {
        use LeftOut::{Here, Once};
        Some(match procedure {
            Procedure::NoEffect => Once(codes::S8103::words_that_only_steer_control()),
            Procedure::WheelSpeed => Here(codes::S8101::speed_of_wheel_is_left_out(&name)),
            Procedure::Dynamics if !matches!(name, "FGROUP" | "CYCLE832") => {
                Once(codes::S8002::words_that_only_shape_speed())
            }
            Procedure::Channel => Once(codes::S8015::words_that_synchronize_channels_are_left_out()),
            Procedure::Actions => Once(codes::S8170::acts_on_synchronized_actions(&name)),
            Procedure::Interrupt => Once(codes::S8016::interrupt_programs_are_left_out()),
            _ => return None,
        })
    }
}

impl GCode {
    /// What is said of a code that is modal and prints nothing; `None` where other blocks ask for it, or where it means what is done
    /// anyway. A path that is `computed` has the feed that they say; `curve_feed` where it has that of all arcs.
    pub(super) fn left_out(self, computed: bool, curve_feed: bool) -> Option<LeftOut> {
        use LeftOut::{Here, Once};
        let feed_is_computed = computed && (self.index == 2 || curve_feed);
        Some(match self.group {
            Group::ExactStopWindow
            | Group::Acceleration
            | Group::Feedforward
            | Group::Compression
            | Group::OrientationSmoothing
            | Group::ContourAccuracy
            | Group::PathReference
            | Group::CornerDeceleration
            | Group::Dynamics => Once(codes::S8002::words_that_only_shape_speed()),
            Group::CurveFeed if feed_is_computed => Once(codes::S8002::words_that_only_shape_speed()),
            _ if matches!(self, GCode::CFC | GCode::FNORM | GCode::RTLION) => {
                Once(codes::S8002::words_that_only_shape_speed())
            }
            Group::CurveFeed => Here(codes::S8101::feed_on_arcs_counts_differently(&self.word())),
            Group::FeedProfile => Here(codes::S8101::feed_runs_from_value_to_value(&self.word())),
            Group::RapidInterpolation => {
                let fault = codes::S8102::under_rtliof_each_axis_runs();
                Once(fault.help("check that both ways are free, or program RTLION"))
            }
            Group::WorkingArea | Group::WorkingAreaChoice => Once(codes::S8013::working_area_limits()),
            Group::ConstantCompensation | Group::SoftApproach | Group::SoftApproachPath if computed => return None,
            Group::ToolWear if self.index > 1 => {
                Here(codes::S8010::target_has_tool_data_of_its_own(&self.word(), &"turns the wear of tools"))
            }
            Group::FineToolOffset if self == GCode::FTOCON => {
                Here(codes::S8010::target_has_tool_data_of_its_own(&self.word(), &"lets other programs shift the tool"))
            }
            Group::OrientationReference
            | Group::OrientationCorner
            | Group::OrientationAngles
            | Group::OrientationPath
            | Group::OrientationVector
            | Group::OrientationContinuity => Once(codes::S8104::words_for_tool_orientation_are_left_out()),
            group if steers_only(group) => Once(codes::S8103::words_that_only_steer_control()),
            _ => return None,
        })
    }
}
