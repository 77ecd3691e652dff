//! Face and mantle: transformations and driven spindles.

super::codes! { TRANSFORMATION:

G3336 Error "feed-spindle-speed" "feed counts turns of a spindle without a speed"
"A feed per revolution follows a spindle that is not the first one of the target. It is printed per minute, feed times speed, so the speed has to be \
programmed before the cut." {
    feed_counts_turns_of_spindle(number) "the feed counts turns of spindle {number}, whose speed is not known"
        help "program its speed before this block: S{number}=1000";
}

G3337 Error "transformation-pole" "way passes the axis of rotation"
"Where the tool passes the axis of rotation of a face closer than 0.01 mm, the workpiece would have to turn over at once. Controls have ways of their own \
around this pole, which are not reproduced. Lead the tool around it." {
    way_passes_axis_of_rotation(closest)
        "the way passes the axis of rotation at {closest:.4} mm: the workpiece would turn over at once";
}

G3338 Error "transformation-start" "place inside a transformation is not known"
"A cut on a face or mantle becomes a motion of X and the rotary axis, which depends on where it starts. Position the tool by G0 with all coordinates of the \
face or mantle first, or say where the rotary axis stands before the transformation." {
    this_block_cuts_from_place_not_known() "this block cuts from a place that is not known inside the transformation"
        help "position the tool before it by G0 with X and Y (on a mantle Y), or the rotary axis before the \
        transformation";
    where_this_block_leads_depends() "where this block leads depends on X and Y, and one of them is not known"
        help "program both in this block or before it";
}

G3339 Error "transformation-inside" "what a transformation cannot carry out"
"Inside a transformation X and the rotary axis follow X and Y of the program. Machine coordinates, threads, the rotary axis itself, other axes beside them and \
feeds per turn of the workpiece spindle cannot be carried out there." {
    frame_shifts(letter) "the frame shifts {letter}, which the transformation moves"
        help "turn the plane by ROT instead of {letter}";
    hole_is_tapped_inside() "a hole is tapped inside the transformation, which takes the spindle as an axis"
        help "tap it outside of the transformation";
    is_moved_by_transformation_and_block(letter) "{letter} is moved by the transformation and by this block"
        help "program X and Y";
    place_of_machine_is_approached() "a place of the machine is approached inside the transformation"
        help "end the transformation first";
    target_cannot_compensate_tool() "the target cannot compensate the tool inside the transformation"
        asks "leave `[output] compensation` at \"resolve\"";
    thread_in_step_with_spindle() "a thread in step with the spindle"
        help "cut the thread outside of the transformation";
    feed_counts_turns_of_first_spindle()
        "the feed counts turns of the first spindle, which the transformation turns as an axis"
        help "program a feed per minute (G94), or make the driven spindle the master";
    another_axis_moves_together(axes) "another axis moves together with {axes}" help "move it in a block of its own";
    plane_is_tilted() "the working plane is tilted inside the transformation"
        help "end the transformation first";
    this_way_takes_more_parts(most) "this way takes more than {most} parts"
        help "keep the way farther from the axis of rotation, or divide it";
}

G3340 Error "tilt-beside-part" "rotary axes turn, and the tool was not taken away"
"Where rotary axes turn, they turn the part or the tool, and what lies in between is not known. They turn only where the program took Z to a place of the \
machine before, and moved main axes in machine coordinates alone since then, or where the configuration says to which place the tool goes first." {
    rotary_axes_turn_beside_part() "rotary axes turn here, and the tool was not taken to a place of the machine before"
        asks "take Z to a place of the machine before it (`L Z-1 R0 FMAX M91`, `SUPA G0 Z0 D0`), or give that place in \
        machine coordinates: `[machine] swivel_retract`";
}

G3341 Warning "tilt-limits" "travel limits are not checked in a tilted plane"
"Which places of the axes a tilted plane leads to is known at the machine. As long as one is on, moves are not held against `[machine] limits`." {
    limits_are_not_checked() "from here on moves are not held against the travel limits: the working plane is tilted"
        help "have the machine or its simulation check them";
}

S2280 Error "siemens-transformation-call" "argument of a transformation"
"TRANSMIT takes the number of the transformation, TRACYL the working diameter, that number and the correction of groove walls. Only the first \
transformation without wall correction is compiled: which axes another one uses is data of the machine." {
    which_axes_tracyl_uses_on_milling_machine()
        "which axes TRACYL uses on a milling machine, only the machine knows"
        asks "set `[machine] kind = \"lathe\"` if the tool points along X to a workpiece that turns about Z";
    working_diameter_of_tracyl(given) "the working diameter of TRACYL is {given}"
        help "give the diameter at which Y counts: TRACYL(80)";
    tracyl_corrects_walls_of_groove_by_real() "TRACYL corrects the walls of a groove by a real Y axis"
        help "leave the third argument out, and program the path of the tool's centre";
    selects_transformation(word, number)
        "{word} selects transformation {number}: which axes it uses, only the machine knows"
        help "select the first one, or compile the face in Cartesian axes";
}

S2281 Error "siemens-transformation-switch" "transformation begins or ends where it cannot"
"TRANSMIT, TRACYL and TRAFOOF want radius compensation off. What becomes of a frame in force is machine data (MD 10602): program it after the switch, or set \
`[control] md10602 = 1` if the control keeps it. A real Y axis has to stand at 0." {
    y_axis_stands_at_where_x(y) "the Y axis stands at {y} where X and the rotary axis take over"
        help "program Y0 before it";
    frame_is_in_force_where_axes_change()
        "a frame is in force where the axes change, and the control may delete it (MD 10602)"
        asks "program the frame after this block (TRANS without values before it), or set `[control] md10602 = \
        1` if it stays on the machine";
    radius_compensation_is_on_where_axes_change() "radius compensation is on where the axes change"
        help "program G40 with a straight move before it";
}

S2282 Error "siemens-transformation-cycle" "turning cycle inside a transformation"
"Turning cycles work on a turning contour and are not possible between TRANSMIT or TRACYL and TRAFOOF; the control raises alarm 61020." {
    is_not_possible_while_transmit_or_tracyl(name) "{name} is not possible while TRANSMIT or TRACYL is on" alarm 61020
        help "program TRAFOOF before it";
}

S2283 Error "siemens-swivelled" "what cannot change while the working plane is swivelled"
"Under a swivelled plane positions count in it, and rotary axes stand as it wants. What lies outside of it, the work offset and the axes of a transformation, stays \
until the plane is off. What becomes of TRANS or ROT where CYCLE800() ends the plane is not confirmed: end it before." {
    work_offset_changes(word) "{word} changes the work offset while the working plane is swivelled"
        help "swivel back before it: CYCLE800 with angles of 0";
    save_brings_work_offset_back() "the program with SAVE brings another work offset back while the working plane is swivelled"
        help "swivel back before its end: CYCLE800 with angles of 0";
    frame_of_offset_changes(word) "`{word}` changes the frame under the swivelled working plane"
        help "swivel back before it: CYCLE800 with angles of 0";
    axes_are_transformed(word) "{word} begins while the working plane is swivelled"
        help "swivel back before it: CYCLE800 with angles of 0";
    programmed_frame_is_in_force_where_plane_ends()
        "CYCLE800 ends the swivelled plane, and TRANS, ROT, SCALE or MIRROR is active in it"
        help "program TRANS without axes before CYCLE800, and the frame again after it";
}

S8255 Warning "siemens-swivel-direction" "copy of the direction of a swivel says otherwise"
"The screen of CYCLE800 keeps its choice of the direction in `_ST` too (100000 for minus, 200000 for plus). The control goes by `_DIR`, and so does partc. Where the two \
contradict each other, the call was changed by hand: check which solution is meant." {
    st_says_otherwise_than_dir(state, direction)
        "`_ST` {state} (argument 3) keeps another direction than `_DIR` {direction} (argument 14), which decides"
        help "accept the call in the editor again, or write 0 or 1 as `_ST`";
}

S8250 Note "siemens-transformation-virtual" "face or mantle is printed in Cartesian axes"
"With `[cycles] transmit = \"cartesian\"` the moves between TRANSMIT or TRACYL and TRAFOOF are printed as programmed, in axes that the program sees. The \
machine needs X and Y, or a control that transforms by itself." {
    face_machining_in_virtual_cartesian_axes(word)
        "{word}: face machining in virtual Cartesian axes; needs a machine with X, Y or a control transformation";
}

S8251 Note "siemens-transformation-axes" "face or mantle is printed with the rotary axis"
"With `[cycles] transmit = \"polar\"` X is the distance from the axis of rotation and the rotary axis turns the workpiece. X0 and the zero of the rotary axis \
in the work offset of the target have to be those of the control; each block has the F by which the contour has the programmed feed." {
    is_printed_with_x(word, letter, zero)
        "{word} is printed with X and {letter}: X0 lies on the axis of rotation, and {zero}";
}

S8252 Warning "siemens-transformation-diameter" "diameter programming on a face"
"Under DIAMON the X of a face is read as a diameter, as everywhere. Most programs for faces are written in radii: program DIAMOF after TRANSMIT, or check \
the picture." {
    diameter_programming_is_on_at_transmit()
        "diameter programming is on at TRANSMIT: X of the face is read as a diameter";
}

S8253 Note "siemens-feed-per-minute" "feed per revolution of a driven spindle"
"Targets count the turns of their first spindle. While another one is the master, G95 F is printed per minute: F times the speed in force at the cut." {
    feed_per_revolution_of_spindle(master)
        "the feed per revolution of spindle {master}, the master, is printed per minute";
}
}
