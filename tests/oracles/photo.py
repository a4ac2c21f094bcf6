"""Decoded photos, as in the program, for oracles of later stages."""

import subprocess

from PIL import Image


def decoded(program, file, folder):
    """The pixels of a file in RGB: drawn by `program` in a style that changes nothing."""
    style, drawn = folder / "plain.json", folder / "drawn.png"
    style.write_text('{"id": "plain", "name": "Plain", "tags": [], "background": []}')
    subprocess.run([program, "stylize", "--style", style, file, "-o", drawn], check=True)
    return Image.open(drawn).convert("RGB")
