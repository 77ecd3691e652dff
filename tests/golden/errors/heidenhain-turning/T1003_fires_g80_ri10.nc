HEADER
#UNIT METRIC
MACHINING
[RI belongs to the form of a recess, not to that of a roughed contour]
N2 T5
N3 G97 S800 G95 F0.2 M3
N4 G0 X70 Z2
N5 G810 P2 H1
N6 G80 XS40 ZS0 XE60 ZE-32 RI10
END
