%1.nc
[I of the cycle takes the place of G57, in Z too: 1 mm on the diameter, nothing in Z]
N1 G95 F0.2 G97 S800 M3
N2 G0 X62 Z4
N3 G57 X2 Z3
N4 G828 P2 H1 I1
N5 G0 X62 Z-4
N6 G1 X40
N7 G1 X20 Z0
N8 G80
END
