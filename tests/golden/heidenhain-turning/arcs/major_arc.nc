%1.nc
[R-10 takes the longer way round: 270 degrees]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X20 Z-10
N3 G2 X40 Z-20 R-10
END
