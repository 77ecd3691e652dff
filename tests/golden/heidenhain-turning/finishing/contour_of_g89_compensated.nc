%1.nc
[G42 behind G89: nose 0.4, edge position 3: along the cylinder the tip has its X, on the face its Z; back to the start]
N1 T1 G95 F0.2 G97 S800 M3
N2 G0 X60 Z3
N3 G89
N4 G42
N5 G0 X30 Z0
N6 G1 Z-20
N7 G1 X40 Z-30
N8 G1 X56
N9 G80
END
