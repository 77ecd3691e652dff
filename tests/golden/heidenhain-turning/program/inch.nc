HEADER
#UNIT INCH
MACHINING
[2 inch diameter is radius 25.4; 0.01 inch/rev is 0.254 mm; 600 ft/min is 182.88 m/min]
N1 G95 F0.01 G96 S600 M3
N2 G0 X2 Z0.1
N3 G1 Z-1 B0.05
N4 G1 X3
N5 G94 F10
N6 G1 Z-2
END
