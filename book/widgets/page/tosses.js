// Three tosses of one book side by side, with the same error of the hand. Where each is, and when it flips, the tumble's module says.
"use strict";

tumblingLive.widget("tosses", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [exact] = await Promise.all([module("tumble"), load(`${from}live.book.js`), load(`${from}live.bodies.js`)]);
    const { palette, clock, looks } = tumblingLive.bodies;
    const [play, back, slip] = ["play", "back", "slip"].map((id) => stage.querySelector(`#tosses-${id}`));
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    const [BOOK, SPIN, SLOW, LONG] = [1, 4 * Math.PI, 6, 60]; // which body; two turns a second, in rad/s; of life's pace; how long flips are known, s
    const book = tumblingLive.book(stage, exact.answer(6, BOOK));
    const moments = Array.from(exact.answer(7, BOOK)).slice(0, 3);
    const ALONG = { across: 0, spine: 2, through: 1 };
    const flights = [...stage.querySelectorAll("canvas")].map((canvas) => ({ canvas, toss: canvas.dataset.toss, count: stage.querySelector(`[data-counts=${canvas.dataset.toss}]`), omega: [], flips: [] }));
    const state = { t: 0, turn: 24, tilt: 0 };
    palette(stage, () => {
        book.dye();
        draw();
    });
    function draw(counts) {
        for (const { canvas, toss, omega, flips, count } of flights) {
            const at = omega.length && exact.answer(4, ...moments, ...omega, state.t, 0);
            if (!at) continue;
            if (counts !== "alone") book.draw(canvas, book.tosses[toss], Array.from(at.slice(3, 7)), state);
            const number = flips.filter((flip) => flip <= state.t).length;
            const text = number > 0 ? `Flip ${number}` : "no flip";
            if (count.textContent !== text) count.textContent = text;
        }
    }
    /** Shows the instant; returns it in words. */
    function go(t) {
        const same = t === 0 && state.t === 0; // there no error of the hand shows yet
        state.t = t;
        draw(same ? "alone" : "too");
        const time = `${fixed(t, 2)} s`;
        if (shown("time").textContent !== time) shown("time").textContent = time;
        return `After ${time}: ${flights.map(({ count }, k) => `${["end over end", "like a pencil", "like a discus"][k]} ${count.textContent.toLowerCase()}`).join(", ")}.`;
    }
    function begin() {
        const error = Number((10 ** slip.value).toPrecision(2));
        for (const flight of flights) {
            flight.omega = [0, 1, 2].map((axis) => (axis === ALONG[flight.toss] ? SPIN : error * SPIN));
            if (flight.toss !== "across") continue; // about x alone a change of its sign is a flip
            const [count, ...times] = exact.answer(5, ...moments, ...flight.omega, LONG, 1);
            flight.flips = times.slice(0, count);
        }
        const [first, second] = flights.find(({ toss }) => toss === "across").flips;
        shown("first").textContent = `${fixed(first, 2)} s, ${fixed(first * SPIN / (2 * Math.PI), 1)} turns`;
        shown("beat").textContent = `${fixed(second - first, 2)} s`;
        shown("slip").textContent = error >= 1e-3 ? `${fixed(100 * error, error >= 0.01 ? 0 : 1)} % of the spin` : `one part in ${fixed(1 / error, 0).replace(/\B(?=(\d{3})+$)/g, " ")}`;
        slip.setAttribute("aria-valuetext", shown("slip").textContent);
        return `The hand is off by ${shown("slip").textContent}: first flip after ${shown("first").textContent}. ${go(0)}`;
    }
    const { pause } = clock(stage, play, { step: 0.1, go: (seconds) => Boolean(go((state.t + seconds / SLOW) % LONG)), pressed: () => say(go(state.t)) });
    back.addEventListener("click", () => {
        pause();
        say(go(0));
    });
    slip.addEventListener("input", () => say(begin()));
    for (const { canvas } of flights) {
        looks(canvas, state, draw);
        new ResizeObserver(draw).observe(canvas);
    }
    begin();
});
