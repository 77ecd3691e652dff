%1.nc
[G14 Q0: both together; X300 of the machine is radius 150]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X50 Z2
N3 G14 Q0
N4 G0 X60 Z5
END
