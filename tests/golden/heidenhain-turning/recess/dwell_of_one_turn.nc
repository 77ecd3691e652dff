%1.nc
[E missing: one turn at 600 1/min is 0.1 s]
N1 T5 G95 F0.1 G97 S600 M3
N2 G0 X62 Z2
N3 G86 X54 Z-30
END
