HEADER
#UNIT METRIC
MACHINING
[RI4 of G80, as in the block of G869: the blank stands 2 mm proud of the rim, so 8 mm in levels of 2]
N1 UNIT ID"G869_G80" [recess turning]
N2 T5
N3 G97 S800 G95 F0.2 M3
N4 G0 X70 Z-23.1
N5 G869 P2 Q1
N6 G80 XS60 ZS-20 XE48 ZE-32 RI4
END_OF_UNIT 1234
END
