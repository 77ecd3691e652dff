%1.nc
[Q2: two cuts more at full depth]
N1 G97 S800 M3
N2 G0 X26 Z5
N3 G32 X20 Z-20 F1.5 P0.92 I0.92 Q2
END
