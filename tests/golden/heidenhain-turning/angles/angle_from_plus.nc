%1.nc
[counted from +Z the angle 20 falls towards -Z: 20 - 2*10 tan 20 = 12.7206]
N1 G95 F0.2 G97 S800 M3
N2 G0 X20 Z0
N3 G1 Z-10 A20
END
