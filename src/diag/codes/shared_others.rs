//! Facts that several languages share: geometry, readings, what is not supported.

super::codes! { SHARED_OTHERS:

P9014 Error "offset-unmapped" "work offset has no counterpart" was "K2505 preset-unmapped S9014 siemens-offset-unknown"
"The target has fewer work offsets than the control.\n\n\
Klartext: Presets 1 to 9 become G54 to G59.3. For any other number name the work offset in partc.toml: `[datums]` with `preset.12 = \
\"G55\"`.\n\n\
SINUMERIK: The selected target has fewer work offsets. Say which one stands for this: `[datums] G510 = \"G55\"`." {
    preset_has_no_work_offset(number) "preset {number} has no work offset";
    has_no_counterpart_on_target(word, free) "{word} has no counterpart on the target"
        asks "name one: `[datums] {word} = \"{free}\"`";
}

P9013 Error "compensation-unresolved" "path of the compensated tool cannot be computed here" was "K9007 M9004 mtc-compensation-unsupported S9010 siemens-resolve"
"Klartext: With `compensation = \"resolve\"` the output is the path of the tool centre. What the control does here is not confirmed: a \
tool radius below zero, compensation under M128, or a rounding as way to the contour or from it, for which `[control] rounded_approach = \
\"round\"` chooses a reading. Program it in another way, or set `[output] compensation = \"control\"` to print the programmed contour \
with G41/G42 and let the target compensate.\n\n\
MTC200: The path beside a contour under G41 and G42 needs the radius of the tool, on a lathe its cutting-edge position too, and no \
correction D; after more than two blocks without a move in the plane the control takes the contour as finished. Outside corners get \
arcs, as after G43: no available manual says how long the chamfers of G44 are. With `[output] compensation = \"control\"` the contour is \
printed with G41 and G42, and the target compensates.\n\n\
SINUMERIK: The path of the tool centre needs the radius of the tool, on lathes also the position of its cutting edge, and rules that are \
published: compensation in space, approaches on polynomials (KONTT, KONTC) and the curves of DISC are not. Tool data come from \
partc.toml or from `$TC_DP` of the program. With `[output] compensation = \"control\"` the contour is printed with G41 and G42." {
    how_control_leads_tool_there_is_not(what, help_) "{what}: how the control leads the tool there is not confirmed"
        asks "{help_}, or set `[control] rounded_approach = \"round\"`";
    under_m128_radius_compensation_is_one() "under M128 the radius compensation is one in space"
        help "program M129 before the contour";
    radius_of_tool_with_its_oversizes(radius)
        "the radius of the tool with its oversizes is {radius} mm: what a control does below zero is not known"
        help "make the oversize DR smaller, or swap RL and RR and give the radius without its sign";
    blocks_in_front_of_this_one(before, most_without_move)
        "{before} blocks before this one do not move in the plane: the control takes the compensated contour as \
        finished after {most_without_move}"
        help "put them before G41 and G42, or after G40";
    cutting_edge_position_of_tool_is_not(tool) "the cutting-edge position of tool {tool} is not known"
        asks "add it to `[tools]` in partc.toml, or set `[output] compensation = \"control\"` to print G41 and \
        G42";
    radius_of_edge_e_in_force()
        "the radius of the edge E in force only the machine knows: `[tools]` describes the first edge"
        asks "compensate the first edge, or set `[output] compensation = \"control\"` to print G41 and G42";
    what_correction_d_in_force_adds()
        "what the correction D in force adds to the radius of the tool only the machine knows"
        asks "leave D out, or set `[output] compensation = \"control\"` to print G41 and G42";
    chamfers_at_outside_corners() "chamfers at outside corners (G44) are not supported"
        help "program G43: an arc leads around outside corners";
    t_is_turning_tool(number) "T{number} is a turning tool, and its nose is compensated in the plane ZX only"
        help "select G18 before G41 and G42";
    frame_tilts_working_plane() "a frame tilts the working plane, and radius compensation is on"
        help "turn the frame about the tool axis only, or have the CAM system put out the centre path";
    under_disc_tool_goes_around_corners(overshoot)
        "under DISC={overshoot} the tool goes around corners on a curve that is not published"
        asks "program DISC=0 or G451, or accept the circle: `[control] disc = \"circle\"`";
    leads_to_contour(word) "{word} leads to the contour and from it on a polynomial, which is not published"
        help "program NORM or KONT, or the approach by arcs";
    under_radius_is_compensated_in_space(word)
        "under {word} the radius is compensated in space, which cannot be printed"
        help "have the CAM system put out the centre path";
    offn_is_larger_than_radius_of_tool(normal, radius)
        "OFFN={normal} is larger than the radius {radius} of the tool and swaps its side"
        help "program the other one of G41 and G42";
    radius_of_t_d_is_not_known(number, edge) "the radius of T{number} D{edge} is not known"
        asks "give it in partc.toml: `[tools.{number}] radius = 5.0`, or in the program: \
        `$TC_DP6[{number},{edge}]=5`";
    offn_changes_while_radius_compensation() "OFFN changes while radius compensation is on"
        help "program it in the block of G41, G42 or G40";
    offset_of_tool_that_program_adds_cannot() "an offset of the tool that the program adds cannot be printed"
        asks "put it into the tool data, or have the path computed: `[output] compensation = \"resolve\"`";
    stands_in_contour_whose_compensation_has_begun(word)
        "{word} stands in a contour whose compensation has begun already"
        help "end the contour with G40, or program G41 or G42 in the block of the approach";
    offset_of_tool_that_program_adds() "an offset of the tool that the program adds cannot be printed"
        help "put it into the tool data";
    radius_of_t_d_is_not(number, edge, what) "the radius of T{number} D{edge} is not known: {what}"
        help "write it before G41 or G42: `$TC_DP6[{number},{edge}]=…`";
    program_changes_radius_of_active_tool() "the program changes the radius of the active tool by `$P_AD`"
        help "write `$TC_DP6` of the tool before its selection";
    data_of_t_d_were_written_after(number, edge)
        "the data of T{number} D{edge} were written after its selection, and no D stands after them: whether they \
        count already is not documented"
        help "program D{edge} after the assignment";
    radius_of_tool_is_below_zero_for_path(tool) "the radius of tool {tool} is below zero"
        asks "add it to `[tools]` in partc.toml, or set `[output] compensation = \"control\"` to print G41 and \
        G42";
    radius_of_tool_is_not_known_for_path(tool) "the radius of tool {tool} is not known"
        asks "add it to `[tools]` in partc.toml, or set `[output] compensation = \"control\"` to print G41 and \
        G42";
    is_on_already(code) "{code} is on already: whether it then holds its offset is not documented"
        help "leave the word out";
    follows_without_g40(code, old) "{code} follows {old} without G40: how the tool changes sides is not documented"
        help "program G40 with a move in the plane in between";
    is_no_position_of_edge(position) "{position} is no position of a cutting edge" help "positions are 1 to 9";
    position_of_edge_is_not_known(number, edge) "the position of the cutting edge of T{number} D{edge} is not known"
        asks "give it in partc.toml: `[tools.{number}] orientation = 3`, or in the program: \
        `$TC_DP2[{number},{edge}]=3`; 9 is the centre of the nose";
}

P3001 Error "end-off-circle" "end point does not lie on the circle" was "M2010 mtc-circle-end S3007 siemens-end-off-circle"
"MTC200: Start and end of the arc have different distances from the centre, read as coordinates or as distance from the start. Check \
start, end and centre. CAM systems that round coarsely may need a larger `[control] circle_tolerance` (default 0.01 mm).\n\n\
SINUMERIK: Start and end have the same distance from the centre, within MD 21000 (0.01 mm) or MD 21010 (a thousandth of the radius): \
alarm 14040. Check start, end and centre; I, J and K count from the start point." {
    end_point_misses_circle_about_centre(shown) "the end point misses the circle about the centre by {shown}"
        asks "check start, end and centre, or raise `[control] circle_tolerance`";
    centre_of_this_full_circle_lies() "the centre of this full circle lies on its start point"
        help "check I, J and K: under G90 they are coordinates of the centre, under G91 distances from the start";
    circle_ends(a, b)
        "the circle ends in {a} and {b}, and its centre is said along other axes: as they are in order here it does \
        not close" alarm 14040;
    start_lies_mm_from_centre(r1, r2)
        "the start lies {r1:.4} mm from the centre, the end {r2:.4} mm, and no centre near it fits both" alarm 14040
        help "check start, end and centre";
    start_lies_mm_from_centre_end(r1, r2) "the start lies {r1:.4} mm from the centre, the end {r2:.4} mm" alarm 14040
        asks "check start, end and centre; `[control] md21000` and `md21010` set the tolerance";
}

P3002 Error "arc-open" "arc without centre or radius" was "M2008 mtc-centre-missing S3003 siemens-arc-open"
"MTC200: A block under G02 or G03 names an end point, but neither I, J, K nor R. Often a G01 is missing after an arc. Program the centre \
or the radius, or G01.\n\n\
SINUMERIK: A circle needs a centre, a radius or an angle, and an arc by radius an end point that differs from its start: alarm 14040." {
    radius_of_arc_is_0() "the radius of the arc is 0";
    arc_has_neither_centre_nor_radius() "the arc has neither centre nor radius"
        help "program I, J, K or R, or G01 if a line is meant";
    arc_has_neither_centre_nor_so_give_i() "the arc has neither a centre nor a radius" alarm 14040
        help "give I, J, K, CR= or AR=; for a straight line program G1";
    ar_needs_end_point_or_centre() "AR= needs an end point or a centre" alarm 14040;
    arc_by_cr_ends_where_it_starts() "the arc by CR= ends where it starts" alarm 14040
        help "program a full circle with I, J, K";
    arc_by_cr_needs_end_point() "an arc by CR= needs an end point that differs from its start" alarm 14040
        help "program the end point, or a full circle with I, J, K";
    arc_starts_in_its_centre() "the arc starts in its centre" alarm 14040
        help "I, J and K lead from the start to the centre, whatever G90 and G91 say; with AC(…) they are the centre itself";
    arc_ends_in_its_centre() "the arc ends in its centre" alarm 14040
        help "I, J and K lead from the start to the centre, whatever G90 and G91 say; with AC(…) they are the centre itself";
}

P8140 Warning "block-not-run" "block that does not run could not be compiled" was "K8001 S8040 siemens-block-not-run"
"`partc check` looks at every block, also at those that this run of the program leaves out: after M30, in subprograms that nothing \
calls, after a jump, in a branch not taken. The output does not depend on this one, so it is no error; if it ever runs, it will be \
refused. `partc explain` with the code that the text names says why." {
    this_jump_is_not_taken(message, id) "this jump is not taken; if it were, it would be refused: {message} ({id})";
    this_block_does_not_run(title, id) "this block does not run; if it did, it would be refused: {title} ({id})"
        help "see `partc explain {id}`";
    this_block_does_not_run_if_it_did(bare, id)
        "this block does not run; if it did, it would call `{bare}`, which is not here ({id})";
    this_jump_is_not_made(what, way, id)
        "this jump is not made; if it were, there is no {what}{way} (alarm 14080, {id})"
        help "check the target and the sense of the jump";
}

P8105 Note "stand-in" "call that `[programs]` stands for" was "K2413 cycle-left-out S8135 siemens-stand-in"
"Klartext: A cycle: no manual of the control has the cycle: it belongs to the machine builder. `[programs] \"CYCL DEF 392\" = { ignore = \
true }` says that it moves nothing and changes nothing that the program relies on, so its definition is left out, and the machining \
cycle that was defined before stays defined. Where it moves axes, name them: `{ ignore = true, lost = [\"Z\"] }`. A program that a block \
calls and that is found nowhere is left out in the same way by its name: `HEADCLEAN = { ignore = true }`, with `change = true` it \
changes to the tool of the TOOL CALL before it. Q parameters that it would set keep what they were.\n\n\
SINUMERIK: The program belongs to the machine builder and is not here. `[programs]` says that its call changes the tool, or is left out; \
whatever else the program does on the machine (coolant, retraction, speed) is not in the output, and the axes stand where the call found \
them, or after a tool change where `[machine] after_tool_change` says. G0 or G1 that it leaves active is `motion = \"G0\"`, axes that \
it moves away `lost = [\"X\"]`. Give a program of your own for it (`TC = { file = \"stubs/TC.SPF\" }`) where more of it is needed." {
    changes_tool(name) "`{name}` changes the tool, as `[programs]` says; whatever else it does is left out";
    is_left_out(name) "`{name}` is left out, as `[programs]` says: the Q parameters keep what they were";
    is_left_out_as_programs_says(name) "{name} is left out, as `[programs]` says";
    is_left_out_with_words(name, words) "{name} is left out, as `[programs]` says, and with it `{words}`";
    changes_tool_as_programs_says(name, left) "{name} changes the tool, as `[programs]` says; {left} left out";
}

P8106 Warning "reading-not-confirmed" "reading that no available manual confirms" was "M8004 mtc-reading S8162 siemens-cycle-reading"
"MTC200: What the program says here is read in a way that fits the names of the words and the programs seen, but that no available \
manual confirms for this control. Check it once at the machine; then list it in `[control] confirmed`, and the warning is gone.\n\n\
SINUMERIK, Klartext: The argument has a meaning that follows from its name, from a few stored programs or from similar cycles, and no \
available manual says it. partc takes it as the message says; compare with what the machine does." {
    q573_0_is_read_as_inscribed_circle() "Q573 = 0 is read as the inscribed circle; this is not confirmed"
        help "compare the size of the stud with what the machine makes";
    q573_1_is_read_as_circumscribed_circle() "Q573 = 1 is read as the circumscribed circle; this is not confirmed"
        help "compare the size of the stud with what the machine makes";
    of_0_in_millions_of_vari_is_taken()
        "0 in the millions of `_VARI` is taken as 1: relief cuts are machined; this is not confirmed"
        help "compare with what the machine does";
    u1_moves_contour_by_its_amount_along()
        "`_U1` moves the contour by its amount along X, as a radius, and along Z; this is not confirmed"
        help "compare with what the machine does";
    falx_counts_on_radius() "`FALX` counts on the radius; this is not confirmed"
        help "compare with what the machine does";
    part_catcher_at_diameter_is_left_out(args, diameter)
        "{args}: the part catcher at diameter {diameter} is left out: the cut goes on";
    enc_11_is_tapping_without_encoder()
        "ENC 11 is tapping without an encoder, with a feed made of S and the pitch; this is not confirmed"
        help "compare with what the machine does";
    enc_20_is_tapping_with_encoder() "ENC 20 is tapping with an encoder and a dwell; this is not confirmed"
        help "compare with what the machine does";
    hundreds_of_dmode_name_spindle_of_lathe()
        "the hundreds of `_DMODE` name the spindle of a lathe, and the tap takes the master spindle; this is not \
        confirmed"
        help "compare with what the machine does";
    amode_says_that_dam_is_percentage()
        "`_AMODE` says that DAM is a percentage (digit 2 of the hundred thousands); this is not confirmed"
        help "compare with what the machine does";
    first_depth_counts_for_tip_of_drill()
        "the first depth counts for the tip of the drill, the last one for its full diameter; this is not confirmed"
        help "compare with what the machine does";
    digits_are_read_so(args, what) "{args}: {what}; this is not confirmed" help "compare with what the machine does";
    which_digit_of_vari_is_predrilling(args)
        "{args}: which digit of `_VARI` is predrilling and which is through-drilling is not confirmed: both zones \
        are drilled slowly"
        asks "say it by `[cycles] cycle82_vari`: \"thousands-through\" or \"thousands-predrill\"";
    below_0_is_taken_without_its_sign(length) "`{length}` below 0 is taken without its sign; this is not confirmed"
        help "compare with what the machine does";
    feed_of_0_percent_is_taken() "a feed of 0 percent is taken as 100; this is not confirmed"
        help "compare with what the machine does";
    sdis_has_no_sign() "SDIS has no sign, and its minus is left out; this is not confirmed"
        help "compare with what the machine does";
    gdep_is_taken_for_return_distance()
        "`_GDEP` is taken for a return distance of the editor, which changes no pass; this is not confirmed"
        help "compare with what the machine does";
    gst_1_is_first_start()
        "`_GST` 1 is the first start that is cut, and the thread has one start; this is not confirmed"
        help "compare with what the machine does";
    numt_0_is_taken_as_one_start() "NUMT 0 is taken as one start; this is not confirmed"
        help "compare with what the machine does";
    thousands_of_amode()
        "the thousands of `_AMODE` (1 for `_FAL`, else `_FALX` and `_FALZ`) choose the other allowance, and roughing \
        leaves this one; this is not confirmed"
        help "compare with what the machine does";
    falx_counts_on_radius_this_is_not() "`_FALX` counts on the radius; this is not confirmed"
        help "compare with what the machine does";
    third_axis_moves_evenly(key) "the third axis of an arc moves evenly with it, as a helix"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    r_is_true_radius(key) "R is the true radius: above zero of the arc up to 180°, below zero of the other"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    lead_of_taper_counts_along_longer(key) "the lead of a taper counts along the axis of the longer travel"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    g16_switches_diameters_on(key) "G16 switches diameter programming on, and G15 off"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    g50_replaces_everything(key) "G50 replaces everything that G51 and G52 added before"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    g43_is_in_force_at_start(key)
        "G43 is taken to be in force at the start: arcs lead around outside corners"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    f_of_g04_counts_in_seconds(key) "the F of G04 counts in seconds"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    g90_and_g94_are_in_force(key)
        "G90 and G94 are taken to be in force at the start, and the program does not say so before this"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    bra_goes_on_at_its_label(key) "BRA goes on at its label"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    branches_look_at_last_assignment(key) "BEQ, BNE, BPL and BMI look at the result of the last assignment"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    bsr_calls_its_label(key) "BSR calls what stands at its label, up to RTS"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    jsr_calls_program(key) "JSR calls a program, up to RTS"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    hlt_waits_for_operator(key) "HLT waits for the operator"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
    angles_count_in_degrees(key) "angles in formulas count in degrees"
        asks "if the control does so, add `[control] confirmed = [\"{key}\"]`";
}

P9011 Error "function-unsupported" "function is not supported" was "K9011 M9001 mtc-g-unsupported S9001 siemens-unsupported T9001 turning-function"
usual "remove the function if the path does not depend on it"
"What the function does to the path cannot be compiled. Nothing is left out in silence.\n\n\
Klartext: The block is a function of newer controls that partc reads by name but does not execute. It may influence the path, so it is \
refused.\n\n\
MTC200: The function exists on the control, or was defined by the machine builder, but what it does to the path cannot be compiled, or \
is not documented well enough. One that partc knows by name moves the tool or says where it goes: program that another way. A function \
of the machine builder that is known not to move the tool or change the path on this machine may be listed in `[control] machine_words`, \
for example `[\"G120\"]`. Beside axes, I to K, R, F, P, D or E that no G0, G1, G2 or other function of the block takes it is refused: \
they may be its arguments.\n\n\
SINUMERIK: The word changes how the machine moves in a way that plain G-code cannot say, or that is not built. Replace it by plain \
moves.\n\n\
HEIDENHAIN turning: The function is known by its name but not compiled, or it is not a function of these controls. Nothing is left out \
in silence: the program is refused." {
    is_parameter_by_name(shown) "`{shown}` is a parameter by name, which is not supported"
        help "use a Q parameter: `Q1`";
    global_def_125_decides_where_tool_goes()
        "GLOBAL DEF 125 decides where the tool goes between the places of a pattern, which is not supported"
        help "remove the block: the tool retracts to the 2nd set-up clearance";
    fn_is_not_supported(number) "FN {number} is not supported";
    fn_24_fits_circle_to_four_points() "FN 24 fits a circle to four points, and how it does is not documented";
    is_not_supported(name) "{name} is not supported"
        help "write the branch as a jump: `FN 9: IF +Q1 EQU +5 GOTO LBL 1`";
    is_cutting_speed(word_text)
        "`{word_text}` is a cutting speed, and partc does not compute the speed of the spindle from it"
        help "write the speed: S = 1000 · VC / (π · diameter of the tool)";
    is_not_supported_2(name, what) "{name} ({what}) is not supported";
    is_not_supported_3(name) "{name} is not supported";
    ret_back_to_start_of_main_program() "RET back to the start of the main program is for ISO programs";
    turns_plane_by_solid_angles(word) "{word} turns the plane by solid angles, which is not supported"
        help "use ROT with angles about the axes";
    is_which_cannot_be_printed(word, what) "{word} is {what}, which cannot be printed"
        help "leave it out, or replace it by plain moves";
    takes_values_from_file_of_control(name) "{name} takes values from a file of the control";
    geoax_gives_geometry_axes_other_names() "GEOAX gives the geometry axes other names"
        asks "name the axes of the machine by `[machine] geometry_axes`";
    leaves_radius_compensation(word) "{word} leaves the radius compensation on" help "write G40 into the block";
    under_g340_without_discl_tool_comes_down()
        "under G340 without DISCL the tool comes down in a way that is not confirmed"
        help "program DISCL above 0, or G341";
    way_leads_to_other_side_of_contour()
        "the way leads to the other side of the contour than the radius compensation"
        help "program G140, or the other one of G141 and G142";
    under_scaling_is_not_supported(word) "{word} under scaling is not supported: the tool is not scaled"
        help "end the scaling before the contour";
    is_not_supported_so_program_approach(word, other) "{word} is not supported {other}"
        help "program the approach and the retraction by plain moves";
    is_not_supported_so_program_way(word) "{word} is not supported" help "program the way by plain moves";
    m70_makes_spindle_axis() "M70 makes the spindle an axis, which plain G-code cannot say"
        asks "leave it out if the axis stands ready, or list it: `[output] pass_m = [70]`";
    orientable_tool_carriers_cannot_be_printed() "orientable tool carriers cannot be printed";
    g_is_not_known(fun) "G{fun} is not known"
        help "check the number; functions of other controls have to be converted";
    g_is_not_supported(fun, function) "G{fun} ({function}) is not supported";
    g_is_function(fun, what, owner) "G{fun}{what} is a function of {owner}; partc does not support it yet";
    g_is_no_element_of_contour(number) "G{number} is no element of a contour";
    g24_in_contour_is_not_supported() "G24 in a contour is not supported"
        help "describe the thread with G34 and the undercut with G25";
    attribute_g_of_contour_elements_is_not(fun) "the attribute G{fun} of contour elements is not supported"
        help "remove it, and put feeds and oversizes into the cycle";
    is_no_function_beside_words(shown) "{shown} is no function of the control that is known"
        help "the words beside {shown} may be its arguments, and no G function of this block takes them: write \
        {shown} alone in its block, or leave it out with all that belongs to it";
    is_no_function_that_is_known(shown) "{shown} is no function of the control that is known"
        asks "if it does not move the tool or change the path, add `[control] machine_words = [\"{shown}\"]` to \
        partc.toml";
}

P9012 Error "iso-block" "block of an ISO dialect" was "K9009 S9003 siemens-iso"
usual "convert the block to L, C or CR"
"Klartext: A G word stands in a Klartext program. Where such blocks occur the meaning of I and J differs between writers (centre or \
offset), so the block is refused. Convert it to L, C or CR.\n\n\
SINUMERIK: G291 and ISOCALL switch to ISO dialect, which is another language with other rules. Translate that part, or compile it by \
itself." {
    is_din_iso_program(name) "`{name}` is a DIN/ISO program";
    is_din_iso_word(name) "{name} is a DIN/ISO word and cannot stand in a Klartext program";
    isocall_calls_program_in_iso_dialect() "ISOCALL calls a program in ISO dialect"
        help "translate the program, or leave the call out";
    g291_switches_to_iso_dialect() "G291 switches to ISO dialect"
        help "translate the ISO part, or compile it by itself";
}
}
