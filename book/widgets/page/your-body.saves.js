// What is taken along from "Your own body": a file for the commands, figures for slides, a film, a sheet.
"use strict";

/** Lets the buttons save what is `given` now, and what the module `found` of it. */
tumblingLive.yourBodySaves = ({ stage, shown, wrong, kind, kinds, given, parts, named, found, pictures, exact }) => {
    const { dot, cross } = tumblingLive.bodies;
    function save(name, content, type) {
        Object.assign(document.createElement("a"), { download: name, href: URL.createObjectURL(new Blob([content], { type })) }).click();
        return `Saved as ${name}.`;
    }
    const LISTS = { box: "sides", plate: "sides", ellipsoid: "semiaxes" };
    /** What a file says of a solid, line by line. */
    function lines(of, mass, numbers) {
        const names = kinds[of].map((name) => (name === "radius of the hole" ? "inner" : name));
        const weight = mass > 0 ? [`mass = ${mass} # kg`] : [];
        if (of === "moments") return [`moments = [${numbers.slice(0, 3).join(", ")}] # kg m²`, `products = [${numbers.slice(3).join(", ")}]`, ...weight];
        return [`shape = "${of === "tube" ? "cylinder" : of}"`, ...(LISTS[of] ? [`${LISTS[of]} = [${numbers.join(", ")}] # m`] : names.map((name, k) => `${name} = ${numbers[k]} # m`)), ...weight];
    }
    function file() {
        const [mass, ...numbers] = given().map(([, value]) => Number(value));
        const whole = parts().length === 0 ? lines(kind.value, mass, numbers)
            : parts().flatMap(({ kind, numbers: [mass, ...sizes], at }) => ["", "[[part]]", ...lines(kind, mass, sizes), `at = [${at.join(", ")}] # m`]);
        return save("your-body.toml", `${['name = "your body"', ...whole].join("\n")}\n`, "text/plain");
    }
    /** The drawings with the look that they have on this page, for programs that know no style sheet. */
    function figures() {
        for (const [name, svg] of Object.entries(pictures)) {
            const copy = svg.cloneNode(true);
            const [own, copied] = [svg, copy].map((root) => [root, ...root.querySelectorAll("*")]);
            own.forEach((element, k) => {
                const look = getComputedStyle(element);
                for (const part of ["fill", "stroke", "stroke-width", "stroke-dasharray", "opacity", "font-family", "font-size", "font-weight", "text-anchor"]) copied[k].style.setProperty(part, look.getPropertyValue(part));
            });
            copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
            copy.style.background = getComputedStyle(document.body).backgroundColor;
            save(`your-body-${name}.svg`, new XMLSerializer().serializeToString(copy), "image/svg+xml");
        }
        return "Saved as your-body-….svg.";
    }
    /** The corners of each face of the box, or of the even box of the same moments, along the principal axes. */
    function faces() {
        const { edges, axes, semiaxes } = found();
        const half = edges ? edges.map((edge) => edge / 2) : semiaxes.map((x) => x * Math.sqrt(3 / 5));
        const size = Math.hypot(...half);
        const place = (p) => (edges ? axes.map((axis) => dot(axis, p)) : p).map((x) => x / size);
        return [0, 1, 2].flatMap((axis) => [-1, 1].map((side) => [[-1, -1], [-1, 1], [1, 1], [1, -1]].map(([a, b]) => {
            const p = [0, 0, 0];
            [p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]] = [side * half[axis], a * half[(axis + 1) % 3], b * half[(axis + 2) % 3]];
            return place(p);
        })));
    }
    /** What of a face lies on the positive side of the middle axis. */
    const marked = (corners) => corners.flatMap((a, k) => {
        const b = corners[(k + 1) % corners.length];
        const cut = a[1] * b[1] < 0 ? [a.map((x, i) => x + ((b[i] - x) * a[1]) / (a[1] - b[1]))] : [];
        return a[1] >= 0 ? [a, ...cut] : cut;
    });
    async function film() {
        const type = ["video/mp4;codecs=avc1.42E01E", "video/webm", "video/mp4"].find((type) => window.MediaRecorder?.isTypeSupported(type));
        if (!type) return "This browser records no film.";
        const [canvas, parts, drawn, moments] = [document.createElement("canvas"), [], faces(), found().moments];
        Object.assign(canvas, { width: 1280, height: 720 });
        const pen = canvas.getContext("2d");
        const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 4e6 });
        recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
        const stopped = new Promise((done) => { recorder.addEventListener("stop", done); });
        const area = (places, color) => {
            pen.beginPath();
            places.forEach(([x, y]) => pen.lineTo(640 + 300 * x, 360 - 300 * y));
            pen.closePath();
            pen.fillStyle = color;
            pen.fill();
            pen.stroke();
        };
        recorder.start();
        const begin = performance.now();
        for (let t = 0; t < 12; t = (performance.now() - begin) / 1000) {
            // A turn a second about the middle axis, which points up, and a hundredth of that across it.
            const [w, ...v] = Array.from(exact.answer(4, ...moments, 0, 2 * Math.PI, 0.02 * Math.PI, t, 0)).slice(3, 7);
            const turned = (p) => {
                const c = cross(v, p).map((x) => 2 * x);
                return p.map((x, i) => x + w * c[i] + cross(v, c)[i]);
            };
            const seen = ([x, y, z]) => [0.8 * x - 0.6 * z, 0.93 * y - 0.22 * x - 0.29 * z, 0.37 * y + 0.56 * x + 0.74 * z];
            const look = (p) => seen(turned(p));
            Object.assign(pen, { fillStyle: "#ffffff", strokeStyle: "#23211d", lineWidth: 3, lineJoin: "round" });
            pen.fillRect(0, 0, 1280, 720);
            const depth = (corners) => corners.reduce((sum, p) => sum + look(p)[2], 0);
            for (const corners of drawn.filter((face) => depth(face) > 0).sort((a, b) => depth(a) - depth(b))) {
                area(corners.map(look), "#dde8ef");
                area(marked(corners).map(look), "#c873b1");
            }
            shown("saved").textContent = `Recording: ${Math.floor(12 - t)} s.`;
            await new Promise((next) => { setTimeout(next, 1000 / 30); });
        }
        recorder.stop();
        await stopped;
        const saved = save(`your-body.${type.slice(6, 10).replace(";", "")}`, new Blob(parts, { type }), type);
        return type.includes("avc1") ? saved : `${saved} This browser records no H.264, so some slide programs will not play it; the command film makes a GIF.`;
    }
    function sheet() {
        const head = document.createElement("p");
        head.textContent = parts().length > 0 ? `Of parts: ${parts().map(named).join("; ")}.` : `Given by ${kind.selectedOptions[0].text}: ${given().map(([name, value]) => `${name} = ${value}`).join(", ")}, in m, kg and kg m².`;
        stage.prepend(head);
        document.body.classList.add("your-body-sheet");
        print();
        head.remove();
        document.body.classList.remove("your-body-sheet");
        return "";
    }
    const SAVES = { file, figures, film, sheet };
    for (const button of stage.querySelectorAll("[data-save]")) {
        button.addEventListener("click", async () => {
            button.disabled = true;
            shown("saved").textContent = wrong.hidden ? await SAVES[button.dataset.save]() : "First the numbers must be right.";
            button.disabled = false;
        });
    }
};
