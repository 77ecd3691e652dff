HEADER
#UNIT METRIC
MACHINING
[units are written out in full: their frames mean nothing]
N1 UNIT ID"G810_G80" [roughing]
N2 T1
N3 G95 F0.2 G97 S500
N4 G0 X50 Z2
END_OF_UNIT 4711
UNIT ID"END"
N5 G1 Z-5
END_OF_UNIT
END
