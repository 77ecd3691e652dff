//! `O93`: what the selected target has no word for, or reads otherwise.

super::codes! { TARGET:

O9300 Error "thread-unknown-to-target" "the target cuts no threads"
"A thread is cut in step with the spindle (G33, and the tapping and threading cycles that end in it), and the selected target moves its axes \
without looking at the spindle. Cut the thread on another machine, mill it, or tap with a floating holder at a feed in mm/min that you compute yourself." {
    target_has_no_word_for_thread(target) "the target {target} has no word for a thread in step with the spindle"
        help "cut the thread another way, or take a target that turns the spindle in step";
}

O9301 Error "feed-unknown-to-target" "the target has no such kind of feed"
"The program states its feed per revolution (G95) or by time (G93), and the selected target takes feeds in mm/min alone. A feed per revolution is not \
converted: the speed of the spindle is only nominal, and under constant cutting speed it changes. Program the feed in mm/min." {
    target_has_no_word_for_feed_per_revolution(target) "the target {target} has no word for feed per revolution"
        help "program the feed in mm/min, or take another target";
    target_has_no_word_for_feed_by_time(target) "the target {target} has no word for feed by time"
        help "program the feed in mm/min, or take another target";
}

O9302 Error "cutting-speed-unknown-to-target" "the target keeps no constant cutting speed"
"Under constant cutting speed (G96) the spindle turns faster on a smaller diameter. The selected target knows speeds in rev/min alone. Program a speed in rev/min." {
    target_has_no_word_for_constant_cutting(target) "the target {target} has no word for constant cutting speed"
        help "program a constant speed with G97 in the source, or take another target";
}

O9303 Error "spindle-angle-unknown-to-target" "the target does not stop its spindle at an angle"
"M19 and SPOS stop the spindle at an angle, for a boring bar or a tool change (directly before G331, SPOS is the angle of the tap, and O4008 tells where it is left out). The selected target starts and stops its spindle and knows nothing of its angle. \
Leave the function out if nothing depends on the angle; a boring bar that lifts off needs another machine." {
    target_has_no_word_for_spindle_stop(target) "the target {target} has no word for a spindle stop at an angle"
        help "leave the stop at an angle (M19, SPOS=) out where nothing depends on it, or take another target";
}

O9304 Error "spindle-unknown-to-target" "the target has one spindle"
"The program speaks to a second spindle or a driven tool. The selected target has words for one spindle. Program the first one, or choose another target." {
    target_has_no_word_for_spindle(target, number) "the target {target} has no word for spindle {number}"
        help "program the first spindle, or take another target";
}

O9305 Error "tool-change-unknown-to-target" "the target changes no tools"
"The selected target refuses M6. With `[output] tool_change = \"stop\"` a change is printed as a spindle stop, a comment and a program stop, and you change by \
hand; the next tool must then have the same length, or the target does not know where its tip is. Or write one program a tool and set each tool up." {
    target_has_no_word_for_tool_0(target) "the target {target} has no word for tool 0"
        help "a turret has no empty place: leave tool 0 out";
    target_has_no_word_for_tool_change(target) "the target {target} has no word for a tool change"
        asks "set `[output] tool_change = \"stop\"` to change by hand, or write one program a tool";
}

O9306 Error "tool-number-too-large" "the target does not count tools that far"
"The number of the tool is larger than the selected target takes. Give the tool a smaller one: in the program, or as `number` of its entry in `[tools]`." {
    tool_target_counts_tools(number, target, most) "tool {number}: the target {target} counts tools to {most}"
        help "give the tool a smaller number in the program or with `number` in `[tools]`";
}

O9307 Error "tool-length-unknown-to-target" "the target has no table of tool lengths"
"With `[output] tool_length = \"G43\"` the target adds the length of the tool from its own table, and the selected target has none. Leave the key at \"off\" and set up the \
length on the target, for instance by touching the part off with every tool." {
    target_has_no_word_for_tool_0(target) "the target {target} has no word for tool 0"
        help "leave tool 0 out: nothing takes a length back";
    target_has_no_word_for_length_of_tool(target)
        "the target {target} has no word for the length of a tool in its table"
        asks "leave `[output] tool_length` at \"off\", and set the length up on the target";
}

O9308 Error "compensation-unknown-to-target" "the target does not compensate the tool radius"
"With `[output] compensation = \"control\"` the target offsets the contour by the radius of the tool (G41, G42), and the selected target cannot, or not by this radius: an oversize of the program is not in its table. Program the path of the \
tool centre, or choose a target that compensates." {
    target_has_no_word_for_radius_compensation(target) "the target {target} has no word for radius compensation"
        help "program the path of the tool centre, or take a target that compensates";
    target_has_no_word_for_tool_radius_with_oversize(target)
        "the target {target} has no word for a tool radius with an oversize of the program"
        asks "put the oversize into the tool table of the target, or set `[output] compensation = \"resolve\"`";
    target_has_no_word_for_radius_of_tool_without_d(target)
        "the target {target} has no word for the radius of a tool whose D it does not print"
        asks "call the tool in the program, and leave `[output] tool_length` away: D1 brings the radius, too";
    target_has_no_word_for_radius_of_tool_0(target) "the target {target} has no word for the radius of tool 0"
        help "call a tool before the contour";
}

O9309 Error "axis-unknown-to-target" "the target does not have this axis"
"The selected target moves X, Y and Z. A rotary or a parallel axis has no letter there, or it is a matter of the machine which way it turns and what F counts; leaving it out would cut on \
the wrong side of the part. Split the program \
where the axis turns and turn it by hand, or choose another target." {
    target_has_no_word_for_axis(target, letter) "the target {target} has no word for the axis {letter}"
        help "turn the axis by hand between programs, or take another target";
    target_has_no_word_for_axes(target, letters) "the target {target} has no word for the axes {letters}"
        help "turn the axis by hand between programs, or take another target";
}

O9310 Error "work-offset-unknown-to-target" "the target does not have this work offset"
"Work offsets are selected by their number, and the selected target has fewer of them. Select another one in the program, or map the preset to another word in `[datums]`." {
    target_has_no_word(target, said, printed, range)
        "the target {target} has no word for {said}{printed}: it has {range}";
    target_has_no_work_offsets(target, said)
        "the target {target} has no work offsets, and the program selects {said}"
        help "take the word out: positions count from where the part is set up on the machine";
    target_has_no_word_for_this_work_offset(target, range) "the target {target} has no word for this work offset"
        help "set the part up in one of {range}";
    target_has_no_word_for_any_work_offset(target) "the target {target} has no word for this work offset"
        help "take the word out: positions count from where the part is set up on the machine";
}

O9311 Error "mist-unknown-to-target" "the target has no mist coolant"
"The selected target refuses M7 as it is delivered. Cool with M8, or leave M7 out and switch the mist by hand." {
    target_has_no_word_for_mist(target) "the target {target} has no word for mist"
        help "cool with M8, or leave the mist out and switch it by hand";
}

O9312 Warning "optional-stop-without-effect" "the target does not stop at an optional stop"
"The selected target reads M1 and goes on, as a control does with its switch off. If the operator has to measure or to clamp anew at this place, program M0." {
    target_reads_optional_stop(target) "the target {target} reads the optional stop and does not stop"
        help "program M0 where the operator has to act";
}

O9313 Error "m-function-unknown-to-target" "the target does not have this M function"
"`[output] pass_m` lets M functions through as they stand, and the selected target refuses all that it does not know. Take the function out of `pass_m` and leave it out \
of the program, or choose a target that a machine builder can extend." {
    target_has_no_word_for_m_function(target, number) "the target {target} has no word for M{number}"
        asks "take it out of `[output] pass_m`, and leave it out of the program";
}

O9314 Error "number-longer-than-read" "number has more digits than the target reads"
"The selected target drops all digits of a number after the eighth without a word, so the axis would stop elsewhere. Print fewer places with `[output] decimals`; a path of \
more than ten metres needs a target that computes in double precision." {
    target_reads_digits_of_number(digits, line) "the target reads {digits} digits of a number, and `{line}` has more"
        asks "check the value, or print fewer places with `[output] decimals`";
    target_reads_digits_before_point(digits, whole, line)
        "the target reads {digits} digits of a number, {whole} of them before the point, and `{line}` has more"
        asks "check the value, or print fewer places with `[output] decimals`";
}

O9315 Error "diameter-unknown-to-target" "the target does not take X as a diameter"
"`[output] diameter = true` prints X of a lathe as a diameter, which needs a word that tells the target so (G7). The selected target has none and takes X as a radius. Leave the key away." {
    target_has_no_word_for_x_as_diameter(target) "the target {target} has no word for X as a diameter"
        asks "leave `[output] diameter` away: X is printed as a radius";
}

O9316 Error "spindle-stands-after-change" "cut with the spindle that a tool change by hand stopped"
"With `[output] tool_change = \"stop\"` the spindle is stopped (M5) before you change the tool. The program cuts after the change and starts no spindle: the control \
may have kept it turning, or started it in its own tool change, and which of the two is not written in the program. Program M3 or M4 after the change, or M5 where the \
tool has to stand, such as a probe." {
    this_block_cuts() "this block cuts, and the spindle stands since the tool change by hand"
        help "program M3 or M4 after the change, or M5 where the tool has to stand";
}

O9317 Error "machine-kind-unknown-to-target" "the target is made for another kind of machine"
"A lathe and a mill of one control speak differently: on many lathes X is always a diameter, and words such as G90 and G94 start cycles. Take the target that belongs \
to the machine, or correct `[machine] kind`; where X is always a diameter, leave `[output] diameter = false` away." {
    target_has_no_word_for_x_as_radius(target) "the target {target} has no word for X as a radius"
        asks "leave `[output] diameter` away: X is printed as a diameter";
    target_has_no_word_for_lathe(target) "the target {target} has no word for a lathe"
        asks "take the target for lathes, or set `[machine] kind = \"mill\"`";
    target_has_no_word_for_mill(target) "the target {target} has no word for a mill"
        asks "take the target for mills, or set `[machine] kind = \"lathe\"`";
}

O9318 Error "tool-length-begins-in-such-a-block" "the tool length cannot begin in this block"
"The selected target takes the length of a tool (G43 H) in a straight move along Z: alone in a block, some controls move by the length. The first block after the tool change \
that moves Z is an arc, a thread or a transformed move. Put a straight move along Z before it." {
    target_has_no_word_for_length(target)
        "the target {target} has no word for the length of a tool that begins in such a block"
        help "move along Z in a straight block after the tool change";
}

O9319 Error "quantity-unknown-in-inches" "the quantity is not printed in inches"
"With `[output] units = \"inch\"` a feed counts inches, and in a move of a rotary axis alone it would count degrees; a cutting speed would count feet. Controls differ in \
both, so neither is converted. Set `units = \"mm\"`." {
    target_has_no_word_for_rotary_axis_in_inches(target)
        "the target {target} has no word for a rotary axis at a feed in inches"
        asks "set `[output] units = \"mm\"`";
    target_has_no_word_for_cutting_speed_in_feet(target) "the target {target} has no word for a cutting speed in feet"
        asks "set `[output] units = \"mm\"`, or program a constant speed with G97";
}

O9320 Error "tool-preparation-unknown-to-target" "the target cannot bring a tool forth before its change"
"A T word without a change tells the changer which tool comes next. On the selected target a T word is the change itself (T0101), so the turret would turn at once. Leave the \
word out of the program." {
    target_has_no_word_for_tool(target)
        "the target {target} has no word for a tool that is brought forth before its change"
        help "leave the T word out that only brings the tool forth, or take another target";
}

O9321 Error "machine-coordinates-unknown-to-target" "the target does not move so in machine coordinates"
"G53, M91 and SUPA name a place in machine coordinates. The selected target has no word for it, or takes it at rapid traverse only. Go there at rapid traverse or by hand, or program \
the place in workpiece coordinates." {
    target_has_no_word_for_move_in_machine_coordinates_at_feed(target)
        "the target {target} has no word for a move in machine coordinates at a feed"
        help "go there at rapid traverse or by hand, or program the place in workpiece coordinates";
    target_has_no_word_for_machine_coordinates(target) "the target {target} has no word for machine coordinates"
        help "go there at rapid traverse or by hand, or program the place in workpiece coordinates";
}

O9322 Error "tapered-thread-unknown-to-target" "the target takes the lead of a thread along one axis"
"partc has the lead of a thread along its way. The selected target counts it along the axis with the longer way, and where both are alike controls differ. Cut the thread along one \
axis, or take another target." {
    target_has_no_word_for_thread_along(target) "the target {target} has no word for a thread along two axes"
        help "cut the thread along one axis, or take a target that takes its lead along the way";
}

O9323 Error "speed-limit-stays" "the target keeps its largest speed"
"Under constant cutting speed the largest speed holds on the selected target until the next one (G50 S, G92 S), and nothing takes it back. The program asks for a cutting speed without a \
limit after one with a limit. State the limit with each." {
    target_has_no_word_for_constant_cutting(target)
        "the target {target} has no word for a constant cutting speed without a largest speed after one that had it"
        help "state the largest speed with each constant cutting speed (LIMS, G92 S)";
}

O9324 Error "program-number-too-large" "the target does not count programs that far"
"The selected target names a program by a number of few digits. Give a smaller `[output] program_number`." {
    program_number(number, target, most) "program number {number}: the target {target} counts programs to {most}"
        asks "give a smaller `[output] program_number`";
}

O9325 Error "thread-behind-stopped-spindle" "the target cannot turn the spindle round between two threads"
"Tapping in step with the spindle is a thread down, a spindle that turns round, and a thread up. The selected target takes threads one after the other only where nothing happens \
between them (SINUMERIK alarm 10600). Tap by a cycle of the target, or with a floating holder at a feed in mm/min." {
    target_has_no_word_for_thread(target)
        "the target {target} has no word for a thread after a thread with another function between them"
        help "tap by a cycle of the target, or with a floating holder at a feed in mm/min";
}

O9326 Error "places-not-read" "the target reads fewer places"
"`[output] decimals` asks for more places of a length, or of a wait, than the selected target reads. Print fewer." {
    decimals_target_reads_places_of_wait(target, most, time)
        "`decimals`: the target {target} reads {most} places of a wait, not {time}"
        help "print fewer places";
    decimals_target_reads_places_of_length(target, most, places)
        "`decimals`: the target {target} reads {most} places of a length, not {places}"
        help "print fewer places";
}

O9327 Error "change-by-hand-unknown-to-target" "a change by hand would bring no length"
"With `[output] tool_change = \"stop\"` a change is a spindle stop, a comment and a program stop. On the selected target the block that calls a tool brings its length and \
its radius, too, and without it those of the last tool count. Leave the key away: where there is no changer, the control stops at TOOL CALL (heidenhain); on a lathe T0101 turns the turret; on a \
SINUMERIK `tool_length = \"off\"` prints no D1, and the lengths of all tools have to be alike then." {
    target_has_no_word_for_change_by_hand(target)
        "the target {target} has no word for a change by hand, for a tool brings its length with its block"
        asks "leave `[output] tool_change` away: the target calls the tool itself";
}

O9328 Error "arc-plane-unknown-to-target" "the target goes round in other planes"
"The selected target takes arcs in XY alone (uccnc, klipper, marlin), helices in XY alone (heidenhain), or no helices at all (marlin, where a bed that is levelled by a mesh drops Z), \
as far as is confirmed. With `[output] arc_fallback_tolerance = 0.005` such an arc is printed as lines \
that leave it by at most so many millimetres; or choose another target." {
    target_has_no_word_for_helix_in_this_plane(target) "the target {target} has no word for a helix in this plane"
        asks "set `[output] arc_fallback_tolerance` in partc.toml: how far lines may leave it, in mm";
    target_has_no_word_for_helix_in_every_build(target) "the target {target} has no word for a helix, in every build"
        asks "set `[output] arc_fallback_tolerance` in partc.toml: how far lines may leave it, in mm";
    target_has_no_word_for_arc_in_this_plane(target) "the target {target} has no word for an arc in this plane"
        asks "set `[output] arc_fallback_tolerance` in partc.toml: how far lines may leave it, in mm";
}

O9329 Warning "block-numbers-of-target" "the target numbers its blocks by itself, or not at all"
"On the selected target every block has a number, counted from 0 by 1 (heidenhain), or a number would want a checksum (klipper, marlin), so `[output] line_numbers` and \
`--numbers` change nothing. Leave them away." {
    target_numbers_every_block(target) "`line_numbers`: the target {target} numbers every block by itself"
        help "leave the key away";
    target_takes_no_numbers_of_blocks(target) "`line_numbers`: the target {target} takes no numbers of blocks"
        help "leave the key away";
}

O9331 Error "dwell-unit-is-a-setting" "what a wait counts is a setting of the receiver"
"A setting of the receiver says whether the number after G4 P counts seconds or milliseconds. Look there, and set `[output] dwell_unit`: a wait of half a second would take eight minutes, or \
none, otherwise." {
    seconds_or_milliseconds(target)
        "seconds or milliseconds: a setting of the target {target} says what a wait counts"
        asks "set `[output] dwell_unit` as the receiver is set";
}

O9332 Error "inches-unknown-to-target" "the target counts millimetres only"
"`[output] units = \"inch\"` prints lengths in inches, and the selected target refuses G20, or does not know it in every build. Leave the key away: a program in inches is printed in \
millimetres." {
    target_has_no_word_for_inches(target) "the target {target} has no word for inches"
        asks "set `[output] units = \"mm\"`, or leave the key away";
}

O9333 Error "rapid-feed-is-missing" "rapid traverse has no feed of its own on the target"
"Klipper and Marlin carry out G0 at the last F, so after a cut a rapid move would creep, and after a fast one the next cut would race. Every rapid move is printed with the F of \
`[output] rapid_feed` in mm/min, and every cut after it with its own. Set the key to what the machine can do." {
    on_target_rapid_traverse_goes_at_last(target)
        "on the target {target} rapid traverse goes at the last F, and none is configured"
        asks "set `[output] rapid_feed` in mm/min, such as 3000";
}

O9334 Error "m-function-is-a-macro" "the target has this M function as a macro only"
"Klipper knows no M3, M5, M8 or M0 unless its configuration has a macro of that name; Marlin has them as options of its build. A receiver that does not know the function says so and goes on, \
with a spindle that stands. Where the machine has the function, list it in `[output] pass_m`; the S of M3 and M4 must count rev/min there (Marlin: CUTTER_POWER_UNIT RPM)." {
    target_has_m_as_macro(target, number) "the target {target} has M{number} as a macro, or as an option, only"
        asks "where the machine has it, list it: `[output] pass_m = [{number}]`";
}

O9335 Error "places-too-coarse-for-arc" "printed places are too coarse for this arc"
"Start, end and centre of an arc are rounded to the printed places, and the receiver goes round what they say. A printed arc may leave the programmed one by 0.005 mm besides the rounding \
of a place, and its radii at start and end may differ by what the receiver takes. Three places of an inch are 0.025 mm. So are lines of `[output] arc_fallback_tolerance` that rounding alone \
takes farther from the arc. Print more places with `[output] decimals`, or leave the key away: every target has enough of its own." {
    printed_with_places(places, unit, mm, more)
        "printed with {places} places of {unit}, this arc would be up to {mm:.3} mm off its path"
        asks "print more places: `[output] decimals = {more}`";
}

O9336 Warning "key-without-effect" "the target does not use this key"
"A key of `[output]` that is written in `partc.toml` changes nothing on the selected target: a unit of waits where the receiver has its own, the number of a program where programs have \
names, a rapid feed where G0 has one. Nothing of the program is lost. Leave the key away, or keep it in the configuration of the target that it is meant for." {
    names_program_by_its_source(key, target, spot)
        "`{key}` changes nothing: the target {target} names a program by its source"
        help "leave the key away{spot}";
    does_not_name_programs(key, target, spot) "`{key}` changes nothing: the target {target} does not name programs"
        help "leave the key away{spot}";
    counts_waits_in_seconds(key, target, spot) "`{key}` changes nothing: the target {target} counts waits in seconds"
        help "leave the key away{spot}";
    counts_waits_in_milliseconds(key, target, spot)
        "`{key}` changes nothing: the target {target} counts waits in milliseconds"
        help "leave the key away{spot}";
    has_rapid_traverse_of_its_own(key, target, spot)
        "`{key}` changes nothing: the target {target} has a rapid traverse of its own"
        help "leave the key away{spot}";
    goes_round_in_every_plane(key, target, spot)
        "`{key}` changes nothing: the target {target} goes round in every plane"
        help "leave the key away{spot}";
    has_no_tap_without_chuck(key, target, spot)
        "`{key}` changes nothing: the target {target} has no tap without a compensating chuck"
        help "leave the key away{spot}";
    says_every_tap_as_it_is(key, target, spot) "`{key}` changes nothing: the target {target} says every tap as it is"
        help "leave the key away{spot}";
    has_no_table_of_tool_lengths(key, target, spot)
        "`{key}` changes nothing: the target {target} has no table of tool lengths"
        help "leave the key away{spot}";
    brings_length_with_tool(key, target, spot)
        "`{key}` changes nothing: the target {target} brings the length with the tool"
        help "leave the key away{spot}";
    has_no_such_limit(key, target, spot)
        "`{key}` changes nothing: the target {target} has no such limit, or no numbers of offsets"
        help "leave the key away{spot}";
    prints_no_angles(key, target, spot) "`{key}` changes nothing: the target {target} prints no angles by themselves"
        help "leave the key away{spot}";
    counts_waits_in_whole_milliseconds(key, target, spot)
        "`{key}` changes nothing: the target {target} counts waits in whole milliseconds"
        help "leave the key away{spot}";
    takes_no_other_m_functions(key, target, spot)
        "`{key}` changes nothing: the target {target} takes no M functions but its own"
        help "leave the key away{spot}";
    does_not_compensate(key, target, spot)
        "`{key}` changes nothing: the target {target} does not compensate the radius of a tool"
        help "leave the key away{spot}";
    prints_mill(key, target, spot)
        "`{key}` changes nothing: the target {target} prints a mill, which has no diameters"
        help "leave the key away{spot}";
}

O9337 Error "tool-offset-too-large" "the target may not count tool offsets that far"
"The length and the radius of a tool are called by its number: T1000 by H1000 and D1000. How many offsets a control has is an option, and a number that it does not have raises an alarm, or is read as another one. \
99 are taken for granted. Give the tool a smaller number (`number` of its entry in `[tools]`), or say how many there are: `[output] tool_offsets = 400`." {
    target_is_taken_to_have_offsets(letter, number, name, most)
        "{letter}{number}: the target {name} is taken to have {most} offsets of tools"
        asks "say how many it has (`[output] tool_offsets`), or give the tool a smaller number (`number` in \
        `[tools]`)";
}

O9338 Warning "corners-without-a-bound" "the target does not bound how far it rounds corners off"
"A control that keeps its speed up leaves the path at corners. How far is a matter of the mode it is in: some have a word for the largest deviation (LinuxCNC `G64 P`, SINUMERIK \
`G642 CTOL=`, cycle 32 of a TNC), and the output states it. The selected target has no such word, or none that stops in a corner, so the part may differ there from the program. \
Told once, before the first move. `[output] path_control = \"exact\"` stops in every corner where the target can; \"none\" says that the machine is set up for the part." {
    target_passes_corners_under(target, word)
        "the target {target} passes corners under {word}, and has no word for how far it may round them off"
        asks "stop in every corner with `[output] path_control = \"exact\"`, or set it to \"none\" where the machine \
        is set up for the part";
    target_passes_all_corners_under(target, word)
        "the target {target} passes corners under {word}, and has no word for how far it may round them off"
        asks "set `[output] path_control = \"none\"` where the machine is set up for the part";
    how_far_target_rounds_corners_off(target)
        "how far the target {target} rounds corners off is a setting of the machine: no word of it is printed"
        asks "stop in every corner with `[output] path_control = \"exact\"`, or set it to \"none\" where the machine \
        is set up for the part";
    how_far_target_rounds_all_corners_off(target)
        "how far the target {target} rounds corners off is a setting of the machine: no word of it is printed"
        asks "set `[output] path_control = \"none\"` where the machine is set up for the part";
    program_stops_in_its_corners(target, mm)
        "the program stops in its corners; the target {target} has no word for that and rounds them off, by {mm} mm \
        at most"
        asks "where that will do, say so: `[output] path_control = {{ tolerance = {mm} }}`";
}

O9339 Error "path-control-unknown-to-target" "the target has no word for how corners shall be taken"
"`[output] path_control` asks for a stop in every corner, or for a bound on how far corners are rounded off, and the selected target cannot say that. Choose what it can say, or \"none\": then \
nothing is printed, and the machine takes its corners as it is set up. docs/targets.md has the words of each target." {
    target_has_no_word_for_stop_in_every_corner(target, choices)
        "`path_control`: the target {target} has no word for a stop in every corner"
        asks "set `[output] path_control` to {choices}";
    target_has_no_word_for_how_far(target, choices)
        "`path_control`: the target {target} has no word for how far corners may be rounded off"
        asks "set `[output] path_control` to {choices}";
}

O9340 Error "rigid-tap-unknown-to-target" "the target has no word for tapping without a compensating chuck"
"The program taps a hole without a compensating chuck (cycles 17, 207 and 209, CYCLE84, G331 with G332, G33.1): axis and spindle go in step all the time, while the spindle turns round, too. The selected target has no word for that, or none that is confirmed. A feed that only fits the speed would tear the thread or break the tap. Tap with a compensating chuck (cycle 206, CYCLE840, G63) where the target can do that, cut the thread by a milling cycle, or take another target." {
    target_has_no_word_for_tapping_without_chuck(target)
        "the target {target} has no word for tapping without a compensating chuck"
        help "tap with a compensating chuck where the target can, mill the thread, or take another target";
}

O9341 Error "rigid-tap-in-other-words" "the target cannot tap this hole"
"The selected target taps by a word of its own, which has a fixed form: along Z downwards, back to where it began, with a speed that is known, on some receivers right-hand threads only. This hole is another one, or its pitch cannot be printed exactly enough. What the target lacks is in the message." {
    target_has_no_word_for_tap_inside_compensation(target)
        "the target {target} has no word for a tap inside radius compensation"
        help "end the compensation before the hole";
    target_has_no_word_for_tap_along_axis_not_moved(target)
        "the target {target} has no word for a tap along an axis that was not moved"
        help "move to the hole before the tap";
    target_has_no_word_for_tap_at_cutting_speed(target)
        "the target {target} has no word for a tap under a constant cutting speed"
        help "program a constant speed (G97 S) before the hole";
    target_has_no_word_for_tap_along_this_axis(target) "the target {target} has no word for a tap along this axis"
        help "tap along X, Y or Z";
    target_has_no_word_for_tap_that_ends_at_another_height(target)
        "the target {target} has no word for a tap that ends at another height than it began"
        help "let the tap come back to where it began: G332 to the height where G331 began";
    target_has_no_word_for_tap_at_speed_not_known(target)
        "the target {target} has no word for a tap at a speed that is not known"
        help "program S before the hole";
    target_has_no_word_for_tap_in_another_direction(target)
        "the target {target} has no word for a tap in another direction than down Z"
        help "set the part up so that Z goes into the hole";
    target_has_no_word_for_left_hand_tap(target) "the target {target} has no word for a left-hand tap"
        help "cut the thread another way, or take another target";
    target_has_no_word_for_this_pitch(target) "the target {target} has no word for this pitch with all its places"
        asks "print more places of a pitch: `[output] decimals`";
    target_has_no_word_for_this_pitch_as_feed(target)
        "the target {target} has no word for this pitch with all its places"
        asks "program another speed, or print more places of a feed: `[output] decimals.feed`";
}

O9342 Error "no-tilted-plane" "target has no word for a tilted plane"
"The selected target has no word for a working plane that is tilted, and what its axes would have to do instead depends on the machine: where its rotary axes \
lie, and how long the tool is. The targets fanuc, mazak, sinumerik and heidenhain have words for it." {
    target_has_no_word_for_tilted_plane(target) "the target {target} has no word for a tilted working plane"
        asks "print for a target that has one: `--target fanuc`, `mazak`, `sinumerik` or `heidenhain`";
}

O9343 Error "tilted-plane-in-other-words" "the target cannot say what happens to this tilted plane"
"The selected target has words for a tilted working plane, but none for what the program does there, or they cannot be printed exactly enough. Angles are printed with four places at least, unless \
`[output] decimals` says fewer. Rotary axes turn back by their letters where the target has no word for it, and those are data of the machine. A move in machine coordinates ends the plane where it is not confirmed that the target takes \
both at once: the plane has to be programmed anew after it. What the target lacks is in the message." {
    angles_print_as_another_plane(places)
        "the angles of this plane, printed with {places} places, make another plane"
        asks "print more places of angles: `[output] decimals.angle`";
    letters_of_rotary_axes_are_not_known(target)
        "the target {target} turns rotary axes back by their letters, which are not known"
        asks "say which axes tilt the plane: `[machine] tilt_axes = [\"A\", \"C\"]`";
    move_goes_on_in_plane(target, word)
        "this move goes on in a tilted plane after a move in machine coordinates, before which the target {target} \
        ended it ({word})"
        help "program the plane anew before it";
    work_offset_is_selected_in_plane(target)
        "the target {target} has no word for another work offset in a tilted plane"
        help "end the plane before it";
}

O9330 Error "line-longer-than-read" "line has more characters than the target reads"
"The selected target takes lines of a certain length and refuses or cuts longer ones. A line that is a little too long gives its F to a line before it; under G93, \
where F is the time of its own block, it cannot. Print fewer places with `[output] decimals`, or move fewer axes in one block." {
    target_reads_lines_of_characters(most, line, line2)
        "the target reads lines of {most} characters, and `{line}` has {line2}"
        asks "print fewer places with `[output] decimals`, or move fewer axes in one block";
}

}
