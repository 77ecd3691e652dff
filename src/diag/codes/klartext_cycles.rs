//! Klartext: machining cycles.

super::codes! { KLARTEXT_CYCLES:

K2941 Error "tip-angle-missing" "angle at the tip of the drill is not known"
"A depth that counts from a diameter (cycle 240 with Q343 or Q342), or from the full diameter of the drill (Q395), follows from the angle at \
its tip. Give `tip_angle` in `[tools.N]`, or the column T-ANGLE of the tool table; 180 degrees have no tip."

K2942 Error "tool-radius-too-small" "tool is too small for the cycle"
"Cycle 208 makes a hole of at most twice the diameter of the tool, unless Q342 says that it is drilled already; the control refuses a larger one. Cycle 265 \
mills a thread from the solid, and a small tool would leave a core in its middle. Cycles 210 and 211 want a third of the width of the slot at least; 213 and 215 \
go round once, which takes off the diameter of the tool. Take a larger tool, or drill first."

K2943 Error "global-def-unreadable" "GLOBAL DEF cannot be read"
"GLOBAL DEF gives values to parameters that a later cycle takes by PREDEF. Its number says which parameters it has: 100 general, 105 drilling, 110 pockets, \
111 contours, 120 probing. Write `GLOBAL DEF 100 GENERAL` and behind it `Q200=+2`, each behind a `~`."

K2944 Error "predef-without-value" "PREDEF finds no value"
"The cycle takes a parameter by PREDEF, and no GLOBAL DEF before it gives that parameter a value. Programs from the control often have the GLOBAL DEF in a program that \
calls this one: write it in front of the cycle, or the value in place of PREDEF."

K2948 Error "datum-table-unreadable" "row of a datum table cannot be used"
"A datum table has `BEGIN NAME.D MM`, a line with the names of its columns (NR X Y Z …), a row a line and `[END]`. The row needs values for X, Y and Z (0 where the \
datum stays in place), its unit is that of the program, and a rotation or a value in a column that partc does not know is refused."

K2945 Error "point-table-unreadable" "point table cannot be read"
"SEL PATTERN names a point table: `BEGIN NAME.PNT MM`, a line with the names of the columns (NR X Y Z FADE CLEARANCE), one place a line, `[END]`. The values \
stand under their columns. A line with as many words as the table has columns may stand beside them; any other word that \
does not stand under one name is refused. A place with FADE Y is left out, CLEARANCE is a height at which the tool goes to the place and from it."

K2946 Error "tangent-behind-cycle" "tangential arc directly behind a cycle"
"CT and CTP go on in the direction of the element in front of them. Behind a cycle call that would be some way of the cycle, which manuals do not print. Put a line \
or an arc of the contour between the two, or give the circle by its centre or its radius."

K2947 Error "cycle-of-another-unit" "cycle is called in a program of another unit"
"The parameters of a cycle are numbers without a unit. A cycle that a program in MM defines, and a called program in INCH runs, or the other way round, would be made with \
lengths of the wrong size, and no manual says which unit counts. Define the cycle in the program that calls it."

K8141 Note "klartext-cycle-way" "way of the tool in a cycle is partc's own"
"Manuals print what the cycle makes, and not every move of its way. partc makes a way of its own, described in docs/cycles.md, that reaches the programmed \
shape exactly and moves at rapid traverse where nothing stands. Compare it with the control where the way itself matters."

K8142 Warning "stroke-of-q202" "Q202 of a slot has two readings"
"Cycles 210 and 211 go to and fro along the slot and fall by Q202, and the manual does not say whether each stroke falls by it, or a stroke to and one fro \
together. partc lets each stroke fall by Q202. `[cycles] q202 = \"stroke\"` says so, `\"pair\"` halves the fall of a stroke; the finished slot is the same."

K9040 Error "cycle-needs-a-choice" "cycle needs a choice in the configuration"
"Manuals at hand do not settle what the control does here, and a wrong guess would spoil the part. The message names the key in `[cycles]` of partc.toml that \
settles it; docs/cycles.md says what each value does."

}
