PROGRAMMKOPF
#EINHEIT METRISCH
[configured turning_arc_q = far: Q0 names the further solution, radius 2]
BEARBEITUNG
N1 G95 F0.25 G97 S1000 M3
N2 G0 X36 Z-14
N3 G13 X? Z-26 I10 K-20
ENDE
