//! `G`: geometry, whatever the dialect.

super::codes! { GEOMETRY:

G3001 Error "arc-end-off-circle" "end point does not lie on the circle"
"Start and end of an arc must have the same distance from its centre, within the tolerance of the control \
(0.016 mm on HEIDENHAIN controls). The difference is larger, so start, centre or end is wrong." {
    start_lies_mm_from_centre(r1, r2, off, tol)
        "the start lies {r1:.4} mm from the centre, the end {r2:.4} mm: {off:.4} mm difference, {tol} allowed"
        help "check start, centre and end of the arc";
}

G3002 Error "radius-too-small" "radius is too small for the distance"
"An arc by radius reaches at most two radii far, and start and end lie further apart. The control stops here. Check radius and end \
point; a sign or a decimal point may be lost." {
    points_are_mm_apart(d, radius, least) "the points are {d:.4} mm apart, the radius reaches {radius:.4} mm"
        help "the radius has to be at least {least:.4}";
}

G3003 Error "radius-full-circle" "arc by radius ends where it starts"
"From a radius alone the centre of a full circle cannot be known: every circle through the point would fit. HEIDENHAIN controls \
refuse the block, too. Program the centre (`CC`, `C`), or two half circles." {
    arc_ends_where_it_starts() "the arc ends where it starts, so its centre is not determined"
        help "program the centre of the circle, or two half circles";
    start_and_end_of_arc_are_same_point()
        "start and end of the arc are the same point, or its angle is no part of a turn"
        help "program the centre of the circle, or two half circles";
}

G3004 Error "tangent-missing" "no element to be tangent to"
"A tangential arc continues the direction of the contour element before it. Here none stands before it that moves in the plane of the arc, \
or the coordinate system changed in between." {
    no_element_with_direction_precedes() "no element with a direction precedes the tangential arc"
        help "put a line or arc of the plane before the tangential arc";
    chamfer_or_rounding_directly_before_leaves()
        "a chamfer or rounding directly before a tangential arc leaves its direction open"
        help "put a line or arc of the plane before the tangential arc";
    element_before_moves_out_of_plane() "the element before the tangential arc moves out of the plane"
        help "put a line or arc of the plane before the tangential arc";
}

G3005 Error "tangent-behind" "tangential arc cannot reach its end"
"The end point lies exactly behind the start, seen in the direction of travel: no circle touches that direction and passes through \
the point. Check the end point, or put a line in between." {
    end_point_lies_exactly_behind_start() "the end point lies exactly behind the start"
        help "check the end point, or put a line in between";
}

G3006 Warning "tangent-straight" "tangential arc is a straight line"
"The end point lies exactly ahead, so the arc degenerates to a line, which is printed. The path is right if a line is meant; then \
program a line. Otherwise check the end point." {
    end_lies_straight_ahead() "the end lies straight ahead, so the arc is a line";
}

G3007 Error "corner-neighbour" "chamfer or rounding has no neighbour"
"A chamfer or rounding is put between two contour elements that both move in the working plane. Here one of them is missing: \
the contour starts or ends with it, or a block in between moves another axis only." {
    block_that_does_not_move_stands_between()
        "a block that does not move stands between the chamfer or rounding and its element"
        help "write it before the two elements, or after them";
    no_contour_element_stands_behind_this_chamfer() "no contour element stands after this chamfer or rounding"
        help "put the corner between two elements that move in the working plane";
    two_chamfers_or_roundings_follow_each_other() "two chamfers or roundings follow each other"
        help "put the corner between two elements that move in the working plane";
    no_contour_element_stands_before_this_chamfer() "no contour element stands before this chamfer or rounding"
        help "put the corner between two elements that move in the working plane";
    block_in_machine_coordinates_cannot_be_next(corner) "a block in machine coordinates cannot be next to a {corner}"
        help "put the corner between two elements that move in the working plane";
    block_moves_axis_outside_working_plane(which, corner)
        "the block {which} the {corner} moves an axis outside the working plane"
        help "put the corner between two elements that move in the working plane";
    block_is_thread(which, corner) "the block {which} the {corner} is a thread, whose end is its run-out"
        help "put the corner between two elements that move in the working plane";
    start_of_element_before_is_not_known(corner) "the start of the element before the {corner} is not known"
        help "put the corner between two elements that move in the working plane";
    element_has_no_length_in_plane(corner) "an element at the {corner} has no length in the plane"
        help "put the corner between two elements that move in the working plane";
}

G3008 Error "corner-too-large" "chamfer or rounding does not fit"
"The corner would cut off more than a neighbouring element is long. Make the radius or chamfer smaller or the elements longer. \
Where a short element has a corner at both ends, both have to fit on it." {
    needs_mm_of_each_neighbour(corner, back, before, after)
        "the {corner} needs {back} mm of each neighbour: the element before has {before} mm, the one after {after} \
        mm"
        help "make the corner smaller, or the short element longer";
    needs_mm_of_each_neighbour_after_corner(corner, back, before, after)
        "the {corner} needs {back} mm of each neighbour: the element before has {before} mm after the corner before \
        it, the one after {after} mm"
        help "make the corner smaller, or the short element longer";
    does_not_fit(corner, before, after)
        "the {corner} does not fit between its neighbours: the element before has {before} mm, the one after {after} \
        mm"
        help "make the corner smaller, or the short element longer";
    does_not_fit_after_corner(corner, before, after)
        "the {corner} does not fit between its neighbours: the element before has {before} mm after the corner \
        before it, the one after {after} mm"
        help "make the corner smaller, or the short element longer";
}

G3025 Warning firm "corner-shortened" "chamfer or rounding was made smaller"
"The corner would cut off more than a neighbouring element is long, so it was made as large as the element allows: because what is missing \
is less than 0.001 mm, which a source rounded to three decimals loses, or because `[control] large_corners` asks for it. SINUMERIK controls \
shorten such corners without a word, in a way that is not documented. Check that the part may be so." {
    is_larger_than_its_neighbours_allow(corner, less)
        "the {corner} is {less:.6} mm larger than its neighbours allow; it is made so much smaller";
    is_made_smaller(too_large, made) "{too_large}; it is made with {made}";
    corner_before_left_nothing(corner) "the corner before the {corner} left nothing of the element; it is left out";
}

G3009 Warning firm "corner-straight" "nothing to round or chamfer"
"The elements before and after continue in the same direction, so there is no corner. Nothing is inserted, and the path is the one \
without the block. Check whether the right corner was meant, else delete the block." {
    there_is_no_corner(corner) "there is no corner to put a {corner} in";
}

G3010 Error "chamfer-at-arc" "chamfer next to an arc"
"A chamfer is defined between two straight lines only: on an arc there is no length along which to cut off the corner. Program a \
rounding, or a line with both its end points. A SINUMERIK control makes chamfers at arcs, too; how they lie there is not confirmed, so they \
need `[control] arc_chamfers = \"bisector\"`." {
    chamfer_is_possible_between_straight_lines() "a chamfer is possible between straight lines only"
        help "program a rounding beside an arc";
}

G3011 Error "arc-scaled-unevenly" "arc under unequal scaling"
"Scaling with different factors in the two axes of the plane turns a circle into an ellipse, which controls refuse and plain G-code \
cannot say. Give both axes the same factor, or program the contour in its final size." {
    axes_of_this_arc_have_different_scaling() "the axes of this arc have different scaling factors"
        help "give both axes of the plane the same factor";
}

G3012 Error "arc-out-of-plane" "arc is turned out of the main planes"
"After the rotation the arc no longer lies in XY, ZX or YZ, for example an arc in ZX under a rotation in XY. Plain G-code has arcs in \
these planes only. Reset the rotation before the arc, or have the CAM system put out lines." {
    rotation_turns_this_arc_out_of_planes() "the rotation turns this arc out of the main planes"
        help "reset the rotation before the arc";
}

G3013 Note "center-adjusted" "arc centres were adjusted"
"Start and end of some arcs have slightly different distances from their programmed centre, within the tolerance of the control. \
Controls that check more strictly would refuse them. The centre was moved to the nearest point that fits both; \
start and end are as programmed. The largest shift is stated." {
    arc_centres_were_adjusted(count, largest) "{count} arc centres were adjusted, this one most: by {largest:.4} mm";
    centre_of_this_arc_of_contour(shift) "the centre of this arc of the contour was adjusted by {shift:.4} mm";
}

G8101 Warning firm "center-moved-far" "arc centre was moved far"
"Start and end of the arc have slightly different distances from its centre, within the tolerance of the control, and lie so close together \
that the point which fits both is more than ten times that tolerance away. The bow of the printed arc is the programmed one within the tolerance, \
but its centre and direction are not: most often a coordinate is rounded too coarsely, or wrong." {
    arc_centres_were_moved_far(count, largest) "{count} arc centres were moved far, this one most: by {largest:.4} mm"
        help "check start, end and centre of the arc in the source";
    centre_is_moved_by_mm(moved) "the centre is moved by {moved:.4} mm, so that start and end lie on one circle";
}

G3014 Error "arc-without-radius" "centre of the arc lies on its start or end"
"The centre of the arc lies on its start or on its end, so the arc has no radius. Most often the circle centre was taken over from \
another place, or the tool stands on the centre when the arc begins. Check the circle centre and the position before the arc." {
    arc_starts_in_its_centre() "the arc starts in its centre"
        help "check the circle centre and the position before the arc";
    arc_ends_in_its_centre() "the arc ends in its centre"
        help "check the circle centre and the position before the arc";
}

G3015 Error "axis-unknown-in-frame" "position of the other axis is not known"
"Under a rotation one programmed axis moves two machine axes. Where the other one stands was not programmed yet, so the target cannot \
be computed. Program both axes of the plane once, in the first block under the rotation." {
    under_this_rotation_target_depends(programmed, missing)
        "under this rotation the target of {programmed} also depends on {missing}, whose position is not known"
        help "program {missing} in this block or before it";
}

G3016 Error "corner-plane" "corner between elements of different planes"
"The elements before and after a chamfer or rounding lie in different planes, for example an arc in ZX and a line in XY. They have no \
common corner. Program the transition as elements of its own." {
    elements_lie_in_different_planes(corner) "the elements at the {corner} lie in different planes"
        help "program the transition as elements of its own";
}

G3017 Error "corner-reversal" "contour turns back on itself"
"The contour goes back the way it came. No radius or chamfer fits between the two directions. Most often an end point is wrong, or \
the corner block stands in the wrong place." {
    contour_turns_back_on_itself(corner) "the contour turns back on itself at the {corner}"
        help "check the end points on both sides of the corner";
}

G3018 Error "travel-limit" "position is beyond the travel limits"
"A coordinate lies outside `[machine] limits` of partc.toml; for arcs the bulge counts, too. The machine would stop at the limit \
switch, or refuse the program. Nothing is written: check the datum and the program, or the limits. Coordinates are compared as they \
are printed, without work offsets." {
    is_beyond_travel_limits(axis, value, low, high) "{axis}{value:.4} is beyond the travel limits {low} to {high}"
        help "check the datum and the program, or the limits of the machine in partc.toml";
}

G3019 Error "corner-frame" "coordinate system changes inside a corner"
"A datum shift, rotation, mirror or scaling is programmed between a chamfer or rounding and the element that follows it. The two \
elements are measured in different systems, so the corner is undetermined. Move the transformation before the corner or after \
the next element." {
    coordinate_system_changes(corner) "the coordinate system changes at the {corner}"
        help "move the transformation before the corner or after the next element";
}

G3020 Error "via-on-line" "three points of an arc lie on one line"
"An arc through an intermediate point needs three different points that are not on one line. Most often the intermediate point is the \
start or the end, or a coordinate of it is missing." {
    start_intermediate_point_and_end_lie() "start, intermediate point and end lie on one line or are the same";
}

G3021 Error "lead-without-way" "lead of a thread along an axis that does not move"
"The lead of a thread is given along one axis, by `I`, `J` or `K`, and the block does not move this axis. Give the lead along the axis that \
moves most, and check the end point." {
    lead_counts_along(axis) "the lead counts along {axis}, which does not move in this block";
}

G3022 Error "thread-scaled-unevenly" "thread under unequal scaling"
"Scaling with different factors changes the lead of a thread in a way that depends on its direction. Cancel the scaling before the thread." {
    axes_of_this_thread_have_different_scaling() "the axes of this thread have different scaling factors"
        help "give its axes the same factor";
}

G3050 Error "tap-axis-changed" "the frame changes the axis along which a hole is tapped"
"A tap without a compensating chuck goes along one axis, in step with the spindle. A frame that turns or mirrors this axis would have the tap cut another thread, and one that scales it would stretch a pitch that the tap has ground into it. Shifts, and whatever a frame does to the other axes, are allowed. Tap the hole before the frame, or after its end." {
    frame_turns_mirrors_or_scales(axis) "the frame turns, mirrors or scales {axis}, along which the hole is tapped"
        help "end the frame before the tap, or turn and mirror the other axes only";
}

G3060 Error "undercut-plane" "undercut outside the plane of the turned contour"
"An undercut belongs to the contour of a turned part, which lies in the plane of Z and X (G18). In another working plane there is none. \
Select G18 before the contour." {
    undercuts_exist_in_plane() "undercuts exist in the plane of Z and X only" help "select G18 before the contour";
}

G3061 Error "undercut-no-lathe" "undercut without turning technology"
"An undercut relieves a corner of a turned part, and the machine is configured as a milling machine. Set `kind = \"lathe\"` in `[machine]` \
of partc.toml if the program is for a lathe." {
    machine_is_configured_as_milling_machine()
        "the machine is configured as a milling machine, which makes no undercuts"
        asks "set `[machine] kind = \"lathe\"` if the program is for a lathe";
}

G3062 Error "undercut-no-diameter-axis" "undercut without a diameter axis"
"Which line of the corner is the cylinder follows from the diameter axis (MD 20100): the cylinder runs along the other axis of the plane. \
No diameter axis is configured, or it is not an axis of the working plane. Set `diameter_axis = \"X\"` in `[machine]` of partc.toml." {
    diameter_axis_is(axis) "the diameter axis is {axis}; a part in the plane of Z and X turns about Z"
        asks "set `[machine] diameter_axis = \"X\"` (MD 20100)";
    no_diameter_axis_is_configured() "no diameter axis is configured, so there is no cylinder to relieve"
        asks "set `[machine] diameter_axis = \"X\"` (MD 20100)";
}

G3063 Error "undercut-corner" "corner cannot take an undercut"
"An undercut lies between two straight lines at feed, one along the part and one across: directions 0, 90, 180 and 270 degrees, each \
within 3 degrees. At other corners, beside arcs, rapids and threads, and where the contour has no corner there is no undercut. Check the lines \
before and after the undercut." {
    block_is_no_straight_line(which) "the block {which} the undercut is no straight line at feed in the plane";
    start_of_line_before_is_not_known() "the start of the line before the undercut is not known";
    line_has_no_length_in_plane() "a line at the undercut has no length in the plane"
        help "put the undercut between the two lines of its corner";
    line_runs_at_degrees(direction) "a line at the undercut runs at {direction:.3} degrees"
        help "undercuts need lines at 0, 90, 180 or 270 degrees, within 3 degrees, one along each axis";
}

G3064 Error "undercut-no-room" "line is too short for the undercut"
"The undercut needs more of the cylinder or of the face than is there. Take a smaller size or the short form, or make the line longer. A \
rounding or chamfer at the other end of the line takes its share, too." {
    undercut_takes_mm_of_cylinder(needs, has)
        "the undercut takes {needs:.4} mm of the cylinder, which is {has:.4} mm long"
        help "take a smaller size, or make the cylinder longer";
    undercut_takes_mm_of_face(needs, has) "the undercut takes {needs:.4} mm of the face, which is {has:.4} mm high"
        help "take a smaller size or form E, or make the face higher";
}

G3065 Error "undercut-dimensions" "dimensions make no undercut"
"Depth, width and radii must be positive, the entry angle above 0 and up to 90 degrees, and slope, floor and roundings must fit into the \
width of the undercut. Check the values against the drawing; sizes of the standards are replaced in `[undercut]` of partc.toml." {
    depth_width_or_radius_is_no_positive() "a depth, width or radius of the undercut is no positive number"
        help "check the values of the undercut";
    angle_is_out_of_range() "an angle of the undercut is out of range"
        help "entry angles lie above 0 and up to 90 degrees";
    slope_floor_and_roundings_do_not_fit() "slope, floor and roundings do not fit into the width of the undercut"
        help "make the undercut wider, or its radii smaller";
}

G3066 Error "undercut-side" "undercut on the wrong side of the part"
"The corner lies outside on the part where the undercut is for a bore, or the other way round. At an edge that points outwards there is \
nothing to relieve, and the undercut would cut into the part. Check the form (A, B external; C, D internal) and the contour." {
    undercut_is_for_bore() "the undercut is for a bore, and the corner lies outside on the part";
    undercut_is_for_outside() "the undercut is for the outside of the part, and the corner lies in a bore";
}

G3067 Warning "undercut-on-taper" "undercut on a taper departs from its standard"
"A line at the undercut leans out of its axis, by at most 3 degrees, as for a tapered thread. Slope, floor and roundings are those of the \
standard, and the undercut begins where its slope meets the taper; its length and depth there are not those of the standard." {
    line_at_undercut_is_not_parallel()
        "a line at the undercut is not parallel to its axis, so the undercut departs from its standard";
}

G3068 Warning "undercut-radius-reduced" "radius in the undercut is reduced"
"The rounding between the slope and the floor of the undercut is larger than the slope is long, which happens with steep entry angles. It is made \
as large as fits. What the control does in this case is not documented; check the drawing, or take a smaller radius or entry angle." {
    radius_at_entry_does_not_fit(radius) "the radius at the entry does not fit and becomes {radius:.4} mm";
}

G3090 Warning "block-at-corner" "block of M functions between a corner and its element"
"An M function stands in a block of its own between a chamfer or rounding and the element before or after it. No manual page says whether the \
control still finds the corner; here it is cut, and the M function is printed in its place. Write it into the block of an element to be sure." {
    block_of_m_functions_stands_between_chamfer()
        "a block of M functions stands between the chamfer or rounding and its element: the corner is cut all the \
        same"
        help "write the M function into the block of an element, or before them";
}

G3023 Error "circle-unclear" "full circle or an arc of nearly no length"
"Start and end of the arc differ by 0.00005 to 0.0005 mm. Up to 0.00005 mm they count as one point, so the block is a full circle; a larger \
difference may be a rounding of fewer decimal places, and the block still meant as a full circle, or an arc that is next to nothing. The two differ by a \
whole turn, so nothing is written. Program the start point again as the end point for a full circle (a circle by angle has no such doubt), \
or leave the arc out." {
    start_end_of_arc_are_mm_apart(gap) "start and end of the arc are {gap:.5} mm apart"
        help "for a full circle, program the start point again as the end point";
    cp_starts_mm_beside_its_end(gap) "CP starts {gap:.5} mm beside its end"
        help "for a full circle, program IPA+360 or IPA-360";
}

G3024 Error "corner-at-rapid" "rounding between two blocks at rapid traverse"
"A rounding is an arc, and plain G-code cuts arcs at a feed only. Both neighbours run at rapid traverse, so there is none. Give the rounding its \
own feed, or program one of the neighbours with a feed." {
    lies_between_two_blocks_at_rapid(corner) "the {corner} lies between two blocks at rapid traverse and has no feed";
}

G3040 Error "cycle-too-many-cuts" "cycle makes too many cuts"
"The infeed is so small against the depth that the cycle would run without end in sight. Most often a decimal point is lost. \
Program a larger infeed." {
    infeed_makes_cuts(cuts, limit) "the infeed makes {cuts} cuts, more than {limit}" help "program a larger infeed";
    infeed_makes_cuts_of_this_thread(cuts, most_cuts)
        "the infeed makes {cuts} cuts of this thread, more than {most_cuts}"
        help "program a larger infeed";
    undercut_takes_cuts_of_mm(count, step) "the undercut takes {count:.0} cuts of {step} mm"
        help "program a larger infeed";
    groove_takes_strokes(strokes) "the groove takes {strokes} strokes"
        help "program a larger infeed, or take a wider tool";
    cuts_are_interrupted_times(count, most_cuts) "the cuts are interrupted {count} times, more than {most_cuts}"
        help "program a longer way between the interruptions";
    recess_needs_strokes(strokes, most_levels) "the recess needs {strokes} strokes, more than {most_levels}"
        help "program a larger distance of the strokes";
    infeed_makes_levels_of_this_recess(levels, most_levels)
        "the infeed makes {levels} levels of this recess, more than {most_levels}"
        help "program a larger infeed";
    drilling_makes_too_many_steps(fault) "{fault}" help "give a least step, or larger steps";
}

G3041 Error "cycle-arguments" "cycle data do not fit together"
"The data of the cycle describe nothing that can be machined. The message names what is wrong; every dialect names its own word for it \
before the path is computed, so this text is the last line of defence." {
    allowance_on_floor_leaves_nothing_of_groove() "the allowance on the floor leaves nothing of the groove"
        help "give a smaller allowance";
    drilling_makes_no_path(fault) "{fault}" help "check the data of the drilling cycle";
    thread_makes_no_path(fault) "{fault}" help "correct the thread data";
    layers_makes_no_path(fault) "{fault}" help "correct the data of the cycle";
    cut_off_makes_no_path(fault) "{fault}" help "correct the data of the cut-off";
    recess_makes_no_path(fault) "{fault}" help "correct the recess data";
    groove_makes_no_path(fault) "{fault}" help "correct the data of the groove";
    finishing_makes_no_path(fault) "{fault}" help "correct the finishing data";
    undercut_makes_no_path(fault) "{fault}" help "check the data of the undercut cycle";
}

G3042 Error "thread-flank-offset" "flank offset is longer than the way it uses up"
"With infeed along a flank the cuts above the last one start a little ahead or behind. A start ahead of the run-in would plunge into the thread at \
its full width, and an end behind the last part would cut nothing. Lengthen the run-in or run-out, or make the flank angle smaller." {
    flank_infeed_ends_cut_mm_early(behind)
        "the flank infeed ends a cut {behind:.3} mm early, before the last part begins"
        help "lengthen the run-out or make the flank angle smaller";
    flank_infeed_starts_cut_mm_ahead(ahead, run_in)
        "the flank infeed starts a cut {ahead:.3} mm ahead, but the run-in is {run_in:.3} mm: the tool would plunge \
        into the thread"
        help "lengthen the run-in or make the flank angle smaller";
}

G3043 Error "cycle-start-unknown" "position before the cycle is not known"
"A turning cycle takes the start of its way from where the tool stands when it is called. Here X or Z was not programmed yet, or was lost by \
machine coordinates or an error before. Position both axes before the cycle." {
    tool_is_lifted_off_along(axis) "the tool is lifted off along {axis}, whose position is not known"
        help "position the tool over the hole in both axes";
    cycle_starts_where_tool_stands()
        "the cycle starts where the tool stands, but its position in X and Z is not known"
        help "position X and Z before the cycle";
}

G3044 Error "recess-contour" "contour is not one recess"
"Recess turning needs a contour that falls from one rim to the floor and rises to the other rim, seen from the tool, without leaning over. \
Several recesses need a cycle each; walls that lean over cannot be reached by a straight tool." {
    contour_is_not_one(name) "the contour is not one {name}: it has to fall to its floor and rise again, only once"
        help "describe it from rim to rim, seen from the tool";
    wall_leans_over(name) "a wall of the {name} leans over, so that the tool cannot reach behind it"
        help "describe it from rim to rim, seen from the tool";
    contour_begins_or_ends_at_floor(name)
        "the contour begins or ends at the floor of the {name}: one of its walls is missing"
        help "describe it from rim to rim, seen from the tool";
}

G3045 Error "recess-tool-too-wide" "recessing tool does not fit"
"Between the walls, with their oversize, there is not room enough for the cutting width down to the floor; or the floor is round or oblique, so that \
a flat tool does not reach its lowest point. Take a narrower tool, or one with a larger nose radius for a round floor." {
    tool_of_mm_width_does_not_reach(width)
        "the tool of {width} mm width does not reach the floor of the groove between its walls and their allowance"
        help "take a narrower tool or a smaller allowance";
    tool_of_mm_width_does_not(width)
        "the tool of {width} mm width does not reach the floor of the recess between its walls and their oversize"
        help "take a narrower tool or a smaller oversize";
}

G3046 Error "cycle-blank" "blank is not where the cycle needs it"
"The blank that the cycle was given does not stand above the contour, or the tool stands inside of it, so that there is nothing to cut or no \
safe way. Check blank, contour and the position before the cycle." {
    tool_stands_beside_thread_at_its_height()
        "the tool stands beside the thread at its height, from where no rapid to the start is safe"
        help "position the tool in front of the thread, or clear of its diameter, before the cycle";
    tool_stands_behind_face_of_undercut()
        "the tool stands behind the face of the undercut, so that there is no safe way to the corner"
        help "position the tool in front of the face before the cycle";
    blank_does_not_reach_above_contour() "the blank does not reach above the contour"
        help "check the size of the blank, the allowances and the contour";
    blank_does_not_reach_above_floor() "the blank does not reach above the floor of the recess"
        help "check the height of the blank and the contour";
}

G3047 Error "roughing-contour" "contour cannot be roughed in parallel cuts"
"The contour has to run from the side where the cuts begin to the other. Parts that fall behind a higher one are cut only where the cuts before follow the contour: \
else steps stand where the tool has to pass." {
    contour_does_not_run_from_side() "the contour does not run from the side where the cuts begin to the other"
        help "check the order and the points of the contour, and the direction of machining";
    contour_falls_behind_higher_part()
        "the contour falls behind a higher part, and without a cut along the contour steps stand where the tool has \
        to pass"
        help "let the cuts follow the contour, or leave the falling part out";
}

G3048 Error "finishing-way" "no free way to the contour or from it"
"Before finishing the tool travels to the start of the contour at rapid traverse, and afterwards away from its end. The way has to keep clear of the contour. Position the tool in front of the start, or choose another way of retraction." {
    way_from_end_of_contour_to_end()
        "the way from the end of the contour to the end position of the cycle touches the contour"
        help "choose another order of the axes, or lift only and position afterwards";
    there_is_no_room_beside_end() "there is no room beside the end of the contour for the tool to lift off"
        help "end the contour at a place that the tool leaves freely, or make the clearance smaller";
    rapid_approach_to_x_z_leads_through(map_or, map_or2)
        "the rapid approach to X{map_or:.3} Z{map_or2:.3} leads through the blank, from which nothing was cut yet"
        help "rough the contour before it is finished, or correct the section BLANK to what is clamped";
    tool_cannot_travel_from_where_it_stands()
        "the tool cannot travel from where it stands to the start of the contour without touching it"
        help "position the tool in front of the start of the contour";
    there_is_no_room_beside_start()
        "there is no room beside the start of the contour for the tool to come down to it"
        help "begin the contour at a place that the tool reaches freely, or make the clearance smaller";
    there_is_no_room_between_end()
        "there is no room between the end of the face and the undercut for the tool to leave"
        help "cut the face up to a greater height, or give a smaller safety distance";
}

G3049 Error "finishing-nose" "nose of the tool does not fit the contour"
"The way of the nose runs parallel to the contour at its radius. Where a hollow, an inner corner between short elements or a recess is narrower than that, the tool would cut into the finished part. Take a smaller nose, or leave the narrow part out of the contour." {
    nose_of_tool_has_no_room()
        "the nose of the tool has no room in a hollow, a corner or an undercut of the contour"
        help "take a tool with a smaller nose radius, or leave the narrow part out";
    nose_radius_is_larger_than_rounding(radius, least)
        "the nose radius {radius} is larger than the rounding {least:.4} of the undercut"
        help "take a tool whose nose is not larger than the roundings of the undercut";
    nose_has_no_room_in_undercut(radius) "a nose of radius {radius} has no room in the undercut"
        help "take a tool whose nose is not larger than the roundings of the undercut";
    nose_of_tool_has_no_room_in_recess()
        "the nose of the tool has no room in a hollow, a corner or a recess of the contour"
        help "take a tool with a smaller nose radius, or leave the narrow part out";
    contour_turns_back_on_itself() "the contour turns back on itself"
        help "take a tool with a smaller nose radius, or leave the narrow part out";
    contour_has_no_length() "the contour has no length"
        help "take a tool with a smaller nose radius, or leave the narrow part out";
}

}
