%1.nc
[the tool comes from -Z, so the shoulder lies at +Z of the corner: everything mirrored, slope from Z-27.5]
N1 G95 F0.1 G97 S800 M3
N2 G0 X44 Z-60
N3 G85 X40 Z-30
END
