%1.nc
[the oversize is left on the floor alone: strokes from Z-25 to Z-30 down to X54.8]
N1 T5 G95 F0.1 G97 S600 M3
N2 G0 X62 Z2
N3 G86 X54 Z-30 I0.4 K8 E1
END
