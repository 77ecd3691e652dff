//! Lists in which programs name sizes of DIN 509 by their place: the contour editor's, and that of CYCLE940 (`_PITI`).

use crate::machine::Undercuts;
use crate::standard::din509::Size;

/// A list, and the key of `[undercut]` that replaces it.
struct List {
    key: &'static str,
    /// r and t1.
    sizes: &'static [(f64, f64)],
    /// The one place that was seen in stored programs.
    seen: u32,
}

/// Places but 4 follow from the order by radius.
const EDITOR: List = List {
    key: "din509_in_editor",
    sizes: &[
        (0.1, 0.1),
        (0.2, 0.1),
        (0.4, 0.2),
        (0.6, 0.2),
        (0.6, 0.3),
        (1.0, 0.2),
        (1.0, 0.4),
        (1.6, 0.3),
        (2.5, 0.4),
        (4.0, 0.5),
    ],
    seen: 4,
};

const CYCLE: List = List {
    key: "din509_in_cycle",
    sizes: &[
        (0.6, 0.3),
        (1.0, 0.4),
        (1.0, 0.2),
        (1.6, 0.3),
        (2.5, 0.4),
        (4.0, 0.5),
        (0.4, 0.2),
        (0.6, 0.2),
        (0.1, 0.1),
        (0.2, 0.1),
    ],
    seen: 0,
};

/// The size at a place of the contour editor's list, and whether the place is confirmed.
pub(super) fn editor_size(tables: &Undercuts, place: u32) -> Option<(&Size, bool)> {
    listed(tables, &EDITOR, place)
}

/// The size at a place of CYCLE940's list, and whether the place is confirmed.
pub(super) fn cycle_size(tables: &Undercuts, place: u32) -> Option<(&Size, bool)> {
    listed(tables, &CYCLE, place)
}

fn listed<'a>(tables: &'a Undercuts, list: &List, place: u32) -> Option<(&'a Size, bool)> {
    // The user answers for a list of the configuration.
    let said = tables.list(list.key);
    let (radius, depth) = *said.unwrap_or(list.sizes).get(place as usize)?;
    Some((tables.size(radius, depth)?, said.is_some() || place == list.seen))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_named_by_their_place() {
        let place = |found: Option<(&Size, bool)>| found.map(|(size, sure)| (size.radius, size.depth, sure));
        let tables = Undercuts::default();
        assert_eq!(place(editor_size(&tables, 4)), Some((0.6, 0.3, true)));
        assert_eq!(place(editor_size(&tables, 0)), Some((0.1, 0.1, false)));
        assert_eq!(place(cycle_size(&tables, 0)), Some((0.6, 0.3, true)));
        assert_eq!(place(cycle_size(&tables, 9)), Some((0.2, 0.1, false)));
        assert_eq!((place(editor_size(&tables, 10)), place(cycle_size(&tables, 10))), (None, None));
        assert!([EDITOR, CYCLE].iter().all(|list| list.sizes.iter().all(|(r, t)| tables.size(*r, *t).is_some())));
    }
}
