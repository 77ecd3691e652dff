%1.nc
[G4 F counts seconds]
N1 G95 F0.25
N2 G0 X50 Z2
N3 G4 F1.5
N4 G1 Z-5
END
