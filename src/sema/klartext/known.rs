//! What an earlier block said, or would have said.

use std::rc::Rc;

#[derive(Debug, Default)]
pub(super) enum Known<T> {
    #[default]
    Nothing,
    /// Its definition was refused, which was reported.
    Lost,
    Given(Rc<T>),
}

impl<T> Clone for Known<T> {
    fn clone(&self) -> Known<T> {
        match self {
            Known::Nothing => Known::Nothing,
            Known::Lost => Known::Lost,
            Known::Given(known) => Known::Given(Rc::clone(known)),
        }
    }
}
