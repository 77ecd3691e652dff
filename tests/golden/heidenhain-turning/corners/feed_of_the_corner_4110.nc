%1.nc
[E is the feed of the chamfer]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X0 Z0
N3 G1 X20 B-1.5 E0.1
N4 G1 Z-12
END
