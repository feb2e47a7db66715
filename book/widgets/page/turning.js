// Body and world: the box turns, and beside it stands its tensor as the world sees it. Both are the tumble module's.
"use strict";

tumblingLive.widget("turning", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [exact] = await Promise.all([module("tumble"), load(`${from}live.solids.js`), load(`${from}live.bodies.js`)]);
    const { rows, through, upright, orbit, model, palette, paper, path, paint, clock, looks } = tumblingLive.bodies;
    const [play, motion, scrub] = ["play", "motion", "scrub"].map((id) => stage.querySelector(`#turning-${id}`));
    const canvas = stage.querySelector("canvas");
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    const [x, y, z, ...centre] = exact.answer(7, 0); // the box's moments, and its centre of mass
    const solid = model(exact.answer(6, 0), 0, centre);
    shown("body").replaceChildren(...[x, 0, 0, 0, y, 0, 0, 0, z].map((entry) => {
        const place = document.createElement("span");
        place.textContent = entry === 0 ? "0" : fixed(entry, 3);
        return place;
    }));

    // About z it turns by a radian a second, so that time tells the angle; else it tumbles, from a spin off its axes.
    const MOTIONS = {
        about: { spin: [0, 0, 1], to: 2 * Math.PI, most: 360, pace: 1, says: (part) => `${fixed(360 * part, 0)}°` },
        free: { spin: [1, 1, 0.4], to: 20, most: 2000, pace: 2, says: (part) => `${fixed(20 * part, 2)} s` },
    };
    const state = { t: 0, turn: 24, tilt: 22, attitude: [1, 0, 0, 0] };
    const colours = palette(stage, () => picture.draw());
    const picture = paper(canvas, (width) => Math.round(Math.min(0.85 * width, 280)), (pen, width, height) => {
        const eye = orbit(upright([0, 0, 1]), state.turn, state.tilt);
        const seen = through(eye, rows(state.attitude));
        const [cx, cy] = [width / 2, height / 2];
        const scale = Math.max(Math.min(width, height) / 2 - 26, 1);
        const lines = (axes, far, names, inks, wide) => [0, 1, 2].forEach((k) => {
            const [u, v] = [axes[0][k] * scale * far, -axes[1][k] * scale * far];
            pen.strokeStyle = pen.fillStyle = inks[k];
            pen.lineWidth = wide;
            path(pen, [[cx, cy], [cx + u, cy + v]]);
            pen.stroke();
            if (!names) return;
            pen.font = colours.font;
            pen.textAlign = "center";
            pen.fillText(names[k], cx + 1.1 * u, cy + 1.1 * v + 5);
        });
        lines(eye, 1.08, ["x", "y", "z"], Array(3).fill(colours.faint), 1.2);
        const body = paint(pen, colours, { ...solid, model: solid.model.filter((part) => !part.pin) }, seen, [cx, cy], 0.86 * scale);
        lines(seen, 0.8, null, [colours["axis-mid"], colours["axis-max"], colours["axis-min"]], 3);
        canvas.shows = { body, turn: state.turn, tilt: state.tilt }; // for those who test it
    });

    /** Shows the instant, in the picture and in numbers; returns it in words. */
    function show() {
        const { says, to } = MOTIONS[motion.value];
        const now = exact.answer(1, state.t);
        const tensor = exact.answer(10, state.t);
        state.attitude = now.slice(3, 7);
        for (const place of stage.querySelectorAll("[data-at]")) {
            const text = fixed(tensor[place.dataset.at], 3);
            place.textContent = text === "−0.000" ? "0.000" : text;
        }
        shown("far").textContent = says(state.t / to);
        scrub.setAttribute("aria-valuetext", shown("far").textContent);
        picture.draw();
        const [xx, yy, zz, xy, xz, yz] = Array.from(tensor.slice(0, 6), (entry) => fixed(entry, 3));
        return `At ${shown("far").textContent} the moments in the world are ${xx}, ${yy} and ${zz}, the products xy ${xy}, xz ${xz}, yz ${yz} kg m².`;
    }
    function at(t) {
        state.t = t;
        scrub.value = scrub.max * t / MOTIONS[motion.value].to;
        return show();
    }
    function begin() {
        const { spin, most } = MOTIONS[motion.value];
        scrub.max = most;
        exact.answer(0, 0, 0, 0, 3, 0, 0, 0, ...spin);
        return at(0);
    }
    const { pause } = clock(stage, play, {
        step: 0.2,
        go(seconds) {
            const { to, pace } = MOTIONS[motion.value];
            at((state.t + pace * seconds) % to);
            return true;
        },
        pressed: () => say(show()),
    });
    scrub.addEventListener("input", () => {
        pause();
        state.t = MOTIONS[motion.value].to * scrub.value / scrub.max;
        say(show());
    });
    motion.addEventListener("input", () => {
        pause();
        say(begin());
    });
    looks(canvas, state, picture.draw);
    begin();
});
