//! `M`: Rexroth MTC200.

super::codes! { MTC200:

M0001 Error "mtc-character" "character that no MTC200 block may contain"
"A character stands outside a comment where the control knows only letters, digits, signs and blanks. Often a file was damaged in \
transfer. Comments stand behind `;`, in round brackets, or in square brackets."

M0002 Warning "mtc-typographic-minus" "typographic dash in an MTC200 block is read as minus"
"The block holds a dash as books print it (U+2013, U+2212), which happens when a program is copied out of a PDF. \
It is read as a minus; a control would refuse it. Replace it by `-`."

M0003 Error "mtc-comment-open" "comment is not closed in its block"
"A comment in brackets ends in the block in which it begins. Without the closing bracket it is not clear which words belong to it, and \
a word that moves the tool might be lost. Close it, or write a comment that begins with `;`."

M1001 Error "mtc-syntax" "MTC200 block cannot be read"
"A word stands where this block cannot have it, or a part is missing. Nothing of the block is used. A block is a list of words: a \
letter and a number (`X10`), a letter, `=` and a formula (`X=@050+1`), or a name (`RET`)."

M1002 Error "mtc-header" "file header is damaged"
"A transfer file begins with a line `%NPG…`, goes on with lines that begin with `!`, `#`, `$` or `*`, and ends its header with a second \
`%NPG`. Here such a line stands in the program, another line stands in the header, or the header never ends. What is header and what is \
program has to be certain: copy the file again. Source: NC Programming Instructions 17VRS, page 14-13."

M1003 Error "mtc-address-alone" "address without a value"
"A letter stands alone. The control needs a number behind it, or `=` and a variable: `X10`, `X=@050`."

M1004 Error "mtc-word-twice" "same word twice in one MTC200 block"
"An address may stand once in a block. Which of the two values the control takes is not documented. Remove one, or, if the control is known to \
take the last one, set `[control] repeated_words = \"last\"` in partc.toml."

M1005 Error "mtc-g-conflict" "G functions of one group in one block"
"Two G functions of the same group contradict each other, for example `G00` and `G01`. Only one of them can act, and the control refuses the \
block. Remove one, or put them into two blocks."

M1006 Error "mtc-word-not-allowed" "word has no place in this MTC200 block"
"The word exists, but means nothing beside the other words of the block, for example an axis word beside `G04`, or R with a straight line. partc never \
drops a word: remove it, or put it where it belongs."

M1007 Error "mtc-word-missing" "MTC200 block lacks a word"
"A word without which the block has no meaning is missing, for example the F of `G04`, the lead of `G33`, or the axes of `G50`. Add it."

M1008 Error "mtc-cut-off" "transfer file ends without RET or M30"
"A file with a header holds a whole program, and that ends with RET, BST, JMP, M02, M30 or PROGRAMMENDE. Most likely the file was cut off in transfer and the end \
of the path is missing. If the program is complete, add the block."

M1009 Warning "mtc-no-end" "program ends without RET or M30"
"The text ends without RET, BST, JMP, M02 or M30. Without `[control] open_end = \"allow\"` that is an error (P0007). The output ends \
with M2. Add RET if this is a program of its own."

M1010 Error "mtc-m-conflict" "M functions of one MTC200 block contradict"
"For example M3 with M4, or M8 with M9 in one block. Which one acts last is not defined, so the spindle might turn the wrong way. \
Keep one, or put them into two blocks."

M1011 Error "mtc-calculation-beside-words" "calculation beside other words"
"A block assigns a variable and does something else as well. In which order the control does both is not documented, and the result \
may depend on it. Put the assignment into a block of its own."

M1012 Error "mtc-second-program" "file holds a second program"
"A line `%NPG` stands behind blocks of a program: another program begins there. JSR and JMP name programs by the number under which they are stored, which no line of a \
transfer file says, and labels belong to one program alone. Which program is meant has to be certain: put each into a file of its own, named by its number."

M1050 Error "mtc-carriage-return" "a line break that does not end the line"
"A carriage return or a line feed stands inside of a block. Other programs show what follows it as a line of its own, the control reads it on, or loses it behind a \
comment. Which of the two was meant cannot be told. Save the file anew with one kind of line break."

M2001 Error "mtc-position-unknown" "position of an axis is not known in this block"
"The block needs the position from which it starts: for an incremental word, an arc or a thread. No block before gave this axis an absolute \
position, or a tool change, a work offset or a move in machine coordinates made it unknown. Program an absolute position first. If the program \
relies on where the machine stands at the start, say so in partc.toml: `[start]` with `X = 0.0`."

M2002 Error "mtc-feed-missing" "cutting move without feed"
"No F word stands before this move, or G94 and G95 changed since the last one. Program F, or set `[control] feed` for fragments that get their feed elsewhere."

M2003 Error "mtc-interpolation-missing" "axis words without G00, G01, G02 or G03"
"No block before named the kind of motion. Which one is in force after switching on depends on the parameters of the machine: it might be \
rapid traverse. Program G00 or G01."

M2004 Error "mtc-feed-zero" "feed of zero"
"F0 stops the machine, or leaves the feed as it was: the manual does not say. Program the feed that is meant. If the control is known to \
keep the last feed, set `[control] zero_feed = \"previous\"`."

M2005 Error "mtc-centre-ambiguous" "centre of the arc can be read in two ways"
"I, J and K are either coordinates of the centre or its distance from the start of the arc. For this arc both readings give a circle through both \
points, and no other arc of the program decides between them. The two circles are different. Set `[control] centres` to \"absolute\", \"relative\" or \
\"dimension\" (absolute under G90, relative under G91)."

M2006 Error "mtc-centre-contradiction" "arcs read their centres in different ways"
"Another arc of the program shows that I, J and K are coordinates, this one fits only as distances from the start, or the other way round. One of \
them is wrong: check end point, centre and the position in front of the arc."

M2007 Warning "mtc-centre-unusual" "centre does not count as G90 or G91 say"
"Under G90 I, J and K are coordinates of the centre, under G91 distances from the start. The arcs of this program fit the other reading only, and that is compiled. \
Set `[control] centres` to say so and silence this warning."

M2008 Error "mtc-centre-missing" "arc without centre or radius"
"A block under G02 or G03 names an end point, but neither I, J, K nor R. Often a G01 is missing after an arc. Program the centre or the radius, or G01."

M2009 Warning "mtc-centre-zero" "missing centre word of a full circle counts as zero"
"A full circle passes through its start whatever its centre is, so nothing shows whether a missing I, J or K was forgotten. The control \
reads it as 0. Write both words."

M2010 Error "mtc-circle-end" "end point is not on the circle"
"Start and end of the arc have different distances from the centre, read as coordinates or as distance from the start. Check start, end and centre. CAM systems \
that round coarsely may need a larger `[control] circle_tolerance` (default 0.01 mm)."

M2011 Error "mtc-compensation-on-arc" "G41/G42 activated with circular interpolation"
"Path compensation starts and ends on a straight move. On an arc the control stops with this text when it starts, and makes contour errors that cannot be foretold when it ends. \
Program a straight block between. Source: NC Programming Instructions 17VRS, pages 5-30, 5-32."

M2012 Error "mtc-tool-missing" "no tool is selected"
"M6 changes to the tool that a T word selected, and path compensation needs its radius. No T stands before. Program `T5` first."

M2013 Error "mtc-g8-under-g61" "G08 cannot be programmed while G61 is active"
"G08 runs over block transitions without slowing down, G61 stops at each of them. The control refuses G08 while G61 is active. \
Program G62 first. Source: NC Programming Instructions 17VRS, page 4-8."

M2014 Error "mtc-offset-axes" "G50 does not name all axes that have an offset"
"G50 replaces the programmed offset. Whether an axis that it does not name keeps the offset of an earlier G50 or G51 is not documented. Name every axis that \
has an offset, with 0 where it shall end."

M2015 Error "mtc-thread-lead" "lead of the thread is not defined"
"G33 needs one lead, along the axis of the longer travel: I for X, J for Y, K for Z. Whether a lead along the other axis of a taper counts along that axis \
is not documented."

M2016 Error "mtc-corner" "CF or RD without neighbours to cut"
"A chamfer or rounding stands at the end of a block that moves at feed in the working plane, or in a block of its own behind such a block, and the next \
motion follows within 20 blocks and is no rapid traverse. Source: NC Programming Instructions 17VRS, page 12-2."

M2017 Error "mtc-rotary" "rotary axis position has no certain direction"
"An absolute position of a rotary axis is approached the short way and lies within 360 degrees. Here the way is exactly half a turn, or the value is larger. \
Program it incrementally, where the sign gives the direction. Source: NC Programming Instructions 17VRS, page 4-1."

M2018 Error "mtc-incremental-offset" "incremental word right behind a changed offset"
"One description of G50 counts an increment from where the tool stands, another from the last programmed position, to which the new offset is added: the two lie \
one offset apart. Program the axis once under G90 behind the offset, then go on with G91."

M2019 Error "mtc-thread-spindle" "thread is cut while the spindle does not turn"
"G33 moves the tool by its lead with every turn of the spindle. No M3, M4, M13 or M14 stands before it, or M5 or M19 stopped the spindle. Start it in front of the \
thread; an M function of the machine that is passed on counts as a start."

M2101 Error "mtc-offset-in-machine" "G53 with a programmed offset"
"G53 cancels the zero offsets. Whether that includes G50, G51 and G52 is not documented. Set the programmed offset to 0 before: `G50 X0 Y0 Z0`."

M2102 Error "mtc-offset-reset" "zero offset after JMP depends on the machine"
"JMP ends the program and resets the zero offset to what the machine's parameters say: none, or G54. The output cannot know which. Program G54 to G59 at the top of the program that JMP goes to."

M2201 Error "mtc-label-missing" "label is not set in this program"
"The jump names a label that no block of the program sets. A label is a point and a name at the start of a block: `.LOOP`. Check the spelling."

M2202 Error "mtc-label-twice" "label is set twice"
"Two blocks set the same label, so a jump to it has two targets, and which one the control takes is not defined. Rename one."

M2203 Error "mtc-rts-alone" "RTS without BSR or JSR"
"RTS goes back to the call, and there was none: the program ran into a subroutine from above, or jumped into it. End the main part with RET."

M2204 Error "mtc-branch-without-result" "branch before any calculation"
"BEQ, BNE, BPL and BMI look at the result of the last assignment, and no assignment ran before. Assign the variable that the branch is about."

M2205 Error "mtc-result-near-zero" "result is too close to zero to branch on"
"The result is not zero, but so small that it comes from the rounding of decimals. Whether the control's arithmetic gives exactly zero here cannot be known. \
Count with whole numbers, or compare with a margin."

M2206 Error "mtc-end-in-subprogram" "called program ends the job"
"RET, M02, M30 and PROGRAMMENDE end the whole program. In one called with JSR, what follows the call would never run, and whether the control goes back to the \
caller is not documented. End a called program with RTS."

M2207 Error "mtc-no-rts" "subroutine has no RTS"
"The file ends inside a subroutine. Where the control goes on is not defined. Add RTS at its end."

M2208 Error "mtc-bst-target" "BST continues in the middle of the program"
"BST ends the run; the next start continues at its label. The output starts at its top every time, so only a label at the top can be compiled. \
End the program with RET, or move the label."

M2301 Error "mtc-variable-unset" "variable was never set"
"Variables keep their values from one program to the next, so the control may hold any value here, and a position made of it may be anywhere. Give it in partc.toml: `[variables]` with `\"@50\" = 12.0`, \
or assign it in the program."

M2302 Error "mtc-arithmetic" "formula has no result"
"A division by zero, a root of a negative number, or a result that is too large. The control stops with an error here, so nothing is compiled. \
Check the variables."

M2303 Error "mtc-variable-number" "no variable has this number"
"Variables have three digits, `@000` to `@999`, so nothing can be read or stored here. Check the number."

M2304 Error "mtc-function-doubtful" "result depends on the control's rounding"
"INT, MOD and DIV of a negative or broken number can round down or towards zero, and the manual does not say which. Make the value positive and whole, or compute it another way."

M2401 Error "mtc-whole-number" "word needs a whole number"
"G, M, T, D, E and the number of a program are whole numbers, zero or more. Check the word or its variable."

M2601 Warning "mtc-compensation-open" "program ends with path compensation on"
"The end of the program switches G41 and G42 off. The last contour element is then left without its transition. Program G40 with a straight move before."

M2701 Error "mtc-m-function" "M function of the machine builder"
"The machine builder defines this M function, and its meaning on the target is not known. If the target machine understands the same number, list it in \
`[output] pass_m`; if it does not matter, list it in `[control] machine_words`."

M2702 Note "mtc-machine-word" "word of the machine is left out"
"The word is listed in `[control] machine_words`, so it is known not to move the tool, and it has no counterpart in the output. \
To print an M function for it, use a table: `machine_words = { LA_ON = \"M101\" }`."

M2703 Note "mtc-no-geometry" "word has no geometry"
"ACC sets the acceleration, D and E select rows of the correction memory (M8007 where they count in the tool length), REV says where the operator's reverse key leads, G06 to G09 how the axes \
run through block transitions, G43 and G44 how path compensation goes around outside corners. None of them changes \
the programmed path, and the output has no word for them. Tool lengths and corrections are the target machine's business."

M2704 Warning "mtc-m-order" "M function is printed before the move"
"The manual does not say whether this M function of the machine builder acts before or after the move of its block. It is printed before. \
Put it into a block of its own to be certain."

M2705 Error "mtc-spindle-speed" "speed or dwell time has no meaning"
"A spindle speed is zero or more, its limit above zero, and a dwell time 0 to 1000000. Check the S or F word, or its variable."

M8001 Note "mtc-tape-mark" "lone % is left out"
"A `%` alone in the first or the last line of a file is a mark of the paper tapes of old, before or after the program. It has no meaning here. Anywhere else it is an error."

M8002 Note "mtc-tool-length" "tool length compensation has no word in the output"
"G48 switches the compensation of the tool length on, G47 off. Under G48 the programmed path is that of the tool tip, which is what the output holds. Lengths are the \
target machine's business: `[output] tool_length = \"G43\"` prints G43 behind each tool change. Source: NC Programming Instructions 17VRS, pages 5-10, 5-38, 5-41."

M8003 Warning "mtc-spindle-nose" "move of the spindle nose"
"Without tool length compensation positions along the tool axis are those of the spindle nose: the tip is one tool length further down. The output has the same number \
for the tip, so the tool stays that much higher. Program G48 before, or have such moves refused: `[control] spindle_nose = \"refuse\"`."

M8004 Warning "mtc-reading" "meaning that no manual at hand confirms"
"What the program says here is read in a way that fits the names of the words and the programs at hand, but that no manual at hand confirms for this control. Check it \
once at the machine; then list it in `[control] confirmed`, and the warning is gone."

M8005 Warning "mtc-m-functions" "M functions are taken in their standard meaning"
"M0 to M9, M13, M14, M19 and M30 are taken as the standard has them. The machine builder may have given them another meaning. If they are as they should be, add \
`[control] confirmed = [\"m-functions\"]`; of those that differ, M7 to M9 may be listed in `[control] machine_words`, and a program with another one cannot be compiled."

M8006 Warning "mtc-border-axes" "one axis only in the way to a compensated contour"
"The first move under G41 or G42, and the move of G40, name both main axes of the plane, says the manual (page 5-34), and not what happens where one is missing. The axis that \
is missing is taken to stay where it was programmed. Program both."

M8007 Warning "mtc-correction" "correction or edge counts in the tool length"
"D chooses a correction, E an edge of the tool. Both count in the tool length while G48 is active (17VRS, pages 5-10 and 5-41), and a program that has no G47 is taken to \
run with it. The output has no word for them, so the target goes wrong by the correction, or by the difference between the edges. D0 and E1 change nothing."

M9050 Error "mtc-spindle-nose-refused" "move of the spindle nose is refused"
"Without tool length compensation positions along the tool axis are those of the spindle nose, and `[control] spindle_nose = \"refuse\"` refuses them. Program G48 in front \
of the move."

M9001 Error "mtc-g-unsupported" "G function is not supported"
"The function exists on the control, or was defined by the machine builder, but what it does to the path cannot be compiled, or is not documented well enough. \
One that partc knows by name moves the tool or says where it goes: program that another way. A function of the machine builder that is known not to move the tool or change the path \
on this machine may be listed in `[control] machine_words`, for example `[\"G120\"]`. Beside axes, I to K, R, F, P, D or E that no G0, G1, G2 or other function of the block takes it is refused: \
they may be its arguments."

M9002 Error "mtc-word-unknown" "word is not known"
"The word is none of the control's, or its meaning is not documented. If it is known not to move the tool, list it in `[control] machine_words`; it is then left out \
with a note, or printed as an M function. Beside axes and other words that no G function of the block takes it is refused: they may be its arguments."

M9003 Error "mtc-flow-unsupported" "jump or process command cannot be resolved"
"Events, tool errors and other processes exist only at the running machine, so where the program goes on cannot be computed. Write the way that is meant with BRA, or \
leave the command out of the copy that is compiled."

M9004 Error "mtc-compensation-unsupported" "path compensation cannot be computed"
"The path beside a contour under G41 and G42 needs the radius of the tool, on a lathe its cutting-edge position too, and no correction D; after more than two blocks without a \
move in the plane the control takes the contour as finished. Outside corners get arcs, as after G43: how long the chamfers of G44 are no manual at hand says. With \
`[output] compensation = \"control\"` the contour is printed with G41 and G42, and the target compensates."

M9005 Error "mtc-machine-position" "machine position is needed"
"G53 and G74 refer to positions that only the machine knows. For G74 give the home position in machine coordinates: `[control] home = { X = 0.0, Z = 0.0 }`. \
For G53 set `[control] g53 = \"machine\"` if positions under G53 are machine coordinates of the tool carrier."

M9006 Error "mtc-g52" "meaning of G52 is not known"
"Depending on the edition G52 names the present position or shifts the zero point. Set `[control] g52` to \"position\" or \"shift\"."

M9007 Error "mtc-inch-speed" "unit of the cutting speed is not known"
"Under G70 the S of G96 may count in m/min or ft/min: the manual does not say. Set `[control] inch_speed` to \"metres\" or \"feet\"."

M9008 Error "mtc-inch-auxiliary" "unit of an auxiliary axis is not known"
"U, V and W may be linear or rotary axes. While inches are programmed their values mean inches or degrees, and which of them depends on the machine. Program \
them under G71 on a machine with metric base unit."

}
