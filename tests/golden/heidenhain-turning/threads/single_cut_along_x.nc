%1.nc
[H1: the pitch counts along X; H3: along the path]
N1 G97 S800 M3
N2 G0 X40 Z5
N3 G33 X20 Z0 F1 H1
N4 G33 X10 Z-3 F1 H3
END
