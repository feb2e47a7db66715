//! The families of methods, a file each.

pub(crate) mod buss;
pub(crate) mod decimal;
pub(crate) mod dormand_prince;
/// The rules by which physics engines turn a free body.
///
/// They differ in what they do with the gyroscopic term `L x w` and in how they turn the attitude by the new
/// spin. All of them bring the attitude back to length 1 after each step, as the engines do. Torques act as
/// they stand at the start of the step, except in the Runge-Kutta ones.
pub(crate) mod engine_rules {
    pub(crate) mod explicit;
    pub(crate) mod newton;
    pub(crate) mod runge_kutta;
    pub(crate) mod turn;
}
pub(crate) mod gauss;
pub(crate) mod implicit;
pub(crate) mod lie;
pub(crate) mod moser_veselov;
pub(crate) mod rk4;
pub(crate) mod spiral;
pub(crate) mod splitting;
pub(crate) mod symmetric_top;
