HEADER
#UNIT METRIC
MACHINING
[the recess in the words of G80: start and end say rim and floor]
N1 UNIT ID"G869_G80" [recess turning]
N2 T5
N3 G97 S800 G95 F0.2 M3
N4 G0 X62 Z-23.1
N5 G869 P6 Q2
N6 G80 XS60 ZS-20 XE48 ZE-32
END_OF_UNIT 1234
END
