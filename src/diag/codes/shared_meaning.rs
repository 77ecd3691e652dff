//! Facts that several languages share: positions, feeds, tools, variables, calls.

super::codes! { SHARED_MEANING:

P2001 Error "position-unknown" "position of an axis is not known here" was "K2001 M2001 mtc-position-unknown S2042 siemens-position-unknown T2002 turning-position-unknown"
"The block counts from where an axis stands, and no block before says it.\n\n\
Klartext: The block needs the position from which it starts: for an incremental word, an arc, a chamfer or a polar word. No block before \
gave this axis an absolute position in the workpiece system, or the last one was in machine coordinates (M91), from which the workpiece \
position cannot be computed. Program an absolute position of the axis first.\n\n\
MTC200: The block needs the position from which it starts: for an incremental word, an arc or a thread. No block before gave this axis \
an absolute position, or a tool change, a work offset or a move in machine coordinates made it unknown. Program an absolute position \
first. If the program relies on where the machine stands at the start, say so in partc.toml: `[start]` with `X = 0.0`.\n\n\
SINUMERIK: The block counts from a position that the program did not say yet: an increment, an arc, a pole, or a line by angle at the \
start of the program, after a tool change, a change of the work offset or a move in machine coordinates. Program the axes absolutely \
once.\n\n\
HEIDENHAIN turning: An incremental word, an angle or an arc counts from where the tool stands, and that is not known: at the start of \
the program, after a tool change, and after a move in machine coordinates. Program the axis once as an absolute value." {
    moves_axes_under_radius_compensation(name) "{name} moves axes under radius compensation, as `[programs]` says";
    block_needs_position(axis) "the block needs the position of {axis}, and where the cycle left the tool is open"
        help "name both axes of the plane in the next block that moves in it, or that cuts";
    moves_axes_under_radius_compensation_as_programs(name)
        "{name} moves axes under radius compensation, as `[programs]` says"
        help "program G40 before the call";
    needs_position_of(what, axis, why) "{what} needs the position of {axis}, which is not known{why}"
        help "program an absolute position of {axis} first";
    moves_tool_axis_together_with_plane(name, axis, why)
        "{name} moves the tool axis together with the plane, and where it starts is not known{why}"
        help "program an absolute position of {axis} first";
    it_is_not_known_where_tool_stands(axis, why) "it is not known where the tool stands in {axis}{why}"
        help "program {axis} once as an absolute value after the tool change";
    position_is_not_known(axis, why) "the position of {axis} is not known{why}"
        help "program an absolute position of {axis} first";
    where_axis_stands_is_not_known(axis, why) "where {axis} stands is not known{why}"
        help "program the axis once in absolute coordinates before this block";
    where_axis_stands_is_not_known_2(axis, why) "where {axis} stands is not known{why}"
        help "program the axis once in absolute coordinates before reading its position";
    this_block_moves_without(letters, stand, why)
        "this block moves without {letters}, and where {letters} {stand} is not known{why}"
        help "program {letters} in absolute coordinates before this block, or in it";
    + start_says_it_of_tool_before(axis)
        ": `[start]` says {axis} of the tool before the first tool call, and the tip of another one stands elsewhere";
    + or_say_where_it_stands_after_change(axis)
        "; or say in partc.toml which {axis} the control shows for the new tool when the change is over: `[machine] \
        after_tool_change = {{ {axis} = … }}`";
    + or_say_where_it_stands_at_start(axis)
        ", or say in partc.toml where {axis} stands before the program: `[start]` with `{axis} = …`";
    + or_say_where_datum_lies(name)
        "; or say where the datum lies, in machine coordinates: `[datums] {name} = {{ X = …, Y = …, Z = … }}`";
    + or_give_length_of_tool(axis, number)
        "; or give the length of the tool, which {axis} of the machine counts without: `[tools.{number}] length = …`";
}

P2002 Error "feed-missing" "cutting move without a feed" was "K2002 M2002 mtc-feed-missing S2040 siemens-feed-missing T2003 turning-feed-missing"
"A cutting move needs a feed. Program F, or set `[control] feed` for fragments that get their feed elsewhere.\n\n\
Klartext: No F word stands before this move, neither in a path block nor in a TOOL CALL. The control stops with \"feed rate is \
missing\". Program F, or set `[control] feed` for fragments that get their feed elsewhere.\n\n\
MTC200: No F word stands before this move, or G94 and G95 changed since the last one. Program F, or set `[control] feed` for fragments \
that get their feed elsewhere.\n\n\
SINUMERIK: A move with G1, G2, G3 needs a feed: alarm 10860. The feed also has to be programmed again when its kind changes (G94, G95, \
G96).\n\n\
HEIDENHAIN turning: A cutting move needs a feed, and F needs G94 (mm per minute) or G95 (mm per revolution) to have a meaning; what \
holds when the control is switched on is not in the program. Program `G95 F0.25` or `G94 F200` first." {
    leaves_feed_that_is_not_known(name)
        "{name} leaves a feed that is not known, as `[programs]` says, and this cut has none of its own"
        help "program F after {name}, or say the feed that it leaves in place of \"lost\"";
    no_feed_rate_is_programmed_before() "no feed rate is programmed before this cutting move";
    no_feed_is_programmed_for_this_move() "no feed is programmed for this move" help "program F in this block";
    kind_of_feed_has_changed_since_frcm()
        "the kind of feed has changed since FRCM=, whose value counts in the other one" alarm 10860
        help "program FRCM= again after G94, G95 and G96, or FRCM=0";
    under_g93_block_has_no_f() "under G93 the block has no F" alarm 10860
        help "program F in every block that cuts: it is 1 divided by the minutes of the block";
    no_feed_is_programmed() "no feed is programmed" alarm 10860;
    feed_of_as_positioning_axis_is_machine(axis) "the feed of {axis} as a positioning axis is a machine datum" alarm 10860
        help "give it: FA[X]=500";
    no_feed_is_programmed_so_program_f() "no feed is programmed" alarm 10860 help "program F in this block";
    has_no_feed(word) "{word} has no feed: the block before is at rapid traverse" alarm 10860
        help "program F in this block";
    cycle_has_no_feed() "the cycle has no feed" alarm 10860 help "program F before the cycle";
    no_feed_is_programmed_before_this_cutting() "no feed is programmed before this cutting move"
        help "program `G95 F…` or `G94 F…` before it";
    neither_g94_nor_g95_says_what_f() "neither G94 nor G95 says what F counts"
        help "program `G95 F…` for mm per revolution or `G94 F…` for mm per minute";
}

P2003 Error "feed-zero" "feed is not above zero" was "M2004 mtc-feed-zero S2041 siemens-feed-zero"
"The feed of a cutting move is above zero.\n\n\
MTC200: F0 stops the machine, or leaves the feed as it was: the manual does not say. Program the feed that is meant. If the control is \
known to keep the last feed, set `[control] zero_feed = \"previous\"`.\n\n\
SINUMERIK: A path feed of zero or less never ends: alarm 14800. Look where the value comes from." {
    feed_is_0() "the feed is 0" asks "program the feed that is meant, or set `[control] zero_feed = \"previous\"`";
    feed_frc_is_not_above_0() "the feed FRC= is not above 0" alarm 14800;
    feed_frcm_is_negative() "the feed FRCM= is negative" alarm 14800;
    feed_fb_is_not_above_0(fb) "the feed FB={fb} is not above 0" alarm 14800;
    feed_of_positioning_axis_is_not_above(given) "the feed {given} of a positioning axis is not above 0" alarm 14810;
    dwell_lies_between_0() "a dwell lies between 0 and 100000 seconds";
    feed_fad_is_not_above_0() "the feed FAD is not above 0" alarm 14800;
    feed_f_is_not_above_0(f) "the feed F{f} is not above 0" alarm 14800 help "program a feed above 0";
}

P2004 Error "tool-fact-missing" "data of the tool are missing" was "K2008 tool-radius-unknown S2201 siemens-nose-unknown S2221 siemens-groove-tool S2241 siemens-milling-radius T2024 turning-tool-data-missing T9005 turning-compensation-resolve"
"The path depends on the radius of the tool, or on more of its data, and neither the program nor the configuration gives them.\n\n\
Klartext: The block needs the tool radius. Put a `TOOL DEF` with R into the program, name the tool table under `[tools] table`, or add \
`[tools.5]` with `radius = 4.0` to partc.toml.\n\n\
SINUMERIK: Stock removal and undercut cycles of a lathe run the nose of the tool along the contour, so its radius and the position of \
its cutting edge have to be known: alarms 61000 and 61009. Give them in the configuration under [tools], or in the program by $TC_DP6 \
and $TC_DP2. A groove is cut with the whole edge of the tool: its cutting width, the radius of its corners and the corner that is \
programmed (the cutting-edge position) have to be known. Give `width`, `radius` and `orientation` under `[tools.N]`; radius and position \
count, too, where the program writes `$TC_DP6` and `$TC_DP2` of the active edge before the call. A milling cycle of the control \
computes the path of the cutter's centre from the radius in the tool memory. Give the radius of the tool in `[tools.N] radius`, or write \
`$TC_DP6` of the active edge before the call. Data that the program changes by `$P_AD`, and an edge that is in doubt between T and \
M6, do not count.\n\n\
HEIDENHAIN turning: Recessing cycles need the cutting width, the nose radius and the kind of the tool in the cutting position. Contour \
cycles need its nose radius and the position of its edge where the contour has a slope, an arc or walls that face each other: there the \
nose touches beside the programmed point. The program does not hold them: add them to `[tools]` in partc.toml. The path of G41 and G42 \
depends on the nose radius of the tool and on where its edge points to: the programmed point is the tip that touches both axes. Give \
`radius` and `orientation` of the tool in partc.toml, or set `[output] compensation = \"control\"` to print G41 and G42 and let the \
target compensate." {
    cycle_21(number) "cycle 21: the radius of tool {number}, which roughs (Q13), is not known"
        asks "add `[tools.{number}]` with `radius = …` to partc.toml, or a TOOL DEF block";
    table_data_of_tool_is_not_known(key) "the table data of tool {key} is not known"
        asks "add `[tools.{key}]` to partc.toml, or name the tool table under `[tools] table`";
    no_tool_is_called() "no tool is called" help "program TOOL CALL first";
    no_tool_is_called_so_it_has_no_value(q)
        "no tool is called, so {q} has no value: the radius of the tool in the spindle"
        asks "program TOOL CALL first, or give the value in partc.toml: `[variables]` with `{q} = …`";
    radius_of_tool_is_not_known(called) "the radius of tool {called} is not known"
        asks "add `[tools.{called}]` with `radius = …` to partc.toml, or a TOOL DEF block";
    tool_has_oversize_dr(called) "tool {called} has an oversize DR, and its radius is not known"
        asks "add `[tools.{called}]` with `radius = …` to partc.toml, or a TOOL DEF block";
    radius_compensation_without_tool() "radius compensation without a tool" help "program TOOL CALL before RL or RR";
    cutting_width_of_tool_d_is_not_known(args, number, edge)
        "{args}: the cutting width of tool {number} D{edge} is not known" alarm 61000
        asks "add it to partc.toml: `[tools.{number}] width = 3.0`";
    nose_radius_for_groove_is_not_known(args, number, edge)
        "{args}: the nose radius of tool {number} D{edge} is not known" alarm 61000
        asks "add it to partc.toml: `[tools.{number}] radius = 0.2`, or write `$TC_DP6[{number},{edge}]=0.2` before";
    position_for_groove_is_not_known(args, number, edge)
        "{args}: the position of the cutting edge of tool {number} D{edge} is not known" alarm 61000
        asks "add it to partc.toml: `[tools.{number}] orientation = 3`, or write `$TC_DP2[{number},{edge}]=3` before";
    position_of_cutting_edge_of_tool_d(args, number, edge)
        "{args}: the position of the cutting edge of tool {number} D{edge} is not known" alarm 61000
        asks "give it in partc.toml: `[tools.{number}] orientation = 3`, or in the program: \
        `$TC_DP2[{number},{edge}]=3`";
    nose_radius_of_tool_d_is_below(args, number, edge) "{args}: the nose radius of tool {number} D{edge} is below 0" alarm 61000
        help "check radius and wear of the edge";
    nose_radius_of_tool_d_is_not(args, number, edge) "{args}: the nose radius of tool {number} D{edge} is not known" alarm 61000
        asks "give it in partc.toml: `[tools.{number}]` with `radius = 0.8` and `orientation = 3`, or in the \
        program: `$TC_DP6[{number},{edge}]=0.8`";
    radius_of_tool(args, number, what, edge) "{args}: the radius of tool {number} {what}" alarm 61000
        asks "give it in partc.toml: `[tools.{number}] radius = 5.0`, or in the program: \
        `$TC_DP6[{number},{edge}]=5`";
    g_compensates_nose_radius_of_tool(fun, number)
        "G{fun} compensates the nose radius of the tool, which is not known"
        asks "give it in partc.toml: `[tools.{number}]` with `radius = 0.8` and `orientation = 3`";
    g_compensates_nose_radius_of_no_tool(fun)
        "G{fun} compensates the nose radius of the tool, which is not known"
        help "program T before the cycle";
    arc_needs_nose_radius_of_tool(number)
        "the nose radius of the tool is not known, and G58 makes an arc around each outer corner"
        asks "give it in partc.toml: `[tools.{number}]` with `radius = 0.8` and `orientation = 3`";
    arc_needs_nose_radius_of_no_tool()
        "the nose radius of the tool is not known, and G58 makes an arc around each outer corner"
        help "program T before the cycle";
    contour_needs_nose_radius_of_tool(number, what)
        "the nose radius of tool {number} is not known, and the contour has {what}"
        asks "give it in partc.toml: `[tools.{number}]` with `radius = 0.8` and `orientation = 3`";
    contour_needs_nose_radius_of_no_tool(what)
        "the contour has {what}, and no tool is in the cutting position whose nose could run along it"
        help "program T before the cycle";
    edge_position_of_tool_has_no_corner(position)
        "cutting-edge position {position} of the tool is not supported in this cycle: its nose cannot be \
        compensated"
        help "add `orientation = 3` (1 to 4: where the edge points to) to the tool in partc.toml, or `radius = \
        0`";
    edge_position_of_tool_is_not_known()
        "the cutting-edge position of the tool is not known, so its nose cannot be compensated"
        asks "add `orientation = 3` (1 to 4: where the edge points to) to the tool in partc.toml, or `radius = \
        0`";
    kind_width_or_nose_radius_of_recessing(number)
        "kind, width or nose radius of the recessing tool {number} is not known"
        asks "add `[tools.{number}]` with `kind = \"recess-radial\"` or `\"recess-axial\"`, `width` and `radius` to \
        partc.toml";
    no_tool_is_in_cutting_position() "no tool is in the cutting position" help "program T before the cycle";
    g_compensates_nose_radius(fun, what) "G{fun} compensates the nose radius: {what}"
        asks "add `radius` and `orientation` of the tool to partc.toml, or set `[output] compensation = \"control\"` \
        to print G41 and G42";
    thread_runs_across_face()
        "the thread runs across a face, and nothing tells whether it is the front or the rear one"
        asks "add `orientation` of the tool to partc.toml (2, 3, 7 front, 1, 4, 5 rear), or set `[control] \
        thread_face`";
    tool_stands_on_cylinder()
        "the tool stands on the cylinder, and nothing tells whether the undercut lies outside or inside"
        help "add `orientation` of the tool to partc.toml (3, 4, 8 outside, 1, 2, 6 inside), or position it clear of \
        the cylinder";
}

P2005 Error "tool-length-unknown" "length of the tool is not known" was "K2012 S9102 siemens-tool-length"
"The block needs the length of the tool.\n\n\
Klartext: The block reads the tool length (Q114 or SYSREAD), and neither the program nor the configuration gives it. Put `TOOL DEF` with \
L into the program, or the length into the tool table or `[tools.5]` of partc.toml.\n\n\
SINUMERIK: G53, G153 and SUPA place the tip of the tool on a SINUMERIK control (MD 10760 = 0), and the nose of the spindle on the \
target; SUPD does the opposite. With `tool_length = \"G43\"` the length of the tool is added, so it has to be known: give it under \
[tools] or write `$TC_DP3`. On lathes it is never known. Under D0, or with `[control] md10760 = true`, no length counts." {
    supd_moves_spindle() "SUPD moves the spindle, not the tip of the tool, to this position"
        help "write D0 in a block before it, and the coordinate of the spindle by SUPA";
    control_goes_to_this_machine_coordinate(axis)
        "the control goes to this machine coordinate of {axis} with the tip of the tool (MD 10760 = 0), the target \
        with its spindle: the length of the tool is not known";
    tool_does_not_stand_along_axis(axis)
        "the control goes to this machine coordinate of {axis} with the tip of the tool (MD 10760 = 0), the target \
        with its spindle, and the tool stands in a tilted plane"
        asks "write D0 in the block, or set `[control] md10760 = true`";
    length_of_tool_is_not_known(called) "the length of tool {called} is not known"
        asks "add `[tools.{called}]` with `length = …` to partc.toml, or a TOOL DEF block";
    no_tool_is_called_so_it_has_no_value(q)
        "no tool is called, so {q} has no value: the length of the tool in the spindle"
        asks "program TOOL CALL first, or give the value in partc.toml: `[variables]` with `{q} = …`";
}

P2006 Warning "tool-not-in-table" "tool is not in the tool table" was "K2007 S8009 siemens-tool-not-listed"
"The program calls a tool that the table does not list.\n\n\
Klartext: The configured tool table has no such tool, so nothing is known about its radius and length. A control with this table would \
stop. Check the number, or add the tool to the table. The change is printed as programmed.\n\n\
SINUMERIK: A tool table was given, and this tool is not in it. Check the number, or add the tool." {
    tool_is_not_in_tool_table(tool) "tool {tool} is not in the tool table";
}

P2007 Error "m-function-unknown" "M function of the machine builder" was "K2701 M2701 mtc-m-function S2044 siemens-m-unknown T2018 turning-m-unknown R9001 gcode-m-function"
"What the M function does only the builder of the machine knows.\n\n\
Klartext: The machine builder defines this M function, so what it does is not known, and it may move something. If the target machine \
understands the same number, list it: `[output] pass_m = [25]`; if it changes the tool as M6 does: `[control] tool_change_m = [25]`. \
Else take it out of the program.\n\n\
MTC200: The machine builder defines this M function, and its meaning on the target is not known. If the target machine understands the \
same number, list it in `[output] pass_m`; if it does not matter, list it in `[control] machine_words`.\n\n\
SINUMERIK: What this M function does, and whether it moves something, is up to the machine builder. If it may be printed as it stands, \
list it under `[output] pass_m`; if it changes the tool as M6 does, under `[control] tool_change_m`.\n\n\
HEIDENHAIN turning: M functions other than M0, M1, M3, M4, M5, M8, M9 and M30 belong to the machine builder. If the target has the same \
one, list it in `[output] pass_m`; otherwise remove it.\n\n\
Plain G-code: M0 to M9, M19 and M30 mean the same everywhere. All others are given by the builder of a machine, and some move it. If the \
target has the same function, list it under `[output] pass_m`." {
    m_means_what_builder_of_machine_wants(number) "M{number} means what the builder of a machine wants";
    m_is_function_of_machine_builder(number) "M{number} is a function of the machine builder";
    m_is_function_of_machine_so_if_target(number) "M{number} is a function of the machine builder"
        asks "if the target machine understands it, add `[output] pass_m = [{number}]`";
    what_m_does_is_up_to_machine(number) "what M{number} does is up to the machine builder";
    m_calls_programs_in_iso_dialect(m) "M{m} calls programs in ISO dialect only"
        help "a subprogram is called by its name, as in L100 or POCKET";
    what_m(n, m) "what M{n}={m} does is up to the machine builder"
        help "leave it out, or call what it does by an M function without `=`";
    m_is_no_m_function(given) "M{given} is no M function";
    m_belongs_to_machine(number) "M{number} belongs to the machine, and what it does is not known"
        asks "if the target may have it, add {number} to `[output] pass_m` in partc.toml";
}

P2008 Warning "m-function-before-move" "M function is printed before the move" was "K2706 m-function-beside-move M2704 mtc-m-order"
"The output has the M function before the move of its block.\n\n\
Klartext: Whether this M function acts at the start or the end of its block is up to the machine builder. It is printed before the move; \
put it into a block of its own to be sure.\n\n\
MTC200: The manual does not say whether this M function of the machine builder acts before or after the move of its block. It is printed \
before. Put it into a block of its own to be certain." {
    m_is_printed_before_move(m) "M{m} is printed before the move";
    m_is_printed_before_move_of_its_block(number) "M{number} is printed before the move of its block"
        help "put it into a block of its own";
}

P2010 Error "label-twice" "label is set twice" was "K2201 M2202 mtc-label-twice"
"Which of the two a jump means is not certain. Rename one.\n\n\
Klartext: A label may be set once in a program; only LBL 0 may stand any number of times. Which of the two a call means cannot be \
guessed, and the control refuses it. Give one of them another number or name.\n\n\
MTC200: Two blocks set the same label, so a jump to it has two targets, and which one the control takes is not defined. Rename one." {
    is_set_twice(label) "{label} is set twice" help "give one of them another number";
    label_is_set_twice(name) "the label .{name} is set twice" help "rename one of them";
}

P2011 Error "label-missing" "label does not exist" was "K2202 M2201 mtc-label-missing S2003 siemens-target-missing"
usual "check the number, or the spelling of the name"
"A jump, a call or a repetition names a label that is not there.\n\n\
Klartext: A call or jump names a label that the program does not set. Labels belong to their file: one of a called program cannot be \
reached from here. Check the number, or the spelling of the name.\n\n\
MTC200: The jump names a label that no block of the program sets. A label is a point and a name at the start of a block: `.LOOP`. Check \
the spelling.\n\n\
SINUMERIK: GOTOF searches to the end of the program, GOTOB to its start, GOTO first forward and then backward, and only in the program \
that jumps. The control shows alarm 14080. After a jump that leads nowhere the run stops, because it is not known where the program goes \
on." {
    lbl_0_ends_subprogram() "LBL 0 ends a subprogram and cannot be called";
    is_no_label_number(q, n) "{q} = {n} is no label number";
    is_not_set_in_this_program(label) "{label} is not set in this program";
    label_is_not_set(name) "the label .{name} is not set";
    there_is_no_label_behind_first(to) "there is no label `{to}` after the first" alarm 14082;
    there_is_no_label_in_program(symbols) "there is no label `{symbols}` in the program" alarm 14082;
    section_behind_this_block_has_no_endlabel() "the section after this block has no ENDLABEL" alarm 14080;
    last_label_of_section_stands_in_front() "the last label of the section stands before its first" alarm 14080;
    there_is_no(what, way) "there is no {what}{way}" alarm 14080;
    jump_target_is_no_text() "the jump target is no text" alarm 14080;
}

P2012 Error "recursive-call" "subprogram or program calls itself" was "K2204 T2012 turning-recursion"
usual "repeat with `CALL LBL 1 REP 2` or a conditional jump instead"
"The calls would never end.\n\n\
Klartext: HEIDENHAIN controls do not allow a subprogram or a program to be called while it runs, and the call would never end. Repeat \
with `CALL LBL n REP` or a conditional jump instead.\n\n\
HEIDENHAIN turning: A subprogram that calls itself, perhaps by way of another one, never ends. The control refuses it as well." {
    program_calls_itself(name) "program `{name}` calls itself";
    calls_itself(label) "{label} calls itself";
    calls_itself_2(name) "`{name}` calls itself";
}

P2013 Error "called-program-ends" "called program ends the job" was "K2208 M2206 mtc-end-in-subprogram T2013 turning-job-end-in-subprogram"
usual "end the called program with END PGM"
"A called program returns to its caller; the end of the whole job stands in the main program.\n\n\
Klartext: M2 or M30 in a called program ends the whole job on some controls and is an error on others. End a called program with END \
PGM.\n\n\
MTC200: RET, M02, M30 and PROGRAMMENDE end the whole program. In one called with JSR, what follows the call would never run, and whether \
the control goes back to the caller is not documented. End a called program with RTS.\n\n\
HEIDENHAIN turning: A subprogram returns with RETURN. END or M30 inside it would end the job in the middle of the main program." {
    called_program_ends_job_with_m2() "a called program ends the job with M2 or M30";
    called_program_ends_whole_job() "a called program ends the whole job" help "end a called program with RTS";
    jmp_in_subroutine_leaves_it_without_rts() "JMP in a subroutine leaves it without RTS";
    subprogram_ends_job() "a subprogram ends the job";
}

P2020 Error "variable-unset" "variable is read before it is set" was "K2301 parameter-undefined M2301 mtc-variable-unset T2008 turning-variable-unset"
usual "assign a value before this block"
"The variable has no value there, and guessing one could move the tool anywhere.\n\n\
Klartext: The parameter is read before any block sets it. On the machine it might still hold a value from another program. Set it, or \
give a start value in partc.toml: `[variables]` with `Q50 = 3.0`.\n\n\
MTC200: Variables keep their values from one program to the next, so the control may hold any value here, and a position made of it may \
be anywhere. Give it in partc.toml: `[variables]` with `\"@50\" = 12.0`, or assign it in the program.\n\n\
HEIDENHAIN turning: What the control would take for a variable without a value differs. Assign a value first, hand it over in the call, \
or give a start value in `[variables]` of partc.toml." {
    has_no_value_to_export(q) "{q} has no value to export";
    is_read_before_value_is_assigned(q) "{q} is read before a value is assigned to it"
        asks "assign a value, or give one in partc.toml: `[variables]` with `{q} = …`";
    is_read_before_text_is_assigned(q) "{q} is read before a text is assigned to it";
    was_never_set(number) "@{number:03} was never set"
        asks "give its value in partc.toml: `[variables]` with `\"@{number}\" = …`";
    is_read_before_value_so_assign_value(var, key) "{var} is read before a value is assigned to it"
        asks "assign a value, or give one in partc.toml: `[variables]` with `\"{key}\" = …`";
    call_gives_no_value(var) "the call gives no value for {var}" help "add the word to the L block of the call";
}

P2021 Warning "variable-unset-is-zero" "variable that was never set is read as 0" was "K2302 parameter-zero S2025 siemens-r-unset"
"The control reads 0.\n\n\
Klartext: TNC controls up to the TNC 426/430 start with zero in every parameter that was never set. If another program sets it on the \
machine, give the value in `[variables]` of partc.toml.\n\n\
SINUMERIK: R parameters keep their values from one program to the next, so what the parameter holds on the machine is not known here. It \
counts as 0. Set it in the program or under [variables]." {
    was_never_set(q) "{q} was never set and is read as 0";
    r_is_read_before_program_sets(n) "R{n} is read before the program sets it; it counts as 0";
    is_read_before_program_sets(word) "`{word}` is read before the program sets it; it counts as its start value";
}

P2022 Error "no-result" "computation has no result" was "K2303 parameter-arithmetic M2302 mtc-arithmetic S2006 siemens-arithmetic T2009 turning-formula"
usual "look where the parameters of the block get their values"
"The value cannot be computed.\n\n\
Klartext: Division by zero, root of a negative number, arc sine beyond 1, logarithm of zero or a result over 1e10: the control stops \
here. Look where the parameters of the block get their values, and test them before.\n\n\
MTC200: A division by zero, a root of a negative number, or a result that is too large. The control stops with an error here, so nothing \
is compiled. Check the variables.\n\n\
SINUMERIK: Division by zero, a root of a negative number, an arc sine beyond 1, a result that is too large: alarm 14051. Look at the \
values of the parameters in the block.\n\n\
HEIDENHAIN turning: The formula divides by zero, takes the root of a negative number, or asks for something the manuals leave open, such \
as the integer part of a negative number. The block is not executed." {
    no_circle_leads_through_three_points() "no circle leads through the three points";
    number_is_too_large() "the number is too large";
    offset_is_too_large() "the offset is too large";
    value_is_infinite() "the value is infinite" alarm 14051;
    formula_has_no_value(word, why) "{word}: {why}";
    axname_names_no_axis_of_this_machine(name) "AXNAME: `{name}` names no axis of this machine" alarm 14097;
    function_has_no_value(name, x) "{name} of {x}";
    root_of_difference_of_squares(a, b) "square root of {a}² - {b}²";
    value_is_divided_by_zero(a) "{a} is divided by zero";
    value_is_divided_by_zero_that(a, said) "{a} is divided by zero: {said}";
    result_is_too_large() "the result is too large";
    result_is_too_large_for_int() "the result is too large for an INT" alarm 14051;
    result_is_over_10_000_000_000() "the result is over 10 000 000 000";
    division_by_zero() "division by zero" alarm 14051 help "check what stands after `/`, DIV or MOD";
    division_by_zero_that(said) "division by zero: {said}" alarm 14051 help "give it another value before this block";
    function_of_value_does_not_exist(name, x) "{name} of {x} does not exist";
    power_does_not_exist(a, b) "{a} to the power of {b} does not exist";
    there_is_no_result(a, b) "there is no result for {a} and {b}";
    number_is_needed_not_text() "a number is needed, not a text";
    number_is_needed() "a number is needed";
    text_is_needed() "a text is needed";
    text_parameter_is_needed() "a text parameter is needed";
    is_no_position(n) "{n} is no position";
    is_no_number(text) "`{text}` is no number";
    text_is_longer(longest) "the text is longer than {longest} characters";
    function_reads_from_control() "the function reads from the control";
    function_does_not_exist(name, x) "{name}({x}) does not exist";
    formula_divides_by_zero() "the formula divides by zero";
    formula_divides_by_zero_that(said) "the formula divides by zero: {said}";
    result_of_formula_is_too_large() "the result of the formula is too large";
    + give_values_that_control_keeps() "give the values that the control keeps under [variables]";
}

P2023 Error "value-of-machine" "value is known on the machine only" was "K2304 parameter-from-machine S2028 siemens-machine-value T2010 turning-machine-variable"
"The program reads something that only the control or the machine knows while it runs.\n\n\
Klartext: The parameter holds something that the control measures or knows at run time. partc does not make up a value: give it in \
`[variables]` of partc.toml if it is always the same.\n\n\
SINUMERIK: The system variable is the state of a machine: inputs, actual values, machine data, offsets. A compiler cannot know it. Give \
a value under [variables], or take the question out of the program.\n\n\
HEIDENHAIN turning: The variable holds what the control measured or knows of the machine; a compiler cannot know it. Give its value in \
`[variables]` of partc.toml if it is the same for every part." {
    is_set_by_control_at_machine(q, what) "{q} is set by the control at the machine{what}"
        asks "give its value in partc.toml: `[variables]` with `{q} = …`";
    is_set_by_control_at_machine_and_nothing(q)
        "{q} is set by the control at the machine, and nothing in the program says to what"
        help "if the value is always the same, assign it after that block: `{q} = …`";
    frame_of_axis_that_is_left_out() "the frame of an axis that is left out is not known";
    has_no_value(key, name, line)
        "`{key}` has no value: {name} in line {line} touches nothing, as `[control] probing_contact` says"
        help "take `probing_contact` out of `[control]`: then each value is asked for";
    cannot_be_set_by_compiled_program(word) "`{word}` cannot be set by a compiled program"
        help "it changes the machine or the control; set it there";
    is_state_of_program(word) "`{word}` is the state of the program and cannot be set" alarm 17070
        help "program the words that bring the state about";
    one_component_of_is_set(word) "one component of {word} is set, the others are known on the machine only"
        asks "give {word} under [datums]";
    value_of_is_known_on_machine(key, said_meaning) "the value of `{key}` is known on the machine only{said_meaning}";
    whether_control_has_is_known_on_machine(wanted) "whether the control has `{wanted}` is known on the machine only";
    asks_for_program_has_selected_none(name, meaning)
        "{name} asks for the {meaning}, and the program has selected none";
    belongs_to_control(var) "{var} belongs to the control";
    holds_what_control_measured(var, key) "{var} holds what the control measured"
        asks "give its value in partc.toml: `[variables]` with `{key} = …`";
    is_set_by_control_so_give(var, key) "{var} is set by the control at the machine"
        asks "give its value in partc.toml: `[variables]` with `\"{key}\" = …`";
}

P2024 Error "kinds-mixed" "kinds of values are mixed up" was "K2307 parameter-kind S2005 siemens-type"
usual "TONUMB makes a number of a text, TOCHAR a text of a number"
"The operation or the variable does not take a value of this kind.\n\n\
Klartext: A string parameter (QS) stands where a number is needed, or a number where a text is needed. TONUMB turns a text into a \
number, TOCHAR a number into a text.\n\n\
SINUMERIK: The operation or the variable does not take a value of this type: texts, axes and frames are no numbers. The control shows \
alarm 12150. Texts become numbers by NUMBER(…)." {
    comparison_mixes_text() "the comparison mixes text and number, or orders texts";
    takes_text(q) "{q} takes a text, not a number";
    takes_number(q) "{q} takes a number, not a text";
    holds_text(q) "{q} holds a text, a number is needed";
    text_parameter_is_needed() "a text parameter is needed";
    does_not_become(what, type_name) "{what} does not become {type_name}";
    list_of_values_fills_array() "a list of values fills an array" alarm 12150;
    name_of_program_is_text(what) "the name of a program is a text, this is {what}" alarm 12150;
    number_is_needed(what) "a number is needed, this is {what}" alarm 12150;
    does_not_take_value_of_this_type(word) "{word} does not take a value of this type" alarm 12150;
    condition_is_needed(what) "a condition is needed, this is {what}" alarm 12150;
    text_is_needed(what) "a text is needed, this is {what}" alarm 12150;
    frame_is_needed(what) "a frame is needed, this is {what}" alarm 12150;
    fills_array(name) "{name} fills an array and is no value of its own" alarm 12150;
    modaxval_takes_axis() "MODAXVAL takes an axis and an angle" alarm 12150;
    operator_does_not_fit(what) "the operator does not fit {what}" alarm 12150;
    values_do_not_go_together(a, b) "{a} and {b} do not go together here" alarm 12150;
    value_is_missing() "a value is missing" alarm 12150;
}

P2025 Error "no-such-variable" "no variable has this number" was "K2308 parameter-number M2303 mtc-variable-number"
usual "Q0 to Q1999, QL0 to QL499, QR0 to QR499 and QS0 to QS1999 exist"
"The control refuses the number. Most often a digit is too many.\n\n\
Klartext: Q0 to Q1999, QL0 to QL499, QR0 to QR499 and QS0 to QS1999 exist. The control refuses any other number. Most often a digit is \
too many, or the blank after the number is missing.\n\n\
MTC200: Variables have three digits, `@000` to `@999`, so nothing can be read or stored here. Check the number." {
    does_not_exist(q) "{q} does not exist";
    there_is_no_variable(number) "there is no variable @{number}" help "variables are @000 to @999";
}

P2026 Error "program-stops-itself" "program stops with an error of its own" was "K2309 program-error-stop S2027 siemens-setal"
usual "look at the condition before this block"
"The program itself says that something is wrong with its data. Look at the condition before the block.\n\n\
Klartext: The block FN 14 makes the control stop with an error text. The program itself says that something is wrong with its \
parameters; look at the condition before it.\n\n\
SINUMERIK: The way through the program reaches SETAL, with which it stops for data it finds wrong. What follows would not run on the \
machine, so nothing is written. Look at the conditions before it." {
    program_stops_with_error(error) "the program stops with error {error}";
    program_raises_alarm(shown, cause) "the program raises alarm{shown}{cause}";
    setal_is_no_alarm_of_program(number) "SETAL({number}) is no alarm of a program" alarm 15700
        help "programs have the alarms 60000 to 69999";
}

P2030 Warning "mirror-tool-axis" "tool axis is mirrored" was "K2503 S8198 siemens-mirror-tool-axis"
"A frame mirrors the tool axis: depths turn into heights, a hole programmed to Z-10 goes to Z+10, and a rapid move above the part becomes \
one inside it. Check that this is meant; most often another axis is." {
    tool_axis_is_mirrored(axis) "the tool axis {axis} is mirrored" help "check that this is meant";
    tool_axis_is_mirrored_2(axis) "the tool axis {axis} is mirrored";
}

P2032 Warning "moves-before-offset" "moves before the first work offset" was "P0204 S8131 siemens-moves-before-offset"
"Before the first work offset (cycle 247, G54) positions count from the one that is active on the control, which an earlier program \
or the operator selected. In the output these moves run under the offset that is active on the target at the start, which may be another \
one. Select the work offset before the first move, or retract in machine coordinates (M91, G53).\n\n\
SINUMERIK: Before the first G54 a control counts from its basic system (G500), unless a machine datum (MD 20150) says otherwise. On \
the target these moves run under the offset that is active there at the start. Select the work offset before the first move; a \
retraction in machine coordinates is SUPA or G53." {
    moves_stand_in_front(word)
        "moves stand before {word}: they run under the offset that is active on the target at the start"
        help "select the work offset before the first move; a retraction may be programmed in machine \
        coordinates";
    moves_stand_in_front_of_they_run(word)
        "moves stand before {word}: they run under the offset that is active on the target at the start";
}

P2040 Error "compensation-in-arc" "radius compensation starts or ends in an arc" was "K2601 M2011 mtc-compensation-on-arc"
"Radius compensation begins and ends over a straight move.\n\n\
Klartext: RL, RR and R0 take effect over a straight block, at whose end the tool stands beside the contour. The control refuses to \
switch in C, CR, CT, CP and CTP. Put a straight block before or after the arc.\n\n\
MTC200: Path compensation starts and ends on a straight move. On an arc the control stops with this text when it starts, and makes \
contour errors that cannot be foretold when it ends. Program a straight block between. Source: NC Programming Instructions 17VRS, pages \
5-30, 5-32." {
    radius_compensation_cannot_start_or_end() "radius compensation cannot start or end in an arc"
        help "program a straight block with RL, RR or R0 before or after the arc";
    g41_g42_activated_with_circular_interpolation() "G41/G42 activated with circular interpolation"
        help "program a straight move between G40, G41 or G42 and the arc";
}

P2041 Warning "compensation-open" "program ends with radius compensation on" was "K2603 M2601 mtc-compensation-open S2082 siemens-compensation-open"
"Klartext: The program ends, calls a tool, a cycle or a program while RL or RR is active. The control cancels the compensation there; the \
tool may cut the contour on the way. Program a block with R0 first.\n\n\
MTC200: The end of the program switches G41 and G42 off. The last contour element is then left without its transition. Program G40 with \
a straight move before.\n\n\
SINUMERIK: Radius compensation is ended by G40 with a straight move. The output ends it before M30, but the last corner is not what was \
meant." {
    program_call_ends_radius_compensation() "a program call ends the radius compensation"
        help "program a block with R0 first";
    rotation_ends_radius_compensation() "the rotation ends the radius compensation"
        help "program a block with R0 first";
    program_ends_with_radius_compensation() "the program ends with radius compensation on"
        help "program a block with R0 before the end";
    turn_of_plane_ends_radius_compensation() "the turn of the plane ends the radius compensation"
        help "program a block with R0 first";
    tool_call_ends_radius_compensation() "TOOL CALL ends the radius compensation"
        help "program a block with R0 first";
    program_ends_with_path_compensation() "the program ends with path compensation on"
        help "program G40 with a straight move before the end";
    program_ends_with_radius_compensation_2() "the program ends with radius compensation on";
}

P2042 Error "tool-askew" "tool does not stand along its axis"
"The tilted plane was switched off, and the rotary axes stay where it put them: the tool stands askew to the workpiece, and where the coordinates of the program lead it \
depends on the machine. Retract in machine coordinates and turn the rotary axes back: by the function that tilted the plane, or by words of their own, each of them \
to 0 (which ones those are says `[machine] tilt_axes`; in Klartext the block that turned them)." {
    plane_is_off_and_rotary_axes_stay(line)
        "the tilted plane was switched off in line {line}, and the rotary axes still stand as in it"
        help "turn them back before this block: to an upright plane by the function that tilted it, or by their own words to 0, if the \
        configuration names them all";
}

P2043 Error "rotary-axis-in-plane" "rotary axis moves while the plane is tilted"
"Under a tilted plane the control has placed the rotary axes so that the tool stands along it. A word that moves one of them turns the tool out of the plane, or the part \
under it, and what the coordinates mean then depends on the machine." {
    rotary_axis_moves_in_tilted_plane(letter) "{letter} moves while the working plane is tilted"
        help "switch the plane off before it, or give the angle to the plane";
}
}
