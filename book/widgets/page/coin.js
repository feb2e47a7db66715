// A plate that wobbles: the cone of its spin in the body rolls on that in the room. Where it is, the tumble's module says.
"use strict";

tumblingLive.widget("coin", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [exact] = await Promise.all([module("tumble"), load(`${from}live.bodies.js`)]);
    const { dot, cross, unit, rows, upright, orbit, palette, paper, path, arrow, clock, looks } = tumblingLive.bodies;
    const canvas = stage.querySelector("canvas");
    const [play, back, body, tilt] = ["play", "back", "body", "tilt"].map((id) => stage.querySelector(`#coin-${id}`));
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    /** The moments across and along the axis, in parts of a unit; its radius, half its length and how far down its middle is, as drawn. */
    const BODIES = { plate: { across: 1, along: 2, wide: 0.72, high: 0.04, low: 0.68 }, stick: { across: 1, along: 0.25, wide: 0.16, high: 0.8, low: 0.53 } };
    const SPIN = 4; // rad/s along the axis
    const state = { t: 0, turn: 30, tilt: 24, omega: null, up: [0, 0, 1], now: null };
    const colours = palette(stage, () => picture.draw());
    /** A circle about an axis, at this angle from it, its radius and height for a line of length 1. */
    const circle = (axis, first, angle, far = 1, many = 48) => {
        const other = cross(axis, first);
        return Array.from({ length: many }, (_, i) => {
            const [c, s] = [Math.cos((2 * Math.PI * i) / many), Math.sin((2 * Math.PI * i) / many)];
            return axis.map((x, k) => far * (Math.cos(angle) * x + Math.sin(angle) * (c * first[k] + s * other[k])));
        });
    };
    const picture = paper(canvas, (width) => Math.round(Math.min(0.8 * width, 340)), (pen, width, height) => {
        if (!state.now) return;
        const eye = orbit(upright(state.up), state.turn, state.tilt);
        const scale = 0.46 * height;
        const on = (p) => [width / 2 + scale * dot(eye[0], p), BODIES[body.value].low * height - scale * dot(eye[1], p)];
        const [x, y, z] = rows(state.now.slice(3, 7));
        const column = (k) => [x[k], y[k], z[k]];
        const [one, , axis] = [0, 1, 2].map(column);
        const spin = unit([x, y, z].map((row) => dot(row, state.now.slice(0, 3))));
        const { wide, high } = BODIES[body.value];
        const cone = (about, first, colour) => {
            const angle = Math.acos(Math.min(1, dot(about, spin)));
            const rim = circle(about, first, angle, 0.95);
            path(pen, rim.map(on), true);
            pen.fillStyle = pen.strokeStyle = colour;
            pen.globalAlpha = 0.16;
            pen.fill();
            pen.globalAlpha = 0.9;
            pen.lineWidth = 1.6;
            pen.stroke();
            pen.lineWidth = 0.8;
            for (let k = 0; k < 48; k += 4) {
                path(pen, [on([0, 0, 0]), on(rim[k])]);
                pen.stroke();
            }
            pen.globalAlpha = 1;
            return angle;
        };
        const solid = () => {
            const ends = [1, -1].map((sign) => circle(axis, one, Math.PI / 2, wide).map((p) => p.map((part, k) => part + sign * high * axis[k])));
            const near = dot(axis, eye[2]) > 0 ? 0 : 1;
            // The side: what lies between the two rims, all of it behind the nearer end.
            pen.fillStyle = colours.plain[16];
            pen.strokeStyle = colours.edge;
            pen.lineWidth = 0.8;
            for (let i = 0; i < 48; i += 1) {
                const next = (i + 1) % 48;
                if (dot(ends[0][i].map((part, k) => part - high * axis[k]), eye[2]) < -0.02) continue;
                path(pen, [ends[0][i], ends[0][next], ends[1][next], ends[1][i]].map(on), true);
                pen.fill();
            }
            path(pen, ends[near].map(on), true);
            pen.fillStyle = near === 0 ? colours.plain[28] : colours.plain[22];
            pen.fill();
            pen.stroke();
            // The medallion: on the upper end, off the middle, so that turns are seen.
            const off = (far, side) => axis.map((part, k) => high * part * (near === 0 ? 1 : -1) + far * wide * one[k] + side * wide * cross(axis, one)[k]);
            pen.fillStyle = colours["axis-max"];
            path(pen, [off(0.9, 0), off(0.25, 0.3), off(0.4, 0), off(0.25, -0.3)].map(on), true);
            pen.fill();
        };
        const [across] = upright(state.up);
        if (dot(axis, eye[2]) < 0) [state.fixed, state.rolling] = [cone(state.up, across, colours.momentum), cone(axis, one, colours["axis-mid"])];
        solid();
        if (dot(axis, eye[2]) >= 0) [state.fixed, state.rolling] = [cone(state.up, across, colours.momentum), cone(axis, one, colours["axis-mid"])];
        arrow(pen, on([0, 0, 0]), on(state.up.map((part) => 1.08 * part)), colours.momentum, 4);
        arrow(pen, on([0, 0, 0]), on(spin), colours.omega, 3);
        canvas.shows = { axis, spin, up: state.up, fixed: state.fixed, rolling: state.rolling, turn: state.turn, tilt: state.tilt }; // for those who test it
    });
    /** Shows the instant; returns it in words. */
    function go(t) {
        const { across, along } = BODIES[body.value];
        state.t = t;
        state.now = Array.from(exact.answer(4, across, across, along, ...state.omega, t, 0));
        const says = { turns: fixed(SPIN * t / (2 * Math.PI), 1), wobbles: fixed(state.rate * t / (2 * Math.PI), 1), ratio: t > 0 ? fixed(state.rate / SPIN, 2) : "?" }; // a question stands above
        for (const [what, text] of Object.entries(says)) if (shown(what).textContent !== text) shown(what).textContent = text;
        picture.draw();
        return `${says.turns} turns, ${says.wobbles} wobbles.`;
    }
    /** The momentum stands so many degrees off the axis. */
    function begin() {
        const { across, along } = BODIES[body.value];
        const angle = (Number(tilt.value) * Math.PI) / 180;
        state.omega = [along * SPIN * Math.tan(angle) / across, 0, SPIN];
        const momentum = [across * state.omega[0], 0, along * SPIN];
        [state.up, state.rate] = [unit(momentum), Math.hypot(...momentum) / across];
        shown("tilt").textContent = `${tilt.value}°`;
        tilt.setAttribute("aria-valuetext", shown("tilt").textContent);
        return `Tilted by ${shown("tilt").textContent}. ${go(0)}`;
    }
    const { pause } = clock(stage, play, { step: 0.1, go: (seconds) => Boolean(go(state.t + seconds)), pressed: () => say(go(state.t)) });
    back.addEventListener("click", () => {
        pause();
        say(go(0));
    });
    for (const control of [body, tilt]) control.addEventListener("input", () => say(begin()));
    looks(canvas, state, picture.draw);
    begin();
});
