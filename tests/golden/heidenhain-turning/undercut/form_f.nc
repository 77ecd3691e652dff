%1.nc
[K0: form F with P0.2 A8: the shoulder is cut 0.2 deep, and left at 8 degrees]
N1 G95 F0.1 G97 S800 M3
N2 G0 X50 Z2
N3 G85 X40 Z-30 K0 E0.05
END
