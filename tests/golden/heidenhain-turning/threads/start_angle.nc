%1.nc
[C90 lengthens the run-in by a quarter of the pitch: Z8.375]
N1 G97 S800 M3
N2 G0 X26 Z5
N3 G31 X20 Z-20 F1.5 U-0.3 I0.3 B3 P1 V1 C90
END
