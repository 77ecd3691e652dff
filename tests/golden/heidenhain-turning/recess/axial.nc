%1.nc
[axial tool: floor Z-4 at X60, oversize 0.2]
N1 T5 G95 F0.1 G97 S600 M3
N2 G0 X60 Z2
N3 G86 X60 Z-4 K0.2 E1
END
