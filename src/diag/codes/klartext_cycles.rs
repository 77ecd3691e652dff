//! Klartext: machining cycles.

super::codes! { KLARTEXT_CYCLES:

K2941 Error "tip-angle-missing" "angle at the tip of the drill is not known"
"A depth that counts from a diameter (cycle 240 with Q343 or Q342), or from the full diameter of the drill (Q395), follows from the angle at \
its tip. Give `tip_angle` in `[tools.N]`, or the column T-ANGLE of the tool table; 180 degrees have no tip." {
    depth_of_full_diameter(called)
        "a depth of the full diameter (Q395 = 1) needs the angle at the tip of tool {called} (T-ANGLE)"
        asks "give `[tools.{called}] tip_angle`, or T-ANGLE in the tool table: 118 for a common drill";
    centring_by_diameter(called)
        "centring by the diameter (Q343 = 1) needs the angle at the tip of tool {called} (T-ANGLE)"
        asks "give `[tools.{called}] tip_angle`, or T-ANGLE in the tool table: 118 for a common drill";
    hole_is_drilled_already(called)
        "a hole that is drilled already (Q342) needs the angle at the tip of tool {called} (T-ANGLE)"
        asks "give `[tools.{called}] tip_angle`, or T-ANGLE in the tool table: 118 for a common drill";
}

K2942 Error "tool-radius-too-small" "tool is too small for the cycle"
"Cycle 208 makes a hole of at most twice the diameter of the tool, unless Q342 says that it is drilled already; the control refuses a larger one. Cycle 265 \
mills a thread from the solid, and a small tool would leave a core in its middle. Cycles 210 and 211 want a third of the width of the slot at least; 213 and 215 \
go round once, which takes off the diameter of the tool. Take a larger tool, or drill first." {
    tool_is_below_third_of_width(size, width)
        "tool radius too small: the tool of {size} mm is below a third of the width Q219 = {width} mm"
        help "take a larger tool, or check the sizes of the definition";
    more_stands_than_one_circuit_takes(stock, takes)
        "tool radius too small: {stock} mm stand on the wall, and one circuit of the tool takes {takes} mm"
        help "take a larger tool, or check the sizes of the definition";
    hole_is_over_two_diameters(size, radius)
        "tool radius too small: the hole has {size} mm (Q335), more than twice the tool of {radius} mm"
        help "take a larger tool, or give the diameter that is drilled already by Q342";
    tool_leaves_core(nominal, radius)
        "tool radius too small: in a thread of {nominal} mm (Q335) a tool of {radius} mm leaves a core in the middle"
        help "take a larger tool, or drill the core and mill the thread with cycle 262";
}

K2943 Error "global-def-unreadable" "GLOBAL DEF cannot be read"
"GLOBAL DEF gives values to parameters that a later cycle takes by PREDEF. Its number says which parameters it has: 100 general, 105 drilling, 110 pockets, \
111 contours, 120 probing. Write `GLOBAL DEF 100 GENERAL` and after it `Q200=+2`, each after a `~`." {
    global_def_with_stands_in_program(q) "the GLOBAL DEF with {q} stands in a program of another unit"
        help "write the value in place of PREDEF";
    is_no_parameter_with_its_value(word) "`{word}` is no parameter with its value"
        help "write `Q200=+2`, each on a line of its own or after `~`";
    global_def_has_no_parameter_q(number, q) "GLOBAL DEF {number} has no parameter Q{q}"
        help "remove the word, or write it into the cycles themselves";
    number_of_this_global_def_is_not() "the number of this GLOBAL DEF is not known"
        help "write 100 (general), 105 (drilling), 110 (pockets), 111 (contours) or 120 (probing)";
}

K2944 Error "predef-without-value" "PREDEF finds no value"
"The cycle takes a parameter by PREDEF, and no GLOBAL DEF before it gives that parameter a value. Programs from the control often have the GLOBAL DEF in a program that \
calls this one: write it before the cycle, or the value in place of PREDEF." {
    no_global_def_gives_value(q) "no GLOBAL DEF gives {q} a value"
        help "write GLOBAL DEF before the cycle, or the value in place of PREDEF";
}

K2948 Error "datum-table-unreadable" "row of a datum table cannot be used"
"A datum table has `BEGIN NAME.D MM`, a line with the names of its columns (NR X Y Z …), a row a line and `[END]`. The row needs values for X, Y and Z (0 where the \
datum stays in place), its unit is that of the program, and a rotation or a value in a column that partc does not know is refused." {
    table_has_no_row(number) "the datum table has no row {number}" help "check the number, or add the row";
    table_has_several_rows(number) "the datum table has several rows {number}" help "number the rows";
    table_and_program_have_different_units() "the datum table and the program have different units"
        help "convert the table, and put its unit after BEGIN";
    row_has_value_under_unknown_title(number, title)
        "row {number} of the datum table has a value under {title}, which is not known"
        help "program the shift: `CYCL DEF 7.1 X+60`";
    row_has_rotation(number) "row {number} of the datum table has a rotation" help "program the shift and cycle 10";
    row_has_no_value(number, axis) "row {number} of the datum table has no value for {axis}"
        help "write 0 where the datum stays in place";
    row_shifts(number, axis) "row {number} of the datum table shifts {axis}" help "shifts of U, V and W are not computed";
    table_is_not_read(name, what) "the datum table `{name}`: {what}" help "check the file";
    line_of_table(line, name, what) "line {line} of the datum table `{name}`: {what}"
        help "a table has `BEGIN NAME.D MM`, a line with the names of its columns (NR X Y Z …), one row a line, and [END]";
    is_another_table(name, kind) "`{name}` is a {kind}"
        help "a table has `BEGIN NAME.D MM`, a line with the names of its columns (NR X Y Z …), one row a line, and [END]";
}

K2945 Error "point-table-unreadable" "point table cannot be read"
"SEL PATTERN names a point table: `BEGIN NAME.PNT MM`, a line with the names of the columns (NR X Y Z FADE CLEARANCE), one place a line, `[END]`. The values \
stand under their columns. A line with as many words as the table has columns may stand beside them; any other word that \
does not stand under one name is refused. A place with FADE Y is left out, CLEARANCE is a height at which the tool goes to the place and from it." {
    line_of_point_table(line, name, what) "line {line} of the point table `{name}`: {what}"
        help "a table has `BEGIN NAME.PNT MM`, a line with the names of its columns, and one place a line";
}

K2946 Error "tangent-behind-cycle" "tangential arc directly after a cycle"
"CT and CTP go on in the direction of the element before them. After a cycle call that would be some way of the cycle, which manuals do not print. Put a line \
or an arc of the contour between the two, or give the circle by its centre or its radius." {
    stands_directly_behind_cycle(function)
        "{function} stands directly after a cycle, whose way is no element of the contour"
        help "put a line or an arc of the contour before it, or write the arc with CC and C, or with CR";
}

K2947 Error "cycle-of-another-unit" "cycle is called in a program of another unit"
"The parameters of a cycle are numbers without a unit. A cycle that a program in MM defines, and a called program in INCH runs, or the other way round, would be made with \
lengths of the wrong size, and no manual says which unit counts. Define the cycle in the program that calls it." {
    cycle_is_called_in_program_of_another(cycle)
        "cycle {cycle} is called in a program of another unit than that of its definition"
        help "define the cycle in the program that calls it, or give both programs the same unit";
}

K8141 Note "klartext-cycle-way" "way of the tool in a cycle is partc's own"
"Manuals print what the cycle makes, and not every move of its way. partc makes a way of its own, described in docs/cycles.md, that reaches the programmed \
shape exactly and moves at rapid traverse where nothing stands. Compare it with the control where the way itself matters." {
    with_q389_1_inner_ways_end_beyond()
        "with Q389 = 1 the inner ways end beyond where manuals print them, so that nothing stays between two paths"
        help "docs/cycles.md describes it";
    spindle_drills_with_m3_at_q428() "the spindle drills with M3 at Q428, and goes in and out as Q426 and Q427 say"
        help "docs/cycles.md describes it";
    with_deepened_start() "with a deepened start (Q379) the plunging depths count from there"
        help "docs/cycles.md describes it";
    tool_goes_mm(deeper)
        "the tool goes {deeper} mm, half a pitch, below the thread: its core hole has to be that much deeper"
        help "docs/cycles.md describes it";
    beside_stud_tool_goes_half_pitch_below()
        "beside the stud the tool goes half a pitch below the thread: the shoulder has to lie that much deeper"
        help "docs/cycles.md describes it";
    countersink_is_made_straight_down_in_middle()
        "the countersink is made straight down in the middle; the circle beside the wall (Q357) is left out"
        help "docs/cycles.md describes it";
}

K8142 Warning "stroke-of-q202" "Q202 of a slot has two readings"
"Cycles 210 and 211 go to and fro along the slot and fall by Q202, and the manual does not say whether each stroke falls by it, or a stroke to and one fro \
together. partc lets each stroke fall by Q202. `[cycles] q202 = \"stroke\"` says so, `\"pair\"` halves the fall of a stroke; the finished slot is the same." {
    each_stroke_falls_by_q202() "each stroke falls by Q202; a stroke to and one fro may be meant"
        asks "say which by `[cycles] q202 = \"stroke\"` or `\"pair\"`";
}

K9040 Error "cycle-needs-a-choice" "cycle needs a choice in the configuration"
"The available manuals do not settle what the control does here, and a wrong guess would spoil the part. The message names the key in `[cycles]` of partc.toml that \
settles it; docs/cycles.md says what each value does." {
    order_of_circles_is_open(size)
        "the hole of {size} mm is milled in several circles (Q342, Q370), whose order is not documented"
        asks "`[cycles] cycle_208_rings = true` mills them from inside out, as docs/cycles.md says";
    whether_edge_or_corner_lies_at_q224()
        "no available manual says whether a corner of the polygon or the middle of an edge lies at its angle of rotation Q224"
        asks "say it by `[cycles] multi_edge_start = \"corner\"` or \"edge\"";
    what_tool_touches_is_open()
        "no available manual says what the radius of the tool touches, the nominal diameter or the core"
        asks "`[cycles] thread_267 = \"core\"` where the radius of the tool is that of its tip, `\"nominal\"` where \
        the tip reaches the core when that radius reaches the nominal diameter";
}

}
