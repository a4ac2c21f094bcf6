#!/usr/bin/env python3
"""Resampling and selection of the held-out photos in plain numpy and scipy.

    python3 tests/oracles/selection.py        (numpy, pillow, scipy)

Writes tests/oracles/data/selection.json. Per photo of tests/photos, it has the exact-area reduction of its
luma to 23 x 17 (as hex). It also has the reduction of a region with fractional edges to 16 x 12, and the
fingerprint and sharpness of the whole. Pillow decodes the photos. Luma is .299 R + .587 G + .114 B, rounded.
"""

import json
import pathlib

import numpy as np
from PIL import Image
from scipy.ndimage import gaussian_filter, laplace

ROOT = pathlib.Path(__file__).resolve().parents[2]


def coverage(length, start, extent, count):
    """A count x length matrix: which part of each output every input makes."""
    edges = start + np.arange(count + 1) * extent / count
    i = np.arange(length)
    lo = np.maximum(edges[:-1, None], i)
    hi = np.minimum(edges[1:, None], i + 1)
    part = np.clip(hi - lo, 0, None)
    return part / part.sum(1, keepdims=True)


def area(plane, width, height, region=None):
    h, w = plane.shape
    x, y, rw, rh = region or (0, 0, w, h)
    return coverage(h, y, rh, height) @ plane @ coverage(w, x, rw, width).T


def round_half_up(values):
    return np.floor(values + 0.5).clip(0, 255).astype(np.uint8)


def fingerprint(luma):
    cells = area(gaussian_filter(area(luma, 36, 32), 2, mode="nearest", truncate=4), 9, 8)
    bits = 0
    for r in range(8):
        for c in range(8):
            bit = cells[r, c + 1] > cells[r, c] if r % 2 == 0 else cells[r, c] > cells[r - 1, c]
            bits |= int(bit) << (8 * r + c)
    return f"{bits:016x}"


def gradients(luma):
    gx = (luma[1:-1, 2:] - luma[1:-1, :-2]) / 2
    gy = (luma[2:, 1:-1] - luma[:-2, 1:-1]) / 2
    return np.hypot(gx, gy)[::3, ::3]


def sharpness(luma):
    magnitude = gradients(luma)
    gradient = magnitude.mean() * max(luma.shape) / 1000 / (luma.std() + 1)
    histogram = np.bincount(round_half_up(magnitude).ravel(), minlength=256) * 256 / magnitude.size
    h, w = luma.shape
    scale = min(1, 640 / max(h, w))
    small = round_half_up(area(luma, round(w * scale), round(h * scale))).astype(float)
    return gradient, 256 / ((histogram - 1) ** 2).sum(), laplace(small, mode="nearest").var()


def main():
    rows = []
    for path in sorted((ROOT / "tests/photos").glob("*.jpg")):
        rgb = np.asarray(Image.open(path).convert("RGB")).astype(float)
        luma = round_half_up(rgb @ [0.299, 0.587, 0.114]).astype(float)
        h, w = luma.shape
        region = (round(w * 0.13, 2), round(h * 0.21, 2), round(w * 0.61, 2), round(h * 0.57, 2))
        gradient, paper, laplacian = sharpness(luma)
        rows.append(
            {
                "file": path.name,
                "whole": round_half_up(area(luma, 23, 17)).tobytes().hex(),
                "region": region,
                "part": round_half_up(area(luma, 16, 12, region)).tobytes().hex(),
                "fingerprint": fingerprint(luma),
                "gradient": round(gradient, 6),
                "paper": round(paper, 7),
                "laplacian": round(laplacian, 3),
            }
        )
    out = pathlib.Path(__file__).parent / "data/selection.json"
    out.write_text("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]\n")


main()
