%1.nc
[the tool is in place already: nothing happens]
N1 T3
N2 G95 F0.25 G97 S1000 M3
N3 G0 X50 Z2
N4 T3
N5 G1 Zi-5
END
