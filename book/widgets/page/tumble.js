// The tumble: a body spun about one of its axes, with a slip; the module says where it is at any instant.
"use strict";

tumblingLive.widget("tumble", async (stage, from) => {
    const { load, module, fixed, short, sayer } = tumblingLive;
    const [exact] = await Promise.all([module("tumble"), load(`${from}live.solids.js`), load(`${from}live.bodies.js`), load(`${from}tumble.polhode.js`)]);
    const { dot, unit, rows, through, upright, orbit, model, palette, paper, path, paint, arrows, clock, dragged } = tumblingLive.bodies;
    const control = (id) => stage.querySelector(`#tumble-${id}`);
    const [scrub, play, reset, time, speed, body, about] = ["scrub", "play", "reset", "time", "speed", "body", "about"].map(control);
    const [spin, spinNumber, push, pushNumber] = ["spin", "spin-number", "push", "push-number"].map(control);
    const [turn, tilt, ride, rolling] = ["turn", "tilt", "ride", "rolling"].map(control);
    const own = ["a", "b", "c"].map(control);
    const ownFields = stage.querySelector("fieldset");
    const wrong = stage.querySelector(".live-wrong");
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);

    let again = () => {}; // draws all anew
    const colours = palette(stage, () => again());
    const papers = [];
    /** A drawing as high as `shape` says for so wide a widget. */
    const sheet = (what, shape, moving, still) => {
        const it = paper(stage.querySelector(`[data-draws=${what}]`), () => shape(stage.querySelector(".tumble-drawings").clientWidth),
            (...all) => state.now && state.setting && moving(...all), still && ((...all) => state.now && state.setting && still(...all)));
        papers.push(it);
        return it;
    };
    /** Sets a style of an element, unless it is so already. */
    const place = (element, what, value) => {
        if (element.style[what] !== value) element.style[what] = value;
    };

    // ---- The body, in the world: momentum up, the reader before it and at first a little above.
    const state = { t: 0, now: null, setting: null, window: null, drawn: 0, flick: null };
    /** The reader's axes in the world: the momentum upright, or after a flick as they were, and from there around and above. */
    function looking(momentum) {
        const { base, turn: turned, tilt: tilted } = state.flick?.from ?? { base: upright(momentum), turn: 0, tilt: 0 };
        return orbit(base, Number(turn.value) - turned, Number(tilt.value) - tilted);
    }
    /** The reader's right, up and toward: in the body's axes, and in the world's. From the room the world keeps still, ridden on the body does. */
    function seen() {
        const { setting: { eye }, now: { attitude } } = state;
        const world = rows(attitude);
        if (ride.value === "room") return { body: through(eye, world), world: eye };
        const back = [0, 1, 2].map((i) => [0, 1, 2].map((j) => world[j][i]));
        return { body: eye, world: through(eye, back) };
    }
    const LABEL = 24; // px around the body for what names the arrows
    const sides = {};
    const square = (wide) => Math.round(wide < 480 ? 0.7 * wide : Math.min(0.5 * wide, 340));
    const solid = sheet("body", square, (pen, width, height, canvas) => {
        const { setting, now } = state;
        const { body, world } = seen();
        const scale = Math.max(0.5 * Math.min(width, height) - LABEL, 1);
        const painted = paint(pen, colours, setting.solid, body, [width / 2, height / 2], scale);
        const tip = (v, far) => [far * dot(world[0], v), -far * dot(world[1], v)];
        const list = [];
        if (setting.up) list.push({ name: "L", tip: tip(setting.up, scale), colour: colours.momentum, width: 5 });
        const spinning = unit(now.world);
        if (spinning) list.push({ name: "ω", tip: tip(spinning, 0.86 * scale), colour: colours.omega, width: 3 });
        canvas.shows = { labels: arrows(pen, colours, painted, list, sides), body: painted }; // for those who test it
    });

    // ---- The ellipsoid of energy, as the body lies, with its polhodes; or rolling on its plane.
    sheet("polhode", square,
        tumblingLive.tumblePolhode({ state, seen, colours, place, rolling, spot: stage.querySelector(".tumble-dot") }));

    // ---- The spin along the axis that it was spun about over time, and the flips predicted.
    const cursor = stage.querySelector(".tumble-cursor");
    const EDGE = 8; // half a slider's thumb: the slider below has the same scale
    const strip = sheet("strip", (wide) => Math.round(Math.min(Math.max(0.15 * wide, 84), 110)), (pen, width, height) => {
        const { from, to } = state.window;
        const x = EDGE + ((state.t - from) / (to - from)) * (width - 2 * EDGE);
        place(cursor, "height", `${height - 22}px`);
        place(cursor, "transform", `translateX(${x.toFixed(1)}px)`);
    }, (pen, width, height) => {
        const { window: { from, to, flips, samples }, setting } = state;
        const [top, bottom] = [8, height - 20];
        const across = (t) => EDGE + ((t - from) / (to - from)) * (width - 2 * EDGE);
        const level = (top + bottom) / 2;
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 1;
        path(pen, [[EDGE, level], [width - EDGE, level]]);
        pen.stroke();
        pen.font = colours.font;
        pen.textAlign = "center";
        let free = -Infinity;
        for (const flip of flips) {
            const x = across(flip);
            pen.strokeStyle = pen.fillStyle = colours.separatrix;
            pen.setLineDash([4, 3]);
            path(pen, [[x, top], [x, bottom]]);
            pen.stroke();
            pen.setLineDash([]);
            const text = `${setting.instant(flip)} s`;
            const half = pen.measureText(text).width / 2;
            if (x - half < free || x - half < 0 || x + half > width) continue;
            pen.fillText(text, x, height - 4);
            free = x + half + 8;
        }
        const greatest = Math.max(...samples.map(Math.abs)) || 1;
        path(pen, samples.map((x, i) => [EDGE + (i / (samples.length - 1)) * (width - 2 * EDGE), level - (x / greatest) * (bottom - top) * 0.46]));
        pen.strokeStyle = colours[spun().colour];
        pen.lineWidth = 2;
        pen.stroke();
    });

    // ---- What the module says.
    const list = (numbers, size) => Array.from({ length: numbers.length / size }, (_, i) => Array.from(numbers.slice(size * i, size * (i + 1))));
    /** What is wrong, in the module's words if there are no others. */
    function complain(said) {
        wrong.textContent = said ?? `${exact.words()}.`;
        wrong.hidden = false;
        pause();
        return wrong.textContent;
    }
    const number = (field) => (field.value.trim() === "" ? NaN : Number(field.value));

    const missing = (what) => `The field for the ${what} has no number in it: type a finite one.`;

    /** Of each axis to spin about: which of x, y, z it is, where the slip goes, its colour, and its name. */
    const SPUN = [
        { along: 0, across: 1, colour: "axis-mid", axis: "the middle axis" },
        { along: 2, across: 0, colour: "axis-min", axis: "the axis of the smallest moment" },
        { along: 1, across: 0, colour: "axis-max", axis: "the axis of the largest moment" },
    ];

    /** The one that the body is spun about now. */
    const spun = () => SPUN.find(({ along }) => along === state.setting?.along) ?? SPUN[0];

    /** Prepares the motion of what the controls are set to, from its start. */
    function prepare() {
        const of = Number(body.value);
        ownFields.hidden = of < 8;
        ownFields.querySelector("legend").textContent = of === 9 ? "Moments, kg m²" : "Edges, m";
        const given = of < 8 ? [0, 0, 0] : own.map(number);
        const empty = [["spin", spinNumber], ["slip", pushNumber], ...["first", "second", "third"].map((name, i) => [`${name} ${of === 9 ? "moment" : "edge"}`, own[i]])]
            .slice(0, of < 8 ? 2 : 5).find(([, field]) => Number.isNaN(number(field)));
        const found = empty ? null : exact.answer(0, of, number(spinNumber), number(pushNumber), state.flick ? 3 : Number(about.value), ...given, ...(state.flick?.omega ?? [0, 0, 0]));
        if (!found) {
            state.setting = null;
            for (const what of ["beat", "next", "time", "flips", "spin"]) shown(what).textContent = "none";
            complain(empty && missing(empty[0]));
            return;
        }
        wrong.hidden = true;
        const [beat, a, b, c, x, y, z, lx, ly, lz, around, depth, onto, ...rest] = found;
        const [omega, along] = [rest.slice(0, 3), rest[3]];
        const moments = [a, b, c];
        const polhode = (axis, value, points = 72) => exact.answer(3, axis, value, points);
        const between = (part, from, to) => from + part * (to - from);
        const decimals = beat < 0.05 ? Math.min(12, 1 - Math.floor(Math.log10(beat))) : 2;
        const instant = (t) => (Math.abs(t) < 1e12 && (t === 0 || Math.abs(t) >= 10 ** -decimals) ? fixed(t, decimals) : short(t));
        const path = around < 3 ? polhode(around, depth, 240) : null;
        const side = omega[around] < 0 ? -1 : 1;
        const turns = (20 * Math.PI) / Math.hypot(...omega);
        const stretch = 6 * beat;
        const key = [of, ...given].join();
        if (state.body !== key) [state.body, state.solid] = [key, model(exact.answer(6, of, ...given), of, [x, y, z])];
        state.setting = {
            solid: state.solid, moments, onto, beat, instant, along,
            deep: onto * dot([lx, ly, lz], omega) / Math.hypot(lx, ly, lz), // how far below the middle the plane lies
            wide: 0,
            up: unit([lx, ly, lz]),
            momentum: [lx, ly, lz],
            eye: looking([lx, ly, lz]),
            others: [0.25, 0.65].flatMap((part) => [polhode(1, between(part, b, a)), polhode(2, between(part, c, a))]),
            between: [polhode(1, a, 120)],
            own: path?.map((value) => side * value) ?? null,
            stretch: stretch > 0 && stretch < 1e300 ? stretch : turns > 0 && turns < 1e300 ? turns : 10,
        };
        state.window = null;
        shown("beat").textContent = Number.isNaN(beat) ? "none: it never flips" : `${spanned(beat)} s`;
        go(0);
        redraw();
    }
    const spanned = (beat) => (beat >= 100 && beat < 1e12 ? fixed(beat, 0) : state.setting.instant(beat));

    /** Shows the instant `t`; says whether there is one. */
    function go(t) {
        if (!state.setting) return false;
        const found = Number.isNaN(t) ? null : exact.answer(1, t);
        if (!found) {
            complain(Number.isNaN(t) ? missing("time") : undefined);
            return false;
        }
        const { stretch, instant } = state.setting;
        if (!state.window || t < state.window.from || t > state.window.to) {
            const from = Math.floor(t / stretch) * stretch;
            const to = from + stretch;
            const part = exact.answer(2, from, to, 480);
            if (!part || !(to > from) || t > to) {
                complain();
                return false;
            }
            const count = part[0];
            state.window = { from, to, flips: Array.from(part.slice(1, 1 + count)), samples: Array.from(part.slice(1 + count)) };
            const { setting } = state;
            state.window.track = list(exact.answer(9, from, to, 600), 6).map((all) => all.slice(3).map((x) => -x * setting.onto));
            setting.wide = 1.1 * Math.max(...state.window.track.map((p) => Math.hypot(...p.map((x, k) => x + setting.deep * (setting.up?.[k] ?? 0)))), 0.9);
            [scrub.min, scrub.max] = [from, to];
            strip.prepare();
        }
        wrong.hidden = true;
        state.t = t;
        const [x, y, z, qw, qx, qy, qz, wx, wy, wz, flips, ...next] = found;
        state.now = { omega: [x, y, z], attitude: [qw, qx, qy, qz], world: [wx, wy, wz] };
        if (state.flips !== flips && clocked.playing()) say(t < 0 ? `A flip at ${instant(t)} s.` : `Flip ${flips} at ${instant(t)} s.`);
        [state.flips, state.next] = [flips, next];
        // Nobody reads numbers that change with every frame, and each would have the page laid out anew.
        const now = performance.now();
        if (!clocked.playing() || !(now - state.told < 100)) {
            state.told = now;
            tell();
        }
        state.drawn += 1;
        for (const it of papers) if (it === solid || solid.coarse === 1 || state.drawn % 3 === 0) it.draw();
        return true;
    }
    /** How the parts of a spin are written: with two decimals, where these tell of it. */
    const speeds = (omega) => {
        const most = Math.max(...omega.map(Math.abs));
        return (w) => (most === 0 || (most >= 0.1 && Math.abs(w) < 1e4) ? fixed(w, 2) : short(w));
    };
    const count = () => `${state.flips} ${state.flips === 1 ? "flip" : "flips"} ${state.t < 0 ? "from here to the start" : "so far"}`;
    /** The numbers of the instant, in the page. */
    function tell() {
        const { t, flips, next, now, setting: { instant } } = state;
        const coming = next.filter((flip) => !Number.isNaN(flip));
        shown("time").textContent = `${instant(t)} s`;
        shown("flips").textContent = t < 0 && flips > 0 ? `none: ${flips} from here to the start` : String(flips);
        shown("next").textContent = coming.length > 0 ? `${coming.map(instant).join(", ")} s` : "none: it never flips";
        shown("spin").textContent = now.omega.map(speeds(now.omega)).join(", ");
        scrub.value = t;
        scrub.setAttribute("aria-valuetext", `${instant(t)} s, ${count()}`);
    }
    const told = () => {
        if (!state.setting || !wrong.hidden) return ""; // what is wrong is said by itself
        return `At ${shown("time").textContent} ${state.t < 0 ? `it has ${count()}` : `it has flipped ${state.flips} times`}; along ${spun().axis} it spins at ${speeds(state.now.omega)(state.now.omega[spun().along])} rad/s. `
            + `Time between flips: ${shown("beat").textContent}. Next flips at: ${shown("next").textContent}.`;
    };

    // ---- Time.
    const rate = () => 10 ** Number(speed.value);
    const clocked = clock(stage, play, {
        step: 0.1,
        go: (seconds) => state.setting !== null && go(state.t + seconds * rate()),
        rested() {
            if (state.setting) tell();
            coarsen(1);
        },
        // Where half of the frames come late, the body is drawn coarser while it moves, and the rest less often.
        late: () => solid.coarse > 0.5 && coarsen(solid.coarse * 0.7),
        pressed: () => say(told()),
    });
    const pause = clocked.pause;
    function coarsen(to) {
        if (solid.coarse === to) return;
        solid.coarse = to;
        solid.measure();
        for (const it of papers) it.draw();
    }
    reset.addEventListener("click", () => {
        pause();
        go(0);
        say(told());
    });
    scrub.addEventListener("input", () => {
        pause();
        go(Number(scrub.value));
        say(told());
    });
    time.addEventListener("change", () => {
        pause();
        go(number(time));
        say(told());
    });

    // ---- The controls; a slider and the number beside it are one.
    function caption() {
        const times = Number(rate().toPrecision(2));
        shown("speed").textContent = times === 1 ? "as in life" : `${times} × life`;
        speed.setAttribute("aria-valuetext", times === 1 ? "as in life" : `${times} times as fast as in life`);
        spin.setAttribute("aria-valuetext", `${spinNumber.value.replace("-", "−")} rad/s`);
        const pushed = number(pushNumber);
        shown("slip").textContent = Number.isFinite(pushed) ? short(pushed) : "none";
        push.setAttribute("aria-valuetext", pushed === 0 ? "no slip" : `a slip of ${Number.isFinite(pushed) ? short(pushed) : "no number"} of the spin`);
    }
    /** What plays goes on playing, from the new start. */
    function change() {
        state.flick = null;
        caption();
        prepare();
        say(told());
    }
    spin.addEventListener("input", () => {
        spinNumber.value = spin.value;
        change();
    });
    spinNumber.addEventListener("input", () => {
        if (Number.isFinite(number(spinNumber))) spin.value = number(spinNumber);
        change();
    });
    push.addEventListener("input", () => {
        const power = Number(push.value);
        pushNumber.value = power <= Number(push.min) ? 0 : Number((10 ** power).toPrecision(3));
        change();
    });
    pushNumber.addEventListener("input", () => {
        const size = Math.abs(number(pushNumber));
        if (Number.isFinite(size)) push.value = size === 0 ? push.min : Math.max(Math.log10(size), Number(push.min) + 0.1);
        change();
    });
    for (const choice of [body, about, ...own]) choice.addEventListener("input", change);
    for (const choice of [ride, rolling]) choice.addEventListener("input", redraw);
    function view() {
        for (const field of [turn, tilt]) field.setAttribute("aria-valuetext", `${fixed(Number(field.value), 0)} degrees`);
        if (!state.setting) return;
        state.setting.eye = looking(state.setting.momentum);
        redraw();
    }
    for (const field of [turn, tilt]) field.addEventListener("input", view);
    // Dragged, both pictures turn with the hand: half a degree for each pixel. Let go in full motion, the body is flicked.
    for (const what of ["body", "polhode"]) {
        const picture = stage.querySelector(`[data-draws=${what}]`);
        let recent = []; // how far it went, px, and when, of the last moves
        dragged(picture, (x, y, { timeStamp }) => {
            recent = [...recent.filter((move) => timeStamp - move[2] < 80), [x, y, timeStamp]];
            turn.value = ((Number(turn.value) + 0.5 * x + 540) % 360) - 180;
            tilt.value = Number(tilt.value) + 0.5 * y;
            view();
        }, ({ timeStamp }) => {
            const moves = recent.filter((move) => timeStamp - move[2] < 80);
            recent = [];
            if (what !== "body" || moves.length < 2) return;
            const passed = timeStamp - moves[0][2];
            const pace = [0, 1].map((i) => moves.slice(1).reduce((sum, move) => sum + move[i], 0) / passed);
            if (Math.hypot(...pace) > FLICK) flicked(pace);
        });
    }
    const FLICK = 0.7; // px a millisecond: slower is a look around
    /** Spins the body as a finger does that runs over it so fast: about the line across its way. */
    function flicked([x, y]) {
        const { body } = seen();
        const size = 10 * Math.hypot(x, y) / FLICK;
        const [right, up] = [y, x].map((part) => part / Math.hypot(x, y));
        pause();
        state.flick = {
            omega: [0, 1, 2].map((k) => size * (right * body[0][k] + up * body[1][k])),
            from: { base: body, turn: Number(turn.value), tilt: Number(tilt.value) },
        };
        prepare();
        if (state.setting && !matchMedia("(prefers-reduced-motion: reduce)").matches) play.click();
        else say(told());
    }
    speed.addEventListener("input", caption);

    function redraw() {
        for (const it of papers) {
            it.prepare();
            it.draw();
        }
    }
    again = redraw;
    caption();
    view();
    prepare();
});
