//! `L1`: rules over what a program does, in every language.

super::codes! { LINT_MOTION:

L1001 Warning "spindle-off" "tool cuts while the spindle stands"
"A move at feed begins while the spindle stands: it was stopped, or nothing has started it since the first tool came. The tool breaks, or the part is \
pushed out of its clamping. Start the spindle (M3, M4) before the tool touches the part. Said once for each time that the spindle stands; a program \
without any tool change and without any spindle word is taken for a part of another one. A retract along the tool axis is no cut."

L1002 Warning "spindle-without-speed" "spindle starts and no speed was given"
"M3 or M4 comes before any S word. The control starts the spindle at the speed that the program before has left, or not at all. Program S with the \
tool call or beside M3."

L1003 Note off "tool-without-speed" "tool cuts at the speed of the one before"
"A tool was changed in, and it cuts without an S of its own: at the speed of the tool before. For a smaller tool that is too slow, for a larger one \
perhaps much too fast. Give each tool its speed. Off by default: some shops give the speed once for tools of one size."

L1004 Warning "tool-unused" "tool is called and does nothing"
"A tool is changed in, and the next tool or the end of the program comes before it has cut anything. A call was left over, or the moves of this tool got \
lost. A last tool that is put in for the next part, tool 0, and tools that only move at rapid (feelers, stops) can be meant: suppress the finding there."

L1005 Warning "tool-called-again" "tool that is in the spindle is called again"
"The same tool is called twice and nothing moves between the two calls. The second call was meant for another tool, or is left over; on machines without a \
check the changer puts the tool away and fetches it again. TOOL CALL of a HEIDENHAIN control with the number of the tool in the spindle, and T of HEIDENHAIN \
turning, change nothing then, and nothing is said."

L1006 Warning "rapid-into-blank" "rapid move ends inside the blank"
"A move at rapid traverse ends inside the blank that BLK FORM describes, deeper than anything was cut before; on a lathe, inside the bar of G20, where nothing was cut before. At rapid traverse the tool does not cut: it \
breaks, or moves the part. Stop above the part and go down at feed. The coordinates of the blank are taken as those of the active datum; after a change \
of the datum nothing is said. `[lint] blank` gives the blank of programs that describe none."

L1007 Warning "cut-below-blank" "tool cuts far below the blank"
"A cutting move goes more than 5 mm below the lower side of the blank that BLK FORM describes: into the vice, the parallels or the table, or the blank is \
described wrong. Tips of drills and chamfers need some way below the part, so up to 5 mm nothing is said. Said once for each tool."

L1009 Note off "coolant-left-on" "program ends and nothing turned the coolant off"
"M7 or M8 was on, and the program ends without M9. Most controls turn the coolant off at M30; where the program is called by another one, or ends without \
M30, it runs on. Off by default."

L1010 Note off "cut-without-coolant" "tool cuts without coolant where others have it"
"The program uses coolant, and this tool cuts while none is on. M8 may be missing behind a tool change. Off by default: some tools are meant to cut dry. Said \
once for each tool."

L1011 Warning "dwell-zero" "dwell takes no time"
"A dwell of 0 seconds does nothing, and some controls read 0 as another value. A parameter was not set, or a digit is missing. \
Where P2021 has said already that nothing sets the variable, it is not said again."

L1012 Warning "dwell-long" "dwell takes more than a minute"
"A dwell of more than 60 seconds is most often one in other units: `G4 F500` waits 500 seconds on a SINUMERIK, not milliseconds. With the tool on the part it \
burns; in any case the machine seems to hang."

L1013 Warning "coordinate-far" "coordinate is farther out than machines reach"
"A linear axis goes farther than 10 m from the zero of the workpiece. A decimal point is missing, or a parameter has a wrong value. Where the travel of the \
machine is known, `[machine] limits` says it exactly, and the error G3018 takes the place of this warning. Said once for each axis."

L1014 Note off "plunge-at-milling-feed" "tool plunges at the feed of milling"
"The tool goes straight down at feed, and the move behind it cuts sideways at the same feed. End mills take far less along their axis: plunge at a third of \
the feed, ramp, or go in by a helix. Off by default: wherever the tool goes down beside the part it is right."

L1015 Warning "feed-tiny" "feed is below 1 mm per minute"
"A cutting move goes at less than 1 mm per minute. The number is most often meant per revolution (`F0.2` under G94 instead of G95), or a decimal point is in \
the wrong place: the machine seems to stand. Said once for each feed."

L1016 Warning "feed-huge" "feed is larger than tools take"
"A cutting move goes at more than 5 mm per revolution, or at more than 50 m per minute. The number is most often meant in the other unit (`F200` under G95 \
instead of G94), or a decimal point is missing. Threads are cut with their lead and are not meant. Said once for each feed."

L1017 Warning "speed-huge" "spindle speed is zero, or higher than spindles turn"
"A tool cuts at a speed of 0, or a spindle is to turn at more than 100,000 revolutions per minute. A parameter was not set, a decimal point is missing, or a cutting speed was \
written as a speed. What the machine really reaches is for its own limits."

L1018 Warning "change-at-feed-end" "tool is changed, or the program ends, where the last cut ended"
"The last move before a tool change or before the end of the program was a cutting move: the tool still stands where it cut. Some machines retract by \
themselves, others turn the changer or open the door with the tool in the part, and the next program starts with a rapid move out of it. \
Retract before it. On lathes, whose tools leave the part in any direction, nothing is said."

L1019 Note off "rapid-slanting-down" "rapid move goes down and sideways at once"
"One block moves the tool down and sideways at rapid traverse. Controls move each axis as fast as it goes, so the way is no straight line, and a clamp that the \
straight line misses may be hit. Position in the plane first, then go down. Off by default: post-processors write such blocks high above the part."

L1020 Warning "spindle-counter-clockwise" "milling tool cuts with the spindle turning left"
"On a milling machine a tool cuts while M4 turns the spindle counter-clockwise. Nearly all tools cut clockwise: turning left they rub, burn and break. Left-handed \
tools are rare enough to suppress this finding for them. Tapping out is no cut of this kind. Said once for each tool."

L1022 Warning "cut-before-first-tool" "program cuts before it calls its first tool"
"The program calls tools, and cuts before the first call: with whatever the program before has left in the spindle. A tool call is missing, or stands too far \
behind. A program that calls no tool at all is taken for a part of another one."

L1023 Warning "tool-data-missing" "tool table has no radius or no length of a tool"
"The tool is in the table that `[tools]` names, and the table has neither a radius nor a length for it. On the machine a tool of length 0 goes as deep as the \
spindle nose is programmed: into the part. Measure the tool, and fill in the table."

L1024 Note off "arc-tiny" "arc has a radius below 0.005 mm"
"An arc is so small that the machine cannot make it: a rest of a post-processor, or a radius in the wrong unit. Off by default."

L1025 Note off "plane-left-changed" "program ends in another working plane than G17"
"On a milling machine the program ends while G18 or G19 holds. A program that follows, or a restart in the middle, may trust in G17. Off by default: controls \
reset the plane at the end of a program."

L1026 Warning "cut-behind-centre" "turning tool cuts far behind the centre"
"On a lathe a cutting move goes more than 5 mm behind the turning axis (radius below -5). Facing goes a little past the centre; farther out a sign or a \
shift is wrong, and the tool cuts with its back. Machines with tools behind the centre count X the other way round; suppress the finding for \
them. Said once for each tool."

L1027 Warning "cutting-speed-unlimited" "constant cutting speed without a limit of the speed"
"G96 keeps the cutting speed constant, so the spindle turns the faster the nearer the tool comes to the centre, up to what the machine can do. Without LIMS= or \
G26 a part or a chuck that is not made for it flies out. Program a limit that part, chuck and bar take."

L1028 Note off "retract-at-feed" "tool is lifted far at feed"
"The tool goes up more than 50 mm at a cutting feed. That takes time and does nothing; FMAX or G0 may have been meant. Off by default: behind reamers and \
boring tools it is right."

L1029 Warning "stop-in-cut" "program stops where the last cut ended"
"M0 stops the machine right behind a cutting move that did not lift the tool. The tool stays on the part, on many machines while the spindle runs down, and \
leaves a mark or breaks at the start. Retract before the stop. On lathes nothing is said."

L1030 Warning "offset-while-compensated" "work offset changes while radius compensation is on"
"A work offset is selected while G41, G42, RL or RR holds. Where the compensated path goes between the two zeros is nobody's intention, and controls differ in \
it. End the compensation first."

L1031 Warning "spindle-reversed" "spindle changes its sense where the last cut ended"
"The spindle changes from M3 to M4, or back, while the tool stands where its last cut ended. It runs through standstill in the material. Retract before it; a tap \
is driven by its cycle. On lathes nothing is said."

L1032 Warning "blank-untouched" "no move reaches the blank"
"The program describes a blank, and all of its cuts are outside it. The blank stands elsewhere than the part, most often because one of them was moved to another \
zero. A tool has a radius and a length: a cut within 100 mm of the blank counts as one that reaches it. The path does not depend on it; every simulation and `partc`'s own rules about the blank do."

L1033 Warning "feed-outlier" "feed is far from the one before"
"Two cuts of one tool that follow each other sideways differ in their feeds by a factor of more than 200. One of the two numbers has its decimal point in the \
wrong place, or is in another unit."

L1034 Warning "drill-cuts-sideways" "drill or tap cuts sideways"
"The tool table says that this tool is a drill or a tap, and it moves sideways at feed below the height from which it last went down. It breaks. Either the wrong \
tool is called, or the retract is missing. Said once for each tool."

L1035 Warning "pitch-implausible" "tap or thread has a pitch that no thread has"
"A tap in a compensating chuck goes as far in a turn as F and S make it go, and here that is less than 0.1 mm or more than 8 mm; a thread that is cut in step with the \
spindle has a pitch below 0.05 mm or above 100 mm. Most often F holds the pitch and G94 is in force (`F1.5` is 1.5 mm per minute), or F is mm per minute \
under G95. The tap breaks. Under G94 program F as pitch times speed, under G95 the pitch. Taps are known by the cycle, by G63, and by `kind = \"tap\"` in the tool table."

L1036 Warning "thread-crossed" "pass crosses the thread that the pass before has cut"
"Two passes lie in one thread, and the second makes a helix of the other hand: it goes the other way while the spindle turns as before, or the same way while the \
spindle turns the other way. A tap that comes out so tears the thread or breaks; a turned thread is destroyed. Reverse the spindle (M3, M4) for the way out of a \
tapped hole; return beside a turned thread at rapid. Cycles reverse the spindle by themselves."

L1037 Warning "cut-beside-blank" "tool cuts far beside the blank"
"A cutting move goes more than 150 mm beyond the sides of the blank. A digit or a sign is wrong, the zero is that of another part, or the blank is described \
wrong. Tools, and their ways in and out, need some room beside the part, so up to 150 mm nothing is said. Said once for each tool; after a change of the datum \
nothing is said."
}
