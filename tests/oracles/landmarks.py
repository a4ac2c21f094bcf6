#!/usr/bin/env python3
"""Points of faces by LiteRT, Google's runtime, with the original model.

    cargo xtask models
    python3 tests/oracles/landmarks.py        (numpy, ai-edge-litert, onnxruntime, pillow)

Writes tests/oracles/data/landmarks.json. It has the faces of detect.json, upright and on their side. False faces are left
out: the program ignores their points. Each face has the box and the six points in fractions of the photo, and the
probability of a face. Its 468 points are in tenths of a pixel of the photo. Everything is a separate
implementation: numpy cuts out the square and maps the points back.
"""

import json
import math
import pathlib

import numpy as np
from ai_edge_litert.interpreter import Interpreter
from PIL import Image
from detect import coverage

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKED = "target/models/mediapipe-face_mesh-0.4.1657299874/package/face_mesh_solution_packed_assets.data"
SIDE = 192
# Minimum probability of a face.
PRESENT = 0.5


def model():
    return Interpreter(model_content=(ROOT / PACKED).read_bytes()[2_495_952:3_737_848])


def square(box, points, size):
    """Middle, side and angle, in pixels: MediaPipe's rectangle of a face, 1.5 times as large, with level eyes."""
    (width, height), (left, top, right, bottom) = size, box
    middle = np.array([(left + right) / 2 * width, (top + bottom) / 2 * height])
    side = 1.5 * max((right - left) * width, (bottom - top) * height)
    (ax, ay), (bx, by) = points[0], points[1]
    return middle, side, math.atan2((by - ay) * height, (bx - ax) * width)


def to_photo(places, middle, side, angle):
    """From pixels of the model's input, [n, 2]."""
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    return (places / SIDE - 0.5) * side @ turn + middle


def cut(photo, middle, side, angle):
    """The square in 192 x 192 pixels from 0 to 1. The part of the photo around a large square is reduced first."""
    size = np.array(photo.size)
    corners = to_photo(np.array([[0, 0], [SIDE, 0], [0, SIDE], [SIDE, SIDE]]), middle, side, angle)
    first = np.floor(corners.min(0) - 1).clip(0, size - 1)
    last = np.minimum(np.ceil(corners.max(0) + 1), size)
    across, down = np.ceil((last - first) / max(1, side / SIDE)).astype(int)
    part = np.asarray(photo, np.float64)[int(first[1]) : int(last[1]), int(first[0]) : int(last[0])]
    rows = np.floor(np.einsum("rh,hwc->rwc", coverage(part.shape[0], down), part) + 0.5)
    part = np.floor(np.einsum("rw,hwc->hrc", coverage(part.shape[1], across), rows) + 0.5)
    at = np.arange(SIDE) + 0.5
    places = to_photo(np.stack(np.meshgrid(at, at), -1).reshape(-1, 2), middle, side, angle)
    x, y = ((places - first) / (last - first) * [across, down] - 0.5).clip(0, [across - 1, down - 1]).T
    left, top = np.floor(x).astype(int), np.floor(y).astype(int)
    right, bottom = np.minimum(left + 1, across - 1), np.minimum(top + 1, down - 1)
    beside, below = (x - left)[:, None], (y - top)[:, None]
    upper = part[top, left] * (1 - beside) + part[top, right] * beside
    lower = part[bottom, left] * (1 - beside) + part[bottom, right] * beside
    return (upper * (1 - below) + lower * below).reshape(SIDE, SIDE, 3) / 255


def look(interpreter, photo, box, points):
    """The 468 points in pixels of the photo, and the probability of a face."""
    place = square(box, points, photo.size)
    interpreter.allocate_tensors()
    interpreter.set_tensor(interpreter.get_input_details()[0]["index"], cut(photo, *place)[None].astype(np.float32))
    interpreter.invoke()
    mesh, logit = (interpreter.get_tensor(output["index"]).ravel() for output in interpreter.get_output_details())
    return to_photo(mesh.reshape(-1, 3)[:, :2].astype(np.float64), *place), 1 / (1 + math.exp(-float(logit[0])))


def on_its_side(photo, box, points):
    """A quarter turn: the photo's left edge becomes its upper edge."""
    left, top, right, bottom = box
    turned = [1 - bottom, left, 1 - top, right]
    return photo.transpose(Image.Transpose.ROTATE_270), turned, [[1 - y, x] for x, y in points]


def main():
    interpreter = model()
    rows = []
    for row in json.loads((ROOT / "tests/oracles/data/detect.json").read_text()):
        faces = [(box[2:6], box[6]) for box in row["boxes"] if box[0] == "face"]
        if not faces:
            continue
        photo = Image.open(ROOT / row["file"]).convert("RGB")
        views = [(False, photo, box, points) for box, points in faces]
        views += [(True, *on_its_side(photo, box, points)) for box, points in faces]
        for turned, seen, box, points in views:
            mesh, presence = look(interpreter, seen, box, points)
            if presence < PRESENT:
                continue
            tenths = np.round(mesh * 10).astype(int).ravel().tolist()
            points = [[round(x, 5), round(y, 5)] for x, y in points]
            box = [round(side, 5) for side in box]
            about = {"file": row["file"], "turned": turned, "box": box, "points": points}
            rows.append({**about, "presence": round(presence, 4), "mesh": tenths})
    text = ",\n".join(json.dumps(row) for row in rows)
    (ROOT / "tests/oracles/data/landmarks.json").write_text(f"[\n{text}\n]\n")


if __name__ == "__main__":
    main()
