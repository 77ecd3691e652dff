%1.nc
[the axis that is not written stays]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X20 Z2
N3 G1 Z-10
N4 G1 X30
N5 G0 Z5
END
