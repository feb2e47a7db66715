//! Shared by the benchmarks: work measured as ratios within one run, or counted under valgrind.

use std::time::Instant;

/// A piece of work by name; its argument is the number of times it has been done.
pub type Work = (&'static str, Box<dyn FnMut(u32)>);

/// The least of several measurements, ns for one.
fn time_of(work: &mut dyn FnMut(u32)) -> f64 {
    let count = 1024;
    (0..500)
        .map(|_| {
            let start = Instant::now();
            (0..count).for_each(&mut *work);
            start.elapsed().as_secs_f64() * 1e9 / f64::from(count)
        })
        .fold(f64::INFINITY, f64::min)
}

#[inline(never)]
fn counted_here(work: &mut dyn FnMut(u32)) {
    (0..1000).for_each(work);
}

/// Does what the command line requests: measures all relative to the first, counts one by name, or only
/// checks that all run.
pub fn run(mut works: Vec<Work>, unit_name: &str) {
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(at) = arguments.iter().position(|a| a == "count") {
        let wanted = arguments.get(at + 1).map_or("", String::as_str);
        for (name, work) in &mut works {
            if *name == wanted {
                counted_here(work);
            }
        }
    } else if arguments.iter().any(|a| a == "--bench") {
        let mut unit = 0.0;
        for (name, work) in &mut works {
            let time = time_of(work);
            if unit == 0.0 {
                unit = time;
            }
            println!("{name:36} {time:8.1} ns {:7.2} {unit_name}", time / unit);
        }
    } else {
        for (_, work) in &mut works {
            work(1);
        }
    }
}
