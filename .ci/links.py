#!/usr/bin/env python3
"""Follows every link inside the built book and looks for what the pages load from elsewhere.

    python3 .ci/links.py [PAGES]

Fails on a link to a page, file or fragment that is not there; on an id used twice in a page; on an
ARIA attribute, or a reference inside a drawing, to an id that is not there; and on any script, style,
picture, font or frame that is not one of the book's own files. Plain links to other sites are fine:
nobody follows them for the reader.
"""

import re
import sys
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# What a page loads by itself, rather than leads to.
LOADS = {"script", "img", "iframe", "source", "audio", "video", "embed", "object", "image", "use", "feimage"}
REFERS = {"aria-labelledby", "aria-describedby", "aria-controls", "aria-details", "for"}


class Page(HTMLParser):
    """The ids of a page, and all that it refers to."""

    def __init__(self, path: Path) -> None:
        super().__init__(convert_charrefs=True)
        self.ids: list[str] = []
        self.links: list[tuple[str, bool]] = []  # target, and whether it is loaded
        self.local: list[str] = []  # ids of this page that it refers to
        self.base = False
        self.styles: list[str] = []
        self._in_style = False
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._in_style = tag == "style"
        given = {name: value or "" for name, value in attrs}
        if "id" in given:
            self.ids.append(given["id"])
        if tag == "base":
            self.base = True
        for name, value in given.items():
            if name in ("href", "xlink:href", "src", "data", "poster", "action"):
                loaded = tag in LOADS or (tag == "link" and "canonical" not in given.get("rel", ""))
                if not (tag == "link" and "prefetch" in given.get("rel", "")):
                    self.links.append((value, loaded))
            elif name == "srcset":
                self.links.extend((part.split()[0], True) for part in value.split(",") if part.strip())
            elif name in REFERS:
                self.local.extend(value.split())
            else:
                self.styles.append(value) if "url(" in value else None

    def handle_data(self, data: str) -> None:
        if self._in_style:
            self.styles.append(data)

    def handle_endtag(self, tag: str) -> None:
        self._in_style = False


def urls(css: str) -> list[str]:
    css = re.sub(r"/\*.*?\*/", "", css, flags=re.S)
    found = re.findall(r"url\(\s*(?:'([^']*)'|\"([^\"]*)\"|([^)\s]*))\s*\)", css)
    found += [(target, "", "") for target in re.findall(r"@import\s+['\"]([^'\"]+)", css)]
    return ["".join(parts) for parts in found]


def check(folder: Path) -> list[str]:
    # The library's documentation is rustdoc's to check, and is (`cargo doc -D warnings`); links into it are ours.
    ours = (path for path in sorted(folder.rglob("*.html")) if path.relative_to(folder).parts[0] != "api")
    pages = {path: Page(path) for path in ours}
    faults: list[str] = []
    counted = 0

    def follow(page: Path, target: str, loaded: bool) -> None:
        nonlocal counted
        parts = urlsplit(target)
        if parts.scheme == "data" or (parts.scheme == "mailto" and not loaded):
            return
        if parts.scheme or parts.netloc:
            if loaded:
                faults.append(f"{page.name}: loads {target}")
            elif parts.scheme not in ("http", "https"):
                faults.append(f"{page.name}: a link of a strange kind: {target}")
            return
        counted += 1
        path = (page.parent / unquote(parts.path)).resolve() if parts.path else page
        if path.is_dir():
            path = path / "index.html"
        if not path.is_relative_to(folder) or not path.is_file():
            faults.append(f"{page.name}: leads to {target}, which is not there")
        elif parts.fragment and path in pages and unquote(parts.fragment) not in pages[path].ids:
            faults.append(f"{page.name}: leads to {target}, but that page has no such place")

    for path, page in pages.items():
        faults += [f"{path.name}: the id {i} is used {n} times" for i, n in Counter(page.ids).items() if n > 1]
        # mdBook names the results of a search before they are there.
        faults += [f"{path.name}: refers to the id {i}, which is not there" for i in page.local if i not in page.ids]
        for target, loaded in page.links:
            follow(path, target, loaded)
        for style in page.styles:
            for target in urls(style):
                if target.startswith("#"):
                    if target[1:] not in page.ids:
                        faults.append(f"{path.name}: a drawing refers to {target}, which is not there")
                else:
                    follow(path, target, True)
    for path in sorted(folder.rglob("*.css")):
        if path.relative_to(folder).parts[0] == "api":
            continue
        for target in urls(path.read_text(encoding="utf-8")):
            follow(path, target, True)
    if len(pages) < 3 or counted < 10:
        faults.append(f"there is no book in {folder}: build it first")
    print(f"links: {len(pages)} pages, {counted} links inside the book, {len(faults)} faults")
    return faults


if __name__ == "__main__":
    default = Path(__file__).resolve().parent.parent / "book" / "html"
    FAULTS = check(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else default)
    print("\n".join(FAULTS), file=sys.stderr)
    sys.exit(1 if FAULTS else 0)
