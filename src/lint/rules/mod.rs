//! The rules: a file and a line each.

mod arc_tiny;
mod behind_centre;
mod behind_end;
mod blank_untouched;
mod change_in_cut;
mod comment_is_code;
mod coolant_left_on;
mod cut_backwards;
mod cut_before_tool;
mod cut_below_blank;
mod cut_beside_blank;
mod cut_dry;
mod diameter_left;
mod drill_sideways;
mod dwell_long;
mod dwell_zero;
mod far_coordinates;
mod feed_huge;
mod feed_outlier;
mod feed_tiny;
mod foreign_letters;
mod incremental_left;
mod label_alike;
mod label_unused;
mod line_end_missing;
mod number_order;
mod number_precision;
mod offset_compensated;
mod plane_left;
mod plunge_at_feed;
mod pole_elsewhere;
mod rapid_into_blank;
mod rapid_slanting_down;
mod redundant_word;
mod skip_mark;
mod slow_retract;
mod speed_huge;
mod speed_unlimited;
mod spindle_off;
mod spindle_reversed;
mod start_without_speed;
mod stop_in_cut;
mod tap_pitch;
mod thread_crossed;
mod tool_called_again;
mod tool_data_missing;
mod tool_unused;
mod tool_without_speed;
mod unfinished;
mod units_mixed;
mod unreachable;
mod variable_unread;

use crate::diag::{Code, codes};

use super::motion::{MotionRule, Setup};
use super::source::SourceRule;

/// How a rule is made.
pub enum Make {
    /// It looks on while the program runs.
    Motion(for<'a> fn(&Setup<'a>) -> Box<dyn MotionRule + 'a>),
    /// It reads the blocks.
    Source(for<'a> fn(&Setup<'a>) -> Box<dyn SourceRule + 'a>),
}

impl std::fmt::Debug for Make {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(if matches!(self, Make::Motion(_)) { "motion" } else { "source" })
    }
}

/// A rule, by the code of what it finds.
#[derive(Debug)]
pub struct Rule {
    pub code: &'static Code,
    pub make: Make,
}

macro_rules! rules {
    ($($kind:ident $code:ident $module:ident::$rule:ident,)+) => {
        /// All rules.
        pub const RULES: &[Rule] = &[
            $(Rule { code: codes::$code, make: Make::$kind(|setup| Box::new($module::$rule::new(setup))) },)+
        ];
    };
}

rules! {
    Motion L1001 spindle_off::SpindleOff,
    Motion L1002 start_without_speed::StartWithoutSpeed,
    Motion L1003 tool_without_speed::ToolWithoutSpeed,
    Motion L1004 tool_unused::ToolUnused,
    Motion L1005 tool_called_again::ToolCalledAgain,
    Motion L1006 rapid_into_blank::RapidIntoBlank,
    Motion L1007 cut_below_blank::CutBelowBlank,
    Motion L1009 coolant_left_on::CoolantLeftOn,
    Motion L1010 cut_dry::CutDry,
    Motion L1011 dwell_zero::DwellZero,
    Motion L1012 dwell_long::DwellLong,
    Motion L1013 far_coordinates::FarCoordinates,
    Motion L1014 plunge_at_feed::PlungeAtFeed,
    Motion L1015 feed_tiny::FeedTiny,
    Motion L1016 feed_huge::FeedHuge,
    Motion L1017 speed_huge::SpeedHuge,
    Motion L1018 change_in_cut::ChangeInCut,
    Motion L1019 rapid_slanting_down::RapidSlantingDown,
    Motion L1020 cut_backwards::CutBackwards,
    Motion L1022 cut_before_tool::CutBeforeTool,
    Motion L1023 tool_data_missing::ToolDataMissing,
    Motion L1024 arc_tiny::ArcTiny,
    Motion L1025 plane_left::PlaneLeft,
    Motion L1026 behind_centre::BehindCentre,
    Motion L1027 speed_unlimited::SpeedUnlimited,
    Motion L1028 slow_retract::SlowRetract,
    Motion L1029 stop_in_cut::StopInCut,
    Motion L1030 offset_compensated::OffsetCompensated,
    Motion L1031 spindle_reversed::SpindleReversed,
    Motion L1032 blank_untouched::BlankUntouched,
    Motion L1033 feed_outlier::FeedOutlier,
    Motion L1034 drill_sideways::DrillSideways,
    Motion L1035 tap_pitch::TapPitch,
    Motion L1036 thread_crossed::ThreadCrossed,
    Motion L1037 cut_beside_blank::CutBesideBlank,
    Source L2001 label_unused::LabelUnused,
    Source L2002 unreachable::Unreachable,
    Source L2003 behind_end::BehindEnd,
    Source L2004 variable_unread::VariableUnread,
    Source L2005 number_order::NumberOrder,
    Source L2006 label_alike::LabelAlike,
    Source L2007 comment_is_code::CommentIsCode,
    Source L2008 redundant_word::RedundantWord,
    Source L2009 incremental_left::IncrementalLeft,
    Source L2010 units_mixed::UnitsMixed,
    Source L2011 line_end_missing::LineEndMissing,
    Source L2012 number_precision::NumberPrecision,
    Source L2013 unfinished::Unfinished,
    Source L2014 skip_mark::SkipMark,
    Source L2015 foreign_letters::ForeignLetters,
    Source L2016 pole_elsewhere::PoleElsewhere,
    Source L2017 diameter_left::DiameterLeft,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_of_a_rule_has_its_rule() {
        let rules: Vec<&str> = RULES.iter().map(|rule| rule.code.id).collect();
        let all = codes::all();
        let found: Vec<&str> = all.iter().map(|code| code.id).filter(|id| id.starts_with('L')).collect();
        assert_eq!(rules, found);
    }
}
