%1.nc
[width 8 to -Z, without oversize: strokes only]
N1 T5 G95 F0.1 G97 S600 M3
N2 G0 X62 Z2
N3 G86 X54 Z-30 K8 E1
END
