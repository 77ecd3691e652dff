%1.nc
[V901 comes from the configuration]
N1 G94 F100
N2 G0 X50 Z2
N3 G1 X{V901*2}
END
