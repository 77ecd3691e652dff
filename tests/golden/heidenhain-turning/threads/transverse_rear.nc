%1.nc
[the same in the rear face at Z-60: the depth goes towards +Z, to Z-59.6, -59.2, -58.8; outwards, X20-8=12 to X60+4=64]
N1 T1 G97 S800 M3
N2 G0 X10 Z-65
N3 G31 X60 Z-60 R20 F2 U-1.2 I0.4 V1 B4 P2
END
