//! Every diagnostic code, with the text behind `partc explain`. Codes are never renumbered or reused.
//!
//! Letter: `P` general, and facts that several languages share, `K` Klartext, `S` SINUMERIK, `T` HEIDENHAIN turning, `M` MTC200, `G` geometry,
//! `R` plain G-code, `O` output, `L` rules in every language, which stand with their
//! checks in `lint::rules`. First digit: 0 lexical, 1 syntax, 2 meaning, 3 geometry, 4 limits, 8 lint, 9 unsupported.

mod compensation;
mod gcode;
mod general;
mod geometry;
mod grooves;
mod klartext;
mod klartext_cycles;
mod klartext_free_contours;
mod klartext_machining;
mod klartext_readings;
mod klartext_transformations;
mod klartext_unsupported;
mod layers;
mod milling;
mod mtc200;
mod output;
mod pockets;
mod shared_cycles;
mod shared_cycles_unsupported;
mod shared_form;
mod shared_meaning;
mod shared_others;
mod sinumerik;
mod sinumerik_arcs;
mod sinumerik_left_out;
mod sinumerik_unsupported;
mod sinumerik_warnings;
mod target;
mod transformation;
mod turning;
mod turning_geometry;

pub use compensation::*;
pub use gcode::*;
pub use general::*;
pub use geometry::*;
pub use grooves::*;
pub use klartext::*;
pub use klartext_cycles::*;
pub use klartext_free_contours::*;
pub use klartext_machining::*;
pub use klartext_readings::*;
pub use klartext_transformations::*;
pub use klartext_unsupported::*;
pub use layers::*;
pub use milling::*;
pub use mtc200::*;
pub use output::*;
pub use pockets::*;
pub use shared_cycles::*;
pub use shared_cycles_unsupported::*;
pub use shared_form::*;
pub use shared_meaning::*;
pub use shared_others::*;
pub use sinumerik::*;
pub use sinumerik_arcs::*;
pub use sinumerik_left_out::*;
pub use sinumerik_unsupported::*;
pub use sinumerik_warnings::*;
pub use target::*;
pub use transformation::*;
pub use turning::*;
pub use turning_geometry::*;

use std::sync::OnceLock;

use rustc_hash::FxHashMap;

use super::Severity;

/// A diagnostic code. Identity is the `id`.
#[derive(Debug, PartialEq, Eq)]
pub struct Code {
    /// Letter and four digits.
    pub id: &'static str,
    /// The same in words, for lists and configuration.
    pub name: &'static str,
    pub severity: Severity,
    /// Is it reported where nobody asks for it?
    pub on: bool,
    /// Does it say, though no error, that the path, or what the machine does, is not what the blocks say?
    pub firm: bool,
    /// One line: what it is about.
    pub title: &'static str,
    /// Codes and names that it had before, when each language had its own; they are taken wherever a code is.
    pub was: &'static str,
    /// What to do about most findings of it in Klartext, where a finding brings no help of its own; empty where nothing is usual.
    pub usual: &'static str,
    /// The text of `partc explain`: what it means on the machine, how to mend it, where it comes from; empty without the feature
    /// `explain`.
    pub explain: &'static str,
    /// What is said of the faults that it stands for.
    pub wordings: &'static [super::fault::Wording],
    /// The example that stands with a rule, as [`Code::example`] gives it; those of other codes are in `examples.txt`.
    pub of_rule: &'static str,
}

/// The first case of each code in the golden books, written by the test suite.
const EXAMPLES: &str = include_str!("examples.txt");

impl Code {
    /// Does its id, or one that it had before, begin so?
    pub fn begins_with(&self, prefix: &str) -> bool {
        let before = self.was.split_ascii_whitespace();
        self.id.starts_with(prefix) || before.into_iter().any(|id| id.starts_with(prefix))
    }

    /// Can nobody ignore it: is it an error, or does it say that the tool goes another way than programmed?
    pub fn is_firm(&self) -> bool {
        self.severity == Severity::Error || self.firm
    }

    /// A program in which it is found: parts that begin with `-- ` and a name.
    pub fn example(&self) -> Option<&'static str> {
        if !self.of_rule.is_empty() {
            return Some(self.of_rule.trim_ascii());
        }
        let (_, found) = EXAMPLES.split_once(&format!("=== {}\n", self.id))?;
        Some(found.split_once("\n=== ").map_or(found, |(own, _)| own).trim_end())
    }

    /// The code together with the alarm that the control itself shows, where it shows one.
    pub fn alarm(&'static self, number: impl Into<Option<u32>>) -> Raised {
        let alarm = number.into();
        debug_assert!(alarm != Some(0), "no alarm is none");
        Raised { code: self, alarm }
    }
}

/// A code as it is raised in one place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Raised {
    pub code: &'static Code,
    /// The number that the control itself shows.
    pub alarm: Option<u32>,
}

impl From<&'static Code> for Raised {
    fn from(code: &'static Code) -> Raised {
        Raised { code, alarm: None }
    }
}

/// Texts of `partc explain` are a twelfth of what a page loads, which shows none of them.
pub(crate) const fn told(text: &'static str) -> &'static str {
    if cfg!(feature = "explain") { text } else { "" }
}

pub(crate) const fn told_of(wordings: &'static [super::fault::Wording]) -> &'static [super::fault::Wording] {
    if cfg!(feature = "explain") { wordings } else { &[] }
}

/// Writes a table of codes as constants plus the list of them all, and the faults that each code has, as functions of a type of its name.
/// Behind the severity `off` says that a code is found where somebody asks for it only, and `firm` that nobody can ignore it.
///
/// A fault is a name with its quantities, the message, the alarm of the control, and what to do: `help`, or `asks` where a key of
/// `partc.toml` answers it. Behind `+` stand helps that only the place can choose, and how a help goes on.
macro_rules! codes {
    (@on) => { true };
    (@on firm) => { true };
    (@on off) => { false };
    (@firm firm) => { true };
    (@firm $(off)?) => { false };
    (@alarm) => { None };
    (@alarm $number:literal) => { Some($number) };
    (@text) => { "" };
    (@text $text:literal) => { $text };
    (@fault $id:ident $fault:ident ($($of:ident),*) $message:literal [$($alarm:literal)?] [$($help:literal)?] []) => {
        #[allow(clippy::useless_format, reason = "a fault without quantities has nothing to fill in")]
        pub fn $fault($($of: &dyn std::fmt::Display),*) -> $crate::diag::Fault {
            $(const _: () = assert!(!$crate::diag::fault::quotes_key($help), "a help that names a key asks for it");)?
            let raised = $id.alarm($crate::diag::codes::codes!(@alarm $($alarm)?));
            $crate::diag::Fault::new(raised, format!($message))$(.help(format!($help)))?
        }
    };
    (@fault $id:ident $fault:ident ($($of:ident),*) $message:literal [$($alarm:literal)?] [] [$asks:literal]) => {
        #[allow(clippy::useless_format, reason = "a fault without quantities has nothing to fill in")]
        pub fn $fault($($of: &dyn std::fmt::Display),*) -> $crate::diag::fault::Asking {
            let raised = $id.alarm($crate::diag::codes::codes!(@alarm $($alarm)?));
            $crate::diag::fault::Asking::new($crate::diag::Fault::new(raised, format!($message)).help(format!($asks)))
        }
    };
    (@entry $id:ident $severity:ident [$($mark:ident)?] $name:literal $title:literal [$($was:literal)?] [$($usual:literal)?]
        $explain:literal [$($example:literal)?] $({$(
        $fault:ident ($($of:ident),*) $message:literal $(alarm $alarm:literal)? $(help $help:literal)? $(asks $asks:literal)?;
    )* $(+ $more:ident ($($part:ident),*) $text:literal;)*})?) => {
        pub const $id: &$crate::diag::Code = &$crate::diag::Code {
            id: stringify!($id),
            name: $name,
            severity: $crate::diag::Severity::$severity,
            on: $crate::diag::codes::codes!(@on $($mark)?),
            firm: $crate::diag::codes::codes!(@firm $($mark)?),
            title: $title,
            of_rule: $crate::diag::codes::told($crate::diag::codes::codes!(@text $($example)?)),
            was: $crate::diag::codes::codes!(@text $($was)?),
            usual: $crate::diag::codes::codes!(@text $($usual)?),
            explain: $crate::diag::codes::told($explain),
            wordings: $crate::diag::codes::told_of(&[$($($crate::diag::fault::Wording {
                name: stringify!($fault),
                message: $message,
                help: $crate::diag::codes::codes!(@text $($help)? $($asks)?),
                alarm: $crate::diag::codes::codes!(@alarm $($alarm)?),
            }),*)?]),
        };
        $(
            #[derive(Debug)]
            pub enum $id {}
            impl $id {
                $($crate::diag::codes::codes! {
                    @fault $id $fault ($($of),*) $message [$($alarm)?] [$($help)?] [$($asks)?]
                })*
                $(pub fn $more($($part: &dyn std::fmt::Display),*) -> String {
                    format!($text)
                })*
            }
        )?
    };
    ($list:ident: $($id:ident $severity:ident $($mark:ident)? $name:literal $title:literal $(was $was:literal)?
        $(usual $usual:literal)? $explain:literal $({$($faults:tt)*})?)*) => {
        $($crate::diag::codes::codes! {
            @entry $id $severity [$($mark)?] $name $title [$($was)?] [$($usual)?] $explain [] $({$($faults)*})?
        })*
        pub(super) const $list: &[&$crate::diag::Code] = &[$($id),*];
    };
}
pub(crate) use codes;

/// Every code, in order of its id.
pub fn all() -> Vec<&'static Code> {
    let mut list: Vec<_> = [
        general::GENERAL,
        gcode::GCODE,
        klartext::KLARTEXT,
        klartext_transformations::KLARTEXT_TRANSFORMATIONS,
        klartext_unsupported::KLARTEXT_UNSUPPORTED,
        klartext_cycles::KLARTEXT_CYCLES,
        klartext_free_contours::KLARTEXT_FREE_CONTOURS,
        klartext_machining::KLARTEXT_MACHINING,
        klartext_readings::KLARTEXT_READINGS,
        geometry::GEOMETRY,
        grooves::GROOVES,
        compensation::COMPENSATION,
        output::OUTPUT,
        target::TARGET,
        pockets::POCKETS,
        shared_form::SHARED_FORM,
        shared_meaning::SHARED_MEANING,
        shared_cycles::SHARED_CYCLES,
        shared_cycles_unsupported::SHARED_CYCLES_UNSUPPORTED,
        shared_others::SHARED_OTHERS,
        sinumerik::SINUMERIK,
        sinumerik_arcs::SINUMERIK_ARCS,
        sinumerik_left_out::SINUMERIK_LEFT_OUT,
        sinumerik_warnings::SINUMERIK_WARNINGS,
        sinumerik_unsupported::SINUMERIK_UNSUPPORTED,
        transformation::TRANSFORMATION,
        layers::LAYERS,
        turning::TURNING,
        turning_geometry::TURNING_GEOMETRY,
        milling::MILLING,
        mtc200::MTC200,
    ]
    .iter()
    .flat_map(|table| table.iter().copied())
    .chain(crate::codes_of_rules())
    .collect();
    list.sort_by_key(|code| code.id);
    list
}

/// Finds a code by its id or name, or one that it had before, upper or lower case.
pub fn find(id: &str) -> Option<&'static Code> {
    static KNOWN: OnceLock<FxHashMap<String, &'static Code>> = OnceLock::new();
    let known = KNOWN.get_or_init(|| {
        let names = |code: &'static Code| [code.id, code.name].into_iter().chain(code.was.split_ascii_whitespace());
        all().into_iter().flat_map(|code| names(code).map(move |name| (name.to_ascii_lowercase(), code))).collect()
    });
    known.get(&id.to_ascii_lowercase()).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_and_names_are_unique_and_every_code_is_explained() {
        let all = all();
        for pair in all.windows(2) {
            assert_ne!(pair[0].id, pair[1].id);
        }
        for code in &all {
            assert_eq!(all.iter().filter(|c| c.name == code.name).count(), 1, "{}", code.name);
            assert!(code.id.len() == 5 && code.id[1..].bytes().all(|b| b.is_ascii_digit()), "{}", code.id);
            assert!(code.explain.len() > 80, "{} needs an explanation", code.id);
            assert!(!code.title.ends_with('.'), "{}", code.id);
        }
    }
}
