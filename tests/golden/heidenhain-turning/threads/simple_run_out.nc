%1.nc
[K2: each cut ends 2 mm further]
N1 G97 S800 M3
N2 G0 X26 Z5
N3 G32 X20 Z-20 F1.5 P0.92 I0.92 K2
END
