"""Makes the fonts of tests/oracles/data/fonts, and shapes words in them with HarfBuzz.

    npm pack @fontsource/noto-sans-jp@5.3.0 @fontsource/noto-naskh-arabic@5.3.0
    pip install fonttools==4.68.0 brotli==1.2.1 uharfbuzz==0.57.0
    python tests/oracles/fonts.py FOLDER_OF_THE_PACKAGES

Both families are under the SIL Open Font License 1.1, which is in the same folder, and reserve no name.

- `japanese.ttf`: the characters of `JAPANESE` from Noto Sans JP, quadratic outlines;
- `cubic.otf`: two of them with cubic outlines, as CFF has them, drawn the other way round;
- `arabic.ttf`: the characters of `ARABIC` from Noto Naskh Arabic, with its joining rules;
- `shaped.json`: for each word its advance and the corners of its outline in ems, as HarfBuzz shapes it;
- `columns.json`: for each character of `JAPANESE` with a vertical form, its vertical advance and the corners of its outline,
  relative to the middle of the column's top. HarfBuzz shapes it from top to bottom.

Without a folder only the last two are written, of the fonts that are there.
"""

import io
import json
import pathlib
import sys
import tarfile

import uharfbuzz
from fontTools.fontBuilder import FontBuilder
from fontTools.merge import Merger
from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.qu2cuPen import Qu2CuPen
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.transformPen import TransformPen
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

JAPANESE = "何だって！？「夜の灯台、見た？」そうか…っー。・漢字でも縦書き"
ARABIC = "مرحبا بالعالم لا؟"
WORDS = {"arabic.ttf": ["مرحبا", "بالعالم", "لا"], "japanese.ttf": ["何", "だ", "「", "。", "ー"], "cubic.otf": ["漢"]}
OUT = pathlib.Path(__file__).parent / "data" / "fonts"


def subset(font, text):
    options = Options(layout_features=["*"], name_IDs=[0, 1, 2, 13, 14], notdef_outline=True, hinting=False)
    subsetter = Subsetter(options)
    subsetter.populate(text=text)
    subsetter.subset(font)
    font.flavor = None
    return font


def packed(folder, name, wanted):
    """Merges the files of a package that have characters of a text, each subset to them."""
    found = []
    archive = next(pathlib.Path(folder).glob(f"fontsource-{name}-*.tgz"))
    with tarfile.open(archive) as files:
        OUT.mkdir(parents=True, exist_ok=True)
        (OUT / f"{name}-OFL.txt").write_bytes(files.extractfile("package/LICENSE").read())
        for file in files.getnames():
            if not file.endswith("-400-normal.woff2"):
                continue
            font = TTFont(io.BytesIO(files.extractfile(file).read()))
            own = set(map(ord, wanted)) & set(font.getBestCmap())
            own -= {code for other in found for code in other.getBestCmap()}
            if own:
                found.append(subset(font, "".join(map(chr, own))))
    if len(found) == 1:
        return found[0]
    parts = []
    for i, font in enumerate(found):
        part = pathlib.Path(folder) / f"part-{i}.ttf"
        font.save(part)
        parts.append(str(part))
    return Merger().merge(parts)


def cubic(font, text):
    """The same glyphs in a font with cubic outlines."""
    glyphs, cmap = font.getGlyphSet(), font.getBestCmap()
    names = [".notdef"] + [cmap[ord(letter)] for letter in text]
    strings = {}
    for name in names:
        pen = T2CharStringPen(glyphs[name].width, glyphs)
        glyphs[name].draw(Qu2CuPen(pen, 0.5, all_cubic=True, reverse_direction=True))
        strings[name] = pen.getCharString()
    made = FontBuilder(font["head"].unitsPerEm, isTTF=False)
    made.setupGlyphOrder(names)
    made.setupCharacterMap({ord(letter): cmap[ord(letter)] for letter in text})
    made.setupCFF("Cubic", {"FullName": "Cubic"}, strings, {})
    made.setupHorizontalMetrics({name: (glyphs[name].width, 0) for name in names})
    made.setupHorizontalHeader(ascent=880, descent=-120)
    made.setupNameTable({"familyName": "Cubic", "styleName": "Regular"})
    made.setupOS2()
    made.setupPost()
    return made.font


def shaped(file, word):
    data = (OUT / file).read_bytes()
    font = uharfbuzz.Font(uharfbuzz.Face(data))
    buffer = uharfbuzz.Buffer()
    buffer.add_str(word)
    buffer.guess_segment_properties()
    uharfbuzz.shape(font, buffer)
    outlines = TTFont(io.BytesIO(data))
    glyphs, order, em = outlines.getGlyphSet(), outlines.getGlyphOrder(), outlines["head"].unitsPerEm
    bounds = BoundsPen(glyphs)
    x = 0
    for info, place in zip(buffer.glyph_infos, buffer.glyph_positions):
        pen = TransformPen(bounds, (1, 0, 0, 1, x + place.x_offset, place.y_offset))
        glyphs[order[info.codepoint]].draw(pen)
        x += place.x_advance
    return {"file": file, "word": word, "advance": x / em, "bounds": [side / em for side in bounds.bounds]}


def standing(file, letter):
    """Returns the vertical form of a character, or None if it equals the horizontal form."""
    data = (OUT / file).read_bytes()
    font = uharfbuzz.Font(uharfbuzz.Face(data))
    shapes = []
    for direction in ("LTR", "TTB"):
        buffer = uharfbuzz.Buffer()
        buffer.add_str(letter)
        buffer.guess_segment_properties()
        buffer.direction = direction
        uharfbuzz.shape(font, buffer)
        shapes.append(buffer)
    (lying,), (form,) = [buffer.glyph_infos for buffer in shapes]
    if lying.codepoint == form.codepoint:
        return None
    place = shapes[1].glyph_positions[0]
    outlines = TTFont(io.BytesIO(data))
    glyphs, order, em = outlines.getGlyphSet(), outlines.getGlyphOrder(), outlines["head"].unitsPerEm
    bounds = BoundsPen(glyphs)
    glyphs[order[form.codepoint]].draw(TransformPen(bounds, (1, 0, 0, 1, place.x_offset, place.y_offset)))
    return {"letter": letter, "length": -place.y_advance / em, "bounds": [side / em for side in bounds.bounds]}


if __name__ == "__main__":
    if len(sys.argv) > 1:
        japanese = packed(sys.argv[1], "noto-sans-jp", JAPANESE)
        japanese.save(OUT / "japanese.ttf")
        packed(sys.argv[1], "noto-naskh-arabic", ARABIC).save(OUT / "arabic.ttf")
        cubic(TTFont(OUT / "japanese.ttf"), "漢字").save(OUT / "cubic.otf")
    columns = [form for letter in JAPANESE if (form := standing("japanese.ttf", letter))]
    (OUT / "columns.json").write_text(json.dumps(columns, ensure_ascii=False, indent=1) + "\n")
    rows = [shaped(file, word) for file, words in WORDS.items() for word in words]
    (OUT / "shaped.json").write_text(json.dumps(rows, ensure_ascii=False, indent=1) + "\n")
