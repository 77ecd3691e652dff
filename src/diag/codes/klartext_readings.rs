//! Klartext: which block changes the tool, words that leave nothing in the output, and readings that manuals leave
//! open.

super::codes! { KLARTEXT_READINGS:

K0801 Error "no-number" "word has no number"
"CAM systems and post-processors print NaN, -nan(ind), inf or 1.#IND where they had no value to print. What the word should say cannot be known. \
A number with an exponent, 1e-05, is one that the control does not read. Only the first such word of a program is reported; write the program anew." {
    is_no_number(word) "`{word}` is no number: what wrote the program had no value here"
        help "write the program anew in the CAM system; further words of this kind are not listed";
    has_exponent_which_control_does_not_read(word) "`{word}` has an exponent, which the control does not read"
        help "let the post-processor write numbers in full: 0.00001 for 1e-05; further words of this kind are not \
        listed";
}

K2801 Error "tool-not-changed" "called tool is not in the spindle yet"
"The program writes M6 of its own, so M6 changes the tool, and TOOL CALL only makes it ready. Here something cuts after a TOOL CALL \
and before its M6: on a control that changes with M6 the old tool would cut with the data of the new one. Write M6 after the TOOL CALL. \
Where TOOL CALL itself changes the tool, set `[control] tool_change = \"t\"`." {
    tool_is_called(number) "tool {number} is called and not in the spindle yet: no M6 stands before this cut"
        asks "write M6 after the TOOL CALL, or set `[control] tool_change = \"t\"` if TOOL CALL changes the tool on \
        your machine";
}

K2802 Error "tool-change-too-early" "change was printed before the tool moved to it"
"When the TOOL CALL was compiled, no program known by then wrote M6, so the change was printed there. Then the tool moved, and now a \
program called in between writes M6: the change may have been meant for this place only. Set `[control] tool_change = \"m6\"` if M6 \
changes the tool on your control, or \"t\" if TOOL CALL does." {
    stands_after_moves(by) "{by} stands after moves, and the change was printed at the TOOL CALL before them"
        asks "set `[control] tool_change = \"m6\"` if M6 changes the tool, or \"t\" if TOOL CALL does";
    changes_tool(name) "`{name}` changes the tool, as `[programs]` says, and no tool waits for it"
        asks "program the TOOL CALL before it; where TOOL CALL only makes the tool ready, set `[control] tool_change \
        = \"m6\"`";
}

K2803 Warning "tool-call-without-m6" "called tool is made ready and not changed in"
"The program changes its tools with M6, and none follows this TOOL CALL. The output makes the tool ready and does not change it. That is \
right for a tool that the next program begins with; otherwise write M6 after the TOOL CALL." {
    no_m6_follows_this_tool_call(number)
        "no M6 follows this TOOL CALL: tool {number} is made ready and not changed in"
        help "write M6 after the TOOL CALL if the change is meant";
    no_m6_follows_this_tool_call_before(next, number)
        "no M6 follows this TOOL CALL before tool {next} is called: tool {number} is made ready and not changed in"
        help "write M6 after the TOOL CALL if the change is meant";
}

K2804 Warning "short-points-left-out" "M124 leaves out points on the control"
"M124 makes the control leave out points of straight blocks that lie close together, so its path cuts some corners of the programmed one. \
The output keeps every point. Remove M124, or make sure that the points it leaves out do not matter." {
    m124_leaves_out_points_on_control() "M124 leaves out points on the control, and the output keeps them all"
        help "remove M124 if the path is to be the programmed one";
}

K2805 Note "statement-without-words" "statement has no counterpart in plain G-code"
"The statement writes to screens and files, waits for the look-ahead of the control, or selects a table for statements that are refused \
themselves. The path does not depend on it, and it is left out." {
    has_no_word_in_output(what) "{what} has no word in the output";
}

K2806 Warning "pattern-feed-open" "feed between the places of a pattern is open"
"CYCL CALL PAT or CYCL CALL POS moves to its places, and the block has no F. Manuals do not say whether the feed programmed last holds \
or rapid traverse. partc takes the feed programmed last, the slower way; `[control] pattern_feed = \"rapid\"` selects the other. Write \
F or FMAX into the call to be sure." {
    has_no_f(value, way) "{value} has no F: the tool goes from place to place {way}"
        asks "write F or FMAX into the call; `[control] pattern_feed` selects the other reading";
}

K8026 Warning "feed-by-word" "FU or FZ in a TOOL CALL or in a cycle"
"How a feed per revolution (FU) or per tooth (FZ) is written in a TOOL CALL and after a parameter of a cycle (`Q206=FU0.2`) is not confirmed by a manual page; in path blocks it is. \
partc reads it as in a path block, FZ times the teeth of the tool. Compare it with the control, or write the feed in mm/min." {
    is_read_as_feed(text, what) "`{text}` is read as a feed {what}"
        help "compare it with the control, or write the feed in mm/min";
}

K8027 Warning "call-without-surface" "CYCL CALL POS without the tool axis"
"In CYCL CALL POS the coordinate of the tool axis shifts the surface of the cycle (Q203) for this call. Where it is missing, partc shifts nothing, as with 0; manuals want all three \
coordinates, and do not say what the control does without one. Write Z+0." {
    cycl_call_pos_names_no(axis) "CYCL CALL POS names no {axis}: the surface stays at Q203, as with {axis}+0"
        help "write {axis}+0 into the call";
}

K2807 Warning "order-of-transformations" "order of mirror, scaling and rotation is open"
"A mirror, or an uneven scaling by cycle 26, is in force together with a rotation, and the contour lies elsewhere depending on which comes first. partc mirrors and \
scales the programmed coordinates first and turns the result; `[control] mirror = \"last\"` turns first. The available manuals do not say; program the two \
so that only one is in force, or compare one point with the control." {
    cycle_26_scales_first() "cycle 26 scales first, then the rotation turns the result"
        help "scale and rotate one after the other, or both axes alike";
    rotation_acts_first() "the rotation acts first, then the mirror"
        asks "compare one point with the control; `[control] mirror` selects the other order";
    mirror_acts_first() "the mirror acts first, then the rotation"
        asks "compare one point with the control; `[control] mirror` selects the other order";
}

K2808 Warning "two-scalings" "scaling by cycle 11 and by cycle 26 together"
"Both scalings are in force. partc scales by cycle 11 first and then by cycle 26 about its centre, so the factors multiply. The available manuals \
do not say what controls do. Program the product into one of them." {
    cycle_11_scales_first() "cycle 11 scales first, then cycle 26 scales the result about its centre"
        help "put the product of the factors into one of the two cycles";
}

K2809 Warning "scaling-centre-open" "centre of cycle 26 is not repeated"
"Cycle 26 was defined with a centre before, and this definition names none for an axis that it scales or leaves scaled. partc counts from the datum, as without \
a centre; `[control] scaling_center = \"kept\"` keeps the one before. Write CCX and CCY into the definition." {
    this_cycle_26_names_no_centre(letter, what)
        "this cycle 26 names no centre for {letter}, and {letter} is scaled about {what}"
        asks "write CC{letter} into the definition; `[control] scaling_center` selects the other reading";
}

K2810 Warning "jump-by-rounding" "jump is decided by the last digits"
"The two values of this comparison differ by less than 0.000000001, which is what is left of rounding in a computed value. partc compares \
them as they are; another control may compute another last digit and jump the other way. Compare with a tolerance, or round with INT." {
    two_values_of_this_jump_differ()
        "the two values of this jump differ by less than 0.000000001, perhaps by rounding alone"
        help "compare with a tolerance: `FN 12: IF +Q1 LT +0.0001 GOTO LBL 1`";
}

K2811 Error "polar-angle-of-a-new-pole" "angle about a new pole is missing"
"PA is missing, and no polar block since the CC gave an angle about this pole. A control may take the direction in which the tool stands or the \
angle it read last, about another pole; each makes another move. Write PA. `[control] polar_missing = \"position\"` or \"programmed\" chooses \
one of the readings, with a warning." {
    pa_is_missing() "PA is missing, and no block since the CC named an angle about this pole"
        asks "write the angle PA, or choose a reading with `[control] polar_missing`";
}

K2890 Error "tool-radius-conflict" "tool has two radii"
"TOOL DEF in the program and the tool table give the tool different radii, and here the radius counts. The target compensates by its own table, \
partc would compute with the TOOL DEF: one contour would be cut by two radii. Write the radius of the tool in use into both." {
    tool_has_radius_in_its_tool_def(called, own, table)
        "tool {called} has radius {own} in its TOOL DEF and {table} in the tool table"
        asks "write the radius of the tool in use into both, or remove `radius` from `[tools.{called}]` or R from \
        TOOL DEF";
}

K2891 Error "compensation-changes-at-chamfer" "compensation changes at a chamfer"
"The blocks before and after CHF need the same radius compensation. Begin or end it in a block that is no neighbour of CHF." {
    at_this_chamfer(change) "{change} at this chamfer"
        help "begin or end the compensation in a block that is no neighbour of CHF";
}

K2892 Warning "compensation-changes-at-rounding" "compensation begins after a rounding"
"RND stands before the block that turns the radius compensation on or changes its side. Manuals show RND after the first compensated block (approach) \
and before the block with R0 (departure); what the control does here is open. partc rounds the programmed corner." {
    at_this_rounding_it_is_made_all(change) "{change} at this rounding; it is made all the same"
        help "for an approach on an arc write RL or RR into the block before RND";
}

K2893 Warning "open-corner" "way across the open corner of M98 is a reading"
"M98 leads the tool beyond the corner on both sides, so that both are machined completely. No available manual says how the tool gets from one side to the other: \
partc takes a straight line. `[control] m98 = \"refuse\"` refuses such corners." {
    m98_opens_corner_at_end()
        "M98 opens the corner at the end of this block where it is an inside one: a straight line leads from one \
        side to the other"
        asks "`[control] m98 = \"refuse\"` refuses such corners";
}

K2894 Warning "rounded-approach" "rounding as way to a contour is a reading"
"RND after the first block with RL or RR, or before the block with R0, leads the tool to the contour or from it on an arc. partc rounds the programmed corner and \
compensates the arc as an element of the contour, as `[control] rounded_approach` says. APPR CT and DEP CT say the same without a doubt." {
    programmed_corner_is_cut_as_between_two(what, help_)
        "{what}: the programmed corner is cut as between two elements"
        help "{help_} to be sure";
}

K2895 Warning "approach-without-side" "approach or departure without RL or RR"
"Controls up to the iTNC 530 compute an APPR block with R0 as for a tool of radius 0 to the right of the contour, newer ones refuse it. partc does the same, and for DEP \
after such a contour as well. Write RL or RR, or program the way as L and C blocks." {
    without_rl_or_rr(name) "{name} without RL or RR: computed with the tool radius 0 to the right of the contour"
        help "write RL or RR, or program the approach as L and C blocks";
}

K2896 Warning "approach-depth" "when the tool axis of an approach or departure moves is a reading"
"The order of plane and tool axis in APPR and DEP blocks differs from one control to the other, and between editions of their manuals. Write the tool axis into a block of its own, or \
choose with `[control] approach_depth`: \"staged\" moves it alone at PH and at the end of the departure, \"together\" with the plane." {
    tool_axis_of_moves_evenly_over_whole(a) "the tool axis of {a} moves evenly over the whole way to the contour"
        asks "write the depth into a block before it, or choose a reading with `[control] approach_depth`";
    tool_axis_of_moves_at_end(name) "the tool axis of {name} moves at the end of the departure"
        asks "write it into a block of its own after it, or choose a reading with `[control] approach_depth`";
}

}
