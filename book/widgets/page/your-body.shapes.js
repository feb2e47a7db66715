// What is typed on "Your own body", and what its solids look like: numbers with units, the question about density, flat faces.
"use strict";

tumblingLive.yourBodyShapes = (() => {
    const UNITS = { mm: 1e-3, cm: 1e-2, m: 1, g: 1e-3, kg: 1 };
    const exactly = (x) => Number(x.toPrecision(15));
    /** A number as typed, in m or kg where it has such a unit or gets this one; NaN if it is none, or may be either of two. */
    function typed(text, unit = null) {
        const [, number, own] = text.trim().replace("−", "-").match(/^([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?)\s*([a-z]*)$/i) ?? [];
        const known = unit === null ? own === "" : own === "" || (own in UNITS && own.endsWith("m") === unit.endsWith("m"));
        // One comma before three digits, as in 1,125, divides thousands or marks decimals.
        if (!known || /^[+-]?[1-9]\d{0,2},\d{3}$/.test(number)) return NaN;
        const value = Number(number.replace(",", "."));
        return unit === null ? value : exactly(value * UNITS[own === "" ? unit : own]);
    }
    /** Why a text is no number, in one line. */
    function refused(text, called, unit) {
        if (text.trim() === "") return `Type a number for ${called}.`;
        const units = { mm: ", or with its unit: mm, cm or m", g: ", or with its unit: g or kg" }[unit] ?? "";
        const either = /^[1-9]\d{0,2},\d{3}$/.test(text.trim()) ? ` It may be ${text.trim().replace(",", "")} or ${text.trim().replace(",", ".")}.` : "";
        return `“${text.trim()}” is not read as a number for ${called}.${either} Write it such as 12.5${units}.`;
    }

    const MOMENT = [[1e-2, 1, "kg m²"], [1e-4, 1e-4, "kg cm²"], [1e-7, 1e-7, "g cm²"], [0, 1e-9, "g mm²"]];
    /** Moments, kg m², in the unit that the command `report` gives them, and that unit. */
    function inUnit(moments) {
        const [, size, unit] = MOMENT.find(([from]) => Math.max(...moments) >= from * (1 - 1e-9));
        return [moments.map((x) => x / size), unit];
    }

    /** Volumes, m³, of what is not thin, and the box around each that its sizes go over to when the kind changes, and back. */
    const VOLUMES = {
        box: (a, b, c) => a * b * c, ball: (r) => (4 / 3) * Math.PI * r ** 3, cylinder: (r, h) => Math.PI * r * r * h, tube: (i, r, h) => Math.PI * (r * r - i * i) * h,
        capsule: (r, h) => Math.PI * r * r * (h + (4 / 3) * r), cone: (r, h) => (Math.PI * r * r * h) / 3, ellipsoid: (a, b, c) => (4 / 3) * Math.PI * a * b * c,
    };
    const AROUND = {
        box: (a, b, c) => [a, b, c], ball: (r) => [2 * r, 2 * r, 2 * r], cylinder: (r, h) => [2 * r, 2 * r, h], tube: (i, r, h) => [2 * r, 2 * r, h],
        capsule: (r, h) => [2 * r, 2 * r, h + 2 * r], cone: (r, h) => [2 * r, 2 * r, h], ellipsoid: (a, b, c) => [2 * a, 2 * b, 2 * c], plate: (a, b) => [a, b, a], disk: (r) => [2 * r, 2 * r, r],
    };
    const WITHIN = {
        box: (x, y, z) => [x, y, z], ball: (x) => [x / 2], cylinder: (x, y, z) => [x / 2, z], tube: (x, y, z) => [x / 4, x / 2, z],
        capsule: (x, y, z) => [x / 2, Math.max(z - x, 0)], cone: (x, y, z) => [x / 2, z], ellipsoid: (x, y, z) => [x / 2, y / 2, z / 2], plate: (x, y) => [x, y], disk: (x) => [x / 2],
    };
    /** Whether other units were meant where no solid is so light or so heavy, as the command line asks; or nothing. */
    function question(kind, mass, sizes, words) {
        const [usual, density] = [(x) => x >= 10 && x < 25000, mass / (VOLUMES[kind]?.(...sizes) ?? NaN)];
        if (Number.isNaN(density) || usual(density)) return "";
        const others = [[1e3, "Is the mass in kg?"], [1e-3, "Is the mass in g?"], [1e-3, "Are the sizes in cm?"], [1e-9, "Are the sizes in m?"]];
        const likely = others.filter(([factor]) => usual(density * factor)).map(([, asked]) => asked);
        return `${words}: no solid is so ${density < 10 ? "light" : "heavy"}. ${likely.join(" ") || "Are the numbers right?"}`;
    }

    const [ROUND, HIGH] = [24, 10];
    /** Half a circle of places (radius, height), from the lowest to the highest, with its middle at a height. */
    const arc = (radius, middle = 0, from = -HIGH / 2, to = HIGH / 2) => Array.from({ length: to - from + 1 }, (_, k) => {
        const angle = ((from + k) * Math.PI) / HIGH;
        return [Math.abs(from + k) === HIGH / 2 ? 0 : radius * Math.cos(angle), middle + radius * Math.sin(angle)];
    });
    const flat = (radius, low, high) => [[0, low], [radius, low], [radius, high], [0, high]];
    const OUTLINES = {
        ball: (r) => arc(r), cylinder: (r, h) => flat(r, -h / 2, h / 2), tube: (i, r, h) => [[i, -h / 2], [r, -h / 2], [r, h / 2], [i, h / 2], [i, -h / 2]],
        capsule: (r, h) => [...arc(r, -h / 2, -HIGH / 2, 0), ...arc(r, h / 2, 0, HIGH / 2)], cone: (r, h) => [[0, 0], [r, 0], [0, h]], ellipsoid: () => arc(1), disk: (r) => flat(r, 0, 0),
    };
    /** The faces of a solid about its origin: corners counter-clockwise as seen from outside, m. */
    function solid(kind, sizes) {
        if (kind === "box" || kind === "plate") {
            const half = [0, 1, 2].map((k) => (sizes[k] ?? 0) / 2);
            return [0, 1, 2].flatMap((axis) => [-1, 1].map((side) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => {
                const p = [0, 0, 0];
                [p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]] = [side * half[axis], side * a * half[(axis + 1) % 3], b * half[(axis + 2) % 3]];
                return p;
            })));
        }
        const outline = OUTLINES[kind](...sizes);
        const wide = kind === "ellipsoid" ? sizes : [1, 1, 1];
        const at = ([r, z], i) => [r * Math.cos((2 * Math.PI * i) / ROUND) * wide[0], r * Math.sin((2 * Math.PI * i) / ROUND) * wide[1], z * wide[2]];
        const around = Array.from({ length: ROUND }, (_, i) => i);
        return outline.slice(1).flatMap((to, k) => {
            const from = outline[k];
            if (from[1] === to[1] && to[0] === 0) return [around.map((i) => at(from, i))];
            if (from[1] === to[1] && from[0] === 0) return [around.map((i) => at(to, -i))];
            return around.map((i) => [at(from, i), ...(from[0] > 0 ? [at(from, i + 1)] : []), at(to, i + 1), ...(to[0] > 0 ? [at(to, i)] : [])]);
        });
    }

    /** A place, turned by these degrees about x, y or z. */
    function turned([axis, degrees], p) {
        const [c, s] = [Math.cos, Math.sin].map((f) => f((degrees * Math.PI) / 180));
        const [second, third] = [(axis + 1) % 3, (axis + 2) % 3];
        return Object.assign([...p], { [second]: c * p[second] - s * p[third], [third]: s * p[second] + c * p[third] });
    }
    /** Where the middle of a part's mass is. */
    const middle = ({ kind, numbers: [, , height], at, turn }) => turned(turn, [0, 0, kind === "cone" ? height / 4 : 0]).map((x, i) => x + at[i]);
    /** A part that is turned as one of moments, in place about the middle of its mass; `tensor` gives them for roll, pitch and yaw. */
    function laid(part, tensor) {
        const { numbers: [mass], turn: [axis, degrees] } = part;
        const moments = degrees === 0 ? null : tensor([0, 1, 2].map((k) => (k === axis ? (degrees * Math.PI) / 180 : 0)));
        return moments ? { kind: "moments", numbers: [mass, ...moments], at: middle(part) } : part;
    }
    /**
     * The faces of parts, held rigidly, about their common centre of mass along these axes, in parts of how far the farthest corner is.
     * Of a part that is given by moments, `even` says the semi-axes and the axes of the ellipsoid that is drawn in its place.
     */
    function faces(parts, axes, even) {
        const weight = (mass) => (mass > 0 ? mass : 1);
        const whole = parts.reduce((sum, { numbers: [mass] }) => sum + weight(mass), 0);
        const centre = [0, 1, 2].map((i) => parts.reduce((sum, part) => sum + (weight(part.numbers[0]) * middle(part)[i]) / whole, 0));
        const places = parts.flatMap(({ kind, numbers: [mass, ...sizes], at, turn }) => {
            const { semiaxes, leads } = kind === "moments" ? even([mass, ...sizes]) : { leads: null };
            const own = leads ? (p) => [0, 1, 2].map((i) => leads.reduce((sum, lead, k) => sum + lead[i] * p[k], 0)) : (p) => p;
            return solid(leads ? "ellipsoid" : kind, semiaxes ?? sizes).map((corners) => corners.map((p) => turned(turn, own(p)).map((x, i) => x + at[i] - centre[i])));
        });
        const reach = Math.max(...places.flat().map((p) => Math.hypot(...p)));
        return places.map((corners) => corners.map((p) => axes.map((axis) => axis.reduce((sum, x, i) => sum + x * p[i], 0) / reach)));
    }
    /** What of a face lies on the positive side of the middle axis. */
    const marked = (corners) => corners.flatMap((a, k) => {
        const b = corners[(k + 1) % corners.length];
        const cut = a[1] * b[1] < 0 ? [a.map((x, i) => x + ((b[i] - x) * a[1]) / (a[1] - b[1]))] : [];
        return a[1] >= 0 ? [a, ...cut] : cut;
    });
    /** The faces that are seen, the farthest first, each with its places (right, up, toward the eye), and with its marked part. */
    function seen(faces, look) {
        const turned = faces.map((corners) => ({ places: corners.map(look), mark: marked(corners).map(look) }));
        const area = (places) => places.reduce((sum, [x, y], k) => { const [u, v] = places[(k + 1) % places.length]; return sum + x * v - u * y; }, 0);
        const depth = ({ places }) => places.reduce((sum, p) => sum + p[2], 0) / places.length;
        return turned.filter(({ places }) => area(places) > 1e-9).sort((a, b) => depth(a) - depth(b));
    }
    /** Mass, tensor and turn of a link as URDF has it, or what is wrong with it. */
    function robot(text) {
        const found = ["text/xml", "text/html"].map((kind) => new DOMParser().parseFromString(text, kind).querySelectorAll("inertial")).find((all) => all.length > 0);
        if (!found) return { why: "There is no inertial element in it." };
        if (found.length > 1) return { why: `There are ${found.length} inertial elements in it: paste one link alone.` };
        const [inertial] = found;
        const number = (selector, name) => Number(inertial.querySelector(selector)?.getAttribute(name) ?? NaN);
        const tensor = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"].map((name) => number("inertia", name));
        const mass = number("mass", "value");
        const turned = (inertial.querySelector("origin")?.getAttribute("rpy") ?? "0 0 0").trim().split(/\s+/).map(Number);
        if (![...tensor, mass, ...turned].every(Number.isFinite) || turned.length !== 3) {
            return { why: "A number is missing: mass, the six of inertia, and the angles of origin where there are any." };
        }
        return mass > 0 ? { tensor, mass, turned } : { why: "The mass must be above zero." };
    }
    /** A part as the address has it, `box_0.2_0.077_0.0078_0.16_0_0_0` or with `_2_30` turned by 30° about z; a list of one or none. */
    function fromText(text, count) {
        const [kind, ...numbers] = text.split("_");
        const n = count(kind);
        const turn = numbers.length === n + 5 ? numbers.splice(n + 3).map(Number) : [0, 0];
        const whole = n > 0 && numbers.length === n + 3 && [...numbers, turn[1]].every((x) => x !== "" && Number.isFinite(Number(x))) && [0, 1, 2].includes(turn[0]);
        return whole ? [{ kind, numbers: numbers.slice(0, n).map(Number), at: numbers.slice(n).map(Number), turn }] : [];
    }
    /** Where each key of the gaps stands, its words and its look. */
    const KEY = [[4, "axis 1 to 3", ""], [118, "1 to 2", "your-body-dashed"], [198, "2 to 3", "your-body-dotted"]];
    /** The gaps against the angle from one axis to another; titles and key stand in the drawing, so that they are saved with it. */
    function gapsDrawn(svg, path, width, height, curves) {
        const { draw } = tumblingLive;
        const most = Math.max(1, ...curves.flat()) * 1.15;
        const at = (x, gap) => [44 + ((width - 60) * x) / 90, height - 44 - ((height - 100) * gap) / most];
        draw("text", svg, { x: 4, y: 15 }, "gap between spin and momentum");
        draw("text", svg, { x: at(45, 0)[0], y: height - 6, "text-anchor": "middle" }, "angle from the first axis to the spin");
        for (const x of [0, 30, 60, 90]) {
            path(svg, "live-grid", [at(x, 0), at(x, most)]);
            draw("text", svg, { x: at(x, 0)[0], y: height - 26, "text-anchor": "middle" }, `${x}°`);
        }
        const step = [30, 10, 5, 2, 1, 0.5, 0.2].find((step) => most / step >= 2.5) ?? 0.2;
        for (let gap = 0; gap < most; gap += step) {
            path(svg, "live-grid", [at(0, gap), at(90, gap)]);
            draw("text", svg, { x: 38, y: at(0, gap)[1] + 5, "text-anchor": "end" }, `${Number(gap.toFixed(1))}°`);
        }
        curves.forEach((gap, k) => {
            const [x, name, look] = KEY[k];
            path(svg, `live-curve ${look}`, [[x, 33], [x + 22, 33]]);
            draw("text", svg, { x: x + 28, y: 38 }, name);
            if (gap.length > 0) path(svg, `live-curve ${look}`, gap.map((y, x) => at(x, y)));
        });
    }
    return { typed, refused, inUnit, exactly, around: AROUND, within: WITHIN, question, faces, laid, seen, robot, fromText, gapsDrawn };
})();
