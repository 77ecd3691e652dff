//! Names of the global data by which measuring cycles are told what to do, and give their results.
//!
//! Source: S 6, P 3.1 (docs/sources.md).

use crate::diag::{Answer, Help};

/// What a call is told: kind, set values, tolerances, tools and probes, paths and feeds.
const GIVEN: &str = "_MVAR _SETVAL _SETV _PRNUM _KNUM _KNUM1 _FA _TSA _VMS _NMSP _MA _MD _TUL _TLL _TDIF _TMV _TZL _TSL _K _EVNUM _ID \
    _CPA _CPO _STA1 _INCA _SZA _SZO _CORA _RA _RF _TNUM _TNAME _TENV _DLNUM _CALNUM _SPEED _CM _CBIT _CHBIT _CVAL _CALCM \
    _ORI_ROUGH _ORI_FINISH _ORI_SEMIFIN _TP _TPW _WP _KB _DIST _ADIST _PLIMIT _MFS _MT_COMP _MT_EC_R _MT_EC_L _TP_CAL";

/// What it gives back.
const RESULTS: &str = "_OVR _OVI _EV _MV _EVMVNUM _TXT";

/// Is it a name of the measuring cycles, and one of a result? `name` is in capitals.
pub(super) fn find(name: &str) -> Option<bool> {
    let is_in = |list: &str| list.split_ascii_whitespace().any(|known| known == name);
    if is_in(RESULTS) { Some(true) } else { is_in(GIVEN).then_some(false) }
}

/// How to leave out what measures.
pub(super) fn leave_out() -> Help {
    Answer::key("control", "probing").one_of(&["\"leave-out\""]).help(
        "leave out what measures: `[control] probing = \"leave-out\"`; what the program computes with afterwards is asked for",
    )
}
