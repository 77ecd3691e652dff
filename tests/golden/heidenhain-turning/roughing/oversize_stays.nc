%1.nc
[G57 X0.4 Z0.1: X50.4 and Z-29.9; it stays in force for the second cycle]
N1 G95 F0.2 G97 S800 M3
N2 G57 X0.4 Z0.1
N3 G0 X62 Z2
N4 G81 X50 Z-30 I-6 V1
N5 G81 X50 Z-30 I-6 V1
END
