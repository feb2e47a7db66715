// Brings the widgets of a page to life: each when it comes into view, with its own script and module and no others.
// A plain script that loads plain scripts, since a page read from a disk may load nothing else.
"use strict";

globalThis.tumblingLive ??= (() => {
    const carried = new Map(); // files that came as text, by name
    const makers = new Map(); // what makes a widget live, by name
    const loading = new Map(); // scripts asked for, by address

    function load(address) {
        if (!loading.has(address)) {
            loading.set(address, new Promise((done, failed) => {
                const script = document.createElement("script");
                script.src = address;
                script.onload = done;
                script.onerror = () => failed(new Error(`cannot load ${address}`));
                document.head.append(script);
            }));
        }
        return loading.get(address);
    }

    /** The bytes of a carried file, which came packed. */
    async function bytes(name) {
        const packed = Uint8Array.from(atob(carried.get(name)), (letter) => letter.charCodeAt(0));
        const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
        return new Uint8Array(await new Response(stream).arrayBuffer());
    }

    /** A module, ready to be asked: see exchange/src/lib.rs for the other side. */
    async function module(name) {
        const { exports } = (await WebAssembly.instantiate(await bytes(name), {})).instance;
        let row = [];
        /** The row of numbers; where the memory has grown it lies in a new buffer. */
        const numbers = () => (row.length === 0 ? (row = new Float64Array(exports.memory.buffer, exports.numbers())) : row);
        return {
            /** The numbers answered, or null: then `words` says why. */
            answer(what, ...asked) {
                numbers().set(asked);
                const count = exports.answer(what);
                return count === 0 ? null : numbers().slice(0, count);
            },
            words() {
                const text = new Uint8Array(exports.memory.buffer, exports.text(), exports.text_length());
                return new TextDecoder().decode(text);
            },
        };
    }

    /** A number as Rust prints it with so many decimals: ties go to the even digit. The minus is a true one. */
    function fixed(number, decimals) {
        if (!Number.isFinite(number) || Math.abs(number) >= 1e15) return String(number).replace("-", "−");
        const size = Math.abs(number);
        let digits = size.toFixed(decimals); // exact, but for ties, which it rounds up
        if (Number.isInteger(size * 2 ** (decimals + 1))) { // a tie has no more binary places
            const [, below, rest] = size.toFixed(decimals + 1).match(/^(.*?)\.?(\d)$/);
            if (rest === "5" && "02468".includes(below.at(-1))) digits = below;
        }
        return number < 0 && /[1-9]/.test(digits) ? `−${digits}` : digits;
    }

    /** A power of ten's raised figures. */
    const raised = (power) => Array.from(String(power), (sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]).join("");

    /** A number of any size in few digits. */
    function short(number) {
        const size = Math.abs(number);
        if (size === 0) return "0";
        if (size >= 0.01 && size < 1e5) return fixed(number, size >= 100 ? 1 : 3);
        const [digits, power] = number.toExponential(2).split("e");
        return `${digits} · 10${raised(Number(power))}`.replace("-", "−");
    }

    /** An element of a drawing: the one that stood there when it was drawn last, where it is of the same kind. Only what is new is set. */
    function draw(kind, parent, attributes, text) {
        let element = parent.next; // see `drawing`
        if (element?.localName === kind) {
            parent.next = element.nextElementSibling;
            if (element.firstElementChild) element.replaceChildren();
        } else parent.insertBefore(element = document.createElementNS("http://www.w3.org/2000/svg", kind), parent.next ?? null);
        const before = element.drawn ?? {};
        for (const name in attributes) if (attributes[name] !== before[name]) element.setAttribute(name, attributes[name]);
        for (const name in before) if (!(name in attributes)) element.removeAttribute(name);
        if (text !== undefined && element.textContent !== text) element.textContent = text;
        element.drawn = attributes;
        return element;
    }

    /** An arrow from one place to another; one too short for its head is all head. */
    function arrow(parent, [x, y], [toX, toY], name, width) {
        const length = Math.hypot(toX - x, toY - y);
        const [ux, uy] = length > 0 ? [(toX - x) / length, (toY - y) / length] : [1, 0];
        const head = 3.4 * width;
        const [tipX, tipY] = length < head ? [x + head * ux, y + head * uy] : [toX, toY];
        const [baseX, baseY] = [tipX - head * ux, tipY - head * uy];
        const [sideX, sideY] = [-1.3 * width * uy, 1.3 * width * ux];
        draw("path", parent, {
            class: `live-arrow ${name}`,
            d: `M${x} ${y}L${baseX} ${baseY}`,
            "stroke-width": width,
        });
        draw("path", parent, {
            class: `live-head ${name}`,
            d: `M${tipX} ${tipY}L${baseX + sideX} ${baseY + sideY}L${baseX - sideX} ${baseY - sideY}z`,
        });
        return [tipX, tipY];
    }

    const MOST = 2; // screen pixels for each of the page's
    /**
     * Writes a word on a canvas: about `[x, y]`, or to the left or right of it (`side` −1 or 1); a `halo` parts it from what is behind. It is drawn
     * once and kept among the `stamps`: to set a font in each frame takes longer than to draw a body.
     */
    function word(pen, stamps, text, font, colour, [x, y], side = 0, halo = "") {
        const key = `${text},${font},${colour},${halo}`;
        let stamp = stamps.get(key);
        if (!stamp) {
            stamps.set(key, stamp = document.createElement("canvas"));
            const [ink, size] = [stamp.getContext("2d"), parseFloat(font.match(/[\d.]+(?=px)/)[0])];
            ink.font = font;
            [stamp.width, stamp.height] = [MOST * Math.ceil(ink.measureText(text).width + 8), MOST * 2 * size];
            ink.scale(MOST, MOST);
            Object.assign(ink, { font, textAlign: "center", fillStyle: colour, strokeStyle: halo, lineWidth: 2.6 });
            const place = [stamp.width / 2 / MOST, 1.35 * size];
            if (halo) ink.strokeText(text, ...place);
            ink.fillText(text, ...place);
        }
        const [wide, high] = [stamp.width / MOST, stamp.height / MOST];
        pen.drawImage(stamp, x - wide / 2 + side * (wide / 2 - 4), y - high / 2, wide, high);
    }

    /**
     * Has a drawing redrawn, in the page's own pixels, when its width changes. Returns what redraws it. What `redraw` returns stays in the
     * drawing, and is given to it the next time, while the size is the same.
     */
    function drawing(svg, height, redraw) {
        let [width, stays] = [0, undefined];
        const again = () => {
            if (width === 0) return;
            const high = height(width);
            svg.next = stays ? stays.nextElementSibling : svg.firstElementChild;
            stays = redraw(width, high, stays);
            while (svg.next) { // no more of it is drawn
                const rest = svg.next;
                svg.next = rest.nextElementSibling;
                rest.remove();
            }
        };
        new ResizeObserver(() => {
            if (svg.clientWidth !== width) {
                [width, stays] = [svg.clientWidth, undefined];
                svg.setAttribute("viewBox", `0 0 ${width} ${height(width)}`);
                svg.style.height = `${height(width)}px`;
                again();
            }
        }).observe(svg);
        // No finger that takes hold of a handle scrolls the page: what the handle's style says would end with it, at the first redraw.
        svg.addEventListener("touchstart", (event) => event.target.classList.contains("live-handle") && event.preventDefault(), { passive: false });
        return again;
    }

    /** Says a text to those who do not see it, once nothing has changed for a while. */
    function sayer(stage) {
        const place = stage.querySelector(".live-said");
        let [due, pending] = [0, 0];
        function rested() {
            const left = due - performance.now();
            pending = left > 0 ? setTimeout(rested, left) : 0;
            if (pending) return;
            place.textContent = place.dataset.next;
            delete place.dataset.next;
        }
        return (text) => {
            due = performance.now() + 700;
            place.dataset.next = text;
            pending ||= setTimeout(rested, 700); // one for all the texts of a slider that moves
        };
    }

    const living = new Map(); // boxes that are live, or are about to be

    function enliven(box) {
        if (!living.has(box)) living.set(box, begin(box));
        return living.get(box);
    }

    async function begin(box) {
        const { live: name, modules, from } = box.dataset;
        const stage = box.querySelector(".live-stage");
        try {
            await Promise.all([`${name}.js`, ...modules.split(" ").map((module) => `${module}.wasm.js`)].map((file) => load(from + file)));
            await makers.get(name)(stage, from);
            stage.inert = false;
            box.dataset.state = "live";
        } catch (why) {
            box.classList.remove("live-on");
            // Not what stands there without scripts: that tells the reader to use them.
            const advice = globalThis.DecompressionStream && globalThis.WebAssembly ? "Load the page again" : "It needs a newer browser";
            box.querySelector(".live-still").textContent = `This part could not be loaded (${why.message}). ${advice}; the rest of the page works without it.`;
            box.dataset.state = `failed: ${why.message}`;
        }
    }

    const seen = new IntersectionObserver((entries) => {
        for (const { isIntersecting, target } of entries) {
            if (isIntersecting) {
                seen.unobserve(target);
                enliven(target);
            }
        }
    }, { rootMargin: "200px 0px" });

    // The whole book for printing keeps still.
    const boxes = /\/print\.html$/.test(location.pathname) ? [] : document.querySelectorAll("[data-live]");
    for (const box of boxes) {
        const waits = box.querySelector("template"); // it stands in an earlier chapter too
        if (waits) {
            box.id = `live-${box.dataset.live}`;
            waits.replaceWith(waits.content);
        }
        // An address that gives a widget its numbers leads to it.
        if (location.hash.startsWith(`#${box.dataset.live}?`)) box.scrollIntoView();
        box.classList.add("live-on");
        box.querySelector(".live-stage").inert = true;
        box.addEventListener("keydown", (event) => event.stopPropagation()); // mdBook turns pages by keys
        seen.observe(box);
    }

    // Files dropped anywhere go to the widget that takes them, live yet or not: without that the browser would leave the page.
    const taker = [...boxes].find((box) => box.querySelector(".live-drop"));
    const over = (is) => taker.querySelector(".live-drop").classList.toggle("live-over", is);
    for (const kind of taker ? ["dragenter", "dragover", "dragleave", "drop"] : []) {
        addEventListener(kind, (event) => {
            if (!event.dataTransfer?.types.includes("Files")) return;
            event.preventDefault();
            // Only what leaves the whole window comes from nowhere.
            over(kind !== "drop" && !(kind === "dragleave" && event.relatedTarget === null));
            if (kind === "dragover") event.dataTransfer.dropEffect = "copy";
            const files = [...event.dataTransfer.files];
            if (kind !== "drop" || files.length === 0) return;
            enliven(taker).then(() => taker.querySelector(".live-stage").dispatchEvent(new CustomEvent("live-files", { detail: files })));
        });
    }

    return {
        carry: (name, text) => carried.set(name, text),
        widget: (name, maker) => makers.set(name, maker),
        load, bytes, module, fixed, raised, short, draw, arrow, word, drawing, sayer,
    };
})();
