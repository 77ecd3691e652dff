%1.nc
[V1: back to X62 Z2, so the next word may be incremental]
N1 G95 F0.2 G97 S800 M3
N2 G0 X62 Z2
N3 G81 X50 Z-30 I-2.5 V1
N4 G0 Zi3
END
