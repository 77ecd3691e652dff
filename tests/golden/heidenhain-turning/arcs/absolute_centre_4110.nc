%1.nc
[G12 I40 is the radius 20, K-10 absolute: the arc of worked example 9]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X20 Z-10
N3 G12 X40 Z-20 I40 K-10
END
