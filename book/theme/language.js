// What scripts write in English stands here in the page's language, with a decimal comma: tumblingWords has the words.
(function language(page) {
    if (/\/print\.html$/.test(location.pathname)) return;
    const escaped = (words) => words.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
    const parts = Object.keys(tumblingWords).sort((a, b) => b.length - a.length).map(escaped);
    const known = new RegExp(`(?<!\\p{L})(?:${parts.join("|")})(?!\\p{L})`, "gu");
    const said = (text) => tumblingWords[text] ?? text.replace(/(\d)\.(?=\d)/g, "$1,").replace(known, (part) => tumblingWords[part]);
    const LABELS = ["aria-label", "aria-valuetext", "title"];
    const original = location.pathname.replace(/-[a-z]+(?=\.html$)/, "");
    function tell(node) {
        if (node.nodeType === Node.TEXT_NODE) {
            if (!node.parentElement?.closest("script, pre, #mdbook-sidebar strong") && said(node.data) !== node.data) node.data = said(node.data);
            return;
        }
        // The table of contents leads to this chapter in its own language.
        if (node.pathname === original && titles?.contains(node)) node.pathname = location.pathname;
        for (const label of LABELS) {
            const text = node.getAttribute?.(label);
            if (text && said(text) !== text) node.setAttribute(label, said(text));
        }
        node.childNodes.forEach(tell);
    }
    const seen = new MutationObserver((changes) => {
        for (const { type, target, addedNodes } of changes) {
            const changed = type === "childList" ? [...addedNodes] : [target];
            // Of what the frame gains, a figure's dialog alone is of this page.
            changed.filter((node) => target !== document.body || node.nodeName === "DIALOG").forEach(tell);
        }
    });
    const [titles, found] = ["mdbook-sidebar", "mdbook-searchresults-header"].map((id) => document.getElementById(id));
    if (titles) tell(titles);
    for (const part of [page, titles, found]) {
        if (part) seen.observe(part, { subtree: true, childList: true, characterData: true, attributeFilter: LABELS });
    }
    seen.observe(document.body, { childList: true });
})(document.currentScript.parentElement);
