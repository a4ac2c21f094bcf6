"""The blocks that draw along a field of directions, that flatten and that print, in plain double precision.

Written from the formulas at the top of each block's source, with numpy and scipy. It uses neither SIMD nor
fixed-point numbers. It solves exactly if the block iterates, and uses scipy's labels if the block joins runs.
`blocks.py` runs it.
"""

import numpy as np
from scipy.ndimage import convolve1d, gaussian_filter, label
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import lsqr

TURNS = 32
WEIGHTS = np.array([0.299, 0.587, 0.114])


def luma_of(image):
    return image if image.ndim == 2 else np.floor(image @ WEIGHTS + 0.5)


def blur(image, sigma):
    return gaussian_filter(image, sigma, mode="nearest", truncate=8)


def halves(image):
    """Means of 2 x 2 pixels; odd ends repeat the edge."""
    h, w = image.shape
    even = np.pad(image, ((0, h % 2), (0, w % 2)), mode="edge")
    return (even[::2, ::2] + even[1::2, ::2] + even[::2, 1::2] + even[1::2, 1::2]) / 4


def tangents(luma, rho):
    """Directions (0 to 31, of half a turn) and coherence (0 to 1) of each cell of 4 x 4 pixels."""
    half = np.pad(halves(luma), 1, mode="edge")
    diff, mean = np.array([1, 0, -1]), np.array([1, 2, 1])
    gx = convolve1d(convolve1d(half, diff, 1), mean, 0)[1:-1, 1:-1]
    gy = convolve1d(convolve1d(half, diff, 0), mean, 1)[1:-1, 1:-1]
    length = np.hypot(gx, gy) + 1
    cells = []
    for part in (gx * gx, gx * gy, gy * gy):
        part = part / length
        h, w = part.shape
        part = np.pad(part, ((0, h % 2), (0, w % 2)))
        part = part[::2, ::2] + part[1::2, ::2] + part[::2, 1::2] + part[1::2, 1::2]
        sigma = rho / 4
        reach = int(np.ceil(2.5 * sigma))
        cells.append(gaussian_filter(part, sigma, mode="nearest", radius=reach) if sigma >= 0.2 else part)
    xx, xy, yy = cells
    angle = 0.5 * np.arctan2(2 * xy, xx - yy) / np.pi + 0.5
    turns = np.floor(angle * TURNS + 0.5).astype(int) % TURNS
    coherence = np.hypot(xx - yy, 2 * xy) / (xx + yy + 1)
    return turns, np.floor(coherence * 255) / 255


def per_pixel(cells, shape):
    return np.repeat(np.repeat(cells, 4, 0), 4, 1)[: shape[0], : shape[1]]


def round_away(values):
    """Halves away from zero, as Rust rounds."""
    return np.sign(values) * np.floor(np.abs(values) + 0.5)


def at(image, dx, dy):
    y, x = np.mgrid[: image.shape[0], : image.shape[1]]
    return image[np.clip(y + dy, 0, image.shape[0] - 1).astype(int), np.clip(x + dx, 0, image.shape[1] - 1).astype(int)]


def along(image, turns, sigma):
    """Averages along the field, in passes whose steps grow threefold."""
    angle = per_pixel(turns, image.shape) * np.pi / TURNS
    done, gap = 0.0, 1.0
    while sigma**2 - done > 0.16:
        left = np.sqrt(sigma**2 - done)
        own = min(np.sqrt((1.8 * gap) ** 2 - done), left) if left > 4.8 * gap else left
        places = np.arange(-np.ceil(2.5 * own / gap), np.ceil(2.5 * own / gap) + 1) * gap
        weights = np.exp(-0.5 * (places / own) ** 2)
        moved = [at(image, round_away(np.cos(angle) * d), round_away(np.sin(angle) * d)) for d in places]
        image = np.tensordot(weights / weights.sum(), moved, 1)
        done, gap = done + own**2, 3 * gap
    return image


def flow_lines(image, sigma, p, length, tone, epsilon, phi, shortest):
    turns, _ = tangents(image, max(5, 2 * sigma, 2))
    narrow, wide = blur(image, sigma), blur(image, 1.6 * sigma)
    lines = tone / 100 * narrow + (1 - tone / 100) * 200 + p * (narrow - wide)
    lines = along(np.clip(lines, -512, 767), turns, length)
    out = np.floor(255 * (1 + np.tanh(phi * np.minimum(0, lines - epsilon))) + 0.5)
    if shortest < 4:
        return out
    h, w = out.shape
    even = np.pad(out, ((0, h % 2), (0, w % 2)), mode="edge")
    dark = np.minimum.reduce([even[::2, ::2], even[1::2, ::2], even[::2, 1::2], even[1::2, 1::2]]) < 208
    pieces, count = label(dark, np.ones((3, 3)))
    kept = np.zeros_like(dark)
    for piece in range(1, count + 1):
        y, x = np.nonzero(pieces == piece)
        if max(np.ptp(y), np.ptp(x)) + 1 >= int(shortest / 2):
            kept |= pieces == piece
    near = convolve1d(convolve1d(kept.astype(int), [1, 1, 1], 0, mode="constant"), [1, 1, 1], 1, mode="constant") > 0
    return np.where(np.repeat(np.repeat(near, 2, 0), 2, 1)[:h, :w], out, 255)


def kuwahara(image, radius, sharpness, stretch, passes):
    image = image.astype(float)
    reach = 4 * (0.25 / 4) ** (sharpness / 100)
    for _ in range(passes):
        luma = luma_of(image)
        turns, coherence = tangents(luma, max(0.8 * radius, 2))
        window = 0.4 * radius
        spread = np.log2(blur(np.abs(luma - blur(luma, window)), window) + 1)
        planes = image[..., None] if image.ndim == 2 else image
        means = np.stack([blur(planes[..., c], window) for c in range(planes.shape[-1])], -1)
        angle = per_pixel(turns, luma.shape) * np.pi / TURNS
        longer = 1 + stretch / 100 * np.floor(per_pixel(np.round(coherence * 255), luma.shape) * 4 / 256) / 3
        samples, spreads = [], []
        for k in range(8):
            u, v = np.cos(k * np.pi / 4) * longer * 0.6 * radius, np.sin(k * np.pi / 4) / longer * 0.6 * radius
            dx = round_away(np.round(u * np.cos(angle) - v * np.sin(angle), 9))
            dy = round_away(np.round(u * np.sin(angle) + v * np.cos(angle), 9))
            samples.append(np.stack([at(means[..., c], dx, dy) for c in range(means.shape[-1])], -1))
            spreads.append(at(spread, dx, dy))
        apart = np.array(spreads) - np.min(spreads, 0)
        weights = (1 - np.minimum(apart, reach) / reach) ** 4
        planes = (np.array(samples) * weights[..., None]).sum(0) / weights.sum(0)[..., None]
        image = np.floor((planes[..., 0] if image.ndim == 2 else planes) + 0.5)
    return image


LAYERS = ((0, 0), (62, 0.42), (-48, 0.7))


def engrave(image, pitch, angle, follow, layers, ink):
    follow /= 100
    gap, form = 8, 14
    h, w = image.shape
    # Form is measured on half the size.
    work = np.floor(halves(image) + 0.5)
    columns, rows = -(-w // gap) + 2, -(-h // gap) + 2
    turns, coherence = tangents(work, form / 2)
    j, i = np.mgrid[:rows, :columns]
    y, x = np.minimum(j * gap // 2, work.shape[0] - 1), np.minimum(i * gap // 2, work.shape[1] - 1)
    turn = turns[y // 4, x // 4]
    coherence = np.floor(np.round(coherence[y // 4, x // 4] * 255) / 31) / 8
    square = [[work[max(b - 2, 0) : b + 3, max(a - 2, 0) : a + 3].mean() for a in x[0]] for b in y[:, 0]]
    relief = gaussian_filter(np.array(square) / 255, form / gap, mode="nearest", radius=int(np.ceil(2.5 * form / gap)))
    dark = np.clip(((1 - image / 255) * ink / 100 - 0.05) / 0.95, 0, 1)
    white, covered = np.ones_like(dark), np.zeros_like(dark)
    for layer in range(layers):
        own = np.deg2rad(angle + LAYERS[layer][0])
        apart = (turn * np.pi / TURNS - own + np.pi / 2) % np.pi - np.pi / 2
        bent = own + follow * coherence * apart * np.cos(apart) ** 2 * 1.6
        padded = np.pad(relief, 1, mode="edge")
        sx = 0.5 * (padded[1:-1, 2:] - padded[1:-1, :-2]) * 9 * follow
        sy = 0.5 * (padded[2:, 1:-1] - padded[:-2, 1:-1]) * 9 * follow
        most = 0.45 * gap / pitch
        held = most / (most + np.hypot(sx, sy))
        vx = (np.sin(own) - np.sin(bent)) * gap / pitch + sx * held
        vy = (np.cos(bent) - np.cos(own)) * gap / pitch + sy * held
        field = least_squares(vx, vy)
        gy, gx = np.mgrid[:h, :w] + 0.5
        fy, fx = gy % gap / gap, gx % gap / gap
        corner = lambda b, a: field[(gy // gap).astype(int) + b, (gx // gap).astype(int) + a]  # noqa: E731
        between = (corner(0, 0) * (1 - fy) + corner(1, 0) * fy) * (1 - fx) + (corner(0, 1) * (1 - fy) + corner(1, 1) * fy) * fx
        phase = (-np.sin(own) * gx + np.cos(own) * gy) / pitch + between
        limit = 1 if layer == layers - 1 else max(LAYERS[layer + 1][1], 0.5)
        wanted = np.where(dark > LAYERS[layer][1], 1 - (1 - dark) / np.maximum(1 - covered, 1e-9), 0)
        wanted = np.clip(wanted, 0, limit)
        paper = np.clip((np.abs(2 * (phase % 1) - 1) - wanted) * 0.5 * pitch + 0.5, 0, 1)
        white *= np.where(wanted <= 0, 1, paper)
        covered = 1 - (1 - covered) * (1 - wanted)
    return white * 255


def least_squares(vx, vy):
    rows, columns = vx.shape
    number = np.arange(rows * columns).reshape(rows, columns)
    pairs = [(number[:, :-1], number[:, 1:], (vx[:, :-1] + vx[:, 1:]) / 2)]
    pairs.append((number[:-1], number[1:], (vy[:-1] + vy[1:]) / 2))
    low, high, wanted = (np.concatenate([np.ravel(pair[k]) for pair in pairs]) for k in range(3))
    k = np.arange(len(low))
    values = np.concatenate([-np.ones(len(low)), np.ones(len(low))])
    matrix = coo_matrix((values, (np.concatenate([k, k]), np.concatenate([low, high]))))
    field = lsqr(matrix, wanted, atol=1e-12, btol=1e-12, iter_lim=20000)[0]
    return (field - field.mean()).reshape(rows, columns)


def hashed(x, y, seed):
    with np.errstate(over="ignore"):
        u = np.uint32
        h = u(x) * u(0x9E3779B1) ^ u(y) * u(0x85EBCA77) ^ u(seed) * u(0xC2B2AE3D)
        h = (h ^ (h >> u(16))) * u(0x7FEB352D)
        h = (h ^ (h >> u(15))) * u(0x846CA68B)
        return h ^ (h >> u(16))


def grain(seed, width, height, shape):
    """Value noise of a lattice of 256 points that repeats."""
    y, x = np.mgrid[:256, :256].astype(np.uint32)
    lattice = (hashed(x, y, np.uint32(seed)) >> np.uint32(8)) / 2**24
    down, right = ((np.arange(n) + 0.5) / max(size, 0.5) for n, size in zip(shape, (height, width)))
    ease = lambda t: t * t * (3 - 2 * t)  # noqa: E731
    ty, tx = ease(down % 1)[:, None], ease(right % 1)
    j, i = down.astype(int)[:, None], right.astype(int)
    corner = lambda b, a: lattice[(j + b) % 256, (i + a) % 256]  # noqa: E731
    return (corner(0, 0) * (1 - ty) + corner(1, 0) * ty) * (1 - tx) + (corner(0, 1) * (1 - ty) + corner(1, 1) * ty) * tx


def strokes(image, width, length, angle, follow, hardness, pressure, cross):
    luma = luma_of(image)
    turns, coherence = tangents(luma, 10)
    follow, hardness, pressure = follow / 100, hardness / 100, pressure / 100

    def bent(degrees, follow):
        own = degrees / 180 * TURNS
        apart = (turns - own + TURNS / 2) % TURNS - TURNS / 2
        near = 1 - np.abs(2 * apart / TURNS) ** 3
        strength = np.minimum(coherence * 1.5, 1) * follow * near
        return round_away(np.round(own + apart * strength, 6)).astype(int) % TURNS

    def hand(field, seed):
        side = int(min(256 * width, 900) + 0.5)
        noise = tile(seed, min(int(side / width + 0.5), 256), side)
        y, x = np.mgrid[: luma.shape[0], : luma.shape[1]]
        noise = along(noise[y % side, x % side] * 255 - 128, field, length)
        spots = max(2 * np.sqrt(np.pi) * length / (1.2 * width), 1)
        z = noise / (51 / np.sqrt(spots))
        return np.floor(255 / (1 + np.exp(-1.595769 * z - 0.0713 * z**3)) + 0.5)

    slope = 1 + 9 * hardness**2
    ink = lambda dark, stroke: np.where(dark == 0, 0, np.clip((dark - stroke) / 255 * slope + 0.5, 0, 1))  # noqa: E731
    dark = 255 - (image if image.ndim == 2 else image.min(-1))
    inked = ink(dark, hand(bent(angle, follow), 1))
    if cross:
        second, start = hand(bent(angle + 58, follow / 2), 2), int(0.45 * 255)
        across = np.floor(np.maximum(dark - start, 0) * 255 / (255 - start))
        inked = np.where((dark > start) & (second > 0), np.maximum(inked, 0.9 * ink(across, second)), inked)
    share = inked * (pressure + (1 - pressure) * (dark / 255) ** 2)
    if image.ndim == 2:
        return 255 - 255 * share
    return 255 - (255 - image) * (share * 255 / np.maximum(dark, 48))[..., None]


COMIC = [
    (24, 22, 34), (46, 58, 110), (44, 120, 180), (120, 190, 220), (196, 40, 44), (230, 110, 50), (248, 200, 60), (60, 130, 80),
    (130, 180, 90), (120, 76, 54), (198, 146, 106), (242, 206, 170), (128, 128, 136), (206, 204, 200), (252, 248, 238),
]  # fmt: skip


def oklab(rgb):
    c = np.asarray(rgb, float) / 255
    c = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    to_lms = [[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566]]
    to_lms.append([0.0883024619, 0.2817188376, 0.6299787005])
    to_lab = [[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099]]
    to_lab.append([0.0259040371, 0.7827717662, -0.8086757660])
    return np.cbrt(c @ np.array(to_lms).T) @ np.array(to_lab).T


def flatten(image, colors, palette, detail, smoothness, own):
    """The complete palette `comic`. No detail is dropped, and borders are not straightened before painting."""
    assert (palette, colors, detail, smoothness, own) == ("comic", 15, 0, 0, 0)
    small = np.stack([np.floor(halves(image[..., c]) + 0.5) for c in range(3)], -1)
    cells = np.floor(small / 8) * 8 + 3.5
    apart = np.linalg.norm(oklab(cells)[..., None, :] - oklab(COMIC), axis=-1)
    labels = np.argmin(np.floor(apart * 8192), -1)
    # Four-connected pixels of one colour are an area. Painted areas are a vote of the areas around.
    areas, count = np.zeros(labels.shape, int), 0
    for name in np.unique(labels):
        found, more = label(labels == name)
        areas[found > 0] = found[found > 0] + count
        count += more
    sigma, (h, w) = 0.6, image.shape[:2]
    reach = int(np.ceil(2 * sigma))
    slope = sigma * np.sqrt(2 * np.pi) * 2
    color_of = np.zeros((count + 1, 3))
    color_of[areas] = np.array(COMIC)[labels]
    out = np.zeros((h, w, 3))
    for y in range(h):
        for x in range(w):
            votes = {}
            for dy in range(-reach, reach + 1):
                for dx in range(-reach, reach + 1):
                    j, i = np.clip(y // 2 + dy, 0, labels.shape[0] - 1), np.clip(x // 2 + dx, 0, labels.shape[1] - 1)
                    apart = (dx - (x % 2 * 0.5 - 0.25)) ** 2 + (dy - (y % 2 * 0.5 - 0.25)) ** 2
                    votes[areas[j, i]] = votes.get(areas[j, i], 0) + np.exp(-apart / (2 * sigma**2))
            order = sorted(votes, key=votes.get, reverse=True)[:2]
            first, second = order[0], order[-1]
            lead = (votes[first] - (votes[second] if len(order) > 1 else 0)) / sum(votes.values())
            share = min(0.5 + 0.5 * lead * slope, 1)
            out[y, x] = share * color_of[first] + (1 - share) * color_of[second]
    return out


INKS = {
    "red-blue": [(241, 80, 60), (0, 98, 172)],
    "yellow-blue-red": [(255, 224, 0), (241, 80, 60), (0, 98, 172)],
}


def plates(image, inks, shift, grain, pitch, steps, density, seed):
    colors = 1 - np.array(INKS[inks]) / 255
    weights = np.linalg.solve(colors @ colors.T + 0.06 * np.eye(len(colors)), colors)
    weights *= density / 100 / np.maximum(weights.sum(1, keepdims=True), 0.2)
    out = np.full(image.shape, 255.0)
    missing = 255 - image
    for i, (color, own) in enumerate(zip(INKS[inks], weights)):
        cover = np.clip(np.floor(missing @ own + 0.5), 0, 255)
        if steps > 1:
            cover = np.minimum(np.floor(cover * steps / 256), steps - 1) * 255 / (steps - 1)
        if grain > 0:
            cover = printed_grain(cover, grain / 100, seed, i)
        if i + 1 < len(colors):
            cover = at(cover, *(-offset for offset in misfit(shift, seed, i)))
        out *= 1 - (1 - np.array(color) / 255) * cover[..., None] / 255
    return out


def printed_grain(cover, strength, seed, plate):
    h, w = cover.shape
    apart = plate * h // 3 + plate * 57
    y, x = np.mgrid[:h, :w] + apart
    noise, cloud = (tile(seed + k, spots, side)[y % side, x % side] for k, spots, side in ((31, 256, 410), (57, 16, 640)))
    a = cover / 255
    broken = np.clip(a + (noise - 128 / 255) * strength * 3.2 * a * (1.25 - a), 0, 1)
    return np.floor(broken * (1 - strength * 0.3 * cloud**2) * 255 + 0.5)


def tile(seed, spots, side):
    """Value noise on a square that repeats, 0 to 1."""
    y, x = np.mgrid[:spots, :spots].astype(np.uint32)
    lattice = (hashed(x, y, np.uint32(seed)) >> np.uint32(8)) / 2**24
    place = (np.arange(side) + 0.5) * spots / side
    t, i = place % 1, place.astype(int)
    t = t * t * (3 - 2 * t)
    rows = lattice[i] * (1 - t)[:, None] + lattice[(i + 1) % spots] * t[:, None]
    return np.floor((rows[:, i] * (1 - t) + rows[:, (i + 1) % spots] * t) * 255 + 0.5) / 255


def misfit(shift, seed, plate):
    x, y, z = ((int(hashed(np.uint32(seed), np.uint32(plate), np.uint32(k))) >> 8) / 2**23 - 1 for k in (1, 2, 3))
    far = shift * (0.75 + 0.25 * z) / max(np.hypot(x, y), 0.05)
    return int(round_away(x * far)), int(round_away(y * far))


NOISES = {
    "smooth": [(1.4, 1.4, 0.7), (4.0, 4.0, 0.4)],
    "cold-press": [(9.0, 8.0, 1.1), (4.2, 4.2, 0.7), (1.6, 1.6, 0.3)],
}
TINTS = {"cream": (248, 239, 220), "ivory": (253, 250, 241)}


def paper(image, sheet, tint, grain, pigment, size):
    assert size == 1
    side = 420
    overlap = side // 6
    long = side + overlap
    fade = np.ones(long)
    fade[:overlap] = np.arange(overlap) / overlap
    fade[side:] = 1 - np.arange(overlap) / overlap
    heights = np.zeros((side, side))
    for seed, (width, height, share) in enumerate(NOISES[sheet]):
        noise = share * 2 * (globals()["grain"](seed + 11, width, height, (long, long)) - 0.5) * fade * fade[:, None]
        noise[:overlap] += noise[side:]
        noise[:, :overlap] += noise[:, side:]
        heights += noise[:side, :side]
    heights = np.clip(heights - heights.mean(), -1, 1)[: image.shape[0], : image.shape[1], None]
    left = np.clip(255 - (255 - image) * (1 + 0.45 * pigment / 100 * heights), 0, 255)
    return left * np.array(TINTS[tint]) / 255 + 16 * grain / 100 * heights
