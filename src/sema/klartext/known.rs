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
