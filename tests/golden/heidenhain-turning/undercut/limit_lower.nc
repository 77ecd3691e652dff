%1.nc
[18 mm belongs to the row below 18: I0.25 K2 R0.6, floor X17.5]
N1 G95 F0.1 G97 S800 M3
N2 G0 X24 Z2
N3 G85 X18 Z-30
END
