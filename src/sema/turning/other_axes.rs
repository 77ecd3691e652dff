//! Functions of axes and slides that are not compiled: the C and the Y axis, driven tools, a second spindle or slide.
//!
//! A table of names only: what a function of these does is in the manuals of the controls (docs/sources.md).

/// What the function of this number belongs to.
pub(super) fn belongs(number: u16) -> Option<&'static str> {
    Some(match number {
        // Moves on the face and on the cylinder, reference diameter, zero shift and short way of C.
        100..=103 | 110..=113 | 120 | 152..=154 => "the C axis",
        // Contours and figures on face and cylinder, patterns of holes.
        300..=317 | 401 | 402 | 411 | 412 => "the C axis",
        743..=746 => "the C axis",
        791..=799 | 801 | 802 | 840 | 845..=848 => "the C axis",
        // Planes, contours and figures of Y, milling and engraving in its planes.
        16..=19 | 170..=173 | 180..=183 => "the Y axis",
        370..=377 | 380..=387 | 471 | 472 | 477 | 481 | 482 | 487 => "the Y axis",
        800 | 803 | 804 | 806 | 841..=844 => "the Y axis",
        126 | 192 | 193 | 195..=197 => "the driven tool",
        30 | 99 | 121 | 720 | 905 | 906 | 916 | 917 => "a second spindle",
        62 | 63 | 162 => "several slides",
        _ => return None,
    })
}
