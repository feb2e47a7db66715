// The judge: records dropped, chosen or pasted are judged by the module, in a worker, piece by piece, one after the other.
"use strict";

tumblingLive.widget("judge", async (stage, from) => {
    const { bytes, load, sayer } = tumblingLive;
    await Promise.all(["picture", "verdict"].map((part) => load(`${from}judge.${part}.js`)));
    const { show, line, put } = tumblingLive.judgeVerdict;
    /** The laws that may have a limit of their own, in the judge's order. */
    const LAWS = ["energy", "momentum", "direction", "unit", "separatrix", "phase", "consistency"];
    const the = (id) => stage.querySelector(`#judge-${id}`);
    const [file, text, moments, threshold, go, example, progress, stop] =
        ["file", "text", "moments", "threshold", "go", "example", "progress", "stop"].map(the);
    const [wrong, place, reading, list] = ["wrong", "verdict", "reading", "records"].map((name) => stage.querySelector(`.live-${name}`));
    const say = sayer(stage);

    /** What runs in the worker: it knows nothing of what is around it here. */
    function work() {
        const PATIENCE = 200; // ms, so long nothing is told of a record, and then no more often
        let module;
        onmessage = async ({ data }) => {
            if (data.module) {
                module = data.module;
                return;
            }
            const { record, asked, turn } = data;
            const reader = new FileReaderSync();
            let at = 0;
            let exports = null;
            let told = performance.now();
            const more = (address, room) => {
                const piece = new Uint8Array(reader.readAsArrayBuffer(record.slice(at, at + room)));
                new Uint8Array(exports.memory.buffer).set(piece, address);
                at += piece.length;
                if (performance.now() - told > PATIENCE) {
                    told = performance.now();
                    postMessage({ turn, at });
                }
                return piece.length;
            };
            try {
                // A fresh one for each record: none has anything from the one before.
                ({ exports } = await WebAssembly.instantiate(module, { page: { more } }));
                new Float64Array(exports.memory.buffer, exports.numbers(), asked.length).set(asked);
                const judged = exports.answer(0) === 1;
                const said = new Uint8Array(exports.memory.buffer, exports.text(), exports.text_length());
                postMessage({ turn, judged, said: new TextDecoder().decode(said) });
            } catch (why) {
                // A folder has no bytes, and a file written anew is no longer the one that was chosen.
                postMessage({ turn, judged: false, said: `the record could not be read to its end (${why.message}); if it was written anew, choose it again` });
            }
        };
    }
    const code = URL.createObjectURL(new Blob([`"use strict";(${work})()`], { type: "text/javascript" }));
    // Here, and not first in the worker: a damaged module is no fault of any record.
    const module = await WebAssembly.compile(await bytes("judge"));

    let worker = hire();
    let busy = false;
    let turn = 0; // only the answer to the last question counts
    let records = []; // those asked for last: each with its name, its bytes and, once judged, its answer
    let now = 0; // which of them is being judged
    let shown = -1; // which is to be seen
    let wish = 0; // and which is to be seen once it is judged
    let asked = [];

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

    function hire() {
        const hired = new Worker(code);
        hired.onmessage = heard;
        hired.postMessage({ module });
        return hired;
    }

    /** Ends what is being judged. A worker that is busy hears nothing before it has read all: another takes its place. */
    function halt() {
        turn += 1;
        if (busy) {
            worker.terminate();
            worker = hire();
        }
        busy = false;
        stage.removeAttribute("aria-busy");
        reading.hidden = true;
    }

    /** Judges these records, each `{ name, record }`, in place of all before. */
    function judge(all, first = 0) {
        halt();
        wish = first;
        records = all.map(({ name, record }) => ({ name, record }));
        shown = -1;
        list.hidden = true;
        list.replaceChildren();
        try {
            const { most, own } = limits();
            asked = [...typed(), most, ...own];
        } catch (why) {
            complain(why.message);
            return;
        }
        if (records.length > 1) offer();
        next(0);
    }

    function next(which) {
        now = which;
        const { record } = records[now];
        turn += 1;
        busy = true;
        worker.postMessage({ record, asked, turn });
        stage.setAttribute("aria-busy", "true");
    }

    function complain(what) {
        place.hidden = true;
        wrong.hidden = false;
        wrong.textContent = `${what}.`;
    }

    function heard({ data }) {
        if (data.turn !== turn) return;
        if (data.at !== undefined) return tell(data.at);
        busy = false;
        reading.hidden = true;
        const of = records[now];
        of.verdict = data.judged ? JSON.parse(data.said) : null;
        of.why = data.said;
        if (records.length > 1) offered(now, ...(of.verdict ? line(of.verdict) : ["Cannot be judged", `: ${of.why}.`]));
        if (now === wish) open(now);
        if (now + 1 < records.length) return next(now + 1);
        stage.removeAttribute("aria-busy");
        if (records.length > 1) return sum();
        if (of.verdict) say(`${line(of.verdict).join("")} ${of.verdict.laws.length} laws judged.`);
        // Reading goes on at the verdict, unless the reader has gone elsewhere.
        if ([document.body, go, file, example, stop].includes(document.activeElement)) place.focus({ preventScroll: true });
    }

    /** How far a long record is read. What is shown of another goes, so that nobody takes it for this one's. */
    function tell(at) {
        const { name, record: { size } } = records[now];
        const unit = size < 1e6 ? ["kB", 1e3] : ["MB", 1e6];
        const [read, whole] = [at, size].map((of) => (of / unit[1]).toFixed(1));
        reading.hidden = false;
        reading.firstElementChild.textContent = `Judging ${name}: ${read} of ${whole} ${unit[0]} are read.`;
        progress.value = at / (size || 1);
        if (records.length === 1) place.hidden = wrong.hidden = true;
        // By quarters, since a voice takes longer than an eye.
        const quarter = Math.floor(4 * at / (size || 1));
        if (records[now].quarter === quarter) return;
        records[now].quarter = quarter;
        say(`Judging ${name}: ${["begun", "a quarter is read", "half is read", "three quarters are read", "all is read"][quarter]}.`);
    }

    /** Shows the verdict on one of the records. */
    function open(which) {
        shown = which;
        const { name, verdict, why } = records[which];
        [...list.children].forEach((item, i) => item.firstElementChild.setAttribute("aria-pressed", String(i === which)));
        if (!verdict) return complain(`${name}: ${why}`);
        wrong.hidden = true;
        show(place, verdict, name);
        place.hidden = false;
    }

    /** A line for each record, of which a button opens the whole. */
    function offer() {
        records.forEach(({ name }, which) => {
            const item = put(list, "li");
            const button = put(item, "button", name);
            button.type = "button";
            button.disabled = true;
            button.addEventListener("click", () => {
                wish = -1;
                open(which);
                say(`The verdict on ${name} is shown.`);
            });
            item.append(" ");
            put(item, "span", "waits");
        });
        list.hidden = false;
        place.hidden = wrong.hidden = true;
    }

    function offered(which, outcome, words) {
        const [button, told] = list.children[which].children;
        button.disabled = false;
        told.replaceChildren();
        put(told, "span", outcome, ["Failed", "Cannot be judged"].includes(outcome) ? "live-failed" : "");
        told.append(words);
    }

    /** What became of them all, said. */
    function sum() {
        const NONE = "cannot be judged";
        const count = (outcome) => records.filter(({ verdict }) => (verdict?.outcome ?? NONE) === outcome).length;
        const outcomes = [...new Set(records.map(({ verdict }) => verdict?.outcome ?? NONE))].sort();
        const parts = outcomes.map((outcome) => `${count(outcome)} ${outcome}`);
        say(`${records.length} records: ${parts.join(", ")}.`);
    }

    stop.addEventListener("click", () => {
        const left = records.slice(now);
        halt();
        for (let i = now; records.length > 1 && i < records.length; i += 1) list.children[i].lastElementChild.textContent = "not judged";
        const what = `Stopped: ${left.length === 1 ? `${left[0].name} is` : `${left.length} records are`} not judged`;
        if (records.length === 1) complain(what);
        else say(`${what}.`);
        go.focus({ preventScroll: true });
    });

    const lines = (name) => {
        file.value = ""; // it would name what is judged no more
        judge([{ name, record: new Blob([text.value]) }]);
    };
    const files = (all) => judge(all.map((record) => ({ name: record.name, record })));
    go.addEventListener("click", () => lines("the lines above"));
    file.addEventListener("click", () => { file.value = ""; }); // so that the same file may be chosen again, written anew
    file.addEventListener("change", () => file.files.length > 0 && files([...file.files]));
    example.addEventListener("click", async () => {
        await load(`${from}judge.example.js`);
        text.value = new TextDecoder().decode(await bytes("judge.example"));
        lines("the example");
    });
    for (const field of [moments, threshold]) field.addEventListener("change", () => records.length > 0 && judge(records, Math.max(0, shown)));
    stage.addEventListener("live-files", ({ detail }) => {
        file.value = "";
        files(detail);
        const { top } = list.parentElement.getBoundingClientRect();
        if (top < 0 || top > 0.7 * innerHeight) list.parentElement.scrollIntoView();
    });
});
