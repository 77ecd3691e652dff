%1.nc
[X20 Z0 to X30 Z-5 moves 5 mm radially and 5 mm axially]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X20 Z0
N3 G1 X30 Z-5
END
