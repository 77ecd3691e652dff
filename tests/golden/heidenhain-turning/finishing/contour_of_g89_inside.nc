%1.nc
[inside: edge position 2 tells the side, though nothing is compensated; K0.5: lifts off by 0.5 in X and Z]
N1 T1 G95 F0.2 G97 S800 M3
N2 G0 X28 Z2
N3 G89 K0.5
N4 G0 X34 Z1
N5 G1 X30 Z-1
N6 G1 Z-30
N7 G1 X20
N8 G80
END
