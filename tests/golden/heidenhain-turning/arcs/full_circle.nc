%1.nc
[end is start and the centre is given: a full circle of radius 5 about X20 Z-10]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X30 Z-10
N3 G2 X30 Z-10 I-10 K0
END
