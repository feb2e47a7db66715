"""Published integrators of Python on the stories with a torque: DOP853 of SciPy, and heyoka, a Taylor integrator that compiles the law.

The program of the peers runs this and asks by lines, `SOLVER<tab>STORY<tab>TOLERANCE`; each is answered by a line: seconds, steps,
the attitude (scalar first), the momentum in body axes; or `refused`, and why. The first line names the solvers found here, with their
versions. The time is that of one run in this process, from a state that is set to one that is read; compiling the law, and all else that
is done once, is left out. SciPy's law is plain Python: it stands here for scale.

    python3 -m venv ENV; ENV/bin/pip install -r crates/measure/peers/requirements.txt
    PATH=ENV/bin:$PATH cargo run --release -- measure --peers
"""

import json
import sys
from math import cos, sin
from pathlib import Path
from time import perf_counter

STORIES = {story["name"]: story for story in
           json.loads((Path(__file__).parent / "../data/truth.json").read_text())["stories"]}
FOUND = {}
try:
    import heyoka

    FOUND["heyoka"] = heyoka.__version__
except ImportError:
    pass
try:
    import scipy
    from scipy.integrate import DOP853

    FOUND["SciPy"] = scipy.__version__
except ImportError:
    pass


class Law:
    """q' = q w / 2, L' = L x w + torque, the momentum in units of its size at the start; of numbers or of heyoka's expressions."""

    def __init__(self, story):
        self.moments = story["moments"]
        start = [i * w for i, w in zip(self.moments, story["omega"])]
        self.size = sum(x * x for x in start) ** 0.5
        self.start = [1.0, 0.0, 0.0, 0.0] + [x / self.size for x in start]
        self.inverse = [self.size / i for i in self.moments]
        self.lever = [story.get("weight", 0.0) * x / self.size for x in story.get("arm", [0.0] * 3)]
        self.damping = [c / i for c, i in zip(story.get("damping", [0.0] * 3), self.moments)]
        self.gradient, self.orbit = story.get("gradient", 0.0) / self.size, story.get("orbit", 0.0)
        self.push, self.rate = [x / self.size for x in story.get("push", [0.0] * 3)], story.get("rate", 0.0)
        self.phases = [(seconds, [x / self.size for x in torque])
                       for seconds, torque in story.get("phases") or [[story["t"], [0.0] * 3]]]

    def rates(self, t, y, pulse, cos, sin):
        s, a, b, c, l, m, n = y
        i, (x, v, z) = self.moments, (k * p for k, p in zip(self.inverse, (l, m, n)))
        dl = [m * z - n * v, n * x - l * z, l * v - m * x]
        if any(self.lever):
            p, q, r = self.lever
            up = 2 * (a * c - s * b), 2 * (b * c + s * a), 1 - 2 * (a * a + b * b)
            dl = [dl[0] - (q * up[2] - r * up[1]), dl[1] - (r * up[0] - p * up[2]), dl[2] - (p * up[1] - q * up[0])]
        if any(self.damping):
            dl = [d - k * p for d, k, p in zip(dl, self.damping, (l, m, n))]
        if self.gradient:
            e, f = cos(self.orbit * t), sin(self.orbit * t)
            g = (e * (1 - 2 * (b * b + c * c)) + f * (2 * (a * b + s * c)),
                 e * (2 * (a * b - s * c)) + f * (1 - 2 * (a * a + c * c)),
                 e * (2 * (a * c + s * b)) + f * (2 * (b * c - s * a)))
            k = self.gradient
            dl = [dl[0] + k * (i[2] - i[1]) * (g[1] * g[2]), dl[1] + k * (i[0] - i[2]) * (g[2] * g[0]),
                  dl[2] + k * (i[1] - i[0]) * (g[0] * g[1])]
        if any(self.push):
            swing = cos(self.rate * t)
            dl = [d + p * swing if p else d for d, p in zip(dl, self.push)]
        if pulse is not None:
            dl = [d + p for d, p in zip(dl, pulse)]
        return [0.5 * (-a * x - b * v - c * z), 0.5 * (s * x + b * z - c * v), 0.5 * (s * v - a * z + c * x),
                0.5 * (s * z + a * v - b * x), *dl]


class Compiled:
    """heyoka's integrator of a story at a tolerance; pulses are its parameters."""

    def __init__(self, story, tolerance):
        self.law = law = Law(story)
        names = heyoka.make_vars("s", "a", "b", "c", "l", "m", "n")
        pulse = [heyoka.par[k] for k in range(3)] if len(law.phases) > 1 else None
        rates = law.rates(heyoka.time, names, pulse, heyoka.cos, heyoka.sin)
        self.run_ = heyoka.taylor_adaptive(list(zip(names, rates)), law.start, tol=tolerance)

    def run(self):
        run, law, steps, end = self.run_, self.law, 0, 0.0
        start = perf_counter()
        run.time = 0.0
        run.state[:] = law.start
        for seconds, torque in law.phases:
            end += seconds
            if len(law.phases) > 1:
                run.pars[:] = torque
            steps += run.propagate_until(end)[3]
        state = run.state.tolist()
        return perf_counter() - start, steps, state


class Interpreted:
    """SciPy's DOP853."""

    def __init__(self, story, tolerance):
        self.law, self.tolerance = Law(story), tolerance

    def run(self):
        law, steps, at = self.law, 0, 0.0
        start = perf_counter()
        state = law.start
        for seconds, torque in law.phases:
            pulse = torque if any(torque) else None
            run = DOP853(lambda t, y: law.rates(t, y.tolist(), pulse, cos, sin), at, state, at + seconds, rtol=self.tolerance,
                         atol=self.tolerance)
            while run.status == "running":
                why = run.step()
                if run.status == "failed":
                    raise ValueError(why)
                steps += 1
            at, state = at + seconds, run.y
        state = [float(x) for x in state]
        return perf_counter() - start, steps, state


KINDS = {"heyoka": Compiled, "SciPy": Interpreted}
READY = {}


def answer(solver, story, tolerance):
    key = solver, story, tolerance
    if key not in READY:
        READY[key] = KINDS[solver](STORIES[story], float(tolerance))
    ready = READY[key]
    seconds, steps, state = ready.run()
    state[4:] = [x * ready.law.size for x in state[4:]]
    return " ".join(map(repr, [seconds, steps, *state]))


def main():
    print(" ".join(f"{name}={version}" for name, version in FOUND.items()), flush=True)
    for line in sys.stdin:
        try:
            print(answer(*line.rstrip("\n").split("\t")), flush=True)
        except Exception as wrong:
            print("refused", " ".join(str(wrong).split()), flush=True)


main()
