//! The vocabulary of places beside a finding: what each of them has to do with it.

use std::fmt;

/// Writes the words as an enum, and their texts.
macro_rules! labels {
    ($($label:ident $(($($of:ident),*))? $text:literal;)*) => {
        /// What a further place has to do with a finding.
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub enum Label {
            $($label $(($(labels!(@quantity $of)),*))?,)*
        }

        impl fmt::Display for Label {
            fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(Label::$label $(($($of),*))? => write!(to, $text),)*
                }
            }
        }
    };
    (@quantity $of:ident) => { String };
}

labels! {
    // Another of its kind.
    FirstOne "the first one";
    OtherOne "the other one";
    OneOfThem "one of them";
    FirstTime "here for the first time";
    FirstSetHere "first set here";
    FirstOneBegins "the first one begins here";
    FirstDefinition "the first definition";
    FirstDeclaration "the first declaration";
    FirstLine "the first line";
    AnotherBegins "another begins here";
    OtherUnit "the other unit";
    OtherArc "the other arc";
    NextToolCall "the next TOOL CALL";
    TakesItsPlace "what takes its place";
    InFolder(folder) "in `{folder}`";
    WithoutFolder "no line names its folder";
    PrintedAs(what, word) "{what} is printed as {word}";

    // Where something begins, ends, stands or is defined.
    Here "here";
    InThisBlock "in this block";
    StandsHere "it stands here";
    BeginsHere "it begins here";
    EndsHere "it ends here";
    ComesBefore "this comes before it";
    DefinedHere "defined here";
    IsDefinedHere "it is defined here";
    SetHere "set here";
    SelectedHere "it is selected here";
    IsOpen(word) "{word} is open here";
    ProgramBegins "the program begins here";
    ProgramEnds "the program ends here";
    ProgramGoesOnElsewhere "the program goes on elsewhere here";
    FileEnds "the file ends here";
    RunStopped "the run stopped here";
    TableBegins "the table begins here";
    Section "the section";
    SaidFor "the element or form that it was said for";
    Typed "what was typed";
    ItsParameters "its parameters";
    ItsProc "its PROC";

    // Calls and cycles.
    Call "the call";
    CalledHere "called here";
    ModalCall "MCALL stands here";
    Cycle "the cycle";
    CycleThatCuts "the cycle that cuts it";
    CycleDefined "the cycle is defined here";
    CycleThatTakesDefined "the cycle that takes it is defined here";
    CycleLeftOut "this cycle is left out";
    PocketMilled "the pocket is milled here";
    Pattern "the pattern";

    // Contours and what they are made of.
    ContourCalled "the contour is called here";
    ContoursNamed "the contours are named here";
    NamedHere "they are named here";
    Crosses "it crosses the element of this block";
    SolvedTogether "solved together with the blocks from here on";
    SameStraight "goes on along the same straight";
    CornerProgrammed "the corner is programmed here";
    Pole "the pole";
    PoleProgrammed "CC is programmed here";
    ThreadBefore "the thread before";
    ThreadAfter "the thread after";

    // Why a value or a position is not known.
    ActionSets "this action sets it";
    Measured "it is measured here";
    MeasuringLeftOut "the measuring is left out here";
    MovesNoAxis "this word moves no axis along a path";
    ToolChanges "the tool changes here, and its tip stands elsewhere";
    EdgeChanges "another cutting edge is selected here, and its tip stands elsewhere";
    CallMoves "what is called here moves the axis, as `[programs]` says";
    ProbeMoves "a probe moves the axis here, and what it does is left out";
    CurveTableLeftOut "a curve table names the axis here, and is left out";
    PlaneTurns "the working plane turns here";
    MachineCoordinate "the axis goes to a machine coordinate here";

    // Beside a corner and under compensation.
    ElementBefore "element before";
    ElementAfter "element after";
    LineBefore "line before";
    LineAfter "line after";
    ThisElement "this element";
    ThisBlock "this block";
    LeftOut "left out";
    CompensationBegins "compensation begins here";
    EndsCompensation "this block ends the compensation";
    ToolLeaves "the tool leaves the contour here";
    Change "the change";
}
