"""Draws a page with text from right to left as a PDF file, and looks for its words with pdfium and poppler.

Usage: python tests/oracles/pdf_search.py INKPANEL FONT PHOTO (needs pypdfium2 and pdftotext)

The font must have Hebrew and Arabic letters, as DejaVu Sans has. Prints the words that a reader does not find, and ends
with 1 if there are any.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import pypdfium2

CAPTIONS = ["שלום עולם! 12", "מחיר: 50%", "مرحبا بالعالم 12!", "Hello שלום world"]
EFFECT = "בום גדול"
WORDS = ["שלום", "עולם", "מחיר", "50%", "مرحبا", "بالعالم", "Hello", "בום", "גדול"]


def main(program, font, photo):
    """Returns the number of words that were not found."""
    words = [
        {"kind": "caption", "text": text, "panel": 0, "x": 0.5, "y": 0.1 + 0.2 * i} for i, text in enumerate(CAPTIONS)
    ]
    words.append({"kind": "effect", "text": EFFECT, "panel": 0, "x": 0.5, "y": 0.9, "angle": -8})
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "words.json").write_text(json.dumps(words), encoding="utf-8")
        page = str(place / "page.pdf")
        command = [program, "render", "--no-detect", "--words", str(place / "words.json"), "--font", font]
        subprocess.run([*command, "-o", page, photo], check=True)
        text = pypdfium2.PdfDocument(page)[0].get_textpage()
        poppler = subprocess.run(["pdftotext", page, "-"], check=True, capture_output=True, text=True).stdout
        lost = [f"pdfium: {word}" for word in [*WORDS, EFFECT, CAPTIONS[0]] if text.search(word).get_next() is None]
        lost += [f"poppler: {word}" for word in WORDS if word not in poppler]
    print("\n".join(lost) or "all words were found")
    return len(lost)


if __name__ == "__main__":
    sys.exit(1 if main(*sys.argv[1:]) else 0)
