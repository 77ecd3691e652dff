HEADER
#UNIT METRIC
FINISHED PART
N1 G0 X50 Z-5
N2 G1 X20
N3 G1 Z0
N4 G1 X0
MACHINING
[faced to the axis; the tool lifts off inwards no further than the turning centre]
N5 T1 G95 F0.2 G97 S800 M3
N6 G0 X60 Z3
N7 G890 NS4
N8 G0 X60 Z3
END
