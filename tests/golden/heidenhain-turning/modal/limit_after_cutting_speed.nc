%1.nc
[a later G26 limits the cutting speed in force]
N1 G96 S180 M3
N2 G26 S2500
N3 G95 F0.2
N4 G0 X50 Z2
N5 G1 Z-5
END
