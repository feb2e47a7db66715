// Methods and steps: the path that a method takes beside the exact one, and its errors at this step and at others.
"use strict";

tumblingLive.widget("steps", async (stage) => {
    const { module, fixed, raised, short, draw, drawing, sayer } = tumblingLive;
    const [methods, motion] = await Promise.all([module("steps"), module("tumble")]);
    const [method, body, start, step] = ["method", "body", "start", "step"].map((id) => stage.querySelector(`#steps-${id}`));
    const svgs = ["path", "errors"].map((what) => stage.querySelector(`[data-drawing=${what}]`));
    const wrong = stage.querySelector(".live-wrong");
    const ran = stage.querySelector(".live-key-right");
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);

    const UNTIL = 10; // s
    const HEAD = 6; // as in steps/src/lib.rs
    /** How many steps the time is cut into: what the slider chooses from, and where the curves have their points. */
    const COUNTS = [1600, 1131, 800, 600, 400, 283, 200, 141, 100, 71, 50, 35, 25, 18, 12, 9, 6];
    const CURVE = [3200, 1600, 800, 400, 200, 100, 50, 25, 12, 6];
    const SPINS = [[1, 1, 1], [10, 0.1, 0.1], [0.1, 10, 0.1]];
    const KEEPS = ["the energy", "|L|", "the direction of L", "the attitude’s length", "the way back"];
    const [LEAST, MOST] = [-16, 4]; // powers of ten in the drawing of errors

    /** What the library says of a method, by name; nothing where there is none. */
    function about(which) {
        const answer = methods.answer(0, which);
        if (!answer) return null;
        const [order, implicit, ...kept] = answer;
        return { name: methods.words(), order, implicit, keeps: KEEPS.filter((_, i) => kept[i]) };
    }
    for (let which = 0, told = about(0); told; which += 1, told = about(which)) {
        const option = document.createElement("option");
        option.value = which;
        option.textContent = told.name;
        option.selected = told.name === "Runge-Kutta 4";
        method.append(option);
    }

    const kept = new Map(); // what was run of this method and motion, by the number of steps
    function run(count) {
        if (!kept.has(count)) kept.set(count, afresh(count));
        return kept.get(count);
    }
    function afresh(count) {
        const answer = methods.answer(1, ...moments, ...SPINS[start.value], UNTIL, count, Number(method.value), ...truth);
        const [taken, why, energy, length, attitude, greatest] = answer;
        const [what, step] = [why ? methods.words() : "", UNTIL / count];
        const reason = ["", `${what} was not found`, `${what} is beyond what an f64 holds`, `${what} cannot be taken`][why];
        return { count, step, taken, reason, energy, length, attitude, greatest, spins: answer.slice(HEAD) };
    }

    let chosen, half, curve, told, exact, moments, truth, key;
    function asked() {
        const now = [method.value, body.value, start.value].join();
        if (now !== key) {
            key = now;
            kept.clear();
            told = about(Number(method.value));
            moments = motion.answer(7, Number(body.value)).slice(0, 3);
            const begun = [...moments, ...SPINS[start.value], UNTIL];
            truth = motion.answer(4, ...begun).slice(3);
            const stretch = motion.answer(5, ...begun, 500);
            exact = stretch.slice(1 + stretch[0]);
            curve = CURVE.map(run);
        }
        chosen = run(COUNTS[step.value]);
        half = run(2 * COUNTS[step.value]);
    }

    const along = (points) => `M${points.map((p) => p.map((x) => x.toFixed(1)).join(" ")).join("L")}`;
    const line = (svg, name, points) => draw("path", svg, { class: name, d: along(points) });
    const cross = (svg, x, y) => draw("path", svg, { class: "live-ran live-wrongly live-cross", d: `M${x - 5} ${y - 5}l10 10m0 -10l-10 10` });

    const drawPath = drawing(svgs[0], (width) => Math.round(Math.max(110, Math.min(0.26 * width, 180))), (width, height, stays) => {
        const svg = svgs[0];
        const most = exact.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
        const reach = height / 2 - 8;
        const at = (time, value) => [6 + (width - 12) * time / UNTIL, height / 2 - reach * Math.max(-1.15, Math.min(1.15, value / (1.1 * most)))];
        const still = resting(svg, stays, (part) => {
            draw("path", part, { class: "live-axis", d: `M6 ${height / 2}H${width - 6}` });
            line(part, "live-exact", Array.from(exact, (value, i) => at(UNTIL * i / (exact.length - 1), value)));
        });
        const name = chosen.reason || off(chosen) ? "live-ran live-wrongly" : "live-ran";
        if (!still.ran.has(chosen.count)) {
            const points = Array.from(chosen.spins, (value, i) => at(i * chosen.step, value));
            const dots = chosen.count > 100 ? "" : points.map(([x, y]) => `M${(x - 2.5).toFixed(2)} ${y.toFixed(2)}a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0z`).join("");
            still.ran.set(chosen.count, { d: along(points.length > 1 ? points : [points[0], points[0]]), dots, end: points.at(-1) });
        }
        const { d, dots, end } = still.ran.get(chosen.count);
        draw("path", svg, { class: name, d });
        if (dots) draw("path", svg, { class: `${name} live-tip`, d: dots });
        if (chosen.reason) cross(svg, ...end);
        return still;
    });

    /** What the step does not change, drawn anew only with another method or motion; and in `ran` what the steps drew so far, by their number. */
    function resting(svg, stays, add) {
        if (stays?.curve === curve) return stays;
        stays?.remove();
        const part = draw("g", svg, {});
        svg.prepend(part);
        add(part);
        return Object.assign(part, { curve, ran: new Map() });
    }

    const KINDS = ["energy", "length", "attitude"];
    const drawErrors = drawing(svgs[1], (width) => Math.round(Math.max(220, Math.min(0.5 * width, 320))), (width, height, stays) => {
        const svg = svgs[1];
        const [left, right, top, bottom] = [46, width - 14, 14, height - 40];
        const [from, to] = [Math.log10(UNTIL / CURVE[0]) - 0.1, Math.log10(UNTIL / CURVE.at(-1)) + 0.1];
        const x = (step) => left + (right - left) * (Math.log10(step) - from) / (to - from);
        const y = (error) => bottom - (bottom - top) * (Math.max(LEAST, Math.min(MOST, error > 0 ? Math.log10(error) : error === 0 ? LEAST : MOST)) - LEAST) / (MOST - LEAST);
        const power = (n) => `10${raised(n)}`;
        const still = resting(svg, stays, (part) => {
            for (let n = LEAST; n <= MOST; n += 4) {
                draw("path", part, { class: "live-grid", d: `M${left} ${y(10 ** n)}H${right}` });
                draw("text", part, { x: left - 6, y: y(10 ** n) + 5, "text-anchor": "end" }, n === 0 ? "1" : power(n));
            }
            for (const step of [0.01, 0.1, 1]) {
                draw("path", part, { class: "live-grid", d: `M${x(step)} ${top}V${bottom}` });
                draw("text", part, { x: x(step), y: bottom + 17, "text-anchor": "middle" }, `${step} s`);
            }
            draw("text", part, { x: (left + right) / 2, y: bottom + 34, "text-anchor": "middle" }, "step");
            for (const kind of KINDS) {
                const held = curve.filter((one) => !one.reason);
                if (held.length > 1) line(part, `live-curve live-curve-${kind}`, held.map((one) => [x(one.step), y(one[kind])]));
                for (const one of held) mark(part, kind, x(one.step), y(one[kind]), 3);
            }
            for (const one of curve) if (one.reason) cross(part, x(one.step), top + 4);
        });
        draw("path", svg, { class: "live-now", d: `M${x(chosen.step)} ${top}V${bottom}` });
        // The order that the library gives, through the attitude's error at this step.
        if (!chosen.reason && told.order > 0 && chosen.attitude > 0) {
            const [logStep, logError] = [Math.log10(chosen.step), Math.log10(chosen.attitude)];
            const within = (far) => Math.max(from, Math.min(to, far));
            const ends = [LEAST, MOST].map((n) => within(logStep + (n - logError) / told.order));
            line(svg, "live-guide", ends.map((end) => [x(10 ** end), y(10 ** (logError + told.order * (end - logStep)))]));
        }
        if (!chosen.reason) for (const kind of KINDS) mark(svg, kind, x(chosen.step), y(chosen[kind]), 6);
        if (chosen.reason) cross(svg, x(chosen.step), top + 4);
        const slope = steepness();
        if (slope !== null) {
            // Above the curve, which rises to the right.
            const room = x(chosen.step) > left + 84;
            draw("text", svg, {
                class: "live-strong", x: x(chosen.step) + (room ? -12 : 12), y: Math.max(top + 12, y(chosen.attitude) - (room ? 10 : 34)),
                "text-anchor": room ? "end" : "start",
            }, `slope ${fixed(slope, 1)}`);
        }
        return still;
    });

    function mark(svg, kind, x, y, size) {
        const name = `live-mark live-curve-${kind}`;
        if (kind === "attitude") draw("circle", svg, { class: name, cx: x, cy: y, r: size });
        else if (kind === "energy") draw("rect", svg, { class: name, x: x - size, y: y - size, width: 2 * size, height: 2 * size });
        else draw("path", svg, { class: name, d: `M${x - 1.4 * size} ${y}l${1.4 * size} ${-1.4 * size}l${1.4 * size} ${1.4 * size}l${-1.4 * size} ${1.4 * size}z` });
    }

    /** Whether a run has lost its way: by more than a tenth of the energy, or by a quarter turn. */
    const off = (one) => !(one.energy < 0.1 && one.attitude < 90);
    /** Below this, in degrees, an error is made of rounding and says nothing of the method. */
    const ROUNDED = 1e-11;
    /** How many times better half the step is. */
    function better() {
        if (chosen.reason || half.reason || !(half.attitude > ROUNDED) || !(chosen.attitude > ROUNDED)) return null;
        return chosen.attitude / half.attitude;
    }
    function steepness() {
        const times = better();
        return times === null || tooLong() ? null : Math.log2(times);
    }
    /** Where the errors are as large as they can be they have no slope. */
    const tooLong = () => !(Math.max(chosen.attitude, half.attitude) < 45) || (chosen.attitude > 1 && half.attitude > chosen.attitude);
    /** As the chapter prints it. */
    const rough = (number) => {
        const [digit, power] = number.toExponential(0).split("e").map(Number);
        return power < -2 || power > 4 ? `${digit} · 10${raised(power)}` : String(Number(number.toPrecision(1)));
    };
    const size = (number) => (number === 0 ? "nothing" : Number.isFinite(number) ? short(number) : "more than an f64 holds");

    function show() {
        asked();
        const chosenStep = `${short(chosen.step)} s, ${chosen.count} steps`;
        shown("step").textContent = chosenStep;
        const astray = chosen.reason || off(chosen);
        ran.className = astray ? "live-key-wrong" : "live-key-right";
        ran.textContent = astray ? "this method, astray" : "this method";
        wrong.hidden = !chosen.reason;
        const refused = chosen.reason && `refused: ${chosen.reason}${chosen.taken ? `, after ${chosen.taken} steps` : ""}`;
        wrong.textContent = refused;
        const put = (what, text) => { shown(what).textContent = chosen.reason ? "refused" : text(); };
        put("attitude", () => (Number.isFinite(chosen.attitude) ? `${rough(chosen.attitude)}°` : "lost"));
        const times = better();
        put("better", () => (times === null ? "lost in rounding, or refused" : times < 1.5 ? "no better" : `${times < 1e4 ? fixed(times, 0) : short(times)} times better`));
        put("slope", () => (times === null ? "none to see" : tooLong() ? "none: the step is too long" : fixed(steepness(), 1)));
        put("energy", () => size(chosen.energy));
        put("length", () => size(chosen.length));
        shown("order").textContent = `${told.order}${told.implicit ? ", implicit" : ""}`;
        shown("keeps").textContent = told.keeps.join(", ") || "nothing";
        drawPath();
        drawErrors();
        const words = chosen.reason ? refused : `Attitude off by ${Number.isFinite(chosen.attitude) ? `${rough(chosen.attitude)}°` : "more than can be told"}, energy by ${size(chosen.energy)}, momentum by ${size(chosen.length)}${off(chosen) ? ": it has lost its way" : ""}`;
        step.setAttribute("aria-valuetext", `${chosenStep}. ${words}`);
        return `${told.name}, step ${chosenStep}. ${words}.`;
    }
    for (const control of [method, body, start, step]) control.addEventListener("input", () => say(show()));
    show();
});
