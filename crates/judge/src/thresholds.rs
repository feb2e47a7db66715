//! Every number that the judge decides by: what it is, its unit, and why it has this value.
//!
//! A *rounding* here is the rounding of the record's own numbers, relative to 1. Numbers that are "far" from
//! rounding, from a rule's own error or from each other are far by two or three orders of magnitude, so that
//! where exactly a limit lies does not matter: the recorded engines and the runs made for the tests stay well
//! on either side of each (`tests/`).

// What is allowed of a law.

/// Error allowed of a conserved law, as a share or in rad: a percent, which nobody sees in a game.
pub(crate) const ALLOWED: f64 = 0.01;
/// Error of phase allowed without a limit of its own, in periods, and as a share of those that the exact
/// motion makes. A right rule of second order loses far less, except near the separatrix, where a period
/// takes as long as the smallest error lets it; a rule without a gyroscopic term loses all, a clock at half
/// its rate a half.
pub(crate) const PHASE: f64 = 0.25;
/// Rows below which no record passes: of a few rows any rule may be had.
pub(crate) const ENOUGH_ROWS: u64 = 8;
/// Share by which the spin must have to change before a body that does not turn once round shows anything.
pub(crate) const ENOUGH_CHANGE: f64 = 0.1;
/// Uncertainty of the angle turned in all, rad, beyond which an `f64` does not say where in its motion the
/// body should be.
pub(crate) const UNTRACEABLE: f64 = 0.1;

// How much is kept of a record of any length.

/// Rows read before it is settled how they are meant.
pub(crate) const PROBE_ROWS: usize = 2048;
/// Pairs of rows, of those, tried for clock and reading.
pub(crate) const PROBE_PAIRS: usize = 256;
/// Steps compared with each rule, evenly from the whole record.
pub(crate) const TRIED_STEPS: usize = 2048;
/// Steps of a run that follow one another: an even stride would see one of two alternating kinds alone.
pub(crate) const TRIED_RUN: usize = 8;
/// Steps compared with each rule where its spin must first be found, step by step.
pub(crate) const TRIED_TURNS: usize = 256;
/// Share of the rows from which on rows that repeat the row before them name no rule.
pub(crate) const REPEATED: f64 = 0.05;
/// Share of the pairs of rows that must be one step apart for a rule to be named.
pub(crate) const TRIED_SHARE: f64 = 0.25;
/// Pairs of rows by which a rule in parts is looked at first, and those that it is then tried on.
pub(crate) const TRIED_IN_PARTS: [usize; 2] = [12, 128];
/// Numbers of parts of a row that every rule is tried with.
pub(crate) const PARTS: [u32; 15] = [2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16];
/// More of them for rules of order four or less, whose errors show in these too.
pub(crate) const MORE_PARTS: [u32; 10] = [17, 20, 24, 25, 32, 33, 40, 48, 50, 64];
/// The number of steps on which rules are compared first, and the error there, in errors of the best rule,
/// beyond which a rule is dropped.
pub(crate) const COMPARED: (usize, f64) = (16, 16.0);
/// Error of a rule in a step, in that of the record, below which it is as good as exact.
pub(crate) const AS_EXACT: f64 = 0.01;
/// Errors of the exact motion, in those of the best rule, beyond which no rule in parts comes near to that
/// one.
pub(crate) const CLEAR: f64 = 1e3;
/// Steps to which a rule's numbers are fitted.
pub(crate) const FITTED_STEPS: usize = 96;
/// How many times as far off as the middle step one is that is left out of a fit.
pub(crate) const PUSHED: f64 = 16.0;
/// Stretches of time in which an error's course is kept.
pub(crate) const STRETCHES: usize = 512;
/// Points kept to draw a run by: more than a picture's pixels show apart.
pub(crate) const POINTS: usize = 256;
/// Flips whose times are kept.
pub(crate) const FLIP_TIMES: usize = 512;
/// The least number of flips for a statement on their lateness, and the largest residual of the fitted line,
/// as a share of the largest lateness.
pub(crate) const LATE_FLIPS: usize = 3;
pub(crate) const LATE_LEFT: f64 = 0.02;
/// Share of the larger part of the lateness below which the other is not named.
pub(crate) const LATE_PART: f64 = 0.1;
/// Resets listed one by one.
pub(crate) const RESETS: usize = 16;
/// Rules named in a list, before "and others".
pub(crate) const RULES_NAMED: usize = 6;
/// Bytes of a line: a longer one is no row of numbers.
pub(crate) const LINE_BYTES: u64 = 1 << 16;
/// Characters of a field that an error shows.
pub(crate) const FIELD_SHOWN: usize = 40;
/// Rows before a value that is not finite, from which on the rest is judged up to there.
pub(crate) const ROWS_BEFORE_THE_END: u64 = 2;

/// Powers of two of the largest moment from which on momenta are counted in that unit: their squares are to
/// be numbers.
pub(crate) const FAR_FROM_ONE: f64 = 128.0;

// The rounding of a record's numbers.

/// Significant digits that a double has at least: with as many, numbers are taken for doubles.
pub(crate) const DIGITS_OF_DOUBLE: u32 = 16;
/// The most significant digits that a double needs.
pub(crate) const MOST_DIGITS: u32 = 17;
/// Significant digits that any decimal keeps in single precision; numbers of no more are not taken for
/// rounded to it.
pub(crate) const DIGITS_OF_SINGLE: u32 = 6;
/// The most significant digits that single precision needs.
pub(crate) const MOST_DIGITS_OF_SINGLE: u32 = 9;
/// The binary digits of single and of half precision, and the rounding of these.
pub(crate) const BITS_OF_SINGLE: u32 = 24;
pub(crate) const BITS_OF_HALF: u32 = 11;
pub(crate) const HALF: f64 = 1.0 / 1024.0;
/// With fewer digits nothing is concluded from them: 0.5 has one, and is exact.
pub(crate) const FEWEST_DIGITS: u32 = 4;
/// Rounding beyond this number of single precision's means few decimal digits.
pub(crate) const FEW_DIGITS: f64 = 2.0;
/// Rounding of a spin found from a turn of one radian or more, in roundings: two attitudes have eight
/// numbers.
pub(crate) const SPIN_FROM_TURN: f64 = 4.0;
/// Share of the largest moment by which the digits printed may miss the triangle inequality: one or two
/// digits are a mistake.
pub(crate) const MOMENTS_MISS: f64 = 2e-3;
/// Share of the sum of the moments up to which a product of inertia is rounding: engines print 1e-17 of it.
pub(crate) const PRODUCTS: f64 = 1e-9;

// The clock.

/// Share by which a step may be off and still be one.
pub(crate) const STEP_SLACK: f64 = 0.05;
/// Share by which times of equal steps, or the step named and the one seen, may differ.
pub(crate) const STEP_APART: f64 = 0.02;
/// How far the number of the header's steps from row to row may be from a whole one: for the step to be taken
/// to the digit, and to be taken at all.
pub(crate) const STEPS_PER_ROW_APART: [f64; 2] = [0.02, 0.1];
/// The greatest number of steps from row to row that is tried.
pub(crate) const STEPS_PER_ROW_MOST: f64 = 4096.0;
/// Roundings of an `f64` time within which steps are equal.
pub(crate) const EVEN_TIMES: f64 = 64.0;
/// Half units of the last digit printed by which a time may miss its step: one for each of two times, and
/// some rounding.
pub(crate) const PRINTED_HALVES: f64 = 2.01;
/// The greatest share of rows that may be missing where the step is found from times of few digits.
pub(crate) const MISSING_ROWS: f64 = 0.1;
/// Factors between recorded and true times that the rounding of such times alone can cause.
pub(crate) const TIMES_OF_ROUNDING: std::ops::RangeInclusive<f64> = 0.6..=1.6;

// How the numbers are meant.

/// Difference of turn and spin, as a share, up to which a reading makes sense: a step's own error is below
/// it.
pub(crate) const TURNS_AGREE: f64 = 0.05;
/// How much nearer another reading must come than the plain one, as a share.
pub(crate) const NEARER_READING: f64 = 0.2;
/// Cosine between changes of spin and the law's, from which on attitudes alone are read as named.
pub(crate) const LAW_AGREES: f64 = 0.8;
/// Cosine from which on the law alone names another reading.
pub(crate) const LAW_DECIDES: f64 = 0.98;
/// By how much more of that cosine a rarer reading is preferred: mirror images tie but for rounding.
pub(crate) const LAW_BETTER: f64 = 1e-3;
/// Share by which a ratio may differ from that of a known unit.
pub(crate) const UNIT_APART: f64 = 0.1;
/// Weight of a mistake that is rare, relative to the usual ones, and of one that is rarer still.
pub(crate) const RARE_MISTAKE: [f64; 2] = [1.25, 1.5];
/// Weight of the cosine with the law, in mistakes: a reading that follows the law is worth one mistake more
/// than one across it.
pub(crate) const LAW_WEIGHT: f64 = 2.0;
/// Weight of a factor of ten in the difference of turn and spin, in mistakes.
pub(crate) const TURNS_WEIGHT: f64 = 0.5;
/// Differences of turn and spin below this are a step's own error, and equal.
pub(crate) const TURNS_EQUAL: f64 = 1e-6;
/// Turn of a step, rad, beyond which the shorter way round need not be the right one: 2.5 < pi.
pub(crate) const LONG_TURN: f64 = 2.5;
/// Turn between two attitudes, rad, beyond which they say nothing of the spin: the other way round is no
/// longer far longer.
pub(crate) const FARTHEST_TURN: f64 = 2.0;
/// How near a ratio found from rows must be to a whole number, or to a fraction of small numbers, to be it,
/// as a share; the greatest whole number that it may be, and the greatest that is far enough from its
/// neighbours to be told from a unit.
pub(crate) const WHOLE_NEAR: f64 = 0.05;
pub(crate) const FRACTION_NEAR: f64 = 0.01;
pub(crate) const WHOLE_MOST: f64 = 64.0;
pub(crate) const WHOLE_SURE: f64 = 12.0;
/// What a step's own error makes of that ratio at most, in squares of the turn, rad: a straight turn a
/// twelfth, Moser and Veselov's a sixth, explicit steps of a body that gains energy more.
pub(crate) const TURN_ERROR: f64 = 0.25;
/// How far from 1 a factor of the times must be: a coarse step's own error is less.
pub(crate) const PACE_APART: f64 = 0.15;
/// Share of the turn that an engine's limit or a straight step leaves of it at least, and the turn of a step,
/// rad, from which on they show.
pub(crate) const TURN_LIMITED: [f64; 2] = [0.6, 0.7];
/// How far the change of the spin may be from what that factor makes of it, as a share.
pub(crate) const PACE_OF_LAW: f64 = 0.25;
/// By how much more a spin must go by its law in the axes named, as a cosine, for the engine to have turned
/// the attitude by it in others.
pub(crate) const SIDES_APART: f64 = 0.1;
/// What may be left of a turn, rad, by a spin found from it.
pub(crate) const TURN_LEFT: f64 = 1e-6;

// Where a motion starts anew.

/// Steps needed before a step can be out of proportion.
pub(crate) const STEPS_BEFORE_A_JUMP: u64 = 8;
/// Jump of spin or turn, as a share of the spin: less may be a rule's error.
pub(crate) const JUMP: f64 = 0.2;
/// Jump of spin, in angles turned a step: the law itself changes the spin by no more than one.
pub(crate) const JUMP_IN_TURNS: f64 = 3.0;
/// Jump, relative to the errors of the steps before.
pub(crate) const JUMP_IN_ERRORS: f64 = 100.0;
/// A turn of a slow body that is a jump, in angles turned a step.
pub(crate) const THROWN_IN_TURNS: f64 = 20.0;
/// A turn of a slow body that is a jump, in roundings.
pub(crate) const THROWN_IN_ROUNDINGS: f64 = 1e3;
/// Turn of a step, rad, beyond which the straight difference of turn and spin says nothing.
pub(crate) const SHORT_TURN: f64 = 1.0;
/// What remains from step to step of the largest error: forgotten slowly, so that a rule that goes astray now
/// and then is known to.
pub(crate) const ERROR_KEPT: f64 = 0.98;
/// Difference from the start, as a share or in rad, below which a body is back there: to the last digits of
/// the file.
pub(crate) const BACK: f64 = 1e-12;
/// Step, relative to the largest error before, that is no way back; and the same in roundings.
pub(crate) const BACK_IN_ERRORS: [f64; 2] = [4.0, 64.0];
/// Jump back to the start, as a share of the spin or in rad, and in angles turned a step.
pub(crate) const JUMP_BACK: [f64; 2] = [0.2, 1.5];
/// Share of the first spin below which a body may come to rest by itself.
pub(crate) const NEARLY_AT_REST: f64 = 1e-3;

// What is rounding.

/// Roundings within which the spin has not moved from its first value.
pub(crate) const CONSTANT: f64 = 64.0;
/// Roundings below which a change of spin is none: a record that should not show more is still.
pub(crate) const STILL: f64 = 100.0;
/// Roundings, relative to the largest component, below which a spin has no component along an axis.
pub(crate) const ON_AXIS: f64 = 8.0;
/// Roundings of a turn that spin and attitude may disagree by: the turn has eight numbers.
pub(crate) const TURN_ROUNDINGS: f64 = 8.0;
/// Roundings in a law kept: of the numbers, and of each step.
pub(crate) const LAW_ROUNDINGS: [f64; 2] = [32.0, 4.0];
/// Digits, in roundings of two rows, by which a law may be off though nothing breaks it: half a unit in each
/// of three components.
pub(crate) const LAW_DIGITS: f64 = 2.0;
/// How many times these for laws that are a product of two such numbers, or an angle between two vectors.
pub(crate) const LAW_OF_TWO: f64 = 2.0;
/// Error, as a share or in rad, beyond which a law is not said to be kept, however few the digits.
pub(crate) const KEPT: f64 = 1e-3;

// How an error grows.

/// Logarithm of a ratio from which on a quantity that stays away from what it was has grown: a tenth.
pub(crate) const GROWN: f64 = 0.1;
/// Share of the time from which on a course is looked at: before it few rows have grown.
pub(crate) const GROWTH_FROM: f64 = 1.0 / 16.0;
/// Growth from the first half of the time to the second below which an error is bounded.
pub(crate) const BOUNDED: f64 = 1.25;
/// Share of the greatest error that the second half never falls below, and the other sign never reaches,
/// where an error stayed.
pub(crate) const STAYED: f64 = 0.5;
/// Power of time from which on growth is faster than linear; from which on it is linear, not a random walk.
pub(crate) const POWERS: [f64; 2] = [1.5, 0.75];
/// Growth over the last seven eighths of the time that an exponential must have.
pub(crate) const EXPONENTIAL: f64 = 10.0;
/// The eighth of the time from which that growth is taken.
pub(crate) const EXPONENTIAL_FROM: f64 = 0.125;
/// Logarithm of a ratio beyond which even growth is exponential; and growth faster than even.
pub(crate) const OF_ITSELF: [f64; 2] = [0.05, 0.5];
/// Powers of e in a second beyond which the time of a tenfold is plainer than a factor.
pub(crate) const STEEP: f64 = 7.0;
/// Powers of e in a second below which hundredths are plainer than a factor.
pub(crate) const GENTLE: f64 = 0.1;

// Which rule made the steps.

/// Roundings within which steps are a rule's own: half of them, and 95 in 100; a step may multiply its
/// rounding.
pub(crate) const FITS: [f64; 2] = [100.0, 1e4];
/// Roundings of single precision within which steps are a rule's own: another rule is off by fewer of these.
pub(crate) const FITS_SINGLE: [f64; 2] = [8.0, 64.0];
/// Roundings of few decimal digits within which they are: each is off by half a unit at most.
pub(crate) const FITS_FEW: [f64; 2] = [2.0, 16.0];
/// Rounding of decimal digits below which steps that are a rule's to it are not those of an engine in single
/// precision: of its numbers half are off by more than 3e-8.
pub(crate) const BELOW_SINGLE: f64 = 1.5e-8;
/// Roundings within which steps are those of the exact motion, to which any accurate rule comes near.
pub(crate) const FITS_EXACT: [f64; 2] = [8.0, 256.0];
/// Rounding from which on it is that of decimal digits, not of an engine's double precision.
pub(crate) const FITS_FEW_FROM: f64 = 5e-15;
/// Roundings within which the steps of a rule are its own, and not those of one that is close to it: the
/// recorded engines' are within six, a tensor frozen at an attitude within ten.
pub(crate) const CLOSELY: [f64; 2] = [16.0, 64.0];
/// Roundings of single precision within which they are its own, and not those of a rule that is close to it.
pub(crate) const CLOSELY_SINGLE: [f64; 2] = [4.0, 64.0];
/// How many times as large as what a rule leaves of it, and as the rounding, the error must be that the rule
/// explains: rules of one order differ by a tenth of their errors and more, but for chance; and where numbers
/// of the rule are fitted to the record.
pub(crate) const ERROR_ABOVE: [f64; 2] = [32.0, 1e3];
/// That of the spin alone, where the record's attitude goes by another rule.
pub(crate) const SPIN_ABOVE: f64 = 4.0;
/// How far from the best, as factors, rules still explain a record alike: half of the steps, and 95 in 100.
pub(crate) const ALIKE: [f64; 2] = [2.0, 4.0];
/// How far from the best, in roundings, rules still explain a record alike.
pub(crate) const ALIKE_ROUNDINGS: [f64; 2] = [8.0, 64.0];
/// How far from the best, in roundings of few decimal digits.
pub(crate) const ALIKE_FEW: [f64; 2] = [2.0, 16.0];
/// Error of half of the steps, relative to the spin, below which a rule may be named though it does not fit.
pub(crate) const NEAR: f64 = 0.01;
/// How many times as far the next rule must be then.
pub(crate) const NEAR_RATIO: f64 = 1e3;
/// Roundings that a change of the spin must have for an error to be a share of it.
pub(crate) const ABOVE_ROUNDING: f64 = 16.0;
/// Error of an accurate rule's step, as a share of what the gyroscopic term changes in the step.
/// Runge and Kutta's of order four and solvers with a tolerance of 1e-4 or less leave up to 8e-5 in the runs
/// made for the tests; a term that is off by 0.5 %, 4e-3 and more. A drag may leave less than this: it is
/// tried by itself ([`ALTERED`]).
pub(crate) const ACCURATE: f64 = 1e-4;
/// How many times as well the exact motion must explain a record once it is damped, or its gyroscopic term
/// multiplied, for a rule not to be called accurate; and for that to be named.
pub(crate) const ALTERED: [f64; 2] = [3.0, 32.0];
/// Roundings within which three rows are on a straight line, and the share of all rows from which on rows
/// beside a plain bend are interpolated; and the share of what the spin's axis moves there that the turn's
/// may.
pub(crate) const STRAIGHT: [f64; 2] = [16.0, 0.05];
pub(crate) const TURNS_APART: f64 = 0.25;
/// How far from 1 a multiple of the gyroscopic term must be to be seen where no rule fits.
pub(crate) const TERM_APART: f64 = 0.2;
/// Rounding from which on numbers have as few digits as half precision or a sensor has.
pub(crate) const DIGITS_OF_A_SENSOR: f64 = 3e-4;
/// Share of a row's error that the next step takes back where rows scatter (half of it, of noise alone), and
/// the steps that it takes to say so.
pub(crate) const TAKEN_BACK: f64 = 0.3;
pub(crate) const SCATTERED_ROWS: f64 = 32.0;
/// By how many times their scatter a step of the exact motion may be off, if it is the rows that scatter.
pub(crate) const OF_SCATTER: f64 = 10.0;
/// How many times as far as steps that still fit one must be from the rule to be a jump, and in how many
/// steps there may be one: of a rule that all the others are to rounding, and of one that is not known.
pub(crate) const JUMP_IN_LIMITS: f64 = 10.0;
pub(crate) const JUMP_EVERY: [usize; 2] = [8, 50];
/// How many times as fast a spin is that rules are compared at, and the difference up to which they are one.
pub(crate) const FASTER: f64 = 3.0;
/// Relative to the spin, or in rad.
pub(crate) const SAME: f64 = 1e-9;
/// Roundings by which a rule changes energy or momentum otherwise than the record: at both ends of rows that
/// follow one another; of random ones in the turn of each step; of an engine's own in each step (SAPIEN's
/// steps have six, by the way in which it rounds); and of random ones in what a rule changes that the record
/// keeps.
pub(crate) const BIASED: [f64; 4] = [4.0, 1.5, 8.0, 8.0];
/// Share of what a rule changes in all its steps that a record changes where it keeps that law.
pub(crate) const KEPT_OF_CHANGED: f64 = 0.1;

// Rules with a number in them.

/// Share by which a spin is beyond a limit.
pub(crate) const BEYOND: f64 = 1e-9;
/// Rows at a greatest spin that make a cap: at least this number, and at least one in this number.
pub(crate) const CAPPED_ROWS: [usize; 2] = [4, 10];
/// Roundings below a greatest spin at which rows are at it.
pub(crate) const CAPPED_ROUNDINGS: f64 = 4.0;
/// Loss of spin a step, as a share, below which there is no damping.
pub(crate) const DAMPED: f64 = 1e-9;
/// Roundings by which a factor of damping must be below one.
pub(crate) const DAMPED_ROUNDINGS: f64 = 16.0;
/// Numbers of steps from row to row that are tried where the header names none.
pub(crate) const DAMPED_STEPS: [u32; 7] = [2, 3, 4, 5, 6, 8, 10];
/// How near a rate of damping must be to one of three digits to be that one, as a share.
pub(crate) const ROUND_RATE: f64 = 1e-5;
/// The cosine of the angle through which a spin turns at least that turns right round.
pub(crate) const RIGHT_ROUND: f64 = -0.99;
/// How near a multiple of the gyroscopic term must be to one that has a name, and how far from 1.
pub(crate) const NEAR_A_TERM: [f64; 2] = [1e-4, 1e-3];
/// How far from 1 a multiple of the exact motion's term must be: methods that keep the laws go at other
/// rates.
pub(crate) const RATE_APART: f64 = 0.1;
/// Standard error of a number of another body's tensor, in the sum of the moments, from which on it is not
/// determined; and the change of the tensor below which it is that of the record.
pub(crate) const UNKNOWN_BODY: f64 = 2e-3;
pub(crate) const OTHER_BODY: f64 = 1e-4;
/// Change of a number of order 1 by which derivatives are taken: the cube root of rounding, about.
pub(crate) const JOLT: f64 = 1e-6;

// A fit by least squares.

/// Shares of a step that are tried: the whole of it, or less where it leads away.
pub(crate) const FIT_SHARES: [f64; 4] = [1.0, 0.5, 0.1, 0.01];
/// Gain, as a share, below which a fit has converged.
pub(crate) const GAIN: f64 = 1e-12;
/// The same for the parameters of a rule. For the rule that made the steps, each iteration removes nearly all
/// of the error, down to rounding.
pub(crate) const RULE_GAIN: f64 = 1e-3;
/// What may be left of the spins, as a share: more is another motion.
pub(crate) const FIT_LEFT: f64 = 0.1;

// Rounds of iterations: each is more than a right record takes, and none goes on without gain.

/// Of Gauss and Newton's way in a fit, and of Newton's to the spin of a turn.
pub(crate) const FIT_ROUNDS: usize = 20;
/// Parts of a gyroscope's record that a body is fitted to, one after the other, and the rows that each has at
/// least: over the whole a first guess may be periods off.
pub(crate) const FIT_PARTS: [usize; 3] = [16, 4, 1];
pub(crate) const FIT_PART_ROWS: usize = 64;
/// Angle, rad, over which Euler's equations are summed for the first guess: much less and noise is as large
/// as the change of spin.
pub(crate) const FIT_ANGLE: f64 = 1.0;
/// What is left of a fit, in that of the fastest spin, below which slopes by differences say nothing.
pub(crate) const FIT_FLOOR: f64 = 1e-6;
/// Standard error of a moment, in the sum of all, from which on it is not determined; and the standard errors
/// by which two must differ for their axes to be.
pub(crate) const UNDETERMINED: f64 = 0.05;
pub(crate) const MOMENTS_APART: f64 = 3.0;
/// Spin's deviation from its mean, in what is left of it, up to which it is as good as steady.
pub(crate) const STEADY: f64 = 2.0;
/// Of a rule's way to the spin of a turn, of first order.
pub(crate) const RULE_ROUNDS: usize = 60;
