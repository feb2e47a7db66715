// Two arrows: the reader turns the spin; the module says where the momentum goes.
"use strict";

tumblingLive.widget("two-arrows", async (stage, origin) => {
    const { load, module, fixed, short, draw, arrow, drawing, sayer } = tumblingLive;
    const [arrows, exact] = await Promise.all([...["two-arrows", "tumble"].map(module), load(`${origin}live.bodies.js`)]);
    const { dot, rows, clock } = tumblingLive.bodies;
    const [play, back] = ["play", "back"].map((id) => stage.querySelector(`#two-arrows-${id}`));
    const free = { t: 0, turned: null, spin: null }; // since it was let go: the body's axes in the room, as rows, and the spin there
    const svg = stage.querySelector("svg");
    const [spin, body, between] = ["spin", "body", "between"].map((id) => stage.querySelector(`#two-arrows-${id}`));
    const shown = (what) => stage.querySelector(`[data-shows=${what}]`);
    const say = sayer(stage);
    const names = ["x", "y", "z"];

    /** What the module answers now, by name. */
    function asked() {
        const angle = (Number(spin.value) * Math.PI) / 180;
        const found = arrows.answer(0, Number(body.value), Number(between.value), Math.cos(angle), Math.sin(angle));
        const [from, to, gap, along, up, light, heavy, wide, high, ...rest] = found;
        return { from, to, gap, along, up, light, heavy, wide, high, places: rest.slice(0, 2), axes: rest.slice(0, 2).map((k) => names[k]), moments: rest.slice(2, 5), sizes: rest.slice(5) };
    }

    let middle = null; // from where both arrows go
    const redraw = drawing(svg, (width) => Math.round(Math.min(0.75 * width, 400)), (width, height) => {
        const now = asked();
        const centre = [0.36 * width, 0.7 * height];
        const reach = Math.min(0.6 * height, 0.5 * width);
        const at = (degrees, far) => {
            const angle = (degrees * Math.PI) / 180;
            return [centre[0] + far * Math.cos(angle), centre[1] - far * Math.sin(angle)];
        };
        const line = (name, ...ends) => draw("path", svg, { class: name, d: `M${ends.map((p) => p.join(" ")).join("L")}` });

        // The body, as one sees it who looks along the third axis.
        const scale = Math.min(0.56 * width / now.wide, 0.52 * height / now.high);
        const [halfWide, halfHigh] = [0.5 * scale * now.wide, Math.max(0.5 * scale * now.high, 1.5)];
        const [first, second] = now.places;
        /** A place in the room, m, as seen along the third axis. */
        const seen = (place, far) => [centre[0] + far * place[first], centre[1] - far * place[second]];
        if (free.t === 0 || body.value === "5") {
            draw("rect", svg, {
                class: "live-body", x: centre[0] - halfWide, y: centre[1] - halfHigh, width: 2 * halfWide, height: 2 * halfHigh,
                rx: body.value === "5" ? halfWide : 2,
            });
        } else {
            // Let go, it turns every way: its six faces, those that look at the reader darker at their edges.
            for (const axis of [0, 1, 2]) {
                for (const sign of [1, -1]) {
                    const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([a, b]) => {
                        const place = [0, 0, 0];
                        [place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]] = [sign, a, b];
                        return seen(free.turned.map((row) => dot(row, place.map((part, k) => 0.5 * part * now.sizes[k]))), scale).join(" ");
                    });
                    draw("path", svg, { class: "live-body", d: `M${corners.join("L")}z` });
                }
            }
        }
        line("live-axis", [0.03 * width, centre[1]], [0.97 * width, centre[1]]);
        line("live-axis", [centre[0], 0.97 * height], [centre[0], 0.03 * height]);
        draw("text", svg, { x: 0.97 * width, y: centre[1] + 18, "text-anchor": "end" }, `axis ${now.axes[0]}:`);
        draw("text", svg, { x: 0.97 * width, y: centre[1] + 36, "text-anchor": "end" }, `${short(now.light)} kg m²`);
        draw("text", svg, { x: centre[0] - 8, y: 0.03 * height + 12, "text-anchor": "end" }, `axis ${now.axes[1]}:`);
        draw("text", svg, { x: centre[0] - 8, y: 0.03 * height + 30, "text-anchor": "end" }, `${short(now.heavy)} kg m²`);

        // The gap, as an arc between the arrows, and the angle of the spin.
        const arc = (from, to, radius, name) => draw("path", svg, {
            class: name, d: `M${at(from, radius).join(" ")}A${radius} ${radius} 0 0 0 ${at(to, radius).join(" ")}`,
        });
        if (now.from > 0 && free.t === 0) arc(0, now.from, 0.28 * reach, "live-arc live-omega");
        // As long as the largest momentum of such a spin is the spin's arrow; a short one is drawn longer, so that the arc stays inside.
        const long = Math.hypot(now.along, now.up) / now.heavy;
        const drawn = Math.max(long, 0.5) * reach;
        const inside = Math.min(0.66 * reach, 0.8 * drawn);
        if (now.gap > 0 && free.t === 0) arc(now.from, now.to, inside, "live-arc live-gap");
        if (drawn > long * reach * 1.001) {
            draw("text", svg, { class: "live-note", x: 0.97 * width, y: 0.985 * height, "text-anchor": "end" }, "L drawn longer than to scale");
        }

        const omega = free.t > 0 ? seen(free.spin, reach) : at(now.from, reach);
        svg.shows = { t: free.t, omega, turned: free.turned, spin: free.spin }; // for those who test it
        const momentum = at(now.to, drawn);
        const tip = arrow(svg, centre, momentum, "live-momentum", 6);
        arrow(svg, centre, omega, "live-omega", 3.5);
        draw("circle", svg, { class: "live-point", cx: centre[0], cy: centre[1], r: 4 });

        // Low down, above the name of the axis.
        const beside = omega[1] + (now.from > 60 ? -2 : now.from < 20 ? -9 : 10);
        draw("text", svg, { class: "live-omega", x: omega[0] + 10, y: beside }, "ω");
        // Beside the upright axis, L stands below what names that axis.
        const low = tip[0] < centre[0] + 40 ? Math.max(tip[1] - 8, 0.03 * height + 52) : tip[1] - (now.to < 10 ? 16 : 8);
        const aside = low > tip[1] - 8 || now.gap <= 12 ? 14 : 4;
        draw("text", svg, { class: "live-momentum", x: tip[0] - aside, y: low, "text-anchor": "end" }, "L");
        if (free.t > 0) { // what follows belongs to a spin that is still held
            const moved = Math.hypot(...at(now.from, reach).map((part, k) => part - omega[k]));
            if (now.gap < 0.01 && moved < 1) draw("text", svg, { x: 0.97 * width, y: 0.03 * height + 12, "text-anchor": "end" }, "on an axis: both arrows stay");
            return;
        }
        draw("text", svg, { x: omega[0] + 10, y: beside + (now.from < 20 ? -17 : 17) }, "drag");
        draw("circle", svg, { class: "live-arc live-omega live-ring", cx: omega[0], cy: omega[1], r: 7 });
        if (now.gap >= 8) {
            const label = at((now.from + now.to) / 2, inside + 22);
            draw("text", svg, { class: "live-strong", x: label[0], y: label[1] + 5, "text-anchor": "middle" }, `${fixed(now.gap, 1)}°`);
        }
        middle = centre;
        draw("circle", svg, { class: "live-handle", cx: omega[0], cy: omega[1], r: 16 });
    });

    // The blue arrow can be dragged too; what it does it does by the slider.
    let held = null;
    svg.addEventListener("pointerdown", (event) => {
        if (!event.target.classList.contains("live-handle")) return;
        event.preventDefault();
        svg.setPointerCapture(event.pointerId);
        held = middle;
    });
    svg.addEventListener("pointermove", (event) => {
        if (!held) return;
        const box = svg.getBoundingClientRect();
        const angle = Math.atan2(held[1] - (event.clientY - box.top), event.clientX - box.left - held[0]) * 180 / Math.PI;
        spin.value = angle < -90 ? 90 : angle; // the slider keeps it within its ends
        change();
    });
    for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => { held = null; });

    /** Moves the body to an instant after it was let go; returns that in words. */
    function go(t) {
        const { moments, places, gap } = asked();
        const angle = (Number(spin.value) * Math.PI) / 180;
        const omega = [0, 0, 0];
        [omega[places[0]], omega[places[1]]] = [Math.cos(angle), Math.sin(angle)];
        const it = exact.answer(4, ...moments, ...omega, t, 0);
        const turned = rows(it.slice(3));
        Object.assign(free, { t, turned, spin: turned.map((row) => dot(row, it)) });
        redraw();
        return t === 0 ? "Let go." : `After ${fixed(t, 1)} s ${gap < 0.01 ? "both arrows stand where they stood" : "the spin has moved; the momentum stands where it stood"}.`;
    }

    /** Shows what the module answers now; returns it in words. */
    function show() {
        pause();
        free.t = 0;
        const { from, to, gap, axes } = asked();
        const [ours, theirs, between] = [from, to, gap].map((angle) => `${fixed(angle, 1)}°`);
        shown("spin").textContent = ours;
        shown("momentum").textContent = theirs;
        shown("gap").textContent = between;
        spin.setAttribute("aria-valuetext", `spin ${ours} from axis ${axes[0]}, momentum ${theirs}, gap ${between}`);
        redraw();
        return `Spin ${ours} from axis ${axes[0]}, the easier. Momentum ${theirs}. Gap ${between}.`;
    }
    const { pause } = clock(stage, play, { step: 0.4, start: "Let go", go: (seconds) => Boolean(go(free.t + 2 * seconds)), pressed: () => say(go(free.t)) });
    back.addEventListener("click", () => say(show()));
    const change = () => say(show());
    for (const control of [spin, body, between]) control.addEventListener("input", change);
    // Apart, unless a question above is still to be answered: until then the arrows lie together and do not answer it.
    const question = document.querySelector(".question");
    if (question && question.dataset.state !== "told") {
        spin.value = 0;
        new MutationObserver((_, seen) => {
            seen.disconnect();
            if (spin.value !== "0") return;
            spin.value = 45;
            show();
        }).observe(question, { attributeFilter: ["data-state"] });
    }
    show();
});
