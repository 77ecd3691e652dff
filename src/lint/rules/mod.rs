//! The rules: a file each, with what, why, an example and the check, and a line here.

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

use crate::diag::Code;

/// `partc check --fix` numbers blocks anew where it is found.
#[cfg(feature = "cli")]
pub use number_order::L2005;

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

/// A rule in its file: its code, how it is made, what `partc explain` says of it, and what it says itself, as in the catalogue of
/// `diag::codes`.
macro_rules! rule {
    ($code:ident $kind:ident $rule:ident $severity:ident $($off:ident)? $name:literal what $what:literal why $why:literal
        example $example:literal says {$($faults:tt)*}) => {
        $crate::diag::codes::codes! {
            @entry $code $severity [$($off)?] $name $what [] [] $why [$example] {$($faults)*}
        }

        pub(super) const RULE: $crate::lint::rules::Rule = $crate::lint::rules::Rule {
            code: $code,
            make: $crate::lint::rules::Make::$kind(|setup| Box::new($rule::new(setup))),
        };
    };
}
use rule;

/// All rules in order of their codes: `build.rs` lists the files of this folder.
pub const RULES: &[Rule] = include!(concat!(env!("OUT_DIR"), "/rules.rs"));

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::codes;

    #[test]
    fn rules_stand_in_order_and_the_catalogue_knows_each() {
        assert!(RULES.len() > 50 && RULES.is_sorted_by(|a, b| a.code.id < b.code.id));
        let rules: Vec<&str> = RULES.iter().map(|rule| rule.code.id).collect();
        let all = codes::all();
        let found: Vec<&str> = all.iter().map(|code| code.id).filter(|id| id.starts_with('L')).collect();
        assert_eq!(rules, found);
    }

    #[cfg(feature = "explain")]
    #[test]
    fn each_rule_says_what_why_an_example_and_its_words() {
        for code in RULES.iter().map(|rule| rule.code) {
            assert!(code.of_rule.starts_with("\n-- Example (") && !code.wordings.is_empty(), "{}", code.id);
        }
    }
}
