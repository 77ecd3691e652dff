//! Functions and operators of formulas, in all dialects.

/// A function of one value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Function {
    Negate,
    Abs,
    /// -1, 0 or 1; what 0 gives differs.
    Sign,
    /// Without its decimals, towards zero.
    Int,
    /// The decimals alone.
    Fraction,
    Round,
    /// Away from zero.
    RoundUp,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sqrt,
    Square,
    Ln,
    Log,
    Exp,
    Not,
    BitNot,
}

/// An operator between two values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    WholeDivide,
    Modulo,
    Power,
    /// √(a² + b²)
    RootOfSum,
    /// √(a² − b²)
    RootOfDifference,
    /// Angle from 0 to 360 degrees; the opposite (sine) side stands first.
    Angle,
    BitAnd,
    BitOr,
    BitXor,
    And,
    Or,
    Xor,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}
