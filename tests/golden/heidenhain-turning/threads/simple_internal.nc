%1.nc
[the tool stands below X20: an internal thread]
N1 G97 S800 M3
N2 G0 X16 Z5
N3 G32 X18.5 Z-20 F1.5 P0.8 I0.4
END
