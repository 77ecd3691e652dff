%1.nc
[worked example 13: passes at Z2 1 0 to X20]
N1 G95 F0.2 G97 S800 M3
N2 G0 X62 Z3
N3 G82 X20 Z0 K-1.25
END
