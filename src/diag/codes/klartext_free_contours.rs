//! Klartext: free contours (FK).

super::codes! { KLARTEXT_FREE_CONTOURS:

K3001 Error "fk-open" "free contour is not determined"
"The contour ends, and the data of an element and of those behind it leave it open: a line needs two data, an arc three besides DR, one less where FLT or \
FCT says that it goes on tangentially. Data of later elements count where elements are solved together. Write one of the words that the help line names."

K3002 Error "fk-ambiguous" "free contour has several solutions"
"More than one contour fits all data up to the block that ends it, and they differ in this element. partc names where it would end. FSELECT does not help where the order \
in which controls count solutions is not known. Write the word that the help line names: it leaves one."

K3003 Error "fk-contradiction" "no element fits the data of a free contour"
"The data of this element and of those that it is solved with contradict each other: a line that misses its circle, an arc that turns the other way, or more data than is \
needed that does not agree within 0.001 mm or 0.001 degrees. Compare the words with the drawing."

K3004 Error "fk-reference" "free contour refers to something that is not known"
"RX, RY, RPR, RPA, RAN, RCCX, RCCY, RCCPR, RCCPA and PAR name the number of an FL, FLT, FC or FCT block, at most 64 elements back; all but PAR belong to the incremental word beside \
them. FLT, FCT and IAN need an element of the working plane directly in front. Write absolute values, or the number of the block that is meant."

K8022 Warning "fselect-observed" "choice of FSELECT is an observed one"
"No manual at hand says in which order a control counts the solutions that FSELECT chooses from. In a few situations it can be seen in printed programs with their drawings, and \
partc takes the same order there. Compare the path with the drawing. `[control] fselect = \"refuse\"` refuses such contours."

K8023 Warning "fk-cca-reading" "CCA of a free contour has two readings"
"Older manuals ask for CCA as the angle from the first axis to the end of the arc, seen from its centre; later ones print it as centre angle. Both fit here and lead to different \
places. partc takes the older reading. Choose with `[control] fk_cca`, or write the end point."

K8024 Warning "fk-reference-reading" "what a centre counts from is a reading"
"An incremental centre without a reference counts from the start of its arc here, and one with a reference to the block of an arc from the centre of that; PAR takes the direction in which an arc ends. No manual at hand says so. \
Write absolute coordinates of the centre to be sure."

K8025 Warning "fk-not-closed" "free contour is never closed"
"CLSD+ marks the first element of a closed contour, and no element with CLSD- ends it: the contour stays open where the last element ends. \
Write CLSD- in the last element, which takes its end point from the first one."

}
