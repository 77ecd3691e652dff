//! Facts that several languages share: machining cycles.

super::codes! { SHARED_CYCLES:

P2090 Error "cycle-argument" "value in a cycle is not usable" was "K2403 cycle-value S2090 siemens-cycle-argument"
"Klartext: The value is outside the range the control accepts: a scaling factor is 0.000001 to 99.999999, a dwell 0 to 3600 seconds. \
Check the value, or the parameter it comes from.\n\n\
SINUMERIK: The data of a machining cycle contradict each other, are missing, or do not fit what stands around the call. The number is \
the alarm that the cycle raises itself. Arguments are counted by their commas; an empty argument is not given, which is not the same as \
0." {
    overlap_q370_makes_more_than_1000_circles() "the overlap Q370 makes more than 1000 circles";
    drilled_hole_q342_is_not_smaller(drilled) "the drilled hole Q342 = {drilled} is not smaller than Q335";
    tool_that_roughs(number) "the tool that roughs, Q13 = {number}, is no number of a tool";
    coarse_tool(number, coarse, radius)
        "the coarse tool {number} (Q18) has radius {coarse}, and the one after it {radius}";
    coarse_tool_q18_cut_with_oversize(number, oversize)
        "the coarse tool {number} (Q18) cut with an oversize of {oversize} mm: whether it cleared as much is open; \
        rough with its true radius, and leave the allowance by Q3";
    no_cycle_22_with_tool(number)
        "no cycle 22 with tool {number} (Q18) roughed these contours, with these data, before it";
    q14_radius_of_cutter_together_are_not(left, radius, allowance, tool)
        "Q14 = {left} and the radius {radius} of the cutter together are not below Q3 = {allowance} and the radius \
        of the cutter that roughed ({tool})";
    overlap_factor_q2_is_not_0_1(factor) "the overlap factor Q2 = {factor} is not 0.1 to 1.9999";
    kind_of_milling_is_not_1(q, other) "the kind of milling {q} = {other} is not +1 or -1";
    infeed_q10_is_0() "the infeed Q10 is 0";
    depth_q1_is_positive(deep) "the depth Q1 = {deep} is positive";
    tool_axis_cannot_mill(axis) "the tool axis {axis} cannot mill";
    is_below_zero(q, value) "{q} = {value} is below zero"
        help "check the values of the definition";
    is_not_one_of(q, value, low, high) "{q} = {value} is not a whole number from {low} to {high}"
        help "check the values of the definition";
    value_is_out_of_range(q, value) "{q} = {value} is out of range"
        help "check the values of the definition";
    makes_no_path(fault) "{fault}";
    deepened_start_lies_below_depth() "a deepened start lies below the depth of the cycle";
    open_hole_q342_lies_below_depth() "Q342 lies below the depth of the cycle";
    q14_and_cutter_reach_q3_unroughed(left, radius, allowance)
        "Q14 = {left} and the radius {radius} of the cutter together are not below Q3 = {allowance} and the radius of \
        the cutter that roughed (0, because no cycle 22 roughed this contour here, with this Q3, before)";
    it_set_to_is_now(q, set, now)
        "it set {q} to {set}, and {q} is {now} now: which of the two counts is open; define the cycle anew";
    tool_goes_on_contour_itself()
        "the tool goes on the contour itself (Q391 = 0), so the way to it is a tangential line (Q390 = 2)";
    is_not_above_zero(q, size) "{q} = {size} is not above zero, and Q390 asks for it";
    way_q390_is_not_1_2(other) "the way Q390 = {other} is not 1, 2 or 3";
    angle_q393_of_arc_is_not_above(angle) "the angle Q393 = {angle} of the arc is not above 0 and below 360";
    side_q391_is_not_0_1(other) "the side Q391 = {other} is not 0, 1 or 2";
    kind_of_milling_q15(other)
        "the kind of milling Q15 = {other}, and the tool goes on the contour itself: there is no up-cut";
    q3_tool_goes_on_contour_itself(allowance) "Q3 = {allowance}, and the tool goes on the contour itself";
    clearance_height_q7_does_not_lie_above(height, surface)
        "the clearance height Q7 = {height} does not lie above the surface Q5 = {surface}";
    tolerance(t) "a tolerance of {t}" help "a tolerance is above zero; `CYCL DEF 32.1` without T ends it";
    spindle_angle_of_degrees_is_out(angle) "a spindle angle of {angle} degrees is out of range"
        help "cycle 13 takes 0 to 360 degrees";
    dwell_of_s_is_out_of_range(seconds) "a dwell of {seconds} s is out of range"
        help "a dwell takes 0 to 3600 seconds";
    depth_is_0() "the depth is 0";
    depth_is_positive() "the depth is positive";
    depth_q201_is_positive(deep) "the depth Q201 = {deep} is positive";
    tool_axis_cannot_drill(axis) "the tool axis {axis} cannot drill";
    blank_q227_does_not_lie_above_face(top, bottom)
        "the blank Q227 = {top} does not lie above the face Q386 = {bottom}";
    stud_that_is_there() "the stud that is there (Q222) is smaller than the finished one (Q223)";
    pocket_that_is_there() "the pocket that is there (Q222) is not smaller than the finished one (Q223)";
    cannot_be_scaled(axis) "{axis} cannot be scaled"
        help "write the factor after X, Y or Z: `CYCL DEF 26.1 X1.4 Y0.6`";
    scaling_factor_of_is_out_of_range(factor) "a scaling factor of {factor} is out of range"
        help "a scaling factor lies between 0.000001 and 99.999999";
    only_x_y() "only X, Y and Z can be mirrored" help "name one or two of X, Y, Z";
    transformations_together_are_too_large_or_too()
        "the transformations together are too large or too small to compute with"
        help "check the scaling factors and shifts in force";
    deepened_start_q379_is_not_above_depth(deepened) "the deepened start Q379 = {deepened} is not above the depth";
    diameter_q344_is_larger_than_tool(diameter, radius)
        "the diameter Q344 = {diameter} is larger than the tool of {radius} mm";
    feed_of_is_not_above_zero(value) "a feed of {value} is not above zero";
    feed_is_not_above_zero(q, value) "the feed {q} = {value} is not above zero";
    dwell_of_s_is_out(seconds) "a dwell of {seconds} s is out of range";
    is_missing(q) "{q} is missing"
        help "check the values of the definition";
    overlap_factor_q370_is_not_0_1(factor) "the overlap factor Q370 = {factor} is not 0.1 to 1.9999";
    kind_of_milling_q351_is_not_1(other) "the kind of milling Q351 = {other} is not +1 or -1";
    floor_would_be_finished_in_one_cut(shown, shown2)
        "the floor would be finished in one cut of {shown} mm (Q369), deeper than the infeed Q202 = {shown2} mm";
    allowance_on_wall_is_mm(shown, shown2, shown3)
        "the allowance on the wall is {shown} mm, and one finishing cut with the tool of {shown2} mm takes off \
        {shown3} mm here: stock would stay between the two";
    is_not_above_zero_2(q, value) "{q} = {value} is not above zero"
        help "check the values of the definition";
    radius_of_tool_with_its_oversizes(radius) "the radius of the tool with its oversizes is {radius} mm";
    its_two_sides_do_not_lie_along() "its two sides do not lie along the two axes of the working plane";
    infeed_in_depth_is_0() "the infeed in depth is 0";
    side_of_mm_is_not_above_zero(side) "a side of {side} mm is not above zero";
    length_mm_of_slot_is_not_above(along, length, across, width)
        "the length {along} = {length} mm of the slot is not above its width {across} = {width} mm";
    pattern_has_more_than_99999_places() "the pattern has more than 99999 places";
    start_angle_q245() "start angle Q245 and stop angle Q246 are the same, and no step Q247 is given";
    set_up_clearance_1_of_cycle(cycle, own, clearance)
        "the set-up clearance {cycle}.1 of the cycle is {own} mm, and Q200 of the pattern {clearance} mm";
    q203_of_pattern(surface, cycle, own)
        "Q203 of the pattern is {surface}, and cycle {cycle} has its height Q227 = {own} in place of it: which of \
        the two counts is open; write the same height";
    opening_angle_q248_is_not_above_0(sweep) "the opening angle Q248 = {sweep} is not above 0 and below 360";
    slot_length_q218_mm_is_not_above(length, width)
        "the slot length Q218 = {length} mm is not above its width Q219 = {width} mm";
    angle_of_approach_q376_is_not_1(angle) "the angle of the approach Q376 = {angle} is not -1, or 0 to 359";
    blank_q222_is_smaller_than_stud() "the blank (Q222) is smaller than the stud (Q223)";
    blank_q222_is_within_corners(corner)
        "the blank (Q222) does not reach the corners of the polygon, which lie on a diameter of {corner} mm";
    blank_q424() "the blank (Q424, Q425) is smaller than the stud (Q218, Q219)";
    depth_q356_is_less_than_depth() "the depth Q356 is less than the depth of the thread Q201";
    depth_is_positive_2(q, depth) "the depth {q} = {depth} is positive";
    pitch_q239_is_0() "the pitch Q239 is 0";
    depth_of_hole_q356_is_0() "the depth of the hole Q356 is 0";
    factor_q403_is_not_0_0001(factor) "the factor Q403 = {factor} is not 0.0001 to 10";
    no_tool_offset_is_active() "no tool offset is active" alarm 61000 help "program D1 before the cycle";
    no_tool_is_active(change) "no tool is active" alarm 61009 help "select the tool before the cycle: {change}";
    argument_is_missing(parameter, place, meaning) "`{parameter}` (argument {place}: {meaning}) is missing"
        help "arguments are counted by their commas";
    argument_takes_no_sign(parameter, place, meaning, value)
        "`{parameter}` (argument {place}: {meaning}) is {value}, and stands without a sign" alarm 61019
        help "give it without a sign";
    argument_is_not_above_zero(parameter, place, meaning, value)
        "`{parameter}` (argument {place}: {meaning}) is {value}, and has to be above 0" help "give a value above 0";
    argument_size_is_zero(parameter, place, meaning) "`{parameter}` (argument {place}: {meaning}) is 0" alarm 61118
        help "give a size above 0";
    argument_is_not_below_90(parameter, place, meaning, value)
        "`{parameter}` (argument {place}: {meaning}) is {value}, and has to be from 0 to below 90 degrees" alarm 61019;
    argument_is_none_of(parameter, place, meaning, value, range)
        "`{parameter}` (argument {place}: {meaning}) is {value}, and has to be {range}" alarm 61002;
    no_contour_is_named() "no contour is named" alarm 61027 help "name a subprogram, or two labels: \"START:END\"";
    more_than_one_contour_is_called() "more than one contour is called" alarm 61704
        help "call one contour by CYCLE62 before each cycle";
    more_than_two_contours_are_called() "more than two contours are called" alarm 61704
        help "one contour is the finished part, two are blank and finished part";
    no_contour_is_called() "no contour is called" help "call it by CYCLE62 before the cycle";
    there_are_too_many_contours() "there are too many contours" alarm 61704
        help "a machining cycle takes the contours before it";
    type_name() "type, name and labels do not go together" alarm 61701
        help "CYCLE62(\"PROGRAM\",0), CYCLE62(\"CONTOUR\",1), CYCLE62(,2,\"LABEL1\",\"LABEL2\") or \
        CYCLE62(\"PROGRAM\",3,\"LABEL1\",\"LABEL2\")";
    so_check_arguments(fault, key, place) "{fault}: `{key}` (argument {place})"
        help "check the arguments of the cycle";
    contour_lies_in_another_plane() "the contour lies in another plane" alarm 61931
        help "describe the contour in the plane of the cycle";
    angle_of_insertion_ew_is_above_0(place)
        "the angle of insertion `_EW` (argument {place}) is above 0 and below 90" alarm 61019
        help "give the angle in degrees";
    pitch_of_helix_ep_is_0(place) "the pitch of the helix `_EP` (argument {place}) is 0 or missing" alarm 61019
        help "give the depth of one turn";
    contour_of_blank_is_missing() "the contour of the blank is missing" alarm 61739
        help "call the contour of the blank by CYCLE62 before that of the part";
    ten_thousands_of_dmode_count_feeds()
        "the ten thousands of `_DMODE` count the feeds of the call per minute, and G94 is not active"
        help "program G94 and its F before the cycle, or give the feeds per turn and 0 in that place";
    transition_is_larger_than_its_edge(key, place)
        "the transition `{key}` (argument {place}) is larger than its edge" alarm 61252
        help "give a smaller radius or chamfer";
    safety_distance_is_missing(args, place) "the safety distance `{args}` (argument {place}) is missing" alarm 61019
        help "the tool needs a distance above 0 from the blank at rapid traverse";
    call_makes_no_cycle(fault) "{fault}";
    cutter_does_not_fit(fault, key, place, diameter) "{fault}: `{key}` (argument {place}), cutter {diameter} mm" alarm 61105
        help "take a smaller cutter, or a smaller allowance";
    pattern_has_no_hole() "the pattern has no hole" alarm 61103 help "check number and spacing of the holes";
    pattern_has_no_column_or_row() "the pattern has no column or no row" alarm 62105
        help "check number and spacing of the holes";
    holes_go_round_more_than_once() "the holes go round more than once" alarm 61106
        help "check number and spacing of the holes";
    pattern_has_too_many_holes() "the pattern has more than 100000 holes" help "check number and spacing of the holes";
    data_of_pattern_make_no_positions() "the data of the pattern make no positions"
        help "check number and spacing of the holes";
    tool_would_lift_beyond_centre() "the tool would lift off beyond the turning centre" alarm 61001
        help "check the diameters, the depth and the lift-off";
    thread_is_deeper_than_part() "the thread is deeper than the part" alarm 61001
        help "check the diameters, the depth and the lift-off";
    number_of_passes_is_missing(place) "the number of roughing passes NRC (argument {place}) is missing"
        help "arguments are counted by their commas";
    family_refuses(fault, key, place) "{fault}: `{key}` (argument {place})";
    reduced_speed_ss2_is_missing(place)
        "the reduced speed `_SS2` (argument {place}) is missing, and the cutting speed at the centre has no limit" alarm 61019
        help "give `_SS2`, or a greatest speed `_SV2`";
    greatest_speed_sv2_without_speed_sv1(place)
        "a greatest speed `_SV2` (argument {place}) without the speed `_SV1`" alarm 61019
        help "give both, or none";
    sdac_is_no_sense_of_spindle(place) "`_SDAC` (argument {place}) is no sense of the spindle" alarm 61102
        help "3 is M3, 4 is M4";
    diameter_spd_is_not_above_0(place) "the diameter `_SPD` (argument {place}) is not above 0" alarm 61019
        help "give the diameter of the bar";
    spindle_direction_is_3_4_or_5() "the spindle direction is 3, 4 or 5" alarm 61102 help "3 is M3";
    pitch_is_below_0() "the pitch is below 0" alarm 61001
        help "give it without a sign: the spindle before the cycle, or SDR, makes the hand of the thread";
    spindle_does_not_turn() "the spindle does not turn" alarm 61102 help "program M3 or M4 before";
    sdr_is_0_3_or_4() "SDR is 0, 3 or 4" alarm 61102
        help "3 or 4 is the sense on the way out, 0 the other one than before the cycle";
    spindle_has_no_speed() "the spindle has no speed" alarm 61102 help "program S before the cycle";
    spindle_has_no_speed_so_give_sst() "the spindle has no speed" alarm 61102
        help "give SST (argument 11) or program S";
    vari_is_0_1_or_2() "`_VARI` is 0, 1 or 2" alarm 61002 help "0 taps in one go, 1 breaks the chip, 2 removes it";
    tapping_under_constant_cutting_speed() "tapping under a constant cutting speed (G96)"
        help "program G97 with S in turns per minute before the cycle";
    first_step_dam_is_deeper_than_hole() "the first step `_DAM` is deeper than the hole" alarm 61809
        help "give `_VARI` 0 for one step";
    depth_of_step_dam_is_0() "the depth of a step `_DAM` is 0" alarm 61808
        help "give `_DAM`, or `_VARI` 0 for one step";
    pitch_is_missing() "the pitch is missing" alarm 61001 help "give PIT, or MPIT as a metric size";
    pitch_contradicts_thread_size(b, a) "the pitch {b} contradicts the thread size, whose pitch is {a}" alarm 61001
        help "give the pitch or the size";
    m_is_no_size_of_this_cycle(diameter) "M{diameter} is no size of this cycle" alarm 61001
        help "give the pitch instead";
    degression_factor_is_above_1() "the degression factor is above 1"
        help "DAM above 0 is an amount, below 0 a factor down to -1";
    degression_is_above_0_to_100_percent() "the degression is above 0 to 100 percent"
        help "give 100 for steps of one size, less for shrinking ones";
    first_drilling_depth_does_not_lie_between()
        "the first drilling depth does not lie between the surface and the bottom" alarm 61107
        help "give FDEP (argument 6) below the surface, or FDPR (argument 7)";
    feed_of_zone_is_below_0() "the feed of a zone is below 0" alarm 61003
        help "give the feed of the zone in percent of F, above 0";
    side_of_face_is_0(name, place) "the side `{name}` (argument {place}) of the face is 0" alarm 61118
        help "give its length, with the sign of its direction";
    limits_lim_are_four_digits_0(place) "the limits `_LIM` (argument {place}) are four digits 0 or 1" alarm 61019
        help "from the right: first axis minus and plus, second axis minus and plus";
    rotation_sta_is_0_to_below_180(place) "the rotation `_STA` (argument {place}) is 0 to below 180 degrees" alarm 61019
        help "turn the face by an angle in this range, and give its sizes their signs";
    groove_would_go_beyond_turning_centre() "the groove would go beyond the turning centre"
        help "check diameter, depth, width and safety distance";
    tool_of_mm_is_wider_than_floor(width, name, place, floor_width)
        "the tool of {width} mm is wider than the floor `{name}` (argument {place}) of {floor_width} mm" alarm 61602
        help "take a narrower tool";
    corner_does_not_fit_on_flank(name, place)
        "the corner `{name}` (argument {place}) does not fit on flank and floor" alarm 61603
        help "give smaller radii or chamfers";
    allowance_on_floor_is_not_less(left) "the allowance on the floor `{left}` is not less than the depth" alarm 61010
        help "give a smaller allowance";
    edge_of_tool_lies_at_position(number, position, first, second)
        "the edge of tool {number} lies at position {position}, and this side is cut with {first} or {second}" alarm 61608
        help "check the side of the groove and `orientation` of the tool: 3 and 4 point outside in, 1 and 2 inside \
        out, 2 and 3 into the front face, 1 and 4 into the rear face";
    grooves_without_distance_dbh(count, place) "{count} grooves without a distance `_DBH` (argument {place})" alarm 61019
        help "give the distance from groove to groove";
    num_is_no_number_of_grooves(place) "`_NUM` (argument {place}) is no number of grooves" alarm 61019
        help "give a whole number from 1 on";
    allowance_on_all_sides_stands_beside_one() "an allowance on all sides stands beside one along an axis"
        help "give either `_FAL`, or `_FALX` and `_FALZ`";
    width_of_top_widg2(place, given, width)
        "the width of the top `_WIDG2` (argument {place}) is {given:.4}, and floor, depth and flanks make it \
        {width:.4}"
        help "give the width that is meant, or leave `_WIDG2` out";
    depth_diag_does_not_lie_in_material(place) "the depth `_DIAG` (argument {place}) does not lie in the material" alarm 61019
        help "absolute it is the other diameter (on faces the other Z), incremental (tens of `_AMODE` 1) a depth \
        above 0";
    tens_of_vari_are_no_kind(place) "the tens of `_VARI` (argument {place}) are no kind of machining" alarm 61002
        help "1 roughs, 2 finishes, 3 does both";
    names_no_side_of_groove(name, place) "`{name}` (argument {place}) names no side of a groove" alarm 61002
        help "1 and 5 outside, 3 and 7 inside, 2 and 4 rear face, 6 and 8 front face; CYCLE930 has it in the \
        hundreds";
    cycle_needs_turning_technology() "the cycle needs turning technology" asks "set `[machine] kind = \"lathe\"`";
    so_check_corner(what, key, place) "{what}: `{key}` (argument {place})" alarm 61118
        help "check the corner of the blank, the end point and the position";
    there_is_no_such_kind_of_machining(key, place) "there is no such kind of machining `{key}` (argument {place})" alarm 61002;
    relief_cut_from_falls_at_degrees(shown, steepest, angle)
        "the relief cut from {shown} falls at {steepest:.1} degrees, and the flank of the tool clears {angle} only" alarm 61604
        help "take a tool with a larger clearance angle (`clearance` in partc.toml, $TC_DP24), or leave the relief \
        to a groove cycle";
    greatest_infeed_is_missing(key, place) "the greatest infeed `{key}` (argument {place}) is missing" alarm 61610
        help "roughing needs the greatest depth of a cut";
    direction_is_0_to_3(args, place) "the direction `{args}` (argument {place}) is 0 to 3" alarm 61002
        help "0 climb, 1 conventional, 2 G2, 3 G3";
    infeed_in_plane_of_mm_is_larger(name, place, width, radius)
        "the infeed in the plane `{name}` (argument {place}) of {width} mm is larger than the cutter, {radius} mm" alarm 61111
        help "give at most the diameter of the cutter";
    no_infeed_in_depth(name, place, length)
        "no infeed in depth `{name}` (argument {place}), and the tool is only {length} mm long" alarm 61019
        help "give the greatest depth of a level";
    feed(name, place, what) "the feed `{name}` (argument {place}) {what}" alarm 61003 help "give a feed above 0";
    feed_is_out_of_all_range(key, place) "the feed `{key}` (argument {place}) is out of all range" alarm 61003
        help "look for a lost decimal point";
    scaling_is_active() "a scaling is active" alarm 61011
        help "switch SCALE off before the cycle: the cutter is not scaled with its shape";
    retraction_plane_lies_below_surface(name, place)
        "the retraction plane `{name}` (argument {place}) lies below the surface, and a mill does not come from \
        below" alarm 61101
        help "give a retraction plane above the surface plus the safety distance";
    argument_is_code_of_digits(place, coded) "argument {place} is a code of digits, which {coded} is not"
        help "give a whole number from 0 on, or leave it out";
    argument_of_is_out_of_all_range(name) "an argument of {name} is out of all range";
    argument_of_has_to_be_text(place, name) "argument {place} of {name} has to be a text" alarm 12150
        help "arguments are counted by their commas";
    argument_of_has_to_be_number(place, name) "argument {place} of {name} has to be a number" alarm 12150
        help "a number in quotation marks is a text";
    turning_cycles_work_in_g18() "turning cycles work in G18" alarm 61101 help "program G18 before the cycle";
    dwell_in_turns_needs_fixed_spindle_speed() "a dwell in turns needs a fixed spindle speed"
        help "program S before the cycle, or give the dwell in seconds";
    radius_compensation() "radius compensation is on" alarm 61815 help "program G40 before the cycle";
    pitch_is_below_0_and_thousands(which)
        "the pitch is below 0, and the thousands of `_AMODE` say a {which}-hand thread" alarm 61001
        help "give the pitch without a sign, or 0 there";
    depth_is_missing(missing) "the depth is missing: {missing}" alarm 61808
        help "0 in the units of `_AMODE` takes what is given";
    depth_is_missing_so_give_dp() "the depth is missing" alarm 61808 help "give DP (argument 4) or DPR (argument 5)";
    dwell_in_seconds_is_below_0() "a dwell in seconds is below 0"
        help "give it without a sign; 2 in the tens of `_AMODE` counts turns";
    needs_angle_at_tip_of_tool(what) "{what} needs the angle at the tip of the tool";
    needs_radius_of_tool(what) "{what} needs the radius of the tool";
    tool_has_diameter_of_mm(radius, diameter)
        "the tool has a diameter of {radius} mm, and the centring {diameter} mm"
        help "take a larger tool, or a smaller centring";
    rtp_rfp_are_same() "RTP and RFP are the same" alarm 61101
        help "RTP lies above RFP, so that the cycle knows where the depth is";
    dpr_stands_beside_centring_by_diameter() "DPR stands beside a centring by diameter" alarm 61805
        help "leave DPR out, or take 0 in the tens of `_GMODE` for a depth";
    diameter_of_centring_is_not_above_0() "the diameter of the centring is not above 0" alarm 61019
        help "give the diameter of the cone at the surface, above 0";
    hole_lies_along_y() "the hole lies along Y, the tool axis of G18, and no block has moved Y" alarm 61005
        help "program G17 before the cycle to drill along Z; where the lathe has a Y, program it once before";
    axn_is_0_to_3() "`_AXN` is 0 to 3" alarm 61803 help "0 is the tool axis";
    there_is_no_such_approach_or_retraction(name, place)
        "there is no such approach or retraction: `{name}` (argument {place})" alarm 61115
        help "1 line, 2 quadrant, 3 semicircle; tens 1 in space";
    length_or_radius_is_0_or_missing(name, place) "the length or radius `{name}` (argument {place}) is 0 or missing" alarm 61116
        help "give a size above 0";
    asks_for_arc(name, place) "`{name}` (argument {place}) asks for an arc, and `_RL` 40 knows lines only" alarm 61115
        help "give 1 or 11, or a side of the contour";
    contour_that_runs_backwards_has_at_most(most_backwards, elements)
        "a contour that runs backwards has at most {most_backwards} elements, this one has {elements}"
        help "split the contour, or turn it around";
    side_rl_is_40_41_or_42(place, other) "the side `_RL` (argument {place}) is 40, 41 or 42, not {other}" alarm 61114
        help "41 left, 42 right of the contour, 40 on it";
    dmode_names_another_plane_than_one() "`_DMODE` names another plane than the one of the contour" alarm 61101
        help "select the plane before the cycle: G17, G18 or G19";
    no_drilling_cycle_is_active() "no drilling cycle is active" alarm 62100 help "call it before: MCALL CYCLE81(…)";
    position_has_one_coordinate() "a position has one coordinate only" help "give both";
    neighbours_run_into_each_other(gap, width)
        "neighbours run into each other: {gap:.4} mm between their centres, {width} mm wide" alarm 61104
        help "give a larger radius of the circle, a larger angle between them, or fewer of them";
    number_num_is_1(place, most_slots) "the number `NUM` (argument {place}) is 1 to {most_slots}" alarm 61103
        help "give a whole number";
    angle_sta2_is_below_90(place) "the angle `_STA2` (argument {place}) is below 90" alarm 61019
        help "give the angle in degrees";
    angle_of_insertion_rad1_is_above_0(place)
        "the angle of insertion `_RAD1` (argument {place}) is above 0 and below 90" alarm 61019
        help "give the angle in degrees";
    pitch_of_helix_dp1_is_0(place) "the pitch of the helix `_DP1` (argument {place}) is 0 or missing" alarm 61019
        help "give the depth of one turn";
    there_is_no_such_kind(name, place) "there is no such kind of machining: `{name}` (argument {place})" alarm 61002;
    corner_radius_of_mm_is_smaller(args, place, corner, radius)
        "the corner radius `{args}` (argument {place}) of {corner} mm is smaller than the cutter's, {radius} mm" alarm 61113
        help "take a smaller cutter, or give a larger corner radius";
    length_leng(length) "the length `LENG` (argument 7) of {length} mm has no room for the cutter" alarm 61105
        help "give a length above the diameter of the cutter, or drill the hole";
    radius_rad(radius) "the radius `RAD` (argument 11) of {radius} mm is not larger than half of the width" alarm 61118
        help "give a larger radius, or mill the ring as a pocket";
    angle_of_slot_afsl() "the angle of the slot `AFSL` (argument 7) is out of range" alarm 61118
        help "give an angle above 0 and below 360 degrees";
    slots_about_one_point_run_into_each() "slots about one point run into each other: `NUM` (argument 6)" alarm 61104
        help "give 1, or 0 in the thousands of `_GMODE` for slots on a circle";
    size_of_blank_is_0_or_missing(name, place) "the size of the blank `{name}` (argument {place}) is 0 or missing" alarm 61019
        help "give it: outside of the blank the tool travels at rapid traverse";
    number_of_edges_num_is_3(place, most_edges) "the number of edges `_NUM` (argument {place}) is 3 to {most_edges}" alarm 61019
        help "give a whole number";
    flank_infeed_iflank_contradicts_angle_iang() "the flank infeed `_IFLANK` contradicts the angle `_IANG`"
        help "give the angle, and the length as the editor computes it";
    is_no_number_of_passes_or_starts(value) "{value} is no number of passes or starts" help "give a whole number";
    vari_is_1_to_4() "VARI is 1 to 4" alarm 61002
        help "1 external, 2 internal with equal infeed; 3 external, 4 internal with equal cross-section";
    infeed_mid_of_mm_makes_passes(infeed, cuts) "the infeed `_MID` of {infeed} mm makes {cuts:.0} passes" alarm 61001
        help "give a larger infeed";
    infeed_mid_is_below_0() "the infeed `_MID` is below 0" alarm 61001
        help "give the infeed without a sign, or the number of passes `_NRC` alone";
    infeed_angle_iang(angle) "the infeed angle IANG is {angle}, over half of the 60 degrees of a metric thread"
        help "give at most 30, below 0 for alternating flanks";
    start_angle_nsp(start_angle) "the start angle NSP is {start_angle}" help "give 0 to below 360 degrees";
    spindle_does_not_turn_so_program_m3() "the spindle does not turn" alarm 61102
        help "program M3 or M4 with a speed before the cycle";
    infeed_mid_is_so_small(place) "the infeed `_MID` (argument {place}) is so small that its passes do not end" alarm 61019
        help "give a larger infeed";
    allowance_fal_is_not_smaller_than_depth(place)
        "the allowance `_FAL` (argument {place}) is not smaller than the depth of the thread" alarm 61019
        help "give a smaller allowance";
    teeth_of_edge_nt_are_1(place) "the teeth of an edge `_NT` (argument {place}) are 1 to 1000" alarm 61019
        help "give a whole number";
    kind_of_thread_is_0_or_1(name, place) "the kind of the thread `{name}` (argument {place}) is 0 or 1" alarm 61002
        help "0 internal, 1 external";
    cycle_would_go_beyond_turning_centre() "the cycle would go beyond the turning centre"
        help "check the diameter, the end of the face and the clearance";
    allowance_on_all_sides_stands_beside() "an allowance on all sides stands beside one along an axis"
        help "the control takes either `_FAL` or `_FALX` and `_FALZ`: give one of them";
    size_piti() "the size `_PITI` (argument 18) is missing" alarm 61001 help "`_PITI` counts the sizes of DIN 509: 0 to 9, 0 is 0.6x0.3";
    size_piti_is_usually(radius, depth, at) "the size `_PITI` (argument 18) is missing" alarm 61001
        help "{radius}x{depth} is usual for this diameter: `_PITI` {at}";
    pitch_piti() "the pitch `_PITI` (argument 18) is missing" alarm 61001 help "`_PITI` counts the pitches of DIN 76 from 0.2 on: 0 to 23";
    pitch_piti_is_usually(pitch, at) "the pitch `_PITI` (argument 18) is missing" alarm 61001
        help "{pitch} is usual for this diameter: `_PITI` {at}";
    table_has_no_such_size_or_pitch() "the table has no such size or pitch" alarm 61001;
    diameter_has_no_undercut(diameter) "the diameter {diameter} has no undercut" alarm 61601 help "give a diameter from 3 mm";
    diameter_has_undercut_of_pitch(diameter, pitch) "the diameter {diameter} has no undercut" alarm 61601
        help "the pitch {pitch} is usual for this diameter: CYCLE940 takes it";
    diameter_has_no_thread(diameter) "the diameter {diameter} has no undercut" alarm 61601
        help "give a diameter from 3 mm, for CYCLE96 a metric size from M3 to M68";
    position_does_not_exist_or_contradicts_form() "the position does not exist or contradicts the form" alarm 61613
        help "forms A and B are external, C and D internal";
    there_is_no_such_form() "there is no such form" alarm 61609
        help "\"E\" and \"F\" are of DIN 509, \"A\" to \"D\" of DIN 76, \"T\" is free (CYCLE940)";
    is_out_of_range(name) "`{name}` is out of range" alarm 61019;
    is_missing_2(name) "`{name}` is missing";
    edge_of_tool_does_not_lie()
        "the edge of the tool does not lie in a corner, so the position of the undercut is not known" alarm 61608
        help "give 1 to 4 as the last argument, `orientation` 1 to 4 of the tool in [tools], or `$TC_DP2` of the \
        edge before the cycle";
    position_vari_contradicts_edge_of_tool(given, edge)
        "the position `_VARI` {given} contradicts the edge of the tool, which lies at {edge}" alarm 61608
        help "give the position of the tool that cuts the undercut, or leave the argument out";
    form_e_has_no_allowance_along_z() "form E has no allowance along Z (`_EPL`)"
        help "leave it out; form F relieves the face, too";
    diameter_with_allowance_epd_lies_inside_part() "the diameter with allowance `_EPD` lies inside the part"
        help "an allowance lies outside the finished part";
    allowance_is_negative(key) "the allowance `{key}` is negative" help "give an allowance above 0, or none";
    entry_angle_sta_is_0() "the entry angle `_STA` is 0" help "give 30 to 90 degrees";
    vari_is_1_2_or_3() "`_VARI` is 1, 2 or 3" alarm 61002 help "1 roughs, 2 finishes, 3 does both";
    position_contradicts_form() "the position contradicts the form" alarm 61613
        help "forms A and B are external, C and D internal";
    machine_datum_20100_names_no_axis() "machine datum 20100 names no axis of G18, so there are no undercuts" alarm 16510
        asks "set `[machine] diameter_axis = \"X\"`";
}

P8101 Note "path-of-partc" "path of a cycle is that of partc" was "K8101 milling-path-of-partc S8220 siemens-groove-way S8225 siemens-cut-off-way S8231 siemens-milling-way"
"The control promises the shape, and its way there is not published. partc makes a path of its own that keeps allowances, infeeds and \
feeds; docs/cycles.md describes it. Compare it with what the machine does where the order of the cuts matters.\n\n\
Klartext: The control promises the finished shape, and its way there is not published. partc makes a path of its own that keeps the \
allowances, infeeds and feeds of the definition; docs/cycles.md describes it. Said once for each cycle and program. Compare the path \
with what the machine does where the order of the cuts matters.\n\n\
SINUMERIK: The control promises the final shape, and how it gets there is not published or not confirmed. The message names how the \
arguments are read and how the plunges are placed; docs/cycles.md describes the whole path. Compare it with what the machine does where \
the order of the cuts matters. The control promises the edge and the cut; how it cuts the edge is not published. partc plunges in front \
of it, so that the edge is cut on one side only. From the diameter of the reduced feed on the speed is constant, and it stays so after \
the cycle. The control promises the final shape, and how it gets there is not published or not confirmed. partc makes a path of its own \
that keeps the allowances and infeeds; docs/cycles.md describes it. Compare the path with what the machine does where the order of the \
cuts matters." {
    cycle_finished_shape_is_as_programmed(cycle, what)
        "cycle {cycle} {what}: the finished shape is as programmed; entry, order of the cuts and approach are those \
        of partc";
    ways_of_call(call, ways) "{call}: {ways}"
        help "docs/cycles.md describes the path; compare with what the machine does";
    first_contour_is_pocket()
        "the first contour is the pocket, the others are islands; the rings, the points of insertion and the order \
        are those of partc";
    helix_becomes_smaller_where_walls_leave_less() "the helix becomes smaller where the walls leave less room";
    what_stands_outside_of_limits_is_taken()
        "what stands outside of the limits is taken as not in the way of the tool";
    of_amode_1(name) "{name} of `_AMODE` 1, is an absolute coordinate";
    digits_of_vari_are_read_from_stored() "the digits of `_VARI` are read from stored calls";
    contour_falls()
        "the contour falls, so roughing takes the nose radius into account: its tip alone would cut into the part";
    tip_of_tool_does_not_lie_ahead()
        "the tip of the tool does not lie ahead of its nose and inwards, so roughing takes the nose radius into \
        account";
    fal_is_left_beside_falx() "`FAL` is left beside `FALX` and `FALZ`";
    cut_goes_in_front_of_edge_first(args)
        "{args}: the cut goes in front of the edge first; the speed stays fixed after the cycle";
    cutter_leaves_open_side_by_safety_distance() "the cutter leaves an open side by the safety distance";
    limits_are_read_from_right_as_walls()
        "limits are read from the right as walls at the minus and plus side of the first axis, then of the second";
    groove_93_as_partc_reads_it()
        "WIDG counts at the floor, DIAG square to the axis, plunges are at most 0.8 of the tool apart and start from the middle";
    groove_930_as_partc_reads_it()
        "the digits of `_VARI` and `_AMODE` are read as in stored calls, plunges are at most 0.8 of the tool apart and start from the middle";
    controls_do_not_publish_cuts()
        "controls do not publish the cuts: they are at equal depths, follow the contour up to the cut before, and \
        relief cuts are cut from their falling side";
    in_space_tool_falls_over_whole_way()
        "in space the tool falls over the whole way at the feed for the depth, and rises at that of the plane";
    of_0_in_hundreds_of_vari_lifts_tool() "0 in the hundreds of `_VARI` lifts the tool to the retraction plane";
    rings_of_level() "the rings of a level, and how the tool comes to the wall, are those of partc";
    single_slot_of_editor_lies_about_cpa() "a single slot of the editor lies about CPA and CPO, and RAD is not used";
    slot_lies_about_cpa() "the slot lies about CPA and CPO, and RAD is not used";
    tool_goes_straight_down_at_feed() "the tool goes straight down at the feed for the depth";
    length_is_taken_over_outer_edges()
        "the length is taken over the outer edges, and the depth goes down at each end";
    angle_of_slot_is_taken_between_centres() "the angle of a slot is taken between the centres of its round ends";
    without_codes_behind_dp1_fifth_argument()
        "without codes after `_DP1` the fifth argument is read as the radius, not as the diameter";
    tool_goes_down_safety_distance_beside_blank()
        "the tool goes down the safety distance beside the blank, and comes to the wall on a semicircle";
    odd_number_of_edges() "an odd number of edges: `_SWL` is read as the length of an edge";
    even_number_of_edges() "an even number of edges: `_SWL` is read as the width across flats";
    tool_comes_to_thread()
        "the tool comes to the thread and leaves it on a semicircle of half a pitch; an internal one needs its core \
        down to the depth";
    no_sense_is_given(hand) "no sense is given: the tool climbs, and the thread is {hand}";
    from_surface_down_this_sense_makes_thread(hand) "from the surface down this sense makes a {hand} thread";
}

P8102 Warning "corner-radius-not-counted" "corner radius of the cutter is not counted" was "K8108 S8241 siemens-milling-corner-radius"
"The milling cycles compute their paths for a cutter with sharp corners. With a corner radius (R2 of the tool table, `[tools.N] \
corner_radius`, DR2) a rounding stays at the foot of each wall, and cusps stay on the floor between paths that lie farther apart than \
the flat part of the cutter is wide. Give a smaller overlap factor, or finish with another cutter." {
    cycle_corner_radius_mm_of_cutter(cycle, shown, shown2)
        "cycle {cycle}: the corner radius {shown} mm of the cutter is not counted: it stays at the foot of walls, \
        and as cusps on floors where paths lie farther apart than {shown2} mm"
        help "give a smaller overlap factor, or finish with a cutter that has no corner radius";
    corner_radius_mm_of_cutter(args, rounding, radius, rounding2)
        "{args}: the corner radius {rounding} mm of the cutter, radius {radius} mm, is not counted: it stays at the \
        foot of walls, and as cusps on floors where the infeed in the plane is larger than {rounding2} mm"
        help "finish the floor with a smaller infeed in the plane, or with a cutter that has no corner radius";
}

P8103 Warning "feed-in-contour" "feed in the contour of a cycle does not count" was "K2953 S8199 siemens-contour-feed"
"Klartext: Cycles along contours have feeds of their own, Q11 and Q12. An F in the subprogram of a contour is left out.\n\n\
SINUMERIK: F, FRC or FRCM stands in a contour that a cycle takes. partc moves at the feeds of the cycle. The available manuals do not say \
for every cycle whether F of the contour counts while finishing; give the feed to the cycle." {
    f_in_contour_does_not_count(contour_name)
        "F in the contour {contour_name} does not count: the cycle moves at its own feeds";
    in_contour_does_not_count(word, name)
        "{word} in the contour `{name}` does not count: the cycle moves at its own feeds";
}
}
