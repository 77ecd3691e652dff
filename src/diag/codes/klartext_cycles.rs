//! Klartext: machining cycles.

super::codes! { KLARTEXT_CYCLES:

K2941 Error "tip-angle-missing" "angle at the tip of the drill is not known"
"A depth that counts from a diameter (cycle 240 with Q343 or Q342), or from the full diameter of the drill (Q395), follows from the angle at \
its tip. Give `tip_angle` in `[tools.N]`, or the column T-ANGLE of the tool table; 180 degrees have no tip."

K8141 Note "klartext-cycle-way" "way of the tool in a cycle is partc's own"
"Manuals print what the cycle makes, and not every move of its way. partc makes a way of its own, described in docs/cycles.md, that reaches the programmed \
shape exactly and moves at rapid traverse where nothing stands. Compare it with the control where the way itself matters."

}
