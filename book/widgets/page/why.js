// Why just the middle axis: four masses on two rods, in a frame that turns steadily about their momentum, with what pulls at them there;
// and in the body the sphere of the momentum, which meets the ellipsoid of the energy in a curve. The motion is the tumble module's.
"use strict";

tumblingLive.widget("why", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [exact] = await Promise.all([module("tumble"), load(`${from}live.bodies.js`), load(`${from}live.meeting.js`)]);
    const { meeting, bodies: { dot, unit, upright, orbit, palette, paper, path, arrow, clock, looks } } = tumblingLive;
    const canvas = (what) => stage.querySelector(`[data-draws=${what}]`);
    const places = Object.fromEntries(Array.from(stage.querySelectorAll("[data-shows]"), (place) => [place.dataset.shows, place]));
    const shown = (what) => places[what];
    const [play, back, size] = ["play", "back", "size"].map((id) => stage.querySelector(`#why-${id}`));
    const choices = [...stage.querySelectorAll("[data-start]")];
    const say = sayer(stage);
    const moments = Array.from(exact.answer(12)); // about x, the light rod; y, across both; z, the heavy rod
    const ENERGY = 2 * moments[0]; // J: a spin of 2 rad/s about the light rod
    const half = moments.map((moment) => Math.sqrt(2 * ENERGY * moment)); // of the ellipsoid, in momenta
    [size.min, size.max] = [half[2], half[1]];
    /** The momentum in this direction that has the energy. */
    const onto = (way) => way.map((part) => part / Math.hypot(...way.map((x, k) => x / half[k])));
    /** Off one axis toward another; of y the end that is turned to the reader. */
    const leaning = (degrees, main, other) => onto([1, -1, 1].map((sign, k) => sign * (k === main ? Math.cos : k === other ? Math.sin : () => 0)(degrees * Math.PI / 180)));
    const STARTS = {
        hard: { at: leaning(8, 1, 0), words: "All four masses swing out. Whichever way the body tilts, the pulls draw it flat again." },
        easy: { at: leaning(8, 2, 1), words: "The heavy pair stands on the axis and is flung outward, whichever way it tilts. But what moves is turned aside: it circles." },
        middle: { at: leaning(3, 0, 1), words: "The light pair stands on the axis. Toward the heavy pair it cannot fall; tilted across, nothing holds it, and it is flung over." },
    };
    const state = { t: 0, start: STARTS.middle, at: STARTS.middle.at, rate: 0, now: null, masses: [], view: { turn: 62, tilt: 20 }, curve: [] };
    const colours = palette(stage, () => [body, globe].forEach((it) => it.draw()));

    // ---- The rods: x, y and z of this frame are the world's at the start. The camera turns with it; the room goes by.
    const PX = 105; // px for a pull of 1 N
    const body = paper(canvas("body"), (width) => Math.round(Math.min(0.72 * width, 300)), (pen, width, height) => {
        const eye = orbit(upright(state.at), state.view.turn, state.view.tilt);
        const scale = 1.9 * height;
        const on = (p, far = scale) => [width / 2 + far * dot(eye[0], p), height / 2 - far * dot(eye[1], p)];
        const [across, up, toward] = upright(state.at);
        const room = (front) => {
            pen.fillStyle = colours.faint;
            pen.beginPath();
            for (let k = 0; k < 16; k += 1) {
                const angle = (k * Math.PI) / 8 + state.rate * state.t; // against the body's turn
                const post = across.map((x, i) => 0.27 * (Math.cos(angle) * x + Math.sin(angle) * toward[i]));
                if ((dot(post, eye[2]) > 0) !== front) continue;
                const [x, y] = on(post);
                pen.moveTo(x, y);
                pen.arc(x, y, front ? 2.6 : 1.7, 0, 2 * Math.PI);
            }
            pen.fill();
        };
        room(false);
        arrow(pen, on([0, 0, 0]), on(up.map((x) => 0.25 * x)), colours.momentum, 4);
        const balls = state.masses.map((mass, k) => ({ ...mass, light: k > 1, deep: dot(mass.place, eye[2]) })).sort((a, b) => a.deep - b.deep);
        for (const { place, light, deep, first } of balls) {
            pen.strokeStyle = colours.edge;
            pen.lineWidth = light ? 4 : 7;
            path(pen, [on([0, 0, 0]), on(place)]);
            pen.stroke();
            const [x, y] = on(place);
            const radius = (light ? 0.028 : 0.04) * scale * (1 + 0.6 * deep);
            pen.fillStyle = light ? (first ? colours["axis-mid"] : colours.bg) : colours.plain[12];
            pen.strokeStyle = light ? colours["axis-mid"] : colours.edge;
            pen.lineWidth = 2;
            pen.beginPath();
            pen.arc(x, y, radius, 0, 2 * Math.PI);
            pen.fill();
            pen.stroke();
        }
        const tips = state.masses.map(({ place, out, aside }) => [[out, colours.fg], [aside, colours.separatrix]].map(([force, colour]) => {
            const [x, y] = on(place);
            const [u, v] = on(force, PX).map((value, k) => value - [width, height][k] / 2);
            if (Math.hypot(...force) * PX > 5) arrow(pen, [x, y], [x + u, y + v], colour, 2.6);
            return [u, v];
        }));
        room(true);
        canvas("body").shows = { tips, masses: state.masses, up, t: state.t, ...state.view }; // for those who test it
    });

    const globe = meeting(canvas("globe"), colours, half, [["light rod", "axis-mid"], ["across", "axis-max"], ["heavy rod", "axis-min"]], {
        get: () => ({ at: state.at, now: state.now, curve: state.curve }),
        moved(to) {
            pause();
            begin(to);
        },
        ended: () => playing() || play.click(),
    });

    /** Shows an instant; returns it in words. */
    function go(t) {
        state.t = t;
        const now = exact.answer(1, t);
        const pulls = exact.answer(11, t, state.rate);
        state.now = moments.map((moment, k) => moment * now[k]);
        const three = (i) => [pulls[i], pulls[i + 1], pulls[i + 2]];
        state.masses = [0, 1, 2, 3].map((i) => ({ place: three(9 * i), out: three(9 * i + 3), aside: three(9 * i + 6), first: i === 2 }));
        const along = [0, 1, 2].reduce((most, k) => (Math.abs(state.at[k]) > Math.abs(state.at[most]) ? k : most));
        const tilt = (180 / Math.PI) * Math.acos(Math.max(-1, Math.min(1, state.now[along] / Math.hypot(...state.at) * Math.sign(state.at[along]))));
        const says = { heavy: fixed(Math.hypot(...state.masses[0].out), 2), light: fixed(Math.hypot(...state.masses[2].out), 2), tilt: `${fixed(tilt, 0)}°`, flips: fixed(along === 0 ? now[10] : 0, 0) };
        for (const [what, text] of Object.entries(says)) if (shown(what).textContent !== text) shown(what).textContent = text;
        for (const it of [body, globe]) it.draw();
        return `After ${fixed(t, 1)} s: tilted by ${says.tilt}, flips ${says.flips}; pulled outward with ${says.heavy} N each heavy mass, ${says.light} N each light one.`;
    }
    /** Begins with this momentum in the body, and a frame in which the body hangs, or comes back to its place. */
    function begin(at, words) {
        state.at = at;
        const omega = at.map((part, k) => part / moments[k]);
        exact.answer(0, 9, 0, 0, 3, ...moments, ...omega);
        const length = Math.hypot(...at);
        const depth = length ** 2 / (2 * ENERGY);
        state.rate = 2 * ENERGY / length;
        const period = exact.answer(11, 0, 0).at(-1);
        if (Math.abs(depth / moments[0] - 1) > 0.06 && period > 0) {
            const [w, ...turned] = exact.answer(1, period).slice(3, 7);
            const over = 2 * Math.atan2(dot(turned, unit(at)), w) - state.rate * period;
            state.rate += (over - 2 * Math.PI * Math.round(over / (2 * Math.PI))) / period;
        }
        const points = exact.answer(3, depth < moments[0] ? 2 : 1, depth, 180);
        const [x, y, z] = moments.map((moment) => moment * Math.sqrt(2 * ENERGY / moments[2]));
        state.curve = Array.from({ length: 180 }, (_, i) => [x * points[3 * i], y * points[3 * i + 1], z * points[3 * i + 2]]);
        if (Number(size.value) !== length) size.value = length;
        for (const button of choices) {
            const pressed = String(STARTS[button.dataset.start].at === at);
            if (button.getAttribute("aria-pressed") !== pressed) button.setAttribute("aria-pressed", pressed); // what is set is styled anew
        }
        const ends = ["The sphere touches the ellipsoid at two points: a spin there stays.", "The curve is a loop about the heavy rod: a spin on it never leaves.",
            "The curves cross at the light rod: a spin near this saddle is led away.", "The curve is a loop about the axis across both rods: a spin on it never leaves."];
        const near = (k) => Math.abs(length / half[k] - 1) < 1e-3;
        const told = words ?? ends[near(2) || near(1) ? 0 : near(0) ? 2 : depth < moments[0] ? 1 : 3];
        if (shown("words").textContent !== told) size.setAttribute("aria-valuetext", shown("words").textContent = told);
        return `${told} ${go(0)}`;
    }
    const { pause, playing } = clock(stage, play, {
        step: 0.3, start: "Let go",
        go: (seconds) => Boolean(go(state.t + seconds)),
        pressed: () => say(go(state.t)),
    });
    for (const button of choices) {
        button.addEventListener("click", () => {
            const { at, words } = STARTS[button.dataset.start];
            say(begin(at, words));
        });
    }
    back.addEventListener("click", () => {
        pause();
        say(go(0));
    });
    size.addEventListener("input", () => {
        // On the great arc from the heavy rod to the axis across; at the cross, exactly.
        const length = Math.abs(size.value / half[0] - 1) < 0.006 ? half[0] : Number(size.value);
        const low = half[2] * Math.sqrt(Math.max(0, (half[1] ** 2 - length ** 2) / (half[1] ** 2 - half[2] ** 2)));
        say(begin([0, -Math.sqrt(Math.max(0, length ** 2 - low ** 2)), low]));
    });
    looks(canvas("body"), state.view, body.draw);
    begin(STARTS.middle.at, STARTS.middle.words);
});
