%1.nc
[worked example 9: centre radius 20, Z-10; quarter arc of radius 10]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X20 Z-10
N3 G2 X40 Z-20 I20 K0
END
