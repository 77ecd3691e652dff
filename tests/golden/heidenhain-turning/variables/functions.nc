%1.nc
[sin30=0.5, cos60=0.5, tan45=1, atan1=45, sqrta(3,4)=5, sqrts(5,4)=3, abs-2=2, int7.9=7, round2.6=3]
N1 G94 F100
N2 #1=SIN(30)+COS(60)+TAN(45)
N3 #2=ATAN(1)
N4 #3=SQRTA(3,4)+SQRTS(5,4)
N5 #4=ABS(-2)+INT(7.9)+ROUND(2.6)
N6 G0 X{#1*10} Z#2
N7 G1 Z#3
N8 G1 Z#4
N9 G1 Z{ASIN(0.5)+ACOS(0.5)+LN(EXP(1))}
END
