//! `G330` and `S22`, `S82`: stock removal in layers.

super::codes! { LAYERS:

G3301 Error "layers-approach" "no free way to where the cuts begin"
"The cycle travels at rapid traverse to a point in front of the blank and clear of it. From where the tool stands every way there leads through the \
blank or what lies below it. Position the tool in front of the blank before the cycle."

G3302 Error "layers-tool" "cutting edge points out of the material"
"The position of the cutting edge in the tool data says which way the nose points. For this cycle it has to point into the material, or along the \
cuts. Select the tool that belongs to the cycle, or correct its edge position."

G3303 Error "layers-limits" "limit of the area lies inside the blank"
"The cuts begin in front of the blank. Where a limit of the area lies on that side inside of the blank, the tool would have to plunge into full \
material. Set the limit in front of the blank, or machine the part in front of it first."
}
