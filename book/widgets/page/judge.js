// The judge: a record dropped, chosen or pasted is judged by the module, in a worker, piece by piece.
"use strict";

tumblingLive.widget("judge", async (stage, from) => {
    const { bytes, load, short, sayer } = tumblingLive;
    await load(`${from}judge.picture.js`);
    /** The laws that may have a limit of their own, in the judge's order. */
    const LAWS = ["energy", "momentum", "direction", "unit", "separatrix", "phase", "consistency"];
    const UNTOLD = { direction: "the direction of L", unit: "the quaternion’s length", consistency: "whether it turns as the spin says" };
    const the = (id) => stage.querySelector(`#judge-${id}`);
    const [file, text, moments, threshold, fit, go, example] =
        ["file", "text", "moments", "threshold", "fit", "go", "example"].map(the);
    const drop = stage.querySelector(".live-drop");
    const wrong = stage.querySelector(".live-wrong");
    const place = stage.querySelector(".live-verdict");
    const say = sayer(stage);

    /** What runs in the worker: it knows nothing of what is around it here. */
    function work() {
        let module;
        onmessage = async ({ data }) => {
            if (data.module) {
                module = WebAssembly.compile(data.module);
                return;
            }
            const { record, asked, turn } = data;
            const reader = new FileReaderSync();
            let at = 0;
            let exports = null;
            const more = (address, room) => {
                const piece = new Uint8Array(reader.readAsArrayBuffer(record.slice(at, at + room)));
                new Uint8Array(exports.memory.buffer).set(piece, address);
                at += piece.length;
                return piece.length;
            };
            try {
                // A fresh one for each record: none has anything from the one before.
                ({ exports } = await WebAssembly.instantiate(await module, { page: { more } }));
                new Float64Array(exports.memory.buffer, exports.numbers(), asked.length).set(asked);
                const judged = exports.answer(0) === 1;
                const said = new Uint8Array(exports.memory.buffer, exports.text(), exports.text_length());
                postMessage({ turn, judged, said: new TextDecoder().decode(said) });
            } catch (why) {
                postMessage({ turn, judged: false, said: `the record could not be read to its end (${why.message})` });
            }
        };
    }
    const code = URL.createObjectURL(new Blob([`"use strict";(${work})()`], { type: "text/javascript" }));
    const worker = new Worker(code);
    URL.revokeObjectURL(code);
    worker.postMessage({ module: bytes("judge") });

    let turn = 0; // only the answer to the last question counts
    let last = null;

    /** Moments as typed: none, three numbers, or a complaint. */
    function typed() {
        const words = moments.value.split(/[\s,;]+/).filter(Boolean);
        if (words.length === 0) return [0, 0, 0, 0];
        const numbers = words.map(Number);
        if (numbers.length !== 3 || numbers.some(Number.isNaN)) {
            throw new Error(`the moments are three numbers, as in 1, 2, 2.5, but \`${moments.value}\` is typed`);
        }
        return [1, ...numbers];
    }

    /** Limits as typed, as the command line takes them: one for all laws, and some for laws by name. */
    function limits() {
        let most = 0.01;
        const own = LAWS.map(() => 0);
        for (const part of threshold.value.split(/[,;]/).map((part) => part.trim()).filter(Boolean)) {
            const [number, law] = part.split("=").map((word) => word.trim()).reverse();
            const limit = number === "" ? NaN : Number(number);
            if (!(limit > 0 && limit < Infinity)) throw new Error(`what a law may be off by is a number above zero, but \`${number}\` is typed`);
            if (law === undefined) most = limit;
            else if (LAWS.includes(law)) own[LAWS.indexOf(law)] = limit;
            else throw new Error(`there is no law \`${law}\`; there are ${LAWS.join(", ")}`);
        }
        return { most, own };
    }

    /** To how many rows the start is to be fitted, as typed; none: 0. */
    function fitted() {
        const rows = Number(fit.value);
        if (!fit.validity.valid || !Number.isInteger(rows) || rows < 0 || rows === 1) {
            throw new Error("the start is fitted to a whole number of rows, two at least, or to none");
        }
        return rows;
    }

    function judge(record, name) {
        last = [record, name];
        try {
            const { most, own } = limits();
            turn += 1;
            worker.postMessage({ record, asked: [...typed(), most, fitted(), ...own], turn });
            stage.setAttribute("aria-busy", "true");
        } catch (why) {
            complain(why.message);
        }
    }

    function complain(what) {
        place.hidden = true;
        wrong.hidden = false;
        wrong.textContent = `${what}.`;
    }

    worker.onmessage = ({ data }) => {
        if (data.turn !== turn) return;
        stage.removeAttribute("aria-busy");
        const [, name] = last;
        if (!data.judged) return complain(`${name}: ${data.said}`);
        wrong.hidden = true;
        show(JSON.parse(data.said), name);
    };

    /** An element with a text, which is never read as HTML: a record may hold any words. */
    function put(parent, kind, words = "", name = "") {
        const element = document.createElement(kind);
        element.textContent = words;
        if (name) element.className = name;
        parent.append(element);
        return element;
    }

    function list(title, items) {
        if (items.length === 0) return;
        put(place, "p", title, "live-title");
        const all = put(place, "ul");
        for (const item of items) put(all, "li", item);
    }

    function show(verdict, name) {
        place.replaceChildren();
        const outcome = { passed: "Passed", failed: "Failed", "nothing to judge": "Nothing to judge" }[verdict.outcome];
        put(place, "p", `${outcome}: ${name}`, `live-outcome ${verdict.outcome === "failed" ? "live-failed" : ""}`);
        const step = verdict.step ? `steps of ${short(verdict.step)} s` : "steps of various lengths";
        put(place, "p", `${verdict.rows} rows, ${step}, judged over ${short(verdict.duration)} s; ` +
            `moments ${verdict.moments.map((moment) => Number(moment.toPrecision(6))).join(", ")} kg m²${verdict.engine ? `; ${verdict.engine}` : ""}.`);

        if (verdict.fit) {
            const { rows, moved, left } = verdict.fit;
            put(place, "p", `The start is fitted to the first ${rows} rows: ${short(moved)} rad/s from the first one; ${short(left)} rad/s are left.`);
        }
        const resets = verdict.resets.map(({ line, time, to_rest, to_start }) => {
            const how = to_rest ? "is put to rest" : to_start ? "is put back to its start" : "jumps to another motion";
            return `line ${line}, at ${short(time)} s: the body ${how}; judged up to there`;
        });
        const gaps = verdict.gaps ? [`rows are missing in ${verdict.gaps.count} places, the first before line ${verdict.gaps.line}`] : [];
        const untold = verdict.untold.length ? [`it does not tell: ${verdict.untold.map((law) => UNTOLD[law] ?? law).join(", ")}`] : [];
        list("The file", [...verdict.misread, ...resets, ...gaps, ...untold]);

        tumblingLive.judgePicture(place, verdict);

        if (verdict.laws.length > 0) {
            const frame = put(place, "div", "", "table-wrapper");
            const table = put(frame, "table");
            const head = put(put(table, "thead"), "tr");
            for (const title of ["law", "off by at most", "at the end", "how it grows"]) put(head, "th", title).scope = "col";
            const body = put(table, "tbody");
            for (const law of verdict.laws) {
                const row = put(body, "tr");
                put(row, "th", law.words).scope = "row";
                for (const number of [law.most, law.last]) put(row, "td", number === null ? "beyond counting" : short(number));
                put(row, "td", law.growth);
            }
        }
        list("What is wrong besides", verdict.complaints);

        if (verdict.diagnosis) {
            const { best, sure, alike, hints, advice } = verdict.diagnosis;
            const how = {
                "to rounding": "Every step is made by", "most steps": "Most steps, but not all, are made by",
                near: "Most like", "none fits": "None of the known rules fits. Nearest is",
            }[sure];
            put(place, "p", "What made it", "live-title");
            put(place, "p", `${how}: ${best.rule}${best.engines.length ? ` (as in ${best.engines.join("; ")})` : ""}.`);
            const others = alike.map(({ rule }) => rule);
            if (others.length) put(place, "p", `Not to be told from it here: ${others.join("; ")}.`);
            for (const hint of hints) put(place, "p", hint);
            if (advice) put(place, "p", `What to do: ${advice}`);
        }
        const more = put(place, "details");
        put(more, "summary", "As the command line prints it");
        const printed = put(put(more, "pre"), "code", verdict.words);
        printed.tabIndex = 0;
        place.hidden = false;
        place.focus({ preventScroll: true });
        say(`${outcome}. ${verdict.laws.length} laws judged.`);
    }

    const lines = () => new Blob([text.value]);
    go.addEventListener("click", () => judge(lines(), "the lines above"));
    file.addEventListener("change", () => file.files[0] && judge(file.files[0], file.files[0].name));
    example.addEventListener("click", async () => {
        await load(`${from}judge.example.js`);
        text.value = new TextDecoder().decode(bytes("judge.example"));
        judge(lines(), "the example");
    });
    for (const field of [moments, threshold, fit]) field.addEventListener("change", () => last && judge(...last));
    for (const kind of ["dragenter", "dragover"]) {
        drop.addEventListener(kind, (event) => {
            event.preventDefault();
            drop.classList.add("live-over");
        });
    }
    drop.addEventListener("dragleave", () => drop.classList.remove("live-over"));
    drop.addEventListener("drop", (event) => {
        event.preventDefault();
        drop.classList.remove("live-over");
        const [dropped] = event.dataTransfer.files;
        if (dropped) judge(dropped, dropped.name);
    });
});
