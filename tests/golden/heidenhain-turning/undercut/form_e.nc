%1.nc
[diameter 40 of the table of G85: I0.35 K2.5 R0.6: slope ends 2.5-0.35/tan15=1.1938 from the shoulder; arc ends at radius 20-0.35+0.6=20.25]
N1 G95 F0.1 G97 S800 M3
N2 G0 X44 Z2
N3 G85 X40 Z-30
END
