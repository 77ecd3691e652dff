%1.nc
[T2.1 has a number of its own in the configuration]
N1 T2.1
N2 G95 F0.25 G97 S1000 M3
N3 G0 X50 Z2
END
