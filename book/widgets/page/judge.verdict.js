// A verdict on the page: the judge's own words, a picture and a table. What a record says is never read as HTML.
"use strict";

tumblingLive.judgeVerdict = (() => {
    /** An element with a text. */
    function put(parent, kind, words = "", name = "") {
        const element = document.createElement(kind);
        element.textContent = words;
        if (name) element.className = name;
        parent.append(element);
        return element;
    }

    /** A law that is broken by more than is allowed, and than the record's digits leave open. */
    const broken = ({ most, allowed, grade }) =>
        allowed !== null && grade !== "kept to rounding" && !(most !== null && Math.abs(most) <= allowed);

    function table(place, rows, { columns, laws }) {
        const table = put(put(place, "div", "", "table-wrapper"), "table");
        // Narrow pages lay a row out in two lines: the roles stay what they are.
        const part = (parent, kind, role, words) => {
            const element = put(parent, kind, words);
            element.setAttribute("role", role);
            return element;
        };
        table.setAttribute("role", "table");
        const head = part(part(table, "thead", "rowgroup"), "tr", "row");
        for (const title of columns) part(head, "th", "columnheader", title).scope = "col";
        const body = part(table, "tbody", "rowgroup");
        rows.forEach(([name, ...numbers], i) => {
            const row = part(body, "tr", "row");
            part(row, "th", "rowheader", name).scope = "row";
            const [most] = numbers.map((words) => part(row, "td", "cell", words));
            if (broken(laws[i])) put(most, "span", ` (allowed: ${laws[i].allowed})`, "live-failed");
        });
    }

    function section(place, { title, table: rows, lines }, verdict) {
        if (rows.length > 0) {
            tumblingLive.judgePicture(place, verdict);
            put(place, "p", title, "live-title");
            table(place, rows, verdict);
            for (const line of lines) put(place, "p", line);
        } else if (lines.length === 1) {
            put(place, "p", `${title}: ${lines[0]}`);
        } else {
            put(place, "p", title, "live-title");
            const all = put(place, "ul");
            for (const line of lines) put(all, "li", line);
        }
    }

    /** The whole verdict, in place of what was there. */
    function show(place, verdict, name) {
        place.replaceChildren();
        const [{ title, lines }, ...others] = verdict.report;
        put(place, "p", `${title}: ${name}`, `live-outcome ${verdict.outcome === "failed" ? "live-failed" : ""}`);
        for (const line of lines) put(place, "p", line);
        for (const part of others) section(place, part, verdict);
        if (verdict.laws.length === 0) tumblingLive.judgePicture(place, verdict);
    }

    /** The verdict in a line: the outcome, and what there is to say of it. */
    function line({ report: [{ title, lines }] }) {
        return [title, `: ${lines.slice(0, 2).join(" ")}`];
    }

    return { show, line, put };
})();
