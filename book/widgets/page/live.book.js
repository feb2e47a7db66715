// A book in the air: its covers, dark in front and pale behind, its title, which is read from one side alone, and a pin in its middle axis.
"use strict";

/** The book that has these parts, as the tumble's module gives them, in the colours of a stage. */
tumblingLive.book = (stage, [, , low, , high, wide, thick]) => {
    /** The tosses: the axis as the module counts it, and how the reader stands. x is across the covers, y through them, z along the spine; in the hand the front cover faces the reader. */
    const tosses = {
        across: { about: 0, eye: [[1, 0, 0], [0, 0, 1], [0, -1, 0]], above: 14 },
        spine: { about: 1, eye: [[0, 0, 1], [-1, 0, 0], [0, -1, 0]], above: 14 },
        through: { about: 2, eye: [[1, 0, 0], [0, 0, 1], [0, -1, 0]], above: 48 },
    };

    // ---- The book: two boards, a spine and the pages between them. Each is a box, from one corner to the opposite.
    const board = 0.13 * thick;
    const [x, y, z] = [wide / 2, thick / 2, (high - low) / 2];
    const boxes = {
        back: { from: [-x + board, y - board, -z], to: [x, y, z], colour: "back" },
        pages: { from: [-x + board, -y + board, -0.97 * z], to: [0.96 * x, y - board, 0.97 * z], colour: "paper" },
        front: { from: [-x + board, -y, -z], to: [x, -y + board, z], colour: "front" },
        spine: { from: [-x, -y, -z], to: [-x + board, y, z], colour: "front" },
    };
    const reach = Math.hypot(x, y, z);
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
        for (const name of ["front", "back", "paper", "gilt"]) colours[name] = style.getPropertyValue(`--book-${name}`).trim();
        colours.edge = style.color;
        colours.pin = style.getPropertyValue("--fig-axis-mid").trim();
    }

    // Read as they change and not at each drawing: after a text was written, that would have the page laid out anew.
    const sizes = new WeakMap();
    const note = (canvas) => sizes.set(canvas, [canvas.clientWidth, canvas.clientHeight]);
    const watch = new ResizeObserver((changed) => changed.forEach(({ target }) => note(target)));

    /** Draws it on a canvas, at this attitude of this toss, seen from `turn` around and `tilt` above. */
    function draw(canvas, { eye: hand, above }, [w, i, j, k], { turn, tilt }) {
        const pen = canvas.getContext("2d");
        if (!sizes.has(canvas)) {
            note(canvas);
            watch.observe(canvas);
        }
        const [width, height] = sizes.get(canvas);
        if (width === 0) return;
        const dots = Math.min(devicePixelRatio || 1, 2);
        // Its height may change alone: on a phone the address bar comes and goes.
        const size = [width, height].map((side) => Math.round(side * dots));
        if (String(size) !== String([canvas.width, canvas.height])) [canvas.width, canvas.height] = size;
        // Body axes in the hand's at the start, as columns; then to the eye's.
        const turned = [
            [1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j)],
            [2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i)],
            [2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j)],
        ];
        const seen = eye(hand, -turn, above + tilt).map((axis) => [0, 1, 2].map((n) => axis[0] * turned[0][n] + axis[1] * turned[1][n] + axis[2] * turned[2][n]));
        const [right, up, toward] = seen;
        const scale = (0.46 * Math.min(width, height)) / reach;
        const onto = (place) => [width / 2 + scale * dot(right, place), height / 2 - scale * dot(up, place)];

        pen.setTransform(dots, 0, 0, dots, 0, 0);
        pen.clearRect(0, 0, width, height);
        pen.lineJoin = "round";
        // What a plane parts from the rest is drawn before it or after it, by the side on which the eye is.
        const layers = ["back", "pages", "front"];
        const pin = () => {
            const [root, end] = [[x, 0, 0], [x + 0.6 * (reach - x), 0, 0]].map(onto);
            pen.strokeStyle = pen.fillStyle = colours.pin;
            pen.lineWidth = 4;
            pen.beginPath();
            pen.moveTo(...root);
            pen.lineTo(...end);
            pen.stroke();
            pen.beginPath();
            pen.arc(...end, 0.055 * scale * reach, 0, 2 * Math.PI);
            pen.fill();
        };
        if (toward[0] <= 0) pin();
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
        if (toward[0] > 0) pin();
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
            pen.lineWidth = 0.016;
            pen.strokeRect(-0.37, -0.66, 0.78, 1.32);
            pen.font = "600 0.14px Literata, serif";
            pen.fillText("TUMBLING", 0.02, -0.36, 0.7);
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
        canvas.shows = { turned, layers, titles, turn, tilt }; // for a test that reads the drawing back
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

    dye();
    return { tosses, dye, draw };
};
