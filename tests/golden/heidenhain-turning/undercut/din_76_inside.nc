%1.nc
[K7.8 inside is the pitch 1.5: R0.8; depth 1.0619 = (20 + 0.5 - 18.3762) / 2: X18.3762 to X20.5; slope starts at Z-30+7.8]
N1 G95 F0.1 G97 S800 M3
N2 G0 X14 Z2
N3 G85 X18.3762 Z-30 I1.0619 K7.8
END
