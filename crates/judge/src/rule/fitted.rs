//! Candidates with parameters, each fitted to the record before it is compared with it.

use crate::law::LawName;
use crate::read::{Pair, is_limited, law, least, median, normal, ordered, rounded, slopes, times_the_turn};
use crate::rule::{Alteration, Base, Rule, Subject, TERMS, Turn, When, distinct, frozen};
use crate::thresholds::*;
use nalgebra::{Matrix2, Matrix3, Matrix3x2, Rotation3, SVector, UnitQuaternion, Vector2, Vector3};
use tumbling::PrincipalMoments;
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::step::Method;

/// The number by which the momentum is divided to give the turn.
pub(crate) fn momentum_for_spin(subject: &Subject, pairs: &[Pair]) -> Option<Rule> {
    let mass = median(&mut pairs.iter().filter_map(|pair| {
        let turn = pair.turn()?.norm();
        // A turn no larger than its rounding does not count.
        let mass = subject.system.momentum(&pair.from.omega).norm() * pair.h / turn;
        (turn > TURN_ROUNDINGS * f64::EPSILON).then_some(mass)
    }));
    (mass.is_finite() && mass > 0.0).then_some(Rule::plain(Base::MomentumForSpin(mass)))
}

/// This number of steps, spread unevenly over all: of steps of two alternating kinds, every Nth would be of
/// one kind.
pub(super) fn some(pairs: &[Pair], count: usize) -> Vec<Pair> {
    let place = |i: usize| i * count.min(pairs.len()) / pairs.len();
    (0..pairs.len()).filter(|&i| place(i) != place(i + 1)).map(|i| pairs[i]).collect()
}

/// By how much a rule misses the spins of the record, relative to them.
fn misses(subject: &Subject, pairs: &[Pair], rule: &Rule) -> Option<Vec<Vector3<f64>>> {
    let miss = |pair: &Pair| {
        let end = subject.spin_after(rule, pair)?;
        Some((end - pair.to.omega) / pair.to.omega.norm().max(f64::MIN_POSITIVE))
    };
    pairs.iter().map(miss).collect()
}

/// The parameter of a rule that fits the spins best, without the steps that are far off (pushes).
fn number(subject: &Subject, pairs: &[Pair], start: f64, rule: &dyn Fn(f64) -> Rule) -> Option<f64> {
    let fit = |pairs: &[Pair], start: f64| {
        least([start].into(), &|x| misses(subject, pairs, &rule(x.x)), &|x| x, RULE_GAIN).map(|x| x.x)
    };
    let first = fit(pairs, start)?;
    let off: Vec<f64> = misses(subject, pairs, &rule(first))?.iter().map(Vector3::norm).collect();
    let most = PUSHED * median(&mut off.iter().copied());
    let own: Vec<Pair> = pairs.iter().zip(&off).filter(|(_, off)| **off <= most).map(|x| *x.0).collect();
    if own.len() == pairs.len() { Some(first) } else { fit(&own, first) }
}

/// A damped rule with the damping that attitudes alone show by its own turns: it is fitted to the spins that
/// the exact motion has in them, and those of a straight turn are larger by a share that grows with the spin.
pub(super) fn refitted(subject: &Subject, pairs: &[Pair], rule: Rule) -> Rule {
    let few = some(pairs, COMPARED.0);
    let sought = few.iter().all(|pair| pair.to.ahead.is_some());
    let Some(Alteration::Damped { factor, when, steps, term, .. }) = rule.alteration.filter(|_| sought)
    else {
        return rule;
    };
    let h = few.first().map_or(f64::NAN, |pair| pair.h / f64::from(steps));
    let with =
        |factor| rule.base.but(Alteration::Damped { factor, rate: rate(factor, h), when, steps, term });
    let misses = |factor: &SVector<f64, 1>| {
        few.iter().map(|pair| Some(subject.left_of_turns(&with(factor.x), pair)?.0)).collect()
    };
    least([factor].into(), &misses, &|x| x, RULE_GAIN).map_or(rule, |found| with(found.x))
}

/// Rules with one number, or none: damping, another gyroscopic term, another turn, a cap.
pub(crate) fn compound(subject: &Subject, pairs: &[Pair], rounding: f64) -> Vec<Rule> {
    let few = &*some(pairs, FITTED_STEPS);
    let with_attitude = pairs.first().is_some_and(|pair| pair.from.attitude.is_some());
    let of_spin = pairs.iter().all(|pair| pair.to.ahead.is_none());
    let whens = places(with_attitude, of_spin);
    let (term, turned) = (law(few, &subject.moments).1, with_attitude.then(|| times_the_turn(few)));
    let (mut all, cap) = (Vec::new(), capped(pairs, rounding));
    let wrong = known_term(term_under_drag(few, &subject.moments));
    for base in [Base::all(), frozen(pairs)].concat() {
        all.extend(damped(subject, few, (base, 1, 1.0), whens, rounding));
        let wrong = wrong.filter(|_| !base.is_still());
        all.extend(wrong.into_iter().flat_map(|term| damped(subject, few, (base, 1, term), whens, rounding)));
        if matches!(base, Base::FrozenTensor(..)) {
            continue;
        }
        all.extend(of_term(subject, few, base, term, turned.filter(|_| of_spin)));
        // It cuts what the base makes beyond it.
        let cuts = |most: &f64| {
            let beyond = most * (1.0 + BEYOND.max(CAPPED_ROUNDINGS * rounding));
            let own = |pair: &Pair| subject.spin_after(&Rule::plain(base), pair);
            few.iter().filter_map(own).any(|omega| omega.norm() > beyond)
        };
        all.extend(cap.filter(cuts).map(|most| base.but(Alteration::Capped(most))));
    }
    if term > 1.5 && turned.is_none_or(|turned| turned > 1.5) {
        // Rows that are left out, with the rest counted as if they were not.
        let rows = (term.min(STEPS_PER_ROW_MOST) - 0.5) as u32..=term.min(STEPS_PER_ROW_MOST) as u32 + 1;
        let times = if with_attitude { Alteration::Times } else { Alteration::TermOrTimes };
        for rows in rows.filter(|rows| *rows > 1) {
            all.extend(Base::every().map(|base| base.in_parts(rows).but(times(f64::from(rows)))));
        }
    }
    if with_attitude && of_spin {
        all.extend(of_turns());
    }
    all
}

/// The common mistake that a multiple of the gyroscopic term is near to.
fn known_term(times: f64) -> Option<f64> {
    TERMS.map(|known| known.0).into_iter().find(|known| (known - times).abs() < TERM_APART)
}

/// The ratio of the gyroscopic term to its right size under drag, by least squares.
fn term_under_drag(pairs: &[Pair], moments: &Vector3<f64>) -> f64 {
    let (mut own, mut both) = (Matrix2::zeros(), Vector2::zeros());
    for Pair { from, to, h } in pairs {
        let mean = (from.omega + to.omega) / 2.0;
        let along =
            Matrix3x2::from_columns(&[angular_acceleration(moments, &mean, &Vector3::zeros()), -mean]);
        // Equal weight for slow and fast steps.
        let weight = mean.norm_squared().powi(-2);
        own += along.tr_mul(&along) * weight;
        both += along.tr_mul(&((to.omega - from.omega) / *h)) * weight;
    }
    own.lu().solve(&both).map_or(f64::NAN, |numbers| numbers.x)
}

/// The places in a step where damping may act: spins alone do not show whether before or after the turn,
/// and turns alone do not show on which side of the row.
const fn places(with_attitude: bool, of_spin: bool) -> &'static [&'static [When]] {
    match (with_attitude, of_spin) {
        (true, true) => &[&[When::Before], &[When::Beside], &[When::After, When::Turned]],
        (true, false) => &[&[When::After, When::Open]],
        (false, _) => &[&[When::Before], &[When::Beside], &[When::Open]],
    }
}

/// Damping in each of several steps per row, as many as the header gives, if it does.
pub(super) fn in_steps(subject: &Subject, pairs: &[Pair], rounding: f64, per_row: Option<u32>) -> Vec<Rule> {
    let few = &*some(pairs, TRIED_IN_PARTS[0]);
    let with_attitude = pairs.first().is_some_and(|pair| pair.from.attitude.is_some());
    let whens = places(with_attitude, pairs.iter().all(|pair| pair.to.ahead.is_none()));
    let steps = per_row.map_or_else(|| DAMPED_STEPS.to_vec(), |steps| vec![steps]);
    let mut all = Vec::new();
    for steps in steps.into_iter().filter(|steps| *steps > 1) {
        let bases = Base::all().into_iter().map(|base| base.in_parts(base.parts().saturating_mul(steps)));
        for base in bases.filter(|base| base.parts() > 1) {
            all.extend(damped(subject, few, (base, steps, 1.0), whens, rounding));
        }
    }
    all
}

/// Another gyroscopic term, or other times, with which a base fits the spins.
fn of_term(subject: &Subject, few: &[Pair], base: Base, term: f64, turned: Option<f64>) -> Vec<Rule> {
    // A rule that keeps the laws goes along the exact motion's curve, at any rate that a number gives; an
    // accurate one nearly so. With attitudes both would have to be off by one factor.
    // The mean spin turns the attitude alone.
    let with_attitude = few.first().is_some_and(|pair| pair.from.attitude.is_some());
    // An attitude that turns about another axis, in short turns, says nothing of the times.
    let across = median(&mut few.iter().filter_map(Pair::across));
    let about_it = with_attitude && !(NEARER_READING..f64::INFINITY).contains(&across);
    let is_accurate = matches!(base, Base::Method(method, _) if method.info().order > 2
        || !with_attitude && method == Method::MeanSpinRungeKutta4);
    let keeps = is_accurate || Rule::plain(base).keeps(LawName::Separatrix);
    if base.is_still() {
        return of_still(few, base, turned.filter(|_| about_it));
    }
    if keeps && turned.is_none() && base != Base::Exact || !term.is_finite() {
        return Vec::new();
    }
    let fitted = number(subject, few, term, &|times| base.but(Alteration::TermOrTimes(times)));
    let Some(times) = fitted.filter(|times| times.abs() > NEAR_A_TERM[1]) else { return Vec::new() };
    // Spins made from turns are those of the exact motion, and a wrong term's are off from these.
    let is_sought = few.iter().any(|pair| pair.to.ahead.is_some());
    let times = match is_sought {
        true if times < 0.0 => times.round().min(-1.0),
        true => known_term(times).unwrap_or(times),
        false => times,
    };
    let far = (times - 1.0).abs();
    let is_seen = |how: &Alteration| match how {
        Alteration::Times(own) => (own - 1.0).abs() > NEAR_A_TERM[1],
        _ if !keeps => far > NEAR_A_TERM[1],
        _ => base == Base::Exact && far > RATE_APART,
    };
    let turned = turned.or(Some(1.0)).filter(|_| about_it);
    multiples(times, turned).filter(is_seen).map(|how| base.but(how)).collect()
}

/// Other times for a constant spin, which only the turns show.
fn of_still(few: &[Pair], base: Base, turned: Option<f64>) -> Vec<Rule> {
    let Some(ratio) = turned.filter(|ratio| !is_limited(*ratio, few)) else {
        return Vec::new();
    };
    let times = rounded(ratio).unwrap_or(ratio);
    let left_out = (2.0..=WHOLE_MOST).contains(&times) && times.fract() == 0.0;
    let bases = [Some(base), left_out.then(|| base.in_parts(times as u32))];
    // No times are so much too long: an attitude that turns less hardly turns.
    let turns = times * WHOLE_MOST >= 1.0;
    let apart = turns && (times - 1.0).abs().min((1.0 / times - 1.0).abs()) > PACE_APART;
    let all = bases.into_iter().flatten().filter(|_| apart);
    all.map(|base| base.but(Alteration::Times(times))).collect()
}

/// Turns on the wrong side, repeated, or by the wrong spin.
fn of_turns() -> Vec<Rule> {
    let (mut all, turned) = (Vec::new(), |base: Base, turn| base.but(Alteration::Turned(turn)));
    for base in distinct(Base::all().into_iter().chain(Base::every()).collect()) {
        all.extend([Turn::Old, Turn::Late, Turn::Early].map(|turn| turned(base, turn)));
    }
    for base in Base::all().into_iter().chain([Base::PositionStage(1)]) {
        // Of a spin that stays, a turn that is made twice may as well be one in times that are wrong.
        let open = |turn: &Turn| !(base.is_still() && matches!(turn, Turn::TwiceBefore | Turn::TwiceAfter));
        all.extend(Turn::OTHERS.into_iter().filter(open).map(|turn| turned(base, turn)));
    }
    all
}

/// What a multiple of the gyroscopic term may mean, given how many times as far as the spin the attitude
/// turns, if there is one.
fn multiples(times: f64, turned: Option<f64>) -> impl Iterator<Item = Alteration> {
    let of_times = turned.is_some_and(|turned| (turned - 1.0).abs() > (times - 1.0).abs() / 2.0);
    let one = match turned {
        _ if times < 0.0 => Alteration::Term(times),
        None => Alteration::TermOrTimes(times),
        Some(_) if of_times => Alteration::Times(times),
        Some(_) => Alteration::Term(times),
    };
    let exact = rounded(times).filter(|exact| of_times && *exact != times).map(Alteration::Times);
    exact.into_iter().chain([one])
}

/// The body with which each base makes the spins of the record: a tensor of the same trace as that named.
pub(crate) fn other_bodies(subject: &Subject, pairs: &[Pair], rounding: f64) -> Vec<Rule> {
    let few = some(pairs, FITTED_STEPS);
    // A constant spin is right for each body that has a principal axis there.
    let moves =
        |pair: &Pair| (pair.to.omega - pair.from.omega).norm() > STILL * rounding * pair.from.omega.norm();
    if !few.iter().any(moves) {
        return Vec::new();
    }
    let trace = subject.moments.sum();
    let named = subject.moments / trace;
    // Euler's equation, as it stands between two rows, is linear in the tensor.
    let linear = |numbers: &SVector<f64, 5>| {
        let tensor = tensor(numbers);
        let miss = |pair: &Pair| {
            let (mean, change) = ((pair.from.omega + pair.to.omega) / 2.0, pair.to.omega - pair.from.omega);
            (tensor * change / pair.h + mean.cross(&(tensor * mean))) / mean.norm_squared()
        };
        Some(few.iter().map(miss).collect())
    };
    let Some(start) = least([named.x, named.y, 0.0, 0.0, 0.0].into(), &linear, &inside, GAIN) else {
        return Vec::new();
    };
    let rule = |base: Base, numbers: &SVector<f64, 5>| {
        let (moments, axes) = principal(&tensor(numbers));
        let excess = 2.0 * moments.max() - moments.sum();
        let moments = if excess.abs() < BEYOND { flat(moments) } else { moments } * trace;
        PrincipalMoments::try_from(moments).ok()?;
        Some(base.but(Alteration::OtherMoments(moments, axes)))
    };
    let fitted = |base: Base| {
        let misses = |numbers: &SVector<f64, 5>| misses(subject, &few, &rule(base, numbers)?);
        let found = least(start, &misses, &inside, RULE_GAIN)?;
        // What the record does not determine is not the engine's body, nor is what hardly differs.
        let here = misses(&found)?;
        let left = (here.iter().map(Vector3::norm_squared).sum::<f64>() / here.len() as f64).sqrt();
        let errors = normal::<5>(&slopes(&found, &here, &misses)?).cholesky()?.inverse().diagonal();
        let unknown = errors.amax().sqrt() * left.max(rounding);
        let moved = (tensor(&found) - Matrix3::from_diagonal(&named)).norm();
        rule(base, &found).filter(|_| unknown < UNKNOWN_BODY && moved > OTHER_BODY)
    };
    Base::all().into_iter().filter_map(fitted).collect()
}

/// The tensor of trace 1 with these entries: two on the diagonal, and the three products.
pub(crate) fn tensor(numbers: &SVector<f64, 5>) -> Matrix3<f64> {
    let [xx, yy, yz, zx, xy] = (*numbers).into();
    Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, 1.0 - xx - yy)
}

/// The moments, in the order of the axes that their own are nearest to, and those axes.
fn principal(tensor: &Matrix3<f64>) -> (Vector3<f64>, UnitQuaternion<f64>) {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let eigen = tensor.symmetric_eigen();
    let near = |order: &[usize; 3]| (0..3).map(|i| eigen.eigenvectors[(i, order[i])].abs()).sum::<f64>();
    let order = ORDERS.into_iter().max_by(|a, b| near(a).total_cmp(&near(b))).unwrap_or([0, 1, 2]);
    let [x, y] = [0, 1].map(|i| {
        let axis = eigen.eigenvectors.column(order[i]).into_owned();
        axis * axis[i].signum()
    });
    let axes = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, x.cross(&y)]));
    (order.map(|i| eigen.eigenvalues[i]).into(), UnitQuaternion::from_rotation_matrix(&axes))
}

/// With the largest moment as the sum of the others.
fn flat(mut moments: Vector3<f64>) -> Vector3<f64> {
    let [small, middle, largest] = ordered(&moments);
    moments[largest] = moments[small] + moments[middle];
    moments
}

/// The tensor that is the nearest flat body's where no body has it.
pub(crate) fn inside(numbers: SVector<f64, 5>) -> SVector<f64, 5> {
    let (moments, axes) = principal(&tensor(&numbers));
    let moments = moments.map(|moment| moment.max(JOLT));
    if 2.0 * moments.max() <= moments.sum() {
        return numbers;
    }
    let moments = flat(moments);
    let axes = axes.to_rotation_matrix();
    let all = axes * Matrix3::from_diagonal(&(moments / moments.sum())) * axes.inverse();
    [all[(0, 0)], all[(1, 1)], all[(1, 2)], all[(2, 0)], all[(0, 1)]].into()
}

/// A base with damping in each of its steps per row by the factor that fits best, in groups of places that
/// the spins do not distinguish.
fn damped(
    subject: &Subject,
    pairs: &[Pair],
    (base, steps, term): (Base, u32, f64),
    groups: &[&[When]],
    rounding: f64,
) -> Vec<Rule> {
    let rule = |factor, rate, when| base.but(Alteration::Damped { factor, rate, when, steps, term });
    let below = 1.0 - DAMPED.max(DAMPED_ROUNDINGS * rounding);
    let mut all = Vec::new();
    for whens in groups {
        let found = number(subject, pairs, 1.0, &|factor| rule(factor, 0.0, whens[0])).zip(pairs.first());
        if let Some((factor, pair)) = found.filter(|(factor, _)| *factor > 0.0 && *factor < below) {
            let rate = rate(factor, pair.h / f64::from(steps));
            all.extend(whens.iter().map(|&when| rule(factor, rate, when)));
        }
    }
    all
}

/// The damping rate, 1/s: of the formulas that engines use, the one that gives a round number, if there is
/// one.
fn rate(factor: f64, h: f64) -> f64 {
    let ways = [(1.0 - factor) / h, (1.0 / factor - 1.0) / h, -factor.ln() / h];
    let short = |digits: usize, x: f64| format!("{x:.digits$e}").parse().unwrap_or(x);
    let round =
        ways.into_iter().map(|x| (x, short(2, x))).find(|(x, near)| (x / near - 1.0).abs() < ROUND_RATE);
    round.map_or_else(|| short(4, ways[0]), |(_, near)| near)
}

/// The greatest spin, if many rows have it.
fn capped(pairs: &[Pair], rounding: f64) -> Option<f64> {
    let most = pairs.iter().map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    let near = most * (1.0 - BEYOND.max(CAPPED_ROUNDINGS * rounding));
    let there: Vec<f64> = pairs.iter().map(|pair| pair.to.omega.norm()).filter(|x| *x >= near).collect();
    let [least, share] = CAPPED_ROWS;
    let many = there.len() >= least && there.len() * share >= pairs.len();
    (most.is_normal() && many).then(|| there.iter().sum::<f64>() / there.len() as f64)
}
