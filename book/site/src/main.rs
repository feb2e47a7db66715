//! Draws the figures and builds the pages, for the default program and for mdBook. The exercises' commands
//! are in `../../exercises/command`, all others in `../../commands`, so that `cargo run` compiles none of
//! them.

use std::io::{stdin, stdout};
use std::process::ExitCode;
use tumbling_site::preprocess::{protocol, supports};
use tumbling_site::share::Site;
use tumbling_site::{build, complain, everything};

fn main() -> ExitCode {
    let words: Vec<_> = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let done = match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => everything(),
        ["build"] => build::build(None),
        ["build", "--site", address] => Site::parse(address).and_then(|site| build::build(Some(&site))),
        // mdBook sends a book. Before that it asks which pages need the change, and reads only the exit code.
        ["preprocess"] => protocol::answer(stdin(), stdout()).map_err(|e| e.to_string()),
        ["preprocess", "supports", renderer] => return ExitCode::from(u8::from(!supports(renderer))),
        _ => Err("`cargo run -- --help` lists the commands".into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            complain!("error: {reason}");
            ExitCode::FAILURE
        }
    }
}
