%1.nc
[U above zero: internal, X grows from 20.6 to 21.2]
N1 G97 S800 M3
N2 G0 X18 Z5
N3 G31 X20 Z-20 F1 U0.6 I0.3 B3 P1 V1
END
