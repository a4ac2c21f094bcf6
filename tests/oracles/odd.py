#!/usr/bin/env python3
"""Makes small files of the rarer kinds of each format, and what Pillow sees in them.

    python3 tests/oracles/odd.py        (numpy, pillow, tifffile, imagecodecs)

Writes tests/oracles/data/odd/*, `odd.bin` (RGB pixels as decoded by Pillow, upright, flattened on white),
`odd.json` and docs/reference/decoding.md. Per file, odd.json has the size, the position of its pixels in
odd.bin, and the reason for a difference between Inkpanel and Pillow, if any.
"""

import io
import json
import pathlib
import struct
import zlib

import numpy as np
import tifffile
from PIL import Image, ImageFile, ImageOps

HERE = pathlib.Path(__file__).parent
DATA = HERE / "data"
FILES = DATA / "odd"
WIDTH, HEIGHT = 45, 27

y, x = np.mgrid[0:HEIGHT, 0:WIDTH].astype(float)
disc = ((x - 14) ** 2 + (y - 10) ** 2 < 60) * 90
RGB = np.stack([x * 5 + 10, y * 8 + 20, 200 - x * 2 - y * 3 + disc], -1).clip(0, 255).round().astype(np.uint8)
ALPHA = (255 - ((x - 30) ** 2 + (y - 14) ** 2)).clip(0, 255).astype(np.uint8)
GREY = np.asarray(Image.fromarray(RGB).convert("L"))
RGBA = np.dstack([RGB, ALPHA])
MULTIPLIED = np.dstack([(RGB.astype(int) * ALPHA[..., None] + 127) // 255, ALPHA]).astype(np.uint8)
CMYK = np.asarray(Image.fromarray(RGB).convert("CMYK")).copy()
CMYK[..., 3] = (x * 3).astype(np.uint8)
BITS = (GREY > 120).astype(np.uint8)
LARGE = np.asarray(Image.fromarray(RGB).resize((105, 70), Image.Resampling.BICUBIC))

# Why Inkpanel sees otherwise what Pillow opens. A file that stands here and agrees fails the test, as does the contrary.
CLEAR = "The area outside the first frame is transparent, like in browsers. Pillow fills it with the first palette colour."
CUT = "Inkpanel rejects a file if less than half of it can be decoded. Pillow draws a gray area instead (LOAD_TRUNCATED_IMAGES)."
DAMAGED = """
## Damaged files

A damaged JPEG or PNG file is decoded as far as possible.
Decoding continues at the next restart marker, or after the Huffman codes synchronise.
The command line and the app report the share of the picture that is missing and drawn grey, or that lacks detail.
`--strict` refuses such a file.
A file is always refused if less than half of it can be decoded.
A missing end marker (EOI or IEND) is not damage if all pixels are there.
"""
SCANS = "Scans are missing. Inkpanel draws the blocks unchanged; libjpeg smooths them."
PLANES = "Pillow reads uncompressed planar 16-bit samples as bytes, each column twice. Compressed files agree."
REASONS = {
    "bmp-os2-v2.bmp": "The long OS/2 2 header is not supported: such files are hardly in use any more.",
    "bmp-fields-24.bmp": "Bit fields of 24 bits are not supported. Only the tests of Pillow write them.",
    "bmp-fields-none.bmp": "Bit fields without a mask are rejected, because they do not define the colours.",
    "bmp-alpha-zero.bmp": "If alpha is zero everywhere, Inkpanel ignores it and shows the colours, like browsers.",
    "bmp-rle8-steps.bmp": "Pixels that the runs skip have no defined colour. Inkpanel makes them black; Pillow uses the first palette colour.",
    "gif-offset.gif": CLEAR,
    "gif-smaller.gif": CLEAR,
    "gif-screen-narrow.gif": CLEAR,
    "jpeg-cut.jpg": CUT,
    "jpeg-patched.jpg": "Data is missing, but the end marker is present. The result is random in every decoder.",
    "jpeg-progressive-1-scans.jpg": SCANS,
    "jpeg-progressive-3-scans.jpg": SCANS,
    "tiff-bigtiff.tif": "BigTIFF is not supported. It is for files larger than 4 GB.",
    "tiff-bits-12.tif": "12-bit samples are not supported. Scientific cameras write them.",
    "tiff-fax3.tif": "Group 4 is the only supported fax compression. Group 3 is for scanned letters.",
    "tiff-float.tif": "Floating-point samples range from 0 to 1, as writers intend. Pillow clips them at 0 and 255.",
    "tiff-grey-16-inverted.tif": "Pillow ignores WhiteIsZero for 16-bit samples.",
    "tiff-int16.tif": "Signed integers are not supported. They are heights and measurements, not light.",
    "tiff-planes-16-big.tif": PLANES,
    "tiff-planes-16-tiles.tif": PLANES,
    "tiff-planes-16.tif": PLANES,
    "tiff-uint32.tif": "32-bit integers are not supported. They are measurements, not light.",
    "tiff-lab.tif": "L*a*b* is not supported.",
    "tiff-lzma.tif": "LZMA is not supported. Its decoder would be larger than the rest of the TIFF decoder.",
    "tiff-zstd.tif": "Zstandard is not supported. Its decoder would be larger than the rest of the TIFF decoder.",
    "tiff-ycbcr-2x2.tif": "Chroma subsampling is supported only in JPEG files.",
}


def save(name, content):
    (FILES / name).write_bytes(content)


def pillow(name, array, **options):
    image = array if isinstance(array, Image.Image) else Image.fromarray(array)
    image.save(FILES / name, **options)


# ---- TIFF

def tiff(name, array, **options):
    """A file by tifffile; planes come first in an array that is to be stored so."""
    options.setdefault("metadata", None)
    tifffile.imwrite(FILES / name, array, **options)


def tiff_by_hand(width, height, strips, fields, endian="<"):
    """A file of uncompressed strips. Fields: tag -> (type, values); 3 is 16 bits, 4 is 32."""
    body, offsets = bytearray(), []
    for strip in strips:
        offsets.append(8 + len(body))
        body += strip + b"\0" * (len(strip) % 2)
    fields = {256: (4, [width]), 257: (4, [height]), 259: (3, [1]), 273: (4, offsets)} | fields
    fields |= {279: (4, [len(strip) for strip in strips])}
    fields.setdefault(278, (4, [-(-height // len(strips))]))
    directory = bytearray(struct.pack(endian + "H", len(fields)))
    place = 8 + len(body) + 2 + 12 * len(fields) + 4
    late = bytearray()
    for tag in sorted(fields):
        kind, values = fields[tag]
        data = struct.pack(endian + f"{len(values)}{'HI'[kind - 3]}", *values)
        directory += struct.pack(endian + "HHI", tag, kind, len(values))
        if len(data) > 4:
            directory += struct.pack(endian + "I", place + len(late))
            late += data + b"\0" * (len(data) % 2)
        else:
            directory += data.ljust(4, b"\0")
    head = (b"II*\0" if endian == "<" else b"MM\0*") + struct.pack(endian + "I", 8 + len(body))
    return head + bytes(body) + bytes(directory) + b"\0" * 4 + bytes(late)


def predicted(array):
    """Differences along rows, as predictor 2 has them."""
    wide = array.astype(np.int32)
    wide[:, 1:] -= array[:, :-1]
    return wide.astype(array.dtype)


def write_tiff():
    wide = RGB.astype(np.uint16) * 257
    wide_alpha = RGBA.astype(np.uint16) * 257
    half_red = np.zeros((8, 8, 4), np.uint8)
    half_red[...] = (128, 0, 0, 128)
    tiff("tiff-half-red.tif", half_red, photometric="rgb", extrasamples=["assocalpha"])
    tiff("tiff-alpha-associated.tif", MULTIPLIED, photometric="rgb", extrasamples=["assocalpha"])
    tiff("tiff-alpha-associated-16.tif", MULTIPLIED.astype(np.uint16) * 257, photometric="rgb", extrasamples=["assocalpha"])
    tiff("tiff-alpha-straight.tif", RGBA, photometric="rgb", extrasamples=["unassalpha"])
    tiff("tiff-alpha-straight-16.tif", wide_alpha, photometric="rgb", extrasamples=["unassalpha"])
    planes = np.moveaxis(MULTIPLIED, -1, 0)
    tiff("tiff-alpha-planes.tif", planes, photometric="rgb", planarconfig="separate", extrasamples=["assocalpha"])
    tiff("tiff-alpha-predicted.tif", MULTIPLIED, photometric="rgb", extrasamples=["assocalpha"], compression="zlib", predictor=2)
    tiff("tiff-extra-unknown.tif", RGBA, photometric="rgb", extrasamples=["unspecified"])
    tiff("tiff-extra-unknown-predicted.tif", RGBA, photometric="rgb", extrasamples=["unspecified"], compression="lzw", predictor=2)
    tiff("tiff-grey-alpha.tif", np.dstack([GREY, ALPHA]), photometric="minisblack", planarconfig="contig", extrasamples=["unassalpha"])
    tiff("tiff-rgb-16.tif", wide, photometric="rgb")
    tiff("tiff-rgb-16-big.tif", wide, photometric="rgb", byteorder=">")
    tiff("tiff-rgb-16-predicted.tif", wide, photometric="rgb", byteorder=">", compression="zlib", predictor=2)
    for bits, array in [(8, RGB), (16, wide)]:
        planes = np.moveaxis(array, -1, 0)
        tiff(f"tiff-planes-{bits}.tif", planes, photometric="rgb", planarconfig="separate", rowsperstrip=5)
        tiff(f"tiff-planes-{bits}-lzw.tif", planes, photometric="rgb", planarconfig="separate", compression="lzw", predictor=2, rowsperstrip=5)
        tiff(f"tiff-planes-{bits}-tiles.tif", planes, photometric="rgb", planarconfig="separate", tile=(16, 16))
        tiff(f"tiff-planes-{bits}-tiles-zip.tif", planes, photometric="rgb", planarconfig="separate", tile=(32, 16), compression="zlib", predictor=2)
        tiff(f"tiff-tiles-{bits}.tif", array, photometric="rgb", tile=(16, 32))
    tiff("tiff-planes-16-big.tif", np.moveaxis(wide, -1, 0), photometric="rgb", planarconfig="separate", byteorder=">")
    tiff("tiff-tiles-large.tif", RGB, photometric="rgb", tile=(64, 64))
    tiff("tiff-tiles-lzw.tif", RGB, photometric="rgb", tile=(16, 16), compression="lzw", predictor=2)
    tiff("tiff-tiles-packbits.tif", RGB, photometric="rgb", tile=(16, 16), compression="packbits")
    pillow("tiff-palette.tif", Image.fromarray(RGB).quantize(40))
    pillow("tiff-palette-lzw.tif", Image.fromarray(RGB).quantize(200), compression="tiff_lzw")
    colours = [(n * 4369 * 5 % 65536) // 257 * 257 for n in range(48)]
    four = (GREY // 16).astype(np.uint8)
    even = np.pad(four, ((0, 0), (0, WIDTH % 2)))
    nibbles = (even[:, ::2] << 4 | even[:, 1::2]).tobytes()
    save("tiff-palette-4.tif", tiff_by_hand(WIDTH, HEIGHT, [nibbles], {258: (3, [4]), 262: (3, [3]), 320: (3, colours)}))
    save("tiff-grey-4.tif", tiff_by_hand(WIDTH, HEIGHT, [nibbles], {258: (3, [4]), 262: (3, [1])}))
    save("tiff-grey-4-inverted.tif", tiff_by_hand(WIDTH, HEIGHT, [nibbles], {258: (3, [4]), 262: (3, [0])}))
    two = np.pad(GREY // 64, ((0, 0), (0, 3)))
    quarters = (two[:, ::4] << 6 | two[:, 1::4] << 4 | two[:, 2::4] << 2 | two[:, 3::4]).astype(np.uint8).tobytes()
    save("tiff-grey-2.tif", tiff_by_hand(WIDTH, HEIGHT, [quarters], {258: (3, [2]), 262: (3, [1])}))
    eights = np.packbits(BITS, axis=1)
    save("tiff-bits.tif", tiff_by_hand(WIDTH, HEIGHT, [eights.tobytes()], {258: (3, [1]), 262: (3, [1])}))
    save("tiff-bits-inverted.tif", tiff_by_hand(WIDTH, HEIGHT, [eights.tobytes()], {258: (3, [1]), 262: (3, [0])}))
    turned = np.packbits(BITS, axis=1, bitorder="little").tobytes()
    save("tiff-bits-turned.tif", tiff_by_hand(WIDTH, HEIGHT, [turned], {258: (3, [1]), 262: (3, [1]), 266: (3, [2])}))
    tiff("tiff-bits-tiles.tif", BITS.astype(bool), tile=(16, 16))
    pillow("tiff-fax4.tif", Image.fromarray(BITS * 255).convert("1"), compression="group4")
    pillow("tiff-fax4-turned.tif", Image.fromarray(BITS * 255).convert("1"), compression="group4", tiffinfo={266: 2})
    pillow("tiff-fax3.tif", Image.fromarray(BITS * 255).convert("1"), compression="group3")
    tiff("tiff-grey-inverted.tif", GREY, photometric="miniswhite")
    tiff("tiff-grey-16-inverted.tif", GREY.astype(np.uint16) * 257, photometric="miniswhite")
    tiff("tiff-grey-16-big.tif", GREY.astype(np.uint16) * 257, byteorder=">", photometric="minisblack")
    twelve = np.pad(GREY.astype(np.uint32) * 4095 // 255, ((0, 0), (0, 1)))
    packed = np.stack([twelve[:, ::2] >> 4, (twelve[:, ::2] & 15) << 4 | twelve[:, 1::2] >> 8, twelve[:, 1::2] & 255], -1)
    rows = packed.astype(np.uint8).reshape(HEIGHT, -1)[:, : (WIDTH * 12 + 7) // 8].tobytes()
    save("tiff-bits-12.tif", tiff_by_hand(WIDTH, HEIGHT, [rows], {258: (3, [12]), 262: (3, [1])}))
    tiff("tiff-cmyk.tif", CMYK, photometric="separated")
    tiff("tiff-cmyk-16.tif", CMYK.astype(np.uint16) * 257, photometric="separated")
    tiff("tiff-cmyk-tiles.tif", CMYK, photometric="separated", tile=(16, 16), compression="zlib", predictor=2)
    tiff("tiff-cmyk-planes.tif", np.moveaxis(CMYK, -1, 0), photometric="separated", planarconfig="separate")
    tiff("tiff-jpeg.tif", LARGE, photometric="rgb", compression="jpeg", compressionargs={"level": 95})
    tiff("tiff-jpeg-ycbcr.tif", LARGE, photometric="ycbcr", compression="jpeg", compressionargs={"level": 95}, subsampling=(2, 2))
    tiff("tiff-jpeg-tiles.tif", LARGE, photometric="ycbcr", compression="jpeg", compressionargs={"level": 95}, subsampling=(1, 1), tile=(64, 64))
    pillow("tiff-jpeg-grey.tif", LARGE[..., 0], compression="jpeg", quality=95)
    pillow("tiff-zstd.tif", RGB, compression="zstd")
    pillow("tiff-lzma.tif", RGB, compression="lzma")
    ycc = np.asarray(Image.fromarray(RGB).convert("YCbCr"))
    rows = [row.tobytes() for row in np.array_split(ycc, 3)]
    meaning = {258: (3, [8, 8, 8]), 262: (3, [6]), 277: (3, [3])}
    save("tiff-ycbcr.tif", tiff_by_hand(WIDTH, HEIGHT, rows, meaning | {530: (3, [1, 1])}))
    even = np.pad(ycc, ((0, 1), (0, 1), (0, 0)), mode="edge")
    blocks = np.dstack([even[::2, ::2, 0], even[::2, 1::2, 0], even[1::2, ::2, 0], even[1::2, 1::2, 0], even[::2, ::2, 1], even[::2, ::2, 2]])
    save("tiff-ycbcr-2x2.tif", tiff_by_hand(WIDTH, HEIGHT, [blocks.tobytes()], meaning | {530: (3, [2, 2])}))
    lab = np.dstack([GREY, RGB[..., 0] // 4, RGB[..., 1] // 4]).tobytes()
    save("tiff-lab.tif", tiff_by_hand(WIDTH, HEIGHT, [lab], {258: (3, [8, 8, 8]), 262: (3, [8]), 277: (3, [3])}))
    tiff("tiff-float.tif", GREY.astype(np.float32) / 255, photometric="minisblack")
    tiff("tiff-uint32.tif", GREY.astype(np.uint32) * 16843009, photometric="minisblack")
    tiff("tiff-int16.tif", GREY.astype(np.int16) * 100, photometric="minisblack")
    tiff("tiff-bigtiff.tif", RGB, photometric="rgb", bigtiff=True)
    whole = {258: (3, [8, 8, 8]), 262: (3, [2]), 277: (3, [3]), 278: (4, [2**32 - 1])}
    save("tiff-one-strip.tif", tiff_by_hand(WIDTH, HEIGHT, [RGB.tobytes()], whole))
    four_samples = {258: (3, [8] * 4), 262: (3, [2]), 277: (3, [4])}
    save("tiff-alpha-unsaid.tif", tiff_by_hand(WIDTH, HEIGHT, [RGBA.tobytes()], four_samples))
    image = Image.fromarray(RGB)
    pillow("tiff-pages.tif", image, save_all=True, append_images=[ImageOps.invert(image)])


# ---- BMP

MASKS = (0xFF0000, 0xFF00, 0xFF, 0xFF000000)


def bmp(rows, bits, header=40, compression=0, masks=(), palette=b"", height=HEIGHT, width=WIDTH, colours=0, extra=b""):
    """A file with the given rows, from bottom to top."""
    pixels = b"".join(row + b"\0" * (-len(row) % 4) for row in rows)
    if header == 12:
        head = struct.pack("<IHHHH", 12, width, height, 1, bits)
    else:
        head = struct.pack("<IiiHHIIiiII", header, width, height, 1, bits, compression, len(pixels), 2835, 2835, colours, 0)
        if header > 40 and header != 64:
            head += struct.pack("<4I", *(tuple(masks) + (0,) * 4)[:4])
        head = head.ljust(header, b"\0")
        if header == 40 and masks:
            head += struct.pack("<3I", *masks[:3])
    offset = 14 + len(head) + len(extra) + len(palette)
    return b"BM" + struct.pack("<IHHI", offset + len(pixels), 0, 0, offset) + head + extra + palette + pixels


def packed_rows(array, shifts):
    """Four channels of eight bits as 32-bit numbers."""
    numbers = sum(array[..., i].astype(np.uint32) << shift for i, shift in enumerate(shifts))
    return [row.astype("<u4").tobytes() for row in numbers[::-1]]


def write_bmp():
    bgra = (16, 8, 0, 24)
    for header in (56, 108, 124):
        save(f"bmp-alpha-{header}.bmp", bmp(packed_rows(RGBA, bgra), 32, header, 3, MASKS))
    save("bmp-alpha-rgba.bmp", bmp(packed_rows(RGBA, (0, 8, 16, 24)), 32, 108, 3, (0xFF, 0xFF00, 0xFF0000, 0xFF000000)))
    save("bmp-alpha-abgr.bmp", bmp(packed_rows(RGBA, (24, 16, 8, 0)), 32, 124, 3, (0xFF000000, 0xFF0000, 0xFF00, 0xFF)))
    zero = np.dstack([RGB, np.zeros_like(ALPHA)])
    full = np.dstack([RGB, np.full_like(ALPHA, 255)])
    save("bmp-alpha-zero.bmp", bmp(packed_rows(zero, bgra), 32, 108, 3, MASKS))
    save("bmp-alpha-full.bmp", bmp(packed_rows(full, bgra), 32, 124, 3, MASKS))
    # Without fields for alpha, the fourth byte has no meaning, for any header.
    save("bmp-32.bmp", bmp(packed_rows(RGBA, bgra), 32))
    save("bmp-32-v4.bmp", bmp(packed_rows(RGBA, bgra), 32, 108, 0, MASKS))
    save("bmp-32-v5.bmp", bmp(packed_rows(zero, bgra), 32, 124, 0, MASKS))
    save("bmp-fields-32.bmp", bmp(packed_rows(RGBA, bgra), 32, 40, 3, MASKS))
    save("bmp-fields-52.bmp", bmp(packed_rows(RGBA, bgra), 32, 52, 3, MASKS))
    save("bmp-fields-xbgr.bmp", bmp(packed_rows(RGBA, (24, 16, 8, 0)), 32, 108, 3, (0xFF000000, 0xFF0000, 0xFF00, 0)))
    save("bmp-fields-none.bmp", bmp(packed_rows(RGBA, bgra), 32, 108, 3, (0, 0, 0, 0)))
    r, g, b = (RGB[::-1, :, i].astype(np.uint16) for i in range(3))
    high = (r >> 3 << 11 | g >> 2 << 5 | b >> 3).astype("<u2")
    even = (r >> 3 << 10 | g >> 3 << 5 | b >> 3).astype("<u2")
    save("bmp-565.bmp", bmp([row.tobytes() for row in high], 16, 40, 3, (0xF800, 0x7E0, 0x1F)))
    save("bmp-565-v4.bmp", bmp([row.tobytes() for row in high], 16, 108, 3, (0xF800, 0x7E0, 0x1F)))
    save("bmp-555.bmp", bmp([row.tobytes() for row in even], 16))
    save("bmp-555-fields.bmp", bmp([row.tobytes() for row in even], 16, 40, 3, (0x7C00, 0x3E0, 0x1F)))
    bgr = [row[:, ::-1].tobytes() for row in RGB[::-1]]
    save("bmp-fields-24.bmp", bmp(bgr, 24, 108, 3, (0xFF0000, 0xFF00, 0xFF, 0)))
    save("bmp-top-down.bmp", bmp(bgr[::-1], 24, height=-HEIGHT))
    save("bmp-core.bmp", bmp(bgr, 24, 12))
    save("bmp-os2-v2.bmp", bmp(bgr, 24, 64))
    save("bmp-gap.bmp", bmp(bgr, 24, extra=b"\7" * 60))
    pale = b"".join(bytes((255 - 3 * i, 5 * i % 256, i * i % 256, 0)) for i in range(16))
    four = np.pad(GREY[::-1] // 16, ((0, 0), (0, 1)))
    save("bmp-4.bmp", bmp([(row[::2] << 4 | row[1::2]).tobytes() for row in four], 4, palette=pale))
    save("bmp-4-few.bmp", bmp([((row % 5)[::2] << 4 | (row % 5)[1::2]).tobytes() for row in four], 4, palette=pale[:20], colours=5))
    save("bmp-1.bmp", bmp([np.packbits(row).tobytes() for row in BITS[::-1]], 1, palette=pale[:8]))
    core = b"".join(bytes((255 - 3 * i, 5 * i % 256, i * i % 256)) for i in range(16))
    save("bmp-core-4.bmp", bmp([(row[::2] << 4 | row[1::2]).tobytes() for row in four], 4, 12, palette=core))
    runs = b""
    for row in GREY[::-1] // 16:
        at = 0
        while at < WIDTH:
            end = at + 1
            while end < WIDTH and row[end] == row[at]:
                end += 1
            runs += bytes((end - at, row[at]))
            at = end
        runs += b"\0\0"
    many = pale + b"\0" * 4 * 240
    save("bmp-rle8.bmp", bmp([runs + b"\0\1"], 8, 40, 1, palette=many))
    steps = b"\x05\x03\0\2\x03\x02\x08\x04\0\0" + b"\0\x05\1\2\3\4\5\0" + b"\x28\x07\0\0" * 24 + b"\0\1"
    save("bmp-rle8-steps.bmp", bmp([steps], 8, 40, 1, palette=many))
    nibbles = b"\x2d\x12\0\0" * 14 + b"\0\x05\x12\x34\x50\0\x28\x77\0\0" * 13 + b"\0\1"
    save("bmp-rle4.bmp", bmp([nibbles], 4, 40, 2, palette=pale))


# ---- GIF

def gif(screen, place, array, palette, local=b"", transparent=None, interlaced=False, background=2, version=b"GIF89a"):
    """A file of one frame; the pixels follow as codes of nine bits, cleared before they grow."""
    height, width = array.shape
    flags = 0xF7 if palette else 0x70
    out = version + struct.pack("<HHBBB", *screen, flags, background, 0) + palette.ljust(768 if palette else 0, b"\0")
    if transparent is not None:
        out += bytes((0x21, 0xF9, 4, 1, 0, 0, transparent, 0))
    kind = (0x87 if local else 0) | (0x40 if interlaced else 0)
    out += b"," + struct.pack("<HHHHB", *place, width, height, kind) + local.ljust(768 if local else 0, b"\0")
    if interlaced:
        order = [*range(0, height, 8), *range(4, height, 8), *range(2, height, 4), *range(1, height, 2)]
        array = array[order]
    bits, length = 0, 0
    for i, value in enumerate(array.ravel().tolist()):
        if i % 200 == 0:
            bits, length = bits | 256 << length, length + 9
        bits, length = bits | value << length, length + 9
    bits, length = bits | 257 << length, length + 9
    data = bits.to_bytes(-(-length // 8), "little")
    out += b"\x08" + b"".join(bytes((len(data[i:i + 255]),)) + data[i:i + 255] for i in range(0, len(data), 255))
    return out + b"\0;"


def write_gif():
    image = Image.fromarray(RGB).quantize(200)
    entries, palette = np.asarray(image), bytes(image.getpalette()[:600])
    other = bytes(255 - value for value in palette)
    size = (WIDTH, HEIGHT)
    save("gif-plain.gif", gif(size, (0, 0), entries, palette))
    save("gif-87.gif", gif(size, (0, 0), entries, palette, version=b"GIF87a"))
    save("gif-offset.gif", gif((60, 40), (9, 7), entries, palette))
    save("gif-smaller.gif", gif((60, 40), (0, 0), entries, palette))
    save("gif-offset-clear.gif", gif((60, 40), (9, 7), entries, palette, transparent=4))
    save("gif-screen-small.gif", gif((20, 10), (0, 0), entries, palette))
    save("gif-screen-narrow.gif", gif((20, 40), (3, 5), entries, palette))
    save("gif-screen-none.gif", gif((0, 0), (0, 0), entries, palette))
    save("gif-beyond-clear.gif", gif((40, 20), (9, 7), entries, palette, transparent=4))
    save("gif-interlaced.gif", gif(size, (0, 0), entries, palette, interlaced=True))
    save("gif-local.gif", gif(size, (0, 0), entries, palette, local=other))
    save("gif-local-only.gif", gif(size, (0, 0), entries, b"", local=other))
    first, second = Image.fromarray(RGB).quantize(40), ImageOps.invert(Image.fromarray(RGB)).quantize(40)
    pillow("gif-two.gif", first, save_all=True, append_images=[second])


# ---- PNG

def png(kind, depth, rows, before=(), width=WIDTH, height=HEIGHT, interlaced=0, after=()):
    def chunk(tag, body):
        return struct.pack(">I", len(body)) + tag + body + struct.pack(">I", zlib.crc32(tag + body))

    head = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, interlaced))
    extra = b"".join(chunk(*one) for one in before)
    late = b"".join(chunk(*one) for one in after)
    body = chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows)))
    return b"\x89PNG\r\n\x1a\n" + head + extra + body + late + chunk(b"IEND", b"")


def adam7(array):
    """Rows of the seven pictures of an interlaced one."""
    for left, top, across, down in [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]:
        part = array[top::down, left::across]
        if part.size:
            yield from (row.tobytes() for row in part)


def write_png():
    palette = bytes(Image.fromarray(RGB).quantize(16).getpalette()[:48])
    entries = np.asarray(Image.fromarray(RGB).quantize(16))
    even = np.pad(entries, ((0, 0), (0, 1)))
    nibbles = [(row[::2] << 4 | row[1::2]).tobytes() for row in even]
    plain = [row.tobytes() for row in RGB]
    save("png-palette-4.png", png(3, 4, nibbles, [(b"PLTE", palette)]))
    save("png-palette-4-clear.png", png(3, 4, nibbles, [(b"PLTE", palette), (b"tRNS", bytes(range(0, 240, 20)))]))
    save("png-palette-1.png", png(3, 1, [np.packbits(row).tobytes() for row in BITS], [(b"PLTE", palette[:6])]))
    save("png-grey-1.png", png(0, 1, [np.packbits(row).tobytes() for row in BITS]))
    four = np.pad(GREY // 16, ((0, 0), (0, 1)))
    save("png-grey-4.png", png(0, 4, [(row[::2] << 4 | row[1::2]).tobytes() for row in four]))
    two = np.pad(GREY // 64, ((0, 0), (0, 3)))
    quarters = [(row[::4] << 6 | row[1::4] << 4 | row[2::4] << 2 | row[3::4]).astype(np.uint8).tobytes() for row in two]
    save("png-grey-2.png", png(0, 2, quarters))
    save("png-grey-clear.png", png(0, 8, [row.tobytes() for row in GREY], [(b"tRNS", struct.pack(">H", int(GREY[5, 5])))]))
    save("png-rgb-clear.png", png(2, 8, plain, [(b"tRNS", struct.pack(">3H", *map(int, RGB[5, 5])))]))
    save("png-background.png", png(6, 8, [row.tobytes() for row in RGBA], [(b"bKGD", struct.pack(">3H", 9, 200, 9))]))
    save("png-grey-alpha-16.png", png(4, 16, [row.astype(">u2").tobytes() for row in np.dstack([GREY, ALPHA]).astype(int) * 257]))
    save("png-interlaced.png", png(2, 8, adam7(RGB), interlaced=1))
    save("png-interlaced-alpha.png", png(6, 8, adam7(RGBA), interlaced=1))
    save("png-interlaced-small.png", png(2, 8, adam7(RGB[:3, :2]), interlaced=1, width=2, height=3))
    save("png-gamma.png", png(2, 8, plain, [(b"gAMA", struct.pack(">I", 100_000))]))
    save("png-text.png", png(2, 8, plain, [(b"zTXt", b"Comment\0\0" + zlib.compress(b"words " * 900))], after=[(b"tEXt", b"Late\0word")]))
    image = Image.fromarray(RGB)
    pillow("png-animated.png", image, save_all=True, append_images=[ImageOps.invert(image)])
    pillow("png-animated-apart.png", image, save_all=True, append_images=[ImageOps.invert(image)] * 2, default_image=True)


# ---- JPEG

def jpeg(array, **options):
    out = io.BytesIO()
    (array if isinstance(array, Image.Image) else Image.fromarray(array)).save(out, "JPEG", **options)
    return out.getvalue()


def scans(file):
    """Positions of the scans in a file."""
    return [i for i in range(len(file) - 1) if file[i:i + 2] == b"\xff\xda"]


def write_jpeg():
    save("jpeg-411.jpg", jpeg(LARGE, quality=92, subsampling="4:1:1"))
    save("jpeg-422.jpg", jpeg(LARGE, quality=92, subsampling="4:2:2"))
    save("jpeg-odd-sizes.jpg", jpeg(LARGE[:33, :17], quality=92))
    save("jpeg-optimised.jpg", jpeg(LARGE, quality=92, optimize=True))
    save("jpeg-cmyk-plain.jpg", jpeg(Image.fromarray(CMYK, "CMYK"), quality=95))
    save("jpeg-one-pixel.jpg", jpeg(LARGE[:1, :1], quality=92))
    progressive = jpeg(LARGE, quality=92, progressive=True)
    starts = scans(progressive)
    end = b"\xff\xd9"
    # Whole scans are missing, but the file ends as it should: a download that a program patched up.
    for count in (1, 3, len(starts) - 1):
        save(f"jpeg-progressive-{count}-scans.jpg", progressive[:starts[count]] + end)
    middle = (starts[-1] + len(progressive)) // 2
    save("jpeg-progressive-patched.jpg", progressive[:middle] + end)
    save("jpeg-progressive-cut.jpg", progressive[:middle])
    baseline = jpeg(LARGE, quality=92)
    save("jpeg-patched.jpg", baseline[:len(baseline) * 2 // 3] + end)
    save("jpeg-cut.jpg", baseline[:len(baseline) * 2 // 3])
    save("jpeg-tail.jpg", baseline + b"\0" * 500 + baseline)


# ---- WebP

def write_webp():
    pillow("webp-lossy-alpha.webp", LARGE, quality=95)
    clear = np.dstack([LARGE, np.asarray(Image.fromarray(ALPHA).resize((105, 70)))])
    pillow("webp-lossy-clear.webp", clear, quality=95)
    pillow("webp-lossless-clear.webp", clear, lossless=True, exact=True)
    frames = [Image.new("RGBA", (60, 40)), Image.new("RGBA", (60, 40))]
    frames[0].paste(Image.fromarray(RGB), (9, 7))
    pillow("webp-animated-offset.webp", frames[0], save_all=True, append_images=frames[1:], lossless=True, background=(0, 99, 0, 255))


def seen(path):
    """The file as decoded by Pillow: upright, flattened on white, 8 bits per channel; None if Pillow cannot
    open it."""
    try:
        image = Image.open(path)
        image.load()
    except (OSError, ValueError, SyntaxError) as error:
        return None, str(error)
    image = ImageOps.exif_transpose(image)
    if image.mode.startswith("I") and image.mode != "I":
        image = Image.fromarray(((np.asarray(image).astype(np.uint32) + 128) // 257).astype(np.uint8))
    if image.mode in ("LA", "PA") or "transparency" in image.info:
        image = image.convert("RGBA")
    if image.mode in ("RGBA", "RGBa"):
        rgba = np.asarray(image.convert("RGBA")).astype(float)
        a = rgba[..., 3:] / 255
        image = Image.fromarray((rgba[..., :3] * a + 255 * (1 - a)).round().astype(np.uint8))
    return image.convert("RGB"), None


TABLE = """\
# Decoding differences from Pillow

This page lists the files that Inkpanel reads differently from Pillow, for integrators who compare pixels.
`tests/oracles/odd.py` writes it.

The script makes {count} small files with rare variants of JPEG, PNG, WebP, GIF, BMP and TIFF.
They cover bit depths, planes, tiles, predictors, alpha modes, palettes, inks, frames outside the screen and missing scans.
Pillow {version} opens {open} of them.
Inkpanel gives the same pixels for {same}, at 45 dB or more.
`tests/it/odd_files.rs` checks this and fails for any other difference.

| File | Reason |
|---|---|
"""


def main():
    FILES.mkdir(parents=True, exist_ok=True)
    for old in FILES.iterdir():
        old.unlink()
    ImageFile.LOAD_TRUNCATED_IMAGES = True
    for write in (write_tiff, write_bmp, write_gif, write_png, write_jpeg, write_webp):
        write()
    blob, index, known = b"", [], {}
    for path in sorted(FILES.iterdir()):
        image, error = seen(path)
        row = {"file": path.name, "reason": REASONS.get(path.name)}
        if image is None:
            print(path.name, "is not opened by Pillow:", error)
        else:
            pixels = image.tobytes()
            offset = known.setdefault(pixels, len(blob))
            if offset == len(blob):
                blob += pixels
            row |= {"width": image.width, "height": image.height, "offset": offset}
        index.append(row)
    missing = set(REASONS) - {row["file"] for row in index if "offset" in row}
    assert not missing, f"Pillow does not open {missing}"
    (DATA / "odd.bin").write_bytes(blob)
    (DATA / "odd.json").write_text("[\n" + ",\n".join(map(json.dumps, index)) + "\n]\n")
    opened = [row for row in index if "offset" in row]
    import PIL
    about = TABLE.format(count=len(index), version=PIL.__version__, open=len(opened), same=len(opened) - len(REASONS))
    rows = "".join(f"| `{name}` | {reason} |\n" for name, reason in sorted(REASONS.items()))
    (HERE.parent.parent / "docs/reference/decoding.md").write_text(about + rows + DAMAGED)


main()
