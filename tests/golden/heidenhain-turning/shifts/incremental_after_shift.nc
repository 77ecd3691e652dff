%1.nc
[the tool stays: Z2 is Z12 in the shifted system, Zi-5 is Z-3 in the first]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X50 Z2
N3 G51 Z-10
N4 G1 Zi-5
END
