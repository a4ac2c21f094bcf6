#!/usr/bin/env python3
"""The model's ratings of photos, by a forward pass in plain numpy on the published weights.

    cargo xtask models; cargo build
    python3 tests/oracles/aesthetics.py target/debug/inkpanel WEIGHTS.hdf5        (h5py, numpy, pillow)

WEIGHTS is `weights_aisthetics.hdf5` of the package that `cargo xtask models` leaves below target/models. Writes
tests/oracles/data/aesthetics.json: per photo of tests/photos and www/public/samples the mean score from 1 to 10.
Nothing of the conversion to ONNX is used: the layers run in f32 with their batch normalisation unfolded.
"""

import json
import pathlib
import sys
import tempfile

import h5py
import numpy as np
from photo import decoded

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIDE = 224


class Weights:
    def __init__(self, path):
        self.file = h5py.File(path, "r")

    def __call__(self, layer, name):
        return np.asarray(self.file[f"{layer}/{layer}/{name}:0"], np.float32)


def windows(x, stride):
    """Height, width, 3, 3, channels: every 3 x 3 window, with a pixel of zeros round the picture."""
    padded = np.pad(x, ((1, 1), (1, 1), (0, 0)))
    view = np.lib.stride_tricks.sliding_window_view(padded, (3, 3), axis=(0, 1))
    return view[::stride, ::stride].transpose(0, 1, 3, 4, 2)


def normalised(x, weights, layer):
    gamma, beta = weights(layer, "gamma"), weights(layer, "beta")
    mean, variance = weights(layer, "moving_mean"), weights(layer, "moving_variance")
    return np.clip((x - mean) / np.sqrt(variance + np.float32(1e-3)) * gamma + beta, 0, 6)


def score(picture, weights):
    # The nearest pixel of a stretched picture, as in training.
    width, height = picture.size
    at = np.arange(SIDE) + 0.5
    pixels = np.asarray(picture, np.float32)
    x = pixels[(at * height / SIDE).astype(int)][:, (at * width / SIDE).astype(int)] / np.float32(127.5) - 1
    x = np.einsum("yxijc,ijcd->yxd", windows(x, 2), weights("conv1", "kernel"), optimize=True)
    x = normalised(x, weights, "conv1_bn")
    for pair in range(1, 14):
        kernel = weights(f"conv_dw_{pair}", "depthwise_kernel")[..., 0]
        x = np.einsum("yxijc,ijc->yxc", windows(x, 2 if pair in (2, 4, 6, 12) else 1), kernel)
        x = normalised(x, weights, f"conv_dw_{pair}_bn")
        x = normalised(x @ weights(f"conv_pw_{pair}", "kernel")[0, 0], weights, f"conv_pw_{pair}_bn")
    logits = x.mean((0, 1)) @ weights("dense_1", "kernel") + weights("dense_1", "bias")
    shares = np.exp(logits - logits.max())
    return float((shares / shares.sum()) @ np.arange(1, 11))


def main():
    weights = Weights(sys.argv[2])
    rows = []
    for file in sorted([*ROOT.glob("tests/photos/*.jpg"), *ROOT.glob("www/public/samples/*.jpg")]):
        with tempfile.TemporaryDirectory() as folder:
            mean = score(decoded(sys.argv[1], file, pathlib.Path(folder)), weights)
        rows.append({"file": file.relative_to(ROOT).as_posix(), "mean": round(mean, 4)})
    text = ",\n".join(json.dumps(row) for row in rows)
    (ROOT / "tests/oracles/data/aesthetics.json").write_text(f"[\n{text}\n]\n")


if __name__ == "__main__":
    main()
