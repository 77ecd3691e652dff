PROGRAMMKOPF
#EINHEIT METRISCH
REVOLVER 1
T1 ID"112-16-080.1"
T2 ID"GROOVE"
BEARBEITUNG
[the name of the turret section finds the tool of the configuration]
N1 T2
N2 G95 F0.1
N3 G0 X50 Z2
ENDE
