%1.nc
[P12: steps to Z-10 Z-22 Z-30, back to the start after each]
N1 G94 F100 G97 S900 M3
N2 G0 X0 Z2
N3 G74 Z-30 P12
END
