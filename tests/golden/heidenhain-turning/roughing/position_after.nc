%1.nc
[without V1 the tool stands where the cuts begin, at the last lift: X52 Z2, and X60 Z-3]
N1 G95 F0.2 G97 S800 M3
N2 G0 X62 Z2
N3 G81 X50 Z-30 I-6
N4 G0 XI4
N5 G0 X60 Z2
N6 G82 X50 Z-4 K3
N7 G0 ZI5
END
