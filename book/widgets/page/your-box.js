// Your box: edges, mass and spin in; moments, momentum and gap out, or the library's own words on why not.
"use strict";

tumblingLive.widget("your-box", async (stage, from) => {
    const { load, module, fixed, short, draw, arrow, drawing, sayer } = tumblingLive;
    const [box, motion] = await Promise.all([...["your-body", "tumble"].map(module), load(`${from}live.bodies.js`)]);
    const { rows, clock } = tumblingLive.bodies;
    const [play, back] = ["play", "back"].map((id) => stage.querySelector(`#your-box-${id}`));
    const svg = stage.querySelector("svg");
    const fields = ["a", "b", "c", "m", "x", "y", "z"].map((id) => stage.querySelector(`#your-box-${id}`));
    const wrong = stage.querySelector(".live-wrong");
    const numbers = stage.querySelector("dl");
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    let found = null;
    let last = null; // the last box that was right, and its answer
    const RISE = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let [time, turned, rate] = [0, RISE, null]; // since it was let go; the box's axes in the room, as rows; its spin along them

    // The eye: at first it looks nearly along z, so that angles between x and y are seen as they are. Dragged, it goes round.
    let [turn, tilt] = [-0.18, 0.2];
    /** To the right, up, and toward the eye, in the box's own axes. */
    const eye = () => {
        const [c, s, low, high] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
        return [[c, s, 0], [-s * low, c * low, high], [s * high, -c * high, low]];
    };
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const inRoom = (place) => turned.map((row) => dot(row, place));
    const seen = (place) => {
        const [right, up] = eye();
        return [dot(right, place), -dot(up, place)];
    };
    let [middle, reach] = [[0, 0], 1]; // of the drawing, px; and how long its arrows are

    const redraw = drawing(svg, (width) => Math.round(Math.min(0.72 * width, 360)), (width, height) => {
        if (!last) return;
        const { values, found } = last;
        const largest = Math.max(...values.slice(0, 3));
        const half = values.slice(0, 3).map((edge) => edge / largest);
        const scale = 0.3 * height;
        const at = (place) => seen(place).map((far, i) => [width, height][i] / 2 + scale * far);
        const corner = (bits) => inRoom(half.map((far, i) => (bits >> i & 1 ? far : -far)));
        // The three edges of the corner that lies farthest from the eye are hidden.
        const toEye = [0, 1, 2].map((i) => dot(turned.map((row) => row[i]), eye()[2]));
        const farthest = toEye.reduce((bits, leads, i) => bits | (leads < 0) << i, 0);
        for (let from = 0; from < 8; from += 1) {
            for (const bit of [1, 2, 4]) {
                if (from & bit) continue;
                const hidden = [from, from | bit].includes(farthest);
                const ends = [from, from | bit].map((bits) => at(corner(bits)).join(" "));
                draw("path", svg, { class: hidden ? "live-edge live-hidden" : "live-edge", d: `M${ends.join("L")}` });
            }
        }
        ["x", "y", "z"].forEach((name, i) => {
            const [near, far] = [half[i], half[i] + 0.28].map((x) => at(inRoom([0, 1, 2].map((j) => (j === i ? x : 0)))));
            draw("path", svg, { class: "live-axis", d: `M${near.join(" ")}L${far.join(" ")}` });
            draw("text", svg, { x: far[0], y: far[1] + 5, "text-anchor": "middle" }, name);
        });
        const length = (vector) => Math.hypot(...vector);
        // A momentum too small for any number has no arrow. The spin grows and shrinks with its size since it was let go.
        const along = (vector, whole = length(vector)) => at(vector.map((x) => (whole > 0 ? 1.5 * (x / whole) : 0)));
        const [spin, momentum] = [time > 0 ? inRoom(rate) : values.slice(4), Array.from(found.slice(3, 6))];
        const centre = [width / 2, height / 2];
        [middle, reach] = [centre, 1.5 * scale];
        const tip = arrow(svg, centre, along(momentum), "live-momentum", 6);
        const end = arrow(svg, centre, along(spin, length(values.slice(4))), "live-omega", 3.5);
        // The spin's name on from its tip; the momentum's beside its own, on the side where the spin is not.
        const toward = ([x, y]) => {
            const [right, down] = [x - centre[0], y - centre[1]];
            const far = Math.hypot(right, down);
            return far > 1 ? [right / far, down / far] : [1, 0];
        };
        const [[ox, oy], [mx, my]] = [toward(end), toward(tip)];
        const side = my * (end[0] - tip[0]) - mx * (end[1] - tip[1]) > 0 ? -1 : 1;
        draw("text", svg, { class: "live-omega", x: end[0] + 15 * ox, y: Math.max(14, end[1] + 15 * oy + 5), "text-anchor": "middle" }, "ω");
        draw("text", svg, { class: "live-momentum", x: tip[0] + side * 20 * my - 6 * mx, y: tip[1] - side * 20 * mx - 6 * my + 6, "text-anchor": "middle" }, "L");
        svg.shows = { time, spin, momentum }; // for those who test it
        if (length(spin) > 0 && time === 0) {
            draw("circle", svg, { class: "live-arc live-omega live-ring", cx: end[0], cy: end[1], r: 7 });
            draw("circle", svg, { class: "live-handle", cx: end[0], cy: end[1], r: 16 });
        }
    });

    // The blue arrow is dragged over the ball of its length, toward the eye as far as it was; anything else turns the box.
    let held = null;
    svg.addEventListener("pointerdown", (event) => {
        event.preventDefault();
        svg.setPointerCapture(event.pointerId);
        const spin = fields.slice(4).map((field) => Number(field.value));
        held = { arrow: event.target.classList.contains("live-handle"), side: dot(eye()[2], spin) < 0 ? -1 : 1, size: Math.hypot(...spin), x: event.clientX, y: event.clientY };
    });
    svg.addEventListener("pointermove", (event) => {
        if (!held) return;
        if (held.arrow) {
            const box = svg.getBoundingClientRect();
            let [x, y] = [(event.clientX - box.left - middle[0]) / reach, (middle[1] - event.clientY + box.top) / reach];
            const far = Math.max(1, Math.hypot(x, y));
            [x, y] = [x / far, y / far];
            const near = held.side * Math.sqrt(Math.max(0, 1 - x * x - y * y));
            const [right, up, toward] = eye();
            [4, 5, 6].forEach((field, i) => {
                fields[field].value = Number((held.size * (x * right[i] + y * up[i] + near * toward[i])).toPrecision(3));
            });
            say(show());
            return;
        }
        turn -= 0.01 * (event.clientX - held.x);
        tilt = Math.max(-1.5, Math.min(1.5, tilt + 0.01 * (event.clientY - held.y)));
        [held.x, held.y] = [event.clientX, event.clientY];
        redraw();
    });
    for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => { held = null; });

    /** Moves the box to an instant after it was let go; returns that in words. */
    function go(t) {
        const now = last && motion.answer(4, ...last.found.slice(0, 3), ...last.values.slice(4), t, 0);
        if (!now) return "";
        [time, rate, turned] = [t, Array.from(now.slice(0, 3)), t > 0 ? rows(now.slice(3)) : RISE];
        const text = `${fixed(box.answer(4, ...last.values.slice(0, 4), ...rate)?.[6] ?? 0, 1)}°`;
        if (shown("gap").textContent !== text) shown("gap").textContent = text;
        redraw();
        return `After ${fixed(t, 1)} s the gap is ${text}. The momentum stands where it stood.`;
    }

    /** Shows what the module answers now; returns it in words. */
    function show() {
        pause();
        [time, turned] = [0, RISE];
        found = box.answer(4, ...fields.map((field) => (field.value === "" ? NaN : Number(field.value))));
        if (found) last = { values: fields.map((field) => Number(field.value)), found };
        wrong.hidden = found !== null;
        svg.classList.toggle("live-dim", !found);
        numbers.style.visibility = found ? "" : "hidden";
        const empty = fields.find((field) => field.value === "");
        wrong.textContent = found ? "" : empty ? `Type a number for ${empty.getAttribute("aria-label")}.` : `${box.words()}.`;
        if (wrong.textContent && last) wrong.textContent += " The drawing is of the last box that was right.";
        const put = (what, text) => { shown(what).textContent = found ? text() : ""; };
        const three = (from) => Array.from(found.slice(from, from + 3), short).join(", ");
        put("moments", () => three(0));
        put("momentum", () => three(3));
        put("gap", () => `${fixed(found[6], 1)}°`);
        put("circled", () => {
            const moments = found.slice(0, 3);
            const [fate] = motion.answer(8, ...moments, ...fields.slice(4).map((field) => Number(field.value))) ?? [];
            if (fate === undefined) return "its motion leaves what an f64 holds";
            const named = (axis) => {
                const which = ["smallest", "middle", "largest"][moments.filter((moment) => moment < moments[axis]).length];
                return `the axis ${["x", "y", "z"][axis]}, of the ${which} moment`;
            };
            if (fate < 3) return `the spin circles ${named(fate)}, for ever`;
            if (fate === 3) return "the spin runs along the edge between two ways of moving";
            if (fate === 4) return "two moments are equal: the spin circles the third axis evenly";
            if (fate === 5) return "the three moments are equal: any spin stays as it is";
            if (fate === 6) return "two moments are equal, and the spin stays as it is";
            if (fate < 10) return `the spin stays on ${named(fate - 7)}; a slight slip makes it wobble, no more`;
            return `the spin stands on ${named(fate - 10)}: the least slip makes it flip`;
        });
        redraw();
        return found ? `Moments ${three(0)}. Momentum ${three(3)}. Gap ${fixed(found[6], 1)}°.` : ""; // what is wrong is said by itself
    }
    const { pause } = clock(stage, play, { step: 0.3, start: "Let go", go: (seconds) => Boolean(go(time + seconds)), pressed: () => say(go(time)) });
    back.addEventListener("click", () => say(show()));
    for (const field of fields) field.addEventListener("input", () => say(show()));
    show();
});
