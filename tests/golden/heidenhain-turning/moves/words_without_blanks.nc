%1.nc
[blanks between words do not matter]
N1 G95 F0.25 G97 S1000 M3
N2 G0X20Z2
N3 G1Z-10B-1
N4 G1X30Z-20
END
