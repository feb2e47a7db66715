// A top on its point: the path of its axis by the closed form, and over it the same in steps; with drag, in steps alone.
"use strict";

tumblingLive.widget("top", async (stage, from) => {
    const { load, module, fixed, sayer } = tumblingLive;
    const [top] = await Promise.all([module("top"), load(`${from}live.bodies.js`), load(`${from}top.drum.js`)]);
    const { dot, rows, through, upright, orbit, palette, paper, path, paint, clock, dragged } = tumblingLive.bodies;
    const control = (id) => stage.querySelector(`#top-${id}`);
    const [play, scrub, pace, step, drag, spin, lean, push] = ["play", "scrub", "pace", "step", "drag", "spin", "lean", "push"].map(control);
    const [pictures, places] = ["draws", "shows"].map((what) => Object.fromEntries(Array.from(stage.querySelectorAll(`[data-${what}]`), (it) => [it.dataset[what], it])));
    const [canvas, shown] = [pictures, places].map((all) => (what) => all[what]);
    /** What is set is laid out and styled anew, even where it was the same. */
    const texts = {};
    const put = (what, text) => texts[what] !== text && (shown(what).textContent = texts[what] = text);
    const choices = [...stage.querySelectorAll("[data-start]")];
    const wrong = stage.querySelector(".live-wrong");
    const say = sayer(stage);

    /** What the buttons set: spin, lean, push (NaN: the steady rate), whether there is drag; and the speed at which it is best seen. */
    const STARTS = {
        "let-go": [200, 30, 0, false, 0.1],
        steady: [200, 30, NaN, false, 0.1],
        on: [200, 30, 3, false, 0.1],
        back: [200, 30, -6, false, 0.1],
        asleep: [140, 1, 0, true, 1],
    };
    const KINDS = [
        "is free", "stands upright, asleep: a slip stays small", "stands upright, but a slip would grow", "hangs down", "goes round steadily, at one lean",
        "draws waves: it always goes round the same way", "draws cusps: it stands still where it is highest", "draws loops: it goes back where it is highest",
        "swings as a pendulum’s, without spin", "rises toward upright and falls back",
    ];
    const [FINE, ROUGH] = [0.004, 0.0075]; // s from one sample to the next; the second while a slider moves
    const [PIECE, INSTANTS] = [800, 1000]; // as in top/src/lib.rs
    const TRAIL = 3; // s of the path that are drawn
    const [ASTRAY, UPRIGHT, UNTIL, UNTIL_DRAGGED] = [5, 10, 1.5, 16]; // degrees; s
    const DEGREES = 180 / Math.PI;
    const ROUND = Array.from({ length: 73 }, (_, i) => [Math.cos(Math.PI * i / 36), Math.sin(Math.PI * i / 36)]);

    const state = { t: 0, turn: 20, tilt: 28, steady: false, facts: null, exact: [], stepped: [], fine: FINE, each: FINE, told: 0, curved: true, solid: null };
    const given = () => [Number(spin.value), Number(lean.value), state.steady ? NaN : Number(push.value)];
    const until = () => (drag.checked ? UNTIL_DRAGGED : UNTIL);
    /** Where a start is shown first: with the whole of its path, or while it may still sleep. */
    const whole = () => (drag.checked ? 0.5 : UNTIL);
    /** The axis of an attitude, and how far it leans, degrees. */
    const axisOf = (q, at = 0) => {
        const [w, x, y, z] = [q[at], q[at + 1], q[at + 2], q[at + 3]];
        return [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
    };
    /** Whether two axes are less than ASTRAY apart: no root for each of the hundreds that are compared. */
    const near = ([x, y, z], [u, v, w]) => (x - u) ** 2 + (y - v) ** 2 + (z - w) ** 2 < (2 * Math.sin(ASTRAY / 2 / DEGREES)) ** 2;
    const leanOf = ([x, y, z]) => DEGREES * Math.atan2(Math.sqrt(x * x + y * y), z);
    const between = (a, b) => DEGREES * 2 * Math.asin(Math.min(1, 0.5 * Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])));

    // ---- What the module answers.
    /** The stepped motion, from its start to the end or as far as it goes: attitudes, the spin after each. */
    function run() {
        const h = Number(step.value) / 1000;
        const each = Math.max(1, Math.round(state.fine / h));
        // While a slider moves, with drag, no further than is shown.
        const end = state.fine > FINE && drag.checked ? state.t : until();
        const count = Math.floor(end / (each * h) + 1e-9);
        let now = top.answer(2, ...given());
        const samples = [[...now.slice(0, 4), given()[0]]];
        while (samples.length <= count) {
            const asked = Math.min(PIECE, count + 1 - samples.length);
            const found = top.answer(3, Number(drag.checked), h, each, asked, ...now);
            for (let k = 8; k < 8 + 5 * found[0]; k += 5) samples.push([found[k], found[k + 1], found[k + 2], found[k + 3], found[k + 4]]);
            now = found.slice(1, 8);
            if (found[0] < asked) break;
        }
        [state.stepped, state.each] = [samples, each * h];
        state.axes = samples.map((sample) => axisOf(sample));
    }
    /** The closed form, at the same instants as the finest samples. */
    function closed() {
        const { fine } = state;
        const count = Math.round(UNTIL / fine);
        state.exact = [];
        for (let i = 0; i <= count; i += INSTANTS) {
            const last = Math.min(i + INSTANTS - 1, count);
            const found = top.answer(1, ...given(), i * fine, last * fine, last - i + 1);
            for (let k = 0; k + 3 < found.length; k += 4) state.exact.push(axisOf(found, k));
        }
    }
    const exactAt = (t) => top.answer(1, ...given(), t, t, 1);
    /** The attitude that was stepped last before an instant; between fine steps, the one between its neighbours. */
    function steppedAt(t) {
        const place = Math.min(t / state.each, state.stepped.length - 1);
        const i = Math.floor(place + 1e-9);
        const [a, b] = [state.stepped[i], state.stepped[Math.min(i + 1, state.stepped.length - 1)]];
        if (Number(step.value) / 1000 > FINE) return a;
        const sign = Math.sign(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]) || 1;
        const part = Math.max(0, place - i);
        const q = [0, 1, 2, 3].map((k) => (1 - part) * a[k] + part * sign * b[k]);
        const size = Math.hypot(...q);
        return [...q.map((x) => x / size), a[4]];
    }

    // ---- The top, and the path of its axis on a sphere around its point.
    const colours = palette(stage, () => again());
    const ink = () => (state.astray ? colours.wrong : colours["axis-min"]);
    const body = paper(canvas("body"), (width) => Math.round(Math.min(0.95 * width, 340)), (pen, width, height) => {
        if (!state.facts) return;
        const { facts: { leans }, t } = state;
        const low = drag.checked || leans[1] > 80; // it needs the room below its point too
        const eye = orbit(upright([0, 0, 1]), state.turn, state.tilt);
        const scale = Math.max(Math.min((low ? 0.5 : 0.76) * height, 0.5 * width / (low ? 1 : 0.8)) - 12, 1);
        const [cx, cy] = [width / 2, low ? height / 2 : height - 0.16 * height];
        const at = (p) => [cx + scale * dot(eye[0], p), cy - scale * dot(eye[1], p)];
        const now = Math.min(Math.floor(t / state.each + 1e-9), state.axes.length - 1);
        const trail = state.axes.slice(Math.max(0, now - Math.round(TRAIL / state.each)), now + 1);
        const over = (points, colour, wide, dim, dashes = [], lean = null) =>
            ({ ...tumblingLive.overSphere(eye, [cx, cy], scale, points, lean), colour, wide, dim, dashes });
        // What keeps still while it plays.
        const key = [state.turn, state.tilt, width, height, colours.fg, colours.faint, drag.checked].join();
        if (state.still?.key !== key || state.still.exact !== state.exact) {
            const all = drag.checked ? [] : [...leans.map((angle) => over(ROUND, colours.fg, 1, 0.8, [5, 4], angle / DEGREES)), over(state.exact, colours.faint, 6, 0.55)];
            state.still = { key, exact: state.exact, all };
        }
        const drawn = [...state.still.all];
        // While a slider moves the path is the closed form's own.
        if (state.axes === state.exact && trail.length === state.exact.length) drawn.push({ ...drawn.at(-1), colour: ink(), wide: 1.8, dim: 1 });
        else drawn.push(over(trail, ink(), 1.8, 1));
        const lines = (side) => {
            pen.lineJoin = "round";
            for (const { [side]: line, colour, wide, dim, dashes } of drawn) {
                [pen.strokeStyle, pen.lineWidth, pen.globalAlpha] = [colour, wide, (side === "front" ? 1 : 0.4) * dim];
                pen.setLineDash(dashes);
                pen.stroke(line);
            }
            pen.setLineDash([]);
            pen.globalAlpha = 1;
        };
        // The stand, below the point.
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 3;
        path(pen, [[cx, cy + 3], [cx, height]]);
        pen.stroke();
        lines("behind");
        const q = drag.checked ? steppedAt(t) : exactAt(t);
        // The top is inside the sphere: what is on this side of it is nearer.
        const painted = paint(pen, colours, state.solid, through(eye, rows(q)), [cx, cy], scale);
        lines("front");
        canvas("body").shows = { body: painted, turn: state.turn, tilt: state.tilt, trail, exact: state.exact }; // for those who test it
        pen.fillStyle = ink();
        pen.beginPath();
        pen.arc(...at(state.axes[now]), 4.5, 0, 2 * Math.PI);
        pen.fill();
    });

    // ---- The lean over time.
    const EDGE = 8; // half a slider's thumb
    const cursor = stage.querySelector(".tumble-cursor");
    const across = (t, width, end = until()) => 44 + (t / end) * (width - 44 - EDGE);
    const curve = paper(canvas("lean"), (width) => Math.round(Math.min(0.62 * width, 260)), (pen, width, height) => {
        // The browser moves it without painting.
        cursor.style.height = `${height - 28}px`;
        cursor.style.transform = `translateX(${across(state.t, width).toFixed(1)}px)`;
    }, (pen, width, height) => {
        if (!state.facts) return;
        const stepped = state.axes.map(leanOf);
        const exact = drag.checked ? [] : state.axes === state.exact ? stepped : state.exact.map(leanOf);
        let [least, most] = [180, 0];
        for (const angle of exact === stepped ? stepped : [...exact, ...stepped]) [least, most] = [Math.min(least, angle), Math.max(most, angle)];
        const room = Math.max(0.08 * (most - least), 0.5);
        const [low, high] = [Math.max(0, least - room), most + room];
        const y = (angle) => 8 + (height - 32) * (angle - low) / (high - low); // down, as the axis sinks
        const write = (...it) => tumblingLive.word(pen, colours.stamps, it.shift(), colours.font, colours.fg, ...it);
        const by = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60].find((by) => (high - low) / by <= 6) ?? 60;
        [pen.strokeStyle, pen.lineWidth] = [colours.faint, 1];
        for (let angle = Math.ceil(low / by) * by; angle <= high; angle += by) {
            path(pen, [[44, y(angle)], [width - EDGE, y(angle)]]);
            pen.globalAlpha = 0.5;
            pen.stroke();
            pen.globalAlpha = 1;
            write(`${fixed(angle, by < 1 ? 1 : 0)}°`, [40, y(angle)], -1);
        }
        for (let t = 0; t <= until(); t += drag.checked ? 4 : 0.5) write(`${t} s`, [across(t, width), height - 10], t === until() ? -1 : 0);
        const end = until();
        const line = (leans, each) => {
            const it = new Path2D();
            const [from, by] = [across(0, width, end), across(each, width, end) - across(0, width, end)];
            for (let i = 0; i < leans.length; i += 1) it.lineTo(from + i * by, y(leans[i]));
            return it;
        };
        const draw = (line, colour, wide, dim) => {
            [pen.strokeStyle, pen.lineWidth, pen.globalAlpha, pen.lineJoin] = [colour, wide, dim, "round"];
            pen.stroke(line);
            pen.globalAlpha = 1;
        };
        const right = line(exact, state.fine);
        draw(right, colours.faint, 6, 0.55);
        draw(exact === stepped ? right : line(stepped, state.each), ink(), 1.8, 1);
        if (drag.checked && state.wakes > 0) {
            pen.strokeStyle = colours.separatrix;
            pen.setLineDash([4, 3]);
            path(pen, [[across(state.wakes, width), 8], [across(state.wakes, width), height - 24]]);
            pen.stroke();
            pen.setLineDash([]);
            tumblingLive.word(pen, colours.stamps, "critical spin", colours.font, colours.separatrix, [across(state.wakes, width) + 6, height - 37], 1);
        }
    });
    function again() {
        body.draw();
        curve.prepare();
        curve.draw();
    }

    // ---- What is shown.
    /** Prepares the motion of what the controls are set to; says what it is. */
    function begin() {
        const found = top.answer(0, ...given());
        const why = found ? null : `${top.words()}.${state.facts ? " The drawings are of the last start that was right." : ""}`;
        wrong.hidden = why === null;
        if (wrong.textContent !== (why ?? "")) wrong.textContent = why ?? "";
        for (const { classList } of [pictures.body, pictures.lean]) classList.toggle("live-dim", why !== null);
        caption(found);
        if (!found) {
            pause();
            state.facts = null;
            for (const what of ["kind", "leans", "nods", "round", "critical", "now"]) put(what, "none");
            return wrong.textContent;
        }
        const [kind, least, greatest, period, round, , critical, ...shape] = found;
        state.facts = { kind, leans: [least, greatest], critical };
        state.solid ??= tumblingLive.drum(shape);
        closed();
        // While a slider moves, steps too short to be told from the closed form in the picture are not taken.
        if (state.fine > FINE && !drag.checked && spin.value * step.value <= 200) [state.axes, state.each] = [state.exact, state.fine];
        else run();
        const wakes = state.stepped.findIndex((sample) => sample[4] < critical);
        state.wakes = wakes < 0 ? NaN : wakes * state.each;
        state.astray = !drag.checked && (state.axes.length * state.each < UNTIL
            || state.axes !== state.exact && state.axes.some((axis, i) => !near(axis, state.exact[Math.min(Math.round(i * state.each / state.fine), state.exact.length - 1)])));
        if (shown("closed").hidden !== drag.checked) shown("closed").hidden = drag.checked;
        shown("stepped").classList.toggle("live-key-wrong", state.astray);
        shown("stepped").classList.toggle("live-key-stepped", !state.astray);
        put("stepped", drag.checked ? "stepped: with drag there is no closed form" : state.astray ? "stepped, astray" : "stepped");
        const angle = (x) => `${fixed(x, 1)}°`;
        const asleep = kind > 3 && greatest < UPRIGHT && Number(spin.value) >= critical;
        put("kind", !drag.checked ? (asleep ? "is asleep, and " : "") + KINDS[kind] : Number(lean.value) > UPRIGHT ? "sinks, as the drag takes the spin"
            : Number(spin.value) < critical ? "sways: the spin is below the critical one" : "stands asleep, until the spin is below the critical one");
        put("leans", greatest - least < 0.05 ? angle(greatest) : `${angle(least)} to ${angle(greatest)}`);
        put("nods", Number.isNaN(period) || kind === 4 ? "never" : `every ${fixed(period, 3)} s`);
        put("round", `${fixed(round, 2)} rad/s`);
        for (const what of ["leans", "nods", "round"]) shown(what).parentElement.hidden = drag.checked; // they do not stay
        put("critical", `${fixed(critical, 0)} rad/s`);
        if (Number(scrub.max) !== until()) scrub.max = until();
        state.curved = state.fine === FINE || (!state.curved && !drag.checked);
        if (state.curved) curve.prepare();
        return at(Math.min(state.t, until()));
    }
    /** The numbers beside the sliders, and which button they are as. */
    function caption(found) {
        const tell = (input, what, text) => {
            if (put(what, text)) input.setAttribute("aria-valuetext", text);
        };
        if (state.steady && found) push.value = found[5];
        tell(spin, "spin", `${spin.value} rad/s`);
        tell(lean, "lean", `${lean.value}°`);
        tell(push, "push", state.steady ? (found ? `${fixed(found[5], 2)} rad/s, the steady rate` : "no steady rate") : Number(push.value) === 0 ? "not at all" : `${fixed(Number(push.value), 1)} rad/s`);
        const now = [...given(), drag.checked];
        for (const button of choices) {
            const set = STARTS[button.dataset.start];
            const same = String(now.every((x, i) => Object.is(x, set[i]) || x === set[i]));
            if (button.getAttribute("aria-pressed") !== same) button.setAttribute("aria-pressed", same);
        }
    }
    /** Shows an instant; returns it in words. */
    function at(t) {
        if (!state.facts) return wrong.textContent;
        [state.t, scrub.value] = [t, t];
        if (!state.late || !state.curved) body.draw();
        curve.draw();
        const now = performance.now();
        if (state.fine > FINE || (clocked.playing() && now - state.told < 100)) return "";
        state.told = now;
        const sample = steppedAt(t);
        const stopped = t > state.axes.length * state.each;
        const lasting = drag.checked ? axisOf(sample) : axisOf(exactAt(t));
        const off = between(axisOf(sample), lasting);
        const angle = (x) => (x < 0.01 ? "less than 0.01°" : `${fixed(x, x < 1 ? 2 : 0)}°`);
        const words = drag.checked
            ? `leans by ${fixed(leanOf(lasting), 1)}°, spins at ${fixed(sample[4], 0)} rad/s`
            : `leans by ${fixed(leanOf(lasting), 1)}°; the stepped axis is ${stopped ? "lost: its numbers have grown too large" : `off by ${angle(off)}`}`;
        put("now", words);
        scrub.setAttribute("aria-valuetext", `${fixed(t, 2)} s, ${words}`);
        return `Its axis ${shown("kind").textContent}. After ${fixed(t, 2)} s it ${words}.`;
    }
    const clocked = clock(stage, play, {
        step: 0.5,
        go(seconds) {
            if (!state.facts) return false;
            at((state.t + Number(pace.value) * seconds) % until());
            return true;
        },
        rested() {
            state.told = 0;
            coarsen(1);
            at(state.t);
        },
        // Where half of the frames come late, the top is drawn coarser while it moves.
        late: () => body.coarse > 0.5 && coarsen(body.coarse * 0.7),
        pressed: () => say(at(state.t)),
    });
    const pause = () => clocked.pause();
    function coarsen(to) {
        if (body.coarse === to) return;
        body.coarse = to;
        body.measure();
    }

    // ---- The address keeps a start.
    const MARK = "#top?";
    let later = 0;
    function keep() {
        clearTimeout(later);
        // Browsers count how often an address changes.
        later = setTimeout(() => {
            const said = { spin: spin.value, lean: lean.value, push: state.steady ? "steady" : push.value, drag: Number(drag.checked), step: step.value };
            history.replaceState(null, "", MARK + new URLSearchParams(said));
        }, 400);
    }
    function fromAddress() {
        if (!location.hash.startsWith(MARK)) return;
        const said = new URLSearchParams(location.hash.slice(MARK.length));
        for (const [name, field] of Object.entries({ spin, lean, push })) {
            if (said.get(name) && Number.isFinite(Number(said.get(name)))) field.value = said.get(name);
        }
        if ([...step.options].some(({ value }) => value === said.get("step"))) step.value = said.get("step");
        state.steady = said.get("push") === "steady";
        drag.checked = said.get("drag") === "1";
    }

    let [moved, resting] = [-Infinity, 0];
    function fully() {
        clearTimeout(resting);
        resting = 0;
        state.fine = FINE;
        coarsen(1);
        say(begin());
    }
    function change() {
        fully();
        keep();
    }
    /** While a slider moves on there are fewer samples, drawn coarser, and the curve has each second frame, alone where they come late; where it rests all of them. */
    function slid() {
        if (performance.now() - moved < 250) {
            resting ||= setTimeout(rest, 260); // one for all the moves
            state.fine = ROUGH;
            coarsen(0.5);
            state.late = performance.now() - moved > 22;
            begin();
            state.late = false;
        } else change();
        moved = performance.now(); // what it took is no rest
    }
    function rest() {
        const left = moved + 260 - performance.now();
        if (left > 0) resting = setTimeout(rest, left);
        else change();
    }
    step.addEventListener("input", change);
    push.addEventListener("input", () => { state.steady = false; });
    for (const field of [spin, lean, push]) field.addEventListener("input", slid);
    drag.addEventListener("input", () => {
        state.t = whole();
        change();
    });
    for (const button of choices) {
        button.addEventListener("click", () => {
            pause();
            let pushed;
            [spin.value, lean.value, pushed, drag.checked, pace.value] = STARTS[button.dataset.start];
            state.steady = Number.isNaN(pushed);
            if (!state.steady) push.value = pushed;
            state.t = whole();
            change();
        });
    }
    scrub.addEventListener("input", () => {
        const t = Number(scrub.value); // `fully` sets it
        pause();
        if (state.fine > FINE) fully();
        say(at(t));
    });
    dragged(canvas("body"), (right, down) => {
        state.turn += 0.5 * right;
        state.tilt = Math.max(-80, Math.min(80, state.tilt + 0.5 * down));
        body.draw();
    });
    function arrive() {
        fromAddress();
        state.t = whole();
        begin();
    }
    addEventListener("hashchange", arrive);
    arrive();
});
