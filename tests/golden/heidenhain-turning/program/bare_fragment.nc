[no name and no sections: a fragment of a 4110 program]
G94 F100
G0 X50 Z2
G1 Z-5 [cut] [here]
