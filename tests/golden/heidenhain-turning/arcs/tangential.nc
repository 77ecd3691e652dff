%1.nc
[G3 without R and I K continues the line: quarter arc R5 about X10 Z-10]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X20 Z5
N3 G1 Z-10
N4 G2 X30 Z-15
END
