// A stable spin, exact and as three engines step it, each at its own rate. The steps are the steps' module's, the exact motion the tumble's.
"use strict";

tumblingLive.widget("engines", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [steps, exact] = await Promise.all([...["steps", "tumble"].map(module), load(`${from}live.solids.js`), load(`${from}live.bodies.js`)]);
    const { dot, rows, through, orbit, upright, model, palette, paper, paint, arrows, clock, looks } = tumblingLive.bodies;
    const [play, back, speed] = ["play", "back", "speed"].map((id) => stage.querySelector(`#engines-${id}`));
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    // The body and the spin of the text: its axes 1, 2, 3 are z, x and y here, as the drawn box has them.
    const [MOMENTS, SPIN, UNTIL, LOST] = [[2, 3, 1], [0.5, 10, 0.5], 60, 60]; // kg m²; rad/s; s; degrees
    // A body of these moments is flat; it is drawn with some thickness, so that its edge is seen.
    const flat = exact.answer(6, 9, ...MOMENTS);
    flat[6] = 0.2;
    const solid = model(flat, 9, [0, 0, 0]);
    // Which rule, and how many steps a second: crates/engines/src/catalogue.rs has them, and the text their fates.
    const RULES = [
        { name: "exact" },
        { name: "pybullet", rule: "explicit gyroscopic step", rate: 240, limit: 100 }, // rad/s in each component
        { name: "Rapier", rule: "rescaled, turned straight", rate: 60, parts: 4 },
        { name: "MuJoCo", rule: "explicit gyroscopic step", rate: 500 },
    ];
    const numbered = new Map();
    for (let k = 0; steps.answer(0, k); k += 1) numbered.set(steps.words(), k);
    const momentum = MOMENTS.map((moment, k) => moment * SPIN[k]);
    const view = { turn: 24, tilt: 16 };
    let [shares, share] = [1, 0]; // where half of the frames come late each draws half of the pictures
    const box = stage.querySelector(".engines-four");
    const colours = palette(stage, () => flights.forEach(({ picture }) => picture.draw()));
    const flights = RULES.map((engine) => {
        const place = box.appendChild(document.createElement("div"));
        const [title, canvas, words] = ["p", "canvas", "p"].map((kind) => place.appendChild(document.createElement(kind)));
        title.textContent = engine.name;
        canvas.className = "live-drawing live-low";
        canvas.setAttribute("aria-hidden", "true");
        words.className = "toss-count";
        const flight = { ...engine, canvas, words, sides: {} };
        flight.picture = paper(canvas, (width) => Math.round(Math.min(1.1 * width, 210)), (pen, width, height) => {
            if (!flight.now) return;
            const eye = orbit(upright(momentum), view.turn, view.tilt);
            const scale = Math.min(width, height) / 2 - 18;
            const turned = rows(flight.now.attitude);
            const body = paint(pen, colours, solid, through(eye, turned), [width / 2, height / 2], 1.05 * scale);
            const tip = (vector, most) => {
                const world = turned.map((row) => dot(row, vector));
                return [0, 1].map((k) => (k ? -1 : 1) * scale * dot(eye[k], world) / most);
            };
            const most = Math.hypot(...momentum);
            const long = Math.max(most, Math.hypot(...flight.now.momentum));
            const fast = Math.max(Math.hypot(...SPIN), Math.hypot(...flight.now.spin));
            arrows(pen, colours, body, [{ name: "L", tip: tip(flight.now.momentum, long), colour: colours.momentum, width: 4 }, { name: "ω", tip: tip(flight.now.spin, 1.15 * fast), colour: colours.omega, width: 3 }], flight.sides);
            canvas.shows = { ...flight.now, lost: flight.lost, rests: flight.rests, t: flight.t, ...view, body }; // for those who test it
        });
        looks(canvas, view, () => flights.forEach(({ picture }) => picture.draw()));
        return flight;
    });

    function begin() {
        for (const flight of flights) Object.assign(flight, { t: 0, taken: 0, lost: null, rests: null, now: { attitude: [1, 0, 0, 0], momentum, spin: SPIN } });
    }
    /** How far the spin leans from its axis, degrees. */
    const leans = ({ spin }) => Math.acos(Math.min(1, Math.abs(spin[1]) / Math.hypot(...spin))) * 180 / Math.PI;
    /** Steps an engine to an instant, as far as it goes, one of its own steps at a time. */
    function move(flight, t) {
        flight.t = t;
        if (!flight.rule) {
            const at = Array.from(exact.answer(4, ...MOMENTS, ...SPIN, t, 0));
            flight.now = { attitude: at.slice(3), spin: at.slice(0, 3), momentum: at.slice(0, 3).map((x, k) => x * MOMENTS[k]) };
            return;
        }
        const parts = flight.parts ?? 1;
        const goal = Math.floor(t * flight.rate * (1 + 1e-12));
        while (flight.taken < goal && flight.rests === null) {
            const { attitude, momentum } = flight.now;
            const [count, ...found] = steps.answer(2, ...MOMENTS, ...attitude, ...momentum, numbered.get(flight.rule), 1 / flight.rate / parts, parts);
            const spin = found.slice(7);
            flight.taken += 1;
            if (count < parts) flight.rests = `gave up at ${fixed(flight.taken / flight.rate, 1)} s`;
            else if (Math.max(...spin.map(Math.abs)) > (flight.limit ?? Infinity)) flight.rests = `cut off at ${flight.limit} rad/s`;
            else flight.now = { attitude: found.slice(0, 4), momentum: found.slice(4, 7), spin };
            if (flight.lost === null && leans(flight.now) > LOST) flight.lost = flight.taken / flight.rate;
        }
    }
    /** Shows the instant; returns it in words. */
    function go(t) {
        if (t < flights[0].t) begin();
        share = (share + 1) % shares;
        const told = flights.map((flight, i) => {
            move(flight, t);
            const text = flight.rests ?? (flight.lost !== null ? `lost at ${fixed(flight.lost, 1)} s` : `leans ${fixed(leans(flight.now), 0)}°`);
            if (flight.text !== text) flight.words.textContent = flight.text = text;
            if (i % shares === share) flight.picture.draw();
            return `${flight.name} ${text}`;
        });
        const time = `${fixed(t, 1)} s`;
        if (shown("time").textContent !== time) shown("time").textContent = time;
        return `At ${time}: ${told.join(", ")}.`;
    }
    const { pause } = clock(stage, play, {
        step: 5,
        go(seconds) {
            say(go(Math.min(UNTIL, flights[0].t + seconds * speed.value)));
            if (flights[0].t >= UNTIL) pause();
            return flights[0].t < UNTIL;
        },
        late: () => { shares = 2; },
        rested() {
            shares = 1;
            go(flights[0].t);
        },
        pressed: () => say(go(flights[0].t)),
    });
    back.addEventListener("click", () => {
        pause();
        say(go(0));
    });
    begin();
    go(0);
});
