%1.nc
[width 8 to +Z, oversize 0.4 counts on the radius: strokes to X54.8 between Z-25.4 and Z-29.6, then right flank and]
[floor, left flank; 1.3 mm slopes at X62]
N1 T5 G95 F0.1 G97 S600 M3
N2 G0 X62 Z2
N3 G86 X54 Z-30 I0.4 K8 E1
END
