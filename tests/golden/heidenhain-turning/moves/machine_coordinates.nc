%1.nc
[G701: rapid traverse in machine coordinates, X300 is radius 150]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X50 Z2
N3 G701 X300 Z400
N4 G0 X50 Z2
N5 G1 Z-5
END
