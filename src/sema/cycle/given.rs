//! What a call of a cycle gives: every argument once, by the name of its parameter, with its place, held against its row.

use core::fmt;

use crate::sema::run::Where;

use super::row::{Kind, Name, Parameter, Rule, Signature};

/// Larger numbers are none of a program.
const LARGEST: f64 = 1e9;

/// What is given for a parameter.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Value {
    #[default]
    Missing,
    Number(f64),
    Text(String),
    /// A word in place of a number, as FMAX.
    Word(&'static str),
    /// Neither: a value of the language that no parameter takes.
    Other,
}

/// How a value breaks what its row says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Breach {
    Missing,
    NoNumber,
    NoText,
    /// No control takes such a number.
    OutOfAllRange,
    /// A number of digits is whole and not below 0.
    NoDigits(f64),
    Negative(f64),
    /// With the alarm of the control, 0 for none.
    NotAboveZero(f64, u32),
    /// A size that is 0.
    Zero,
    NotBelow90(f64),
    NoneOf(f64, Range),
}

/// The whole numbers from one to another: `1 to 4`, `0 or 1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Range(pub i32, pub i32);

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Range(low, high) = *self;
        match high - low {
            0 => write!(f, "{low}"),
            1 => write!(f, "{low} or {high}"),
            _ => write!(f, "{low} to {high}"),
        }
    }
}

/// The arguments of a call.
#[derive(Debug, Clone)]
pub struct Given {
    pub signature: &'static Signature,
    /// How a finding calls the cycle: `CYCLE81`, `cycle 200`; empty where the block says it.
    pub called: String,
    /// Where it is called.
    pub place: Where,
    /// Millimetres per unit of length.
    pub unit: f64,
    values: Vec<(Value, Where)>,
}

/// The lists of one control write a name with and without `_` in front; it is one name.
fn bare(name: &'static str) -> &'static [u8] {
    match name.as_bytes() {
        [b'_', rest @ ..] => rest,
        all => all,
    }
}

impl Name {
    fn is(self, other: Name) -> bool {
        match (self, other) {
            (Name::Word(a), Name::Word(b)) => bare(a) == bare(b),
            _ => self == other,
        }
    }
}

impl Signature {
    /// The place of a parameter, counted from 1 as the manuals do; `None` where the cycle does not have it.
    pub fn place(&self, name: Name) -> Option<usize> {
        self.parameters.iter().position(|parameter| parameter.name.is(name)).map(|at| at + 1)
    }

    pub fn parameter(&self, name: Name) -> Option<&'static Parameter> {
        self.parameters.get(self.place(name)? - 1)
    }
}

impl Given {
    pub fn new(signature: &'static Signature, called: impl Into<String>, place: Where, unit: f64) -> Given {
        Given { signature, called: called.into(), place, unit, values: Vec::new() }
    }

    /// The next argument in the order of the row.
    pub fn push(&mut self, value: Value, place: Where) {
        self.values.push((value, place));
    }

    /// An argument by its name; one that the cycle does not have is left out.
    pub fn set(&mut self, name: Name, value: Value, place: Where) {
        let Some(at) = self.signature.place(name) else { return };
        if self.values.len() < at {
            self.values.resize(at, (Value::Missing, self.place));
        }
        self.values[at - 1] = (value, place);
    }

    /// How many arguments the call writes, empty ones in between counted.
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// The first argument that is not what its row says, by its place from 0.
    pub fn breach(&self) -> Option<(usize, Breach)> {
        self.breach_where(|_| true)
    }

    /// The same, among the parameters that count for this call.
    pub fn breach_where(&self, counts: impl Fn(&Parameter) -> bool) -> Option<(usize, Breach)> {
        let at = |at: usize| self.values.get(at).map_or(&Value::Missing, |(value, _)| value);
        let all = self.signature.parameters.iter().enumerate().filter(|(_, parameter)| counts(parameter));
        let mut found = all.filter_map(|(place, parameter)| Some((place, parameter.breach(at(place))?)));
        found.next()
    }

    /// Does the cycle have this parameter?
    pub fn takes(&self, name: Name) -> bool {
        self.signature.place(name).is_some()
    }

    /// The place of the parameter, counted from 1; 0 where the cycle does not have it.
    pub fn argument(&self, name: Name) -> usize {
        self.signature.place(name).unwrap_or(0)
    }

    /// The parameter as the list of the cycle writes it.
    pub fn written(&self, name: Name) -> String {
        self.signature.parameter(name).map_or_else(String::new, |parameter| parameter.name.to_string())
    }

    /// What is given; [`Value::Missing`] for an empty or missing argument, and for a parameter that the cycle does not have.
    pub fn value(&self, name: Name) -> &Value {
        let place = self.signature.place(name).unwrap_or(0);
        self.values.get(place.wrapping_sub(1)).map_or(&Value::Missing, |(value, _)| value)
    }

    /// The place of an argument; that of the call where it is not given.
    pub fn place_of(&self, name: Name) -> Where {
        let place = self.signature.place(name).unwrap_or(0);
        let found = self.values.get(place.wrapping_sub(1)).filter(|(value, _)| *value != Value::Missing);
        found.map_or(self.place, |(_, at)| *at)
    }

    /// The place of the argument at a place counted from 0.
    pub fn place_at(&self, at: usize) -> Where {
        let found = self.values.get(at).filter(|(value, _)| *value != Value::Missing);
        found.map_or(self.place, |(_, at)| *at)
    }

    /// Is a value given?
    pub fn has(&self, name: Name) -> bool {
        *self.value(name) != Value::Missing
    }

    pub fn number(&self, name: Name) -> Option<f64> {
        match self.value(name) {
            Value::Number(value) => Some(*value),
            _ => None,
        }
    }

    /// The number, 0 where there is none.
    pub fn or_zero(&self, name: Name) -> f64 {
        self.number(name).unwrap_or(0.0)
    }

    /// A length in mm.
    pub fn length_if(&self, name: Name) -> Option<f64> {
        self.number(name).map(|value| value * self.unit)
    }

    /// A length in mm, 0 where it is not given.
    pub fn length(&self, name: Name) -> f64 {
        self.length_if(name).unwrap_or(0.0)
    }

    /// A length in mm without its sign.
    pub fn magnitude(&self, name: Name) -> f64 {
        self.length(name).abs()
    }

    /// A text; `None` for an empty one.
    pub fn text(&self, name: Name) -> Option<&str> {
        match self.value(name) {
            Value::Text(text) if !text.is_empty() => Some(text),
            _ => None,
        }
    }

    /// The word in place of a number.
    pub fn word(&self, name: Name) -> Option<&'static str> {
        match self.value(name) {
            Value::Word(word) => Some(word),
            _ => None,
        }
    }

    /// The first of them that is given below 0.
    pub fn below_zero(&self, names: &[Name]) -> Option<Name> {
        names.iter().copied().find(|name| self.or_zero(*name) < 0.0)
    }

    /// The nearest whole number; 0 where there is none.
    pub fn whole(&self, name: Name) -> i32 {
        self.number(name).and_then(crate::sema::value::whole).unwrap_or(0)
    }

    /// A decimal digit of a coded number, from the right: 0 is the units.
    pub fn digit(&self, name: Name, position: u32) -> i32 {
        digit(self.whole(name), position)
    }
}

/// A decimal digit of a number, from the right.
pub fn digit(value: i32, position: u32) -> i32 {
    value.unsigned_abs().checked_div(10u32.saturating_pow(position)).map_or(0, |rest| (rest % 10) as i32)
}

impl Parameter {
    /// How a value breaks the row.
    pub fn breach(&self, value: &Value) -> Option<Breach> {
        match value {
            Value::Missing => self.needed.then_some(Breach::Missing),
            _ => self.breach_of_kind(value).or_else(|| match value {
                Value::Number(number) => self.rule.breach(*number),
                _ => None,
            }),
        }
    }

    /// A number among the texts is a sign of a comma too many or too few, 0 for a text that changes nothing apart; a word stands for a number where the cycle reads words.
    pub fn breach_of_kind(&self, value: &Value) -> Option<Breach> {
        match (value, self.kind) {
            (Value::Number(number), _) if !number.is_finite() || number.abs() > LARGEST => Some(Breach::OutOfAllRange),
            (Value::Number(number), Kind::Text) if *number != 0.0 || self.without_effect.is_none() => {
                Some(Breach::NoText)
            }
            (Value::Number(number), Kind::Digits(_)) if *number < 0.0 || number.fract() != 0.0 => {
                Some(Breach::NoDigits(*number))
            }
            (Value::Missing | Value::Number(_) | Value::Word(_), _)
            | (Value::Text(_) | Value::Other, Kind::Text | Kind::Either) => None,
            (Value::Text(_) | Value::Other, _) => Some(Breach::NoNumber),
        }
    }
}

impl Rule {
    fn breach(self, number: f64) -> Option<Breach> {
        match self {
            Rule::Any => None,
            Rule::Unsigned => (number < 0.0).then_some(Breach::Negative(number)),
            Rule::Above(alarm) => (number <= 0.0).then_some(Breach::NotAboveZero(number, alarm)),
            Rule::AboveOrEmpty(alarm) => (number < 0.0).then_some(Breach::NotAboveZero(number, alarm)),
            Rule::Size => (number == 0.0).then_some(Breach::Zero),
            Rule::Below90 => (!(0.0..90.0).contains(&number)).then_some(Breach::NotBelow90(number)),
            Rule::OneOf(low, high) => {
                let fits = number.fract() == 0.0 && (f64::from(low)..=f64::from(high)).contains(&number);
                (!fits).then_some(Breach::NoneOf(number, Range(low, high)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::row::{Status, length, number, words};
    use super::*;

    const ROW: Signature = Signature {
        name: "CYCLE",
        what: "",
        status: Status::Built,
        source: "",
        parameters: &[
            length("_RTP", "").needed(),
            length("W", "").rule(Rule::Above(0)),
            number("Q", "").rule(Rule::OneOf(0, 2)),
            words("NAME", ""),
        ],
    };

    fn given(values: &[Value]) -> Given {
        let mut given = Given::new(&ROW, "CYCLE", Where::Block, 25.4);
        for value in values {
            given.push(value.clone(), Where::Block);
        }
        given
    }

    #[test]
    fn each_value_is_held_against_its_row() {
        use Value::{Missing, Number, Text};
        for (values, breach) in [
            (&[][..], Some((0, Breach::Missing))),
            (&[Number(1.0)], None),
            (&[Number(0.0), Number(0.0)], Some((1, Breach::NotAboveZero(0.0, 0)))),
            (&[Number(f64::NAN)], Some((0, Breach::OutOfAllRange))),
            (&[Number(0.0), Missing, Number(1.5)], Some((2, Breach::NoneOf(1.5, Range(0, 2))))),
            (&[Number(0.0), Missing, Number(3.0)], Some((2, Breach::NoneOf(3.0, Range(0, 2))))),
            (&[Text("A".to_owned())], Some((0, Breach::NoNumber))),
            (&[Number(0.0), Missing, Missing, Number(2.0)], Some((3, Breach::NoText))),
            (&[Number(0.0), Missing, Missing, Text("A".to_owned())], None),
        ] {
            let made = given(values).breach();
            assert_eq!(format!("{made:?}"), format!("{breach:?}"), "{values:?}");
        }
    }

    #[test]
    fn a_name_counts_with_and_without_its_underline() {
        let given = given(&[Value::Number(2.0)]);
        assert_eq!(given.length(Name::Word("RTP")), 50.8);
        assert_eq!(given.argument(Name::Word("RTP")), 1);
        assert_eq!(given.written(Name::Word("RTP")), "_RTP");
        assert_eq!(given.number(Name::Word("NONE")), None);
    }

    #[test]
    fn digits_count_from_the_right() {
        let given = given(&[Value::Missing, Value::Missing, Value::Number(4321.0)]);
        assert_eq!([0, 1, 3, 4, 40].map(|at| given.digit(Name::Word("Q"), at)), [1, 2, 4, 0, 0]);
    }
}
