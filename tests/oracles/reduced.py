#!/usr/bin/env python3
"""Makes small JPEG files, and what libjpeg makes of them at a half, a quarter and an eighth of their sides.

    python3 tests/oracles/reduced.py        (pillow)

Writes tests/oracles/data/reduced/NAME.jpg and NAME-4.png, NAME-2.png, NAME-1.png. The number is the reduced
size of eight samples.
"""

import pathlib

from PIL import Image

ROOT = pathlib.Path(__file__).parent
OUT = ROOT / "data" / "reduced"
PHOTO = ROOT.parents[1] / "www/public/samples/06-castle.jpg"
# Complete blocks, but not complete units of four blocks.
WIDTH, HEIGHT = 216, 152

OUT.mkdir(exist_ok=True)
photo = Image.open(PHOTO).convert("RGB")
scale = 3
part = photo.crop((300, 200, 300 + scale * WIDTH, 200 + scale * HEIGHT)).resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS)

FILES = {
    "colours-half": (part, {"quality": 92, "subsampling": "4:2:0"}),
    "colours-whole": (part, {"quality": 75, "subsampling": "4:4:4", "optimize": True}),
    "coarse": (part, {"quality": 8, "subsampling": "4:2:0"}),
    "finest": (part, {"quality": 100, "subsampling": "4:4:4"}),
    "grey": (part.convert("L"), {"quality": 90}),
    "restarts": (part, {"quality": 85, "subsampling": "4:2:0", "restart_marker_blocks": 5}),
}

for name, (picture, how) in FILES.items():
    path = OUT / f"{name}.jpg"
    picture.save(path, "JPEG", **how)
    for of_eight in (4, 2, 1):
        small = Image.open(path)
        small.draft(small.mode, (WIDTH * of_eight // 8, HEIGHT * of_eight // 8))
        assert small.size == (WIDTH * of_eight // 8, HEIGHT * of_eight // 8), (name, small.size)
        small.convert("RGB").save(OUT / f"{name}-{of_eight}.png", optimize=True)
