"""Records what physics engines do to a free body: `record.py ENGINE...`, writing ENGINE--STORY.csv beside this file.

Engines: mujoco (whichever version is installed), bullet (pybullet), rapier (the program of rapier.rs, on the PATH).
Needs Python 3, NumPy and the engines named. `record.py --compare ENGINE...` writes nothing, and says how the records differ.
"""

import os
import subprocess
import sys

H = 1 / 60
STEPS = 1200
# Every step up to here, and of the rest every twelfth with the one after it.
ALL, EVERY = 120, 12
NONE = (0.0, 0.0, 0.0)
# Moments, spin, torque constant in the world, steps.
STORIES = {
    "box-middle": ((5 / 6, 13 / 12, 5 / 12), (10.0, 0.1, 0.1), NONE, STEPS),
    "major": ((1.0, 2.0, 3.0), (0.5, 0.5, 10.0), NONE, STEPS),
    "middle": ((1.0, 2.0, 3.0), (0.01, 10.0, 0.01), NONE, STEPS),
    "minor": ((1.0, 2.0, 3.0), (10.0, 0.5, 0.5), NONE, STEPS),
    "fast": ((1.0, 2.0, 3.0), (1.0, 1.0, 60.0), NONE, ALL),
    "wound": ((1.0, 2.0, 3.0), (4.0, 100.0, -9.0), NONE, ALL),
    "pushed": ((1.0, 2.0, 3.0), (0.5, 3.0, 0.5), (2.0, -1.0, 3.0), ALL),
}


def mujoco(integrator):
    import mujoco

    def record(moments, spin, torque, steps):
        inertia = " ".join(repr(x) for x in moments)
        model = mujoco.MjModel.from_xml_string(
            f"""<mujoco><option gravity="0 0 0" timestep="{H!r}" integrator="{integrator}"/><worldbody><body>
            <freejoint/><inertial pos="0 0 0" mass="1" diaginertia="{inertia}"/></body></worldbody></mujoco>"""
        )
        data = mujoco.MjData(model)
        data.qvel[3:] = spin
        for _ in range(steps + 1):
            yield [*data.qpos[3:], *data.qvel[3:]]
            data.xfrc_applied[1, 3:] = torque
            mujoco.mj_step(model, data)

    return record


def bullet(multibody, most=None):
    import numpy
    import pybullet

    def record(moments, spin, torque, steps):
        pybullet.connect(pybullet.DIRECT)
        pybullet.setTimeStep(H)
        pybullet.setGravity(0, 0, 0)
        # In maximal coordinates a body without a shape has moments of its own.
        shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[0.1, 0.1, 0.1])
        body = pybullet.createMultiBody(1, shape, useMaximalCoordinates=not multibody)
        pybullet.changeDynamics(body, -1, localInertiaDiagonal=moments, linearDamping=0, angularDamping=0)
        if most:
            pybullet.changeDynamics(body, -1, maxJointVelocity=most)
        # New moments reach torques in maximal coordinates only after a step.
        pybullet.stepSimulation()
        pybullet.resetBaseVelocity(body, NONE, spin)
        for _ in range(steps + 1):
            x, y, z, w = pybullet.getBasePositionAndOrientation(body)[1]
            turn = numpy.array(pybullet.getMatrixFromQuaternion([x, y, z, w])).reshape(3, 3)
            yield [w, x, y, z, *(turn.T @ numpy.array(pybullet.getBaseVelocity(body)[1]))]
            if any(torque):
                pybullet.applyExternalTorque(body, -1, torque, pybullet.WORLD_FRAME)
            pybullet.stepSimulation()
        pybullet.disconnect()

    return record


def rapier(moments, spin, torque, steps):
    numbers = [repr(x) for x in (*moments, *spin, *torque)]
    text = subprocess.run(["rapier", *numbers, str(steps)], check=True, capture_output=True, text=True).stdout
    return ([float(x) for x in line.split(",")] for line in text.splitlines())


def kept(rows):
    """Which rows are written: as above, and the last ones before a body is put back to rest."""
    resets = [n for n in range(1, len(rows)) if any(rows[n - 1][4:]) and not any(rows[n][4:])]
    near = lambda n: any(reset - EVERY <= n <= reset + 1 for reset in resets)
    return [n for n in range(len(rows)) if n <= ALL or n % EVERY < 2 or near(n)]


def compare(path, text):
    old, new = ([line.split(",") for line in t.splitlines()[2:]] for t in (open(path).read(), text))
    apart = [n for n, (a, b) in enumerate(zip(old, new)) if list(map(float, a)) != list(map(float, b))]
    print(os.path.basename(path), "the same" if not apart and len(old) == len(new) else f"differ from row {apart[:1]}")


def write(engine, record, check, stories=STORIES):
    for story in stories:
        moments, spin, torque, steps = STORIES[story]
        rows = [[float(x) for x in row] for row in record(moments, spin, torque, steps)]
        words = lambda numbers: " ".join(repr(float(x)) for x in numbers)
        lines = [f"# {engine}; moments {words(moments)} kg m2; torque {words(torque)} N m in the world; step 1/60 s"]
        lines.append("step,qw,qx,qy,qz,wx,wy,wz")
        lines += [",".join([str(n), *map(repr, rows[n])]) for n in kept(rows)]
        path = os.path.join(os.path.dirname(os.path.abspath(__file__)), f"{engine}--{story}.csv")
        text = "\n".join(lines) + "\n"
        if check:
            compare(path, text)
        else:
            open(path, "w").write(text)


def main():
    check = "--compare" in sys.argv
    for engine in sys.argv[1:]:
        if engine == "mujoco":
            import mujoco as module

            version = module.__version__
            new = int(version.split(".")[0]) >= 4
            for integrator in ("Euler", "implicitfast", "RK4") if new else ("RK4",):
                stories = STORIES if new else list(STORIES)[:4]
                write(f"mujoco-{version}-{integrator.lower()}", mujoco(integrator), check, stories)
        elif engine == "bullet":
            write("bullet-3.2.7-multibody", bullet(True), check)
            write("bullet-3.2.7-multibody-1e9", bullet(True, 1e9), check, ("major", "minor"))
            write("bullet-3.2.7-rigid", bullet(False), check)
        elif engine == "rapier":
            write("rapier3d-f64-0.36.1", rapier, check)


if __name__ == "__main__":
    main()
