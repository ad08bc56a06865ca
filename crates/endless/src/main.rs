//! The program `endless`. All of it is in the library beside it.

use std::process::ExitCode;

fn main() -> ExitCode {
    endless::main()
}
