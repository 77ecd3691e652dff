//! Words that no entry of `[control] machine_words` may name: they move the tool, or say where it goes and how fast.

use super::Core;
use super::g_functions::{self, G, Group};
use super::words::is_of_flow;

impl Core<'_> {
    /// No entry of `machine_words` takes away what moves the tool.
    pub(super) fn refuse_known_words(&self) {
        let of_flow = |name: &str| is_of_flow(name).then_some("a word of the program flow");
        let names = self.job.settings.control.mtc200.machine_words.keys();
        let entries: Vec<(&str, &str)> =
            names.filter_map(|name| Some((name.as_str(), reserved(name).or_else(|| of_flow(name))?))).collect();
        let help = "take them out of the list: without them the tool would go another way, or the machine would not do what the program asks";
        self.refuse_entries("[control] machine_words", &entries, help);
        let words = self.job.settings.control.mtc200.machine_words.iter();
        let printed: Vec<(String, &str)> = words
            .filter_map(|(name, number)| Some((name, (*number)?)))
            .filter_map(|(name, number)| Some((format!("{name} = M{number}"), reserved_m(number)?)))
            .collect();
        let printed: Vec<(&str, &str)> = printed.iter().map(|(entry, what)| (entry.as_str(), *what)).collect();
        let help = "take them out: partc has to know of these functions, and would take the word for one that does nothing to the \
                    path; write the M function itself into the program";
        self.refuse_entries("[control] machine_words", &printed, help);
    }
}

/// What the control does by this word, if it is one of motion, dimensions or coordinates; `name` is in capitals.
pub(super) fn reserved(name: &str) -> Option<&'static str> {
    let letter = *name.as_bytes().first()?;
    let rest = name.get(1..)?.trim();
    let number = || rest.trim_end_matches('.').parse::<u32>().ok();
    match letter {
        b'G' if number().is_some() => number().and_then(g_function),
        b'M' if number().is_some() => number().and_then(reserved_m),
        b'C' if rest == "F" => Some("the chamfer of a corner"),
        b'R' if rest == "D" => Some("the rounding of a corner"),
        _ if rest.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') => None,
        b'A'..=b'C' | b'U'..=b'Z' => Some("the position of an axis"),
        b'I'..=b'K' => Some("the centre of a circle or the lead of a thread"),
        b'R' => Some("the radius of a circle"),
        b'F' => Some("the feed"),
        b'O' => Some("the bank of zero offsets"),
        b'P' => Some("an angle of offsets and threads, or a program"),
        _ => None,
    }
}

/// What an M function does that no entry of `[control] machine_words` may name on either side: partc has to know of it, or a
/// receiver takes it for the flow of the program. Coolant changes nothing that partc keeps.
pub(super) fn reserved_m(number: u32) -> Option<&'static str> {
    Some(match number {
        0 | 1 => "a stop of the program",
        2 | 30 => "the end of the program",
        3 | 4 | 13 | 14 => "the start of the spindle",
        5 => "the stop of the spindle",
        6 => "the tool change",
        19 => "the orientation of the spindle",
        17 | 99 => "the end of a subprogram on many machines",
        29 => "rigid tapping on many machines",
        98 | 198 => "the call of a subprogram on many machines",
        96 | 97 => "a jump or a call on many machines",
        _ => return None,
    })
}

fn g_function(number: u32) -> Option<&'static str> {
    if let Some(what) = g_functions::refused(number) {
        return Some(what);
    }
    let (group, g) = g_functions::entry(number)?;
    Some(match group {
        Group::Motion => "the kind of motion",
        Group::Plane => "the working plane",
        Group::Dimension => "absolute and incremental dimensions",
        Group::Diameter => "dimensions of X as diameter or radius",
        Group::Unit => "the unit of lengths",
        Group::Compensation | Group::CornerElement => "path compensation",
        Group::Offset => "a zero offset",
        Group::FeedUnit => "the unit of the feed",
        Group::SpindleMode => "constant cutting speed",
        Group::Once => match g {
            G::Dwell => "the dwell time",
            G::Home => "the move to the home position",
            G::SpeedLimit => "the limit of the spindle speed",
            _ => "a programmed zero offset",
        },
        // Dynamics, and the length that the target counts: no number of the output depends on them.
        Group::FollowingError | Group::Transition | Group::ExactStop | Group::ToolLength => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_moves_is_reserved() {
        for name in [
            "G63", "G063", "G0", "G78", "G93", "G49", "M30", "M3", "M06", "M0", "M19", "X", "X5", "X2=5", "O1", "CF",
            "RD", "R5",
        ] {
            assert!(reserved(name).is_some(), "{name}");
        }
        for name in ["G48", "G47", "G8", "G61", "G130", "M8", "M48", "LA_ON", "Q5", "H3", "XPOS", "ACC", "CFG", ""] {
            assert_eq!(reserved(name), None, "{name}");
        }
    }
}
