PROGRAMMKOPF
#EINHEIT METRISCH
[U1 with the option: the second pass ends 0.3 earlier, the third 0.6; the rest at that wall is cut off afterwards]
BEARBEITUNG
N1 T5 G95 F0.2 G97 S800 M3
N2 G0 X62 Z-23.1
N3 G869 P2 I0.4 K0.1 B0.3 U1 Q1
N4 G0 X60 Z-20
N5 G1 X48
N6 G1 Z-32
N7 G1 X60
N8 G80
ENDE
