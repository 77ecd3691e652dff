//! `O`: what the target can and cannot say.

super::codes! { OUTPUT:

O1001 Error "feed-not-positive" "feed rate is zero or negative"
"A cutting move with F0 never ends, or raises an alarm. Look where the feed word or the parameter after it is set; the F of a TOOL \
CALL, RND or CHF block counts, too." {
    feed_prints_as_zero_or_not(feed) "the feed {feed} prints as zero or not at all";
    feed_has_to_be_above_zero(what) "{what}: the feed has to be above zero" help "program the feed of this move";
    feed_of_m140_is_not_above_zero() "the feed of M140 is not above zero";
    feed(at) "the feed is {at}";
}

O1002 Error "value-not-finite" "value is too large to print"
"A coordinate, centre or radius is beyond 100 km, another number beyond what can be printed, or a computation overflowed; or a chamfer, rounding or \
arc lies so far out that its end points cannot be computed to the last printed digit. Nothing sensible can be printed, so nothing is. Look at the coordinates and at the \
parameters that the block computes with." {
    axis_of_this_arc_starts_where_nothing() "an axis of this arc starts where nothing was printed for it";
    start_of_this_arc_was_not_printed() "the start of this arc was not printed";
    number_of_this_block_is_too_large() "a number of this block is too large to print";
    number_of_this_block_is_too_large_to() "a number of this block is too large to compute with"
        help "check the coordinates, and the parameters that the block computes with";
}

O1003 Error "thread-lead-not-positive" "thread without a lead or a length"
"A thread is cut by moving the tool by its lead with every turn of the spindle. Here the lead or the whole way is zero, or too small \
or too large to print. Look where the lead is programmed." {
    thread_has_no_length_that_can() "the thread has no length that can be printed";
    lead_of_this_thread_prints_as_zero() "the lead of this thread prints as zero or not at all";
    pitch_of_this_tap_prints_as_zero() "the pitch of this tap prints as zero or not at all";
    tap_has_no_length_that_can() "the tap has no length that can be printed";
}

O1004 Error "speed-prints-as-zero" "spindle speed prints as zero"
"The target reads whole numbers after S, or as many places as `[output] decimals` says, and the speed is below half of the last of them. The spindle would stand \
while the tool cuts. Look at the S of the program; cutting speeds and limits of the speed count, too." {
    speed_prints_as_zero(speed) "the speed {speed} prints as zero, and the spindle would stand"
        asks "program a higher speed, or give `[output] decimals.speed` where the target reads parts of a turn";
}

O1005 Error "wait-prints-as-zero" "wait is shorter than its last printed place"
"The receiver would not wait at all. The wait of the program is above zero and less than half of what the selected target, or `[output] decimals`, can say: half a millisecond where waits are \
whole milliseconds. Look at the number after the wait and at its unit, program a wait that can be said, or leave it out." {
    wait_of_s_prints_as_zero(seconds) "the wait of {seconds} s prints as zero"
        asks "print more places (`[output] decimals = {{ time = 3 }}`), or leave the wait out";
    wait_of_s_prints_as_zero_milliseconds(seconds) "the wait of {seconds} s prints as zero"
        help "the target counts whole milliseconds: program 0.001 s, or leave the wait out";
}

O1006 Warning "feed-or-speed-rounded" "rounding changes a feed, a speed or a lead by more than one per cent"
"The target reads so many places after F, S and the lead of a thread, or `[output] decimals` says so many, and the number of the program has more: 0.01 mm a turn are 0.00039 inch, and 0.0004 with four places. Of a feed per revolution, which has few digits, a tenth of a per cent is told. The first \
one of a program is told. Print more places where the target reads them, or program a number that it can say." {
    prints_as(what, printed, percent, more, key)
        "the {what} prints as {printed}, which is {percent:.1} % {more} than the program says"
        asks "print more places where the target reads them (`[output] {key}`), or program a {what} that can be \
        said";
}

O1007 Error "feed-or-speed-becomes-another" "rounding makes another feed, speed or lead of it"
"The number that is printed would differ from that of the program by more than ten per cent: S0.5 would become S1 where the target counts whole turns, which is twice as fast. Print more \
places where the target reads them (`[output] decimals.feed` and `decimals.speed`), or program a number that it can say." {
    prints_as(what, printed, percent, more, key)
        "the {what} prints as {printed}, which is {percent:.1} % {more} than the program says"
        asks "print more places where the target reads them (`[output] {key}`), or program a {what} that can be \
        said";
}

O2001 Warning "m-function-of-target" "M function that means something on the target"
"`[output] pass_m` lets M functions through as they stand. The target has this one, too, and does with it what the text says, which is hardly \
what the machine of the program did. Take it out of `pass_m` and leave it out of the program, or make the target's machine do what is meant by another number." {
    m_is_printed_as_listed_in_pass(number, does)
        "M{number} is printed as listed in `pass_m`; on the target it {does}";
}

O2002 Warning "work-offsets-not-confirmed" "whether the target knows this work offset is not confirmed"
"The selected target is a preview, made after what published post processors write, and its work offsets are general knowledge. Run the program in the air, and look \
whether the part lies where it should." {
    work_offsets_of_target_are_not_confirmed(target) "work offsets of the target {target} are not confirmed"
        help "look in the air whether the part lies where it should";
}

O2003 Warning "tilt-solution" "the target may take the other position of the rotary axes"
"Most tilted planes are reached by two positions of the rotary axes. The program says which of them it wants (SEQ of PLANE, `_DIR` of CYCLE800), or leaves it to its control. Some \
targets choose by themselves and have no word for it, others count by another axis. The part is the same, the room is not: the table may turn the other way round, and an axis may come to its \
limit. Each kind is told once. Run the program in the air, and look which way the axes turn." {
    target_chooses_by_itself(target, word)
        "the program says by {word} which position the rotary axes take; the target {target} chooses by itself"
        help "look in the air which way they turn: the part is the same, the room is not";
    target_counts_by_another_axis(target, word, own)
        "the program says by {word} which position the rotary axes take; the target {target} counts by another axis \
        ({own})"
        help "look in the air which way they turn: the part is the same, the room is not";
    program_leaves_it_to_its_control(target, own)
        "the program leaves to its control which position the rotary axes take; the target {target} has to be told, and \
        gets {own}"
        help "look in the air which way they turn: the part is the same, the room is not";
}

O2004 Warning "tilt-option" "tilted planes are an option of the target"
"The words for a tilted working plane (G68.2 and G53.1) are an option that not every control of this kind has. Without it the control stops at the first one with an alarm. Where the machine \
has the option, nothing is to be done. Told once, at the first plane." {
    plane_is_an_option(target, word) "{word} is an option of the target {target}"
        help "look whether the machine has it: otherwise its control stops at this block";
}

O2005 Warning "swivel-record" "the name of the swivel record is not known"
"CYCLE800 takes the name of a swivel record: the data of the rotary axes that swivel. The program does not say how it is called at the machine that gets the output, and an empty name stands for the only record \
there. With several of them the control raises an alarm, or swivels by another one. Say its name, or that there is only one." {
    empty_name_of_swivel_record()
        "CYCLE800 is printed with an empty name, which stands for the only swivel record of the machine"
        asks "say its name: `[machine] swivel_record = \"TC1\"`, or `\"\"` where there is only one";
}

O4001 Note "arc-as-lines" "arc is printed as straight lines"
"The arc is so small or so flat that its printed numbers cannot describe a circle within the tolerance of the target: \
after rounding, start and end lie at different distances from every possible centre. It is printed as lines that leave the arc \
by less than half a printed unit." {
    arc_is_flatter_than_target_computes()
        "the arc is flatter than the target computes exactly and is printed as lines";
    arc_is_too_small_for_its_printed_numbers() "the arc is too small for its printed numbers and is printed as lines";
}

O4002 Note "arc-rounded-away" "arc is shorter than the last printed digit"
"Start and end of the arc print as the same numbers. A control would take that for a full circle, so the arc is left out; \
the path differs by less than the last printed digit." {
    arc_is_shorter_than_last_printed_digit() "the arc is shorter than the last printed digit and is left out";
}

O4003 Note "work-offset-as-preset" "work offset is printed as a preset, or as another one"
"A TNC has a preset table instead of work offsets. G54 to G59.3 are printed as cycle 247 with the presets 1 to 9, as partc reads them. Set the part up in that line of the \
preset table. From the seventh on, offsets are G54.1 P1 to P48 on a Fanuc and G154 P1 to P99 on a Haas; after G57 they are G505 to G599 on a SINUMERIK, and on an Okuma \
all are G15 H1 to H9." {
    work_offset_is_printed_as_preset(number, word) "the work offset is printed as preset {number} ({word})";
    work_offset_is_printed(word) "the work offset is printed as {word}";
}

O4004 Note "arc-as-lines-within-tolerance" "arc that the target cannot say is printed as lines"
"`[output] arc_fallback_tolerance` allows lines for arcs that the selected target cannot say, and says how far they may leave the arc. The ends are exact." {
    is_printed_as_lines_that_leave(what, most) "{what} is printed as lines that leave it by at most {most} mm";
}

O4006 Note "path-control-left-out" "how the program takes its corners is left out"
"The program says how corners are taken (exact stop, a tolerance, G64), and `[output] path_control = \"none\"` keeps all words of it out of the output. The machine takes \
its corners as it is set up. Leave the key away, and what the program says is printed." {
    how_program_takes_its_corners_is_left()
        "how the program takes its corners is left out: `[output] path_control` is \"none\"";
}

O4005 Warning "compensation-begins-at-rapid" "radius compensation of the target begins in a rapid move"
"`[output] compensation = \"control\"`, and the move that leads to the contour is a rapid one. Each control has its own way to the first element: LinuxCNC \
for one goes at rapid traverse to a place beside the contour that may lie farther along it, where the tool cuts already. Lead to the contour at a feed (F in the block of \
G41, G42, RL or RR), or have partc compute the path: `compensation = \"resolve\"`." {
    radius_compensation_begins_in_rapid_move()
        "radius compensation begins in a rapid move: where the target goes beside the contour is its own choice"
        asks "lead to the contour at a feed, or set `[output] compensation = \"resolve\"`";
}

O4007 Warning "chip-removed-for-broken" "the tap leaves the hole to break the chip"
"The program breaks the chip of a tapped hole by a short way back within the hole. The tapping word of the selected target always goes back to where it began, so the hole is tapped in several strokes, each deeper than the one before and each out of the hole again. The chip is removed where it would have been broken, and it takes longer. Where the strokes meet in one thread only if the spindle is set up for it, O4009 says so. State that you want it so: `[output] tapping = \"as-target\"`." {
    chip_is_broken_within_hole()
        "the chip is broken within the hole, and the target's tap always comes back to where it began: each step \
        leaves the hole"
        asks "where that is meant, set `[output] tapping = \"as-target\"`";
}

O4008 Warning "tap-without-detail" "the tap is printed without a detail"
"The tapping word of the selected target has no place for a detail that the program gives: the dwell at the bottom, another speed for the way out, the speed of the way down to the last depth, or the angle of the spindle at which the thread begins. Depth, pitch and hand of the thread are exact. Take the detail out of the program, or see that nothing depends on it; `[output] tapping = \"as-target\"` says that it may be left out." {
    tap_of_target_has_no_word(details) "the target's tap has no word for {details}, left out here"
        asks "where that is meant, set `[output] tapping = \"as-target\"`";
}

O4009 Warning "tap-steps-have-to-meet" "the steps of a tap meet only where the spindle begins at one angle"
"The program taps a hole in several steps (chip breaking or chip removal: CYCLE84, cycle 209, G331 and G332). The tapping cycle of the selected target always goes back to where it began, so each step is a tap of its own. All of them cut one thread only if the spindle begins each at the same angle, and that is a setting of the machine: on a Haas setting 133 (REPT RIGID TAP), on a Fanuc what rigid tapping keeps while it stays on, and parameter 5202. Check it in the air or in scrap, or tap in one step. `[output] tapping = \"as-target\"` says that the machine is set up for it." {
    hole_is_tapped_in_steps(count, meets)
        "the hole is tapped in {count} steps out of the hole, and they cut one thread only where the spindle begins \
        each of them at the same angle: {meets}"
        asks "where that is meant, set `[output] tapping = \"as-target\"`";
}

O9001 Error "word-unknown-to-target" "the target has no word for this"
"The program asks for something that the selected target cannot express. Choose another target or change the program."

O9002 Error "spindle-speed-negative" "spindle speed is negative"
usual "the sense of rotation comes from M3 or M4, the speed is positive"
"The sense of rotation comes from M3 or M4, the speed is positive. Look where the S word or its parameter is set." {
    spindle_speed(speed) "the spindle speed is {speed}";
    speed(num) "the speed is {num}";
}

O9003 Error "compensation-by-target" "not possible under the target's radius compensation"
"With `[output] compensation = \"control\"` the target offsets the contour between G41 or G42 and G40. Meanwhile it takes no block in \
machine coordinates, no change of plane or side, no arc outside the working plane, and no contour that goes on after a tool change or \
work offset; and it compensates in some planes only. Most targets end it in a straight move alone, and look ahead over one block that moves nothing in the plane, not over two. The target would stop there with an alarm, so nothing is written. End the compensation before the block, \
or let partc compute the tool path with `compensation = \"resolve\"`." {
    stop_stands_in_compensated_contour(target)
        "a stop stands in the compensated contour, and the target {target} does not read on beyond it"
        asks "put it before the contour or after it, or set `[output] compensation = \"resolve\"`";
    second_block_that_moves_nothing_in_working()
        "a second block that moves nothing in the working plane stands in the compensated contour"
        asks "put it before the contour or after it; comments count (`[output] comments = false`)";
    target_has_no_word_for_radius_compensation(target)
        "the target {target} has no word for radius compensation that begins or ends in a transformed move"
        asks "set `[output] compensation = \"resolve\"`";
    how_corners_are_taken_changes_while_radius(name)
        "how corners are taken changes while radius compensation is on, and the target {name} does not change it \
        there"
        asks "let it change before the contour or after it, or set `[output] compensation = \"resolve\"`";
    radius_compensation_is_on_at_block()
        "radius compensation is on at a block that ends it, and the target ends it in a straight move only"
        help "move away from the contour without compensation before this block";
    begins_or_ends_in_block_that_does_not_move()
        "radius compensation begins or ends in a block that does not move in the working plane"
        help "begin and end it in a block that moves from beside the contour to it, or away";
    ends_before_contour_has_element()
        "radius compensation ends before the contour has an element: there is no direction to stand beside"
        help "program one element of the contour at least between the two blocks";
    target_needs_straight_move_to_end()
        "the target needs a straight move to end its radius compensation, and this block is an arc"
        help "put a straight block without compensation before the arc";
    cannot_go_on_after_tool_change()
        "radius compensation cannot go on after a tool change, work offset or plane change"
        help "end the compensation before that block and start it again after it";
    target_does_not_compensate_in_this_plane() "the target does not compensate the tool radius in this working plane"
        asks "set `[output] compensation = \"resolve\"`, or take another target";
    side_changes_while_it_is_on() "the side of the radius compensation changes while it is on"
        help "end the compensation before the side changes or the mirror begins";
    working_plane_changes() "the working plane changes under radius compensation"
        asks "end the compensation before this block, or set `[output] compensation = \"resolve\"`";
    cannot_start_in_arc() "radius compensation cannot start in an arc"
        help "put a straight block with compensation before the arc";
    block_in_machine_coordinates_cannot_run()
        "a block in machine coordinates cannot run under the target's radius compensation"
        asks "end the compensation before this block, or set `[output] compensation = \"resolve\"`";
    thread_cannot_be_cut() "a thread cannot be cut under the target's radius compensation"
        asks "end the compensation before this block, or set `[output] compensation = \"resolve\"`";
    arc_outside_working_plane_cannot_run()
        "an arc outside the working plane cannot run under the target's radius compensation"
        asks "end the compensation before this block, or set `[output] compensation = \"resolve\"`";
}

O9190 Error "tool-length-not-along-z" "tool length does not act along Z"
"`[output] tool_length = \"G43\"` has the target add the length of the tool, by G43 H, or by its own word (G56 H on an Okuma, D1 on a SINUMERIK), and that adds it to Z. Under G18 and G19, and with \
another tool axis in a TOOL CALL, the control counts it along another axis, so the tool would stand wrong by its length in both. Set the key to \"off\", which holds without it on linuxcnc alone, and set the \
length up on the target. The call of a tool brings its length on some targets (heidenhain): \"off\" fits there only where \
the length is zero in its table." {
    with_tool_axis_length_of_tool_acts(axis, who)
        "with the tool axis {axis} the length of the tool acts along it, and {who} adds it to Z";
    outside_g17_length_of_tool_does_not(who, way)
        "outside G17 the length of the tool does not act along Z, to which {who} adds it"
        asks "{way}, or program the block under G17";
    under_length_of_tool_acts_along(plane, third, who)
        "under {plane} the length of the tool acts along {third}, and {who} adds it to Z";
}

O9100 Error "compensation-way-too-short" "move to or from the compensated contour is shorter than the tool radius"
"With `compensation = \"control\"` the target compensates the radius of the tool, and it takes the way to the contour only if that is longer \
than the radius. A way from the contour shorter than the radius ends with the tool over the contour. The radius is known from `[tools]`, the tool \
table, TOOL DEF or an oversize. Program the block farther from the contour." {
    move_that_leaves_contour(length, radius)
        "the move that leaves the compensated contour is {length:.4} mm long, and the tool radius is {radius:.4} mm"
        help "begin farther from the contour, or end farther away, so that the whole tool stands beside it";
    move_that_leads_to_contour(length, radius)
        "the move that leads to the compensated contour is {length:.4} mm long, and the tool radius is {radius:.4} \
        mm"
        help "begin farther from the contour, or end farther away, so that the whole tool stands beside it";
}

}
