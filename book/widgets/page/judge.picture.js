// The picture of a verdict: the spin as recorded over the exact one, and below it the errors, a power of ten a step.
"use strict";

tumblingLive.judgePicture = (() => {
    const { raised, short, draw, drawing } = tumblingLive;
    /** What is smaller lies on the lower edge. */
    const FLOOR = -16;
    /** Spins are drawn up to so many times the exact motion's greatest. */
    const ROOM = 2.5;
    /** Around the plots: figures of the axes to the left, names of the curves to the right. */
    const [LEFT, RIGHT, LINE] = [46, 80, 18];
    const LAWS = [
        { key: "energy", name: "energy", ink: "live-ink" },
        { key: "momentum", name: "|L|", ink: "live-ink-momentum" },
        { key: "direction", name: "direction", ink: "live-ink-momentum live-dashed" },
    ];

    const clamp = (x, least, most) => Math.min(Math.max(x, least), most);
    const finite = (x) => typeof x === "number" && Number.isFinite(x);
    const largest = (...rows) => rows.flat().reduce((most, x) => (finite(x) ? Math.max(most, Math.abs(x)) : most), 0);
    const decade = (power) => (power === 0 ? "1" : power === 1 ? "10" : `10${raised(power)}`);
    const times = (count) => (count === 1 ? "once" : `${count} times`);

    /** Steps of one, two or five times a power of ten, so many about, with what they are called; and the power of ten left out. */
    function ticks(from, to, count) {
        const size = Math.floor(Math.log10(Math.max(Math.abs(from), Math.abs(to))));
        const power = size > 3 || size < -2 ? size : 0;
        const rough = (to - from) / count;
        const unit = 10 ** Math.floor(Math.log10(rough));
        const step = unit * ([1, 2, 5].find((times) => times * unit >= rough) ?? 10);
        const digits = clamp(power - Math.floor(Math.log10(step) + 1e-9), 0, 12);
        const all = [];
        for (let i = Math.ceil(from / step); i * step <= to * (1 + 1e-12) && all.length < 20; i += 1) {
            all.push([i * step, i === 0 ? "0" : (i * step / 10 ** power).toFixed(digits).replace("-", "−")]);
        }
        return { all, unit: power === 0 ? "" : `${decade(power)} ` };
    }

    /** What is in the picture, apart from any size. */
    function content(verdict) {
        const { curve, flips, moments, torque } = verdict;
        const axis = [0, 1, 2].reduce((a, b) => (Math.abs(curve.exact[b][0]) > Math.abs(curve.exact[a][0]) ? b : a), 0);
        const order = [0, 1, 2].sort((a, b) => moments[a] - moments[b]);
        const row = (name) => curve[name][axis];
        const exact = largest(row("exact_least"), row("exact_greatest"));
        const found = largest(row("spin_least"), row("spin_greatest"));
        const lost = ["spin_least", "spin_greatest"].some((name) => row(name).some((x) => !finite(x)));
        // Where a torque acts the exact motion of a free body is no measure.
        const free = torque === null;
        const laws = free ? LAWS.flatMap((law) => {
            const told = verdict.laws.find(({ law: key }) => key === law.key);
            return told && curve[law.key] ? [{ ...law, told, errors: curve[law.key] }] : [];
        }) : [];
        const most = 1.12 * (free && exact > 0 ? Math.max(exact, Math.min(found, ROOM * exact)) : found);
        const middle = flips !== null && order[1] === axis;
        const end = Math.max(verdict.duration, curve.time.at(-1));
        return {
            axis, row, exact, found, lost, free, laws, middle, flips,
            end: finite(end) && end > 0 ? end : 1,
            most: finite(most) && most > 0 ? most : 1,
            time: curve.time,
            many: verdict.rows > 1.5 * curve.time.length,
            leaves: free && (lost || (exact > 0 && found > ROOM * exact)),
        };
    }

    /** The limits that have a place in the picture, and of which laws each is. */
    function limits(laws) {
        const all = new Map();
        for (const { told, name } of laws) {
            if (finite(told.allowed) && told.allowed >= 10 ** FLOOR) all.set(told.allowed, [...(all.get(told.allowed) ?? []), name]);
        }
        return [...all].map(([most, names]) => ({ most, name: all.size > 1 ? `${names[0]} may` : "allowed" }));
    }

    /** Names beside the ends of their curves, moved apart where they would lie on each other. */
    function beside(svg, names, x, top, bottom) {
        const sorted = names.toSorted((a, b) => a.y - b.y);
        let next = top;
        for (const name of sorted) {
            name.at = Math.max(name.y, next);
            next = name.at + 16;
        }
        let most = bottom;
        for (const name of sorted.toReversed()) {
            name.at = Math.min(name.at, most);
            most = name.at - 16;
        }
        for (const { name, ink, y, at } of sorted) {
            draw("path", svg, { class: `live-curve live-thin ${ink}`, d: `M${x + 2} ${y.toFixed(1)}L${x + 9} ${at.toFixed(1)}` });
            draw("text", svg, { class: ink.split(" ")[0], x: x + 12, y: (at + 4.5).toFixed(1) }, name);
        }
    }

    /** A line through points, broken where there is none. */
    function line(svg, points, ink, shows) {
        let pen = "M";
        const d = points.map((point) => {
            if (!point) {
                pen = "M";
                return "";
            }
            const part = `${pen}${point[0].toFixed(1)} ${point[1].toFixed(1)}`;
            pen = "L";
            return part;
        }).join("");
        draw("path", svg, { class: `live-curve ${ink}`, d: d || "M0 0", "data-shows": shows });
    }

    /** The axes of a plot. */
    function frame(svg, x, y, left, right, upper, lower, names) {
        for (const [value, name] of y.all) {
            draw("path", svg, { class: "live-grid", d: `M${left} ${y.at(value).toFixed(1)}H${right}` });
            draw("text", svg, { x: left - 6, y: (y.at(value) + 4.5).toFixed(1), "text-anchor": "end" }, name);
        }
        for (const [value, name] of x.all) {
            draw("path", svg, { class: "live-grid", d: `M${x.at(value).toFixed(1)} ${upper}V${lower}` });
            if (names) draw("text", svg, { x: x.at(value).toFixed(1), y: lower + 16, "text-anchor": "middle" }, name);
        }
        draw("path", svg, { class: "live-frame", d: `M${left} ${upper}H${right}V${lower}H${left}z` });
    }

    function spins(svg, of, x, right, upper, lower) {
        const scale = (value) => (upper + lower) / 2 - (clamp(value, -of.most, of.most) / of.most) * (lower - upper) / 2;
        const { all, unit } = ticks(-of.most, of.most, (lower - upper) / 34);
        const which = of.middle && right > 420 ? ", the middle one" : "";
        draw("text", svg, { class: "live-strong", x: 0, y: upper - 12 }, `spin about axis ${of.axis + 1}${which}, ${unit}rad/s`);
        frame(svg, x, { all, at: scale }, LEFT, right, upper, lower, false);
        const at = (row) => of.row(row).map((value, i) => (finite(value) ? [x.at(of.time[i]), scale(value)] : null));
        const band = (least, greatest, ink) => {
            const [low, high] = [at(least), at(greatest)];
            const ends = high.concat(low.toReversed()).filter(Boolean).map((point) => point.map((x) => x.toFixed(1)).join(" "));
            if (ends.length > 0) draw("path", svg, { class: `live-band ${ink}`, d: `M${ends.join("L")}z` });
        };
        // Where a point stands for many rows, what they reach shows as a band.
        if (of.many && of.free) band("exact_least", "exact_greatest", "live-ink");
        if (of.many) band("spin_least", "spin_greatest", "live-ink-omega");
        const names = [];
        const curve = (row, name, ink) => {
            const points = at(row);
            line(svg, points, ink, name);
            const last = points.findLast(Boolean);
            if (last) names.push({ name, ink: ink.split(" ")[0], y: last[1] });
        };
        if (of.free) curve("exact", "exact", "live-ink live-wide-pen");
        curve("spin", "recorded", "live-ink-omega");
        beside(svg, names, right, upper + 6, lower - 6);

        let y = lower + LINE;
        const remark = (text, ink) => {
            draw("text", svg, { class: ink, x: LEFT, y }, text);
            y += LINE;
        };
        if (of.middle && of.free) {
            const places = of.flips.times.filter((t) => t <= of.end);
            const marked = places.length * 7 <= right - LEFT;
            for (const t of marked ? places : []) draw("circle", svg, { class: "live-flip", cx: x.at(t).toFixed(1), cy: scale(0), r: 4 });
            remark(`flips${marked && places.length > 0 ? " ○" : ""}: ${of.flips.found}, exact: ${of.flips.exact}`, "live-ink-middle");
        }
        const over = of.free ? of.flips?.turned_over : null;
        if (finite(over)) {
            const [cx, cy] = [x.at(over), scale(0)];
            draw("path", svg, { class: "live-curve live-ink-wrong", d: `M${cx - 5} ${cy - 5}l10 10m0 -10l-10 10`, "data-shows": "turns over" });
            remark(`turns over × at ${short(over)} s`, "live-ink-wrong");
        }
        if (of.leaves) remark(of.lost ? "leaves the picture" : `leaves the picture: ${short(of.found)} rad/s`, "live-ink-wrong");
        return y;
    }

    function errors(svg, of, x, right, upper, lower) {
        const held = limits(of.laws);
        const reach = Math.max(1e-14, largest(of.laws.map(({ told }) => told.most)), ...held.map(({ most }) => Math.min(most, 1)));
        const top = clamp(Math.ceil(Math.log10(reach) - 1e-9), -12, 300);
        const scale = (size) => {
            const power = size === null ? top : clamp(Math.log10(Math.abs(size)), FLOOR, top);
            return lower - ((power - FLOOR) / (top - FLOOR)) * (lower - upper);
        };
        const every = Math.max(1, Math.ceil((top - FLOOR) / ((lower - upper) / 22)));
        const all = [];
        for (let power = FLOOR; power <= top; power += every) all.push([10 ** power, decade(power)]);
        draw("text", svg, { class: "live-strong", x: 0, y: upper - 12 },
            of.laws.some(({ key }) => key === "direction") ? "errors: shares; direction, rad" : "errors, as shares");
        frame(svg, x, { all, at: scale }, LEFT, right, upper, lower, true);
        draw("text", svg, { x: right, y: lower + 34, "text-anchor": "end" }, `time, ${x.unit}s`);
        if (of.laws.length === 0) {
            draw("text", svg, { x: (LEFT + right) / 2, y: (upper + lower) / 2, "text-anchor": "middle" }, "no free body’s law is judged");
            return;
        }
        const names = [];
        for (const { most, name } of held.filter(({ most }) => Math.log10(most) <= top)) {
            line(svg, [[LEFT, scale(most)], [right, scale(most)]], "live-ink-wrong live-dotted", "allowed");
            names.push({ name, ink: "live-ink-wrong", y: scale(most) });
        }
        for (const { key, name, ink, errors } of of.laws) {
            const points = errors.map((size, i) => [x.at(of.time[i]), scale(size)]);
            line(svg, points, ink, key);
            names.push({ name, ink, y: points.at(-1)[1] });
        }
        beside(svg, names, right, upper + 6, lower - 6);
    }

    /** What the picture shows, for those who do not see it. */
    function told(verdict, of) {
        const ends = (row) => {
            const all = of.row(`${row}_least`).concat(of.row(`${row}_greatest`)).filter(finite);
            return all.length === 0 ? "beyond counting" : `from ${short(Math.min(...all))} to ${short(Math.max(...all))} rad/s`;
        };
        const said = [`Above, the spin about axis ${of.axis + 1}${of.middle ? ", the middle one," : ""} in ${short(of.end)} s: recorded, it goes ${ends("spin")}` +
            (of.free ? `; exact, ${ends("exact")}.` : ".")];
        const [last, should] = [of.row("spin").at(-1), of.row("exact").at(-1)];
        if (of.free && finite(last) && finite(should)) said.push(`Near the end it is ${short(last)}, and should be ${short(should)} rad/s.`);
        if (of.leaves) said.push("The recorded spin leaves the picture.");
        if (of.middle && of.free) said.push(`It changes sign ${times(of.flips.found)}, and should ${of.flips.exact === 0 ? "never" : `do so ${times(of.flips.exact)}`}.`);
        if (of.free && finite(of.flips?.turned_over)) said.push(`The spin that should never turn over about this axis does so at ${short(of.flips.turned_over)} s.`);
        for (const { told, name } of of.laws) {
            const most = told.most === null ? "beyond counting" : `up to ${short(told.most)}`;
            said.push(`Below, the error of ${name}: ${most}; ${told.growth}.`);
        }
        if (of.laws.length === 0) said.push("Below, nothing: no law of a free body is judged.");
        return said.join(" ");
    }

    /** Puts the picture of a verdict into the page. */
    return (parent, verdict) => {
        if (verdict.curve.time.length === 0) return;
        const of = content(verdict);
        const svg = draw("svg", parent, { class: "live-drawing live-picture", role: "img", "aria-label": told(verdict, of) });
        const remarks = [of.middle && of.free, of.free && finite(of.flips?.turned_over), of.leaves].filter(Boolean).length;
        const high = (width) => Math.round(clamp(0.28 * width, 130, 220));
        const height = (width) => 28 + high(width) + LINE * remarks + 44 + high(width) + 42;
        drawing(svg, height, (width) => {
            const right = width - RIGHT;
            const x = ticks(0, of.end, Math.max(2, (right - LEFT) / 70));
            x.at = (t) => LEFT + (t / of.end) * (right - LEFT);
            const below = spins(svg, of, x, right, 28, 28 + high(width)) - LINE;
            errors(svg, of, x, right, below + 44, below + 44 + high(width));
        });
    };
})();
