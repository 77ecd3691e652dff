%1.nc
[a contour of lines along X; the second part leans by 1 mm in 10: Z at X36 is -1, B and P measured along X:]
[start X60+2*2=64 Z0, end X36-2*2=32 Z-1.2; 3 cuts of 0.3]
N1 T1 G97 S800 M3
N2 G0 X70 Z5
N3 G31 F2 U-0.9 I0.3 V1 B2 P2
N4 G0 X60 Z0
N5 G1 X56
N6 G1 X36 Z-1
N7 G80
END
