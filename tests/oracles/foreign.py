#!/usr/bin/env python3
"""Makes photos of a format that only the browser decodes, and what Pillow sees in them.

    python3 tests/oracles/foreign.py        (numpy, pillow with AVIF)

Writes tests/oracles/data/foreign/*.avif, and for each a PNG of the upright pixels in sRGB, transparency
flattened on white.
"""

import io
import pathlib

import numpy as np
from PIL import Image, ImageCms

import profiles

OUT = pathlib.Path(__file__).parent / "data/foreign"
WIDTH, HEIGHT = 90, 54

y, x = np.mgrid[0:HEIGHT, 0:WIDTH].astype(float)
rgb = np.stack([x * 2.5 + 10, y * 4 + 20, 200 - x - y * 1.5], -1).clip(0, 255).round().astype(np.uint8)
alpha = (255 - ((x - 60) ** 2 + (y - 28) ** 2) / 4).clip(0, 255).astype(np.uint8)
# Transformations that make a picture of each EXIF orientation upright.
TURNS = {2: 0, 3: 3, 4: 1, 5: 5, 6: 4, 7: 6, 8: 2}
TURNS = {orientation: Image.Transpose(turn) for orientation, turn in TURNS.items()}
colour = Image.fromarray(rgb)
clear = Image.fromarray(np.dstack([rgb, alpha]))


def save(name, image, profile=None, orientation=1, **options):
    exif = Image.Exif()
    exif[0x0112], exif[0x010F] = orientation, "Tests"
    exif.get_ifd(0x8769)[0x9003] = "2019:07:14 18:03:59"
    if profile:
        options["icc_profile"] = profile
    path = OUT / f"{name}.avif"
    image.save(path, quality=95, subsampling="4:4:4", speed=6, exif=exif, **options)
    seen = Image.open(path)
    seen.load()
    if orientation > 1:
        seen = seen.transpose(TURNS[orientation])
    if seen.mode == "RGBA":
        rgba = np.asarray(seen).astype(float)
        a = rgba[..., 3:] / 255
        seen = Image.fromarray((rgba[..., :3] * a + 255 * (1 - a)).round().astype(np.uint8))
    if profile:
        source = ImageCms.ImageCmsProfile(io.BytesIO(profile))
        seen = ImageCms.profileToProfile(seen, source, ImageCms.createProfile("sRGB"), outputMode="RGB")
    seen.convert("RGB").save(OUT / f"{name}.png")


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    save("plain", colour)
    save("clear", clear)
    for orientation in TURNS:
        save(f"turned-{orientation}", colour, orientation=orientation)
    save("p3", colour, profile=profiles.colour(profiles.DISPLAY_P3, profiles.SRGB_CURVE))


main()
