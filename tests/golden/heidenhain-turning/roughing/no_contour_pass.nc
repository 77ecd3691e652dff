%1.nc
[H2: no pass along the contour; G818 returns to the start]
N1 G95 F0.2 G97 S800 M3
N2 G0 X52 Z2
N3 G818 P6 H2
N4 G0 X30 Z2
N5 G1 Z-20
N6 G1 X50
N7 G80
END
