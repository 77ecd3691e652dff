%1.nc
[M0 and M1 stop, M48 passes by configuration]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X50 Z2 M48
N3 M0
N4 M1
N5 G1 Z-5
N6 M30
