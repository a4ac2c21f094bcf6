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


def profile(space, tags):
    text = b"\0\0\0\x0cenUS" + struct.pack(">II", 10, 28) + "Tests".encode("utf-16-be")
    words = b"mluc\0\0\0\0\0\0\0\x01" + text
    tags = {b"desc": words, b"cprt": words, b"wtpt": b"XYZ \0\0\0\0" + b"".join(map(fixed, D50))} | tags
    body, index, start = b"", b"", 132 + 12 * len(tags)
    for name, data in tags.items():
        index += name + struct.pack(">II", start + len(body), len(data))
        body += data + b"\0" * (-len(data) % 4)
    head = struct.pack(">I4sI4s4s4s", start + len(body), b"", 0x04300000, b"mntr", space, b"XYZ ")
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
