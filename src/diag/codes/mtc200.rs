//! `M`: Rexroth MTC200.

super::codes! { MTC200:

M0003 Error "mtc-comment-open" "comment is not closed in its block"
"A comment in brackets ends in the block in which it begins. Without the closing bracket it is not clear which words belong to it, and \
a word that moves the tool might be lost. Close it, or write a comment that begins with `;`." {
    comment_that_begins_here_is_not_closed() "the comment that begins here is not closed"
        help "close it in the same block, or begin it with `;`";
}

M1002 Error "mtc-header" "file header is damaged"
"A transfer file begins with a line `%NPG…`, goes on with lines that begin with `!`, `#`, `$` or `*`, and ends its header with a second \
`%NPG`. Here such a line stands in the program, another line stands in the header, or the header never ends. What is header and what is \
program has to be certain: copy the file again. Source: NC Programming Instructions 17VRS, page 14-13." {
    header_of_file_never_ends() "the header of the file never ends" help "a second line `%NPG` ends it";
    this_line_stands_in_file_header() "this line stands in the file header"
        help "a second line `%NPG` ends the header";
    this_line_belongs_into_file_header() "this line belongs into a file header"
        help "a header begins with a line `%NPG:…` and ends with a line `%NPG`";
}

M1003 Error "mtc-address-alone" "address without a value"
"A letter stands alone. The control needs a number after it, or `=` and a variable: `X10`, `X=@050`." {
    address_has_no_value(letter) "the address {letter} has no value"
        help "write it with a number, or as {letter}=@050";
    word_has_no_value() "the word has no value";
    has_no_value(name) "{name} has no value" help "write it as `CF2` or `RD2`";
    acc_has_no_value() "ACC has no value";
}

M1005 Error "mtc-g-conflict" "G functions of one group in one block"
"Two G functions of the same group contradict each other, for example `G00` and `G01`. Only one of them can act, and the control refuses the \
block. Remove one, or put them into two blocks." {
    g_contradicts_g_of_same_block(number, first) "G{number} contradicts G{first} of the same block";
}

M1011 Error "mtc-calculation-beside-words" "calculation beside other words"
"A block assigns a variable and does something else as well. In which order the control does both is not documented, and the result \
may depend on it. Put the assignment into a block of its own." {
    variable_is_assigned_in_block_with_other() "a variable is assigned in a block with other words"
        help "put the assignment into a block of its own";
}

M2003 Error "mtc-interpolation-missing" "axis words without G00, G01, G02 or G03"
"No block before named the kind of motion. Which one is in force after switching on depends on the parameters of the machine: it might be \
rapid traverse. Program G00 or G01." {
    no_g00() "no G00, G01, G02 or G03 stands before this block"
        help "program the kind of motion in this block or in one before it";
}

M2005 Error "mtc-centre-ambiguous" "centre of the arc can be read in two ways"
"I, J and K are either coordinates of the centre or its distance from the start of the arc. For this arc both readings give a circle through both \
points, and no other arc of the program decides between them. The two circles are different. Set `[control] centres` to \"absolute\", \"relative\" or \
\"dimension\" (absolute under G90, relative under G91)." {
    centre_can(show, show2, radius) "the centre can be {show} or {show2}{radius}"
        asks "set `[control] centres` to \"absolute\", \"relative\" or \"dimension\"";
}

M2006 Error "mtc-centre-contradiction" "arcs read their centres in different ways"
"Another arc of the program shows that I, J and K are coordinates, this one fits only as distances from the start, or the other way round. One of \
them is wrong: check end point, centre and the position before the arc." {
    centre_fits_as_coordinates() "the centre fits only as coordinates, another arc only as distances"
        help "check end point, centre and the position before both arcs";
    centre_fits_as_distances()
        "the centre fits only as distances from the start, another arc only as coordinates"
        help "check end point, centre and the position before both arcs";
}

M2007 Warning "mtc-centre-unusual" "centre does not count as G90 or G91 say"
"Under G90 I, J and K are coordinates of the centre, under G91 distances from the start. The arcs of this program fit the other reading only, and that is compiled. \
Set `[control] centres` to say so and silence this warning." {
    centres_are_coordinates() "under G91 the centres of this program are coordinates"
        asks "set `[control] centres = \"absolute\"` if that is meant";
    centres_are_distances() "under G90 the centres of this program are distances from the start"
        asks "set `[control] centres = \"relative\"` if that is meant";
}

M2009 Warning "mtc-centre-zero" "missing centre word of a full circle counts as zero"
"A full circle passes through its start whatever its centre is, so nothing shows whether a missing I, J or K was forgotten. The control \
reads it as 0. Write both words." {
    of_this_full_circle_is_missing(missing) "{missing} of this full circle is missing and counts as 0"
        help "write both words";
}

M2012 Error "mtc-tool-missing" "no tool is selected"
"M6 changes to the tool that a T word selected, and path compensation needs its radius. No T stands before. Program `T5` first." {
    path_compensation_without_tool() "path compensation without a tool" help "program T and M6 before";
    m6_without_selected_tool() "M6 without a selected tool" help "program T before M6";
}

M2013 Error "mtc-g8-under-g61" "G08 cannot be programmed while G61 is active"
"G08 runs over block transitions without slowing down, G61 stops at each of them. The control refuses G08 while G61 is active. \
Program G62 first. Source: NC Programming Instructions 17VRS, page 4-8." {
    g08_cannot_be_programmed_while_g61() "G08 cannot be programmed while G61 is active" help "program G62 first";
}

M2014 Error "mtc-offset-axes" "G50 does not name all axes that have an offset"
"G50 replaces the programmed offset. Whether an axis that it does not name keeps the offset of an earlier G50 or G51 is not documented. Name every axis that \
has an offset, with 0 where it shall end." {
    g50_does_not_say_whether_keeps(letter) "G50 does not say whether {letter} keeps its offset"
        help "add {letter}0 to end it, or repeat its offset";
}

M2015 Error "mtc-thread-lead" "lead of the thread is not defined"
"G33 needs one lead, along the axis of the longer travel: I for X, J for Y, K for Z. Whether a lead along the other axis of a taper counts along that axis \
is not documented." {
    is_not_lead_of_longer_travel(letter) "{letter} is not the lead of the longer travel"
        help "write the lead of the axis that travels farthest";
    lead_of_thread(value) "the lead of the thread is {value}";
    g33_needs_one_lead() "G33 needs one lead: I, J or K"
        help "write the lead of the longer travel: K2 for Z, I2 for X";
}

M2016 Error "mtc-corner" "CF or RD without neighbours to cut"
"A chamfer or rounding stands at the end of a block that moves at feed in the working plane, or in a block of its own after such a block, and the next \
motion follows within 20 blocks and is no rapid traverse. Source: NC Programming Instructions 17VRS, page 12-2." {
    more_than_blocks_without_motion_stand(most_between)
        "more than {most_between} blocks without motion stand after this corner";
    block_behind_chamfer_or_rounding_is_no() "the block after a chamfer or rounding is no line or circle at feed";
    no_block_that_moves_at_feed_stands(name) "no block that moves at feed stands before this {name}"
        help "write it at the end of the first of the two blocks, or between them";
}

M2017 Error "mtc-rotary" "rotary axis position has no certain direction"
"An absolute position of a rotary axis is approached the short way and lies within 360 degrees. Here the way is exactly half a turn, or the value is larger. \
Program it incrementally, where the sign gives the direction. Source: NC Programming Instructions 17VRS, page 4-1." {
    moves_exactly_half_turn(letter) "{letter} moves exactly half a turn, either way"
        help "program it incrementally with G91";
    is_more_than_turn(letter, value) "{letter}{value} is more than a turn" help "program it incrementally with G91";
}

M2018 Error "mtc-incremental-offset" "incremental word right after a changed offset"
"One description of G50 counts an increment from where the tool stands, another from the last programmed position, to which the new offset is added: the two lie \
one offset apart. Program the axis once under G90 after the offset, then go on with G91." {
    is_incremental_its_zero_offset_changed_since(letter)
        "{letter} is incremental, and its zero offset changed since {letter} was programmed last"
        asks "program {letter} once under G90 after the offset, then go on with G91; or set `[control] \
        g91_after_offset` to \"with-offset\" or \"increment\"";
}

M2019 Error "mtc-thread-spindle" "thread is cut while the spindle does not turn"
"G33 moves the tool by its lead with every turn of the spindle. No M3, M4, M13 or M14 stands before it, or M5 or M19 stopped the spindle. Start it before the \
thread; an M function of the machine that is passed on counts as a start." {
    spindle_does_not_turn_when_g33_begins() "the spindle does not turn when G33 begins"
        help "program S and M3 or M4 before";
}

M2101 Error "mtc-offset-in-machine" "G53 with a programmed offset"
"G53 cancels the zero offsets. Whether that includes G50, G51 and G52 is not documented. Set the programmed offset to 0 before: `G50 X0 Y0 Z0`." {
    programmed_offset_while_g53_is_active() "a programmed offset while G53 is active"
        help "program G54 to G59 before";
    g53_while_offset_of_g50_or_g51() "G53 while an offset of G50 or G51 is in force"
        help "set the programmed offset to 0 before: `G50 X0 Y0 Z0`";
}

M2102 Error "mtc-offset-reset" "zero offset after JMP depends on the machine"
"JMP ends the program and resets the zero offset to what the machine's parameters say: none, or G54. The output cannot know which. Program G54 to G59 at the top of the program that JMP goes to." {
    zero_offset_after_jmp_depends_on_machine() "the zero offset after JMP depends on the machine"
        help "program G54 to G59 at the top of this program";
}

M2203 Error "mtc-rts-alone" "RTS without BSR or JSR"
"RTS goes back to the call, and there was none: the program ran into a subroutine from above, or jumped into it. End the main part with RET." {
    rts_without_call_by_bsr_or_jsr() "RTS without a call by BSR or JSR"
        help "end the main part with RET before the subroutines";
}

M2204 Error "mtc-branch-without-result" "branch before any calculation"
"BEQ, BNE, BPL and BMI look at the result of the last assignment, and no assignment ran before. Assign the variable that the branch is about." {
    no_result_was_calculated_before_this_branch() "no result was calculated before this branch"
        help "assign the variable that the branch is about in the block before";
}

M2205 Error "mtc-result-near-zero" "result is too close to zero to branch on"
"The result is not zero, but so small that it comes from the rounding of decimals. Whether the control's arithmetic gives exactly zero here cannot be known. \
Count with whole numbers, or compare with a margin." {
    last_result_is_nearly_zero(result) "the last result is {result}, nearly zero"
        help "count with whole numbers, or compare with a margin";
}

M2207 Error "mtc-no-rts" "subroutine has no RTS"
"The file ends inside a subroutine. Where the control goes on is not defined. Add RTS at its end." {
    subroutine_called_here_has_no_rts() "the subroutine called here has no RTS" help "add RTS at its end";
}

M2208 Error "mtc-bst-target" "BST continues in the middle of the program"
"BST ends the run; the next start continues at its label. The output starts at its top every time, so only a label at the top can be compiled. \
End the program with RET, or move the label." {
    next_start_would_go(label) "the next start would go on at .{label}"
        help "end the program with RET, or put the label at the top";
}

M2304 Error "mtc-function-doubtful" "result depends on the control's rounding"
"INT, MOD and DIV of a negative or broken number can round down or towards zero, and the manual does not say which. Make the value positive and whole, or compute it another way." {
    result_of_function_depends_on_rounding(name, x)
        "the result of {name}({x}) depends on how the control rounds"
        help "make the value positive: -INT(-@050)";
    result_of_two_depends_on_rounding(a, name, b)
        "the result of {a} {name} {b} depends on how the control rounds"
        help "use whole numbers of zero or more";
}

M2401 Error "mtc-whole-number" "word needs a whole number"
"G, M, T, D, E and the number of a program are whole numbers, zero or more. Check the word or its variable." {
    takes_whole_number(letter, at) "{letter} takes a whole number, not {at}";
}

M2702 Note "mtc-machine-word" "word of the machine is left out"
"The word is listed in `[control] machine_words`, so it is known not to move the tool, and it has no counterpart in the output. \
To print an M function for it, use a table: `machine_words = { LA_ON = \"M101\" }`." {
    is_left_out(name) "`{name}` is left out";
}

M2703 Note "mtc-no-geometry" "word has no geometry"
"ACC sets the acceleration, D and E select rows of the correction memory (M8007 where they count in the tool length), REV says where the operator's reverse key leads, G06 to G09 how the axes \
run through block transitions, G43 and G44 how path compensation goes around outside corners. None of them changes \
the programmed path, and the output has no word for them. Tool lengths and corrections are the target machine's business." {
    does_not_change_programmed_path(name) "{name} does not change the programmed path and has no word in the output";
}

M2705 Error "mtc-spindle-speed" "speed or dwell time has no meaning"
"A spindle speed is zero or more, its limit above zero, and a dwell time 0 to 1000000. Check the S or F word, or its variable." {
    dwell_time(at) "the dwell time is {at}";
    spindle_speed(at) "the spindle speed is {at}";
}

M8001 Note "mtc-tape-mark" "lone % is left out"
"A `%` alone in the first or the last line of a file is a mark of the paper tapes of old, before or after the program. It has no meaning here. Anywhere else it is an error." {
    that_stands_alone_is_mark_of_tape() "the `%` that stands alone is a mark of the tape and is left out";
}

M8002 Note "mtc-tool-length" "tool length compensation has no word in the output"
"G48 switches the compensation of the tool length on, G47 off. Under G48 the programmed path is that of the tool tip, which is what the output holds. Lengths are the \
target machine's business: `[output] tool_length = \"G43\"` prints G43 after each tool change. Source: NC Programming Instructions 17VRS, pages 5-10, 5-38, 5-41." {
    has_no_word_in_output(word) "{word} has no word in the output, whose positions are those of the tool tip";
}

M8003 Warning "mtc-spindle-nose" "move of the spindle nose"
"Without tool length compensation positions along the tool axis are those of the spindle nose: the tip is one tool length further down. The output has the same number \
for the tip, so the tool stays that much higher. Program G48 before, or have such moves refused: `[control] spindle_nose = \"refuse\"`." {
    moves_spindle_nose_here(letter, why)
        "{letter} moves the spindle nose here ({why}), and the output moves the tool tip"
        asks "program G48 before the move; to refuse such moves set `[control] spindle_nose = \"refuse\"`";
}

M8005 Warning "mtc-m-functions" "M functions are taken in their standard meaning"
"M0 to M9, M13, M14, M19 and M30 are taken as the standard has them. The machine builder may have given them another meaning. If they are as they should be, add \
`[control] confirmed = [\"m-functions\"]`; of those that differ, M7 to M9 may be listed in `[control] machine_words`, and a program with another one cannot be compiled." {
    m_functions_are_standard(number, key)
        "M{number} and the other M functions are taken in their standard meaning"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
}

M8006 Warning "mtc-border-axes" "one axis only in the way to a compensated contour"
"The first move under G41 or G42, and the move of G40, name both main axes of the plane, says the manual (page 5-34), and not what happens where one is missing. The axis that \
is missing is taken to stay where it was programmed. Program both." {
    way_to_contour_or_from_it_names()
        "the way to the contour or from it names one axis of the plane only; the other one stays"
        help "program both axes of the plane";
}

M8007 Warning "mtc-correction" "correction or edge counts in the tool length"
"D chooses a correction, E an edge of the tool. Both count in the tool length while G48 is active (17VRS, pages 5-10 and 5-41), and a program that has no G47 is taken to \
run with it. The output has no word for them, so the target goes wrong by the correction, or by the difference between the edges. D0 and E1 change nothing." {
    correction_counts_in_length()
        "the correction D counts in the tool length, and the output has no word for it: the tool goes \
        wrong by the correction"
        help "put the correction into the tool data of the target, and leave D out";
    edge_has_lengths_of_its_own()
        "the edge E has lengths of its own, and the output has no word for it: the target takes those of \
        the first edge, and goes wrong by the difference"
        help "give the edge a tool number of its own";
}

M9050 Error "mtc-spindle-nose-refused" "move of the spindle nose is refused"
"Without tool length compensation positions along the tool axis are those of the spindle nose, and `[control] spindle_nose = \"refuse\"` refuses them. Program G48 before \
the move." {
    moves_spindle_nose_here(letter, why)
        "{letter} moves the spindle nose here ({why}), and the output moves the tool tip"
        help "program G48 before the move";
}

M9002 Error "mtc-word-unknown" "word is not known"
"The word is none of the control's, or its meaning is not documented. If it is known not to move the tool, list it in `[control] machine_words`; it is then left out \
with a note, or printed as an M function. Beside axes and other words that no G function of the block takes it is refused: they may be its arguments." {
    is_not_supported_so_give_what(word, system_function) "`{word}` ({system_function}) is not supported"
        help "give what is read as a number, or as a variable in `[variables]` of partc.toml; leave out a block that \
        only writes";
    is_variable_of_another_process(word) "`{word}` is a variable of another process"
        help "give the value as a variable of this process in `[variables]` of partc.toml";
    start_angle_of_thread_has_no_word() "the start angle of a thread has no word in the output"
        help "move the start of the thread instead: a part of the lead earlier";
    angle_p_of_offset_is_not_documented() "the angle P of an offset is not documented"
        help "rotation of the zero offset is not supported: leave P out";
    is_not_supported(shown, what) "`{shown}` ({what}) is not supported";
    e_behind_number_looks_like_exponent()
        "E after a number looks like an exponent, which the control does not know"
        help "write the number in full: 1000 for 1E3; put a blank before E if the word E is meant";
    is_no_word_beside_words(shown) "`{shown}` is no word of the control that is known"
        help "the words beside {shown} may be its arguments, and no G function of this block takes them: write \
        {shown} alone in its block, or leave it out with all that belongs to it";
    is_no_word_that_is_known(shown) "`{shown}` is no word of the control that is known"
        asks "if it does not move the tool or change the path, add `[control] machine_words = [\"{shown}\"]` to \
        partc.toml";
}

M9003 Error "mtc-flow-unsupported" "jump or process command cannot be resolved"
"Events, tool errors and other processes exist only at the running machine, so where the program goes on cannot be computed. Write the way that is meant with BRA, or \
leave the command out of the copy that is compiled." {
    depends_on_running_machine(name) "{name} depends on the running machine"
        help "write the way that is meant with BRA, or leave the command out";
}

M9005 Error "mtc-machine-position" "machine position is needed"
"G53 and G74 refer to positions that only the machine knows. For G74 give the home position in machine coordinates: `[control] home = { X = 0.0, Z = 0.0 }`. \
For G53 set `[control] g53 = \"machine\"` if positions under G53 are machine coordinates of the tool carrier." {
    home_position_of_is_known(letter) "the home position of {letter} is known only to the machine"
        asks "set it in partc.toml: `[control] home = {{ {letter} = 0.0 }}`";
    arc_under_g53_has_no_counterpart() "an arc under G53 has no counterpart in the output"
        help "program G54 to G59 before the arc";
    move_under_g53_is_absolute() "a move under G53 is absolute and has no path compensation"
        help "program G90 and G40 before it";
    block_moves_while_g53_is_active() "the block moves while G53 is active"
        asks "set `[control] g53 = \"machine\"` if positions under G53 are machine coordinates";
}

M9006 Error "mtc-g52" "meaning of G52 is not known"
"Depending on the edition G52 names the present position or shifts the zero point. Set `[control] g52` to \"position\" or \"shift\"." {
    meaning_of_g52_is_not_known() "the meaning of G52 is not known"
        asks "set `[control] g52` to \"position\" or \"shift\"";
}

M9007 Error "mtc-inch-speed" "unit of the cutting speed is not known"
"Under G70 the S of G96 may count in m/min or ft/min: the manual does not say. Set `[control] inch_speed` to \"metres\" or \"feet\"." {
    unit_of_cutting_speed_under_g70() "the unit of the cutting speed under G70 is not known"
        asks "set `[control] inch_speed` to \"metres\" or \"feet\"";
}

M9008 Error "mtc-inch-auxiliary" "unit of an auxiliary axis is not known"
"U, V and W may be linear or rotary axes. While inches are programmed their values mean inches or degrees, and which of them depends on the machine. Program \
them under G71 on a machine with metric base unit." {
    unit_of_feed_of_these_axes() "the unit of the feed of these axes is not known" help "program the feed under G71";
    may_mean_inches_or_degrees_here(axis) "{axis} may mean inches or degrees here"
        help "program auxiliary axes under G71";
}

}
