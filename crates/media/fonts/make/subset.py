#!/usr/bin/env python3
"""Makes the four fonts of exported drawings: the letters that labels may need, cut from Inter and from Liberation Serif.

    apt-get install fonts-inter fonts-liberation2
    pip install fonttools==4.68.0
    python3 subset.py /usr/share/fonts ..

Both have the Open Font License (OFL.txt beside the results) and are renamed because they are changed, as it asks.
"""

import sys
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

RANGES = [
    (0x0020, 0x007E),  # ASCII
    (0x00A0, 0x017F),  # Latin with accents: degree, times, superscripts, names of bodies
    (0x0391, 0x03C9),  # Greek
    (0x200B, 0x200B),  # the space without width that carries a baseline back
    (0x2010, 0x2026),  # dashes, quotes, dots
    (0x2032, 0x2033),  # primes
    (0x2070, 0x2094),  # superscripts and subscripts
    (0x2190, 0x2193),  # arrows
    (0x2202, 0x2265),  # minus, root, infinity, inequalities
]

FONTS = [
    ("opentype/inter/Inter-Regular.otf", "tumbling-sans.otf", "Tumbling Sans", "Regular"),
    ("opentype/inter/Inter-SemiBold.otf", "tumbling-sans-semibold.otf", "Tumbling Sans", "SemiBold"),
    ("truetype/liberation2/LiberationSerif-Italic.ttf", "tumbling-symbols.ttf", "Tumbling Symbols", "Italic"),
    ("truetype/liberation2/LiberationSerif-BoldItalic.ttf", "tumbling-symbols-bold.ttf", "Tumbling Symbols", "Bold Italic"),
]


def cut(source: Path, target: Path, family: str, style: str) -> None:
    font = TTFont(source, recalcTimestamp=False)
    options = Options()
    options.layout_features = ["kern"]
    options.name_IDs = [0, 1, 2, 4, 6, 13, 14]
    options.notdef_outline = True
    options.hinting = False
    options.recalc_timestamp = False
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=[c for first, last in RANGES for c in range(first, last + 1)])
    subsetter.subset(font)
    postscript = f"{family}-{style}".replace(" ", "")
    for number, words in {1: family, 2: style, 4: f"{family} {style}", 6: postscript}.items():
        font["name"].setName(words, number, 3, 1, 0x409)
    if "CFF " in font:
        font["CFF "].cff.fontNames = [postscript]
        top = font["CFF "].cff.topDictIndex[0]
        top.FamilyName, top.FullName = family, f"{family} {style}"
    font.save(target)
    print(f"{target}: {len(font.getGlyphOrder())} glyphs, {target.stat().st_size} bytes")


def main(source: Path, target: Path) -> None:
    for file, name, family, style in FONTS:
        cut(source / file, target / name, family, style)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
