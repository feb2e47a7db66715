// Bodies on canvases: solids in the page's colours, their arrows and what names these; and the clock by which they move.
"use strict";

tumblingLive.bodies ??= (() => {
    // ---- Vectors.
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    /** Of length 1; none for a vector of no length. */
    const unit = (a) => {
        const size = Math.max(...a.map(Math.abs));
        if (!(size > 0 && size < Infinity)) return null;
        const scaled = a.map((x) => x / size);
        return scaled.map((x) => x / Math.hypot(...scaled));
    };
    /** What turns body axes into world axes, as rows, by the attitude. */
    const rows = ([w, x, y, z]) => [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ];
    /** World axes, as rows, seen from others: each of `eye` in the axes that `world` turns. */
    const through = (eye, world) => eye.map((axis) => [0, 1, 2].map((j) => axis[0] * world[0][j] + axis[1] * world[1][j] + axis[2] * world[2][j]));
    /** To the right, up and toward a reader who has the momentum upright. */
    function upright(momentum) {
        const up = unit(momentum) ?? [1, 0, 0];
        const right = unit(cross(up, [0, -1, 0].map((x, i) => x + dot([0, 1, 0], up) * up[i]))) ?? [0, 0, 1];
        return [right, up, cross(right, up)];
    }
    /** The same, of a reader who goes around by `turn` and above by `tilt` degrees. */
    function orbit([right, up, toward], turn, tilt) {
        const [around, above] = [turn, tilt].map((degrees) => (degrees * Math.PI) / 180);
        const across = right.map((x, i) => Math.cos(around) * x + Math.sin(around) * toward[i]);
        const near = toward.map((x, i) => Math.cos(around) * x - Math.sin(around) * right[i]);
        return [
            across,
            up.map((x, i) => Math.cos(above) * x - Math.sin(above) * near[i]),
            near.map((x, i) => Math.cos(above) * x + Math.sin(above) * up[i]),
        ];
    }

    /** A body about its centre of mass, all within a ball of radius 1: every place of it once, and what joins which places. */
    function model(told, which, centre) {
        const { parts, strings, leaves, across } = tumblingLive.solids(told, which, centre);
        const [places, model, lines] = [[], [], []];
        const add = (some) => some.map((place) => places.push(place) - 1);
        const mean = (some) => [0, 1, 2].map((i) => some.reduce((sum, p) => sum + p[i], 0) / some.length);
        for (const { corners, faces } of parts) {
            const from = places.length;
            add(corners);
            const shift = (list) => list?.map((i) => from + i);
            model.push({
                faces: faces.map((face) => ({ ...face, at: shift(face.at), hole: shift(face.hole), normal: unit(across(face, corners)) ?? [0, 0, 0] })),
                middle: add([mean(corners)])[0],
            });
        }
        for (const { ends } of strings) lines.push(add(ends));
        const reach = (some) => Math.max(...some.map((p) => Math.hypot(...p.map((x, i) => x - centre[i]))));
        const pin = [[leaves, centre[1], centre[2]], [leaves + 0.3 * reach(places), centre[1], centre[2]]];
        model.push({ pin: add(pin), middle: add([mean(pin)])[0] });
        const size = reach(places);
        return { model, lines, places: Float64Array.from(places.flatMap((p) => p.map((x, i) => (x - centre[i]) / size))) };
    }

    // ---- Colours, from the page's theme.
    const mixed = (a, b, part) => `rgb(${a.map((x, i) => Math.round(x + (b[i] - x) * part)).join(" ")})`;
    /** Reads the colours of a stage, now and whenever the theme changes, and then calls `changed`; of each kind of face from the darkest to the lightest. */
    function palette(stage, changed) {
        const dip = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
        const probe = document.createElement("span");
        probe.hidden = true; // nor has it a transition from one theme's colour to the next
        probe.style.forcedColorAdjust = "none";
        stage.append(probe);
        const triple = (colour) => {
            dip.clearRect(0, 0, 1, 1);
            dip.fillStyle = colour;
            dip.fillRect(0, 0, 1, 1);
            return [...dip.getImageData(0, 0, 1, 1).data.slice(0, 3)];
        };
        const stamps = new Map();
        const colours = { stamps };
        function dye() {
            const of = (name) => {
                probe.style.color = name.startsWith("--") ? `var(${name})` : name;
                return triple(getComputedStyle(probe).color);
            };
            const page = matchMedia("(forced-colors: active)").matches ? ["CanvasText", "Canvas"] : ["--fg", "--bg"];
            const [fg, bg, surface, links, middle] = [...page, "--fig-surface", "--links", "--fig-axis-mid"].map(of);
            const night = fg[0] + fg[1] + fg[2] > bg[0] + bg[1] + bg[2];
            const shades = (near, far) => Array.from({ length: 33 }, (_, i) => mixed(near, far, i / 32));
            const raised = (colour, part) => triple(mixed(colour, fg, part));
            const sunk = (colour, part) => triple(mixed(colour, night ? [0, 0, 0] : fg, part));
            const range = (colour) => (night ? shades(sunk(colour, 0.35), raised(colour, 0.3)) : shades(sunk(colour, 0.55), colour));
            Object.assign(colours, {
                plain: range(surface),
                front: range(triple(mixed(surface, links, 0.4))),
                mark: range(middle),
                hole: shades(sunk(surface, 0.7), sunk(surface, 0.5)),
                ground: mixed(bg, fg, 0.07),
                edge: mixed(fg, bg, 0.35), fg: mixed(fg, fg, 0), bg: mixed(bg, bg, 0),
            });
            for (const name of ["faint", "omega", "momentum", "separatrix", "axis-min", "axis-mid", "axis-max", "wrong"]) {
                const colour = of(`--fig-${name}`);
                colours[name] = mixed(colour, colour, 0);
            }
            const style = getComputedStyle(stage);
            colours.font = `14px ${style.fontFamily}`;
            const symbols = getComputedStyle(document.documentElement).getPropertyValue("--fig-symbols").trim() || "serif";
            colours.symbols = `italic bold 17px ${symbols}`;
            stamps.clear();
            dip.font = colours.symbols;
            colours.half = Object.fromEntries(["L", "ω"].map((name) => [name, [dip.measureText(name).width / 2 + 1, 9]]));
        }
        const again = () => {
            dye();
            changed();
        };
        dye();
        document.fonts.addEventListener("loadingdone", again);
        new MutationObserver(again).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
        for (const query of ["(forced-colors: active)", "(prefers-color-scheme: dark)"]) matchMedia(query).addEventListener("change", again);
        return colours;
    }

    // ---- Drawing.
    const MOST = 2; // screen pixels for each of the page's: more are not told apart in what moves
    /** A canvas in the page's own pixels, as high as `shape` says: `draw(pen, width, height)` draws all of it. */
    function paper(canvas, shape, draw, still) {
        const pen = canvas.getContext("2d");
        let [width, height, dots] = [0, 0, 1];
        const clear = () => {
            pen.setTransform(1, 0, 0, 1, 0, 0);
            pen.clearRect(0, 0, canvas.width, canvas.height);
            pen.setTransform(dots, 0, 0, dots, 0, 0);
        };
        const it = {
            coarse: 1,
            /** What changes from frame to frame: on the canvas, or as a part of the page that the browser moves without painting. */
            draw() {
                if (width === 0) return;
                if (!still) clear();
                draw(pen, width, height, canvas);
            },
            /** What keeps still from frame to frame. */
            prepare() {
                if (width === 0 || !still) return;
                clear();
                still(pen, width, height, canvas);
            },
            measure() {
                dots = Math.max(Math.min(devicePixelRatio || 1, MOST) * it.coarse, Math.min(devicePixelRatio || 1, 1));
                height = shape(width);
                canvas.style.height = `${height}px`;
                [canvas.width, canvas.height] = [Math.round(width * dots), Math.round(height * dots)];
                it.prepare();
                it.draw();
            },
        };
        let seen = "";
        new ResizeObserver(() => {
            width = canvas.clientWidth; // read here alone: after a text was written it would have the page laid out
            const size = `${width} ${devicePixelRatio}`;
            if (size !== seen) it.measure();
            seen = size;
        }).observe(canvas);
        return it;
    }
    const path = (pen, points, closed) => {
        pen.beginPath();
        points.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
        if (closed) pen.closePath();
    };
    function arrow(pen, [x, y], [toX, toY], colour, width) {
        const length = Math.hypot(toX - x, toY - y);
        const [ux, uy] = length > 0 ? [(toX - x) / length, (toY - y) / length] : [0, -1];
        const head = Math.min(3.4 * width, length);
        const [baseX, baseY] = [toX - head * ux, toY - head * uy];
        const side = 0.38 * head;
        pen.strokeStyle = pen.fillStyle = colour;
        pen.lineWidth = width;
        path(pen, [[x, y], [baseX, baseY]]);
        pen.stroke();
        path(pen, [[toX, toY], [baseX - side * uy, baseY + side * ux], [baseX + side * uy, baseY - side * ux]], true);
        pen.fill();
    }
    const LIGHT = unit([-0.45, 0.75, 0.6]);
    /** A body about `[cx, cy]`, a ball of radius 1 being `scale` px wide; `seen` are the reader's axes in the body's. Returns its places, in px from there. */
    function paint(pen, colours, { model, lines, places }, seen, [cx, cy], scale) {
        const [right, up, toward] = seen;
        const count = places.length / 3;
        const [xs, ys, zs] = [0, 1, 2].map(() => new Float64Array(count));
        for (let i = 0; i < count; i += 1) {
            const [x, y, z] = [places[3 * i], places[3 * i + 1], places[3 * i + 2]];
            xs[i] = scale * (right[0] * x + right[1] * y + right[2] * z);
            ys[i] = -scale * (up[0] * x + up[1] * y + up[2] * z);
            zs[i] = toward[0] * x + toward[1] * y + toward[2] * z;
        }
        const trace = (list) => {
            for (let i = 0; i < list.length; i += 1) {
                if (i === 0) pen.moveTo(cx + xs[list[i]], cy + ys[list[i]]);
                else pen.lineTo(cx + xs[list[i]], cy + ys[list[i]]);
            }
        };
        const outline = ({ at, hole }) => {
            for (const list of hole ? [at, hole] : [at]) {
                trace(list);
                pen.closePath();
            }
        };
        pen.lineJoin = "round";
        pen.strokeStyle = colours.faint;
        pen.lineWidth = 0.7;
        pen.beginPath();
        for (const ends of lines) trace(ends);
        pen.stroke();
        model.sort((a, b) => zs[a.middle] - zs[b.middle]);
        for (const part of model) {
            if (part.pin) {
                pen.strokeStyle = pen.fillStyle = colours["axis-mid"];
                pen.lineWidth = 3;
                pen.beginPath();
                trace(part.pin);
                pen.stroke();
                pen.beginPath();
                pen.arc(cx + xs[part.pin[1]], cy + ys[part.pin[1]], Math.min(4.5, 0.045 * scale), 0, 2 * Math.PI);
                pen.fill();
                continue;
            }
            pen.lineWidth = 0.8;
            const edges = []; // all at once: the faces that are seen do not lie over each other, and to set a colour takes long
            for (const face of part.faces) {
                const near = dot(toward, face.normal);
                if (near <= 0) continue;
                const light = 0.5 + 0.5 * (LIGHT[0] * dot(right, face.normal) + LIGHT[1] * dot(up, face.normal) + LIGHT[2] * near);
                const shade = colours[face.kind][Math.round(32 * Math.max(0, Math.min(1, light)))];
                pen.beginPath();
                outline(face);
                pen.fillStyle = shade;
                pen.fill("evenodd");
                if (!face.smooth) edges.push(face);
                else {
                    pen.strokeStyle = shade;
                    pen.stroke();
                }
            }
            if (edges.length === 0) continue;
            pen.strokeStyle = colours.edge;
            pen.beginPath();
            edges.forEach(outline);
            pen.stroke();
        }
        return { xs, ys, cx, cy };
    }
    /**
     * Arrows from the middle of a painted body, the first named first: `{ name, tip: [x, y] px, colour, width }`; the names stand off the
     * body and off each other. `sides` keeps from frame to frame on which side of the first the second's name stands.
     */
    function arrows(pen, colours, body, list, sides) {
        const { xs, ys, cx, cy } = body;
        /** How far from the middle a name stands in a direction, wholly off the body and the tip of its arrow. */
        const beyond = (ux, uy, tip, [wide, high]) => {
            let far = tip;
            for (let i = 0; i < xs.length; i += 1) far = Math.max(far, xs[i] * ux + ys[i] * uy);
            return far + 4 + Math.abs(ux) * wide + Math.abs(uy) * high;
        };
        const labels = [];
        const label = (name, x, y, colour) => {
            const [wide, high] = colours.half[name];
            tumblingLive.word(pen, colours.stamps, name, colours.symbols, colour, [x, y]);
            labels.push({ name, left: x - wide, right: x + wide, top: y - high, bottom: y + high });
        };
        let first = null; // the direction of the first, and how far beside it no other name may stand
        for (const { name, tip: [x, y], colour, width } of list) {
            arrow(pen, [cx, cy], [cx + x, cy + y], colour, width);
            const half = colours.half[name];
            const far = Math.hypot(x, y);
            const leads = far > 2 ? [x / far, y / far] : [0, -1];
            if (!first) {
                first = leads;
                const out = beyond(...leads, far, half);
                label(name, cx + out * leads[0], cy + out * leads[1], colour);
                continue;
            }
            // From the first's direction on; what is right above it changes sides late.
            const angle = Math.atan2(first[0] * leads[1] - first[1] * leads[0], dot([...first, 0], [...leads, 0]));
            if (Math.abs(angle) > 0.1) sides.last = Math.sign(angle);
            const side = sides.last ?? 1;
            const beside = Math.max(colours.half[list[0].name][0], 8) + 3 + Math.abs(first[1]) * half[0] + Math.abs(first[0]) * half[1];
            for (let turn = Math.abs(angle), i = 0; i < 40; turn += 0.05, i += 1) {
                const [c, s] = [Math.cos(side * turn), Math.sin(side * turn)];
                const [ux, uy] = [c * first[0] - s * first[1], s * first[0] + c * first[1]];
                const out = beyond(ux, uy, far, half);
                if (c > 0 && Math.abs(out * s) < beside) continue;
                label(name, cx + out * ux, cy + out * uy, colour);
                break;
            }
        }
        pen.fillStyle = colours.fg;
        pen.beginPath();
        pen.arc(cx, cy, 2.5, 0, 2 * Math.PI);
        pen.fill();
        return labels;
    }

    // ---- Time: it runs only when asked, and where less motion is preferred it goes by steps.
    /**
     * `go(seconds)` moves on by so many seconds of the reader's and says whether it can; `step` is how many a step takes, `start` the button's name at rest; `rested` is called
     * when it has stopped, `late(often)` when half of some frames came late. Out of sight it rests.
     */
    function clock(stage, play, { go, step, start = "Play", rested = () => {}, late = () => {}, pressed = () => {} }) {
        const still = matchMedia("(prefers-reduced-motion: reduce)");
        let [playing, pending] = [false, 0];
        const name = () => {
            play.textContent = still.matches ? "Step" : playing ? "Pause" : start;
        };
        function pause() {
            cancelAnimationFrame(pending);
            if (!playing) return;
            playing = false;
            name();
            rested();
        }
        function run() {
            playing = true;
            name();
            let last = null;
            let [behind, frames] = [0, 0];
            const frame = (now) => {
                // A page out of sight gets no frames: what it missed is not made up for.
                const passed = last === null ? 0 : Math.min((now - last) / 1000, 0.1);
                last = now;
                frames += 1;
                if (passed > 0.022) behind += 1;
                if (frames === 12) {
                    if (behind > 6) late();
                    [behind, frames] = [0, 0];
                }
                if (go(passed)) pending = requestAnimationFrame(frame);
            };
            pending = requestAnimationFrame(frame);
        }
        play.addEventListener("click", () => {
            if (still.matches) go(step);
            else if (playing) pause();
            else run();
            pressed();
        });
        still.addEventListener("change", () => {
            pause();
            name();
        });
        new IntersectionObserver(([{ isIntersecting }]) => isIntersecting || pause()).observe(stage);
        name();
        return { pause, playing: () => playing };
    }

    /** A drag over an element, by mouse, pen or finger: `moved(x, y, event)` has how far it went since it was last called, px. */
    function dragged(element, moved, ended = () => {}) {
        let held = null;
        element.addEventListener("pointerdown", (event) => {
            element.setPointerCapture(event.pointerId);
            held = [event.clientX, event.clientY];
        });
        element.addEventListener("pointermove", (event) => {
            if (!held) return;
            moved(event.clientX - held[0], event.clientY - held[1], event);
            held = [event.clientX, event.clientY];
        });
        for (const end of ["pointerup", "pointercancel"]) {
            element.addEventListener(end, (event) => {
                if (held && end === "pointerup") ended(event);
                held = null;
            });
        }
    }

    /**
     * A picture seen from `view.turn` around and `view.tilt` above, degrees, which a drag changes by half a degree for each pixel. A drag that
     * begins where `grip.takes([x, y])` is grip's own, and no finger there scrolls the page: it has `moved` and `ended`.
     */
    function looks(element, view, redraw, grip) {
        let own = false;
        const at = ({ clientX, clientY }) => {
            const box = element.getBoundingClientRect();
            return [clientX - box.left, clientY - box.top];
        };
        if (grip) {
            element.addEventListener("pointerdown", (event) => { own = grip.takes(at(event)); });
            element.addEventListener("touchstart", (event) => { if (grip.takes(at(event.touches[0]))) event.preventDefault(); }, { passive: false });
        }
        dragged(element, (right, down, event) => {
            if (own) return grip.moved(at(event));
            view.turn += 0.5 * right;
            view.tilt = Math.max(-80, Math.min(80, view.tilt + 0.5 * down));
            redraw();
        }, () => own && grip.ended());
    }

    return { dot, cross, unit, rows, through, upright, orbit, model, palette, paper, path, arrow, paint, arrows, clock, dragged, looks };
})();
