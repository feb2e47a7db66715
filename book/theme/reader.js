// What the pages need besides mdBook's own script: a menu button, and keys for boxes that scroll.
"use strict";

// mdBook's menu button is a <label>, which no keyboard reaches. Ours is a button, and passes the click
// on to the checkbox that the sidebar hangs on.
(function menuButton() {
    const checkbox = document.getElementById("mdbook-sidebar-toggle-anchor");
    document.getElementById("mdbook-sidebar-toggle").addEventListener("click", () => checkbox.click());
})();

// The search needs scripts, so what it lacks is said here: what its parts are, to those who do not see them.
(function searchInWords() {
    for (const [id, attributes] of Object.entries({
        "mdbook-search-wrapper": { role: "search" },
        "mdbook-searchresults-header": { role: "status" },
    })) {
        for (const [name, value] of Object.entries(attributes)) document.getElementById(id)?.setAttribute(name, value);
    }
})();

// A formula, figure, table or program wider than the window scrolls in its own box. Only while it
// does may the keyboard stop there, to scroll it by the arrows.
(function scrollingBoxes() {
    const kinds = {
        ".math-display": "Formula",
        ".fig-frame": "Figure",
        ".table-wrapper": "Table",
        "pre > code": "Program",
    };
    const seen = new ResizeObserver((entries) => entries.forEach(({ target }) => mark(target)));

    function mark(box) {
        if (box.scrollWidth > box.clientWidth + 1) {
            box.tabIndex = 0;
            box.setAttribute("role", "group");
            box.setAttribute("aria-label", box.dataset.kind + ", scrolls sideways");
        } else {
            for (const attribute of ["tabindex", "role", "aria-label"]) {
                box.removeAttribute(attribute);
            }
        }
    }

    for (const [selector, kind] of Object.entries(kinds)) {
        for (const box of document.querySelectorAll(selector)) {
            box.dataset.kind = kind;
            seen.observe(box);
        }
    }
    // A page without a program in sight fetches their font when a fold opens: then lines grow wider, and no box its size.
    document.fonts.addEventListener("loadingdone", () => document.querySelectorAll("[data-kind]").forEach(mark));

    // mdBook turns pages by the arrow keys; inside a box that scrolls they are the box's.
    document.addEventListener("keydown", (event) => {
        if (event.key.startsWith("Arrow") && event.target.closest("[data-kind][tabindex]")) {
            event.stopPropagation();
        }
    }, true);
})();

// The name of a test in a table breaks between its words; the page's CSS breaks it anywhere only if one word is too long.
(function longNames() {
    for (const code of document.querySelectorAll("td code")) {
        const [first, ...others] = code.textContent.split(/(?<=_)/);
        code.replaceChildren(first, ...others.flatMap((word) => [document.createElement("wbr"), word]));
    }
})();

// A drawing opens large over its page, in its colours; Escape, the button or a click beside it leads back. In a window of
// its own it takes the page's theme along, at the end of its address.
(function largeFigures() {
    const links = document.querySelectorAll("a.fig-large");
    if (links.length === 0) return;
    const themes = ["light", "rust", "coal", "navy", "ayu"];
    const aim = () => {
        const theme = themes.find((name) => document.documentElement.classList.contains(name));
        for (const link of links) link.hash = theme ? `${link.pathname.split("/").at(-1).replace(".svg", "")}-${theme}` : "";
    };
    aim();
    new MutationObserver(aim).observe(document.documentElement, { attributeFilter: ["class"] });

    for (const link of links) {
        link.addEventListener("click", (event) => {
            if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey || !HTMLDialogElement.prototype.showModal) return;
            event.preventDefault();
            const frame = link.closest(".fig").querySelector(".fig-frame");
            const drawing = frame.querySelector("svg");
            const dialog = document.createElement("dialog");
            dialog.className = "fig-dialog";
            dialog.setAttribute("aria-label", "Figure, large");
            const button = Object.assign(document.createElement("button"), { type: "button", textContent: "Close" });
            frame.style.minHeight = `${frame.offsetHeight}px`; // the page keeps its place
            dialog.append(button, drawing);
            document.body.append(dialog);
            dialog.addEventListener("click", ({ target }) => (target === dialog || target === button) && dialog.close());
            dialog.addEventListener("keydown", (event) => event.stopPropagation()); // mdBook turns pages by keys
            dialog.addEventListener("close", () => {
                frame.append(drawing);
                frame.style.minHeight = "";
                dialog.remove();
                link.focus({ preventScroll: true });
            });
            dialog.showModal();
        });
    }
})();

// All programs of the text are folded; the button opens them all, here and on the pages to come.
(function codeFolds() {
    const button = document.getElementById("code-toggle");
    const folds = [...document.querySelectorAll("main details.program")];
    if (folds.length === 0) return;

    // A page opened from disk may have no storage; then the choice lasts as long as the page.
    const remembered = (choice) => {
        try {
            if (choice !== undefined) localStorage.setItem("tumbling-code", choice);
            return localStorage.getItem("tumbling-code");
        } catch {
            return null;
        }
    };

    function show(shown) {
        button.setAttribute("aria-pressed", String(shown));
        for (const fold of folds) fold.open = shown;
    }

    button.hidden = false;
    show(remembered() === "shown");
    button.addEventListener("click", () => {
        const shown = button.getAttribute("aria-pressed") !== "true";
        remembered(shown ? "shown" : "folded");
        show(shown);
    });
})();
