PROGRAMMKOPF
#EINHEIT METRISCH
[#l1 of the subprogram is another one than #l1 here: Z-10-2, then Z-7]
BEARBEITUNG
N1 G94 F50
N2 G0 X50 Z-10
N3 #l1=7
N4 L"LOCAL" V1
N5 G1 Z{0-#l1}
ENDE
