//! Every diagnostic code, with the text behind `partc explain`. Codes are never renumbered or reused.
//!
//! Letter: `P` general, `K` Klartext, `S` SINUMERIK, `T` HEIDENHAIN turning, `M` MTC200, `G` geometry,
//! `R` plain G-code, `O` output, `L` rules in every language. First digit: 0 lexical, 1 syntax, 2 meaning, 3 geometry, 4 limits, 8 lint, 9 unsupported.

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
mod layers;
mod lint_motion;
mod lint_source;
mod milling;
mod mtc200;
mod output;
mod pockets;
mod sinumerik;
mod sinumerik_unsupported;
mod sinumerik_warnings;
mod transformation;
mod turning;

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
pub use layers::*;
pub use lint_motion::*;
pub use lint_source::*;
pub use milling::*;
pub use mtc200::*;
pub use output::*;
pub use pockets::*;
pub use sinumerik::*;
pub use sinumerik_unsupported::*;
pub use sinumerik_warnings::*;
pub use transformation::*;
pub use turning::*;

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
    /// One line: what it is about.
    pub title: &'static str,
    /// The text of `partc explain`: what it means on the machine, how to mend it, where it comes from; empty without the feature
    /// `explain`.
    pub explain: &'static str,
}

/// The first case of each code in the golden books, written by the test suite.
const EXAMPLES: &str = include_str!("examples.txt");

/// Warnings and notes that say that the path, or what the machine does, is not what the blocks say.
const FIRM: &[&str] =
    &["G3009", "G3025", "G3210", "G3211", "G3212", "G8101", "K2851", "K2854", "P0006", "P0201", "S8130"];

impl Code {
    /// Can nobody ignore it: is it an error, or does it say that the tool goes another way than programmed?
    pub fn is_firm(&self) -> bool {
        self.severity == Severity::Error || FIRM.contains(&self.id)
    }

    /// A program in which it is found: parts that begin with `-- ` and a name.
    pub fn example(&self) -> Option<&'static str> {
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
const fn told(text: &'static str) -> &'static str {
    if cfg!(feature = "explain") { text } else { "" }
}

/// Writes a table of codes as constants plus the list of them all. Behind the severity `off` says that a code is found where
/// somebody asks for it only.
macro_rules! codes {
    (@on) => { true };
    (@on off) => { false };
    ($list:ident: $($id:ident $severity:ident $($off:ident)? $name:literal $title:literal $explain:literal)*) => {
        $(pub const $id: &$crate::diag::Code = &$crate::diag::Code {
            id: stringify!($id),
            name: $name,
            severity: $crate::diag::Severity::$severity,
            on: $crate::diag::codes::codes!(@on $($off)?),
            title: $title,
            explain: $crate::diag::codes::told($explain),
        };)*
        pub(super) const $list: &[&$crate::diag::Code] = &[$($id),*];
    };
}
use codes;

/// Every code, in order of its id.
pub fn all() -> Vec<&'static Code> {
    let mut list: Vec<_> = [
        general::GENERAL,
        gcode::GCODE,
        klartext::KLARTEXT,
        klartext_cycles::KLARTEXT_CYCLES,
        klartext_free_contours::KLARTEXT_FREE_CONTOURS,
        klartext_machining::KLARTEXT_MACHINING,
        klartext_readings::KLARTEXT_READINGS,
        geometry::GEOMETRY,
        grooves::GROOVES,
        compensation::COMPENSATION,
        output::OUTPUT,
        pockets::POCKETS,
        sinumerik::SINUMERIK,
        sinumerik_warnings::SINUMERIK_WARNINGS,
        sinumerik_unsupported::SINUMERIK_UNSUPPORTED,
        transformation::TRANSFORMATION,
        layers::LAYERS,
        lint_motion::LINT_MOTION,
        lint_source::LINT_SOURCE,
        turning::TURNING,
        milling::MILLING,
        mtc200::MTC200,
    ]
    .iter()
    .flat_map(|table| table.iter().copied())
    .collect();
    list.sort_by_key(|code| code.id);
    list
}

/// Finds a code by its id or name, upper or lower case.
pub fn find(id: &str) -> Option<&'static Code> {
    static KNOWN: OnceLock<FxHashMap<String, &'static Code>> = OnceLock::new();
    let known = KNOWN.get_or_init(|| {
        all().into_iter().flat_map(|code| [code.id, code.name].map(|id| (id.to_ascii_lowercase(), code))).collect()
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
