// What is taken along from "Your own body": a file for the commands, figures for slides, a film, a sheet.
"use strict";

/** Lets the buttons save what is `given` now, and what the module `found` of it. */
tumblingLive.yourBodySaves = ({ stage, shown, wrong, kinds, called, found, pictures, exact }) => {
    const { cross } = tumblingLive.bodies;
    const { seen: faced } = tumblingLive.yourBodyShapes;
    const filed = () => called().toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "") || "your-body";
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
        const parts = found().whole;
        const whole = found().single ? lines(parts[0].kind, parts[0].numbers[0], parts[0].numbers.slice(1))
            : parts.flatMap(({ kind, numbers: [mass, ...sizes], at, turn: [axis, degrees] }) => ["", "[[part]]", ...lines(kind, mass, sizes), ...(degrees === 0 ? [] : [`turn = [${[0, 1, 2].map((k) => Number(k === axis)).join(", ")}, ${degrees}] # about ${"xyz"[axis]}`]), `at = [${at.join(", ")}] # m`]);
        return save(`${filed()}.toml`, `${[`name = ${JSON.stringify(called())}`, ...whole].join("\n")}\n`, "text/plain");
    }
    /** A colour as programs know it that are no browser. */
    const plain = (look) => look.replace(/color\(srgb ([\d.e -]+)\)/g, (_, parts) => `rgb(${parts.split(" ").map((x) => Math.round(255 * x)).join(", ")})`);
    /** The drawings with the look and the size that they have on this page, for programs that know no style sheet. */
    function figures() {
        for (const [name, svg] of Object.entries(pictures)) {
            const copy = svg.cloneNode(true);
            const [own, copied] = [svg, copy].map((root) => [root, ...root.querySelectorAll("*")]);
            own.forEach((element, k) => {
                const look = getComputedStyle(element);
                for (const part of ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "opacity", "font-family", "font-size", "font-weight", "text-anchor"]) copied[k].style.setProperty(part, plain(look.getPropertyValue(part)));
            });
            copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
            const [, , width, height] = svg.getAttribute("viewBox").split(" ");
            for (const [side, length] of [["width", width], ["height", height]]) copy.setAttribute(side, length);
            copy.insertAdjacentHTML("afterbegin", `<rect width="${width}" height="${height}" style="fill: ${getComputedStyle(document.documentElement).backgroundColor}"/>`);
            save(`${filed()}-${name}.svg`, new XMLSerializer().serializeToString(copy), "image/svg+xml");
        }
        return `Saved as ${filed()}-….svg.`;
    }
    async function film() {
        const type = ["video/mp4;codecs=avc1.42E01E", "video/webm", "video/mp4"].find((type) => window.MediaRecorder?.isTypeSupported(type));
        if (!type) return "This browser records no film.";
        const [canvas, parts, drawn, moments] = [document.createElement("canvas"), [], found().faces, found().moments];
        Object.assign(canvas, { width: 1280, height: 720 });
        const pen = canvas.getContext("2d");
        const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 4e6 });
        recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
        const stopped = new Promise((done) => { recorder.addEventListener("stop", done); });
        const area = (places, color) => {
            pen.beginPath();
            places.forEach(([x, y]) => pen.lineTo(640 + 230 * x, 350 - 230 * y));
            pen.closePath();
            pen.fillStyle = color;
            pen.fill();
            pen.stroke();
        };
        const line = (...places) => {
            pen.beginPath();
            places.forEach(([x, y]) => pen.lineTo(640 + 230 * x, 350 - 230 * y));
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
            const [near, far] = [found().reach[1][0], found().reach[1][0] + 0.25].map((x) => look([0, x, 0]));
            const pin = (from) => {
                Object.assign(pen, { strokeStyle: "#c873b1", lineWidth: 7 });
                line(from, far);
            };
            pin(look([0, 0, 0]));
            for (const { places, mark } of faced(drawn, look)) {
                Object.assign(pen, { strokeStyle: "#23211d", lineWidth: places.length === 4 && drawn.length < 40 ? 3 : 0.7 });
                area(places, "#dde8ef");
                if (mark.length > 0) area(mark, "#c873b1");
            }
            if (far[2] >= near[2]) pin(near);
            Object.assign(pen, { fillStyle: "#23211d", font: '26px "Tumbling Sans", sans-serif' });
            pen.fillText(`${called()}, 1 turn/s about its middle axis, slip 1 %`, 28, 692);
            pen.fillText(`t = ${t.toFixed(1)} s`, 1120, 692);
            pen.fillStyle = "#a04c8b";
            pen.fillText("middle axis", 28, 44);
            if (found().whole.some(({ kind }) => kind === "moments")) pen.fillText("drawn as an even ellipsoid of the same moments", 28, 80);
            shown("saved").textContent = `Recording: ${Math.floor(12 - t)} s.`;
            await new Promise((next) => { setTimeout(next, 1000 / 30); });
        }
        recorder.stop();
        await stopped;
        const saved = save(`${filed()}.${type.slice(6, 10).replace(";", "")}`, new Blob(parts, { type }), type);
        return type.includes("avc1") ? saved : `${saved} This browser records no H.264, so some slide programs will not play it; the command film makes a GIF.`;
    }
    function sheet() {
        print(); // what prints of this page is its sheet
        return "";
    }
    const SAVES = { file, figures, film, sheet };
    for (const button of stage.querySelectorAll("[data-save]")) {
        button.addEventListener("click", async () => {
            button.disabled = true;
            shown("saved").textContent = wrong.hidden ? await SAVES[button.dataset.save]() : "Correct the numbers first.";
            button.disabled = false;
        });
    }
};
