%1.nc
[B and P of G33 lie inside of the programmed thread, I and K belong to a stop: the moves are those without them]
N1 G97 S800 M3
N2 G0 X20 Z5
N3 G33 Z-20 F1.5 B2 P1 I1 K1
END
