//! `T`: geometry, readings and what is not supported of HEIDENHAIN turning.

super::codes! { TURNING_GEOMETRY:

T3001 Error "turning-undetermined" "element is not determined"
"The end, centre or direction of the element is left open, and the elements beside it do not fix it. B missing means a tangential transition, \
`B0` a corner; a line by angle is fixed by one coordinate or by the next element." {
    element_is_not_determined(why) "the element is not determined: {why}"
        help "give its end point, its angle or its centre";
}

T3002 Error "turning-impossible" "geometry does not exist"
"No line or arc has all the programmed properties: a circle does not reach a line, two lines are parallel, or an angle never reaches the \
coordinate. Check the numbers of this block and the next one." {
    angles_leave_no_room_between_start() "the angles leave no room between start and end";
    element_is_not_possible(why) "the element is not determined: {why}"
        help "check the end points, angles and radii of this and the next block";
}

T3003 Error "turning-contour" "contour is not complete"
"A contour after a cycle begins with `G0`, consists of G0 to G3, G12 and G13, and ends with a block that holds G80 alone." {
    g80_ends_contour() "G80 ends a contour, and none was begun" help "a cycle such as G817 or G31 begins the contour";
    contour_has_no_element() "the contour has no element";
    g_cannot_stand_in_contour_of_g(fun, cycle, what) "G{fun} cannot stand in the contour of G{cycle} ({what})"
        help "close the contour with a block that holds G80 alone";
    contour_of_g_holds_block(cycle, what) "the contour of G{cycle} ({what}) holds a block that is no element"
        help "close the contour with a block that holds G80 alone";
    contour_of_cycle_has_more_than_elements(most_edges) "the contour of a cycle has more than {most_edges} elements";
    contour_does_not_say_where_it_starts() "the contour does not say where it starts"
        help "program `G0 X… Z…` as the first element";
    contour_starts_once() "a contour starts once, with G0";
    contour_of_this_cycle_has_no_end() "the contour of this cycle has no end"
        help "close it with a block that holds G80 alone";
    chamfer_rounding_or_undercut_interrupts_thread() "a chamfer, rounding or undercut interrupts the thread";
    thread_is_cut_along_straight_elements() "a thread is cut along straight elements, one at least";
    contour_of_thread_has_elements(elements, most_parts)
        "the contour of a thread has {elements} elements, more than {most_parts}";
    contour_has_more_than_elements(most) "the contour has more than {most} elements"
        help "check this block and the blocks beside it";
}

T3004 Error "turning-form" "recess or undercut does not fit"
"A recess belongs to the straight element before it, an undercut to the corner between a line parallel to Z and one parallel to X. Its sizes \
have to fit on these elements." {
    u_needs_line_parallel_to_z_before() "U needs a line parallel to Z before the recess";
    stands_behind_element_of_contour(what) "{what} stands after an element of the contour";
    no_element_follows_undercut()
        "no element follows the undercut";
    undercut_stands_between_two_lines()
        "an undercut stands between two lines";
    undercut_stands_between_line_along_z_and_one_along_x()
        "an undercut stands between a line parallel to Z and one parallel to X";
    undercut_has_no_room()
        "the undercut is wider than the element before it, or higher than the shoulder";
    slope_of_undercut()
        "the slope of an undercut lies between 0 and 90 degrees";
    radius_does_not_fit_into_undercut()
        "the radius does not fit into the undercut";
    undercut_is_too_narrow()
        "the undercut is too narrow for its radius";
    sizes_of_undercut_do_not_fit()
        "the sizes of the undercut do not fit together";
    size_of_thread_undercut_is_missing()
        "a size of the thread undercut is missing: give I, K and R, or a pitch FP that is in the table of \
        DIN 76";
    depth_of_thread_undercut_in_bore()
        "the depth of a thread undercut in a bore counts from the nominal diameter, which FP does not \
        give: program I with (nominal diameter + value of DIN 76 - bore) / 2";
    undercut_after_chamfer_or_rounding()
        "the element before the undercut has a chamfer or rounding at the same corner"
        help "check this block and the blocks beside it";
    recess_lies_beside_its_element()
        "the recess does not lie on the element before, or cuts into another recess"
        help "check this block and the blocks beside it";
    recess_belongs_to_straight_element() "a recess belongs to a straight element before it"
        help "check this block and the blocks beside it";
    recess_needs_line_along_z() "a recess with Z needs a line parallel to Z before it"
        help "check this block and the blocks beside it";
    recess_needs_line_along_x() "a recess with X needs a line parallel to X before it"
        help "check this block and the blocks beside it";
    middle_of_recess_lies_beside_its_element() "the middle of the recess does not lie on the element"
        help "check this block and the blocks beside it";
    flanks_of_recess_meet() "the flanks of the recess meet above its floor"
        help "check this block and the blocks beside it";
    recess_has_no_depth_or_width() "the recess has no depth or no width"
        help "check this block and the blocks beside it";
}

T3005 Error "turning-contour-corner" "chamfer or rounding of a contour does not fit"
"The chamfer or rounding at the end of an element is larger than the element or its neighbour, or there is no corner. B is the radius, or with \
a minus sign the width of the chamfer." {
    no_element_follows_corner()
        "the last element of the contour has a chamfer or rounding, and no element follows it"
        help "check this block and the blocks beside it";
    no_corner_for_chamfer_or_rounding() "there is no corner to put the chamfer or rounding in"
        help "check this block and the blocks beside it";
    contour_turns_back_at_corner() "the contour turns back on itself at the chamfer or rounding"
        help "check this block and the blocks beside it";
    corner_is_larger_than_element() "the chamfer or rounding is larger than a neighbouring element"
        help "check this block and the blocks beside it";
    chamfer_between_lines_only() "a chamfer is possible between straight lines only"
        help "check this block and the blocks beside it";
    element_beside_corner_has_no_length() "an element beside the chamfer or rounding has no length"
        help "check this block and the blocks beside it";
}

T3006 Error "turning-contradiction" "values of an element contradict each other"
"The block says the same thing twice, and the two do not agree: an angle and an end point, a radius and a centre, or a tangential arc that would \
have to turn the other way." {
    element_contradicts_itself(why) "the element is not determined: {why}"
        help "leave out one of the values, or correct it";
}

T3050 Error "turning-form-in-the-air" "recess or undercut lies on the air side of the contour"
"An undercut relieves an inner corner, and a recess goes into the material. Here the tool works on the other side, where the undercut would be \
a bead and the recess a ring that no cut makes, and the part would not come out as it is drawn. Move the undercut into an inner corner, or \
correct the sign of the depth or the diameter of the floor." {
    recess_rises_out_of_material()
        "the recess rises out of the material: on the side of the tool it would be a ring left standing"
        help "check the sign of I or K, and the floor, of this recess";
    undercut_stands_at_convex_edge()
        "the undercut stands at a convex edge: on the side of the tool it would be a bead left standing"
        help "an undercut belongs into an inner corner: move it there, or remove it";
    forms_lie_on_different_sides(name, first, line)
        "this {name} and the {first} in line {line} lie on different sides of the contour: one of them \
        stands in the air"
        help "check this block and the blocks beside it";
}

T3051 Error "turning-contour-arc" "arc of a contour is not closed"
"The arc is given by its end and by its centre, and the distances of both ends from the centre differ by more than the controls accept \
(0.02 mm, `[control] arc_tolerance`). Check start, end, I and K; on the 4110 I counts on the diameter, on later controls on the radius." {
    arc_is_nearly_full_circle(apart)
        "the arc is nearly a full circle that does not close, and {apart:.4} mm between the distances of its ends from \
        the centre leave open where it lies"
        help "check this block and the blocks beside it";
    arc_touches_its_centre() "the arc starts or ends in its centre"
        help "check this block and the blocks beside it";
    ends_of_arc_lie_on_two_circles(start, end, apart, allowed)
        "the start lies {start:.4} mm from the centre, the end {end:.4} mm: {apart:.4} mm difference, \
        {allowed} allowed"
        help "check this block and the blocks beside it";
}

T8001 Warning "turning-thread-left" "side of H of a thread is partc's reading"
"H1 shifts the cuts of a thread to the left, H2 to the right; to which end of the axis the left one lies is shown in a picture only. The last cut is not \
shifted, so the finished thread is the same either way, the load on the flanks is not." {
    left_is_ahead_of_cut()
        "the side to which H shifts the cuts of a thread is taken as: left is ahead of a cut towards -Z"
        asks "set `[control] thread_left = \"minus\"` to confirm it, or \"plus\"";
}

T8002 Warning "turning-thread-face" "face of a transverse thread is partc's reading"
"G31 cuts threads in the front face and in the rear face with the same words. The edge position of the tool tells which one is meant; no available \
manual says that the control decides by it." {
    face_is_taken_from_edge()
        "the face of this transverse thread is taken from the edge position of the tool"
        asks "set `[control] thread_face = \"front\"` or \"rear\" to say it";
}

T8003 Warning "turning-simple-thread" "words of G32 are partc's reading"
"No available manual lists the words of G32. They are read as docs/turning.md says. Program G31 where its words are known." {
    words_of_g32_are_read()
        "the words of G32 are read as docs/turning.md says: no available manual lists them"
        asks "set `[control] simple_thread = \"documented\"` to confirm it, or \"refuse\"";
}

T8004 Warning "turning-infeed" "infeed of G81 is partc's reading"
"No available manual says whether I of G81 counts on the radius or on the diameter. The number of cuts depends on it, the finished contour does not." {
    infeed_is_taken_as_radius()
        "the infeed I of G81 is taken as a depth of cut, on the radius"
        asks "set `[control] infeed = \"radius\"` to confirm it, or \"diameter\"";
}

T8005 Warning "turning-line-angle" "sense of an angle is partc's reading"
"The manuals show the angle A of a line in pictures, and their texts disagree whether it counts from -Z or from +Z. A contour printed in one of them \
is an ordinary shoulder only where it counts from -Z." {
    angle_counts_from_minus_z()
        "the angle of a line is taken to count from -Z: the diameter grows where the line runs towards -Z"
        asks "set `[control] line_angle = \"minus-z\"` to confirm it, or \"plus-z\"";
}

T8006 Warning "turning-arc-q" "solution of an arc is partc's reading"
"Where two arcs have the programmed values, Q chooses one. In earlier manuals Q0 is the far one, from software 7.1 on the near one." {
    q0_is_near_solution()
        "Q0 of an arc is taken to mean the near one of two solutions, as from software 7.1 on"
        asks "set `[control] turning_arc_q = \"near\"` to confirm it, or \"far\" for earlier controls";
}

T8007 Warning "turning-undercut-limit" "size of an undercut is partc's reading"
"The table of G85 has rows below and above 18 and 80 mm and none for these diameters themselves; of forms E and F over 3 to 10 mm manuals \
and DIN 509 have different radii. Give the sizes of the drawing with I, K and R, \
or say which row holds." {
    size_of_this_undercut_is_x(r, t, source, otherwise)
        "the size of this undercut is {r} x {t} ({source}); {otherwise}"
        asks "set `[undercut] din509_by_diameter`, or give the sizes of the drawing with I, K and R";
    table_has_no_row_for_diameter()
        "the table of G85 has no row for exactly this diameter: the one of smaller diameters is taken"
        asks "set `[control] undercut_limit = \"lower\"` to confirm it, or \"upper\"";
}

T8008 Warning "turning-undercut-side" "side of an undercut is partc's reading"
"G85 has no word for outside and inside. A tool above the cylinder cuts outside, one below inside; where it stands on the cylinder, its edge position \
tells: 3, 4 and 8 outside, 1, 2 and 6 inside. No available manual says that the control decides by it." {
    side_is_taken_from_edge()
        "the tool stands on the cylinder: whether the undercut lies outside or inside is taken from its \
        edge position"
        help "position the tool clear of the cylinder to say it";
}

T8009 Warning "turning-contour-words" "contour in the words of G80 is partc's reading"
"The words of G80 that describe a contour are shown in pictures only. They are read as docs/turning.md says: AC and WC lean the walls about \
their rims, so that the recess opens." {
    words_of_g80_are_read()
        "the words of G80 are read as docs/turning.md says: AC and WC lean the walls about their rims"
        asks "set `[control] contour_words = \"documented\"` to confirm it, or \"refuse\"";
}

T8010 Warning "turning-recess-blank" "blank oversize of G869 is partc's reading"
"RI says how far the blank stands above the rim of a recess. No available manual says whether it counts on the diameter, as the oversize I does. \
A tool that expects too little material would plunge too deep at once: compare the first plunge with the drawing." {
    ri_counts_on_diameter()
        "RI of G869 is taken to count on the diameter"
        asks "set `[control] recess_blank = \"diameter\"` to confirm it, or \"radius\"";
}

T8011 Warning "turning-depth-compensation" "sense of R or RB of G869 is partc's reading"
"The compensation counteracts the bending of the tool while it turns the floor. It is taken to lift the tool, which never cuts too deep; no \
available manual gives the sign." {
    compensation_lifts_tool()
        "the turning depth compensation of G869 is taken to lift the tool off the floor"
        asks "set `[control] turning_depth = \"away\"` to confirm it, or \"towards\"";
}

T8012 Warning "turning-offset-one-way" "offset width of one-way turning is partc's reading"
"B pulls the ends of turned cuts in where the tool changes from turning to plunging. One way (U1) there is no such change inside the material, \
so B has no effect; no available manual says so." {
    offset_width_has_no_effect()
        "the offset width B has no effect under U1: one way there is no change from turning to plunging"
        asks "set `[control] offset_one_way = \"none\"` to confirm it, or \"end\"";
}

T8013 Warning "turning-recess-depth" "incremental I of G22 is partc's reading"
"I of G22 is a diameter, so its increment is taken as a difference of diameters. No available manual says so: with the other reading the recess is twice \
as deep." {
    incremental_i_counts_on_diameter()
        "an incremental I of G22 is taken to count on the diameter"
        asks "set `[control] recess_depth = \"diameter\"` to confirm it, or \"radius\"";
}

T8014 Warning "turning-recess-width" "width of G23 is partc's reading"
"Where the flanks of a recess lean, K is its width at the surface or at its floor; this is shown in a picture only." {
    k_is_width_of_opening()
        "K of G23 is taken as the width of the opening, where the flanks lean"
        asks "set `[control] recess_width = \"opening\"` to confirm it, or \"floor\"";
}

T8015 Warning "turning-recess-oversize" "oversize of G86 is partc's reading"
"The oversize of G86 is left until the finishing cut. No available manual says whether it is left on the walls as well as on the floor; on both never cuts too much." {
    oversize_is_left_on_floor_and_walls()
        "the oversize of G86 is left on the floor and on the walls until the finishing cut"
        asks "set `[control] recess_oversize = \"all\"` to confirm it, or \"floor\"";
}

T8016 Warning "turning-blank-contour" "contour of the blank is not used"
"The section BLANK draws the blank as a contour. The cycles of partc know bars, tubes and castings (G20, G21); of another blank they take that it reaches \
to where the tool stands when the cycle begins." {
    blank_is_drawn_as_contour()
        "the blank is drawn as a contour, which is not used: cycles take the blank to reach to the tool"
        help "position the tool outside of the blank before each cycle, or describe the blank by G20 or G21";
}

T8017 Note "turning-word-idle" "word changes nothing here"
"The word is known and does not change the path: the end of an element is given, so Q has nothing to choose; the run-in and run-out of G33 lie inside \
of the programmed thread. It is named because no word is left out in silence." {
    changes_nothing_here_i_or_k(name)
        "{name} changes nothing here: I or K of the cycle takes its place, for both axes"
        help "program both I and K in the cycle, or neither";
    from_here_on_changes_nothing(old, new) "from here on {old} changes nothing: {new} takes its place"
        help "keep one of the two";
    only_height_of_blank_counts(name)
        "{name} changes nothing here: only the height of the blank along the infeed counts"
        help "nothing is to be done, or remove it";
    end_is_given_without_choice(word)
        "{word} changes nothing here: the end of the element is given, so there is nothing to choose"
        help "nothing is to be done, or remove it";
    g52_ends_oversizes_as_g50(word)
        "{word} changes nothing here: G52 in a program ends oversizes, as G50 does"
        help "nothing is to be done, or remove it";
    run_in_of_g33_lies_inside(word)
        "{word} changes nothing here: the run-in and the run-out of G33 lie inside of the programmed \
        thread"
        help "nothing is to be done, or remove it";
    retraction_of_g33_belongs_to_stop(word)
        "{word} changes nothing here: the retraction of G33 belongs to a stop inside of the thread"
        help "nothing is to be done, or remove it";
}

T8018 Warning "turning-finishing-side" "side of G41 and G42 after G89 is partc's reading"
"The page of G89 prints G41 as right and G42 as left of the contour, the general page of the same manual the other way round. partc compensates the \
nose on the side on which the tool works: told by its edge position, else by where it stands." {
    side_is_taken_from_tool()
        "two pages of the manual give G41 and G42 after G89 opposite sides: the side is taken from the \
        tool"
        help "check the side of the tool: where it stands, or `orientation` in partc.toml";
}

T8019 Warning "turning-nose-path" "path beside a contour is partc's reading"
"The available manuals say when G41 and G42 begin to act, and not where the tool stands then. partc leads it straight to the point at a right angle beside the start of \
the contour, around outside corners on an arc of the nose radius, and from the point beside its end straight on, as other controls do." {
    ends_of_compensation_are_partcs()
        "no available manual says how G41 and G42 begin, end and go around outside corners: at a right angle \
        beside the contour, and on an arc about the corner"
        help "look at the first and the last way beside the contour";
}

T9002 Error "turning-keyword" "keyword or section is not supported"
"The word begins something that partc does not compile. Write the blocks out, or remove what is not needed." {
    is_not_supported(shown, what) "`{shown}` ({what}) is not supported";
    is_not_supported_2(shown) "`{shown}` is not supported";
    names_of_constants() "names of constants and variables (CONST, VAR) are not supported"
        help "write the value or the variable itself where a name stands";
    several_contours_on_one_bar_are_not() "several contours on one bar are not supported"
        help "compile a program with one part at the workpiece zero";
}

T9003 Error "turning-formula-function" "function of a formula is not supported"
"Formulas know SQRT, SIN, COS, TAN, ASIN, ACOS, ATAN, ABS, INT, ROUND, LN, EXP, SQRTA and SQRTS, angles in degrees. Write the formula with these." {
    function_is_not_supported(name) "the function `{name}` is not supported";
    para_parameter_of_machine_is_not_supported() "`PARA` (a parameter of the machine) is not supported";
}

T9004 Error "turning-axis" "axis is not supported"
"Only X and Z of the first slide are compiled. C and Y axis machining, a second slide and a counter spindle need other moves." {
    belongs_to_c_axis(letter)
        "{letter} belongs to the C axis, the Y axis or a second slide, which are not supported here";
}

T9007 Error "turning-unconfirmed" "meaning is not confirmed by a manual"
"What this word means is shown in a picture only, or differs between manuals. Compiling it on a guess could cut in the wrong place, so it is refused." {
    whether_q_counts_passes_or_repeats_no() "no available manual says whether Q counts passes or repeats"
        help "write the L block as often as it shall run";
    of_g89_how_it_makes_is_shown(letter, what) "{letter} of G89: how it makes {what} is shown in a picture only"
        help "begin the contour with the element before the corner, and write the corner at its end";
    in_contour_of_g80_is_not_supported(name)
        "{name} in a contour of G80 is not supported: no available manual describes it"
        help "write the contour with G0, G1, G2 and G3 blocks before G80";
    no_manual_at_hand_lists_words(addr) "no available manual lists the words of G80 ({addr})"
        asks "write the contour with G0, G1, G2 and G3 blocks before G80, or set `[control] contour_words = \
        \"documented\"`";
    contour_in_words_of_g80_is_not(addr, number)
        "a contour in the words of G80 ({addr}) is not supported for G{number}"
        help "write the contour with G0, G1, G2 and G3 blocks before G80";
    v4_only_chamfer_or_rounding_of_element() "V4 (only the chamfer or rounding of an element) is not supported"
        help "write the chamfer as an element of its own";
    steps_that_become_shorter_by_i_down()
        "steps that become shorter by I down to another least depth J are not supported"
        help "program J with the same value as I, or leave I out";
    drilling_along_x_is_not_supported() "drilling along X is not supported"
        help "position the tool over the hole, and program Z of its bottom";
    of_g36_what_its_values_do_no(letter, what) "{letter} of G36 ({what}): no available manual says what its values do"
        help "leave it out, and position the tool far enough in front of the thread";
    deep_hole_drilling_with_retraction_at_feed() "deep-hole drilling with retraction at feed is not supported";
    by_how_much_v_lowers_feed() "no available manual says by how much V lowers the feed at entry and exit"
        help "leave V out, and program the feed for the whole hole";
    d_names_one_kind_of_ring_groove()
        "D names one kind of ring groove, and a recess of G22 does not say which kind it is"
        help "program 1536 for all recesses of G22";
    thread_with_several_starts_is_not_supported() "a thread with several starts is not supported"
        help "program G31 once for each start, with C";
    of_g37_is_not_supported(letter) "{letter} of G37 is not supported"
        help "program the thread with B, P, C and Q of G31";
    undercuts_h() "the undercuts H and K are shown in pictures only"
        help "describe the undercut with G1 and G2 blocks";
    relief_turn() "a relief turn: how it is measured is shown in a picture only"
        help "describe the relief turn with G1 blocks";
    target_cannot_cut(what) "the target cannot cut a {what}";
    of_g869_cutting_limit(letter) "{letter} of G869 (cutting limit, approach or departure angle) is not supported"
        help "leave it out, and end the contour where the recess ends";
    corner_of_blank_is_taken_from_tool() "the corner of the blank is taken from the tool"
        help "leave it out, and position the tool at the corner";
    only_value_0_of_q_is_supported() "only the value 0 of Q is supported: back to the start"
        help "leave Q out, and position the tool after the cycle";
    of_g_is_not_supported(letter, number) "{letter} of G{number} is not supported"
        help "leave it out, and end the contour where the cuts shall end";
    to_which_side_makes_end_oblique(offset)
        "to which side {offset} makes the end oblique is shown in a picture only"
        help "rough along a contour with G817 or G827";
    on_which_side_of_its_corner_wide() "on which side of its corner a wide recess lies is shown in a picture only"
        asks "set `[control] recess_side = \"plus\"` or `\"minus\"` in partc.toml: the side of the programmed \
        corner, along Z";
    whether_width_of_axial_recess_counts()
        "no available manual says whether the width of an axial recess counts as a diameter"
        help "leave I out and cut side by side, or program the recess with G869 on a later control";
    of_g32_no_manual_at_hand_gives(letter, what) "{letter} of G32: no available manual gives {what}"
        help "program G31, which has R, H and A";
    words_of_g32_are_not_confirmed() "the words of G32 are not confirmed by a manual"
        asks "program G31, or set `[control] simple_thread = \"documented\"` in partc.toml";
    alternating_flanks_that_begin_on_other_side()
        "alternating flanks that begin on the other side (a thread towards +Z) are not supported"
        help "program H0, H1 or H2";
    how_v_divides_depth_no_manual(kind) "no available manual says how V{kind} divides the depth"
        help "program V0, V1, V2 or V3";
    v3_divides_depth_on_manualplus()
        "V3 divides the depth on the MANUALplus and follows pitch and speed on the CNC PILOT 4290"
        asks "set `[control] heidenhain_turning = \"manualplus620\"` in partc.toml, or program V0, V1 or V2";
    elements_of_thread_have_different_pitches() "the elements of the thread have different pitches or depths"
        help "program F and U for all of it, or a cycle for each element";
    o_of_thread_is_not_supported(num) "O{num} of a thread is not supported"
        help "leave the word out, and write the contour as it is to be cut";
    wear_oversize_of_undercut_e_or_f() "the wear oversize of an undercut E or F is not supported"
        help "leave I out, and correct the wear at the tool";
    how_q_chooses_approach_no_manual()
        "no available manual says how Q chooses the approach"
        help "leave the word out, and name the elements to be finished with NS and NE";
    u_names_element_in_words_of_g80()
        "U names an element in the words of G80, which is not supported"
        help "leave the word out, and name the elements to be finished with NS and NE";
    what_b_of_g890_means_no_manual()
        "no available manual says what B of G890 means"
        help "leave the word out, and name the elements to be finished with NS and NE";
    cutting_limit_is_not_supported()
        "a cutting limit is not supported: to which side it holds is shown in a picture only"
        help "leave the word out, and name the elements to be finished with NS and NE";
    oversize_does_not_fit_cycle()
        "this oversize does not fit the cycle after it"
        help "program I and K in the cycle, or G50 before it";
    oversize_does_not_fit_contour()
        "this oversize does not fit the contour after it"
        help "program I and K in the cycle, or G50 before it";
    equidistant_or_negative_oversize()
        "an equidistant or negative oversize is not supported here"
        help "program I and K in the cycle, or G50 before it";
    g57_does_not_belong_to_g89()
        "G57 does not belong to G89"
        help "program I and K in the cycle, or G50 before it";
}

}
