%1.nc
[4290 page: two G33 in a row make one path; the pitch counts along Z]
N1 G97 S800 M3
N2 G0 X101.84 Z5
N3 G33 X120 Z-80 F1.5
N4 G33 X140 Z-122.5 F1.5
N5 G0 X144
END
