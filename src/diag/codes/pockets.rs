//! Milling cycles: what all of them take, pockets and slots.

super::codes! { POCKETS:

G3321 Error "milling-no-room" "area has no path for the cutter"
"The sizes of a pocket or slot leave no path for the centre of the cutter: the cutter with the allowance is wider than the area, a corner is \
tighter than the cutter, or the rings computed for a contour did not stand the check of their distance to it. Check the sizes, the radius of the \
tool, the allowances and the infeeds."

S2241 Error "siemens-milling-radius" "milling cycle without a radius of the cutter"
"A milling cycle of the control computes the path of the cutter's centre from the radius in the tool memory. Give the radius of the tool in \
`[tools.N] radius`, or write `$TC_DP6` of the active edge in front of the call. Data that the program changes by `$P_AD`, and an edge that is in doubt \
between T and M6, do not count."

S8230 Warning "siemens-milling-left-open" "argument of a milling cycle is left open"
"The call leaves open what the control takes from elsewhere: the infeed in depth or in the plane, or the sense in which the spindle turns for climb \
and conventional milling. The message says what is taken. Give the argument, or program M3 or M4 in front of the call."

S8231 Note "siemens-milling-way" "path of a milling cycle is that of partc"
"The control promises the final shape, and how it gets there is not published or not confirmed. partc makes a path of its own that keeps the allowances and infeeds; \
docs/cycles.md describes it. Compare the path with what the machine does where the order of the cuts matters."
}
