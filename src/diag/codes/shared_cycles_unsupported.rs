//! Cycles that no language compiles.

super::codes! { SHARED_CYCLES_UNSUPPORTED:

P9010 Error "cycle-unsupported" "cycle is not supported" was "K9001 S9005 siemens-cycle T9006 turning-cycle"
usual "program the moves of the cycle as blocks"
"The cycle is known, and partc cannot make its path. A path without it would leave out material removal, so nothing is written.\n\n\
Klartext: The cycle is read, but partc cannot compute its path yet, and a path without it would leave out material removal. Nothing is \
written.\n\n\
SINUMERIK: The cycle or procedure of the control is known by name and not built. Nothing is left out in silence, so the program is \
refused. Where a key leaves it out, the message names it.\n\n\
HEIDENHAIN turning: The cycle is known, its parameters are checked, but partc does not make its moves. Nothing is written." {
    is_to_be_left_out_as_cycle(name, word)
        "{name} is to be left out as a cycle that does nothing to the path, and `{word}` in its definition says \
        otherwise";
    cycle_is_not_known(number, name) "cycle {number} is not known"
        asks "if it is a cycle of the machine builder that moves nothing, leave it out: `[programs]` with \
        `\"{name}\" = {{ ignore = true }}`; if it moves, program its moves as blocks";
    going_out_of_pocket_at_feed(feed) "going out of the pocket at a feed (Q208 = {feed}) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    what_coarse_tool() "what a coarse tool (Q18) left is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    contour_whose_label_stands_in_another_program()
        "a contour whose label stands in another program than the call is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    contour_at_places_of_pattern() "a contour at the places of a pattern or of CYCL CALL POS is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    cycle_acts_where_it_is_defined(number, what)
        "cycle {number} {what} acts where it is defined, and is not supported";
    cycle_is_not_supported_yet(number, what) "cycle {number} {what} is not supported yet";
    cycl_call_pos_with_program_call()
        "CYCL CALL POS with the program call of cycle 12 is not supported: what its Z shifts is open"
        help "move to the position with L, and call with M99";
    with_program_of_cycle_12_is_not(by, name) "{by} with the program `{name}` of cycle 12 is not supported";
    lifting_edge_off_wall_under_mirror()
        "lifting the edge off the wall under a mirror, rotation or scaling is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    tapping_under_scaling() "tapping under a scaling, which would change the pitch of the thread, is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    pattern_or_cycl_call_pos_with_face()
        "a pattern or CYCL CALL POS with a face that has a place of its own is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    paths_from_outside_inwards() "paths from outside inwards (Q389=4) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    paths_without_overrun() "paths without overrun (Q389=3) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    face_with_limit_is_not_supported(limit, value) "a face with a limit ({limit}={value}) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    m_function_is_not_supported(q, other) "the M function {q} = {other} is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    pecking_is_not_supported(infeed) "pecking (Q202 = {infeed}) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    another_feed_than_that_of_q206() "another feed than that of Q206 (Q401) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    dwell_depth() "a dwell depth (Q435) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    leaves_speed_that_is_not_known(name, what) "{name} leaves a speed that is not known, as `[programs]` says"
        help "say the speed that the {what} leaves: `\"{name}\" = {{ ignore = true, speed = 1000 }}`";
    pattern_of_slots_about_one_centre()
        "a pattern of slots whose centre is Q216 and Q217 (Q367=0), so that every place would be the same slot, is not \
        supported"
        help "write Q367=+2, so that the places are those of the middles of the slots";
    going_sideways_at_rapid() "going sideways through the material at rapid traverse (Q253=FMAX) is not supported"
        help "write Q253 as a number, or take a tool that is nearly as wide as the core of the thread";
    lower_feed_at_full_engagement() "a lower feed at full engagement (Q401) is not supported"
        help "write Q401=+100, and Q12 as the feed that the tool bears at full engagement";
    old_slot_with_another_tool(width, tool)
        "a slot of {width} mm with a tool of {tool} mm (where the slot lies beside the tool is not documented) is not \
        supported"
        help "take a tool as wide as the slot, or program cycle 253 with its place";
    fauto_with_tool_call_that_counts_f(q) "{q}=FAUTO with a TOOL CALL that counts F in another way is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    word_as_value(word, q) "{word} as the value of {q} is not supported" help "write a number: `{q}=+750`";
    fu_without_number(q) "FU as the value of {q} is not supported"
        help "write the number of FU after it, or the feed a minute: mm per revolution times the speed: `{q}=+750`";
    fz_without_number(q) "FZ as the value of {q} is not supported"
        help "write the number of FZ after it, or the feed a minute: mm per tooth times the teeth and the speed: \
        `{q}=+750`";
    feed_of_cutting_edge_is_not_supported(other) "a feed of the cutting edge (Q439={other}) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    running_it_at_places_of_pattern_def()
        "running it at the places of PATTERN DEF or of a point table is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    cycl_call_pos_is_supported_for_cycles()
        "CYCL CALL POS is supported for cycles from 200 on, with absolute X, Y and Z"
        help "write `CYCL CALL POS X+50 Y+50 Z+0 FMAX`, or move with L and call with M99";
    with_face_which_has_heights(by)
        "{by} with a face, which has heights of its own in place of Q203, is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    going_from_place_to_place_on_arcs() "going from place to place on arcs (Q365=1) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    pattern_of_cycle_is_not_supported(cycle) "a pattern of cycle {cycle} is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    this_pattern_is_not_supported() "this pattern is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    call_at_one_end_of_slot(other) "a call at one end of the slot (Q367={other}) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    program_of_cycle_12_changes_coordinate_system(name)
        "the program `{name}` of cycle 12 changes the coordinate system, and the pattern shifts it"
        help "let the program leave the system as it was";
    cycl_call_pat_with_program_of_cycle(name)
        "CYCL CALL PAT with the program `{name}` of cycle 12 under a rotation, mirror or scaling: along which axes \
        the places shift is open"
        help "end the transformation before the pattern";
    cycl_call_pat_with_program(name)
        "CYCL CALL PAT with the program `{name}` of cycle 12: the places have a Z, and what it shifts is open"
        help "leave Z out of the pattern";
    cycl_call_pat_with_program_of_cycle_12(name)
        "CYCL CALL PAT with the program `{name}` of cycle 12: what the places are to it is open"
        asks "say it by `[cycles] pattern_program = \"shift\"` or \"position\", or call the program at each place by \
        M99";
    pattern_or_cycl_call_pos_with_surface()
        "a pattern or CYCL CALL POS with a surface that has a place of its own is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    pattern_with_centre_of_its_own()
        "a pattern with a centre of its own (Q216, Q217), so that every place would be the same, is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    approach_at_corner_is_not_supported(approach) "an approach at a corner (Q437={approach}) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    radius_or_chamfer_at_corners_of_polygon()
        "a radius or chamfer at the corners of the polygon (Q220) is not supported"
        help "set Q220 to 0 and round the corners by a contour, or program the moves as blocks";
    chamfer_at_corners_is_not_supported(corner) "a chamfer at the corners (Q220={corner}) is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    milling_under_mirror() "milling under a mirror, which would change the hand of the thread, is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    q256_0_with_q403() "Q256 = 0 with Q403, whose speed back into the hole is not known, is not supported"
        help "use the plain variant of the cycle, or program its moves as blocks";
    curve_table_has_no_ctabend() "the curve table has no CTABEND: all blocks after it belong to it";
    in_curve_table_only_positions_of_axes() "in a curve table only positions of axes are left out";
    oscillation_moves_beside_path(name, axis)
        "{name} (oscillation) moves {axis} beside the path, and {axis} is in the output";
    is_not_supported(name, kind) "{name} ({kind}) is not supported";
    procedure_is_not_supported(name, what) "{name} ({what}) is not supported"
        help "take it out of the copy that is compiled, or program what it does in blocks";
    procedure_may_be_left_out(name, what) "{name} ({what}) is not supported"
        asks "leave it out, where the target manages its tools: `[programs] {name} = {{ ignore = true }}`";
    cycle_is_not_supported_but_file_may_run(name, what, instead) "{name} ({what}) is not supported"
        asks "{instead}; or say what runs instead: `[programs] {name} = {{ file = \"stubs/{name}.SPF\" }}`";
    lets_follow(name, spindle) "{name} lets {spindle} follow: a spindle that follows is never left out"
        help "program its speed and sense as blocks";
    lets_follow_and_is_in_output(name, axis)
        "{name} lets {axis} follow, and {axis} is in the output: without the coupling it would stand still";
    ctabend_ends_no_curve_table() "CTABEND ends no curve table" help "write CTABDEF before its first point";
    is_not_supported_as_modal_call(word, what) "{word} ({what}) is not supported as a modal call";
    is_not_supported_so_replace(symbols, what) "{symbols} ({what}) is not supported" help "replace it by plain moves";
    stands_under_radius_compensation(probe) "{probe} stands under radius compensation, in a contour or under MCALL"
        help "program G40 before it, and measure outside of contours and modal calls";
    measuring_is_not_supported(probe) "{probe} (measuring) is not supported";
    stands_under_radius_compensation_or_in_contour(name) "{name} stands under radius compensation or in a contour"
        help "program G40 before it, and measure outside the contour";
    measuring_cycle_is_not_supported(name) "{name} (measuring cycle) is not supported";
    cycle_of_control_or_of_machine_builder(name, line)
        "{name} (a cycle of the control or of the machine builder) is not supported"
        help "replace it by plain moves, or put its program beside this one; or {line}";
    asks_for_tool_of_spindle(name, number) "{name} asks for the tool of spindle {number}, which is not the master"
        help "write the number of the tool itself";
    gett_asks_for_sister(name) "GETT asks for a sister of \"{name}\", which only the control knows"
        help "write the number of the tool itself";
    g85_of_din_plus_is_not_supported() "G85 of DIN PLUS is not supported"
        help "describe the undercut with G25 in the contour";
    g86_of_din_plus_is_not_supported() "G86 of DIN PLUS is not supported"
        help "describe the recess in the contour and program G869";
    cycle_at_place_of_clearance(number, high)
        "cycle {number} at a place of CLEARANCE {high} mm: how it comes down from there to its set-up clearance is open"
        help "move to the set-up clearance above the places before CYCL CALL PAT, or give the places by cycle 220 or 221";
    cycle_starts_where_tool_stands(number, height, clearance, start)
        "cycle {number} starts where the tool stands, at {height} mm, and the set-up clearance {clearance} mm above the Z of the place is {start} mm: which of the two counts is open"
        help "move to the set-up clearance above the places before CYCL CALL PAT, or give the places by cycle 220 or 221";
}
}
