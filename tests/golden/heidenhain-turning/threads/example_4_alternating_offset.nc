%1.nc
[worked example 4, H3: offsets -0.7337, +0.4891, -0.2446, 0 of Z8]
N1 G97 S800 M3
N2 G0 X26 Z5
N3 G31 X20 Z-20 F1.5 U-0.92 I0.3 B3 P1 V3 H3
END
