//! Draws the figures named, or all, into their committed files.
//!
//! ```text
//! cargo run --release -p tumbling-figures --example draw -- two-arrows
//! ```

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    for figure in tumbling_figures::registry() {
        if names.is_empty() || names.iter().any(|name| name == figure.name) {
            let svg = figure.draw()?;
            std::fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("{}.svg", figure.name)), &svg)?;
            println!("{:20} {:6} bytes", figure.name, svg.len());
        }
    }
    Ok(())
}
