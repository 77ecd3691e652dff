//! `S0` to `S4`: faults of SINUMERIK programs. A text that names an alarm means the number the control itself shows.

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
"A word that is no word of the language is the call of a program (alarm 14011). It is looked for where the control looks, whoever calls: in \
the folder of the main program as .SPF and .MPF, then as .SPF in `/_N_SPF_DIR`, in the folder of CALLPATH, in `/_N_CUS_DIR`, `/_N_CMA_DIR` and `/_N_CST_DIR`. The programs of an \
archive lie in the folders of their `;$PATH=` lines, and `[include] roots` names the folder of this computer for each. Other workpieces are never searched. Programs of the machine builder are answered in partc.toml: `[programs] TC = { tool = 1 }`. A mistyped word ends here, too."

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
"The main program ends without M30, M2 or M17; a control raises alarm 14000. Without \
`[control] open_end = \"allow\"` that is an error (P0007). The output gets an M2."

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
`[output] pass_m`; if it changes the tool as M6 does, under `[control] tool_change_m`."

S2045 Error "siemens-spindle" "spindle word cannot be carried out"
"The speed is negative or missing, the spindle does not exist, or a dwell in turns has no fixed speed to count with."

S2046 Error "siemens-programs-of-one-name" "several programs of one name and rank"
"The call names a program, and more than one has that name in the same folder of the control: two in an archive with the same `;$PATH=` line or none, one in an archive and \
one on the disk, or one in each of two folders that stand for it. So it is where a file beside the main program lies in another folder by its own `;$PATH=` line, and another program of that name would run \
by one of the two. A control keeps one of them, which depends on what was read in last. The same is said where a folder of a backup is called as one folder of the control and the `;$PATH=` \
line of a program in it names another one: nothing says which of the two is out of date.\n\
Delete or rename all but one, place a program by a `;$PATH=` line behind its head, or call it by its path."

S2047 Error "siemens-spf-beside-mpf" "subprogram and main program of one name"
"NAME_SPF and NAME_MPF lie in the folder of the main program, and the call says NAME. Manuals disagree which of them runs: the SPF (SINUMERIK ONE, programming manual \
12/2019, 3.4.1.4), the MPF (older ones), or none without its ending (828D).\n\
Write the ending, `CALL \"NAME_SPF\"`, rename one of them, or say what your control runs: `[control] called_first = \"spf\"` or `\"mpf\"`."

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
}
