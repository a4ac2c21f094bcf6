"""Writes data/direction.tsv: lines of text in logical order, and in the order in which they are seen, by python-bidi.

The algorithm of python-bidi does not know the pairs of brackets of UAX #9 (N0), so random lines have no brackets.

Usage: python tests/oracles/direction.py (needs python-bidi)
"""

import pathlib
import random

from bidi.algorithm import get_display

LINES = [
    "שלום עולם!",
    "עולם! 12",
    "מחיר: 50%",
    "מחיר 1,250.50 ש\"ח",
    "(שלום) [עולם] {טוב} <כן>",
    "«שלום» he said",
    "Hello שלום world",
    "שלום Hello (world) 12",
    "כתובת: user@example.com, טלפון 03-1234567",
    "مرحبا، 12 يوم!",
    "السعر: 50% أو 12.5$",
    "٣٠٪ من ١٢٣",
    "نص English نص",
    "12 + 3 = 15 שווה",
    "-5 מעלות",
    "10:30 בבוקר",
    "1/2 כוס",
    "שלום...",
    "...שלום",
    "?מה",
    "a (ב) c",
    "א-ב-ג 1-2-3",
    "№ 5 דף",
    "plain text (only) 12",
]
PARTS = [
    "שלום", "עולם", "מה", "ברכה", "مرحبا", "كتاب", "abc", "Word", "12", "3.5", "1,000", "50%", "$7", "10:30", "٣٤",
    "!", "?", "...", ",", "-", "\"", "'", "/", "+", "&", "«", "»",
]


def lines():
    """The lines above, and lines of random parts."""
    chance = random.Random(7)
    yield from LINES
    for _ in range(400):
        count = chance.randint(2, 8)
        yield "".join(chance.choice(PARTS) + chance.choice([" ", " ", ""]) for _ in range(count)).strip()


def main():
    """Writes the file."""
    out = pathlib.Path(__file__).parent / "data" / "direction.tsv"
    cases = dict.fromkeys(lines())
    out.write_text("".join(f"{line}\t{get_display(line)}\n" for line in cases if line), encoding="utf-8")


if __name__ == "__main__":
    main()
