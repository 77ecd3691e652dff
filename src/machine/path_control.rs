//! How a machine takes corners: what programs say of it, what the user wants, and what a target prints for both.

use crate::target::PathWords;

/// How the path is left at corners.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PathControl {
    /// Every block ends on its corner.
    Exact,
    /// Corners are rounded off, by so many mm off the programmed path at most; above zero.
    Within(f64),
    /// Rounding off begins so many mm in front of the corner, not earlier; above zero.
    Before(f64),
    /// Corners are passed without a stop, and nobody says how far off.
    Unbounded,
}

/// What the configuration says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathChoice {
    Exact,
    /// Millionths of a mm.
    Within(u32),
    /// Nothing is printed of it.
    None,
}

/// The bound where nobody says another one, in mm.
pub const USUAL: f64 = 0.01;

/// A blend that begins so far in front of a corner leaves the path by this part of it at most: the parabola from one leg to
/// the other passes halfway between the corner and its chord, `d / 2 * cos(a)` from the corner and, with half the angle
/// `a` between the legs, `d / 2 * cos(a) * sin(a) <= d / 4` from each leg.
const OF_DISTANCE: f64 = 0.25;

/// What is printed for what the program says of its corners, `None` where it has no say. No answer: nothing is printed.
///
/// A program that passes corners without a bound leaves that to the control: there the configuration decides, and the
/// output has a bound wherever the target has a word for one.
pub(super) fn printed(
    words: &PathWords,
    choice: Option<PathChoice>,
    said: Option<PathControl>,
    lathe: bool,
) -> Option<PathControl> {
    let bound = match choice {
        Some(PathChoice::None) => return None,
        Some(PathChoice::Within(millionths)) => f64::from(millionths) / 1e6,
        Some(PathChoice::Exact) | None => USUAL,
    };
    let bounded = |mm| words.within.map(|_| PathControl::Within(mm));
    let exact = words.exact.map(|_| PathControl::Exact);
    let unbounded = words.unbounded.map(|_| PathControl::Unbounded);
    match said {
        Some(PathControl::Exact) => exact.or_else(|| bounded(bound)),
        Some(PathControl::Within(mm)) => bounded(mm).or(unbounded),
        Some(PathControl::Before(_)) if words.before.is_some() => said,
        Some(PathControl::Before(mm)) => bounded(mm * OF_DISTANCE).or(unbounded),
        Some(PathControl::Unbounded) if choice == Some(PathChoice::Exact) => exact,
        Some(PathControl::Unbounded) => bounded(bound).or(unbounded),
        None => match choice {
            Some(PathChoice::Exact) => exact,
            Some(_) => bounded(bound),
            None if lathe && words.exact_on_lathes => exact,
            None => bounded(bound).or_else(|| unbounded.filter(|_| words.starts_unbounded)),
        },
    }
}

/// Has the target a word for what the configuration says?
pub(super) fn can_say(words: &PathWords, choice: Option<PathChoice>) -> bool {
    match choice {
        Some(PathChoice::Exact) => words.exact.is_some(),
        Some(PathChoice::Within(_)) => words.within.is_some(),
        Some(PathChoice::None) | None => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::target;

    #[test]
    fn what_the_program_says_wins_where_the_target_can_say_it() {
        use PathControl::{Before, Exact, Unbounded, Within};
        let printed = |name: &str, choice, said, lathe| {
            let target = target::find(name).expect("a target");
            super::printed(&target.path, choice, said, lathe)
        };
        let within = Some(PathChoice::Within(50_000));
        for (name, choice, said, lathe, wanted) in [
            ("linuxcnc", None, None, false, Some(Within(0.01))),
            ("linuxcnc", None, None, true, Some(Exact)),
            ("linuxcnc", within, None, true, Some(Within(0.05))),
            ("linuxcnc", Some(PathChoice::Exact), None, false, Some(Exact)),
            ("linuxcnc", Some(PathChoice::Exact), Some(Within(0.02)), false, Some(Within(0.02))),
            ("linuxcnc", Some(PathChoice::Exact), Some(Unbounded), false, Some(Exact)),
            ("linuxcnc", within, Some(Unbounded), false, Some(Within(0.05))),
            ("linuxcnc", None, Some(Exact), false, Some(Exact)),
            ("linuxcnc", None, Some(Before(0.4)), false, Some(Within(0.1))),
            ("linuxcnc", Some(PathChoice::None), Some(Exact), false, None),
            ("sinumerik", None, None, false, Some(Within(0.01))),
            ("sinumerik", None, None, true, Some(Exact)),
            ("sinumerik", None, Some(Before(0.4)), false, Some(Before(0.4))),
            ("heidenhain", None, None, false, Some(Within(0.01))),
            // No word stops on a corner there.
            ("heidenhain", None, Some(Exact), false, Some(Within(0.01))),
            ("fanuc", None, None, false, Some(Unbounded)),
            ("fanuc-lathe", None, None, true, Some(Unbounded)),
            ("fanuc", None, Some(Exact), false, Some(Exact)),
            ("fanuc", None, Some(Within(0.02)), false, Some(Unbounded)),
            ("fanuc", Some(PathChoice::Exact), None, false, Some(Exact)),
            // How it starts is a setting.
            ("mach3", None, None, false, None),
            ("mach3", None, Some(Unbounded), false, Some(Unbounded)),
            ("grbl", None, Some(Exact), false, None),
            ("klipper", None, None, false, None),
        ] {
            assert_eq!(printed(name, choice, said, lathe), wanted, "{name} {choice:?} {said:?} {lathe}");
        }
    }
}
