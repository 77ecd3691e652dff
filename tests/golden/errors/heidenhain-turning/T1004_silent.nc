%1.nc
[part]
N1 G94 F100
N2 G0 X50 Z2
N3 G1 Z-5 [cut]
END
