"""The reference of Edge Tangent Flow in plain numpy: Kang's field and a Gaussian line integral along it.

Source: Kang, Lee and Chui, "Flow-based image abstraction", 2009. The trainer of the filter bank has the same in Rust
(examples/train_blade/etf.rs).
"""

import numpy as np
from scipy.ndimage import map_coordinates, sobel

RADIUS = 5
PASSES = 3
STEP = 0.5


def field(plane):
    """Unit tangents (x, y), H x W each; zero in flat areas."""
    gx, gy = (sobel(plane, axis=axis, mode="nearest") for axis in (1, 0))
    magnitude = np.hypot(gx, gy)
    safe = np.maximum(magnitude, 1e-6)
    tx, ty = -gy / safe, gx / safe
    g = magnitude / max(magnitude.max(), 1e-6)
    h, w = plane.shape
    offsets = [
        (dx, dy)
        for dy in range(-RADIUS, RADIUS + 1)
        for dx in range(-RADIUS, RADIUS + 1)
        if dx * dx + dy * dy <= RADIUS * RADIUS
    ]
    for _ in range(PASSES):
        padded = [np.pad(p, RADIUS, mode="edge") for p in (tx, ty, g)]
        sx, sy = np.zeros_like(plane), np.zeros_like(plane)
        for dx, dy in offsets:
            window = (slice(RADIUS + dy, RADIUS + dy + h), slice(RADIUS + dx, RADIUS + dx + w))
            nx, ny, ng = (p[window] for p in padded)
            weight = 0.5 * (1 + np.tanh(ng - g)) * (tx * nx + ty * ny)
            sx += weight * nx
            sy += weight * ny
        length = np.hypot(sx, sy)
        flat = length < 1e-6
        tx = np.where(flat, 0, sx / np.maximum(length, 1e-6))
        ty = np.where(flat, 0, sy / np.maximum(length, 1e-6))
    return tx, ty


def reference(image, sigma):
    """Averages each pixel along the flow line through it, weights exp(-s^2 / 2 sigma^2) to 3 sigma."""
    tx, ty = field(image)
    h, w = image.shape
    y0, x0 = np.mgrid[:h, :w].astype(float)

    def at(plane, x, y):
        return map_coordinates(plane, [y.clip(0, h - 1), x.clip(0, w - 1)], order=1, mode="nearest")

    def direction(x, y, vx, vy):
        dx, dy = at(tx, x, y), at(ty, x, y)
        length = np.maximum(np.hypot(dx, dy), 1e-6)
        sign = np.where(dx * vx + dy * vy < 0, -1, 1)
        return dx / length * sign, dy / length * sign

    total, weights = image.copy(), np.ones_like(image)
    for sense in (1, -1):
        x, y = x0.copy(), y0.copy()
        vx, vy = tx * sense, ty * sense
        for step in range(1, int(np.ceil(3 * sigma / STEP)) + 1):
            kx, ky = direction(x, y, vx, vy)
            vx, vy = direction(x + STEP / 2 * kx, y + STEP / 2 * ky, kx, ky)
            x, y = (x + STEP * vx).clip(0, w - 1), (y + STEP * vy).clip(0, h - 1)
            weight = np.exp(-((step * STEP) ** 2) / (2 * sigma * sigma))
            total += weight * at(image, x, y)
            weights += weight
    return total / weights
