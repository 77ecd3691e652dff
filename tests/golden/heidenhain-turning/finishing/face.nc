HEADER
#UNIT METRIC
FINISHED PART
N1 G0 X50 Z-5
N2 G1 X20
N3 G1 Z0
N4 G1 X0
MACHINING
[NS2 NE2: outwards along the face, from the foot of the step; the tool comes down beside the step, not inside of it]
N5 T1 G95 F0.2 G97 S800 M3
N6 G0 X60 Z3
N7 G890 NS2 NE2
N8 G0 X60 Z3
END
