#!/usr/bin/env python3
"""Expected results of every filter block, made by other libraries.

    python3 tests/oracles/blocks.py            all blocks
    python3 tests/oracles/blocks.py posterize  only the pictures of these blocks

Needs numpy, opencv-contrib-python-headless, pillow, scipy and scikit-image, and onnxruntime for the block Painter.

Writes tests/oracles/data/blocks/: the photo and its luma, and one PNG per block with its cases one below the
other. The file blocks.json has the block, parameters and rows of each case. The file similarity.json has one
value for tests/it/preview.rs. The test tests/it/blocks.rs compares them, with the tolerance of each block and its
reason. Parameters in pixels are pixels of these files, because the test sets the scale to 1.
"""

import base64
import io
import json
import pathlib
import sys

import cv2
import numpy as np
from drawing import engrave, flatten, flow_lines, kuwahara, plates, strokes
from drawing import paper as sheet_of_paper
from etf import reference as etf
from painters import CASES as PAINTED
from painters import painter
from PIL import Image
from scipy.ndimage import gaussian_filter
from scipy.optimize import brentq
from scipy.stats import rankdata
from skimage.metrics import structural_similarity
from skimage.restoration import denoise_tv_chambolle

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUT = ROOT / "tests/oracles/data/blocks"
WEIGHTS = np.array([0.299, 0.587, 0.114])


def to_u8(values):
    return np.floor(np.asarray(values, float) + 0.5).clip(0, 255).astype(np.uint8)


def percentiles(luma, *percents):
    return np.percentile(luma, percents, method="inverted_cdf").astype(float)


# One function a block: (image as float, H x W or H x W x 3; parameters) -> the same, not yet rounded.


def to_gray(image):
    return cv2.cvtColor(to_u8(image), cv2.COLOR_RGB2GRAY)


def to_color(image):
    """There and back. Intermediate values are rounded to bytes, as in the blocks."""
    y = image @ WEIGHTS
    u, v = to_u8((image[..., 2] - y) / 1.772 + 128) - 128.0, to_u8((image[..., 0] - y) / 1.402 + 128) - 128.0
    y = to_u8(y).astype(float)
    return np.stack([y + 1.402 * v, y - 0.344136 * u - 0.714136 * v, y + 1.772 * u], -1)


def posterize(image, levels):
    return np.floor(image * levels / 256) * 255 / (levels - 1)


def luma_only(image, change):
    """A colour image takes the new luma and keeps its colour differences."""
    if image.ndim == 2:
        return change(image)
    y = to_u8(image @ WEIGHTS).astype(float)
    return image + (to_u8(change(y)) - y)[..., None]


def luma_posterize(image, levels):
    return luma_only(image, lambda y: posterize(y, levels))


def working_on(channels, image, change):
    """Only luma, or each channel separately."""
    return luma_only(image, change) if channels == "luma" else change(image)


def brightness(image, gain, channels="luma"):
    return working_on(channels, image, lambda v: v * gain)


def soft_threshold(image, phi, epsilon, channels="each"):
    return working_on(channels, image, lambda v: 255 * (1 + np.tanh(np.minimum(0, phi * (v - epsilon)))))


def saturation(image, amount, spare=0):
    y = (image @ WEIGHTS)[..., None]
    strength = np.ptp(image, axis=-1, keepdims=True) / 255
    change = max(amount - 1, 0) * (1 - spare / 100 * strength) + min(amount - 1, 0)
    return y + (1 + change) * (image - y)


def hue(image, angle, red, green, blue):
    y = image @ WEIGHTS
    uv = ((image[..., 2] - y) / 1.772 + 1j * (image[..., 0] - y) / 1.402) * np.exp(1j * np.deg2rad(angle))
    u, v = uv.real, uv.imag
    rgb = [y + 1.402 * v, y - (0.114 * 1.772 * u + 0.299 * 1.402 * v) / 0.587, y + 1.772 * u]
    return np.stack(rgb, -1) + [red, green, blue]


def colorize(image, hue, saturation):
    h, s = np.full_like(image, hue % 360), np.full_like(image, saturation)
    hls = np.stack([h, image / 255, s], -1).astype(np.float32)
    return cv2.cvtColor(hls, cv2.COLOR_HLS2RGB) * 255.0


def gaussian(image, sigma):
    axes = (sigma, sigma) + (0,) * (image.ndim - 2)
    return gaussian_filter(image, axes, mode="nearest", truncate=8)


def tvf(image, time):
    return denoise_tv_chambolle(image / 255, weight=time / 255, eps=1e-6, max_num_iter=1000) * 255


def sobel(image, gain, invert):
    y = image.astype(np.float32)
    d = [cv2.Sobel(y, cv2.CV_32F, *order, ksize=3, borderType=cv2.BORDER_REPLICATE) for order in ((1, 0), (0, 1))]
    magnitude = np.minimum(np.hypot(*d) / 4 * gain, 255)
    return 255 - to_u8(magnitude).astype(float) if invert else magnitude


def xdog(image, sigma, p):
    return (1 + p) * gaussian(image, sigma) - p * gaussian(image, 1.6 * sigma)


def size(image, percent):
    h, w = (round(side * percent / 100) for side in image.shape)
    if percent <= 100:
        return cv2.resize(image, (w, h), interpolation=cv2.INTER_AREA)
    # Catmull-Rom. Pillow drops samples beyond the border, while the block repeats the edge.
    pad, k = 4, percent // 100
    padded = Image.fromarray(np.pad(image, pad, mode="edge").astype(np.float32))
    large = padded.resize((padded.width * k, padded.height * k), Image.Resampling.BICUBIC)
    return np.asarray(large)[pad * k : -pad * k, pad * k : -pad * k]


def stroke(position, spacing, width):
    return np.abs((position / spacing) % 1 - 0.5) * spacing - width / 2


def own_texture(image, levels, texture):
    """A tone takes ink at the darkest parts of a custom texture, until the ink covers the tone."""
    tones = np.asarray(Image.open(io.BytesIO(base64.b64decode(texture.split(",")[1]))).convert("L")).astype(int)
    radius = max(min(tones.shape) // 48, 1)
    count, around = 2 * radius + 1, tones * 16
    for _ in range(3):
        for axis in (1, 0):
            around = (sum(np.roll(around, k, axis) for k in range(-radius, radius + 1)) + count // 2) // count
    order = (2 * 16 * tones + around + 24) // 48
    ranks = to_u8((rankdata(order, method="average") - 0.5).reshape(order.shape) / order.size * 255)
    tile = np.tile(ranks, [-(-side // part) for side, part in zip(image.shape, ranks.shape)])
    tile = tile[: image.shape[0], : image.shape[1]].astype(float)
    level = np.floor(image * levels / 256)
    drawn = np.clip((tile - 255 * (1 - level / (levels - 1))) / 24 + 0.5, 0, 1) * 255
    return np.where(level == 0, 0, np.where(level == levels - 1, 255, drawn))


def pattern(image, levels, pattern="hatch", scale=1, texture=""):
    """Tiles of strokes at scale 1, by their distance to ink at pixel centres."""
    assert scale == 1
    if texture:
        return own_texture(image, levels, texture)
    y, x = np.mgrid[: image.shape[0], : image.shape[1]] + 0.5
    out = np.zeros_like(image)
    for level in range(1, levels):
        darkness = 1 - level / (levels - 1)

        def diagonal(along, spacing, width):
            return stroke(along, spacing, width * np.sqrt(2)) / np.sqrt(2)

        width = (1 - np.sqrt(1 - darkness)) * 8 / np.sqrt(2)
        ink = {
            "lines": stroke(y, 6, 6 * darkness),
            "cross_hatch": np.minimum(diagonal(x + y, 8, width), diagonal(x - y, 8, width)),
        }[pattern]
        tile = np.full_like(image, 255.0) if level == levels - 1 else np.clip(ink + 0.5, 0, 1) * 255
        out = np.where(np.floor(image * levels / 256) >= level, tile, out)
    return out


def dot_radius(coverage):
    def covered(r):
        if r <= 0.5:
            return np.pi * r * r
        return np.pi * r * r - 4 * (r * r * np.arccos(0.5 / r) - 0.5 * np.sqrt(r * r - 0.25))

    return 1.0 if coverage >= 1 else brentq(lambda r: covered(r) - coverage, 0, np.sqrt(0.5))


RADII = np.array([dot_radius(v / 255) for v in range(256)])


def screen(ink, degrees, pitch):
    """White share of a dot screen, 0..1. `ink` is 0..255."""
    y, x = np.mgrid[: ink.shape[0], : ink.shape[1]].astype(float)
    turned = (x + 1j * y) * np.exp(-1j * np.deg2rad(degrees)) / pitch
    distance = np.hypot(turned.real % 1 - 0.5, turned.imag % 1 - 0.5)
    radius = RADII[to_u8(ink)]
    covered = np.clip((radius - distance) * pitch + 0.5, 0, 1)
    return 1 - np.where(radius > 0, covered, 0)


def halftone(image, pitch, mode):
    if mode == "mono":
        return screen(255 - image, 45, pitch) * 255
    most = image.max(-1)
    key = screen(255 - most, 45, pitch)
    inks = (most[..., None] - image) * (255 / np.maximum(most, 1))[..., None]
    return np.stack([screen(inks[..., i], angle, pitch) * key * 255 for i, angle in enumerate((15, 75, 0))], -1)


def detail(image, delta, sigma_s, sigma_r):
    y = image.astype(np.float32)
    base = cv2.bilateralFilter(y, 6 * sigma_s + 1, sigma_r, sigma_s, borderType=cv2.BORDER_REPLICATE)
    return image + delta / 100 * (image - base)


def equalize(image, low, high, channels="luma", knee=0):
    low, high = percentiles(image if image.ndim == 2 else to_u8(image @ WEIGHTS), low, high)
    tones = (np.arange(256) - low) / (high - low)
    # The knee is the hyperbola through the start of the knee, with slope 1, and through the tone of white.
    part = knee / 100
    for _ in range(2 if part else 0):
        tones = 1 - tones[::-1]
        far = (tones.max() - 1 + part) / part
        away = (tones - 1 + part) / part
        bent = 1 - part + part * away * far / (far + away * (far - 1))
        tones = np.where((away > 0) & (far > 1), bent, tones)
    return working_on(channels, image, lambda v: 255 * np.interp(v, np.arange(256), tones)) if high > low else image


def dynamic_range(image, range):
    low, high = percentiles(image, 5, 95)
    if not low < high < low + range:
        return image
    start = np.clip((low + high - range) / 2, 0, 255 - range)
    return start + (image - low) * range / (high - low)


def own_picture(rows):
    """A custom texture, as a user could make it: slanted strokes in two tones, as a data URL."""
    y, x = np.mgrid[:rows, :48]
    file = io.BytesIO()
    Image.fromarray(np.where((x + 2 * y) % 16 < 6, 30, 225).astype(np.uint8)).save(file, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(file.getvalue()).decode()


LUMA, COLOR = "luma", "photo"
FLOW = {"sigma": 1.4, "p": 30, "length": 6, "tone": 0, "epsilon": 180, "phi": 0.03, "shortest": 14}
ENGRAVE = {"pitch": 7, "angle": 20, "follow": 70, "layers": 2, "ink": 100}
STROKES = {"width": 2.2, "length": 14, "angle": -50, "follow": 60, "hardness": 55, "pressure": 80, "cross": True}
PLATES = {"inks": "red-blue", "shift": 3, "grain": 35, "pitch": 0, "steps": 1, "density": 100, "seed": 1}
PAPER = {"sheet": "smooth", "tint": "cream", "grain": 40, "pigment": 25, "size": 1}
CASES = [
    (to_gray, COLOR, {}),
    (to_color, COLOR, {}),
    *[(posterize, source, {"levels": n}) for source, n in ((LUMA, 2), (LUMA, 10), (COLOR, 5), (LUMA, 64))],
    *[(luma_posterize, source, {"levels": n}) for source, n in ((LUMA, 8), (COLOR, 5))],
    *[(brightness, COLOR, {"gain": gain}) for gain in (0.5, 1.2, 3)],
    (brightness, COLOR, {"gain": 1.6, "channels": "each"}),
    *[(soft_threshold, LUMA, {"phi": phi, "epsilon": e}) for phi, e in ((0.013, 50), (0.03, 80), (0.5, 120))],
    *[(soft_threshold, COLOR, {"phi": 0.03, "epsilon": 130, "channels": c}) for c in ("each", "luma")],
    *[(saturation, COLOR, {"amount": amount}) for amount in (0, 0.4, 1.5, 4)],
    *[(saturation, COLOR, {"amount": amount, "spare": spare}) for amount, spare in ((0.4, 50), (1.6, 60), (4, 100))],
    *[(hue, COLOR, {"angle": a, "red": r, "green": 0, "blue": b}) for a, r, b in ((30, 0, 0), (-120, 40, -25))],
    *[(colorize, LUMA, {"hue": h, "saturation": s}) for h, s in ((30, 0.5), (200, 1), (300, 0.25))],
    *[(gaussian, LUMA, {"sigma": sigma}) for sigma in (0.3, 0.5, 1, 2, 2.9, 3, 3.1, 6, 12, 25, 50)],
    (gaussian, COLOR, {"sigma": 4}),
    *[(etf, LUMA, {"sigma": sigma}) for sigma in (2, 4)],
    *[(tvf, LUMA, {"time": time}) for time in (5, 15, 40)],
    *[(sobel, LUMA, {"gain": gain, "invert": invert}) for gain, invert in ((1, False), (3, True))],
    *[(xdog, LUMA, {"sigma": sigma, "p": 20}) for sigma in (1, 2, 4, 8)],
    *[(size, LUMA, {"percent": percent}) for percent in (50, 35, 200)],
    *[(pattern, LUMA, {"levels": n, "pattern": p, "scale": 1}) for n, p in ((5, "lines"), (6, "cross_hatch"))],
    *[(pattern, LUMA, {"levels": n, "texture": own_picture(rows)}) for n, rows in ((5, 32), (8, 50))],
    *[(halftone, LUMA, {"pitch": pitch, "mode": "mono"}) for pitch in (6, 11.5)],
    (halftone, COLOR, {"pitch": 8, "mode": "cmyk"}),
    *[(detail, LUMA, {"delta": d, "sigma_s": s, "sigma_r": r}) for d, s, r in ((-100, 8, 25), (-100, 4, 40), (60, 8, 25))],
    *[(equalize, source, {"low": lo, "high": hi}) for source, lo, hi in ((LUMA, 5, 95), (LUMA, 20, 60), (COLOR, 5, 95))],
    (equalize, COLOR, {"low": 5, "high": 95, "channels": "each"}),
    *[(equalize, LUMA, {"low": 10, "high": 80, "knee": knee}) for knee in (15, 50)],
    (equalize, COLOR, {"low": 20, "high": 80, "channels": "each", "knee": 25}),
    *[(dynamic_range, LUMA, {"range": range_}) for range_ in (128, 250)],
    *[(flow_lines, LUMA, FLOW | more) for more in ({}, {"tone": 80, "epsilon": 120, "p": 20}, {"sigma": 3, "shortest": 0})],
    *[(kuwahara, LUMA, {"radius": r, "sharpness": 70, "stretch": 70, "passes": 1}) for r in (5, 10)],
    (kuwahara, COLOR, {"radius": 8, "sharpness": 50, "stretch": 100, "passes": 2}),
    *[(painter, COLOR, params) for params in PAINTED],
    *[(engrave, LUMA, ENGRAVE | more) for more in ({}, {"follow": 0, "angle": 35}, {"layers": 3, "pitch": 9})],
    *[(strokes, LUMA, STROKES | more) for more in ({}, {"length": 6, "follow": 0, "cross": False})],
    (strokes, COLOR, STROKES),
    (flatten, COLOR, {"colors": 15, "palette": "comic", "detail": 0, "smoothness": 0, "own": 0}),
    *[(plates, COLOR, PLATES | more) for more in ({}, {"inks": "yellow-blue-red", "steps": 4, "shift": 6})],
    *[(sheet_of_paper, COLOR, PAPER | more) for more in ({}, {"sheet": "cold-press", "tint": "ivory", "pigment": 80})],
]


def main(chosen):
    """Computes the chosen blocks, or all blocks. The rows and pictures of the others stay."""
    OUT.mkdir(parents=True, exist_ok=True)
    stored = json.loads((OUT / "blocks.json").read_text()) if chosen else []
    others = [row for row in stored if row["block"] not in chosen]
    photo = np.asarray(Image.open(ROOT / "tests/photos/macaw.jpg").convert("RGB"))[90:234, 250:442]
    sources = {COLOR: photo.astype(float)}
    sources[LUMA] = to_u8(sources[COLOR] @ WEIGHTS).astype(float)
    for name, source in sources.items():
        Image.fromarray(source.astype(np.uint8)).save(OUT / f"{name}.png", optimize=True)
    rows, sheets = [], {}
    for block, source, params in CASES:
        name = {etf: "etf", sheet_of_paper: "paper"}.get(block, block.__name__)
        if chosen and name not in chosen:
            rows.append(others.pop(0))
            continue
        expected = to_u8(block(sources[source], **params))
        if expected.ndim == 2 and any(c[0] is block and c[1] == COLOR for c in CASES) and block is not to_gray:
            expected = np.repeat(expected[..., None], 3, -1)
        sheet = sheets.setdefault(name, [])
        top = sum(part.shape[0] for part in sheet)
        rows.append({"block": name, "params": params, "source": source, "top": top, "size": [*expected.shape[1::-1]]})
        sheet.append(expected)
    for name, parts in sheets.items():
        width = max(part.shape[1] for part in parts)
        pad = [[(0, 0), (0, width - part.shape[1]), (0, 0)][: part.ndim] for part in parts]
        sheet = np.concatenate([np.pad(part, p) for part, p in zip(parts, pad)])
        Image.fromarray(sheet).save(OUT / f"{name}.png", optimize=True)
    if not chosen or "etf" in chosen:
        write_similarity(sources[LUMA], sheets["etf"][0])
    (OUT / "blocks.json").write_text("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]\n")


def write_similarity(luma, smoothed):
    similarity = structural_similarity(luma.astype(np.uint8), smoothed, data_range=255)
    (OUT / "similarity.json").write_text(json.dumps({"luma_etf": round(similarity, 9)}) + "\n")


main(sys.argv[1:])
