%1.nc
[worked example 8: passes X58 54 50 to Z-30, lift of 1 mm at 45 degrees]
N1 G95 F0.2 G97 S800 M3
N2 G0 X62 Z2
N3 G81 X50 Z-30 I-2.5
END
