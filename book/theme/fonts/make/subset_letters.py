#!/usr/bin/env python3
"""Makes the fonts of running text, of controls and of code: what the book needs of Literata, Inter and JetBrains Mono.

    apt-get install fonts-inter fonts-jetbrains-mono
    npm pack @fontsource-variable/literata@5.3.0 && tar xzf fontsource-variable-literata-5.3.0.tgz
    pip install fonttools==4.68.0 brotli==1.2.1
    python3 subset_letters.py /usr/share/fonts package/files ..

All three have the Open Font License (LITERATA-OFL.txt, LETTERS-OFL.txt beside the results).
"""

import io
import sys
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont
from fontTools.varLib.instancer import instantiateVariableFont

TEXT = [
    (0x0020, 0x007E),  # ASCII
    (0x00A0, 0x00FF),  # Latin-1: degree, times, superscripts, letters with accents
    (0x0131, 0x0131),  # dotless i
    (0x0152, 0x0153),  # oe
    (0x02D9, 0x02D9),  # a dot that stands alone
    (0x200B, 0x200B),  # the space without width that carries a baseline back
    (0x2010, 0x2026),  # dashes, quotes, dots
    (0x2032, 0x2033),  # primes
    (0x2191, 0x2193),  # arrows
    (0x2212, 0x2212),  # minus
]
NAMES = [(0x0100, 0x017F)]  # letters with accents in the names of authors
LABELS = [
    *TEXT,
    (0x0391, 0x03C9),  # Greek
    (0x2070, 0x2094),  # superscripts and subscripts
    (0x2190, 0x2193),  # arrows
    (0x2202, 0x2265),  # minus, root, infinity, inequalities
    (0x25CB, 0x25CB),  # the ring that marks a flip
    (0x2713, 0x2717),  # right and wrong
]

READING = ["kern", "liga", "pnum", "tnum", "rvrn"]
WEIGHTS = (400, 700)

# Source, result, name of the family if it is renamed, ranges, features.
FONTS = [
    ("{npm}/literata-latin-wght-normal.woff2", "literata.woff2", None, TEXT, READING),
    ("{npm}/literata-latin-wght-italic.woff2", "literata-italic.woff2", None, TEXT, READING),
    ("{npm}/literata-latin-ext-wght-normal.woff2", "literata-names.woff2", None, NAMES, ["kern"]),
    ("{fonts}/opentype/inter/Inter-Regular.otf", "tumbling-sans.woff2", "Tumbling Sans", LABELS, ["kern", "tnum"]),
    ("{fonts}/opentype/inter/Inter-SemiBold.otf", "tumbling-sans-semibold.woff2", "Tumbling Sans", LABELS, ["kern", "tnum"]),
    ("{fonts}/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf", "tumbling-mono.woff2", "Tumbling Mono", LABELS, []),
]


def lighter(font: TTFont) -> TTFont:
    """The font without the weights that the book does not use."""
    variations = font["gvar"].variations
    for name in font.getGlyphOrder():
        if name not in variations:
            variations[name] = []
    instantiateVariableFont(font, {"wght": WEIGHTS}, inplace=True)
    font.flavor = None
    saved = io.BytesIO()
    font.save(saved)
    font = TTFont(saved, recalcTimestamp=False)
    for name in font.getGlyphOrder():
        font["gvar"].variations.setdefault(name, [])
    return font


def cut(source: Path, target: Path, family: str | None, ranges: list[tuple[int, int]], features: list[str]) -> None:
    # A fixed time of change: the same bytes come out on every run.
    font = TTFont(source, recalcTimestamp=False)
    if "fvar" in font:
        font = lighter(font)
    options = Options()
    options.layout_features = features
    options.hinting = False
    options.notdef_outline = True
    options.recalc_timestamp = False
    options.desubroutinize = True  # larger before compression, smaller after
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=[c for first, last in ranges for c in range(first, last + 1)])
    subsetter.subset(font)
    if family:
        for record in font["name"].names:
            if record.nameID in (1, 4, 16):
                record.string = family
            elif record.nameID == 6:
                record.string = family.replace(" ", "")
        if "CFF " in font:
            font["CFF "].cff.fontNames = [family.replace(" ", "")]
            top = font["CFF "].cff.topDictIndex[0]
            top.FamilyName = top.FullName = family
    font.flavor = "woff2"
    font.save(target)
    print(f"{target}: {len(font.getGlyphOrder())} glyphs, {target.stat().st_size} bytes")


def main(fonts: str, npm: str, target: str) -> None:
    for source, name, family, ranges, features in FONTS:
        cut(Path(source.format(fonts=fonts, npm=npm)), Path(target) / name, family, ranges, features)


if __name__ == "__main__":
    main(*sys.argv[1:])
