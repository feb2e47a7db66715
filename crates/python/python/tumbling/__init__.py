"""Free rigid-body rotation in closed form, bodies under torques, and a judge of engines that turn bodies.

All that computes is the Rust library `tumbling`; the results are the same to the last bit. SI units and radians.
Attitudes take body coordinates to world, as quaternions x, y, z, w like SciPy's (w, x, y, z with `scalar_first=True`);
spins are in body axes, but for the frame that `judge` is given.
"""

from ._tumbling import (
    Batch, Comparison, Error, FittedInertia, FreeMotion, Inertia, LagrangeTop, Stepper, Story, Torque, Verdict,
    __version__, compare, fit_inertia, judge,
)

__all__ = [
    "Batch", "Comparison", "Error", "FittedInertia", "FreeMotion", "Inertia", "LagrangeTop", "Stepper", "Story", "Torque",
    "Verdict", "compare", "fit_inertia", "judge",
]
