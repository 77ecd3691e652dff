%1.nc
[thread_left = "plus": H1 shifts to +Z: Z8 plus 0.5196, 0.3464, 0.1732, 0]
N1 G97 S800 M3
N2 G0 X26 Z5
N3 G31 X20 Z-20 F1.5 U-0.92 I0.3 B3 P1 V3 H1 A30
END
