%1.nc
[nose 0.8: the cuts end earlier by what the nose needs on the cone, and the contour is left exact]
N1 T1 G95 F0.2 G97 S800 M3
N2 G0 X52 Z2
N3 G817 P3 H1
N4 G0 X30 Z2
N5 G1 Z-20
N6 G1 X40 Z-30
N7 G1 X50
N8 G80
END
