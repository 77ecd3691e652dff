%1.nc
[the tool below the bore of 40 cuts outwards: floor at radius 20.35]
N1 G95 F0.1 G97 S800 M3
N2 G0 X36 Z2
N3 G85 X40 Z-30
END
