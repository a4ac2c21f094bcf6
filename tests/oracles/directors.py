"""Writes data/directors.tsv: lines of text with marks, embeddings, overrides and isolates, and the same lines as they are
seen, by GNU FriBidi. Characters that only direct the order are not in the second column.

Usage: python tests/oracles/directors.py (needs the library fribidi 1.0)
"""

import ctypes
import ctypes.util
import pathlib
import random
import unicodedata

DIRECTORS = "\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
LINES = [
    "אני אוהב C++\u200e מאוד",
    "אני אוהב C++ מאוד",
    "I like שלום!\u200f very",
    "שלום \u202aabc (def)!\u202c עולם",
    "שלום \u2066abc (def)!\u2069 עולם",
    "abc \u2067שלום (12)!\u2069 def",
    "abc \u2068שלום! 12\u2069 def",
    "\u202eabc 12\u202c def",
    "\u202dשלום 12\u202c abc",
    "\u200f12 - 15",
    "\u200e- שלום -",
    "مرحبا 12-15\u061c 3",
    "abc\u2069 שלום\u202c!",
]
PARTS = ["שלום", "עולם", "مرحبا", "abc", "Word", "12", "3.5", "50%", "!", "?", "-", "(", ")", "«", "»", "...", "+"]

library = ctypes.CDLL(ctypes.util.find_library("fribidi") or "libfribidi.so.0")


def seen(line):
    """The line from left to right. Its first strong character gives the direction."""
    codes = [ord(letter) for letter in line]
    text = (ctypes.c_uint32 * len(codes))(*codes)
    out = (ctypes.c_uint32 * (len(codes) + 1))()
    # FRIBIDI_PAR_ON: the direction of the first strong character, from left to right without one.
    base = ctypes.c_uint32(0x40)
    if not library.fribidi_log2vis(text, len(codes), ctypes.byref(base), out, None, None, None):
        raise RuntimeError(line)
    # FriBidi joins Arabic letters, which is the task of a font here.
    plain = lambda letter: unicodedata.normalize("NFKC", letter) if "\ufb50" <= letter <= "\ufefc" else letter
    letters = "".join(plain(chr(code)) for code in out[: len(codes)])
    return "".join(letter for letter in letters if letter not in DIRECTORS and letter != "\ufeff")


def lines():
    """The lines above, and lines of random parts."""
    chance = random.Random(11)
    yield from LINES
    for _ in range(400):
        parts = [chance.choice(DIRECTORS if chance.random() < 0.35 else PARTS) for _ in range(chance.randint(3, 10))]
        yield "".join(part + chance.choice([" ", "", ""]) for part in parts).strip()


def main():
    """Writes the file."""
    out = pathlib.Path(__file__).parent / "data" / "directors.tsv"
    rows = [f"{line}\t{seen(line)}\n" for line in dict.fromkeys(lines()) if line]
    out.write_text("".join(rows), encoding="utf-8")
    print(len(rows), "lines")


if __name__ == "__main__":
    main()
