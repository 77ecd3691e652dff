%1.nc
[B2 rounds the corner: radius 8 at Z0, radius 10 at Z-2]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X0 Z2
N3 G1 Z0
N4 G1 X20 B2
N5 G1 Z-12
END
