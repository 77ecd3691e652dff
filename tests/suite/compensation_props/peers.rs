//! Others who compute paths beside contours.
