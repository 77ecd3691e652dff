//! Grooves and cut-off.

super::codes! { GROOVES:

S2221 Error "siemens-groove-tool" "groove cycle without the data of its tool"
"A groove is cut with the whole edge of the tool: its cutting width, the radius of its corners and the corner that is programmed (the cutting-edge \
position) have to be known. Give `width`, `radius` and `orientation` under `[tools.N]`; radius and position count, too, where the program writes \
`$TC_DP6` and `$TC_DP2` of the active edge in front of the call."

S8220 Note "siemens-groove-way" "path of a groove cycle is that of partc"
"The control promises the final shape, and how it gets there is not published or not confirmed. The message names how the arguments are read and how the \
plunges are placed; docs/cycles.md describes the whole path. Compare it with what the machine does where the order of the cuts matters."

S8221 Note "siemens-groove-allowance" "allowance on the flanks is reduced"
"With its allowance the groove is narrower than the tool, without it the tool fits. The allowance on the flanks is made as large as the tool leaves room \
for. Take a narrower tool, or no allowance on the flanks."

S8222 Warning "siemens-groove-dwell" "dwell of a groove cycle is left out"
"CYCLE930 waits at the floor of the groove for turns of the spindle, and no speed is known from which their time follows. Program S in front of the call, \
or say by `[cycles] groove_dwell = false` that the machine does not wait."

S8223 Note "siemens-second-edge" "second edge of a groove tool is computed"
"The call names the offset of the second cutting edge. The target has one offset a tool, so that partc leads the second corner by the cutting width \
of the tool table instead."

S8224 Warning "siemens-cut-off-reference" "what a cut-off puts at its Z"
"The programmed corner of the tool lies on the side away from the workpiece. Whether CYCLE92 puts this corner at Z0 or the one that makes the face is \
not confirmed: partc takes the corner on the side of the workpiece. Set `[cycles] cutoff_reference` to \"workpiece\" or \"tip\"."

S8225 Note "siemens-cut-off-way" "path of a cut-off is that of partc"
"The control promises the edge and the cut; how it cuts the edge is not published. partc plunges in front of it, so that the edge is cut on one side only. \
From the diameter of the reduced feed on the speed is constant, and it stays so behind the cycle."
}
