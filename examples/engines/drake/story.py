"""Runs the kit's stories in Drake: `story.py STEP [--integrator discrete|NAME] [STORY...]`, all stories if none is named.

NAME is one of Drake's integrators, such as runge_kutta3 (its default) or implicit_euler; `discrete` steps the plant itself.
Writes STORY.csv into the folder `records` beside this file, for `judge`.
"""

import argparse
import json
from fractions import Fraction
from importlib.metadata import version
from pathlib import Path

from pydrake.common.eigen_geometry import Quaternion
from pydrake.math import RigidTransform
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import SpatialInertia, UnitInertia
from pydrake.systems.analysis import ApplySimulatorConfig, Simulator, SimulatorConfig

HERE = Path(__file__).resolve().parent
KIT = HERE.parents[2] / "crates" / "judge" / "kit" / "stories.json"


def run(story, step, integrator, accuracy):
    """Time, attitude (w, x, y, z) and spin in body axes, at each step."""
    h = float(Fraction(step))
    plant = MultibodyPlant(h if integrator == "discrete" else 0.0)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, 0])
    body = plant.AddRigidBody("body", SpatialInertia(1, [0, 0, 0], UnitInertia(*story["moments"])))
    plant.Finalize()
    simulator = Simulator(plant)
    if integrator != "discrete":
        config = SimulatorConfig(integration_scheme=integrator, max_step_size=h, accuracy=accuracy)
        ApplySimulatorConfig(config, simulator)
    context = simulator.get_mutable_context()
    pose = RigidTransform(Quaternion(*story["attitude"]), [0, 0, 0])
    plant.SetFreeBodyPose(context, body, pose)
    # Drake takes the spin in world axes.
    spin = pose.rotation().multiply(story["spin"])
    plant.SetFreeBodySpatialVelocity(context=context, body=body, V_JpJc=SpatialVelocity(spin, [0, 0, 0]))
    for n in range(round(story["duration"] / h) + 1):
        if n:
            # A discrete plant changes at the start of each step: half a step before its time it has its new state.
            simulator.AdvanceTo((n - 0.5 if integrator == "discrete" else n) * h)
        pose = plant.EvalBodyPoseInWorld(context, body)
        spin = plant.EvalBodySpatialVelocityInWorld(context, body).rotational()
        q = pose.rotation().ToQuaternion()
        yield [n * h, q.w(), q.x(), q.y(), q.z(), *pose.rotation().transpose().multiply(spin)]


def main():
    parser = argparse.ArgumentParser(description="Runs the kit's stories in Drake.")
    parser.add_argument("step", help="as a fraction of a second: 1/60")
    parser.add_argument("stories", nargs="*")
    parser.add_argument("--integrator", default="runge_kutta3")
    parser.add_argument("--accuracy", type=float, default=1e-3, help="the accuracy of integrators that control their error")
    args = parser.parse_intermixed_args()
    (HERE / "records").mkdir(exist_ok=True)
    for story in json.loads(KIT.read_text())["stories"]:
        if args.stories and story["name"] not in args.stories:
            continue
        with open(HERE / "records" / f"{story['name']}.csv", "w") as file:
            print(f"# engine: Drake {version('drake')}, {args.integrator}, accuracy {args.accuracy}", file=file)
            print("# inertia:", *map(repr, story["moments"]), "kg m2", file=file)
            print(f"# dt: {args.step} s", file=file)
            print("t,qw,qx,qy,qz,wx,wy,wz", file=file)
            for row in run(story, args.step, args.integrator, args.accuracy):
                print(*(repr(float(x)) for x in row), sep=",", file=file)
        print(file.name)


if __name__ == "__main__":
    main()
