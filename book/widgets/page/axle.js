// A lumpy body on an axle that the reader moves: spun about it and let go, the axle wobbles, unless it is a principal axis. The tensor is the
// two arrows' module's, its axes your body's, and where the body is, the tumble's.
"use strict";

tumblingLive.widget("axle", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [tensor, own, exact] = await Promise.all([...["two-arrows", "your-body", "tumble"].map(module), load(`${from}live.bodies.js`)]);
    const { dot, unit, rows, orbit, palette, paper, path, arrow, clock, looks } = tumblingLive.bodies;
    const canvas = stage.querySelector("canvas");
    const [play, back, around, above] = ["play", "back", "around", "above"].map((id) => stage.querySelector(`#axle-${id}`));
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    const SPIN = 4; // rad/s
    const TRUE = 4; // so near to a principal axis, degrees, the axle is put onto it

    // ---- The body: lumps on rods, each its mass, kg, and place, m; moved so that their common centre is the origin.
    const loose = [[1.5, [0.75, 0.2, 0.45]], [1.1, [-0.7, -0.3, -0.4]], [0.45, [-0.5, 0.45, 0.5]], [0.5, [0.25, 0.45, -0.75]], [0.3, [-0.15, -0.8, 0.45]]];
    const whole = loose.reduce((sum, [mass]) => sum + mass, 0);
    const lumps = loose.map(([mass, at]) => [mass, at.map((x, i) => x - loose.reduce((sum, [m, p]) => sum + m * p[i], 0) / whole)]);
    const told = tensor.answer(1, 1, 1, 0, 0, lumps.length, ...lumps.flatMap(([mass, at]) => [mass, ...at]));
    const found = Array.from(own.answer(0, 9, whole, ...told.slice(0, 6)));
    const moments = found.slice(6, 9);
    const axes = [0, 1, 2].map((k) => found.slice(9 + 3 * k, 12 + 3 * k)); // in the body as it was built
    const NAMES = ["smallest", "middle", "largest"];
    const places = lumps.map(([mass, at]) => ({ at: axes.map((axis) => dot(axis, at)), size: 0.13 * Math.cbrt(mass) })); // along its principal axes, from here on
    const built = (p) => [0, 1, 2].map((i) => axes.reduce((sum, axis, k) => sum + p[k] * axis[i], 0));
    const FACING = [[1, 0, 0], [0, 0, 1], [0, -1, 0]]; // in the body as it was built

    const state = { axle: unit([0.55, -0.08, 0.83]), t: 0, turn: 20, tilt: 16, trace: [], most: 0, now: null, resumes: false };
    const colours = palette(stage, () => picture.draw());
    const sight = () => orbit(FACING, state.turn, state.tilt).map((eye) => axes.map((axis) => dot(axis, eye)));
    const scaled = (height) => 0.37 * height;
    const picture = paper(canvas, (width) => Math.round(Math.min(0.85 * width, 380)), (pen, width, height) => {
        if (!state.now) return;
        const eye = sight();
        const scale = scaled(height);
        const on = (p) => [width / 2 + scale * dot(eye[0], p), height / 2 - scale * dot(eye[1], p)];
        const turned = (p) => state.now.turn.map((row) => dot(row, p));
        const end = turned(state.axle);
        const bar = (far, colour, wide) => {
            pen.strokeStyle = colour;
            pen.lineWidth = wide;
            path(pen, far.map(on));
            pen.stroke();
        };
        pen.globalAlpha = 0.8;
        bar(state.trace, colours.faint, 1.6);
        pen.globalAlpha = 1;
        // From far to near: the lumps with their rods, and the two halves of the axle.
        const halves = [1, -1].map((sign) => ({ deep: sign * dot(end, eye[2]) * 0.6, half: end.map((x) => 1.25 * sign * x) }));
        const all = [...halves, ...places.map(({ at, size }) => ({ at: turned(at), size, deep: dot(turned(at), eye[2]) }))].sort((a, b) => a.deep - b.deep);
        for (const { at, size, half, deep } of all) {
            if (half) {
                bar([[0, 0, 0], half], colours.fg, 3.5);
                continue;
            }
            bar([[0, 0, 0], at], colours.edge, 5);
            const [x, y] = on(at);
            const radius = scale * size * (1 + 0.12 * deep);
            const light = pen.createRadialGradient(x - 0.35 * radius, y - 0.4 * radius, 0.1 * radius, x, y, radius);
            light.addColorStop(0, colours.plain[32]);
            light.addColorStop(1, colours.plain[8]);
            pen.fillStyle = light;
            pen.beginPath();
            pen.arc(x, y, radius, 0, 2 * Math.PI);
            pen.fill();
        }
        arrow(pen, on([0, 0, 0]), on(state.up.map((x) => 1.3 * x)), colours.momentum, 5);
        arrow(pen, on([0, 0, 0]), on(unit(state.now.spin).map((x) => 1.15 * x)), colours.omega, 3);
        const tip = on(end.map((x) => 1.25 * x));
        pen.fillStyle = colours.omega;
        pen.beginPath();
        pen.arc(...tip, state.t === 0 ? 7 : 4, 0, 2 * Math.PI);
        pen.fill();
        canvas.shows = { tip, axle: built(state.axle), end, up: state.up, spin: state.now.spin, t: state.t, turn: state.turn, tilt: state.tilt, trace: state.trace }; // for those who test it
    });

    /** Shows the instant; returns it in words. */
    function go(t) {
        const now = Array.from(exact.answer(4, ...moments, ...state.axle.map((x) => SPIN * x), t, 0));
        const turn = rows(now.slice(3));
        state.now = { turn, spin: turn.map((row) => dot(row, now)) };
        const end = turn.map((row) => dot(row, state.axle));
        if (t < state.t || t === 0) [state.trace, state.most] = [[], 0];
        state.t = t;
        state.trace.push(end.map((x) => 1.25 * x));
        if (state.trace.length > 400) state.trace.shift();
        state.most = Math.max(state.most, 2 * Math.asin(Math.min(1, Math.hypot(...end.map((x, k) => x - state.axle[k])) / 2)) * 180 / Math.PI);
        const says = { wobble: `${fixed(state.most, state.most < 1 ? 1 : 0)}°`, time: `${fixed(t, 1)} s` };
        for (const [what, text] of Object.entries(says)) if (shown(what).textContent !== text) shown(what).textContent = text;
        picture.draw();
        return `After ${says.time} the axle has wobbled by ${says.wobble}.`;
    }
    /** Puts the axle into this direction of the body as it was built, or onto the principal axis beside it; returns what it says. */
    function begin(to, byHand = true) {
        const away = axes.map((axis) => Math.acos(Math.min(1, Math.abs(dot(axis, to)))) * 180 / Math.PI);
        const near = away.findIndex((angle) => angle < TRUE);
        state.axle = axes.map((axis, k) => (near < 0 ? dot(axis, to) : k === near ? Math.sign(dot(axis, to)) : 0));
        const momentum = state.axle.map((x, k) => x * moments[k]);
        state.up = unit(momentum);
        const gap = Math.acos(Math.min(1, dot(state.up, state.axle))) * 180 / Math.PI;
        shown("gap").textContent = `${fixed(gap, 1)}°`;
        const [x, y, z] = built(state.axle);
        // A slider that is moved stays where it was put, or keys could never leave a principal axis.
        if (byHand) [around.value, above.value] = [Math.atan2(y, x) * 180 / Math.PI, Math.asin(Math.max(-1, Math.min(1, z))) * 180 / Math.PI];
        const words = near < 0 ? `${fixed(Math.min(...away), 0)}° from the nearest principal axis. Let go, and the axle wobbles.` : `True: on the axis of the ${NAMES[near]} moment. Let go, the axle stays.`;
        shown("words").textContent = words;
        for (const slider of [around, above]) slider.setAttribute("aria-valuetext", `${fixed(Number(slider.value), 0)}°: ${words}`);
        return `${words} Gap ${shown("gap").textContent}. ${go(0)}`;
    }
    const { pause, playing } = clock(stage, play, { step: 0.4, start: "Let go", go: (seconds) => Boolean(go(state.t + seconds)), pressed: () => say(go(state.t)) });
    looks(canvas, state, picture.draw, {
        takes([x, y]) {
            if (Math.hypot(x - canvas.shows.tip[0], y - canvas.shows.tip[1]) > 26) return false;
            state.side = dot(state.now.turn.map((row) => dot(row, state.axle)), sight()[2]) < 0 ? -1 : 1;
            state.resumes = playing();
            pause();
            return true;
        },
        moved([x, y]) {
            const reach = 1.25 * scaled(canvas.clientHeight);
            let [u, v] = [(x - canvas.clientWidth / 2) / reach, (canvas.clientHeight / 2 - y) / reach];
            const far = Math.max(1, Math.hypot(u, v));
            [u, v] = [u / far, v / far];
            const near = state.side * Math.sqrt(Math.max(0, 1 - u * u - v * v));
            const [right, up, toward] = orbit(FACING, state.turn, state.tilt);
            say(begin(right.map((part, i) => u * part + v * up[i] + near * toward[i])));
        },
        ended: () => state.resumes && play.click(),
    });
    back.addEventListener("click", () => {
        pause();
        say(go(0));
    });
    const degrees = (slider) => (Number(slider.value) * Math.PI) / 180;
    for (const slider of [around, above]) {
        slider.addEventListener("input", () => say(begin([Math.cos(degrees(above)) * Math.cos(degrees(around)), Math.cos(degrees(above)) * Math.sin(degrees(around)), Math.sin(degrees(above))], false)));
    }
    begin(unit([0.55, -0.08, 0.83]));
});
