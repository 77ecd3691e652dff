%1.nc
[X is a diameter: radius 25 and 10]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X50 Z2
N3 G1 X20
N4 G1 Z-5.5
END
