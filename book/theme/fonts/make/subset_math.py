#!/usr/bin/env python3
"""Makes tumbling-math.woff2, the part of Latin Modern Math that the book's formulas need.

    apt-get install fonts-lmodern
    pip install fonttools==4.68.0 brotli==1.2.1
    python3 subset_math.py /usr/share/texmf/fonts/opentype/public/lm-math/latinmodern-math.otf ../tumbling-math.woff2

The whole font has 4800 glyphs in 733 kB. The font is renamed because it is changed, as its licence
(GUST-FONT-LICENSE.txt beside the result) asks.
"""

import sys

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

NAME = "Tumbling Math"

RANGES = [
    (0x0020, 0x007E),  # ASCII
    (0x00A0, 0x00FF),  # Latin-1: degree, times, middle dot
    (0x02C6, 0x02DD),  # accents that stand alone, as <mo> has them: hat, dot, tilde
    (0x0300, 0x0338),  # accents that combine
    (0x0391, 0x03F6),  # Greek
    (0x2010, 0x2057),  # dashes, quotes, primes, dots
    (0x2061, 0x2064),  # invisible operators
    (0x20D0, 0x20EF),  # arrows and dots above
    (0x2100, 0x214F),  # letterlike: ell, the reals
    (0x2190, 0x21FF),  # arrows
    (0x2200, 0x22FF),  # operators
    (0x2308, 0x230B),  # floor and ceiling
    (0x239B, 0x23B7),  # pieces of tall brackets
    (0x23DC, 0x23E1),  # braces above and below
    (0x25A0, 0x25FF),  # shapes
    (0x27C2, 0x27EF),  # perpendicular, angle brackets
    (0x27F5, 0x27FF),  # long arrows
    (0x2A00, 0x2A2F),  # large operators, cross product
    (0x2A7D, 0x2A7E),  # slanted inequalities
    # Letters as formulas have them. A browser turns <mi>I</mi> into one of these, so none may lack.
    (0x1D400, 0x1D49B),  # bold, italic, bold italic
    (0x1D49C, 0x1D4CF),  # script
    (0x1D538, 0x1D56B),  # the sets of numbers
    (0x1D5A0, 0x1D5D3),  # upright without serifs: the transpose
    (0x1D6A4, 0x1D755),  # Greek bold, italic, bold italic
    (0x1D7CE, 0x1D7D7),  # bold digits
]


def main(source: str, target: str) -> None:
    # A fixed time of change: the same bytes come out on every run.
    font = TTFont(source, recalcTimestamp=False)
    options = Options()
    # Not "ssty", letters redrawn for exponents: they double the size and Chromium ignores them.
    options.layout_features = ["kern"]
    options.name_IDs = ["*"]
    options.notdef_outline = True
    options.recalc_timestamp = False
    options.desubroutinize = True  # larger before compression, smaller after
    options.flavor = "woff2"
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=[c for first, last in RANGES for c in range(first, last + 1)])
    subsetter.subset(font)

    for record in list(font["name"].names):
        renamed = {1: NAME, 3: NAME + " subset", 4: NAME, 6: NAME.replace(" ", ""), 16: NAME}
        if record.nameID in renamed:
            record.string = renamed[record.nameID]
    cff = font["CFF "].cff
    cff.fontNames = [NAME.replace(" ", "")]
    top = cff.topDictIndex[0]
    top.FullName = top.FamilyName = NAME

    font.flavor = "woff2"
    font.save(target)
    print(f"{target}: {len(font.getGlyphOrder())} glyphs")


if __name__ == "__main__":
    main(*sys.argv[1:])
