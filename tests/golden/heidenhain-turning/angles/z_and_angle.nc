%1.nc
[worked example 10: X20 Z-12, Z-24 A20 reaches X28.7353, radius 14.3676]
N1 G95 F0.25
N2 G0 X20 Z-12
N3 G1 Z-24 A20
END
