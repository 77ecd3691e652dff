//! Milling cycles: faces, spigots, paths along contours, threads.

super::codes! { MILLING:

G3331 Error "milling-no-path" "milling cycle has no path for the cutter"
"The sizes of a face, spigot, contour or thread leave no path on which the cutter keeps its distance, or they would make more cuts than any tool makes. \
The message names the argument. Look for a lost decimal point, take a smaller cutter, or give a larger infeed." {
    straight_way_back_to_start_of_contour()
        "the straight way back to the start of the contour, in its depth, cuts into it"
        help "retract the tool at the end of the contour";
    way_to_contour() "the way to the contour, or from it, cuts into the contour elsewhere"
        help "give a smaller radius or length of the way, or another shape of it";
    bore_makes_no_path(fault) "{fault}" help "check the sizes of the hole, the infeed and the cutter";
    spigot_makes_no_path(fault) "{fault}" help "check the sizes of the spigot and the data of the cutter";
    face_makes_no_path(fault) "{fault}" help "check the sizes of the face and the data of the cutter";
    contour_makes_no_path(fault) "{fault}" help "check the contour, and the data of its approach";
    surface_makes_no_path(fault) "{fault}" help "check the corners of the surface and the data of the cutter";
    thread_makes_no_path(fault) "{fault}" help "check the sizes of the thread and the data of the cutter";
}

S8240 Warning "siemens-spigot-stock" "part of the blank of a spigot stays"
"CYCLE76 and CYCLE77 go round once on each level, as wide as the cutter: a blank that stands out by more than the allowance and the diameter of the cutter keeps a ring outside. \
Later moves may run into it. Call the cycle several times with smaller and smaller allowances, the outermost first, and give each call the blank that the one before leaves." {
    tool_goes_round_once(args, stays, what, args2, place)
        "{args}: the tool goes round once, and leaves {stays:.3} mm {what} `{args2}` (argument {place}) standing \
        outside"
        help "call the cycle several times with smaller and smaller `_FAL`, each with the blank that the one before leaves";
}

}
