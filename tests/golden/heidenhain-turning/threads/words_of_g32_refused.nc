%1.nc
[simple_thread = "refuse"]
N1 G97 S800 M3
N2 G0 X26 Z5
N3 G32 X20 Z-20 F1.5 P0.92 I0.3
END
