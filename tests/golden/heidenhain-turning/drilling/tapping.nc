%1.nc
[G36: in with the pitch, spindle back, out with the pitch, spindle on again]
N1 T1 G97 S400 M3
N2 G0 X0 Z4
N3 G36 Z-15 F1.25
END
