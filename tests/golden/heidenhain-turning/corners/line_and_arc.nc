%1.nc
[rounding between a line and an arc]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X20 Z0
N3 G1 Z-20 B1
N4 G3 X40 Z-20 R8
END
