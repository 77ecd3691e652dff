//! `O`: what the target can and cannot say.

super::codes! { OUTPUT:

O1001 Error "feed-not-positive" "feed rate is zero or negative"
"A cutting move with F0 never ends, or raises an alarm. Look where the feed word or the parameter behind it is set; the F of a TOOL \
CALL, RND or CHF block counts, too."

O1002 Error "value-not-finite" "value is too large to print"
"A coordinate or feed is beyond 1000 km, or a computation overflowed. Nothing sensible can be printed, so nothing is. Look at the \
parameters that the block computes with."

O1003 Error "thread-lead-not-positive" "thread without a lead or a length"
"A thread is cut by moving the tool by its lead with every turn of the spindle. Here the lead or the whole way is zero, or too small \
or too large to print. Look where the lead is programmed."

O2001 Warning "m-function-of-target" "M function that means something on the target"
"`[output] pass_m` lets M functions through as they stand. The target has this one, too, and does with it what the text says, which is hardly \
what the machine of the program did. Take it out of `pass_m` and leave it out of the program, or make the target's machine do what is meant by another number."

O4001 Note "arc-as-lines" "arc is printed as straight lines"
"The arc is so small or so flat that its printed numbers cannot describe a circle within the tolerance of the target: \
after rounding, start and end lie at different distances from every possible centre. It is printed as lines that leave the arc \
by less than half a printed unit."

O4002 Note "arc-rounded-away" "arc is shorter than the last printed digit"
"Start and end of the arc print as the same numbers. A control would take that for a full circle, so the arc is left out; \
the path differs by less than the last printed digit."

O9001 Error "word-unknown-to-target" "the target has no word for this"
"The program asks for something that the selected target cannot express. Choose another target or change the program."

O9002 Error "spindle-speed-negative" "spindle speed is negative"
"The sense of rotation comes from M3 or M4, the speed is positive. Look where the S word or its parameter is set."

O9003 Error "compensation-by-target" "not possible under the target's radius compensation"
"With `[output] compensation = \"control\"` the target offsets the contour between G41 or G42 and G40. Meanwhile it takes no block in \
machine coordinates, no change of plane or side, no arc outside the working plane, and no contour that goes on behind a tool change or \
work offset; and it compensates in some planes only. The target would stop there with an alarm, so nothing is written. End the compensation before the block, \
or let partc compute the tool path with `compensation = \"resolve\"`."

O9190 Error "tool-length-not-along-z" "tool length does not act along Z"
"`[output] tool_length = \"G43\"` has the target add the length of the tool, and G43 adds it to Z with an ordinary tool table. Under G18 and G19, and with \
another tool axis in a TOOL CALL, the control counts it along another axis, so the tool would stand wrong by its length in both. Leave the key at \"off\" and set the \
length up on the target."

O9100 Error "compensation-way-too-short" "move to or from the compensated contour is shorter than the tool radius"
"With `compensation = \"control\"` the target compensates the radius of the tool, and it takes the way to the contour only if that is longer \
than the radius. A way from the contour shorter than the radius ends with the tool over the contour. The radius is known from `[tools]`, the tool \
table, TOOL DEF or an oversize. Program the block farther from the contour."

}
