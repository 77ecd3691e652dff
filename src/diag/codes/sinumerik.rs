//! `S`: SINUMERIK programs. A text that names an alarm means the number the control itself shows.

super::codes! { SINUMERIK:

S0001 Error "siemens-character" "character has no place in a block"
"The character belongs to no word of the SINUMERIK language. Comments start with a semicolon. The control shows alarm 12080."

S0002 Warning "siemens-dash" "printed dash instead of a minus sign"
"A dash of printed text stands where a minus sign is meant, as happens when a program is copied from a document. It is read as `-`. \
Replace it: the control does not accept it."

S0003 Error "siemens-bracket-comment" "comment in brackets"
"Brackets hold comments in DIN 66025 and ISO programs. On a SINUMERIK control they group formulas and hold arguments; \
a comment starts with a semicolon. The control shows alarm 12080."

S1001 Error "siemens-syntax" "block cannot be read"
"The words of the block do not fit together: a value or `=` is missing, or a word stands where none can stand. \
The control shows alarm 12080 and stops at the block."

S1002 Error "siemens-two-operators" "two operators in a row"
"Two arithmetic operators cannot follow each other: `R1=R2--R3` is refused with alarm 12180. Put the signed value in brackets."

S1003 Error "siemens-skip-level" "skip level does not exist"
"Blocks are skipped on levels /0 to /9; a slash alone means level 0. The control shows alarm 14060."

S1004 Error "siemens-structure-mark" "label or skip mark on a control structure"
"Lines with IF, ELSE, ENDIF, WHILE, FOR, LOOP, REPEAT and their ends take neither a label nor a skip mark. \
Put the label into the block before. The control shows alarm 12630."

S1013 Error "siemens-modal-passes" "number of passes in a modal call"
"MCALL calls the program once behind every positioning block; a number of passes cannot be given. The control shows alarm 12100."

S1015 Error "siemens-block-in-comment" "comment hides a block behind a lone carriage return"
"A comment holds a carriage return, and what follows reads as a block. Lines of this file end with a line feed, so for the control the rest still \
belongs to the comment, while many editors show it as a block of its own. End the comment with a line feed, or remove the block."

S1101 Error "siemens-lone-return" "carriage return inside a block"
"The lines of this file end with a line feed, and a carriage return alone stands between two words. Most often it is what is left of a line \
end, so that two blocks would be read as one. End every line in the same way: with a line feed, or with a carriage return and a line feed."

S1014 Error "siemens-name-length" "name is too long"
"Labels and names have at most 32 characters; the control stops at a longer one with alarm 12420. Shorten it."

S2001 Error "siemens-name-unknown" "name is not defined"
"The name is neither a variable nor a word of the language nor a function. The control shows alarm 12550. Variables are defined by DEF at the \
top of the program, by PROC, or in a definition file (SGUD, MGUD, UGUD, GUD4 to GUD9, macros in SMAC, MMAC, UMAC) beside the program."

S2002 Error "siemens-program-missing" "called program is not found"
"A word that is no word of the language is the call of a program (alarm 14011). It is looked for in the same archive, beside the program and \
in the include roots, as .MPF and .SPF. A mistyped word ends here, too."

S2003 Error "siemens-target-missing" "jump target is not found"
"GOTOF searches to the end of the program, GOTOB to its start, GOTO first forward and then backward, and only in the program that jumps. \
The control shows alarm 14080. Behind a jump that leads nowhere the run stops, because nobody knows where the program goes on."

S2004 Error "siemens-structure" "control structure is not closed"
"Every IF has its ENDIF, every WHILE its ENDWHILE, FOR its ENDFOR, LOOP its ENDLOOP, REPEAT without a label its UNTIL, in the same \
program and without crossing. The control shows alarm 12640 or 12641."

S2005 Error "siemens-type" "types do not go together"
"The operation or the variable does not take a value of this type: texts, axes and frames are no numbers. The control shows alarm 12150. \
Texts become numbers by NUMBER(…)."

S2006 Error "siemens-arithmetic" "value cannot be computed"
"Division by zero, a root of a negative number, an arc sine beyond 1, a result that is too large: alarm 14051. Look at the values of the \
parameters in the block."

S2007 Error "siemens-address-twice" "address stands twice in a block"
"Each address may stand once in a block; only G and M may be repeated. The control shows alarm 12000 or 16420. One of the two words is \
too many, or an axis letter is mistyped."

S2008 Error "siemens-group-twice" "two G codes of one group"
"Codes of one group exclude each other. The control takes the last one and shows alarm 12060; which one was meant cannot be known, so the \
block is refused."

S2009 Error "siemens-shape-twice" "two codes that shape the block"
"Of the G groups 1 to 4 (motion, dwell and reference points, frames and poles, preprocessing) one code may stand in a block. The control \
shows alarm 12070. Give each its own block."

S2010 Error "siemens-g-unknown" "G code is not known"
"The number belongs to no G group of the SINUMERIK language (alarm 12470). G codes of other languages, like G43, G28 or G80, mean nothing here."

S2011 Error "siemens-g-index" "G group has no such index"
"`G[group]=index` selects a code by its place in the group, counted from 1. The control shows alarm 12475."

S2012 Error "siemens-word-misfit" "word does not fit the block"
"The word has no meaning beside the others: a centre in a straight line, a repeat without a label, a modifier that the address does not take. The \
control shows alarm 12110, or 15460 if the G code is modal only. Nothing is dropped, so the block is refused."

S2013 Error "siemens-own-block" "word needs a block of its own"
"G4, G25, G26, G110 to G112, frame statements, calls and declarations stand alone in their block. The control shows alarm 12120. \
Put the other words into the block before or behind."

S2014 Error "siemens-mixed-assignment" "assignment beside other words"
"A block with an assignment like R1=5 holds assignments only; the control shows alarm 12080. Give it a block of its own."

S2015 Error "siemens-definition-late" "definition behind executed blocks"
"DEF and PROC stand at the top of a program, in front of the first block that does something, and PROC in front of DEF. The control shows alarm 14500 or 14520."

S2016 Error "siemens-name-taken" "name is used already, or no address"
"The name is an axis, a word of the language or a variable that exists (alarm 12170), or the letter is no address of this machine (alarm \
12050). Choose another name, or check the letter."

S2017 Error "siemens-start-values" "start values do not fit"
"More values are given than the array has elements (alarm 12260), or the type takes no start value in DEF (alarm 12261)."

S2018 Error "siemens-index" "no such element"
"The index lies outside the array, or the number outside the R parameters, spindles or work offsets. Indices count from 0. \
The control shows alarm 12400, 12410, 12430 or 17020."

S2019 Error "siemens-passes" "number of passes does not exist"
"A program or section is passed 1 to 9999 times; 0 and negative numbers raise alarm 14013. Look at the value of P."

S2020 Error "siemens-ret-in-main" "RET in the main program"
"RET returns to a calling program; the main program has none. The control shows alarm 14091. A main program ends by M30 or M2."

S2021 Error "siemens-arguments" "arguments do not fit the parameters"
"Number or types of the arguments differ from those of PROC or of the function: alarms 12300 to 12360, 12480, 14020, 14021, 14510; those of EXTERN from those of PROC: alarm 14530. VAR needs a \
variable of exactly the same type."

S2025 Warning "siemens-r-unset" "R parameter is read before it is set"
"R parameters keep their values from one program to the next, so what the parameter holds on the machine is not known here. It counts as 0. \
Set it in the program or under [variables]."

S2026 Warning "siemens-no-end" "program has no end"
"The main program ends without M30, M2 or M17; a control raises alarm 14000. The output gets an M2."

S2027 Error "siemens-setal" "program raises an alarm itself"
"The way through the program reaches SETAL, with which it stops for data it finds wrong. What follows would not run on the machine, so \
nothing is written. Look at the conditions in front of it."

S2028 Error "siemens-machine-value" "value is known on the machine only"
"The system variable is the state of a machine: inputs, actual values, machine data, offsets. A compiler cannot know it. Give a value under \
[variables], or take the question out of the program."

S2029 Error "siemens-range" "value lies outside its type"
"INT holds whole numbers up to 2147483647, CHAR 0 to 255. The control shows alarm 12160, 12560 or 14096."

S2030 Error "siemens-text-length" "text is too long"
"A text is longer than the variable takes, or longer than 200 characters: alarm 12210 or 14099. A constant 'H41' in a text is one character (alarms 12220, 12230). Macros have at most 256 characters."

S2031 Error "siemens-axis-needed" "an axis is needed"
"In this place stands the name of an axis, or a variable of type AXIS that names one: alarm 12040."

S2034 Error "siemens-frame" "frame cannot be built"
"A scaling factor is 0, a value is infinite, or a component is asked of a chain of frames that has none. Check the frame statements in front of the block."

S2040 Error "siemens-feed-missing" "no feed is programmed"
"A move with G1, G2, G3 needs a feed: alarm 10860. The feed also has to be programmed again when its kind changes (G94, G95, G96)."

S2041 Error "siemens-feed-zero" "feed is not above zero"
"A path feed of zero or less never ends: alarm 14800. Look where the value comes from."

S2042 Error "siemens-position-unknown" "position is not known"
"The block counts from a position that the program did not say yet: an increment, an arc, a pole, or a line by angle at the start of the \
program, behind a tool change, a change of the work offset or a move in machine coordinates. Program the axes absolutely once."

S2043 Error "siemens-tool" "tool is not known"
"The tool is called by a name that has no number, by a number that is none, or changed before it was chosen. Names get numbers in the \
[tools] tables of partc.toml. The control shows alarm 17190 or 17191."

S2044 Error "siemens-m-unknown" "M function of the machine builder"
"What this M function does, and whether it moves something, is up to the machine builder. If it may be printed as it stands, list it under \
`[output] pass_m`."

S2045 Error "siemens-spindle" "spindle word cannot be carried out"
"The speed is negative or missing, the spindle does not exist, or a dwell in turns has no fixed speed to count with."

S2050 Error "siemens-pole-axis" "pole outside the working plane"
"A pole lies in the working plane: X and Y in G17, Z and X in G18, Y and Z in G19. The control shows alarm 14270."

S2051 Error "siemens-polar-mixed" "polar and Cartesian end point mixed"
"The end point in the plane is given by AP= and RP=, or by axes, not by both. The control shows alarm 14280. The axis at a right angle to the \
plane may stand beside AP and RP."

S2052 Error "siemens-polar-radius" "polar radius is negative"
"RP= is a distance from the pole and cannot be negative: alarm 14200, in a pole block 14250."

S2053 Error "siemens-polar-angle" "polar angle out of range"
"AP= lies between -360 and 360 degrees: alarm 14210, in a pole block 14260. Look at the word that is marked, and at the value behind it."

S2054 Error "siemens-polar-missing" "polar word was not programmed"
"After a new pole or a change of plane AP= has to be programmed again, and RP= once at all: the manuals demand the word, so its value is not \
known. The same holds for an AP=IC(…) that has no angle to count from. Program both words in this block."

S2060 Error "siemens-no-diameter-axis" "no diameter axis"
"Diameter programming and constant cutting speed refer to the one transverse axis that machine datum 20100 names; without it they raise alarm \
16510 or 10870. Set `[machine] diameter_axis`."

S2061 Error "siemens-rotary-word" "modifier does not fit the axis"
"DC, ACP and ACN are for rotary axes, with angles from 0 to below 360 degrees: alarms 16800 to 16830."

S2070 Error "siemens-angle-line" "line by angle is not determined"
"ANG= with one end coordinate is a line; with none it is the first of two lines, and the next block has ANG and both end coordinates. \
Alarms 10790 to 10795. Nothing but blocks without motion may stand between the two."

S2071 Error "siemens-corner-word" "chamfer or rounding cannot stand here"
"RND, CHR and CHF stand in the block that leads to the corner and are not negative: alarms 16500, 10882."

S2080 Error "siemens-compensation" "radius compensation cannot change here"
"G41, G42 and G40 take effect on a straight line with a tool selected; plane, frame, work offset and tool do not change in between. \
Alarms 10750 to 10757, 10780."

S2081 Error "siemens-thread" "thread is not determined"
"G33 needs the lead along the axis that moves furthest: K along Z, I along X, J along Y. Alarms 16720 to 16740."

S2082 Warning "siemens-compensation-open" "program ends with compensation on"
"Radius compensation is ended by G40 with a straight move. The output ends it before M30, but the last corner is not what was meant."

S2083 Error "siemens-soft-approach" "soft approach or retraction is not determined"
"G147, G247 and G347 lead to a contour, G148, G248 and G348 from it, on a line, a quadrant or a semicircle. The way needs its size (DISR), the direction of the contour, which the element \
next to it gives, the side, which G41, G42, G141 or G142 give, and heights in order: DISCL between the contour and the start or end. Alarms 10740 to 10748."

S2090 Error "siemens-cycle-argument" "argument of a cycle is wrong"
"The data of a machining cycle contradict each other, are missing, or do not fit what stands around the call. The number is the alarm that the \
cycle raises itself. Arguments are counted by their commas; an empty argument is not given, which is not the same as 0."

S2091 Error "siemens-cycle-contour" "contour of a cycle is wrong"
"What CYCLE62, CYCLE95, CYCLE72 and others call is no contour that the cycle can take: it has no start point, moves at rapid traverse inside, \
leaves its plane, crosses itself, holds functions or cycles, or is not closed where it has to be. The number is the alarm of the control."

S2130 Error "siemens-axis-twice" "two names of one printed axis"
"Two axes of the machine, such as Z and Z2, would be printed with one letter, so that a move of the one would move the other. Give one of them \
another letter under `[machine] axes`, or \"leave-out\" if the target has no such axis."

S3001 Error "siemens-radius" "arc by radius does not reach its end"
"CR= is at least half the distance of start and end: alarm 14095. Look at the word that is marked, and at the value behind it."

S3002 Error "siemens-arc-twice" "arc is given twice"
"Centre, CR= and AR= exclude each other, and a polar arc has the pole as its centre: alarm 14900."

S3003 Error "siemens-arc-open" "arc is not determined"
"A circle needs a centre, a radius or an angle, and an arc by radius an end point that differs from its start: alarm 14040."

S3004 Error "siemens-opening" "opening angle out of range"
"AR= lies between 0.0001 and 359.9999 degrees: alarm 14910. A full circle is programmed by its centre."

S3005 Error "siemens-turns" "number of turns does not exist"
"TURN= counts additional full circles, 0 to 999: alarm 14048. Look at the word that is marked, and at the value behind it."

S3006 Error "siemens-via" "intermediate point is missing"
"CIP runs through a point between start and end, given by I1=, J1=, K1=: alarm 14920."

S3007 Error "siemens-end-off-circle" "end point does not lie on the circle"
"Start and end have the same distance from the centre, within MD 21000 (0.01 mm) or MD 21010 (a thousandth of the radius): alarm 14040. Check \
start, end and centre; I, J and K count from the start point."

S3008 Error "siemens-tangent" "CT has no tangent"
"CT goes on in the direction of the block before, which has to travel in the working plane, and cannot turn back: alarm 14045. Put a line or an \
arc in front of it, and the end point not straight behind the start."

S4001 Error "siemens-contour-long" "contour has too many elements"
"A contour that a cycle works along is kept as a whole, so its length is limited: 1000 elements, roundings and chamfers counted. The control \
has a limit of its own (alarm 61933). Split the contour."

S8001 Warning "siemens-unbracketed-logic" "AND or OR beside a comparison without brackets"
"Comparisons bind weakest on a SINUMERIK control: `R1==1 AND R2==2` is read as `R1 == (1 AND R2) == 2`, which is hardly what is meant. \
Put each comparison in brackets. The program is compiled as the control reads it."

S8002 Note "siemens-dynamics" "words for speed and accuracy are left out"
"G64 and its kin, SOFT, FFWON, COMP…, CYCLE832, ADIS, ACC and others shape how a control follows the path, not the path itself. The \
programmed path is printed exactly; set the path mode of the target there."

S8003 Warning "siemens-several-programs" "file holds several main programs"
"An archive can hold several main programs; the first one is compiled, the others are not looked at. Put each into a file of its own."

S8004 Note "siemens-gear" "gear steps are left out"
"M40 to M45 select the gear of a spindle. The target chooses its own, so they are not printed; list them under `[output] pass_m` to print them."

S8005 Note "siemens-h" "H functions are left out"
"H functions are messages to the machine's own control. What they do is not known, and the target has no word for them."

S8006 Note "siemens-outputs" "outputs and counters are left out"
"Writing outputs, timers and counters of the control has no effect on the path and is not printed. Values that the program reads back are kept."

S8007 Warning "siemens-increment-frame" "increment behind a change of the frame"
"Whether an increment travels the change of the frame, too, depends on setting datum 42440: with 1 it counts from the programmed value of \
before in the new frame, with 0 from where the tool stands. Set `[control] sd42440`, or program absolutely."

S8008 Warning "siemens-rnd-and-chr" "rounding and chamfer in one block"
"With RND and CHR or CHF in one block the control makes the rounding only. Delete one of them."

S8009 Warning "siemens-tool-not-listed" "tool is not in the tool table"
"A tool table was given, and this tool is not in it. Check the number, or add the tool."

S8010 Note "siemens-edges" "tool data of the control are not printed"
"A tool of the target has one set of offsets, in a table of its own. Edges D2 and higher, and lengths that the program writes ($TC_DP3), are \
not printed; the target has to be told them. Under G41 and G42 the radius of the edge counts: where it is not known the block is refused."

S8011 Note "siemens-g500" "how positions under G500 are printed"
"G500 switches the work offset off, so that positions count from the basic system: the machine zero, shifted by the basic frame. Where the program uses no offset \
of the machine they are printed as they stand; the offset that is active on the target has to be zero or to lie there. Beside offsets of the machine they are \
printed with G53 through `[datums] basic`, or through the values of the offset in `[datums]`. If G500 stands for a work offset, name it: `[datums] G500 = \"G54\"`."

S8012 Note "siemens-written-offset" "work offset of the program is in the coordinates"
"The program writes the work offset itself ($P_UIFR). It is put into the printed coordinates, which count from the basic system; no G54 is \
printed for it. So the work offset that is active on the target has to be zero, or to lie at the basic zero point."

S8101 Warning "siemens-feed-words" "word that changes feeds or speeds"
"CFTCP and CFIN make F count differently on arcs under radius compensation, FLIN and FCUB let the feed run from value to value, FGROUP lets \
it count along some of the axes, GWPSON makes S a speed of the circumference of the wheel. The output has F and S as they are programmed. CFC, FNORM and GWPSOF are what the target does."

S8102 Warning "siemens-rapid-by-axis" "rapid traverse of each axis by itself"
"Under RTLIOF each axis goes to its end at its own rapid traverse, so that the path between the points is no straight line. The target moves straight: \
check that the way is free, or program RTLION."

S8103 Note "siemens-control-words" "words that steer the control only are left out"
"STOPRE, SBLOF, DISPLOF, WAITP and others act on the buffer, the display and the single block of the control; LFON and RMI on what happens behind an \
interruption; CP, TRAFOOF, TOROTOF, CUTCONOF and others switch off what no block can switch on here. None of them moves an axis."

S8104 Note "siemens-orientation-words" "words for tool orientation are left out"
"ORIWKS, ORIMKS, ORIAXES, ORIC and others say how a control turns the tool. The output has no tool orientation: rotary axes are printed as they are \
programmed, and tool directions (A3=, LEAD=) are refused."

S8105 Note "siemens-length-added" "tool length is in a machine coordinate"
"G53, G153 and SUPA place the tip of the tool on a SINUMERIK control (MD 10760 = 0), and the nose of the spindle on the target. The length of the \
tool is added to the printed coordinate, so that the spindle stands where the control has it."

S8106 Warning "siemens-tip-in-machine" "machine coordinate counts for the tip of the tool"
"G53, G153 and SUPA suppress frames, not the length of the tool, unless MD 10760 says so: the tip goes to the machine coordinate, and the \
spindle stands a tool length higher. The target places its spindle there. Write D0 in the block as most programs do, set `[control] md10760 = \
true` if the machine suppresses the length, or print tool lengths (`tool_length = \"G43\"`) and give them."

S8107 Warning "siemens-negative-half" "half of a negative number is rounded"
"A negative number that ends in .5 becomes an INT here by rounding up (-2.5 is -2), and ROUND takes it away from zero (-3). The manuals say what \
becomes of positive halves only. Keep the value off the half, or round it in the program."

S8108 Note "siemens-file-error" "error variable of a file access is 0"
"WRITE and DELETE report in a variable whether they worked. They are left out, so the variable gets 0: no error."

S8013 Note "siemens-limits" "working-area limits are left out"
"G25 and G26 set limits for axes or spindle speeds in the control. They are no moves and have no word on the target."

S8014 Note "siemens-master" "another spindle is the master"
"SETMS makes another spindle the master: S, M3, M4, M5 and SPOS without a number are its words from here on and are printed with its number. \
Feed per revolution, threads and G96 would follow it, too, and are refused: the target follows its first spindle."

S8015 Note "siemens-channels" "channel words are left out"
"INIT, START, WAITM and others synchronize programs in several channels. The output is for one channel; what the others do is not in it."

S8016 Note "siemens-interrupts" "interrupt programs are left out"
"SETINT and others name programs that run when a signal comes. They are not part of the path."

S8017 Note "siemens-files" "file access is left out"
"WRITE, DELETE and others work on files of the control. They have no effect on the path."

S8018 Warning "siemens-two-depths" "two depths for one hole"
"DP and DPR, or FDEP and FDPR, give different depths. The cycle takes the relative one. Leave one of them out."

S8019 Warning "siemens-starts" "thread with several starts"
"The editor of CYCLE99 may leave a number of starts in its call though one start is meant. All starts are cut as the argument says: check it."

S8020 Note "siemens-thread-variant" "digits of a thread cycle"
"What the digits of _VARI in CYCLE99 mean is not confirmed beyond their units, which are read as in CYCLE97. Of the other digits only \
those of stored calls are taken (1310101: roughing and finishing, so many passes as NRC says); others are refused."

S8021 Warning "siemens-flank" "reference of the flank infeed"
"With a flank infeed the passes are shifted along the thread. Which of them stands at the programmed start is not documented; partc shifts from \
the crest on. The finished thread is the same up to a shift along its axis, which matters where a thread is cut anew. `[control] thread_flank` says it."

S8022 Note "siemens-undercut-facts" "undercut rests on facts that are not confirmed"
"Some values of undercut tables and their use in the control have one source only. They can be set under [undercut]; check the drawing."

S8023 Note "siemens-undercut-roughing" "roughing of an undercut"
"How a control roughs an undercut is not published. partc cuts in equal steps, then along the undercut; the finished form is the same."

S8024 Note "siemens-nose" "nose radius is not compensated"
"The cycle of the control selects radius compensation itself. With `compensation = \"control\"` the output does so, too; otherwise the \
programmed point of the tool follows the undercut."

S8025 Warning "siemens-tap" "tapping with a tension-compression chuck"
"CYCLE84, CYCLE840, G331 and G332: the target cuts a thread in step with the spindle and reverses in between, which is not rigid: the tap needs a chuck that gives way. Where the \
target has rigid tapping of its own, replace the two moves by it."

S8026 Warning "siemens-contour-differs" "blocks and records of a stored contour differ"
"The contour editor stores a contour twice: as NC blocks, which run, and as hidden records of what was typed. They make different points here, so one \
of the two was changed by hand. The blocks are compiled, as the control does."

S8027 Note "siemens-contour-unchecked" "records of a stored contour cannot be checked"
"The hidden records of this contour use elements that cannot be solved here. The NC blocks are compiled; nothing is lost but the check."

S8029 Note "siemens-swivel-zero" "swivelling by nothing is left out"
"CYCLE800 with angles, offsets and retraction of 0 leaves the plane where it is. Rotary axes stay where they are: the output has a machine in \
mind whose plane is not swivelled."

S8028 Note "siemens-contour-rebuilt" "stored contour is made from its records"
"The NC blocks of a contour of the contour editor are missing. Its hidden records determine it, so the blocks are made from them, at the feed that \
is modal. Compare the result with the drawing."

S8030 Warning "siemens-contour-choice" "stored contour has two solutions"
"A contour is made from its hidden records, and the values of one leave two solutions. Which one was chosen in the editor is stored in a way that is \
not confirmed; the shorter arc or the farther point is taken. Compare it with the drawing."

S8031 Note "siemens-spindle-sense" "sense of a spindle stop is not printed"
"SPOS=ACP(…) and SPOS=ACN(…) say in which sense the spindle turns to its angle. The angle is printed; the target chooses the sense."

S8032 Warning "siemens-speed-limited" "spindle speed is above its limit"
"G26 S limits the speed of a spindle, LIMS= that of the master under G96 and G97. The control turns the spindle at the limit, so the limit is printed."

S8033 Warning "siemens-mcall-trigger" "block without a move under a modal drilling cycle"
"Under MCALL of a drilling cycle some controls drill behind a bare G0, G1, F or S as well, at the place where the tool stands. It is read here \
as a block that drills nothing. Put such blocks in front of MCALL."

S8034 Warning "siemens-thread-spindle" "thread without a turning spindle"
"G33 follows the turning of the spindle. No block before starts it, so that the machine would wait for a spindle that stands. \
A subprogram may have its spindle started by its caller; then all is well."

S8035 Note "siemens-argument-unused" "argument that this form of the cycle does not use"
"The cycle has forms that use different arguments. The one named has a value and no meaning for the form of the call, so it changes \
nothing. Check whether the form or the place of the argument is meant otherwise."

S8036 Warning "siemens-label-twice" "label that stands twice"
"A jump goes to the nearest label in the direction of its search, so that a label that stands twice leads to different places from \
different blocks, and a block inserted later changes the way. Some controls refuse such a program when it is translated. Rename one of them."

S8037 Note "siemens-callpath" "search path of the control is not used"
"CALLPATH adds a folder of the control in which called programs are looked for. partc looks beside the program that calls and in the \
folders of `[include] roots`. If a program lies in the folder that CALLPATH names, list the folder there."

S8038 Warning "siemens-mcall-open" "modal call that is never ended"
"MCALL with a program or a cycle calls it behind each block that moves, up to an MCALL without a name. The program ends before: \
every move behind the last hole, the retraction to the tool change included, has drilled again."

S8040 Warning "siemens-block-not-run" "block that does not run could not be compiled"
"`partc check` looks at every block, also at those that this run of the program leaves out: behind M30, in subprograms that nothing calls, behind a \
jump, in a branch not taken. The output does not depend on this one, so it is no error; if it ever runs, it will be refused. `partc explain` \
with the code that the text names says why."

S8041 Note "siemens-tap-stop" "spindle stands behind rigid tapping"
"G331 and G332 turn the spindle with the drilling axis, and it stands in front of and behind them. An M3 or M4 of before does not count \
any more, so M5 is printed behind the tap. Program M3 or M4 again where the next tool path needs it."

S8042 Note "siemens-tangent-frame" "direction of CT is turned with the frame"
"CT goes on in the direction of the last block that travelled. A frame that turns, mirrors or scales between the two is applied to that \
direction, too, so that the path has a corner there. Program CT in front of the change of the frame if it shall go on smoothly."

S8043 Note "siemens-compensation-shape" "shape of the compensated path is the target's"
"KONT, KONTT, KONTC, G451, G461 and G462 say how the control leads the tool to a compensated contour, away from it and round its corners. \
With `[output] compensation = \"control\"` the target computes that path by its own rules: watch the entry, the exit and sharp outside \
corners in its simulation."

S8044 Note "siemens-first-dc" "way of the first DC position of a rotary axis"
"C=DC(30) takes the shortest way to 30 degrees, and C30 of an axis that counts modulo 360 degrees stays inside its turn. No block before says where \
the axis stands, so the position is printed as it is, and the target's rotary axis goes there in its own way. A position of the axis in front of it, C=0 at the start, makes the way known."

S8045 Warning "siemens-feed-at-start" "kind of feed that no block names"
"What F counts at the start of a program is a machine datum (MD 20150): mm per minute on most machines, mm per revolution on many lathes. \
An F of 0.2 means two very different things. Program G94 or G95 in front of the first F, or set `[control] md20150`."

S8046 Warning "siemens-speed-frozen" "constant cutting speed ends without a speed"
"G97, G94 and G95 behind G96 keep the speed that the spindle has at this moment. It is computed from the diameter at which the tool stands and \
printed; on the machine it depends on where the control last adapted it. Program S with the word."

S8047 Warning "siemens-feed-spindle" "feed per revolution without a turning spindle"
"G95 moves with the turns of the spindle. No block before starts it, so that the machine would wait. \
A subprogram may have its spindle started by its caller; then all is well."

S8048 Warning "siemens-via-diameter" "intermediate point of CIP in diameters"
"Under DIAMON the intermediate point of a circle is read as the end point is: I1= along the diameter axis is a diameter. The manuals do not \
list this word among the diameters. Where it is a radius on your control, program DIAMOF and radii for this circle."

S8049 Note "siemens-goto-start" "jump to the start of the program is left out"
"GOTOS goes back to the start of the program where the machine (its PLC) asks for another run. The output is one run; start it again on the target."

S8050 Warning "siemens-count-rounded" "number of holes is rounded"
"The number of holes is an INT of the cycle, and the control rounds a REAL that is given for one: 4.5 holes become 5. Write a whole number, or \
look at the formula that makes it."

S8130 Note "siemens-axis-left-out" "axis that is left out"
"`[machine] axes` says that the target has no such axis. Its words are left out of every block; other words of the blocks are printed. See to it that \
the axis stands where the program needs it."

S8131 Warning "siemens-moves-before-offset" "moves in front of the first work offset"
"In front of the first G54 a control counts from its basic system (G500), unless a machine datum (MD 20150) says otherwise. On the target these moves run under \
the offset that is active there at the start. Select the work offset in front of the first move; a retraction in machine coordinates is SUPA or G53."

S8133 Warning "siemens-thread-shifted" "start of a thread is shifted"
"SF=, the start angle and further starts of a thread cycle begin a thread at an angle of the spindle, which the target cannot. It begins farther back by lead · angle / 360 instead and is the same thread from the \
programmed start on. The tool goes to that place at rapid traverse: see that no shoulder and no tailstock stands there."

S8134 Warning "siemens-g40-waits" "G40 without a move in the plane"
"The manuals want G40 in a block that moves in the working plane (alarm 10754); programs that ran have it in front of a retraction along the tool. The offset stays \
through such moves and is taken off in the next G0 or G1 with an axis of the plane, an arc there is refused. `[control] g40_without_motion = \"error\"` refuses it at once."

S8135 Note "siemens-stand-in" "program that `[programs]` stands for"
"The program belongs to the machine builder and is not here. `[programs]` says that its call changes the tool, or is left out; whatever else the program does on \
the machine is not in the output. Give a program of your own for it (`TC = { file = \"stubs/TC.SPF\" }`) where more of it is needed."

S8190 Warning "siemens-g53-beside-g500" "machine coordinates beside positions under G500"
"Positions under G500 count from the basic system and are printed as they stand, in the offset that is active on the target at the start. Those of G53, G153 and SUPA \
count from the machine zero. The way between the two is the basic frame of the machine: give it by `[datums] basic`, or see that the offset on the target lies where the \
basic system of the control lies."

S8191 Warning "siemens-g96-shifted" "constant cutting speed under a shift of the diameter axis"
"G96 makes the speed of the spindle from the diameter at which the tool stands. The target takes the printed coordinate, in which a TRANS of the diameter axis is contained; \
which of the two the control takes is not confirmed. Look at the speed on the machine, end the shift in front of the cut, or program G97 with a speed."

S8192 Warning "siemens-point-without-axis" "G74 or G75 without an axis"
"G74 and G75 move the axes that their block names to points of the machine. This block names none, so nothing is printed for it; a retraction that it may stand for is \
not made. Name the axes: `G75 X1=0 Z1=0`."

S8193 Warning "siemens-disc" "DISC is read as a circle"
"DISC=1 to DISC=100 stretch the arc about an outside corner towards the intersection; the curve is not published. With `[control] disc = \"circle\"` the tool goes around \
the corner on a circle, as under DISC=0: it touches the same contour, on a shorter way."

S8194 Warning "siemens-edge-position" "centre of the nose by the position of the edge"
"The path of a turning tool is that of its theoretical tip. From there the centre of the nose lies as the position of the cutting edge says (`$TC_DP2`, or `orientation` in partc.toml): \
3 is an outside tool that cuts towards the chuck, 2 a boring bar, 9 the centre itself. The table was not confirmed by a manual at hand: compare it with the tool data of the control once."

S8195 Warning "siemens-corner-code" "G450 or G451 in a block of the contour"
"G450 and G451 change inside a compensated contour, in a block that moves. The manuals do not say whether the corner in front of the block or the one behind it is meant: the one behind \
it is taken. Write the code into a block without a move."

S9001 Error "siemens-unsupported" "not supported"
"The word changes how the machine moves in a way that plain G-code cannot say, or that is not built. Replace it by plain moves."

S9002 Error "siemens-interpolation" "interpolation that plain G-code cannot say"
"Splines, polynomials, involutes, threads of changing lead and taps that a frame turns have no word in plain G-code. Have the CAM system put out lines and arcs."

S9003 Error "siemens-iso" "ISO dialect"
"G291 and ISOCALL switch to ISO dialect, which is another language with other rules. Translate that part, or compile it by itself."

S9004 Error "siemens-synchronized" "synchronized action"
"WHEN, WHENEVER, EVERY, FROM, DO, ID and IDS run beside the program, as signals of the machine come. What they would do cannot be known here."

S9005 Error "siemens-cycle" "cycle is not supported"
"The cycle or procedure of the control is known by name and not built. Nothing is left out in silence, so the program is refused."

S9006 Error "siemens-transformation" "transformation is not supported"
"TRAORI, TRANSMIT, TRACYL, CYCLE800 and others turn programmed coordinates into other axes, which needs the kinematics of the machine."

S9007 Error "siemens-other-spindle" "word for another spindle"
"Only speed and sense of rotation of further spindles can be printed. Feed per revolution, threads, tapping and G96 follow the master spindle \
(SETMS); the target follows its first one, so they are refused while another is the master."

S9008 Error "siemens-axis-motion" "axis motion that cannot be printed"
"Positioning axes that run beside the path, and approaches of machine-fixed points, need data of the machine. Reference and fixed points can be \
given under [machine]."

S9009 Error "siemens-feed-kind" "kind of feed that cannot be printed"
"G931 and the feeds that are kept at a switch cannot be printed. Under G93 F is the time of its own block: roundings, chamfers, cycles and \
radius compensation have no share of it. Program the feed by G94 or G95."

S9010 Error "siemens-resolve" "tool-centre path cannot be computed"
"The path of the tool centre needs the radius of the tool, on lathes also the position of its cutting edge, and rules that are published: compensation in space, approaches on polynomials \
(KONTT, KONTC) and the curves of DISC are not. Tool data come from partc.toml or from `$TC_DP` of the program. With `[output] compensation = \"control\"` the contour is printed with G41 and G42."

S9011 Error "siemens-machine-coordinates" "cannot be printed in machine coordinates"
"Under G53, G153, SUPA and G500 only straight absolute moves can be printed. Look at the word that is marked, and at the value behind it."

S9012 Error "siemens-thread-start" "start angle of a thread"
"The target starts every thread at the same angle of the spindle. SF= is made by a start that lies farther back along the thread by lead · angle / 360; \
in a chain of threads, behind a chamfer or rounding and in a turned or scaled frame that cannot be done. Shift the start point in the program."

S9101 Error "siemens-modulo-shift" "sense of a modulo axis under a shift"
"An absolute position of a rotary axis that counts modulo 360 degrees is reached inside the turn in which the axis stands. Where its zero is shifted \
(TRANS, `$P_UIFR`) the turn begins elsewhere in the program than on the machine, so the sense of rotation is not known. Write DC, ACP or ACN, or \
set `[control] md30455 = \"shortest\"` if the machine takes the short way."

S9102 Error "siemens-tool-length" "length of the tool is not known"
"G53, G153 and SUPA place the tip of the tool on a SINUMERIK control (MD 10760 = 0), and the nose of the spindle on the target; SUPD does the \
opposite. With `tool_length = \"G43\"` the length of the tool is added, so it has to be known: give it under [tools] or write `$TC_DP3`. On lathes \
it is never known. Under D0, or with `[control] md10760 = true`, no length counts."

S9103 Error "siemens-setting" "setting datum is changed"
"Setting data (`$SC_…`, `$SN_…`) change what other words of the program do. Those that partc knows are followed; this one is not. If the machine has the \
value anyhow, say so under [variables], and the block is left out."

S9013 Error "siemens-oblique-circle" "circle stands obliquely in space"
"Plain G-code has circles in the main planes only. Look at the word that is marked, and at the value behind it."

S9014 Error "siemens-offset-unknown" "work offset has no counterpart"
"The target has nine work offsets, G54 to G59.3. Say which one stands for this: `[datums] G510 = \"G55\"`."

S8160 Warning "siemens-contour-inches" "records of a contour are read in inches"
"The NC blocks of a contour of the contour editor are missing, and the unit in force is the inch, so its hidden records are taken as inches, as the \
blocks would be. No stored contour of inches is known to us: compare the size of the part with the drawing."

S8161 Warning "siemens-contour-start-undercut" "contour starts with an undercut"
"The NC blocks of a contour of the contour editor are missing, and its records put an undercut at its start. The contour is begun where the undercut \
leaves the line in front of it, as is done for a chamfer or a rounding there; what the editor writes for an undercut was never seen."

S8162 Warning "siemens-cycle-reading" "reading of a cycle argument that is not confirmed"
"The argument has a meaning that follows from a few stored programs or from similar cycles, and no manual at hand says it. partc takes it as the \
message says; compare with what the machine does."

S9015 Error "siemens-cycle-variant" "variant of a cycle is not supported"
"The cycle is built, but not this variant of it, or the meaning of a coded argument is not confirmed. Use the plain variant, or plain moves."

S9016 Error "siemens-offsets-off" "move without tool offsets"
"D0 switches the offsets of the tool off, so that positions count for the spindle nose. The target knows positions of the tool tip only. \
Moves in machine coordinates (SUPA, G53, G500) can be printed."

S9017 Error "siemens-mixed-offsets" "work offset of the program beside one of the machine"
"A work offset that the program writes ($P_UIFR) is put into the coordinates, which then count from the basic system. Offsets that it only \
selects are those of the machine, whose values are not known. Between the two no way can be computed. Use the one kind or the other."

S9018 Warning "siemens-save-offset" "SAVE and a changed work offset"
"A program with SAVE changed the frame of the work offset that is in force before and after it. Bit 0 of machine datum 10617 decides whether the frame of the \
call comes back; it is read as 0: the frame stays. Set `[control] md10617`, or select the offset again in the calling program."

S9019 Error "siemens-contour-open" "stored contour cannot be made"
"The NC blocks of a contour of the contour editor are missing, and its hidden records leave elements open. Open the contour in the editor \
of the control and accept it again."

S9020 Error "siemens-contour-cycle" "contour cycle is not supported"
"The arguments of the cycle were read and its contour was run and checked, so what is reported about them is true. But the tracks of the cycle are \
computed inside the control and are not published. Replace it by plain moves, or have the CAM system put them out."

S9130 Error "siemens-left-out-position" "position that only an axis that is left out makes"
"Under MCALL each block that moves an axis calls the program or cycle. Here the axis is left out by `[machine] axes`, so that every call would work at one \
place. Print the axis, or end the modal call before."

S9131 Error "siemens-g500-unrelated" "G500 beside a work offset of the machine"
"Positions under G500 count from the basic system, those under G54 from where the machine has that offset. The way between the two is known on the machine only. \
Give the basic frame (`[datums] basic`), the values of the offset (`[datums] G54 = { X = … }`), or the offset that G500 stands for (`[datums] G500 = \"G55\"`). \
A retraction in machine coordinates is SUPA or G53."

S9132 Error "siemens-word-not-compiled" "word of the control that is not compiled"
"The word belongs to the language and is no missing program: what it does has no word in plain G-code, or is not built. The text says what it is and what to write \
instead. Nothing is left out in silence, so the program is refused."

}
