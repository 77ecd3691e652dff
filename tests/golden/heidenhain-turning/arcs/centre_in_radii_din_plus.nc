PROGRAMMKOPF
#EINHEIT METRISCH
[worked example 9: the same arc on later controls: I is a radius difference]
BEARBEITUNG
N1 G95 F0.25 G97 S1000 M3
N2 G0 X20 Z-10
N3 G2 X40 Z-20 I10 K0
ENDE
