// The tumble: a body spun about its middle axis, with a push; the module says where it is at any instant.
"use strict";

tumblingLive.widget("tumble", async (stage) => {
    const { module, fixed, short, sayer } = tumblingLive;
    const exact = await module("tumble");
    const control = (id) => stage.querySelector(`#tumble-${id}`);
    const [scrub, play, reset, time, speed, body] = ["scrub", "play", "reset", "time", "speed", "body"].map(control);
    const [spin, spinNumber, push, pushNumber] = ["spin", "spin-number", "push", "push-number"].map(control);
    const wrong = stage.querySelector(".live-wrong");
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);

    // ---- Vectors.
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    /** Of length 1; none for a vector of no length. */
    const unit = (a) => {
        const size = Math.max(...a.map(Math.abs));
        if (!(size > 0 && size < Infinity)) return null;
        const scaled = a.map((x) => x / size);
        return scaled.map((x) => x / Math.hypot(...scaled));
    };
    /** What turns body axes into world axes, as rows, by the attitude. */
    const rows = ([w, x, y, z]) => [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ];

    // ---- Bodies: convex parts of flat faces, counter-clockwise from outside, sizes in m as in the library's `bodies`.
    /** A box about a place; `along` are the directions of its edges. */
    function block([cx, cy, cz], half, kinds = {}, along = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
        const corner = (bits) => [cx, cy, cz].map((c, k) =>
            along.reduce((sum, edge, i) => sum + (bits >> i & 1 ? 1 : -1) * half[i] * edge[k], c));
        const faces = [[1, 3, 7, 5, "+x"], [0, 4, 6, 2, "-x"], [2, 6, 7, 3, "+y"], [0, 1, 5, 4, "-y"], [4, 5, 7, 6, "+z"], [0, 2, 3, 1, "-z"]];
        return { faces: faces.map(([a, b, c, d, side]) => ({ at: [a, b, c, d].map(corner), kind: kinds[side] ?? kinds.all ?? "plain" })) };
    }
    const bar = ([x, z], [toX, toZ], thick, kind) => {
        const [ux, , uz] = unit([toX - x, 0, toZ - z]);
        const half = [thick / 2, thick / 2, Math.hypot(toX - x, toZ - z) / 2];
        return block([(x + toX) / 2, 0, (z + toZ) / 2], half, { all: kind }, [[uz, 0, -ux], [0, 1, 0], [ux, 0, uz]]);
    };
    const cuboid = (a, b, c, front) => () => ({ parts: [block([0, 0, 0], [a / 2, b / 2, c / 2], { "+x": "mark", "+y": front })], pin: a / 2 });
    function racket() {
        const [wide, long, middle] = [0.122, 0.165, 0.52];
        const corner = (i) => [wide * Math.cos((i * Math.PI) / 16), middle + long * Math.sin((i * Math.PI) / 16)];
        const parts = [];
        for (let i = 0; i < 32; i += 1) parts.push(bar(corner(i), corner(i + 1), 0.016, corner(i + 0.5)[0] > 0 ? "mark" : "plain"));
        for (const side of [-1, 1]) parts.push(bar([0.012 * side, 0.19], [0.08 * side, 0.395], 0.014, side > 0 ? "mark" : "plain"));
        parts.push(block([0, 0, 0.095], [0.017, 0.0145, 0.095], { "+x": "mark" }));
        const strings = [];
        for (let i = -7; i <= 7; i += 1) {
            const across = Math.sqrt(1 - (i / 8) ** 2);
            strings.push([[wide * i / 8, 0, middle - long * across], [wide * i / 8, 0, middle + long * across]]);
            strings.push([[-wide * across, 0, middle + long * i / 8], [wide * across, 0, middle + long * i / 8]]);
        }
        return { parts, strings, pin: wide };
    }
    function wingNut() {
        const [radius, height, top, span, wing] = [0.00825, 0.0068, 0.0177, 0.0362, 0.0118];
        const around = (x, r, i) => [x, r * Math.cos((i * Math.PI) / 12), r * Math.sin((i * Math.PI) / 12)];
        const ring = (x, r) => Array.from({ length: 24 }, (_, i) => around(x, r, i));
        const boss = { faces: ring(0, radius).map((_, i) => ({
            at: [around(0, radius, i), around(0, radius, i + 1), around(height, radius, i + 1), around(height, radius, i)], kind: "plain", smooth: true,
        })) };
        boss.faces.push({ at: ring(height, radius), kind: "mark" }, { at: ring(height, 0.0045), kind: "hole" });
        boss.faces.push({ at: ring(0, radius).reverse(), kind: "plain" }, { at: ring(0, 0.0045).reverse(), kind: "hole" });
        const reach = span / 2 - radius;
        const wings = [-1, 1].map((side) => block([top - wing / 2, 0, side * (radius + reach / 2)], [wing / 2, 0.00165, reach / 2], { "+x": "mark" }));
        return { parts: [boss, ...wings], pin: height };
    }
    const makers = [cuboid(2, 1, 3, "plain"), cuboid(0.129, 0.02, 0.198, "front"), cuboid(0.0716, 0.0078, 0.1476, "front"), racket, wingNut];

    /** A body's parts about its centre of mass, with normals, all within a ball of radius 1. */
    function modelled(which, centre) {
        const { parts, strings = [], pin } = makers[which]();
        const all = parts.flatMap((part) => part.faces.flatMap((face) => face.at));
        const size = Math.max(...all.map((p) => Math.hypot(...p.map((x, i) => x - centre[i]))));
        const place = (p) => p.map((x, i) => (x - centre[i]) / size);
        const middle = (points) => [0, 1, 2].map((i) => points.reduce((sum, p) => sum + p[i], 0) / points.length);
        const model = parts.map((part) => {
            const faces = part.faces.map(({ at, kind, smooth }) => {
                const [a, b, c] = at;
                const normal = unit(cross(b.map((x, i) => x - a[i]), c.map((x, i) => x - b[i])));
                return { at: at.map(place), normal, kind, smooth };
            });
            return { faces, middle: middle(faces.flatMap((face) => face.at)) };
        });
        const [from, to] = [[pin, centre[1], centre[2]], [pin + 0.3 * size, centre[1], centre[2]]].map(place);
        model.push({ pin: [from, to], middle: middle([from, to]) });
        return { model, strings: strings.map((ends) => ends.map(place)) };
    }

    // ---- Colours, from the page's theme.
    const dip = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    const probe = document.createElement("span");
    probe.hidden = true; // nor has it a transition from one theme's colour to the next
    probe.style.forcedColorAdjust = "none";
    stage.append(probe);
    const triple = (colour) => {
        dip.clearRect(0, 0, 1, 1);
        dip.fillStyle = colour;
        dip.fillRect(0, 0, 1, 1);
        return [...dip.getImageData(0, 0, 1, 1).data.slice(0, 3)];
    };
    const mixed = (a, b, part) => `rgb(${a.map((x, i) => Math.round(x + (b[i] - x) * part)).join(" ")})`;
    let colours = {};
    /** Reads the colours; for each kind of face its colours from the darkest to the lightest. */
    function dye() {
        const of = (name) => {
            probe.style.color = name.startsWith("--") ? `var(${name})` : name;
            return triple(getComputedStyle(probe).color);
        };
        const page = matchMedia("(forced-colors: active)").matches ? ["CanvasText", "Canvas"] : ["--fg", "--bg"];
        const [fg, bg, surface, links, middle] = [...page, "--fig-surface", "--links", "--fig-axis-mid"].map(of);
        const night = fg[0] + fg[1] + fg[2] > bg[0] + bg[1] + bg[2];
        const shades = (near, far) => Array.from({ length: 33 }, (_, i) => mixed(near, far, i / 32));
        const raised = (colour, part) => triple(mixed(colour, fg, part));
        const sunk = (colour, part) => triple(mixed(colour, night ? [0, 0, 0] : fg, part));
        const range = (colour) => (night ? shades(sunk(colour, 0.35), raised(colour, 0.3)) : shades(sunk(colour, 0.55), colour));
        colours = {
            plain: range(surface),
            front: range(triple(mixed(surface, links, 0.4))),
            mark: range(middle),
            hole: shades(sunk(surface, 0.7), sunk(surface, 0.5)),
            edge: mixed(fg, bg, 0.35), fg: mixed(fg, fg, 0), bg: mixed(bg, bg, 0),
        };
        for (const name of ["faint", "omega", "momentum", "separatrix", "axis-mid"]) {
            const colour = of(`--fig-${name}`);
            colours[name] = mixed(colour, colour, 0);
        }
        const style = getComputedStyle(stage.querySelector("canvas"));
        colours.font = `14px ${style.fontFamily}`;
        const symbols = getComputedStyle(document.documentElement).getPropertyValue("--fig-symbols").trim() || "serif";
        colours.symbols = `italic bold 17px ${symbols}`;
    }

    // ---- Paper to draw on, in the screen's own pixels.
    const papers = [];
    function paper(what, shape, still, moving) {
        const canvas = stage.querySelector(`[data-draws=${what}]`);
        const back = document.createElement("canvas"); // what does not change from frame to frame
        const [front, behind] = [canvas, back].map((c) => c.getContext("2d"));
        let [width, height, dots] = [0, 0, 1];
        const it = {
            /** What moves, over what keeps still. */
            draw() {
                if (width === 0 || !state.now) return;
                front.setTransform(1, 0, 0, 1, 0, 0);
                front.clearRect(0, 0, canvas.width, canvas.height);
                front.drawImage(back, 0, 0);
                front.setTransform(dots, 0, 0, dots, 0, 0);
                moving(front, width, height);
            },
            prepare() {
                if (width === 0 || !state.now) return;
                behind.setTransform(1, 0, 0, 1, 0, 0);
                behind.clearRect(0, 0, back.width, back.height);
                behind.setTransform(dots, 0, 0, dots, 0, 0);
                still(behind, width, height);
            },
            measure() {
                dots = Math.min(devicePixelRatio || 1, 3);
                width = canvas.clientWidth;
                height = shape(stage.querySelector(".tumble-drawings").clientWidth);
                canvas.style.height = `${height}px`;
                for (const c of [canvas, back]) [c.width, c.height] = [Math.round(width * dots), Math.round(height * dots)];
                it.prepare();
                it.draw();
            },
        };
        let seen = "";
        new ResizeObserver(() => {
            const size = `${canvas.clientWidth} ${devicePixelRatio}`;
            if (size !== seen) it.measure();
            seen = size;
        }).observe(canvas);
        papers.push(it);
        return it;
    }
    const path = (pen, points, closed) => {
        pen.beginPath();
        points.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
        if (closed) pen.closePath();
    };
    function arrow(pen, [x, y], [toX, toY], colour, width, name) {
        const length = Math.hypot(toX - x, toY - y);
        const [ux, uy] = length > 0 ? [(toX - x) / length, (toY - y) / length] : [0, -1];
        const head = Math.min(3.4 * width, length);
        const [baseX, baseY] = [toX - head * ux, toY - head * uy];
        const side = 0.38 * head;
        pen.strokeStyle = pen.fillStyle = colour;
        pen.lineWidth = width;
        path(pen, [[x, y], [baseX, baseY]]);
        pen.stroke();
        path(pen, [[toX, toY], [baseX - side * uy, baseY + side * ux], [baseX + side * uy, baseY - side * ux]], true);
        pen.fill();
        pen.font = colours.symbols;
        pen.textAlign = "center";
        pen.fillText(name, toX + (name === "L" ? -14 : 15), toY + 6); // the two arrows are often one above the other
    }

    // ---- The body, in the world: momentum up, the reader before it and a little above.
    const state = { t: 0, now: null, setting: null, window: null, playing: false };
    const TURN = 0.5;
    const TILT = 0.38;
    /** From world axes to right, up and toward the reader. */
    function eye(momentum) {
        const up = unit(momentum) ?? [1, 0, 0];
        const right = unit(cross(up, [0, -1, 0].map((x, i) => x + dot([0, 1, 0], up) * up[i]))) ?? [0, 0, 1];
        const toward = cross(right, up);
        const across = right.map((x, i) => Math.cos(TURN) * x + Math.sin(TURN) * toward[i]);
        const near = toward.map((x, i) => Math.cos(TURN) * x - Math.sin(TURN) * right[i]);
        return [
            across,
            up.map((x, i) => Math.cos(TILT) * x - Math.sin(TILT) * near[i]),
            near.map((x, i) => Math.cos(TILT) * x + Math.sin(TILT) * up[i]),
        ];
    }
    const LIGHT = unit([-0.45, 0.75, 0.6]);
    paper("body", (wide) => Math.round(Math.min(0.62 * wide, 400)), () => {}, (pen, width, height) => {
        const { setting, now } = state;
        const centre = [width / 2, height * 0.53];
        const scale = Math.min(0.48 * width, 0.43 * height);
        const world = rows(now.attitude);
        const columns = [0, 1, 2].map((j) => world.map((row) => row[j]));
        const seen = setting.eye.map((axis) => columns.map((column) => dot(axis, column))); // body axes to the reader's
        const turned = (p) => [dot(seen[0], p), dot(seen[1], p), dot(seen[2], p)];
        const at = (p) => [centre[0] + scale * dot(seen[0], p), centre[1] - scale * dot(seen[1], p)];
        pen.lineJoin = "round";
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 0.7;
        for (const ends of setting.strings) {
            path(pen, ends.map(at));
            pen.stroke();
        }
        const order = setting.model.map((part) => [dot(seen[2], part.middle), part]).sort((a, b) => a[0] - b[0]);
        for (const [, part] of order) {
            if (part.pin) {
                const [from, to] = part.pin.map(at);
                pen.strokeStyle = pen.fillStyle = colours["axis-mid"];
                pen.lineWidth = 3;
                path(pen, [from, to]);
                pen.stroke();
                pen.beginPath();
                pen.arc(to[0], to[1], 4.5, 0, 2 * Math.PI);
                pen.fill();
                continue;
            }
            for (const face of part.faces) {
                const normal = turned(face.normal);
                if (normal[2] <= 0) continue;
                const light = Math.max(0, Math.min(1, 0.5 + 0.5 * dot(normal, LIGHT)));
                path(pen, face.at.map(at), true);
                pen.fillStyle = pen.strokeStyle = colours[face.kind][Math.round(32 * light)];
                pen.fill();
                pen.lineWidth = 0.8;
                if (!face.smooth) pen.strokeStyle = colours.edge;
                pen.stroke();
            }
        }
        const project = (v, far) => [centre[0] + far * dot(setting.eye[0], v), centre[1] - far * dot(setting.eye[1], v)];
        const reach = Math.min(1.08 * scale, 0.47 * height);
        if (setting.up) arrow(pen, centre, project(setting.up, reach), colours.momentum, 5, "L");
        const spinning = unit(now.world);
        if (spinning) arrow(pen, centre, project(spinning, 0.86 * reach), colours.omega, 3, "ω");
        pen.fillStyle = colours.fg;
        pen.beginPath();
        pen.arc(centre[0], centre[1], 2.5, 0, 2 * Math.PI);
        pen.fill();
    });

    // ---- The ellipsoid of energy and its polhodes, in the body: the longest half axis, of the smallest moment, upright.
    const look = (() => {
        const [turn, tilt] = [0.62, 0.3];
        const toward = [Math.cos(tilt) * Math.cos(turn), Math.cos(tilt) * Math.sin(turn), Math.sin(tilt)];
        const right = unit(cross([0, 0, 1], toward));
        return [right, cross(toward, right), toward];
    })();
    const ellipsoid = (width, height) => {
        const { moments } = state.setting;
        const half = moments.map((m) => Math.sqrt(moments[2] / m));
        const extent = [0, 1].map((i) => Math.hypot(...half.map((h, k) => h * look[i][k])));
        const scale = Math.min((0.5 * width - 26) / extent[0], (0.5 * height - 34) / extent[1]);
        const at = (p) => [width / 2 + scale * dot(look[0], p), height / 2 - scale * dot(look[1], p)];
        const before = (p) => dot(p.map((x, k) => x / half[k] ** 2), look[2]) >= 0;
        return { half, scale, at, before };
    };
    paper("polhode", (wide) => Math.round(Math.min(0.62 * wide, 400)), (pen, width, height) => {
        const { setting } = state;
        const { half, scale, at, before } = ellipsoid(width, height);
        // The outline is where a ball's is, drawn out along the half axes.
        const [a, b, c] = [[0, 0], [0, 1], [1, 1]].map(([i, j]) => half.reduce((sum, h, k) => sum + h * h * look[i][k] * look[j][k], 0));
        const lean = 0.5 * Math.atan2(2 * b, a - c);
        const root = Math.hypot((a - c) / 2, b);
        pen.beginPath();
        pen.ellipse(width / 2, height / 2, scale * Math.sqrt((a + c) / 2 + root), scale * Math.sqrt(Math.max((a + c) / 2 - root, 0)), -lean, 0, 2 * Math.PI);
        pen.fillStyle = colours.plain[26];
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 1.2;
        pen.fill();
        pen.stroke();
        const curve = (points, colour, thick) => {
            for (const front of [false, true]) {
                pen.beginPath();
                points.forEach((p, i) => {
                    const last = points.at(i - 1);
                    if (before(p) !== front && before(last) !== front) return;
                    pen.moveTo(...at(last));
                    pen.lineTo(...at(p));
                });
                pen.strokeStyle = colour;
                pen.lineWidth = thick;
                pen.globalAlpha = front ? 1 : 0.28;
                pen.stroke();
            }
            pen.globalAlpha = 1;
        };
        const mirrored = (points) => points.map((p) => p.map((x) => -x));
        for (const points of setting.others) for (const side of [points, mirrored(points)]) curve(side, colours.faint, 0.8);
        for (const points of setting.between) for (const side of [points, mirrored(points)]) curve(side, colours.separatrix, 1.2);
        if (setting.own) curve(setting.own, colours.omega, 2.2);
        ["x", "y", "z"].forEach((name, k) => {
            const [from, to] = [half[k], half[k] + 14 / scale].map((far) => [0, 1, 2].map((i) => (i === k ? far : 0)));
            pen.strokeStyle = pen.fillStyle = k === 0 ? colours["axis-mid"] : colours.fg;
            pen.lineWidth = k === 0 ? 2.4 : 1.2;
            path(pen, [at(from), at(to)]);
            pen.stroke();
            const [x, y] = at(to.map((value) => (value === 0 ? 0 : value + (k === 0 ? 16 : 9) / scale)));
            pen.font = colours.font;
            pen.textAlign = "center";
            pen.fillText(name, x, y + 5);
        });
    }, (pen, width, height) => {
        const { now, setting } = state;
        const point = now.omega.map((x) => x * setting.onto);
        if (!point.every(Number.isFinite)) return;
        const { at, before } = ellipsoid(width, height);
        const [x, y] = at(point);
        pen.beginPath();
        pen.arc(x, y, 5.5, 0, 2 * Math.PI);
        pen.globalAlpha = before(point) ? 1 : 0.45;
        pen.fillStyle = colours.omega;
        pen.strokeStyle = colours.bg;
        pen.lineWidth = 1.5;
        pen.fill();
        pen.stroke();
        pen.globalAlpha = 1;
    });

    // ---- The spin along the middle axis over time, and the flips predicted.
    const EDGE = 8; // half a slider's thumb: the slider below has the same scale
    paper("strip", (wide) => Math.round(Math.min(Math.max(0.15 * wide, 84), 110)), (pen, width, height) => {
        const { window: { from, to, flips, samples }, setting } = state;
        const [top, bottom] = [8, height - 20];
        const across = (t) => EDGE + ((t - from) / (to - from)) * (width - 2 * EDGE);
        const level = (top + bottom) / 2;
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 1;
        path(pen, [[EDGE, level], [width - EDGE, level]]);
        pen.stroke();
        pen.font = colours.font;
        pen.textAlign = "center";
        let free = -Infinity;
        for (const flip of flips) {
            const x = across(flip);
            pen.strokeStyle = pen.fillStyle = colours.separatrix;
            pen.setLineDash([4, 3]);
            path(pen, [[x, top], [x, bottom]]);
            pen.stroke();
            pen.setLineDash([]);
            const text = `${setting.instant(flip)} s`;
            const half = pen.measureText(text).width / 2;
            if (x - half < free || x - half < 0 || x + half > width) continue;
            pen.fillText(text, x, height - 4);
            free = x + half + 8;
        }
        const greatest = Math.max(...samples.map(Math.abs)) || 1;
        path(pen, samples.map((x, i) => [EDGE + (i / (samples.length - 1)) * (width - 2 * EDGE), level - (x / greatest) * (bottom - top) * 0.46]));
        pen.strokeStyle = colours["axis-mid"];
        pen.lineWidth = 2;
        pen.stroke();
    }, (pen, width, height) => {
        const { from, to } = state.window;
        const x = EDGE + ((state.t - from) / (to - from)) * (width - 2 * EDGE);
        pen.fillStyle = colours.fg;
        pen.fillRect(x - 1, 4, 2, height - 22);
    });

    // ---- What the module says.
    const list = (numbers, size) => Array.from({ length: numbers.length / size }, (_, i) => Array.from(numbers.slice(size * i, size * (i + 1))));
    /** The library's own words on what is wrong, its numbers filled in. */
    function complain() {
        const numbers = exact.left(2);
        let i = 0;
        wrong.textContent = `${exact.words().replace(/#/g, () => {
            const number = numbers[i++];
            return Number.isFinite(number) ? short(number) : String(number).replace("-", "−").replace("Infinity", "inf");
        })}.`;
        wrong.hidden = false;
        pause();
        return wrong.textContent;
    }
    const number = (field) => (field.value.trim() === "" ? NaN : Number(field.value));

    /** Prepares the motion of what the controls are set to, from its start. */
    function prepare() {
        const found = exact.answer(0, Number(body.value), number(spinNumber), number(pushNumber));
        if (!found) {
            state.setting = null;
            for (const what of ["beat", "next", "time", "flips", "spin"]) shown(what).textContent = "none";
            complain();
            return;
        }
        wrong.hidden = true;
        const [beat, a, b, c, x, y, z, lx, ly, lz, around, depth, onto] = found;
        const moments = [a, b, c];
        const polhode = (axis, value) => list(exact.answer(3, axis, value, 240), 3);
        const between = (part, from, to) => from + part * (to - from);
        const decimals = beat < 0.05 ? Math.min(12, 1 - Math.floor(Math.log10(beat))) : 2;
        const instant = (t) => (Math.abs(t) < 1e12 && (t === 0 || Math.abs(t) >= 10 ** -decimals) ? fixed(t, decimals) : short(t));
        const own = around < 3 ? polhode(around, depth) : null;
        const side = [0, number(pushNumber), 0][around] < 0 ? -1 : 1;
        const turns = (20 * Math.PI) / Math.abs(number(spinNumber));
        const stretch = 6 * beat;
        state.setting = {
            ...modelled(Number(body.value), [x, y, z]),
            moments, onto, beat, instant,
            up: unit([lx, ly, lz]),
            eye: eye([lx, ly, lz]),
            others: [0.25, 0.65].flatMap((part) => [polhode(1, between(part, b, a)), polhode(2, between(part, c, a))]),
            between: [polhode(1, a)],
            own: own?.map((p) => p.map((value) => side * value)),
            stretch: stretch > 0 && stretch < 1e300 ? stretch : turns > 0 && turns < 1e300 ? turns : 10,
        };
        state.window = null;
        shown("beat").textContent = Number.isNaN(beat) ? "none: it never flips" : `${spanned(beat)} s`;
        go(0);
        for (const it of papers) {
            it.prepare();
            it.draw();
        }
    }
    const spanned = (beat) => (beat >= 100 && beat < 1e12 ? fixed(beat, 0) : state.setting.instant(beat));

    /** Shows the instant `t`; says whether there is one. */
    function go(t) {
        if (!state.setting) return false;
        const found = exact.answer(1, t);
        if (!found) {
            complain();
            return false;
        }
        const { stretch, instant } = state.setting;
        if (!state.window || t < state.window.from || t > state.window.to) {
            const from = Math.floor(t / stretch) * stretch;
            const to = from + stretch;
            const part = exact.answer(2, from, to, 480);
            if (!part || !(to > from) || t > to) {
                complain();
                return false;
            }
            const count = part[0];
            state.window = { from, to, flips: Array.from(part.slice(1, 1 + count)), samples: Array.from(part.slice(1 + count)) };
            [scrub.min, scrub.max] = [from, to];
            papers[2].prepare();
        }
        wrong.hidden = true;
        state.t = t;
        const [x, y, z, qw, qx, qy, qz, wx, wy, wz, flips, ...next] = found;
        state.now = { omega: [x, y, z], attitude: [qw, qx, qy, qz], world: [wx, wy, wz] };
        const coming = next.filter((flip) => !Number.isNaN(flip));
        if (state.flips !== flips && state.playing) say(`Flip ${flips} at ${instant(t)} s.`);
        state.flips = flips;
        shown("time").textContent = `${instant(t)} s`;
        shown("flips").textContent = String(flips);
        shown("next").textContent = coming.length > 0 ? `${coming.map(instant).join(", ")} s` : "none: it never flips";
        shown("spin").textContent = state.now.omega.map((w) => (Math.abs(w) < 1e4 ? fixed(w, 2) : short(w))).join(", ");
        scrub.value = t;
        const now = performance.now();
        if (!state.playing || !(now - state.told < 500)) {
            state.told = now;
            scrub.setAttribute("aria-valuetext", `${instant(t)} s, ${flips} flips so far`);
        }
        for (const it of papers) it.draw();
        return true;
    }
    const told = () => {
        if (!state.setting || !wrong.hidden) return ""; // what is wrong is said by itself
        return `At ${shown("time").textContent} it has flipped ${state.flips} times; along the middle axis it spins at ${fixed(state.now.omega[0], 2)} rad/s. `
            + `Time between flips: ${shown("beat").textContent}. Next flips at: ${shown("next").textContent}.`;
    };

    // ---- Time: it runs only when asked, and where less motion is preferred it goes by steps.
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    const rate = () => 10 ** Number(speed.value);
    function label() {
        play.textContent = still.matches ? "Step" : state.playing ? "Pause" : "Play";
    }
    function pause() {
        if (!state.playing) return;
        state.playing = false;
        label();
        if (state.setting) scrub.setAttribute("aria-valuetext", `${state.setting.instant(state.t)} s, ${state.flips} flips so far`);
    }
    function run() {
        state.playing = true;
        label();
        let last = null;
        const frame = (now) => {
            if (!state.playing) return;
            // A page out of sight gets no frames: what it missed is not made up for.
            const passed = last === null ? 0 : Math.min((now - last) / 1000, 0.1);
            last = now;
            if (go(state.t + passed * rate())) requestAnimationFrame(frame);
        };
        requestAnimationFrame(frame);
    }
    play.addEventListener("click", () => {
        if (!state.setting) return;
        if (still.matches) go(state.t + rate() * 0.1);
        else if (state.playing) pause();
        else run();
        say(told());
    });
    still.addEventListener("change", () => {
        pause();
        label();
    });
    new IntersectionObserver(([{ isIntersecting }]) => isIntersecting || pause()).observe(stage);
    reset.addEventListener("click", () => {
        pause();
        go(0);
        say(told());
    });
    scrub.addEventListener("input", () => {
        pause();
        go(Number(scrub.value));
        say(told());
    });
    time.addEventListener("change", () => {
        pause();
        go(number(time));
        say(told());
    });

    // ---- The controls; a slider and the number beside it are one.
    function name() {
        const times = Number(rate().toPrecision(2));
        shown("speed").textContent = times === 1 ? "as in life" : `${times} × life`;
        speed.setAttribute("aria-valuetext", times === 1 ? "as in life" : `${times} times as fast as in life`);
        spin.setAttribute("aria-valuetext", `${spinNumber.value} rad/s`);
        const pushed = number(pushNumber);
        push.setAttribute("aria-valuetext", pushed === 0 ? "no push" : `a push of ${Number.isFinite(pushed) ? short(pushed) : "no number"} of the spin`);
    }
    function change() {
        pause();
        name();
        prepare();
        say(told());
    }
    spin.addEventListener("input", () => {
        spinNumber.value = spin.value;
        change();
    });
    spinNumber.addEventListener("input", () => {
        if (Number.isFinite(number(spinNumber))) spin.value = number(spinNumber);
        change();
    });
    push.addEventListener("input", () => {
        const power = Number(push.value);
        pushNumber.value = power <= Number(push.min) ? 0 : Number((10 ** power).toPrecision(3));
        change();
    });
    pushNumber.addEventListener("input", () => {
        const size = Math.abs(number(pushNumber));
        if (Number.isFinite(size)) push.value = size === 0 ? push.min : Math.max(Math.log10(size), Number(push.min) + 0.1);
        change();
    });
    body.addEventListener("input", change);
    speed.addEventListener("input", name);

    dye();
    new MutationObserver(() => {
        dye();
        for (const it of papers) {
            it.prepare();
            it.draw();
        }
    }).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
    label();
    name();
    prepare();
});
