"""Runs the kit's stories in Bullet: `story.py STEP [--kind multibody|rigid] [STORY...]`, all stories if none is named.

Writes STORY.csv into the folder `records` beside this file, for `judge`.
"""

import argparse
import json
from fractions import Fraction
from importlib.metadata import version
from pathlib import Path

import pybullet

HERE = Path(__file__).resolve().parent
KIT = HERE.parents[2] / "crates" / "judge" / "kit" / "stories.json"


def in_body(attitude, vector):
    """A vector of the world, in body axes."""
    m = pybullet.getMatrixFromQuaternion(attitude)
    return [sum(m[3 * row + column] * vector[row] for row in range(3)) for column in range(3)]


def in_world(attitude, vector):
    m = pybullet.getMatrixFromQuaternion(attitude)
    return [sum(m[3 * row + column] * vector[column] for column in range(3)) for row in range(3)]


def run(story, step, kind):
    """Time, attitude (w, x, y, z) and spin in body axes, at each step."""
    h = float(Fraction(step))
    w, x, y, z = story["attitude"]
    pybullet.connect(pybullet.DIRECT)
    pybullet.setTimeStep(h)
    pybullet.setGravity(0, 0, 0)
    # In maximal coordinates a body without a shape has moments of its own.
    shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[0.1, 0.1, 0.1])
    body = pybullet.createMultiBody(1, shape, useMaximalCoordinates=kind == "rigid")
    pybullet.changeDynamics(body, -1, localInertiaDiagonal=story["moments"], linearDamping=0, angularDamping=0)
    pybullet.resetBasePositionAndOrientation(body, [0, 0, 0], [x, y, z, w])
    # New moments act in maximal coordinates only after a step.
    pybullet.stepSimulation()
    pybullet.resetBaseVelocity(body, [0, 0, 0], in_world([x, y, z, w], story["spin"]))
    for n in range(round(story["duration"] / h) + 1):
        x, y, z, w = pybullet.getBasePositionAndOrientation(body)[1]
        yield [n * h, w, x, y, z, *in_body([x, y, z, w], pybullet.getBaseVelocity(body)[1])]
        pybullet.stepSimulation()
    pybullet.disconnect()


def main():
    parser = argparse.ArgumentParser(description="Runs the kit's stories in Bullet.")
    parser.add_argument("step", help="as a fraction of a second: 1/60")
    parser.add_argument("stories", nargs="*")
    parser.add_argument("--kind", default="multibody", choices=["multibody", "rigid"])
    args = parser.parse_intermixed_args()
    (HERE / "records").mkdir(exist_ok=True)
    for story in json.loads(KIT.read_text())["stories"]:
        if args.stories and story["name"] not in args.stories:
            continue
        with open(HERE / "records" / f"{story['name']}.csv", "w") as file:
            print(f"# engine: Bullet {version('pybullet')} (pybullet), {args.kind}", file=file)
            print("# inertia:", *map(repr, story["moments"]), "kg m2", file=file)
            print(f"# dt: {args.step} s", file=file)
            print("t,qw,qx,qy,qz,wx,wy,wz", file=file)
            for row in run(story, args.step, args.kind):
                print(*map(repr, row), sep=",", file=file)
        print(file.name)


if __name__ == "__main__":
    main()
