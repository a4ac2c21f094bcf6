#!/usr/bin/env python3
"""The block Painter by ONNX Runtime and scipy, for blocks.py, and the network by ONNX Runtime.

    cargo xtask models
    python3 tests/oracles/painters.py        (numpy, onnxruntime, pillow, scipy)

Writes tests/oracles/data/painters.json: for some painters and mixtures, the painting of a small photo, as
hexadecimal digits of every third pixel of every third row. It also draws the rows of the block in
tests/oracles/data/blocks, so that the other blocks need not be drawn again.
"""

import json
import pathlib

import numpy as np
from PIL import Image
from scipy.ndimage import convolve1d, uniform_filter

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCKS = ROOT / "tests/oracles/data/blocks"
MODEL = ROOT / "www/models/painters.onnx"
PAINTERS = 10
LUMA = np.array([0.299, 0.587, 0.114])
# Numbers as in styles: 2.5 is the mean of the painters 2 and 3.
NUMBERS = [*range(1, PAINTERS + 1), 2.5, 6.2]
CASES = [{"painter": 1, "brush": 2}, {"painter": 3.4, "brush": 2, "strength": 70, "colours": 60}]


def to_u8(values):
    return np.floor(np.asarray(values, float) + 0.5).clip(0, 255).astype(np.uint8)


def shares(number):
    """The weight of each painter."""
    return np.maximum(0, 1 - abs(np.arange(1, PAINTERS + 1) - number)).astype(np.float32)


def network(image, number):
    import onnxruntime  # Only this block needs it.

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads, options.log_severity_level = 1, 3
    session = onnxruntime.InferenceSession(MODEL, options, providers=["CPUExecutionProvider"])
    planes = (image.astype(np.float32) / 255).transpose(2, 0, 1)[None]
    (painting,) = session.run(None, {"image": planes, "painters": shares(number)})
    return to_u8(painting[0].transpose(1, 2, 0) * 255)


def enlarged(image, factor):
    """Catmull-Rom on repeated borders."""

    def matrix(length):
        places = (np.arange(length * factor) + 0.5) / factor - 0.5
        weights = np.zeros((length * factor, length))
        for row, place in enumerate(places):
            start, t = int(np.floor(place)), place - np.floor(place)
            near = 0.5 * np.array([
                -t + 2 * t**2 - t**3, 2 - 5 * t**2 + 3 * t**3, t + 4 * t**2 - 3 * t**3, -(t**2) + t**3,
            ])  # fmt: skip
            for i, weight in enumerate(near):
                weights[row, np.clip(start - 1 + i, 0, length - 1)] += weight
        return weights

    height, width = image.shape[:2]
    return to_u8(np.einsum("yi,xj,ij...->yx...", matrix(height), matrix(width), image.astype(float)))


def gains(luma, painted):
    """How far a painting follows the luma of its photo, in windows that end at the border."""

    def mean(values):
        def sums(values):
            return uniform_filter(np.pad(values, 1), 3, mode="constant")[1:-1, 1:-1]

        return sums(values) / sums(np.ones_like(values))

    luma, painted = luma.astype(float), painted.astype(float)
    variance = mean(luma**2) - mean(luma) ** 2 + 40
    return np.clip((mean(luma * painted) - mean(luma) * mean(painted)) / variance, 0, 1)


def painter(image, painter=1, brush=3, strength=100, colours=0):
    height, width, _ = image.shape
    small = to_u8(image.reshape(height // brush, brush, width // brush, brush, 3).mean((1, 3)))
    painting = network(small, painter).astype(float)
    for axis in (0, 1):
        painting = to_u8(convolve1d(painting, [0.25, 0.5, 0.25], axis=axis, mode="nearest")).astype(float)
    luma = to_u8(small @ LUMA)
    gain = enlarged(gains(luma, to_u8(painting @ LUMA)) * 255, brush) / 256
    details = to_u8(image @ LUMA).astype(float) - enlarged(luma, brush)
    painted = to_u8(enlarged(painting, brush) + (gain * details)[..., None]).astype(float)
    shift = to_u8(painted @ LUMA).astype(float) - to_u8(image @ LUMA)
    painted += colours / 100 * (to_u8(image + shift[..., None]) - painted)
    return image + strength / 100 * (painted - image)


def main():
    photo = np.asarray(Image.open(BLOCKS / "photo.png").convert("RGB"))
    rows = [{"painter": number, "pixels": network(photo, number)[::3, ::3].tobytes().hex()} for number in NUMBERS]
    (ROOT / "tests/oracles/data/painters.json").write_text(json.dumps(rows, indent=1) + "\n")
    file = BLOCKS / "blocks.json"
    cases = [case for case in json.loads(file.read_text()) if case["block"] != "painter"]
    height, width, _ = photo.shape
    for i, params in enumerate(CASES):
        size = {"source": "photo", "top": i * height, "size": [width, height]}
        cases.append({"block": "painter", "params": params, **size})
    file.write_text("[\n" + ",\n".join(json.dumps(case) for case in cases) + "\n]\n")
    sheet = np.concatenate([to_u8(painter(photo.astype(float), **params)) for params in CASES])
    Image.fromarray(sheet).save(BLOCKS / "painter.png", optimize=True)


if __name__ == "__main__":
    main()
