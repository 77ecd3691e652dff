%1.nc
[skip level 1 is on]
N1 G94 F100
N2 G0 X50 Z2
/1 N3 G1 Z-5
/2 N4 G1 Z-6
N5 G1 X60
END
