// Wrong and right: four bodies, each turned by an engine that the module steps, and its spin over the exact one.
"use strict";

tumblingLive.widget("pitfalls", async (stage, from) => {
    const { load, module, fixed, raised, short, draw, drawing, sayer } = tumblingLive;
    const [engines, motion] = await Promise.all([module("pitfalls"), module("tumble"), load(`${from}live.solids.js`), load(`${from}live.bodies.js`)]);
    const { dot, unit, rows: matrix, through, upright, orbit, model, palette, paper, paint, arrows, dragged } = tumblingLive.bodies;
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
    const NAMES = ["Right", "1 Frozen tensor", "2 Momentum for spin", "3 No gyroscopic term"];
    const [STATE, PIECE, HEAD] = [9, 1000, 24]; // as in pitfalls/src/lib.rs
    const PARTS = 1200; // of a drawing
    const BROKEN = 1e-3; // so great an error, in parts, is seen
    const JOINED = 24; // parts in one piece of an engine's line

    const still = matchMedia("(prefers-reduced-motion: reduce)");
    let start, stepping, length, exact, bundle, steps, frame = 0;

    // A place for each engine: its name, its body, three readouts and its line.
    const READ = [["energy", "energy"], ["angle", "L"], ["flips", "flips"]];
    let view = { turn: 28, eye: upright([1, 0, 0]), solid: null };
    const colours = palette(stage, () => rows.forEach((row) => row.paper.draw()));
    const rows = NAMES.map((name, which) => {
        const place = document.createElement("div");
        place.className = "live-engine";
        place.innerHTML = `<p class="live-title"></p><canvas class="live-drawing live-low" aria-hidden="true"></canvas><dl>${
            READ.map(([what, words]) => `<div><dt class="live-of-${what}">${words}</dt> <dd data-of="${what}"></dd></div>`).join("")}</dl><svg class="live-drawing live-low" aria-hidden="true"></svg>`;
        place.querySelector("p").textContent = name;
        stage.querySelector(".live-engines").append(place);
        const cells = Object.fromEntries(READ.map(([what]) => [what, place.querySelector(`[data-of=${what}]`)]));
        const row = { which, place, cells, title: place.querySelector("p"), side: {} };
        row.paper = paper(place.querySelector("canvas"), (width) => Math.round(Math.min(0.96 * width, 210)), (...it) => turned(row, ...it));
        row.redraw = drawing(place.querySelector("svg"), (width) => Math.max(50, Math.round(Math.min(0.34 * width, 80))),
            (width, height) => path(row, width, height));
        return row;
    });

    /** An engine's body as it stands, its momentum and its spin, as measured on it. */
    function turned(row, pen, width, height, canvas) {
        if (!row.state || !view.solid) return;
        const scale = Math.max(0.5 * Math.min(width, height) - 20, 1);
        const body = paint(pen, colours, view.solid, through(view.eye, matrix(row.state)), [width / 2, height / 2], scale);
        const tip = (v, far) => [far * dot(view.eye[0], v), -far * dot(view.eye[1], v)];
        const list = [];
        const [momentum, spinning] = [unit(row.momentum), unit(row.omega)];
        if (momentum) list.push({ name: "L", tip: tip(momentum, scale), colour: colours.momentum, width: 4 });
        if (spinning) list.push({ name: "ω", tip: tip(spinning, 0.86 * scale), colour: colours.omega, width: 2.6 });
        canvas.shows = { labels: arrows(pen, colours, body, list, row.side), momentum, omega: spinning, body, turn: view.turn }; // for those who test it
    }
    for (const row of rows) {
        // Around only: upward and downward a finger scrolls the page.
        dragged(row.place.querySelector("canvas"), (x) => {
            view.turn += 0.5 * x;
            look();
        });
    }
    function look() {
        view.eye = orbit(upright(rows[0].first.momentum), view.turn, 22);
        for (const row of rows) row.paper.draw();
    }

    /** What an answer on an engine says, by name. */
    function told(row, found) {
        const [energy, size, angle, low, high, flips, first, off, ...vectors] = found.slice(1 + STATE, HEAD);
        [row.omega, row.momentum] = [vectors.slice(0, 3), vectors.slice(3)];
        row.state = found.slice(1, 1 + STATE);
        row.refused = false;
        Object.assign(row, { energy, size, angle, low: Math.min(row.low, low), high: Math.max(row.high, high), off });
        if (flips > 0 && row.flips === 0) row.turned = first;
        row.flips += flips;
        // No more points than can be told apart, but the least and the greatest of those that cannot.
        for (let i = HEAD; i < found.length; i += 1) {
            const value = found[i];
            const bin = row.bins[Math.floor(row.count / bundle)] ??= { least: value, most: value, falls: false };
            if (value <= bin.least) {
                bin.least = value;
                bin.falls = true;
            }
            if (value >= bin.most) {
                bin.most = value;
                bin.falls = false;
            }
            row.tip = value;
            row.count += 1;
        }
    }

    function begin() {
        stop();
        const [w, p] = [SPINS[spin.value], PUSHES[push.value]];
        const [, ...at] = [0, ...motion.answer(7, Number(body.value))];
        if (view.of !== body.value) view = { ...view, of: body.value, solid: model(motion.answer(6, Number(body.value)), Number(body.value), at.slice(3)) };
        start = [...at.slice(0, 3), w, about.value === "z" ? 0 : p, about.value === "y" ? 0 : p];
        stepping = STEPS[step.value];
        length = UNTIL[until.value];
        steps = 0;
        bundle = Math.ceil((last() + 1) / PARTS);
        const answer = motion.answer(5, ...start, length, PARTS);
        const count = answer[0];
        exact = { flips: answer.slice(1, 1 + count), spins: answer.slice(1 + count) };
        exact.most = exact.spins.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
        for (const row of rows) {
            Object.assign(row, { bins: [], count: 0, flips: 0, low: Infinity, high: -Infinity });
            told(row, engines.answer(0, ...start, row.which));
            row.first = { energy: row.energy, off: row.off, momentum: row.momentum };
            row.redraw();
        }
        look();
        const tell = (input, what, value, unit) => {
            shown(what).textContent = `${value} ${unit}`;
            input.setAttribute("aria-valuetext", `${value} ${unit}`);
        };
        tell(spin, "spin", plain(w), "rad/s");
        tell(push, "push", plain(p), "rad/s");
        tell(step, "step", plain(stepping), "s");
        tell(until, "until", plain(length), "s");
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
        row.paper.draw();
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

    /** A share as a change, in per cent: with a sign, and as short as it can be. */
    const change = (ratio) => {
        const percent = 100 * (ratio - 1);
        return `${percent < 0 ? "−" : "+"}${Math.abs(percent) < 1e4 ? fixed(Math.abs(percent), Math.abs(percent) < 0.5 ? 1 : 0) : `10${raised(Math.floor(Math.log10(Math.abs(percent))))}`}`;
    };
    /** How far the energy went, from the least to the greatest that was met. */
    function range(low, high) {
        const [fell, rose] = [1 - low >= BROKEN, high - 1 >= BROKEN];
        if (!fell && !rose) return "kept";
        if (fell && rose) return `${change(low)}/${change(high)} %`;
        return `${change(fell ? low : high)} %`;
    }

    /** What is wrong with the momentum, in a few words: its direction, or where that is right, its length. */
    function momentum({ angle, size }) {
        if (angle >= 0.5) return `${fixed(angle, 0)}° off`;
        if (Math.abs(size - 1) < BROKEN) return `${fixed(angle, 1)}° off`;
        return `${change(size).slice(1)} % too ${size > 1 ? "long" : "short"}`;
    }

    function show(some = rows) {
        const time = now();
        const flipped = exact.flips.filter((t) => t <= time);
        for (const row of rows) {
            const put = (what, text, right) => {
                if (row.cells[what].textContent !== text) row.cells[what].textContent = text;
                row.cells[what].classList.toggle("live-broken", !right);
            };
            const kept = row.angle * Math.PI / 180 < BROKEN && Math.abs(row.size - 1) < BROKEN;
            const energy = range(row.low, row.high);
            put("energy", energy, energy === "kept");
            put("angle", kept ? "kept" : momentum(row), kept);
            put("flips", `${row.flips} of ${flipped.length}`, row.flips === flipped.length);
            const title = NAMES[row.which] + (row.refused ? ": too large for an f64" : "");
            if (row.title.textContent !== title) row.title.textContent = title;
        }
        some.forEach(follow);
        shown("time").textContent = `${fixed(time, 1)} s of ${plain(length)} s`;
        end.disabled = steps >= last();
        const name = frame ? "Pause" : still.matches ? "Step" : "Play";
        if (play.textContent !== name) play.textContent = name;
        play.disabled = steps >= last();
    }
    /** The same, and says it to those who do not see it: only at rest, as the words take long. */
    function report() {
        show();
        say(`After ${fixed(now(), 1)} s. ${rows.map(inWords).join(" ")} Right would be ${exact.flips.filter((t) => t <= now()).length} flips.`);
    }
    function inWords(row) {
        const turned = row.flips > 0 ? `, the first after ${fixed(row.turned, 1)} s` : "";
        return `${NAMES[row.which]}: energy from ${100 + Number(fixed(100 * (row.low - 1), 0).replace("−", "-"))} % to ${
            100 + Number(fixed(100 * (row.high - 1), 0).replace("−", "-"))} %, momentum turned by ${fixed(row.angle, 1)}°, ${row.flips} flips${turned}. Its spin began ${fixed(row.first.off, 1)}° off.`;
    }

    function stop() {
        cancelAnimationFrame(frame);
        frame = 0;
    }

    play.addEventListener("click", () => {
        if (frame) {
            stop();
            report();
            return;
        }
        if (still.matches) {
            go(Math.min(last(), steps + Math.ceil(last() / 10)));
            report();
            return;
        }
        // Time passes as it does for the reader, but never by leaps.
        let before = null; // the first frame begins it
        let time = now();
        let numbers = -Infinity; // when they were last shown
        let [late, share] = [0, 0]; // of the last frames, and which half of the pictures is drawn where most came late
        const tick = (instant) => {
            late = 0.9 * late + 0.1 * (instant - before > 22);
            time = Math.min(length, time + Math.min(0.1, (instant - (before ?? instant)) / 1000));
            before = instant;
            go(Math.min(last(), Math.floor(time / stepping + 1e-9)));
            frame = steps < last() ? requestAnimationFrame(tick) : 0;
            // Nobody reads numbers that change with every frame, and each would have the page laid out anew.
            share = 1 - share;
            const some = late < 0.5 ? rows : rows.filter((row) => row.which % 2 === share);
            if (frame && instant - numbers < 100) return some.forEach(follow);
            numbers = instant;
            if (frame) show(some);
            else report();
        };
        frame = requestAnimationFrame(tick);
        show();
    });
    end.addEventListener("click", () => {
        stop();
        go(last());
        report();
    });
    function restart() {
        begin();
        report();
    }
    reset.addEventListener("click", restart);
    still.addEventListener("change", () => {
        stop();
        show();
    });
    for (const button of stage.querySelectorAll("[data-start]")) {
        button.addEventListener("click", () => {
            [body, about, spin, push, step, until].forEach((input, i) => { input.value = STARTS[button.dataset.start][i]; });
            restart();
        });
    }
    for (const input of [body, about, spin, push, step, until]) input.addEventListener("input", restart);
    // Out of sight it rests.
    const rest = () => {
        if (!frame) return;
        stop();
        show();
    };
    document.addEventListener("visibilitychange", () => document.hidden && rest());
    new IntersectionObserver(([{ isIntersecting }]) => isIntersecting || rest()).observe(stage);
    begin();
    show();
});
