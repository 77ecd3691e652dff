//! `[undercut]`: sizes of undercuts that differ from DIN 509 and DIN 76. docs/undercuts.md describes them.

use super::key::{Key, Kind, key};

pub const KEYS: &[Key] = &[
    key("din509", Kind::Free, "size of forms E and F: \"0.6x0.3\" = { f = 2.5, t2 = 0.2 }", |s, v| {
        s.undercut.set("din509", v)
    }),
    key(
        "din76",
        Kind::Free,
        "thread undercut of a pitch: \"1.5\" = { external = 2.3, a = [3.2, 5.2], r = 0.8 }",
        |s, v| s.undercut.set("din76", v),
    ),
    key(
        "din509_by_diameter",
        Kind::Free,
        "size up to a diameter: \"80\" = \"0.6x0.3\", above = \"1.0x0.4\"",
        |s, v| s.undercut.set("din509_by_diameter", v),
    ),
    key(
        "din509_in_editor",
        Kind::Texts,
        "SINUMERIK: sizes by their index in the contour editor: [\"0.1x0.1\", …]",
        |s, v| s.undercut.set("din509_in_editor", v),
    ),
    key("din509_in_cycle", Kind::Texts, "SINUMERIK: sizes by `_PITI` of CYCLE940: [\"0.6x0.3\", …]", |s, v| {
        s.undercut.set("din509_in_cycle", v)
    }),
    key(
        "thread_length",
        Kind::Choice(&["middle", "shortest", "longest"]),
        "length of a thread undercut between g1 and g2; if not given, what the control does (SINUMERIK: middle)",
        |s, v| s.undercut.set("thread_length", v),
    ),
    key(
        "internal_depth",
        Kind::Choice(&["core", "bore"]),
        "what the contour is at an internal thread undercut; if not given, what the control does (SINUMERIK: core)",
        |s, v| s.undercut.set("internal_depth", v),
    ),
];
