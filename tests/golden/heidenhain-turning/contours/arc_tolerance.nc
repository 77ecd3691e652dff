HEADER
#UNIT METRIC
FINISHED PART
N1 G0 X33.4 Z0
N2 G1 Z-24.3
N3 G2 X49.78 Z-37.665 I15.05 K0
N4 G1 X60
MACHINING
[radii 15.05 and 15.0227 differ by 0.0273: accepted by the option; the centre moves along the chord by]
[0.0273 * 15.04 / 15.66 = 0.026, the way between the distances of both ends]
N7 T1 G95 F0.2 G97 S800 M3
N8 G0 X60 Z3
N10 G890 NS2 NE4 E0.1 O1
END
