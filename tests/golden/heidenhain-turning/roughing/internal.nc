%1.nc
[inside: passes X21, 22 away from the axis]
N1 G95 F0.2 G97 S800 M3
N2 G0 X20 Z2
N3 G81 X22 Z-30 I-0.5
END
