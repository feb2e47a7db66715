// A racket tossed so that its handle goes round once: which face is up when it is caught. Its motion, from any error of the hand, is the tumble module's.
"use strict";

tumblingLive.widget("racket", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [exact] = await Promise.all([module("tumble"), load(`${from}live.solids.js`), load(`${from}live.bodies.js`)]);
    const { dot, rows, through, orbit, model, palette, paper, path, paint, clock, looks } = tumblingLive.bodies;
    const [play, back, handle, across] = ["play", "back", "handle", "through"].map((id) => stage.querySelector(`#racket-${id}`));
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const canvas = (what) => stage.querySelector(`[data-draws=${what}]`);
    const say = sayer(stage);
    const [RACKET, SPIN, SLOW] = [3, 10, 3]; // which body; rad/s about x, the middle axis; times slower than life
    const [, , , ...centre] = exact.answer(7, RACKET);
    const told = exact.answer(6, RACKET);
    const solid = model(told, RACKET, centre);
    solid.model = solid.model.filter((part) => !part.pin);
    // The two faces: the strings' ends, in their order round the hoop.
    const ends = [...new Set(solid.lines.flat())].map((i) => Array.from(solid.places.slice(3 * i, 3 * i + 3)));
    const middle = ends.reduce((sum, p) => sum.map((x, i) => x + p[i] / ends.length), [0, 0, 0]);
    const hoop = ends.sort((a, b) => Math.atan2(a[2] - middle[2], a[0] - middle[0]) - Math.atan2(b[2] - middle[2], b[0] - middle[0]));

    const state = { t: 0, last: 0, twist: 0, turn: -28, tilt: 40 };
    const colours = palette(stage, () => pictures.forEach((it) => it.draw()));
    // In the hand the handle, z, lies toward the reader and the strings face up: x to the right, y down.
    const FACING = [[1, 0, 0], [0, -1, 0], [0, 0, -1]];
    const attitude = (t) => rows(exact.answer(1, t).slice(3, 7));
    const drawn = (what, time) => paper(canvas(what), (width) => Math.round(Math.min(1.05 * width, 230)), (pen, width, height, paper) => {
        const seen = through(orbit(FACING, state.turn, state.tilt), attitude(time()));
        const scale = Math.min(width, height) / 2 - 8;
        const up = seen[2][1] < 0; // whether the face that was up in the hand is turned to the reader
        path(pen, hoop.map((p) => [width / 2 + scale * dot(seen[0], p), height / 2 - scale * dot(seen[1], p)]), true);
        pen.globalAlpha = 0.85;
        pen.fillStyle = up ? colours["axis-mid"] : colours.plain[20];
        pen.fill();
        pen.globalAlpha = 1;
        paint(pen, colours, solid, seen, [width / 2, height / 2], scale);
        paper.shows = { up, seen, t: time(), turn: state.turn, tilt: state.tilt }; // for those who test it
    });
    const pictures = [drawn("start", () => 0), drawn("flight", () => state.t), drawn("end", () => state.last)];

    /** How far round the handle points, seen along the axis of the toss, rad. */
    const points = (t) => {
        const [, [, , y], [, , z]] = attitude(t);
        return Math.atan2(-y, z);
    };
    /** When the handle has gone round once, s. */
    function caught() {
        const way = (from, to) => (to - from) - 2 * Math.PI * Math.round((to - from) / (2 * Math.PI));
        let [low, round, each] = [0, 0, 0.02];
        for (;;) {
            const next = way(points(low), points(low + each));
            if (round + next >= 2 * Math.PI) break;
            [round, low] = [round + next, low + each];
        }
        let high = low + each;
        for (let i = 0; i < 40; i += 1) {
            const mid = (low + high) / 2;
            const more = way(points(low), points(mid));
            if (round + more >= 2 * Math.PI) high = mid;
            else [round, low] = [round + more, mid];
        }
        return high;
    }
    const percent = (share) => `${Number((100 * share).toPrecision(2))} %`;
    /** Shows the instant; returns it in words. */
    function go(t) {
        state.t = Math.min(t, state.last);
        pictures[1].draw();
        return state.t < state.last;
    }
    function begin() {
        const about = Number((10 ** handle.value).toPrecision(2));
        const share = Number(across.value) / 100;
        exact.answer(0, RACKET, 0, 0, 3, 0, 0, 0, SPIN, SPIN * share, SPIN * about);
        state.last = caught();
        const [, [, y]] = attitude(state.last);
        state.twist = Math.acos(Math.max(-1, Math.min(1, y))) * 180 / Math.PI;
        state.t = 0;
        shown("handle").textContent = percent(about);
        shown("through").textContent = percent(share).replace("-", "−");
        shown("words").textContent = `Caught after one turn of the handle, it is twisted by ${fixed(state.twist, 0)}°: the ${state.twist > 90 ? "other" : "same"} face is up.`;
        for (const slider of [handle, across]) slider.setAttribute("aria-valuetext", `${shown(slider === handle ? "handle" : "through").textContent}: twisted by ${fixed(state.twist, 0)}°`);
        for (const it of pictures) it.draw();
        return shown("words").textContent;
    }
    const { pause } = clock(stage, play, {
        step: 0.3, start: "Toss",
        go(seconds) {
            // Caught, it is tossed anew after a moment.
            if (go(state.t + seconds / SLOW)) return true;
            state.rest = (state.rest ?? 0) + seconds;
            if (state.rest > 1) [state.rest, state.t] = [0, 0];
            return true;
        },
        pressed: () => say(shown("words").textContent),
    });
    back.addEventListener("click", () => {
        pause();
        go(0);
        say(shown("words").textContent);
    });
    // Between two errors of the hand it flies on: only the toss begins anew.
    for (const slider of [handle, across]) slider.addEventListener("input", () => say(begin()));
    for (const what of ["start", "flight", "end"]) looks(canvas(what), state, () => pictures.forEach((it) => it.draw()));
    begin();
});
