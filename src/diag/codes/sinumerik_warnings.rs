//! `S8`: what SINUMERIK programs leave open, or what the output leaves out.

super::codes! { SINUMERIK_WARNINGS:

S8001 Warning "siemens-unbracketed-logic" "AND or OR beside a comparison without brackets"
"Comparisons bind weakest on a SINUMERIK control: `R1==1 AND R2==2` is read as `R1 == (1 AND R2) == 2`, which is hardly what is meant. \
Put each comparison in brackets. The program is compiled as the control reads it." {
    and_or_xor_bind_tighter_than_comparison() "AND, OR and XOR bind tighter than the comparison beside them";
}

S8002 Note "siemens-dynamics" "words for speed and accuracy are left out"
"SOFT, FFWON, COMP…, G601, ADISPOS, ACC and others shape how a control follows the path, not the path itself, and are left out. G60, G9, G64, G641, G642, CTOL and the tolerance of CYCLE832 are none of \
them: what they say of corners is printed. G642 to G645 without CTOL round by machine data, which no program shows: the output keeps its own bound then." {
    words_that_only_shape_speed() "words that only shape speed and accuracy are left out";
    rounds_corners_by_machine_data(code)
        "{code} without CTOL= rounds corners by machine data: the output keeps the bound of its head";
}

S8003 Warning "siemens-several-programs" "file holds several main programs"
"An archive can hold several main programs; the first one is compiled, the others are not looked at. Put each into a file of its own." {
    file_holds_several_main_programs(name) "the file holds several main programs; {name} is compiled";
}

S8004 Note "siemens-gear" "gear steps are left out"
"M40 to M45 select the gear of a spindle. The target chooses its own, so they are not printed; list them under `[output] pass_m` to print them." {
    gear_steps_m40_to_m45_are_left() "gear steps M40 to M45 are left out";
}

S8005 Warning "siemens-h" "H functions are left out"
"H functions are messages to the machine's own control. What they do is not known, and the target has no word for them." {
    h_functions_are_for_machines_own_control() "H functions are for the machine's own control and are left out";
}

S8006 Note "siemens-outputs" "outputs and counters are left out"
"Writing outputs, timers and counters of the control has no effect on the path and is not printed. Values that the program reads back are kept." {
    is_for_trial_runs(word) "`{word}` is for trial runs only and is left out";
    is_output_or_counter_of_control(word) "`{word}` is an output or a counter of the control and is left out";
}

S8007 Warning "siemens-increment-frame" "increment after a change of the frame"
"Whether an increment travels the change of the frame, too, depends on setting datum 42440: with 1 it counts from the programmed value of \
before in the new frame, with 0 from where the tool stands. Set `[control] sd42440`, or program absolutely." {
    increment_of_follows_change_of_frame(axis) "the increment of {axis} follows a change of the frame";
}

S8008 Warning "siemens-rnd-and-chr" "rounding and chamfer in one block"
"With RND and CHR or CHF in one block the control makes the rounding only. Delete one of them." {
    rnd_chamfer_stand_in_one_block() "RND and a chamfer stand in one block: only RND counts";
}

S8010 Note "siemens-edges" "tool data of the control are not printed"
"A tool of the target has one set of offsets, in a table of its own. Edges D2 and higher, and lengths that the program writes ($TC_DP3), are \
not printed; the target has to be told them. Under G41 and G42 the radius of the edge counts: where it is not known the block is refused." {
    target_has_tool_data_of_its_own(word, what) "{word} {what}: the target has tool data of its own";
    cutting_edges_other_than_d1_are_not()
        "cutting edges other than D1 are not printed: the target knows one offset a tool";
    is_not_printed(word) "`{word}` is not printed: the target has tool data of its own";
}

S8254 Warning "siemens-edge-without-length" "lengths of a cutting edge are not known"
"A tool of the target has one set of lengths, those of D1. The program takes another edge, and neither it nor the tool data say what lengths \
that has: where they differ, every position after it is off by the difference. Give the edge a tool number of its own, or tell both lengths \
($TC_DP3 to $TC_DP5); lengths that differ are refused (S9021)." {
    d_is_not_printed(edge)
        "D{edge} is not printed, and its lengths are not known: the target takes those of D1, and goes wrong by the \
        difference"
        help "give the edge a tool number of its own, or tell its lengths: `$TC_DP3` to `$TC_DP5` in the tool data";
}

S8011 Note "siemens-g500" "how positions under G500 are printed"
"G500 switches the work offset off, so that positions count from the basic system: the machine zero, shifted by the basic frame. Where the program uses no offset \
of the machine they are printed as they stand; the offset that is active on the target has to be zero or to lie there. Beside offsets of the machine they are \
printed with G53 through `[datums] basic`, or through the values of the offset in `[datums]`. If G500 stands for a work offset, name it: `[datums] G500 = \"G54\"`." {
    positions_under_g500_are_printed()
        "positions under G500 are printed as they stand: the offset that is active on the target has to be zero, or \
        to lie where the basic system of the control lies";
    positions_under_g500_are_printed_in_through(word)
        "positions under G500 are printed in {word}, through its values in `[datums]`";
    under_g500_positions_are_printed_in_machine()
        "under G500 positions are printed in machine coordinates with G53, through `[datums] basic`";
}

S8012 Note "siemens-written-offset" "work offset of the program is in the coordinates"
"The program writes the work offset itself ($P_UIFR). It is put into the printed coordinates, which count from the basic system; no G54 is \
printed for it. So the work offset that is active on the target has to be zero, or to lie at the basic zero point." {
    work_offset_that_program_writes_itself()
        "a work offset that the program writes itself is put into the coordinates, no G54 is printed: the offset \
        active on the target has to be zero";
}

S8101 Warning "siemens-feed-words" "word that changes feeds or speeds"
"CFTCP and CFIN make F count differently on arcs under radius compensation, FLIN and FCUB let the feed run from value to value, FGROUP lets \
it count along some of the axes, GWPSON makes S a speed of the circumference of the wheel. The output has F and S as they are programmed. CFC, FNORM and GWPSOF are what the target does." {
    fgroup_is_left_out() "FGROUP lets F count along the named axes only, which is left out"
        help "check the feeds of the program on the target";
    feed_on_arcs_counts_differently(name)
        "{name} makes the feed on arcs count differently under radius compensation, which is left out"
        help "check the feeds of the program on the target";
    feed_runs_from_value_to_value(name) "{name} lets the feed run from value to value, which is left out"
        help "check the feeds of the program on the target";
    speed_of_wheel_is_left_out(name)
        "{name} makes S a speed of the circumference of the wheel, which is left out"
        help "check the feeds of the program on the target";
}

S8102 Warning "siemens-rapid-by-axis" "rapid traverse of each axis by itself"
"Under RTLIOF each axis goes to its end at its own rapid traverse, so that the path between the points is no straight line. The target moves straight: \
check that the way is free, or program RTLION." {
    under_rtliof_each_axis_runs()
        "under RTLIOF each axis runs at its own rapid traverse; the output goes straight to the point";
}

S8103 Note "siemens-control-words" "words that steer the control only are left out"
"STOPRE, SBLOF, DISPLOF, WAITP and others act on the buffer, the display and the single block of the control; LFON and RMI on what happens after an \
interruption; CP, TRAFOOF, TOROTOF, CUTCONOF and others switch off what no block can switch on here. None of them moves an axis." {
    words_that_only_steer_control() "words that only steer the control, or switch off what is not on, are left out";
    supd_is_left_out() "SUPD is left out: no tool offset counts in the axes of the block";
}

S8104 Note "siemens-orientation-words" "words for tool orientation are left out"
"ORIWKS, ORIMKS, ORIAXES, ORIC and others say how a control turns the tool. The output has no tool orientation: rotary axes are printed as they are \
programmed, and tool directions (A3=, LEAD=) are refused." {
    words_for_tool_orientation_are_left_out() "words for tool orientation are left out: the output turns no tool";
}

S8105 Note "siemens-length-added" "tool length is in a machine coordinate"
"G53, G153 and SUPA place the tip of the tool on a SINUMERIK control (MD 10760 = 0), and the nose of the spindle on the target. The length of the \
tool is added to the printed coordinate, so that the spindle stands where the control has it." {
    tool_length_is_added_to_machine_coordinates(length, axis)
        "the tool length {length} is added to machine coordinates of {axis}";
}

S8106 Warning "siemens-tip-in-machine" "machine coordinate counts for the tip of the tool"
"G53, G153 and SUPA suppress frames, not the length of the tool, unless MD 10760 says so: the tip goes to the machine coordinate, and the \
spindle stands a tool length higher. The target places its spindle there. Write D0 in the block as most programs do, set `[control] md10760 = \
true` if the machine suppresses the length, or print tool lengths (`tool_length = \"G43\"`) and give them." {
    control_goes_to_this_machine_coordinate()
        "the control goes to this machine coordinate with the tip of the tool (MD 10760 = 0), the target with its \
        spindle: a tool length lower";
}

S8107 Warning "siemens-negative-half" "half of a negative number is rounded"
"A negative number that ends in .5 becomes an INT here by rounding up (-2.5 is -2), and ROUND takes it away from zero (-3). The manuals say what \
becomes of positive halves only. Keep the value off the half, or round it in the program." {
    is_rounded_to_manuals_do_not_say(value, made)
        "{value} is rounded to {made}: the manuals do not say how negative halves are rounded";
}

S8108 Note "siemens-file-error" "error variable of a file access is 0"
"WRITE and DELETE report in a variable whether they worked. They are left out, so the variable gets 0: no error." {
    error_variable_is_set_to_0(name, shown) "the error variable of {name}, {shown}, is set to 0: no error";
}

S8013 Note "siemens-limits" "working-area limits are left out"
"G25 and G26 set limits for axes or spindle speeds in the control. They are no moves and have no word on the target." {
    working_area_limits()
        "working-area limits and lowest speeds (G25, G26) are left out; G26 S limits the spindle speed";
}

S8014 Note "siemens-master" "another spindle is the master"
"SETMS makes another spindle the master: S, M3, M4, M5 and SPOS without a number are its words from here on and are printed with its number. \
Feed per revolution, threads and G96 would follow it, too, and are refused: the target follows its first spindle." {
    s_m_words_without_number_go(n) "S and M words without a number go to spindle {n} from here on";
}

S8015 Note "siemens-channels" "channel words are left out"
"INIT, START, WAITM and others synchronize programs in several channels. The output is for one channel; what the others do is not in it." {
    words_that_synchronize_channels_are_left_out()
        "words that synchronize channels are left out: the output has one channel";
}

S8016 Note "siemens-interrupts" "interrupt programs are left out"
"SETINT and others name programs that run when a signal comes. They are not part of the path." {
    interrupt_programs_are_left_out() "interrupt programs are left out";
}

S8017 Note "siemens-files" "file access is left out"
"WRITE, DELETE and others work on files of the control. They have no effect on the path." {
    works_on_file_of_control(name) "{name} works on a file of the control and is left out";
}

S8018 Warning "siemens-two-depths" "two depths for one hole"
"DP and DPR, or FDEP and FDPR, give different depths. The cycle takes the relative one. Leave one of them out." {
    dp_dpr_give_different_depths(args) "{args}: DP and DPR give different depths; DPR counts" help "leave one of them out";
    fdep_fdpr_give_different_first_depths(args)
        "{args}: FDEP and FDPR give different first depths; FDPR counts" help "leave one of them out";
    dp_dpr_are_both_given(args, used)
        "{args}: DP and DPR are both given; the units of `_AMODE` choose {used} (message 61805)" help "leave the other one out";
}

S8019 Warning "siemens-starts" "thread with several starts"
"The editor of CYCLE99 may leave a number of starts in its call though one start is meant. All starts are cut as the argument says: check it." {
    cuts_starts(args, starts) "{args} cuts {starts} starts"
        help "the editor may leave a number here though one start is meant: set it to 1 then";
}

S8020 Warning "siemens-thread-variant" "digits of a thread cycle"
"What the digits of _VARI in CYCLE99 mean is not confirmed beyond their units, which are read as in CYCLE97. Of the other digits only \
those of stored calls are taken (1310101: roughing and finishing, so many passes as NRC says); others are refused." {
    units_of_vari_are_read()
        "the units of `_VARI` are read as in CYCLE97 (1 and 3 external, 2 and 4 internal), and its other digits as \
        roughing and finishing in one call";
}

S8021 Warning "siemens-flank" "reference of the flank infeed"
"With a flank infeed the passes are shifted along the thread. Which of them stands at the programmed start is not documented; partc shifts from \
the crest on. The finished thread is the same up to a shift along its axis, which matters where a thread is cut anew. `[control] thread_flank` says it." {
    flank_infeed_is_counted_from_crest()
        "a flank infeed is counted from the crest: the manuals leave open which pass stands at the programmed Z"
        asks "say it by `[control] thread_flank`: \"crest\", or \"root\" for the last pass";
}

S8022 Warning "siemens-undercut-facts" "undercut rests on facts that are not confirmed"
"Some values of undercut tables and their use in the control have one source only. They can be set under [undercut]; check the drawing." {
    not_confirmed(what, verb) "{what} {verb} not confirmed: compare with the drawing";
    undercut_rests_on_facts_that_are_not(thread) "the undercut rests on facts that are not confirmed: {thread}";
    contour_does_not_tell_side_of_material(side, facts)
        "the contour does not tell the side of the material; the undercut is taken as one {side}{facts}";
}

S8023 Note "siemens-undercut-roughing" "roughing of an undercut"
"How a control roughs an undercut is not published. partc cuts in equal steps, then along the undercut; the finished form is the same." {
    roughing_of_undercut_is_up_to_control()
        "roughing of the undercut is up to the control; it is cut in equal steps parallel to its floor";
}

S8024 Note "siemens-nose" "nose radius is not compensated"
"Retired: CYCLE94, CYCLE96 and CYCLE940 cut the undercut with the nose of the tool, as the control does. Without its radius and position they are refused (P2004)."

S8025 Warning "siemens-tap" "tapping with a tension-compression chuck"
"CYCLE840: the target cuts a thread in step with the spindle, or goes at the feed, and the spindle is reversed in between. Axis and spindle are not in step while it turns round: the tap needs the chuck that gives \
way, as on the control. CYCLE84, and G331 with G332, are printed as taps without one." {
    g63_tap_needs_compensating_chuck_on_target() "G63: the tap needs a compensating chuck on the target";
    without_encoder_f(args, word, given)
        "{args}: without an encoder F and S make the thread, and the pitch of the call, {word} {given}, is not used";
    tap_needs_compensating_chuck_on_target(args) "{args}: the tap needs a compensating chuck on the target";
}

S8026 Warning "siemens-contour-differs" "blocks and records of a stored contour differ"
"The contour editor stores a contour twice: as NC blocks, which run, and as hidden records of what was typed. They make different points here, so one \
of the two was changed by hand. The blocks are compiled, as the control does." {
    element_runs_at_rapid_traverse(i)
        "element {i} runs at rapid traverse, which no record of the contour editor says"
        help "program G1 in the first element";
    contour_starts_at(there, here, way)
        "the contour starts at {there}, by the records of the contour editor at {here}: {way} apart"
        help "the blocks are compiled; if they were changed by hand, accept the contour in the editor again";
    contour_has_elements(there, here)
        "the contour has {there} elements, but the records of the contour editor make {here}"
        help "the blocks are compiled; if they were changed by hand, accept the contour in the editor again";
    element_ends_at(i, there, here, way)
        "element {i} ends at {there}, by the records of the contour editor at {here}: {way} apart"
        help "the blocks are compiled; if they were changed by hand, accept the contour in the editor again";
    element_is(i, there, here) "element {i} is {there}, by the records of the contour editor {here}"
        help "the blocks are compiled; if they were changed by hand, accept the contour in the editor again";
    element_is_about_another_centre(i, there, here, way)
        "element {i} is {there}, by the records of the contour editor {here}: {way} apart"
        help "the blocks are compiled; if they were changed by hand, accept the contour in the editor again";
    element_has_another_radius(i, there, here, radius)
        "element {i} is {there}, by the records of the contour editor {here} with radius {radius}"
        help "the blocks are compiled; if they were changed by hand, accept the contour in the editor again";
    corner_after_element_has(i, there, here)
        "the corner after element {i} has {there}, by the records of the contour editor {here}"
        help "the blocks are compiled; if they were changed by hand, accept the contour in the editor again";
}

S8027 Note "siemens-contour-unchecked" "records of a stored contour cannot be checked"
"The hidden records of this contour use elements that cannot be solved here. The NC blocks are compiled; nothing is lost but the check." {
    records_of_this_contour_cannot_be_checked(what) "the records of this contour cannot be checked: {what}";
    records_of_this_contour_are_for_another() "the records of this contour are for another plane";
}

S8029 Note "siemens-swivel-zero" "swivelling by nothing"
"CYCLE800 without angles leaves a plane where it is that is not swivelled; its offsets before and after the rotation shift the workpiece. Rotary axes stay where they are: the output has a machine in \
mind whose plane is not swivelled." {
    turns_nothing_and_is_left_out() "CYCLE800 without angles and offsets turns nothing and is left out";
    turns_nothing_and_only_retracts() "CYCLE800 without angles and offsets turns nothing and only retracts";
    turns_nothing_and_shifts(x, y, z)
        "CYCLE800 without angles turns nothing and shifts the workpiece by X{x} Y{y} Z{z}";
}

S8028 Note "siemens-contour-rebuilt" "stored contour is made from its records"
"The NC blocks of a contour of the contour editor are missing. Its hidden records determine it, so the blocks are made from them, at the feed that \
is modal. Compare the result with the drawing." {
    blocks_of_stored_contour_are_missing() "the blocks of a stored contour are missing and are made from its records";
}

S8030 Warning "siemens-contour-choice" "stored contour has two solutions"
"A contour is made from its hidden records, and the values of one leave two solutions. Which one was chosen in the editor is stored in a way that is \
not confirmed; the shorter arc or the farther point is taken. Compare it with the drawing." {
    this_record_leaves_two_solutions() "this record leaves two solutions, and the stored choice is not confirmed";
}

S8031 Warning "siemens-spindle-sense" "sense of a spindle stop is not printed"
"SPOS=ACP(…) and SPOS=ACN(…) say in which sense the spindle turns to its angle. The angle is printed; the target chooses the sense." {
    sense_in_which_spos_acp() "the sense in which SPOS=ACP(…) and ACN(…) turn the spindle is not printed";
}

S8032 Warning "siemens-speed-limited" "spindle speed is above its limit"
"G26 S limits the speed of a spindle, LIMS= that of the master under G96 and G97. The control turns the spindle at the limit, so the limit is printed." {
    lims_does_not_count(code, before, now)
        "LIMS= does not count under {code}: the spindle goes from {before} to {now} turns"
        help "program S with it, or limit the speed by G26 S";
    speed_is_above_limit(speed, limit) "the speed {speed} is above the limit {limit}, at which the spindle turns"
        help "program a speed within the limit of LIMS= and G26";
}

S8033 Warning "siemens-mcall-trigger" "block without a move under a modal drilling cycle"
"Under MCALL of a drilling cycle some controls drill after a bare G0, G1, F or S as well, at the place where the tool stands. It is read here \
as a block that drills nothing. Put such blocks before MCALL." {
    under_mcall_of_drilling_cycle_this_block()
        "under MCALL of a drilling cycle this block moves no axis; it is read as one that drills nothing";
}

S8034 Warning "siemens-thread-spindle" "thread without a turning spindle"
"G33 follows the turning of the spindle. No block before starts it, so that the machine would wait for a spindle that stands. \
A subprogram may have its spindle started by its caller; then all is well." {
    no_block_in_front_of_this_thread() "no block before this thread starts the spindle";
}

S8035 Note "siemens-argument-unused" "argument that this form of the cycle does not use"
"The cycle has forms that use different arguments. The one named has a value and no meaning for the form of the call, so it changes \
nothing. Check whether the form or the place of the argument is meant otherwise." {
    is_not_used(args, name, why) "{args}: `{name}` is not used {why}";
    form_does_not_use(args, form, key) "{args}: form {form} does not use `{key}`";
}

S8036 Warning "siemens-label-twice" "label that stands twice"
"A jump goes to the nearest label in the direction of its search, so that a label that stands twice leads to different places from \
different blocks, and a block inserted later changes the way. Some controls refuse such a program when it is translated. Rename one of them." {
    label_stands_twice_in_this_program(name) "the label `{name}` stands twice in this program" alarm 12450
        help "rename one of them; a jump goes to the nearest one in its direction";
}

S8037 Note "siemens-callpath" "folder of CALLPATH is not known"
"CALLPATH adds a folder of the control in which called programs are looked for, after `/_N_SPF_DIR` and before `/_N_CUS_DIR`. No `[include] roots` stands for \
this one, and no program of the archive lies in it. Calls that are answered before the search comes to it do not depend on it; a program that would be found after it is refused. Name \
its folder: `[include] roots = { \"/_N_WKS_DIR/_N_SHAFT_WPD\" = \"shaft\" }`." {
    no_folder_of_this_computer_stands(folder)
        "no folder of this computer stands for `{folder}`; a program that it may have is refused";
}

S8038 Warning "siemens-mcall-open" "modal call that is never ended"
"MCALL with a program or a cycle calls it after each block that moves, up to an MCALL without a name. The program ends before: \
every move after the last hole, the retraction to the tool change included, has drilled again." {
    program_ends_with_modal_call() "the program ends with a modal call on";
}

S8039 Note "siemens-copied-folder" "folder beside the program's own stands for one of the control"
"The program lies in a folder that is called as one of the control (`MPF.DIR`, `_N_MPF_DIR` or `MPF`; `WKS.DIR/A.WPD`), so that the folders beside it that are called so are copies of the control's others: `SPF.DIR` is `/_N_SPF_DIR`. A program or the definitions were taken from the one named. `[include] roots` goes before the names: `roots = { \"/_N_SPF_DIR\" = \"other\" }`." {
    stands_for_because_of_its_name(copy, control) "`{copy}` stands for `{control}`, because of its name";
}

S8041 Note "siemens-tap-stop" "spindle stands after rigid tapping"
"G331 and G332 turn the spindle with the drilling axis, and it stands before and after them. An M3 or M4 of before does not count \
any more, so M5 is printed after the tap. Program M3 or M4 again where the next tool path needs it." {
    spindle_stands_after(word, m) "the spindle stands after {word}: the {m} before it does not count any more";
}

S8042 Warning "siemens-tangent-frame" "direction of CT is turned with the frame"
"CT goes on in the direction of the last block that travelled. A frame that turns, mirrors or scales between the two is applied to that \
direction, too, so that the path has a corner there. Program CT before the change of the frame if it shall go on smoothly." {
    frame_has_turned_since_block_in_front()
        "the frame has turned since the block before CT, and the direction of CT is turned with it";
}

S8043 Warning "siemens-compensation-shape" "shape of the compensated path is the target's"
"KONT, KONTT, KONTC, G451, G461 and G462 say how the control leads the tool to a compensated contour, away from it and round its corners. \
With `[output] compensation = \"control\"` the target computes that path by its own rules: watch the entry, the exit and sharp outside \
corners in its simulation." {
    is_left_out(word) "{word} is left out: the target enters, leaves and rounds a compensated contour its way";
}

S8044 Warning "siemens-first-dc" "way of the first DC position of a rotary axis"
"C=DC(30) takes the shortest way to 30 degrees, and C30 of an axis that counts modulo 360 degrees stays inside its turn. No block before says where \
the axis stands, so the position is printed as it is, and the target's rotary axis goes there in its own way. A position of the axis before it, C=0 at the start, makes the way known." {
    way_of_to_machine_position_is_left(letter) "the way of {letter} to a machine position is left to the target";
    where_stands_is_not_known(letter)
        "where {letter} stands is not known: the shortest way of {letter}=DC(…) is left to the target";
    where_stands_is_not_known_its_way(letter)
        "where {letter} stands is not known: its way to this position is left to the target";
}

S8045 Warning "siemens-feed-at-start" "kind of feed that no block names"
"What F counts at the start of a program is a machine datum (MD 20150): mm per minute on most machines, mm per revolution on many lathes. \
An F of 0.2 means two very different things. Program G94 or G95 before the first F, or set `[control] md20150`." {
    no_block_says_what_f_counts() "no block says what F counts: it is taken in mm per minute (G94)";
}

S8046 Warning "siemens-speed-frozen" "constant cutting speed ends without a speed"
"G97, G94 and G95 after G96 keep the speed that the spindle has at this moment. It is computed from the diameter at which the tool stands and \
printed; on the machine it depends on where the control last adapted it. Program S with the word." {
    g96_ends_without_s(turns) "G96 ends without S: the spindle goes on at about {turns} turns per minute"
        help "program S with G97";
}

S8047 Warning "siemens-feed-spindle" "feed per revolution without a turning spindle"
"G95 moves with the turns of the spindle. No block before starts it, so that the machine would wait. \
A subprogram may have its spindle started by its caller; then all is well." {
    no_block_in_front_of_this_feed() "no block before this feed per revolution starts the spindle";
}

S8048 Warning "siemens-via-diameter" "intermediate point of CIP in diameters"
"Under DIAMON the intermediate point of a circle is read as the end point is: I1= along the diameter axis is a diameter. The manuals do not \
list this word among the diameters. Where it is a radius on your control, program DIAMOF and radii for this circle." {
    intermediate_point_of_cip_is_read() "the intermediate point of CIP is read as a diameter, like the end point";
}

S8049 Note "siemens-goto-start" "jump to the start of the program is left out"
"GOTOS goes back to the start of the program where the machine (its PLC) asks for another run. The output is one run; start it again on the target." {
    gotos_is_left_out() "GOTOS is left out: the machine decides whether the program starts again";
}

S8050 Warning "siemens-count-rounded" "number of holes is rounded"
"The number of holes is an INT of the cycle, and the control rounds a REAL that is given for one: 4.5 holes become 5. Write a whole number, or \
look at the formula that makes it." {
    argument_is_cycle_counts(args, place, given, count)
        "{args}: argument {place} is {given}, and the cycle counts {count}" help "write a whole number";
}

S8130 Note firm "siemens-axis-left-out" "axis that is left out"
"`[machine] axes` says that the target has no such axis. Its words are left out of every block; other words of the blocks are printed. See to it that \
the axis stands where the program needs it." {
    axis_is_left_out(named) "the axis {named} is left out, as `[machine] axes` says";
}

S8133 Warning "siemens-thread-shifted" "start of a thread is shifted"
"SF=, the start angle and further starts of a thread cycle begin a thread at an angle of the spindle, which the target cannot. It begins farther back by lead · angle / 360 instead and is the same thread from the \
programmed start on. The tool goes to that place at rapid traverse: see that no shoulder and no tailstock stands there." {
    is_made_by_start_that_lies_mm(word, start, back, axis)
        "{word}={start} is made by a start that lies {back:.4} mm farther back along {axis}, where the tool goes at \
        rapid";
    start_angle_by_cuts_farther_back(args, angle, back)
        "{args}: the start angle {angle} is made by cuts that begin up to {back:.4} mm farther back, where the tool goes at rapid"
        help "see that nothing stands there";
    starts_by_cuts_farther_back(args, starts, back)
        "{args}: {starts} starts are made by cuts that begin up to {back:.4} mm farther back, where the tool goes at rapid"
        help "see that nothing stands there";
    angle_and_starts_by_cuts_farther_back(args, angle, starts, back)
        "{args}: the start angle {angle} and {starts} starts are made by cuts that begin up to {back:.4} mm farther back, where the tool \
        goes at rapid"
        help "see that nothing stands there";
}

S8134 Warning "siemens-g40-waits" "G40 without a move in the plane"
"The manuals want G40 in a block that moves in the working plane (alarm 10754); programs that ran have it before a retraction along the tool. The offset stays \
through such moves and is taken off in the next G0 or G1 with an axis of the plane, an arc there is refused. `[control] g40_without_motion = \"error\"` refuses it at once." {
    g40_stands_in_front_of_move()
        "G40 stands before a move that leaves the plane alone: the offset is taken off in the next move in the \
        plane";
}



S8172 Warning "siemens-variable-unused" "value of `[variables]` is not used"
"The program reads a value of the control that follows from the program itself or from the data of the tool, and `[variables]` gives another one. What partc computes goes first: \
`[tools]` says the radius that `$P_TOOLR` reads, and that compensates. Take the entry out of `[variables]`, or correct the data of the tool." {
    of_variables_is_not_used(key, given, taken)
        "`{key}` = {given} of `[variables]` is not used: the program, `[tools]` or another key make it {taken}"
        help "take `\"{key}\"` out of `[variables]`, or correct what says otherwise";
}

S8190 Warning "siemens-g53-beside-g500" "machine coordinates beside positions under G500"
"Positions under G500 count from the basic system and are printed as they stand, in the offset that is active on the target at the start. Those of G53, G153 and SUPA \
count from the machine zero. The way between the two is the basic frame of the machine: give it by `[datums] basic`, or see that the offset on the target lies where the \
basic system of the control lies." {
    moves_in_machine_coordinates()
        "moves in machine coordinates (G53, G153, SUPA) stand beside moves under G500, and where the basic system \
        lies from the machine zero is not known";
}

S8191 Warning "siemens-g96-shifted" "constant cutting speed under a shift of the diameter axis"
"G96 makes the speed of the spindle from the diameter at which the tool stands. The target takes the printed coordinate, in which a TRANS of the diameter axis is contained; \
which of the two the control takes is not confirmed. Look at the speed on the machine, end the shift before the cut, or program G97 with a speed." {
    under_g96_frame_shifts_diameter_axis(shift)
        "under G96 the frame shifts the diameter axis by {shift} mm in radius: the target takes its speed from the \
        printed diameter, the control may take the programmed one"
        help "end the shift before the cut, or program the speed by G97 S";
}

S8192 Warning "siemens-point-without-axis" "G74 or G75 without an axis"
"G74 and G75 move the axes that their block names to points of the machine. This block names none, so nothing is printed for it; a retraction that it may stand for is \
not made. Name the axes: `G75 X1=0 Z1=0`." {
    names_no_axis(word) "{word} names no axis: nothing moves";
}

S8193 Warning "siemens-disc" "DISC is read as a circle"
"DISC=1 to DISC=100 stretch the arc about an outside corner towards the intersection; the curve is not published. With `[control] disc = \"circle\"` the tool goes around \
the corner on a circle, as under DISC=0: it touches the same contour, on a shorter way." {
    disc_is_read_as_disc_0(overshoot) "DISC={overshoot} is read as DISC=0: outside corners get circles"
        help "check the corners";
}

S8194 Warning "siemens-edge-position" "centre of the nose by the position of the edge"
"The path of a turning tool is that of its theoretical tip. From there the centre of the nose lies as the position of the cutting edge says (`$TC_DP2`, or `orientation` in partc.toml): \
3 is an outside tool that cuts towards the chuck, 2 a boring bar, 9 the centre itself. No available manual confirms the table: compare it with the tool data of the control once." {
    cutting_edge_position(position, radius, radius2)
        "cutting-edge position {position}: the centre of the nose lies Z{radius:+} X{radius2:+} mm in radius from \
        the programmed point";
}

S8195 Warning "siemens-corner-code" "G450 or G451 in a block of the contour"
"G450 and G451 change inside a compensated contour, in a block that moves. The manuals do not say whether the corner before the block or the one after it is meant: the one after \
it is taken. Write the code into a block without a move." {
    stands_in_block_of_contour(word)
        "{word} stands in a block of the contour: it counts from the end of this block on";
}

S8196 Note "siemens-fad" "FAD has no effect in this approach or retraction"
"FAD is the feed of the slow way from DISCL to the contour plane. A retraction under G340 goes at F, and where DISCL is missing there is no such way." {
    fad_has_no_effect_here(why) "FAD has no effect here: {why}";
}

S8197 Warning "siemens-no-discl" "soft approach without DISCL"
"Without DISCL the height at which the fast infeed ends is that of the contour: the tool goes into the material at the velocity of the block before. So the manuals are read; \
none says it in words. Program DISCL and FAD." {
    has_no_discl(soft) "{soft} has no DISCL: the tool goes to the contour plane at rapid traverse";
}

S8160 Warning "siemens-contour-inches" "records of a contour are read in inches"
"The NC blocks of a contour of the contour editor are missing, and the unit in force is the inch, so its hidden records are taken as inches, as the \
blocks would be. No stored contour of inches is known to us: compare the size of the part with the drawing." {
    records_of_this_contour_are_read()
        "the records of this contour are read in inches, the unit in force where it stands";
}

S8161 Warning "siemens-contour-start-undercut" "contour starts with an undercut"
"The NC blocks of a contour of the contour editor are missing, and its records put an undercut at its start. The contour is begun where the undercut \
leaves the line before it, as is done for a chamfer or a rounding there; what the editor writes for an undercut was never seen." {
    contour_starts_with_undercut()
        "the contour starts with an undercut, and is taken to begin where that leaves the line before it";
}

S8164 Warning "siemens-cycle-from-unknown-place" "cycle begins at a place that is not known"
"Before the cycle the tool was changed, and no block has placed it since, so that where it stands is not known. The cycle goes to the front of the part in one rapid move, \
as to any first position, and comes back there; on the control it may end where it came from. After it the position counts as not known again. Position the tool before the cycle." {
    where_tool_stands_is_not_known(args)
        "{args}: where the tool stands is not known: it goes to the front of the part first"
        help "position the tool in X and Z before the cycle";
}
}
