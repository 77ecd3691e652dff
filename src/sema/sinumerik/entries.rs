//! Entries of `[programs]` that would make a word of the language vanish.

use crate::machine::StandIn;
use crate::text::Span;

use super::beside_path::Beside;
use super::vocabulary::{Address, Indexed, Meaning, Procedure};
use super::{Core, dictionary, probe_state};

/// No entry of `[programs]` takes away what moves the tool or says where it goes; a file may stand for a cycle.
pub(super) fn refuse_known_words(core: &Core<'_>) {
    let (programs, vocabulary) = (&core.job.settings.programs, dictionary::words());
    let entries: Vec<(&str, &str)> = programs
        .iter()
        .filter(|(_, stands)| !matches!(stands, StandIn::File(_)))
        .filter_map(|(name, _)| Some((name.as_str(), reserved(*vocabulary.get(name.as_str())?)?)))
        .collect();
    let help = "take them out: without them the tool would go another way; a file may run in place of a cycle: \
                `CYCLE952 = { file = \"stubs/CYCLE952.SPF\" }`";
    core.refuse_entries("[programs]", &entries, help);
    let fixed: Vec<(&str, &str)> = programs
        .iter()
        .filter(|(name, stands)| !matches!(stands, StandIn::Ignored) && !entries.iter().any(|(entry, _)| entry == name))
        .filter(|(name, _)| vocabulary.get(name.as_str()).is_some_and(|known| !takes_program(name, *known)))
        .map(|(name, _)| (name.as_str(), "a word of the language, for which the control calls no program"))
        .collect();
    let help =
        "take them out: they have no effect; what stands under `[programs]` is the name of a program or of a cycle";
    core.refuse_entries("[programs]", &fixed, help);
}

/// Does the control look for a program of this name, so that one may stand for it?
fn takes_program(name: &str, meaning: Meaning) -> bool {
    match meaning {
        Meaning::Code(_) | Meaning::Axis(_) => false,
        // A program in their place would drop the axis that follows, or what is measured.
        _ if Beside::find(name).is_some() || probe_state::word(name, Span::default()).is_some() => false,
        Meaning::Procedure(Procedure::Refused(_) | Procedure::Transformation(_)) => true,
        Meaning::Procedure(_) => super::cycles::is_program(name),
        Meaning::Address(_) | Meaning::Indexed(_) | Meaning::Known(_) | Meaning::Unknown => true,
    }
}

/// What a word of the language is, if without it the path would be another one.
pub(super) fn reserved(meaning: Meaning) -> Option<&'static str> {
    match meaning {
        Meaning::Code(_) => Some("a G function"),
        Meaning::Axis(_) => Some("an axis"),
        Meaning::Address(Address::Dynamics) | Meaning::Indexed(Indexed::Dynamics | Indexed::Override) => None,
        Meaning::Address(_) | Meaning::Indexed(_) => Some("a word of the path"),
        Meaning::Known(known) => known.moves.then_some(known.what),
        Meaning::Procedure(procedure) => of_procedure(procedure),
        Meaning::Unknown => None,
    }
}

fn of_procedure(procedure: Procedure) -> Option<&'static str> {
    match procedure {
        Procedure::Transformation(_) => Some("a transformation"),
        Procedure::TransformationOff => Some("the end of a transformation"),
        Procedure::Swivel => Some("the swivelling of the plane"),
        Procedure::GeoAxes => Some("a change of the geometry axes"),
        Procedure::DiameterChannel => Some("the kind of dimensions of X"),
        Procedure::SetMaster => Some("the choice of the spindle that feeds count by"),
        Procedure::ExecString | Procedure::Return | Procedure::EndLabel => Some("a word of the program flow"),
        Procedure::Refused(refusal) => refusal.moves.then_some(refusal.what),
        Procedure::NoEffect
        | Procedure::Dynamics
        | Procedure::WheelSpeed
        | Procedure::Message
        | Procedure::SetAlarm
        | Procedure::Channel
        | Procedure::Interrupt
        | Procedure::Actions
        | Procedure::FileAccess
        | Procedure::CallPath => None,
    }
}
