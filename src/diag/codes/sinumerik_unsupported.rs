//! `S9`: words of SINUMERIK programs that are not compiled.

super::codes! { SINUMERIK_UNSUPPORTED:

S9002 Error "siemens-interpolation" "interpolation that plain G-code cannot say"
"Splines, polynomials, involutes, threads of changing lead and taps that a frame turns have no word in plain G-code. Have the CAM system put out lines and arcs." {
    is_which_plain_g_code_cannot_say(word, what) "{word} is {what}, which plain G-code cannot say"
        help "have the CAM system put out lines and arcs";
    polynomials_cannot_be_printed() "polynomials cannot be printed" help "have the CAM system put out lines and arcs";
    frame_turns(axis) "the frame turns, mirrors or scales {axis}, along which the block taps"
        help "end the frame before G331, and program the hole in plain coordinates";
}

S9004 Error "siemens-synchronized" "synchronized action"
"WHEN, WHENEVER, EVERY, FROM, DO, ID and IDS run beside the program, as signals of the machine come. What they would do cannot be known here. Those that set outputs, markers or the feed only are left out by \
`[control] synchronized_actions = \"leave-out\"`; those that move axes, act on the spindle or call a program never." {
    synchronized_actions_run_beside_program()
        "synchronized actions run beside the program, as the machine's signals come";
    synchronized_action_cannot_be_left_out(shown, reached)
        "the synchronized action `{shown}` cannot be left out: {reached}"
        help "take the action out, and program what it does in blocks of the program";
    synchronized_action_has_no_do_that_can() "the synchronized action has no DO that can be read" alarm 12080
        help "write what it does after DO";
}

S9006 Error "siemens-transformation" "transformation is not supported"
"TRAORI, TRAANG and others turn programmed coordinates into other axes, which needs the kinematics of the machine. CYCLE800 is compiled where it swivels \
axis by axis and turns the rotary axes by itself; its other ways are refused by name. TRANSMIT and TRACYL are \
compiled where `[cycles] transmit` says how they are printed: \"polar\" with X and the rotary axis, \"cartesian\" as the program sees them." {
    procedure_is_not_supported(name, what) "{name} ({what}) is not supported";
    gives_direction_of_tool(letter, number) "{letter}{number}= gives the direction of the tool"
        help "have the CAM system put out three axes, or the rotary axes themselves";
    retraction_fr_i() "the retraction `_FR_I` (argument 15) of CYCLE800 is below 0"
        help "give the way along the tool without sign";
    cycle800_retracts_tool_to_place() "CYCLE800 retracts the tool to a place that is a machine datum";
    cycle800_has_no_retraction(other) "CYCLE800 has no retraction {other}"
        help "0 none, 1 Z, 2 Z and XY, 4 and 5 along the tool";
    cycle800_for_new_plane_deletes_programmed_frames()
        "CYCLE800 for a new plane deletes the programmed frames, and for an additive one takes them over: TRANS, \
        ROT, SCALE or MIRROR is active"
        help "program TRANS without axes before CYCLE800, and the frame again after it";
    cycle800_shifts_workpiece()
        "CYCLE800 shifts the workpiece, and whether X0 and X1 are diameters is not documented"
        help "shift by TRANS in place of CYCLE800";
    cycle800_may_turn_back_to_0(axis) "CYCLE800 may turn {axis} back to 0"
        help "program the rotary axis, and leave CYCLE800 out";
    cycle800_has_no(value, name, at, wanted) "CYCLE800 has no {value} as `{name}` (argument {at})"
        help "give {wanted}";
    cycle800_swivels_in_mode(mode, what)
        "CYCLE800 swivels by {what} (`_MODE` {mode}, argument 4), which is not supported"
        help "swivel axis by axis: `_MODE` 57, 54, 45, 39, 30 or 27";
    cycle800_has_no_order(mode)
        "CYCLE800 has no `_MODE` {mode} (argument 4) with angles: its turns are about X, Y and Z, each once"
        help "give 57 (X Y Z), 54 (Y X Z), 45 (X Z Y), 39 (Z X Y), 30 (Y Z X) or 27 (Z Y X)";
    cycle800_does_more(digit, name, what)
        "CYCLE800 with {digit} as the {name} of `_ST` (argument 3) {what}, which is not supported"
        help "give 0 there, and program what it does in blocks of the program";
    cycle800_turns_frame_only()
        "CYCLE800 with `_DIR` 0 (argument 14) turns the plane and no rotary axis: the tool would not stand along the \
        plane, and what turns the axes after it is not followed"
        help "give -1 or 1, so that the cycle turns the rotary axes";
    cycle800_selects_another_record(name, other)
        "CYCLE800 swivels by the record \"{name}\", and before it by \"{other}\": another head or table, which is not \
        supported"
        help "compile the parts of the two records as two programs";
    cycle800_swivels_deselected_record()
        "CYCLE800 deselects the swivel record (`_TC` \"0\") and gives angles" help "give the name of the record";
    cycle800_swivels_on_lathe()
        "CYCLE800 swivels on a lathe, where how the plane lies to the turning axes is not built yet"
        help "have the CAM system put out the swivelled part by itself";
    cycle800_swivels_in_another_plane()
        "CYCLE800 swivels for a working plane other than G17 (`_DMODE`, or the code in force)"
        help "program G17 before it, and 0 or 1 as the last digit of `_DMODE`";
    cycle800_swivels_while_axes_are_transformed() "CYCLE800 swivels while TRANSMIT or TRACYL is on"
        help "program TRAFOOF before it";
    cycle800_swivels_turned_offset() "CYCLE800 swivels while a turned or scaled work offset is in force" alarm 61186
        help "select a work offset that only shifts, and swivel by CYCLE800 alone";
    cycle800_swivels_under_g500()
        "CYCLE800 swivels under G500, and its positions are printed in machine coordinates"
        help "select a work offset before it: G54";
    cycle800_swivels_diameters() "CYCLE800 turns X into another direction while X is programmed as a diameter"
        help "program DIAMOF before it";
    machines_in_axes_that_target_may_not(word, what)
        "{word} machines the {what} in axes that the target may not have"
        asks "set `[cycles] transmit = \"polar\"` for X and the rotary axis, or \"cartesian\" for a control that \
        transforms by itself";
}

S9007 Error "siemens-other-spindle" "word for another spindle"
"Threads, tapping and G96 follow the master spindle (SETMS); the target follows its first one, so they are refused while another is the \
master. Speed, sense of rotation and stop at an angle of further spindles are printed where the target has words for them." {
    follows_spindle(what, master)
        "{what} follows spindle {master}, the master; the target follows its first spindle"
        help "make spindle 1 the master: SETMS(1)";
}

S9008 Error "siemens-axis-motion" "axis motion that cannot be printed"
"Positioning axes that run beside the path, and approaches of machine-fixed points, need data of the machine. Reference and fixed points can be \
given under [machine]." {
    is_positioning_axis_while_frame_is_turned(axis)
        "{axis} is a positioning axis while the frame is turned or scaled" alarm 16430
        help "program the axis by G0 or G1";
    pos_beside_path_motion() "POS beside a path motion: the two run at the same time"
        help "give POS a block of its own";
    axis_that_moves_beside_path_cannot() "an axis that moves beside the path cannot be printed"
        asks "move the axis in a path block, or by POS[…]; leave out an axis that the target does not have: \
        `[machine] axes`";
    where_moves_to_is_machine_datum(word, letter, key) "where {word} moves {letter} to is a machine datum"
        asks "give it in machine coordinates: `[machine] {key} = {{ {letter} = 0.0 }}`";
}

S9009 Error "siemens-feed-kind" "kind of feed that cannot be printed"
"G931 and the feeds that are kept at a switch cannot be printed. Under G93 F is the time of its own block: roundings, chamfers, cycles and \
radius compensation have no share of it. Program the feed by G94 or G95." {
    gives_feeds_that_plain_g_code_cannot(word) "{word} gives feeds that plain G-code cannot say"
        help "program the feed by G94 or G95";
    ovra_changes_feed_of_axis_or_speed()
        "OVRA[…]= changes the feed of an axis or the speed of a spindle by a factor"
        help "program the feed itself, and OVRA[…]=100";
    ovr_changes_every_feed_by_factor() "OVR= changes every feed by a factor"
        help "program the feed itself, and OVR=100";
    corner_has_no_share_of_time() "a chamfer or rounding has no share of the time that G93 gives the blocks"
        help "program the feed by G94 or G95 for it";
    time_under_compensation_is_of_target()
        "under radius compensation the length of the path, and so the time of G93, is the target's"
        help "program the feed by G94 or G95 for it";
    moves_of_cycle_have_no_share_of_time() "the moves of a cycle have no share of the time that G93 gives the blocks"
        help "program the feed by G94 or G95 for it";
}

S9011 Error "siemens-machine-coordinates" "cannot be printed in machine coordinates"
"Under G53, G153, SUPA and G500 only straight absolute moves can be printed. Look at the word that is marked, and at the value after it." {
    as_g500_wants(message) "{message}, as G500 wants"
        asks "select a work offset (G54) for it, say which one G500 is (`[datums] G500 = \"G55\"`), or have the \
        program write its offsets";
    positioning_axis_in_machine_coordinates()
        "a positioning axis in machine coordinates or without its tool offset cannot be printed"
        help "program the axis by G0 or G1 in this block";
    increment_in_machine_coordinates_starts_from_place()
        "an increment in machine coordinates starts from a place that only the machine knows"
        help "program the machine coordinate with AC(…) or under G90";
    in_machine_coordinates_only_straight_moves_can() "in machine coordinates only straight moves can be printed"
        help "program G0 or G1 with axes in this block";
}

S9012 Error "siemens-thread-start" "start angle of a thread"
"The target starts every thread at the same angle of the spindle. SF= is made by a start that lies farther back along the thread by lead · angle / 360; \
in a chain of threads, after a chamfer or rounding and in a turned or scaled frame that cannot be done. Shift the start point in the program." {
    whether_holds_for_threads_of_cycle(start_angle, value)
        "whether `{start_angle}={value}` holds for the threads of a cycle is not known"
        help "set it to 0 before the cycle: {start_angle}=0";
    start_angle_of_thread_cannot_be_made(why)
        "the start angle of the thread cannot be made by a shift of its start: {why}"
        help "program the start point farther back by lead · angle / 360, and no SF=";
    start_angle_lies_outside_0_to_359(word, start) "the start angle {word}={start} lies outside 0 to 359.999"
        help "program the angle within one turn";
}

S9101 Error "siemens-modulo-shift" "sense of a modulo axis under a shift"
"An absolute position of a rotary axis that counts modulo 360 degrees is reached inside the turn in which the axis stands. Where its zero is shifted \
(TRANS, `$P_UIFR`) the turn begins elsewhere in the program than on the machine, so the sense of rotation is not known. Write DC, ACP or ACN, or \
set `[control] md30455 = \"shortest\"` if the machine takes the short way." {
    sense_in_which_turns_is_not_known(letter)
        "the sense in which {letter} turns is not known: its zero is shifted, and it counts modulo 360"
        help "write {letter}=DC(…), ACP(…) or ACN(…)";
}

S9103 Error "siemens-setting" "setting datum is changed"
"Setting data (`$SC_…`, `$SN_…`) change what other words of the program do. Those that partc knows are followed; this one is not. If the machine has the \
value anyhow, say so under [variables], and the block is left out." {
    is_setting_datum(word, key, shown) "`{word}` is a setting datum, and what it changes is not compiled"
        asks "leave it out; if the machine has this value anyhow, say so under [variables]: \"{key}\" = {shown}";
}

S9013 Error "siemens-oblique-circle" "circle stands obliquely in space"
"Plain G-code has circles in the main planes only. Look at the word that is marked, and at the value after it." {
    circle_stands_obliquely_in_space() "the circle stands obliquely in space"
        help "plain G-code has circles in the main planes only; have the CAM system put out lines";
}

S9015 Error "siemens-cycle-variant" "variant of a cycle is not supported"
"The cycle is built, but not this variant of it, or the meaning of a coded argument is not confirmed. Use the plain variant, or plain moves." {
    chamfering_units_of_vari_is_not_supported() "chamfering (units of `_VARI`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    this_kind_of_area() "this kind of area, a spigot or residual material (`_VARI`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    residual_material_of_another_tool() "residual material of another tool (`_TR`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    one_of_limits_without_other_one(names)
        "one of the limits {names} without the other one on this side of the part is not supported"
        help "use the plain variant of the cycle, or plain moves";
    residual_material() "residual material, whose blank the control keeps in a file, is not supported"
        help "use the plain variant of the cycle, or plain moves";
    further_allowance_u1_on_contour_that_falls()
        "the further allowance `_U1` on a contour that falls, whose walls it would move to one side, is not \
        supported"
        help "use the plain variant of the cycle, or plain moves";
    cutting_parallel_to_contour() "cutting parallel to the contour (units 3 of `_VARI`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    this_process_vari_has_7_digits()
        "this process (`_VARI` has 7 digits): grooving, plunge turning and residual material is not supported"
        help "use the plain variant of the cycle, or plain moves";
    at_diameter_diagm_cut_stops(args, diameter)
        "{args}: at diameter {diameter} (`_DIAGM`) the cut stops and a program of the machine builder brings the \
        part catcher out"
        asks "give `_DIAGM` 0; or leave the catcher out, with the same cut: `[cycles] parts_gripper = \"ignore\"`";
    whether_tool_lifts_off_under_gmode(args, digit)
        "{args}: whether the tool lifts off under `_GMODE` {digit} is not known"
        asks "say what the machine does: `[control] cycle86_lift = \"lift\"` or `\"none\"`";
    this_unit_of_pitch() "this unit of the pitch (`_PITA`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    this_use_of_encoder() "this use of the encoder (ENC) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    start_angle_of_machine_data() "the start angle of the machine data (a negative POSS) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    another_digit_than_1_in_thousands()
        "another digit than 1 in the thousands and ten thousands of `_VARI` is not supported"
        help "use the plain variant of the cycle, or plain moves";
    feed_of_its_own_at_floor() "a feed of its own at the floor (`S_FB`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    inclined_groove() "an inclined groove (`_STA`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    inclined_groove_nr_2_is_not() "an inclined groove (`_NR` 2) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    kind_of_machining_without_1_at_ten()
        "a kind of machining without 1 at the ten thousands (`_VARI`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    groove_in_inclined_surface() "a groove in an inclined surface (STA1) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    under_mirrored_or_turned_frame_programmed_corner(args)
        "{args}: under a mirrored or turned frame the programmed corner of the tool would lie elsewhere"
        help "cancel MIRROR and ROT before the cycle";
    plane_other_than_active_one() "a plane other than the active one (`_DMODE`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    under_frame_that_turns_part_by_angle(args)
        "{args}: under a frame that turns the part by an angle the nose of the tool lies beside the path that would \
        be printed"
        help "cancel ROT before the cycle";
    turning_cycle_in_another_plane_than_g18()
        "a turning cycle in another plane than G18 (units of `_DMODE`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    frame_mirrors_or_tilts_tool_axis(args)
        "{args}: a frame mirrors or tilts the tool axis, and the tool would come from the far side"
        help "turn and mirror in the plane of the cycle only";
    this_plane_units_of_dmode_is_not() "this plane (units of `_DMODE`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    offn_is_in_force(args, normal)
        "{args}: OFFN={normal} is in force, and is not supported in the path of this cycle"
        help "program OFFN=0 before the cycle, and leave material by the allowances of the cycle";
    digit_at_place_is_not_supported(args, digit, place, name)
        "{args}: the digit {digit} at place {place} from the right of `{name}` is not supported"
        help "use the plain variant of the cycle, or plain moves";
    is_not_supported(args, what) "{args}: {what} is not supported"
        help "use the plain variant of the cycle, or plain moves";
    whether_its_lengths_along_are_diameters_under(name, axis)
        "{name}: whether its lengths along {axis} are diameters under DIAMON is not documented"
        help "program DIAMOF before the cycle, and radii in it";
    plane_or_unit_was_changed_since_mcall()
        "the plane or the unit was changed since MCALL: the hole would go elsewhere"
        help "call the cycle again after G17, G18, G19, G70 or G71";
    this_plane_dmode_is_not_supported() "this plane (`_DMODE`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    axis_by_axn_outside_g17()
        "an axis by `_AXN` outside G17, which may count the axes of the plane or of the machine, is not supported"
        help "use the plain variant of the cycle, or plain moves";
    line_at_right_angle_to_contour(name) "a line at a right angle to the contour (`{name}`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    cycle72_runs_contour_backwards()
        "CYCLE72 runs the contour backwards: whether `_RL` is seen in the direction of travel or of the contour is \
        not confirmed"
        asks "say it by `[cycles] backward_side = \"travel\"` or \"contour\", or turn the contour around";
    variant_of_pattern() "a variant of the pattern (`_VARI`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    another_first_position() "another first position (`_NSP`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    hidden_positions() "hidden positions (`_HIDE`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    mask_that_is_not_111111111() "a mask that is not 111111111, all absolute (`_XA`, `_YA`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    further_arguments_of_cycle802_is_not_supported() "further arguments of CYCLE802 is not supported"
        help "use the plain variant of the cycle, or plain moves";
    pattern_with_modal_program_of_ones_own() "a pattern with a modal program of one's own is not supported"
        help "use the plain variant of the cycle, or plain moves";
    oblique_grid_is_not_supported() "an oblique grid is not supported"
        help "use the plain variant of the cycle, or plain moves";
    this_variant_of_pattern() "this variant of the pattern (`_VARI`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    helix_in_slot() "a helix in a slot (tens of `VARI`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    speed_for_finishing_under_g96_is_not() "a speed for finishing under G96 is not supported"
        help "use the plain variant of the cycle, or plain moves";
    cycle79_whether_edge_or_corner_of_multi()
        "CYCLE79: whether an edge or a corner of the multi-edge lies on the first axis is not confirmed"
        asks "say it by `[cycles] multi_edge_start = \"edge\"` or \"corner\"";
    transition_at_corners_of_multi_edge() "a transition at the corners of a multi-edge (`_RC`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    cycle79_on_round_blank_is_not_supported(flats, edges, place)
        "CYCLE79: {flats} on a round blank (`_NUM` {edges}, argument {place}) is not supported"
        help "mill each flat by CYCLE61 or CYCLE72, or by plain moves";
    cycle77_in_its_old_form_of_16()
        "CYCLE77 in its old form of 16 arguments: whether the sixth one is the diameter or the radius of the spigot \
        is not confirmed"
        asks "say it by `[cycles] spigot_size = \"diameter\"`, or write the call with the codes after `_AP1`";
    infeed_along_one_flank()
        "an infeed along one flank (`_VARI`) with the negative angle of an alternating one is not supported"
        help "use the plain variant of the cycle, or plain moves";
    digit_at_place_from_right_of_vari(digit, place)
        "the digit {digit} at place {place} from the right of `_VARI`, whose meaning is not confirmed, is not \
        supported"
        help "use the plain variant of the cycle, or plain moves";
    thread_leans_out_of_z(args, angle)
        "{args}: the thread leans {angle:.1} degrees out of Z, and over 45 degrees it is a face thread: from which side \
        the control feeds in, and how run-in and lift-off count, is not published"
        help "cut a face thread by blocks: G0 to the depth of the pass in Z, then G33 X… I… with the pitch along X";
    part_of_thread_leans_out_of_z(args, part, angle)
        "{args}: part {part} of the thread leans {angle:.1} degrees out of Z, and over 45 degrees it is a face thread: from which side \
        the control feeds in, and how run-in and lift-off count, is not published"
        help "cut a face thread by blocks: G0 to the depth of the pass in Z, then G33 X… I… with the pitch along X";
    pitch_in_inches() "a pitch in inches, turns or modules (`_PITA`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    digit_at_place_from_right_of_amode(digit, place)
        "the digit {digit} at place {place} from the right of `_AMODE`, which was never seen, is not supported"
        help "use the plain variant of the cycle, or plain moves";
    choice_of_first_start_that_is_cut(first)
        "the choice of the first start that is cut (`_GST` {first}), whose order is not confirmed, is not supported"
        help "use the plain variant of the cycle, or plain moves";
    passes_contradict_infeed(args, passes, cuts)
        "{args}: the number of passes `_NRC` is {passes}, and the infeed `_MID` makes {cuts}: which of them counts is not known"
        help "leave one of them 0";
    cycle70_what_tens()
        "CYCLE70: what the tens and hundreds of `_VARI` mean, sense and hand of the thread, is not confirmed"
        asks "have them read by `[cycles] thread_milling_digits = true`: tens 1 down, 2 up; hundreds 1 left-hand";
    this_kind_of_machining() "this kind of machining (`_VARI`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    another_reading_of_argument() "another reading of an argument (`_AMODE`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
    thread_by_name_of_table() "a thread by the name of a table (`_PTAB`, `_PTABA`) is not supported"
        help "use the plain variant of the cycle, or plain moves";
}

S9016 Error "siemens-offsets-off" "move without tool offsets"
"D0 switches the offsets of the tool off, so that positions count for the spindle nose. The target knows positions of the tool tip only. \
Moves in machine coordinates (SUPA, G53, G500) can be printed." {
    under_d0_position_counts_without_length() "under D0 the position counts without the length of the tool"
        help "program the retraction in machine coordinates (SUPA, G53), or select D1 before";
}

S9017 Error "siemens-mixed-offsets" "work offset of the program beside one of the machine"
"A work offset that the program writes ($P_UIFR) is put into the coordinates, which then count from the basic system. Offsets that it only \
selects are those of the machine, whose values are not known. Between the two no way can be computed. Use the one kind or the other." {
    program_uses_work_offset_that_it_writes()
        "the program uses a work offset that it writes itself beside one of the machine"
        help "let it write all the offsets it uses, or none";
}

S9018 Warning "siemens-save-offset" "SAVE and a changed work offset"
"A program with SAVE changed the frame of the work offset that is in force before and after it. Bit 0 of machine datum 10617 decides whether the frame of the \
call comes back; it is read as 0: the frame stays. Set `[control] md10617`, or select the offset again in the calling program." {
    program_with_save_changed_frame_of_work()
        "the program with SAVE changed the frame of the work offset; it stays changed (MD 10617, bit 0 = 0)";
}

S9019 Error "siemens-contour-open" "stored contour cannot be made"
"The NC blocks of a contour of the contour editor are missing, and its hidden records leave elements open. Open the contour in the editor \
of the control and accept it again." {
    contour_has_no_blocks(what) "the contour has no blocks, and its records do not make it: {what}";
    contour_has_no_blocks_and_its_records(what)
        "the contour has no blocks, and its records are not complete: {what}"
        help "open the contour in the editor of the control and accept it again";
    contour_has_no_blocks_and_its_records_are_for_another()
        "the contour has no blocks, and its records are for another plane"
        help "select the plane of the contour before it, or accept it in the editor again";
    contour_has_no_blocks_and_they_are_not(what)
        "the contour has no blocks, and they are not made from its records: {what}";
}

S9020 Error "siemens-contour-cycle" "contour cycle is not supported"
"The arguments of the cycle were read and its contour was run and checked, so what is reported about them is true. But the tracks of the cycle are \
computed inside the control and are not published. Replace it by plain moves, or have the CAM system put them out." {
    cycle_is_not_supported(args, what) "{args} ({what}) is not supported"
        help "replace it by plain moves, or have the CAM system put them out";
    cycle_is_read_without_fault(args, what, shown) "{args} ({what}) is not supported; read without a fault: {shown}"
        help "replace it by plain moves, or have the CAM system put them out";
}

S9021 Error "siemens-edge-length" "edge of another length than D1"
"The target has one length for a tool and prints the positions of the program. Of an edge whose length is another one ($TC_DP3 to $TC_DP5) they would be off by the difference. \
Give the edge a tool number of its own." {
    length_of_d_of_t_is_mm(parameter, edge, number, other, first)
        "length {parameter} of D{edge} of T{number} is {other} mm, and that of D1 is {first} mm: the target has one \
        length for a tool"
        help "give the edge a tool number of its own";
}

S9130 Error "siemens-left-out-position" "position that only an axis that is left out makes"
"Under MCALL each block that moves an axis calls the program or cycle. Here the axis is left out by `[machine] axes`, so that every call would work at one \
place. Print the axis, or end the modal call before." {
    takes_modal_call_to_another_place(named) "{named} takes the modal call to another place, and is left out"
        asks "print the axis (`[machine] axes`), or end the modal call before this block";
}

S9131 Error "siemens-g500-unrelated" "G500 beside a work offset of the machine"
"Positions under G500 count from the basic system, those under G54 from where the machine has that offset. The way between the two is known on the machine only. \
Give the basic frame (`[datums] basic`), the values of the offset (`[datums] G54 = { X = … }`), or the offset that G500 stands for (`[datums] G500 = \"G55\"`). \
A retraction in machine coordinates is SUPA or G53." {
    work_offset_of_machine(what)
        "{what} a work offset of the machine, and where it lies from the basic system is not known"
        asks "give the basic frame (`[datums] basic = {{ X = 0.0, Y = 0.0, Z = 0.0 }}`), the values of the offset \
        (`[datums] G54 = {{ … }}`), or the offset that G500 stands for (`[datums] G500 = \"G55\"`)";
    moves_under_g500_stand_in_front(word)
        "moves under G500 stand before {word}: they were printed as they stand, before a work offset was \
        selected";
}

S9132 Error "siemens-word-not-compiled" "word of the control that is not compiled"
"The word belongs to the language and is no missing program: what it does has no word in plain G-code, or is not built. The text says what it is and what to write \
instead. Nothing is left out in silence, so the program is refused." {
    is_not_compiled(symbols, what) "{symbols} ({what}) is not compiled";
    scc_refers_g96(named) "SCC refers G96 to {named}, which is not the diameter axis"
        asks "name it: `[machine] diameter_axis`, or program S in turns under G97";
}

S9133 Error "siemens-measuring-data" "data of the measuring cycles"
"Measuring cycles take their arguments from global variables of the control (`_MVAR`, `_SETVAL`, `_PRNUM` …) and put their results into others (`_OVR`, `_OVI`). They are not defined in the \
program, and no DEF answers: what is measured is known at the machine only. Leave the measuring out: `[control] probing = \"leave-out\"`; results are asked for under [variables] then." {
    is_of_measuring_cycles(word, what)
        "`{word}` is {what} of the measuring cycles, which the control keeps in its global data";
    is_result_of_measuring_cycles(key, said_meaning) "`{key}` is a result of the measuring cycles{said_meaning}";
}

S9022 Error "siemens-value-of-action" "value that a left-out synchronized action sets"
"The program reads a variable that a synchronized action sets beside it. The action is left out, and when it would have set the value is known at the machine only. Compute the value in the program." {
    is_set_by_synchronized_action_in_line(name, line)
        "`{name}` is set by the synchronized action in line {line}, which is left out: its value is not known";
}

S9023 Error "siemens-move-from-probe" "move from where a probe stopped"
"A block with MEAS is left out with its move, so the target does not stand where the probe stopped. A move that does not name these axes would go on at another place than on the control. After a measuring \
cycle the same holds for moves that cut. Program these axes in absolute coordinates first." {
    this_block_moves(letters)
        "this block moves without {letters}, and where a probe left {letters} is known at the machine only";
}

S9024 Error "siemens-measured-offset" "measuring cycle corrects a work offset"
"The cycle corrects a work offset by what it measures, so that blocks after it count from another place than those before it. If the work offset of the target is set as the cycle sets it \
before the program runs, and nothing but the probe has worked before it, say so: `[control] probing_datum = \"set\"`." {
    corrects_work_offset_by_what_it_measures(name, which) "{name} corrects a work offset{which} by what it measures"
        asks "if the work offset of the target is already as this cycle sets it when the program starts, set \
        `[control] probing_datum = \"set\"`";
    corrects_work_offset_by_what(name, which) "{name} corrects a work offset{which} by what it measures";
    coordinates_count_from_basic_system(message)
        "{message}, and the coordinates count from the basic system, or from an offset that the program writes"
        help "select a work offset of the machine: G54";
    another_tool_worked_before(message)
        "{message}, and another tool worked before it: one work offset cannot be both"
        help "split the program before the cycle";
}
}
