%1.nc
[G89 without G41: the programmed point follows the contour, 0.2 outside of it; K0: the tool stays at the end]
N1 T1 G95 F0.2 G97 S800 M3
N2 G0 X60 Z3
N3 G89 I0.2 K0
N4 G0 X30 Z0
N5 G1 Z-20
N6 G1 X56
N7 G80
END
