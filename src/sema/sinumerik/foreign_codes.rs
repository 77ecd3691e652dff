//! G codes of ISO dialects, which the SINUMERIK language does not have or writes by other words.

/// The code, and what the SINUMERIK language has in its place.
const CODES: &[(u16, &str)] = &[
    (20, "`G70` for inches"),
    (21, "`G71` for millimetres"),
    (28, "`G75` or a move with SUPA"),
    (30, "`G75 FP=2` or a move with SUPA"),
    (43, "the D number of the tool"),
    (44, "the D number of the tool"),
    (49, "`D0`"),
    (50, "`TRANS` or `LIMS=`"),
    (52, "`TRANS`"),
    (65, "the name of the program with its arguments"),
    (66, "`MCALL` with the name of the program"),
    (67, "`MCALL` alone"),
    (68, "`ROT`"),
    (69, "`ROT` alone"),
    (73, "`CYCLE83`"),
    (76, "`CYCLE86`, or `CYCLE99` on a lathe"),
    (80, "`MCALL` alone"),
    (81, "`CYCLE81`"),
    (82, "`CYCLE82`"),
    (83, "`CYCLE83`"),
    (84, "`CYCLE84`"),
    (85, "`CYCLE85`"),
    (86, "`CYCLE86`"),
    (92, "`TRANS` or `LIMS=`"),
    (98, "the planes RTP and SDIS of the cycle"),
    (99, "the planes RTP and SDIS of the cycle"),
];

/// What to do about a G code that is not known.
pub(super) fn in_place_of(number: f64) -> String {
    match CODES.iter().find(|(code, _)| f64::from(*code) == number) {
        Some((code, ours)) => format!("G{code} is a code of ISO dialects; in its place this language has {ours}"),
        None => "check the number; `G=` takes a G number, `G[group]=` an index".to_owned(),
    }
}
