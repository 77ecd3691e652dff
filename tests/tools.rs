//! The last lines of `cargo test`: which checks did nothing, because what they need is not on this machine.

#[allow(dead_code, reason = "the suite uses more of it")]
#[path = "suite/tools.rs"]
mod tools;

fn main() {
    let missing = tools::missing();
    // Listing the tests is no run.
    if std::env::args().any(|argument| argument == "--list") {
        return;
    }
    match missing.len() {
        0 => println!("every check had what it needs"),
        n => println!("{n} checks did nothing: {}", missing.join("; ")),
    }
}
