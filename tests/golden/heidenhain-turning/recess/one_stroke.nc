%1.nc
[no width: one stroke of the tool; then the flanks with their slopes of 1.3 mm, dwell 2 s at the floor]
N1 T5 G95 F0.1 G97 S600 M3
N2 G0 X62 Z2
N3 G86 X54 Z-30 E2
END
