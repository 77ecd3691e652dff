//! `T`: HEIDENHAIN turning: MANUALplus 4110, DIN PLUS and smart.Turn.

super::codes! { TURNING:

T1004 Error "turning-comment" "comment is not closed, or words follow it"
"A comment stands in square brackets at the end of its block or alone on its line. Words after a comment would be easy to overlook, and \
a bracket that is not closed may have swallowed words." {
    words_stand_behind_comment() "words stand after a comment";
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
    section_begins_behind_blocks_that_ran_already() "a section begins after blocks that ran already"
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
"A zero shift moves everything that follows. Here its amount depends on something the program does not say, or on a rule that no available manual \
confirms. Write the coordinates without the shift, or put it before the first move." {
    whether_g59_ends_shifts_of_g51() "no available manual says whether G59 ends the shifts of G51 and G56"
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
        help "name the first element that is cut: the G1, G2 or G3 block after the start point";
    block_number_stands_in_two_contours(ns) "the block number {ns} stands in two contours"
        help "number the blocks of the geometry sections so that each number stands once";
    no_element_of_named_contour(name, number)
        "no element of the contour `{name}` has the block number {number}"
        help "NS and NE name blocks of the contour that ID names";
}

T2020 Error "turning-case-fall-through" "branch of SWITCH without BREAK"
"A branch runs into the next CASE. No available manual says whether the control then goes on there or leaves the SWITCH. End each branch with BREAK." {
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
        help "program a straight move with G40, G41 or G42, or after it";
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
}
