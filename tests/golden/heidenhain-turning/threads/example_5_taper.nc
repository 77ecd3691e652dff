%1.nc
[worked example 5: XA 28, X 30, R1: at depth 0 from X27.7273 Z5 to X30.0909 Z-21]
N1 G97 S800 M3
N2 G0 X40 Z2
N3 G31 X30 Z-20 R1 F1.5 U-0.5 I0.5 B3 P1 V1
END
