"""Three engines before and after the position stage: fetches each, patches it, runs the scenes in both and has the
records judged.

    python3 examples/engines/before-after/before_after.py rapier box3d avian    # some minutes each; renews before-after.csv
    python3 examples/engines/before-after/before_after.py                       # prints the table of before-after.csv

Needs cargo, gcc, cmake, git and patch. Everything is fetched and built below target/engines, or below the folder that
WORK names. BOX3D names another place to clone Box3D from.
"""

import csv
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
WORK = pathlib.Path(os.environ.get("WORK", ROOT / "target/engines")).resolve()
RECORD = HERE / "before-after.csv"

CRATES = {
    "rapier": ("rapier3d", "0.36.1", "src/dynamics/solver", 'rapier3d = {{ path = "{}" }}\n'),
    "avian": (
        "avian3d",
        "0.7.0",
        "src/dynamics/integrator",
        'avian3d = {{ path = "{}", default-features = false, features = ["3d", "f32", "parry-f32", "xpbd_joints"] }}\n'
        'bevy = {{ version = "0.19", default-features = false }}\n',
    ),
}
BOX3D = "30c67b5e6d0a3a66f0f506c69ce9e9e0587e3b7c"  # of 12 August 2026, after v0.1.0
NAMES = {"rapier": "Rapier 0.36.1", "box3d": "Box3D 0.1.0, " + BOX3D[:8], "avian": "Avian 0.7.0"}

T_HANDLE = (3.968528955053007e-5, 7.558257234306772e-5, 0.0001128707638670557)
FLIPS = 361
TILT = 0.3
SCENES = [
    "free largest 216000 60 1 1 2 3 1 0 0 0 0.3 0.3 10",
    "free smallest 216000 60 1 1 2 3 1 0 0 0 10 0.3 0.3",
    "free t-handle 36000 1 1 {} {} {} 1 0 0 0 0.3 10 0.3".format(*T_HANDLE),
    f"top top 1800 1 0 -0.1 0 0.01 1 0.021 0.04 0.021 {math.cos(TILT / 2)} {math.sin(TILT / 2)} 0 0 0 40 0 0 0.1088 0",
    "stack stack 1200 1200 8 0.5 0.25 0.4",
    "wheel wheel 3600 1 0.5 0 0"
    " 4 0.2 0.3 0.4 1 0 0 0 0.5 0.8 0.2 0 0 0 0 0 0"
    " 1 0.02 0.02 0.04 1 0 0 0 0.5 0.8 30.2 0.5 0 0 0 0.1 -0.4",
]
TIMES = ["time-crowd crowd 10 20 1000 1 1 2 3 1 0 0 0 0.3 10 0.3", "time-stack stack 10 20 8 0.5 0.25 0.4"]


def run(*command, **more):
    return subprocess.run([str(word) for word in command], check=True, **more)


def unpacked(name, version):
    """The sources of a crate, as cargo got them from its registry."""
    folder = WORK / "fetch" / name
    (folder / "src").mkdir(parents=True, exist_ok=True)
    (folder / "src/lib.rs").touch()
    (folder / "Cargo.toml").write_text(
        f'[package]\nname = "fetch"\nversion = "0.0.0"\n[workspace]\n[dependencies]\n{name} = "={version}"\n'
    )
    text = run("cargo", "metadata", "--format-version=1", cwd=folder, capture_output=True).stdout
    package = next(p for p in json.loads(text)["packages"] if p["name"] == name)
    assert package["version"] == version, package["version"]
    return pathlib.Path(package["manifest_path"]).parent


def cloned():
    folder = WORK / "fetch/box3d"
    if not folder.exists():
        run("git", "clone", "-q", os.environ.get("BOX3D", "https://github.com/erincatto/box3d"), folder)
    run("git", "checkout", "-q", BOX3D, cwd=folder)
    return folder


def program(engine, when):
    """Builds the scenes with the engine as it is, or patched."""
    folder = WORK / engine / when
    shutil.rmtree(folder, ignore_errors=True)
    source = cloned() if engine == "box3d" else unpacked(*CRATES[engine][:2])
    shutil.copytree(source, folder, ignore=shutil.ignore_patterns(".git"))
    if when == "after":
        run("patch", "-p1", "-s", "-i", HERE / f"{engine}.patch", cwd=folder)
        if engine == "box3d":
            shutil.copy(ROOT / "examples/engines/c/position_stage.h", folder / "src")
        else:
            shutil.copy(HERE.parent / "position_stage.rs", folder / CRATES[engine][2])
    build = WORK / engine / f"{when}-build"
    build.mkdir(exist_ok=True)
    if engine == "box3d":
        options = [f"-DBOX3D_{x}=OFF" for x in ("VALIDATE", "SAMPLES", "UNIT_TESTS")]
        run("cmake", "-S", folder, "-B", build, "-DCMAKE_BUILD_TYPE=Release", *options, stdout=subprocess.DEVNULL)
        run("cmake", "--build", build, "-j2", stdout=subprocess.DEVNULL)
        library = next(build.rglob("libbox3d*.a"))
        run("gcc", "-O2", f"-I{folder}/include", HERE / "box3d.c", library, "-lm", "-lpthread", "-o", build / "scenes")
        return build / "scenes"
    (build / "Cargo.toml").write_text(
        '[package]\nname = "scenes"\nversion = "0.0.0"\nedition = "2024"\n[workspace]\n'
        f'[[bin]]\nname = "scenes"\npath = "{HERE / engine}.rs"\n[dependencies]\n' + CRATES[engine][3].format(folder)
    )
    target = WORK / engine / "target"
    run("cargo", "build", "--release", "-q", cwd=build, env={**os.environ, "CARGO_TARGET_DIR": str(target)})
    return shutil.copy(target / "release/scenes", build / "scenes")


def stories():
    for story in json.loads((ROOT / "crates/judge/kit/stories.json").read_text())["stories"]:
        steps = round(60 * story["duration"])
        numbers = [1, *story["moments"], *story["attitude"], *story["spin"]]
        yield f"free kit-{story['name']} {steps} 1 " + " ".join(map(str, numbers))


def turned(q, v, back=1):
    w, x, y, z = q
    cross = lambda a: (y * a[2] - z * a[1], z * a[0] - x * a[2], x * a[1] - y * a[0])
    once = cross(v)
    twice = cross(once)
    return [v[i] + 2 * (back * w * once[i] + twice[i]) for i in range(3)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def norm(a):
    return math.sqrt(dot(a, a))


def degrees_between(a, b):
    return math.degrees(math.acos(max(-1, min(1, dot(a, b) / norm(a) / norm(b)))))


def rows(path):
    return [[float(x) for x in line.split(",")] for line in path.read_text().splitlines() if line[0] not in "#t"]


def free(path, moments, axis):
    """The share of the energy gained, and how far the spin went from the axis, at most."""
    record = rows(path)
    energy = lambda row: dot(moments, [w * w for w in row[5:8]])
    unit = [float(i == axis) for i in range(3)]
    return 100 * (energy(record[-1]) / energy(record[0]) - 1), max(degrees_between(row[5:8], unit) for row in record)


def wheel(path):
    record = rows(path)
    parts = [(4, (0.2, 0.3, 0.4)), (1, (0.02, 0.02, 0.04))]

    def whole(two):
        energy, momentum = 0, [0, 0, 0]
        for (mass, moments), row in zip(parts, two):
            q, w, x, v = row[1:5], row[5:8], row[8:11], row[11:14]
            energy += (dot(moments, [a * a for a in w]) + mass * dot(v, v)) / 2
            spin = turned(q, [i * a for i, a in zip(moments, w)])
            orbit = [x[1] * v[2] - x[2] * v[1], x[2] * v[0] - x[0] * v[2], x[0] * v[1] - x[1] * v[0]]
            momentum = [a + b + mass * c for a, b, c in zip(momentum, spin, orbit)]
        return energy, norm(momentum)

    (energy, momentum), (energy_1, momentum_1) = whole(record[:2]), whole(record[-2:])
    wobble = max(norm(row[5:7]) for row in record[-120::2])
    return 100 * (energy_1 / energy - 1), 100 * (momentum_1 / momentum - 1), wobble


def judged(folder):
    files = sorted(folder.glob("kit-*.csv"))
    judge = ["cargo", "run", "-q", "--release", "-p", "tumbling-judge", "--"]
    passed = [subprocess.run([*judge, file], cwd=ROOT, stdout=subprocess.DEVNULL).returncode == 0 for file in files]
    return sum(passed), len(files)


def measured(engine, when, scenes):
    folder = WORK / engine / f"{when}-records"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    run(scenes, folder, input="\n".join([*stories(), *SCENES]) + "\n", text=True)
    passed, of = judged(folder)
    yield "kit", f"stories passed, of {of}", passed
    for name, axis in [("largest", 2), ("smallest", 0)]:
        energy, lean = free(folder / f"{name}.csv", (1, 2, 3), axis)
        yield f"an hour about the axis of {name} moment", "energy, %", energy
        yield f"an hour about the axis of {name} moment", "farthest from the axis, deg", lean
    record = rows(folder / "t-handle.csv")
    flips = sum((a[6] > 0) != (b[6] > 0) for a, b in zip(record, record[1:]))
    yield "T-handle, ten minutes", f"flips, of {FLIPS}", flips
    yield "T-handle, ten minutes", "energy, %", free(folder / "t-handle.csv", T_HANDLE, 1)[0]
    tilts = [degrees_between(turned(row[1:5], (0, 1, 0)), (0, 1, 0)) for row in rows(folder / "top.csv")]
    yield "top on a plane, half a minute", f"largest tilt, deg, from {math.degrees(TILT):.1f}", max(tilts)
    boxes = rows(folder / "stack.csv")[-8:]
    yield "eight boxes in a stack, 20 s", "top box moved aside, mm", 1000 * math.hypot(boxes[-1][8], boxes[-1][10])
    names = ["energy, %", "momentum, %", "spin of the body across the axle, rad/s"]
    for name, value in zip(names, wheel(folder / "wheel.csv")):
        yield "wheel on an axle, a minute", name, value


def times(programs):
    """Both in turns, each the least and the median of all."""
    found = {when: [[] for _ in TIMES] for when in programs}
    for _ in range(5):
        for when, scenes in programs.items():
            text = run(scenes, WORK, input="\n".join(TIMES) + "\n", capture_output=True, text=True).stdout
            for all_of, line in zip(found[when], text.splitlines()):
                all_of += [float(x) for x in line.split()]
    for at, name in enumerate(["1000 bodies that nothing touches", "eight boxes in a stack"]):
        for word, of in [("least", min), ("median", lambda x: sorted(x)[len(x) // 2])]:
            yield name, f"microseconds a step, {word} of 100", *(of(found[when][at]) for when in ("before", "after"))


def compared(engine):
    programs = {when: program(engine, when) for when in ("before", "after")}
    before, after = ([*measured(engine, *both)] for both in programs.items())
    for (scene, what, x), (_, _, y) in zip(before, after):
        yield scene, what, x, y
    yield from times(programs)


def table():
    with open(RECORD, newline="") as file:
        record = list(csv.DictReader(file))
    engines = list(dict.fromkeys(row["engine"] for row in record))
    print("| scene | quantity | " + " | ".join(engines) + " |\n|---|---|" + "---|" * len(engines))
    for scene, what in dict.fromkeys((row["scene"], row["quantity"]) for row in record):
        cells = {r["engine"]: f"{r['before']} → {r['after']}" for r in record if (r["scene"], r["quantity"]) == (scene, what)}
        print(f"| {scene} | {what} | " + " | ".join(cells.get(engine, "") for engine in engines) + " |")


def main():
    engines = sys.argv[1:]
    old = []
    if RECORD.exists():
        with open(RECORD, newline="") as file:
            old = list(csv.reader(file))[1:]
    for engine in engines:
        new = [[NAMES[engine], scene, what, f"{x:.4g}", f"{y:.4g}"] for scene, what, x, y in compared(engine)]
        old = [row for row in old if row[0] != NAMES[engine]] + new
        with open(RECORD, "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["engine", "scene", "quantity", "before", "after"])
            writer.writerows(old)
    table()


if __name__ == "__main__":
    main()
