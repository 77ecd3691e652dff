//! Cases that need a parameter of a SINUMERIK cycle: left out, the program does something else.

/// Cycles, each with cases under `tests/golden/sinumerik` and the parameters that these need.
const CASES: &[(&str, &[(&str, &str)])] = &[
    (
        "CYCLE81",
        &[
            ("drilling/cycle81_dp_and_dpr_agree", "RTP RFP SDIS"),
            ("drilling/cycle81_dp_zero", "DP"),
            ("drilling/cycle81_dpr", "DPR"),
            ("drilling/cycle81_dwell", "DTB"),
            ("drilling/cycle81_centring_diameter", "_GMODE"),
            ("drilling/cycle81_in_the_plane_it_names", "_DMODE"),
            ("drilling/cycle81_incremental_mode", "_AMODE"),
        ],
    ),
    (
        "CYCLE82",
        &[
            ("drilling/cycle82_dpr", "RTP RFP SDIS DPR DTB"),
            ("drilling/cycle82_new_signature", "DP"),
            ("drilling/cycle82_shank", "_GMODE"),
            ("drilling/cycle82_other_plane", "_DMODE"),
            ("drilling/cycle82_dwell_in_turns_by_digit", "_AMODE"),
            ("drilling/cycle82_predrilling", "_VARI"),
            ("drilling/cycle82_rest_depths_without_variant", "S_ZA S_FA S_ZD S_FD"),
        ],
    ),
    (
        "CYCLE83",
        &[
            ("drilling/cycle83_amount", "RTP RFP SDIS DP FDEP DAM"),
            ("drilling/cycle83_dpr", "DPR"),
            ("drilling/cycle83_amount_5", "FDPR"),
            ("drilling/cycle83_dwell", "DTB"),
            ("drilling/cycle83_dwell_above", "DTS"),
            ("drilling/cycle83_feed_factor", "FRF"),
            ("drilling/cycle83_anticipation", "VARI _DIS1"),
            ("drilling/cycle83_axn_1", "_AXN"),
            ("drilling/cycle83_factor", "_MDEP"),
            ("drilling/cycle83_break_way", "_VRT"),
            ("drilling/cycle83_dwell_at_the_bottom", "_DTD"),
            ("drilling/cycle83_shank", "_GMODE"),
            ("drilling/cycle83_other_plane", "_DMODE"),
            ("drilling/cycle83_feed_percent", "_AMODE"),
        ],
    ),
    (
        "CYCLE84",
        &[
            ("drilling/cycle84_axn", "RTP RFP SDIS DP PIT SST _AXN"),
            ("drilling/cycle84_dpr", "DPR"),
            ("drilling/cycle84_dwell", "DTB"),
            ("drilling/cycle84_left_hand", "SDAC SST1"),
            ("drilling/cycle84_metric_size", "MPIT"),
            ("drilling/cycle84_oriented", "POSS"),
            ("drilling/cycle84_inch_pitch", "_PITA"),
            ("drilling/cycle84_technology", "_TECHNO"),
            ("drilling/cycle84_full_retract", "_VARI _DAM"),
            ("drilling/cycle84_chip_breaking_way", "_VRT"),
            ("drilling/cycle84_shank", "_GMODE"),
            ("drilling/cycle84_other_plane", "_DMODE"),
            ("drilling/cycle84_depth_by_digit_2", "_AMODE"),
        ],
    ),
    (
        "CYCLE840",
        &[
            ("drilling/cycle840_axn", "RTP RFP SDIS DP SDAC ENC _AXN"),
            ("drilling/cycle840_dpr", "DPR"),
            ("drilling/cycle840_dwell", "DTB"),
            ("drilling/cycle840_left", "SDR"),
            ("drilling/cycle840_encoder_size", "MPIT"),
            ("drilling/cycle840_encoder", "PIT"),
            ("drilling/cycle840_inch_pitch", "_PITA"),
            ("drilling/cycle840_technology", "_TECHNO"),
            ("drilling/cycle840_shank", "_GMODE"),
            ("drilling/cycle840_other_plane", "_DMODE"),
            ("drilling/cycle840_depth_by_digit_2", "_AMODE"),
        ],
    ),
    (
        "CYCLE85",
        &[
            ("drilling/cycle85_dpr", "RTP RFP SDIS DPR FFR RFF"),
            ("drilling/cycle85_dwell", "DP DTB"),
            ("drilling/cycle85_shank", "_GMODE"),
            ("drilling/cycle85_other_plane", "_DMODE"),
            ("drilling/cycle85_depth_by_digit_2", "_AMODE"),
        ],
    ),
    (
        "CYCLE86",
        &[
            ("drilling/cycle86_dpr", "RTP RFP SDIS DPR SDIR RPA RPO RPAP POSS"),
            ("drilling/cycle86_no_lift", "DP"),
            ("drilling/cycle86_plain", "DTB"),
            ("drilling/cycle86_shank", "_GMODE"),
            ("drilling/cycle86_other_plane", "_DMODE"),
            ("drilling/cycle86_depth_by_digit_2", "_AMODE"),
        ],
    ),
    ("CYCLE87", &[("drilling/cycle87_dpr", "RTP RFP SDIS DPR SDIR"), ("drilling/cycle87_plain", "DP")]),
    ("CYCLE88", &[("drilling/cycle88_dpr", "RTP RFP SDIS DPR DTB SDIR"), ("drilling/cycle88_plain", "DP")]),
    (
        "CYCLE89",
        &[
            ("drilling/cycle89_dpr", "RTP RFP SDIS DPR"),
            ("drilling/cycle89_plain", "DP DTB"),
            ("drilling/cycle89_shank", "_GMODE"),
            ("drilling/cycle89_other_plane", "_DMODE"),
            ("drilling/cycle89_depth_by_digit_2", "_AMODE"),
        ],
    ),
    (
        "HOLES1",
        &[
            ("patterns/holes1_backwards", "SPCA SPCO STA1 FDIS DBH NUM"),
            ("patterns/holes1_vari", "_VARI"),
            ("patterns/holes1_hidden_positions", "_HIDE"),
            ("patterns/holes1_start_position", "_NSP"),
            ("patterns/holes1_other_plane", "_DMODE"),
        ],
    ),
    (
        "HOLES2",
        &[
            ("patterns/holes2_new_call", "CPA CPO"),
            ("drilling/lathe_holes_in_g17", "RAD STA1 NUM"),
            ("patterns/holes2_just_under_a_turn", "INDA"),
            ("patterns/holes2_vari", "_VARI"),
            ("patterns/holes2_hidden_positions", "_HIDE"),
            ("patterns/holes2_start_position", "_NSP"),
            ("patterns/holes2_other_plane", "_DMODE"),
        ],
    ),
    (
        "CYCLE801",
        &[
            ("patterns/cycle801_along_y", "_SPCA _SPCO _DIS1 _DIS2 _NUM1 _NUM2"),
            ("patterns/cycle801_turned", "_STA"),
            ("patterns/cycle801_frame", "_VARI"),
            ("patterns/cycle801_oblique", "_ANG1"),
            ("patterns/cycle801_oblique_rows", "_ANG2"),
            ("patterns/cycle801_hidden_positions", "_HIDE"),
            ("patterns/cycle801_start_position", "_NSP"),
            ("patterns/cycle801_other_plane", "_DMODE"),
        ],
    ),
    (
        "CYCLE802",
        &[
            (
                "patterns/cycle802_nine",
                "_XA _YA _X0 _Y0 _X1 _Y1 _X2 _Y2 _X3 _Y3 _X4 _Y4 _X5 _Y5 _X6 _Y6 _X7 _Y7 _X8 _Y8",
            ),
            ("patterns/cycle802_vari", "_VARI"),
            ("patterns/cycle802_other_plane", "_DMODE"),
            ("patterns/cycle802_argument_24", "S_ABA"),
            ("patterns/cycle802_argument_25", "S_AB0"),
            ("patterns/cycle802_argument_26", "S_AB1"),
            ("patterns/cycle802_argument_27", "S_AB2"),
            ("patterns/cycle802_argument_28", "S_AB3"),
            ("patterns/cycle802_argument_29", "S_AB4"),
            ("patterns/cycle802_argument_30", "S_AB5"),
            ("patterns/cycle802_argument_31", "S_AB6"),
            ("patterns/cycle802_argument_32", "S_AB7"),
            ("patterns/cycle802_argument_33", "S_AB8"),
        ],
    ),
    ("CYCLE94", &[("undercut_cycles/cycle94_by_edge_2", "SPD SPL FORM"), ("undercut_cycles/cycle94_e_10", "_VARI")]),
    ("CYCLE96", &[("undercut_cycles/cycle96_a_m10", "DIATH SPL FORM _VARI")]),
    (
        "CYCLE940",
        &[
            ("undercut_cycles/cycle940_a_allowance_x", "_SPD _SPL _FORM _LAGE _SDIS _FFP _VARI _VRT _MID _FALX _PITI"),
            ("undercut_cycles/cycle940_e_allowance", "_EPD _AMODE"),
            ("undercut_cycles/cycle940_f_allowance_both", "_EPL"),
            ("undercut_cycles/cycle940_t", "_R1 _R2"),
            ("undercut_cycles/cycle940_a_entry_45", "_STA"),
            ("undercut_cycles/cycle940_a_allowance_all", "_FAL"),
            ("undercut_cycles/cycle940_a_allowance_z", "_FALZ"),
            ("undercut_cycles/cycle940_by_table", "_PTABA"),
            ("undercut_cycles/cycle940_other_plane", "_DMODE"),
        ],
    ),
    (
        "CYCLE97",
        &[
            ("thread_cycles/cycle97_cone", "PIT SPL FPL DM1 DM2 APP ROP TDEP NRC VARI"),
            ("thread_cycles/cycle97_metric_size", "MPIT"),
            ("thread_cycles/cycle97_constant_area", "FAL NID"),
            ("thread_cycles/cycle97_flank_infeed", "IANG"),
            ("thread_cycles/cycle97_start_angle", "NSP"),
            ("thread_cycles/cycle97_three_starts_and_angle", "NUMT"),
            ("thread_cycles/cycle97_lift_off", "_VRT"),
        ],
    ),
    (
        "CYCLE98",
        &[
            (
                "thread_cycles/cycle98_all_arguments",
                "PO1 DM1 PO2 DM2 PO3 DM3 PO4 DM4 APP ROP TDEP NRC PP1 PP2 PP3 VARI",
            ),
            ("thread_cycles/cycle98_flank_infeed", "FAL IANG NID"),
            ("thread_cycles/cycle98_start_angle", "NSP"),
            ("thread_cycles/cycle98_two_starts", "NUMT"),
            ("thread_cycles/cycle98_lift_off", "_VRT"),
            ("thread_cycles/cycle98_first_infeed", "_MID"),
            ("thread_cycles/cycle98_gdep", "_GDEP"),
            ("thread_cycles/cycle98_flank_length", "_IFLANK"),
            ("thread_cycles/cycle98_pitch_in_inches", "_PITA"),
            ("thread_cycles/cycle98_other_plane", "_DMODE"),
            ("thread_cycles/cycle98_amode", "_AMODE"),
        ],
    ),
    (
        "CYCLE99",
        &[
            ("thread_cycles/cycle99_clearance", "_SPL _SPD _FPL _APP _ROP _TDEP _NRC _PIT _VARI _SDIS"),
            ("thread_cycles/cycle99_cone", "_FPD"),
            ("thread_cycles/cycle99_degressive", "_FAL _NID"),
            ("thread_cycles/cycle99_flank_infeed", "_IANG"),
            ("thread_cycles/cycle99_start_angle", "_NSP"),
            ("thread_cycles/cycle99_two_starts", "_NUMTH"),
            ("thread_cycles/cycle99_first_infeed", "_MID"),
            ("thread_cycles/cycle99_gdep", "_GDEP"),
            ("thread_cycles/cycle99_changing_pitch", "_PIT1"),
            ("thread_cycles/cycle99_fdep", "_FDEP"),
            ("thread_cycles/cycle99_gst", "_GST"),
            ("thread_cycles/cycle99_gud", "_GUD"),
            ("thread_cycles/cycle99_flank_length", "_IFLANK"),
            ("thread_cycles/cycle99_inch_pitch", "_PITA"),
            ("thread_cycles/cycle99_other_plane", "_DMODE"),
            ("thread_cycles/cycle99_amode", "_AMODE"),
            ("thread_cycles/cycle99_crowned", "_S_XRS"),
        ],
    ),
    (
        "POCKET1",
        &[
            (
                "machining/pocket1_complete",
                "RTP RFP SDIS DPR LENG WID CRAD CPA CPO STA1 FFD FFP1 MID CDIR FAL FFP2 SSF",
            ),
            ("machining/pocket1_roughing", "DP VARI"),
            ("machining/pocket1_finishing_in_levels", "MIDF"),
        ],
    ),
    (
        "POCKET2",
        &[
            ("machining/pocket2_complete", "RTP RFP SDIS DPR PRAD CPA CPO FFD FFP1 MID FAL MIDF FFP2 SSF"),
            ("machining/pocket2_roughing", "DP CDIR VARI"),
        ],
    ),
    (
        "POCKET3",
        &[
            (
                "machining/pocket3_roughing",
                "_RTP _RFP _SDIS _DP _LENG _WID _CRAD _MID _FAL _FALD _FFP1 _FFD _VARI _MIDA",
            ),
            ("machining/pocket3_on_a_helix_turned_about_a_corner", "_PA _PO _STA _RAD1 _DP1 _GMODE"),
            ("machining/pocket3_in_percent_and_incremental", "_CDIR _AMODE"),
            ("machining/pocket3_cleared_before", "_AP1 _AP2 _AD"),
            ("machining/pocket3_in_the_plane_it_names", "_DMODE"),
        ],
    ),
    (
        "POCKET4",
        &[
            ("machining/pocket4_roughing", "_RTP _RFP _SDIS _DP _CDIAM _PA _PO _MID _FAL _FFP1 _FFD _VARI _MIDA"),
            ("machining/pocket4_in_percent", "_FALD _RAD1 _DP1 _AMODE"),
            ("machining/pocket4_finishing", "_CDIR"),
            ("machining/pocket4_cleared_before", "_AP1 _AD"),
            ("machining/pocket4_cleared_before_by_a_stale_size", "_GMODE"),
            ("machining/pocket4_in_the_plane_it_names", "_DMODE"),
        ],
    ),
    (
        "SLOT1",
        &[
            ("machining/slot1_complete", "RTP RFP SDIS DP LENG WID RAD FFD FFP1 MID CDIR FAL FFP2 SSF"),
            ("machining/slot1_three_roughing", "DPR NUM CPA CPO STA1 INDA VARI"),
            ("machining/slot1_finishing_in_levels", "MIDF"),
            ("machining/slot1_to_and_fro_about_its_centre", "_FALD _STA2 _GMODE _DMODE _AMODE"),
        ],
    ),
    (
        "SLOT2",
        &[
            ("machining/slot2_three", "RTP RFP SDIS DP NUM AFSL WID CPA CPO RAD FFD FFP1 MID CDIR FAL MIDF FFP2 SSF"),
            ("machining/slot2_with_an_arc_from_slot_to_slot", "DPR STA1 INDA VARI _FFCP"),
            ("machining/slot2_start_point_only", "_GMODE"),
            ("machining/slot2_to_and_fro", "_DMODE _AMODE"),
        ],
    ),
    (
        "LONGHOLE",
        &[
            ("machining/longhole_four", "RTP _RFP SDIS DP NUM LENG CPA CPO RAD STA1 FFD FFP1 MID"),
            ("machining/longhole_with_codes", "DPR INDA _DMODE _AMODE"),
            ("machining/longhole_of_an_unknown_machining", "_VARI"),
            ("machining/longhole_start_point_only", "_GMODE"),
        ],
    ),
    (
        "CYCLE92",
        &[
            ("machining/cycle92_chamfer", "_SPD _SPL _DIAG1 _DIAG2 _RC _SDIS _SV1 _SV2 _FF1 _FF2 _SS2 _AMODE"),
            ("machining/cycle92_pipe", "_SDAC"),
            ("machining/cycle92_part_catcher", "_DIAGM"),
            ("machining/cycle92_kind_1", "_VARI"),
            ("machining/cycle92_cutting_speed_in_force", "_DN"),
            ("machining/cycle92_other_plane", "_DMODE"),
        ],
    ),
    (
        "CYCLE93",
        &[
            (
                "machining/cycle93_flanks_and_corners",
                "SPD SPL WIDG DIAG ANG1 ANG2 RCO1 RCO2 RCI1 RCI2 FAL1 FAL2 IDEP VARI _VRT",
            ),
            ("machining/cycle93_inclined", "STA1"),
            ("machining/cycle93_chamfers_and_dwell", "DTB"),
            ("machining/cycle93_second_edge", "_DN"),
        ],
    ),
    (
        "CYCLE930",
        &[
            (
                "machining/cycle930_roughing_and_finishing",
                "_SPD _SPL _WIDG _DIAG _ANG1 _ANG2 _RCO1 _RCI1 _RCI2 _RCO2 _FAL _SDIS _VARI _FF1 _NR _AMODE",
            ),
            ("machining/cycle930_other_width", "_WIDG2"),
            ("machining/cycle930_stored_depth_of_the_other_side", "_DIAG2"),
            ("machining/cycle930_inclined_by_angle", "_STA"),
            ("machining/cycle930_in_turns", "_IDEP1"),
            ("machining/cycle930_feed_in_force", "_DN"),
            ("machining/cycle930_several_grooves", "_NUM _DBH"),
            ("machining/cycle930_allowances_along_the_axes", "_FALX _FALZ"),
            ("machining/cycle930_other_plane", "_DMODE"),
            ("machining/cycle930_geometry_code", "_GMODE"),
            ("machining/cycle930_feed_at_the_floor", "S_FB"),
        ],
    ),
    (
        "CYCLE71",
        &[(
            "machining/all_of_cycle71",
            "_RTP _RFP _SDIS _DP _PA _PO _LENG _WID _STA _MID _MIDA _FDP _FALD _FFP1 _VARI _FDP1",
        )],
    ),
    (
        "CYCLE61",
        &[(
            "machining/all_of_cycle61",
            "_RTP _RFP _SDIS _DP _PA _PO _LENG _WID _MID _MIDA _FALD _FFP1 _VARI _LIM _DMODE _AMODE",
        )],
    ),
    (
        "CYCLE76",
        &[
            (
                "machining/all_of_cycle76",
                "_RTP _RFP _SDIS _DP _LENG _WID _CRAD _PA _PO _STA _MID _FAL _FALD _FFP1 _FFD _CDIR _VARI _AP1 _AP2 _DMODE _AMODE",
            ),
            ("machining/all_of_cycle76_by_dpr", "_DPR"),
            ("machining/alarm_spigot_reference", "_GMODE"),
        ],
    ),
    (
        "CYCLE77",
        &[
            (
                "machining/all_of_cycle77",
                "_RTP _RFP _SDIS _DP _CDIAM _PA _PO _MID _FAL _FALD _FFP1 _FFD _CDIR _VARI _AP1 _DMODE _AMODE",
            ),
            ("machining/all_of_cycle77_by_dpr", "_DPR"),
            ("machining/alarm_spigot_start_point_only", "_GMODE"),
        ],
    ),
    (
        "CYCLE79",
        &[
            (
                "machining/all_of_cycle79",
                "_RTP _RFP _SDIS _DP _NUM _SWL _PA _PO _STA _AP1 _MIDA _MID _FAL _FALD _FFP1 _CDIR _VARI _DMODE _AMODE",
            ),
            ("machining/alarm_multi_edge_corner", "_RC"),
            ("machining/alarm_multi_edge_start_point_only", "_GMODE"),
        ],
    ),
    (
        "CYCLE72",
        &[
            (
                "machining/all_of_cycle72",
                "_KNAME _RTP _RFP _SDIS _DP _MID _FAL _FALD _FFP1 _FFD _VARI _RL _AS1 _LP1 _FF3 _AS2 _LP2 _AMODE",
            ),
            ("machining/alarm_path_start_point_only", "_GMODE"),
            ("machining/alarm_path_61101_plane", "_DMODE"),
        ],
    ),
    (
        "CYCLE70",
        &[
            (
                "machining/all_of_cycle70",
                "_RTP _RFP _SDIS _DP _DIATH _H1 _FAL _PIT _MID _FFR _TYPTH _PA _PO _NSP _VARI _DMODE",
            ),
            ("machining/cycle70_with_several_teeth", "_NT"),
            ("machining/cycle70_pitch_in_millimetres_of_a_program_in_inches", "_PITA"),
            ("machining/alarm_thread_start_point_only", "_GMODE"),
            ("machining/cycle70_external_in_passes", "_AMODE"),
        ],
    ),
    (
        "CYCLE90",
        &[
            ("machining/all_of_cycle90", "RTP RFP SDIS DP DIATH KDIAM PIT FFR CDIR TYPTH CPA CPO"),
            ("machining/cycle90_internal", "DPR"),
        ],
    ),
    (
        "CYCLE63",
        &[
            ("machining/cycle63_with_an_island", "_VARI _RP _Z0 _SC _Z1 _F _FZ _MID _UXY _ER _EP"),
            ("machining/cycle63_with_the_edge_of_no_tool", "_DXY _DR"),
            ("machining/cycle63_finishing_the_wall", "_UZ"),
            ("machining/cycle63_finishing_the_floor", "_CDIR"),
            ("machining/cycle63_from_a_start_point", "_XS _YS"),
            ("machining/cycle63_in_two_regions", "_EW"),
            ("machining/cycle63_with_the_material_of_another_tool", "_TR"),
            ("machining/cycle63_with_the_start_point_alone", "_GMODE"),
            ("machining/cycle63_under_g18_in_g17", "_DMODE"),
            ("machining/cycle63_hexagon", "_AMODE"),
        ],
    ),
    (
        "CYCLE95",
        &[
            ("machining/cycle95_complete", "NPP MID FALZ FALX FF1 FF3 VARI"),
            ("machining/cycle95_relief_cut", "FAL FF2"),
            ("machining/cycle95_chips", "DT DAM"),
            ("machining/cycle95_face", "_VRT"),
            ("machining/cycle95_geometry_code", "_GMODE"),
            ("machining/cycle95_other_plane", "_DMODE"),
        ],
    ),
    (
        "CYCLE951",
        &[
            (
                "machining/cycle951_with_transitions",
                "_SPD _SPL _EPD _EPL _LAGE _MID _FALX _FALZ _VARI _RF1 _RF2 _RF3 _SDIS _FF1 _NR _AMODE",
            ),
            ("machining/cycle951_double_cone", "_ZPD _ZPL"),
            ("machining/cycle951_other_plane", "_DMODE"),
        ],
    ),
    (
        "CYCLE952",
        &[
            ("machining/cycle952_residual_material_read", "_CON"),
            ("machining/cycle952_residual_material", "_CONR"),
            ("machining/cycle952_cylinder", "_VARI _F _D _UX _UZ _AMODE"),
            ("machining/cycle952_relief_cut", "_FR"),
            ("machining/cycle952_bore", "_RP"),
            ("machining/cycle952_parallel_allowance", "_U"),
            ("machining/cycle952_further_allowance", "_U1"),
            ("machining/cycle952_allowance", "_BL"),
            ("machining/cycle952_larger_cylinder", "_XD _ZD"),
            ("machining/cycle952_limits_on_all_sides", "_XA _ZA"),
            ("machining/cycle952_limits", "_XB _ZB _GMODE"),
            ("machining/cycle952_chips", "_DI"),
            ("machining/cycle952_clearance", "_SC"),
            ("machining/cycle952_other_plane", "_DMODE"),
            ("machining/cycle952_code_of_plunging", "_PK"),
            ("machining/cycle952_unknown_argument", "_DCH"),
            ("machining/cycle952_face", "_FS"),
        ],
    ),
];

/// Cycle, parameter, and case.
pub fn cases() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    CASES.iter().flat_map(|(cycle, cases)| {
        cases.iter().flat_map(|(case, parameters)| parameters.split(' ').map(|parameter| (*cycle, parameter, *case)))
    })
}
