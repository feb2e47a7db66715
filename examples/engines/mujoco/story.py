"""Runs the kit's stories in MuJoCo: `story.py STEP [--integrator Euler|implicitfast|RK4] [STORY...]`, all stories if none is named.

Writes STORY.csv into the folder `records` beside this file, for `judge`.
"""

import argparse
import json
from fractions import Fraction
from pathlib import Path

import mujoco

HERE = Path(__file__).resolve().parent
KIT = HERE.parents[2] / "crates" / "judge" / "kit" / "stories.json"


def run(story, step, integrator):
    """Time, attitude (w, x, y, z) and spin in body axes, at each step."""
    h = float(Fraction(step))
    inertia = " ".join(map(repr, story["moments"]))
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco>
          <option gravity="0 0 0" timestep="{h!r}" integrator="{integrator}"/>
          <worldbody><body><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="{inertia}"/></body></worldbody>
        </mujoco>"""
    )
    data = mujoco.MjData(model)
    # Of a free joint: qpos is place and attitude, qvel is velocity in the world and spin in the body.
    data.qpos[3:7] = story["attitude"]
    data.qvel[3:6] = story["spin"]
    for n in range(round(story["duration"] / h) + 1):
        yield [n * h, *data.qpos[3:7], *data.qvel[3:6]]
        mujoco.mj_step(model, data)


def main():
    parser = argparse.ArgumentParser(description="Runs the kit's stories in MuJoCo.")
    parser.add_argument("step", help="as a fraction of a second: 1/60")
    parser.add_argument("stories", nargs="*")
    parser.add_argument("--integrator", default="Euler")
    args = parser.parse_intermixed_args()
    (HERE / "records").mkdir(exist_ok=True)
    for story in json.loads(KIT.read_text())["stories"]:
        if args.stories and story["name"] not in args.stories:
            continue
        with open(HERE / "records" / f"{story['name']}.csv", "w") as file:
            print(f"# engine: MuJoCo {mujoco.__version__}, {args.integrator}", file=file)
            print("# inertia:", *map(repr, story["moments"]), "kg m2", file=file)
            print(f"# dt: {args.step} s", file=file)
            print("t,qw,qx,qy,qz,wx,wy,wz", file=file)
            for row in run(story, args.step, args.integrator):
                print(*(repr(float(x)) for x in row), sep=",", file=file)
        print(file.name)


if __name__ == "__main__":
    main()
