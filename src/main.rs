//! The `partc` command.

use std::process::ExitCode;

fn main() -> ExitCode {
    partc::cli::main()
}
