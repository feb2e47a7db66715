// The first screen: a book in the air, in slow motion, tossed about one of its three axes. Where it is, the tumble's module says.
"use strict";

tumblingLive.widget("toss", async (stage) => {
    const { module, sayer } = tumblingLive;
    const exact = await module("tumble");
    const canvas = stage.querySelector("canvas");
    const pen = canvas.getContext("2d");
    const play = stage.querySelector("#toss-play");
    const choices = [...stage.querySelectorAll("[data-toss]")];
    const words = stage.querySelector("[data-shows=words]");
    const say = sayer(stage);

    const [BOOK, SPIN, SLIP, SLOW] = [1, 10, 0.04, 0.25]; // which body; rad/s; how far a hand misses the axis, of the spin; of life's pace
    const [, ...moments] = exact.answer(0, BOOK, SPIN, SLIP, 0).slice(0, 4);
    const [, , low, , high, wide, thick] = exact.answer(6, BOOK);

    // The body's axes: x across the covers, y through them, z along the spine. In the hand the front cover faces the reader.
    const TOSSES = {
        across: {
            spin: [SPIN, SLIP * SPIN, 0], eye: [[1, 0, 0], [0, 0, 1], [0, -1, 0]], above: 14,
            words: "About the middle axis the spin is not steady: every few turns the book flips over, though nothing touches it.",
        },
        spine: {
            spin: [0, SLIP * SPIN, SPIN], eye: [[0, 0, 1], [-1, 0, 0], [0, -1, 0]], above: 14,
            words: "About the axis of least resistance the spin is steady.",
        },
        through: {
            spin: [SLIP * SPIN, SPIN, 0], eye: [[1, 0, 0], [0, 0, 1], [0, -1, 0]], above: 48,
            words: "About the axis of greatest resistance it is steady, too.",
        },
    };

    // ---- The book: two boards, a spine and the pages between them. Each is a box, from one corner to the opposite.
    const board = 0.13 * thick;
    const [x, y, z] = [wide / 2, thick / 2, (high - low) / 2];
    const boxes = {
        back: { from: [-x + board, y - board, -z], to: [x, y, z], colour: "cloth" },
        pages: { from: [-x + board, -y + board, -0.97 * z], to: [0.96 * x, y - board, 0.97 * z], colour: "paper" },
        front: { from: [-x + board, -y, -z], to: [x, -y + board, z], colour: "cloth" },
        spine: { from: [-x, -y, -z], to: [-x + board, y, z], colour: "cloth" },
    };
    const reach = Math.hypot(x, y, z);

    const state = { toss: TOSSES.across, t: 0, turn: -24, tilt: 0, playing: false };
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const radians = (degrees) => (degrees * Math.PI) / 180;
    /** The eye's right, up and toward, from those of the hand: `turn` around the upright, then `tilt` above. */
    function eye([right, up, toward], turn, tilt) {
        const mix = (a, b, angle) => a.map((v, i) => Math.cos(angle) * v + Math.sin(angle) * b[i]);
        const [across, near] = [mix(right, toward, -radians(turn)), mix(toward, right, radians(turn))];
        return [across, mix(up, near, -radians(tilt)), mix(near, up, radians(tilt))];
    }
    const LIGHT = [-0.42, 0.62, 0.66];
    let colours = {};
    function dye() {
        const style = getComputedStyle(stage);
        for (const name of ["cloth", "paper", "gilt"]) colours[name] = style.getPropertyValue(`--book-${name}`).trim();
        colours.edge = style.color;
    }

    function draw() {
        const [width, height] = [canvas.clientWidth, canvas.clientHeight];
        if (width === 0) return;
        const dots = Math.min(devicePixelRatio || 1, 2);
        if (canvas.width !== Math.round(width * dots)) [canvas.width, canvas.height] = [Math.round(width * dots), Math.round(height * dots)];
        const { spin, eye: hand, above } = state.toss;
        const [, , , w, i, j, k] = exact.answer(4, ...moments, ...spin, state.t, 0);
        // Body axes in the hand's at the start, as columns; then to the eye's.
        const turned = [
            [1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j)],
            [2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i)],
            [2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j)],
        ];
        const seen = eye(hand, state.turn, above + state.tilt).map((axis) => [0, 1, 2].map((n) => axis[0] * turned[0][n] + axis[1] * turned[1][n] + axis[2] * turned[2][n]));
        const [right, up, toward] = seen;
        const scale = (0.47 * Math.min(width, height)) / reach;
        const onto = (place) => [width / 2 + scale * dot(right, place), height / 2 - scale * dot(up, place)];

        pen.setTransform(dots, 0, 0, dots, 0, 0);
        pen.clearRect(0, 0, width, height);
        pen.lineJoin = "round";
        // What a plane parts from the rest is drawn before it or after it, by the side on which the eye is.
        const layers = ["back", "pages", "front"];
        if (toward[1] > 0) layers.reverse();
        if (toward[0] > 0) layers.unshift("spine");
        else layers.push("spine");
        for (const name of layers) {
            const { from, to, colour } = boxes[name];
            for (const axis of [0, 1, 2]) {
                const sign = toward[axis] > 0 ? 1 : -1;
                const [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
                const corner = (far, wide) => {
                    const place = [0, 0, 0];
                    place[axis] = sign > 0 ? to[axis] : from[axis];
                    place[a] = far ? to[a] : from[a];
                    place[b] = wide ? to[b] : from[b];
                    return place;
                };
                const light = sign * (LIGHT[0] * right[axis] + LIGHT[1] * up[axis] + LIGHT[2] * toward[axis]);
                const face = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)].map(onto);
                pen.beginPath();
                face.forEach(([u, v], n) => (n === 0 ? pen.moveTo(u, v) : pen.lineTo(u, v)));
                pen.closePath();
                pen.fillStyle = colours[colour];
                pen.fill();
                pen.fillStyle = light > 0 ? `rgb(255 255 255 / ${0.22 * light})` : `rgb(0 0 0 / ${-0.4 * light})`;
                pen.fill();
                pen.strokeStyle = colours.edge;
                pen.lineWidth = 0.6;
                pen.stroke();
                if (name === "pages" && axis !== 1) leaves(pen, onto, axis, sign, from, to);
            }
        }
        // The front cover's frame and title, and the spine's, as they lie on the book: upright along `top`, and read from outside, where
        // the way across is the cross product of the way up and the way out. `unit`, the covers' width, is 1 in what is painted.
        const unit = 2 * x;
        const titles = [];
        const print = (place, out, top, paint) => {
            if (dot(toward, out) <= 0) return;
            const across = [0, 1, 2].map((n) => unit * (top[(n + 1) % 3] * out[(n + 2) % 3] - top[(n + 2) % 3] * out[(n + 1) % 3]));
            const [at, far, below] = [place, place.map((v, n) => v + across[n]), place.map((v, n) => v - unit * top[n])].map(onto);
            titles.push([[far[0] - at[0], far[1] - at[1]], [below[0] - at[0], below[1] - at[1]]]);
            pen.setTransform(dots * (far[0] - at[0]), dots * (far[1] - at[1]), dots * (below[0] - at[0]), dots * (below[1] - at[1]), dots * at[0], dots * at[1]);
            pen.fillStyle = pen.strokeStyle = colours.gilt;
            pen.textAlign = "center";
            pen.textBaseline = "middle";
            paint();
        };
        print([0, -y, 0], [0, -1, 0], [0, 0, 1], () => {
            pen.lineWidth = 0.012;
            pen.strokeRect(-0.37, -0.66, 0.78, 1.32);
            pen.font = "600 0.125px Literata, serif";
            pen.fillText("TUMBLING", 0.02, -0.36, 0.66);
            pen.beginPath();
            pen.ellipse(0.02, 0.14, 0.24, 0.16, 0, 0, 2 * Math.PI);
            pen.moveTo(0.02 - 0.24, 0.3);
            pen.quadraticCurveTo(0.02, 0.1, 0.26, -0.02);
            pen.stroke();
        });
        // The spine's title stands upright where the book lies on its back, and so runs from top to bottom.
        print([-x, 0, 0], [-1, 0, 0], [0, -1, 0], () => {
            pen.font = "600 0.075px Literata, serif";
            pen.fillText("TUMBLING", 0, 0.004);
        });
        pen.setTransform(dots, 0, 0, dots, 0, 0);
        canvas.shows = { t: state.t, turned, layers, titles }; // for a test that reads the drawing back
    }
    /** Lines that leaves show at their edges. */
    function leaves(pen, onto, axis, sign, from, to) {
        pen.strokeStyle = "rgb(0 0 0 / 0.16)";
        pen.beginPath();
        for (let n = 1; n < 6; n += 1) {
            const deep = from[1] + ((to[1] - from[1]) * n) / 6;
            for (const end of [from, to]) {
                const place = [...end];
                place[1] = deep;
                place[axis] = sign > 0 ? to[axis] : from[axis];
                const [u, v] = onto(place);
                if (end === from) pen.moveTo(u, v);
                else pen.lineTo(u, v);
            }
        }
        pen.stroke();
    }

    // ---- Time: it runs while the book is in view, unless it is paused or less motion is preferred.
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    let [wanted, inView, pending, last] = [!still.matches, false, 0, null];
    function frame(now) {
        if (last !== null) state.t += (SLOW * Math.min(now - last, 100)) / 1000; // what a hidden page missed is not made up for
        last = now;
        draw();
        pending = requestAnimationFrame(frame);
    }
    function settle() {
        const runs = wanted && inView;
        if (runs === state.playing) return;
        state.playing = runs;
        last = null;
        if (runs) pending = requestAnimationFrame(frame);
        else cancelAnimationFrame(pending);
    }
    function name() {
        play.textContent = wanted ? "Pause" : "Play";
    }
    play.addEventListener("click", () => {
        wanted = !wanted;
        name();
        settle();
    });
    still.addEventListener("change", () => {
        wanted = !still.matches;
        name();
        settle();
    });
    new IntersectionObserver(([{ isIntersecting }]) => {
        inView = isIntersecting;
        settle();
    }).observe(canvas);

    function toss(which) {
        for (const button of choices) button.setAttribute("aria-pressed", String(button.dataset.toss === which));
        state.toss = TOSSES[which];
        state.t = 0;
        words.textContent = state.toss.words;
        draw();
    }
    for (const button of choices) {
        button.addEventListener("click", () => {
            toss(button.dataset.toss);
            say(state.toss.words);
        });
    }

    // Dragged, the reader goes round: half a degree for each pixel, by finger as by mouse.
    let held = null;
    canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        held = [event.clientX, event.clientY];
    });
    canvas.addEventListener("pointermove", (event) => {
        if (!held) return;
        state.turn -= 0.5 * (event.clientX - held[0]);
        state.tilt = Math.max(-80 - state.toss.above, Math.min(80 - state.toss.above, state.tilt + 0.5 * (event.clientY - held[1])));
        held = [event.clientX, event.clientY];
        if (!state.playing) draw();
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = null; });

    const recolour = () => {
        dye();
        draw();
    };
    new MutationObserver(recolour).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
    new ResizeObserver(draw).observe(canvas);
    dye();
    name();
    toss("across");
});
