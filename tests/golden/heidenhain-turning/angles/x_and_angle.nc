%1.nc
[4110 page 308: from X90 the line X100 A80 leans towards -Z: dz=-5/tan80=-0.8816]
N1 G95 F0.25 G97 S1000 M3
N2 G0 X90 Z-10
N3 G1 Zi-6
N4 G1 X100 A80 B-0.5
N5 G1 Z-47
END
