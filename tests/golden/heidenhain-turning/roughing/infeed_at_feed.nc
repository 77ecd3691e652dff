%1.nc
[Q1: to the depth at feed]
N1 G95 F0.2 G97 S800 M3
N2 G0 X62 Z2
N3 G81 X50 Z-30 I-6 Q1
END
