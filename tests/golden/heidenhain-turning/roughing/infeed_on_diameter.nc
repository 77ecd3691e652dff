%1.nc
[infeed = "diameter": I5 is 2.5 on the radius, passes X58 54 50]
N1 G95 F0.2 G97 S800 M3
N2 G0 X62 Z2
N3 G81 X50 Z-30 I-5
END
