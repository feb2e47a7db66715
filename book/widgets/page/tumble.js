// The tumble: a body spun about one of its axes, with a push; the module says where it is at any instant.
"use strict";

tumblingLive.widget("tumble", async (stage, from) => {
    const { load, module, fixed, short, sayer } = tumblingLive;
    await load(`${from}tumble.solids.js`);
    const exact = await module("tumble");
    const control = (id) => stage.querySelector(`#tumble-${id}`);
    const [scrub, play, reset, time, speed, body, about] = ["scrub", "play", "reset", "time", "speed", "body", "about"].map(control);
    const [spin, spinNumber, push, pushNumber] = ["spin", "spin-number", "push", "push-number"].map(control);
    const [turn, tilt] = ["turn", "tilt"].map(control);
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

    // ---- Bodies.
    /** A body about its centre of mass, all within a ball of radius 1: every place of it once, and what joins which places. */
    function modelled(which, centre) {
        const { parts, strings, leaves, across } = tumblingLive.solids(exact.answer(6, which), which, centre);
        const [places, model, lines] = [[], [], []];
        const add = (some) => some.map((place) => places.push(place) - 1);
        const mean = (some) => [0, 1, 2].map((i) => some.reduce((sum, p) => sum + p[i], 0) / some.length);
        for (const { corners, faces } of parts) {
            const from = places.length;
            add(corners);
            const shift = (list) => list?.map((i) => from + i);
            model.push({
                faces: faces.map((face) => ({ ...face, at: shift(face.at), hole: shift(face.hole), normal: unit(across(face, corners)) })),
                middle: add([mean(corners)])[0],
            });
        }
        for (const { ends } of strings) lines.push(add(ends));
        const reach = (some) => Math.max(...some.map((p) => Math.hypot(...p.map((x, i) => x - centre[i]))));
        const pin = [[leaves, centre[1], centre[2]], [leaves + 0.3 * reach(places), centre[1], centre[2]]];
        model.push({ pin: add(pin), middle: add([mean(pin)])[0] });
        const size = reach(places);
        return { model, lines, places: Float64Array.from(places.flatMap((p) => p.map((x, i) => (x - centre[i]) / size))) };
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
        for (const name of ["faint", "omega", "momentum", "separatrix", "axis-min", "axis-mid", "axis-max"]) {
            const colour = of(`--fig-${name}`);
            colours[name] = mixed(colour, colour, 0);
        }
        const style = getComputedStyle(stage.querySelector("canvas"));
        colours.font = `14px ${style.fontFamily}`;
        const symbols = getComputedStyle(document.documentElement).getPropertyValue("--fig-symbols").trim() || "serif";
        colours.symbols = `italic bold 17px ${symbols}`;
        dip.font = colours.symbols;
        colours.half = Object.fromEntries(["L", "ω"].map((name) => [name, [dip.measureText(name).width / 2 + 1, 9]]));
    }

    // ---- Paper to draw on, in the screen's own pixels.
    const papers = [];
    const MOST = 2; // screen pixels for each of the page's: more are not told apart in what moves
    /**
     * A drawing as high as `shape` says for so wide a widget: `still` draws what keeps still from frame to frame, `moving` what does not,
     * on the canvas or as a part of the page that the browser moves without painting anything.
     */
    function paper(what, shape, still, moving) {
        const canvas = stage.querySelector(`[data-draws=${what}]`);
        const pen = canvas.getContext("2d");
        let [width, height, dots] = [0, 0, 1];
        const clear = () => {
            pen.setTransform(1, 0, 0, 1, 0, 0);
            pen.clearRect(0, 0, canvas.width, canvas.height);
            pen.setTransform(dots, 0, 0, dots, 0, 0);
        };
        const it = {
            coarse: 1,
            draw() {
                if (width === 0 || !state.now) return;
                if (!still) clear();
                moving(pen, width, height, canvas);
            },
            prepare() {
                if (width === 0 || !state.now || !still) return;
                clear();
                still(pen, width, height, canvas);
            },
            measure() {
                dots = Math.max(Math.min(devicePixelRatio || 1, MOST) * it.coarse, Math.min(devicePixelRatio || 1, 1));
                width = canvas.clientWidth;
                height = shape(stage.querySelector(".tumble-drawings").clientWidth);
                canvas.style.height = `${height}px`;
                [canvas.width, canvas.height] = [Math.round(width * dots), Math.round(height * dots)];
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
    /** Sets a style of an element, unless it is so already. */
    const place = (element, what, value) => {
        if (element.style[what] !== value) element.style[what] = value;
    };
    const path = (pen, points, closed) => {
        pen.beginPath();
        points.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
        if (closed) pen.closePath();
    };
    function arrow(pen, [x, y], [toX, toY], colour, width) {
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
    }

    // ---- The body, in the world: momentum up, the reader before it and at first a little above.
    const state = { t: 0, now: null, setting: null, window: null, playing: false, drawn: 0, side: 1 };
    const radians = (field) => (Number(field.value) * Math.PI) / 180;
    /** From world axes to right, up and toward the reader, who goes around as `turn` says, and up as `tilt` does. */
    function eye(momentum) {
        const [around, above] = [radians(turn), radians(tilt)];
        const up = unit(momentum) ?? [1, 0, 0];
        const right = unit(cross(up, [0, -1, 0].map((x, i) => x + dot([0, 1, 0], up) * up[i]))) ?? [0, 0, 1];
        const toward = cross(right, up);
        const across = right.map((x, i) => Math.cos(around) * x + Math.sin(around) * toward[i]);
        const near = toward.map((x, i) => Math.cos(around) * x - Math.sin(around) * right[i]);
        return [
            across,
            up.map((x, i) => Math.cos(above) * x - Math.sin(above) * near[i]),
            near.map((x, i) => Math.cos(above) * x + Math.sin(above) * up[i]),
        ];
    }
    const LIGHT = unit([-0.45, 0.75, 0.6]);
    const LABEL = 24; // px around the body for what names the arrows
    let [xs, ys] = [new Float64Array(0), new Float64Array(0)]; // every place of the body, from the middle of the drawing
    let zs = new Float64Array(0);
    /** How far from the middle a label stands in a direction, wholly off the body and the tip of its arrow. */
    function beyond(ux, uy, tip, [wide, high]) {
        let far = tip;
        for (let i = 0; i < xs.length; i += 1) far = Math.max(far, xs[i] * ux + ys[i] * uy);
        return far + 4 + Math.abs(ux) * wide + Math.abs(uy) * high;
    }
    function label(pen, name, x, y, colour) {
        const [wide, high] = colours.half[name];
        pen.font = colours.symbols;
        pen.textAlign = "center";
        pen.fillStyle = colour;
        pen.fillText(name, x, y + 6);
        return { name, left: x - wide, right: x + wide, top: y - high, bottom: y + high };
    }
    const solid = paper("body", (wide) => Math.round(wide < 480 ? 0.72 * wide : Math.min(0.62 * wide, 400)), null, (pen, width, height, canvas) => {
        const { setting, now } = state;
        const [cx, cy] = [width / 2, height / 2];
        const scale = Math.max(Math.min(cx, cy) - LABEL, 1);
        const world = rows(now.attitude);
        // Body axes to the reader's.
        const seen = setting.eye.map((axis) => [0, 1, 2].map((j) => axis[0] * world[0][j] + axis[1] * world[1][j] + axis[2] * world[2][j]));
        const [right, up, toward] = seen;
        const { places } = setting;
        const count = places.length / 3;
        if (xs.length !== count) [xs, ys, zs] = [0, 1, 2].map(() => new Float64Array(count));
        for (let i = 0; i < count; i += 1) {
            const [x, y, z] = [places[3 * i], places[3 * i + 1], places[3 * i + 2]];
            xs[i] = scale * (right[0] * x + right[1] * y + right[2] * z);
            ys[i] = -scale * (up[0] * x + up[1] * y + up[2] * z);
            zs[i] = toward[0] * x + toward[1] * y + toward[2] * z;
        }
        const trace = (list) => {
            for (let i = 0; i < list.length; i += 1) {
                if (i === 0) pen.moveTo(cx + xs[list[i]], cy + ys[list[i]]);
                else pen.lineTo(cx + xs[list[i]], cy + ys[list[i]]);
            }
        };
        pen.lineJoin = "round";
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 0.7;
        pen.beginPath();
        for (const ends of setting.lines) trace(ends);
        pen.stroke();
        setting.model.sort((a, b) => zs[a.middle] - zs[b.middle]);
        for (const part of setting.model) {
            if (part.pin) {
                pen.strokeStyle = pen.fillStyle = colours["axis-mid"];
                pen.lineWidth = 3;
                pen.beginPath();
                trace(part.pin);
                pen.stroke();
                pen.beginPath();
                pen.arc(cx + xs[part.pin[1]], cy + ys[part.pin[1]], 4.5, 0, 2 * Math.PI);
                pen.fill();
                continue;
            }
            for (const face of part.faces) {
                const near = dot(toward, face.normal);
                if (near <= 0) continue;
                const light = 0.5 + 0.5 * (LIGHT[0] * dot(right, face.normal) + LIGHT[1] * dot(up, face.normal) + LIGHT[2] * near);
                pen.beginPath();
                trace(face.at);
                pen.closePath();
                if (face.hole) {
                    trace(face.hole);
                    pen.closePath();
                }
                pen.fillStyle = pen.strokeStyle = colours[face.kind][Math.round(32 * Math.max(0, Math.min(1, light)))];
                pen.fill("evenodd");
                pen.lineWidth = 0.8;
                if (!face.smooth) pen.strokeStyle = colours.edge;
                pen.stroke();
            }
        }

        // The arrows, and what names them: off the body, off each other, and within the drawing.
        const onto = (v, far) => [far * dot(setting.eye[0], v), -far * dot(setting.eye[1], v)];
        const labels = [];
        let beside = 0; // how far on either side of the momentum another label may not stand
        if (setting.up) {
            const [x, y] = onto(setting.up, scale);
            arrow(pen, [cx, cy], [cx + x, cy + y], colours.momentum, 5);
            beside = Math.max(colours.half.L[0], 8) + 3;
            labels.push(label(pen, "L", cx, cy - beyond(0, -1, -y, colours.half.L), colours.momentum));
        }
        const spinning = unit(now.world);
        if (spinning) {
            const [x, y] = onto(spinning, 0.86 * scale);
            arrow(pen, [cx, cy], [cx + x, cy + y], colours.omega, 3);
            // From the momentum's direction, which is up, to the right; what is right above changes sides late.
            const angle = Math.atan2(x, -y);
            if (Math.abs(angle) > 0.1) state.side = Math.sign(angle);
            const half = colours.half.ω;
            for (let turn = Math.abs(angle), i = 0; i < 40; turn += 0.05, i += 1) {
                const [ux, uy] = [state.side * Math.sin(turn), -Math.cos(turn)];
                const far = beyond(ux, uy, Math.hypot(x, y), half);
                if (Math.abs(far * ux) < beside + half[0]) continue;
                labels.push(label(pen, "ω", cx + far * ux, cy + far * uy, colours.omega));
                break;
            }
        }
        pen.fillStyle = colours.fg;
        pen.beginPath();
        pen.arc(cx, cy, 2.5, 0, 2 * Math.PI);
        pen.fill();
        canvas.shows = { labels, body: { xs, ys, cx, cy } }; // for those who test it
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
        const scale = Math.max(Math.min((0.5 * width - 26) / extent[0], (0.5 * height - 34) / extent[1]), 1);
        const at = (p) => [width / 2 + scale * dot(look[0], p), height / 2 - scale * dot(look[1], p)];
        const before = (p) => dot(p.map((x, k) => x / half[k] ** 2), look[2]) >= 0;
        return { half, scale, at, before };
    };
    const spot = stage.querySelector(".tumble-dot");
    paper("polhode", (wide) => Math.round(wide < 480 ? 0.6 * wide : Math.min(0.62 * wide, 400)), (pen, width, height) => {
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
            // Its name on from its tip, as one sees it.
            const [[fromX, fromY], [tipX, tipY]] = [at(from), at(to)];
            const long = Math.hypot(tipX - fromX, tipY - fromY);
            const [x, y] = [tipX + 11 * (tipX - fromX) / long, tipY + 11 * (tipY - fromY) / long];
            pen.font = colours.font;
            pen.textAlign = "center";
            pen.fillText(name, x, y + 5);
        });
    }, (pen, width, height) => {
        const { now, setting } = state;
        const point = now.omega.map((x) => x * setting.onto);
        const there = point.every(Number.isFinite);
        place(spot, "visibility", there ? "visible" : "hidden");
        if (!there) return;
        const { at, before } = ellipsoid(width, height);
        const [x, y] = at(point);
        place(spot, "transform", `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`);
        place(spot, "opacity", before(point) ? "1" : "0.45");
    });

    // ---- The spin along the axis that it was spun about over time, and the flips predicted.
    const cursor = stage.querySelector(".tumble-cursor");
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
        pen.strokeStyle = colours[SPUN[about.value].colour];
        pen.lineWidth = 2;
        pen.stroke();
    }, (pen, width, height) => {
        const { from, to } = state.window;
        const x = EDGE + ((state.t - from) / (to - from)) * (width - 2 * EDGE);
        place(cursor, "height", `${height - 22}px`);
        place(cursor, "transform", `translateX(${x.toFixed(1)}px)`);
    });

    // ---- What the module says.
    const list = (numbers, size) => Array.from({ length: numbers.length / size }, (_, i) => Array.from(numbers.slice(size * i, size * (i + 1))));
    /** What is wrong, in the module's words if there are no others. */
    function complain(said) {
        wrong.textContent = said ?? `${exact.words()}.`;
        wrong.hidden = false;
        pause();
        return wrong.textContent;
    }
    const number = (field) => (field.value.trim() === "" ? NaN : Number(field.value));

    const missing = (what) => `The field for the ${what} has no number in it: type a finite one.`;

    /** Of each axis to spin about: which of x, y, z it is, where the push goes, its colour, and its name. */
    const SPUN = [
        { along: 0, across: 1, colour: "axis-mid", axis: "the middle axis" },
        { along: 2, across: 0, colour: "axis-min", axis: "the axis of the smallest moment" },
        { along: 1, across: 0, colour: "axis-max", axis: "the axis of the largest moment" },
    ];

    /** Prepares the motion of what the controls are set to, from its start. */
    function prepare() {
        const empty = [["spin", spinNumber], ["push", pushNumber]].find(([, field]) => Number.isNaN(number(field)));
        const found = empty ? null : exact.answer(0, Number(body.value), number(spinNumber), number(pushNumber), Number(about.value));
        if (!found) {
            state.setting = null;
            for (const what of ["beat", "next", "time", "flips", "spin"]) shown(what).textContent = "none";
            complain(empty && missing(empty[0]));
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
        const { along, across } = SPUN[about.value];
        const omega = [0, 0, 0];
        [omega[along], omega[across]] = [number(spinNumber), number(spinNumber) * number(pushNumber)];
        const side = omega[around] < 0 ? -1 : 1;
        const turns = (20 * Math.PI) / Math.abs(number(spinNumber));
        const stretch = 6 * beat;
        if (state.body !== body.value) [state.body, state.model] = [body.value, modelled(Number(body.value), [x, y, z])];
        state.setting = {
            ...state.model,
            moments, onto, beat, instant,
            up: unit([lx, ly, lz]),
            momentum: [lx, ly, lz],
            eye: eye([lx, ly, lz]),
            others: [0.25, 0.65].flatMap((part) => [polhode(1, between(part, b, a)), polhode(2, between(part, c, a))]),
            between: [polhode(1, a)],
            own: own?.map((p) => p.map((value) => side * value)),
            stretch: stretch > 0 && stretch < 1e300 ? stretch : turns > 0 && turns < 1e300 ? turns : 10,
        };
        state.window = null;
        shown("beat").textContent = Number.isNaN(beat) ? "none: it never flips" : `${spanned(beat)} s`;
        go(0);
        redraw();
    }
    const spanned = (beat) => (beat >= 100 && beat < 1e12 ? fixed(beat, 0) : state.setting.instant(beat));

    /** Shows the instant `t`; says whether there is one. */
    function go(t) {
        if (!state.setting) return false;
        const found = Number.isNaN(t) ? null : exact.answer(1, t);
        if (!found) {
            complain(Number.isNaN(t) ? missing("time") : undefined);
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
        if (state.flips !== flips && state.playing) say(t < 0 ? `A flip at ${instant(t)} s.` : `Flip ${flips} at ${instant(t)} s.`);
        [state.flips, state.next] = [flips, next];
        // Nobody reads numbers that change with every frame, and each would have the page laid out anew.
        const now = performance.now();
        if (!state.playing || !(now - state.told < 100)) {
            state.told = now;
            tell();
        }
        state.drawn += 1;
        for (const it of papers) if (it === solid || solid.coarse === 1 || state.drawn % 3 === 0) it.draw();
        return true;
    }
    /** How the parts of a spin are written: with two decimals, where these tell of it. */
    const speeds = (omega) => {
        const most = Math.max(...omega.map(Math.abs));
        return (w) => (most === 0 || (most >= 0.1 && Math.abs(w) < 1e4) ? fixed(w, 2) : short(w));
    };
    const count = () => `${state.flips} ${state.flips === 1 ? "flip" : "flips"} ${state.t < 0 ? "from here to the start" : "so far"}`;
    /** The numbers of the instant, in the page. */
    function tell() {
        const { t, flips, next, now, setting: { instant } } = state;
        const coming = next.filter((flip) => !Number.isNaN(flip));
        shown("time").textContent = `${instant(t)} s`;
        shown("flips").textContent = t < 0 && flips > 0 ? `none: ${flips} from here to the start` : String(flips);
        shown("next").textContent = coming.length > 0 ? `${coming.map(instant).join(", ")} s` : "none: it never flips";
        shown("spin").textContent = now.omega.map(speeds(now.omega)).join(", ");
        scrub.value = t;
        scrub.setAttribute("aria-valuetext", `${instant(t)} s, ${count()}`);
    }
    const told = () => {
        if (!state.setting || !wrong.hidden) return ""; // what is wrong is said by itself
        return `At ${shown("time").textContent} ${state.t < 0 ? `it has ${count()}` : `it has flipped ${state.flips} times`}; along ${SPUN[about.value].axis} it spins at ${speeds(state.now.omega)(state.now.omega[SPUN[about.value].along])} rad/s. `
            + `Time between flips: ${shown("beat").textContent}. Next flips at: ${shown("next").textContent}.`;
    };

    // ---- Time: it runs only when asked, and where less motion is preferred it goes by steps.
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    const rate = () => 10 ** Number(speed.value);
    let pending = 0; // the frame that was asked for last
    function name() {
        play.textContent = still.matches ? "Step" : state.playing ? "Pause" : "Play";
    }
    function pause() {
        cancelAnimationFrame(pending);
        if (!state.playing) return;
        state.playing = false;
        name();
        if (state.setting) tell();
        coarsen(1);
    }
    function coarsen(to) {
        if (solid.coarse === to) return;
        solid.coarse = to;
        solid.measure();
        for (const it of papers) it.draw();
    }
    function run() {
        state.playing = true;
        name();
        let last = null;
        let [late, frames] = [0, 0];
        const frame = (now) => {
            // A page out of sight gets no frames: what it missed is not made up for.
            const passed = last === null ? 0 : Math.min((now - last) / 1000, 0.1);
            last = now;
            // Where half of the frames come late, the body is drawn coarser while it moves, and the rest less often.
            frames += 1;
            if (passed > 0.022) late += 1;
            if (frames === 12) {
                if (late > 6 && solid.coarse > 0.5) coarsen(solid.coarse * 0.7);
                [late, frames] = [0, 0];
            }
            if (go(state.t + passed * rate())) pending = requestAnimationFrame(frame);
        };
        pending = requestAnimationFrame(frame);
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
        name();
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
    function caption() {
        const times = Number(rate().toPrecision(2));
        shown("speed").textContent = times === 1 ? "as in life" : `${times} × life`;
        speed.setAttribute("aria-valuetext", times === 1 ? "as in life" : `${times} times as fast as in life`);
        spin.setAttribute("aria-valuetext", `${spinNumber.value} rad/s`);
        const pushed = number(pushNumber);
        push.setAttribute("aria-valuetext", pushed === 0 ? "no push" : `a push of ${Number.isFinite(pushed) ? short(pushed) : "no number"} of the spin`);
    }
    function change() {
        pause();
        caption();
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
    for (const choice of [body, about]) choice.addEventListener("input", change);
    function view() {
        for (const field of [turn, tilt]) field.setAttribute("aria-valuetext", `${field.value} degrees`);
        if (!state.setting) return;
        state.setting.eye = eye(state.setting.momentum);
        solid.draw();
    }
    for (const field of [turn, tilt]) field.addEventListener("input", view);
    // Dragged, the picture turns with the hand: half a degree for each pixel.
    const picture = stage.querySelector("[data-draws=body]");
    picture.addEventListener("pointerdown", (event) => picture.setPointerCapture(event.pointerId));
    picture.addEventListener("pointermove", (event) => {
        if (!picture.hasPointerCapture(event.pointerId)) return;
        turn.value = ((Number(turn.value) + 0.5 * event.movementX + 540) % 360) - 180;
        tilt.value = Number(tilt.value) + 0.5 * event.movementY;
        view();
    });
    speed.addEventListener("input", caption);

    function redraw() {
        for (const it of papers) {
            it.prepare();
            it.draw();
        }
    }
    const recolour = () => {
        dye();
        redraw();
    };
    dye();
    new MutationObserver(recolour).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
    for (const query of ["(forced-colors: active)", "(prefers-color-scheme: dark)"]) matchMedia(query).addEventListener("change", recolour);
    name();
    caption();
    view();
    prepare();
});
