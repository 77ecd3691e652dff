%1.nc
[the feed of the configuration holds at the start, in mm per minute]
N1 G0 X50 Z2
N2 G1 Z-5
END
