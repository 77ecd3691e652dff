//! `G330` and `S22`, `S82`: stock removal in layers.

super::codes! { LAYERS:

G3301 Error "layers-approach" "no free way to where the cuts begin"
"The cycle travels at rapid traverse to a point in front of the blank and clear of it. From where the tool stands every way there leads through the \
blank or what lies below it. Position the tool in front of the blank before the cycle." {
    tool_stands_inside_of_blank()
        "the tool stands inside of the blank, or behind it: it cannot travel to where the cuts begin"
        help "position the tool in front of the blank, clear of it, before the cycle";
}

G3302 Error "layers-tool" "cutting edge points out of the material"
"The position of the cutting edge in the tool data says which way the nose points. For this cycle it has to point into the material, or along the \
cuts. Select the tool that belongs to the cycle, or correct its edge position." {
    cutting_edge_of_tool_points_out() "the cutting edge of the tool points out of the material"
        help "select a tool whose edge position fits the side that is machined";
}

G3303 Error "layers-limits" "limit of the area lies inside the blank"
"The cuts begin in front of the blank. Where a limit of the area lies on that side inside of the blank, the tool would have to plunge into full \
material. Set the limit in front of the blank, or machine the part in front of it first." {
    area_that_is_machined_begins_inside()
        "the area that is machined begins inside of the blank, so that the cuts cannot begin beside it"
        help "set the limit in front of the blank, or machine what lies there before";
}

G3304 Warning "cycle-cuts-nothing" "cycle cuts nothing"
"No move of the cycle is at a feed: nothing is left to cut at this depth, or between the blank and the part within the limits of the area. A limit on the wrong side, a blank \
smaller than the part or a wrong datum looks like this. Compare the arguments of the call with the contour." {
    cycle_cuts_nothing() "the cycle cuts nothing: it only travels there and back"
        help "compare the depth, or the blank, its allowances and the limits of the area, with the part";
}

S8210 Note "siemens-relief-left" "relief cut is left standing"
"The call says that parts which fall behind higher ones are not machined. They stay level with the higher part, in roughing and in finishing. Machine them by a call with \
relief cuts, or by a groove cycle." {
    relief_cut_from_is_left_standing(args, shown) "{args}: the relief cut from {shown} is left standing";
}

S8211 Note "siemens-relief-unchecked" "clearance of the tool in a relief cut is not checked"
"On the falling side of a relief cut the flank of the tool has to clear the part: the side may be at most as steep as the clearance angle of the \
tool. The tool data do not hold this angle, so nothing is checked here, as on a control where it is 0." {
    relief_cut(args, shown)
        "{args}: relief cut from {shown}: whether the flank of the tool clears its falling side is not checked";
}

S8212 Note "siemens-leaning" "leaning part is left to finishing"
"Cuts along an axis cannot get behind a part that leans over, such as the side of an undercut of form F. Roughing leaves the little that stands there; finishing along the contour removes it." {
    part_of_contour_leans_over(args) "{args}: a part of the contour leans over; roughing leaves it to finishing";
}

S8213 Warning "siemens-edge-points-back" "cutting edge points against the way of the cuts"
"The edge position in the tool data says that the programmed point lies behind the nose, seen along the cuts. The body of such a tool runs ahead of its nose, into whatever stands at the end of the cut. Check the edge position, or turn the direction of the cycle around." {
    cutting_edge_points_back(args)
        "{args}: the cutting edge points back, against the way of the cuts: the body of such a tool runs ahead of \
        its nose"
        help "check the edge position in the tool data, and the direction of the cycle";
}
}
