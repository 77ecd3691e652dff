%1.nc
[inner structures of a branch that is passed are passed with it]
N1 #1=0
N2 G94 F100
N3 G0 X50 Z2
N4 IF #1==1
N5 WHILE #1<5
N6 G1 Z-1
N7 ENDWHILE
N8 IF #1==2
N9 G1 Z-2
N10 ELSE
N11 G1 Z-3
N12 ENDIF
N13 ELSE
N14 G1 Z-4
N15 ENDIF
END
