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
from PIL import Image, ImageOps

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


def write_files():
    save("jpeg-420.jpg", colour, quality=90)
    save("jpeg-422.jpg", colour, quality=90, subsampling=1)
    save("jpeg-444.jpg", colour, quality=95, subsampling=0)
    save("jpeg-progressive.jpg", colour, quality=90, progressive=True)
    save("jpeg-restarts.jpg", colour, quality=90, restart_marker_blocks=2)
    save("jpeg-grey.jpg", grey, quality=90)
    save("jpeg-cmyk.jpg", colour.convert("CMYK"), quality=95)
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
    """The file as Pillow sees it: upright, flattened on white, 8 bits a channel."""
    image = Image.open(path)
    orientation = image.getexif().get(0x0112, 1)
    taken = image.getexif().get_ifd(0x8769).get(0x9003)
    image.seek(0)
    if image.mode.startswith("I"):
        image = Image.fromarray((np.asarray(image).astype(np.uint32) // 257).astype(np.uint8))
    image = ImageOps.exif_transpose(image)
    if image.mode == "P" and "transparency" in image.info or image.mode in ("LA", "PA"):
        image = image.convert("RGBA")
    if image.mode == "RGBA":
        rgba = np.asarray(image).astype(float)
        a = rgba[..., 3:] / 255
        image = Image.fromarray((rgba[..., :3] * a + 255 * (1 - a)).round().astype(np.uint8))
    return image.convert("RGB"), orientation, taken


def main():
    FILES.mkdir(parents=True, exist_ok=True)
    write_files()
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
