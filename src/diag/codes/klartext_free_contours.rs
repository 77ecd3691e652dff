//! Klartext: free contours (FK).

super::codes! { KLARTEXT_FREE_CONTOURS:

K3001 Error "fk-open" "free contour is not determined"
"The contour ends, and the data of an element and of those after it leave it open: a line needs two data, an arc three besides DR, one less where FLT or \
FCT says that it goes on tangentially. Data of later elements count where elements are solved together. Write one of the words that the help line names." {
    behind_it_lie_on_one_straight(names, names2, x, y)
        "{names} and the {names2} after it lie on one straight, and no datum says where on it the one ends and the \
        other begins"
        help "write {x} of the end, {y} of the end or LEN into the first of the two, or make one line of them";
    one_datum_is_missing(name)
        "{name} is not determined: one datum is missing in this block or in those after it";
    data_are_missing(name, missing)
        "{name} is not determined: {missing} data are missing in this block or in those after it";
}

K3002 Error "fk-ambiguous" "free contour has several solutions"
"More than one contour fits all data up to the block that ends it, and they differ in this element. partc names where it would end. FSELECT does not help where the order \
in which controls count solutions is not known. Write the word that the help line names: it leaves one." {
    has_solutions_that_fit_all_data(item, candidates, ends, chosen, deciding)
        "{item} has {candidates} solutions that fit all data up to the end of the contour; it ends in {ends}{chosen}"
        help "write {deciding} into this block";
}

K3003 Error "fk-contradiction" "no element fits the data of a free contour"
"The data of this element and of those that it is solved with contradict each other: a line that misses its circle, an arc that turns the other way, or more data than is \
needed that does not agree within 0.001 mm or 0.001 degrees. Compare the words with the drawing." {
    no_fits_its_data(name, why, by) "no {name} fits its data and that of its neighbours: {why}{by}"
        help "check the words of this block and of the blocks that it is solved with";
}

K3004 Error "fk-reference" "free contour refers to something that is not known"
"RX, RY, RPR, RPA, RAN, RCCX, RCCY, RCCPR, RCCPA and PAR name the number of an FL, FLT, FC or FCT block, at most 64 elements back; all but PAR belong to the incremental word beside \
them. FLT, FCT and IAN need an element of the working plane directly before it. Write absolute values, or the number of the block that is meant." {
    fselect_chooses_solution_of_element_in_front()
        "FSELECT chooses a solution of the element before it, and there is none"
        help "write it after an FL, FLT, FC or FCT block";
    refers_to_block_that_is_no_fl(text)
        "`{text}` refers to a block that is no FL, FLT, FC or FCT block of the last 64 before it"
        help "write the number of such a block; where it was removed or renumbered, write absolute values";
    names_block_by_its_number(text) "`{text}` names a block by its number, and the blocks before it have none"
        help "number the blocks of the program, as the control shows them, or write absolute values";
    refers_to_one_of_several_blocks(text) "`{text}` refers to one of several blocks with this number"
        help "number the blocks anew, and name the block that is meant";
    belongs_to_incremental_word(text) "`{text}` belongs to an incremental word, and there is none in this block"
        help "write the word that it belongs to with I: `IX+20 RX 13`";
    direction_of_element_before_is_not_known() "the direction of the element before is not known here"
        help "write AN, or program a line or an arc of the working plane directly before it";
}

K8022 Warning "fselect-observed" "choice of FSELECT is an observed one"
"No available manual says in which order a control counts the solutions that FSELECT chooses from. In a few situations it can be seen in printed programs with their drawings, and \
partc takes the same order there. Compare the path with the drawing. `[control] fselect = \"refuse\"` refuses such contours." {
    has_several_solutions(item, unwrap_or_default)
        "{item} has several solutions; FSELECT {unwrap_or_default} is taken as printed programs count them"
        help "compare the path with the drawing, or write a word that leaves one solution";
}

K8023 Warning "fk-cca-reading" "CCA of a free contour has two readings"
"Older manuals ask for CCA as the angle from the first axis to the end of the arc, seen from its centre; later ones print it as centre angle. Both fit here and lead to different \
places. partc takes the older reading. Choose with `[control] fk_cca`, or write the end point." {
    cca_is_read_as_direction_of_end(angle, shown, shown2)
        "CCA {angle} is read as the direction of the end from the centre, which leads to {shown}; as the angle that \
        the arc sweeps it would lead to {shown2}"
        asks "choose with `[control] fk_cca = \"end-angle\"` or \"sweep\", or write the end point";
}

K8024 Warning "fk-reference-reading" "what a centre counts from is a reading"
"An incremental centre without a reference counts from the start of its arc here, and one with a reference to the block of an arc from the centre of that; PAR takes the direction in which an arc ends. No available manual says so. \
Write absolute coordinates of the centre to be sure." {
    no_manual_at_hand_says(text, what) "`{text}` {what}: no available manual says so";
}

K8025 Warning "fk-not-closed" "free contour is never closed"
"CLSD+ marks the first element of a closed contour, and no element with CLSD- ends it: the contour stays open where the last element ends. \
Write CLSD- in the last element, which takes its end point from the first one." {
    no_clsd_closes_contour_that_begins_here() "no CLSD- closes the contour that begins here";
    no_clsd_closes_contour_that_begins() "no CLSD- closes the contour that begins here"
        help "write CLSD- in the last element of the first one, or remove one CLSD+";
}

}
