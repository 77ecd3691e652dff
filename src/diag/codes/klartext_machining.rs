//! Klartext: milling cycles whose path the control chooses.

super::codes! { KLARTEXT_MACHINING:

K2901 Error "cycle-tool-too-large" "tool is too large for what the cycle mills"
"The cutter with its oversizes, or with the allowance on the wall, does not fit into the pocket or slot; the control says `Tool radius too large`. Check \
the sizes of the cycle, Q368, and the radius of the tool with DR." {
    cutter_is_wider(width, room)
        "tool radius too large: the cutter is {width} mm wide, and there are {room} mm"
        help "take a smaller tool, or check the sizes, the allowances and the radius of the tool";
    allowance_leaves_no_room(allowance)
        "tool radius too large: the allowance Q368 = {allowance} mm leaves the cutter no room"
        help "take a smaller tool, or check the sizes, the allowances and the radius of the tool";
    no_room_between_paths()
        "tool radius too large: the paths lie its radius inside of the sides, and Q219 leaves no room between them"
        help "take a smaller tool, or check the sizes, the allowances and the radius of the tool";
    tool_is_not_below_half_of_slot(size, length)
        "tool radius too large: the tool of {size} mm is not below half of the length {length} mm of the slot"
        help "take a smaller tool, or check the sizes, the allowances and the radius of the tool";
    hole_is_smaller(size, tool)
        "tool radius too large: the hole has {size} mm (Q335), and the tool {tool} mm"
        help "take a smaller tool, or check the sizes, the allowances and the radius of the tool";
    core_is_smaller(tool, hole)
        "tool radius too large: the tool of {tool} mm does not fit into the core of a thread of {hole} mm (Q335)"
        help "take a smaller tool, or check the sizes, the allowances and the radius of the tool";
}

K2902 Error "plunge-angle-missing" "plunging on a helix or to and fro needs ANGLE of the tool"
"Q366 = 1 and 2 go down into the material at the angle that the column ANGLE of the tool table allows. partc does not know it, or it is 0, which \
the control refuses, too. Give `[tools.N] plunge_angle` in degrees, a tool table with the column, or plunge straight down by Q366 = 0 with a cutter that can." {
    plunging_by_q366_needs_angle(kind, called)
        "Q366 = {kind} needs the plunging angle ANGLE of tool {called}, which is not known"
        asks "give `[tools.{called}] plunge_angle = 3.0`, the column ANGLE of the tool table, or plunge straight \
        down by Q366 = 0";
    plunging_by_q366_at_angle_0(kind, called)
        "Q366 = {kind} needs the plunging angle ANGLE of tool {called}, which is 0: it cannot plunge so"
        asks "give `[tools.{called}] plunge_angle = 3.0`, the column ANGLE of the tool table, or plunge straight \
        down by Q366 = 0";
    plunging_by_q19_needs_angle(called)
        "Q19 above 0 needs the plunging angle ANGLE of tool {called}, which is not known"
        asks "give `[tools.{called}] plunge_angle = 3.0`, the column ANGLE of the tool table, or plunge straight \
        down by Q19 = 0";
    plunging_by_q19_at_angle_0(called)
        "Q19 above 0 needs the plunging angle ANGLE of tool {called}, which is 0: it cannot plunge so"
        asks "give `[tools.{called}] plunge_angle = 3.0`, the column ANGLE of the tool table, or plunge straight \
        down by Q19 = 0";
}

K2903 Error "no-room-to-plunge" "pocket is too small for its plunging"
"The room beside the cutter is so small that a helix or a stroke at the angle of the tool would need more than 10,000 turns, or has no way at all. Take \
a smaller cutter, or plunge straight down by Q366 = 0 with a cutter that can." {
    no_room_for_plunging(kind)
        "the pocket has no room for plunging by Q366 = {kind} at the angle of the tool"
        help "take a smaller tool, or plunge straight down by Q366 = 0";
}

K8102 Warning "corner-of-the-cutter" "corners get the radius of the cutter"
"The corner radius Q220 of the pocket is smaller than the cutter, which cannot make it: the corners get the radius of the cutter, as on the control. Take a \
smaller tool where the corners have to be tighter." {
    corners_get_radius_of_cutter(radius, word, corner)
        "the corners get the radius of the cutter, {radius} mm, and not {word} = {corner}"
        help "take a smaller tool where the corners have to be tighter";
}

K8103 Warning "nothing-to-finish" "cycle finishes, and no allowance is left"
"Q215 = 2 finishes the wall where Q368 leaves something, and the floor where Q369 does. Both are 0, so the cycle does nothing, as on the control. Give the allowances \
that roughing left." {
    neither_q368_nor_q369_leaves_anything()
        "Q215 = 2 finishes, and neither Q368 nor Q369 leaves anything to finish"
        help "give the allowances that roughing left: without them the cycle does nothing";
    q369_leaves_nothing() "Q215 = 2 finishes, and Q369 leaves nothing to finish"
        help "give the allowances that roughing left: without them the cycle does nothing";
    tool_is_as_wide_as_slot() "Q215 = 2 finishes the wall, and the tool is as wide as the slot"
        help "give the allowances that roughing left: without them the cycle does nothing";
}

K8104 Note "cycle-end-open" "where a cycle leaves the tool is open"
"The manuals do not say where the tool stands in the working plane after this cycle. partc takes the position as unknown: until a block names both axes, \
incremental words, cuts, cycles, and moves of one axis of the plane are refused (P2001), and only the tool axis may move, at rapid traverse or upwards. Said once for each cycle and program." {
    cycle_where_control_leaves_tool_in_working(cycle)
        "cycle {cycle}: where the control leaves the tool in the working plane is open"
        help "name both axes of the plane in the next block that moves in it";
}

K8105 Warning "pattern-without-places" "pattern has no place left"
"The point table has no line, or FADE leaves out every place, so CYCL CALL PAT runs the cycle nowhere. Check the table." {
    cycl_call_pat_runs_cycle_nowhere() "CYCL CALL PAT runs the cycle nowhere: the point table has no place left"
        help "add places to the table, or take FADE out of those that shall be machined";
}

K8106 Warning "places-twice" "places of a pattern lie on each other"
"Two places of the pattern are the same, so the cycle runs there twice: a distance or a step of 0, or more than one turn. Check the number of places, their distance and \
the angles." {
    has_places_of_which_lie_on_others(what, count, list)
        "{what} has {count} places, of which {list} lie on others: they are machined again"
        help "check the number of places, their distance, and the angles";
}

K8107 Warning "mirrored-milling-sense" "mirror turns climb into up-cut milling"
"Under a mirror of one axis the tool goes round the other way, and the spindle does not. partc mirrors the path with the part, so that climb milling (Q351 = +1) becomes up-cut \
milling. Whether the control keeps the kind of milling is not confirmed. Compare, and give the kind of milling the other sign where it does." {
    mirror_turns_climb_into_up_cut()
        "the mirror turns climb into up-cut milling, and up-cut into climb"
        help "give the kind of milling the other sign where the control keeps it under a mirror";
}

K8109 Warning "floor-behind-larger-cutter" "floor is finished by a smaller cutter than roughed it"
"Cycle 22 ran with a larger cutter before this cycle 23. Where that one did not get into a corner or a narrow part, the material stands as high as before, and \
the smaller cutter of cycle 23 takes it away down to the floor in one cut. Let a cycle 22 with the smaller tool and Q18 (the coarse tool) run in between." {
    cycle_23_with_cutter_of_radius_mm(rounded, rounded2)
        "cycle 23 with a cutter of radius {rounded} mm after cycle 22 with one of {rounded2} mm: what that one left \
        is cut down to the floor in one cut"
        help "let a cycle 22 with this tool and Q18 run in between";
}

K8110 Warning "contours-that-cross" "contours of cycle 14 cross"
"partc takes all pockets together and leaves out all islands, and cuts crossing contours at their crossings. No available manual says it in full: look at a picture (`partc plot`), \
or draw one contour around the area. Said once for a program." {
    contours_of_cycle_14_cross()
        "contours of cycle 14 cross: the pockets are taken together, and the islands left out"
        help "look at a picture of the path, or draw one contour";
}

K8111 Warning "countersink-over-the-face" "circle of a countersink lies over the face"
"Q359 of cycles 263, 264 and 267 is the distance from the middle of the thread to the middle of the cutter while it countersinks at the front. Here the cutter is led over the face beside the thread, a pitch and more from its edge, and takes the face away down to Q358. A chamfer is made from the other side of the edge: from inside a hole, from outside a stud." {
    circle_of_countersink(front_offset, radius, diameter)
        "the circle of the countersink, {front_offset} = {radius} mm from the middle, goes over the \
        face beside the thread of {diameter} mm"
        help "the offset counts from the middle of the thread to that of the cutter; check it in a picture (`partc \
        plot`)";
}

K9030 Error "milling-frame" "milling cycle under a scaling or a mirrored tool axis"
"A scaling would change the sizes of the cycle and not the cutter, and a tool axis that is mirrored or tilted would lead the tool from the far side. Shifts, rotations and \
mirrors in the plane are computed. End the transformation before the call." {
    milling_under_scaling()
        "milling under a scaling, which would change the path and not the cutter, is not supported"
        help "end the transformation before the call, or program the sizes as they shall be";
    milling_with_mirrored_tool_axis() "milling while the tool axis is mirrored or tilted is not supported"
        help "end the transformation before the call, or program the sizes as they shall be";
}

K9031 Error "milling-with-m4" "climb or up-cut milling with M4"
"Manuals define Q351 = +1 climb and -1 up-cut for M3. Whether the control goes round the other way with M4 is not confirmed, and the wrong sense pulls the tool into \
the material. Program M3, or the moves of the cycle as blocks." {
    climb_is_defined_for_m3() "climb milling is defined for M3, and the spindle turns by M4"
        help "program M3, or the moves of the cycle as blocks";
    climb_and_up_cut_are_defined_for_m3(q)
        "climb and up-cut milling ({q}) are defined for M3, and the spindle turns by M4"
        help "program M3, or the moves of the cycle as blocks";
}
}
