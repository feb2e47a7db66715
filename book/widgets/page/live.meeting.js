// In the body the momentum lies on two surfaces: the sphere of its length and the ellipsoid of its energy. Drawn with the curve where they
// meet, and with the point, which can be dragged over the ellipsoid.
"use strict";

/**
 * `half` are the ellipsoid's half axes, `names` what each is called, and its colour. `get()` is what is shown: the momentum `at` its start and `now`, and the `curve`. A dragged point is
 * `moved(to)`, in the same numbers; then it is `ended()`.
 */
tumblingLive.meeting = (canvas, colours, half, names, { get, moved, ended }) => {
    const { dot, unit, orbit, paper, looks } = tumblingLive.bodies;
    const view = { turn: 38, tilt: 24 };
    const by = (a, b) => a.reduce((sum, x, k) => sum + x * b[k] / half[k] ** 2, 0);
    const eyes = () => orbit([[0, 0, -1], [1, 0, 0], [0, -1, 0]], view.turn, view.tilt);
    const LIGHT = unit([-0.45, 0.75, 0.6]);
    const sheet = document.createElement("canvas");
    const kept = { key: "", at: -Infinity, coarse: false, later: 0 };

    /**
     * Both surfaces, point by point: the nearer one is seen. Painted anew only if they or the view have changed; coarsely while they go on
     * changing, and finely once they rest.
     */
    function surfaces(length, eye, fine) {
        const key = [length, view.turn, view.tilt, fine, colours.bg, colours.momentum].join();
        const soon = performance.now() - kept.at < 200;
        if (key === kept.key && (soon || !kept.coarse)) return;
        const dots = soon ? Math.round(fine / 2) : fine;
        clearTimeout(kept.later);
        Object.assign(kept, { key, at: performance.now(), coarse: soon, later: soon ? setTimeout(() => picture.draw(), 250) : 0 });
        [sheet.width, sheet.height] = [dots, dots];
        const pen = sheet.getContext("2d");
        const image = pen.createImageData(dots, dots);
        const triple = (colour) => colour.match(/[\d.]+/g).map(Number);
        // Whole pixels in the machine's own order of bytes, so that no point of a hundred thousand makes a list.
        const pixels = new Uint32Array(image.data.buffer);
        const warm = triple(colours.momentum);
        const whole = (colour) => new Uint32Array(Uint8ClampedArray.from([...colour, 255]).buffer)[0];
        const [grey, warmed] = [0, 0.5].map((part) => colours.plain.map((shade) => whole(triple(shade).map((x, k) => x + part * (warm[k] - x)))));
        const [A, uu, uv, vv, ut, vt] = [by(eye[2], eye[2]), by(eye[0], eye[0]), by(eye[0], eye[1]), by(eye[1], eye[1]), by(eye[0], eye[2]), by(eye[1], eye[2])];
        const reach = 1.04 * Math.max(...half);
        for (let row = 0; row < dots; row += 1) {
            const v = reach * (1 - (2 * row + 1) / dots);
            for (let column = 0; column < dots; column += 1) {
                const u = reach * ((2 * column + 1) / dots - 1);
                const b = u * ut + v * vt;
                const inside = b * b - A * (u * u * uu + 2 * u * v * uv + v * v * vv - 1);
                const round = length * length - u * u - v * v;
                const [deep, near] = [inside > 0 ? (Math.sqrt(inside) - b) / A : -Infinity, round > 0 ? Math.sqrt(round) : -Infinity];
                const z = Math.max(deep, near);
                if (z === -Infinity) continue;
                // What points outward, to the right, up and toward the reader.
                const sphere = near > deep;
                const [right, up, toward] = sphere ? [u, v, z] : [u * uu + v * uv + z * ut, u * uv + v * vv + z * vt, u * ut + v * vt + z * A];
                const lit = 0.5 + 0.5 * (LIGHT[0] * right + LIGHT[1] * up + LIGHT[2] * toward) / Math.sqrt(right * right + up * up + toward * toward);
                pixels[row * dots + column] = (sphere ? warmed : grey)[Math.round(32 * Math.max(0, Math.min(1, lit)))];
            }
        }
        pen.putImageData(image, 0, 0);
    }

    const picture = paper(canvas, (width) => Math.round(Math.min(0.9 * width, 330)), (pen, width, height) => {
        const { at, now, curve } = get();
        if (!now) return;
        const eye = eyes();
        const side = Math.min(width, height);
        const scale = side / 2 / (1.04 * Math.max(...half));
        const on = (p) => [width / 2 + scale * dot(eye[0], p), height / 2 - scale * dot(eye[1], p)];
        const faces = (p) => by(p, eye[2]) > 0;
        surfaces(Math.hypot(...at), eye, Math.round(side * Math.min(devicePixelRatio || 1, 2)));
        pen.drawImage(sheet, (width - side) / 2, (height - side) / 2, side, side);
        pen.lineWidth = 2.6;
        for (const front of [false, true]) {
            pen.strokeStyle = colours.omega;
            pen.globalAlpha = front ? 1 : 0.22;
            for (const sign of [1, -1]) {
                pen.beginPath();
                curve.forEach((p, i) => {
                    const [one, other] = [curve.at(i - 1), p].map((q) => q.map((x) => sign * x));
                    if (faces(other) !== front) return;
                    pen.moveTo(...on(one));
                    pen.lineTo(...on(other));
                });
                pen.stroke();
            }
        }
        names.forEach(([name, colour], k) => {
            for (const sign of [1, -1]) {
                const end = [0, 1, 2].map((i) => (i === k ? sign * half[k] : 0));
                const [x, y] = on(end.map((part) => 1.06 * part));
                pen.globalAlpha = faces(end) ? 1 : 0.25;
                pen.fillStyle = colours[colour];
                pen.beginPath();
                pen.arc(...on(end), 4, 0, 2 * Math.PI);
                pen.fill();
                if (!faces(end)) continue;
                pen.fillStyle = colours.fg;
                pen.font = colours.font;
                pen.textAlign = x > 0.6 * width ? "right" : x < 0.4 * width ? "left" : "center";
                pen.fillText(name, x, y + (y > height / 2 ? 18 : -8));
            }
        });
        pen.globalAlpha = faces(now) ? 1 : 0.4;
        pen.fillStyle = colours.omega;
        pen.strokeStyle = colours.bg;
        pen.beginPath();
        pen.arc(...on(now), 8, 0, 2 * Math.PI);
        pen.fill();
        pen.stroke();
        pen.globalAlpha = 1;
        canvas.shows = { spot: on(now), now, curve, length: Math.hypot(...at), scale, ...view };
    });

    /** The place of the ellipsoid that is seen there, or that of its rim that is nearest to it. */
    function under([x, y]) {
        const { scale } = canvas.shows;
        const eye = eyes();
        let flat = [0, 1, 2].map((k) => ((x - canvas.clientWidth / 2) * eye[0][k] - (y - canvas.clientHeight / 2) * eye[1][k]) / scale);
        const A = by(eye[2], eye[2]);
        const far = by(flat, flat) - by(flat, eye[2]) ** 2 / A;
        if (far > 0.999) flat = flat.map((part) => part * Math.sqrt(0.999 / far));
        const b = by(flat, eye[2]);
        const deep = (Math.sqrt(b * b - A * (by(flat, flat) - 1)) - b) / A;
        return flat.map((part, k) => part + deep * eye[2][k]);
    }
    looks(canvas, view, picture.draw, {
        takes: ([x, y]) => Math.hypot(x - canvas.shows.spot[0], y - canvas.shows.spot[1]) < 26,
        moved: (place) => moved(under(place)),
        ended,
    });
    return picture;
};
