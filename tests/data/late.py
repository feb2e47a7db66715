"""Six motions after 1, 1000, a million and a billion flips, in the format of free-motion.json.

    python3 late.py > late.json

The bodies are those of the table of enclosures in crates/proofs/src/interval/motion.rs; computed as in sweep.py."""
import json
from sweep import case

BODIES = [
    ("box", [10.0, 13.0, 5.0], [1.0, 0.25, 0.5]),
    ("racket", [1.25, 16.5, 17.75], [0.25, 10.0, 0.125]),
    ("needle", [1.0, 1.00048828125, 0.0009765625], [0.5, 0.25, 8.0]),
    ("plate", [1.0, 2.0, 3.0], [0.5, 1.0, 2.0]),
    ("next to the separatrix", [5.0, 10.0, 13.0], [0.0, 1.0, 9.094947017729282e-13]),
    ("nearly a ball", [1.0, 1.0009765625, 1.00390625], [1.0, 0.5, 0.25]),
]
keep = ["name", "inertia", "w0", "t", "kind", "w", "q", "kappa_w", "kappa_q"]
cases = [case(*body, [0.5, 5e2, 5e5, 5e8], None) for body in BODIES]
print(json.dumps({"about": "late.py; see README.md", "cases": [{k: c[k] for k in keep} for c in cases]}, indent=0))
