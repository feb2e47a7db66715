//! The exact motion, for the widgets that set something beside it: they ask this module, since most of each
//! would be that.

use exchange::Numbers;
use nalgebra::Vector3;
use tumbling::exact::FreeMotion;

/// The most flips, and the most parts, in one answer.
const MOST: usize = 1500;

/// Both questions begin with three principal moments, kg m², and the spin along their axes at the start,
/// rad/s.
///
/// 0, an instant: when, s. The answer: the spin along the axes, and the attitude from that at the start, real
/// part first.
///
/// 1, a motion from the start on: until when, and in how many parts. The answer: how many flips, the time of
/// each, and the spin about x at the parts' ends.
///
/// There is no answer where the library has none.
pub(crate) fn answer(what: u32, row: &Numbers) -> usize {
    found(what, row).unwrap_or(0)
}

fn found(what: u32, row: &Numbers) -> Option<usize> {
    let (moments, omega) = (Vector3::from(row.take::<3>(0)), Vector3::from(row.take::<3>(3)));
    let [time, parts] = row.take(6);
    let motion = FreeMotion::new(moments.try_into().ok()?, &omega).ok()?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_motion_is_the_librarys() {
        let row = Numbers::new();
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
