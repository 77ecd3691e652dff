%1.nc
[Xi is a diameter difference: 50-10=40 is radius 20; Zi a length: 2-5=-3]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X50 Z2
N3 G1 Xi-10
N4 G1 Zi-5
N5 G1 XI5 ZI-2
END
