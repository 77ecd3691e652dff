//! `K9`: Klartext that partc does not compile.

super::codes! { KLARTEXT_UNSUPPORTED:

K9002 Error "fk-unsupported" "free contour (FK) that partc cannot construct"
usual "write the end point of an element more"
"The data of a free contour may be enough, but partc finds no element that it can construct from what is known, or too many elements or solutions wait for each other (64). Write an \
end point more. Most controls can also convert an FK program to conventional blocks (CONVERT PROGRAM)." {
    too_many_blocks(name) "too many blocks from this {name} on, or too many solutions, are still open"
        help "write the end point of an element between them";
    blocks_behind_have_data_enough(name)
        "{name} and the blocks after it have data enough, and partc knows no way to construct them";
    has_ccpr_lacks_ccpa(name)
        "{name} has CCPR and lacks CCPA: partc cannot construct an arc whose centre lies anywhere on a circle about \
        the pole"
        help "write CCPA, the angle of the centre about the pole";
    too_many_blocks_stand_between_elements() "too many blocks stand between elements that are still open"
        help "write the end point of an element before them";
}

K9003 Error "approach-unsupported" "this form of APPR or DEP is not supported"
usual "program the approach and the departure as L and C blocks"
"All eight forms are compiled onto a contour with RL or RR, and from it. Its first element has to have a direction of its own: a line, or an arc by centre or \
radius; so has the last one. Not supported are scaling, an approach while RL or RR is active, R0 on newer controls, and LN where the target compensates. \
Program the approach as L and C blocks." {
    approach_or_departure_under_scaling_is_not() "an approach or departure under scaling is not supported"
        help "reset the scaling before the contour";
    about_pole_of_another_plane(name) "{name} about a pole of another plane";
    is_not_supported_where_target_compensates(name)
        "{name} is not supported where the target compensates: it would not come straight to the contour"
        asks "set `[output] compensation = \"resolve\"`, or write LT or CT";
    is_not_supported(name) "{name} is not supported";
    no_contour_element_follows(approach) "no contour element follows {approach}"
        help "let a path block follow directly";
    with_tool_axis_is_not_supported(a) "{a} with the tool axis is not supported for this control"
        help "write the depth into a block before the approach";
    leads_onto_block_whose_direction_is_not(approach)
        "{approach} leads onto a block whose direction is not known here"
        help "let a straight line or an arc of the working plane with centre or radius follow";
    with_r0_is_not_supported(name) "{name} with R0 is not supported: the control refuses it"
        help "write RL or RR, or program the approach as L and C blocks";
    starts_beside_contour(name) "{name} starts beside a contour: no block has led away from it in the working plane"
        help "program a straight block with R0 to the start of the approach";
    while_rl_or_rr_is_active(name)
        "{name} while RL or RR is active is not supported: what controls make of it differs"
        help "program DEP or a block with R0 before it";
    with_tool_axis_under_m103_is_not(name) "{name} with the tool axis under M103 is not supported"
        help "write the depth into a block before the approach";
    has_no_end_point_away_from_contour(name)
        "{name} has no end point away from the contour: the tool would go onto its last point"
        help "program the end point of the departure";
    follows_block_whose_direction_is_not_known(name) "{name} follows a block whose direction is not known here"
        help "let a straight line or an arc of the working plane with centre or radius stand before it";
    stands_behind_block_that_leads_to_contour(name)
        "{name} stands after the block that leads to the contour, which has no element yet"
        help "program one element of the contour at least";
    is_supported_behind_contour_with_rl(name) "{name} is supported after a contour with RL or RR"
        help "program the departure as L and C blocks";
}

K9004 Error "tilting-unsupported" "tilted working plane that cannot be compiled"
usual "have the CAM system put out the plane by space angles (PLANE SPATIAL … TURN)"
"PLANE functions and cycle 19 turn the coordinate system in space. Space angles, Euler angles, vectors, points and RELATIVE say where the plane lies; axis angles \
and projected angles, MOVE, SYM and words of a machine do not, unless the machine is known. Have the CAM system put out the tilted work by space angles." {
    moves_while_coordinates_are_turned_about_z(axis)
        "{axis} moves while the coordinates are turned about Z, and the turn is printed already"
        help "leave the move out, or program the rotary axis without PLANE, cycle 19 and TCH PROBE 404";
    cycle_19_sets_rotary_table_to_angle()
        "cycle 19 sets the rotary table to an angle, which only the machine can turn into coordinates";
    cycle_19_tilts_working_plane_by_b(a, b, c)
        "cycle 19 tilts the working plane by A{a:+} B{b:+} C{c:+}, which cannot be compiled for three axes";
    sets_rotary_table_to_angle(plane)
        "{plane} sets the rotary table to an angle, which only the machine can turn into coordinates";
    tilts_working_plane(plane, words)
        "{plane} tilts the working plane by {words}: where it lies then is known at the machine";
    tilts_under_another_tool_axis(axis) "the working plane tilts under the tool axis {axis}, which is compiled for Z only";
    data_are_no_plane(plane, words) "{plane} has data that make no plane: {words}";
    vectors_are_not_perpendicular(plane, words)
        "{plane} has vectors that are not perpendicular ({words}), of which controls make different planes"
        help "write a vector B that is perpendicular to N";
    sym_counts_from_point_of_machine(plane)
        "{plane} chooses by SYM, which counts from a point of the machine" help "choose by SEQ";
    moves_tool_while_axes_turn(plane)
        "{plane} moves the tool with the part while the rotary axes turn (MOVE), beside the part"
        help "retract the tool and write TURN";
    names_none_of_stay_turn_move(plane) "{plane} names none of STAY, TURN and MOVE"
        help "say what the rotary axes do: `TURN FMAX`, or `STAY`";
    retracts_at_open_feed(plane) "{plane} retracts the tool by MB, and no F says how fast"
        help "write FMAX, or a number for F";
    cycle_19_leaves_angle_open()
        "cycle 19 tilts the working plane and does not name each of A, B and C: what the others are is open"
        help "write all three: `CYCL DEF 19.1 A+20 B+0 C+30`";
    cycle_19_turns_axes_by_itself()
        "cycle 19 turns the rotary axes by itself here, along with the tool"
        help "leave F and the distance out, and turn the axes by `L A+Q120 C+Q122 R0 FMAX` after a retraction";
    turns_plane_by_unsettled_words(plane) "{plane} turns the plane by words whose sense no manual page settles";
    holds_word_that_is_not_known(plane) "{plane} holds a word that is not known, so its plane is open";
    retracts_tool_by_mb(plane) "{plane} retracts the tool by MB before it turns, which cannot be compiled";
    needs_each_of_spa_spb_spc(plane)
        "{plane} needs each of SPA, SPB and SPC once and no other angle, so its plane is open";
    needs_each_of_eulpr_eulnu_eulrot(plane)
        "{plane} needs each of EULPR, EULNU and EULROT once and no other angle, so its plane is open";
    does_not_hold_words_of_this_plane(plane)
        "{plane} does not hold the words that this kind of plane needs, so its plane is open";
    moves_rotary_axes_turned_by_program(what) "{what} moves the rotary axes, and the program has turned them";
    turns_about_z(what, axis) "{what} turns about Z, which tilts the plane of the tool axis {axis}";
}

K9005 Error "touch-probe" "touch probe cycles run only at the machine"
"The block measures the workpiece or the tool; its result is known at the machine only. Remove it, or compile the part of the program after the setup." {
    touch_probe_cycles_run_only_at_machine() "touch probe cycles run only at the machine"
        asks "remove the block, or set `[control] probing = \"leave-out\"` if the part is set up before the program";
    ends_basic_rotation_or_goes_on(number)
        "TCH PROBE {number} ends the basic rotation of TCH PROBE 404, or goes on with it: which is open"
        help "end the basic rotation before it: TCH PROBE 404 with Q307=+0";
    sets_datum_by_what_it_measures(number) "TCH PROBE {number} sets the datum by what it measures"
        asks "`[control] probing_datum = \"refuse\"` compiles no such program";
    sets_datum_at_known_place(number, lay, reads)
        "TCH PROBE {number} sets the datum: what lay at {lay} reads {reads} from here on"
        asks "`[control] probing_datum = \"refuse\"` compiles no such program";
    turns_part_or_its_coordinates(number)
        "TCH PROBE {number} turns the part or its coordinates by what it measures"
        asks "`[control] probing_datum = \"refuse\"` compiles no such program";
    is_cycle_of_machines_builder(number)
        "TCH PROBE {number} is a cycle of the machine's builder and may set the datum"
        asks "`[control] probing_datum = \"refuse\"` compiles no such program";
    writes_basic_rotation_into_preset_table()
        "TCH PROBE 404 writes the basic rotation into a row of the preset table (Q305), which only the machine has"
        help "write Q305=+0, which sets the rotation at once, or turn the coordinates by cycle 10";
    turns_coordinates_about_z(axis)
        "TCH PROBE 404 turns the coordinates about Z, and the tool axis is {axis}"
        help "turn the coordinates by cycle 10";
}

K9006 Error "file-function" "table and file functions run only at the control"
usual "put the values into the program"
"The block opens, reads or writes a file of the control. What it reads is not known here, and what it writes would be missing there. \
Put the values into the program instead." {
    fn_works_on_table_of_control(number) "FN {number} works on a table of the control";
}

K9008 Error "m-function-unsupported" "M function changes the path in a way that is not supported"
"The function moves the tool, changes what coordinates mean, or needs the geometry of the machine. It is refused rather than left out." {
    what_m109() "what M109 and M110 make of the feed on the arc of APPR or DEP is not known"
        help "program M111 before it, and M109 or M110 in the first block of the contour";
    m109_m110_change_feed_on_compensated_arcs()
        "M109 and M110 change the feed on compensated arcs, which the target computes";
    m98_opens_corner_at_end()
        "M98 opens the corner at the end of this block, and the way from one side to the other is not confirmed"
        asks "program the corner as two contours, or set `[control] m98 = \"line\"`";
    unit_of_f_under_m136_in_inch() "the unit of F under M136 in an INCH program is not documented";
    m_changes_compensated_path(m) "M{m} changes the compensated path, which the target computes"
        help "remove it if the tool fits into every corner, or program the contour so that it is not needed";
    m130_takes_this_block_out_of_working()
        "M130 takes this block out of the working plane that PLANE or cycle 19 turned"
        help "reset the plane before the block, and program it again after";
    m(m, what) "M{m} {what}";
    m140_retracts_along(axis) "M140 retracts along {axis}, and {axis} is mirrored or turned here"
        help "reset the mirror or rotation before M140";
    machine_coordinates() "machine coordinates (M91) are supported in L blocks with absolute words"
        help "write `L Z+0 R0 FMAX M91`";
    m92_counts_from_position_that_machine_builder(axis, name)
        "M92 counts from a position that the machine builder sets, and where it lies along {axis} is not known"
        asks "say it in machine coordinates: `[datums] {name} = {{ X = …, Y = …, Z = … }}`; or program workpiece \
        coordinates, or M91";
    m91_m92_count_from_two_places() "M91 and M92 count from two places" help "write one of the two";
    under_m128_tool_tip_stays_while_turns(axis)
        "under M128 the tool tip stays while {axis} turns, so the other axes move with it"
        help "use 3-axis output of the CAM system";
    m128_makes_control_follow_tool_tip()
        "M128 makes the control follow the tool tip with the rotary axes, and they are turned"
        help "use 3-axis output of the CAM system";
    m143_ends_basic_rotation()
        "M143 ends a basic rotation, and the one that a touch probe cycle measured is known only at the machine"
        help "take M143 out, and set the part up without a basic rotation; or split the program here";
    under_m126_it_is_open_whether_i(axis, step)
        "under M126 it is open whether I{axis}{step:+} goes its own way or the short one"
        help "program M127 first, or the absolute angle";
}

K9010 Error "pattern-unsupported" "no pattern is in force"
usual "put the points into the program: `PATTERN DEF POS1 (X+12 Y+20 Z+0)`"
"CYCL CALL PAT runs over the places of PATTERN DEF, or of the point table that SEL PATTERN names, and neither stands before it in the program. The control may have a \
table selected by hand. Put the points into the program: `PATTERN DEF POS1 (X+12 Y+20 Z+0)`, or select the table: `SEL PATTERN \"HOLES.PNT\"`." {
    cycl_call_pat_runs_over_pattern()
        "CYCL CALL PAT runs over a pattern, and neither PATTERN DEF nor SEL PATTERN is in force"
        help "put PATTERN DEF or SEL PATTERN before it";
}

K9012 Error "datum-table" "datum table is not available"
usual "program the values: `CYCL DEF 7.1 X+60`"
"A datum shift takes a row of a datum table, and no table is selected in the program; the control may have one selected by hand. Select it (`SEL TABLE \"NAME.D\"`), \
name it in partc.toml (`[control] datum_table = \"NAME.D\"`), or program the values: `CYCL DEF 7.1 X+…`." {
    no_datum_table_is_selected() "no datum table is selected"
        asks "select it in the program, `SEL TABLE \"NAME.D\"`, or name the file in partc.toml: `[control] \
        datum_table = \"NAME.D\"`";
}

K9013 Error "feed-form" "feed per tooth without the teeth, or feed by time"
"FZ is a feed per tooth: it needs the number of teeth, `[tools.N] teeth` or CUT of the tool table. FT and FMAXT give the time of the block, which is not \
compiled. Program the feed in mm/min (F) or mm per revolution (FU)." {
    fz_is_feed_per_tooth(called) "FZ is a feed per tooth, and how many teeth tool {called} has is not known"
        asks "add `[tools.{called}]` with `teeth = …` to partc.toml, or CUT to the tool table";
    fz_is_feed_per_tooth_and_no() "FZ is a feed per tooth, and no tool is called"
        help "program TOOL CALL first, or the feed in mm/min";
    gives_time_of_block_in_place(word_text)
        "`{word_text}` gives the time of the block in place of a feed, which is not supported"
        help "program the feed in mm/min or, with FU, in mm/rev";
}

K9014 Error "machine-function" "block talks to the machine"
usual "remove the block if the part does not depend on it"
"The block waits for, reads or sets a signal of the machine control. Leaving it out could start a motion too early, so it is refused." {
    fn_talks_to_machine(number) "FN {number} talks to the machine";
}

K9015 Error "spline-or-normal-vector" "3-D blocks with normal vectors or splines are not supported"
usual "have the CAM system put out lines and arcs"
"LN blocks carry surface normals for 3-D tool compensation, SPL blocks carry polynomials. Neither has a counterpart in plain G-code." {
    blocks_are_not_supported(name) "{name} blocks are not supported";
}

K9016 Error "system-data" "system data is known only at the machine"
"FN 18: SYSREAD asks for something the program text does not determine. Supported are the active tool (ID 20), tool data (ID 50, ID 200), \
transformations (ID 210, ID 220) and the programmed position (ID 270)." {
    id_50_reads_tool_table()
        "ID 50 reads the tool table, and no manual says what it reads without a tool number in IDX"
        help "name the tool: `ID50 NR2 IDX5`";
    system_data_id_nr_is_known(id, nr, what, why, r)
        "system data ID {id} NR {nr}{what} is known only at the machine{why}"
        asks "assign the value with FN 0 if it is always the same, or say it in partc.toml: `[variables]` with \
        `\"{r}\" = …`";
}

K9017 Error "string-function" "string function is not supported"
usual "assign the text itself: `QS1 = \"TEXT\"`"
"SYSSTR and CFGREAD read a text from the control, which is not known here; other names are no string function that partc knows. \
Assign the text itself: `QS1 = \"TEXT\"`." {
    this_string_function_reads_from_control() "this string function reads from the control";
}

K9019 Error "rapid-arc" "arc at rapid traverse"
"Plain G-code moves at rapid traverse in straight lines only. Program a feed for the arc, or say in partc.toml at which feed such arcs run: \
`[control] rapid_feed = 10000.0`." {
    arc_at_fmax_has_no_counterpart() "an arc at FMAX has no counterpart in plain G-code"
        asks "program a feed, or set `[control] rapid_feed` in partc.toml";
}

K9018 Error "contour-cycle" "contours that contour cycles (SL) cannot take yet"
usual "program the roughing as blocks"
"Cycles 21 to 24 mill the contours that cycle 14 names by their labels. The contours of SEL CONTOUR, CONTOUR DEF and DECLARE CONTOUR are not supported, \
and without them material would stay or be lost. Name labels in cycle 14, or program the roughing as blocks." {
    contours_that_are_put_together_are_not(name) "{name}: contours that are put together are not supported";
}
}
