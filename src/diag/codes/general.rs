//! `P`: files, configuration, limits of a run.

super::codes! { GENERAL:

P0001 Error "utf16-file" "file is UTF-16"
"The file has two bytes a character. No control writes that; it comes from a text editor set to \"Unicode\".\n\
Save the program as UTF-8 or Windows-1252 and compile again." {
    is_utf_16_file(name) "`{name}` is a UTF-16 file" help "save it as UTF-8 or Windows-1252";
}

P0002 Error "file-too-large" "file is over 4 GiB"
"Places in a program are counted in 32 bits, so one file holds at most 4 GiB. Nothing is written. Split the program and call the \
parts from a short one with `CALL PGM`." {
    is_over_4_gib(name) "`{name}` is over 4 GiB";
}

P0003 Error "block-too-long" "block is over 1 MiB"
"No control accepts a block of this length; the file is damaged or is no part program. The block is left out, so no output is written." {
    block_is_longer_than_1_mib() "block is longer than 1 MiB";
}

P0004 Error "empty-file" "file holds no block"
"The file is empty, or holds nothing but blanks. No control runs that, and most often a transfer broke off or the editor did not save. \
Nothing is written, since a program without moves would look like one that was compiled." {
    is_empty(name) "`{name}` is empty" help "check whether the file was transferred completely";
}

P0005 Error "hole-in-block" "NUL or Ctrl-Z stands inside a block"
"Text of one block or comment stands before and after these bytes, which no editor and no control writes. Something else stood there before: \
a memory card, a transfer or a full disk lost it, perhaps with the end of the block and the next ones. Nothing is written.\n\
Get the program anew from where it was made." {
    nul_or_ctrl_z_stands_inside_block() "NUL or Ctrl-Z stands inside a block";
}

P0006 Warning firm "hole-between-blocks" "NUL or Ctrl-Z stands between the blocks of a program"
"Controls leave these bytes out where a paper tape or a transfer program has put them; partc does the same. They also stand where a memory card \
or a transfer lost whole blocks: compare the program with the one that was sent. Before the first block and after the last one they are padding \
and mean nothing." {
    nul_or_ctrl_z_stands_between_blocks() "NUL or Ctrl-Z stands between the blocks of the program";
}

P0007 Error "open-end" "main program has no end of program"
"The file of a main program is over, and no block of it has ended the program (M30, M2, END PGM, RET). A file that was cut off in transfer \
looks like that, and what the missing blocks do is not known: nothing is written, since an end that partc adds would hide it from the \
machine, too. A control stops there as well (SINUMERIK: alarm 14000).\n\
Compare the file with the original. If it is complete, write the end as its last block. Where the control or the transfer needs none, set \
`[control] open_end = \"allow\"`: the end is added then, with a warning. Subprograms are not meant." {
    program_ends(end, best) "the program ends without {end}"
        asks "the file may have been cut off in transfer; if it is complete, add {best}; for a control that needs no \
        end, set `[control] open_end = \"allow\"`";
}

P0008 Error "cut-off" "file stops in its last line"
"The last line has no line end, and there is no end of program after it or in it: the file was cut off, perhaps inside a number (`G1 X12` \
of `G1 X123.456`). No key allows it (a piece of Klartext without BEGIN PGM, which another \
program joins to others, is P0007). Get the file anew from where it was made. If it is complete, write the end of the program as its last \
block; a last line that holds the end of the program needs no line end, unless the file stops after `M2`: that may be the beginning of `M20` or `M2=3`, so write \
`M30`, or a line end after it." {
    file_stops_in_its_last_line(end, best) "the file stops in its last line, without {end}: it was cut off"
        help "get the file anew; if its last line is complete, end it, and add {best}";
    file_stops_in_its_last_line_after()
        "the file stops in its last line, after `M2`, which may be the beginning of a longer word: it was cut off"
        help "get the file anew; if `M2` is its end, write a line end after it";
}

P0009 Error "other-language" "file is in none of the languages"
"The file is called like a part program, and its words show that it is something else: a program for another control (Fanuc, Okuma, a 3-D \
printer), an archive, source text, a document. The message names what was recognized, and the words and lines that show it. It is the only \
finding: read in the wrong language, such a file would bring up nothing but misleading ones.\n\
partc reads Klartext, SINUMERIK, MTC200, HEIDENHAIN turning and plain G-code. If the file is in one of these, say so with `--dialect` or \
under `[dialects]` in partc.toml: then nothing is guessed. `--dialect gcode` is advised where the reader of plain G-code takes the beginning of the file; \
otherwise the help names the first line that it refuses.\n\
`.nc` is the name of programs of many controls. Such a file is read as HEIDENHAIN turning where a name line (`%95.nc`), a comment in \
square brackets, `END` or a function of that control shows it, and with a warning (P0012) where only its blocks are numbered by one. To leave files out, add a line to `.partcignore`."

P0012 Warning "turning-by-numbers" "language is told by the numbers of the blocks alone"
"A file `.nc` may come from many controls. Nothing in this one shows which but the numbers of its blocks, N1, N2, N3, and feeds of a lathe: it is \
read as HEIDENHAIN turning, where X is a diameter. Say so with `--dialect heidenhain-turning` or under `[dialects]`, and the warning is gone; if the \
program is for another control, say that one." {
    file_is_read_as_heidenhain_turning()
        "the file is read as HEIDENHAIN turning, where X is a diameter, and only the numbers of its blocks show it"
        help "say the language with `--dialect`, or under [dialects]: \"*.nc\" = \"heidenhain-turning\"";
}

P0101 Error "program-not-found" "called program is not in the include roots"
"The program calls another one that partc cannot find. Without it the path is incomplete, so nothing is written.\n\
Put the file beside the calling program, or name its folder under `[include] roots` in partc.toml, for example `\"TNC:\" = \"programs\"`.\n\
Upper and lower case do not matter as long as one file fits." {
    no_program_is_selected() "no program is selected: SEL PGM comes first";
    program_is_not_found(name) "program `{name}` is not found";
}

P0107 Warning "found-elsewhere" "file is not where the control looks for it"
"A HEIDENHAIN control looks for a name without a path in the folder of the program that names it, and nowhere else. Here the file lies in another folder \
that partc knows, in one only, and is taken from there. In a SINUMERIK text, a path names a folder of which nothing is known, and a program without a `;$PATH=` line has that \
name; or a file lies beside the main program, and by its own `;$PATH=` line in a folder in which nothing looks. Either way the machine may run another program, or none.\n\
Put the file where the control looks, or write its path; give a program of an archive, or the main program, its `;$PATH=` line." {
    does_not_lie_beside_program_that_names(name, opened)
        "`{name}` does not lie beside the program that names it; `{opened}` is taken"
        help "on the control a name without a path means the folder of the program that names it: put the file \
        there, or write its path";
    by_its_path_line_lies(shown, folder)
        "by its `;$PATH=` line `{shown}` lies in `{folder}`, where this call looks only if the main program lies \
        there, too; it is taken"
        help "write the line `;$PATH={folder}` after the head of the main program if both lie there";
    no_folder_is_known(folder, program)
        "no folder is known for `{folder}`; the program {program} of this file is taken"
        help "write the line `;$PATH={folder}` after its head if it lies there";
}

P0102 Error "path-forbidden" "called program lies outside the include roots"
"A called program may only come from the folders in `[include] roots` (by default the folder of the main program). \
Names with `..`, absolute paths of the host, network shares, device names and links that lead out are refused, so that compiling \
a foreign program can never read other files of this computer." {
    program_may_not_be_opened(name, why) "program `{name}` may not be opened: {why}"
        asks "name its folder under `[include] roots`";
}

P0103 Error "file-name-ambiguous" "more than one file fits the called name"
"Controls ignore upper and lower case in names, this computer does not, and two files differ only in that. Or the name has no path, and files in \
several folders have it; or it has no extension, and a file without one lies beside one that has it. \
Rename one of them, or write the path: which program the machine would run cannot be guessed." {
    program_may_be_any(name, names) "program `{name}` may be any of {names}";
}

P0104 Error "include-root-missing" "no include root for this drive or folder of the control"
"The program is called by a path of the control, such as `TNC:\\\\PARTS\\\\A.H`. partc.toml has to say which folder of this computer that is: \
`[include] roots = { \"TNC:\" = \"programs\" }`." {
    no_folder_is_known(prefix) "no folder is known for `{prefix}`"
        asks "add `[include] roots = {{ \"{prefix}\" = \"folder\" }}` to partc.toml";
}

P0105 Error "file-unreadable" "called program could not be read"
"The operating system refused to read the file, so what it would do is not known and nothing is written. Check that it exists, is a \
file and not a folder, and may be read." {
    file_cannot_be_read(error) "the file cannot be read: {error}";
    program_cannot_be_read(name, why) "program `{name}` cannot be read: {why}";
    cannot_be_read(name, error) "`{name}` cannot be read: {error}";
    file_cannot_be_read_2() "the file cannot be read";
}

P0106 Error "too-many-files" "program calls more than 1000 different files"
"A run opens at most 1000 files. A program that calls more is most likely calling names that a loop makes up. Join programs, or call \
the same ones again: each counts once." {
    too_many_programs_are_called() "too many programs are called";
}

P0120 Error "called-file-too-large" "called program is over 256 MiB"
"A jump reads its file whole, so one called program may have 256 MiB at most. The size is looked at before a byte of it is read: \
often it is no program at all. A main program without jumps may be larger; compile the called one by itself, or split it." {
    called_program_has_mib(name, size, most)
        "called program `{name}` has {size} MiB, more than the {most} MiB of one called file"
        help "compile it as a main program, or split it";
}

P0121 Error "called-files-too-large" "called programs are over 1 GiB together"
"All programs that a run calls may have 1 GiB together. Compile the large ones as main programs of their own." {
    with_called_programs_have_mib(name, all, most)
        "with `{name}` the called programs have {all} MiB, more than {most} MiB together"
        help "compile the large ones as main programs";
}

P0130 Error "tool-table-unit" "tool table and program have different units"
"The tool table is in another unit than the program, or states none and is taken for mm. A radius that is off by 25.4 breaks the tool, so \
the compiler asks: \
check the table, and say its unit in partc.toml, `[tools] unit = \"mm\"`. Its lengths are converted then." {
    program_calls_tool(program, table) "the program calls a tool in {program}, and the tool table is in {table}"
        asks "check the table; if its lengths are in {table}, say so in partc.toml: `[tools] unit = \"{table}\"`";
}

P0201 Warning firm "two-skip-levels" "two skip levels are switched on as one"
"`[control] skip_blocks` lists level 1 and not level 0, and the program has blocks with / and blocks with /1. Level 1 takes the plain / \
along, as users count \
who have one switch only; on a SINUMERIK / is level 0, the first of ten, and /1 is another switch. Both kinds are left out. Write `[0]` to \
leave out those \
with / alone, or `[0, 1]` where both are meant." {
    skip_blocks_1_leaves_out_blocks()
        "`skip_blocks = [1]` leaves out blocks with / and blocks with /1, and this program has both; on the control \
        / is level 0, the first one, and /1 is the second"
        help "write `skip_blocks = [0]` to leave out the blocks with / alone, `[0, 1]` for both";
}

P0202 Error "work-offset-of-two" "two work offsets are printed as one"
"`[datums]` maps a work offset of the program to one that stands for another work offset of the same program, too: two parts that lie \
apart would be cut at one place. \
Name another work offset of the target for one of them, and set it up there. Where both are one place on purpose, give the second one the \
same values; partc does not know them." {
    is_to_be_printed(said, word, theirs) "{said} is to be printed as {word}, and so was {theirs}";
}

P0203 Error "tool-number-of-two" "two tools are printed by one number"
"`number` in `[tools]` says what a tool is printed as, and the program calls another tool that is printed so, too: the machine would bring \
the same tool for both. Give each of them \
a number of its own." {
    tool_is_printed_as_another(own, number, other, mapped)
        "tool {own} is to be printed as T{number}, and so is tool {other}"
        asks "give it a number of its own in partc.toml: `number` in `[tools.{mapped}]`; if both are one tool, \
        describe it in one place: `[tools.{number}]` with its `name`";
    tool_has_number_of_another(own, number, other, printed, mapped)
        "tool {own} has the number {number}, and so has tool {other}, which is printed as T{printed}"
        asks "give it a number of its own in partc.toml: `number` in `[tools.{mapped}]`; if both are one tool, \
        describe it in one place: `[tools.{number}]` with its `name`";
}

P0205 Error "entry-takes-a-move-away" "entry of partc.toml would make a move vanish"
"An entry says of a word that it does nothing to the path: `[control] machine_words`, or `ignore` under `[programs]`. partc knows the word, and it moves the tool, or says where it goes: a tapping \
function, a machining cycle, mirror, scale, a transformation. Left out, what follows would be another path: a tap would go into its hole at rapid. Take the entry out. What cannot be compiled has to \
be programmed another way; for a cycle, a program of your own may stand: `{ file = \"stubs/CYCLE952.SPF\" }`. No program can stand for another word of the language, such as TRANS, and no word of the machine may \
be, or become, an M function that partc has to know of, such as M3, M6 or M30. Of a Klartext program or cycle an entry may not say what Klartext does not have: `motion`, \
or an argument." {
    programs_says_that_argument_of_names_tool(key)
        "`[programs]` says that an argument of {key} names the tool, and CALL PGM has none"
        help "`\"{key}\" = {{ change = true }}` changes to the tool of the TOOL CALL before it";
    programs_says_that_leaves_g0_or_g1(key)
        "`[programs]` says that {key} leaves G0 or G1 active, and Klartext has neither"
        help "take `motion` out of the entry";
    of_partc_toml_names(key, named) "`{key}` of partc.toml names {named}";
}

P0206 Warning "tool-never-changed" "tool is chosen, and the program changes none"
"T chooses a tool, the program cuts, and no word of it changes a tool. Where M6 changes tools, the tool that is in the spindle at the start cuts, on the control and here. Where T itself changes them, the output would cut with the wrong one: partc takes M6 for the word unless the machine is a lathe. Set `[control] tool_change = \"t\"` for a machine that changes with T, or \"m6\" where the program means the tool that is there." {
    t_chooses_tool(number)
        "T chooses tool {number}, and the program has no M6: it cuts with the tool that is in the spindle at its \
        start"
        asks "if T alone changes the tool, set `[control] tool_change = \"t\"`; if M6 is missing, program it; \
        `tool_change = \"m6\"` takes the tool that is there";
}

P4001 Error "step-limit" "program runs too many blocks"
"partc executes the program as the control would, and stops after `[limits] steps` blocks, counted from the first jump \
or call on (10 million by default). \
Most often a loop never ends: the condition of its jump is always true. The message names the jump or repeat that ran most often.\n\
If the program really is that long, raise the limit." {
    after_error_fewer_blocks_run(number, what) "stopped: after an error only {number} {what} are run"
        help "mend the other errors first; then check the condition that ends this loop";
    run_has_no_steps_left(number, what) "stopped after {number} {what}"
        asks "check the condition that ends this loop, or raise `[limits] steps`";
}

P4002 Error "output-limit" "program makes too many output blocks"
"The output has more lines than `[limits] output_blocks` (50 million by default), head and end included, so it was given up: most often a \
loop runs too many times, or \
never ends. Check the loops and repeats around the marked block, or raise the limit." {
    output_has_more_than_lines(most_lines) "the output has more than {most_lines} lines, head and end included"
        asks "look for a loop that does not end, or raise `[limits] output_blocks`";
}

P4003 Error "call-depth" "calls are nested too deep"
usual "nest the calls less deeply"
"Programs and subprograms call each other deeper than `[limits] call_depth`, or deeper than the selected control allows. \
Often a program calls itself by way of another one." {
    program_calls_itself(number) "program {number} calls itself";
    calls_go_round(message, cycle) "{message}: {cycle}";
    calls_are_nested_deeper(limit) "calls are nested deeper than {limit} levels";
    subprograms_are_nested_deeper(limit) "subprograms are nested deeper than {limit} levels";
    subroutines_are_nested_deeper(limit) "subroutines are nested deeper than {limit} levels";
    control_allows_no_deeper_nesting(what, limit)
        "{what} are nested deeper than {limit} levels, which the control does not allow";
    programs_repeats_are_nested_deeper(levels) "programs and repeats are nested deeper than {levels}" alarm 14012;
    texts_that_execute_texts_are_nested_too() "texts that execute texts are nested too deep" alarm 14012
        help "check for an EXECSTRING that executes itself";
}

P8001 Warning "suppression-unused" "suppression that suppresses nothing"
"A comment `partc: ignore[CODE]` wants a finding not to be shown, and there is none in its block (or, for `ignore-file`, in the file). The block was \
mended, or the comment stands at the wrong one, and would hide the next mistake there. Remove it. `partc check` says so for the program \
that is checked, not for those that it calls, and only where no error ends the search."

P8002 Warning "suppression-without-code" "suppression without a code, or with one that does not exist"
"A suppression names what it suppresses: `partc: ignore[K8022]`, several by commas, each by its code or its name. Without a code it would \
hide whatever comes, so nothing is suppressed. `partc rules` lists all codes and names."

P8003 Warning "suppression-refused" "suppression of what cannot be suppressed"
"An error is never hidden: the program is not compiled, whatever a comment says. The same holds for the few warnings and notes that say that the \
tool goes another way than the blocks do, such as a rounding that was made smaller. Mend the program, and remove the comment."

P8004 Warning "suppression-unreadable" "suppression that cannot be read"
"A comment begins with `partc:` and goes on with something else than `ignore[CODE, …]` or `ignore-file[CODE, …]`, perhaps with `-- reason` \
after it; or a bracket is not closed, or something else stands after it. Nothing is suppressed by it."

}
