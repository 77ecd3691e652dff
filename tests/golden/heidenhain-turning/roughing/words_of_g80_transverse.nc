HEADER
#UNIT METRIC
MACHINING
[the contour in the words of G80: two elements, rounded where they meet]
N1 T1 G95 F0.2 G97 S800 M3
N2 G0 X52 Z2
N3 G820 P4 E0
N4 G80 XS50 ZS-10 XE20 ZE0 RC2
END
