%1.nc
[to Z-30, 0.5 s, back to Z2 at rapid]
N1 G94 F100 G97 S900 M3
N2 G0 X0 Z2
N3 G71 Z-30 E0.5
END
