//! What the alarms of the standard cycles mean, for programs that raise them by `SETAL`.
//!
//! Source: C 7 (docs/sources.md).

/// The cause of an alarm of the standard cycles, and what to do; `None` for alarms of users and machine builders.
pub(super) fn meaning(alarm: f64) -> Option<(&'static str, &'static str)> {
    let known = ALARMS.iter().find(|(number, ..)| f64::from(*number) == alarm);
    known.map(|(_, what, help)| (*what, *help))
}

/// Help for data that a cycle finds wrong.
const CHECK: &str = "look at the conditions before SETAL, and at the data they test";

const ALARMS: [(u32, &str, &str); 24] = [
    (61000, "no tool offset is active", "select the tool and its edge before: T… D…"),
    (61001, "the pitch of the thread is wrong", CHECK),
    (61002, "the kind of machining is wrong", CHECK),
    (61003, "no feed is programmed", "program F before the call"),
    (61008, "no tool is active", "select the tool before"),
    (61009, "the active tool is T0", "select the tool before"),
    (61010, "the allowance on the floor is larger than the depth", CHECK),
    (61011, "a scaling is active", "switch SCALE off before the call"),
    (61014, "the retraction plane is exceeded", CHECK),
    (
        61015,
        "the contour is not defined: the contour editor stored it with elements that are still open",
        "complete the contour in the editor of the control, and accept it again",
    ),
    (61019, "a parameter is wrong", CHECK),
    (61027, "a subprogram does not exist", "put it beside the program, or name its folder under [include]"),
    (61101, "the reference plane is wrong", CHECK),
    (61102, "no spindle direction is given", CHECK),
    (61103, "the number of holes is 0", CHECK),
    (61106, "the holes do not fit on the circle", CHECK),
    (61107, "the first drilling depth lies on the wrong side", CHECK),
    (61601, "the finished diameter is too small", CHECK),
    (61602, "the tool is wider than the groove", CHECK),
    (61605, "the contour is wrong", CHECK),
    (61606, "the contour could not be prepared", CHECK),
    (61609, "the form is not known", CHECK),
    (62100, "no drilling cycle is active", "call it before: MCALL CYCLE81(…)"),
    (62105, "the number of rows or columns is 0", CHECK),
];
