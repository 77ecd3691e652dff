//! Facts that several languages share: what is wrong with the form of a block or a program.

super::codes! { SHARED_FORM:

P0010 Error "character-without-place" "character has no place in a block" was "K0001 klartext-character M0001 mtc-character S0001 siemens-character T0001 turning-character"
"A character stands outside a comment or a text where the control knows only letters, digits, signs and blanks. Often a file was damaged \
in transfer, or a word processor put it in.\n\n\
Klartext: A character stands outside a comment or a text in quotes where Klartext knows only letters, digits, signs and blanks. Often a \
file was damaged in transfer, or a word processor put in a special character.\n\n\
MTC200: A character stands outside a comment where the control knows only letters, digits, signs and blanks. Often a file was damaged in \
transfer. Comments stand after `;`, in round brackets, or in square brackets.\n\n\
SINUMERIK: The character belongs to no word of the SINUMERIK language. Comments start with a semicolon. The control shows alarm 12080.\n\n\
HEIDENHAIN turning: The character belongs to no word of a turning program. Comments stand in square brackets: `[ROUGH THE OUTSIDE]`." {
    carriage_return_without_line_feed_stands_inside()
        "a carriage return without a line feed stands inside this block"
        help "end every line of the file in the same way";
    has_no_place_in_block(of) "{of} has no place in a block" help "a comment starts with `;`";
    has_no_place_in_block_so_comment_stands(of) "{of} has no place in a block"
        help "a comment stands after `;` or in brackets";
    has_no_place_in_block_2(of) "{of} has no place in a block";
}

P0011 Warning "printed-dash" "printed dash is read as a minus sign" was "K0002 typographic-minus M0002 mtc-typographic-minus S0002 siemens-dash T0002 turning-dash"
"The block holds a dash as books print it (U+2013, U+2212), which happens when a program is copied out of a PDF. It is read as a minus; a \
control would refuse it. Replace it by `-`."

P1001 Error "block-unreadable" "block cannot be read" was "K1001 klartext-syntax M1001 mtc-syntax S1001 siemens-syntax T1001 turning-syntax"
"A word stands where this block cannot have it, or a part is missing. Nothing of the block is used.\n\n\
Klartext: A word stands where this block cannot have it, or a part is missing. Nothing of the block is used. Compare the block with the \
form the help line shows.\n\n\
MTC200: A word stands where this block cannot have it, or a part is missing. Nothing of the block is used. A block is a list of words: a \
letter and a number (`X10`), a letter, `=` and a formula (`X=@050+1`), or a name (`RET`).\n\n\
SINUMERIK: The words of the block do not fit together: a value or `=` is missing, or a word stands where none can stand. The control \
shows alarm 12080 and stops at the block.\n\n\
HEIDENHAIN turning: The words of the block do not fit together: a value is missing, or a word stands where none can stand. An address \
and its value stand together (`X50`, `Xi-5`, `X#5`, `X{#5+2}`); a coordinate that is left open is written `X?`." {
    cannot_stand_here(word) "`{word}` cannot stand here";
    block_ends_too_early() "block ends too early";
    cannot_stand_in_front(text) "`{text}` cannot stand before `=`";
    block_ends_too_early_so_formula() "the block ends too early" help "a formula or a value is missing";
    is_no_value(text) "`{text}` is no value" alarm 12080;
    label_too_many_in_repetition() "a label too many in the repetition" alarm 12080;
    only_p_may_follow_label_of_repetition() "only P= may follow the label of a repetition" alarm 12080;
    p_stands_twice() "P stands twice" alarm 12080;
    block_number_is_whole_number() "a block number is a whole number" alarm 12080;
    constant_of_case_is_whole_number() "a constant of CASE is a whole number" alarm 12080;
    cannot_stand_in_front_2(text) "`{text}` cannot stand before `=`" alarm 12080;
    text_cannot_stand_here() "a text cannot stand here"
        help "a text is an argument, as in MSG(\"TEXT\"), or a value, as in T=\"DRILL\"";
    address_has_no_value(letter) "the address {letter} has no value";
    letter_o_stands_behind_digit() "a letter O stands after a digit";
    is_missing_in_front(word) "`=` is missing before `{word}`";
    block_ends_too_early_2() "the block ends too early";
    takes_another_number_of_values(name) "`{name}` takes another number of values";
    is_no_value_2(shown) "`{shown}` is no value";
    is_no_address(shown) "`{shown}` is no address";
    stands_where_value_is_missing(word) "`{word}` stands where a value is missing";
    fn_23_names_its_result() "FN 23 names its result and its points" help "write `FN 23: Q20 = CDATA Q30`";
    fn_37_exports_ql_parameter() "FN 37 exports a QL parameter: `FN 37: EXPORT QL5`";
    sysread_takes_whole_numbers_behind_id() "SYSREAD takes whole numbers after ID and NR, and IDX";
    sysread_takes_id() "SYSREAD takes ID, NR and IDX with a value each";
    takes_no_value(name) "`{name}` takes no value";
    this_takes_no_value() "this takes no value" alarm 12080;
    this_cannot_count_loop() "this cannot count a loop" alarm 12080;
    address_cannot_count_loop() "an address cannot count a loop" alarm 12080;
    value_are_missing() "`=` and a value are missing" alarm 12080;
    lacks_axis_in_brackets(name) "{name} lacks the axis in brackets" alarm 12080 help "write {name}[X]=…";
    has_no_index_here(letter) "`{letter}` has no index here" alarm 12080;
    lacks_axis_or_spindle_in_brackets(word) "{word} lacks the axis or spindle in brackets" alarm 12080
        help "write {word}[X]=…";
    macro_is_written_define_name_as_words() "a macro is written DEFINE NAME AS words" alarm 12080
        help "DEFINE M_START AS M3 S1000";
    takes_no_index(letter) "`{letter}` takes no index" alarm 12080;
    endlabel_is_label() "ENDLABEL is a label, and its colon is missing" alarm 12080
        help "write `ENDLABEL:` at the start of the block";
    is_missing(name, letters, digits) "`=` is missing in `{name}`" alarm 12080
        help "an address of more than one letter takes `=`: {letters}={digits}";
    is_word_of_language(name) "{name} is a word of the language and lacks its value" alarm 12080
        help "give its value: {name}=… or {name}[…]=…";
    is_function_no_block(name) "{name} is a function and no block" alarm 12080
        help "give its value to a variable or a word: X={name}(…)";
    subprogram_number_is_written_in_digits() "a subprogram number is written in digits: L10" alarm 12080;
    word_has_no_value() "the word has no value" alarm 12080;
    this_does_not_name_contour() "this does not name the contour" help "write the name as ID\"…\", or nothing";
    there_is_no_function(letter, value) "there is no function {letter}{value}";
    function_has_number() "a function has a number";
    value_is_missing_in_formula() "a value is missing";
    formula_is_empty() "the formula is empty";
    save_is_attribute_of_proc() "SAVE is an attribute of PROC" alarm 12080
        help "write it after the name in the PROC block";
    stopre_takes_no_argument() "STOPRE takes no argument" alarm 12080 help "write STOPRE alone";
}

P1002 Error "word-twice" "same word twice in one block" was "K1004 M1004 mtc-word-twice S2007 siemens-address-twice T1002 turning-word-twice"
"An address may stand once in a block, and which of the two words was meant cannot be guessed. Remove one.\n\n\
Klartext: An address may stand once in a block, absolute or incremental: `X+10 IX+5` counts as twice. Which of the two the programmer \
meant cannot be guessed, and the control refuses the block. Remove one.\n\n\
MTC200: An address may stand once in a block. Which of the two values the control takes is not documented. Remove one, or, if the \
control is known to take the last one, set `[control] repeated_words = \"last\"` in partc.toml.\n\n\
SINUMERIK: Each address may stand once in a block; only G and M may be repeated. The control shows alarm 12000 or 16420. One of the two \
words is too many, or an axis letter is mistyped.\n\n\
HEIDENHAIN turning: A block may hold several functions as long as no address is used twice. Which of the two values counts cannot be \
guessed. Put the second function into a block of its own." {
    sets_second_time_so_remove_one(shown, q) "`{shown}` sets {q} a second time in this definition"
        help "remove one of the two";
    repeats_word_of_this_block(shown) "`{shown}` repeats a word of this block" help "remove one of the two";
    one_corner_takes_one_cf_or_rd() "one corner takes one CF or RD";
    acc_stands_twice_in_this_block() "ACC stands twice in this block";
    stands_twice_in_this_block(letter) "{letter} stands twice in this block"
        asks "remove one of the two, or set `[control] repeated_words = \"last\"` in partc.toml";
    axis_stands_twice_in_block(named) "the axis {named} stands twice in the block" alarm 12000
        help "delete one of the words";
    axis_stands_twice_in_block_so_delete_one(named) "the axis {named} stands twice in the block" alarm 16420
        help "delete one of the words";
    spos_sposa_stand_in_one_block() "SPOS= and SPOSA= stand in one block" alarm 12000;
    block_has_at_most_three_s_words() "a block has at most three S words" alarm 12010 help "divide the block";
    block_has_at_most_five_m_functions() "a block has at most five M functions" alarm 12010 help "divide the block";
    address_stands_twice_in_block() "the address stands twice in the block" alarm 12000
        help "delete one of the words";
    l_stands_twice_in_block() "L stands twice in the block" alarm 12000 help "give each call a block of its own";
    p_stands_twice_in_block() "P stands twice in the block" alarm 12000 help "delete one of the words";
    s_stands_twice_in_block() "S stands twice in the block" alarm 12000 help "delete one of the words";
    g_stands_twice_in_block(fun) "G{fun} stands twice in the block";
    two_addresses_of_block_mean_same() "two addresses of the block mean the same";
    word_stands_twice_in_block(word) "{word} stands twice in the block"
        help "put the second function into a block of its own";
}

P1003 Error "word-misplaced" "word has no place in this block" was "K1005 word-not-allowed M1006 mtc-word-not-allowed S2012 siemens-word-misfit T1003 turning-word-not-admitted"
usual "remove the word, or put it into a block where it belongs"
"The word exists, but means nothing beside the other words of the block. partc never drops a word: remove it, or put it where it belongs.\n\n\
Klartext: The word exists in Klartext, but not in a block of this kind, so the control would refuse the block or ignore the word. partc \
never drops a word: remove it, or put it where it belongs.\n\n\
MTC200: The word exists, but means nothing beside the other words of the block, for example an axis word beside `G04`, or R with a \
straight line. partc never drops a word: remove it, or put it where it belongs.\n\n\
SINUMERIK: The word has no meaning beside the others: a centre in a straight line, a repeat without a label, a modifier that the address \
does not take. The control shows alarm 12110, or 15460 if the G code is modal only. Nothing is dropped, so the block is refused.\n\n\
HEIDENHAIN turning: Every word has to belong to a function of its block, and the functions of this one do not take it. The control would \
refuse it or ignore it; partc never drops a word. Remove it, or put it where it belongs." {
    has_no_place_so_cycle_parameter(shown, value) "`{shown}` has no place after `{value}`"
        help "a cycle parameter takes one number or one parameter: `Q201=-20` or `Q201=-Q1`; a remark starts with \
        `;`";
    has_no_place_in_cycle_definition(shown) "`{shown}` has no place in a cycle definition";
    is_joined_to_line_in_front(shown, of) "`{shown}` is joined to {of}: the line before it ends with `~`"
        help "remove the `~` at the end of the line before";
    moves_axes_of_plane(name) "{name} moves the axes of the plane and the tool axis";
    is_arc_in_plane(function) "{function} is an arc in the plane and moves no other axis"
        help "program the other axis in a block of its own";
    has_no_place_behind_section(text) "`{text}` has no place after a section word, which stands alone in its line"
        help "write it into a line of its own";
    has_no_place_in_cycle(text, cycle) "`{text}` has no place in cycle {cycle}";
    stands_in_name_of_cycle(word_text, number) "`{word_text}` stands in the name of the cycle"
        help "the values of cycle {number} belong into the blocks {number}.1 and up";
    in_point_may_belong_to_name(word_text) "in `{word_text}` the point may belong to the name or to the number"
        help "write a blank between the name and the number";
    cycle_has_no_parameter(number, q) "cycle {number} has no parameter {q}"
        help "remove it; if the line is a block of its own, remove the `~` at the end of the line before";
    in_definition_of_cycle(word_text, number, q)
        "`{word_text}` in the definition of cycle {number}: Q0 to Q99 belong to the program, and whether the cycle \
        changes {q} there is up to the machine builder"
        help "if the program counts with this {q}, write it as a block of its own and end the line before it without \
        `~`; if only the cycle reads it, take the line out together with the cycle";
    m_has_no_place_in_block(m, head) "M{m} has no place in a {head} block"
        help "write M{m} into the positioning block it belongs to";
    block_without_function_word_moves_one_axis() "a block without a function word moves one axis only"
        help "write L in front for a straight line: `L X+50 Y+10`";
    has_no_place_in_block(text, head) "`{text}` has no place in a {head} block"
        help "the feed of a corner is a number; without F the one in force holds";
    this_axis_is_not_in_working_plane() "this axis is not in the working plane: write both axes";
    cc_takes_two_of_x() "CC takes two of X, Y, Z" help "write `CC X+20 Y+10`";
    takes_its_end_from_pr(function) "{function} takes its end from PR and PA, not from an axis of the plane"
        help "remove the axis word, or use L or C";
    cp_takes_no_pr() "CP takes no PR: its radius is the distance of the tool from the pole"
        help "remove PR, or go to the radius with LP first";
    has_no_place_in_this_block(shown) "`{shown}` has no place in this block"
        help "remove the word, or put it into a block where it belongs";
    has_no_place(text, block) "`{text}` has no place in {block}";
    too_many_m_functions_in_one_block() "too many M functions in one block";
    moves_in_working_plane(head) "{head} moves in the working plane only"
        help "program the other axes in a block of their own, before the contour or after it";
    g41_g42_follow_each_other_without_g40() "G41 and G42 follow each other without G40"
        help "program G40 with a straight move between them";
    tool_changes_under_path_compensation() "the tool changes under path compensation" help "program G40 before";
    working_plane_changes_inside_compensated_contour()
        "the working plane changes inside a compensated contour or a corner"
        help "program G40 before";
    g04_stands_beside_other_words() "G04 stands beside other words" help "put G04 F… into a block of its own";
    only_names_its_axis_beside_g74(letter) "{letter} only names its axis beside G74, so its value is 0"
        help "write {letter}0";
    g74_inside_compensated_contour_or_corner() "G74 inside a compensated contour or a corner"
        help "program G40 before";
    zero_offset_changes_under_path_compensation() "the zero offset changes under path compensation"
        help "program G40 before";
    thread_under_g53_or_path_compensation() "a thread under G53 or path compensation"
        help "program G54 and G40 before";
    two_words_of_one_block_say() "two words of one block say where the program goes on";
    no_label_belongs(name) "no label belongs to `{name}`";
    word_does_not_fit_other_words() "the word does not fit the other words of the block"
        help "check which G code of group 1 is in force, and what it takes";
    only_ac_ic() "only AC(…) and IC(…) fit here" alarm 12020;
    this_word_counts_along(axis) "this word counts along {axis}, which lies outside the plane of the circle" alarm 12110
        help "an arc in G17 takes I and J, in G18 K and I, in G19 J and K; a helix has `TURN=` for its whole turns, \
        and no pitch";
    disc_lies_outside_0_to_100(disc) "DISC={disc} lies outside 0 to 100" help "0 is the circle, 100 the intersection";
    there_is_no_fixed_point(given) "there is no fixed point {given}" help "G75 has the fixed points FP=1 to FP=4";
    only_ac_and_ic_fit_ap() "only AC(…) and IC(…) fit AP=" alarm 12020;
    polar_pole_needs_ap() "a polar pole needs AP= and RP=" alarm 12110 help "give both";
    d_h_stand_in_one_block() "D and H stand in one block" alarm 14197;
    this_address_takes_no_such_modifier() "this address takes no such modifier" alarm 12020
        help "AC(…), IC(…), DC(…) and their kin are for end points, centres, polar words and SPOS=, PM(…) and PR(…) \
        for FAD=";
    no_function_of_block_takes(letter) "no function of the block takes {letter}"
        help "remove the word, or put it where it belongs";
    no_function_of_block_takes_text(addr) "no function of the block takes a text at {addr}";
    takes_number(name) "{name} takes a number";
    takes_plain_number_here(letter) "{letter} takes a plain number here"
        help "only X and Z can be incremental or left open with `?`";
    hands_no_value_over(addr) "{addr} hands no value over";
    call_takes_plain_numbers() "a call takes plain numbers";
    block_of_call_holds_words_that_no() "the block of a call holds words that no available manual describes"
        help "hand over values with LA to LF, LH and I, and put functions into blocks of their own";
    g80_takes_no_behind_g(name, number) "G80 takes no {name} after G{number}"
        help "remove the word, or put it where it belongs";
    g80_stands_alone_in_its_block() "G80 stands alone in its block";
    i_k_are_end_position(kind) "I and K are the end position, and H{kind} goes to none"
        help "program H0, H1, H2 or H8 with I and K, or leave I and K out";
    i_k_take_plain_numbers_here() "I and K take plain numbers here";
    takes_plain_number_here_2(letter) "{letter} takes a plain number here";
    is_not_supported_in_contour(addr) "{addr} is not supported in a contour";
    has_no_place_in_contour(addr) "{addr} has no place in a contour";
    m_function_has_no_place_in_contour() "an M function has no place in a contour";
    has_no_place_in_this_block_of_contour(letter) "{letter} has no place in this block of a contour"
        help "remove the word";
    feed_has_no_place_in_this_block_of_contour(letter) "{letter} has no place in this block of a contour"
        help "the feed of a corner is set in the cycle";
    e_is_feed_of_chamfer_or_rounding() "E is the feed of a chamfer or rounding, and the block has none"
        help "program B with the radius or the width, or leave out E";
    ic_belongs_to_v0() "IC belongs to V0 and V1";
    is_no_centre_word_of_plane(letter) "{letter} is no centre word of the working plane";
    r_belongs_to_arc() "R is the radius of an arc, and this block is none";
    i_j_k_belong_to_arc_or_thread() "I, J and K belong to an arc or a thread, and this block is neither";
    arc_has_centre_or_radius() "an arc has a centre or a radius, not both";
    thread_moves_linear_main_axes() "a thread moves linear main axes only";
    block_ends_program_and_goes_on() "the block ends the program and goes on elsewhere";
    axis_words_beside_g92() "axis words have no meaning beside G92";
    i_j_k_have_no_meaning() "I, J and K have no meaning in this block";
    r_has_no_meaning() "R has no meaning in this block";
    p_has_no_meaning() "P has no meaning in this block";
}

P1004 Error "word-missing" "block lacks a word" was "K1006 M1007 mtc-word-missing T1005 turning-word-missing"
"A word without which the block has no meaning is missing. Add it.\n\n\
Klartext: A word without which the block has no meaning is missing, for example the radius of `CR` or the value after an axis letter. \
The control would ask for it in its dialogue. Add the word.\n\n\
MTC200: A word without which the block has no meaning is missing, for example the F of `G04`, the lead of `G33`, or the axes of `G50`. \
Add it.\n\n\
HEIDENHAIN turning: A word without which the function has no meaning is missing. The control would ask for it in its dialogue. Add the \
word." {
    takes_its_size_from_other_words(name, form) "{name} takes its size from other words" help "write {form}";
    cr_needs_radius_that_is_not_zero() "CR needs a radius that is not zero" help "write R+20 or R-20";
    has_no_number(label) "`{label}` has no number" help "write the number after it";
    has_no_number_so_write_number(word) "`{word}` has no number" help "write the number after the letter";
    value_is_missing() "a value is missing";
    name_of_program_is_missing() "the name of the program is missing";
    names_no_table(name) "{name} names no table" help "write the name of the table: `SEL TABLE \"NAME.D\"`";
    l_lacks_its_value() "L lacks its value";
    tool_def_names_no_tool() "TOOL DEF names no tool";
    fpol_needs_both_axes_of_working_plane() "FPOL needs both axes of the working plane, as absolute words"
        help "write `FPOL X+50 Y+20`";
    fselect_needs_number_of_solution() "FSELECT needs the number of a solution" help "write it after: `FSELECT 1`";
    needs(text, needs) "`{text}` needs {needs}" help "complete the data, or remove the word";
    word_lacks(text, what) "`{text}` {what}" help "correct the value";
    lacks_its_value(word_text) "`{word_text}` lacks its value" help "write the value after the word";
    needs_length_above_zero(name) "{name} needs a length above zero";
    names_no_label(name) "`{name}` names no label" help "write the label after it: `BRA .LOOP`";
    name_of_subprogram_is_missing() "the name of the subprogram is missing";
    is_missing_contour_has_no_start(name) "{name} is missing: the contour has no start or no end";
    cycle_has_neither_ns_nor_contour() "the cycle has neither NS nor a contour after it";
    z_is_missing() "Z is missing: the bottom of the hole";
    i_is_missing()
        "I is missing: the greatest infeed"
        help "program I with the greatest infeed, on the radius";
    i_is_missing_under_v(kind)
        "I is missing: under V{kind} the control computes the greatest infeed from the speed and the pitch \
        F, by a formula that no available manual prints"
        help "program I with the greatest infeed, on the radius";
    size_of_undercut_is_missing(diameter)
        "a size of the undercut is missing, and the table has none for the diameter {diameter}";
    spindle_does_not_turn() "the spindle does not turn, so it is open whether the thread is right-handed"
        help "program M3 or M4 before G36";
    is_missing(letter, what) "{letter} is missing: {what}";
    shift_needs_absolute_z() "the shift needs an absolute Z";
    start_of_contour_needs_absolute_x() "the start of a contour needs absolute X and Z";
    p_is_missing(kind) "P is missing: the depth of a thread of type Q{kind}"
        help "program P with the depth on the radius";
    recess_needs_either_its_depth_i() "the recess needs either its depth I or its floor U";
    middle_of_recess_is_missing() "the middle of the recess is missing: X in a face, Z in a cylinder";
    recess_names_either_x_or_z() "a recess names either X or Z, as an absolute value"
        help "program Z for a recess in a cylinder, X for one in a face";
    block_names_no_end_point() "the block names no end point";
    thread_needs_end_point() "a thread needs an end point";
    cycle_needs_x() "the cycle needs X and Z of the corner that stays";
    line_of_turret_section_names_position() "a line of the turret section names a position: T1";
    e_is_missing() "E is missing: the dwell at the floor, which is one turn of the spindle"
        help "program E in seconds, or S before the cycle";
    changes_what_s_means(name, form) "{name} changes what S means, and has no S"
        help "program the speed in the same block: {form}";
    thread_across_face_has_no_r() "a thread across a face has no R: where it starts is not known"
        help "program R with the radial length, (X of the end - X of the start) / 2";
    end_of_thread_cannot_be_left_open() "the end of a thread cannot be left open";
    thread_needs_both_x() "a thread needs both X and Z of its end"
        help "X is the diameter at the end; a thread across a face needs R, its radial length, as well";
    is_missing_so_control_computes(letter, what) "{letter} is missing: the {what}"
        help "the control computes it from the speed, which is not fixed here: program it, or G97 S… before the \
        cycle";
    spindle_does_not_turn_when_g_begins(number)
        "the spindle does not turn when G{number} begins, so the thread has no pitch"
        help "program M3 or M4 before G{number}";
    undercut_needs_absolute_x() "an undercut needs absolute X and Z of its corner";
    g92_needs_its_s() "G92 needs its S: `G92 S2000`";
    offset_names_no_axis() "the offset names no axis";
    g74_names_no_axis() "G74 names no axis: `G74 X0 Z0`";
    needs_its_s_in_same_block(name, form) "{name} needs its S in the same block: `{form}`";
    g04_needs_its_time() "G04 needs its time: `G04 F2.5`";
    jmp_and_jsr_name_program() "JMP and JSR name a program: `JSR P5`";
    rnd_needs_radius() "RND needs a radius above zero" help "write the radius: `RND R5`";
    chf_needs_length() "CHF needs a length above zero"
        help "write the length cut off along each side: `CHF 5`";
}

P1005 Error "functions-conflict" "functions of one block contradict each other" was "K1014 m-functions-conflict M1010 mtc-m-conflict T1006 turning-functions-clash"
"Two functions of the block cannot act together. Keep one, or put them into two blocks.\n\n\
Klartext: For example M3 with M4, or M8 with M9 in one block. Which one acts last is not defined, so the spindle might turn the wrong \
way. Keep one, or put them into two blocks.\n\n\
MTC200: For example M3 with M4, or M8 with M9 in one block. Which one acts last is not defined, so the spindle might turn the wrong way. \
Keep one, or put them into two blocks.\n\n\
HEIDENHAIN turning: Two functions of the block cannot act together: both move, both take the same word, or they say opposite things (`M3 \
M4`). Put the second one into a block of its own." {
    cycle_call() "a cycle call and the end of the program in one block"
        help "write the end of the program into a block of its own";
    m_contradicts_m(b, a) "M{b} contradicts M{a}" help "keep one of them, or put them into two blocks";
    m_contradicts_m_of_same_block(number, first) "M{number} contradicts M{first} of the same block";
    more_than_m_functions_in_one_block(most_m) "more than {most_m} M functions in one block";
    g_another_move_or_cycle_stand(fun) "G{fun} and another move or cycle stand in one block"
        help "put the second one into a block of its own";
    two_functions_of_block_take(letter) "two functions of the block take {letter}"
        help "put the second function into a block of its own";
    stands_in_block_of_g869(name) "{name} stands in the block of G869 and in the words of G80"
        help "leave one of the two out";
    contour_stands_in_blocks() "the contour stands in blocks and in the words of G80";
    m_stands_in_block_of_cycle_whose(m) "M{m} stands in the block of a cycle whose contour follows"
        help "put it before the cycle or after its G80";
    tapping_under_constant_cutting_speed() "tapping under a constant cutting speed (G96)"
        help "program `G97 S…` before G36";
    m_m_cannot_stand_in_one_block(other, m) "M{other} and M{m} cannot stand in one block"
        help "put the second one into a block of its own";
    xa_za_say_where_corner_of_blank() "XA and ZA say where the corner of the blank is, and RI and RK say it again"
        help "leave one of the two out";
    r_rb_are_same_word_of_g869() "R and RB are the same word of G869";
    thread_has_end_point() "the thread has an end point and a contour: only one can hold";
    r_is_not_difference_of_radii(y)
        "R is not the difference of the radii at the ends of the contour, which is {y:.4} mm";
    i_gives_infeed() "I gives the infeed and IC the number of cuts: only one of the two can hold"
        help "leave one of the two out";
}

P1006 Error "program-cut-off" "file ends without the end of its program" was "K1011 no-program-end M1008 mtc-cut-off T1010 turning-no-end"
"Most likely the file was cut off in transfer, and the end of the path is missing. If the program is complete, add its end.\n\n\
Klartext: The program has a head but no `END PGM` block: most likely the file was cut off in transfer, and the end of the path is \
missing. If the program is complete, add the block.\n\n\
MTC200: A file with a header holds a whole program, and that ends with RET, BST, JMP, M02, M30 or PROGRAMMENDE. Most likely the file was \
cut off in transfer and the end of the path is missing. If the program is complete, add the block.\n\n\
HEIDENHAIN turning: A main program ends with END (ENDE), a subprogram with RETURN. The file has a program name or sections but no end: \
most likely it was cut off in transfer, and the end of the path is missing. If the program is complete, add the word." {
    file_ends_without_end_pgm() "the file ends without END PGM"
        help "the file may have been cut off in transfer; if it is complete, add END PGM";
    file_ends_without_ret_or_m30() "the file ends without RET or M30"
        help "it may have been cut off in transfer; if it is complete, add RET";
    file_ends(what) "the file ends without {what}"
        help "the file may have been cut off in transfer; if it is complete, add {what}";
}

P1007 Warning "program-without-end" "program has no end" was "M1009 mtc-no-end S2026 siemens-no-end R1002 gcode-end-missing"
"The output ends with M2 all the same.\n\n\
MTC200: The text ends without RET, BST, JMP, M02 or M30. Without `[control] open_end = \"allow\"` that is an error (P0007). The output \
ends with M2. Add RET if this is a program of its own.\n\n\
SINUMERIK: The main program ends without M30, M2 or M17; a control raises alarm 14000. Without `[control] open_end = \"allow\"` that is \
an error (P0007). The output gets an M2.\n\n\
Plain G-code: The last line is no end of a program. The file may have been cut off in transfer, or the program that made it leaves the \
end to the control. Without `[control] open_end = \"allow\"` that is an error (P0007); a file between two lines of % may end so. The \
output gets M2. Where the file begins with a line of `%`, the second one ends the program, and this is said there, too. Look at the last \
lines, and add M30." {
    program_ends_at_its_second() "the program ends at its second `%`, without M2 or M30";
    program_ends_without_m2_or_m30() "the program ends without M2 or M30";
    program_ends_without_ret_or_m30() "the program ends without RET or M30";
    program_ends_without_m30() "the program ends without M30, M2 or M17" alarm 14000;
}

P1008 Warning "text-after-end" "blocks after the end of the program" was "K1012 T1011 turning-behind-end"
"The control does not execute what follows the end of the program, and nor does partc.\n\n\
Klartext: The control ignores what follows END PGM, and so does partc. If the blocks belong to the program, move the END PGM block \
after them; otherwise delete them.\n\n\
HEIDENHAIN turning: What stands after END is not executed. Most often two programs were joined into one file; each needs a file of its \
own." {
    this_stands_behind_end_pgm() "this stands after END PGM and is not part of the program";
    this_stands_behind_end_of_program() "this stands after the end of the program and is not part of it";
}

P1009 Error "second-program" "file holds a second program" was "K1013 second-program-head M1012 mtc-second-program"
"A file holds one program. Put each into a file of its own.\n\n\
Klartext: A file holds one program. A second head means that two files were joined: on the machine the second one would never load this \
way. Put each program into a file of its own.\n\n\
MTC200: A line `%NPG` stands after blocks of a program: another program begins there. JSR and JMP name programs by the number under \
which they are stored, which no line of a transfer file says, and labels belong to one program alone. Which program is meant has to be \
certain: put each into a file of its own, named by its number." {
    second_program_begins_in_this_file() "a second program begins in this file"
        help "put each program into a file of its own";
    second_program_begins_here() "a second program begins here";
}

P1010 Error "block-in-comment" "comment hides a block after a lone carriage return" was "K1016 S1015 siemens-block-in-comment"
"A comment holds a carriage return, and what follows reads as a block. Lines of this file end with a line feed, so for the control the \
rest still is comment, while many editors show a line of its own. Whether the block shall run cannot be known: end the comment with a \
line feed, or remove the block." {
    stands_in_comment_behind_lone_carriage_return(block)
        "`{block}` stands in a comment after a lone carriage return"
        help "end the line of the comment with a line feed, or remove the block";
}

P1011 Error "lone-carriage-return" "carriage return inside a block" was "M1050 mtc-carriage-return S1101 siemens-lone-return T2050 turning-lone-return"
"Other programs show what follows the carriage return as a line of its own, and the control reads it on. Which of the two was meant \
cannot be told. Save the file anew with one kind of line end.\n\n\
MTC200: A carriage return or a line feed stands inside of a block. Other programs show what follows it as a line of its own, the control \
reads it on, or loses it after a comment. Which of the two was meant cannot be told. Save the file anew with one kind of line break.\n\n\
SINUMERIK: The lines of this file end with a line feed, and a carriage return alone stands between two words. Most often it is what is \
left of a line end, so that two blocks would be read as one. End every line in the same way: with a line feed, or with a carriage return \
and a line feed.\n\n\
HEIDENHAIN turning: A carriage return stands alone, without a line feed, in a file whose lines end with line feeds. Editors show what \
follows as a line of its own; partc and the control would read it as part of the same line, or of its comment. End the line with a line \
feed." {
    line_break_stands_inside_of_block() "a line break stands inside of the block, and does not end it"
        help "save the file with one kind of line break";
    carriage_return_without_line_feed_stands_inside()
        "a carriage return without a line feed stands inside this block"
        help "end every line of the file in the same way";
    stands_behind_lone_carriage_return(of) "`{of}` stands after a lone carriage return"
        help "end the line before it with a line feed, or remove it";
}
}
