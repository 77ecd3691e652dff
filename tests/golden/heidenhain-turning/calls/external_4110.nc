%1.nc
[a 4110 program calls files]
N1 G94 F50
N2 G0 X50 Z-10
N3 L"ONE"
N4 G0 X60
END
