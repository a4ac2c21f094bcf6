"""The operations of examples/native.rs by OpenCV on one thread, and both as a Markdown table.

Usage: native.py PHOTO TIMES.json, where TIMES.json is what the example printed. `cargo xtask bench native` runs it.
"""

import json
import statistics
import sys
import time

import cv2
import numpy as np

RUNS, WARM = 25, 3
ALLOWED = 1.5

cv2.setNumThreads(1)
photo = cv2.cvtColor(cv2.imread(sys.argv[1]), cv2.COLOR_BGR2RGB)
rgb = cv2.resize(photo, (1920, 1080), interpolation=cv2.INTER_AREA)
bgr = cv2.cvtColor(rgb, cv2.COLOR_RGB2BGR)
gray = cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY)
tones = np.arange(256)
weights = np.array([0.299, 0.587, 0.114])
replicate = cv2.BORDER_REPLICATE


def table(values):
    entries = np.clip(np.round(values), 0, 255).astype(np.uint8)
    return lambda: cv2.LUT(gray, entries)


def matrix(rows):
    return lambda: cv2.transform(rgb, rows)


def hue(degrees):
    to_yuv = np.array([weights, (np.array([0, 0, 1]) - weights) / 1.772, (np.array([1, 0, 0]) - weights) / 1.402])
    cos, sin = np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))
    return np.linalg.inv(to_yuv) @ np.array([[1, 0, 0], [0, cos, -sin], [0, sin, cos]]) @ to_yuv


def sobel():
    across, down = cv2.Sobel(gray, cv2.CV_32F, 1, 0), cv2.Sobel(gray, cv2.CV_32F, 0, 1)
    return cv2.convertScaleAbs(cv2.magnitude(across, down), alpha=0.25)


def xdog(sigma=1.5, p=20):
    fine = gray.astype(np.float32)
    blurs = [cv2.GaussianBlur(fine, (0, 0), s, borderType=replicate) for s in (sigma, 1.6 * sigma)]
    return cv2.convertScaleAbs(cv2.max(cv2.addWeighted(blurs[0], 1 + p, blurs[1], -p, 0), 0))


def equalize():
    below = np.cumsum(cv2.calcHist([gray], [0], None, [256], [0, 256])) / gray.size
    low, high = np.searchsorted(below, 0.05), np.searchsorted(below, 0.95)
    return cv2.LUT(gray, np.clip((tones - low) * 255 / (high - low) + 0.5, 0, 255).astype(np.uint8))


def size(image, percent, way):
    return lambda: cv2.resize(image, (1920 * percent // 100, 1080 * percent // 100), interpolation=way)


def gaussian(image, sigma):
    return lambda: cv2.GaussianBlur(image, (0, 0), sigma, borderType=replicate)


OPERATIONS = {
    "To GrayScale, colour": lambda: cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY),
    "Posterization": table(np.floor(tones * 10 / 256) * 255 / 9),
    "Soft Threshold": table(255 * (1 + np.tanh(np.minimum(0, 0.03 * (tones - 80))))),
    "Saturation, colour": matrix(1.5 * np.eye(3) - 0.5 * weights),
    "Hue, angle 30, colour": matrix(hue(30)),
    "Gaussian Smoothing": gaussian(gray, 2),
    "Gaussian Smoothing, sigma 6": gaussian(gray, 6),
    "Gaussian Smoothing, sigma 6, colour": gaussian(rgb, 6),
    # The usual diameter of 9 instead of at least 25 for this sigma: less work, an advantage for OpenCV.
    "Image Detail Control, delta -100": lambda: cv2.bilateralFilter(gray, 9, 25, 8, borderType=replicate),
    "Sobel": sobel,
    "XDoG": xdog,
    "Size, percent 50": size(gray, 50, cv2.INTER_AREA),
    "Size, percent 50, colour": size(rgb, 50, cv2.INTER_AREA),
    "Size, percent 200": size(gray, 200, cv2.INTER_CUBIC),
    "Linear Histogram Equalization": equalize,
    # The OpenCV function for the same purpose. Its pictures differ.
    "Flow Lines": lambda: cv2.pencilSketch(bgr),
    "Engraving": lambda: cv2.pencilSketch(bgr),
    "Pencil Strokes": lambda: cv2.pencilSketch(bgr),
    "Anisotropic Kuwahara, one pass, colour": lambda: cv2.stylization(bgr),
    "Flat Areas, colour": lambda: cv2.stylization(bgr),
    "Printing Plates, colour": lambda: cv2.stylization(bgr),
    "Paper, colour": lambda: cv2.stylization(bgr),
}


def median(operation):
    """Milliseconds; slow ones are run less often."""
    times = []
    for _ in range(WARM + RUNS):
        start = time.perf_counter()
        operation()
        times.append((time.perf_counter() - start) * 1000)
        if sum(times) > 4000 and len(times) > WARM:
            break
    return statistics.median(times[WARM:] or times)


def main():
    own = json.load(open(sys.argv[2], encoding="utf-8"))
    lines = [
        f"Milliseconds at 1920 x 1080 in a native program, one thread each, compared with OpenCV {cv2.__version__}.",
        f"The goal is a ratio of at most {ALLOWED}. Higher ratios are bold.",
        "",
        "| Block | ms | OpenCV | ratio |",
        "|---|--:|--:|--:|",
    ]
    for name, ms in own.items():
        peer = median(OPERATIONS[name])
        ratio = f"{ms / peer:.2f}"
        lines.append(f"| {name} | {ms:.2f} | {peer:.2f} | {f'**{ratio}**' if ms / peer > ALLOWED else ratio} |")
    print("\n".join(lines))


main()
