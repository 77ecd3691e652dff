%1.nc
[B1: back by 1 mm after each step]
N1 G94 F100 G97 S900 M3
N2 G0 X0 Z2
N3 G74 Z-30 P12 B1
END
