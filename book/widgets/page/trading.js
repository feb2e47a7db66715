// Euler's equations: the three components of the box's spin trade with each other, and the energy with them. The motion is the tumble module's.
"use strict";

tumblingLive.widget("trading", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [exact] = await Promise.all([module("tumble"), load(`${from}live.solids.js`), load(`${from}live.bodies.js`)]);
    const { dot, unit, rows, through, upright, orbit, model, palette, paper, path, paint, arrows, clock, looks } = tumblingLive.bodies;
    const [play, start, scrub] = ["play", "start", "scrub"].map((id) => stage.querySelector(`#trading-${id}`));
    const canvas = (what) => stage.querySelector(`[data-draws=${what}]`);
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const shares = ["mid", "max", "min"].map((axis) => stage.querySelector(`.trading-energy .trading-${axis}`)); // of x, y, z
    const say = sayer(stage);
    const [, , , ...centre] = exact.answer(7, 0);
    const solid = model(exact.answer(6, 0), 0, centre);
    const INKS = ["axis-mid", "axis-max", "axis-min"]; // of x, y, z
    /** The starts: the spin, rad/s, how long is shown, s, and how many seconds of it pass in one. */
    const STARTS = [
        { spin: [1, 1, 0], until: 16.4, pace: 1 },
        { spin: [0, 0, 1], until: 16.4, pace: 1 },
        { spin: [0.1, 0, 10], until: 8, pace: 0.4 },
        { spin: [10, 0.1, 0], until: 8, pace: 0.4 },
        { spin: [0.1, 10, 0], until: 8, pace: 0.4 },
    ];
    const SAMPLES = 400;
    const state = { t: 0, turn: 28, tilt: 22, now: null, samples: [], up: [0, 0, 1], sides: {} };
    const colours = palette(stage, () => {
        curves.prepare();
        curves.draw();
        body.draw();
    });

    const body = paper(canvas("body"), (width) => Math.round(Math.min(0.85 * width, 240)), (pen, width, height) => {
        if (!state.now) return;
        const eye = orbit(upright(state.up), state.turn, state.tilt);
        const scale = Math.max(0.5 * Math.min(width, height) - 22, 1);
        const painted = paint(pen, colours, solid, through(eye, rows(state.now.slice(3, 7))), [width / 2, height / 2], scale);
        const tip = (v, far) => [far * dot(eye[0], v), -far * dot(eye[1], v)];
        canvas("body").shows = { body: painted, turn: state.turn, tilt: state.tilt }; // for those who test it
        arrows(pen, colours, painted, [
            { name: "L", tip: tip(unit(state.up), scale), colour: colours.momentum, width: 4.5 },
            { name: "ω", tip: tip(unit(Array.from(state.now.slice(7, 10))), 0.86 * scale), colour: colours.omega, width: 3 },
        ], state.sides);
    });
    const across = (t, width) => 8 + (t / STARTS[start.value].until) * (width - 16);
    const curves = paper(canvas("curves"), (width) => Math.round(Math.min(0.7 * width, 240)), (pen, width, height) => {
        curves.prepare();
        if (!state.now) return;
        const x = across(state.t, width);
        pen.strokeStyle = colours.fg;
        pen.lineWidth = 1.4;
        path(pen, [[x, 6], [x, height - 6]]);
        pen.stroke();
        [0, 1, 2].forEach((k) => {
            pen.fillStyle = colours[INKS[k]];
            pen.beginPath();
            pen.arc(x, level(height, state.now[k]), 4.5, 0, 2 * Math.PI);
            pen.fill();
        });
    }, (pen, width, height) => {
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 1;
        path(pen, [[8, height / 2], [width - 8, height / 2]]);
        pen.stroke();
        [2, 1, 0].forEach((k) => {
            path(pen, state.samples.map((sample, i) => [across(STARTS[start.value].until * i / (SAMPLES - 1), width), level(height, sample[k])]));
            pen.strokeStyle = colours[INKS[k]];
            pen.lineWidth = 2.2;
            pen.stroke();
        });
    });
    const level = (height, value) => height / 2 - (0.46 * height * value) / state.most;

    function begin() {
        const { spin, until } = STARTS[start.value];
        const prepared = exact.answer(0, 0, 0, 0, 3, 0, 0, 0, ...spin);
        state.up = Array.from(prepared.slice(7, 10));
        const path = exact.answer(9, 0, until, SAMPLES);
        state.samples = Array.from({ length: SAMPLES }, (_, i) => Array.from(path.slice(6 * i, 6 * i + 3)));
        state.most = Math.max(...state.samples.flat().map(Math.abs));
        scrub.max = until;
        return at(0);
    }
    /** Shows an instant; returns it in words. */
    function at(t) {
        [state.t, scrub.value] = [t, t];
        state.now = exact.answer(1, t);
        const change = exact.answer(10, t);
        const three = (from, list) => Array.from(list.slice(from, from + 3), (x) => fixed(x, 2).replace("−0.00", "0.00")).join(", ");
        shown("time").textContent = `${fixed(t, 2)} s`;
        shown("spin").textContent = three(0, state.now);
        shown("rate").textContent = three(6, change);
        shares.forEach((share, k) => { share.style.flexGrow = change[9 + k].toFixed(4); });
        scrub.setAttribute("aria-valuetext", `${fixed(t, 2)} s, spin ${three(0, state.now)} rad/s`);
        body.draw();
        curves.draw();
        const percent = [9, 10, 11].map((k) => `${fixed(100 * change[k], 0)} %`);
        return `After ${fixed(t, 2)} s the spin along x, y, z is ${three(0, state.now)} rad/s; of the energy, ${percent[0]} belongs to the spin about x, ${percent[1]} to that about y, ${percent[2]} to that about z.`;
    }
    const { pause } = clock(stage, play, {
        step: 0.5,
        go(seconds) {
            const { until, pace } = STARTS[start.value];
            at((state.t + pace * seconds) % until);
            return true;
        },
        pressed: () => say(at(state.t)),
    });
    scrub.addEventListener("input", () => {
        pause();
        say(at(Number(scrub.value)));
    });
    start.addEventListener("input", () => {
        pause();
        say(begin());
    });
    looks(canvas("body"), state, body.draw);
    begin();
});
