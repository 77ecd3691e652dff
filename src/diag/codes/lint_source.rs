//! `L2`: rules over the blocks of a program, in every language.

super::codes! { LINT_SOURCE:

L2001 Note off "label-unused" "label is never called"
"No block of the program jumps to the label or calls it. It is left over, or the call names another one. Where a jump computes its target, or a label is called by \
another program, nothing is said. Off by default: labels also mark places for people."

L2002 Warning "block-unreachable" "block can never run"
"A jump that is always made stands before this block, and no label leads to it. It can never run: a condition got lost, or the label in front of it. Said at the \
first block of each such stretch."

L2003 Warning "block-behind-end" "block stands behind the end of the program and nothing leads to it"
"M30, M2, RET or END stands before this block, and no label that could be called comes between. It never runs. It was left over, or the end of the program stands too \
early. Subprograms behind M30 begin with a label. Said once."

L2004 Note off "variable-unread" "variable gets a value that nothing reads"
"A variable is set, and no block of the program reads it. It is left over, or the block that should read it names another one. Programs that call others, and \
parameters that the control reads itself (Q100 to Q1999 of Klartext cycles), are left alone. Off by default: operators read variables, too."

L2005 Note off "block-number-order" "block number is not larger than the one before"
"The number of a block is smaller than, or the same as, that of the block before it. Blocks were moved or joined from two programs. Controls run them in the order \
in which they stand; a search for a block number finds the wrong one. Said once. Off by default; `partc check --fix --unsafe-fixes` numbers the blocks \
anew where nothing jumps to a number."

L2006 Warning "label-alike" "two labels differ in upper and lower case only"
"Two labels have the same letters in different case. Controls differ in whether they tell them apart, so a call may lead to the wrong one on another \
machine. Rename one of them."

L2007 Note off "comment-is-code" "comment reads like a block"
"A comment holds what would be a block with coordinates or a G function without the sign of the comment. Blocks that were switched off for a test and forgotten \
are the most frequent reason why a part lacks something. Off by default."

L2008 Note off "word-redundant" "word says what holds already"
"A modal G function, an F or an S is programmed, and the same holds already from a block before. It does no harm. Off by default; `partc check --fix` removes it \
where the program does the same without it. F and S of a tool call are those of the tool, and no modal words."

L2009 Warning "incremental-left-on" "program ends while G91 holds"
"The last of G90 and G91 in the program is G91, and then comes its end. Where the control does not reset it, the next program starts with increments: a rapid move to a \
height becomes one by this height. Go back to G90 where the increments end."

L2010 Warning "units-mixed" "program changes between inches and millimetres"
"G70 or G700 (inches) and G71 or G710 (millimetres) both stand in the program. Feeds, offsets and cycle parameters do not all follow the change, and controls differ \
in which. Write the program in one unit. Said once."

L2011 Note off "line-end-missing" "last block has no line end"
"The last line of the file does not end. Some controls and transfer programs lose such a block, which is most often the end of the program. Off by default; `partc \
check --fix` ends it."

L2012 Note off "digits-beyond-resolution" "number has more digits than controls resolve"
"A literal has more than five decimals. Controls resolve a tenth of a micrometre at best, and some refuse longer numbers. Digits were computed and not rounded. Off by \
default. Said once."

L2013 Note off "comment-unfinished" "comment says that something is to be done"
"A comment holds TODO, FIXME or XXX: whoever wrote the program meant to come back. Off by default."

L2014 Note off "skip-mark-open" "blocks with a skip mark, and nothing says whether they run"
"The program has blocks with `/`, and `[control] skip_blocks` says nothing of them, so they are compiled as if the switch at the machine were off. Say in the \
configuration what holds in the shop. Off by default. Said once."

L2015 Note off "comment-foreign-letters" "comment holds letters that controls do not show"
"A comment holds characters beyond ASCII. Controls show them as other signs or not at all, and some refuse the file. Off by default. Said once."

L2016 Warning "pole-of-other-plane" "polar block uses a pole of another working plane"
"The pole was set, then the working plane changed (G17, G18, G19; another tool axis in TOOL CALL), and now a block counts from the pole. SINUMERIK takes the zero of \
the new plane for its pole; a HEIDENHAIN control keeps a pole in axes that are no longer those of the plane. Neither is what the program seems to mean. Set the \
pole again behind the change of the plane. Behind a label nothing is said: who leads there is not known."

L2017 Warning "radius-left-on" "program ends in radius programming on a lathe that begins in diameters"
"The last of DIAMON, DIAM90 and DIAMOF in the program is DIAMOF (G15 of G15 and G16 on an MTC200), and then comes its end. The configuration says that the lathe begins in diameters. Where the control does not \
reset it, the next program takes its diameters for radii, and the tool stands twice as far out or the part gets twice as thick. Go back to DIAMON where radii end."
}
