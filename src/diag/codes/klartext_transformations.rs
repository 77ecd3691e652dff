//! `K25` to `K28`: transformations, compensation, functions of the machine.

super::codes! { KLARTEXT_TRANSFORMATIONS:

K2501 Warning "shift-while-turned" "datum shift while mirrored, rotated or scaled"
"Manuals do not say whether a datum shift programmed under an active mirror, rotation or scaling is measured along the original axes. \
partc measures it along the original axes; `[control] shift_axes = \"transformed\"` along the transformed ones. \
Reset the other transformations first to be sure." {
    datum_shift_is_measured_along_original_axes()
        "the datum shift is measured along the original axes, although they are turned, mirrored or scaled"
        asks "reset the other transformations first, or set `[control] shift_axes`";
}

K2502 Warning "transformation-open" "program ends with a transformation in force"
"A datum shift, mirror, rotation or scaling is still active at the end of the program. Some controls keep it for the next program." {
    program_ends_with_transformation_in_force() "the program ends with a transformation in force"
        help "reset datum shift, mirror, rotation and scaling before the end";
}

K2504 Note "preset-to-offset" "preset number is printed as a work offset"
"Cycle 247 activates a row of the preset table. The output selects the work offset of the same order: 1 is G54, 9 is G59.3. \
Set the offsets of the target machine accordingly, or name others under `[datums]`: `preset.12 = \"G55\"`." {
    preset_is_printed(number, offset_word) "preset {number} is printed as {offset_word}";
}

K2506 Error "coordinate-under-transformation" "axis cannot be moved under this transformation"
"A parallel axis U, V or W moves while a scaling, mirror or rotation acts on its direction. Controls differ in whether they transform such \
an axis, so the block is refused. Reset the transformation first." {
    moves_while_is_active(axis, what) "{axis} moves while a {what} is active"
        help "reset the transformation before the block";
}

K2507 Warning "scaling-of-depth" "scaling also changes the tool axis"
"A machine parameter (MP 7410) decides whether scaling acts in the working plane only or on all three axes. partc scales all three, which is \
the parameter's basic setting. `[control] scaling = \"plane\"` leaves the tool axis alone." {
    scaling_acts_on_tool_axis() "the scaling acts on the tool axis, too"
        asks "if MP 7410 limits it to the plane, set `[control] scaling = \"plane\"`";
}

K2508 Warning "blank-form" "blank form is not usable"
"The MIN point of BLK FORM 0.1 must lie below the MAX point of BLK FORM 0.2 in every axis. The control refuses the blank, and one \
that lacks an axis; the path does not depend on it. Most often the two points are mixed up." {
    blank_is_defined_behind_first_move() "the blank is defined after the first move"
        help "put BLK FORM before the first positioning block, where the control looks for it";
    blk_form_names_no_corner_or_shape() "BLK FORM names neither 0.1 nor 0.2 nor a shape"
        help "the control refuses this blank; the path does not depend on it";
    blk_form_is_no_corner(corner) "BLK FORM {corner} is neither 0.1 nor 0.2"
        help "the control refuses this blank; the path does not depend on it";
    blk_form_does_not_name_all_axes(corner) "BLK FORM {corner} does not name X, Y and Z"
        help "the control refuses this blank; the path does not depend on it";
    max_does_not_lie_above_min() "the MAX point does not lie above the MIN point"
        help "the control refuses this blank; the path does not depend on it";
}

K2509 Error "rotary-feed" "feed of a rotary axis under M116 is not supported"
"M116 makes F a speed at the workpiece surface, which depends on the radius at which the tool stands from the rotary axis. \
Plain G-code counts degrees per minute." {
    moves_at_feed_under_m116(axis) "{axis} moves at a feed under M116"
        help "switch M116 off with M117 and program degrees per minute";
}

K2510 Warning "rotary-half-turn" "rotary axis goes half a turn under M126"
"M126 takes the shorter way, and over exactly 180 degrees both ways are as short. The manuals do not say which one the control takes; \
partc turns in the positive sense. Program M127 and the angle with its turns where the sense of rotation matters." {
    goes_half_turn(axis) "{axis} goes half a turn, where both ways are as short; it turns in the positive sense";
}

K2511 Warning "rotation-plane" "tool axis changes under a rotation"
"A rotation turns the coordinates in the working plane in which it was programmed. The manuals do not say what becomes of it when a \
TOOL CALL changes the working plane: partc leaves it where it is. Reset it before the change, and program it again after." {
    tool_axis_becomes(axis) "the tool axis becomes {axis}, and the rotation stays in its plane"
        help "reset the rotation before the change, and program it again after";
}

K2512 Note "rotary-axes-at-zero" "rotary axes are taken to stand at zero"
"PLANE with TURN or MOVE and without a tilt turns the rotary axes to zero. The program moved none of them away from zero, so nothing turns. On a \
machine whose rotary axes stand elsewhere at the start, bring them to zero first." {
    rotary_axes_are_taken_to_stand() "the rotary axes are taken to stand at zero, so nothing turns";
}

K2513 Note "datum-from-table" "datum is shifted by a row of a table"
"The shift comes from a datum table: compare the values with the table of the machine that will run the program. The row replaces the shift of all axes that it names." {
    row_of_datum_table_shifts(number, shown) "row {number} of the datum table shifts by {shown}";
}

K2602 Error "compensation-side" "change between RL and RR without R0"
"Between left and right compensation at least one straight block with R0 has to lie in the working plane, or the tool would cross the \
contour. The control refuses the block." {
    r0_between_rl_and_rr_moved_nothing()
        "RL and RR follow each other, and R0 between them moved nothing in the working plane"
        help "program a straight block with R0 between them";
    rl_and_rr_follow_without_r0() "RL and RR follow each other without R0"
        help "program a straight block with R0 between them";
}

K2604 Error "paraxial-compensation" "R+ or R- where it cannot act"
"R+ and R- lengthen or shorten a block that moves one axis by the tool radius, such as `X+50 R+ F200`. They cannot be used with \
several axes, without a way, in machine coordinates or while RL or RR is active; and no arc or polar block can start where they left the \
tool. Split the block, or program RL or RR." {
    starts_where_r_or_r_left_tool(what) "{what} starts where R+ or R- left the tool, beside its nominal position"
        help "program the axes of the plane with R0 first";
    is_there_already(axis, name) "{axis} is there already, so {name} has no direction"
        help "program a way in this block that is longer than the tool radius";
    r_r_belong_to_block_that_moves() "R+ and R- belong to a block that moves one of X, Y, Z without RL or RR"
        help "program the axes in blocks of their own";
    r_r_need_way_of_axis() "R+ and R- need the way of the axis, which machine coordinates (M91) leave open"
        help "program workpiece coordinates, or the corrected machine coordinate without R+";
}

K2605 Error "approach-radius" "radius of an approach or departure does not fit"
"The point outside lies inside the circle of APPR LCT or DEP LCT, so that no line touches it, or the arc of a negative R is not larger than the tool. \
R counts on the path of the tool centre. Start further away, or change R." {
    radius_of_is_not_larger_than_tool(name)
        "the radius of {name} is not larger than the tool, and its arc bends around the contour"
        help "make R larger than the radius of the tool";
    start_of_lies_inside_its_circle(a) "the start of {a} lies inside its circle"
        help "start further away, or make R smaller";
    start_of_is_point(a) "the start of {a} is the point from which it leads to the contour" help "start further away";
    end_of_lies_inside_its_circle(name) "the end of {name} lies inside its circle"
        help "end further away, or make R smaller";
}

K2606 Error "compensation-under-way" "block may not stand in a compensated contour"
"TOOL CALL, the end of the program, M128, and whatever changes the coordinate system come while RL or RR is active. The control stops there, or ends the \
compensation in a way that is not confirmed, and where the tool stands beside the contour would be a guess. End the compensation first." {
    while_radius_compensation(what) "{what} while radius compensation is on"
        help "end the compensation before this block, by R0 in a straight block or DEP";
}

K2607 Error "corner-function-without-element" "M97, M98 or M197 in a block without a contour element"
"These functions change what the control makes of the corner at the end of their block. A block that moves nothing in the working plane has no such corner. \
Write the function into the block that ends in the corner." {
    m_acts_on_corner_at_end(m)
        "M{m} acts on the corner at the end of its block, and this block moves nothing in the working plane"
        help "write it into the block that ends in the corner";
}

K2702 Note "tool-change-joined" "M6 changes no tool by itself"
"Either the tool change was printed at the TOOL CALL already, because `[control] tool_change = \"t\"` says so or this M6 was not known of, or no TOOL CALL \
stands before the M6, as in programs that stop with M6 for a change by hand and call the tool then: there the next TOOL CALL is the change. \
The M6 stops the spindle, which is printed." {
    stops_spindle_tool_is_in_it(by) "{by} stops the spindle; the tool that was called is in it already";
    belongs_to_change_of_tool_call(by) "{by} belongs to the tool change printed for the TOOL CALL";
    stops_spindle_and_changes_no_tool(by)
        "{by} stops the spindle and changes no tool; the next TOOL CALL of another tool prints its change";
}

K2703 Note "m-function-without-words" "M function has no counterpart in plain G-code"
"The function changes how the control smooths, filters or supervises the path, not the path the program describes. It is left out." {
    hsc_mode() "HSC-MODE and TA of cycle 32 have no word in the output";
    m_no_word_in_output(m, what) "M{m} {what} no word in the output";
    m_has_no_word_in_output(m) "M{m} has no word in the output";
    has_no_word_in_output(block) "{block} has no word in the output";
}

K2704 Note "retract-to-limit" "M140 MB MAX is printed as a move to a machine coordinate"
"The control retracts to the end of the travel in the tool axis. The output moves to the machine coordinate in `[control] retract_max`." {
    goes_to_machine_coordinate(what, axis, top) "{what} goes to machine coordinate {axis}{top}";
}

K2705 Error "retract-limit-unknown" "M140 MB MAX needs the end of the travel"
"How far the tool axis can go is known to the machine only. Give the machine coordinate in partc.toml: `[control] retract_max = -1.0`." {
    retracts_to_end(what) "{what} retracts to the end of the travel, which only the machine knows"
        asks "set the machine coordinate in partc.toml: `[control] retract_max = -1.0`";
}

K2707 Error "m-function-form" "M function lacks or has wrong words"
"The function needs a value after it, or has one that it does not take: `M140 MB 50`, `M103 F20`, `M120 LA 5`. Without it what \
the function would do is not known." {
    m197_prolongs_elements(by) "M197 prolongs the elements by {by}" help "write a length that is not below zero";
    m197_lacks_its_length() "M197 lacks its length" help "write `M197 DL0.5`";
    m120_looks_ahead_blocks(blocks) "M120 looks ahead {blocks} blocks"
        help "write a whole number up to 99: `M120 LA5`";
    m103_f_is_no_share_of_feed(share) "M103 F{share} is no share of the feed in %";
    path_of_m140_is_not_above_zero() "the path of M140 is not above zero"
        help "write how far to retract: `M140 MB 50`";
    behind_m_may_belong(text, number) "`{text}` after M{number} may belong to it, or be where the block goes"
        help "write the coordinates before M{number}, or M{number} into a block of its own without L";
    m_lacks_its_path(number) "M{number} lacks its path" help "write `M140 MB 50` or `M140 MB MAX`";
    of_m_lacks_its_value(name, number) "`{name}` of M{number} lacks its value";
    does_not_belong_to_m(name, number, wanted) "`{name}` does not belong to M{number}"
        help "write `M{number} {wanted}`";
}

K2708 Note "stop-ends-spindle" "M0 stops spindle and coolant as the control does"
"On the control M0 also stops the spindle and the coolant; a plain M0 does not on every target. M5 and M9 are printed before it." {
    m0_also_stops(what) "M0 also stops {what}";
}

K2709 Warning "plunge-feed-open" "what M103 does to this feed is open"
"M103 limits the feed by the share of the way that leads down, and where this move starts was not programmed. partc takes the lowest \
feed that M103 can mean, as if the whole way led down. Program M103 after the first positioning. A drilling cycle called under \
M103 keeps the feeds of its own parameters." {
    start_of_this_move_is_not_known(share)
        "the start of this move is not known, so M103 limits it to {share} % of its feed"
        help "program M103 after the first positioning";
    m103_does_not_change_feeds() "M103 does not change the feeds of this cycle"
        help "program M103 without F before the cycle, or the feed of the cycle as it is meant";
}

K2710 Warning "basic-rotation-not-ended" "M143 does not end a basic rotation of the target"
"M143 ends the basic rotation. One of TCH PROBE 404 is computed, and ends with M143; one that was set up at the machine, in the row of the preset table, is part of the work offset \
of the target, and the output has no word that ends it. If the offset of the target has a rotation, blocks after M143 would be turned, which they are not on the control; \
blocks before it would be turned on both. Set up the target without a rotation where M143 stands before the first move; otherwise split the program there." {
    basic_rotation_of_preset() "the basic rotation of the preset, if it has one, is not ended in the output"
        help "set the work offset of the target without a rotation";
}

K2850 Warning "open-subprogram" "END PGM inside a called label ends the program"
"A label is called whose section runs to END PGM without LBL 0. The manuals do not say whether the control takes this for the end of the \
program; `[control] open_subprogram = \"end\"` says that it does. Nothing after the call runs then." {
    program_ends_inside_this_label()
        "the program ends inside this label, whose call ends it: nothing after the call runs"
        help "write M30, or LBL 0 after the last block of the subprogram";
}

K2851 Warning firm "probing-left-out" "touch probe cycle is left out"
"`[control] probing = \"leave-out\"` leaves touch probe cycles out. What they would have measured is unknown from there on: the \
results in Q115 to Q199 and in the parameters they name, the positions of all axes, and the data of tools that were measured. A block \
that needs one of these is refused, and so is a cut that does not name all axes. The target stays where it stood before the cycle, so a \
rapid move runs at that height until the program names the tool axis. The datum and the rotation that the cycle sets have to be set up \
on the target machine." {
    is_left_out(name, probe, what) "{name} {probe} is left out: {what} that it would set are not known from here on"
        help "set up on the target machine what this cycle measures, before the program runs; look at the next rapid \
        move: the target stands where it stood before the cycle";
}

K2852 Error "shift-under-turned-plane" "datum shift and turned working plane are mixed"
"A datum shift before PLANE or cycle 19 is measured along the axes of the part, one after it along the turned ones. What becomes of the \
one where the other is programmed anew, or where the plane turns back first, no manual page says. Reset the shift before the plane turns, and \
the plane after the shift that belongs to it. A mirror of X or Y and an uneven scaling by cycle 26 have to be programmed after the turn, too, and reset before the next one." {
    datum_is_set_while_working_plane() "the datum is set while the working plane is turned";
    datum_was_shifted_before_working_plane()
        "the datum was shifted before the working plane was turned, and is shifted again now";
    working_plane_turns_while_mirror_or_uneven()
        "the working plane turns while a mirror or an uneven scaling of one of its axes is in force";
    working_plane_turns_while_datum_shift_along()
        "the working plane turns while a datum shift along the turned axes is in force";
    only_shift_may_stand_before_plane()
        "the working plane tilts while more than a shift of X, Y and Z is in force, and the order of both is open";
    plane_ends_before_what_was_set_in_it()
        "the tilted plane ends or changes while a mirror, rotation or scaling that was set in it is in force"
        help "reset it before this block";
    datum_is_shifted_in_plane_and_before()
        "the datum is shifted in the tilted plane, and a shift from before the plane is in force: whether this one replaces it is open"
        help "shift the datum before the plane only, or reset that shift and program the whole one in the plane";
    shift_and_plane_are_not_both_reset()
        "a datum shift and the tilted plane are not both reset: where this block leads is open"
        help "reset the shift directly before or after PLANE RESET";
}

K2853 Note "plane-turned" "turn about the tool axis is printed in the coordinates"
"PLANE, cycle 19 or the basic rotation of TCH PROBE 404 turns the system about the tool axis only, so nothing is tilted. The control may turn the rotary table instead of the \
coordinates; on the part it is the same. The output has turned coordinates, and the table of the target stays where it is." {
    turns_coordinates_by_about_z(name, angle, ways) "{name} turns the coordinates by {angle}° about Z{ways}"
        help "the rotary table of the target stays where it is: clamp the part as it lies at table angle zero";
    tch_probe_404_turns_coordinates_by_about(angle) "TCH PROBE 404 turns the coordinates by {angle}° about Z"
        help "the coordinates are printed turned: no rotation may be set on the target besides";
}

K2854 Warning firm "probing-sets-datum" "datum that a touch probe cycle sets is not set in the output"
"On the control the coordinates after this cycle count from a datum, or along axes, that it has just set; the output leaves the cycle out and prints the blocks before it and \
after it into one work offset. Where the offset of the target is set, before the program runs, as the cycle sets it, and nothing but the probe moved before it, that is right: say so by \
`[control] probing_datum = \"set\"`. `\"refuse\"` compiles no such program. Nothing is said where the parameters of the cycle show that the feature reads what it read before, nor where the datum \
goes into a row of the preset table that a later cycle 247 selects." {
    blocks_in_front(message) "{message}; blocks before it and after it are printed into one work offset"
        asks "if the work offset of the target is set as this cycle sets it before the program runs, set `[control] \
        probing_datum = \"set\"`; `\"refuse\"` compiles no such program";
}

K2855 Error "system-data-unit" "unit of a length that the control gives is open"
"FN 18: SYSREAD reads a length in a program in INCH. A TNC7 gives millimetres, whatever the unit of the program; of older controls no manual page says whether they give millimetres or inches. \
`[control] system_unit = \"mm\"` or `\"program\"` says it; `klartext = \"tnc7\"` needs neither." {
    is_length_in_inch_program_controls_may(r)
        "{r} is a length, and in an INCH program controls may give it in inches or in mm"
        asks "say which by `[control] system_unit = \"program\"` or `\"mm\"`; a TNC7 gives mm (`klartext = \
        \"tnc7\"`)";
}

K2857 Error "plane-not-reached" "rotary axes do not stand in the tilted plane"
"A tilted plane is defined by PLANE or cycle 19, and reached by TURN or by the block of rotary axes that follows STAY: `L A+Q120 C+Q122 R0 FMAX`. Before it, and \
after the plane has ended while the axes stay, coordinates count in a system in which the tool does not stand. Which angles the axes take is left to the \
machine, so numbers for them cannot be held against the plane." {
    axes_do_not_stand_in_plane()
        "this block moves in a tilted plane in which the rotary axes are not known to stand"
        help "let the plane turn them (TURN FMAX), or write `L A+Q120 C+Q122 R0 FMAX` with the axes of the machine before it";
    which_axes_turned_is_not_known()
        "after the tilted plane, a block of rotary axes has to take those to 0 that the program named in the plane"
        help "write `PLANE RESET TURN FMAX`";
    plane_about_z_needs_turn()
        "the plane is turned about Z alone while the rotary axes stay: where they stand then is not known"
        help "write TURN, or end the plane by PLANE RESET before it";
    plane_tilts_under_m128() "the working plane tilts while M128 is on" help "end it by M129 before the plane";
    what_stands_in_tilted_plane(what) "{what} stands in a tilted working plane" help "end the plane by PLANE RESET before it";
}

K2856 Error "work-before-datum" "moves before a datum count from another one"
"`[control] probing_datum = \"set\"` says that the work offset of the target is the datum that a touch probe cycle sets. Other tools than the probe moved before this cycle, in coordinates \
of the datum before: one work offset cannot be both. Split the program there, or select a preset of its own by cycle 247." {
    moved_in_front_of_it_with_another(message, worked)
        "{message}, and {worked} moved before it with another tool"
        help "one work offset cannot be both datums: split the program before the cycle, or select another \
        preset by cycle 247";
}
}
