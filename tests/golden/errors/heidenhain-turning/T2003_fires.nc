%1.nc
[part]
N1 G0 X50 Z2
N2 G1 Z-5
END
