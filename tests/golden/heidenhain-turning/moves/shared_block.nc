%1.nc
[several functions in one block: tool, feed, cutting speed, spindle]
N1 T3 G95 F0.25 G96 S200 M3
N2 G0 X50 Z2 M8
N3 G1 Z-10 M9
N4 M5
END
