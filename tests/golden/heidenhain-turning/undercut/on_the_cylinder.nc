%1.nc
[the tool stands on the cylinder: that is machined up to the slope at Z-27.5, then the undercut; edge position 3 is outside]
N1 T1 G95 F0.2 G97 S800 M3
N2 G0 X40 Z2
N3 G85 X40 Z-30 E0.1
END
