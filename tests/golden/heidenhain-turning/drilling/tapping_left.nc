%1.nc
[M4: a left-hand thread]
N1 T1 G97 S400 M4
N2 G0 X0 Z4
N3 G36 Zi-19 F1.25
END
