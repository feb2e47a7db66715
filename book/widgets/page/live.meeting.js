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
    const [wide, high, deep] = half.map((part) => 1 / part ** 2);
    const by = (a, b) => wide * a[0] * b[0] + high * a[1] * b[1] + deep * a[2] * b[2];
    const eyes = () => orbit([[0, 0, -1], [1, 0, 0], [0, -1, 0]], view.turn, view.tilt);
    const LIGHT = unit([-0.45, 0.75, 0.6]);
    const reach = 1.04 * Math.max(...half);
    const sheet = document.createElement("canvas");
    const ink = sheet.getContext("2d");
    const kept = { key: "", at: -Infinity, coarse: false, later: 0 };

    /** The ellipsoid alone, from where it was last seen: its picture, how near each point is to the reader, and the shades of the sphere over it. */
    function ellipsoid(eye, dots) {
        const key = [view.turn, view.tilt, dots, colours.bg, colours.momentum].join();
        if (kept.seen === key) return kept.ellipsoid;
        const [near, image] = [new Float32Array(dots * dots).fill(-Infinity), new ImageData(dots, dots)];
        // Whole pixels in the machine's own order of bytes, so that no point of a hundred thousand makes a list.
        const pixels = new Uint32Array(image.data.buffer);
        const triple = (colour) => colour.match(/[\d.]+/g).map(Number);
        const warm = triple(colours.momentum);
        const whole = (colour) => new Uint32Array(Uint8ClampedArray.from([...colour, 255]).buffer)[0];
        const [grey, warmed] = [0, 0.5].map((part) => Uint32Array.from(colours.plain, (shade) => whole(triple(shade).map((x, k) => x + part * (warm[k] - x)))));
        const [A, uu, uv, vv, ut, vt] = [by(eye[2], eye[2]), by(eye[0], eye[0]), by(eye[0], eye[1]), by(eye[1], eye[1]), by(eye[0], eye[2]), by(eye[1], eye[2])];
        for (let row = 0; row < dots; row += 1) {
            const v = reach * (1 - (2 * row + 1) / dots);
            for (let column = 0; column < dots; column += 1) {
                const u = reach * ((2 * column + 1) / dots - 1);
                const b = u * ut + v * vt;
                const inside = b * b - A * (u * u * uu + 2 * u * v * uv + v * v * vv - 1);
                if (!(inside > 0)) continue;
                const z = (Math.sqrt(inside) - b) / A;
                // What points outward, to the right, up and toward the reader.
                const [x, y, out] = [u * uu + v * uv + z * ut, u * uv + v * vv + z * vt, u * ut + v * vt + z * A];
                near[row * dots + column] = z;
                pixels[row * dots + column] = grey[Math.round(16 + 16 * (LIGHT[0] * x + LIGHT[1] * y + LIGHT[2] * out) / Math.sqrt(x * x + y * y + out * out))];
            }
        }
        // At each dot: the square of the least length at which a sphere is nearer than the ellipsoid.
        const hidden = near.map((z, dot) => {
            const [u, v] = [2 * (dot % dots) + 1, 2 * Math.floor(dot / dots) + 1].map((place) => reach * (place / dots - 1));
            return u * u + v * v + Math.max(z, 0) ** 2;
        });
        Object.assign(kept, { seen: key, ellipsoid: { hidden, image, pixels, bare: pixels.slice(), warmed } });
        return kept.ellipsoid;
    }
    /**
     * Both surfaces: the nearer one is seen. Painted anew only if they or the view have changed; coarsely while they go on changing, and
     * finely once they rest.
     */
    function surfaces(length, eye, fine) {
        const key = [length, view.turn, view.tilt, fine, colours.bg, colours.momentum].join();
        const soon = performance.now() - kept.at < 200;
        if (key === kept.key && (soon || !kept.coarse)) return;
        const dots = soon ? Math.round(fine / (devicePixelRatio > 1 ? 4 : 3)) : fine;
        Object.assign(kept, { key, at: performance.now(), coarse: soon });
        if (soon) kept.later ||= setTimeout(finely, 250); // one for all the changes of a slider that moves
        if (sheet.width !== dots) [sheet.width, sheet.height] = [dots, dots];
        const { hidden, image, pixels, bare, warmed } = ellipsoid(eye, dots);
        pixels.set(bare);
        const [right, up, toward] = LIGHT.map((part) => 16 * part / length);
        const square = length * length;
        const side = (part) => Math.max(0, Math.min(dots, Math.round(0.5 * dots * (1 + part / reach)))); // the dot at a height, or at a place across
        for (let row = side(-length); row < side(length); row += 1) {
            const v = reach * (1 - (2 * row + 1) / dots);
            const wide = Math.sqrt(Math.max(0, square - v * v));
            const shade = 16.5 + up * v; // half more: cut off, it is rounded
            for (let column = side(-wide), end = side(wide); column < end; column += 1) {
                const dot = row * dots + column;
                if (square <= hidden[dot]) continue;
                const u = reach * ((2 * column + 1) / dots - 1);
                pixels[dot] = warmed[(shade + right * u + toward * Math.sqrt(Math.max(0, wide * wide - u * u))) | 0];
            }
        }
        ink.putImageData(image, 0, 0);
    }
    function finely() {
        const left = kept.at + 250 - performance.now();
        kept.later = left > 0 ? setTimeout(finely, left) : 0;
        if (!kept.later) picture.draw();
    }

    const picture = paper(canvas, (width) => Math.round(Math.min(0.9 * width, 330)), (pen, width, height) => {
        const { at, now, curve } = get();
        if (!now) return;
        const eye = eyes();
        const side = Math.min(width, height);
        const scale = side / 2 / reach;
        const on = (p) => [width / 2 + scale * dot(eye[0], p), height / 2 - scale * dot(eye[1], p)];
        const outward = [wide * eye[2][0], high * eye[2][1], deep * eye[2][2]];
        const faces = (p) => dot(p, outward) > 0;
        surfaces(Math.hypot(...at), eye, Math.round(side * Math.min(devicePixelRatio || 1, 2)));
        pen.drawImage(sheet, (width - side) / 2, (height - side) / 2, side, side);
        pen.lineWidth = 2.6;
        // The curve and its mirror image through the middle, which is in front where the curve is behind.
        const [behind, before] = [new Path2D(), new Path2D()];
        let [[x, y], was] = [on(curve.at(-1)), null];
        for (const p of curve) {
            const front = faces(p);
            const [line, image] = front ? [before, behind] : [behind, before];
            if (front !== was) {
                line.moveTo(x, y);
                image.moveTo(width - x, height - y);
            }
            [x, y] = on(p);
            line.lineTo(x, y);
            image.lineTo(width - x, height - y);
            was = front;
        }
        pen.strokeStyle = colours.omega;
        for (const [line, alpha] of [[behind, 0.22], [before, 1]]) {
            pen.globalAlpha = alpha;
            pen.stroke(line);
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
                // So far to the side that a small loop about the dot, and the point on it, leave it free; where a large loop passes, its halo does.
                const aside = x > 0.6 * width ? -1 : x < 0.4 * width ? 1 : 0;
                const place = [x + 24 * aside, y + (aside ? 0 : y > height / 2 ? 13 : -13)];
                tumblingLive.word(pen, colours.stamps, name, colours.font, colours.fg, place, aside, colours.bg);
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
