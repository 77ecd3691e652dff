%1.nc
[T0303 is tool 3 with its own offset]
N1 T0303
N2 G95 F0.25 G97 S1000 M3
N3 G0 X50 Z2
END
