//! What values of the control mean, for those who are asked for them.
//!
//! Source: S 5.7, P 3.1, 3.2 and 5.3 (docs/sources.md).

use super::value::{Val, to_text};

/// The first part of a name, and what the value is; `#` stands for the first index, `@` for the second.
const MEANINGS: &[(&str, &str)] = &[
    ("$AC_MEA", "1 if probe # touched, 0 if it did not"),
    ("$AA_MM", "machine coordinate of # where the probe touched"),
    ("$AA_MW", "workpiece coordinate of # where the probe touched"),
    ("$AA_MEAACT", "1 while # measures"),
    ("$AA_IM", "machine coordinate of #"),
    ("$AA_IB", "coordinate of # in the basic system"),
    ("$A_IN", "input # of the machine: 0 or 1"),
    ("$A_INA", "analogue input #"),
    ("$A_DB", "value # of the machine's own control"),
    ("$A_PROBE", "1 while probe # touches"),
    ("$AC_TIMER", "seconds of timer #"),
    ("$AC_ACTUAL_PARTS", "parts made so far"),
    ("$AC_TOTAL_PARTS", "parts made since the start of the counter"),
    ("$AC_REQUIRED_PARTS", "parts to be made"),
    ("$TC_DP1", "type of tool #, edge @"),
    ("$TC_DP2", "cutting-edge position of tool #, edge @, 1 to 9"),
    ("$TC_DP3", "length 1 of tool #, edge @"),
    ("$TC_DP4", "length 2 of tool #, edge @"),
    ("$TC_DP5", "length 3 of tool #, edge @"),
    ("$TC_DP6", "radius of tool #, edge @"),
    ("$TC_DP7", "corner radius of tool #, edge @"),
    ("$TC_DP12", "wear of length 1 of tool #, edge @"),
    ("$TC_DP13", "wear of length 2 of tool #, edge @"),
    ("$TC_DP14", "wear of length 3 of tool #, edge @"),
    ("$TC_DP15", "wear of the radius of tool #, edge @"),
    ("$TC_DP24", "clearance angle of tool #, edge @"),
    ("$TC_TP1", "duplo number of tool #"),
    ("$TC_TP2", "name of tool #"),
    ("$TC_TP3", "places to the left that tool # takes"),
    ("$TC_TP4", "places to the right that tool # takes"),
    ("$TC_TP7", "magazine place type of tool #"),
    ("$TC_TP8", "state of tool #"),
    ("$TC_TP9", "kind of monitoring of tool #"),
    ("$TC_TPG", "grinding data of wheel #"),
    ("$TC_MOP", "monitoring data of tool #, edge @"),
    ("$TC_MPP6", "number of the tool in this place of the magazine"),
    ("$P_TOOLNO", "number of the tool in use"),
    ("$P_TOOLP", "number of the tool that was programmed last"),
    ("$P_TOOLEXIST", "1 if tool # exists, else 0"),
    ("$P_TOOLND", "number of edges of tool #"),
    ("$P_TOOLL", "length # of the tool in use"),
    ("$P_TOOLR", "radius of the tool in use"),
    ("$P_AD", "parameter # of the edge in use, as $TC_DP"),
];

/// Results of the measuring cycles by their index in `_OVR`: the same place holds another thing in some cycles.
const OVR: &[(&str, i32, &str)] = &[
    ("_OVR", 0, "set value"),
    ("_OVR", 4, "actual value that was measured"),
    ("_OVR", 16, "difference between actual and set value"),
    ("_OVI", 0, "number of the tool edge or work offset"),
    ("_OVI", 2, "number of the measuring cycle"),
    ("_OVI", 5, "number of the probe"),
    ("_OVI", 9, "alarm number, 0 if there was none"),
];

/// Names of what a measuring block finds.
pub(super) fn is_measured(word: &str) -> bool {
    word.starts_with("$AC_MEA")
        || word.starts_with("$AA_MM")
        || word.starts_with("$AA_MW")
        || word.starts_with("$AA_MEA")
}

/// What the value of a name is.
pub(super) fn meaning_of(word: &str, args: &[Val]) -> Option<String> {
    if let Some((.., meaning)) = OVR
        .iter()
        .find(|(name, index, _)| *name == word && args.first().and_then(Val::number) == Some(f64::from(*index)))
    {
        return Some((*meaning).to_owned());
    }
    let fits = |known: &&(&str, &str)| {
        // A number belongs to the name, but for families: `$TC_TPG1`, `$AA_MM2`, `$A_DBB`.
        word == known.0
            || matches!(known.0, "$TC_TPG" | "$TC_MOP" | "$AA_MM" | "$AA_MW" | "$A_DB" | "$AA_IB")
                && word.starts_with(known.0)
    };
    let (_, meaning) = MEANINGS.iter().find(fits)?;
    let shown = |at: usize| args.get(at).and_then(to_text).map(|text| String::from_utf8_lossy(&text).into_owned());
    let meaning = meaning.replace('#', &shown(0).unwrap_or_default()).replace('@', &shown(1).unwrap_or_default());
    Some(meaning.replace("  ", " ").trim_end().to_owned())
}

/// The end of a message: what the value means.
pub(super) fn said_meaning(name: &str, args: &[Val]) -> String {
    meaning_of(name, args).map_or_else(String::new, |meaning| format!(" ({meaning})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meanings_name_the_index() {
        assert_eq!(meaning_of("$AC_MEA", &[Val::Int(1)]).as_deref(), Some("1 if probe 1 touched, 0 if it did not"));
        assert_eq!(
            meaning_of("$TC_DP12", &[Val::Int(3), Val::Int(1)]).as_deref(),
            Some("wear of length 1 of tool 3, edge 1")
        );
        assert_eq!(meaning_of("_OVR", &[Val::Int(16)]).as_deref(), Some("difference between actual and set value"));
        assert_eq!(meaning_of("$AC_UNKNOWN", &[]), None);
    }
}
