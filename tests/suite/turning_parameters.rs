//! No word of a turning cycle is ignored: each stands in a golden program that prints something else without it, or
//! with another value.

use partc::internals::text::files::NoFiles;

use super::book::find;
use super::common::compile_bytes;

/// A case below `heidenhain-turning`, a word of its cycle, and what stands there instead.
type Case = (&'static str, &'static str, &'static str);

/// G31, from where the tool stands and along a contour.
const THREAD: &[Case] = &[
    ("threads/example_1_constant_cross_section", "X20 Z-20", "X21 Z-20"),
    ("threads/example_1_constant_cross_section", "Z-20", "Z-21"),
    ("threads/example_1_constant_cross_section", "F1.5", "F1.25"),
    ("threads/example_1_constant_cross_section", "U-0.92", "U-0.9"),
    ("threads/internal", "U0.6", "U0.5"),
    ("threads/example_1_constant_cross_section", "I0.3", "I0.4"),
    ("threads/example_5_taper", " R1", ""),
    ("threads/example_1_constant_cross_section", "B3", "B4"),
    ("threads/run_in_from_speed", "S800", "S1600"),
    ("threads/example_1_constant_cross_section", "P1", "P2"),
    ("threads/example_4_left_offset", " A30", ""),
    ("threads/example_2_constant_infeed", "V1", "V0"),
    ("threads/example_3_remainder_split", "V2", "V3"),
    ("threads/example_4_left_offset", "H1", "H0"),
    ("threads/right_offset", "H2", "H1"),
    ("threads/example_4_alternating_offset", "H3", "H1"),
    ("threads/air_cuts", " Q2", ""),
    ("threads/start_angle", " C90", ""),
    ("threads/din_plus_reference", "NS3", "NS2"),
    ("threads/din_plus_reference", "V1", "V0"),
    ("threads/cuts_by_count", " IC4", " IC5"),
    ("threads/data_of_g34", "G34 F1.5", "G34 F1.25"),
    ("threads/data_of_g37", "P0.8", "P0.9"),
    ("threads/data_of_g37_overridden", " U-0.3", ""),
    ("threads/example_14_successive", "X34 Z-40", "X35 Z-40"),
    ("threads/transverse_front", "R-20", "R-15"),
    ("threads/transverse_front", "B4", "B3"),
    ("threads/transverse_front", "P2", "P1"),
    ("threads/transverse_front", "U-1.2", "U-1.1"),
    ("threads/transverse_front", "V1", "V0"),
];

/// G869 and the G80 that closes the unit with direct contour input.
const RECESS_TURNING: &[Case] = &[
    ("recess_turning/infeed", "P3", "P2"),
    ("recess_turning/example_6", "I0.4", "I0.6"),
    ("recess_turning/example_6", "K0.1", "K0.2"),
    ("recess_turning/example_6", "B0.3", "B0.2"),
    ("recess_turning/compensation", "R0.05", "R0.1"),
    ("recess_turning/compensation_of_the_unit", " RB0.05", ""),
    ("recess_turning/one_way", "U1", "U0"),
    ("recess_turning/finish_only", "Q2", "Q1"),
    ("recess_turning/rough_and_finish", "Q0", "Q1"),
    ("recess_turning/end_in_front", "H1", "H0"),
    ("recess_turning/end_lifted", "H2", "H0"),
    ("recess_turning/rims_left_out", " V3", ""),
    ("recess_turning/feeds", " O0.08", ""),
    ("recess_turning/feeds", " E0.12", ""),
    ("recess_turning/blank_corner", "XA64", "XA62"),
    ("recess_turning/blank_corner_axial", "ZA2", "ZA1"),
    ("recess_turning/blank_oversize_x", "RI4", "RI2"),
    ("recess_turning/blank_oversize_z", "RK2", "RK1"),
    ("recess_turning/reference_to_the_finished_part", "NS5 NE7", "NS7 NE5"),
    ("recess_turning/named_contour", "ID\"left\"", "ID\"RIGHT\""),
    ("recess_turning/words_of_g80", "XS60", "XS61"),
    ("recess_turning/words_of_g80", "ZS-20", "ZS-21"),
    ("recess_turning/words_of_g80", "XE48", "XE50"),
    ("recess_turning/words_of_g80", "ZE-32", "ZE-34"),
    ("recess_turning/words_base_radius", " RC1", ""),
    ("recess_turning/words_angles", " AC10", ""),
    ("recess_turning/words_angles", " WC20", ""),
    ("recess_turning/words_chamfer_at_start", " BS-0.5", ""),
    ("recess_turning/words_rounding_at_end", " BE0.5", ""),
];

/// G890.
const FINISHING: &[Case] = &[
    ("finishing/along_the_contour", "NS3 NE7", "NS4 NE7"),
    ("finishing/along_the_contour", "NE7", "NE6"),
    ("finishing/plunging_feed", "E0.08", "E0.09"),
    ("finishing/plunging_left_out", " E0", ""),
    ("finishing/ends_v1", " V1", ""),
    ("finishing/ends_v2", " V2", ""),
    ("finishing/ends_v3", " V3", ""),
    ("finishing/end_h0", " H0 I70 K5", ""),
    ("finishing/end_h0", "I70", "I72"),
    ("finishing/end_h0", "K5", "K6"),
    ("finishing/end_h1", "H1", "H0"),
    ("finishing/end_h2", "H2", "H1"),
    ("finishing/end_h4", " H4", ""),
    ("finishing/end_h5", " H5", ""),
    ("finishing/end_h6", "H6", "H7"),
    ("finishing/end_h7", "H7", "H5"),
    ("finishing/end_h8", "H8", "H0"),
    ("finishing/left_out_d256", " D256", ""),
    ("finishing/left_out_d1536", " D1536", ""),
    ("finishing/left_out_d65536", " D65536", ""),
    ("finishing/arc_without_reduction", " O1", ""),
    ("finishing/oversize_of_g57", "X0.6", "X0.5"),
    ("finishing/oversize_of_g57", " Z0.1", ""),
    ("finishing/oversize_of_g58", "P0.3", "P0.2"),
    ("finishing/clearance", "P3", "P2"),
    ("finishing/recess_with_flanks", " A40", ""),
];

/// G32, G33, G36, G71, G74, G81, G82, G85, G86 and the roughing cycles.
const OTHERS: &[Case] = &[
    ("threads/simple", "X20", "X21"),
    ("threads/simple", "Z-20", "Z-21"),
    ("threads/simple", "F1.5", "F2"),
    ("threads/simple", "P0.92", "P0.9"),
    ("threads/simple", "I0.3", "I0.2"),
    ("threads/simple_without_division", " B1", ""),
    ("threads/simple_air_cuts", " Q2", ""),
    ("threads/simple_run_out", " K2", ""),
    ("threads/simple_start_angle", " C120", ""),
    ("threads/single_cut", "F1.5", "F2"),
    ("drilling/tapping", "F1.25", "F1"),
    ("drilling/tapping", "Z-15", "Z-14"),
    ("drilling/tapping", "M3", "M4"),
    ("drilling/drill", "E0.5", "E2"),
    ("drilling/out_at_feed", " D1", ""),
    ("drilling/deep_hole", "P12", "P8"),
    ("drilling/chip_breaking", " B1", ""),
    ("drilling/shorter_steps", "I4 J4", "I3 J3"),
    ("roughing/example_8", "X50", "X48"),
    ("roughing/example_8", "Z-30", "Z-28"),
    ("roughing/example_8", "I-2.5", "I-5"),
    ("roughing/example_13", "K-1.25", "K-2"),
    ("roughing/infeed_at_feed", " Q1", ""),
    ("roughing/return_to_start", " V1", ""),
    ("roughing/oversize_stays", "X0.4", "X0.8"),
    ("roughing/example_12", "P3", "P4"),
    ("roughing/each_cut", "H0", "H1"),
    ("roughing/no_contour_pass", "H2", "H1"),
    ("roughing/contour_oversize", "I1", "I2"),
    ("roughing/contour_oversize", "K0.2", "K0.3"),
    ("roughing/undercut_left_out", "E0 D65536", "E0 D131072"),
    ("roughing/words_of_g80", " RC2", ""),
    ("roughing/words_of_g80", " BE-1", ""),
    ("roughing/words_of_g80_angles", "AC5", "AC6"),
    ("roughing/words_of_g80_angles", "WC10", "WC12"),
    ("roughing/words_of_g80_angles", " BS-1", ""),
    ("undercut/form_e", "X40", "X60"),
    ("undercut/form_f", " E0.05", ""),
    ("undercut/form_f", " K0", ""),
    ("undercut/din_76", "I1.15", "I1"),
    ("recess/one_stroke", "X54", "X55"),
    ("recess/one_stroke", "Z-30", "Z-31"),
    ("recess/one_stroke", "E2", "E1"),
    ("recess/finished", "I0.4", "I0.6"),
    ("recess/finished", "K8", "K7"),
    ("recess/axial", " K0.2", ""),
    ("finishing/contour_of_g89", " I0.2", ""),
    ("finishing/contour_of_g89_inside", " K0.5", ""),
    ("finishing/contour_of_g89_compensated", "N4 G42\n", ""),
    ("undercut/din_76_inside", "K7.8", "K5.2"),
    ("undercut/limit_upper", "X18", "X17.9"),
    ("finishing/thread_undercut_inside", "FP1.5", "FP1.25"),
    ("finishing/thread_undercut_inside", "I1.0619", "I1"),
];

/// The moves: what is printed without comments and without the hash of the source.
fn moves(printed: &str) -> Vec<&str> {
    printed.lines().filter(|line| !line.starts_with('(')).collect()
}

fn check(cases: &[Case]) -> Vec<String> {
    let mut ignored = Vec::new();
    for &(name, word, instead) in cases {
        let Some(case) = find(&format!("heidenhain-turning/{name}")) else {
            ignored.push(format!("{name}: no such program"));
            continue;
        };
        let text = case.text().expect("a program in UTF-8");
        // The comment of the case names the word, too.
        let commented = text.lines().filter(|line| line.starts_with('[')).map(str::len).sum::<usize>();
        let blocks: String = text.lines().filter(|line| !line.starts_with('[')).flat_map(|line| [line, "\n"]).collect();
        assert!(commented > 0, "{name} has no comment");
        if !blocks.contains(word) {
            ignored.push(format!("{name}: no `{word}`"));
            continue;
        }
        let changed = blocks.replacen(word, instead, 1).into_bytes();
        let before = case.compile();
        assert!(!before.has_errors(), "{name}");
        let after = compile_bytes(name, changed, "heidenhain-turning", &case.settings(), &NoFiles);
        if !after.has_errors() && moves(&before.output) == moves(&after.output) {
            ignored.push(format!("{name}: `{word}` and `{instead}` print the same"));
        }
    }
    ignored
}

#[test]
fn every_word_changes_what_is_printed() {
    let all = [THREAD, RECESS_TURNING, FINISHING, OTHERS].concat();
    let ignored = check(&all);
    assert!(ignored.is_empty(), "{}", ignored.join("\n"));
}
