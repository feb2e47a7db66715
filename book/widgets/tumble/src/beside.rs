//! The exact motion for other widgets, which ask this module, because otherwise it would be most of the code
//! of each.

use exchange::Numbers;
use nalgebra::Vector3;
use tumbling::dynamics::stability::{Stability, of_spin};
use tumbling::exact::{FreeMotion, Regime};
use tumbling::{Axis, PrincipalMoments};

/// The most flips, and the most parts, in one answer.
const MOST: usize = 1500;

/// All questions begin with three principal moments, kg m², and the spin along their axes at the start,
/// rad/s.
///
/// 0, an instant: when, s. The answer: the spin along the axes, and the attitude from that at the start, real
/// part first.
///
/// 1, a motion from the start on: until when, and in how many parts. The answer: how many flips, the time of
/// each, and the spin about x at the parts' ends.
///
/// Question 2, the fate of the spin without torque; one number. 0, 1 or 2 for x, y or z: it circles that axis
/// for ever. 3: it is on the separatrix. 4: two moments are equal, and it circles the third axis at a
/// constant rate. 5: all three are equal. 6: two are equal, and it is constant. 7 plus the axis: it stays on
/// an axis of the smallest or the largest moment. 10 plus the axis: it is exactly on that of the middle one.
///
/// There is no answer where the library has none.
pub(crate) fn answer(what: u32, row: &Numbers) -> usize {
    found(what, row).unwrap_or(0)
}

fn found(what: u32, row: &Numbers) -> Option<usize> {
    let (moments, omega) = (Vector3::from(row.take::<3>(0)), Vector3::from(row.take::<3>(3)));
    let [time, parts] = row.take(6);
    let moments: PrincipalMoments = moments.try_into().ok()?;
    let motion = FreeMotion::new(moments, &omega).ok()?;
    if what == 2 {
        row.set(0, f64::from(fate(moments, &motion, &omega)? as u8));
        return Some(1);
    }
    if what == 0 {
        let now = motion.at(time).ok()?;
        let ([x, y, z], q) = (now.omega.into(), now.attitude);
        return Some(row.fill(&[x, y, z, q.w, q.i, q.j, q.k]));
    }
    let parts = (parts as usize).clamp(1, MOST);
    let mut place = 1;
    for flip in motion.flips(0.0, time).ok()?.take(MOST) {
        row.set(place, flip);
        place += 1;
    }
    row.set(0, (place - 1) as f64);
    for part in 0..=parts {
        row.set(place, motion.at(time * (part as f64 / parts as f64)).ok()?.omega.x);
        place += 1;
    }
    Some(place)
}

/// The numbers of question 2.
fn fate(moments: PrincipalMoments, motion: &FreeMotion, omega: &Vector3<f64>) -> Option<usize> {
    Some(match motion.regime() {
        Regime::Elliptic { about, .. } => moments.axis(about),
        Regime::Separatrix { .. } => 3,
        Regime::SymmetricTop { .. } => 4,
        _ => {
            let vector = moments.vector();
            let equal = (0..3).filter(|&axis| vector[axis] == vector[(axis + 1) % 3]).count();
            if equal > 0 {
                return Some(if equal == 3 { 5 } else { 6 });
            }
            let along = Axis::ALL.into_iter().find(|&axis| omega[moments.axis(axis)] != 0.0)?;
            let axis = moments.axis(along);
            match of_spin(moments, along, omega[axis]).ok()? {
                Stability::Growth { .. } => 10 + axis,
                _ => 7 + axis,
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spin_left_alone_goes_as_the_laws_of_energy_and_momentum_say() {
        let row = Numbers::empty();
        let fate = |moments: [f64; 3], omega: [f64; 3]| {
            row.fill(&[moments, omega].concat());
            assert_eq!(answer(2, &row), 1, "{moments:?} {omega:?}");
            row.get(0)
        };
        // Of moments 3, 4 and 6 a spin runs along the separatrix where 3 (4 - 3) w1² = 6 (6 - 4) w3².
        for (omega, right) in [
            ([2.1, 1.0, 1.0], 0.0),
            ([1.9, 1.0, 1.0], 2.0),
            ([2.0, -1.0, 1.0], 3.0),
            ([-1.0, 0.0, 0.0], 7.0),
            ([0.0, 2.0, 0.0], 11.0),
            ([0.0, 0.0, 0.1], 9.0),
        ] {
            assert_eq!(fate([3.0, 4.0, 6.0], omega), right, "{omega:?}");
        }
        assert_eq!(fate([2.0, 2.0, 3.0], [1.0, 0.0, 1.0]), 4.0);
        assert_eq!(fate([2.0, 2.0, 3.0], [1.0, 1.0, 0.0]), 6.0);
        assert_eq!(fate([2.0, 2.0, 2.0], [1.0, 1.0, 0.5]), 5.0);
    }

    #[test]
    fn the_motion_is_the_librarys() {
        let row = Numbers::empty();
        let (moments, omega) = (Vector3::new(10.0, 13.0, 5.0) / 12.0, Vector3::new(10.0, 0.1, 0.1));
        let asked =
            |last: [f64; 2]| [moments.x, moments.y, moments.z, omega.x, omega.y, omega.z, last[0], last[1]];
        let motion = FreeMotion::new(moments.try_into().unwrap(), &omega).unwrap();
        row.fill(&asked([20.0, 100.0]));
        let count = answer(1, &row);
        let times: Vec<f64> = motion.flips(0.0, 20.0).unwrap().collect();
        assert_eq!((row.get(0), times.len()), (8.0, 8));
        assert_eq!(row.take::<8>(1).to_vec(), times);
        assert_eq!(count, 1 + 8 + 101);
        assert_eq!(row.get(9), 10.0);
        assert_eq!(row.get(count - 1), motion.at(20.0).unwrap().omega.x);
        row.fill(&asked([3.7, 0.0]));
        assert_eq!(answer(0, &row), 7);
        let now = motion.at(3.7).unwrap();
        assert_eq!(row.take(0), [now.omega.x, now.omega.y, now.omega.z]);
        assert_eq!(row.take(3), [now.attitude.w, now.attitude.i, now.attitude.j, now.attitude.k]);
        row.fill(&asked([f64::NAN, 0.0]));
        assert_eq!(answer(0, &row), 0);
    }
}
