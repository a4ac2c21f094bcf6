#!/usr/bin/env python3
"""Faces and objects by ONNX Runtime, with the models of the program.

    cargo xtask models; cargo build
    python3 tests/oracles/detect.py target/debug/inkpanel        (numpy, onnxruntime, pillow)

Writes tests/oracles/data/detect.json. Per photo of tests/photos and www/public/samples, it has the boxes of
one pass over the whole photo, in fractions of the photo. A box is [label or COCO number, score, left, top,
right, bottom]. A face also has its six points, [x, y] each. Everything except the models is a separate implementation. Pillow decodes, and plain numpy
does exact-area reduction, letterbox, anchors, decoding of boxes and removal of duplicates.
"""

import json
import pathlib
import sys
import tempfile

import numpy as np
import onnxruntime
from photo import decoded

ROOT = pathlib.Path(__file__).resolve().parents[2]


def net(name):
    options = onnxruntime.SessionOptions()
    options.log_severity_level = 3
    return onnxruntime.InferenceSession(ROOT / "www/models" / name, options, providers=["CPUExecutionProvider"])


def coverage(length, count):
    """A count x length matrix: which part of each output every input makes."""
    edges = np.arange(count + 1) * length / count
    i = np.arange(length)
    part = np.clip(np.minimum(edges[1:, None], i + 1) - np.maximum(edges[:-1, None], i), 0, None)
    part /= part.sum(1, keepdims=True)
    # The program's fixed-point weights, so that no value ends on the other side of a half.
    one = 2**19 if part[0].max() < 1 / 17 else 2**14
    return np.diff(np.floor(np.cumsum(part, 1) * one + 0.5), axis=1, prepend=0) / one


def letterbox(photo, side):
    scale = side / max(photo.size)
    width, height = (max(1, int(length * scale + 0.5)) for length in photo.size)
    left, top = (side - width) // 2, (side - height) // 2
    planes = np.asarray(photo, np.float64).transpose(2, 0, 1)
    square = np.zeros((3, side, side))
    # Whole numbers after each axis, as in the program: the scores of textured photos are that touchy.
    rows = np.floor(coverage(photo.height, height) @ planes + 0.5)
    square[:, top : top + height, left : left + width] = np.floor(rows @ coverage(photo.width, width).T + 0.5)
    values = square[None].astype(np.float32) / 127.5 - 1

    def back(boxes):
        moved = (boxes * side - [left, top, left, top]) / [width, height, width, height]
        return moved.clip(0, 1)

    return values, back


def iou(box, others):
    shared = np.clip(np.minimum(box[2:], others[:, 2:]) - np.maximum(box[:2], others[:, :2]), 0, None).prod(1)
    area = (others[:, 2:] - others[:, :2]).prod(1)
    return shared / ((box[2:] - box[:2]).prod() + area - shared)


def suppress(boxes, scores, limit):
    order = np.argsort(-scores, kind="stable")
    kept = []
    while len(order):
        kept.append(order[0])
        order = order[1:][iou(boxes[order[0]], boxes[order[1:]]) <= limit]
    return kept


def sigmoid(x):
    return 1 / (1 + np.exp(-x.astype(np.float64)))


def anchors():
    rows = []
    scales = np.append(np.linspace(0.2, 0.95, 6), 1.0)
    for level, cells in enumerate((19, 10, 5, 3, 2, 1)):
        if level == 0:
            shapes = [(0.1, 1), (0.2, 2), (0.2, 0.5)]
        else:
            shapes = [(scales[level], ratio) for ratio in (1, 2, 0.5, 3, 1 / 3)]
            shapes.append((np.sqrt(scales[level] * scales[level + 1]), 1))
        for y in range(cells):
            for x in range(cells):
                for size, ratio in shapes:
                    centre = ((x + 0.5) / cells, (y + 0.5) / cells)
                    rows.append((*centre, size * np.sqrt(ratio), size / np.sqrt(ratio)))
    return np.array(rows)


def boxes_of(x, y, w, h):
    return np.stack([x - w / 2, y - h / 2, x + w / 2, y + h / 2], 1)


def objects(session, photo, grid=anchors()):
    values, back = letterbox(photo, 300)
    moves, logits = session.run(["Squeeze", "concat_1"], {"image": values})
    ty, tx, th, tw = moves[0].astype(np.float64).T
    ax, ay, aw, ah = grid.T
    boxes = back(boxes_of(ax + tx / 10 * aw, ay + ty / 10 * ah, aw * np.exp(tw / 5), ah * np.exp(th / 5)))
    scores = sigmoid(logits[0])
    found = []
    for label in range(1, 91):
        sure = scores[:, label] > 0.4
        some, marks = boxes[sure], scores[sure, label]
        found += [(label, marks[i], *some[i]) for i in suppress(some, marks, 0.5)]
    return found


def faces(session, photo):
    values, back = letterbox(photo, 192)
    names = ["reshaped_regressor_face_4", "reshaped_classifier_face_4"]
    numbers, logits = session.run(names, {"image": values})
    scores = sigmoid(logits[0, :, 0])
    dx, dy, w, h = numbers[0, :, :4].astype(np.float64).T / 192
    cell = np.arange(48 * 48)
    ax, ay = (cell % 48 + 0.5) / 48, (cell // 48 + 0.5) / 48
    boxes = back(boxes_of(ax + dx, ay + dy, w, h))
    moves = numbers[0, :, 4:].astype(np.float64) / 192
    # Two points are the corners of a box, for the way back to the photo.
    points = [back(np.stack([ax + x, ay + y, ax + x, ay + y], 1))[:, :2] for x, y in zip(moves.T[::2], moves.T[1::2])]
    points = np.stack(points, 1)
    sure = scores > 0.5
    boxes, scores, points = boxes[sure], scores[sure], points[sure]
    return [("face", scores[i], *boxes[i], points[i].tolist()) for i in suppress(boxes, scores, 0.3)]


def rounded(value):
    return [rounded(part) for part in value] if isinstance(value, list) else round(float(value), 5)


def main():
    nets = net("faces.onnx"), net("objects.onnx")
    rows = []
    for file in sorted([*ROOT.glob("tests/photos/*.jpg"), *ROOT.glob("www/public/samples/*.jpg")]):
        with tempfile.TemporaryDirectory() as folder:
            photo = decoded(sys.argv[1], file, pathlib.Path(folder))
        found = faces(nets[0], photo) + objects(nets[1], photo)
        boxes = [[label, *(rounded(number) for number in rest)] for label, *rest in found]
        rows.append({"file": file.relative_to(ROOT).as_posix(), "boxes": boxes})
    text = ",\n".join(json.dumps(row) for row in rows)
    (ROOT / "tests/oracles/data/detect.json").write_text(f"[\n{text}\n]\n")


if __name__ == "__main__":
    main()
