// A verdict in words and a table, and in a line. What the record itself says is never read as HTML.
"use strict";

tumblingLive.judgeVerdict = (() => {
    const { raised, short } = tumblingLive;
    /** The judge's words, with the indices and powers that a terminal has no room for. */
    const typeset = (words) => words.replace("I2", "I₂").replace("L^2", "L²");
    const capital = (words) => `${words[0].toUpperCase()}${words.slice(1)}`;

    /** An element with a text. */
    function put(parent, kind, words = "", name = "") {
        const element = document.createElement(kind);
        element.textContent = words;
        if (name) element.className = name;
        parent.append(element);
        return element;
    }

    function list(place, title, items) {
        if (items.length === 0) return;
        put(place, "p", title, "live-title");
        const all = put(place, "ul");
        for (const item of items) put(all, "li", item);
    }

    /** Four digits, as the command line prints them. */
    function digits(number) {
        if (number === null) return "beyond counting";
        if (number === 0) return "0";
        const [front, power] = number.toExponential(3).split("e");
        const small = power < -3 || power > 4;
        return (small ? `${front} · 10${raised(Number(power))}` : number.toPrecision(4)).replace("-", "−");
    }

    /** Whether a law is broken by more than is allowed. */
    const broken = ({ most, allowed }) => allowed !== null && !(most !== null && Math.abs(most) <= allowed);

    function table(place, laws) {
        const table = put(put(place, "div", "", "table-wrapper"), "table");
        // Narrow pages lay a row out in two lines: the roles stay what they are.
        const part = (parent, kind, role, words) => {
            const element = put(parent, kind, words);
            element.setAttribute("role", role);
            return element;
        };
        table.setAttribute("role", "table");
        const head = part(part(table, "thead", "rowgroup"), "tr", "row");
        for (const title of ["law", "off by at most", "at the end", "how it grows"]) part(head, "th", "columnheader", title).scope = "col";
        const body = part(table, "tbody", "rowgroup");
        for (const law of laws) {
            const row = part(body, "tr", "row");
            part(row, "th", "rowheader", typeset(law.heading)).scope = "row";
            const most = part(row, "td", "cell", digits(law.most));
            if (broken(law)) put(most, "span", ` (allowed: ${law.allowed})`, "live-failed");
            part(row, "td", "cell", digits(law.last));
            part(row, "td", "cell", law.growth);
        }
    }

    function diagnosis(place, { heading, details, advice }) {
        put(place, "p", "What made it", "live-title");
        put(place, "p", `${heading}.`);
        for (const detail of details) put(place, "p", `${capital(detail)}${detail.endsWith(".") ? "" : "."}`);
        put(place, "p", `What to do: ${advice}`);
    }

    /** The whole verdict, in place of what was there. */
    function show(place, verdict, name) {
        place.replaceChildren();
        const failed = verdict.outcome === "failed";
        put(place, "p", `${capital(verdict.outcome)}: ${name}`, `live-outcome ${failed ? "live-failed" : ""}`);
        if (verdict.reason) put(place, "p", `${capital(verdict.reason)}.`);
        const step = verdict.step ? `steps of ${digits(verdict.step)} s` : "steps of various lengths";
        put(place, "p", `${verdict.rows} rows, ${step}, judged over ${short(verdict.duration)} s; ` +
            `moments ${verdict.moments.map((moment) => Number(moment.toPrecision(6))).join(", ")} kg m²${verdict.engine ? `; ${verdict.engine}` : ""}.`);
        if (verdict.fit) {
            const { rows, moved, left } = verdict.fit;
            put(place, "p", `The start is fitted to the first ${rows} rows: ${short(moved)} rad/s from the first one; ${short(left)} rad/s are left.`);
        }
        list(place, "The file", verdict.file);
        tumblingLive.judgePicture(place, verdict);
        if (verdict.laws.length > 0) table(place, verdict.laws);
        const { separatrix, flips, torque } = verdict;
        if (separatrix?.every(Number.isFinite)) {
            put(place, "p", `Where the spin is heading: 2 E I₂ / L² goes from ${separatrix.map((of) => of.toFixed(6)).join(" to ")}; the separatrix is at 1.`);
        }
        if (flips && torque === null) {
            put(place, "p", `The spin along the middle axis changes sign ${flips.found === 1 ? "once" : `${flips.found} times`} (exact: ${flips.exact}).`);
        }
        list(place, "What is wrong besides", verdict.complaints);
        if (verdict.diagnosis) diagnosis(place, verdict.diagnosis);
        const more = put(place, "details");
        put(more, "summary", "As the command line prints it");
        put(put(more, "pre"), "code", verdict.words).tabIndex = 0;
    }

    /** The verdict in a line: the outcome, and what there is to say of it. */
    function line({ outcome, laws, diagnosis }) {
        const worst = laws.filter(broken).map(({ words }) => typeset(words));
        const rule = diagnosis ? ` ${diagnosis.heading}.` : "";
        return [capital(outcome), `${worst.length ? ` (${worst.join(", ")})` : ""}.${rule}`];
    }

    return { show, line, put };
})();
