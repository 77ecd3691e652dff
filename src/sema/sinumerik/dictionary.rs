//! All words of the language in one place: G codes, addresses, procedures, cycles, and those that are not compiled.

use std::sync::OnceLock;

use rustc_hash::FxHashMap;

use crate::diag::codes;

use super::g_groups::named_codes;
use super::known_words::KNOWN;
use super::vocabulary::{
    ACTIONS, ADDRESS_NAMES, CHANNEL, DYNAMICS, FILES, INDEXED_NAMES, INTERRUPT, Meaning, NO_EFFECT, OnSurface,
    Procedure, REFUSED, Refusal, TRANSFORMATIONS, WITHOUT_MOVES,
};

/// Every word of the language by name.
pub(super) fn words() -> &'static FxHashMap<&'static str, Meaning> {
    static WORDS: OnceLock<FxHashMap<&'static str, Meaning>> = OnceLock::new();
    WORDS.get_or_init(all)
}

fn all() -> FxHashMap<&'static str, Meaning> {
    let mut map = FxHashMap::default();
    for (list, code) in [(TRANSFORMATIONS, codes::S9006), (REFUSED, codes::P9010)] {
        for (what, names) in list {
            let moves = !WITHOUT_MOVES.contains(what);
            for name in names.split(' ') {
                map.insert(name, Meaning::Procedure(Procedure::Refused(Refusal { what, code, moves })));
            }
        }
    }
    for cycle in super::cycles::rows() {
        let moves = !cycle.measures();
        let refusal = Refusal { what: "machining cycle", code: codes::P9010, moves };
        map.insert(cycle.signature.name, Meaning::Procedure(Procedure::Refused(refusal)));
    }
    let simple = [
        (NO_EFFECT, Procedure::NoEffect),
        (CHANNEL, Procedure::Channel),
        (INTERRUPT, Procedure::Interrupt),
        (ACTIONS, Procedure::Actions),
        (FILES, Procedure::FileAccess),
        (DYNAMICS, Procedure::Dynamics),
        ("GWPSON", Procedure::WheelSpeed),
        ("MSG", Procedure::Message),
        ("SETAL", Procedure::SetAlarm),
        ("SETMS", Procedure::SetMaster),
        ("CALLPATH", Procedure::CallPath),
        ("EXECSTRING", Procedure::ExecString),
        ("RET", Procedure::Return),
        ("TRANSMIT", Procedure::Transformation(OnSurface::Face)),
        ("TRACYL", Procedure::Transformation(OnSurface::Mantle)),
        ("TRAFOOF", Procedure::TransformationOff),
        ("CYCLE800", Procedure::Swivel),
        ("GEOAX", Procedure::GeoAxes),
        ("ENDLABEL", Procedure::EndLabel),
        ("DIAMCHAN", Procedure::DiameterChannel),
    ];
    for (names, procedure) in simple {
        for name in names.split_ascii_whitespace() {
            map.insert(name, Meaning::Procedure(procedure));
        }
    }
    for (name, address) in ADDRESS_NAMES {
        map.insert(*name, Meaning::Address(*address));
    }
    for (name, indexed) in INDEXED_NAMES {
        map.insert(*name, Meaning::Indexed(*indexed));
    }
    for (name, code) in named_codes() {
        map.insert(name, Meaning::Code(code));
    }
    for row in KNOWN {
        for name in row.names.split(' ') {
            map.entry(name).or_insert(Meaning::Known(row));
        }
    }
    map
}

/// Every word that the compiler knows, with its G group if it is a code of one; in order.
pub fn all_words() -> Vec<(String, Option<u8>)> {
    let mut list: Vec<(String, Option<u8>)> = words()
        .iter()
        .filter(|(name, _)| **name != "-")
        .map(|(name, meaning)| match meaning {
            Meaning::Code(code) => ((*name).to_owned(), Some(code.group.number())),
            _ => ((*name).to_owned(), None),
        })
        .collect();
    list.sort();
    list
}

#[cfg(test)]
mod tests {
    use super::super::g_groups::GCode;
    use super::*;

    #[test]
    fn codes_are_words() {
        assert_eq!(words().get("DIAMON"), Some(&Meaning::Code(GCode::DIAMON)));
    }
}
