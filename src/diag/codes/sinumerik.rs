//! `S`: SINUMERIK programs. A text that names an alarm means the number the control itself shows.

super::codes! { SINUMERIK:

S0001 Error "siemens-character" "character has no place in a block"
"The character belongs to no word of the SINUMERIK language. Comments start with a semicolon. The control shows alarm 12080."

S0002 Warning "siemens-dash" "printed dash instead of a minus sign"
"A dash of printed text stands where a minus sign is meant, as happens when a program is copied from a document. It is read as `-`. \
Replace it: the control does not accept it."

S0003 Error "siemens-bracket-comment" "comment in brackets"
"Brackets hold comments in DIN 66025 and ISO programs. On a SINUMERIK control they group formulas and hold arguments; \
a comment starts with a semicolon. The control shows alarm 12080."

S1001 Error "siemens-syntax" "block cannot be read"
"The words of the block do not fit together: a value or `=` is missing, or a word stands where none can stand. \
The control shows alarm 12080 and stops at the block."

S1002 Error "siemens-two-operators" "two operators in a row"
"Two arithmetic operators cannot follow each other: `R1=R2--R3` is refused with alarm 12180. Put the signed value in brackets."

S1003 Error "siemens-skip-level" "skip level does not exist"
"Blocks are skipped on levels /0 to /9; a slash alone means level 0. The control shows alarm 14060."

S1004 Error "siemens-structure-mark" "label or skip mark on a control structure"
"Lines with IF, ELSE, ENDIF, WHILE, FOR, LOOP, REPEAT and their ends take neither a label nor a skip mark. \
Put the label into the block before. The control shows alarm 12630."

S1013 Error "siemens-modal-passes" "number of passes in a modal call"
"MCALL calls the program once behind every positioning block; a number of passes cannot be given. The control shows alarm 12100."

S1014 Error "siemens-name-length" "name is too long"
"Labels and names have at most 32 characters; the control stops at a longer one with alarm 12420. Shorten it."

S8001 Warning "siemens-unbracketed-logic" "AND or OR beside a comparison without brackets"
"Comparisons bind weakest on a SINUMERIK control: `R1==1 AND R2==2` is read as `R1 == (1 AND R2) == 2`, which is hardly what is meant. \
Put each comparison in brackets. The program is compiled as the control reads it."

}
