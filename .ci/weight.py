#!/usr/bin/env python3
"""Weighs the pages of the built book: what a reader's browser fetches to show each, as a host sends it (gzip).

    python3 .ci/weight.py [PAGES]

Counts the page, its styles and its scripts, not the fonts (fetched once for the whole book), not the index of
the search (fetched by the first search), not what a widget fetches when it comes into view. Fails above the
limit; the page for printing, which holds the whole book, is weighed and not limited.
"""

import gzip
import re
import sys
from pathlib import Path

LIMIT = 150_000


def fetched(page: Path) -> list[Path]:
    text = page.read_text(encoding="utf-8")
    targets = re.findall(r'<link rel="stylesheet"[^>]*href="([^"]+)"', text)
    targets += re.findall(r'<script[^>]* src="([^"]+)"', text)
    return [page] + [(page.parent / target).resolve() for target in targets if "fonts/" not in target]


def main() -> int:
    default = Path(__file__).resolve().parent.parent / "book" / "html"
    folder = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else default
    known: dict[Path, tuple[int, int]] = {}

    def weight(file: Path) -> tuple[int, int]:
        if file not in known:
            data = file.read_bytes()
            known[file] = (len(gzip.compress(data, 9)), len(data))
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
    heavy = [name for sent, _, name in pages if sent > LIMIT and name != "print.html"]
    for name in heavy:
        print(f"{name} weighs more than {LIMIT / 1000:.0f} kB", file=sys.stderr)
    return 1 if heavy else 0


sys.exit(main())
