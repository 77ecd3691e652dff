%1.nc
[worked example 12: layers X46.5 to Z-30, X41 to Z-30, X35.5 to Z-25.5, X30 to Z-20, then the contour]
N1 G95 F0.2 G97 S800 M3
N2 G0 X52 Z2
N3 G817 P3 H1
N4 G0 X30 Z2
N5 G1 Z-20
N6 G1 X40 Z-30
N7 G1 X50
N8 G80
END
