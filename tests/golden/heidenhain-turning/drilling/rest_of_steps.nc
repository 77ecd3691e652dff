%1.nc
[P8 J8: whole steps of 8 to Z-8 -16 -24, and the 1 mm that remains to Z-25]
N1 G94 F100 G97 S900 M3
N2 G0 X0 Z0
N3 G74 Z-25 P8 J8
END
