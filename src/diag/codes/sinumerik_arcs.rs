//! `S3` and `S4`: arcs and contours of SINUMERIK programs. A text that names an alarm means the number the control itself shows.

super::codes! { SINUMERIK_ARCS:

S3001 Error "siemens-radius" "arc by radius does not reach its end"
"CR= is at least half the distance of start and end: alarm 14095. Look at the word that is marked, and at the value after it." {
    points_are_mm_apart(chord, cr, radius, length_unit)
        "the points are {chord:.4} mm apart, CR={cr} reaches {radius:.4}" alarm 14095
        help "CR= has to be at least {length_unit:.4}";
}

S3002 Error "siemens-arc-twice" "arc is given twice"
"Centre, CR= and AR= exclude each other, and a polar arc has the pole as its centre: alarm 14900." {
    polar_arc_has_pole_as_its_centre() "a polar arc has the pole as its centre" alarm 14900
        help "leave the centre, CR= and AR= out, or program the end point by axes";
    centre_cr() "centre, CR= and AR= exclude each other" alarm 14900 help "keep one of them";
    ar_stands_beside_both_centre() "AR= stands beside both a centre and an end point" alarm 14900
        help "give the end point or the centre";
}

S3004 Error "siemens-opening" "opening angle out of range"
"AR= lies between 0.0001 and 359.9999 degrees: alarm 14910. A full circle is programmed by its centre." {
    ar_lies_outside_0_0001_to_359(ar) "AR={ar} lies outside 0.0001 to 359.9999 degrees" alarm 14910
        help "the sense of rotation comes from G2 or G3";
}

S3005 Error "siemens-turns" "number of turns does not exist"
"TURN= counts additional full circles, 0 to 999: alarm 14048. Look at the word that is marked, and at the value after it." {
    turn_is_no_number_of_turns(turn) "TURN={turn} is no number of turns" alarm 14048
        help "TURN counts additional full circles, 0 to 999";
}

S3006 Error "siemens-via" "intermediate point is missing"
"CIP runs through a point between start and end, given by I1=, J1=, K1=: alarm 14920." {
    start_intermediate_point() "start, intermediate point and end lie on one line" alarm 14920
        help "move the intermediate point off the line, between start and end of the arc";
    cip_needs_intermediate_point() "CIP needs an intermediate point" alarm 14920 help "give I1=, J1=, K1=";
}

S3008 Error "siemens-tangent" "CT has no tangent"
"CT goes on in the direction of the block before, which has to travel in the working plane, and cannot turn back: alarm 14045. Put a line or an \
arc before it, and the end point not straight behind the start." {
    no_block_gives_direction() "no block before CT gives a direction" alarm 14045
        help "put a line or arc of the plane before CT";
    frame_changed_behind_cycle() "a cycle stands before CT, and the frame has changed since" alarm 14045
        help "put a line or arc of the plane before CT";
    block_before_starts_at_unknown_place()
        "the block before CT starts at a place that is not known" alarm 14045
        help "put a line or arc of the plane before CT";
    block_before_runs_across_plane() "the block before CT runs at a right angle to the plane" alarm 14045
        help "put a line or arc of the plane before CT";
    end_lies_straight_behind_start() "the end point lies straight behind the start" alarm 14045
        help "give the end point to one side";
    straight_line_has_no_turns() "CT is a straight line here, which has no turns" alarm 14045 help "leave TURN= out";
}

S4001 Error "siemens-contour-long" "contour has too many elements"
"A contour that a cycle works along is kept as a whole, so its length is limited: 1000 elements, roundings and chamfers counted. The control \
has a limit of its own (alarm 61933). Split the contour." {
    contour_has_more_than_elements(most_elements) "the contour has more than {most_elements} elements" alarm 61933;
}
}
