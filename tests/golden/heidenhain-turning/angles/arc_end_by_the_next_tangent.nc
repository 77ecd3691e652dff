%1.nc
[ball end R10 about Z-10, then a cone of 20 degrees to Z-40, tangential: the arc ends at Z-10+10 sin 20 = -6.5798,]
[radius 10 cos 20 = 9.3969; the cone rises 33.4202 tan 20 = 12.1640 to the radius 21.5609]
N1 G95 F0.2 G97 S800 M3
N2 G0 X0 Z0
N3 G13 X? Z? I0 K-10
N4 G1 Z-40 A20
END
