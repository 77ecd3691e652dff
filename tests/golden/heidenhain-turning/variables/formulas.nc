%1.nc
[#1=2+3*4=14; X(14/2)=7: radius 3.5; V1=sqrt(16)=4]
N1 #1=2+3*4
N2 V1=SQRT(16)
N3 G94 F100
N4 G0 X{#1/2} Z#1
N5 G1 Z-#1
N6 G1 X{V1*(#1-4)}
END
