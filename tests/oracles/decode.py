#!/usr/bin/env python3
"""Makes small files of every format that Inkpanel reads, and what Pillow sees in them.

    python3 tests/oracles/decode.py        (numpy, pillow)

Writes tests/oracles/data/files/*, `expected.bin` (RGB pixels, upright, transparency flattened on white) and
`expected.json` (per file: size, orientation, date, and where its pixels begin in expected.bin).
"""

import io
import json
import pathlib

import numpy as np
from PIL import Image, ImageCms, ImageOps

import profiles

DATA = pathlib.Path(__file__).parent / "data"
FILES = DATA / "files"
WIDTH, HEIGHT = 45, 27
TAKEN = "2019:07:14 18:03:59"

y, x = np.mgrid[0:HEIGHT, 0:WIDTH].astype(float)
disc = ((x - 14) ** 2 + (y - 10) ** 2 < 60) * 90
rgb = np.stack([x * 5 + 10, y * 8 + 20, 200 - x * 2 - y * 3 + disc], -1).clip(0, 255).round().astype(np.uint8)
alpha = (255 - ((x - 30) ** 2 + (y - 14) ** 2)).clip(0, 255).astype(np.uint8)
colour = Image.fromarray(rgb)
grey = colour.convert("L")
clear = Image.fromarray(np.dstack([rgb, alpha]))
palette = colour.quantize(40)


def exif(orientation):
    record = Image.Exif()
    record[0x0112] = orientation
    record.get_ifd(0x8769)[0x9003] = TAKEN
    return record


def save(name, image, **options):
    image.save(FILES / name, **options)


def png16(name, samples, kind):
    """A PNG of 16-bit samples, which Pillow cannot write in colour."""
    import struct
    import zlib

    def chunk(tag, body):
        return struct.pack(">I", len(body)) + tag + body + struct.pack(">I", zlib.crc32(tag + body))

    rows = b"".join(b"\0" + row.astype(">u2").tobytes() for row in samples)
    head = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 16, kind, 0, 0, 0)
    body = chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
    (FILES / name).write_bytes(b"\x89PNG\r\n\x1a\n" + body)


def write_profiled():
    p3 = profiles.colour(profiles.DISPLAY_P3, profiles.SRGB_CURVE)
    adobe = profiles.colour(profiles.ADOBE_RGB, profiles.gamma(563 / 256))
    curves = [(np.arange(n) / (n - 1)) ** 1.8 for n in (2, 16, 1024)]
    formulas = [(1, 2.2, 0.9, 0.1), (2, 2, 0.8, 0.1, 0.05), (4, 2.4, 0.9, 0.08, 0.07, 0.04, 0.02, 0.01)]
    save("jpeg-icc-p3.jpg", colour, quality=95, subsampling=0, icc_profile=p3)
    save("jpeg-icc-parts.jpg", colour, quality=95, subsampling=0, icc_profile=p3 + b"\0" * 70_000)
    save("jpeg-icc-exif-6.jpg", colour, quality=95, subsampling=0, icc_profile=adobe, exif=exif(6))
    three = np.asarray(colour.convert("CMYK"))[..., :3]
    inks = Image.frombytes("CMYK", colour.size, np.dstack([three * 0.8, x * 4]).astype(np.uint8).tobytes())
    press = profiles.of_press()
    save("jpeg-icc-tables-press.jpg", inks, quality=95, icc_profile=press)
    adobe_marked = (FILES / "jpeg-icc-tables-press.jpg").read_bytes()
    at = adobe_marked.index(b"Adobe") + 11
    (FILES / "jpeg-icc-tables-ycck.jpg").write_bytes(adobe_marked[:at] + b"\2" + adobe_marked[at + 1:])
    save("tiff-icc-tables-press.tif", inks, compression="tiff_adobe_deflate", icc_profile=press)
    save("tiff-icc-tables-eight.tif", colour, compression="tiff_adobe_deflate", icc_profile=profiles.of_scanner(False))
    save("png-icc-tables-scanner.png", colour, icc_profile=profiles.of_scanner())
    save("webp-icc-tables-printer.webp", colour, lossless=True, icc_profile=profiles.of_printer())
    save("jpeg-icc-ignored-cmyk.jpg", colour.convert("CMYK"), quality=95, icc_profile=profiles.of_tables(b"CMYK"))
    save("png-icc-p3.png", colour, icc_profile=p3)
    save("png-icc-adobe.png", colour, icc_profile=adobe)
    save("png-icc-palette.png", palette, icc_profile=adobe)
    save("png-icc-linear.png", colour, icc_profile=profiles.colour(profiles.SRGB, b"curv" + b"\0" * 8))
    save("png-icc-curves.png", colour, icc_profile=profiles.colour(profiles.ADOBE_RGB, *map(profiles.table, curves)))
    save("png-icc-formulas.png", colour, icc_profile=profiles.colour(profiles.DISPLAY_P3, *[profiles.formula(*f) for f in formulas]))
    save("png-icc-srgb.png", colour, icc_profile=profiles.colour(profiles.SRGB, profiles.SRGB_CURVE))
    save("png-icc-grey.png", grey, icc_profile=profiles.grey(profiles.gamma(1.8)))
    save("webp-icc-p3.webp", colour, lossless=True, icc_profile=p3)
    save("tiff-icc-adobe.tif", colour, icc_profile=adobe)
    # Unreadable profiles, and profiles for another kind of samples, change nothing.
    save("png-icc-ignored-tables.png", colour, icc_profile=profiles.of_tables())
    save("png-icc-ignored-cut.png", colour, icc_profile=p3[:300])
    save("png-icc-ignored-kind.png", colour, icc_profile=profiles.grey(profiles.gamma(1.8)))


def write_files():
    save("jpeg-420.jpg", colour, quality=90)
    save("jpeg-422.jpg", colour, quality=90, subsampling=1)
    save("jpeg-444.jpg", colour, quality=95, subsampling=0)
    save("jpeg-progressive.jpg", colour, quality=90, progressive=True)
    save("jpeg-restarts.jpg", colour, quality=90, restart_marker_blocks=2)
    save("jpeg-grey.jpg", grey, quality=90)
    save("jpeg-cmyk.jpg", colour.convert("CMYK"), quality=95)
    # The same samples under the other transform of Adobe's marker: other colours, a file as Photoshop writes it.
    cmyk = (FILES / "jpeg-cmyk.jpg").read_bytes()
    adobe = cmyk.index(b"Adobe") + 11
    (FILES / "jpeg-ycck.jpg").write_bytes(cmyk[:adobe] + b"\2" + cmyk[adobe + 1:])
    save("jpeg-rgb.jpg", colour, quality=95, keep_rgb=True)
    for orientation in range(1, 9):
        save(f"jpeg-exif-{orientation}.jpg", colour, quality=90, exif=exif(orientation))
    save("png-rgb.png", colour)
    save("png-rgba.png", clear)
    save("png-palette.png", palette)
    save("png-palette-clear.png", palette, transparency=3)
    save("png-grey.png", grey)
    save("png-grey-alpha.png", clear.convert("LA"))
    save("png-bits.png", grey.convert("1"))
    save("png-exif-8.png", colour, exif=exif(8))
    png16("png-rgb16.png", rgb.astype(np.uint16) * 257, 2)
    png16("png-rgba16.png", np.dstack([rgb, alpha]).astype(np.uint16) * 257, 6)
    png16("png-grey16.png", np.asarray(grey).astype(np.uint16) * 257, 0)
    save("webp-lossy.webp", colour, quality=90)
    save("webp-lossless.webp", colour, lossless=True)
    save("webp-alpha.webp", clear, lossless=True, exact=True)
    save("webp-exif-6.webp", colour, lossless=True, exif=exif(6))
    save("webp-animated.webp", colour, save_all=True, append_images=[grey.convert("RGB")], lossless=True)
    save("gif.gif", palette)
    save("gif-clear.gif", palette, transparency=5)
    save("gif-animated.gif", palette, save_all=True, append_images=[ImageOps.invert(colour).quantize(40)])
    save("bmp-24.bmp", colour)
    save("bmp-palette.bmp", palette)
    save("bmp-grey.bmp", grey)
    save("tiff.tif", colour)
    save("tiff-lzw.tif", colour, compression="tiff_lzw")
    save("tiff-deflate.tif", colour, compression="tiff_adobe_deflate")
    save("tiff-packbits.tif", grey, compression="packbits")
    save("tiff-exif-6.tif", colour, tiffinfo={0x0112: 6})
    big_endian = io.BytesIO()
    Image.fromarray((np.asarray(grey).astype(np.uint16) * 257)).save(big_endian, "TIFF")
    (FILES / "tiff-grey16.tif").write_bytes(big_endian.getvalue())


def seen(path):
    """The file as decoded by Pillow: upright, flattened on white, 8 bits per channel."""
    image = Image.open(path)
    orientation = image.getexif().get(0x0112, 1)
    taken = image.getexif().get_ifd(0x8769).get(0x9003)
    image.seek(0)
    if image.mode.startswith("I"):
        image = Image.fromarray((np.asarray(image).astype(np.uint32) // 257).astype(np.uint8))
    profile = image.info.get("icc_profile")
    image = ImageOps.exif_transpose(image)
    if image.mode == "P" and "transparency" in image.info or image.mode in ("LA", "PA"):
        image = image.convert("RGBA")
    if image.mode == "RGBA":
        rgba = np.asarray(image).astype(float)
        a = rgba[..., 3:] / 255
        image = Image.fromarray((rgba[..., :3] * a + 255 * (1 - a)).round().astype(np.uint8))
    if image.mode not in ("L", "CMYK"):
        image = image.convert("RGB")
    if profile and "ignored" not in path.name:
        image = in_srgb(image, profile)
    return image.convert("RGB"), orientation, taken


def in_srgb(image, profile):
    """The image as littlecms turns it to sRGB."""
    source = ImageCms.ImageCmsProfile(io.BytesIO(profile))
    intent = ImageCms.Intent.RELATIVE_COLORIMETRIC
    return ImageCms.profileToProfile(image, source, ImageCms.createProfile("sRGB"), intent, "RGB")


def main():
    FILES.mkdir(parents=True, exist_ok=True)
    write_files()
    write_profiled()
    blob, index, known = b"", [], {}
    for path in sorted(FILES.iterdir()):
        image, orientation, taken = seen(path)
        pixels = image.tobytes()
        offset = known.setdefault(pixels, len(blob))
        if offset == len(blob):
            blob += pixels
        row = {"file": path.name, "width": image.width, "height": image.height, "orientation": orientation}
        index.append(row | {"taken": taken, "offset": offset})
    (DATA / "expected.bin").write_bytes(blob)
    (DATA / "expected.json").write_text("[\n" + ",\n".join(json.dumps(row) for row in index) + "\n]\n")


main()
