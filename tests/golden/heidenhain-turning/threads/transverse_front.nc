%1.nc
[face thread: R-20 is the radial length, so it starts at X20+40=60; B4 and P2 along X: X68 to X16; the tip of the tool]
[points to -Z, so the depth goes there: Z-0.4, -0.8, -1.2; the tool returns at its Z5]
N1 T1 G97 S800 M3
N2 G0 X70 Z5
N3 G31 X20 Z0 R-20 F2 U-1.2 I0.4 V1 B4 P2
END
