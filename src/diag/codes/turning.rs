//! `T`: HEIDENHAIN turning: MANUALplus 4110, DIN PLUS and smart.Turn.

super::codes! { TURNING:

T0001 Error "turning-character" "character has no place in a block"
"The character belongs to no word of a turning program. Comments stand in square brackets: `[ROUGH THE OUTSIDE]`."

T0002 Warning "turning-dash" "printed dash instead of a minus sign"
"A dash of printed text stands where a minus sign is meant, as happens when a program is copied from a document. It is read as `-`. \
Replace it: the control does not accept it."

T1001 Error "turning-syntax" "block cannot be read"
"The words of the block do not fit together: a value is missing, or a word stands where none can stand. An address and its value stand \
together (`X50`, `Xi-5`, `X#5`, `X{#5+2}`); a coordinate that is left open is written `X?`."

T1002 Error "turning-word-twice" "word stands twice in a block"
"A block may hold several functions as long as no address is used twice. Which of the two values counts cannot be guessed. \
Put the second function into a block of its own."

T1003 Error "turning-word-not-admitted" "word has no place in this block"
"Every word has to belong to a function of its block, and the functions of this one do not take it. The control would refuse it or \
ignore it; partc never drops a word. Remove it, or put it where it belongs."

T1004 Error "turning-comment" "comment is not closed, or words follow it"
"A comment stands in square brackets at the end of its block or alone on its line. Words behind a comment would be easy to overlook, and \
a bracket that is not closed may have swallowed words."

T1005 Error "turning-word-missing" "block lacks a word"
"A word without which the function has no meaning is missing. The control would ask for it in its dialogue. Add the word."

T1006 Error "turning-functions-clash" "functions of the block contradict each other"
"Two functions of the block cannot act together: both move, both take the same word, or they say opposite things (`M3 M4`). \
Put the second one into a block of its own."

T1007 Error "turning-value" "value is out of range"
"The word takes other values than this one: a whole number of a short list, a length above zero, or a factor up to 1. Check the value, \
and the sign."

T1008 Error "turning-place" "block stands in the wrong part of the program"
"A DIN PLUS program consists of sections: header lines in HEADER, tools in TURRET, shape in BLANK and FINISHED PART, everything that moves in \
MACHINING. The same words mean different things in different sections, so a block in the wrong one is refused."

T1009 Error "turning-structure" "IF, WHILE or SWITCH is not closed or not opened"
"Every IF needs its ENDIF, every WHILE its ENDWHILE, every SWITCH its ENDSWITCH, in the same program and section. \
Otherwise it is open which blocks run."

T1010 Error "turning-no-end" "file ends without END or RETURN"
"A main program ends with END (ENDE), a subprogram with RETURN. The file has a program name or sections but no end: most likely it was cut \
off in transfer, and the end of the path is missing. If the program is complete, add the word."

T1011 Warning "turning-behind-end" "block stands behind the end of the program"
"What stands behind END is not executed. Most often two programs were joined into one file; each needs a file of its own."

T1012 Warning "turning-unit-frame" "frames of units do not match"
"smart.Turn frames the blocks of a unit with UNIT and END_OF_UNIT. The blocks are compiled as they stand, the frame means nothing to the path. \
A frame that does not match shows that the file was edited: check that no block is lost."

T1013 Note "turning-unit-missing" "no #UNIT line"
"The unit of a DIN PLUS program is fixed in its header. Without the line the control takes its own setting; partc takes `[control] unit` of \
partc.toml, or millimetres."

T1014 Error "turning-unit" "unknown unit"
"The header line #UNIT says METRIC or INCH. The difference is a factor of 25.4, so another word is not guessed."

T2001 Error "turning-no-path-function" "coordinates without a function that moves"
"On these controls every block that moves holds its function (G0, G1, G2 …); no manual says that the last one goes on. \
Write the function into the block."

T2002 Error "turning-position-unknown" "position of the tool is not known"
"An incremental word, an angle or an arc counts from where the tool stands, and that is not known: at the start of the program, after a \
tool change, and after a move in machine coordinates. Program the axis once as an absolute value."

T2003 Error "turning-feed-missing" "no feed, or no kind of feed"
"A cutting move needs a feed, and F needs G94 (mm per minute) or G95 (mm per revolution) to have a meaning; what holds when the control is \
switched on is not in the program. Program `G95 F0.25` or `G94 F200` first."

T2004 Error "turning-speed-mode" "S without G96 or G97"
"S is a cutting speed under G96 and a number of revolutions under G97. Neither was programmed, so S has no meaning yet."

T2005 Note "turning-speed-limited" "speed is lowered to the limit of G26"
"G26 sets the highest speed. The program asks for more under G97, and the control would turn with the limit; the limit is printed."

T2006 Error "turning-change-point" "tool change point is not known"
"G14 moves to the tool change point, which is stored in the control. Where it lies decides whether the turret can turn without a collision, \
so it is never guessed: set `[control] tool_change_point = { X = 300.0, Z = 400.0 }` in partc.toml, in machine coordinates, X as a diameter."

T2007 Error "turning-tool-number" "tool number cannot be printed"
"T names a position of the turret, with a point and a digit for one edge of a tool that has several (`T2.1`). The target knows whole tool \
numbers only: give the edge a number in `[tools.\"2.1\"]`. Four digits name a tool and its offset; both have to be the same."

T2008 Error "turning-variable-unset" "variable is read before it is set"
"What the control would take for a variable without a value differs. Assign a value first, hand it over in the call, or give a start value \
in `[variables]` of partc.toml."

T2009 Error "turning-formula" "formula cannot be computed"
"The formula divides by zero, takes the root of a negative number, or asks for something the manuals leave open, such as the integer part of a \
negative number. The block is not executed."

T2010 Error "turning-machine-variable" "variable belongs to the machine"
"The variable holds what the control measured or knows of the machine; a compiler cannot know it. Give its value in `[variables]` of partc.toml \
if it is the same for every part."

T2011 Error "turning-subprogram" "subprogram is not found, or not clear"
"L calls a subprogram of the same file by the name in its section SUBPROGRAM, or with V1 one in a file of its own. There is none of this \
name, or there are two. Without it the path is incomplete, so nothing is written."

T2012 Error "turning-recursion" "subprogram calls itself"
"A subprogram that calls itself, perhaps by way of another one, never ends. The control refuses it as well."

T2013 Error "turning-job-end-in-subprogram" "subprogram ends the job"
"A subprogram returns with RETURN. END or M30 inside it would end the job in the middle of the main program."

T2014 Error "turning-variable-scope" "variable of another program"
"The manuals disagree whether # variables with a plain number belong to one program or to all. The program reads one that another program \
set, so the result depends on that. Hand the value over in the L block, or use #c variables."

T2015 Note "turning-zero" "coordinates count from the workpiece zero of G59"
"G59 sets the workpiece zero in machine terms. The output has coordinates relative to the first G59 of the program: the work offset of the target \
has to be set there. Later shifts are computed into the coordinates."

T2016 Error "turning-shift" "zero shift is not clear"
"A zero shift moves everything that follows. Here its amount depends on something the program does not say, or on a rule that no manual at hand \
confirms. Write the coordinates without the shift, or put it in front of the first move."

T2017 Error "turning-family" "program is for another control than configured"
"MANUALplus 4110 programs have no sections; DIN PLUS and smart.Turn programs have them. The same words differ between the two: I of an arc is a \
diameter on the 4110 and a radius later. Set `[control] heidenhain_turning` in partc.toml to the control the program was written for."

T2018 Error "turning-m-unknown" "M function of the machine"
"M functions other than M0, M1, M3, M4, M5, M8, M9 and M30 belong to the machine builder. If the target has the same one, list it in \
`[output] pass_m`; otherwise remove it."

T2019 Error "turning-contour-reference" "contour reference is not found"
"NS and NE name the first and last element of a contour by their block numbers. No block of a geometry section has the number. Block numbers \
change when a program is renumbered: check the references."

T2020 Error "turning-case-fall-through" "branch of SWITCH without BREAK"
"A branch runs into the next CASE. Whether the control then goes on there or leaves the SWITCH no manual at hand says. End each branch with BREAK."

T2021 Error "turning-compensation" "nose radius compensation in the wrong place"
"G40, G41 and G42 need a straight move, exclude cycles and tool changes, and G41 and G42 cannot follow each other directly."

T2022 Error "turning-slide" "program for another slide"
"The program or the block is for a slide other than $1. Two slides work at the same time, which plain G-code for one slide cannot say."

T2023 Warning "turning-tool-data" "tool data of the program is not used"
"A line of the turret section holds data of a simple tool. partc takes tool data from partc.toml: add the tool there where a cycle or the \
compensation needs it."

T2024 Error "turning-tool-data-missing" "cycle needs data of the tool"
"Recessing cycles need the cutting width, the nose radius and the kind of the tool in the cutting position. Contour cycles need its nose radius and the \
position of its edge where the contour has a slope, an arc or walls that face each other: there the nose touches beside the programmed point. The program does \
not hold them: add them to `[tools]` in partc.toml."

T2025 Error "turning-side" "tool stands on the wrong side of the contour"
"Roughing removes what lies between the contour and the tool. Here the contour falls away from the tool, so the tool stands where the finished \
part will be, or it is not clear whether the cycle works outside or inside. Nothing is written: position the tool at the corner of the blank."

T2026 Note "turning-left-standing" "falling parts of the contour are left standing"
"Parts of the contour that fall behind a higher one can only be reached by plunging, which this cycle does not do as it is programmed. The cuts \
end as if the contour went on level. G810, G819, G820 and G829 cut these parts with a feed above 0 in E; else rough them with a cycle of their own."

T2027 Note "turning-nose-unknown" "nose radius of the tool is not known"
"Contour cycles compensate the radius of the nose. The program does not hold it. This contour lies along the axes, where the programmed point of the tool is \
exact, so it is printed; in inner corners the nose leaves its radius standing. A face that ends at X0 keeps a pip of that radius at the centre: the nose touches the face beside the programmed point. With a slope or an arc the cycle is refused (T2024). Add `radius` and `orientation` \
of the tool to `[tools]` in partc.toml."

T2028 Warning "turning-descending-feed" "feed on descending elements is partc's choice"
"Where E is missing the control lowers the feed on descending elements by up to a half, depending on their angle. partc takes half the feed on \
all of them. Program E to set it."

T2029 Note "turning-strokes-only" "recess is cut in strokes only"
"Retired: G86 without an oversize was not finished. Its strokes reach the floor, and walls, floor and chamfers are finished with an oversize or without."

T2030 Error "turning-flank" "flank of the tool does not clear a falling part"
"A part of the contour falls more steeply than the clearance angle of the tool: its flank would cut into the finished part behind its edge. Take another tool, \
or rough this part with a recess cycle."

T2031 Note "turning-flank-unknown" "clearance of the flank is not checked"
"Roughing goes down the falling parts of the contour, where the flank of the tool has to clear them. Its angle is not known: add `clearance` of the tool to \
`[tools]` in partc.toml to have it checked."

T2050 Error "turning-lone-return" "carriage return inside a block"
"A carriage return stands alone, without a line feed, in a file whose lines end with line feeds. Editors show what follows as a line of its own; \
partc and the control would read it as part of the same line, or of its comment. End the line with a line feed."

T2070 Error "turning-said-twice" "form or blank is described twice"
"A corner takes one undercut, an element one thread, and a part one blank. Here a second block describes the same one once more, and only one of \
the two can be meant. Remove the other."

T3001 Error "turning-undetermined" "element is not determined"
"The end, centre or direction of the element is left open, and the elements beside it do not fix it. B missing means a tangential transition, \
`B0` a corner; a line by angle is fixed by one coordinate or by the next element."

T3002 Error "turning-impossible" "geometry does not exist"
"No line or arc has all the programmed properties: a circle does not reach a line, two lines are parallel, or an angle never reaches the \
coordinate. Check the numbers of this block and the next one."

T3003 Error "turning-contour" "contour is not complete"
"A contour behind a cycle begins with `G0`, consists of G0 to G3, G12 and G13, and ends with a block that holds G80 alone."

T3004 Error "turning-form" "recess or undercut does not fit"
"A recess belongs to the straight element before it, an undercut to the corner between a line parallel to Z and one parallel to X. Its sizes \
have to fit on these elements."

T3005 Error "turning-contour-corner" "chamfer or rounding of a contour does not fit"
"The chamfer or rounding at the end of an element is larger than the element or its neighbour, or there is no corner. B is the radius, or with \
a minus sign the width of the chamfer."

T3006 Error "turning-contradiction" "values of an element contradict each other"
"The block says the same thing twice, and the two do not agree: an angle and an end point, a radius and a centre, or a tangential arc that would \
have to turn the other way."

T3050 Error "turning-form-in-the-air" "recess or undercut lies on the air side of the contour"
"An undercut relieves an inner corner, and a recess goes into the material. Here the tool works on the other side, where the undercut would be \
a bead and the recess a ring that no cut makes, and the part would not come out as it is drawn. Move the undercut into an inner corner, or \
correct the sign of the depth or the diameter of the floor."

T3051 Error "turning-contour-arc" "arc of a contour is not closed"
"The arc is given by its end and by its centre, and the distances of both ends from the centre differ by more than the controls accept \
(0.02 mm, `[control] arc_tolerance`). Check start, end, I and K; on the 4110 I counts on the diameter, on later controls on the radius."

T8001 Warning "turning-thread-left" "side of H of a thread is partc's reading"
"H1 shifts the cuts of a thread to the left, H2 to the right; to which end of the axis the left one lies is shown in a picture only. The last cut is not \
shifted, so the finished thread is the same either way, the load on the flanks is not."

T8002 Warning "turning-thread-face" "face of a transverse thread is partc's reading"
"G31 cuts threads in the front face and in the rear face with the same words. The edge position of the tool tells which one is meant; no manual at \
hand says that the control decides by it."

T8003 Warning "turning-simple-thread" "words of G32 are partc's reading"
"No manual at hand lists the words of G32. They are read as docs/turning.md says. Program G31 where its words are known."

T8004 Warning "turning-infeed" "infeed of G81 is partc's reading"
"Whether I of G81 counts on the radius or on the diameter no manual at hand says. The number of cuts depends on it, the finished contour does not."

T8005 Warning "turning-line-angle" "sense of an angle is partc's reading"
"The manuals show the angle A of a line in pictures, and their texts disagree whether it counts from -Z or from +Z. A contour printed in one of them \
is an ordinary shoulder only where it counts from -Z."

T8006 Warning "turning-arc-q" "solution of an arc is partc's reading"
"Where two arcs have the programmed values, Q chooses one. In earlier manuals Q0 is the far one, from software 7.1 on the near one."

T8007 Warning "turning-undercut-limit" "size of an undercut is partc's reading"
"The table of G85 has rows below and above 18 and 80 mm and none for these diameters themselves; of forms E and F over 3 to 10 mm manuals \
and DIN 509 have different radii. Give the sizes of the drawing with I, K and R, \
or say which row holds."

T8008 Warning "turning-undercut-side" "side of an undercut is partc's reading"
"G85 has no word for outside and inside. A tool above the cylinder cuts outside, one below inside; where it stands on the cylinder, its edge position \
tells: 3, 4 and 8 outside, 1, 2 and 6 inside. No manual at hand says that the control decides by it."

T8009 Warning "turning-contour-words" "contour in the words of G80 is partc's reading"
"The words of G80 that describe a contour are shown in pictures only. They are read as docs/turning.md says: AC and WC lean the walls about \
their rims, so that the recess opens."

T8010 Warning "turning-recess-blank" "blank oversize of G869 is partc's reading"
"RI says how far the blank stands above the rim of a recess. Whether it counts on the diameter, as the oversize I does, no manual at hand says. \
A tool that expects too little material would plunge too deep at once: compare the first plunge with the drawing."

T8011 Warning "turning-depth-compensation" "sense of R or RB of G869 is partc's reading"
"The compensation counteracts the bending of the tool while it turns the floor. It is taken to lift the tool, which never cuts too deep; no \
manual at hand gives the sign."

T8012 Warning "turning-offset-one-way" "offset width of one-way turning is partc's reading"
"B pulls the ends of turned cuts in where the tool changes from turning to plunging. One way (U1) there is no such change inside the material, \
so B has no effect; no manual at hand says so."

T8013 Warning "turning-recess-depth" "incremental I of G22 is partc's reading"
"I of G22 is a diameter, so its increment is taken as a difference of diameters. No manual at hand says so: with the other reading the recess is twice \
as deep."

T8014 Warning "turning-recess-width" "width of G23 is partc's reading"
"Where the flanks of a recess lean, K is its width at the surface or at its floor; this is shown in a picture only."

T8015 Warning "turning-recess-oversize" "oversize of G86 is partc's reading"
"The oversize of G86 is left until the finishing cut. Whether on the walls as well as on the floor no manual at hand says; on both never cuts too much."

T8016 Warning "turning-blank-contour" "contour of the blank is not used"
"The section BLANK draws the blank as a contour. The cycles of partc know bars, tubes and castings (G20, G21); of another blank they take that it reaches \
to where the tool stands when the cycle begins."

T8017 Note "turning-word-idle" "word changes nothing here"
"The word is known and does not change the path: the end of an element is given, so Q has nothing to choose; the run-in and run-out of G33 lie inside \
of the programmed thread. It is named because no word is left out in silence."

T8018 Warning "turning-finishing-side" "side of G41 and G42 behind G89 is partc's reading"
"The page of G89 prints G41 as right and G42 as left of the contour, the general page of the same manual the other way round. partc compensates the \
nose on the side on which the tool works: told by its edge position, else by where it stands."

T8019 Warning "turning-nose-path" "path beside a contour is partc's reading"
"The manuals at hand say when G41 and G42 begin to act, and not where the tool stands then. partc leads it straight to the point at a right angle beside the start of \
the contour, around outside corners on an arc of the nose radius, and from the point beside its end straight on, as other controls do."

T9001 Error "turning-function" "G function is not supported"
"The function is known by its name but not compiled, or it is not a function of these controls. Nothing is left out in silence: the program is refused."

T9002 Error "turning-keyword" "keyword or section is not supported"
"The word begins something that partc does not compile. Write the blocks out, or remove what is not needed."

T9003 Error "turning-formula-function" "function of a formula is not supported"
"Formulas know SQRT, SIN, COS, TAN, ASIN, ACOS, ATAN, ABS, INT, ROUND, LN, EXP, SQRTA and SQRTS, angles in degrees. Write the formula with these."

T9004 Error "turning-axis" "axis is not supported"
"Only X and Z of the first slide are compiled. C and Y axis machining, a second slide and a counter spindle need other moves."

T9005 Error "turning-compensation-resolve" "nose radius or edge position of the tool is not known"
"The path of G41 and G42 depends on the nose radius of the tool and on where its edge points to: the programmed point is the tip that touches both axes. \
Give `radius` and `orientation` of the tool in partc.toml, or set `[output] compensation = \"control\"` to print G41 and G42 and let the target compensate."

T9006 Error "turning-cycle" "cycle is not supported"
"The cycle is known, its parameters are checked, but partc does not make its moves. Nothing is written."

T9007 Error "turning-unconfirmed" "meaning is not confirmed by a manual"
"What this word means is shown in a picture only, or differs between manuals. Compiling it on a guess could cut in the wrong place, so it is refused."

}
