%1.nc
[G51 Z-10 shifts the zero; a second one replaces it]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X50 Z2
N3 G51 Z-10
N4 G1 Z0
N5 G51 Z-20
N6 G1 Z0
N7 G51 Z0
N8 G1 Z0
END
