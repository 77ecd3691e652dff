//! `S0` to `S4`: faults of SINUMERIK programs. A text that names an alarm means the number the control itself shows.

super::codes! { SINUMERIK:

S0003 Error "siemens-bracket-comment" "comment in brackets"
"Brackets hold comments in DIN 66025 and ISO programs. On a SINUMERIK control they group formulas and hold arguments; \
a comment starts with a semicolon. The control shows alarm 12080." {
    brackets_hold_no_comment_on_this_control() "brackets hold no comment on this control";
}

S1002 Error "siemens-two-operators" "two operators in a row"
"Two arithmetic operators cannot follow each other: `R1=R2--R3` is refused with alarm 12180. Put the signed value in brackets." {
    follows_another_operator(word) "`{word}` follows another operator";
}

S1003 Error "siemens-skip-level" "skip level does not exist"
"Blocks are skipped on levels /0 to /9; a slash alone means level 0. The control shows alarm 14060." {
    there_is_no_such_skip_level() "there is no such skip level";
}

S1004 Error "siemens-structure-mark" "label or skip mark on a control structure"
"Lines with IF, ELSE, ENDIF, WHILE, FOR, LOOP, REPEAT and their ends take neither a label nor a skip mark. \
Put the label into the block before. The control shows alarm 12630." {
    cannot_stand_in_front_of_control_structure(what) "{what} cannot stand before a control structure";
}

S1013 Error "siemens-modal-passes" "number of passes in a modal call"
"MCALL calls the program once after every positioning block; a number of passes cannot be given. The control shows alarm 12100." {
    modal_call_takes_no_number_of_passes() "a modal call takes no number of passes";
}

S1014 Error "siemens-name-length" "name is too long"
"Labels and names have at most 32 characters; the control stops at a longer one with alarm 12420. Shorten it." {
    label_is_longer_than_characters(readable, most_label)
        "the label `{readable}` is longer than {most_label} characters"
        help "shorten it";
    name_has_characters(word) "the name has {word} characters" alarm 12420 help "shorten it to 31";
}

S2001 Error "siemens-name-unknown" "name is not defined"
"The name is neither a variable nor a word of the language nor a function. The control shows alarm 12550. Variables are defined by DEF at the \
top of the program, by PROC, or in a definition file (SGUD, MGUD, UGUD, GUD4 to GUD9, macros in SMAC, MMAC, UMAC) beside the program." {
    there_is_no_function(symbols) "there is no function `{symbols}`" alarm 12550
        help "a program is called in a block of its own, not in a formula";
    name_is_not_defined(word) "the name `{word}` is not defined" alarm 12550;
    word_is_not_known_here(name) "the word `{name}` is not known here" alarm 12550;
}

S2002 Error "siemens-program-missing" "called program is not found"
"A word that is no word of the language is the call of a program (alarm 14011). It is looked for where the control looks, whoever calls: in \
the folder of the main program as .SPF and .MPF, then as .SPF in `/_N_SPF_DIR`, in the folder of CALLPATH, in `/_N_CUS_DIR`, `/_N_CMA_DIR` and `/_N_CST_DIR`. The programs of an \
archive lie in the folders of their `;$PATH=` lines, and `[include] roots` names the folder of this computer for each. Other workpieces are never searched. Programs of the machine builder are answered in partc.toml: `[programs] TC = { tool = 1 }`. A mistyped word ends here, too." {
    there_is_no_program(name) "there is no program `{name}`" alarm 14011;
    there_is_no_program_and_no(name, file)
        "there is no program `{name}`, and no file `{file}`, which `[programs]` gives for it" alarm 14011
        help "put the file where `[programs]` says, counted from its partc.toml";
}

S2004 Error "siemens-structure" "control structure is not closed"
"Every IF has its ENDIF, every WHILE its ENDWHILE, FOR its ENDFOR, LOOP its ENDLOOP, REPEAT without a label its UNTIL, in the same \
program and without crossing. The control shows alarm 12640 or 12641." {
    has_no_opening(word) "{word} has no opening" alarm 12640;
    structures_are_nested_more_than_deep(most_nested) "structures are nested more than {most_nested} deep" alarm 12641
        help "move the inner part into a subprogram";
    is_not_closed(word) "{word} is not closed" alarm 12640;
}

S2008 Error "siemens-group-twice" "two G codes of one group"
"Codes of one group exclude each other. The control takes the last one and shows alarm 12060; which one was meant cannot be known, so the \
block is refused." {
    are_of_one_group(a, b) "{a} and {b} are of one group" alarm 12060;
}

S2009 Error "siemens-shape-twice" "two codes that shape the block"
"Of the G groups 1 to 4 (motion, dwell and reference points, frames and poles, preprocessing) one code may stand in a block. The control \
shows alarm 12070. Give each its own block." {
    cannot_stand_in_one_block(a, b) "{a} and {b} cannot stand in one block" alarm 12070;
}

S2010 Error "siemens-g-unknown" "G code is not known"
"The number belongs to no G group of the SINUMERIK language (alarm 12470). G codes of other languages, like G43, G28 or G80, mean nothing here." {
    g_group_cannot_be_set_by_index(group) "G group {group} cannot be set by index" alarm 12470;
    g_is_not_known(number) "G{number} is not known" alarm 12470;
}

S2011 Error "siemens-g-index" "G group has no such index"
"`G[group]=index` selects a code by its place in the group, counted from 1. The control shows alarm 12475." {
    g_group_has_indices_1(group, size, given) "G group {group} has the indices 1 to {size}, not {given}" alarm 12475;
}

S2013 Error "siemens-own-block" "word needs a block of its own"
"G4, G25, G26, G110 to G112, frame statements, calls and declarations stand alone in their block. The control shows alarm 12120. \
Put the other words into the block before or after." {
    blocks_stand_behind_that_closes_program()
        "blocks stand after the `%` that closes the program, and no program of theirs begins"
        help "delete the `%`, or give them a head of their own: %_N_NAME_MPF";
    blocks_stand_in_front_of_first_program() "blocks stand before the first program of this archive"
        help "delete them, or give them a head of their own: %_N_NAME_MPF";
    definition_file_holds_def() "a definition file holds DEF and DEFINE only" alarm 12500;
    selects_work_offset_on_802d(word) "{word} selects a work offset on an 802D and moves in the same block"
        help "give the selection a block of its own";
    has_no_axes(word) "{word} has no axes" alarm 12120
        asks "on an 802D it selects a work offset: set `[control] sinumerik = \"802d\"`";
    needs_move(probe) "{probe} needs a move" alarm 12120;
    control_structure_or_declaration_cannot_be_executed()
        "a control structure or declaration cannot be executed as a text" alarm 12080;
    two_calls_stand_in_one_block() "two calls stand in one block" alarm 12080
        help "give each call a block of its own";
    this_word_cannot_stand_beside_code() "this word cannot stand beside the code that shapes the block" alarm 12120
        help "give it a block of its own";
    g4_takes_f_or_s() "G4 takes F or S" alarm 12120
        help "G4 F1.5 waits seconds, G4 S20 turns of the spindle; G4 P is of another language";
    call_stands_beside_other_words() "a call stands beside other words" alarm 12120
        help "give the call a block of its own";
}

S2014 Error "siemens-mixed-assignment" "assignment beside other words"
"A block with an assignment like R1=5 holds assignments only; the control shows alarm 12080. Give it a block of its own." {
    assignment_stands_beside_other_words() "an assignment stands beside other words" alarm 12080
        help "give the assignment a block of its own";
}

S2015 Error "siemens-definition-late" "definition after executed blocks"
"DEF and PROC stand at the top of a program, before the first block that does something, and PROC before DEF. The control shows alarm 14500 or 14520." {
    def_stands_behind_executed_blocks() "DEF stands after executed blocks" alarm 14500
        help "move it to the top of the program";
    proc_stands_inside_definition_part() "PROC stands inside the definition part" alarm 14520
        help "write PROC as the first block of the program, before DEF and EXTERN";
    proc_stands_behind_executed_blocks() "PROC stands after executed blocks" alarm 14500;
}

S2016 Error "siemens-name-taken" "name is used already, or no address"
"The name is an axis, a word of the language or a variable that exists (alarm 12170), or the letter is no address of this machine (alarm \
12050). Choose another name, or check the letter." {
    which_axis_is_only_machine_knows(name, letter) "which axis {name} is, only the machine knows" alarm 12050
        asks "say it: `[machine] axes = {{ {name} = \"{letter}\" }}`, or \"leave-out\" for an axis that the target \
        does not have";
    is_cannot_be_variable(word, what) "`{word}` is {what} and cannot be a variable" alarm 12170
        help "choose another name";
    is_defined_twice(word) "`{word}` is defined twice" alarm 12170;
    is_variable_already(symbol) "`{symbol}` is a variable already" alarm 12270;
    macro_is_defined_twice(symbol) "the macro `{symbol}` is defined twice" alarm 12270 help "rename one of them";
    address_is_not_known(letter) "the address {letter} is not known" alarm 12050;
    address_r_has_no_meaning() "the address R has no meaning" alarm 12050 help "the radius of an arc is CR=";
    is_word_of_language(word) "`{word}` is a word of the language" help "choose a name that means nothing yet";
}

S2017 Error "siemens-start-values" "start values do not fit"
"More values are given than the array has elements (alarm 12260), or the type takes no start value in DEF (alarm 12261)." {
    values_for_elements(count, room) "{count} values for {room} elements" alarm 12260;
    rep_needs_value() "REP needs a value" alarm 12260;
    rep_counts_elements_by_whole_number() "REP counts elements by a whole number" alarm 12260;
    frame_cannot_be_given_value_by_def() "a FRAME cannot be given a value by DEF" alarm 12261;
}

S2018 Error "siemens-index" "no such element"
"The index lies outside the array, or the number outside the R parameters, spindles or work offsets. Indices count from 0. \
The control shows alarm 12400, 12410, 12430 or 17020." {
    array_has_no_such_element() "the array has no such element" alarm 12400;
    text_has_no_character(at) "the text has no character {at}" alarm 12400;
    there_is_no_parameter_r(n) "there is no parameter R{n}" alarm 17020;
    variables_of_program_are_too_large() "the variables of the program are too large" alarm 12380;
    elements_are_too_many(count) "{count} elements are too many" alarm 12380;
    array_has_at_most_three_directions() "an array has at most three directions" alarm 12190;
    array_has_1_to_32767_elements() "an array has 1 to 32767 elements in a direction" alarm 12430;
    r_parameter_has_one_index() "an R parameter has one index" alarm 12400;
    there_is_no_spindle(n) "there is no spindle {n}" alarm 12430;
    index_is_whole_number() "an index is a whole number" alarm 12410;
    one_index_is_needed() "one index is needed" alarm 12430;
    work_offsets_have_numbers_0_to_99() "work offsets have the numbers 0 to 99" alarm 17020;
    number_of_work_offset_is_missing() "the number of the work offset is missing" alarm 17020;
    there_is_no_such_g_group() "there is no such G group" alarm 17020;
    variable_is_no_array() "the variable is no array" alarm 12400;
    array_has_indices(n, given) "the array has {n} indices, not {given}" alarm 12400;
    array_has_no_element(indices, sizes) "the array has no element {indices}; its sizes are {sizes}, counted from 0" alarm 12400;
    there_is_no_element(sizes, indices)
        "the array has the sizes {sizes}, counted from 0; there is no element {indices}" alarm 12400;
    index_is_whole_number_this_is(what) "an index is a whole number, this is {what}" alarm 12410;
}

S2019 Error "siemens-passes" "number of passes does not exist"
"A program or section is passed 1 to 9999 times; 0 and negative numbers raise alarm 14013. Look at the value of P." {
    p_is_no_number_of_passes(value) "P={value} is no number of passes" alarm 14013
        help "P is a whole number, 1 to 9999";
}

S2020 Error "siemens-ret-in-main" "RET in the main program"
"RET returns to a calling program; the main program has none. The control shows alarm 14091. A main program ends by M30 or M2." {
    ret_goes_back_over_levels(levels, programs) "RET goes back over {levels} levels, and there are {programs}" alarm 14091
        help "check the third argument of RET";
    ret_stands_in_main_program() "RET stands in the main program" alarm 14091;
}

S2021 Error "siemens-arguments" "arguments do not fit the parameters"
"Number or types of the arguments differ from those of PROC or of the function: alarms 12300 to 12360, 12480, 14020, 14021, 14510; those of EXTERN from those of PROC: alarm 14530. VAR needs a \
variable of exactly the same type." {
    lacks_axis_that_follows(name) "{name} lacks the axis that follows" alarm 14020;
    takes(word, takes) "{word} takes {takes}" alarm 14021;
    extern_does_not_fit_program(name, what) "EXTERN does not fit the program {name}: {what}" alarm 14530;
    is_declared_second_time_with_other_parameters(symbols)
        "{symbols} is declared a second time with other parameters" alarm 12480;
    this_argument_of_ret_is_whole_number() "this argument of RET is a whole number" alarm 14020;
    priority_of_interrupt_is_1_to_128() "the priority of an interrupt is 1 to 128" alarm 14660;
    arguments_are_given() "arguments are given, but the program has no PROC" alarm 14510;
    argument_for_parameter_is_missing(name) "the argument for parameter {name} is missing"
        help "give a variable; this parameter has no default";
    parameter_is_var(shown, what, what2) "parameter {shown} is VAR {what}, the argument is {what2}"
        help "both need the same type";
    parameter_is_var_and_needs_variable(shown) "parameter {shown} is VAR and needs a variable" alarm 12320
        help "a formula cannot take the result";
    parameter_is_var_this_is_subprogram(shown) "parameter {shown} is VAR: this is a subprogram, and needs a caller" alarm 12300
        help "compile the program that calls it";
    parameter_is_argument(shown, type_name, what) "parameter {shown} is {type_name}, the argument is {what}" alarm 12330;
    parameter_of_proc_needs_name() "a parameter of PROC needs a name" alarm 12080;
    program_takes_arguments(count) "the program takes {count} arguments" alarm 12340;
    geoax_names_geometry_axis(n) "GEOAX names geometry axis {n}; there are 1 to 3" alarm 14414;
    is_no_folder_of_control(wrong) "`{wrong}` is no folder of the control" alarm 14009
        help "write its path from the root: CALLPATH(\"/_N_WKS_DIR/_N_SHAFT_WPD\")";
    callpath_takes_one_text() "CALLPATH takes one text" alarm 14021;
    execstring_takes_one_text() "EXECSTRING takes one text" alarm 14021;
    takes_no_argument(name) "{name} takes no argument" alarm 12090;
    cycle800_takes_arguments(most) "CYCLE800 takes {most} arguments" alarm 12340;
    cmirror_takes_geometry_axes() "CMIRROR takes geometry axes" alarm 14020;
    axes_values_follow_each_other() "axes and values follow each other" alarm 14020 help "for example (Z,45)";
    plane_of_crpl_is_0_to_3() "the plane of CRPL is 0 to 3" alarm 14020;
    crpl_takes_plane() "CRPL takes a plane and an angle" alarm 14021;
    axes_and_values_follow_each_other() "axes and values follow each other" alarm 14020
        help "for example (X,10,Y,20)";
    axname_takes_text() "AXNAME takes a text" alarm 14021;
    takes_text(name) "{name} takes a text" alarm 14021;
    modaxval_takes_axis() "MODAXVAL takes an axis and an angle" alarm 14021;
    invframe_takes_frame() "INVFRAME takes a frame" alarm 14021;
    needs_variable(name) "{name} needs a variable, which takes the number of the tool" alarm 14020;
    lacks_variable_that_takes_tool(name) "{name} lacks the variable that takes the tool" alarm 14020;
    gett_takes_name_of_tool() "GETT takes the name of a tool and the number of its sister" alarm 14021;
    takes_argument(word, most, most2) "{word} takes {most} argument{most2}" alarm 12340;
    modifier_takes_one_value() "the modifier takes one value" alarm 14021;
    takes_arguments(name, most) "{name} takes {most} arguments" alarm 12340;
}

S2029 Error "siemens-range" "value lies outside its type"
"INT holds whole numbers up to 2147483647, CHAR 0 to 255. The control shows alarm 12160, 12560 or 14096." {
    value_lies_outside_what_holds(type_name) "the value lies outside what {type_name} holds";
    is_above_limit_uli(number, most) "{number} is above the limit ULI {most}";
    is_below_limit_lli(number, least) "{number} is below the limit LLI {least}";
    lli_is_above_uli(least, most) "LLI {least} is above ULI {most}" alarm 12161;
    number_is_too_large() "the number is too large" alarm 12160;
    count_of_for_fits_no_int() "the count of FOR fits no INT" alarm 12560;
}

S2030 Error "siemens-text-length" "text is too long"
"A text is longer than the variable takes, or longer than 200 characters: alarm 12210 or 14099. A constant 'H41' in a text is one character (alarms 12220, 12230). Macros have at most 256 characters." {
    text_has_characters(text, length) "the text has {text} characters, the variable takes {length}" alarm 12210;
    text_has_0_to_200_characters() "a text has 0 to 200 characters" alarm 12210;
    constant_in_text_is_larger_than_one(what) "the {what} constant in the text is larger than one character"
        help "a character has 8 bits: 'H00' to 'HFF'";
    text_of_macro_has_at_most_256() "the text of a macro has at most 256 characters" alarm 12280;
    text_has_characters_parameter_takes(text, shown, length)
        "the text has {text} characters, parameter {shown} takes {length}" alarm 12210 help "shorten it";
    joined_text_is_too_long() "the joined text is too long" alarm 14099;
}

S2031 Error "siemens-axis-needed" "an axis is needed"
"In this place stands the name of an axis, or a variable of type AXIS that names one: alarm 12040." {
    component_of_frame_is_axis() "a component of a frame is an axis and one of TR, FI, RT, SC, MI" alarm 12040
        help "for example [X,TR]";
    axis_is_needed(what) "an axis is needed, this is {what}" alarm 12040;
    is_no_geometry_axis(axis) "{axis} is no geometry axis" alarm 16440;
    axis_is_needed_in_brackets(what) "an axis is needed in brackets, this is {what}" alarm 12040;
    one_axis_is_needed_in_brackets() "one axis is needed in brackets" alarm 12040;
    is_no_geometry_axis_2(axis) "{axis} is no geometry axis" alarm 12040;
    needs_axis(word) "`{word}` needs an axis: `{word}[X]`" alarm 12040;
}

S2034 Error "siemens-frame" "frame cannot be built"
"A scaling factor is 0, a value is infinite, or a component is asked of a chain of frames that has none. Check the frame statements before the block." {
    this_component_cannot_be_set() "this component cannot be set: a chain of rotations and scales, or a factor 0";
    this_chain_of_rotations() "this chain of rotations and scales has no such components";
    scaling_factor_is_0() "a scaling factor is 0";
    frame_cannot_be_used() "the frame cannot be used: a factor or a shift is zero or out of all range";
    frame_cannot_be_inverted() "the frame cannot be inverted";
}

S2043 Error "siemens-tool" "tool is not known"
"The tool is called by a name that has no number, by a number that is none, or changed before it was chosen. Names get numbers in the \
[tools] tables of partc.toml. The control shows alarm 17190 or 17191." {
    argument_of_is_no_tool(place, name) "argument {place} of {name} is no tool" alarm 17190;
    has_no_argument(name, place) "{name} has no argument {place}" help "count the arguments for `[programs]` from 1";
    argument_of_is_no_d_number(place, name) "argument {place} of {name} is no D number" alarm 17180;
    no_tool_is_chosen(name) "no tool is chosen for {name}"
        help "program T before {name}, or name its argument: `{name} = {{ tool = 1 }}`";
    changes_tool_times(name, passes) "{name} changes the tool {passes} times";
    mcall_calls_after_each_move(name)
        "MCALL calls {name} after each move, and `[programs]` says what one call of it leaves"
        help "call it without MCALL; or look at what `[programs]` says of it";
    changes_tool(name) "{name} changes the tool, as `[programs]` says, and MCALL calls it after each move"
        help "call it without MCALL; or look at what `[programs]` says of it";
    d_is_no_edge_number(d) "D{d} is no edge number" alarm 17180;
    no_tool_is_chosen_so_program_t() "no tool is chosen" help "program T before M6";
    tool_has_no_number(name) "the tool `{name}` has no number" alarm 17191;
    t_is_no_tool_number(t) "T{t} is no tool number" alarm 17190;
}

S2045 Error "siemens-spindle" "spindle word cannot be carried out"
"The speed is negative or missing, the spindle does not exist, or a dwell in turns has no fixed speed to count with." {
    g96_has_no_cutting_speed() "G96 has no cutting speed" alarm 10900;
    dwell_in_turns_needs_fixed_spindle_speed() "a dwell in turns needs a fixed spindle speed" alarm 10900
        help "give the time in seconds: G4 F1.5";
    cycle832_with_tolerance(tolerance) "CYCLE832 with a tolerance of {tolerance}"
        help "a tolerance is above zero; CYCLE832() ends it";
    there_is_no_spindle(n) "there is no spindle {n}";
    speed_limit_is_negative(words) "the speed limit {words} is negative" alarm 14820;
    speed_limit_is_0(words) "the speed limit {words} is 0: the spindle would stand"
        help "give the highest speed in turns per minute: {words}2500";
    master_spindle_changes_while_it_turns() "the master spindle changes while it turns at a constant cutting speed"
        help "stop it by M5, or program G97 with a speed, before SETMS";
    where_spindle_stands(n) "where spindle {n} stands, from which SPOS=IC(…) counts, is not known"
        help "program the angle absolutely";
    where_spindle_stands_from_which_spos() "where the spindle stands, from which SPOS=IC(…) counts, is not known"
        help "stop it by SPOS= at an angle first";
    m19_spos_stop_spindle_in_one_block() "M19 and SPOS= stop the spindle in one block"
        help "leave M19 out: SPOS= says where the spindle stops";
    speed_s_is_negative(s) "the speed S{s} is negative" alarm 14840 help "the sense of rotation comes from M3 or M4";
    speed_s_is_out_of_all_range(s) "the speed S{s} is out of all range";
    in_line_leaves_speed_that_is_not(needs, name, line)
        "{needs}, and {name} in line {line} leaves a speed that is not known"
        help "program S after {name}; or say the speed: `speed = 1000` in place of \"lost\" under `[programs]`";
    rigid_tapping_has_no_speed_s() "rigid tapping has no speed S" alarm 16760
        help "program S in this block or before";
    speed_of_rigid_tapping_is_0() "the speed of rigid tapping is 0" alarm 16763
        help "program S in this block or before";
    rigid_tapping_under_constant_cutting_speed()
        "rigid tapping under a constant cutting speed (G96): the speed of the spindle is not fixed"
        help "program G97 with S in turns per minute before it";
    stands_in_block_of_g332(name) "{name} stands in the block of G332 and would act while the tap is in the hole"
        help "program {name} in a block before G331 or after G332";
    speed_s_is_negative_so_sign(s) "the speed S{s} is negative" alarm 16763
        help "the sign of the lead turns the spindle; program S without a sign";
    spos_stands_in_block_that_taps() "SPOS= stands in a block that taps"
        help "give SPOS= a block of its own before G331";
    m_stands_in_block_that_taps(m) "M{m} stands in a block that taps"
        help "leave it out: the sign of the lead turns the spindle, which stands before and after the tap";
    m_m_stand_in_one_block(first, second) "M{first} and M{second} stand in one block: each ends a program" alarm 14760
        help "leave one of them out";
    m_and_m_stand_in_one(first, second) "M{first} and M{second} stand in one block" alarm 14760
        help "give each a block of its own";
    block_cuts_at_speed_kept_since_g96()
        "this block cuts at the speed that the spindle happens to have kept since G96"
        help "program the speed in turns per minute after G97: S1000";
    spindle_starts_without_speed()
        "the spindle starts without a speed: the one of before was a cutting speed (G96)"
        help "program the speed in turns per minute after G97: S1000";
    g96_ends_at_unknown_diameter() "G96 ends at a diameter at which its speed is not known"
        help "program the speed in turns per minute after G97: S1000";
}

S2046 Error "siemens-programs-of-one-name" "several programs of one name and rank"
"The call names a program, and more than one has that name in the same folder of the control: two in an archive with the same `;$PATH=` line or none, one in an archive and \
one on the disk, or one in each of two folders that stand for it. So it is where a file beside the main program lies in another folder by its own `;$PATH=` line, and another program of that name would run \
by one of the two. A control keeps one of them, which depends on what was read in last. The same is said where a folder of a backup is called as one folder of the control and the `;$PATH=` \
line of a program in it names another one: nothing says which of the two is out of date.\n\
Delete or rename all but one, place a program by a `;$PATH=` line after its head, or call it by its path." {
    lies_in_by_name_of_its_folder(shown, by_name, by_line)
        "`{shown}` lies in `{by_name}` by the name of its folder, and in `{by_line}` by its `;$PATH=` line: which \
        program this call means depends on it"
        help "move the file to the folder of the line, or correct the line; `[include]` says which folder stands for \
        which one of the control";
    programs_are_named(all, called_name)
        "{all} programs are named `{called_name}`, and no rule says which of them runs";
}

S2047 Error "siemens-spf-beside-mpf" "subprogram and main program of one name"
"NAME_SPF and NAME_MPF lie in the folder of the main program, and the call says NAME. Manuals disagree which of them runs: the SPF (SINUMERIK ONE, programming manual \
12/2019, 3.4.1.4), the MPF (older ones), or none without its ending (828D).\n\
Write the ending, `CALL \"NAME_SPF\"`, rename one of them, or say what your control runs: `[control] called_first = \"spf\"` or `\"mpf\"`." {
    spf_mpf_both_lie_in_folder(plain) "`{plain}_SPF` and `{plain}_MPF` both lie in the folder of the main program";
}

S2050 Error "siemens-pole-axis" "pole outside the working plane"
"A pole lies in the working plane: X and Y in G17, Z and X in G18, Y and Z in G19. The control shows alarm 14270." {
    is_no_axis_of_working_plane(axis) "{axis} is no axis of the working plane" alarm 14270;
}

S2051 Error "siemens-polar-mixed" "polar and Cartesian end point mixed"
"The end point in the plane is given by AP= and RP=, or by axes, not by both. The control shows alarm 14280. The axis at a right angle to the \
plane may stand beside AP and RP." {
    ap_or_rp_stands_beside_axis() "AP= or RP= stands beside an axis of the working plane" alarm 14280
        help "give the end point by AP= and RP=, or by its axes";
}

S2052 Error "siemens-polar-radius" "polar radius is negative"
"RP= is a distance from the pole and cannot be negative: alarm 14200, in a pole block 14250." {
    rp_is_negative(rp) "RP={rp} is negative" help "a polar radius is positive; turn AP by 180 degrees instead";
}

S2053 Error "siemens-polar-angle" "polar angle out of range"
"AP= lies between -360 and 360 degrees: alarm 14210, in a pole block 14260. Look at the word that is marked, and at the value after it." {
    ap_lies_outside_360_to_360_degrees(ap) "AP={ap} lies outside -360 to 360 degrees";
}

S2054 Error "siemens-polar-missing" "polar word was not programmed"
"After a new pole or a change of plane AP= has to be programmed again, and RP= once at all: the manuals demand the word, so its value is not \
known. The same holds for an AP=IC(…) that has no angle to count from. Program both words in this block." {
    was_not_programmed_since_pole_or_plane(what) "{what} was not programmed since the pole or the plane was set"
        help "program AP=… and RP=… in this block";
    rp_was_never_programmed() "RP= was never programmed" help "program RP=… in this block";
}

S2060 Error "siemens-no-diameter-axis" "no diameter axis"
"Diameter programming and constant cutting speed refer to the one transverse axis that machine datum 20100 names; without it they raise alarm \
16510 or 10870. Set `[machine] diameter_axis`." {
    no_diameter_axis_is_configured() "no diameter axis is configured (MD 20100)" alarm 16510
        asks "set `[machine] diameter_axis = \"X\"`, and `kind = \"lathe\"` for a lathe";
    only_counts_in_diameters(axis) "only {axis} counts in diameters (MD 20100)" alarm 16510
        help "DAC, DIC, RAC, RIC and DIAMONA[…] are for this axis; program the other one as it is";
    constant_cutting_speed_needs_diameter_axis() "constant cutting speed needs a diameter axis (MD 20100)" alarm 10870
        asks "set `[machine] diameter_axis = \"X\"`";
}

S2061 Error "siemens-rotary-word" "modifier does not fit the axis"
"DC, ACP and ACN are for rotary axes, with angles from 0 to below 360 degrees: alarms 16800 to 16830." {
    is_no_rotary_axis(axis) "{axis} is no rotary axis" help "DC, ACP and ACN are for rotary axes";
    lies_outside_0_to_359_999(given) "{given} lies outside 0 to 359.999" alarm 16830
        help "positions of an axis that counts modulo 360 lie inside one turn; write more turns as increments";
}

S2070 Error "siemens-angle-line" "line by angle is not determined"
"ANG= with one end coordinate is a line; with none it is the first of two lines, and the next block has ANG and both end coordinates. \
Alarms 10790 to 10795. Nothing but blocks without motion may stand between the two." {
    first_line_of_pair_stands_under_mcall()
        "the first line of a pair stands under MCALL, and the call would come before its end is known";
    second_line_of_pair_is_missing() "the second line of the pair is missing" alarm 10793;
    two_lines_are_parallel() "the two lines are parallel and have no corner" alarm 10791 help "check the two angles";
    lines_meet_behind_start(which) "the lines meet behind the start: {which}" alarm 10791
        help "turn that angle by 180 degrees, or check the end point";
    end_coordinate_lies_behind_start() "the end coordinate lies behind the start, seen along the angle" alarm 10795
        help "turn the angle by 180 degrees, or check the end coordinate";
    end_coordinate_cannot_be_reached() "the end coordinate cannot be reached at this angle" alarm 10795
        help "the line runs at a right angle to the axis of the end coordinate";
    second_line_of_pair_is_no_straight() "the second line of the pair is no straight line" alarm 10792;
    second_line_of_pair_is_programmed()
        "the second line of the pair is programmed by increments, and from where they count is not documented"
        help "program its end point in absolute coordinates: G90, or AC(…)";
    both_end_coordinates() "both end coordinates and an angle say too much" alarm 10795
        help "leave ANG out; only the second line of a pair has all three";
    second_line_of_pair_needs_both_end() "the second line of the pair needs both end coordinates" alarm 10794;
    second_line_of_pair_has_no_ang() "the second line of the pair has no ANG" alarm 10794;
    ang_is_for_straight_lines() "ANG= is for straight lines only" alarm 10792 help "program G1 or G0 before it";
    plane_changes_between_two_lines_of_pair() "the plane changes between the two lines of a pair" alarm 10790;
}

S2071 Error "siemens-corner-word" "chamfer or rounding cannot stand here"
"RND, CHR and CHF stand in the block that leads to the corner and are not negative: alarms 16500, 10882." {
    chamfer_or_rounding_is_negative() "a chamfer or rounding is negative" alarm 16500;
    chamfer_or_rounding_stands_in_block() "a chamfer or rounding stands in a block that does not move" alarm 10882
        help "write it into the block that leads to the corner";
    more_than_blocks_without_move_stand(most_between)
        "more than {most_between} blocks without a move stand after the chamfer or rounding" alarm 10880;
    frc_stands_without_chamfer_or_rounding() "FRC= stands without a chamfer or rounding"
        help "give RND=, CHR= or CHF= in the same block";
    chr_chf_stand_in_one_block() "CHR and CHF stand in one block" help "keep one of them";
    thread_has_no_corner_to_chamfer() "a thread has no corner to chamfer or round"
        help "program the transition as elements of its own, and RNDM=0 before the thread";
}

S2080 Error "siemens-compensation" "radius compensation cannot change here"
"G41, G42 and G40 take effect on a straight line with a tool selected; plane, frame, work offset and tool do not change in between. \
Alarms 10750 to 10757, 10780." {
    frame_changes_while_radius_compensation() "the frame changes while radius compensation is on"
        help "program G40 in a block before it";
    plane_changes_while_radius_compensation() "the plane changes while radius compensation is on" alarm 10757
        help "program G40 in a block before it";
    block_in_machine_coordinates_under_radius_compensation()
        "a block in machine coordinates under radius compensation";
    fixed_point_is_approached_under_radius_compensation() "a fixed point is approached under radius compensation" alarm 14091;
    work_offset_changes_while_radius_compensation() "the work offset changes while radius compensation is on";
    cycle800_retracts_under_radius_compensation() "CYCLE800 retracts under radius compensation";
    radius_compensation(on, what) "radius compensation {on} {what}"
        help "program G41, G42 or G40 with G0 or G1 and an axis of the plane";
    radius_compensation_under_d0() "radius compensation under D0, which has no radius"
        help "select the edge before G41 or G42: D1";
    d_was_programmed_between_t()
        "D was programmed between T and M6: which edge is in force after M6 is machine datum 20270"
        help "program D after M6";
    radius_compensation_without_tool() "radius compensation without a tool" alarm 10750;
    cutting_edge_changes_while_radius_compensation() "the cutting edge changes while radius compensation is on"
        help "program G40 in a block before it";
    tool_changes_while_radius_compensation() "the tool changes while radius compensation is on" alarm 10780
        help "program G40 in a block before it";
    g40_in_front_has_had_no_move() "G40 before this block has had no move" alarm 10754
        help "program G40 with G0 or G1 and an axis of the plane";
    side_stands_behind_g40_without_move()
        "G41 or G42 stands after a G40 that has had no move in the plane yet" alarm 10754
        help "program G40 with G0 or G1 and an axis of the plane";
    g40_has_had_no_move_in_plane() "G40 has had no move in the plane before this block" alarm 10754
        help "program G40 with G0 or G1 and an axis of the plane";
}

S2081 Error "siemens-thread" "thread is not determined"
"G33 needs the lead along the axis that moves furthest: K along Z, I along X, J along Y. Alarms 16720 to 16740." {
    thread_block_moves_no_axis() "the thread block moves no axis" alarm 16740
        help "program the end point of the thread with it";
    does_not_move(axis) "{axis} does not move, so nothing is tapped" alarm 16740 help "program the depth of the hole";
    moves_beside_tapping_axis(other, axis) "{other} moves beside the tapping axis {axis}"
        help "position the tool over the hole in a block before G331";
    g332_comes_back_with_another_pitch()
        "G332 comes back with another pitch, at another speed than before, or not back"
        help "program the lead of G331 and a height towards its start";
    g332_comes_back() "G332 comes back, and no G331 went down"
        help "program G331 down to the depth before it, and one G332 back";
    tap_makes_too_many_steps() "the tap makes too many steps";
    g331_goes_on_with_another_pitch() "G331 goes on with another pitch, at another speed or in another direction"
        help "program the steps of one hole alike, or retract by G0 between two holes";
    hole_is_tapped_in_coordinates_of_machine() "a hole is tapped in coordinates of the machine"
        help "select a work offset (G54) before the hole";
    tapped_thread_has_no_lead() "the tapped thread has no lead" alarm 16720
        help "program K along Z: positive for a right-hand thread, negative for a left-hand one";
    g331_taps_down() "G331 taps down, and no G332 comes back";
    lead_counts_along(axis) "the lead counts along {axis}, which the block does not move" alarm 16730;
    lead_of_thread_is_0() "the lead of the thread is 0" alarm 16720
        help "write the lead, or give the variable after the address its value before this block";
    thread_does_not_move_along_its_lead() "the thread does not move along its lead" alarm 16740;
    lead_is_given_along(axis, longer) "the lead is given along {axis}, but {longer} moves further" alarm 16730
        help "give the lead along the axis that moves further";
    thread_has_no_lead() "the thread has no lead" alarm 16720 help "program K along Z, I along X";
    lead_of_thread_is_negative() "the lead of the thread is negative"
        help "the spindle makes the hand of the thread: M3 or M4; program the lead without a sign";
    auxiliary_function_stands_in_chain() "an auxiliary function stands in a chain of threads"
        help "program M, S, T and H words before the first thread or after the last";
    axes_stand_in_chain() "the axes stand between two threads of a chain, which spoils the thread"
        help "leave the stop out, or retract and start the second thread anew";
}

S2083 Error "siemens-soft-approach" "soft approach or retraction is not determined"
"G147, G247 and G347 lead to a contour, G148, G248 and G348 from it, on a line, a quadrant or a semicircle. The way needs its size (DISR), the direction of the contour, which the element \
next to it gives, the side, which G41, G42, G141 or G142 give, and heights in order: DISCL between the contour and the start or end. Alarms 10740 to 10748." {
    no_contour_element_follows(soft) "no contour element follows {soft}" alarm 10744;
    approach_before_has_no_contour() "the approach before has no contour yet" alarm 10743 help "let its contour follow";
    disr_is_missing_or_too_small() "the size of the way, DISR, is missing or too small" alarm 10742
        help "a length that is above zero with the radius of the tool, or a radius above zero: DISR=10";
    end_point_is_no_point_of_plane()
        "the end point of the approach is not a point of the plane in a straight block" alarm 10745
        help "program the point where the contour begins in the block of the approach";
    side_of_way_is_not_known()
        "from which side the way comes is not known: radius compensation is off" alarm 10747
        help "program G141 (left) or G142 (right)";
    direction_behind_is_not_known() "the direction of the contour is not known here" alarm 10744
        help "let a line or an arc by centre or radius follow the point of the contour";
    direction_in_front_is_not_known() "the direction of the contour is not known here" alarm 10744
        help "let a line or an arc of the plane stand before the retraction";
    discl_lies_outside_way() "DISCL lies outside the way between the two planes" alarm 10741
        help "DISCL is the distance from the plane of the contour, DISCL=AC(…) a coordinate";
    disrp_lies_outside_way() "DISRP lies outside the way" alarm 10748
        help "program a height between DISCL and the start or end";
}

S2091 Error "siemens-cycle-contour" "contour of a cycle is wrong"
"What CYCLE62, CYCLE95, CYCLE72 and others call is no contour that the cycle can take: it has no start point, moves at rapid traverse inside, \
leaves its plane, crosses itself, holds functions or cycles, or is not closed where it has to be. The number is the alarm of the control." {
    contour(name, what) "contour `{name}`: {what}";
    stands_in_contour(name, contour) "{name} stands in the contour `{contour}`"
        help "a contour is made of lines and arcs only";
    stands_in_contour_which_is_shape(word, name)
        "{word} stands in the contour `{name}`, which is a shape for a cycle"
        help "remove it from the contour: the cycle leads its tool beside the shape with arguments of its own";
    positioning_axis_moves_in_contour(name) "a positioning axis moves in the contour `{name}`"
        help "a contour is made of lines and arcs only";
    contour_holds_function_of_machine(name) "the contour `{name}` holds a function of the machine"
        help "move it before the call of the cycle: in which pass the control would carry it out is not known";
    program_ends_inside_contour() "the program ends inside a contour"
        help "put the label of the end of the contour before this block";
    contour_crosses_itself() "the contour crosses itself";
    island_does_not_lie_inside_pocket(name) "the island `{name}` does not lie inside the pocket by itself" alarm 61932
        help "draw one contour where areas touch; call the pocket first, then its islands";
    there_is_no_label(missing, behind, program) "there is no label `{missing}`{behind} in `{program}`" alarm 61701;
    rapid_traverse_inside_contour() "rapid traverse inside a contour" alarm 61936
        help "a contour is made of lines and arcs at feed after its start point";
    thread_inside_contour() "a thread inside a contour" alarm 10930
        help "a contour is made of lines and arcs at feed after its start point";
    full_circle_inside_turned_contour() "a full circle inside a turned contour" alarm 10931
        help "a contour is made of lines and arcs at feed after its start point";
    contour_has_no_start_point() "the contour has no start point" alarm 10931
        help "its first block names both coordinates of the plane: G0 Z0 X20";
    working_plane_changes_inside_contour() "the working plane changes inside the contour"
        help "a contour lies in one plane";
    coordinate_system_changes_inside_contour() "the coordinate system changes inside the contour"
        help "program TRANS, ROT, SCALE and MIRROR before the cycle";
    block_of_contour_leaves_its_plane() "a block of the contour leaves its plane"
        help "a contour has moves of the two axes of its plane only";
}

S2130 Error "siemens-axis-twice" "two names of one printed axis"
"Two axes of the machine, such as Z and Z2, would be printed with one letter, so that a move of the one would move the other. Give one of them \
another letter under `[machine] axes`, or \"leave-out\" if the target has no such axis." {
    would_both_be_printed(first, named, axis) "{first} and {named} would both be printed as {axis}"
        asks "give one of them another letter under `[machine] axes`, or \"leave-out\" if the target has no such \
        axis";
}
}
