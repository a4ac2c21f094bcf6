"""ICC profiles for the files of `decode.py`, written from the primaries and curves that define the colour spaces."""

import struct

import numpy as np

D50 = (0.9642, 1.0, 0.8249)
D65 = (0.3127, 0.3290)
BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])

SRGB = ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06))
DISPLAY_P3 = ((0.680, 0.320), (0.265, 0.690), (0.150, 0.060))
ADOBE_RGB = ((0.64, 0.33), (0.21, 0.71), (0.15, 0.06))


def fixed(value):
    return struct.pack(">i", round(value * 65536))


def gamma(value):
    """A v2 curve of one number."""
    return b"curv" + struct.pack(">IIH", 0, 1, round(value * 256))


def table(light):
    """A v2 curve of as many entries as `light` has."""
    entries = [round(65535 * value) for value in light]
    return b"curv" + struct.pack(f">II{len(entries)}H", 0, len(entries), *entries)


def formula(kind, *values):
    """A v4 curve of one of the five formulas."""
    return b"para" + struct.pack(">IHH", 0, kind, 0) + b"".join(map(fixed, values))


SRGB_CURVE = formula(3, 2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045)


def columns(primaries, white=D65):
    """XYZ of the three primaries, adapted to D50."""
    def xyz(x, y):
        return np.array([x / y, 1, (1 - x - y) / y])

    matrix = np.stack([xyz(*primary) for primary in primaries], 1)
    matrix = matrix * np.linalg.solve(matrix, xyz(*white))
    cones = np.diag((BRADFORD @ D50) / (BRADFORD @ xyz(*white)))
    return (np.linalg.inv(BRADFORD) @ cones @ BRADFORD @ matrix).T


def profile(space, tags, kind=b"mntr", pcs=b"XYZ ", version=0x04300000):
    text = b"\0\0\0\x0cenUS" + struct.pack(">II", 10, 28) + "Tests".encode("utf-16-be")
    words = b"mluc\0\0\0\0\0\0\0\x01" + text
    tags = {b"desc": words, b"cprt": words, b"wtpt": b"XYZ \0\0\0\0" + b"".join(map(fixed, D50))} | tags
    body, index, start, places = b"", b"", 132 + 12 * len(tags), {}
    for name, data in tags.items():
        # Tags with the same data share it, except the two text tags, whose positions older files have.
        shared = data if name.startswith(b"A2B") else name
        if shared not in places:
            places[shared] = start + len(body)
            body += data + b"\0" * (-len(data) % 4)
        index += name + struct.pack(">II", places[shared], len(data))
    head = struct.pack(">I4sI4s4s4s", start + len(body), b"", version, kind, space, pcs)
    head += struct.pack(">6H", 2026, 1, 1, 0, 0, 0) + b"acsp" + b"\0" * 28 + b"".join(map(fixed, D50))
    return head.ljust(128, b"\0") + struct.pack(">I", len(tags)) + index + body


def colour(primaries, *curves):
    """A profile of a matrix and a curve, or three."""
    curves = curves * 3 if len(curves) == 1 else curves
    points = [b"XYZ \0\0\0\0" + b"".join(map(fixed, column)) for column in columns(primaries)]
    names = [b"rXYZ", b"gXYZ", b"bXYZ"], [b"rTRC", b"gTRC", b"bTRC"]
    return profile(b"RGB ", dict(zip(names[0], points)) | dict(zip(names[1], curves)))


def grey(curve):
    return profile(b"GRAY", {b"kTRC": curve})


def of_tables(space=b"RGB "):
    """A profile without a matrix, as printers have: not read by Inkpanel, nor valid."""
    return profile(space, {b"A2B0": b"mft1" + b"\0" * 44})


# ---- Tables

def lab(light):
    """Linear sRGB of 0 to 1 as L*a*b* under D50."""
    xyz = light @ np.array(columns(SRGB)) / np.array(D50)
    f = np.where(xyz > 216 / 24389, np.cbrt(xyz), (24389 / 27 * xyz + 16) / 116)
    return np.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], -1)


def press(inks):
    """Light reflected by four inks. Each ink absorbs its own third and some of the others, more with dot
    gain."""
    absorbed = np.array([[0.93, 0.32, 0.10], [0.22, 0.90, 0.45], [0.03, 0.12, 0.92], [0.88, 0.90, 0.91]])
    grown = inks ** 0.8
    return np.prod(1 - grown[..., None] * absorbed, axis=-2)


def scanner(samples):
    """Filters of a scanner that let some of their neighbours' light through."""
    return samples ** 1.9 @ np.array([[0.86, 0.10, 0.02], [0.11, 0.82, 0.08], [0.03, 0.08, 0.90]])


def grid(channels, size, model):
    """Colours of a grid whose last channel changes first."""
    steps = np.linspace(0, 1, size)
    return lab(model(np.stack(np.meshgrid(*[steps] * channels, indexing="ij"), -1).reshape(-1, channels)))


def tables(channels, size, model, wide=True):
    """A lut16Type or lut8Type: curves that do nothing around a grid of colours, as version 2 encodes them."""
    colours = grid(channels, size, model)
    head = struct.pack(">4sIBBBB", b"mft2" if wide else b"mft1", 0, channels, 3, size, 0)
    head += b"".join(fixed(float(i % 4 == 0)) for i in range(9))
    if wide:
        entries = np.stack([colours[:, 0] * 652.8, (colours[:, 1] + 128) * 256, (colours[:, 2] + 128) * 256], -1)
        straight = np.array([0, 65535], ">u2").tobytes()
        head += struct.pack(">HH", 2, 2)
        body = entries.round().clip(0, 65535).astype(">u2").tobytes()
    else:
        entries = np.stack([colours[:, 0] * 2.55, colours[:, 1] + 128, colours[:, 2] + 128], -1)
        straight = bytes(range(256))
        body = entries.round().clip(0, 255).astype(np.uint8).tobytes()
    return head + straight * channels + body + straight * 3


def curves_and_tables(channels, size, model):
    """A lutAToBType of version 4: a gamma for each channel, then a grid."""
    colours = grid(channels, size, lambda samples: model(samples ** (1 / 1.6)))
    entries = np.stack([colours[:, 0] * 655.35, (colours[:, 1] + 128) * 257, (colours[:, 2] + 128) * 257], -1)
    values = entries.round().clip(0, 65535).astype(">u2").tobytes()
    straight, bent = b"curv" + b"\0" * 8, formula(0, 1.6)
    cube = bytes([size] * channels).ljust(16, b"\0") + b"\2\0\0\0" + values
    cube += b"\0" * (-len(cube) % 4)
    first = 32 + 3 * len(straight)
    offsets = struct.pack(">5I", 32, 0, 0, first, first + len(cube))
    return b"mAB \0\0\0\0" + bytes([channels, 3, 0, 0]) + offsets + straight * 3 + cube + bent * channels


def of_press(size=7):
    """A press as profiles of version 2 have it, one table for two intents."""
    both = tables(4, size, press)
    return profile(b"CMYK", {b"A2B0": both, b"A2B1": both}, b"prtr", b"Lab ", 0x02400000)


def of_scanner(wide=True):
    """A scanner with one table."""
    return profile(b"RGB ", {b"A2B0": tables(3, 9, scanner, wide)}, b"scnr", b"Lab ", 0x02400000)


def of_printer():
    """An RGB printer profile of version 4."""
    both = curves_and_tables(3, 9, scanner)
    return profile(b"RGB ", {b"A2B0": both, b"A2B1": both}, b"prtr", b"Lab ")
