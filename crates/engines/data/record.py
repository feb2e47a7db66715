"""Records what physics engines do to a free body: `record.py [NAME...]`, all of ENGINES if none is named; into ENGINE--STORY.csv beside this file or in `table`.

`--compare` writes nothing, and says how the records differ. It needs Python 3, NumPy, and the packages of the engines named, from PyPI;
those of record.mjs come from npm, by `npm install` in the folder in which this is run, and `rapier` is the program of rapier.rs, on
the PATH. An engine that is not installed is named and left out.
"""

import importlib
import importlib.metadata
import os
import subprocess
import sys

import numpy

H = 1 / 60
STEPS = 1200
NONE = (0.0, 0.0, 0.0)
# Moments, spin, torque constant in the world, steps.
STORIES = {
    "box-middle": ((5 / 6, 13 / 12, 5 / 12), (10.0, 0.1, 0.1), NONE, STEPS),
    "major": ((1.0, 2.0, 3.0), (0.5, 0.5, 10.0), NONE, STEPS),
    "middle": ((1.0, 2.0, 3.0), (0.01, 10.0, 0.01), NONE, STEPS),
    "minor": ((1.0, 2.0, 3.0), (10.0, 0.5, 0.5), NONE, STEPS),
    "fast": ((1.0, 2.0, 3.0), (1.0, 1.0, 60.0), NONE, 120),
    "wound": ((1.0, 2.0, 3.0), (4.0, 100.0, -9.0), NONE, 120),
    "pushed": ((1.0, 2.0, 3.0), (0.5, 3.0, 0.5), (2.0, -1.0, 3.0), 120),
}
FREE = list(STORIES)[:4]
TWO = FREE[:2]


def mjcf(moments, more=""):
    inertia = " ".join(repr(x) for x in moments)
    body = f'<body><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="{inertia}"/><geom size="0.1" mass="0"/></body>'
    return f'<mujoco><option gravity="0 0 0" timestep="{H!r}"{more}/><worldbody>{body}</worldbody></mujoco>'


def mujoco(integrator):
    def record(moments, spin, torque, steps):
        import mujoco

        model = mujoco.MjModel.from_xml_string(mjcf(moments, f' integrator="{integrator}"'))
        data = mujoco.MjData(model)
        data.qvel[3:] = spin
        for _ in range(steps + 1):
            yield [*data.qpos[3:], *data.qvel[3:]]
            data.xfrc_applied[1, 3:] = torque
            mujoco.mj_step(model, data)

    return record


def bullet(multibody, most=None):
    def record(moments, spin, torque, steps):
        import pybullet

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


def javascript(package):
    def record(moments, spin, torque, steps):
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "record.mjs")
        numbers = [repr(x) for x in (*moments, *spin)]
        ran = subprocess.run(["node", script, package, *numbers, str(steps)], check=True, capture_output=True, text=True)
        version, *rows = ran.stdout.splitlines()
        record.version = version
        return ([float(x) for x in line.split(",")] for line in rows)

    return record


def mjx(integrator):
    def record(moments, spin, torque, steps):
        import jax
        import mujoco
        from mujoco import mjx

        model = mjx.put_model(mujoco.MjModel.from_xml_string(mjcf(moments, f' integrator="{integrator}"')))
        data = mjx.make_data(model)
        data = data.replace(qvel=data.qvel.at[3:].set(jax.numpy.array(spin)))
        step = jax.jit(mjx.step)
        for _ in range(steps + 1):
            yield [*data.qpos[3:], *data.qvel[3:]]
            data = step(model, data)

    return record


def brax(pipeline):
    def record(moments, spin, torque, steps):
        import jax
        from brax.io import mjcf as read

        rules = importlib.import_module(f"brax.{pipeline}.pipeline")
        system = read.loads(mjcf(moments))
        state = rules.init(system, system.init_q, jax.numpy.array([*NONE, *spin]))
        step = jax.jit(lambda state: rules.step(system, state, jax.numpy.zeros(0)))
        for _ in range(steps + 1):
            yield [*state.x.rot[0], *state.xd.ang[0]]
            state = step(state)

    return record


def drake(scheme):
    def record(moments, spin, torque, steps):
        from pydrake.multibody.math import SpatialVelocity
        from pydrake.multibody.plant import MultibodyPlant
        from pydrake.multibody.tree import SpatialInertia, UnitInertia
        from pydrake.systems.analysis import ApplySimulatorConfig, Simulator, SimulatorConfig

        discrete = scheme == "discrete"
        plant = MultibodyPlant(H if discrete else 0.0)
        plant.mutable_gravity_field().set_gravity_vector(NONE)
        body = plant.AddRigidBody("body", SpatialInertia(1, NONE, UnitInertia(*moments)))
        plant.Finalize()
        simulator = Simulator(plant)
        if not discrete:
            ApplySimulatorConfig(SimulatorConfig(integration_scheme=scheme, max_step_size=H, accuracy=1e-3), simulator)
        context = simulator.get_mutable_context()
        plant.SetFreeBodySpatialVelocity(context=context, body=body, V_JpJc=SpatialVelocity(spin, NONE))
        for n in range(steps + 1):
            # A discrete plant changes at the start of each step: half a step before its time it has its new state.
            if n:
                simulator.AdvanceTo((n - 0.5 if discrete else n) * H)
            q = plant.EvalBodyPoseInWorld(context, body).rotation().ToQuaternion()
            yield [q.w(), q.x(), q.y(), q.z(), *plant.EvalBodySpatialVelocityInWorld(context, body).rotational()]

    return record


def dart(moments, spin, torque, steps):
    import dartpy

    world = dartpy.simulation.World()
    world.setGravity(NONE)
    world.setTimeStep(H)
    skeleton = dartpy.dynamics.Skeleton()
    _, body = skeleton.createFreeJointAndBodyNodePair()
    body.setInertia(dartpy.dynamics.Inertia(1.0, NONE, numpy.diag(moments)))
    skeleton.setVelocities([*spin, *NONE])
    world.addSkeleton(skeleton)
    for _ in range(steps + 1):
        q = dartpy.math.Quaternion(body.getWorldTransform().rotation())
        yield [q.w(), q.x(), q.y(), q.z(), *body.getAngularVelocity()]
        world.step()


def pinocchio(moments, spin, torque, steps):
    """The step of Pinocchio's own simulators: the acceleration of its `aba`, then its `integrate`."""
    import pinocchio

    model = pinocchio.Model()
    place = pinocchio.SE3.Identity()
    joint = model.addJoint(0, pinocchio.JointModelFreeFlyer(), place, "body")
    model.appendBodyToJoint(joint, pinocchio.Inertia(1.0, numpy.zeros(3), numpy.diag(moments)), place)
    model.gravity = pinocchio.Motion.Zero()
    data = model.createData()
    q, v = pinocchio.neutral(model), numpy.array([*NONE, *spin])
    for _ in range(steps + 1):
        yield [q[6], *q[3:6], *v[3:]]
        v = v + H * pinocchio.aba(model, data, q, v, numpy.zeros(6))
        q = pinocchio.integrate(model, q, H * v)


def newton(solver):
    def record(moments, spin, torque, steps):
        import newton
        import warp

        warp.config.quiet = True
        builder = newton.ModelBuilder(gravity=NONE)
        builder.add_body(mass=1.0, inertia=warp.mat33(*numpy.diag(moments).ravel()))
        model = builder.finalize(device="cpu")
        rule = getattr(newton.solvers, solver)(model, **({} if solver == "SolverFeatherstone" else {"angular_damping": 0.0}))
        state, other = model.state(), model.state()
        state.joint_qd.assign([*NONE, *spin])
        newton.eval_fk(model, state.joint_q, state.joint_qd, state)
        for _ in range(steps + 1):
            q, v = state.body_q.numpy()[0], state.body_qd.numpy()[0]
            yield [q[6], *q[3:6], *v[3:]]
            state.clear_forces()
            rule.step(state, other, None, None, H)
            state, other = other, state

    return record


def sapien(moments, spin, torque, steps):
    import sapien

    scene = sapien.Scene([sapien.physx.PhysxCpuSystem()])
    scene.set_timestep(H)
    body = sapien.physx.PhysxRigidDynamicComponent()
    entity = sapien.Entity()
    entity.add_component(body)
    body.set_mass(1)
    body.set_inertia(moments)
    body.set_angular_damping(0)
    body.set_disable_gravity(True)
    scene.add_entity(entity)
    body.set_angular_velocity(spin)
    for _ in range(steps + 1):
        yield [*entity.pose.q, *body.angular_velocity]
        scene.step()


def ode(moments, spin, torque, steps):
    from panda3d.ode import OdeBody, OdeMass, OdeWorld

    world = OdeWorld()
    world.setGravity(*NONE)
    body, mass = OdeBody(world), OdeMass()
    mass.setParameters(1, 0, 0, 0, *moments, 0, 0, 0)
    body.setMass(mass)
    body.setAngularVel(*spin)
    for _ in range(steps + 1):
        yield [*body.getQuaternion(), *body.getAngularVel()]
        world.quickStep(H)


# Name of the records after the package's own name and version: how they are made, of which stories, and whether the spin is in body axes.
ENGINES = {
    "mujoco": {f"-{x.lower()}": (mujoco(x), STORIES, True) for x in ("Euler", "implicitfast", "RK4")},
    "pybullet": {
        "-multibody": (bullet(True), STORIES, True),
        "-multibody-1e9": (bullet(True, 1e9), ("major", "minor"), True),
        "-rigid": (bullet(False), STORIES, True),
    },
    "rapier3d-f64": {"": (rapier, STORIES, True)},
    "mujoco-mjx": {f"-{x.lower()}": (mjx(x), TWO, True) for x in ("Euler", "implicitfast", "RK4")},
    "brax": {f"-{x}": (brax(x), TWO, False) for x in ("generalized", "positional", "spring")},
    "drake": {"-discrete": (drake("discrete"), TWO, False), "-runge-kutta-3": (drake("runge_kutta3"), TWO, False)},
    "dartpy": {"": (dart, TWO, False)},
    "pin": {"": (pinocchio, TWO, True)},
    "newton": {f"-{x.lower()}": (newton(f"Solver{x}"), TWO, False) for x in ("Featherstone", "SemiImplicit", "XPBD")},
    "sapien": {"": (sapien, TWO, False)},
    "panda3d": {"-ode": (ode, TWO, False)},
    **{x: {"": (javascript(x), TWO, False)} for x in ("@babylonjs/havok", "@dimforge/rapier3d-compat", "ammojs-typed", "cannon-es", "oimo", "oimophysics")},
    "jolt-physics": {f"-{x}" if x else "": (javascript(f"jolt-physics:{x}"), TWO, False) for x in ("", "gyroscopic", "gyroscopic4")},
    "physx-js-webidl": {f"-{x}" if x else "": (javascript(f"physx-js-webidl:{x}"), TWO, False) for x in ("", "gyroscopic")},
}


def version(package, record):
    """Of a package of npm the record says it."""
    fixed = {"rapier3d-f64": "0.36.1"}
    return getattr(record, "version", None) or fixed.get(package) or importlib.metadata.version(package)


def number(x):
    """The shortest decimal that reads back as this number, in single precision where that holds it."""
    x = float(x)
    return str(numpy.float32(x)) if float(numpy.float32(x)) == x and len(repr(x)) > 9 else repr(x)


def kept(rows, all, every):
    """Each row up to here, and of the rest some with the one after them; and the last ones before a body is put back to rest."""
    resets = [n for n in range(1, len(rows)) if any(rows[n - 1][4:]) and not any(rows[n][4:])]
    near = lambda n: any(reset - every <= n <= reset + 1 for reset in resets)
    return [n for n in range(len(rows)) if n <= all or n % every < 2 or near(n)]


def compare(path, text):
    old, new = ([line.split(",") for line in t.splitlines()[2:]] for t in (open(path).read(), text))
    off = lambda a, b: max(abs(float(x) - float(y)) for x, y in zip(a, b)) / max(abs(float(x)) for x in a[1:])
    apart = [off(a, b) for a, b in zip(old, new)]
    first = next((n for n, x in enumerate(apart) if x > 1e-15), None)
    same = "the same" if not any(apart) else "the same to rounding"
    print(os.path.basename(path), same if first is None and len(old) == len(new) else f"differ from row {first}")


def write(package, setting, record, stories, in_body, check):
    for story in stories:
        moments, spin, torque, steps = STORIES[story]
        rows = [[float(x) for x in row] for row in record(moments, spin, torque, steps)]
        finite = [all(map(numpy.isfinite, row)) and any(row[:4]) for row in rows] + [False]
        rows = rows[: finite.index(False)]
        name = package.replace("pybullet", "bullet").replace("@", "").replace("/", "-")
        engine = f"{name}-{version(package, record)}{setting}"
        words = lambda numbers: " ".join(repr(float(x)) for x in numbers)
        lines = [f"# {engine}; moments {words(moments)} kg m2; torque {words(torque)} N m in the world; step 1/60 s"]
        lines.append("step,qw,qx,qy,qz," + ("wx,wy,wz" if in_body else "wxw,wyw,wzw"))
        few = (48, 24) if stories is TWO else (120, 12)
        lines += [",".join([str(n), *map(number, rows[n])]) for n in kept(rows, *few)]
        folder = "table" if stories is TWO else "."
        path = os.path.join(os.path.dirname(os.path.abspath(__file__)), folder, f"{engine}--{story}.csv")
        text = "\n".join(lines) + "\n"
        if check:
            compare(path, text)
        else:
            open(path, "w").write(text)
            print(os.path.basename(path))


def main():
    names = [x for x in sys.argv[1:] if x != "--compare"]
    for package in names or ENGINES:
        for setting, (record, stories, in_body) in ENGINES[package].items():
            if package == "mujoco" and importlib.metadata.version(package) < "4":
                if setting != "-rk4":
                    continue
                stories = FREE
            try:
                write(package, setting, record, stories, in_body, "--compare" in sys.argv)
            except (ImportError, FileNotFoundError, subprocess.CalledProcessError, importlib.metadata.PackageNotFoundError) as why:
                print(f"{package}{setting} is left out: {str(why).splitlines()[0]}")


if __name__ == "__main__":
    main()
