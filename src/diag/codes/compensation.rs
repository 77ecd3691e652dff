//! `G32`: radius compensation that the compiler computes.

super::codes! { COMPENSATION:

G3201 Error "compensation-arc" "arc is smaller than the tool"
"A hollow arc of the contour has a smaller radius than the tool, so the tool cannot lie in it. Controls stop with \"tool radius too large\" or leave \
the arc out, which changes the part. Take a smaller tool, or make the radius of the arc at least that of the tool; with the same radius the corner gets sharp." {
    tool_does_not_fit_into_this_arc(tool, arc)
        "the tool of radius {tool} mm does not fit into this arc of radius {arc} mm"
        help "take a smaller tool, or make the radius of the arc at least that of the tool";
    element_of_no_length_has_no_path() "an element of no length has no path beside it"
        help "take a smaller tool, or make the radius of the arc at least that of the tool";
}

G3202 Error "compensation-room" "tool does not fit into a corner of the contour"
"The paths of the tool centre along two neighbouring elements do not cross: an element is shorter than the radius needs, such as a step or a short side \
at an inside corner. Controls stop here, unless they are told to leave elements out (HEIDENHAIN `M120 LA`, SINUMERIK `CDON`), or to prolong the \
elements at an outside corner (HEIDENHAIN `M97`). Take a smaller tool, or make the elements longer." {
    path_meets_none_of_next_elements(radius, ahead)
        "the tool of radius {radius} mm does not fit: the path meets none of the next {ahead} elements"
        help "take a smaller tool, or make the elements at this corner longer";
    tool_does_not_fit_into_corner(radius, before, own)
        "the tool of radius {radius} mm does not fit into the corner before this element: {before} mm of the path \
        before are left, the element is {own} mm long, and their paths do not cross"
        help "take a smaller tool, or make the elements at this corner longer";
    tool_damages_contour(radius)
        "the tool of radius {radius} mm damages the contour here: its path comes too near to an element that is no \
        neighbour"
        help "take a smaller tool, or switch the search of the control off before this contour (M120 LA0, CDOF)";
}

G3203 Error "compensation-start" "radius compensation begins or ends where it cannot"
"The way to a compensated contour, and the way from it, are straight lines that move in the working plane: the tool goes from beside the contour to the \
point that lies at a right angle beside its first element. On an arc, or without a move in the plane, there is no such way. Program a straight block with RL, RR, \
R0, G41, G42 or G40." {
    position_of_tool_gets_lost_inside_compensated() "the position of the tool gets lost inside a compensated contour"
        help "end the compensation before this block";
    follows_compensated_contour(what)
        "{what} follows a compensated contour: the tool stands beside it, where the block does not start"
        help "put a straight block without compensation in between";
    where_this_element_of_compensated_contour_lies()
        "where this element of the compensated contour lies in the plane is not known"
        help "program both axes of the plane before the contour";
    radius_compensation_on_arc(begins) "radius compensation {begins} on an arc"
        help "begin it in a straight block that leads from beside the contour to its first point";
    radius_compensation_in_block_that_does_not_move(begins)
        "radius compensation {begins} in a block that does not move in the working plane"
        help "begin it in a straight block that leads from beside the contour to its first point";
}

G3204 Error "compensation-unfinished" "compensated contour has no end or no element"
"Where the tool stands beside a contour depends on the direction of its elements. Here the compensation ends before there was one, or a tool change, a work \
offset, another plane or the end of the program comes while it is on. End it in a straight block that leads away from the contour." {
    radius_compensation_is_still_on_at_end()
        "radius compensation is still on at the end of the program: how the contour ends is not known"
        help "end it in a block that leads away from the contour";
    radius_compensation_ends_before_contour_has_element()
        "radius compensation ends before the contour has an element: there is no direction to stand beside"
        help "program one element of the contour at least between the two blocks";
    tool_changes() "the tool changes while radius compensation is on"
        help "end the compensation in a block before it";
    program_ends() "the program ends while radius compensation is on"
        help "end the compensation in a block before it";
    work_offset_changes() "the work offset changes while radius compensation is on"
        help "end the compensation in a block before it";
    tool_data_change() "the tool data change while radius compensation is on"
        help "end the compensation in a block before it";
    working_plane_changes() "the working plane changes while radius compensation is on"
        help "end the compensation in a block before it";
    working_plane_is_tilted() "the working plane is tilted while radius compensation is on"
        help "end the compensation in a block before it";
    transformation_begins_or_ends() "a transformation begins or ends while radius compensation is on"
        help "end the compensation in a block before it";
}

G3205 Error "compensation-inside" "what may not stand inside a compensated contour"
"Machine coordinates, threads, arcs outside the working plane and a change of plane, side or radius cannot stand between the first and the last block of a \
compensated contour: the path beside it would have no meaning. End the compensation before the block, and begin it again after it." {
    cycle_is_called_while_tool_stands_beside()
        "a cycle is called while the tool stands beside a contour with radius compensation"
        help "leave the contour in the plane in a block before it";
    offset_is_held_constant_before_contour() "the offset is held constant before the contour has one"
        help "let one element of the contour stand before it";
    of_compensation_changes_inside_contour(what) "{what} of the compensation changes inside a contour"
        help "end the compensation, and begin it anew after this place";
    too_many_blocks_without_move_in_plane()
        "too many blocks without a move in the plane stand between two elements of a compensated contour"
        help "end the compensation before them";
    working_plane_changes_inside_contour() "the working plane changes inside a contour with radius compensation"
        help "end the compensation before this block";
    block_in_machine_coordinates_stands_inside()
        "a block in machine coordinates stands inside a contour with radius compensation"
        help "end the compensation before this block";
    thread_stands_inside() "a thread stands inside a contour with radius compensation"
        help "end the compensation before this block";
    arc_outside_working_plane_stands_inside()
        "an arc outside the working plane stands inside a contour with radius compensation"
        help "end the compensation before this block";
}

G3206 Error "compensation-no-feed" "arc about an outside corner has no feed"
"At an outside corner the tool travels on an arc about the corner. Between two blocks at rapid traverse there is no feed for it. Program the contour at a feed." {
    arc_about_this_corner_lies_between_two()
        "the arc about this corner lies between two blocks at rapid traverse and has no feed"
        help "program the contour at a feed";
}

G3207 Error "compensation-length" "elements are prolonged too far at an outside corner"
"The length by which both elements are to be prolonged (M197 DL) is larger than the way after which they meet, so that no arc is left between them. Make it smaller." {
    elements_are_to_be_prolonged_by_mm(length, length2)
        "the elements are to be prolonged by {length} mm beyond the corner, and meet after {length2} mm"
        help "make the length smaller";
}

G3208 Error "compensation-behind" "way around the start or end of a contour is not known"
"The tool stands on the other side of the contour point, and the control leads it around (KONT). With G450 that is a circle of the tool radius about the point, for \
which the tool has to stand outside of it; the ways of other settings are not published. Start or end beside the contour." {
    tool_contour(what) "the tool {what} the contour from behind, and the control's way around the corner is not known"
        help "program the way around, or let it lead around on a circle (G450)";
    of_way_lies_nearer_than_radius(end, radius)
        "the {end} of the way lies nearer to the contour point than the radius of the tool, {radius} mm"
        help "start or end farther away from the contour";
}

G3210 Warning firm "compensation-left-out" "elements are left out where the tool does not fit"
"A corner of the contour is too narrow for the tool. The program asks for the collision search of the control (HEIDENHAIN M120, SINUMERIK CDON and CDOF), \
so the elements that are named were left out, and the path goes on where it meets a later one. Material stays there. The functions of their blocks happen at that point." {
    element_is_left_out(radius)
        "an element is left out, because the tool of radius {radius} mm does not fit: the path goes on in this \
        block"
        help "check that the material may stay, or take a smaller tool";
    elements_are_left_out(radius)
        "elements are left out, because the tool of radius {radius} mm does not fit: the path goes on in this block"
        help "check that the material may stay, or take a smaller tool";
}

G3211 Warning firm "compensation-damage" "tool damages the contour at a narrow place"
"The path beside one element comes nearer to another element than the radius of the tool, although neighbours fit: a bottleneck. HEIDENHAIN controls \
do not look for it without M120, SINUMERIK controls not without CDON. The path is printed as the control travels it. Take a smaller tool." {
    tool_damages_contour(radius)
        "the tool of radius {radius} mm damages the contour here: its path comes too near to an element that is no \
        neighbour"
        help "take a smaller tool";
}

G3212 Warning firm "compensation-stays" "tool stays beside the contour"
"The block that ends the radius compensation does not move in the working plane. The tool stays where it is, beside the contour, and the next block in the plane starts there and moves \
both axes. No available manual confirms this. End the compensation in a block that leads away from the contour in the plane." {
    radius_compensation_ends_in_block_that_leaves()
        "radius compensation ends in a block that leaves the plane alone: the tool stays beside the contour until \
        the next block in the plane"
        help "end the compensation in a block that leads away from the contour";
    radius_compensation_ends_where_tool_stays(place)
        "radius compensation ends in a block that leaves the plane alone: the tool stays beside the contour \
        ({place}) until the next block in the plane"
        help "end the compensation in a block that leads away from the contour";
}

G3213 Warning "compensation-joint" "arc about an outside corner is partc's reading"
"At an outside corner the tool travels on an arc about the corner. Which feed counts on it, and whether blocks that stand between the two elements happen before \
it or after it, the available manuals of HEIDENHAIN controls do not say. partc takes the feed of the element after the corner, and lets those blocks happen before the arc, as \
SINUMERIK controls do." {
    arc_about_corner_takes_its_feed()
        "the arc about the corner before this element takes its feed; the element before has another one"
        help "program the same feed for both elements, and nothing between them";
    what_stands_between_happens_before_arc()
        "what stands between this element and the one before happens before the arc about the corner"
        help "program the same feed for both elements, and nothing between them";
}

G3214 Warning "compensation-nearly-behind" "start or end of a contour may lie behind it"
"KONT leads around the contour point where the tool stands behind the contour. No available manual says where that begins: partc takes it to be where the straight way would \
come nearer to the contour point than the radius. Here the tool stands on the right side of the contour, but nearer than that. Start or end farther away." {
    of_way_lies_less_than_tool_radius(what)
        "the {what} of the way lies less than the tool radius beside the contour: it is taken to be behind it, so a \
        circle leads around the contour point"
        help "start or end farther away from the contour, or clearly behind it";
}

G3215 Warning "compensation-limit" "limit of the control decides an outside corner"
"Controls prolong the paths at flat outside corners until they meet, and go around sharp ones on an arc. Where one becomes the other is machine data (SINUMERIK MD 20210 with \
G451, MD 20230 with G450); their defaults are not confirmed, so 100 degrees and 0 are taken. Both ways keep the contour. Give the values of the machine by `[control] g451_limit` and `g450_flat`." {
    paths_at_outside_corner_are_prolonged(degrees)
        "at this outside corner of {degrees} degrees a limit decides that is machine data of the control: both paths \
        are prolonged until they meet";
    tool_goes_around_outside_corner(degrees)
        "at this outside corner of {degrees} degrees a limit decides that is machine data of the control: the tool \
        goes around it on an arc";
}

G3216 Warning "compensation-feed" "feed on compensated arcs is not the control's"
"Under CFC, which is in force at power-on, a SINUMERIK control keeps F at the contour: in a hollow arc the centre of the tool travels slower, around others faster. The output has F as \
it is programmed, so the cutting edge is faster than meant in a hollow arc. `[control] curve_feed = \"control\"` prints the feed of the centre, F times its radius by that of the contour." {
    f_is_printed_for_centre_of_tool(center, center2)
        "F is printed for the centre of the tool, whose radius is {center} mm here; the control keeps it at the \
        contour of radius {center2} mm";
}

G3217 Error "compensation-border" "chamfer or rounding at the border of a compensated contour"
"The way to a compensated contour ends beside its first element, and the way from it begins beside the last one; neither is an element of the contour. What a control makes of a chamfer \
or rounding between such a way and the contour is in no available manual. Let the compensation begin and end in blocks without one (RNDM: switch it on after the first element)." {
    chamfer_or_rounding_stands_at_point(what)
        "a chamfer or rounding stands at the {what} point of a contour with radius compensation"
        help "let the compensation begin and end in blocks without a chamfer or rounding";
}

G3218 Warning "corner-without-effect" "M function for a corner has no effect"
"M97 and M197 lead the tool around the corner at the end of their block in a way of their own. Only an outside corner has a way around it: at an inside corner, and where the contour goes on \
straight, nothing comes of them; neither does at the end of the compensation. The block may be the wrong one." {
    m_function_for_corner_at_end()
        "the M function for the corner at the end of this element has no effect: the compensation ends there"
        help "move it into the block that ends in the corner that is meant, or remove it";
    m_function_for_corner_at_end_of_this_element()
        "the M function for the corner at the end of this element has no effect: the contour turns towards the tool \
        there, or goes on straight"
        help "move it into the block that ends in the corner that is meant, or remove it";
}

}
