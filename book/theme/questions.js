// Questions: the answer waits until the reader has chosen one of several, or has set a slider to where it should be.
"use strict";

(function questions() {
    const make = (kind, given = {}, ...inside) => {
        const element = Object.assign(document.createElement(kind), given);
        element.append(...inside);
        return element;
    };

    for (const box of document.querySelectorAll(".question")) {
        // The whole book for printing asks nothing.
        if (/\/print\.html$/.test(location.pathname)) {
            box.dataset.state = "told";
            continue;
        }
        const quote = box.querySelector("blockquote");
        const answer = quote.lastElementChild;
        const right = answer.querySelector("em");
        const list = quote.querySelector("ul");
        const place = make("div", { role: "status" });
        const tell = (...first) => {
            box.dataset.state = "told";
            answer.prepend(...first);
            place.append(answer);
        };
        answer.before(place);
        const same = (a, b) => a.innerHTML.trim() === b.innerHTML.trim();
        if (list) choose();
        else guess();

        function choose() {
            const options = [...list.children].map((item) => ({ item, is: same(item, right) }));
            for (const { item, is } of options) {
                const button = make("button", { type: "button" }, ...item.childNodes);
                item.append(button);
                button.addEventListener("click", () => {
                    if (box.dataset.state === "told") return;
                    for (const option of options) option.item.classList.toggle("question-right", option.is);
                    item.classList.toggle("question-wrong", !is);
                    button.setAttribute("aria-pressed", "true");
                    tell(is ? "Right. " : "No. ");
                });
            }
        }

        function guess() {
            const [, digits, unit] = right.textContent.replace(",", ".").match(/^([\d.]+)\s*(.*)$/);
            const value = Number(digits);
            const power = 10 ** Math.floor(Math.log10(2.2 * value));
            const most = unit === "°" ? 90 : [2, 5, 10].map((step) => step * power).find((most) => most >= 2.2 * value);
            const decimals = Math.max(0, 2 - Math.ceil(Math.log10(most)));
            const written = (x) => `${x.toFixed(decimals)}${unit === "°" ? "°" : ` ${unit}`}`;
            const output = make("output", {}, "?");
            const slider = make("input", { type: "range", min: 0, max: most, step: 10 ** -decimals, value: 0, ariaLabel: `Your guess, ${unit || "as a number"}` });
            const button = make("button", { type: "button", disabled: true }, "See");
            const track = make("span", { className: "question-track" }, slider);
            slider.addEventListener("input", () => {
                output.textContent = written(Number(slider.value));
                slider.ariaValueText = output.textContent;
                button.disabled = box.dataset.state === "told";
            });
            button.addEventListener("click", () => {
                button.disabled = true;
                slider.disabled = true;
                const mark = make("span", { className: "question-mark", ariaHidden: "true" });
                mark.style.setProperty("--at", value / most);
                track.append(mark);
                tell(`You: ${written(Number(slider.value))}. `);
            });
            place.before(make("p", { className: "question-guess" }, track, output, button));
        }
        box.addEventListener("keydown", (event) => event.stopPropagation()); // mdBook turns pages by keys
    }
})();
