#!/usr/bin/env python3
"""Makes small animated files, and what Pillow sees in each of their pictures.

    python3 tests/oracles/animation.py        (numpy, pillow)

Writes tests/oracles/data/animations/*: the files, `expected.bin` (RGB pixels of every frame, transparency
flattened on white) and `expected.json`. Per file, it has the size, the end of each frame in seconds, and the
position of its pixels.
"""

import json
import pathlib

import numpy as np
from PIL import Image, ImageDraw

OUT = pathlib.Path(__file__).parent / "data/animations"
WIDTH, HEIGHT, COUNT = 40, 24, 6
DELAYS = [120, 80, 300, 40, 200, 110]


def picture(i, clear):
    """A disc that wanders over a plain ground, which is clear or not."""
    image = Image.new("RGBA", (WIDTH, HEIGHT), (0, 0, 0, 0) if clear else (30, 90, 160, 255))
    draw = ImageDraw.Draw(image)
    draw.rectangle([0, 18, WIDTH, HEIGHT], fill=(200, 120, 40, 255))
    draw.ellipse([2 + 5 * i, 2 + i, 12 + 5 * i, 12 + i], fill=(250, 30 * i, 60, 255))
    return image


def gif(name, clear, disposal):
    frames = [picture(i, clear) for i in range(COUNT)]
    frames[0].save(OUT / name, save_all=True, append_images=frames[1:], duration=DELAYS, disposal=disposal, loop=0)


def webp(name, clear, **options):
    frames = [picture(i, clear) for i in range(COUNT)]
    frames[0].save(OUT / name, save_all=True, append_images=frames[1:], duration=DELAYS, **options)


def seen(path):
    pictures, ends, end = [], [], 0
    image = Image.open(path)
    for i in range(image.n_frames):
        image.seek(i)
        rgba = np.asarray(image.convert("RGBA")).astype(float)
        a = rgba[..., 3:] / 255
        pictures.append((rgba[..., :3] * a + 255 * (1 - a)).round().astype(np.uint8).tobytes())
        end += image.info["duration"]
        ends.append(end / 1000)
    return pictures, ends


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    gif("kept.gif", False, 1)
    gif("cleared.gif", True, 2)
    gif("restored.gif", False, [1, 3, 1, 3, 3, 1])
    webp("lossless.webp", False, lossless=True)
    webp("clear.webp", True, lossless=True)
    webp("lossy.webp", False, quality=90)
    blob, index = b"", []
    for path in sorted(p for p in OUT.iterdir() if p.suffix in (".gif", ".webp")):
        pictures, ends = seen(path)
        index.append({"file": path.name, "width": WIDTH, "height": HEIGHT, "ends": ends, "offset": len(blob)})
        blob += b"".join(pictures)
    (OUT / "expected.bin").write_bytes(blob)
    (OUT / "expected.json").write_text("[\n" + ",\n".join(map(json.dumps, index)) + "\n]\n")


main()
