"""How far FRB and this library are from motions known to 40 digits, and their times; prints the record frb.csv.

    python3 frb.py FOLDER COMMIT > frb.csv

FOLDER has frb_matrix and frb_quaternion, built as frb.c says. The motions are those of tests/data/free-motion.json
and tests/data/late.json, but for the body at rest, since FRB wants a momentum of length 1. Errors are angles in rad;
units are those of tests/data/README.md, 2^-53 times the condition number of the quaternion where that is above 1.
Needs mpmath and gfortran's library; builds examples/free_motion.rs."""
import json
import re
import subprocess
import sys
from datetime import date
from math import isfinite
from pathlib import Path
from mpmath import asin, mp, mpf, sqrt

mp.dps = 45
WAYS = "matrix", "quaternion"
HOME = Path(__file__).parents[3]
KINDS = {
    "box-x-flip": "flips about the middle axis",
    "negative-time": "flips about the middle axis",
    "separatrix": "on the separatrix",
    "prolate": "equal moments", "oblate": "equal moments", "symmetric": "equal moments", "sphere": "equal moments",
    "spin-": "steady spin",
}


def kind_of(name, file):
    if file == "late":
        return "six bodies to a billion flips"
    return next((kind for start, kind in KINDS.items() if name.startswith(start)), "boxes and a plate and rods")


def distance(found, true):
    return sqrt(sum((mpf(x) - y) ** 2 for x, y in zip(found, true)))


def matrix(q):
    w, x, y, z = q
    return [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
            2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
            2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]


def angle(found, q):
    """The angle between two attitudes, in rad; that of a matrix by its nine numbers."""
    if len(found) == 9:
        return 2 * asin(min(distance(found, matrix(q)) / sqrt(mpf(8)), 1))
    return 4 * asin(min(distance(found, q), distance(found, [-x for x in q])) / 2)


def frb(way, case, time, nodes=0):
    given = [str(x) for x in [nodes] + case["inertia"] + case["w0"] + [time]]
    try:
        run = subprocess.run([f"{sys.argv[1]}/frb_{way}", *given], capture_output=True, text=True, timeout=20)
    except subprocess.TimeoutExpired:
        return "no end"
    if run.returncode:
        return "crash"
    if "invalid" in run.stdout:
        return "refused"
    numbers = [float(x) for x in run.stdout.split()]
    return numbers[:3], numbers[3:]


def error(answer, case, k):
    if isinstance(answer, str):
        return [answer] * 2
    spin, attitude = answer
    w, q = ([mpf(x) for x in case[field][k]] for field in "wq")
    lost = ["" if all(map(isfinite, part)) else "not finite" for part in answer]
    return [lost[0] or f"{float(distance(spin, w) / distance(w, [0] * 3)):.1e}",
            lost[1] or f"{float(angle(attitude, q)):.1e}"]


def times():
    """The least ns for an instant of the two bodies, over runs in turns; ours with and without preparing."""
    found = {}
    bench = ["cargo", "bench", "-q", "-p", "tumbling-measure", "--bench", "exact"]
    for _ in range(4):
        for way in WAYS:
            run = subprocess.run([f"{sys.argv[1]}/frb_{way}"], capture_output=True, text=True, check=True)
            for body, short, ns in re.findall(r"(generic|flipping)( in short steps)? (\d+) ns", run.stdout):
                found.setdefault((f"FRB by {way}{short}", body), []).append(float(ns))
        run = subprocess.run(bench, cwd=HOME, capture_output=True, text=True, check=True)
        for what, body, ns in re.findall(r"(preparing|w and q), (generic|flipping) +([\d.]+) ns", run.stdout):
            found.setdefault((what, body), []).append(float(ns))
    for body in "generic", "flipping":
        least = {way: min(ns) for (way, of), ns in found.items() if of == body}
        least["ours prepared"] = least.pop("w and q")
        least["ours with preparing"] = least.pop("preparing") + least["ours prepared"]
        print(f"# ns for one instant, {body}: " + ", ".join(f"{way} {ns:.0f}" for way, ns in least.items()))


def random_ones():
    """Counts the answers to the random motions of crates/measure, of which no errors are printed."""
    cases = json.loads((HOME / "crates/measure/record/errors.json").read_text())["cases"]
    for kind in "generic", "flip", "near-separatrix":
        asked = [(case, time) for case in cases if case["spin"] == kind for time in case["t"]]
        given = [sum(not isinstance(frb(way, case, time), str) for case, time in asked) for way in WAYS]
        print(f"# answered of {len(asked)} random instants, {kind}: matrix {given[0]}, quaternion {given[1]}")


def main():
    print(f"# Printed by frb.py on {date.today()}: errors of the spin as a share of it, and of the attitude in rad.")
    print(f"# FRB of CALGO at commit {sys.argv[2]}, gfortran 12.2 -O2; rustc 1.95.0, release; AMD EPYC, 2 cores.")
    print("# crash: it writes beyond arrays of 20 numbers in EGELLIPX_STEP; with 99, tried by hand, each is refused.")
    print("# refused: it prints that Carlson's integral has invalid arguments.")
    print("# in short steps: below 0.1 rad, by 5 nodes of its quadrature; else its integral in full.")
    times()
    random_ones()
    print("motions,name,time,condition,matrix: spin,attitude,quaternion: spin,attitude,ours: spin,attitude,"
          "matrix in short steps: attitude,quaternion in short steps: attitude")
    for file in "free-motion", "late":
        path = HOME / f"tests/data/{file}.json"
        run = ["cargo", "run", "-q", "--example", "free_motion", "--", path]
        ours = json.loads(subprocess.run(run, cwd=HOME, capture_output=True, check=True).stdout)["cases"]
        for case, own in zip(json.loads(path.read_text())["cases"], ours):
            if case["name"] == "zero-w":
                continue
            for k, time in enumerate(case["t"]):
                answers = [frb(way, case, time) for way in WAYS]
                errors = [x for answer in [*answers, (own["w"][k], own["q"][k])] for x in error(answer, case, k)]
                turn = abs(float(time)) * float(distance(map(float, case["w0"]), [0] * 3))
                steps = [frb(way, case, time, 5) for way in WAYS] if 0 < turn < 0.1 else ["long"] * 2
                errors += [error(answer, case, k)[1] for answer in steps]
                unit = max(float(case["kappa_q"][k]) if case["kappa_q"] else 1.0, 1.0)
                print(",".join([kind_of(case["name"], file), case["name"], time, f"{unit:.1e}", *errors]))


main()
