// Your body: sizes, moments or a robot's link in; axes, stability, times between flips, paths of the spin out.
"use strict";

tumblingLive.widget("your-body", async (stage, from) => {
    const { load, module, fixed, short, raised, draw, arrow, drawing, sayer } = tumblingLive;
    const [body, exact] = await Promise.all([...["your-body", "tumble"].map(module), load(`${from}live.bodies.js`), load(`${from}your-body.saves.js`), load(`${from}your-body.shapes.js`)]);
    const { dot, cross, rows, clock } = tumblingLive.bodies;
    const { typed, refused, inUnit, exactly, around, within, question, faces, laid, seen, robot, fromText, gapsDrawn } = tumblingLive.yourBodyShapes;
    const field = (id) => stage.querySelector(`#your-body-${id}`);
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    const kind = field("kind");
    const wrong = stage.querySelector(".live-wrong");
    const SIZES = ["a", "b", "c"];
    const TENSOR = ["xx", "yy", "zz", "xy", "xz", "yz"];
    /** Each kind's sizes by their names, in the order in which the module counts kinds. */
    const KINDS = {
        box: ["x", "y", "z"], ball: ["radius"], cylinder: ["radius", "height"], tube: ["radius of the hole", "radius", "height"], capsule: ["radius", "length"],
        cone: ["radius", "height"], ellipsoid: ["semi-axis x", "y", "z"], plate: ["x", "y"], disk: ["radius"], moments: [],
    };
    const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));
    let found = null; // what the module answers, by name
    let parts = []; // those added: kind, numbers as the module takes them (kg, m, kg m²), place, axis and degrees of its turn
    const PLACE = ["x", "y", "z"];
    const MOST_PARTS = 20;

    /** Sizes and mass are typed in mm and g, or with a unit; asked, and kept in the address, in m and kg. */
    const UNIT = (name) => ([...TENSOR, "degrees"].includes(name) ? null : name === "m" ? "g" : "mm");
    const fill = (name, value) => { field(name).value = value === "" ? "" : exactly(value * (UNIT(name) ? 1000 : 1)); };
    const names = (kind) => (KINDS[kind].length > 0 ? ["m", ...SIZES.slice(0, KINDS[kind].length)] : ["m", ...TENSOR]);
    const asked = (name) => [name, field(name).value.trim() === "" ? "" : String(typed(field(name).value, UNIT(name)))];
    /** What is asked now, by the fields: names and values. */
    const given = () => names(kind.value).map(asked);

    /** What is wrong with what is typed, before the module looks at it; or null. */
    function lacks(known) {
        const bad = known.find(([, value]) => value === "" || value === "NaN")?.[0];
        return bad ? refused(field(bad).value, field(bad).getAttribute("aria-label") ?? bad, UNIT(bad)) : null;
    }
    const nth = (kind) => Object.keys(KINDS).indexOf(kind);
    const settled = (part) => laid(part, (rpy) => body.answer(3, ...(body.answer(0, nth(part.kind), ...part.numbers) ?? []).slice(0, 6), ...rpy));
    const together = (parts) => body.answer(5, parts.length, ...parts.map(settled).flatMap(({ kind, numbers, at }) => [nth(kind), ...numbers, ...Array(7 - numbers.length).fill(0), ...at]));
    /** A part in words, in mm and g. */
    function named({ kind: of, numbers: [mass, ...sizes], at, turn: [axis, degrees] }) {
        const mm = (lengths) => lengths.map((x) => String(exactly(x * 1000)).replace("-", "−"));
        const size = of === "moments" ? "" : `, ${of === "box" || of === "plate" ? mm(sizes).join(" × ") : mm(sizes).map((x, k) => `${KINDS[of][k]} ${x}`).join(", ")} mm`;
        const place = parts.length > 0 || at.some((x) => x !== 0) ? `, at (${mm(at).join(", ")}) mm` : "";
        return `${of}, ${exactly(mass * 1000)} g${size}${degrees === 0 ? "" : `, turned by ${String(degrees).replace("-", "−")}° about ${PLACE[axis]}`}${place}`;
    }
    function list() {
        stage.querySelector("[data-of-parts]").hidden = parts.length === 0;
        stage.querySelector(".your-body-parts").replaceChildren(...parts.map((part, k) => {
            const [item, remove] = ["li", "button"].map((name) => document.createElement(name));
            Object.assign(remove, { type: "button", textContent: "Remove" }).setAttribute("aria-label", `Remove part ${k + 1}, ${named(part)}`);
            remove.addEventListener("click", () => {
                parts.splice(k, 1);
                shown("added").textContent = `Part ${k + 1} is removed.`;
                show();
                (stage.querySelectorAll(".your-body-parts button")[Math.min(k, parts.length - 1)] ?? field("add")).focus();
            });
            item.append(`${named(part)} `, remove);
            return item;
        }));
    }
    function add() {
        const [at, degrees] = [PLACE.map(asked), asked("degrees")];
        const part = { kind: kind.value, numbers: given().map(([, value]) => Number(value)), at: at.map(([, value]) => Number(value)), turn: [Number(field("axis").value), Number(degrees[1])] };
        const why = parts.length === MOST_PARTS ? `There is room for ${MOST_PARTS} parts.` : lacks([...given(), ...at, degrees]) ?? (together([...parts, part]) ? null : `${body.words()}.`);
        if (why === null) parts.push(part);
        shown("added").textContent = why ?? `Part ${parts.length} is added.`;
        if (why === null) show();
    }

    // ---- It tumbles, spun about axis 2: where it is, and its spin along its axes.
    const [SPIN, SLIP] = [2 * Math.PI, 0.01]; // rad/s; the slip about axis 3, as a share
    const motion = { t: 0, turned: null, spin: [0, SPIN, SLIP * SPIN], flips: [] };
    /** A direction of the body as it lies, and where it points now. */
    const inRoom = (p) => {
        if (!motion.turned) return p;
        const along = found.axes.map((axis) => dot(axis, p));
        return inBody(motion.turned.map((row) => dot(row, along)));
    };
    const axesNow = () => found.axes.map(inRoom);

    function ask() {
        const values = given();
        if (parts.length === 0) {
            const why = lacks(kind.value === "moments" && values[0][1] === "" ? values.slice(1) : values);
            if (why) return why;
            if (values[0][1] < 0) return "The mass must be above zero, or left out where it is not known.";
        }
        const answer = parts.length > 0 ? together(parts) : body.answer(0, nth(kind.value), ...values.map(([, value]) => Number(value)));
        if (!answer) return `${body.words()}.`;
        const whole = parts.length > 0 ? parts : [{ kind: kind.value, numbers: values.map(([, x]) => Number(x)), at: [0, 0, 0], turn: [0, 0] }];
        const part = (from, count) => Array.from(answer.slice(from, from + count));
        found = {
            tensor: part(0, 6), moments: part(6, 3), axes: [part(9, 3), part(12, 3), part(15, 3)], equal: answer[18], growth: answer[19],
            circles: [answer[20], answer[21]], semiaxes: part(22, 3), flips: part(25, 9), whole, single: parts.length === 0,
        };
        const even = (numbers) => {
            const own = body.answer(0, 9, ...numbers);
            return { semiaxes: Array.from(own.slice(22, 25)), leads: [9, 12, 15].map((at) => Array.from(own.slice(at, at + 3))) };
        };
        found.faces = faces(whole, found.axes, even);
        found.reach = [0, 1, 2].map((k) => [1, -1].map((side) => Math.max(...found.faces.flat().map((p) => side * p[k]))));
        return null;
    }

    // The eye goes round both pictures alike.
    const [turn, tilt] = [field("turn"), field("tilt")];
    const eye = () => {
        const [a, b] = [turn, tilt].map((slider) => (Number(slider.value) * Math.PI) / 180);
        const [c, s, low, high] = [Math.cos(a), Math.sin(a), Math.sin(b), Math.cos(b)];
        return [[c, s, 0], [-s * low, c * low, high], [s * high, -c * high, low]];
    };
    /** From principal axes to the body's. */
    const inBody = (p) => [0, 1, 2].map((i) => p.reduce((sum, x, k) => sum + x * found.axes[k][i], 0));
    const path = (svg, name, places, close = "") => draw("path", svg, { class: name, d: `M${places.map((p) => p.map((x) => x.toFixed(1)).join(" ")).join("L")}${close}` });

    /** The outline of an ellipsoid along the principal axes, or where they point now. */
    function outline(semiaxes, at, leads = found.axes) {
        const toward = leads.map((axis) => dot(axis, eye()[2]));
        const pole = unit(toward.map((x, k) => x / Math.max(semiaxes[k], 1e-6)));
        const first = unit(cross(pole, Math.abs(pole[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));
        const second = cross(pole, first);
        return Array.from({ length: 72 }, (_, k) => {
            const [c, s] = [Math.cos((k * Math.PI) / 36), Math.sin((k * Math.PI) / 36)];
            const place = first.map((x, i) => (x * c + second[i] * s) * semiaxes[i]);
            return at([0, 1, 2].map((i) => leads.reduce((sum, axis, n) => sum + place[n] * axis[i], 0)));
        });
    }

    /** An arrow along each principal axis from where it leaves what is drawn, with its number. */
    function axes(svg, at, from, leads = found.axes) {
        leads.forEach((axis, k) => {
            const lead = dot(axis, eye()[2]) < -0.05 ? -1 : 1;
            const start = from[k][lead === 1 ? 0 : 1] ?? from[k];
            const [near, far] = [start, start + 0.42].map((x) => at(axis.map((part) => lead * part * x)));
            const tip = arrow(svg, near, far, `your-body-${k + 1}`, 3);
            const [right, down] = unit([tip[0] - near[0], tip[1] - near[1], 0]);
            draw("text", svg, { class: `your-body-${k + 1} live-strong`, x: tip[0] + 12 * right, y: tip[1] + 12 * down + 5, "text-anchor": "middle" }, String(k + 1));
        });
    }

    /** Places in the middle of a drawing; `scale` is the number of pixels of a length of one. */
    const looking = (width, height, scale) => {
        const [right, up] = eye();
        return (p) => [width / 2 + scale * dot(right, p), height / 2 - scale * dot(up, p)];
    };
    const square = (width) => Math.round(Math.min(0.86 * width, 320));
    const redraws = [];
    let spot = () => {}; // puts the point to where the spin is
    const pictures = {};
    for (const svg of stage.querySelectorAll("[data-drawing]")) pictures[svg.dataset.drawing] = svg;

    redraws.push(drawing(pictures.body, square, (width, height) => {
        if (!found) return;
        const svg = pictures.body;
        const at = looking(width, height, 0.31 * Math.min(width, height));
        const flat = ([right, up]) => [width / 2 + 0.31 * Math.min(width, height) * right, height / 2 - 0.31 * Math.min(width, height) * up];
        const look = (p) => { const now = inBody(motion.turned ? motion.turned.map((row) => dot(row, p)) : p); return eye().map((side) => dot(side, now)); };
        for (const { places, mark } of seen(found.faces, look)) {
            path(svg, `live-body your-body-face${places.length === 4 && found.faces.length < 40 ? "" : " your-body-fine"}`, places.map(flat), "z");
            if (mark.length > 0) path(svg, "your-body-marked", mark.map(flat), "z");
        }
        axes(svg, at, found.reach, axesNow());
        svg.shows = { t: motion.t, spin: motion.spin, turned: motion.turned, axes: axesNow() }; // for those who test it
    }));

    redraws.push(drawing(pictures.polhodes, square, (width, height) => {
        if (!found) return;
        const svg = pictures.polhodes;
        const true_ = found.moments.map((moment) => Math.sqrt(found.moments[0] / moment));
        const reach = true_[2] > 0.3 ? true_ : [1, 0.85, 0.8]; // a needle's would be too thin to draw on
        const at = looking(width, height, 0.31 * Math.min(width, height));
        path(svg, "live-body", outline(reach, at), "z");
        const toward = found.axes.map((axis) => dot(axis, eye()[2]));
        const curve = (name, axis, sign, share) => {
            const numbers = body.answer(1, ...found.moments, axis, sign, share);
            const points = Array.from({ length: numbers.length / 3 }, (_, k) => [0, 1, 2].map((i) => (numbers[3 * k + i] / true_[i]) * reach[i]));
            const before = (p) => p.reduce((sum, x, i) => sum + (x / reach[i] ** 2) * toward[i], 0) > 0;
            let part = [];
            points.forEach((p, k) => {
                part.push(at(inBody(p)));
                if (k + 1 === points.length || before(points[k + 1]) !== before(p)) {
                    if (part.length > 1) path(svg, before(p) ? name : `${name} your-body-behind`, part);
                    part = [at(inBody(p))];
                }
            });
        };
        const ends = { 0: [0, 2], 1: [0], 2: [2], 3: [] }[found.equal];
        for (const axis of ends) {
            for (const sign of [1, -1]) for (const share of [0.22, 0.45, 0.68, 0.88]) curve(`your-body-path your-body-${axis + 1}`, axis, sign, share);
        }
        if (found.equal === 0) for (const sign of [1, -1]) curve("your-body-path your-body-edge", 0, sign, 1);
        axes(svg, at, reach);
        const point = draw("circle", svg, { class: "live-point live-omega", r: 5 });
        // The spin on its path, as paths are given: of equal energy, in parts of the longest.
        spot = () => {
            const energy = motion.spin.reduce((sum, x, k) => sum + found.moments[k] * x * x, 0);
            const [cx, cy] = at(inBody(motion.spin.map((x, k) => (x * Math.sqrt(found.moments[0] / energy) / true_[k]) * reach[k])));
            for (const [name, value] of Object.entries({ cx, cy, visibility: motion.t === 0 ? "hidden" : "visible" })) point.setAttribute(name, value);
        };
        spot();
    }));

    /** Two axes and the gap between spin and momentum from the easier to the harder. */
    const PLANES = [[0, 2], [0, 1], [1, 2]];
    const DEGREES = Array.from({ length: 91 }, (_, k) => k);
    function gaps([easy, hard]) {
        return Array.from(body.answer(2, ...found.moments, easy, hard, DEGREES.length, ...DEGREES.map((x) => Math.tan((x * Math.PI) / 360))) ?? []);
    }
    redraws.push(drawing(pictures.gap, (width) => Math.round(Math.min(0.5 * width, 224)) + 56, (width, height) => {
        if (found) gapsDrawn(pictures.gap, path, width, height, PLANES.map(gaps));
    }));
    const redraw = () => {
        for (const slider of [turn, tilt]) slider.setAttribute("aria-valuetext", `${fixed(Number(slider.value), 0)} degrees`);
        redraws.forEach((again) => again());
    };

    /** Moves the body to an instant; returns it in words. */
    function go(t) {
        const omega = [0, SPIN, SLIP * SPIN];
        const now = found && t > 0 ? exact.answer(4, ...found.moments, ...omega, t, 0) : null;
        Object.assign(motion, { t: now ? t : 0, turned: now && rows(now.slice(3)), spin: now ? Array.from(now.slice(0, 3)) : omega });
        const flips = motion.flips.filter((flip) => flip <= motion.t).length;
        const text = motion.t > 0 ? `${fixed(motion.t, 1)} s, flips: ${flips}` : "";
        if (shown("tumbles").textContent !== text) shown("tumbles").textContent = text;
        redraws[0]();
        if (found) spot();
        return `After ${text}.`;
    }

    // Dragged, the view goes round; the sliders do the same for a keyboard.
    for (const svg of [pictures.body, pictures.polhodes]) {
        let held = null;
        svg.addEventListener("pointerdown", (event) => {
            event.preventDefault();
            svg.setPointerCapture(event.pointerId);
            held = [event.clientX, event.clientY];
        });
        svg.addEventListener("pointermove", (event) => {
            if (!held) return;
            turn.value = ((Number(turn.value) - 0.6 * (event.clientX - held[0]) + 540) % 360) - 180;
            tilt.value = Number(tilt.value) + 0.6 * (event.clientY - held[1]);
            held = [event.clientX, event.clientY];
            redraw();
        });
        for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => { held = null; });
    }
    for (const slider of [turn, tilt]) slider.addEventListener("input", redraw);

    /** What the address says of a body, and what it is to say. */
    const MARK = "#your-body?";
    const CALLED = field("name").value;
    const called = () => field("name").value.trim() || CALLED;
    const words = () => `${MARK}${new URLSearchParams([["kind", kind.value], ...given(), ...(called() === CALLED ? [] : [["name", called()]]), ...parts.map(({ kind, numbers, at, turn }) => ["part", [kind, ...numbers, ...at, ...(turn[1] === 0 ? [] : turn)].join("_")])])}`;
    function fromAddress() {
        if (!location.hash.startsWith(MARK)) return;
        const said = new URLSearchParams(location.hash.slice(MARK.length));
        if (Object.hasOwn(KINDS, said.get("kind") ?? "")) kind.value = said.get("kind");
        for (const name of ["m", ...SIZES, ...TENSOR]) {
            const value = said.get(name);
            if (value !== null && (value === "" || Number.isFinite(Number(value)))) fill(name, value);
        }
        if (said.has("name")) field("name").value = said.get("name").slice(0, 60);
        parts = said.getAll("part").flatMap((text) => fromText(text, (kind) => (Object.hasOwn(KINDS, kind) ? 1 + (KINDS[kind].length || TENSOR.length) : 0))).slice(0, MOST_PARTS);
        if (parts.length > 0) field("many").open = true;
    }
    let later = 0;
    function keep() {
        clearTimeout(later);
        later = setTimeout(() => history.replaceState(null, "", words()), 400); // browsers count how often an address changes
    }

    const turns = (perRadian) => `once in ${digits(1 / perRadian)} turns`;
    /** With its zeros, as those above and below it in a column; `toPrecision` gives a power of ten from 1000 on. */
    const digits = (x, count = 3) => {
        const text = x.toPrecision(count);
        if (Math.abs(x) < 0.001 || Math.abs(x) >= 1e5) return short(x);
        return text.includes("e") ? String(Number(text)) : text;
    };
    function tell() {
        const { moments, axes, equal, growth, circles, flips } = found;
        const direction = (axis) => axis.map((x) => x.toFixed(3).replace("-0.000", "0.000").replace("-", "−")).join(", ");
        const [numbers, unit] = inUnit(moments);
        numbers.forEach((moment, k) => { shown(`axis-${k + 1}`).textContent = `${digits(moment, 4)} ${unit}, along (${direction(axes[k])})`; });
        const never = { 1: "moments 2 and 3 are equal: it never flips", 2: "moments 1 and 2 are equal: it never flips", 3: "all moments are equal: any spin stays as it is" }[equal];
        shown("growth").textContent = never ?? `unstable, it flips: a slip becomes ${digits(Math.exp(growth * 2 * Math.PI))} times as large in each turn, ten times in ${digits(Math.log(10) / (growth * 2 * Math.PI))} turns`;
        shown("circles").textContent = equal === 3 ? "the same" : [0, 2].filter((k) => circles[k / 2] > 0).map((k) => `axis ${k + 1}: stable, circled ${turns(circles[k / 2])}`).join("; ");
        const widest = PLANES.map((plane) => Math.max(...gaps(plane)));
        shown("gap").textContent = equal === 3 ? "none in any direction" : `${digits(Math.max(...widest))}°`;
        stage.querySelector(".your-body-flips").hidden = equal !== 0;
        stage.querySelector(".your-body-flips tbody").replaceChildren(...flips.map((time, k) => {
            const row = document.createElement("tr");
            row.append(Object.assign(document.createElement("th"), { scope: "row", textContent: `10${raised(-1 - k)}` }), Object.assign(document.createElement("td"), { textContent: digits(time) }));
            return row;
        }));
        return `${shown("growth").textContent}.`;
    }

    function show() {
        for (const set of stage.querySelectorAll("[data-of]")) set.hidden = (set.dataset.of === "moments") !== (kind.value === "moments");
        SIZES.forEach((name, k) => {
            const called = KINDS[kind.value][k];
            field(name).parentElement.hidden = called === undefined;
            field(name).previousElementSibling.textContent = called ?? "";
            field(name).setAttribute("aria-label", called?.length === 1 ? `the side along ${called}` : called ?? "");
        });
        list();
        const why = ask();
        // Of each part that no solid could be, and of a body that is drawn as what it is not, it is said.
        const asks = why ? [] : found.whole.map(({ kind, numbers: [mass, ...sizes], ...part }) => question(kind, mass, sizes, named({ kind, numbers: [mass, ...sizes], ...part })));
        shown("asks").textContent = asks.filter((text) => text !== "").join(" ");
        shown("stand-in").hidden = why !== null || found.whole.every((part) => part.kind !== "moments");
        shown("title").textContent = `How ${called()} turns`;
        shown("what").textContent = why ? "" : `${found.whole.map((part) => (part.numbers[0] > 0 ? named(part) : "moments and products alone")).join("; ")}.`;
        pause();
        if (why === null) {
            const [count, ...times] = found.equal === 0 ? exact.answer(5, ...found.moments, 0, SPIN, SLIP * SPIN, 60, 1) ?? [0] : [0];
            motion.flips = times.slice(0, count);
        }
        go(0);
        wrong.hidden = why === null;
        wrong.textContent = why === null ? "" : why + (found ? " The drawings are of the last body that was right." : "");
        for (const svg of Object.values(pictures)) svg.classList.toggle("live-dim", why !== null);
        stage.querySelector("dl").style.visibility = why === null ? "" : "hidden";
        if (why === null) {
            say(tell());
            keep();
        }
        redraw();
    }

    /** The tensor of a link as URDF has it, or what is wrong with it. */
    function link(text) {
        const { why, tensor, mass, turned } = robot(text);
        if (why) return why;
        const answer = body.answer(3, ...tensor, ...turned);
        if (!answer) return `${body.words()}.`;
        kind.value = "moments";
        fill("m", mass);
        TENSOR.forEach((name, k) => { field(name).value = answer[k]; });
        show();
        return "Read: its tensor about its centre of mass, in the link’s axes.";
    }
    const { pause } = clock(stage, field("play"), { step: 0.4, start: "Let it tumble", go: (seconds) => Boolean(go(motion.t + seconds)), pressed: () => say(go(motion.t)) });
    field("back").addEventListener("click", () => {
        pause();
        go(0);
    });
    field("urdf").addEventListener("input", () => { shown("urdf").textContent = field("urdf").value.trim() === "" ? "" : link(field("urdf").value); });

    field("copy").addEventListener("click", async () => {
        clearTimeout(later);
        history.replaceState(null, "", words());
        try {
            await navigator.clipboard.writeText(location.href);
            shown("copied").textContent = "Copied.";
        } catch {
            shown("copied").textContent = "The link is the address of this page: copy it from there.";
        }
    });
    tumblingLive.yourBodySaves({ stage, shown, wrong, kinds: KINDS, called, found: () => found, pictures, exact });
    addEventListener("hashchange", () => { fromAddress(); sized(); show(); });
    // Another kind takes over the box around the one before.
    let [before, box] = [null, null];
    function sized() {
        const sizes = given().slice(1).map(([, value]) => Number(value));
        if (around[kind.value] && sizes.every((x) => x > 0)) box = around[kind.value](...sizes);
        before = kind.value;
    }
    kind.addEventListener("input", () => {
        if (kind.value !== before && box) within[kind.value]?.(...box).forEach((value, k) => fill(SIZES[k], value));
        before = kind.value;
        show();
    });
    field("add").addEventListener("click", add);
    for (const name of ["m", ...SIZES, ...TENSOR]) {
        field(name).addEventListener("input", () => {
            sized();
            show();
        });
    }
    field("name").addEventListener("input", show);
    fromAddress();
    sized();
    // What stands there at first is not in the address until something is changed.
    const first = location.hash;
    show();
    if (!first.startsWith(MARK)) clearTimeout(later);
});
