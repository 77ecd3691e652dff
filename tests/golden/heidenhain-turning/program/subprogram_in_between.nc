HEADER
#UNIT METRIC
SUBPROGRAM "GROOVE"
N1 G1 Xi-4
N2 G1 Xi4
RETURN
MACHINING
[the section of the subprogram is passed until it is called]
N3 G94 F50
N4 G0 X50 Z-10
N5 L"GROOVE"
N6 G0 Z-20
N7 L"groove" Q1
END
