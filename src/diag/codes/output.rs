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
    speed_prints_as_zero(speed) "the speed {speed} prints as zero, and the spindle would stand";
}

O1005 Error "wait-prints-as-zero" "wait is shorter than its last printed place"
"The receiver would not wait at all. The wait of the program is above zero and less than half of what the selected target, or `[output] decimals`, can say: half a millisecond where waits are \
whole milliseconds. Look at the number after the wait and at its unit, program a wait that can be said, or leave it out." {
    wait_of_s_prints_as_zero(seconds) "the wait of {seconds} s prints as zero";
}

O1006 Warning "feed-or-speed-rounded" "rounding changes a feed, a speed or a lead by more than one per cent"
"The target reads so many places after F, S and the lead of a thread, or `[output] decimals` says so many, and the number of the program has more: 0.01 mm a turn are 0.00039 inch, and 0.0004 with four places. Of a feed per revolution, which has few digits, a tenth of a per cent is told. The first \
one of a program is told. Print more places where the target reads them, or program a number that it can say."

O1007 Error "feed-or-speed-becomes-another" "rounding makes another feed, speed or lead of it"
"The number that is printed would differ from that of the program by more than ten per cent: S0.5 would become S1 where the target counts whole turns, which is twice as fast. Print more \
places where the target reads them (`[output] decimals.feed` and `decimals.speed`), or program a number that it can say."

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

O4001 Note "arc-as-lines" "arc is printed as straight lines"
"The arc is so small or so flat that its printed numbers cannot describe a circle within the tolerance of the target: \
after rounding, start and end lie at different distances from every possible centre. It is printed as lines that leave the arc \
by less than half a printed unit."

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
        "radius compensation begins in a rapid move: where the target goes beside the contour is its own choice";
}

O4007 Warning "chip-removed-for-broken" "the tap leaves the hole to break the chip"
"The program breaks the chip of a tapped hole by a short way back within the hole. The tapping word of the selected target always goes back to where it began, so the hole is tapped in several strokes, each deeper than the one before and each out of the hole again. The chip is removed where it would have been broken, and it takes longer. Where the strokes meet in one thread only if the spindle is set up for it, O4009 says so. State that you want it so: `[output] tapping = \"as-target\"`."

O4008 Warning "tap-without-detail" "the tap is printed without a detail"
"The tapping word of the selected target has no place for a detail that the program gives: the dwell at the bottom, another speed for the way out, the speed of the way down to the last depth, or the angle of the spindle at which the thread begins. Depth, pitch and hand of the thread are exact. Take the detail out of the program, or see that nothing depends on it; `[output] tapping = \"as-target\"` says that it may be left out."

O4009 Warning "tap-steps-have-to-meet" "the steps of a tap meet only where the spindle begins at one angle"
"The program taps a hole in several steps (chip breaking or chip removal: CYCLE84, cycle 209, G331 and G332). The tapping cycle of the selected target always goes back to where it began, so each step is a tap of its own. All of them cut one thread only if the spindle begins each at the same angle, and that is a setting of the machine: on a Haas setting 133 (REPT RIGID TAP), on a Fanuc what rigid tapping keeps while it stays on, and parameter 5202. Check it in the air or in scrap, or tap in one step. `[output] tapping = \"as-target\"` says that the machine is set up for it."

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
        "a stop stands in the compensated contour, and the target {target} does not read on beyond it";
    second_block_that_moves_nothing_in_working()
        "a second block that moves nothing in the working plane stands in the compensated contour"
        asks "put it before the contour or after it; comments count (`[output] comments = false`)";
    target_has_no_word_for_radius_compensation(target)
        "the target {target} has no word for radius compensation that begins or ends in a transformed move"
        asks "set `[output] compensation = \"resolve\"`";
    how_corners_are_taken_changes_while_radius(name)
        "how corners are taken changes while radius compensation is on, and the target {name} does not change it \
        there";
    radius_compensation_is_on_at_block()
        "radius compensation is on at a block that ends it, and the target ends it in a straight move only"
        help "move away from the contour without compensation before this block";
}

O9300 Error "thread-unknown-to-target" "the target cuts no threads"
"A thread is cut in step with the spindle (G33, and the tapping and threading cycles that end in it), and the selected target moves its axes \
without looking at the spindle. Cut the thread on another machine, mill it, or tap with a floating holder at a feed in mm/min that you compute yourself." {
    target_has_no_word_for_thread(target) "the target {target} has no word for a thread in step with the spindle"
        help "cut the thread another way, or take a target that turns the spindle in step";
}

O9301 Error "feed-unknown-to-target" "the target has no such kind of feed"
"The program states its feed per revolution (G95) or by time (G93), and the selected target takes feeds in mm/min alone. A feed per revolution is not \
converted: the speed of the spindle is only nominal, and under constant cutting speed it changes. Program the feed in mm/min."

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
"The program speaks to a second spindle or a driven tool. The selected target has words for one spindle. Program the first one, or choose another target."

O9305 Error "tool-change-unknown-to-target" "the target changes no tools"
"The selected target refuses M6. With `[output] tool_change = \"stop\"` a change is printed as a spindle stop, a comment and a program stop, and you change by \
hand; the next tool must then have the same length, or the target does not know where its tip is. Or write one program a tool and set each tool up." {
    target_has_no_word_for_tool_0(target) "the target {target} has no word for tool 0"
        help "a turret has no empty place: leave tool 0 out";
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
}

O9308 Error "compensation-unknown-to-target" "the target does not compensate the tool radius"
"With `[output] compensation = \"control\"` the target offsets the contour by the radius of the tool (G41, G42), and the selected target cannot, or not by this radius: an oversize of the program is not in its table. Program the path of the \
tool centre, or choose a target that compensates." {
    target_has_no_word_for_radius_compensation(target) "the target {target} has no word for radius compensation"
        help "program the path of the tool centre, or take a target that compensates";
}

O9309 Error "axis-unknown-to-target" "the target does not have this axis"
"The selected target moves X, Y and Z. A rotary or a parallel axis has no letter there, or it is a matter of the machine which way it turns and what F counts; leaving it out would cut on \
the wrong side of the part. Split the program \
where the axis turns and turn it by hand, or choose another target."

O9310 Error "work-offset-unknown-to-target" "the target does not have this work offset"
"Work offsets are selected by their number, and the selected target has fewer of them. Select another one in the program, or map the preset to another word in `[datums]`." {
    target_has_no_word(target, said, printed, range)
        "the target {target} has no word for {said}{printed}: it has {range}";
    target_has_no_work_offsets(target, said)
        "the target {target} has no work offsets, and the program selects {said}"
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
of the program, or choose a target that a machine builder can extend."

O9314 Error "number-longer-than-read" "number has more digits than the target reads"
"The selected target drops all digits of a number after the eighth without a word, so the axis would stop elsewhere. Print fewer places with `[output] decimals`; a path of \
more than ten metres needs a target that computes in double precision." {
    target_reads_digits_of_number(digits, whole, line)
        "the target reads {digits} digits of a number{whole}, and `{line}` has more";
}

O9315 Error "diameter-unknown-to-target" "the target does not take X as a diameter"
"`[output] diameter = true` prints X of a lathe as a diameter, which needs a word that tells the target so (G7). The selected target has none and takes X as a radius. Leave the key away."

O9316 Error "spindle-stands-after-change" "cut with the spindle that a tool change by hand stopped"
"With `[output] tool_change = \"stop\"` the spindle is stopped (M5) before you change the tool. The program cuts after the change and starts no spindle: the control \
may have kept it turning, or started it in its own tool change, and which of the two is not written in the program. Program M3 or M4 after the change, or M5 where the \
tool has to stand, such as a probe." {
    this_block_cuts() "this block cuts, and the spindle stands since the tool change by hand"
        help "program M3 or M4 after the change, or M5 where the tool has to stand";
}

O9317 Error "machine-kind-unknown-to-target" "the target is made for another kind of machine"
"A lathe and a mill of one control speak differently: on many lathes X is always a diameter, and words such as G90 and G94 start cycles. Take the target that belongs \
to the machine, or correct `[machine] kind`; where X is always a diameter, leave `[output] diameter = false` away."

O9318 Error "tool-length-begins-in-such-a-block" "the tool length cannot begin in this block"
"The selected target takes the length of a tool (G43 H) in a straight move along Z: alone in a block, some controls move by the length. The first block after the tool change \
that moves Z is an arc, a thread or a transformed move. Put a straight move along Z before it." {
    target_has_no_word_for_length(target)
        "the target {target} has no word for the length of a tool that begins in such a block"
        help "move along Z in a straight block after the tool change";
}

O9319 Error "quantity-unknown-in-inches" "the quantity is not printed in inches"
"With `[output] units = \"inch\"` a feed counts inches, and in a move of a rotary axis alone it would count degrees; a cutting speed would count feet. Controls differ in \
both, so neither is converted. Set `units = \"mm\"`."

O9320 Error "tool-preparation-unknown-to-target" "the target cannot bring a tool forth before its change"
"A T word without a change tells the changer which tool comes next. On the selected target a T word is the change itself (T0101), so the turret would turn at once. Leave the \
word out of the program." {
    target_has_no_word_for_tool(target)
        "the target {target} has no word for a tool that is brought forth before its change"
        help "leave the T word out that only brings the tool forth, or take another target";
}

O9321 Error "machine-coordinates-unknown-to-target" "the target does not move so in machine coordinates"
"G53, M91 and SUPA name a place in machine coordinates. The selected target has no word for it, or takes it at rapid traverse only. Go there at rapid traverse or by hand, or program \
the place in workpiece coordinates."

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
SINUMERIK `tool_length = \"off\"` prints no D1, and the lengths of all tools have to be alike then."

O9328 Error "arc-plane-unknown-to-target" "the target goes round in other planes"
"The selected target takes arcs in XY alone (uccnc, klipper, marlin), helices in XY alone (heidenhain), or no helices at all (marlin, where a bed that is levelled by a mesh drops Z), \
as far as is confirmed. With `[output] arc_fallback_tolerance = 0.005` such an arc is printed as lines \
that leave it by at most so many millimetres; or choose another target." {
    target_has_no_word(target, what) "the target {target} has no word for {what}";
}

O9329 Warning "block-numbers-of-target" "the target numbers its blocks by itself, or not at all"
"On the selected target every block has a number, counted from 0 by 1 (heidenhain), or a number would want a checksum (klipper, marlin), so `[output] line_numbers` and \
`--numbers` change nothing. Leave them away." {
    line_numbers(name, why) "`line_numbers`: the target {name} {why}" help "leave the key away";
}

O9331 Error "dwell-unit-is-a-setting" "what a wait counts is a setting of the receiver"
"A setting of the receiver says whether the number after G4 P counts seconds or milliseconds. Look there, and set `[output] dwell_unit`: a wait of half a second would take eight minutes, or \
none, otherwise." {
    seconds_or_milliseconds(target)
        "seconds or milliseconds: a setting of the target {target} says what a wait counts";
}

O9332 Error "inches-unknown-to-target" "the target counts millimetres only"
"`[output] units = \"inch\"` prints lengths in inches, and the selected target refuses G20, or does not know it in every build. Leave the key away: a program in inches is printed in \
millimetres."

O9333 Error "rapid-feed-is-missing" "rapid traverse has no feed of its own on the target"
"Klipper and Marlin carry out G0 at the last F, so after a cut a rapid move would creep, and after a fast one the next cut would race. Every rapid move is printed with the F of \
`[output] rapid_feed` in mm/min, and every cut after it with its own. Set the key to what the machine can do." {
    on_target_rapid_traverse_goes_at_last(target)
        "on the target {target} rapid traverse goes at the last F, and none is configured";
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
    printed_with_places(places, unit, mm)
        "printed with {places} places of {unit}, this arc would be up to {mm:.3} mm off its path";
}

O9336 Warning "key-without-effect" "the target does not use this key"
"A key of `[output]` that is written in `partc.toml` changes nothing on the selected target: a unit of waits where the receiver has its own, the number of a program where programs have \
names, a rapid feed where G0 has one. Nothing of the program is lost. Leave the key away, or keep it in the configuration of the target that it is meant for." {
    changes_nothing(key, name, why) "`{key}` changes nothing: the target {name} {why}";
}

O9337 Error "tool-offset-too-large" "the target may not count tool offsets that far"
"The length and the radius of a tool are called by its number: T1000 by H1000 and D1000. How many offsets a control has is an option, and a number that it does not have raises an alarm, or is read as another one. \
99 are taken for granted. Give the tool a smaller number (`number` of its entry in `[tools]`), or say how many there are: `[output] tool_offsets = 400`." {
    target_is_taken_to_have_offsets(letter, number, name, most)
        "{letter}{number}: the target {name} is taken to have {most} offsets of tools";
}

O9338 Warning "corners-without-a-bound" "the target does not bound how far it rounds corners off"
"A control that keeps its speed up leaves the path at corners. How far is a matter of the mode it is in: some have a word for the largest deviation (LinuxCNC `G64 P`, SINUMERIK \
`G642 CTOL=`, cycle 32 of a TNC), and the output states it. The selected target has no such word, or none that stops in a corner, so the part may differ there from the program. \
Told once, before the first move. `[output] path_control = \"exact\"` stops in every corner where the target can; \"none\" says that the machine is set up for the part."

O9339 Error "path-control-unknown-to-target" "the target has no word for how corners shall be taken"
"`[output] path_control` asks for a stop in every corner, or for a bound on how far corners are rounded off, and the selected target cannot say that. Choose what it can say, or \"none\": then \
nothing is printed, and the machine takes its corners as it is set up. docs/targets.md has the words of each target." {
    path_control(target, what) "`path_control`: the target {target} has no word for {what}";
}

O9340 Error "rigid-tap-unknown-to-target" "the target has no word for tapping without a compensating chuck"
"The program taps a hole without a compensating chuck (cycles 17, 207 and 209, CYCLE84, G331 with G332, G33.1): axis and spindle go in step all the time, while the spindle turns round, too. The selected target has no word for that, or none that is confirmed. A feed that only fits the speed would tear the thread or break the tap. Tap with a compensating chuck (cycle 206, CYCLE840, G63) where the target can do that, cut the thread by a milling cycle, or take another target."

O9341 Error "rigid-tap-in-other-words" "the target cannot tap this hole"
"The selected target taps by a word of its own, which has a fixed form: along Z downwards, back to where it began, with a speed that is known, on some receivers right-hand threads only. This hole is another one, or its pitch cannot be printed exactly enough. What the target lacks is in the message."

O9330 Error "line-longer-than-read" "line has more characters than the target reads"
"The selected target takes lines of a certain length and refuses or cuts longer ones. A line that is a little too long gives its F to a line before it; under G93, \
where F is the time of its own block, it cannot. Print fewer places with `[output] decimals`, or move fewer axes in one block." {
    target_reads_lines_of_characters(most, line, line2)
        "the target reads lines of {most} characters, and `{line}` has {line2}";
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
table, TOOL DEF or an oversize. Program the block farther from the contour."

}
