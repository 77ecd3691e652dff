//! `K`: HEIDENHAIN Klartext.

super::codes! { KLARTEXT:

K0003 Error "klartext-number" "number has too many digits or is out of range"
"Klartext numbers have at most nine digits before and six after the point (a Q parameter holds up to 16). \
A longer number is a damaged line or a missing blank between two words." {
    m_function_number_is_out_of_range() "M function number is out of range" help "M0 to M999";
    is_beyond_input_range_of_control(shown) "`{shown}` is beyond the input range of the control"
        help "a position, radius, angle or speed is at most 99999.9999";
    number_is_out_of_range() "number is out of range" help "at most 9 digits before and 6 after the decimal point";
}

K1002 Error "klartext-statement" "unknown statement"
"The block starts with a word that begins no Klartext block, so nothing of it is used. Check the spelling. A remark starts with `;`; \
a block of another language (DIN/ISO, another control) has to be converted." {
    begins_no_klartext_block(head, second) "`{head} {second}` begins no Klartext block";
    is_not_complete(head, second, form) "`{head} {second}` is not complete" help "the block looks like `{form}`";
    alone_is_no_klartext_block(head, form) "`{head}` alone is no Klartext block" help "the block looks like `{form}`";
    begins_no_klartext_block_2(word) "`{word}` begins no Klartext block";
}

K1003 Warning "keyword-misspelled" "keyword is misspelled but clear"
"The word is not spelled as the control writes it, for instance `CYCLE DEF` for `CYCL DEF`. \
There is only one reading, and that is compiled; a control would refuse the block." {
    cycle_is_read_as_cycl() "`CYCLE` is read as `CYCL`" help "the control writes `CYCL`";
}

K1007 Error "unit-missing" "BEGIN PGM states neither MM nor INCH"
usual "write the unit after the name: `BEGIN PGM PART MM`"
"The unit decides every length of the program: the difference is a factor of 25.4, and it cannot be guessed. The control writes it \
after the name: `BEGIN PGM PART MM`. Add it." {
    begin_pgm_states_neither_mm_nor_inch() "BEGIN PGM states neither MM nor INCH";
}

K1008 Warning "no-program-head" "file has no BEGIN PGM block"
"The file is a fragment. A control takes the unit from `BEGIN PGM … MM` or `INCH`; partc uses the one in `[control] unit` of \
partc.toml, or millimetres when that is not set. Setting it silences this warning." {
    no_begin_pgm_block() "no BEGIN PGM block: lengths are taken as millimetres"
        asks "set `[control] unit` in partc.toml, or add the block";
}

K1009 Error "program-unit-mismatch" "BEGIN PGM and END PGM state different units"
usual "correct the wrong one of the two"
"The head says one unit, the end another. The control refuses to load such a file, and which one is right cannot be guessed: the \
difference is a factor of 25.4. Correct the wrong one." {
    end_pgm_states_another_unit_than_begin() "END PGM states another unit than BEGIN PGM"
        help "correct the wrong one of the two";
}

K1010 Warning "program-name-mismatch" "BEGIN PGM and END PGM name different programs"
"A control checks that both names are the same when it loads the file. The names have no influence on the path. Most often the file \
was copied and only one end was renamed." {
    end_pgm_names(end, begin) "END PGM names `{end}`, BEGIN PGM `{begin}`";
}

K1015 Warning "speed-in-path-block" "spindle speed outside TOOL CALL"
"The control takes S in TOOL CALL only: `TOOL CALL S2500` sets a new speed without a change of tool. Some CAM posts write S into \
positioning blocks; partc sets the speed before the move of such a block, as DIN/ISO does." {
    s_stands_in_positioning_block() "S stands in a positioning block, and the control takes it in TOOL CALL only"
        help "write `TOOL CALL S2500` before this block";
}

K2003 Error "feed-auto-missing" "F AUTO without a usable feed in the TOOL CALL"
"`F AUTO` means the feed of the last TOOL CALL, and that block has none, or M136 or M137 changed what F counts since. Put F into the \
TOOL CALL, or set `[control] feed` in partc.toml \
for fragments." {
    last_tool_call_has_no_f() "the last TOOL CALL has no F, so F AUTO has no value"
        asks "put F into the TOOL CALL, or set `[control] feed` in partc.toml";
    f_of_last_tool_call_counts_per()
        "the F of the last TOOL CALL counts per revolution, and M137 makes F count per minute"
        help "program F in mm/min, or M136 first";
    f_of_last_tool_call_counts()
        "the F of the last TOOL CALL counts per minute, and M136 makes F count per revolution"
        help "program F in mm/rev, or M137 first";
    last_tool_call_has_no_f_so_fauto(q) "the last TOOL CALL has no F, so {q}=FAUTO has no value"
        help "put F into the TOOL CALL, or a number after the parameter";
}

K2004 Error "tool-axis-missing" "first TOOL CALL has no tool axis"
"The tool axis (Z, Y or X) decides the working plane: which axes a pole, an arc and an angle refer to. Write it after the tool number: `TOOL CALL 5 Z S2500`." {
    first_tool_call_has_no_tool_axis() "the first TOOL CALL has no tool axis"
        help "write it after the tool number: `TOOL CALL 5 Z S2500`";
}

K2005 Error "tool-name-unknown" "tool name has no number"
"The program calls a tool by its name, and the output needs a number. Say which one belongs to the name in partc.toml: \
`[tools.\"MILL_D10\"]` with `number = 7`, or name a tool table that holds it." {
    tool_has_no_number(tool) "tool {tool} has no number";
}

K2006 Error "tool-index" "indexed tool needs a number of its own"
"`TOOL CALL 5.2` is the second set of data of tool 5. The output has only whole numbers: give the index one in partc.toml, \
`[tools.\"5.2\"]` with `number = 52`." {
    tool_is_index(number, index, tool) "tool {number}.{index} is an index, and the output has whole numbers only"
        asks "give it a number in partc.toml: `[tools.{tool}]` with `number = …`";
}

K2009 Warning "oversize-dropped" "TOOL CALL without DL/DR ends the oversizes in force"
"The earlier TOOL CALL of this tool had oversizes. A new TOOL CALL sets them anew, and the ones it does not name are taken as zero \
(the manuals are not explicit here). Repeat DL and DR if they are to stay." {
    this_tool_call_does_not_repeat_oversizes() "this TOOL CALL does not repeat the oversizes in force, so they end"
        help "write DL, DR and DR2 again if they are to stay";
}

K2010 Error "tool-number" "tool number is not one a control knows"
usual "check the number, or the parameter it comes from"
"Tool numbers are whole, from 0 to 32767, with an optional index after a point (`5.2`). Check the number, or the parameter it comes \
from." {
    is_no_tool_number(text) "{text} is no tool number";
    tool_that_program_defines_needs_number() "a tool that the program defines needs a number";
}

K2011 Note "length-oversize" "length oversize DL is part of the printed coordinates"
"The control adds DL to the length of the tool, which lifts or lowers every cut by that amount. The output has no such word, \
so partc adds it to the coordinates of the tool axis. Blocks in machine coordinates (M91) are not changed." {
    length_oversize_dl_mm_of_tool(lift, called, axis)
        "the length oversize DL {lift} mm of tool {called} is added to {axis}";
}

K2013 Warning "feed-per-revolution-large" "feed under M136 is far too large for a feed per revolution"
"M136 acts at the start of its block and makes every F that follows count millimetres per revolution of the spindle, the F of its own block \
included. A number like 200 was most likely meant per minute. Write the feed per revolution, or M137 first." {
    under_m136_this_feed_is_mm_per(feed) "under M136 this feed is {feed} mm per revolution"
        help "write the feed in mm/rev, or M137 before a feed in mm/min";
}

K2014 Note "corner-radius-oversize" "oversize of the corner radius changes no path"
"DR2 in a TOOL CALL enlarges the corner radius of the tool for 3-D compensation with surface normals, which partc does not compile. Paths in three axes, and the radius compensation \
RL and RR, do not count the corner radius: the output is the same with and without DR2." {
    dr2_mm_changes_no_path(delta)
        "DR2 {delta:+} mm changes no path: in three axes the corner radius of the tool does not count"
        help "give the oversize of the radius by DR and that of the length by DL";
}

K2101 Error "pole-missing" "no circle centre or pole in force"
"C, CP, LP and CTP refer to the last CC block, and there is none before this block that is still valid. Program `CC X… Y…` first." {
    needs_circle_centre_or_pole(function) "{function} needs a circle centre or pole"
        help "program `CC X… Y…` before this block";
    polar_words_of_need_pole_of_free(head) "the polar words of {head} need the pole of free contours"
        help "program `FPOL X… Y…` before this block";
}

K2102 Warning "pole-incomplete" "CC block with one coordinate"
"Manuals do not say what the missing coordinate of a CC block is. partc takes the last programmed position; \
`[control] cc_missing = \"previous\"` takes the one of the CC before. Write both to be sure." {
    cc_with_one_coordinate(value) "CC with one coordinate: the other one is taken from {value}"
        help "write both coordinates";
}

K2103 Warning "turn-missing" "arc without DR turns as the last one did"
"DR is missing, so the last DR programmed holds, as on the control. It may stand far above, or in a subprogram; CT and CTP do not \
change it. Write \
DR+ (counter-clockwise) or DR- to be sure." {
    without_dr_turns_as_last_dr_said(function, turn) "{function} without DR turns as the last DR said: {turn}"
        help "write DR+ or DR-";
}

K2104 Error "turn-unknown" "arc without DR, and no arc before it"
"The direction of rotation is missing and no earlier arc gives one. The control stops here. Write DR+ (counter-clockwise) or DR- \
(clockwise)." {
    without_dr_no_arc_before(function) "{function} without DR, and no arc before it"
        help "write DR+ for counter-clockwise or DR- for clockwise";
}

K2105 Error "polar-arc-sign" "signs of IPA and DR contradict each other"
"In a CP block the sign of the incremental angle must agree with DR. Older and newer controls differ in what they do otherwise, \
so the block is refused. With `[control] cp_sign = \"dr\"` DR wins and the angle is reduced to one turn." {
    ipa_turns_one_way(angle) "IPA {angle} turns one way and DR the other"
        asks "give IPA the sign of DR, or set `[control] cp_sign = \"dr\"`";
}

K2106 Warning "polar-angle-range" "absolute angle beyond 360 degrees"
"PA of a CP block names a direction, so partc reduces it to one turn; the manuals do not say whether an older control would add \
turns. A helix of several turns is programmed with IPA." {
    pa_is_reduced_to_direction(angle) "PA {angle} is reduced to a direction"
        help "program more than one turn with IPA";
}

K2107 Warning "polar-inherited" "missing polar word is taken from the position"
"PR or PA is missing and the block before was not a polar block about the same pole, or its PR was not above zero. partc computes the missing one from the position; \
a control might keep the last programmed one. `[control] polar_missing = \"programmed\"` selects that. Write both words to be sure." {
    open_word_is_computed_from_position()
        "PR was not above zero in the block before; the word left open is computed from the position"
        help "write both PR and PA";
    missing_word_is_computed_from_position() "the missing polar word is computed from the position" help "write both PR and PA";
}

K2108 Warning "pole-moved" "pole was set before the coordinate system changed"
"Between CC and its use a datum shift, rotation, mirror or scaling changed. partc keeps the numbers of the pole in the new system; \
the manuals do not say. Program CC again to be sure." {
    coordinate_system_changed_since_cc_was_programmed() "the coordinate system changed since CC was programmed"
        help "program CC again after the change";
}

K2109 Error "arc-without-end" "arc names no end"
usual "write the end point of the arc"
"The block has neither an end point nor an angle, so the arc is undetermined. Write the end point in the working plane (C, CR, CT), \
PR or PA (LP, CTP), or PA or IPA (CP). A full circle is `C` with the start point as its end." {
    ct_names_no_end_point_in_working() "CT names no end point in the working plane";
    cr_names_no_end_point_in_working() "CR names no end point in the working plane";
    ipa_is_zero() "IPA is zero: the arc has no length"
        help "write the angle to go; a full circle is IPA+360 or IPA-360";
    cp_needs_pa_or_ipa() "CP needs PA or IPA"
        help "write the angle of the end point, or the angle to go: `CP IPA+90 DR+`";
    has_neither_pr_nor_pa(function) "{function} has neither PR nor PA"
        help "write the polar radius and angle of the end point";
}

K2110 Error "polar-angle-undefined" "angle is undefined on the pole"
"The tool stands on the pole, where every angle fits, and the block does not say PA, or says it as an increment. Write the angle as \
PA." {
    tool_stands_on_pole() "the tool stands on the pole, so the angle is not determined" help "write the angle PA";
}

K2203 Error "label-zero-missing" "subprogram has no LBL 0"
"A subprogram called by CALL LBL runs to the next LBL 0; here the program ends first, so the control would not find its way back to \
the call. Put LBL 0 after the last block of the subprogram." {
    program_ends_before_lbl_0() "the program ends before the LBL 0 of this subprogram"
        asks "put LBL 0 after the last block of the subprogram; if the control takes END PGM for the end of the \
        program here, set `[control] open_subprogram = \"end\"`";
}

K2205 Error "repeat-count" "number of repeats is not usable"
"REP takes a whole number from 0 to 65534. What the control makes of a broken one is not documented: round the parameter with INT first, \
or say in partc.toml how your control does it: `[control] repeat_count = \"truncate\"` or `\"round\"`." {
    rep_is_no_number_of_repeats(count) "REP {count} is no number of repeats"
        asks "REP takes a whole number from 0 to 65534; round the parameter with INT, or set `[control] \
        repeat_count`";
}

K2206 Error "repeat-forward" "repeated section lies after its call"
"`CALL LBL n REP` repeats the section from LBL n up to the call. Here the label follows the call. For a subprogram leave out REP." {
    lies_behind_this_block(label) "{label} lies after this block"
        help "a repeated section lies before its call; leave out REP to call a subprogram";
}

K2207 Warning "jump-out-of-subprogram" "jump leaves a subprogram"
"A conditional jump leaves the subprogram without its LBL 0. partc keeps the return pending, and the next LBL 0 goes back to the call; \
the manuals do not say what the control does." {
    jump_to_leaves_subprogram(label) "the jump to {label} leaves the subprogram"
        help "leave a subprogram by its LBL 0";
}

K2209 Warning "called-unit-differs" "called program has another unit"
"The called program is in INCH and the caller in MM, or the other way round. partc uses the unit of each file while it runs; \
the manuals do not say. Q parameters are not converted." {
    called_program_has_another_unit() "the called program has another unit than its caller";
}

K2210 Warning "label-runs-through" "main program runs into a subprogram"
"The main program is not ended by M2 or M30 before this label, so its blocks run once without being called. \
That is allowed, but rarely meant." {
    this_lbl_0_ends_no_subprogram() "this LBL 0 ends no subprogram";
    program_runs_into_this_subprogram_without_call() "the program runs into this subprogram without a call";
}

K2212 Warning "plc-value" "values for the PLC of the machine are left out"
"FN 19 and FN 29 hand numbers to the machine's own control. The path does not depend on them, and plain G-code has no word for it. What the \
machine builder makes of them (clamping, coolant pressure) will not happen on the target: see to it there, or use an M function." {
    fn_gives_values_to_plc_of_machine(number)
        "FN {number} gives values to the PLC of the machine, and the output has no word for it"
        help "if the target machine needs them, switch by an M function that the target knows";
}

K2305 Warning "parameter-of-control" "parameter belongs to the control"
"Q100 to Q199 are set by the control, for example Q108 with the tool radius. What a program writes there may be overwritten at any \
time. Use Q0 to Q99." {
    belongs_to_control(q) "{q} belongs to the control" help "use Q0 to Q99 or Q1600 to Q1999";
}

K2306 Warning "formula-precedence" "formula that controls may read differently"
"`-a^b` and `a^b^c` are computed as the TNC7 manual defines: the sign first, chained powers from right to left. \
For older controls no rule is printed. Write brackets." {
    older_controls_may_compute_this_power_differently() "older controls may compute this power differently"
        help "write brackets";
}

K2310 Error "modulo-sign" "remainder of a negative number is not documented"
"The manuals show `400 % 360 = 40` and say nothing of negative operands: -400 % 360 may be -40 or 320. Make the operands positive, or say \
in partc.toml how your control computes: `[control] modulo = \"truncate\"` keeps the sign of the left operand (-40), `\"floor\"` that of the right one (320)." {
    sign_of_result_is_not_documented(a, b) "{a} % {b}: the sign of the result is not documented"
        asks "make the operands positive first, or set `[control] modulo` to \"truncate\" or \"floor\"";
}

K2401 Error "cycle-not-defined" "cycle call without a cycle"
usual "put CYCL DEF of the machining cycle before it"
"CYCL CALL, M99, M89 and the pattern cycles 220 and 221 run the machining cycle defined last, and there is none. Put CYCL DEF in \
front, or remove the call: the control stops here." {
    calls_cycle(by) "{by} calls a cycle, and none is defined"
        help "put CYCL DEF before the call, or remove the call";
    runs_machining_cycle(by) "{by} runs a machining cycle, and none is defined";
}

K2402 Error "cycle-incomplete" "cycle definition lacks a part"
usual "program all parts of the cycle, one after the other"
"A dotted cycle needs all its sub-blocks, in order and directly one after the other; a cycle with Q parameters needs their values." {
    cycle_14_names_contours(contours, most_contours) "cycle 14 names {contours} contours"
        help "write 1 to {most_contours} labels: `CYCL DEF 14.1 CONTOUR LABEL 1 /2`";
    cycle_lacks_its_value(open) "cycle {open} lacks its value";
    cycle_12_names_no_program() "cycle 12 names no program";
    cycle_lacks_its_part_1(open) "cycle {open} lacks its part {open}.1";
    part_does_not_follow_its_cycle(number, part) "part {number}.{part} does not follow its cycle"
        help "the definition begins with `CYCL DEF {number}.0`";
    is_no_row_of_datum_table(number) "{number} is no row of a datum table" help "rows count from 0 to 2999";
    cycle_7_does_not_name_one_row() "cycle 7 does not name one row of the datum table"
        help "write the number of the row: `CYCL DEF 7.1 #5`";
    cycle_7_has_row_of_table() "cycle 7 has a row of a table and axes"
        help "write either the row, `CYCL DEF 7.1 #5`, or the axes";
    lacks_its_values(head) "{head} lacks its values";
    lacks(head, wanted) "{head} lacks {wanted}";
    trans_datum_table_names_no_row() "TRANS DATUM TABLE names no row that partc reads"
        help "write the number of the row: `TRANS DATUM TABLE TABLINE5`";
    cycle_247_lacks_preset_number_q339() "cycle 247 lacks the preset number Q339"
        help "write `Q339=1` into the definition";
    shift_of_lacks_its_value(axis) "the shift of {axis} lacks its value" help "write the shift after the letter";
    cycle_7_names_no_axis() "cycle 7 names no axis" help "write the shift: `CYCL DEF 7.1 X+60`";
    lacks_so_program_all(what, missing) "{what} lacks {missing}" help "program all parameters of the cycle";
    cycle_lacks_value_of_part(cycle, missing) "cycle {cycle} lacks the value of part {cycle}{missing}"
        help "program all parts of the cycle";
    tch_probe_404_lacks_its_angle_q307() "TCH PROBE 404 lacks its angle Q307"
        help "write the basic rotation: `Q307=+0`";
}

K2404 Warning "cycle-depth-zero" "cycle has depth 0 and does nothing"
"A drilling cycle with Q201 = 0 moves nothing, on the control as here. Most often the depth comes from a parameter that was never set as meant." {
    cycle_has_depth_0(cycle) "cycle {cycle} has depth 0" help "program the depth Q1 with a minus sign";
    cycle_has_depth_0_so_program_depth(cycle) "cycle {cycle} has depth 0"
        help "program the depth Q201 with a minus sign";
}

K2405 Error "cycle-spindle" "cycle is called while the spindle does not turn"
"The control refuses to run a cycle with the spindle at rest (\"spindle not turning\"); only rigid tapping starts it itself, and needs a speed. \
TOOL CALL stops the spindle: program M3 or M13 after it, before the call." {
    spindle_has_no_speed_at_this_cycle() "the spindle has no speed at this cycle call"
        help "program S in the TOOL CALL";
    spindle_does_not_turn_at_this_cycle() "the spindle does not turn at this cycle call"
        help "program M3 before the call";
}

K2406 Warning "cycle-clearance" "2nd set-up clearance lies below the set-up clearance"
"Q204 is smaller than Q200. partc leaves the tool at the set-up clearance after the hole and never moves it down there; whether that is high enough \
on the way to the next position is up to the program." {
    of_2nd_set_up_clearance_q204_lies_below(second, clearance)
        "the 2nd set-up clearance Q204 = {second} lies below the set-up clearance Q200 = {clearance}"
        help "the tool stays at the set-up clearance; check the way to the next position";
}

K2407 Error "cycle-compensated" "cycle is called while radius compensation is on"
"A drilling cycle moves the tool axis over the programmed position, but with RL or RR the tool stands beside it. Program a straight block with R0 first." {
    cycle_is_called_while_rl_or_rr() "a cycle is called while RL or RR is active"
        help "program a straight block with R0 before the call";
    program_of_cycle_12_ends_with_radius(name)
        "the program `{name}` of cycle 12 ends with radius compensation on, and the pattern goes on to its next \
        place"
        help "end the compensation in the program: `L R0`";
}

K2408 Note "stop-distance" "advanced stop distance changes in even steps"
"Cycle 205 lets rapid traverse end above the last depth: by Q258 after the first step, by Q259 before the last one. The manuals do not give \
the values between; partc takes even steps. The drilled hole is the same." {
    advanced_stop_distance_changes_from_q258() "the advanced stop distance changes from Q258 to Q259 in even steps";
}

K2409 Note "tapping-chuck" "tapping reverses the spindle by M3 and M4"
"Cycles 2 and 206 tap at the programmed feed, and the spindle is reversed between the way in and the way out, which takes a chuck with length compensation, as on the control. \
Cycles 17, 207 and 209 are printed as taps without one." {
    spindle_is_reversed_by_m4()
        "the spindle is reversed by M4 and M3: the tap needs a compensating chuck on the target";
}

K2410 Note "pattern-order" "order of a grid of places"
"Manuals do not say in which order the control visits the places of PAT and FRAME. partc goes line by line, to and fro; the holes are the same." {
    places_of_are_visited_line_by_line(name) "the places of {name} are visited line by line, to and fro";
}

K2411 Error "pattern-data" "pattern cannot be read"
"PATTERN DEF takes POS, ROW, PAT, FRAME, CIRC and PITCHCIRC, each with a number and its data in brackets, absolute: \
`ROW1 (X+12 Y+20 D+9 NUM4 ROT+15 Z+0)`. Where the places have a surface Z of their own, Q203 of the cycle has to be 0." {
    places_have_surface_z_of_their_own() "the places have a surface Z of their own, and Q203 of the cycle is not 0"
        help "set Q203 to 0, or leave Z out of the pattern";
    cannot_be_read_here(word)
        "`{word}` cannot be read here: POS1, ROW1, PAT1, FRAME1, CIRC1 and PITCHCIRC1 have their data in brackets after them"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    ends_too_early()
        "the data of the last pattern have no closing bracket"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    names_no_place()
        "PATTERN DEF names no place"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    has_too_many_places()
        "the pattern has more than 99999 places"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    word_stands_twice(word)
        "`{word}` stands twice in the brackets"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    needs_its_place(pattern, first, second)
        "{pattern} needs {first} and {second} as absolute values"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    has_no_such_word(pattern, word)
        "`{word}` has no place in {pattern}"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    has_step_and_end(pattern)
        "{pattern} has STEP and END, and each says where the last place lies"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    diameter_is_below_zero(pattern)
        "the diameter D of {pattern} is below zero"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    lacks_word(pattern, word)
        "{pattern} lacks {word}"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
    has_no_number_of_places(pattern)
        "{pattern} has no usable number of places"
        help "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`";
}

K2412 Note "cycle-never-called" "cycle that is not supported is defined and never called"
"The definition of a cycle that partc does not compile is no fault as long as nothing calls it: it moves nothing. The same holds for definitions that only give data to such cycles (271, 285, \
1271). Is a call missing? Otherwise remove the definition." {
    cycle(number, called, what) "cycle {number} {called} {what}" help "remove the definition, or call the cycle";
}

K2414 Warning "feed-of-before-call" "cut takes the feed of before a program that is left out"
"Between the last F and this cut stands the call of a program that `[programs]` leaves out. If that program leaves another feed on the control, the output cuts at the wrong one. \
Program F after the call, or say what it leaves: `HEADCLEAN = { ignore = true, feed = 500 }`; `feed = \"lost\"` makes every cut without an F of its own an error. It is said once for each \
program that is called." {
    this_cut_takes_feed_of_before(name, key)
        "this cut takes the feed of before `{name}`, which is left out and may leave another one"
        help "program F after the call; or say under `[programs]` what it leaves: `feed = …` beside the rest of \
        `\"{key}\" = {{ … }}`";
}

K2415 Warning "variable-unused" "value of `[variables]` is not used"
"The program reads Q108 to Q114, which follow from the program itself or from the data of the tool, and `[variables]` gives another value. What partc computes goes first: \
`[tools]` says the radius that Q108 holds, and that compensates. Take the entry out of `[variables]`, or correct the data of the tool." {
    of_variables_is_not_used(key, given, taken)
        "`{key}` = {given} of `[variables]` is not used: what the program and `[tools]` say makes it {taken}"
        help "take `{key}` out of `[variables]`, or correct the data of the tool";
}

K1850 Error "block-in-wrapped-comment" "line of a wrapped comment reads as a block"
"A comment that ends with `~` goes on in the next line, which is text for the control. Here that line reads as a block of its own, so \
the `~` may be meant as decoration, and then the block would be lost. Remove the `~`, or write the text on one line." {
    is_text_of_comment_before(shown)
        "`{shown}` is text of the comment before, whose line ends with `~`, and reads as a block"
        help "remove the `~` if this is a block; if it is text, write it on the line of the comment";
}

K8020 Warning "cycle-19-reading" "cycle 19 is read as space angles"
"The machine's configuration decides whether the angles of cycle 19 are space angles or positions of the rotary axes. As a space angle C turns the \
coordinates about Z; as the position of a table it says nothing about them. Set `[control] cycle_19 = \"axes\"` where it is the latter." {
    c_of_cycle_19_is_read(turn) "C{turn:+} of cycle 19 is read as a space angle: the coordinates turn about Z"
        asks "if it is the angle of the rotary axis on this machine, set `[control] cycle_19 = \"axes\"`";
}

K8021 Warning "system-data-reading" "system data is read as older programs use it"
"FN 18: SYSREAD asks for data whose number is taken from programs for the iTNC 530, not from a manual page: tool axis and spindle speed (ID 20 NR 3 \
and 4), length and radius of the active tool (ID 200). Check the value against the manual of the control." {
    id_nr_is_answered_as_older_programs(id, nr) "ID {id} NR {nr} is answered as older programs use it"
        help "check the value against the manual of the control, or assign it with FN 0";
}

K2951 Error "contour-label" "a subprogram describes no contour for its cycle"
"Cycle 14 names subprograms whose blocks describe a contour. The first block names both axes of the working plane, and RL or RR: with the tool inside it is a \
pocket. After it stand path functions, FK, RND, CHF, parameters from Q21 on, jumps and labels; no tool axis, no transformation, no M function, no other side, \
no cycle. A pocket is closed, and no contour crosses itself." {
    contour(label, what) "the contour {label}: {what}";
    stands_in_contour(word_text, contour_name) "`{word_text}` stands in the contour {contour_name}"
        help "move it before the cycle call: in which pass the control would carry it out is not known";
    rl_rr_or_r0_stands_in_contour(contour_name)
        "RL, RR or R0 stands in the contour {contour_name}, after its first block"
        help "write RL or RR into the first block only";
    contour_sets(contour_name, target)
        "the contour {contour_name} sets {target}, which cycles 20 to 25 keep their data in"
        help "take another parameter, or a local one: QL1";
    this_block_stands_in_contour(contour_name)
        "this block stands in the contour {contour_name}, which is a shape for a cycle"
        help "a contour is made of path functions, FK, RND, CHF, parameters and labels; move the block before \
        the cycle call";
    contour_crosses_itself(label) "the contour {label} crosses itself";
}

K2952 Error "contour-missing" "the cycle lacks its contour or its data"
"Cycles 21 to 25 mill the contours that cycle 14 names, and cycles 21 to 24 take depth, allowances, heights and overlap of cycle 20. Program both before the call." {
    no_contour_is_named() "no contour is named before it"
        help "write CYCL DEF 14.0 and 14.1 CONTOUR LABEL 1";
    there_is_no_contour_data() "there is no contour data before it"
        help "write CYCL DEF 20 with Q1 to Q9";
}

K2954 Warning "further-contours" "cycle 25 mills the first contour only"
"Cycle 25 takes the first label of cycle 14; the contours of the other labels are not milled by it." {
    cycle_25_mills_first_contour_of_cycle() "cycle 25 mills the first contour of cycle 14, and not the others"
        help "name the contour alone, and call the cycle once for each contour";
}

K2955 Error "contours-together" "the contours of cycle 14 make no certain area together"
"Cycles 21 to 24 clear all pockets that cycle 14 names, less its islands. Contours lie apart, or an island in a pocket, or they cross: then each pocket begins outside \
the pockets named after it and outside the islands, and each island inside a pocket. Contours that touch, run along each other or lie in one of their \
own kind are refused, and so is what two pockets have in common." {
    cycle(cycle, what) "cycle {cycle}: {what}";
}
}
