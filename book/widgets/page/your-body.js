// Your body: sizes, moments or a robot's link in; axes, stability, times between flips, paths of the spin out.
"use strict";

tumblingLive.widget("your-body", async (stage, from) => {
    const { load, module, fixed, short, raised, draw, arrow, drawing, sayer } = tumblingLive;
    const [body, exact] = await Promise.all([...["your-body", "tumble"].map(module), load(`${from}live.bodies.js`), load(`${from}your-body.saves.js`)]);
    const { rows, clock } = tumblingLive.bodies;
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
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));
    let found = null; // what the module answers, by name
    let parts = []; // those added: kind, numbers as the module takes them (kg, m, kg m²), place
    const PLACE = ["x", "y", "z"];
    const MOST_PARTS = 20;

    /** Sizes and mass are typed in mm and g; asked, and kept in the address, in m and kg. */
    const UNIT = (name) => (TENSOR.includes(name) ? 1 : 1000);
    const exactly = (x) => Number(x.toPrecision(15));
    /** What is asked now, by the fields: names and values. */
    function given() {
        const names = KINDS[kind.value].length > 0 ? ["m", ...SIZES.slice(0, KINDS[kind.value].length)] : ["m", ...TENSOR];
        return names.map((name) => [name, field(name).value === "" ? "" : String(exactly(field(name).value / UNIT(name)))]);
    }

    /** What is wrong with what is typed, before the module looks at it; or null. */
    function lacks(known) {
        const empty = known.find(([, value]) => value === "");
        return empty ? `Type a number for ${field(empty[0]).getAttribute("aria-label") ?? empty[0]}.` : null;
    }
    const together = (parts) => body.answer(5, parts.length, ...parts.flatMap(({ kind, numbers, at }) => [Object.keys(KINDS).indexOf(kind), ...numbers, ...Array(7 - numbers.length).fill(0), ...at]));
    /** A part in words, in mm and g. */
    function named({ kind: of, numbers: [mass, ...sizes], at }) {
        const mm = (lengths) => lengths.map((x) => String(exactly(x * 1000)).replace("-", "−"));
        const size = of === "moments" ? "" : `, ${mm(sizes).join(" × ")} mm`;
        return `${of}, ${exactly(mass * 1000)} g${size}, at (${mm(at).join(", ")}) mm`;
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
        const at = PLACE.map((name) => [name, field(name).value]);
        const part = { kind: kind.value, numbers: given().map(([, value]) => Number(value)), at: at.map(([, value]) => exactly(value / 1000)) };
        const why = parts.length === MOST_PARTS ? `There is room for ${MOST_PARTS} parts.` : lacks([...given(), ...at]) ?? (together([...parts, part]) ? null : `${body.words()}.`);
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
            const why = lacks(kind.value === "moments" ? values.slice(1) : values);
            if (why) return why;
            if (Number(field("m").value) < 0) return "The mass must be above zero, or left out where it is not known.";
        }
        const answer = parts.length > 0 ? together(parts) : body.answer(0, Object.keys(KINDS).indexOf(kind.value), ...values.map(([, value]) => Number(value)));
        if (!answer) return `${body.words()}.`;
        const drawn = parts[0] ?? { kind: kind.value, numbers: values.map(([, x]) => Number(x)) };
        const part = (from, count) => Array.from(answer.slice(from, from + count));
        found = {
            tensor: part(0, 6), moments: part(6, 3), axes: [part(9, 3), part(12, 3), part(15, 3)], equal: answer[18], growth: answer[19],
            circles: [answer[20], answer[21]], semiaxes: part(22, 3), flips: part(25, 9), edges: drawn.kind === "box" && parts.length < 2 ? drawn.numbers.slice(1) : null,
        };
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
            const [near, far] = [from[k], from[k] + 0.42].map((x) => at(axis.map((part) => lead * part * x)));
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
        const edges = found.edges;
        const longest = edges ? Math.hypot(...edges) / 2 : Math.max(...found.semiaxes);
        const at = looking(width, height, 0.31 * Math.min(width, height));
        if (edges) {
            const half = edges.map((edge) => edge / 2 / longest);
            const corner = (bits) => inRoom(half.map((far, i) => (bits >> i & 1 ? far : -far)));
            const toward = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((edge) => dot(inRoom(edge), eye()[2]));
            const farthest = toward.reduce((bits, leads, i) => bits | (leads < 0) << i, 0);
            for (let from = 0; from < 8; from += 1) {
                for (const bit of [1, 2, 4]) {
                    if (from & bit) continue;
                    const hidden = [from, from | bit].includes(farthest);
                    path(svg, hidden ? "live-edge live-hidden" : "live-edge", [at(corner(from)), at(corner(from | bit))]);
                }
            }
            axes(svg, at, found.axes.map((axis) => Math.min(...half.map((far, i) => far / Math.max(Math.abs(axis[i]), 1e-9)))), axesNow());
        } else {
            const semiaxes = found.semiaxes.map((x) => x / longest);
            path(svg, "live-body", outline(semiaxes, at, axesNow()), "z");
            axes(svg, at, semiaxes, axesNow());
        }
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
    const PLANES = [[0, 2, ""], [0, 1, "your-body-dashed"], [1, 2, "your-body-dotted"]];
    const DEGREES = Array.from({ length: 91 }, (_, k) => k);
    function gaps([easy, hard]) {
        return Array.from(body.answer(2, ...found.moments, easy, hard, DEGREES.length, ...DEGREES.map((x) => Math.tan((x * Math.PI) / 360))) ?? []);
    }
    redraws.push(drawing(pictures.gap, (width) => Math.round(Math.min(0.5 * width, 224)), (width, height) => {
        if (!found) return;
        const svg = pictures.gap;
        const curves = PLANES.map(gaps);
        const most = Math.max(1, ...curves.flat()) * 1.15;
        const at = (x, gap) => [44 + ((width - 60) * x) / 90, height - 24 - ((height - 44) * gap) / most];
        for (const x of [0, 30, 60, 90]) {
            path(svg, "live-grid", [at(x, 0), at(x, most)]);
            draw("text", svg, { x: at(x, 0)[0], y: height - 6, "text-anchor": "middle" }, `${x}°`);
        }
        const step = [30, 10, 5, 2, 1, 0.5, 0.2].find((step) => most / step >= 2.5) ?? 0.2;
        for (let gap = 0; gap < most; gap += step) {
            path(svg, "live-grid", [at(0, gap), at(90, gap)]);
            draw("text", svg, { x: 38, y: at(0, gap)[1] + 5, "text-anchor": "end" }, `${Number(gap.toFixed(1))}°`);
        }
        curves.forEach((gap, k) => { if (gap.length > 0) path(svg, `live-curve ${PLANES[k][2]}`, gap.map((y, x) => at(x, y))); });
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
    const words = () => `${MARK}${new URLSearchParams([["kind", kind.value], ...given(), ...parts.map(({ kind, numbers, at }) => ["part", [kind, ...numbers, ...at].join("_")])])}`;
    /** A part as the address has it: `box_0.2_0.077_0.0078_0.16_0_0_0`. */
    function fromText(text) {
        const [kind, ...numbers] = text.split("_");
        const count = Object.hasOwn(KINDS, kind) ? 1 + (KINDS[kind].length || TENSOR.length) : 0;
        const whole = count > 0 && numbers.length === count + 3 && numbers.every((x) => x !== "" && Number.isFinite(Number(x)));
        return whole ? [{ kind, numbers: numbers.slice(0, count).map(Number), at: numbers.slice(count).map(Number) }] : [];
    }
    function fromAddress() {
        if (!location.hash.startsWith(MARK)) return;
        const said = new URLSearchParams(location.hash.slice(MARK.length));
        if (Object.hasOwn(KINDS, said.get("kind") ?? "")) kind.value = said.get("kind");
        for (const name of ["m", ...SIZES, ...TENSOR]) {
            const value = said.get(name);
            if (value !== null && (value === "" || Number.isFinite(Number(value)))) field(name).value = value === "" ? "" : exactly(value * UNIT(name));
        }
        parts = said.getAll("part").flatMap(fromText).slice(0, MOST_PARTS);
        if (parts.length > 0) field("many").open = true;
    }
    let later = 0;
    function keep() {
        clearTimeout(later);
        // Browsers count how often an address changes.
        later = setTimeout(() => history.replaceState(null, "", words()), 400);
    }

    const turns = (perRadian) => `once in ${digits(1 / perRadian)} turns`;
    const digits = (x, count = 3) => (Math.abs(x) >= 0.001 && Math.abs(x) < 1e5 ? String(Number(x.toPrecision(count))) : short(x));
    function tell() {
        const { moments, axes, equal, growth, circles, flips } = found;
        const direction = (axis) => axis.map((x) => x.toFixed(3).replace("-0.000", "0.000").replace("-", "−")).join(", ");
        moments.forEach((moment, k) => { shown(`axis-${k + 1}`).textContent = `${digits(moment, 4)} kg m², along (${direction(axes[k])})`; });
        const never = { 1: "moments 2 and 3 are equal: it never flips", 2: "moments 1 and 2 are equal: it never flips", 3: "all moments are equal: any spin stays as it is" }[equal];
        shown("growth").textContent = never ?? `unstable, it flips: in each turn a slip grows by a factor of ${digits(Math.exp(growth * 2 * Math.PI))}`;
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
        const found = ["text/xml", "text/html"].map((kind) => new DOMParser().parseFromString(text, kind).querySelectorAll("inertial")).find((all) => all.length > 0);
        if (!found) return "There is no inertial element in it.";
        if (found.length > 1) return `There are ${found.length} inertial elements in it: paste one link alone.`;
        const [inertial] = found;
        const number = (selector, name) => Number(inertial.querySelector(selector)?.getAttribute(name) ?? NaN);
        const tensor = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"].map((name) => number("inertia", name));
        const mass = number("mass", "value");
        const turned = (inertial.querySelector("origin")?.getAttribute("rpy") ?? "0 0 0").trim().split(/\s+/).map(Number);
        if (![...tensor, mass, ...turned].every(Number.isFinite) || turned.length !== 3) return "A number is missing: mass, the six of inertia, and the angles of origin where there are any.";
        if (!(mass > 0)) return "The mass must be above zero.";
        const answer = body.answer(3, ...tensor, ...turned);
        if (!answer) return `${body.words()}.`;
        kind.value = "moments";
        field("m").value = exactly(mass * UNIT("m"));
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
            shown("copied").textContent = "It stands in the address of this page: copy it from there.";
        }
    });
    tumblingLive.yourBodySaves({ stage, shown, wrong, kind, kinds: KINDS, given, parts: () => parts, named, found: () => found, pictures, exact });
    addEventListener("hashchange", () => { fromAddress(); show(); });
    kind.addEventListener("input", show);
    field("add").addEventListener("click", add);
    for (const name of ["m", ...SIZES, ...TENSOR]) field(name).addEventListener("input", show);
    fromAddress();
    // What stands there at first is not in the address until something is changed.
    const first = location.hash;
    show();
    if (!first.startsWith(MARK)) clearTimeout(later);
});
