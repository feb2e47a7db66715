// Chooses in the atlas: a case, a column of it, a method; and says what became of it.
(function atlas() {
    const root = document.currentScript.previousElementSibling;
    const charts = [...root.querySelectorAll("[data-chart]")];
    const choice = root.querySelector(".atlas-choice");
    const said = root.querySelector(".atlas-fate");
    const meanings = new Map([...root.querySelectorAll(".atlas-key li")].map((item) =>
        [item.firstChild.textContent, item.textContent.split(": the method ")[1]]));
    const words = (cell) => cell.firstChild?.textContent ?? "";

    function list(label) {
        const select = document.createElement("select");
        const name = document.createElement("label");
        name.append(label + " ", select);
        choice.append(name, " ");
        select.addEventListener("change", show);
        return select;
    }

    function fill(select, names) {
        const before = select.value;
        select.replaceChildren(...names.map((text) => new Option(text, text)));
        if (names.includes(before)) select.value = before;
    }

    const body = list("Body");
    const step = list("At");
    const method = list("Method");

    function show() {
        const chart = charts.find((one) => one.dataset.chart === body.value);
        const heads = [...chart.querySelectorAll("thead th")].slice(1).map((th) => th.textContent);
        const rows = [...chart.querySelectorAll("tbody tr")];
        fill(step, heads);
        fill(method, rows.map((row) => row.firstChild.textContent));
        for (const one of charts) one.hidden = one !== chart;
        root.querySelector(".atlas-chosen")?.classList.remove("atlas-chosen");
        const row = rows.find((one) => one.firstChild.textContent === method.value);
        const cell = row.children[1 + heads.indexOf(step.value)];
        cell.classList.add("atlas-chosen");
        const single = cell.querySelector("small")?.textContent.replace("single: ", "");
        const at = chart.dataset.columns === "case" ? step.value : `${chart.dataset.columns}: ${step.value}`;
        said.textContent = `${method.value} (${body.value}, ${at}): it ${meanings.get(words(cell))}`
            + (single ? ` In single precision it ${meanings.get(single)}` : "");
    }

    fill(body, charts.map((one) => one.dataset.chart));
    choice.hidden = false;
    show();
    // A cell is chosen by a click as well.
    root.addEventListener("click", (event) => {
        const cell = event.target.closest("tbody td");
        if (!cell) return;
        method.value = cell.parentElement.firstChild.textContent;
        step.selectedIndex = cell.cellIndex - 1;
        show();
    });
})();
