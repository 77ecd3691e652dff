//! Words that have no counterpart in the output and change no move: what is said of them.
//!
//! Source: S 1.5, 2.14 and 3 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::machine::AxisSet;
use crate::parser::sinumerik::ast::{Block, Formula, Op};
use crate::text::Span;

use super::axis_names::NamedAxis;
use super::g_groups::{GCode, Group};
use super::value::Val;
use super::{Core, Outcome, Run};

impl Run<'_> {
    /// FGROUP: the axes along which F counts. Without arguments, or with the geometry axes, it is the path.
    pub(super) fn feed_axes(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        let mut named = AxisSet::EMPTY;
        for formula in formulas.iter().filter(|formula| !formula.is_missing()) {
            if let Val::Axis(NamedAxis { axis: Some(axis), .. }) = self.eval(*formula, block, text)? {
                named.insert(axis);
            }
        }
        let geometry: AxisSet = self.channel.st.machine.geometry_axes.into_iter().collect();
        if named.is_empty() || named == geometry {
            self.channel.core.dynamics_are_left_out(span);
        } else {
            self.channel.core.changes_feeds(codes::S8101::fgroup_is_left_out(), span);
        }
        Ok(())
    }

    /// WRITE, DELETE and their kin: nothing is written, and nothing is read.
    pub(super) fn file_access(
        &mut self,
        name: &str,
        formulas: &[Formula],
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        if !matches!(name, "WRITE" | "DELETE") {
            return self.channel.core.refuse(span, codes::P9011::takes_values_from_file_of_control(&name));
        }
        self.channel.core.say_once(span, codes::S8017::works_on_file_of_control(&name));
        let Some(formula) = formulas.first().filter(|formula| !formula.is_missing()) else { return Ok(()) };
        let Some(reference) = self.reference(*formula, block, text)? else {
            return match block.formula(*formula) {
                [Op::Name(name, at)] => self.undefined(*name, *at),
                _ => Ok(()),
            };
        };
        self.set_reference(reference, 0);
        let shown = match block.formula(*formula) {
            [Op::Name(name, _)] => self.channel.core.symbols.name(*name).to_owned(),
            [Op::R(n, _)] => format!("R{n}"),
            _ => "its first argument".to_owned(),
        };
        self.channel.core.say_once(formula.span, codes::S8108::error_variable_is_set_to_0(&name, &shown));
        Ok(())
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

impl Core<'_> {
    pub(super) fn dynamics_are_left_out(&self, span: Span) {
        self.say_once(span, codes::S8002::words_that_only_shape_speed());
    }

    pub(super) fn control_words_are_left_out(&self, span: Span) {
        self.say_once(span, codes::S8103::words_that_only_steer_control());
    }

    /// Does the computed path have the feed that `code` says?
    fn computes_curve_feed(&self, code: GCode) -> bool {
        self.resolves() && (code.index == 2 || self.job.settings.control.sinumerik.compensation.curve_feed)
    }

    /// A code that holds on and prints nothing. Codes that other blocks ask for are no matter of this.
    pub(super) fn left_out_code(&self, code: GCode, span: Span) {
        match code.group {
            Group::ExactStopWindow
            | Group::Acceleration
            | Group::Feedforward
            | Group::Compression
            | Group::OrientationSmoothing
            | Group::ContourAccuracy
            | Group::PathReference
            | Group::CornerDeceleration
            | Group::Dynamics => self.dynamics_are_left_out(span),
            // A path that is computed has the feed that they say.
            Group::CurveFeed if self.computes_curve_feed(code) => self.dynamics_are_left_out(span),
            _ if matches!(code, GCode::CFC | GCode::FNORM | GCode::RTLION) => self.dynamics_are_left_out(span),
            Group::CurveFeed | Group::FeedProfile => {
                let name = code.word();
                let fault = if code.group == Group::CurveFeed {
                    codes::S8101::feed_on_arcs_counts_differently(&name)
                } else {
                    codes::S8101::feed_runs_from_value_to_value(&name)
                };
                self.changes_feeds(fault, span);
            }
            Group::RapidInterpolation if self.job.diags.first_time(codes::S8102, ()) => {
                let found = codes::S8102::under_rtliof_each_axis_runs().at(self.loc(span));
                self.report(found.help("check that both ways are free, or program RTLION"));
            }
            Group::WorkingArea | Group::WorkingAreaChoice => self.limits_are_left_out(span),
            Group::ConstantCompensation | Group::SoftApproach | Group::SoftApproachPath if self.resolves() => {}
            Group::ToolWear if code.index > 1 => self.tool_data_differ(code, "turns the wear of tools", span),
            Group::FineToolOffset if code == GCode::FTOCON => {
                self.tool_data_differ(code, "lets other programs shift the tool", span);
            }
            Group::OrientationReference
            | Group::OrientationCorner
            | Group::OrientationAngles
            | Group::OrientationPath
            | Group::OrientationVector
            | Group::OrientationContinuity => {
                self.say_once(span, codes::S8104::words_for_tool_orientation_are_left_out());
            }
            group if steers_only(group) => self.control_words_are_left_out(span),
            // The others are asked for where they count.
            _ => {}
        }
    }

    fn tool_data_differ(&self, code: GCode, what: &str, span: Span) {
        let found = codes::S8010::target_has_tool_data_of_its_own(&code.word(), &what).at(self.loc(span));
        if !self.job.diags.knows(&found) {
            self.report(found);
        }
    }

    pub(super) fn limits_are_left_out(&self, span: Span) {
        self.say_once(span, codes::S8013::working_area_limits());
    }

    pub(super) fn changes_feeds(&self, fault: Fault, span: Span) {
        let found = fault.at(self.loc(span));
        if !self.job.diags.knows(&found) {
            self.report(found);
        }
    }

    /// The manuals say how positive halves are rounded.
    pub(super) fn says_negative_half(&self, value: f64, made: f64, span: Span) {
        if value >= 0.0 || value.fract() != -0.5 {
            return;
        }
        let found = codes::S8107::is_rounded_to_manuals_do_not_say(&value, &made).at(self.loc(span));
        if !self.job.diags.knows(&found) {
            self.report(found.help("keep the value off the half"));
        }
    }
}
