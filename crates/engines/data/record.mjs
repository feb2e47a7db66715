// `node record.mjs ENGINE I1 I2 I3 w1 w2 w3 COUNT`: prints a line with the packages' version, then COUNT + 1 rows of a free
// body, 60 steps a second: attitude (w, x, y, z; body to world) and spin in world axes, rad/s. For record.py, which names
// the engines; their packages are looked for in the working directory (`npm install`).

import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const require = createRequire(pathToFileURL(`${process.cwd()}/x.js`));
const load = async (name) => import(pathToFileURL(require.resolve(name)));
const version = (name) => require(require.resolve.paths(name).map((path) => `${path}/${name}/package.json`).find((path) => require("fs").existsSync(path))).version;
const H = 1 / 60;

// Each returns how to read the body, and how to step it.
const ENGINES = {
  "cannon-es": async ({ moments, spin }) => {
    const { Body, World, Vec3 } = await load("cannon-es");
    const world = new World({ gravity: new Vec3(0, 0, 0) });
    const body = new Body({ mass: 1, angularDamping: 0, linearDamping: 0 });
    body.inertia.set(...moments);
    body.invInertia.set(...moments.map((x) => 1 / x));
    body.updateInertiaWorld(true);
    body.angularVelocity.set(...spin);
    world.addBody(body);
    return [() => [body.quaternion, body.angularVelocity], () => world.step(H)];
  },
  "@dimforge/rapier3d-compat": async ({ moments, spin }) => {
    const rapier = (await load("@dimforge/rapier3d-compat")).default;
    await rapier.init();
    const world = new rapier.World({ x: 0, y: 0, z: 0 });
    const vector = ([x, y, z]) => ({ x, y, z });
    const none = vector([0, 0, 0]);
    const how = rapier.RigidBodyDesc.dynamic().setCanSleep(false).setAngvel(vector(spin));
    how.setAdditionalMassProperties(1, none, vector(moments), { ...none, w: 1 });
    const body = world.createRigidBody(how);
    return [() => [body.rotation(), body.angvel()], () => world.step()];
  },
  "jolt-physics": async ({ moments, spin, setting }) => {
    const Jolt = await (await load("jolt-physics")).default();
    const settings = new Jolt.JoltSettings();
    const pairs = new Jolt.ObjectLayerPairFilterTable(1);
    const layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
    layers.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
    const jolt = new Jolt.JoltInterface(settings);
    const system = jolt.GetPhysicsSystem();
    system.SetGravity(new Jolt.Vec3(0, 0, 0));
    const shape = new Jolt.SphereShape(0.1);
    const how = new Jolt.BodyCreationSettings(shape, new Jolt.RVec3(0, 0, 0), new Jolt.Quat(0, 0, 0, 1), Jolt.EMotionType_Dynamic, 0);
    how.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
    how.mMassPropertiesOverride.mMass = 1;
    const tensor = Jolt.Mat44.prototype.sIdentity();
    tensor.SetDiagonal3(new Jolt.Vec3(...moments));
    how.mMassPropertiesOverride.mInertia = tensor;
    Object.assign(how, { mAngularDamping: 0, mLinearDamping: 0, mAllowSleeping: false, mApplyGyroscopicForce: setting.startsWith("gyroscopic") });
    const bodies = system.GetBodyInterface();
    const body = bodies.CreateBody(how);
    bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
    body.SetAngularVelocity(new Jolt.Vec3(...spin));
    const plain = (v) => ({ x: v.GetX(), y: v.GetY(), z: v.GetZ(), w: v.GetW?.() });
    return [() => [plain(body.GetRotation()), plain(body.GetAngularVelocity())], () => jolt.Step(H, setting.endsWith("4") ? 4 : 1)];
  },
  "ammojs-typed": async ({ moments, spin }) => {
    const Ammo = await (await load("ammojs-typed")).default();
    const config = new Ammo.btDefaultCollisionConfiguration();
    const world = new Ammo.btDiscreteDynamicsWorld(new Ammo.btCollisionDispatcher(config), new Ammo.btDbvtBroadphase(), new Ammo.btSequentialImpulseConstraintSolver(), config);
    world.setGravity(new Ammo.btVector3(0, 0, 0));
    const vector = (v) => new Ammo.btVector3(...v);
    const state = new Ammo.btDefaultMotionState(new Ammo.btTransform(new Ammo.btQuaternion(0, 0, 0, 1), vector([0, 0, 0])));
    const body = new Ammo.btRigidBody(new Ammo.btRigidBodyConstructionInfo(1, state, new Ammo.btSphereShape(0.1), vector(moments)));
    body.setActivationState(4);
    body.setDamping(0, 0);
    body.setAngularVelocity(vector(spin));
    world.addRigidBody(body);
    const plain = (v) => ({ x: v.x(), y: v.y(), z: v.z(), w: v.w?.() });
    return [() => [plain(body.getWorldTransform().getRotation()), plain(body.getAngularVelocity())], () => world.stepSimulation(H, 0)];
  },
  oimo: async ({ moments, spin }) => {
    const { World } = (await load("oimo")).default;
    const world = new World({ timestep: H, gravity: [0, 0, 0] });
    const body = world.add({ type: "sphere", size: [0.1], move: true, density: 1 });
    body.allowSleep = false;
    moments.forEach((x, i) => {
      body.localInertia.elements[4 * i] = x;
      body.inverseLocalInertia.elements[4 * i] = 1 / x;
    });
    body.angularVelocity.set(...spin);
    return [() => [body.orientation, body.angularVelocity], () => world.step()];
  },
  oimophysics: async ({ moments, spin }) => {
    const { oimo } = await load("oimophysics");
    const { Vec3, Mat3, Quat } = oimo.common;
    const { RigidBody, RigidBodyConfig } = oimo.dynamics.rigidbody;
    const world = new oimo.dynamics.World(oimo.collision.broadphase.BroadPhaseType.BRUTE_FORCE, new Vec3(0, 0, 0));
    const how = new RigidBodyConfig();
    how.autoSleep = false;
    const body = new RigidBody(how);
    const mass = body.getMassData();
    mass.mass = 1;
    mass.localInertia = new Mat3(moments[0], 0, 0, 0, moments[1], 0, 0, 0, moments[2]);
    body.setMassData(mass);
    body.setAngularVelocity(new Vec3(...spin));
    world.addRigidBody(body);
    return [() => [body.getOrientation(), body.getAngularVelocity()], () => world.step(H)];
  },
  "physx-js-webidl": async ({ moments, spin, setting }) => {
    // It is built for browsers alone, and asks whether it is in one.
    const wasmBinary = require("fs").readFileSync(require.resolve("physx-js-webidl").replace(/mjs$/, "wasm"));
    globalThis.window = globalThis;
    Object.defineProperty(process.versions, "node", { value: undefined });
    const PhysX = await (await load("physx-js-webidl")).default({ wasmBinary });
    const top = PhysX.PxTopLevelFunctions.prototype ?? PhysX.PxTopLevelFunctions;
    const foundation = top.CreateFoundation(top.PHYSICS_VERSION ?? PhysX.PHYSICS_VERSION, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
    const scale = new PhysX.PxTolerancesScale();
    const physics = top.CreatePhysics(top.PHYSICS_VERSION ?? PhysX.PHYSICS_VERSION, foundation, scale);
    const how = new PhysX.PxSceneDesc(scale);
    how.set_gravity(new PhysX.PxVec3(0, 0, 0));
    how.set_cpuDispatcher(top.DefaultCpuDispatcherCreate(0));
    how.set_filterShader(top.DefaultFilterShader());
    const scene = physics.createScene(how);
    const place = new PhysX.PxTransform(new PhysX.PxVec3(0, 0, 0), new PhysX.PxQuat(0, 0, 0, 1));
    const body = physics.createRigidDynamic(place);
    body.setMass(1);
    body.setMassSpaceInertiaTensor(new PhysX.PxVec3(...moments));
    body.setAngularDamping(0);
    body.setLinearDamping(0);
    body.setSleepThreshold(0);
    // The package has no name for eENABLE_GYROSCOPIC_FORCES.
    if (setting === "gyroscopic") body.setRigidBodyFlag(1 << 10, true);
    scene.addActor(body);
    body.setAngularVelocity(new PhysX.PxVec3(...spin));
    const plain = (v) => ({ x: v.x, y: v.y, z: v.z, w: v.w });
    return [() => [plain(body.getGlobalPose().q), plain(body.getAngularVelocity())], () => { scene.simulate(H); scene.fetchResults(true); }];
  },
  "@babylonjs/havok": async ({ moments, spin }) => {
    const path = require.resolve("@babylonjs/havok").replace("lib/umd/HavokPhysics_umd", "lib/esm/HavokPhysics_es");
    const wasmBinary = require("fs").readFileSync(path.replace(/[^/]*$/, "HavokPhysics.wasm"));
    const havok = await (await import(pathToFileURL(path))).default({ wasmBinary });
    const world = havok.HP_World_Create()[1];
    havok.HP_World_SetGravity(world, [0, 0, 0]);
    const body = havok.HP_Body_Create()[1];
    havok.HP_Body_SetShape(body, havok.HP_Shape_CreateSphere([0, 0, 0], 0.1)[1]);
    havok.HP_Body_SetMotionType(body, havok.MotionType.DYNAMIC);
    havok.HP_Body_SetMassProperties(body, [[0, 0, 0], 1, moments, [0, 0, 0, 1]]);
    havok.HP_Body_SetAngularDamping(body, 0);
    havok.HP_Body_SetActivationControl(body, havok.ActivationControl.ALWAYS_ACTIVE);
    havok.HP_World_AddBody(world, body, false);
    havok.HP_Body_SetAngularVelocity(body, spin);
    const read = () => {
      const [[x, y, z, w], [a, b, c]] = [havok.HP_Body_GetOrientation(body)[1], havok.HP_Body_GetAngularVelocity(body)[1]];
      return [{ x, y, z, w }, { x: a, y: b, z: c }];
    };
    return [read, () => havok.HP_World_Step(world, H)];
  },
};

// The shortest decimal that single precision, or double, reads back.
const shortest = (x) => {
  if (Math.fround(x) !== x) return String(x);
  for (let digits = 1; ; digits += 1) {
    const text = x.toPrecision(digits);
    if (Math.fround(Number(text)) === x) return String(Number(text));
  }
};

const [name, ...numbers] = process.argv.slice(2);
const [engine, setting = ""] = name.split(":");
const given = numbers.map(Number);
const [read, step] = await ENGINES[engine]({ moments: given.slice(0, 3), spin: given.slice(3, 6), setting });
const lines = [version(engine)];
for (let i = 0; i <= given[6]; i += 1) {
  const [q, w] = read();
  lines.push([q.w, q.x, q.y, q.z, w.x, w.y, w.z].map(shortest).join(","));
  step();
}
process.stdout.write(`${lines.join("\n")}\n`, () => process.exit(0));
