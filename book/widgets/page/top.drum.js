// What the top is made of, and the lines on the sphere around its point.
"use strict";

/** A drum on a pin, the pin's end at 1; two quarters of the drum in another colour, so that it is seen to turn. */
tumblingLive.drum = ([radius, low, high]) => {
    const end = 1.9 * high;
    const [places, model] = [[], []];
    const round = (size, at, AROUND) => Array.from({ length: AROUND }, (_, i) =>
        places.push([size * Math.cos(2 * Math.PI * i / AROUND), size * Math.sin(2 * Math.PI * i / AROUND), at].map((x) => x / end)) - 1);
    function cylinder(size, from, to, quarters) {
        const AROUND = quarters ? 24 : 8;
        const [below, above] = [from, to].map((at) => round(size, at, AROUND));
        const [under, over] = [from, to].map((at) => places.push([0, 0, at / end]) - 1);
        const kind = (i) => (quarters && Math.floor(4 * i / AROUND) % 2 === 1 ? "front" : "plain");
        const faces = [];
        for (let i = 0; i < AROUND; i += 1) {
            const next = (i + 1) % AROUND;
            const middle = 2 * Math.PI * (i + 0.5) / AROUND;
            faces.push({ at: [below[i], below[next], above[next], above[i]], normal: [Math.cos(middle), Math.sin(middle), 0], kind: kind(i), smooth: true });
        }
        // The ends, a quarter at once: each face takes its own stroke.
        for (let from = 0; from < AROUND; from += AROUND / 4) {
            const rim = (ring) => Array.from({ length: AROUND / 4 + 1 }, (_, i) => ring[(from + i) % AROUND]);
            faces.push({ at: [over, ...rim(above)], normal: [0, 0, 1], kind: kind(from), smooth: true });
            faces.push({ at: [under, ...rim(below)], normal: [0, 0, -1], kind: kind(from), smooth: true });
        }
        model.push({ faces, middle: places.push([0, 0, 0.5 * (from + to) / end]) - 1 });
    }
    cylinder(0.025 * end, 0, low, false);
    cylinder(radius, low, high, true);
    cylinder(0.025 * end, high, 0.97 * end, false);
    return { model, lines: [], places: Float64Array.from(places.flat()) };
};

/** A line over a ball of `scale` px about `[cx, cy]`, or for `lean` the circle on it at that angle from upright: what of it is on the reader's side, and what is behind. */
tumblingLive.overSphere = ([[a, b, c], [d, e, f], [u, v, w]], [cx, cy], scale, points, lean) => {
    const [front, behind] = [new Path2D(), new Path2D()];
    const size = lean === null ? 1 : Math.sin(lean);
    let was = null;
    let goes = null; // what the last piece is in
    for (let i = 0, fromX = 0, fromY = 0; i < points.length; i += 1) {
        const p = points[i];
        const x = size * p[0];
        const y = size * p[1];
        const z = lean === null ? p[2] : Math.cos(lean);
        const is = u * x + v * y + w * z >= 0;
        const toX = cx + scale * (a * x + b * y + c * z);
        const toY = cy - scale * (d * x + e * y + f * z);
        const line = was === null ? null : is || was ? front : behind;
        if (line && line !== goes) line.moveTo(fromX, fromY);
        line?.lineTo(toX, toY);
        was = is;
        goes = line;
        fromX = toX;
        fromY = toY;
    }
    return { front, behind };
};
