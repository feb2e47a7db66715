"""Free rigid-body rotation in closed form, bodies under torques, and a judge of engines that turn bodies.

The Rust library `tumbling` does all computation; the results are the same to the last bit. SI units and radians.
Attitudes take body coordinates to world, as quaternions x, y, z, w as in SciPy (w, x, y, z with `scalar_first=True`).
Spins are in body axes, except in `judge` and `compare`, where `frame` names the axes ('world' by default).
"""

from ._tumbling import (
    Batch, Comparison, Error, FittedInertia, FreeMotion, Inertia, LagrangeTop, Stepper, Story, Torque, Verdict,
    __version__, compare, fit_inertia, judge,
)

__all__ = [
    "Batch", "Comparison", "Error", "FittedInertia", "FreeMotion", "Inertia", "LagrangeTop", "Stepper", "Story", "Torque",
    "Verdict", "compare", "fit_inertia", "judge",
]
