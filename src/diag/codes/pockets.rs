//! Milling cycles: what all of them take, pockets and slots.

super::codes! { POCKETS:

G3321 Error "milling-no-room" "area has no path for the cutter"
"The sizes of a pocket or slot leave no path for the centre of the cutter: the cutter with the allowance is wider than the area, a corner is \
tighter than the cutter, or the rings computed for a contour did not stand the check of their distance to it. Check the sizes, the radius of the \
tool, the allowances and the infeeds." {
    angle_of_insertion_is_so_small() "the angle of insertion is so small that the strokes to and fro do not end"
        help "give a larger angle";
    rings_along_contour_do_not_keep() "the rings along the contour do not keep their distance from it"
        help "move an end point of the contour a little, or take another infeed in the plane";
    from_start_point_no_straight_way_leads()
        "from the start point no straight way leads between the walls to where the rings begin"
        help "give a start point farther from the walls, or leave the choice to the cycle";
    cutter_finds_no_room_between_walls() "the cutter finds no room between the walls of the contour"
        help "take a smaller cutter, or a smaller allowance";
    pocket_makes_no_path(fault) "{fault}" help "check the sizes of the pocket and the data of the cutter";
    long_hole_makes_no_path(fault) "{fault}" help "check the sizes of the long hole and the data of the cutter";
    region_makes_no_path(fault) "{fault}" help "check the contour, the data of the cutter, and the allowances";
    pilot_holes_makes_no_path(fault) "{fault}"
        help "check the contour, the data of the cutter that roughs it, and the allowances";
    ring_can_only_be_reached_straight_down() "a ring of the pocket can only be reached straight down"
        help "take a smaller cutter, or go straight down, which needs a cutter that can plunge";
    walls_leave_no_room_for_helix() "the walls leave no room for the helix"
        help "take a smaller cutter, or go straight down, which needs a cutter that can plunge";
    walls_leave_no_room_for_strokes() "the walls leave no room for strokes to and fro"
        help "take a smaller cutter, or go straight down, which needs a cutter that can plunge";
    rings_do_not_keep_between_walls(x, y, width, takes)
        "the rings along the contour do not keep their distance from it: the walls next to ({x:.3}, {y:.3}) are \
        {width:.3} mm apart, and the cutter with its allowance takes {takes:.3} mm"
        help "take a cutter or an allowance that is smaller, so that it passes there, or larger, so that it does \
        not";
    rings_do_not_keep_at_arc(x, y, radius, takes)
        "the rings along the contour do not keep their distance from it: the arc about ({x:.3}, {y:.3}) has a radius \
        of {radius:.3} mm, and the cutter with its allowance takes {takes:.3} mm"
        help "take a cutter or an allowance that is smaller, so that it passes there, or larger, so that it does \
        not";
}

S8230 Warning "siemens-milling-left-open" "argument of a milling cycle is left open"
"The call leaves open what the control takes from elsewhere: the infeed in depth or in the plane, or the sense in which the spindle turns for climb \
and conventional milling. The message says what is taken. Give the argument, or program M3 or M4 before the call." {
    call_leaves_open(call, what) "{call}: {what}";
    mirrored_frame_turns_sense_around(asked, made)
        "a mirrored frame turns the sense around: {asked} is asked for, and {made} milling comes out"
        help "give the other `CDIR` where the sense is to stay on the mirrored part";
    whether_spindle_turns_by_m3_or_m4()
        "whether the spindle turns by M3 or M4 is not known: M3 is taken for climb and conventional"
        help "program M3 or M4 before the cycle, or CDIR 2 or 3";
    no_infeed_in_plane(name, place)
        "no infeed in the plane `{name}` (argument {place}): 0.8 of the cutter's diameter"
        help "give the greatest width of a cut";
    no_infeed_in_depth(name, place, way) "no infeed in depth `{name}` (argument {place}): one level of {way} mm"
        help "give the greatest depth of a level";
    feed_is_read_as_way_per_revolution(value)
        "the feed {value} is read as a way per revolution, since G95 is in force"
        help "program G94 before the cycle where it is a feed per minute";
    offn_is_in_force(normal) "OFFN={normal} is in force and not counted: the allowance of the cycle is"
        help "program OFFN=0 before the cycle, and `_FAL` in it";
    there_is_no_room_to_go() "there is no room to go to and fro: the tool goes straight down"
        help "the pocket has no room for it; a cutter that cannot plunge breaks";
    radius_of_helix_is_mm(made) "the radius of the helix is {made:.3} mm only" help "the pocket has no room for more";
    there_is_no_room_for_helix() "there is no room for the helix: the tool goes straight down"
        help "the pocket has no room for it; a cutter that cannot plunge breaks";
    there_is_no_room_for_helical_turns()
        "there is no room for the helical turns: the tool goes straight down by the infeeds"
        help "the pocket has no room for it; a cutter that cannot plunge breaks";
    tool_goes_down_at_rapid_traverse()
        "the tool goes down at rapid traverse: it needs a hole that was drilled before"
        help "1 in the tens of `_VARI` goes down at the feed for the depth";
    radius_of_helix_is_mm_only_larger(radius)
        "the radius of the helix is {radius} mm only: a larger one leaves a core"
        help "give at most the radius of the cutter as `_RAD1`";
    speed_of_finishing_stays() "the speed of finishing stays, as none stands before the cycle"
        help "program S before the cycle";
    allowance_on_wall_is_mm(room) "the allowance on the wall is {room} mm only: the cutter leaves no room for more"
        help "take a smaller cutter, or a smaller allowance";
    no_corner_radius() "no corner radius: the corners keep the radius of the cutter"
        help "give the radius of the corners";
    blank_is_smaller_than_spigot() "the blank is smaller than the spigot"
        help "give the size of the blank before the cycle";
}

}
