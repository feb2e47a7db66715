//! Measures published integrators and a whole engine together with the tumbling library, in one run.
//!
//! ```text
//! cargo run --release --manifest-path crates/measure/peers/Cargo.toml -- [--quick] --into FOLDER
//! ```

mod dop853;
mod equations;
mod python;
mod rapier;
mod tsit45;

use std::path::PathBuf;
use tumbling_measure::measure::Effort;
use tumbling_measure::{AnyError, campaign, contestant};

/// The peers with their versions, as the lock file has them.
const LOCKED: &str = include_str!("../Cargo.lock");
const PEERS: [&str; 3] = ["differential-equations", "diffsol", "rapier3d-f64"];

fn version(package: &str) -> String {
    let after = LOCKED.split_once(&format!("name = \"{package}\"\nversion = \""));
    let version = after.and_then(|(_, after)| after.split('"').next());
    format!("{package} {}", version.unwrap_or("of no known version"))
}

fn main() -> Result<(), AnyError> {
    let (mut effort, mut folder) = (Effort::FULL, None);
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--quick" => effort = Effort::QUICK,
            "--into" => folder = words.next().map(PathBuf::from),
            other => return Err(format!("`{other}` is not understood").into()),
        }
    }
    let (of_python, versions) = python::found()?;
    let mut all = contestant::ours();
    all.push(Box::new(dop853::Dop853));
    all.push(Box::new(tsit45::Tsit45));
    all.push(Box::new(rapier::Rapier));
    all.extend(of_python);
    let peers: Vec<String> = PEERS.map(version).into_iter().chain(versions).collect();
    let folder = folder.ok_or("it needs `--into FOLDER`")?;
    println!("{}", campaign::write(&all, effort, &peers, &folder, &mut |what| eprintln!("{what}"))?);
    Ok(())
}
