HEADER
#UNIT METRIC
FINISHED PART
N1 G0 X40 Z0
N2 G1 Z-30
N3 G25 H6
N4 G1 X60
MACHINING
[the relief of the face leans over: the cuts end in front of it, at Z-30; the undercut is left to the finishing]
N7 T1 G95 F0.2 G97 S800 M3
N8 G0 X60 Z3
N9 G810 NS2 NE4 P5
N10 G890 NS2 NE4 E0.1 O1
END
