//! Milling cycles: faces, spigots, paths along contours, threads.

super::codes! { MILLING:

G3331 Error "milling-no-path" "milling cycle has no path for the cutter"
"The sizes of a face, spigot, contour or thread leave no path on which the cutter keeps its distance, or they would make more cuts than any tool makes. \
The message names the argument. Look for a lost decimal point, take a smaller cutter, or give a larger infeed."
}
