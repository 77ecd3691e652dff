//! Rows of `[control]` of HEIDENHAIN Klartext.

use super::key::{Key, Kind, key};
use crate::machine::options::klartext::{
    ApproachDepth, CcMissing, CpSign, Modulo, PolarMissing, RepeatCount, ShiftAxes,
};
use crate::machine::values::{is, number, put, text};

pub const KEYS: &[Key] = &[
    // A file, which whoever reads files takes.
    key(
        "datum_table",
        Kind::Text,
        "datum table (.D) that is selected on the control, where the program selects none",
        |_, _| Ok(()),
    ),
    key("cc_missing", Kind::Choice(&["position", "previous"]), "missing coordinate of a CC block", |s, v| {
        put(&mut s.control.cc_missing, if is(v, "previous") { CcMissing::Previous } else { CcMissing::Position })
    })
    .or(r#""position""#),
    key(
        "polar_missing",
        Kind::Choice(&["same-pole", "position", "programmed"]),
        "missing PR or PA after a block that is not polar; same-pole: from the position, but no PA about a new pole",
        |s, v| {
            s.control.polar_missing = match text(v) {
                "programmed" => PolarMissing::Programmed,
                "position" => PolarMissing::Position,
                _ => PolarMissing::SamePole,
            };
            Ok(())
        },
    )
    .or(r#""same-pole""#),
    key("pattern_feed", Kind::Choice(&["last", "rapid"]), "CYCL CALL PAT and CYCL CALL POS without F", |s, v| {
        put(&mut s.control.klartext_readings.pattern_at_rapid, is(v, "rapid"))
    })
    .or(r#""last""#),
    key(
        "mirror",
        Kind::Choice(&["first", "last"]),
        "Klartext: mirror before or after the rotation of cycle 10",
        |s, v| put(&mut s.control.klartext_readings.mirror_last, is(v, "last")),
    )
    .or(r#""first""#),
    key(
        "scaling_center",
        Kind::Choice(&["datum", "kept"]),
        "centre of a cycle 26 that names none where one before did",
        |s, v| put(&mut s.control.klartext_readings.keep_scaling_center, is(v, "kept")),
    )
    .or(r#""datum""#),
    key(
        "shift_axes",
        Kind::Choice(&["original", "transformed"]),
        "axes of a datum shift under rotation, mirror or scaling",
        |s, v| {
            put(
                &mut s.control.shift_axes,
                if is(v, "transformed") { ShiftAxes::Transformed } else { ShiftAxes::Original },
            )
        },
    )
    .or(r#""original""#),
    key("cp_sign", Kind::Choice(&["refuse", "dr"]), "CP block whose IPA and DR disagree", |s, v| {
        put(&mut s.control.cp_sign, if is(v, "dr") { CpSign::Dr } else { CpSign::Refuse })
    })
    .or(r#""refuse""#),
    key(
        "modulo",
        Kind::Choice(&["refuse", "truncate", "floor"]),
        "% with a negative operand: refused, sign of the left or of the right operand",
        |s, v| {
            s.control.modulo = match text(v) {
                "truncate" => Modulo::Truncate,
                "floor" => Modulo::Floor,
                _ => Modulo::Refuse,
            };
            Ok(())
        },
    )
    .or(r#""refuse""#),
    key(
        "repeat_count",
        Kind::Choice(&["refuse", "truncate", "round"]),
        "number of repeats (CALL LBL REP) with decimals",
        |s, v| {
            s.control.repeat_count = match text(v) {
                "truncate" => RepeatCount::Truncate,
                "round" => RepeatCount::Round,
                _ => RepeatCount::Refuse,
            };
            Ok(())
        },
    )
    .or(r#""refuse""#),
    key(
        "open_subprogram",
        Kind::Choice(&["refuse", "end"]),
        "END PGM inside a called label without LBL 0: refused, or the end of the program file",
        |s, v| put(&mut s.control.klartext_choices.open_subprogram_ends, is(v, "end")),
    )
    .or(r#""refuse""#),
    key(
        "probing",
        Kind::Choice(&["refuse", "leave-out"]),
        "touch probe cycles; SINUMERIK: measuring cycles (CYCLE978 …), MEAS and MEAW",
        |s, v| put(&mut s.control.klartext_choices.probing_left_out, is(v, "leave-out")),
    )
    .or(r#""refuse""#),
    key(
        "probing_datum",
        Kind::Choice(&["set", "refuse"]),
        "touch probe cycles that are left out and set a datum or a basic rotation; set: the work offset of the target is \
         set as they set it; without it they warn; SINUMERIK: measuring cycles that correct a work offset, refused without it",
        |s, v| put(&mut s.control.klartext_choices.probing_datum, Some(is(v, "set"))),
    ),
    key(
        "probing_contact",
        Kind::Choice(&["none"]),
        "SINUMERIK: what MEAS and MEAW find where probing is left out; none: the probe touches nothing, each of their moves goes its whole \
         way and is printed; without it the moves of MEAS are left out, and $AC_MEA is asked for",
        |s, v| put(&mut s.control.klartext_choices.never_touches, is(v, "none")),
    ),
    key(
        "system_unit",
        Kind::Choice(&["program", "mm"]),
        "unit of the lengths that FN 18 reads in an INCH program; without it mm on a TNC7, and refused on older controls",
        |s, v| put(&mut s.control.klartext_choices.system_in_mm, Some(is(v, "mm"))),
    ),
    key("cycle_19", Kind::Choice(&["space", "axes"]), "angles of cycle 19: space angles, or rotary axes", |s, v| {
        put(&mut s.control.klartext_choices.cycle_19_axes, is(v, "axes"))
    })
    .or(r#""space""#),
    key(
        "m98",
        Kind::Choice(&["line", "refuse"]),
        "Klartext: open corner of M98: a line between its sides, or refused",
        |s, v| put(&mut s.control.klartext_choices.open_corners_refused, is(v, "refuse")),
    )
    .or(r#""line""#),
    key(
        "rounded_approach",
        Kind::Choice(&["refuse", "round"]),
        "RND directly after the block with RL or RR, or before the one with R0",
        |s, v| put(&mut s.control.klartext_choices.rounded_approach, is(v, "round")),
    )
    .or(r#""refuse""#),
    key(
        "approach_depth",
        Kind::Choice(&["staged", "together"]),
        "tool axis in APPR and DEP: alone at PH or PN, or with the plane; without it as the control generation does",
        |s, v| {
            put(
                &mut s.control.klartext_choices.approach_depth,
                Some(if is(v, "together") { ApproachDepth::Together } else { ApproachDepth::Staged }),
            )
        },
    ),
    key(
        "fk_cca",
        Kind::Choice(&["end-angle", "sweep"]),
        "CCA of FC and FCT: direction of the end seen from the centre, or the angle that the arc sweeps",
        |s, v| put(&mut s.control.klartext_choices.fk_cca_swept, Some(is(v, "sweep"))),
    )
    .or_warn(r#""end-angle""#),
    key(
        "fselect",
        Kind::Choice(&["observed", "refuse"]),
        "FSELECT where several solutions are left: in the order observed in printed programs, or refused",
        |s, v| put(&mut s.control.klartext_choices.fselect_refused, is(v, "refuse")),
    )
    .or(r#""observed""#),
    key("scaling", Kind::Choice(&["all", "plane"]), "axes that cycle 11 scales (MP 7410)", |s, v| {
        put(&mut s.control.scaling_in_plane, is(v, "plane"))
    })
    .or(r#""all""#),
    key("retract_max", Kind::Number, "machine coordinate of the tool axis for M140 MB MAX, in mm", |s, v| {
        put(&mut s.control.retract_max, number(v))
    }),
];
