//! `T`: HEIDENHAIN turning: MANUALplus 4110, DIN PLUS and smart.Turn.

super::codes! { TURNING:

T1004 Error "turning-comment" "comment is not closed, or words follow it"
"A comment stands in square brackets at the end of its block or alone on its line. Words behind a comment would be easy to overlook, and \
a bracket that is not closed may have swallowed words." {
    words_stand_behind_comment() "words stand behind a comment";
    comment_is_not_closed() "the comment is not closed" help "close it with `]`";
}

T1007 Error "turning-value" "value is out of range"
"The word takes other values than this one: a whole number of a short list, a length above zero, or a factor up to 1. Check the value, \
and the sign." {
    dwell_time_is_not_negative() "a dwell time is not negative";
    oversize_of_blank_is_not_negative() "the oversize of a blank is not negative";
    rc_is_radius() "RC is a radius";
    lies_between_0(name) "{name} lies between 0 and 90 degrees";
    ns_ne_are_block_numbers() "NS and NE are block numbers, and NE does not stand alone";
    ns_and_ne_are_block_numbers() "NS and NE are block numbers";
    hole_does_not_lie_in_front() "the hole does not lie in front of the tool, towards -Z";
    has_to_be_above_zero(what) "{what} has to be above zero";
    is_none_of(letter, num, range) "{letter}{num} is out of range: {letter} is {range}";
    q_is_neither_0_nor_1(num) "Q{num} is neither 0 nor 1";
    r_is_no_radius(num) "R{num} is no radius";
    shift_is_no_number() "the shift is no number";
    bore_of_tube_is_smaller_than_tube() "the bore of a tube is smaller than the tube";
    d_is_no_sum_of_codes(num) "D{num} is no sum of codes of recesses and undercuts"
        help "add 256 for G23, 1536 for G22, 32768 for U, 65536 for E, 131072 for F, 262144 for DIN 76";
    h_is_no_form_of_undercut(form) "H{form} is no form of an undercut";
    lies_between_0_and_180_degrees() "A lies between 0 and 180 degrees";
    g701_takes_absolute_machine_coordinates() "G701 takes absolute machine coordinates";
    thread_leans_more_than_45_degrees_out() "the thread leans more than 45 degrees out of the axis of its pitch"
        help "program H0 for a pitch along Z, H1 for one along X";
    h_is_0_for_z_1() "H is 0 for Z, 1 for X, or 3 for along the path";
    e_is_no_share_of_feed(num) "E{num} is no share of the feed"
        help "on this control E is a factor above 0 and up to 1";
    e_has_to_be_above_zero() "E has to be above zero";
    greatest_infeed_is_not_zero() "the greatest infeed is not zero";
    cuts_of_g81_would_lie_beyond_turning(y) "the cuts of G81 would lie beyond the turning centre, down to X{y}"
        help "program X0 or more; an inside contour is roughed from X0 or more outwards";
    recess_is_narrower_than_tool() "the recess is narrower than the tool";
    recess_is_not_deeper_than_slope()
        "the recess is not deeper than the slope of 1.3 mm by which its flanks are entered"
        help "position the tool higher above the recess";
    recess_has_no_depth_below_tool() "the recess has no depth below the tool";
    negative_depth_is_that_of_external_thread()
        "a negative depth is that of an external thread, and the tool stands inside of it"
        help "position the tool outside of the thread, or program P without the sign";
    thread_has_no_depth() "the thread has no depth";
    speed_limit_is_above_zero() "a speed limit is above zero";
    thread_with_its_run(end) "the thread with its run-in and run-out leads beyond the turning centre, to X{end}"
        help "check R, B and P";
    does_not_lie_between_0(num) "A{num} does not lie between 0 and 60 degrees";
    thread_at_x_with_depth_of_mm(least, depth, root)
        "the thread at X{least} with a depth of {depth} mm reaches the turning centre: its root lies at X{root}"
        help "check the diameter and the depth, which counts as a radius";
    thread_runs_across_face() "the thread runs across a face, and U above 0 is the depth of a thread in a bore"
        help "program U with a minus sign";
    no_undercut_of_din_76_is_mm(width) "no undercut of DIN 76 is {width} mm wide"
        help "take the width of the table, or write the undercut with G1 and G2 blocks";
    number_is_too_large_for_any_control() "the number is too large for any control";
    is_below_zero(name, value, what)
        "{name}{value} is below 0: {what}";
    is_not_above_zero(name, value, what)
        "{name}{value} is not above 0: {what}";
    is_no_value(name, what)
        "{name} has no value that it takes: {what}";
}

T1008 Error "turning-place" "block stands in the wrong part of the program"
"A DIN PLUS program consists of sections: header lines in HEADER, tools in TURRET, shape in BLANK and FINISHED PART, everything that moves in \
MACHINING. The same words mean different things in different sections, so a block in the wrong one is refused." {
    words_have_no_place_in_this_section() "words have no place in this section"
        help "blocks that machine stand in the section MACHINING";
    variables_program_flow_belong_into_section_machining()
        "variables and program flow belong into the section MACHINING, not into a contour";
    block_of_contour_holds_one_g_function() "a block of a contour holds one G function"
        help "write one element in each block: G1 X50 Z-20";
    section_begins_inside_subprogram() "a section begins inside a subprogram";
    subprogram_ends_with_return() "a subprogram ends with RETURN, not with END";
    header_lines_stand_in_section_header() "header lines stand in the section HEADER";
    section_begins_behind_blocks_that_ran_already() "a section begins behind blocks that ran already"
        help "put the blocks into the section MACHINING";
    program_name_stands_in_middle_of_program() "a program name stands in the middle of the program"
        help "one file holds one program: put the second one into a file of its own";
}

T1009 Error "turning-structure" "IF, WHILE or SWITCH is not closed or not opened"
"Every IF needs its ENDIF, every WHILE its ENDWHILE, every SWITCH its ENDSWITCH, in the same program and section. \
Otherwise it is open which blocks run." {
    this_is_not_closed_when_subprogram_ends() "this is not closed when the subprogram ends";
    this_structure_is_not_closed() "this structure is not closed" help "close it with ENDIF, ENDWHILE or ENDSWITCH";
    stands_outside(what, needs) "{what} stands outside of {needs}";
    structures_are_nested_deeper_than_levels(deepest) "structures are nested deeper than {deepest} levels";
    this_is_not_closed_when_program_ends() "this is not closed when the program ends";
    this_is_not_closed_when_next_section() "this is not closed when the next section begins";
}

T1012 Warning "turning-unit-frame" "frames of units do not match"
"smart.Turn frames the blocks of a unit with UNIT and END_OF_UNIT. The blocks are compiled as they stand, the frame means nothing to the path. \
A frame that does not match shows that the file was edited: check that no block is lost." {
    unit_begins_inside_another() "a unit begins inside another one"
        help "the file may have been edited by hand: check that no block is lost";
    unit_ends_that_did_not_begin() "a unit ends that did not begin"
        help "the file may have been edited by hand: check that no block is lost";
}

T1013 Note "turning-unit-missing" "no #UNIT line"
"The unit of a DIN PLUS program is fixed in its header. Without the line the control takes its own setting; partc takes `[control] unit` of \
partc.toml, or millimetres." {
    no_unit_line() "no #UNIT line: lengths are taken as millimetres"
        asks "set `[control] unit` in partc.toml, or add `#UNIT METRIC`";
}

T1014 Error "turning-unit" "unknown unit"
"The header line #UNIT says METRIC or INCH. The difference is a factor of 25.4, so another word is not guessed." {
    is_no_unit(value) "`{value}` is no unit" help "write `#UNIT METRIC` or `#UNIT INCH`";
}

T2001 Error "turning-no-path-function" "coordinates without a function that moves"
"On these controls every block that moves holds its function (G0, G1, G2 …); no manual says that the last one goes on. \
Write the function into the block." {
    block_has_coordinates() "the block has coordinates and no function that moves"
        help "write G0 or G1 into the block";
}

T2004 Error "turning-speed-mode" "S without G96 or G97"
"S is a cutting speed under G96 and a number of revolutions under G97. Neither was programmed, so S has no meaning yet." {
    neither_g96_nor_g97_says_what_s() "neither G96 nor G97 says what S means"
        help "program `G97 S…` for revolutions per minute or `G96 S…` for a constant cutting speed";
}

T2005 Note "turning-speed-limited" "speed is lowered to the limit of G26"
"G26 sets the highest speed. The program asks for more under G97, and the control would turn with the limit; the limit is printed." {
    speed_is_lowered_to_limit_of_g26(speed, limit) "the speed {speed} is lowered to the limit {limit} of G26";
}

T2006 Error "turning-change-point" "tool change point is not known"
"G14 moves to the tool change point, which is stored in the control. Where it lies decides whether the turret can turn without a collision, \
so it is never guessed: set `[control] tool_change_point = { X = 300.0, Z = 400.0 }` in partc.toml, in machine coordinates, X as a diameter." {
    where_tool_change_point_lies_only_machine() "where the tool change point lies only the machine knows"
        asks "set its machine coordinates in partc.toml: `[control] tool_change_point = {{ X = 300.0, Z = 400.0 }}`";
    only_first_tool_change_point_is_known() "only the first tool change point is known";
}

T2007 Error "turning-tool-number" "tool number cannot be printed"
"T names a position of the turret, with a point and a digit for one edge of a tool that has several (`T2.1`). The target knows whole tool \
numbers only: give the edge a number in `[tools.\"2.1\"]`. Four digits name a tool and its offset; both have to be the same." {
    word_is_no_tool(word) "`{word}` is no tool" help "write the position in the turret: T3";
    word_is_no_edge(word) "`{word}` is no edge of a tool" help "write the edge with one digit: T3.1";
    word_names_tool_and_offset_of_another(word)
        "`{word}` names a tool and the offset of another, which the target cannot select"
        help "write the tool alone: T3";
    edge_of_tool_has_no_tool_number(edge, number) "edge {edge} of tool {number} has no tool number to print"
        asks "add `[tools.\"{number}.{edge}\"]` with `number = …` to partc.toml";
}

T2011 Error "turning-subprogram" "subprogram is not found, or not clear"
"L calls a subprogram of the same file by the name in its section SUBPROGRAM, or with V1 one in a file of its own. There is none of this \
name, or there are two. Without it the path is incomplete, so nothing is written." {
    there_is_no_section_subprogram(name) "there is no section SUBPROGRAM \"{name}\"";
    subprogram_stands_twice_in_this_file(name) "the subprogram `{name}` stands twice in this file"
        help "give one of them another name";
}

T2014 Error "turning-variable-scope" "variable of another program"
"The manuals disagree whether # variables with a plain number belong to one program or to all. The program reads one that another program \
set, so the result depends on that. Hand the value over in the L block, or use #c variables." {
    was_assigned_in_another_program_than_one(var) "{var} was assigned in another program than the one that reads it"
        help "hand the value over in the L block, or use #c variables";
}

T2015 Note "turning-zero" "coordinates count from the workpiece zero of G59"
"G59 sets the workpiece zero in machine terms. The output has coordinates relative to the first G59 of the program: the work offset of the target \
has to be set there. Later shifts are computed into the coordinates." {
    coordinates_count_from_workpiece_zero_of_g59(z)
        "coordinates count from the workpiece zero of G59, {z} mm in front of the chuck"
        help "set the work offset of the target there";
}

T2016 Error "turning-shift" "zero shift is not clear"
"A zero shift moves everything that follows. Here its amount depends on something the program does not say, or on a rule that no manual at hand \
confirms. Write the coordinates without the shift, or put it in front of the first move." {
    whether_g59_ends_shifts_of_g51() "whether G59 ends the shifts of G51 and G56 no manual at hand says"
        help "program `G51 Z0` first, and take the sum of G56 back";
    g59_moves_workpiece_zero_that_positions()
        "G59 moves the workpiece zero that the positions of `[start]` count from, by an amount that only the machine \
        knows"
        help "leave `[start]` out of partc.toml, and begin the program with absolute positions";
    g59_moves_workpiece_zero_that_program()
        "G59 moves a workpiece zero that the program has used already, by an amount that only the machine knows"
        help "program G59 before the first move, too";
    zero_shift_in_x_is_not_supported()
        "a zero shift in X is not supported: the manuals do not say whether it counts in diameters"
        help "leave out X, or take the shift into the coordinates";
}

T2017 Error "turning-family" "program is for another control than configured"
"MANUALplus 4110 programs have no sections; DIN PLUS and smart.Turn programs have them. The same words differ between the two: I of an arc is a \
diameter on the 4110 and a radius later. Set `[control] heidenhain_turning` in partc.toml to the control the program was written for." {
    manualplus_4110_has_no_g869()
        "the MANUALplus 4110 has no G869, and a program without sections is one of that control"
        asks "set `[control] heidenhain_turning = \"manualplus620\"` in partc.toml if it is for a later control";
    programs_of_manualplus_4110_have_no_sections() "programs of the MANUALplus 4110 have no sections"
        asks "set `[control] heidenhain_turning = \"manualplus620\"` in partc.toml for DIN PLUS programs";
}

T2019 Error "turning-contour-reference" "contour reference is not found"
"NS and NE name the first and last element of a contour by their block numbers. No block of a geometry section has the number. Block numbers \
change when a program is renumbered: check the references." {
    there_is_no_contour(name) "there is no contour `{name}`, or more than one"
        help "give each auxiliary contour a name of its own: AUXIL_CONTOUR ID\"…\"";
    no_element_of_contour_has_block_number(missing) "no element of a contour has the block number {missing}"
        help "NS and NE name blocks of the geometry sections; each number may stand there once";
    n_is_start_point_of_contour(missing) "N{missing} is the start point of a contour (G0), not an element of it"
        help "name the first element that is cut: the G1, G2 or G3 block behind the start point";
    block_number_stands_in_two_contours(ns) "the block number {ns} stands in two contours"
        help "number the blocks of the geometry sections so that each number stands once";
    no_element_of_named_contour(name, number)
        "no element of the contour `{name}` has the block number {number}"
        help "NS and NE name blocks of the contour that ID names";
}

T2020 Error "turning-case-fall-through" "branch of SWITCH without BREAK"
"A branch runs into the next CASE. Whether the control then goes on there or leaves the SWITCH no manual at hand says. End each branch with BREAK." {
    branch_before_has_no_break() "the branch before has no BREAK" help "end every branch of SWITCH with BREAK";
}

T2021 Error "turning-compensation" "nose radius compensation in the wrong place"
"G40, G41 and G42 need a straight move, exclude cycles and tool changes, and G41 and G42 cannot follow each other directly." {
    g_stands_under_nose_radius_compensation(fun) "G{fun} stands under nose radius compensation"
        help "program G40 with a straight move before it";
    g_stands_inside_of_contour_of_g89(side) "G{side} stands inside of the contour of G89"
        help "program it once, in the block after G89";
    workpiece_zero_shifts_under_nose_radius_compensation()
        "the workpiece zero shifts under nose radius compensation"
        help "program G40 with a straight move before the shift";
    program_ends_with_nose_radius_compensation() "the program ends with the nose radius compensation on"
        help "program G40 with a straight move before the end";
    nose_radius_compensation_begins_or_ends() "nose radius compensation begins or ends on an arc"
        help "program a straight move with G40, G41 or G42, or behind it";
    tool_changes_under_nose_radius_compensation() "the tool changes under nose radius compensation"
        help "program G40 with a straight move before the tool change";
    g41_g42_follow_each_other_without_g40() "G41 and G42 follow each other without G40"
        help "program G40 with a straight move between them";
}

T2022 Error "turning-slide" "program for another slide"
"The program or the block is for a slide other than $1. Two slides work at the same time, which plain G-code for one slide cannot say." {
    block_is_for_slide(number) "the block is for slide ${number}: two slides move at the same time"
        help "compile a copy that holds the blocks of slide $1 only";
    these_blocks_are_for_other_slides() "these blocks are for other slides than $1"
        help "only programs of the first slide are compiled";
    program_is_for_slide(value) "the program is for slide {value}, not for slide $1"
        help "only programs of the first slide are compiled";
}

T2023 Warning "turning-tool-data" "tool data of the program is not used"
"A line of the turret section holds data of a simple tool. partc takes tool data from partc.toml: add the tool there where a cycle or the \
compensation needs it." {
    data_of_this_tool_is_not_used(tool) "the data of this tool is not used: tool data comes from partc.toml"
        asks "add `[tools.{tool}]` with `radius`, `width` and `orientation`";
}

T2025 Error "turning-side" "tool stands on the wrong side of the contour"
"Roughing removes what lies between the contour and the tool. Here the contour falls away from the tool, so the tool stands where the finished \
part will be, or it is not clear whether the cycle works outside or inside. Nothing is written: position the tool at the corner of the blank." {
    tool_stands_at_inside_of_material(word, scale, scale2)
        "the tool stands at {word}{scale} inside of the material: the rim of the recess lies at {word}{scale2}"
        help "position the tool outside of the material, beyond the rims of the recess, and begin its contour at a \
        rim";
    tool_does_not_stand_outside_of_contour()
        "the tool does not stand outside of the contour on the side from which it is roughed"
        help "position the tool at the corner of the blank, beyond the highest point of the contour; a bore is given \
        with I of G20";
    tool_does_not_stand_beside_contour()
        "the tool does not stand beside the contour, so there is no side to begin at"
        help "position the tool in front of the contour, at the corner of the blank";
    g_begins_at_tool(number, word, tool, limit, beyond)
        "G{number} begins at the tool, which stands at {word}{tool} inside of the blank: its surface lies at \
        {word}{limit}"
        help "position the tool at {word}{limit} {beyond} before the cycle; where that part of the blank was cut off \
        before, give in BLANK what is left";
    tool_comes_to_undercut_from_side(edge)
        "the tool comes to the undercut from a side that its edge position {edge} does not cut"
        help "check where the tool stands before G85, and `orientation` of the tool in partc.toml";
    tool_does_not_stand_in_front() "the tool does not stand in front of the undercut and clear of it"
        help "position it in front of where the undercut begins, and beyond its end at the shoulder";
    side_of_contour_is_not_clear()
        "it is not clear on which side of the contour the tool works"
        help "position the tool clear of the contour, on the side from which it is turned; for a bore give I of \
        G20, or `radius` and `orientation` of the tool in partc.toml";
    tool_stands_below_contour()
        "the tool stands below the contour, and no bore is known"
        help "position the tool clear of the contour, on the side from which it is turned; for a bore give I of \
        G20, or `radius` and `orientation` of the tool in partc.toml";
}

T2026 Note "turning-left-standing" "falling parts of the contour are left standing"
"Parts of the contour that fall behind a higher one can only be reached by plunging, which this cycle does not do as it is programmed. The cuts \
end as if the contour went on level. G810, G819, G820 and G829 cut these parts with a feed above 0 in E; else rough them with a cycle of their own." {
    g_leaves_parts_of_contour_standing(number)
        "G{number} leaves the parts of the contour standing that fall behind higher ones";
    e_cuts_parts_that_g_leaves(number)
        "G{number} leaves the parts of the contour standing that fall behind higher ones"
        help "E with a feed above 0 cuts them";
}

T2027 Note "turning-nose-unknown" "nose radius of the tool is not known"
"Contour cycles compensate the radius of the nose. The program does not hold it. This contour lies along the axes, where the programmed point of the tool is \
exact, so it is printed; in inner corners the nose leaves its radius standing. A face that ends at X0 keeps a pip of that radius at the centre: the nose touches the face beside the programmed point. With a slope or an arc the cycle is refused (P2004). Add `radius` and `orientation` \
of the tool to `[tools]` in partc.toml." {
    nose_leaves_inner_corners()
        "the nose radius of the tool is not known: its programmed point follows the contour, which lies \
        along the axes"
        help "add `radius` and `orientation` of the tool to partc.toml: the nose leaves its radius in inner \
        corners";
    nose_leaves_inner_corners_and_pip()
        "the nose radius of the tool is not known: its programmed point follows the contour, which lies \
        along the axes"
        help "add `radius` and `orientation` of the tool to partc.toml: the nose leaves its radius in inner \
        corners, and a pip of that radius at the centre of the face, unless the face goes past the centre \
        by it";
}

T2028 Warning "turning-descending-feed" "feed on descending elements is partc's choice"
"Where E is missing the control lowers the feed on descending elements by up to a half, depending on their angle. partc takes half the feed on \
all of them. Program E to set it." {
    descending_elements_are_cut_at_half_feed()
        "descending elements are cut at half the feed: E is missing, and the control lowers it by up to that"
        help "program E with the feed for descending elements";
}

T2029 Note "turning-strokes-only" "recess is cut in strokes only"
"Retired: G86 without an oversize was not finished. Its strokes reach the floor, and walls, floor and chamfers are finished with an oversize or without."

T2030 Error "turning-flank" "flank of the tool does not clear a falling part"
"A part of the contour falls more steeply than the clearance angle of the tool: its flank would cut into the finished part behind its edge. Take another tool, \
or rough this part with a recess cycle." {
    contour_falls_at_degrees(steepest, angle)
        "the contour falls at {steepest:.1} degrees, and the flank of the tool clears {angle} only"
        help "take a tool with a larger clearance angle (`clearance` in partc.toml), or leave these parts out with \
        E0";
}

T2031 Note "turning-flank-unknown" "clearance of the flank is not checked"
"Roughing goes down the falling parts of the contour, where the flank of the tool has to clear them. Its angle is not known: add `clearance` of the tool to \
`[tools]` in partc.toml to have it checked." {
    g_cuts_falling_parts(number)
        "G{number} cuts falling parts: whether the flank of the tool clears them is not checked"
        asks "give the clearance angle of the tool in partc.toml: `[tools.N] clearance = 30`";
}

T2070 Error "turning-said-twice" "form or blank is described twice"
"A corner takes one undercut, an element one thread, and a part one blank. Here a second block describes the same one once more, and only one of \
the two can be meant. Remove the other." {
    blank_is_described_already() "the blank is described already, by an earlier G20 or G21"
        help "keep one of the two blocks";
    corner_has_undercut() "this corner has an undercut already"
        help "keep one of the two blocks";
    element_is_thread() "this element is a thread already"
        help "keep one of the two blocks";
}

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
"A contour behind a cycle begins with `G0`, consists of G0 to G3, G12 and G13, and ends with a block that holds G80 alone." {
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
    stands_behind_element_of_contour(what) "{what} stands behind an element of the contour";
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
"G31 cuts threads in the front face and in the rear face with the same words. The edge position of the tool tells which one is meant; no manual at \
hand says that the control decides by it." {
    face_is_taken_from_edge()
        "the face of this transverse thread is taken from the edge position of the tool"
        asks "set `[control] thread_face = \"front\"` or \"rear\" to say it";
}

T8003 Warning "turning-simple-thread" "words of G32 are partc's reading"
"No manual at hand lists the words of G32. They are read as docs/turning.md says. Program G31 where its words are known." {
    words_of_g32_are_read()
        "the words of G32 are read as docs/turning.md says: no manual at hand lists them"
        asks "set `[control] simple_thread = \"documented\"` to confirm it, or \"refuse\"";
}

T8004 Warning "turning-infeed" "infeed of G81 is partc's reading"
"Whether I of G81 counts on the radius or on the diameter no manual at hand says. The number of cuts depends on it, the finished contour does not." {
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
tells: 3, 4 and 8 outside, 1, 2 and 6 inside. No manual at hand says that the control decides by it." {
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
"RI says how far the blank stands above the rim of a recess. Whether it counts on the diameter, as the oversize I does, no manual at hand says. \
A tool that expects too little material would plunge too deep at once: compare the first plunge with the drawing." {
    ri_counts_on_diameter()
        "RI of G869 is taken to count on the diameter"
        asks "set `[control] recess_blank = \"diameter\"` to confirm it, or \"radius\"";
}

T8011 Warning "turning-depth-compensation" "sense of R or RB of G869 is partc's reading"
"The compensation counteracts the bending of the tool while it turns the floor. It is taken to lift the tool, which never cuts too deep; no \
manual at hand gives the sign." {
    compensation_lifts_tool()
        "the turning depth compensation of G869 is taken to lift the tool off the floor"
        asks "set `[control] turning_depth = \"away\"` to confirm it, or \"towards\"";
}

T8012 Warning "turning-offset-one-way" "offset width of one-way turning is partc's reading"
"B pulls the ends of turned cuts in where the tool changes from turning to plunging. One way (U1) there is no such change inside the material, \
so B has no effect; no manual at hand says so." {
    offset_width_has_no_effect()
        "the offset width B has no effect under U1: one way there is no change from turning to plunging"
        asks "set `[control] offset_one_way = \"none\"` to confirm it, or \"end\"";
}

T8013 Warning "turning-recess-depth" "incremental I of G22 is partc's reading"
"I of G22 is a diameter, so its increment is taken as a difference of diameters. No manual at hand says so: with the other reading the recess is twice \
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
"The oversize of G86 is left until the finishing cut. Whether on the walls as well as on the floor no manual at hand says; on both never cuts too much." {
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

T8018 Warning "turning-finishing-side" "side of G41 and G42 behind G89 is partc's reading"
"The page of G89 prints G41 as right and G42 as left of the contour, the general page of the same manual the other way round. partc compensates the \
nose on the side on which the tool works: told by its edge position, else by where it stands." {
    side_is_taken_from_tool()
        "two pages of the manual give G41 and G42 behind G89 opposite sides: the side is taken from the \
        tool"
        help "check the side of the tool: where it stands, or `orientation` in partc.toml";
}

T8019 Warning "turning-nose-path" "path beside a contour is partc's reading"
"The manuals at hand say when G41 and G42 begin to act, and not where the tool stands then. partc leads it straight to the point at a right angle beside the start of \
the contour, around outside corners on an arc of the nose radius, and from the point beside its end straight on, as other controls do." {
    ends_of_compensation_are_partcs()
        "how G41 and G42 begin, end and go around outside corners no manual at hand says: at a right angle \
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
    whether_q_counts_passes_or_repeats_no() "whether Q counts passes or repeats no manual at hand says"
        help "write the L block as often as it shall run";
    of_g89_how_it_makes_is_shown(letter, what) "{letter} of G89: how it makes {what} is shown in a picture only"
        help "begin the contour with the element in front of the corner, and write the corner at its end";
    in_contour_of_g80_is_not_supported(name)
        "{name} in a contour of G80 is not supported: no manual at hand describes it"
        help "write the contour with G0, G1, G2 and G3 blocks before G80";
    no_manual_at_hand_lists_words(addr) "no manual at hand lists the words of G80 ({addr})"
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
    of_g36_what_its_values_do_no(letter, what) "{letter} of G36 ({what}): what its values do no manual at hand says"
        help "leave it out, and position the tool far enough in front of the thread";
    deep_hole_drilling_with_retraction_at_feed() "deep-hole drilling with retraction at feed is not supported";
    by_how_much_v_lowers_feed() "by how much V lowers the feed at entry and exit no manual at hand says"
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
        help "leave Q out, and position the tool behind the cycle";
    of_g_is_not_supported(letter, number) "{letter} of G{number} is not supported"
        help "leave it out, and end the contour where the cuts shall end";
    to_which_side_makes_end_oblique(offset)
        "to which side {offset} makes the end oblique is shown in a picture only"
        help "rough along a contour with G817 or G827";
    on_which_side_of_its_corner_wide() "on which side of its corner a wide recess lies is shown in a picture only"
        asks "set `[control] recess_side = \"plus\"` or `\"minus\"` in partc.toml: the side of the programmed \
        corner, along Z";
    whether_width_of_axial_recess_counts()
        "whether the width of an axial recess counts as a diameter no manual at hand says"
        help "leave I out and cut side by side, or program the recess with G869 on a later control";
    of_g32_no_manual_at_hand_gives(letter, what) "{letter} of G32: {what} no manual at hand gives"
        help "program G31, which has R, H and A";
    words_of_g32_are_not_confirmed() "the words of G32 are not confirmed by a manual"
        asks "program G31, or set `[control] simple_thread = \"documented\"` in partc.toml";
    alternating_flanks_that_begin_on_other_side()
        "alternating flanks that begin on the other side (a thread towards +Z) are not supported"
        help "program H0, H1 or H2";
    how_v_divides_depth_no_manual(kind) "how V{kind} divides the depth no manual at hand says"
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
        "how Q chooses the approach no manual at hand says"
        help "leave the word out, and name the elements to be finished with NS and NE";
    u_names_element_in_words_of_g80()
        "U names an element in the words of G80, which is not supported"
        help "leave the word out, and name the elements to be finished with NS and NE";
    what_b_of_g890_means_no_manual()
        "what B of G890 means no manual at hand says"
        help "leave the word out, and name the elements to be finished with NS and NE";
    cutting_limit_is_not_supported()
        "a cutting limit is not supported: to which side it holds is shown in a picture only"
        help "leave the word out, and name the elements to be finished with NS and NE";
    oversize_does_not_fit_cycle()
        "this oversize does not fit the cycle behind it"
        help "program I and K in the cycle, or G50 before it";
    oversize_does_not_fit_contour()
        "this oversize does not fit the contour behind it"
        help "program I and K in the cycle, or G50 before it";
    equidistant_or_negative_oversize()
        "an equidistant or negative oversize is not supported here"
        help "program I and K in the cycle, or G50 before it";
    g57_does_not_belong_to_g89()
        "G57 does not belong to G89"
        help "program I and K in the cycle, or G50 before it";
}

}
