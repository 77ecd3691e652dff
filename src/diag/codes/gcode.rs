//! `R`: plain G-code.

super::codes! { GCODE:

R1001 Error "gcode-line" "line of plain G-code cannot be read"
"partc reads G-code that is resolved already: G0 to G3, G33, positions, F, S, T, M, work offsets, planes, units. A line with a variable, a call, a cycle or another \
function is refused, and so is a line that counts on something that is not stated: a unit, a feed, the place of an axis. Positions hold as numbers only when the line in \
front of it is certain. Resolve the program first, or name its language with `--dialect`; `[control] unit` and `[start]` in partc.toml say what a program leaves open." {
    this_line_cannot_be_read(why, why2) "this line cannot be read: {why}{why2}";
    has_to_stand_in_line() "`%` has to stand in a line of its own";
    line_break_stands_inside_of_this_line() "a line break stands inside of this line";
}

R1003 Error "gcode-of-another-receiver" "program was printed for another receiver"
"The head of this program says for which target partc printed it. Its lines look like those of LinuxCNC, and some mean another thing there: on a Fanuc control G4 P counts \
thousandths of a second, and on its lathes G90 cuts. Compile the program that it was made of; `partc diff` compares such outputs as they are meant." {
    this_program_was_printed_for_target(name)
        "this program was printed for the target {name}, where its words mean other things";
}

R1004 Warning "gcode-after-percent" "lines after the closing %"
"The file begins with a line of a single `%`, so the second one ends the program, as it ended a paper tape: LinuxCNC reads nothing after it, and neither does partc. There was no M2 or M30 before it, \
so the lines after it may be part of the program, and a second `%` may stand in the middle where files were joined. If they belong to the program, delete the `%` before them; otherwise delete them." {
    this_stands_after_that_ends_program() "this stands after the `%` that ends the program, and does not run";
}

R1005 Warning "gcode-program-number" "program number of another control"
"The program begins with a number such as O1001, as on a Fanuc or Haas control; LinuxCNC has none. The number is left out, and the lines after it are read as LinuxCNC reads them. Two things may mean \
another value on the control that the program is for: G4 P may count thousandths of a second, and a number without a decimal point may count thousandths of a millimetre. Cycles, calls and variables are \
refused. Compare the output with the program; if it holds no such numbers, nothing is to be done." {
    program_number_of_fanuc_control(trim_ascii)
        "program number {trim_ascii} of a Fanuc control or its like is left out, and the lines after it are read as \
        plain G-code"
        help "check dwells and numbers without a point: G4 P counts seconds and `X100` is 100 mm here, and on such a \
        control they may be thousandths";
}

R2001 Error "gcode-tool-length" "tool length that the output does not have"
"G43 H adds the length of a tool, G49 takes it away, and all positions along Z count with it or without it. The output has G43 after each tool change with the number \
of the tool where `[output] tool_length = \"G43\"` is set, and nowhere else. A program that does it in another way cannot be printed." {
    g97_stands_without_s()
        "G97 stands after G96 without S: the last S was a cutting speed, and as turns a minute its number \
        is another speed"
        help "write the turns a minute with it: `G97 S1000`";
    output_has_no_tool_length(number) "G43 H{number} adds a tool length, and the output has none"
        asks "set `[output] tool_length = \"G43\"`";
    g43_adds_length_of_another_tool(number)
        "G43 H{number} adds the length of another tool than the one in the spindle"
        help "the output has G43 after each tool change, with the number of the tool";
    tool_moves_without_its_length()
        "the tool moves without its length, and the output adds it (G43) at the tool change"
        asks "set `[output] tool_length = \"off\"`, or write G43 before the move";
}

R4001 Error "gcode-arc-turns" "arc of too many turns"
"P of an arc is the number of its turns. More than 100,000 are no work that a machine does: most often P belongs to another word of the line, or a digit is wrong. A target \
that does not count turns would get a block or more for each. The line is refused, so nothing is written." {
    arc_turns_times(unsigned_abs, most_turns)
        "the arc turns {unsigned_abs} times, and partc takes {most_turns} at most";
}

R8001 Note "gcode-path-control" "G64 without P gets the bound of the output"
"G64 alone keeps the speed up and promises no bound on how far it rounds corners off. The output states one: 0.01 mm, or what `[output] path_control` says. G61 and `G64 P` are printed as they are meant." {
    g64_without_p_says_no_bound(what) "G64 without P says no bound: {what}";
}

}
