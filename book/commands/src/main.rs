//! The commands besides `build` and `exercises`; `cargo run -- --help` lists them.

mod cli;
mod command;
mod guard;
mod paper;

use clap::Parser as _;
use std::process::ExitCode;
use tumbling_site::complain;

fn main() -> ExitCode {
    match cli::run(cli::Cli::parse()) {
        Ok(code) => code,
        Err(reason) => {
            complain!("error: {reason}");
            ExitCode::FAILURE
        }
    }
}
