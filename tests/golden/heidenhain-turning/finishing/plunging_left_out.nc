HEADER
#UNIT METRIC
FINISHED PART
N2 G0 X50 Z0
N3 G1 Z-20
N4 G1 X44 Z-24
N5 G1 Z-34
N6 G1 X50 Z-38
N7 G1 Z-60
MACHINING
[E0: the descending part is left out, the cut goes on level to where the contour rises again]
N10 T1 G95 F0.2 G97 S800 M3
N11 G0 X64 Z3
N12 G890 NS3 NE7 E0
END
