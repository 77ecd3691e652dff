//! partc for a page: a request in, an answer out, both as bytes in the memory of the module.
//!
//! The page asks `request(n)` for room of `n` bytes, writes them there, and calls `answer()`; the bytes of the answer begin at
//! `answer_at()` and are as many as `answer()` returned. They stay until the next call. [`partc::page_data::answer`] says what they
//! are. There is no block of `unsafe` here: names that a linker sees are the only thing that Rust calls unsafe.

use std::cell::RefCell;

use partc::page_data;

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for a request of so many bytes, and says where.
#[unsafe(no_mangle)]
pub extern "C" fn request(bytes: usize) -> *mut u8 {
    // The answer before is not needed any more.
    ANSWER.with_borrow_mut(|answer| *answer = Vec::new());
    REQUEST.with_borrow_mut(|request| {
        *request = vec![0; bytes];
        request.as_mut_ptr()
    })
}

/// Answers the request, and says how many bytes the answer has.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    let request = REQUEST.take();
    let made = page_data::answer(&request);
    let bytes = made.len();
    ANSWER.set(made);
    bytes
}

/// Where the answer begins.
#[unsafe(no_mangle)]
pub extern "C" fn answer_at() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.as_ptr())
}
