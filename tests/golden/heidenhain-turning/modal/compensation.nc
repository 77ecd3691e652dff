%1.nc
[G41 and G42 are printed where the target compensates]
N1 T3
N2 G95 F0.25 G97 S1000 M3
N3 G0 X50 Z2
N4 G42 G1 X20 Z0
N5 G1 Z-20
N6 G40 G1 X30 Z-18
END
