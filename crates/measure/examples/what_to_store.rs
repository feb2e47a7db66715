//! What an engine in single precision should store between two steps: the spin in the world, the spin in the
//! body, or the momentum in the world. Prints by how much energy and momentum are off at worst, over the named
//! bodies at 60 Hz.
//!
//! `cargo run --release -p tumbling-measure --example what_to_store`

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::body::named::NamedBody;
use tumbling::step::PositionStage;

#[derive(Clone, Copy)]
enum Stored {
    WorldSpin,
    BodySpin,
    WorldMomentum,
}

const H: f32 = 1.0 / 60.0;

/// The largest relative change of the energy and of the momentum in the world, looked at once a second.
fn drift(moments: &Vector3<f32>, omega: &Vector3<f32>, stored: Stored, steps: u32) -> [f64; 2] {
    let Ok(body) = PositionStage::new(moments) else { return [f64::NAN; 2] };
    let exact = |q: &Quaternion<f32>, omega: &Vector3<f32>| {
        let q = UnitQuaternion::from_quaternion(q.cast::<f64>());
        let spin = q.inverse() * omega.cast::<f64>();
        let momentum = moments.cast::<f64>().component_mul(&spin);
        (spin.dot(&momentum), q * momentum)
    };
    let turned = |q: &Quaternion<f32>, v: &Vector3<f32>| UnitQuaternion::new_unchecked(*q) * v;
    let back = |q: &Quaternion<f32>, v: &Vector3<f32>| UnitQuaternion::new_unchecked(*q).inverse() * v;
    let mut q = Quaternion::new(0.8, 0.0, 0.6, 0.0);
    let mut omega = turned(&q, omega);
    let mut in_body = back(&q, &omega);
    let momentum = turned(&q, &moments.component_mul(&in_body));
    let (energy_0, momentum_0) = exact(&q, &omega);
    let mut most = [0.0_f64; 2];
    for k in 1..=steps {
        omega = match stored {
            Stored::WorldSpin => omega,
            Stored::BodySpin => turned(&q, &in_body),
            Stored::WorldMomentum => turned(&q, &back(&q, &momentum).component_div(moments)),
        };
        let end = body.step(&q, &omega, H);
        (q, omega) = (end.attitude, end.omega);
        in_body = back(&q, &omega);
        if k % 60 == 0 {
            let seen = match stored {
                Stored::WorldMomentum => turned(&q, &back(&q, &momentum).component_div(moments)),
                _ => omega,
            };
            let (energy, momentum) = exact(&q, &seen);
            let off = [(energy / energy_0 - 1.0).abs(), (momentum - momentum_0).norm() / momentum_0.norm()];
            most = [0, 1].map(|i| most[i].max(off[i]));
        }
    }
    most
}

fn main() {
    println!("{:28} {:>7}  {:>10} {:>10}", "stored", "minutes", "energy", "momentum");
    let all = [
        ("spin in the world", Stored::WorldSpin),
        ("spin in the body", Stored::BodySpin),
        ("momentum in the world", Stored::WorldMomentum),
    ];
    for (name, stored) in all {
        for minutes in [10, 60] {
            let mut most = [0.0_f64; 2];
            for body in NamedBody::ALL {
                let Ok(properties) = body.properties() else { continue };
                let moments = properties.inertia().principal().moments().cast::<f32>();
                for omega in [[0.3, 0.3, 10.0], [10.0, 0.3, 0.3], [1.0, 10.0, 1.0]] {
                    let off = drift(&moments, &Vector3::from(omega), stored, minutes * 3600);
                    most = [0, 1].map(|i| most[i].max(off[i]));
                }
            }
            println!("{name:28} {minutes:>7}  {:>10.1e} {:>10.1e}", most[0], most[1]);
        }
    }
}
