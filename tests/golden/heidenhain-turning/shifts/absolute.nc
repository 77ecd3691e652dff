%1.nc
[coordinates count from the first G59; the second one is 30 further left]
N1 G59 Z150
N2 G95 F0.25 G97 S1000 M3
N3 G0 X50 Z2
N4 G1 Z0
N5 G59 Z120
N6 G1 Z0
END
