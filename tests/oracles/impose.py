"""Order of pages on sheets, from pdfimpose (PyPI, 2.10): a booklet of one fold, and a zine of eight pages
from one sheet. Writes tests/oracles/data/impose.json: by name and number of pages the sides in printing
order, as rows of [page from 0, upside down]. pdfimpose is under the AGPL. It is only run here, and no release
contains it.

    pip install pdfimpose==2.10.0
    python tests/oracles/impose.py
"""

import json
from pathlib import Path

from pdfimpose.schema import onepagezine, saddle


def sides(imposition, pages):
    def seat(page):
        return [page.number, page.rotate == 180]

    return [
        [[seat(matrix[x, y]) for x in range(matrix.width)] for y in range(matrix.height)]
        for matrix in imposition.matrixes(pages)
    ]


def main():
    told = {
        "booklet": {pages: sides(saddle.SaddleImpositor(folds="h"), pages) for pages in (4, 8, 12, 20)},
        "zine": {pages: sides(onepagezine.OnePageZineImpositor(), pages) for pages in (8, 16)},
    }
    target = Path(__file__).parent / "data" / "impose.json"
    target.write_text(json.dumps(told, separators=(",", ":")) + "\n")


if __name__ == "__main__":
    main()
