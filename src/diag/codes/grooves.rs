//! Grooves and cut-off.

super::codes! { GROOVES:

S8221 Note "siemens-groove-allowance" "allowance on the flanks is reduced"
"With its allowance the groove is narrower than the tool, without it the tool fits. The allowance on the flanks is made as large as the tool leaves room \
for. Take a narrower tool, or no allowance on the flanks." {
    tool_of_mm_leaves_no_room(args, width, shown)
        "{args}: the tool of {width} mm leaves no room for the allowance on the flanks, which is reduced to {shown}"
        help "take a narrower tool, or no allowance on the flanks";
}

S8222 Warning "siemens-groove-dwell" "dwell of a groove cycle is left out"
"CYCLE930 waits at the floor of the groove for turns of the spindle, and no speed is known from which their time follows. Program S before the call, \
or say by `[cycles] groove_dwell = false` that the machine does not wait." {
    cycle930_waits_at_floor_for_turns()
        "CYCLE930 waits at the floor for turns of the spindle, whose speed is not known: no dwell is printed"
        asks "program S before the cycle, or set `[cycles] groove_dwell = false`";
}

S8223 Note "siemens-second-edge" "second edge of a groove tool is computed"
"The call names the offset of the second cutting edge. The target has one offset a tool, so that partc leads the second corner by the cutting width \
of the tool table instead." {
    control_partc_computes_it_from_cutting_width(args, what, place)
        "{args}: the control {what} (`_DN`, argument {place}); partc computes it from the cutting width, and D stays"
        help "check that the cutting width in the tool table is that of the tool";
}

S8224 Warning "siemens-cut-off-reference" "what a cut-off puts at its Z"
"The programmed corner of the tool lies on the side away from the workpiece. Whether CYCLE92 puts this corner at Z0 or the one that makes the face is \
not confirmed: partc takes the corner on the side of the workpiece. Set `[cycles] cutoff_reference` to \"workpiece\" or \"tip\"." {
    cycle92_z0_is_taken_for_corner(width)
        "CYCLE92: Z0 is taken for the corner on the side of the workpiece, so that the programmed corner is printed \
        {width} mm beside it"
        asks "set `[cycles] cutoff_reference` to \"workpiece\" or \"tip\"";
}

}
