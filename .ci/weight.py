#!/usr/bin/env python3
"""Weighs the pages of the built book: what a reader's browser fetches to show each, as a host sends it (gzip); and counts the story's words.

    python3 .ci/weight.py [PAGES]

Counts the page, its styles and its scripts, not the fonts (fetched once for the whole book), not the index of
the search (fetched by the first search), not what a widget fetches when it comes into view. Fails above the
limit; the page for printing, which holds the whole book, is weighed and not limited.

The first page has a limit of its own for all that it fetches until its book tumbles: the scripts and modules of its
widgets, the fonts (those for formulas, code and names only if it has such) and its icon too. The same limit holds without scripts,
where a film stands in for the book.
"""

import gzip
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

LIMIT = 150_000
# Words of the story: the first page and the part "Why it flips".
STORY_LIMIT = 12_000
FIRST_LIMIT = 245_000


def fetched(page: Path) -> list[Path]:
    text = page.read_text(encoding="utf-8")
    targets = re.findall(r'<link rel="stylesheet"[^>]*href="([^"]+)"', text)
    targets += re.findall(r'<script[^>]* src="([^"]+)"', text)
    return [page] + [(page.parent / target).resolve() for target in targets if "fonts/" not in target]


def first(page: Path) -> list[Path]:
    """What the first page fetches besides: its widgets' own, fonts, icon."""
    text = page.read_text(encoding="utf-8")
    found = [page.parent / target for target in re.findall(r'<link rel="icon"[^>]*href="([^"]+)"', text)]
    for name, modules in re.findall(r'data-live="([a-z-]+)" data-modules="([a-z -]*)"', text):
        folder = page.parent / "widgets"
        parts = re.findall(r"\$\{from\}([a-z.]+\.js)", (folder / f"{name}.js").read_text(encoding="utf-8"))
        found += [folder / part for part in [f"{name}.js", *(f"{module}.wasm.js" for module in modules.split()), *parts]]
    sheets = [page.parent / target for target in re.findall(r'href="(fonts/[^"]+\.css)"', text)]
    fonts = [font for sheet in sheets for font in re.findall(r"url\('([^']+)'\)", sheet.read_text(encoding="utf-8"))]
    needed = {"math": "<math", "mono": "<(code|pre|textarea)", "names": "[\u0100-\u017f]"}
    used = [page.parent / "fonts" / font for font in fonts if all(name not in font or re.search(sign, text) for name, sign in needed.items())]
    if len(used) < 2 or not any(file.name.endswith(".wasm.js") for file in found):
        raise SystemExit("the first page has lost its fonts or its widget: look again at what it fetches")
    return sorted({file.resolve() for file in found + sheets + used})


def film(page: Path) -> list[Path]:
    """The heaviest of the films that stand in for the first page's book without scripts: a browser takes one."""
    text = page.read_text(encoding="utf-8")
    found = [page.parent / name for part in re.findall(r"<noscript>(.*?)</noscript>", text, re.S) for name in re.findall(r'src(?:set)?="([^"]+\.png)"', part)]
    if not found:
        raise SystemExit("the first page has lost its film for readers without scripts")
    return [max(found, key=lambda file: file.stat().st_size)]


class Words(HTMLParser):
    """The words that a page tells: captions, answers and exercises too; no code, formula, figure, fold, live part or foot."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[bool] = []  # of each element around: whether it tells nothing
        self.count = 0

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        if tag not in ("br", "img", "input", "hr", "source", "wbr"):
            silent = tag in ("script", "svg", "math", "details", "noscript", "template", "pre", "footer")
            self.open.append(silent or dict(attributes).get("class") in ("live-still", "live-stage"))

    def handle_endtag(self, tag: str) -> None:
        if self.open:
            self.open.pop()

    def handle_data(self, data: str) -> None:
        if not any(self.open):
            self.count += sum(any(map(str.isalnum, word)) for word in data.split())


def story(folder: Path) -> int:
    """How many words the story has."""
    summary = (Path(__file__).resolve().parent.parent / "book/chapters/SUMMARY.md").read_text(encoding="utf-8")
    count = 0
    for name in re.findall(r"\]\((.+)\.md\)", summary.split("\n# ")[0] + summary.split("\n# ")[1]):
        page = (folder / f"{name}.html").read_text(encoding="utf-8")
        words = Words()
        words.feed(page[page.index("<main") : page.index("</main>")])
        count += words.count
    return count


def main() -> int:
    default = Path(__file__).resolve().parent.parent / "book" / "html"
    folder = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else default
    known: dict[Path, tuple[int, int]] = {}

    def weight(file: Path) -> tuple[int, int]:
        if file not in known:
            data = file.read_bytes()
            # Fonts and pictures are compressed already.
            sent = data if file.suffix in (".woff2", ".png") else gzip.compress(data, 9)
            known[file] = (len(sent), len(data))
        return known[file]

    pages = []
    for page in folder.glob("*.html"):
        weights = [weight(file) for file in fetched(page)]
        pages.append((sum(w[0] for w in weights), sum(w[1] for w in weights), page.name))
    pages.sort(reverse=True)
    if not pages:
        print(f"there is no book in {folder}: build it first", file=sys.stderr)
        return 1
    for sent, whole, name in pages[:4] + pages[-1:]:
        print(f"{name:28} {sent / 1000:6.1f} kB sent, {whole / 1000:7.1f} kB unpacked")
    index = folder / "index.html"
    opening = sum(weight(file)[0] for file in fetched(index) + first(index))
    print(f"{'the first page, with all':28} {opening / 1000:6.1f} kB sent, of {FIRST_LIMIT / 1000:.0f}")
    still = [file for file in fetched(index) + first(index) if file.suffix != ".js"] + film(index)
    scriptless = sum(weight(file)[0] for file in still)
    print(f"{'the first page, no scripts':28} {scriptless / 1000:6.1f} kB sent, of {FIRST_LIMIT / 1000:.0f}")
    told = story(folder)
    print(f"{'the story':28} {told:6d} words, of {STORY_LIMIT}")
    if told > STORY_LIMIT:
        print(f"the story has more than {STORY_LIMIT} words", file=sys.stderr)
        return 1
    heavy = [name for sent, _, name in pages if sent > LIMIT and name != "print.html"]
    for name in heavy:
        print(f"{name} weighs more than {LIMIT / 1000:.0f} kB", file=sys.stderr)
    if max(opening, scriptless) > FIRST_LIMIT:
        print(f"the first page sends more than {FIRST_LIMIT / 1000:.0f} kB", file=sys.stderr)
    return 1 if heavy or max(opening, scriptless) > FIRST_LIMIT else 0


sys.exit(main())
