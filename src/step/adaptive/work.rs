//! The work of each torque in a run: its power at the run's states, summed by Gauss's quadrature.

use super::dense::AdaptiveRun;
use super::largest;
use super::switching::{piece, signed};
use crate::attitude;
use crate::body::State;
use crate::error::{Error, Refusal, Subject};
use crate::number::Analytic;
use crate::step::system::System;
use alloc::vec;
use alloc::vec::Vec;
use num_traits::FromPrimitive;

/// Nodes and weights on an interval from -1 to 1, the others by symmetry: exact to the power 15.
const GAUSS_8: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
];

/// The most panels of the quadrature.
const MOST: usize = 1 << 14;

/// How many tolerances of a step the works of all torques may be off the energy gained: states within a step
/// and at its end have errors of their own.
const CLOSING: f64 = 1e3;

/// The work of each torque from `start` on, J, to the tolerance of the run relative to all energy on the way.
pub(in crate::step) fn work<T: Analytic + Copy + FromPrimitive>(
    system: &System<T>,
    start: &State<T>,
    duration: f64,
    tolerance: f64,
    budget: usize,
) -> Result<Vec<f64>, Error> {
    let by = |panels: usize| by_panels(system, start, duration, tolerance, budget, panels);
    // About one a radian at first.
    let turned = largest(system.omega(&start.momentum).as_slice()) * duration.abs();
    let mut panels = 1 + turned.min(MOST as f64) as usize;
    let (mut before, _, _) = by(panels)?;
    loop {
        panels *= 2;
        let (now, moved, end) = by(panels)?;
        let (first, last) = (signed(system.energy(start)), signed(system.energy(&end)));
        // Two quadratures that both miss a loss which is over at once agree; the energy says so.
        let missing = (now.iter().sum::<f64>() - (last - first)).abs();
        let apart = now.iter().zip(&before).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        let scale = tolerance * (first + last + moved);
        if apart <= scale && missing <= CLOSING * scale {
            return Ok(now);
        }
        if panels >= MOST {
            let what = Subject::Work;
            return Err(
                Refusal::NotConverged { what, iterations: panels, residual: apart.max(missing) }.into()
            );
        }
        before = now;
    }
}

/// The same by this number of panels or a few more; the integral of the sizes of all powers; and the end.
fn by_panels<T: Analytic + Copy + FromPrimitive>(
    system: &System<T>,
    start: &State<T>,
    duration: f64,
    tolerance: f64,
    mut budget: usize,
    panels: usize,
) -> Result<(Vec<f64>, f64, State<T>), Error> {
    let mut run = AdaptiveRun::new(system, start, duration, tolerance)?;
    let (mut work, mut moved) = (vec![0.0; system.torques().len()], 0.0);
    let mut from = 0.0;
    while from != duration {
        let (_, until) = piece(system, from, duration);
        let count = (panels as f64 * ((until - from) / duration)) as usize + 1;
        let half = 0.5 * (until - from) / count as f64;
        for panel in 0..count {
            let middle = from + (2 * panel + 1) as f64 * half;
            let nodes = GAUSS_8.iter().rev().map(|&(x, w)| (-x, w)).chain(GAUSS_8);
            for (x, weight) in nodes {
                let time = middle + x * half;
                let state = run.at(time, &mut budget)?;
                for (work, power) in work.iter_mut().zip(powers(system, &state, time)) {
                    *work += power * weight * half;
                    moved += (power * weight * half).abs();
                }
            }
        }
        from = until;
    }
    Ok((work, moved, run.at(duration, &mut budget)?))
}

/// The power of each torque, W.
fn powers<T: Analytic + Copy + FromPrimitive>(
    system: &System<T>,
    state: &State<T>,
    time: f64,
) -> impl Iterator<Item = f64> {
    let rotation = attitude::rotation_matrix(&state.attitude);
    let (omega, momentum) = (system.omega(&state.momentum), state.momentum);
    let then = *system.time() + T::from_f64(time).unwrap_or_else(T::zero);
    system.torques().iter().map(move |torque| {
        signed(torque.at(system.inverse(), &then, &rotation, &momentum, &omega).dot(&omega))
    })
}
