// Wrong and right: four engines stepped by the module, each drawn over the exact motion as it goes.
"use strict";

tumblingLive.widget("pitfalls", async (stage, from) => {
    const { load, module, fixed, short, draw, drawing, sayer } = tumblingLive;
    const [engines, motion] = await Promise.all([module("pitfalls"), module("tumble")]);
    const control = (id) => stage.querySelector(`#pitfalls-${id}`);
    const [body, about, spin, push, step, until] = ["body", "about", "spin", "push", "step", "until"].map(control);
    const [play, end, reset] = ["play", "end", "reset"].map(control);
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);

    // What the sliders choose from; rad/s and s.
    const SPINS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 20, 30];
    const PUSHES = [0, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.02, 0.05, 0.1, 0.5, 1, 5];
    const STEPS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1];
    const UNTIL = [5, 10, 20, 40, 60, 100];
    /** The starts of the chapter, as places on the sliders: body, about, spin, push, step, until. */
    const STARTS = { 1: [0, "both", 3, 10, 3, 3], 2: [0, "y", 3, 10, 3, 1], 3: [0, "both", 6, 8, 0, 2] };
    const NAMES = ["Right: the tensor turned with the body", "Pitfall one: the tensor that never turned",
        "Pitfall two: momentum taken for spin", "Pitfall three: no gyroscopic term"];
    const [STATE, PIECE, HEAD] = [9, 1000, 18]; // as in pitfalls/src/lib.rs
    const PARTS = 1200; // of a drawing
    const BROKEN = 1e-3; // so great an error, in parts, is seen
    const JOINED = 24; // parts in one piece of an engine's line

    const still = matchMedia("(prefers-reduced-motion: reduce)");
    let start, stepping, length, exact, bundle, steps, frame = 0;

    // A row for each engine: what it is, its drawing, its meters.
    const rows = NAMES.map((name, which) => {
        const place = document.createElement("div");
        place.className = "live-engine";
        place.innerHTML = `<p class="live-title"></p><svg class="live-drawing live-low" aria-hidden="true"></svg><dl class="live-meters">${
            [["energy", "energy"], ["length", "|L|"], ["angle", "L’s direction"], ["flips", "flips"], ["off", "its spin, at the start"]].map(([what, words]) =>
                `<div${what === "flips" || what === "off" ? " class=\"live-words\"" : ""}><dt>${words}</dt><dd data-of="${what}"></dd>${what === "flips" || what === "off" ? "" : "<span class=\"live-bar\" aria-hidden=\"true\"><span></span></span>"}</div>`).join("")}</dl>`;
        place.querySelector("p").textContent = name;
        stage.querySelector(".live-engines").append(place);
        const row = { which, place };
        row.redraw = drawing(place.querySelector("svg"), (width) => Math.max(70, Math.round(Math.min(0.16 * width, 110))),
            (width, height) => path(row, width, height));
        return row;
    });

    /** What an answer on an engine says, by name. */
    function told(row, found) {
        const [energy, size, angle, low, high, flips, first, off] = found.slice(1 + STATE, HEAD);
        row.state = found.slice(1, 1 + STATE);
        row.refused = false;
        Object.assign(row, { energy, size, angle, low: Math.min(row.low, low), high: Math.max(row.high, high), off });
        if (flips > 0 && row.flips === 0) row.turned = first;
        row.flips += flips;
        // No more points than can be told apart, but the least and the greatest of those that cannot.
        for (const value of found.slice(HEAD)) {
            const bin = row.bins[Math.floor(row.count / bundle)] ??= { least: value, most: value };
            if (value <= bin.least) Object.assign(bin, { least: value, falls: true });
            if (value >= bin.most) Object.assign(bin, { most: value, falls: false });
            row.tip = value;
            row.count += 1;
        }
    }

    function begin() {
        stop();
        const [w, p] = [SPINS[spin.value], PUSHES[push.value]];
        start = [Number(body.value), w, about.value === "z" ? 0 : p, about.value === "y" ? 0 : p];
        stepping = STEPS[step.value];
        length = UNTIL[until.value];
        steps = 0;
        bundle = Math.ceil((last() + 1) / PARTS);
        const answer = motion.answer(5, ...engines.answer(2, start[0]), ...start.slice(1), length, PARTS);
        const count = answer[0];
        exact = { flips: answer.slice(1, 1 + count), spins: answer.slice(1 + count) };
        exact.most = exact.spins.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
        for (const row of rows) {
            Object.assign(row, { bins: [], count: 0, flips: 0, low: Infinity, high: -Infinity });
            told(row, engines.answer(0, ...start, row.which));
            row.first = { energy: row.energy, off: row.off };
            row.redraw();
        }
        const tell = (input, what, value, unit) => {
            shown(what).textContent = `${value} ${unit}`;
            input.setAttribute("aria-valuetext", `${value} ${unit}`);
        };
        tell(spin, "spin", plain(w), "rad/s");
        tell(push, "push", plain(p), "rad/s");
        tell(step, "step", plain(stepping), "s");
        tell(until, "until", plain(length), "s");
        return show();
    }

    /** A chosen number, as it was chosen. */
    const plain = (number) => (number === 0 || number >= 1e-3 ? String(number) : short(number));
    const last = () => Math.floor(length / stepping + 1e-9);
    const now = () => Math.min(steps * stepping, length);

    /** Has all engines take steps until so many are taken. */
    function go(to) {
        for (const row of rows) {
            for (let taken = steps; taken < to && !row.refused;) {
                const count = Math.min(PIECE, to - taken);
                const found = engines.answer(1, ...start, row.which, stepping, taken, count, ...row.state);
                told(row, found);
                taken += found[0];
                row.refused = found[0] < count;
            }
        }
        steps = to;
    }

    /** The spin about the middle axis: the exact one through all of the time, the engine's as far as it has gone. */
    function path(row, width, height) {
        const svg = row.place.querySelector("svg");
        const [left, right, middle, reach] = [6, width - 6, height / 2, (height / 2 - 6) / 1.15];
        const x = (time) => left + (right - left) * time / length;
        const y = (value) => middle - reach * Math.max(-1.15, Math.min(1.15, exact.most > 0 ? value / exact.most : 0));
        draw("path", svg, { class: "live-axis", d: `M${left} ${middle}H${right}` });
        const parts = exact.spins.length - 1;
        const points = Array.from(exact.spins, (value, i) => `${x(length * i / parts).toFixed(1)} ${y(value).toFixed(1)}`);
        draw("path", svg, { class: "live-exact", d: `M${points.join("L")}` });
        const name = row.which === 0 ? "live-ran" : "live-ran live-wrongly";
        const tip = draw("circle", svg, { class: `${name} live-tip`, r: 4 });
        row.pen = { svg, x, y, name, tip, pieces: [] };
        follow(row);
    }

    /** Has a drawing follow its engine: only the last piece of its line is drawn anew. */
    function follow(row) {
        const { svg, x, y, name, tip, pieces } = row.pen ?? {};
        if (!svg) return; // it has no width yet
        const place = (i, at, value) => `${x((i + at) * bundle * stepping).toFixed(1)} ${y(value).toFixed(1)}`;
        const points = (i) => {
            const { least, most, falls } = row.bins[i];
            if (bundle === 1) return [place(i, 0, most)];
            return falls ? [place(i, 0.25, most), place(i, 0.75, least)] : [place(i, 0.25, least), place(i, 0.75, most)];
        };
        for (let piece = Math.max(0, pieces.length - 1); piece * JOINED < row.bins.length; piece += 1) {
            // It begins where the one before ends.
            const some = [];
            for (let i = Math.max(0, piece * JOINED - 1); i < Math.min((piece + 1) * JOINED, row.bins.length); i += 1) some.push(...points(i));
            if (some.length === 1) some.push(some[0]);
            pieces[piece] ??= draw("path", svg, { class: name });
            pieces[piece].setAttribute("d", `M${some.join("L")}`);
        }
        if (svg.lastChild !== tip) svg.append(tip);
        tip.setAttribute("cx", x((row.count - 1) * stepping).toFixed(1));
        tip.setAttribute("cy", y(row.tip).toFixed(1));
    }

    /** How long a bar is, in parts, that stands for so great an error. */
    const bar = (error) => Math.max(0, Math.min(1, (Math.log10(error) + 15) / 16)) || 0;
    const share = (ratio) => `${ratio < 1e4 ? fixed(100 * ratio, 0) : short(100 * ratio)} %`;
    /** That an error is, or is not, seen. */
    const beside = (error) => (error === 0 ? "" : `, off by ${short(error)}`);

    function show() {
        const time = now();
        const flipped = exact.flips.filter((t) => t <= time);
        const words = [];
        for (const row of rows) {
            const put = (what, text, error, worst = error) => {
                const place = row.place.querySelector(`[data-of=${what}]`);
                place.textContent = text;
                if (error === undefined) return;
                place.textContent = `${text} (${worst < BROKEN ? "kept" : "broken"})`;
                const filled = place.parentNode.querySelector(".live-bar > span");
                filled.style.width = `${(100 * bar(error)).toFixed(1)}%`;
                filled.classList.toggle("live-slight", worst < BROKEN);
            };
            const met = share(row.low) === share(row.high) ? "" : `; so far ${share(row.low)} to ${share(row.high)}`;
            const off = Math.abs(row.energy - 1);
            put("energy", `${share(row.energy)}${off < BROKEN ? beside(off) : ""}${met}`, off, Math.max(off, 1 - row.low, row.high - 1));
            const far = Math.abs(row.size - 1);
            put("length", `${share(row.size)}${far < BROKEN ? beside(far) : ""}`, far);
            // A raised power and a sign of degrees beside it would run together.
            const angle = row.angle === 0 || row.angle >= 0.05 ? `${fixed(row.angle, 1)}°` : `${short(row.angle)} degrees`;
            put("angle", `${angle} off`, row.angle * Math.PI / 180);
            const first = row.flips > 0 ? `, the first after ${fixed(row.turned, 1)} s` : "";
            put("flips", `${row.flips} ${row.flips === 1 ? "time" : "times"}${first}; right: ${flipped.length}`);
            put("off", `${fixed(row.first.off, 1)}° off, energy ${share(row.first.energy)}`);
            row.place.querySelector(".live-title").textContent = NAMES[row.which]
                + (row.refused ? ": refused, for its numbers leave what an f64 holds" : "");
            words.push(`${NAMES[row.which]}: energy ${share(row.energy)}, momentum ${share(row.size)}, ${row.flips} flips.`);
        }
        for (const row of rows) follow(row);
        shown("time").textContent = `${fixed(time, 1)} s of ${plain(length)} s`;
        end.disabled = steps >= last();
        play.textContent = frame ? "Pause" : still.matches ? "Go on for a tenth" : "Play";
        play.disabled = steps >= last();
        return `After ${fixed(time, 1)} s. ${words.join(" ")} Right would be ${flipped.length} flips.`;
    }

    function stop() {
        cancelAnimationFrame(frame);
        frame = 0;
    }

    play.addEventListener("click", () => {
        if (frame) {
            stop();
            say(show());
            return;
        }
        if (still.matches) {
            go(Math.min(last(), steps + Math.ceil(last() / 10)));
            say(show());
            return;
        }
        // Time passes as it does for the reader, but never by leaps.
        let before = null; // the first frame begins it
        let time = now();
        let numbers = -Infinity; // when they were last shown
        const tick = (instant) => {
            time = Math.min(length, time + Math.min(0.1, (instant - (before ?? instant)) / 1000));
            before = instant;
            go(Math.min(last(), Math.floor(time / stepping + 1e-9)));
            frame = steps < last() ? requestAnimationFrame(tick) : 0;
            // Nobody reads numbers that change with every frame, and each would have the page laid out anew.
            if (frame && instant - numbers < 100) return rows.forEach(follow);
            numbers = instant;
            const words = show();
            if (!frame) say(words);
        };
        frame = requestAnimationFrame(tick);
        show();
    });
    end.addEventListener("click", () => {
        stop();
        go(last());
        say(show());
    });
    reset.addEventListener("click", () => say(begin()));
    still.addEventListener("change", () => {
        stop();
        show();
    });
    for (const button of stage.querySelectorAll("[data-start]")) {
        button.addEventListener("click", () => {
            [body, about, spin, push, step, until].forEach((input, i) => { input.value = STARTS[button.dataset.start][i]; });
            say(begin());
        });
    }
    for (const input of [body, about, spin, push, step, until]) input.addEventListener("input", () => say(begin()));
    // Out of sight it rests.
    const rest = () => {
        if (!frame) return;
        stop();
        show();
    };
    document.addEventListener("visibilitychange", () => document.hidden && rest());
    new IntersectionObserver(([{ isIntersecting }]) => isIntersecting || rest()).observe(stage);
    begin();
});
