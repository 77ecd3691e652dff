%1.nc
[block numbers are names: blocks run in file order]
N30 G94 F100
N10 G0 X50 Z2
N20 G1 Z-5
G1 X60
END
