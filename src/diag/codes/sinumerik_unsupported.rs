//! `S9`: words of SINUMERIK programs that are not compiled.

super::codes! { SINUMERIK_UNSUPPORTED:

S9001 Error "siemens-unsupported" "not supported"
"The word changes how the machine moves in a way that plain G-code cannot say, or that is not built. Replace it by plain moves."

S9002 Error "siemens-interpolation" "interpolation that plain G-code cannot say"
"Splines, polynomials, involutes, threads of changing lead and taps that a frame turns have no word in plain G-code. Have the CAM system put out lines and arcs."

S9003 Error "siemens-iso" "ISO dialect"
"G291 and ISOCALL switch to ISO dialect, which is another language with other rules. Translate that part, or compile it by itself."

S9004 Error "siemens-synchronized" "synchronized action"
"WHEN, WHENEVER, EVERY, FROM, DO, ID and IDS run beside the program, as signals of the machine come. What they would do cannot be known here. Those that set outputs, markers or the feed only are left out by \
`[control] synchronized_actions = \"leave-out\"`; those that move axes, act on the spindle or call a program never."

S9005 Error "siemens-cycle" "cycle is not supported"
"The cycle or procedure of the control is known by name and not built. Nothing is left out in silence, so the program is refused. Where a key leaves it out, the message names it."

S9006 Error "siemens-transformation" "transformation is not supported"
"TRAORI, TRAANG, CYCLE800 and others turn programmed coordinates into other axes, which needs the kinematics of the machine. TRANSMIT and TRACYL are \
compiled where `[cycles] transmit` says how they are printed: \"polar\" with X and the rotary axis, \"cartesian\" as the program sees them."

S9007 Error "siemens-other-spindle" "word for another spindle"
"Threads, tapping and G96 follow the master spindle (SETMS); the target follows its first one, so they are refused while another is the \
master. Speed, sense of rotation and stop at an angle of further spindles are printed where the target has words for them."

S9008 Error "siemens-axis-motion" "axis motion that cannot be printed"
"Positioning axes that run beside the path, and approaches of machine-fixed points, need data of the machine. Reference and fixed points can be \
given under [machine]."

S9009 Error "siemens-feed-kind" "kind of feed that cannot be printed"
"G931 and the feeds that are kept at a switch cannot be printed. Under G93 F is the time of its own block: roundings, chamfers, cycles and \
radius compensation have no share of it. Program the feed by G94 or G95."

S9010 Error "siemens-resolve" "tool-centre path cannot be computed"
"The path of the tool centre needs the radius of the tool, on lathes also the position of its cutting edge, and rules that are published: compensation in space, approaches on polynomials \
(KONTT, KONTC) and the curves of DISC are not. Tool data come from partc.toml or from `$TC_DP` of the program. With `[output] compensation = \"control\"` the contour is printed with G41 and G42."

S9011 Error "siemens-machine-coordinates" "cannot be printed in machine coordinates"
"Under G53, G153, SUPA and G500 only straight absolute moves can be printed. Look at the word that is marked, and at the value behind it."

S9012 Error "siemens-thread-start" "start angle of a thread"
"The target starts every thread at the same angle of the spindle. SF= is made by a start that lies farther back along the thread by lead · angle / 360; \
in a chain of threads, behind a chamfer or rounding and in a turned or scaled frame that cannot be done. Shift the start point in the program."

S9101 Error "siemens-modulo-shift" "sense of a modulo axis under a shift"
"An absolute position of a rotary axis that counts modulo 360 degrees is reached inside the turn in which the axis stands. Where its zero is shifted \
(TRANS, `$P_UIFR`) the turn begins elsewhere in the program than on the machine, so the sense of rotation is not known. Write DC, ACP or ACN, or \
set `[control] md30455 = \"shortest\"` if the machine takes the short way."

S9102 Error "siemens-tool-length" "length of the tool is not known"
"G53, G153 and SUPA place the tip of the tool on a SINUMERIK control (MD 10760 = 0), and the nose of the spindle on the target; SUPD does the \
opposite. With `tool_length = \"G43\"` the length of the tool is added, so it has to be known: give it under [tools] or write `$TC_DP3`. On lathes \
it is never known. Under D0, or with `[control] md10760 = true`, no length counts."

S9103 Error "siemens-setting" "setting datum is changed"
"Setting data (`$SC_…`, `$SN_…`) change what other words of the program do. Those that partc knows are followed; this one is not. If the machine has the \
value anyhow, say so under [variables], and the block is left out."

S9013 Error "siemens-oblique-circle" "circle stands obliquely in space"
"Plain G-code has circles in the main planes only. Look at the word that is marked, and at the value behind it."

S9014 Error "siemens-offset-unknown" "work offset has no counterpart"
"The selected target has fewer work offsets. Say which one stands for this: `[datums] G510 = \"G55\"`."

S9015 Error "siemens-cycle-variant" "variant of a cycle is not supported"
"The cycle is built, but not this variant of it, or the meaning of a coded argument is not confirmed. Use the plain variant, or plain moves."

S9016 Error "siemens-offsets-off" "move without tool offsets"
"D0 switches the offsets of the tool off, so that positions count for the spindle nose. The target knows positions of the tool tip only. \
Moves in machine coordinates (SUPA, G53, G500) can be printed."

S9017 Error "siemens-mixed-offsets" "work offset of the program beside one of the machine"
"A work offset that the program writes ($P_UIFR) is put into the coordinates, which then count from the basic system. Offsets that it only \
selects are those of the machine, whose values are not known. Between the two no way can be computed. Use the one kind or the other."

S9018 Warning "siemens-save-offset" "SAVE and a changed work offset"
"A program with SAVE changed the frame of the work offset that is in force before and after it. Bit 0 of machine datum 10617 decides whether the frame of the \
call comes back; it is read as 0: the frame stays. Set `[control] md10617`, or select the offset again in the calling program."

S9019 Error "siemens-contour-open" "stored contour cannot be made"
"The NC blocks of a contour of the contour editor are missing, and its hidden records leave elements open. Open the contour in the editor \
of the control and accept it again."

S9020 Error "siemens-contour-cycle" "contour cycle is not supported"
"The arguments of the cycle were read and its contour was run and checked, so what is reported about them is true. But the tracks of the cycle are \
computed inside the control and are not published. Replace it by plain moves, or have the CAM system put them out."

S9021 Error "siemens-edge-length" "edge of another length than D1"
"The target has one length for a tool and prints the positions of the program. Of an edge whose length is another one ($TC_DP3 to $TC_DP5) they would be off by the difference. \
Give the edge a tool number of its own."

S9130 Error "siemens-left-out-position" "position that only an axis that is left out makes"
"Under MCALL each block that moves an axis calls the program or cycle. Here the axis is left out by `[machine] axes`, so that every call would work at one \
place. Print the axis, or end the modal call before."

S9131 Error "siemens-g500-unrelated" "G500 beside a work offset of the machine"
"Positions under G500 count from the basic system, those under G54 from where the machine has that offset. The way between the two is known on the machine only. \
Give the basic frame (`[datums] basic`), the values of the offset (`[datums] G54 = { X = … }`), or the offset that G500 stands for (`[datums] G500 = \"G55\"`). \
A retraction in machine coordinates is SUPA or G53."

S9132 Error "siemens-word-not-compiled" "word of the control that is not compiled"
"The word belongs to the language and is no missing program: what it does has no word in plain G-code, or is not built. The text says what it is and what to write \
instead. Nothing is left out in silence, so the program is refused."

S9133 Error "siemens-measuring-data" "data of the measuring cycles"
"Measuring cycles take their arguments from global variables of the control (`_MVAR`, `_SETVAL`, `_PRNUM` …) and put their results into others (`_OVR`, `_OVI`). They are not defined in the \
program, and no DEF answers: what is measured is known at the machine only. Leave the measuring out: `[control] probing = \"leave-out\"`; results are asked for under [variables] then."

S9022 Error "siemens-value-of-action" "value that a left-out synchronized action sets"
"The program reads a variable that a synchronized action sets beside it. The action is left out, and when it would have set the value is known at the machine only. Compute the value in the program."

S9023 Error "siemens-move-from-probe" "move from where a probe stopped"
"A block with MEAS is left out with its move, so the target does not stand where the probe stopped. A move that does not name these axes would go on at another place than on the control. Behind a measuring \
cycle the same holds for moves that cut. Program these axes in absolute coordinates first."

S9024 Error "siemens-measured-offset" "measuring cycle corrects a work offset"
"The cycle corrects a work offset by what it measures, so that blocks after it count from another place than those before it. If the work offset of the target is set as the cycle sets it \
before the program runs, and nothing but the probe has worked before it, say so: `[control] probing_datum = \"set\"`."
}
