%1.nc
[worked example 10: X20 B-1.5 is X17 Z0, X20 Z-1.5: radius 8.5, 10]
N1 G95 F0.25
N2 G0 X0 Z2
N3 G1 Z0
N4 G1 X20 B-1.5
N5 G1 Z-12
END
