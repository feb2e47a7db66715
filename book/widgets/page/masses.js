// Two pairs of masses on an axle: the reader moves them, their tensor answers, and a torque shows how they resist. The tensor, the momentum
// and how fast the torque takes hold are the module's of the two arrows.
"use strict";

tumblingLive.widget("masses", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [tensor] = await Promise.all([module("two-arrows"), load(`${from}live.bodies.js`)]);
    const { dot, unit, orbit, palette, paper, path, arrow, clock, looks } = tumblingLive.bodies;
    const canvas = stage.querySelector("canvas");
    const [play, back, pair, along, out] = ["play", "back", "pair", "along", "out"].map((id) => stage.querySelector(`#masses-${id}`));
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    const [TORQUE, LASTS] = [1, 3]; // N m; s
    const FACING = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]; // the axle, x, to the right
    const state = { pairs: [[0.75, 0.45], [-0.25, 0.6]], t: 0, turn: 16, tilt: 14, found: null, held: 0 };
    const colours = palette(stage, () => picture.draw());

    /** The four masses: where each is in the body, m, and whose. All weigh 1 kg. */
    const masses = () => state.pairs.flatMap(([x, y], k) => [[x, y, 0], [-x, -y, 0]].map((at) => ({ at, k })));
    /** Driven by the torque from rest, and then let go on: how far, rad, and how fast, rad/s. */
    function turned() {
        const faster = state.found?.faster ?? 0;
        const driven = Math.min(state.t, LASTS);
        return { far: faster * driven * (state.t - driven / 2), fast: faster * driven };
    }
    const about = (angle, [x, y, z]) => [x, Math.cos(angle) * y - Math.sin(angle) * z, Math.sin(angle) * y + Math.cos(angle) * z];
    const sight = (width, height) => {
        const eye = orbit(FACING, state.turn, state.tilt);
        const scale = Math.min(width / 2 - 16, height / 2 - 12) / 1.12;
        return { eye, scale, on: (p) => [width / 2 + scale * dot(eye[0], p), height / 2 - scale * dot(eye[1], p)] };
    };
    const picture = paper(canvas, (width) => Math.round(Math.min(0.95 * width, 320)), (pen, width, height) => {
        const { eye, scale, on } = sight(width, height);
        const { far } = turned();
        const line = (ends, colour, wide) => {
            pen.strokeStyle = colour;
            pen.lineWidth = wide;
            path(pen, ends.map(on));
            pen.stroke();
        };
        line([[-1.1, 0, 0], [1.1, 0, 0]], colours.faint, 5);
        const balls = masses().map(({ at, k }) => ({ at: about(far, at), k }));
        for (const { at } of balls) line([[0, 0, 0], at], colours.edge, 2.5);
        // From far to near, the larger the nearer.
        balls.sort((a, b) => dot(a.at, eye[2]) - dot(b.at, eye[2]));
        const places = [];
        for (const { at, k } of balls) {
            const [x, y] = on(at);
            pen.fillStyle = k === 0 ? colours["axis-mid"] : colours.plain[26];
            pen.strokeStyle = k === 0 ? colours["axis-mid"] : colours.edge;
            pen.lineWidth = 2;
            pen.beginPath();
            pen.arc(x, y, 0.085 * scale * (1 + 0.15 * dot(at, eye[2])), 0, 2 * Math.PI);
            pen.fill();
            pen.stroke();
            places.push({ x, y, k });
        }
        if (state.found) {
            const { momentum } = state.found;
            arrow(pen, on([0, 0, 0]), on(unit(about(far, momentum)).map((part) => 0.95 * part)), colours.momentum, 5);
            arrow(pen, on([0, 0, 0]), on([0.95, 0, 0]), colours.omega, 3);
        }
        canvas.shows = { places, far, turn: state.turn, tilt: state.tilt, pairs: state.pairs.map((p) => [...p]) }; // for those who test it
    });

    /** Shows the instant; returns it in words. */
    function go(t) {
        state.t = t;
        const { fast } = turned();
        const now = fixed(fast, 1);
        if (shown("now").textContent !== now) shown("now").textContent = now;
        picture.draw();
        return `It turns at ${now} rad/s.`;
    }
    /** Asks for the tensor of the masses where they are now, at rest; returns it in words. */
    function begin() {
        const told = masses().flatMap(({ at }) => [1, ...at]);
        const found = tensor.answer(1, TORQUE, 1, 0, 0, 4, ...told);
        state.found = found && { entries: found.slice(0, 6), momentum: Array.from(found.slice(6, 9)), faster: found[10] };
        [along.value, out.value] = state.pairs[pair.value];
        const says = found ? { about: fixed(found[9], 2), faster: fixed(found[10], 2), gap: `${fixed(Math.atan2(Math.hypot(found[7], found[8]), found[6]) * 180 / Math.PI, 1)}°` }
            : { about: "none", faster: "without end", gap: "no momentum" };
        for (const [what, text] of Object.entries(says)) shown(what).textContent = text;
        for (const place of stage.querySelectorAll("[data-at]")) {
            const text = found ? fixed(found[place.dataset.at], 2).replace(/^−0\.00$/, "0.00") : "0.00";
            if (place.textContent === text) continue;
            if (place.textContent && !matchMedia("(prefers-reduced-motion: reduce)").matches) place.animate([{ background: "var(--fig-surface)" }, { background: "none" }], 700);
            place.textContent = text;
        }
        for (const slider of [along, out]) slider.setAttribute("aria-valuetext", `${fixed(Number(slider.value), 2)} m: resistance ${says.about}, gap ${says.gap}`);
        play.disabled = !found;
        return `Resistance about the axle ${says.about}; the torque makes it faster by ${says.faster} rad/s each second; gap ${says.gap}. ${go(0)}`;
    }
    const { pause } = clock(stage, play, { step: 0.5, start: "Apply the torque", go: (seconds) => Boolean(go(state.t + seconds)), pressed: () => say(go(state.t)) });
    function move(k, [x, y]) {
        pause();
        state.pairs[k] = [x, y].map((part) => Math.max(-1, Math.min(1, Math.round(part * 20) / 20)));
        pair.value = k;
        say(begin());
    }
    looks(canvas, state, picture.draw, {
        takes([x, y]) {
            const near = canvas.shows.places.map((place) => ({ ...place, far: Math.hypot(place.x - x, place.y - y) })).sort((a, b) => a.far - b.far)[0];
            if (near.far > 24) return false;
            // Each mass by itself, not its partner: on which side of the middle it is.
            const { on } = sight(canvas.clientWidth, canvas.clientHeight);
            const [u, v] = on(about(turned().far, [...state.pairs[near.k], 0]));
            state.held = { k: near.k, sign: Math.hypot(u - near.x, v - near.y) < 1 ? 1 : -1 };
            return true;
        },
        moved([x, y]) {
            // Where the finger's line meets the plane of the masses, at rest.
            const { eye: [right, up], scale } = sight(canvas.clientWidth, canvas.clientHeight);
            const [u, v] = [(x - canvas.clientWidth / 2) / scale, (canvas.clientHeight / 2 - y) / scale];
            const size = right[0] * up[1] - right[1] * up[0];
            if (Math.abs(size) < 0.1) return; // the plane is seen from its edge
            const { k, sign } = state.held;
            move(k, [u * up[1] - v * right[1], v * right[0] - u * up[0]].map((part) => sign * part / size));
        },
        ended: () => {},
    });
    back.addEventListener("click", () => {
        pause();
        say(go(0));
    });
    pair.addEventListener("input", () => { [along.value, out.value] = state.pairs[pair.value]; });
    for (const slider of [along, out]) slider.addEventListener("input", () => move(Number(pair.value), [Number(along.value), Number(out.value)]));
    begin();
});
