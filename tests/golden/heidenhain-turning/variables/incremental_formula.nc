%1.nc
[Xi takes a formula as well]
N1 #1=5
N2 G94 F100
N3 G0 X50 Z2
N4 G1 Xi#1 Zi-#1
END
