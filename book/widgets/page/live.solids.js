// Bodies as solids of flat faces, from the parts that the tumble's module gives: see tumble/src/parts.rs.
"use strict";

/**
 * Of a body, in m: its parts, each with its corners, its faces (corners counter-clockwise from outside, perhaps with a hole, and a
 * kind, which is a colour) and its mass; its strings, each with both ends and its mass; and where a line along x through
 * `centre` leaves it.
 */
tumblingLive.solids = (told, which, centre) => {
    const [SIZE, SIDES] = [8, 32]; // numbers for a part, as in parts.rs; sides of what is round
    const parts = [];
    const strings = [];

    /** A bar; one that lies along z has its side toward positive x painted, others are painted whole on that side. */
    function bar(x, z, toX, toZ, wide, thick, mass) {
        const long = Math.hypot(toX - x, toZ - z);
        const [ux, uz] = [(toX - x) / long, (toZ - z) / long];
        const corners = Array.from({ length: 8 }, (_, bits) => {
            const [far, deep, along] = [0, 1, 2].map((bit) => (bits >> bit & 1 ? 0.5 : -0.5));
            return [(x + toX) / 2 + far * wide * uz + along * long * ux, deep * thick, (z + toZ) / 2 - far * wide * ux + along * long * uz];
        });
        const cover = which === 1 || which === 2 ? "front" : "plain"; // of the book, of the phone
        const kinds = x === toX ? { right: "mark", back: cover } : { all: x + toX > 0 ? "mark" : "plain" };
        const sides = { right: [1, 3, 7, 5], left: [0, 4, 6, 2], back: [2, 6, 7, 3], fore: [0, 1, 5, 4], top: [4, 5, 7, 6], low: [0, 2, 3, 1] };
        const faces = Object.entries(sides).map(([side, at]) => ({ at, kind: kinds.all ?? kinds[side] ?? "plain" }));
        parts.push({ corners, faces, mass });
    }

    /** A tube along x, of flat sides; as much stays within the true round as without it. */
    function tube(x, toX, inner, outer, mass) {
        const angle = (2 * Math.PI) / SIDES;
        const fair = Math.sqrt(angle / Math.sin(angle)); // a polygon of the circle's area
        const ring = (x, radius) => Array.from({ length: SIDES }, (_, i) =>
            [x, fair * radius * Math.cos(i * angle), fair * radius * Math.sin(i * angle)]);
        const corners = [ring(x, outer), ring(toX, outer), ring(x, inner), ring(toX, inner)].flat();
        const [low, high, lowIn, highIn] = [0, 1, 2, 3].map((k) => Array.from({ length: SIDES }, (_, i) => k * SIDES + i));
        const next = (list, i) => list[(i + 1) % SIDES];
        // The hole's wall first: whatever else is seen stands before it.
        const wall = lowIn.map((from, i) => ({ at: [from, highIn[i], next(highIn, i), next(lowIn, i)], kind: "hole", smooth: true }));
        const round = low.map((from, i) => ({ at: [from, next(low, i), next(high, i), high[i]], kind: "plain", smooth: true }));
        const caps = [{ at: high, hole: highIn, kind: "mark" }, { at: [...low].reverse(), hole: [...lowIn].reverse(), kind: "plain" }];
        parts.push({ corners, faces: [...wall, ...round, ...caps], mass });
    }

    /** A round bar, of flat sides, as heavy as it would be round; one along z has its side toward positive x painted. */
    function rod(x, z, toX, toZ, radius, mass) {
        const long = Math.hypot(toX - x, toZ - z);
        const [ux, uz] = [(toX - x) / long, (toZ - z) / long];
        const angle = (2 * Math.PI) / SIDES;
        const fair = Math.sqrt(angle / Math.sin(angle));
        const ring = (atX, atZ) => Array.from({ length: SIDES }, (_, i) => {
            const [far, deep] = [fair * radius * Math.cos(i * angle), fair * radius * Math.sin(i * angle)];
            return [atX + far * uz, deep, atZ - far * ux];
        });
        const corners = [ring(x, z), ring(toX, toZ)].flat();
        const kind = (i) => (x !== toX || Math.cos((i + 0.5) * angle) > 0 ? "mark" : "plain");
        const faces = Array.from({ length: SIDES }, (_, i) => {
            const next = (i + 1) % SIDES;
            return { at: [i, next, SIDES + next, SIDES + i], kind: kind(i), smooth: true };
        });
        const [low, high] = [0, 1].map((k) => Array.from({ length: SIDES }, (_, i) => k * SIDES + i));
        faces.push({ at: low.reverse(), kind: x === toX ? "plain" : "mark" }, { at: high, kind: x === toX ? "plain" : "mark" });
        parts.push({ corners, faces, mass });
    }

    /** A ball, of flat faces, with its side toward positive x painted. */
    function ball(radius, mass) {
        const [ROUND, HIGH] = [24, 12];
        const fair = 1.012 * radius; // as much stays within the true ball as without it
        const corners = [];
        for (let k = 0; k <= HIGH; k += 1) {
            const [z, wide] = [Math.cos((k * Math.PI) / HIGH), Math.sin((k * Math.PI) / HIGH)];
            for (let i = 0; i < ROUND; i += 1) {
                const turn = (i * 2 * Math.PI) / ROUND;
                corners.push([fair * wide * Math.sin(turn), fair * wide * Math.cos(turn), fair * z]);
            }
        }
        const faces = [];
        for (let k = 0; k < HIGH; k += 1) {
            for (let i = 0; i < ROUND; i += 1) {
                const next = (i + 1) % ROUND;
                const at = [ROUND * k + i, ROUND * k + next, ROUND * (k + 1) + next, ROUND * (k + 1) + i];
                if (k === 0) at.splice(1, 1);
                if (k === HIGH - 1) at.pop();
                faces.push({ at, kind: i < ROUND / 2 ? "mark" : "plain", smooth: true });
            }
        }
        parts.push({ corners, faces, mass });
    }

    for (let from = 0; from < told.length; from += SIZE) {
        const [kind, a, b, c, d, wide, thick, mass] = told.slice(from, from + SIZE);
        if (kind === 2) ball(a, mass);
        else if (kind === 3) rod(a, b, c, d, wide, mass);
        else if (kind === 1) tube(a, b, c, d, mass);
        else if (wide === 0) strings.push({ ends: [[a, 0, b], [c, 0, d]], mass });
        else bar(a, b, c, d, wide, thick, mass);
    }

    const minus = (a, b) => a.map((x, i) => x - b[i]);
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    /** Across a face, outward; of any length. */
    const across = ({ at }, corners) => {
        const [a, b, c] = at.map((i) => corners[i]);
        const [p, q] = [minus(b, a), minus(c, b)];
        return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    };
    let leaves = -Infinity;
    for (const { corners, faces } of parts) {
        let [enter, leave] = [-Infinity, Infinity];
        for (const face of faces) {
            if (face.kind === "hole") continue;
            const normal = across(face, corners);
            const room = dot(normal, minus(corners[face.at[0]], centre));
            if (normal[0] > 0) leave = Math.min(leave, room / normal[0]);
            else if (normal[0] < 0) enter = Math.max(enter, room / normal[0]);
            else if (room < 0) leave = -Infinity;
        }
        if (enter < leave) leaves = Math.max(leaves, centre[0] + leave);
    }
    return { parts, strings, leaves, across };
};
