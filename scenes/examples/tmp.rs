use nalgebra::Vector3;
use std::hint::black_box;
use std::time::Instant as I;
use tumbling::exact::*;
use tumbling::scalar::Lane;
#[path = "../src/many/lanes.rs"]
mod lanes;
#[path = "../src/many/wide4.rs"]
mod wide4;
fn motions(n: usize, near: bool) -> Vec<FreeMotion> {
    let mut s = 12345u64;
    let mut r = || {
        s = s.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (s >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..n)
        .map(|_| {
            let m = Vector3::new(1.0 + 0.1 * r(), 1.2 + 0.1 * r(), 1.5 + 0.2 * r());
            let w = if near {
                Vector3::new(0.01 * r(), 1.0, 0.01 * r())
            } else {
                Vector3::new(0.3 * r(), 0.4 * r(), 1.0 + r())
            };
            FreeMotion::new(&m, &w).unwrap()
        })
        .collect()
}
fn run<T: Lane>(name: &str, ms: &[FreeMotion]) {
    let b = Batch::<T>::new(ms);
    let s = Spins::<T>::new(ms);
    let times: Vec<f64> = (0..16).map(|k| 1.0 + 3.7 * k as f64).collect();
    let zero = ms[0].at(0.0).unwrap();
    let mut out = vec![zero; ms.len() * times.len()];
    let mut ws = vec![Vector3::zeros(); out.len()];
    let (mut best, mut bs) = (f64::MAX, f64::MAX);
    for _ in 0..200 {
        let t = I::now();
        b.each(black_box(&times), |k, n, i| out[k * ms.len() + n] = i).unwrap();
        best = best.min(t.elapsed().as_secs_f64());
        black_box(&out);
        let t = I::now();
        s.each(black_box(&times), |k, n, i| ws[k * ms.len() + n] = i).unwrap();
        bs = bs.min(t.elapsed().as_secs_f64());
        black_box(&ws);
    }
    let mut bad = 0;
    for (k, &t) in times.iter().enumerate() {
        for (n, m) in ms.iter().enumerate() {
            if m.at(t).unwrap() != out[k * ms.len() + n] || m.omega(t).unwrap() != ws[k * ms.len() + n] {
                bad += 1;
            }
        }
    }
    let per = 1e9 / out.len() as f64;
    println!(
        "{name}: both {:.1} ns, spin {:.1} ns, bytes {} {} per body, differ {bad}",
        best * per,
        bs * per,
        b.bytes() / ms.len(),
        s.bytes() / ms.len()
    );
}
fn main() {
    for near in [false, true] {
        let ms = motions(256, near);
        println!("{:?}", ms[0].regime());
        let t = I::now();
        let mut k = 0;
        let times: Vec<f64> = (0..16).map(|k| 1.0 + 3.7 * k as f64).collect();
        let mut best = f64::MAX;
        for _ in 0..100 {
            let t = I::now();
            for m in &ms {
                for &t in &times {
                    black_box(m.at(black_box(t)).unwrap());
                }
            }
            best = best.min(t.elapsed().as_secs_f64());
        }
        println!("direct {:.1}", best * 1e9 / 4096.0);
        run::<f64>("f64", &ms);
        run::<lanes::Lanes<2>>("2", &ms);
        run::<lanes::Lanes<4>>("4", &ms);
        run::<lanes::Lanes<8>>("8", &ms);
        run::<wide4::Four>("wide", &ms);
    }
}
