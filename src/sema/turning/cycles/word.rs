//! The words of the cycles by name: what the plans read.

use crate::sema::cycle::row::Name;

macro_rules! words {
    ($($name:ident)*) => {
        $(pub(in super::super) const $name: Name = Name::Word(stringify!($name));)*
        #[cfg(test)]
        pub(super) const ALL: &[Name] = &[$($name),*];
    };
}

words! {
    A B C D E F H I IC ID J K NS O P Q R RB RI RK U V W X XA Z ZA
}
