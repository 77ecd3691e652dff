//! `K`: HEIDENHAIN Klartext.

super::codes! { KLARTEXT:

K0001 Error "klartext-character" "character that no block may contain"
"A character stands outside a comment or a text in quotes where Klartext knows only letters, digits, signs and blanks. \
Often a file was damaged in transfer, or a word processor put in a special character."

K0002 Warning "typographic-minus" "typographic dash is read as a minus sign"
"The block holds a dash as books print it (U+2013, U+2212), which happens when a program is copied out of a PDF. \
It is read as a minus; a control would refuse it. Replace it by `-`."

K0003 Error "klartext-number" "number has too many digits or is out of range"
"Klartext numbers have at most nine digits before and six after the point (a Q parameter holds up to 16). \
A longer number is a damaged line or a missing blank between two words."

K1001 Error "klartext-syntax" "block cannot be read"
"A word stands where this block cannot have it, or a part is missing. Nothing of the block is used. \
Compare the block with the form the help line shows."

K1002 Error "klartext-statement" "unknown statement"
"The block starts with a word that begins no Klartext block, so nothing of it is used. Check the spelling. A remark starts with `;`; \
a block of another language (DIN/ISO, another control) has to be converted."

K1003 Warning "keyword-misspelled" "keyword is misspelled but clear"
"The word is not spelled as the control writes it, for instance `CYCLE DEF` for `CYCL DEF`. \
There is only one reading, and that is compiled; a control would refuse the block."

K1004 Error "word-twice" "same word twice in one block"
"An address may stand once in a block, absolute or incremental: `X+10 IX+5` counts as twice. Which of the two the programmer meant \
cannot be guessed, and the control refuses the block. Remove one."

K1005 Error "word-not-allowed" "word has no place in this block"
"The word exists in Klartext, but not in a block of this kind, so the control would refuse the block or ignore the word. \
partc never drops a word: remove it, or put it where it belongs."

K1006 Error "word-missing" "block lacks a word"
"A word without which the block has no meaning is missing, for example the radius of `CR` or the value behind an axis letter. The \
control would ask for it in its dialogue. Add the word."

K1007 Error "unit-missing" "BEGIN PGM states neither MM nor INCH"
"The unit decides every length of the program: the difference is a factor of 25.4, and it cannot be guessed. The control writes it \
behind the name: `BEGIN PGM PART MM`. Add it."

K1008 Warning "no-program-head" "file has no BEGIN PGM block"
"The file is a fragment. A control takes the unit from `BEGIN PGM … MM` or `INCH`; partc uses the one in `[control] unit` of \
partc.toml, or millimetres when that is not set. Setting it silences this warning."

K1009 Error "program-unit-mismatch" "BEGIN PGM and END PGM state different units"
"The head says one unit, the end another. The control refuses to load such a file, and which one is right cannot be guessed: the \
difference is a factor of 25.4. Correct the wrong one."

K1010 Warning "program-name-mismatch" "BEGIN PGM and END PGM name different programs"
"A control checks that both names are the same when it loads the file. The names have no influence on the path. Most often the file \
was copied and only one end was renamed."

K1011 Error "no-program-end" "file ends without END PGM"
"The program has a head but no `END PGM` block: most likely the file was cut off in transfer, and the end of the path is missing. \
If the program is complete, add the block."

K1012 Warning "text-after-end" "blocks after END PGM are not part of the program"
"The control ignores what follows END PGM, and so does partc. If the blocks belong to the program, move the END PGM block behind \
them; otherwise delete them."

K1013 Error "second-program-head" "BEGIN PGM inside a program"
"A file holds one program. A second head means that two files were joined: on the machine the second one would never load this way. \
Put each program into a file of its own."

K1014 Error "m-functions-conflict" "M functions of one block contradict each other"
"For example M3 with M4, or M8 with M9 in one block. Which one acts last is not defined, so the spindle might turn the wrong way. \
Keep one, or put them into two blocks."

K1015 Warning "speed-in-path-block" "spindle speed outside TOOL CALL"
"The control takes S in TOOL CALL only: `TOOL CALL S2500` sets a new speed without a change of tool. Some CAM posts write S into \
positioning blocks; partc sets the speed in front of the move of such a block, as DIN/ISO does."

K1016 Error "block-in-comment" "comment hides a block behind a lone carriage return"
"A comment holds a carriage return, and what follows reads as a block. Lines of this file end with a line feed, so for the control the rest still \
is comment, while many editors show a line of its own. Whether the block shall run cannot be known: end the comment with a line feed, or remove the block."

K2001 Error "position-unknown" "position of an axis is not known here"
"The block needs the position from which it starts: for an incremental word, an arc, a chamfer or a polar word. No block before gave this axis \
an absolute position in the workpiece system, or the last one was in machine coordinates (M91), from which the workpiece position \
cannot be computed. Program an absolute position of the axis first."

K2002 Error "feed-missing" "cutting move without a feed rate"
"No F word stands before this move, neither in a path block nor in a TOOL CALL. The control stops with \"feed rate is missing\". \
Program F, or set `[control] feed` for fragments that get their feed elsewhere."

K2003 Error "feed-auto-missing" "F AUTO without a usable feed in the TOOL CALL"
"`F AUTO` means the feed of the last TOOL CALL, and that block has none, or M136 or M137 changed what F counts since. Put F into the \
TOOL CALL, or set `[control] feed` in partc.toml \
for fragments."

K2004 Error "tool-axis-missing" "first TOOL CALL has no tool axis"
"The tool axis (Z, Y or X) decides the working plane: which axes a pole, an arc and an angle refer to. Write it behind the tool number: `TOOL CALL 5 Z S2500`."

K2005 Error "tool-name-unknown" "tool name has no number"
"The program calls a tool by its name, and the output needs a number. Say which one belongs to the name in partc.toml: \
`[tools.\"MILL_D10\"]` with `number = 7`, or name a tool table that holds it."

K2006 Error "tool-index" "indexed tool needs a number of its own"
"`TOOL CALL 5.2` is the second set of data of tool 5. The output has only whole numbers: give the index one in partc.toml, \
`[tools.\"5.2\"]` with `number = 52`."

K2007 Warning "tool-not-in-table" "tool is not in the tool table"
"The configured tool table has no such tool, so nothing is known about its radius and length. A control with this table would stop. \
Check the number, or add the tool to the table. The change is printed as programmed."

K2008 Error "tool-radius-unknown" "radius of the tool is not known"
"The block needs the tool radius. Put a `TOOL DEF` with R into the program, name the tool table under `[tools] table`, or add \
`[tools.5]` with `radius = 4.0` to partc.toml."

K2009 Warning "oversize-dropped" "TOOL CALL without DL/DR ends the oversizes in force"
"The earlier TOOL CALL of this tool had oversizes. A new TOOL CALL sets them anew, and the ones it does not name are taken as zero \
(the manuals are not explicit here). Repeat DL and DR if they are to stay."

K2010 Error "tool-number" "tool number is not one a control knows"
"Tool numbers are whole, from 0 to 32767, with an optional index behind a point (`5.2`). Check the number, or the parameter it comes \
from."

K2011 Note "length-oversize" "length oversize DL is part of the printed coordinates"
"The control adds DL to the length of the tool, which lifts or lowers every cut by that amount. The output has no such word, \
so partc adds it to the coordinates of the tool axis. Blocks in machine coordinates (M91) are not changed."

K2012 Error "tool-length-unknown" "length of the tool is not known"
"The block reads the tool length (Q114 or SYSREAD), and neither the program nor the configuration gives it. Put `TOOL DEF` with L \
into the program, or the length into the tool table or `[tools.5]` of partc.toml."

K2013 Warning "feed-per-revolution-large" "feed under M136 is far too large for a feed per revolution"
"M136 acts at the start of its block and makes every F that follows count millimetres per revolution of the spindle, the F of its own block \
included. A number like 200 was most likely meant per minute. Write the feed per revolution, or M137 first."

K2014 Note "corner-radius-oversize" "oversize of the corner radius changes no path"
"DR2 in a TOOL CALL enlarges the corner radius of the tool for 3-D compensation with surface normals, which partc does not compile. Paths in three axes, and the radius compensation \
RL and RR, do not count the corner radius: the output is the same with and without DR2."

K2101 Error "pole-missing" "no circle centre or pole in force"
"C, CP, LP and CTP refer to the last CC block, and there is none before this block that is still valid. Program `CC X… Y…` first."

K2102 Warning "pole-incomplete" "CC block with one coordinate"
"Manuals do not say what the missing coordinate of a CC block is. partc takes the last programmed position; \
`[control] cc_missing = \"previous\"` takes the one of the CC before. Write both to be sure."

K2103 Warning "turn-missing" "arc without DR turns as the last one did"
"DR is missing, so the last DR programmed holds, as on the control. It may stand far above, or in a subprogram; CT and CTP do not \
change it. Write \
DR+ (counter-clockwise) or DR- to be sure."

K2104 Error "turn-unknown" "arc without DR, and no arc before it"
"The direction of rotation is missing and no earlier arc gives one. The control stops here. Write DR+ (counter-clockwise) or DR- \
(clockwise)."

K2105 Error "polar-arc-sign" "signs of IPA and DR contradict each other"
"In a CP block the sign of the incremental angle must agree with DR. Older and newer controls differ in what they do otherwise, \
so the block is refused. With `[control] cp_sign = \"dr\"` DR wins and the angle is reduced to one turn."

K2106 Warning "polar-angle-range" "absolute angle beyond 360 degrees"
"PA of a CP block names a direction, so partc reduces it to one turn; the manuals do not say whether an older control would add \
turns. A helix of several turns is programmed with IPA."

K2107 Warning "polar-inherited" "missing polar word is taken from the position"
"PR or PA is missing and the block before was not a polar block about the same pole, or its PR was not above zero. partc computes the missing one from the position; \
a control might keep the last programmed one. `[control] polar_missing = \"programmed\"` selects that. Write both words to be sure."

K2108 Warning "pole-moved" "pole was set before the coordinate system changed"
"Between CC and its use a datum shift, rotation, mirror or scaling changed. partc keeps the numbers of the pole in the new system; \
the manuals do not say. Program CC again to be sure."

K2109 Error "arc-without-end" "arc names no end"
"The block has neither an end point nor an angle, so the arc is undetermined. Write the end point in the working plane (C, CR, CT), \
PR or PA (LP, CTP), or PA or IPA (CP). A full circle is `C` with the start point as its end."

K2110 Error "polar-angle-undefined" "angle is undefined on the pole"
"The tool stands on the pole, where every angle fits, and the block does not say PA, or says it as an increment. Write the angle as \
PA."

K2201 Error "label-twice" "label is set twice"
"A label may be set once in a program; only LBL 0 may stand any number of times. Which of the two a call means cannot be guessed, and \
the control refuses it. Give one of them another number or name."

K2202 Error "label-missing" "label does not exist"
"A call or jump names a label that the program does not set. Labels belong to their file: one of a called program cannot be reached \
from here. Check the number, or the spelling of the name."

K2203 Error "label-zero-missing" "subprogram has no LBL 0"
"A subprogram called by CALL LBL runs to the next LBL 0; here the program ends first, so the control would not find its way back to \
the call. Put LBL 0 behind the last block of the subprogram."

K2204 Error "recursive-call" "subprogram or program calls itself"
"HEIDENHAIN controls do not allow a subprogram or a program to be called while it runs, and the call would never end. Repeat with \
`CALL LBL n REP` or a conditional jump instead."

K2205 Error "repeat-count" "number of repeats is not usable"
"REP takes a whole number from 0 to 65534. What the control makes of a broken one is not documented: round the parameter with INT first, \
or say in partc.toml how your control does it: `[control] repeat_count = \"truncate\"` or `\"round\"`."

K2206 Error "repeat-forward" "repeated section lies behind its call"
"`CALL LBL n REP` repeats the section from LBL n up to the call. Here the label follows the call. For a subprogram leave out REP."

K2207 Warning "jump-out-of-subprogram" "jump leaves a subprogram"
"A conditional jump leaves the subprogram without its LBL 0. partc keeps the return pending, and the next LBL 0 goes back to the call; \
the manuals do not say what the control does."

K2208 Error "called-program-ends" "called program holds M2 or M30"
"M2 or M30 in a called program ends the whole job on some controls and is an error on others. End a called program with END PGM."

K2209 Warning "called-unit-differs" "called program has another unit"
"The called program is in INCH and the caller in MM, or the other way round. partc uses the unit of each file while it runs; \
the manuals do not say. Q parameters are not converted."

K2210 Warning "label-runs-through" "main program runs into a subprogram"
"The main program is not ended by M2 or M30 in front of this label, so its blocks run once without being called. \
That is allowed, but rarely meant."

K2212 Warning "plc-value" "values for the PLC of the machine are left out"
"FN 19 and FN 29 hand numbers to the machine's own control. The path does not depend on them, and plain G-code has no word for it. What the \
machine builder makes of them (clamping, coolant pressure) will not happen on the target: see to it there, or use an M function."

K2301 Error "parameter-undefined" "Q parameter has no value"
"The parameter is read before any block sets it. On the machine it might still hold a value from another program. \
Set it, or give a start value in partc.toml: `[variables]` with `Q50 = 3.0`."

K2302 Warning "parameter-zero" "undefined Q parameter is read as 0"
"TNC controls up to the TNC 426/430 start with zero in every parameter that was never set. If another program sets it on the machine, \
give the value in `[variables]` of partc.toml."

K2303 Error "parameter-arithmetic" "computation has no result"
"Division by zero, root of a negative number, arc sine beyond 1, logarithm of zero or a result over 1e10: the control stops here. \
Look where the parameters of the block get their values, and test them before."

K2304 Error "parameter-from-machine" "value is known only at the machine"
"The parameter holds something that the control measures or knows at run time. partc does not make up a value: \
give it in `[variables]` of partc.toml if it is always the same."

K2305 Warning "parameter-of-control" "parameter belongs to the control"
"Q100 to Q199 are set by the control, for example Q108 with the tool radius. What a program writes there may be overwritten at any \
time. Use Q0 to Q99."

K2306 Warning "formula-precedence" "formula that controls may read differently"
"`-a^b` and `a^b^c` are computed as the TNC7 manual defines: the sign first, chained powers from right to left. \
For older controls no rule is printed. Write brackets."

K2307 Error "parameter-kind" "text and number are mixed up"
"A string parameter (QS) stands where a number is needed, or a number where a text is needed. TONUMB turns a text into a number, \
TOCHAR a number into a text."

K2308 Error "parameter-number" "no such parameter"
"Q0 to Q1999, QL0 to QL499, QR0 to QR499 and QS0 to QS1999 exist. The control refuses any other number. Most often a digit is too \
many, or the blank behind the number is missing."

K2309 Error "program-error-stop" "program stops with its own error"
"The block FN 14 makes the control stop with an error text. The program itself says that something is wrong with its parameters; \
look at the condition in front of it."

K2310 Error "modulo-sign" "remainder of a negative number is not documented"
"The manuals show `400 % 360 = 40` and say nothing of negative operands: -400 % 360 may be -40 or 320. Make the operands positive, or say \
in partc.toml how your control computes: `[control] modulo = \"truncate\"` keeps the sign of the left operand (-40), `\"floor\"` that of the right one (320)."

K2401 Error "cycle-not-defined" "cycle call without a cycle"
"CYCL CALL, M99, M89 and the pattern cycles 220 and 221 run the machining cycle defined last, and there is none. Put CYCL DEF in \
front, or remove the call: the control stops here."

K2402 Error "cycle-incomplete" "cycle definition lacks a part"
"A dotted cycle needs all its sub-blocks, in order and directly one after the other; a cycle with Q parameters needs their values."

K2403 Error "cycle-value" "value in a cycle is not usable"
"The value is outside the range the control accepts: a scaling factor is 0.000001 to 99.999999, a dwell 0 to 3600 seconds. Check the \
value, or the parameter it comes from."

K2404 Warning "cycle-depth-zero" "cycle has depth 0 and does nothing"
"A drilling cycle with Q201 = 0 moves nothing, on the control as here. Most often the depth comes from a parameter that was never set as meant."

K2405 Error "cycle-spindle" "cycle is called while the spindle does not turn"
"The control refuses to run a cycle with the spindle at rest (\"spindle not turning\"); only rigid tapping starts it itself, and needs a speed. \
TOOL CALL stops the spindle: program M3 or M13 behind it, in front of the call."

K2406 Warning "cycle-clearance" "2nd set-up clearance lies below the set-up clearance"
"Q204 is smaller than Q200. partc leaves the tool at the set-up clearance behind the hole and never moves it down there; whether that is high enough \
on the way to the next position is up to the program."

K2407 Error "cycle-compensated" "cycle is called while radius compensation is on"
"A drilling cycle moves the tool axis over the programmed position, but with RL or RR the tool stands beside it. Program a straight block with R0 first."

K2408 Note "stop-distance" "advanced stop distance changes in even steps"
"Cycle 205 lets rapid traverse end in front of the last depth: by Q258 after the first step, by Q259 before the last one. The manuals do not give \
the values between; partc takes even steps. The drilled hole is the same."

K2409 Note "tapping-chuck" "tapping reverses the spindle by M3 and M4"
"Cycles 2 and 206 tap at the programmed feed, and the spindle is reversed between the way in and the way out, which takes a chuck with length compensation, as on the control. \
Cycles 17, 207 and 209 are printed as taps without one."

K2410 Note "pattern-order" "order of a grid of places"
"Manuals do not say in which order the control visits the places of PAT and FRAME. partc goes line by line, to and fro; the holes are the same."

K2411 Error "pattern-data" "pattern cannot be read"
"PATTERN DEF takes POS, ROW, PAT, FRAME, CIRC and PITCHCIRC, each with a number and its data in brackets, absolute: \
`ROW1 (X+12 Y+20 D+9 NUM4 ROT+15 Z+0)`. Where the places have a surface Z of their own, Q203 of the cycle has to be 0."

K2412 Note "cycle-never-called" "cycle that is not supported is defined and never called"
"The definition of a cycle that partc does not compile is no fault as long as nothing calls it: it moves nothing. The same holds for definitions that only give data to such cycles (271, 285, \
1271). Is a call missing? Otherwise remove the definition."

K2413 Note "cycle-left-out" "cycle or program of the machine builder that `[programs]` leaves out"
"A cycle: no manual of the control has the cycle: it belongs to the machine builder. `[programs] \"CYCL DEF 392\" = { ignore = true }` says that it moves nothing and changes nothing that the \
program relies on, so its definition is left out, and the machining cycle that was defined before stays defined. Where it moves axes, name them: `{ ignore = true, lost = [\"Z\"] }`. \
A program that a block calls and that is found nowhere is left out in the same way by its name: `HEADCLEAN = { ignore = true }`, with `change = true` it changes to the tool of the TOOL CALL \
before it. Q parameters that it would set keep what they were."

K2414 Warning "feed-of-before-call" "cut takes the feed of before a program that is left out"
"Between the last F and this cut stands the call of a program that `[programs]` leaves out. If that program leaves another feed on the control, the output cuts at the wrong one. \
Program F after the call, or say what it leaves: `HEADCLEAN = { ignore = true, feed = 500 }`; `feed = \"lost\"` makes every cut without an F of its own an error. It is said once for each \
program that is called."

K2415 Warning "variable-unused" "value of `[variables]` is not used"
"The program reads Q108 to Q114, which follow from the program itself or from the data of the tool, and `[variables]` gives another value. What partc computes goes first: \
`[tools]` says the radius that Q108 holds, and that compensates. Take the entry out of `[variables]`, or correct the data of the tool."

K2501 Warning "shift-while-turned" "datum shift while mirrored, rotated or scaled"
"Manuals do not say whether a datum shift programmed under an active mirror, rotation or scaling is measured along the original axes. \
partc measures it along the original axes; `[control] shift_axes = \"transformed\"` along the transformed ones. \
Reset the other transformations first to be sure."

K2502 Warning "transformation-open" "program ends with a transformation in force"
"A datum shift, mirror, rotation or scaling is still active at the end of the program. Some controls keep it for the next program."

K2503 Warning "mirror-tool-axis" "tool axis is mirrored"
"Mirroring the tool axis turns depths into heights: a hole programmed to Z-10 goes to Z+10. Controls allow it with restrictions. \
Check that this is meant; most often another axis is."

K2504 Note "preset-to-offset" "preset number is printed as a work offset"
"Cycle 247 activates a row of the preset table. The output selects the work offset of the same order: 1 is G54, 9 is G59.3. \
Set the offsets of the target machine accordingly, or name others under `[datums]`: `preset.12 = \"G55\"`."

K2505 Error "preset-unmapped" "preset number has no work offset"
"Presets 1 to 9 become G54 to G59.3. For any other number name the work offset in partc.toml: `[datums]` with `preset.12 = \"G55\"`."

K2506 Error "coordinate-under-transformation" "axis cannot be moved under this transformation"
"A parallel axis U, V or W moves while a scaling, mirror or rotation acts on its direction. Controls differ in whether they transform such \
an axis, so the block is refused. Reset the transformation first."

K2507 Warning "scaling-of-depth" "scaling also changes the tool axis"
"A machine parameter (MP 7410) decides whether scaling acts in the working plane only or on all three axes. partc scales all three, which is \
the parameter's basic setting. `[control] scaling = \"plane\"` leaves the tool axis alone."

K2508 Warning "blank-form" "blank form is not usable"
"The MIN point of BLK FORM 0.1 must lie below the MAX point of BLK FORM 0.2 in every axis. The control refuses the blank, and one \
that lacks an axis; the path does not depend on it. Most often the two points are mixed up."

K2509 Error "rotary-feed" "feed of a rotary axis under M116 is not supported"
"M116 makes F a speed at the workpiece surface, which depends on the radius at which the tool stands from the rotary axis. \
Plain G-code counts degrees per minute."

K2510 Warning "rotary-half-turn" "rotary axis goes half a turn under M126"
"M126 takes the shorter way, and over exactly 180 degrees both ways are as short. The manuals do not say which one the control takes; \
partc turns in the positive sense. Program M127 and the angle with its turns where the sense of rotation matters."

K2511 Warning "rotation-plane" "tool axis changes under a rotation"
"A rotation turns the coordinates in the working plane in which it was programmed. The manuals do not say what becomes of it when a \
TOOL CALL changes the working plane: partc leaves it where it is. Reset it before the change, and program it again after."

K2512 Note "rotary-axes-at-zero" "rotary axes are taken to stand at zero"
"PLANE with TURN or MOVE and without a tilt turns the rotary axes to zero. The program moved none of them away from zero, so nothing turns. On a \
machine whose rotary axes stand elsewhere at the start, bring them to zero first."

K2513 Note "datum-from-table" "datum is shifted by a row of a table"
"The shift comes from a datum table: compare the values with the table of the machine that will run the program. The row replaces the shift of all axes that it names."

K2601 Error "compensation-in-arc" "radius compensation starts or ends in an arc"
"RL, RR and R0 take effect over a straight block, at whose end the tool stands beside the contour. The control refuses to switch in \
C, CR, CT, CP and CTP. Put a straight block in front of or behind the arc."

K2602 Error "compensation-side" "change between RL and RR without R0"
"Between left and right compensation at least one straight block with R0 has to lie in the working plane, or the tool would cross the \
contour. The control refuses the block."

K2603 Warning "compensation-open" "radius compensation is still on"
"The program ends, calls a tool, a cycle or a program while RL or RR is active. The control cancels the compensation there; \
the tool may cut the contour on the way. Program a block with R0 first."

K2604 Error "paraxial-compensation" "R+ or R- where it cannot act"
"R+ and R- lengthen or shorten a block that moves one axis by the tool radius, such as `X+50 R+ F200`. They cannot be used with \
several axes, without a way, in machine coordinates or while RL or RR is active; and no arc or polar block can start where they left the \
tool. Split the block, or program RL or RR."

K2605 Error "approach-radius" "radius of an approach or departure does not fit"
"The point outside lies inside the circle of APPR LCT or DEP LCT, so that no line touches it, or the arc of a negative R is not larger than the tool. \
R counts on the path of the tool centre. Start further away, or change R."

K2606 Error "compensation-under-way" "block may not stand in a compensated contour"
"TOOL CALL, the end of the program, M128, and whatever changes the coordinate system come while RL or RR is active. The control stops there, or ends the \
compensation in a way that is not confirmed, and where the tool stands beside the contour would be a guess. End the compensation first."

K2607 Error "corner-function-without-element" "M97, M98 or M197 in a block without a contour element"
"These functions change what the control makes of the corner at the end of their block. A block that moves nothing in the working plane has no such corner. \
Write the function into the block that ends in the corner."

K2701 Error "m-function-unknown" "M function is unknown"
"The machine builder defines this M function, so what it does is not known, and it may move something. \
If the target machine understands the same number, list it: `[output] pass_m = [25]`; if it changes the tool as M6 does: `[control] tool_change_m = [25]`. Else take it out of the program."

K2702 Note "tool-change-joined" "M6 changes no tool by itself"
"Either the tool change was printed at the TOOL CALL already, because `[control] tool_change = \"t\"` says so or nobody knew of this M6, or no TOOL CALL \
stands in front of the M6, as in programs that stop with M6 for a change by hand and call the tool then: there the next TOOL CALL is the change. \
The M6 stops the spindle, which is printed."

K2703 Note "m-function-without-words" "M function has no counterpart in plain G-code"
"The function changes how the control smooths, filters or supervises the path, not the path the program describes. It is left out."

K2704 Note "retract-to-limit" "M140 MB MAX is printed as a move to a machine coordinate"
"The control retracts to the end of the travel in the tool axis. The output moves to the machine coordinate in `[control] retract_max`."

K2705 Error "retract-limit-unknown" "M140 MB MAX needs the end of the travel"
"How far the tool axis can go is known to the machine only. Give the machine coordinate in partc.toml: `[control] retract_max = -1.0`."

K2706 Warning "m-function-beside-move" "passed M function stands before the move"
"Whether this M function acts at the start or the end of its block is up to the machine builder. It is printed before the move; \
put it into a block of its own to be sure."

K2707 Error "m-function-form" "M function lacks or has wrong words"
"The function needs a value behind it, or has one that it does not take: `M140 MB 50`, `M103 F20`, `M120 LA 5`. Without it nobody \
knows what the function would do."

K2708 Note "stop-ends-spindle" "M0 stops spindle and coolant as the control does"
"On the control M0 also stops the spindle and the coolant; a plain M0 does not on every target. M5 and M9 are printed before it."

K2709 Warning "plunge-feed-open" "what M103 does to this feed is open"
"M103 limits the feed by the share of the way that leads down, and where this move starts was not programmed. partc takes the lowest \
feed that M103 can mean, as if the whole way led down. Program M103 behind the first positioning. A drilling cycle called under \
M103 keeps the feeds of its own parameters."

K2710 Warning "basic-rotation-not-ended" "M143 does not end a basic rotation of the target"
"M143 ends the basic rotation. One of TCH PROBE 404 is computed, and ends with M143; one that was set up at the machine, in the row of the preset table, is part of the work offset \
of the target, and the output has no word that ends it. If the offset of the target has a rotation, blocks after M143 would be turned, which they are not on the control; \
blocks before it would be turned on both. Set up the target without a rotation where M143 stands before the first move; otherwise split the program there."

K8001 Warning "block-not-run" "block that does not run could not be compiled"
"`partc check` looks at every block, also at those that this run of the program leaves out: behind M30, in subprograms that nothing calls, behind a \
jump. The output does not depend on this one, so it is no error; if it ever runs, it will be refused. `partc explain` with the code that \
the text names says why."

K9001 Error "cycle-unsupported" "machining cycle is not supported yet"
"The cycle is read, but partc cannot compute its path yet, and a path without it would leave out material removal. Nothing is written."

K9002 Error "fk-unsupported" "free contour (FK) that partc cannot construct"
"The data of a free contour may be enough, but partc finds no element that it can construct from what is known, or too many elements or solutions wait for each other (64). Write an \
end point more. Most controls can also convert an FK program to conventional blocks (CONVERT PROGRAM)."

K9003 Error "approach-unsupported" "this form of APPR or DEP is not supported"
"All eight forms are compiled onto a contour with RL or RR, and from it. Its first element has to have a direction of its own: a line, or an arc by centre or \
radius; so has the last one. Not supported are scaling, an approach while RL or RR is active, R0 on newer controls, and LN where the target compensates. \
Program the approach as L and C blocks."

K9004 Error "tilting-unsupported" "tilted working plane cannot be compiled for three axes"
"PLANE functions and cycle 19 turn the coordinate system in space, unless all they do is a turn about the tool axis Z. The output has no word \
for that on three axes. Have the CAM system put out the tilted work for the target machine."

K9005 Error "touch-probe" "touch probe cycles run only at the machine"
"The block measures the workpiece or the tool; its result is known at the machine only. Remove it, or compile the part of the program after the setup."

K9006 Error "file-function" "table and file functions run only at the control"
"The block opens, reads or writes a file of the control. What it reads is not known here, and what it writes would be missing there. \
Put the values into the program instead."

K9007 Error "compensation-unresolved" "radius compensation cannot be computed here"
"With `compensation = \"resolve\"` the output is the path of the tool centre. What the control does here is not confirmed: a tool radius below zero, compensation \
under M128, or a rounding as way to the contour or from it, for which `[control] rounded_approach = \"round\"` chooses a reading. Program it in another way, or set \
`[output] compensation = \"control\"` to print the programmed contour with G41/G42 and let the target compensate."

K9008 Error "m-function-unsupported" "M function changes the path in a way that is not supported"
"The function moves the tool, changes what coordinates mean, or needs the geometry of the machine. It is refused rather than left out."

K9009 Error "iso-block" "DIN/ISO block in a Klartext program"
"A G word stands in a Klartext program. Where such blocks occur the meaning of I and J differs between writers (centre or offset), \
so the block is refused. Convert it to L, C or CR."

K9010 Error "pattern-unsupported" "no pattern is in force"
"CYCL CALL PAT runs over the places of PATTERN DEF, or of the point table that SEL PATTERN names, and neither stands before it in the program. The control may have a \
table selected by hand. Put the points into the program: `PATTERN DEF POS1 (X+12 Y+20 Z+0)`, or select the table: `SEL PATTERN \"HOLES.PNT\"`."

K9011 Error "function-unsupported" "function is not supported"
"The block is a function of newer controls that partc reads by name but does not execute. It may influence the path, so it is refused."

K9012 Error "datum-table" "datum table is not available"
"A datum shift takes a row of a datum table, and no table is selected in the program; the control may have one selected by hand. Select it (`SEL TABLE \"NAME.D\"`), \
name it in partc.toml (`[control] datum_table = \"NAME.D\"`), or program the values: `CYCL DEF 7.1 X+…`."

K9013 Error "feed-form" "feed per tooth without the teeth, or feed by time"
"FZ is a feed per tooth: it needs the number of teeth, `[tools.N] teeth` or CUT of the tool table. FT and FMAXT give the time of the block, which is not \
compiled. Program the feed in mm/min (F) or mm per revolution (FU)."

K9014 Error "machine-function" "block talks to the machine"
"The block waits for, reads or sets a signal of the machine control. Leaving it out could start a motion too early, so it is refused."

K9015 Error "spline-or-normal-vector" "3-D blocks with normal vectors or splines are not supported"
"LN blocks carry surface normals for 3-D tool compensation, SPL blocks carry polynomials. Neither has a counterpart in plain G-code."

K1850 Error "block-in-wrapped-comment" "line of a wrapped comment reads as a block"
"A comment that ends with `~` goes on in the next line, which is text for the control. Here that line reads as a block of its own, so \
the `~` may be meant as decoration, and then the block would be lost. Remove the `~`, or write the text on one line."

K2850 Warning "open-subprogram" "END PGM inside a called label ends the program"
"A label is called whose section runs to END PGM without LBL 0. The manuals do not say whether the control takes this for the end of the \
program; `[control] open_subprogram = \"end\"` says that it does. Nothing behind the call runs then."

K2851 Warning "probing-left-out" "touch probe cycle is left out"
"`[control] probing = \"leave-out\"` leaves touch probe cycles out. What they would have measured is unknown from there on: the results in \
Q115 to Q199 and in the parameters they name, the positions of all axes, and the data of tools that were measured. A block that needs \
one of these is refused, and so is a cut that does not name all axes. The target stays where it stood before the cycle, so a rapid move runs at that height until \
the program names the tool axis. The datum and the rotation that the cycle sets have to be set up on the target machine."

K2852 Error "shift-under-turned-plane" "datum shift and turned working plane are mixed"
"A datum shift in front of PLANE or cycle 19 is measured along the axes of the part, one behind it along the turned ones. What becomes of the \
one where the other is programmed anew, or where the plane turns back first, no manual page says. Reset the shift before the plane turns, and \
the plane after the shift that belongs to it. A mirror of X or Y and an uneven scaling by cycle 26 have to be programmed after the turn, too, and reset before the next one."

K2853 Note "plane-turned" "turn about the tool axis is printed in the coordinates"
"PLANE, cycle 19 or the basic rotation of TCH PROBE 404 turns the system about the tool axis only, so nothing is tilted. The control may turn the rotary table instead of the \
coordinates; on the part it is the same. The output has turned coordinates, and the table of the target stays where it is."

K2854 Warning "probing-sets-datum" "datum that a touch probe cycle sets is not set in the output"
"On the control the coordinates behind this cycle count from a datum, or along axes, that it has just set; the output leaves the cycle out and prints the blocks in front of it and \
behind it into one work offset. Where the offset of the target is set, before the program runs, as the cycle sets it, and nothing but the probe moved in front, that is right: say so by \
`[control] probing_datum = \"set\"`. `\"refuse\"` compiles no such program. Nothing is said where the parameters of the cycle show that the feature reads what it read before, nor where the datum \
goes into a row of the preset table that a later cycle 247 selects."

K2855 Error "system-data-unit" "unit of a length that the control gives is open"
"FN 18: SYSREAD reads a length in a program in INCH. A TNC7 gives millimetres, whatever the unit of the program; of older controls no manual page says whether they give millimetres or inches. \
`[control] system_unit = \"mm\"` or `\"program\"` says it; `klartext = \"tnc7\"` needs neither."

K2856 Error "work-before-datum" "moves in front of a datum count from another one"
"`[control] probing_datum = \"set\"` says that the work offset of the target is the datum that a touch probe cycle sets. Other tools than the probe moved in front of this cycle, in coordinates \
of the datum before: one work offset cannot be both. Split the program there, or select a preset of its own by cycle 247."

K8020 Warning "cycle-19-reading" "cycle 19 is read as space angles"
"The machine's configuration decides whether the angles of cycle 19 are space angles or positions of the rotary axes. As a space angle C turns the \
coordinates about Z; as the position of a table it says nothing about them. Set `[control] cycle_19 = \"axes\"` where it is the latter."

K8021 Warning "system-data-reading" "system data is read as older programs use it"
"FN 18: SYSREAD asks for data whose number is taken from programs for the iTNC 530, not from a manual page: tool axis and spindle speed (ID 20 NR 3 \
and 4), length and radius of the active tool (ID 200). Check the value against the manual of the control."

K9016 Error "system-data" "system data is known only at the machine"
"FN 18: SYSREAD asks for something the program text does not determine. Supported are the active tool (ID 20), tool data (ID 50, ID 200), \
transformations (ID 210, ID 220) and the programmed position (ID 270)."

K9017 Error "string-function" "string function is not supported"
"SYSSTR and CFGREAD read a text from the control, which is not known here; other names are no string function that partc knows. \
Assign the text itself: `QS1 = \"TEXT\"`."

K9019 Error "rapid-arc" "arc at rapid traverse"
"Plain G-code moves at rapid traverse in straight lines only. Program a feed for the arc, or say in partc.toml at which feed such arcs run: \
`[control] rapid_feed = 10000.0`."

K9018 Error "contour-cycle" "contours that contour cycles (SL) cannot take yet"
"Cycles 21 to 24 mill the contours that cycle 14 names by their labels. The contours of SEL CONTOUR, CONTOUR DEF and DECLARE CONTOUR are not supported, \
and without them material would stay or be lost. Name labels in cycle 14, or program the roughing as blocks."

K2951 Error "contour-label" "a subprogram describes no contour for its cycle"
"Cycle 14 names subprograms whose blocks describe a contour. The first block names both axes of the working plane, and RL or RR: with the tool inside it is a \
pocket. Behind it stand path functions, FK, RND, CHF, parameters from Q21 on, jumps and labels; no tool axis, no transformation, no M function, no other side, \
no cycle. A pocket is closed, and no contour crosses itself."

K2952 Error "contour-missing" "the cycle lacks its contour or its data"
"Cycles 21 to 25 mill the contours that cycle 14 names, and cycles 21 to 24 take depth, allowances, heights and overlap of cycle 20. Program both in front of the call."

K2953 Warning "feed-in-contour" "F of a contour does not count"
"Cycles along contours have feeds of their own, Q11 and Q12. An F in the subprogram of a contour is left out."

K2954 Warning "further-contours" "cycle 25 mills the first contour only"
"Cycle 25 takes the first label of cycle 14; the contours of the other labels are not milled by it."

K2955 Error "contours-together" "the contours of cycle 14 make no certain area together"
"Cycles 21 to 24 clear all pockets that cycle 14 names, less its islands. Contours lie apart, or an island in a pocket, or they cross: then each pocket begins outside \
the pockets named after it and outside the islands, and each island inside a pocket. Contours that touch, run along each other or lie in one of their \
own kind are refused, and so is what two pockets have in common."

}
